"""A match as remarks for people: sentences of the rules, and the score when it changes."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from rcj_challenges.core.amounts import Score
from rcj_challenges.core.measures import number_words
from rcj_challenges.core.play import HalfInfo, RefereeOutput
from rcj_challenges.core.sanitize import sanitize
from rcj_challenges.core.timing import s_from_ticks
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.views.naming import distinct_names
from rcj_challenges.views.payloads import extra_payload_text
from rcj_challenges.views.sentences import clock
from rcj_challenges.views.timeline import TimelineBuilder, TimelineEvent

_MAX_UNANNOUNCED = 20
"""Points without an event, of each rule and half: one that pays on every tick would leave no room for anything else."""


@dataclass(frozen=True, slots=True)
class Remark:
    """One line of a commentary.

    Attributes:
        text: safe in a terminal.
        seat: the seat whose score changed; empty if none did.
    """

    text: str
    seat: str = ""


class Commentator:
    """Turns outputs into remarks.

    Attributes:
        colours: by seat, the colour of its first robot, a CSS name.
    """

    def __init__(self, scenario: Scenario) -> None:
        self._builder = TimelineBuilder(scenario, _MAX_UNANNOUNCED)
        self.colours = {
            seat: scenario.robots[robot].colour
            for seat, entrant in scenario.entrants.items()
            for robot in list(entrant.robots)[:1]
            if robot in scenario.robots
        }
        self._teams: dict[str, str] = {}
        self._names: dict[str, str] = {}

    def begin(self, half: HalfInfo) -> None:
        """Begin a half."""
        self._builder.begin_half(half)
        self._teams = half.teams
        self._names = distinct_names({seat: sanitize(name, 32) for seat, name in half.team_names.items()})

    def remarks(self, output: RefereeOutput) -> Iterator[Remark]:
        """Yield the remarks about an output: its events, then points that were given without one."""
        for event in self._builder.add(output.events, output.firings, output.changes).events:
            scored = {seat: points for seat, points in event.scored.items() if points}
            # The score changes once, also by a rule that emits several events.
            yield self._score(event, scored) if scored and event.is_first else _sentence(event)

    def _score(self, event: TimelineEvent, scored: Mapping[str, Score]) -> Remark:
        seat = max(scored, key=lambda one: scored[one])  # the seat that gained, else the one that lost
        gain = "" if scored[seat] == 1 else f"{scored[seat]:+g}, "
        return Remark(f"{_name(event)}  {self._standing(seat, event.score)}  ({seat}, {gain}{_time(event)})", seat)

    def _standing(self, seat: str, score: Mapping[str, Score]) -> str:
        """Return ``Hanse 2 : 1``, a team's own points first; among more than two teams only these."""
        others = [score.get(team, 0) for other, team in self._teams.items() if other != seat]
        against = f" : {number_words(others[0])}" if len(others) == 1 else ""
        return f"{self._names[seat]} {number_words(score.get(self._teams[seat], 0))}{against}"


def _sentence(event: TimelineEvent) -> Remark:
    says = "" if event.cause is None else event.cause.says
    values = extra_payload_text(event.name, event.payload, says)
    return Remark(f"{_time(event):>7}  {sanitize(' · '.join(filter(None, (says or _name(event), values))), 300)}")


def _name(event: TimelineEvent) -> str:
    return sanitize(event.name.replace("_", " "), 40)


def _time(event: TimelineEvent) -> str:
    return clock(s_from_ticks(event.tick))
