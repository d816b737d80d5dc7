"""Pairing one round of a Swiss stage."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Player:
    """A team before a round.

    Attributes:
        team: id.
        points: so far.
        balance: matches begun on the first seat minus those begun on the second.
        met: opponents so far.
        had_bye: whether it had a bye.
    """

    team: str
    points: float
    balance: int
    met: Collection[str]
    had_bye: bool


def pair(players: Sequence[Player], round_: int) -> tuple[list[tuple[str, str]], str]:
    """Return the pairs, the first team of each on the first seat, and the team with a bye (empty: none).

    Neighbours in the table are paired; then pairs exchange partners as long as that makes the round better. What
    counts, first things first: no rematch and no second bye, seats that differ by two at most, equal points, equal
    seats, neighbours. As long as each has met less than half of the others, two pairs of which one is a rematch can
    always be exchanged for a better one: such rounds have none.

    Args:
        players: in the order of the table.
        round_: from 1.
    """
    size = len(players) + len(players) % 2
    costs = {(one, other): _cost(players, one, other) for other in range(size) for one in range(other)}
    pairs = [(one, one + 1) for one in range(0, size, 2)]
    while _exchange(pairs, costs):
        pass
    found, bye = [], ""
    for number, (one, other) in enumerate(sorted(pairs)):
        if other == len(players):
            bye = players[one].team
            continue
        first, second = players[one], players[other]
        is_turned = first.balance > second.balance or (first.balance == second.balance and (number + round_) % 2 == 0)
        found.append((second.team, first.team) if is_turned else (first.team, second.team))
    return found, bye


def _exchange(pairs: list[tuple[int, int]], costs: Mapping[tuple[int, int], int]) -> bool:
    """Let pairs exchange partners where that costs less; return whether any did."""
    has_changed = False
    for i in range(len(pairs)):
        for j in range(i + 1, len(pairs)):
            (a, b), (c, d) = pairs[i], pairs[j]
            straight, crossed = (_ordered(a, c), _ordered(b, d)), (_ordered(a, d), _ordered(b, c))
            best = min(straight, crossed, key=lambda two: costs[two[0]] + costs[two[1]])
            if costs[best[0]] + costs[best[1]] < costs[pairs[i]] + costs[pairs[j]]:
                pairs[i], pairs[j] = best
                has_changed = True
    return has_changed


def _ordered(one: int, other: int) -> tuple[int, int]:
    return (one, other) if one < other else (other, one)


def _cost(players: Sequence[Player], one: int, other: int) -> int:
    """Return what it costs to pair two, of which ``one`` stands above; the one behind the last is the bye."""
    first = players[one]
    uneven = very_uneven = 0
    if other == len(players):
        is_again, points = first.had_bye, first.points - players[-1].points
    else:
        second = players[other]
        is_again, points = second.team in first.met, first.points - second.points
        # The team that was less often on the first seat begins there.
        least, most = min(first.balance, second.balance) + 1, max(first.balance, second.balance) - 1
        uneven = max(0, abs(least) - 1) + max(0, abs(most) - 1)
        very_uneven = max(0, abs(least) - 2) + max(0, abs(most) - 2)
    # Each weight is larger than all that two pairs can cost by what comes after it.
    return (
        is_again * 10**24
        + very_uneven * 10**20
        + round(100 * points * points) * 10**11
        + uneven * 10**8
        + (other - one) ** 2
    )
