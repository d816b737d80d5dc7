"""What a team's program sees: the ``controller`` package, and the code that starts the program in its own process.

Belongs here: the classes that programs import, the simulated clock, the seeded chance, the counted output. Does not
belong here: anything beyond the standard library (this runs in the program's process, started without ``site-packages``
of its own), and anything that the match decides. The parent imports only `_landlock` and `_seccomp` from here, to find
out what this machine supports: otherwise both sides share only the protocol (``docs/protocol.md``).

Only type checkers import ``typing`` and ``collections`` here: they would take more than half of a program's start time,
and six programs start with every match (ADR 10).
"""
