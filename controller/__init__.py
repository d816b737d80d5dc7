"""Lets editors resolve ``controller`` outside a match; the types are in ``__init__.pyi``.

In a match programs import the implementation, ``rcj_challenges/programs/program_side/controller``.
"""

import sys

program = sys.argv[0] or "robot.py"
sys.exit(f"error: robot programs run in a match; start one with: rcj-challenge run match --yellow {program}")
