"""The circle method: the pairings of each round of a round robin."""

from __future__ import annotations

from collections.abc import Mapping


def pairings(count: int, legs: int = 1) -> list[list[tuple[int, int]]]:
    """Return the pairs of each round, by index; the first of a pair begins on the first seat.

    The circle method: one stays, all others move on. No team is on one seat more than once more than on the other.

    Args:
        count: number of teams; with an odd number, one rests in each round.
        legs: 2: all rounds again with the seats changed.
    """
    size = count + count % 2
    rounds = []
    for turn in range(size - 1):
        pairs = [(size - 1, turn) if turn % 2 else (turn, size - 1)]
        for step in range(1, size // 2):
            one, other = (turn + step) % (size - 1), (turn - step) % (size - 1)
            pairs.append((one, other) if step % 2 else (other, one))
        rounds.append([pair for pair in pairs if max(pair) < count])
    if legs == 2:
        rounds += [[(other, one) for one, other in pairs] for pairs in rounds]
    return rounds


def all_meet(tables: Mapping[str, int], legs: int) -> tuple[int, int]:
    """Return the numbers of matches and of rounds in which all of each table meet; ``tables`` has their sizes."""
    largest = max(tables.values(), default=0)
    rounds = (largest - 1 + largest % 2) * legs if largest > 1 else 0
    return sum(size * (size - 1) // 2 * legs for size in tables.values()), rounds
