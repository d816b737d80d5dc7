"""Codes about running programs."""

from rcj_challenges.core.code import Code

# fmt: off
UNKNOWN_SANDBOX = Code("unknown-sandbox", page="""
The value of --sandbox is unknown.
Write auto, strict or off.""")
ISOLATION_MISSING = Code("isolation-missing", page="""
--sandbox strict was given, and this computer lacks some layers of isolation.
Play with --sandbox auto, or on another computer. docs/isolation.md lists the layers.""")
HOST_TOO_BUSY = Code("host-too-busy", page="""
The match waited a very long time for programs, but none of them used up its own time.
This computer is too busy: close other programs, and play the match again.""")
CANNOT_START_PROGRAM = Code("cannot-start-program", page="""
This computer cannot start one more program.
Close other programs and run it again.""")
