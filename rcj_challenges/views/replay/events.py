"""The timeline as the page has it: events with captions and what the referee measured, and lists of changes as JSON."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Iterable, Mapping
from typing import Any

from rcj_challenges.core.amounts import Score, distinct_decimals, number_words
from rcj_challenges.core.play import Fault
from rcj_challenges.records.reflog import PROGRAM_FAULT
from rcj_challenges.rules.base import Trigger
from rcj_challenges.rules.triggers import TRIGGERS
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.views.naming import seat_colours
from rcj_challenges.views.palette import css_colour
from rcj_challenges.views.payloads import extra_payload_text
from rcj_challenges.views.replay.packing import Jumps
from rcj_challenges.views.replay.things import bodies_in
from rcj_challenges.views.sentences import Reasons, event_title, fault_sentence
from rcj_challenges.views.timeline import POINTS, HalfTimeline, Timeline, TimelineEvent

_QUIET = ("MATCH_START", "MATCH_FINISH", "KICKOFF")
_LONGEST_TEXT, _LONGEST_DETAIL = 2_000, 10_000
_MAX_CHANGES = 2_000
"""Of what is counted in a half, so many changes are on the page: about 40 bytes each."""

_UNITS = {
    word.name(): unit[1] if (unit := re.search(r" in (m|s|rad)\b", word.MEASURED)) else ""
    for word in TRIGGERS.words()
    if issubclass(word, Trigger)
}
"""The unit of what a trigger measures, by its word."""


def half_facts(
    scenario: Scenario, half: HalfTimeline, ticks: int = 0, jumps: Jumps = (), faults: Iterable[Fault] = ()
) -> dict[str, Any]:
    """Return a half as the page has it: what changes as a list for each thing, ``[tick, value]`` in order."""
    # A rule that counts in each tick would fill the page: of each stretch only the last value is kept.
    info, counted = half.info, half.changes["counted"]
    stretch = 1 if len(counted) <= _MAX_CHANGES else ticks // _MAX_CHANGES + 1
    return {
        "half": info.half,
        "ticks": ticks,
        "planned_ticks": info.ticks,
        "sides": dict(info.teams),
        "scores": {info.teams[seat]: points for seat, points in info.scores.items()},
        **half.changes,
        "counted": list({row[0] // stretch: row for row in counted}.values()),
        "jumps": [list(each) for each in jumps],
        "faults": fault_facts(faults),
        "bodies": bodies_in(scenario, info.half),
    }


def fault_facts(faults: Iterable[Fault]) -> list[dict[str, Any]]:
    """Return failures of programs: as detail the traceback, which ends with the error, or else one line."""
    return [
        {
            "robot": fault.robot,
            "tick": fault.tick,
            "kind": fault.kind,
            "detail": (fault.traceback.rstrip() or fault.detail)[-_LONGEST_DETAIL:],
        }
        for fault in faults
    ]


class EventFacts:
    """Converts events of a timeline to the data of the page; names are by the seats of the first half."""

    def __init__(self, scenario: Scenario, names: Mapping[str, str]) -> None:
        self._halves, self._period = scenario.match.halves, scenario.match.period
        self._reasons = Reasons(scenario)
        self._seats = tuple(scenario.entrants)
        self._names = {seat: entrant.title or seat for seat, entrant in scenario.entrants.items()} | dict(names)
        self._colours = {seat: css_colour(colour) for seat, colour in seat_colours(scenario).items()}

    def of_timeline(self, timeline: Timeline) -> list[dict[str, Any]]:
        """Return all events of a run, in the order of time."""
        events = (self.event(event, timeline.halves[event.half].info.teams) for event in timeline.events)
        return sorted(events, key=lambda event: (event["half"], event["tick"]))

    def event(self, event: TimelineEvent, teams: Mapping[str, str]) -> dict[str, Any]:
        """Return an event; ``teams`` are those of its half by seat."""
        name, cause, fault, scored = event.name, event.cause, event.fault, event.scored
        # The seat that gained points, or else one that lost some.
        seat = next((seat for seat, points in scored.items() if points > 0), next(iter(scored), ""))
        team = teams.get(seat, seat)
        standing = " : ".join(number_words(event.score.get(team, 0)) for team in self._seats) if scored else ""
        trigger = cause.trigger if cause is not None else ""
        measured, limit = (None, None) if cause is None else (cause.measured, cause.limit)
        decimals = distinct_decimals(measured, limit, 4)
        payload = self._points(event, teams) if name == POINTS and cause is not None else event.payload
        says, reason = _short(cause.says if cause is not None else ""), self._reasons.reason(cause)
        about = _short(self._reasons.about(cause))
        beside = [reason if about != reason else "", extra_payload_text(name, payload, says)]
        if fault is not None:
            about, says, beside = fault_sentence(fault), _short(fault.traceback or fault.detail), []
        more = _short(" · ".join(filter(None, beside)), 300)
        title = event_title(name, event.half, self._halves, self._period)
        head = " ".join(filter(None, (title, self._names.get(team, ""), standing)))
        caption = " · ".join(filter(None, (about, more)))
        return {
            "half": event.half,
            "tick": event.tick,
            "name": name,
            "title": title,
            "kind": _kind(name, scored),
            "scored": bool(scored),
            "team": team,
            "colour": self._colours.get(seat),
            "standing": standing,
            "about": _short(about or more, 300),
            "payload_text": more if about else "",
            "caption": _short(f"{head}: {caption}" if caption else head, 200),
            "says": says,
            "rule": cause.rule.removesuffix(f"_{cause.copy}") if cause is not None else "",
            "copy": cause.copy if cause is not None else "",
            "trigger": trigger,
            "measured": _rounded(measured, decimals),
            "limit": _rounded(limit, decimals),
            "unit": _UNITS.get(trigger, ""),
            "payload": [[key, _short(value)] for key, value in payload.items()],
        }

    def _points(self, event: TimelineEvent, teams: Mapping[str, str]) -> dict[str, str]:
        by_team = {teams.get(seat, seat): points for seat, points in event.scored.items() if points}
        return {self._names.get(team, team): f"{points:+g}" for team, points in by_team.items()}


def _kind(name: str, scored: Mapping[str, Score]) -> str:
    if any(points > 0 for points in scored.values()):
        return "goal"
    if any(scored.values()):
        return "loss"
    if name == PROGRAM_FAULT:
        return "fault"
    return "start" if name in _QUIET else "call"


def _short(value: Any, longest: int = _LONGEST_TEXT) -> str:
    text = value if isinstance(value, str) else json.dumps(value, ensure_ascii=False)
    return text if len(text) <= longest else text[: longest - 1] + "…"


def _rounded(value: float | None, decimals: int) -> float | None:
    return None if value is None or not math.isfinite(value) else round(value, decimals)
