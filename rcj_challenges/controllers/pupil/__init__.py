"""What a team's program sees: the ``controller`` package, and the code that starts the program in its own process.

Belongs here: the classes that programs import, the simulated clock, the seeded chance, the counted output. Does not
belong here: anything beyond the standard library (this runs in the program's process, started without
``site-packages`` of its own), and anything that the match decides. The parent imports
nothing from here but `_landlock` and `_seccomp`, to ask what this machine can do: both sides know only the protocol
(``docs/protocol.md``).

Only type checkers import ``typing`` and ``collections`` here: they would be more than half of a program's start, and
six programs start with every match (ADR 10).
"""
