"""Sums over robots, halves and runs, from which the figures are computed."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Any


@dataclass
class Tally:
    """What is counted of one robot, one ball, or of all robots of a team.

    Attributes:
        ball_ticks: ticks of play, for each ball, in the halves in which it took part, on the field or not: what
            ``owned_ticks`` is a share of.
        field_ticks: ticks of play in which it was on the field.
        distance_m: way driven or rolled in them in m; being put elsewhere is no way.
        fastest_mps: greatest distance of any such tick over the tick's 0.032 s, in m/s.
        sided_ticks: those of ``field_ticks`` in which its team had an own half.
        own_half_ticks: those of ``sided_ticks`` in which its centre was in it.
        owned_ticks: ticks of play in which it was the last to have touched a ball, for each ball of several.
        touches: times it touched a ball.
        shots: touches that sent a ball over the line behind which the attacked goal stands.
        on_goal: those of ``shots`` between the posts.
        calls: referee calls about it, by event.
        faults: failures of its program, by kind.
    """

    ball_ticks: int = 0
    field_ticks: int = 0
    distance_m: float = 0.0
    fastest_mps: float = 0.0
    sided_ticks: int = 0
    own_half_ticks: int = 0
    owned_ticks: int = 0
    touches: int = 0
    shots: int = 0
    on_goal: int = 0
    calls: Counter[str] = field(default_factory=Counter)
    faults: Counter[str] = field(default_factory=Counter)


@dataclass
class TeamTally:
    """A team's robots and points over all runs, of which ``runs`` is the number.

    Robots go by label: the names that a robot had (``B1/Y1`` where teams changed sides). ``ball_ticks`` are the ticks
    of play, for each ball.
    """

    robots: dict[str, Tally] = field(default_factory=dict)
    points: float = 0
    runs: int = 0
    ball_ticks: int = 0
    programs: set[str] = field(default_factory=set)

    @property
    def total(self) -> Tally:
        """All robots together."""
        total = Tally()
        for robot in self.robots.values():
            _add(total, robot)
        total.ball_ticks = self.ball_ticks  # they play at the same time
        return total


@dataclass
class Stats:
    """One run or several, by the names of their folders, teams and balls.

    Attributes:
        play_ticks: ticks of play: not waiting for a kick-off.
        calls: referee calls that are about no robot, by event.
        notes: what is missing or damaged, each with the run's name.
    """

    runs: list[str] = field(default_factory=list)
    teams: dict[str, TeamTally] = field(default_factory=dict)
    balls: dict[str, Tally] = field(default_factory=dict)
    play_ticks: int = 0
    ticks: int = 0
    calls: Counter[str] = field(default_factory=Counter)
    has_goals: bool = False
    notes: list[str] = field(default_factory=list)


def merge_stats(several: Iterable[Stats]) -> Stats:
    """Return the sums over several runs; teams of one name are one team, and their robots go by their labels.

    A note reports a name under which several submissions played, because the sum may mix two teams.
    """
    total = Stats()
    for one in several:
        _add(total, one)
    for name, team in total.teams.items():
        if len(team.programs) > 1:
            note = f"{len(team.programs)} different submissions have this name; they are added up as one team"
            total.notes.append(f"{name}: {note}")
    return total


def _known_label(label: str, known: Iterable[str]) -> str:
    """Return the known label of a robot: ``B1/Y1`` drove as yellow first in another run, where it was ``Y1/B1``."""
    names = sorted(label.split("/"))
    return next((one for one in known if sorted(one.split("/")) == names), label)


def _add(total: Any, other: Any) -> None:
    """Add sums of the same kind to a total, field by field."""
    for name, value in vars(other).items():
        mine = getattr(total, name)
        if name == "fastest_mps":
            setattr(total, name, max(mine, value))
        elif isinstance(value, bool | set):
            setattr(total, name, mine | value)
        elif isinstance(value, dict) and not isinstance(value, Counter):
            for label, one in value.items():
                _add(mine.setdefault(_known_label(label, mine) if name == "robots" else label, type(one)()), one)
        else:
            setattr(total, name, mine + value)
