"""How long the halves of a match are: all alike, or each its own length; longer where a phase stops the clock."""

from __future__ import annotations

from rcj_challenges.scenario.models.field import Match
from rcj_challenges.scenario.models.scenario import Scenario

MAX_LENGTHS = 10
"""A half whose clock a phase has stopped for good ends after this many times its length."""


def half_lengths_s(match: Match) -> tuple[float, ...]:
    """Return the length of each half that is played, in s.

    Where more halves are asked for than the file has lengths (on the command line), the last one goes for them too.
    """
    written = match.half_s if isinstance(match.half_s, tuple) else (match.half_s,)
    return tuple(written[min(number, len(written) - 1)] for number in range(match.halves))


def half_length_s(match: Match, half: int) -> float:
    """Return the length of a half in s, numbered from 1; beyond those that are played it is as long as the last."""
    lengths_s = half_lengths_s(match)
    return lengths_s[min(half, len(lengths_s)) - 1]


def longest_half_s(match: Match) -> float:
    """Return the length of the longest half that is played, in s."""
    return max(half_lengths_s(match))


def clock_may_stop(scenario: Scenario) -> bool:
    """Return whether a phase stops the clock, so that a half lasts longer than its length."""
    return any(phase.clock == "stops" for phase in scenario.phases.values())
