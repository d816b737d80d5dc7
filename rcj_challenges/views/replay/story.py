"""What happened, for the page: events with what the referee measured, the score as it went, phases, who is held.

Points that a rule gives without announcing an event stand among the events, as ``POINTS``: who watches the score change
asks for what.
"""

from __future__ import annotations

import json
import re
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from rcj_challenges.facts.amounts import Score, round_score
from rcj_challenges.facts.measures import number_words
from rcj_challenges.facts.play import Fault
from rcj_challenges.records.referee_log import events_as_lines, read_referee_log
from rcj_challenges.records.reflog import PROGRAM_FAULT
from rcj_challenges.records.result import RunResult
from rcj_challenges.records.trajectory import HalfTrack
from rcj_challenges.rules.actions.emit import Emit
from rcj_challenges.rules.base import Trigger
from rcj_challenges.rules.phrasing import quoted
from rcj_challenges.rules.triggers import TRIGGERS
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.views.naming import changes_sides, told_apart
from rcj_challenges.views.palette import shown_colour
from rcj_challenges.views.payloads import told_beside
from rcj_challenges.views.standing import Counting

_QUIET = ("MATCH_START", "MATCH_FINISH", "KICKOFF")
_LONGEST_TEXT = 2_000
_MOST_CHANGES = 2_000
"""Of what is counted in a half, so many changes are on the page: about 40 bytes each."""
MOST_UNANNOUNCED = 300
"""Of points without an event a page lists so many of each rule and half: one that pays on every tick would fill it."""
_POINTS = "POINTS"

_UNITS = {
    word.name(): unit[1] if (unit := re.search(r" in (m|s|rad)\b", word.MEASURED)) else ""
    for word in TRIGGERS.words()
    if issubclass(word, Trigger)
}
"""The unit of what a trigger measures, by its word."""
_WHERE = re.compile(r'File "(?:[^"]*[/\\])?([^"/\\]+)", line (\d+)')


@dataclass
class Story:
    """All halves of a run, told.

    Attributes:
        events: in order, as the page shows them.
        phases: by half, ``[tick, phase, waiting for kick-off]`` from each change on.
        held: by half, ``[tick, robots that rules hold]`` from each change on.
        score_changes: by half, ``[tick, points by team]`` from each change on.
        counted: by half, ``[tick, values by team]`` of the counters that decide the ranking, from each change on.
        unannounced: by half and rule, how many points without an event are among the events.
        unreadable: how many lines of the log were damaged.
    """

    events: list[dict[str, Any]] = field(default_factory=list)
    phases: dict[int, list[list[Any]]] = field(default_factory=dict)
    held: dict[int, list[list[Any]]] = field(default_factory=dict)
    score_changes: dict[int, list[list[Any]]] = field(default_factory=dict)
    counted: dict[int, list[list[Any]]] = field(default_factory=dict)
    unannounced: Counter[tuple[int, str]] = field(default_factory=Counter)
    unreadable: int = 0


def tell(folder: Path, scenario: Scenario, halves: Sequence[HalfTrack], result: RunResult | None) -> Story:
    """Return the story of a run from the referee's log, as far as it can be read; also without a readable result."""
    lines, unreadable = read_referee_log(folder)
    story = Story(unreadable=unreadable)
    if not lines and result is not None:
        lines = events_as_lines(result)
    firings = [line for line in lines if line["kind"] == "firing" and line.get("suppressed") is None]
    counting = Counting(scenario)
    for half in halves:
        counted = [line for line in lines if line["kind"] == "counted" and line["half"] == half.info.half]
        story.counted[half.info.half] = _follow_the_counters(counting, half, counted)
        _follow_the_score(story, half, [line for line in firings if line["half"] == half.info.half])
        story.phases[half.info.half] = [
            [line["tick"], line["phase"], line["waiting_for_kickoff"]]
            for line in lines
            if line["kind"] == "phase" and line["half"] == half.info.half
        ]
        story.held[half.info.half] = [
            [line["tick"], line["robots"]]
            for line in lines
            if line["kind"] == "held" and line["half"] == half.info.half
        ]
    names = told_apart(_names(halves, result), sides_change=changes_sides(scenario))
    told = Teller(scenario, {half.info.half: half.info.teams for half in halves}, firings, story, names)
    faults = {(half.info.half, tick): faults for half in halves for tick, faults in half.faults.items()}
    events = [
        told.event(line, faults.get((line["half"], line["tick"]), ())) for line in lines if line["kind"] == "event"
    ]
    story.events = sorted([*events, *told.unannounced()], key=lambda event: (event["half"], event["tick"]))
    return story


def _names(halves: Sequence[HalfTrack], result: RunResult | None) -> dict[str, str]:
    """Return what teams call themselves, of those that have a name."""
    if result is not None:
        return {team: entrant.name for team, entrant in result.entrants.items() if entrant.name}
    first = halves[0].info
    return {first.teams[seat]: name for seat, name in first.team_names.items() if name}


def _follow_the_score(story: Story, half: HalfTrack, firings: list[dict[str, Any]]) -> None:
    teams = half.info.teams
    scores = {teams[seat]: points for seat, points in half.info.scores.items()}
    changes = []
    for firing in firings:
        if firing["scored"]:
            for seat, points in firing["scored"].items():
                if teams.get(seat) in scores:
                    scores[teams[seat]] = round_score(scores[teams[seat]] + points)
            changes.append([firing["tick"], dict(scores)])
    story.score_changes[half.info.half] = changes


def _follow_the_counters(counting: Counting, half: HalfTrack, lines: list[dict[str, Any]]) -> list[list[Any]]:
    counting.begin(half.info)
    found = [[line["tick"], counting.at(line["counters"])] for line in lines]
    changes = [change for change in found if change[1] is not None]
    if len(changes) <= _MOST_CHANGES:
        return changes
    # One that counts on every tick would fill the page: of each stretch of it only the last is kept.
    stretch = half.ticks // _MOST_CHANGES + 1
    return list({tick // stretch: [tick, values] for tick, values in changes}.values())


class Teller:
    """Joins events with the firings of the rules that emitted them.

    Args:
        scenario: whose rules fired.
        teams: by half, by seat: who played there.
        firings: lines of the referee's log whose actions ran.
        story: its score as it went is what events are told with.
        names: what teams are called, by the seats that they had in the first half; left out: as the scenario says.
    """

    def __init__(
        self,
        scenario: Scenario,
        teams: Mapping[int, Mapping[str, str]],
        firings: list[dict[str, Any]],
        story: Story,
        names: Mapping[str, str] | None = None,
    ) -> None:
        self._rules = scenario.rules
        self._entities = {*scenario.robots, *scenario.balls, *scenario.obstacles}
        self._names = {seat: entrant.title or seat for seat, entrant in scenario.entrants.items()} | dict(names or {})
        self._emitted = {
            rule: [action.event for action in definition.actions if isinstance(action, Emit)]
            for rule, definition in scenario.rules.items()
        }
        # One place for each event that a firing emits, in order; an event takes the first that fits it.
        self._open: dict[tuple[int, int, str], list[dict[str, Any]]] = {}
        for firing in firings:
            for event in self._emitted.get(firing["rule"], ()):
                self._open.setdefault((firing["half"], firing["tick"], event), []).append(firing)
        self._story = story
        paid = (one for one in firings if any((one["scored"] or {}).values()))
        self._silent = [one for one in paid if not self._emitted.get(one["rule"])]
        self._seats = teams
        # The scoreboard's order: as they stood in the first half.
        self._teams = list(teams[min(teams)].values()) if teams else []
        self._colours = {
            seat: shown_colour(scenario.robots[next(iter(entrant.robots))].colour)
            for seat, entrant in scenario.entrants.items()
            if next(iter(entrant.robots), None) in scenario.robots
        }

    def event(self, line: Mapping[str, Any], faults: Sequence[Fault] = ()) -> dict[str, Any]:
        """Return an event as the page shows it.

        Args:
            line: of the referee's log.
            faults: of the programs that failed on its tick.
        """
        half, tick, name = line["half"], line["tick"], line["event"]
        waiting = self._open.get((half, tick, name))
        firing = waiting.pop(0) if waiting else {}
        scored: Mapping[str, Score] = firing.get("scored") or {}
        seat = _whose(scored)
        team = self._seats.get(half, {}).get(seat, seat)
        standing = self._standing(half, tick) if scored else ""
        trigger = firing.get("trigger", "")
        payload = line["payload"] if isinstance(line["payload"], dict) else {"payload": line["payload"]}
        says, reason = _short(firing.get("says") or ""), self._reason(firing)
        about = reason if reason and self._leaves_open(firing) else says
        beside = [reason if about != reason else "", told_beside(name, payload, says)]
        fault = next((one for one in faults if name == PROGRAM_FAULT and one.robot == payload.get("robot_name")), None)
        if fault is not None:  # it is said when the program failed; the referee heard of it a tick later
            tick = fault.tick
            about, says, beside = fault_sentence(fault), _short(fault.traceback or fault.detail), []
        told = _short(" · ".join(filter(None, beside)), 300)
        head = " ".join(filter(None, (name.replace("_", " "), self._names.get(team, ""), standing)))
        caption = " · ".join(filter(None, (about, told)))
        return {
            "half": half,
            "tick": tick,
            "name": name,
            "kind": _kind(name, scored),
            "scored": bool(scored),
            "team": team,
            "colour": self._colours.get(seat),
            "standing": standing,
            "about": _short(about or told, 300),
            "told": told if about else "",
            "caption": _short(f"{head}: {caption}" if caption else head, 200),
            "says": says,
            "rule": firing.get("rule", ""),
            "trigger": trigger,
            "measured": _rounded(firing.get("measured")),
            "limit": _rounded(firing.get("limit")),
            "unit": _UNITS.get(trigger, ""),
            "payload": [[key, _short(value)] for key, value in payload.items()],
        }

    def _leaves_open(self, firing: Mapping[str, Any]) -> bool:
        """Return whether a rule has several triggers, so that its sentence does not say which one it was."""
        rule = self._rules.get(firing.get("rule", ""))
        return rule is not None and len(rule.triggers) > 1

    def _reason(self, firing: Mapping[str, Any]) -> str:
        """Return why a rule fired: ``Y1 made no progress: 0.497 m in 15 s, at least 0.5``; empty if no word says it."""
        rule = self._rules.get(firing.get("rule", ""))
        fired = [] if rule is None else [one for one in rule.triggers if one.name() == firing.get("trigger")]
        if len(fired) != 1 or not fired[0].REASON or (firing.get("measured") is None and fired[0].LIMIT):
            return ""
        fields = {key: quoted(value) if isinstance(value, str) else value for key, value in fired[0]}
        numbers = {key: number_words(firing[key], 3) for key in ("measured", "limit") if firing.get(key) is not None}
        reason = fired[0].REASON.format(**{**fields, **numbers})
        entity = firing.get("entity") or getattr(fired[0], "entity", "")
        reason = f"{entity} {reason}" if entity in self._entities else reason
        return reason[0].upper() + reason[1:]

    def unannounced(self) -> Iterator[dict[str, Any]]:
        """Yield the points that rules gave without an event, as the page shows them, in order."""
        for firing in self._silent:
            half, rule = firing["half"], firing["rule"]
            if self._story.unannounced[half, rule] == MOST_UNANNOUNCED:
                continue
            self._story.unannounced[half, rule] += 1
            seats = self._seats.get(half, {})
            teams = {seats.get(seat, seat): number for seat, number in firing["scored"].items() if number}
            points = {self._names.get(team, team): f"{number:+g}" for team, number in teams.items()}
            self._open[half, firing["tick"], _POINTS] = [firing]
            yield self.event({**firing, "event": _POINTS, "payload": points})

    def _standing(self, half: int, tick: int) -> str:
        """Return the score after a tick, ``2 : 1`` in the order of the scoreboard."""
        scores: Mapping[str, Score] = {}
        for at, standing in self._story.score_changes.get(half, ()):
            if at <= tick:
                scores = standing
        return " : ".join(number_words(scores.get(team, 0)) for team in self._teams)


def _whose(scored: Mapping[str, Score]) -> str:
    """Return the seat in whose colour a change of the score is shown: who gained, or else who lost points."""
    gained = (seat for seat, points in scored.items() if points > 0)
    return next(gained, next(iter(scored), ""))


def fault_sentence(fault: Fault) -> str:
    """Return ``Y1 crashed at robot.py:7: ZeroDivisionError: division by zero``."""
    where = _WHERE.findall(fault.traceback)
    at = f" at {where[-1][0]}:{where[-1][1]}" if where else ""
    what = "crashed" if fault.kind == "crash" else f"failed ({fault.kind.replace('_', ' ')})"
    return f"{fault.robot} {what}{at}: {fault.detail}"


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


def _rounded(value: Any) -> float | int | None:
    return round(value, 4) if isinstance(value, int | float) else None
