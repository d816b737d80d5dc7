"""What was drawn is kept: once a match has counted, teams, seed, groups and pairings change only on purpose.

Belongs here: the drawn data, what the file must not change any more, drawing again, adding a late team. Does not
belong here: how something is drawn (`formats`).
"""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import chain
from typing import Any, Self

from rcj_challenges.core.diagnostics import Diagnostic, DiagnosticError
from rcj_challenges.scenario.errors import listing
from rcj_challenges.tournament.codes import DRAWN_BEFORE
from rcj_challenges.tournament.season import Team

Rounds = list[list[list[str]]]
"""Of a group: by round the pairs, the team on the first seat first."""


@dataclass
class Drawn:
    """What was drawn; JSON-able.

    Attributes:
        match_seed: the seeds of matches are derived from it: the first one, also after another draw.
        pots: by team, in the order in which they take part; 0: none.
        left_out: by stage that takes all teams: those that came too late for it.
        draws: by stage, or stage and hash of what led to a draw.
        moved: by fixture: its id before it was drawn again; its seed is derived from that.
    """

    seed: int | str
    match_seed: int | str
    pots: dict[str, int]
    left_out: dict[str, list[str]] = field(default_factory=dict)
    draws: dict[str, Any] = field(default_factory=dict)
    moved: dict[str, str] = field(default_factory=dict)

    @classmethod
    def of(cls, seed: int | str, teams: Mapping[str, Team]) -> Self:
        """Return the data before the draw."""
        return cls(seed, seed, {team: one.pot for team, one in teams.items()})

    def draw(self, stage: str, inputs: Any, make: Callable[[], Any]) -> Any:
        """Return the draw of a stage, JSON-able, drawing it now if it was not.

        ``inputs`` are the causes of the draw, when other results may lead to another one; None if they cannot.
        """
        key = stage if inputs is None else f"{stage}/{hashlib.sha256(repr(inputs).encode()).hexdigest()[:16]}"
        if key not in self.draws:
            self.draws[key] = make()
        return self.draws[key]

    def check(self, seed: int | str, teams: Mapping[str, Team]) -> None:
        """Compare it with the tournament of today.

        Raises:
            DiagnosticError: the seed, the teams or their pots are others.
        """
        new, gone = [one for one in teams if one not in self.pots], [one for one in self.pots if one not in teams]
        other_pots = [one for one in teams if one in self.pots and self.pots[one] != teams[one].pot]
        found = {"new teams": new, "missing teams": gone, "another pot": other_pots}
        changes = [f"{words}: {listing(teams)}" for words, teams in found.items() if teams]
        changes += [f"the seed was {self.seed!r}"] if seed != self.seed else []
        if changes:
            late = " ".join(f"--add {one}" for one in new)
            raise drawn_before(changes, *([f"'run FILE {late}' takes them in"] if late and len(changes) == 1 else []))


def drawn_before(changes: Iterable[str], *ways: str) -> DiagnosticError:
    """Return the error of changes after the draw, with ways out beside undoing them and another draw."""
    redraw = "'run FILE --redraw' draws again and keeps the matches of pairs that still exist"
    help_ = "; or ".join(("undo the change", *ways, redraw))
    return DiagnosticError(Diagnostic(DRAWN_BEFORE, f"changed after the draw: {'; '.join(changes)}", help_))


def add_to_rounds(rounds: Rounds, teams: Sequence[str], late: str, legs: int) -> None:
    """Add the matches of a late team: each in the first round in which both are free."""
    for leg in range(legs):
        for number, team in enumerate(teams):
            pairs = next((pairs for pairs in rounds if not {late, team} & set(chain.from_iterable(pairs))), None)
            if pairs is None:
                rounds.append(pairs := [])
            pairs.append([late, team] if (number + leg) % 2 else [team, late])


def turn_pairs(rounds: Rounds, before: Iterable[tuple[str, str]]) -> None:
    """Give each pair that has met the seats that it had."""
    known = set(before)
    for pair in chain.from_iterable(rounds):
        if (pair[1], pair[0]) in known and (pair[0], pair[1]) not in known:
            pair.reverse()
