"""Groups of a round robin, listed in the file or drawn evenly from pots, and the pairings of their rounds."""

from __future__ import annotations

from collections.abc import Mapping
from string import ascii_uppercase

from rcj_challenges.tournament.seeds import shuffled


def groups_of(
    groups: int | Mapping[str, tuple[str, ...]], pots: Mapping[str, int], seed: int | str, use: str
) -> dict[str, tuple[str, ...]]:
    """Return the teams of each group; one group has an empty name. In pot 0 are teams without one."""
    if isinstance(groups, Mapping):
        return {name: tuple(team for team in listed if team in pots) for name, listed in groups.items()}
    if groups == 1:
        return {"": tuple(pots)}
    dealt: list[list[str]] = [[] for _ in range(groups)]
    # Dealt on from pot to pot: groups differ by one team at most, and so does each pot among them.
    for index, team in enumerate(by_pot(pots, seed, use)):
        dealt[index % groups].append(team)
    return dict(zip(group_names(groups), map(tuple, dealt), strict=True))


def by_pot(pots: Mapping[str, int], seed: int | str, use: str) -> list[str]:
    """Return teams pot by pot, in each in the order of a draw; those in none of them come last."""
    numbers = sorted(set(pots.values()), key=lambda pot: (pot == 0, pot))
    return [
        team for pot in numbers for team in shuffled(seed, f"{use}/pot{pot}", [one for one in pots if pots[one] == pot])
    ]


def group_names(count: int) -> list[str]:
    """Return the names of so many drawn groups: A to Z, then A2 and on."""
    return [ascii_uppercase[i % 26] + (str(i // 26 + 1) if i >= 26 else "") for i in range(count)]


def pairings(count: int, legs: int = 1) -> list[list[tuple[int, int]]]:
    """Return the pairs of each round, by index; the first of a pair begins on the first seat.

    The circle method: one stays, all others move on. No team is on one seat more than once more than on the other.
    With an odd number of teams, one rests in each round; a second leg is all rounds again with the seats changed.
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
