"""Codes about matches."""

from rcj_challenges.core.code import Code

# fmt: off
RECORD_DOES_NOT_FIT = Code("record-does-not-fit", page="""
A record can be judged only by a scenario with the same robots, balls, obstacles and entrants, in the same order.
Judge it by the scenario that was played, or by a copy of it with other rules.""")
