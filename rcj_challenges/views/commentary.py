"""A match as remarks for people: sentences of the rules, and the score when it changes."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from rcj_challenges.core.amounts import Score
from rcj_challenges.core.play import HalfInfo, RefereeOutput
from rcj_challenges.core.sanitize import sanitize
from rcj_challenges.core.timing import s_from_ticks
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.views.naming import score_so_far, seat_colours, shown_names, team_names
from rcj_challenges.views.payloads import extra_payload_text
from rcj_challenges.views.sentences import Reasons, clock
from rcj_challenges.views.timeline import TimelineBuilder, TimelineEvent

_MAX_UNANNOUNCED = 20
"""Points without an event, of each rule and half: one that pays on every tick would leave no room for anything else."""


@dataclass(frozen=True, slots=True)
class Remark:
    """One line of a commentary, safe in a terminal; ``seat``: whose score changed, empty if none did."""

    text: str
    seat: str = ""


class Commentator:
    """Turns outputs into remarks; ``colours``: by seat, that of its first robot, a CSS name."""

    def __init__(self, scenario: Scenario) -> None:
        self._builder = TimelineBuilder(scenario, _MAX_UNANNOUNCED)
        self.colours = seat_colours(scenario)
        self._reasons = Reasons(scenario)
        self._half: HalfInfo

    def begin(self, half: HalfInfo) -> None:
        """Begin a half."""
        self._builder.begin_half(half)
        self._half = half

    def remarks(self, output: RefereeOutput) -> Iterator[Remark]:
        """Yield the remarks about an output: its events, then points that were given without one."""
        for event in self._builder.add(output.events, output.firings, output.changes)[0]:
            scored = {seat: points for seat, points in event.scored.items() if points}
            # The score changes once, also by a rule that emits several events.
            yield self._score(event, scored) if scored and event.is_first else self._sentence(event)

    def _score(self, event: TimelineEvent, scored: Mapping[str, Score]) -> Remark:
        seat = max(scored, key=lambda one: scored[one])  # the seat that gained, else the one that lost
        gain = "" if scored[seat] == 1 else f"{scored[seat]:+g}, "
        teams = self._half.teams
        score = score_so_far(self._half, {place: event.score.get(team, 0) for place, team in teams.items()})
        name = shown_names(team_names(self._half), sides_change=seat != teams[seat])[teams[seat]]
        return Remark(f"{_name(event)}  {score}  ({name}, {gain}{_time(event)})", seat)

    def _sentence(self, event: TimelineEvent) -> Remark:
        about = self._reasons.about(event.cause) or _name(event)
        values = extra_payload_text(event.name, event.payload, "" if event.cause is None else event.cause.says)
        return Remark(f"{_time(event):>7}  {sanitize(' · '.join(filter(None, (about, values))), 300)}")


def _name(event: TimelineEvent) -> str:
    return sanitize(event.name.replace("_", " "), 40)


def _time(event: TimelineEvent) -> str:
    return clock(s_from_ticks(event.tick))
