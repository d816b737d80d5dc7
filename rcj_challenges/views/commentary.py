"""What happens in a match, in sentences for people: the rules' own, and the score when it changes."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from rcj_challenges.facts.amounts import Score, on_paper
from rcj_challenges.facts.measures import number_words
from rcj_challenges.facts.play import Event, Firing, HalfInfo, Verdict
from rcj_challenges.facts.shown import shown
from rcj_challenges.facts.timing import s_from_ticks
from rcj_challenges.scenario.models.actions import Emit
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.views.naming import told_apart
from rcj_challenges.views.payloads import told_beside
from rcj_challenges.views.sentences import clock


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
    """Turns verdicts into remarks.

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

    def begin(self, half: HalfInfo) -> None:
        """Begin a half."""
        self._scores = dict(half.scores)
        self._names = told_apart({seat: shown(name, 32) for seat, name in half.team_names.items()})

    def remarks(self, verdict: Verdict) -> Iterator[Remark]:
        """Yield what there is to say about one verdict: its events, then points that were given without one."""
        ran = [firing for firing in verdict.firings if firing.suppressed is None]
        waiting: dict[str, list[Firing]] = {}
        for firing in ran:
            for name in self._emitted.get(firing.rule, ()):
                waiting.setdefault(name, []).append(firing)
        for event in verdict.events:
            firings = waiting.get(event.name)
            yield self._remark(event, firings.pop(0) if firings else None)
        for firing in ran:
            if any(firing.scored.values()) and not self._emitted.get(firing.rule):
                yield self._remark(Event(firing.tick, "POINTS"), firing)

    def _remark(self, event: Event, firing: Firing | None) -> Remark:
        at, name = clock(s_from_ticks(event.tick)), shown(event.name.replace("_", " "), 40)
        scored = {} if firing is None else {seat: points for seat, points in firing.scored.items() if points}
        says = "" if firing is None else firing.says
        if scored:
            for seat, points in scored.items():
                self._scores[seat] = on_paper(self._scores[seat] + points)
            seat = max(scored, key=lambda one: scored[one])  # who gained, else who lost
            gain = "" if scored[seat] == 1 else f"{scored[seat]:+g}, "
            return Remark(f"{name}  {self._standing(seat)}  ({seat}, {gain}{at})", seat)
        told = told_beside(event.name, event.payload, says)
        return Remark(f"{at:>7}  {shown(' · '.join(filter(None, (says or name, told))), 300)}")

    def _standing(self, seat: str) -> str:
        """Return ``Hanse 2 : 1``, a team's own points first; among more than two teams only these."""
        others = [points for other, points in self._scores.items() if other != seat]
        against = f" : {number_words(others[0])}" if len(others) == 1 else ""
        return f"{self._names[seat]} {number_words(self._scores[seat])}{against}"
