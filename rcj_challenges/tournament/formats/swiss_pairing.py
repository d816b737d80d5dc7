"""Pairing one round of a Swiss stage."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import combinations
from math import lcm


@dataclass(frozen=True, slots=True)
class Player:
    """A team before a round; ``balance``: matches begun on the first seat minus those begun on the second."""

    team: str
    points: float
    balance: int
    met: Collection[str]
    had_bye: bool


def pair(players: Sequence[Player], round_: int) -> tuple[list[tuple[str, str]], str]:
    """Return the pairs, the first team of each on the first seat, and the team with a bye (empty: none).

    Of all pairings the best is taken. What counts, first things first: few rematches, few second byes, seats that
    differ by two at most, equal points, equal seats, neighbours in the table. Players come in the order of the table.
    """
    found, bye = [], ""
    for number, (one, other) in enumerate(sorted(_matched(_costs(players)))):
        if other == len(players):
            bye = players[one].team
            continue
        first, second = players[one], players[other]
        is_turned = first.balance > second.balance or (first.balance == second.balance and (number + round_) % 2 == 0)
        found.append((second.team, first.team) if is_turned else (first.team, second.team))
    return found, bye


def _matched(costs: Mapping[tuple[int, int], int]) -> list[tuple[int, int]]:
    """Return the pairing that costs least."""
    import networkx as nx  # noqa: PLC0415 - loaded only when a round is drawn

    graph = nx.Graph()
    graph.add_weighted_edges_from((one, other, -cost) for (one, other), cost in costs.items())
    return [(min(pair), max(pair)) for pair in nx.max_weight_matching(graph, maxcardinality=True)]


def _costs(players: Sequence[Player]) -> dict[tuple[int, int], int]:
    """Return the cost of each pair: exact, and by each criterion more than all pairs together by those after it."""
    size = len(players) + len(players) % 2
    exact = [Fraction(player.points) for player in players]
    points = [int(one * lcm(*(other.denominator for other in exact))) for one in exact]
    criteria = {pair: _criteria(players, points, *pair) for pair in combinations(range(size), 2)}
    costs = dict.fromkeys(criteria, 0)
    for column in range(6):
        above = size * max((own[column] for own in criteria.values()), default=0) + 1
        costs = {pair: costs[pair] * above + own[column] for pair, own in criteria.items()}
    return costs


def _criteria(players: Sequence[Player], points: Sequence[int], one: int, other: int) -> tuple[int, ...]:
    """Return the cost of a pair by criterion; the first is higher in the table, and behind the last is the bye."""
    first = players[one]
    if other == len(players):
        return 0, int(first.had_bye), 0, (points[one] - points[-1]) ** 2, 0, (other - one) ** 2
    second = players[other]
    # The team that was less often on the first seat begins there.
    least, most = min(first.balance, second.balance) + 1, max(first.balance, second.balance) - 1
    uneven, very_uneven = (max(0, abs(least) - by) + max(0, abs(most) - by) for by in (1, 2))
    return int(second.team in first.met), 0, very_uneven, (points[one] - points[other]) ** 2, uneven, (other - one) ** 2
