"""What happens in a match, in sentences for people: the rules' own, and the score when it changes."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass

from rcj_challenges.facts.amounts import Score, round_score
from rcj_challenges.facts.measures import number_words
from rcj_challenges.facts.play import Event, Firing, HalfInfo, RefereeOutput
from rcj_challenges.facts.sanitize import sanitize
from rcj_challenges.facts.timing import s_from_ticks
from rcj_challenges.rules.actions.emit import Emit
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.views.naming import told_apart
from rcj_challenges.views.payloads import told_beside
from rcj_challenges.views.sentences import clock

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
        self._emitted = {
            name: [action.event for action in rule.actions if isinstance(action, Emit)]
            for name, rule in scenario.rules.items()
        }
        self.colours = {
            seat: scenario.robots[robot].colour
            for seat, entrant in scenario.entrants.items()
            for robot in list(entrant.robots)[:1]
            if robot in scenario.robots
        }
        self._scores: dict[str, Score] = {}
        self._names: dict[str, str] = {}
        self._unannounced: Counter[str] = Counter()

    def begin(self, half: HalfInfo) -> None:
        """Begin a half."""
        self._scores = dict(half.scores)
        self._unannounced.clear()
        self._names = told_apart({seat: sanitize(name, 32) for seat, name in half.team_names.items()})

    def remarks(self, output: RefereeOutput) -> Iterator[Remark]:
        """Yield what there is to say about one output: its events, then points that were given without one."""
        ran = [firing for firing in output.firings if firing.suppressed is None]
        waiting: dict[str, list[Firing]] = {}
        for firing in ran:
            for name in self._emitted.get(firing.rule, ()):
                waiting.setdefault(name, []).append(firing)
        told: list[Firing] = []
        for event in output.events:
            firings = waiting.get(event.name)
            cause = firings.pop(0) if firings else None
            # The score changes once, also by a rule that emits several events.
            scored = {} if cause is None or any(cause is one for one in told) else _points(cause)
            told += [] if cause is None else [cause]
            yield self._score(event, scored) if scored else _sentence(event, "" if cause is None else cause.says)
        for firing in ran:
            if _points(firing) and not self._emitted.get(firing.rule):
                remark = self._score(Event(firing.tick, "POINTS"), _points(firing))
                self._unannounced[firing.rule] += 1
                if self._unannounced[firing.rule] <= _MAX_UNANNOUNCED:
                    yield remark

    def _score(self, event: Event, scored: dict[str, Score]) -> Remark:
        for seat, points in scored.items():
            self._scores[seat] = round_score(self._scores[seat] + points)
        seat = max(scored, key=lambda one: scored[one])  # who gained, else who lost
        gain = "" if scored[seat] == 1 else f"{scored[seat]:+g}, "
        return Remark(f"{_name(event)}  {self._standing(seat)}  ({seat}, {gain}{_time(event)})", seat)

    def _standing(self, seat: str) -> str:
        """Return ``Hanse 2 : 1``, a team's own points first; among more than two teams only these."""
        others = [points for other, points in self._scores.items() if other != seat]
        against = f" : {number_words(others[0])}" if len(others) == 1 else ""
        return f"{self._names[seat]} {number_words(self._scores[seat])}{against}"


def _points(firing: Firing) -> dict[str, Score]:
    return {seat: points for seat, points in firing.scored.items() if points}


def _sentence(event: Event, says: str) -> Remark:
    told = told_beside(event.name, event.payload, says)
    return Remark(f"{_time(event):>7}  {sanitize(' · '.join(filter(None, (says or _name(event), told))), 300)}")


def _name(event: Event) -> str:
    return sanitize(event.name.replace("_", " "), 40)


def _time(event: Event) -> str:
    return clock(s_from_ticks(event.tick))
