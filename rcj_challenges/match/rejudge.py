"""Judges a recorded match again: its poses, by its own rules or by others, without physics and programs."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from rcj_challenges.core.errors import RcjError
from rcj_challenges.core.grouping import grouped
from rcj_challenges.core.play import Event, HalfInfo
from rcj_challenges.core.timing import s_from_ticks, ticks_from_s
from rcj_challenges.match.codes import RECORD_DOES_NOT_FIT
from rcj_challenges.match.loop import should_continue
from rcj_challenges.records.lines import json_line
from rcj_challenges.records.referee_log import RefereeLog
from rcj_challenges.records.reflog import event_line, events_of
from rcj_challenges.records.trajectory import HalfTrack, Trajectory
from rcj_challenges.referee.carry_over import CarryOver
from rcj_challenges.referee.engine import Referee
from rcj_challenges.scenario.halves import by_seat, half_length_s, in_half
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.roster import Roster

Score = int | float


@dataclass(frozen=True)
class JudgedHalf:
    """One half, as far as it could be judged: not complete if the recorded poses end before these rules end it."""

    half: int
    ticks: int
    ended: str | None
    complete: bool


@dataclass(frozen=True)
class Judgement:
    """The verdict of the rules on a match, as in ``result.json``; complete if all halves were judged to their end."""

    scores: dict[str, Score]
    ranking: list[dict[str, Any]]
    events: list[dict[str, Any]]
    halves: tuple[JudgedHalf, ...]
    complete: bool


@dataclass(frozen=True)
class Difference:
    """An event in which two judgements differ, with its payload in both; None where there is no such event."""

    half: int
    tick: int
    event: str
    before: dict[str, Any] | None
    after: dict[str, Any] | None

    def as_json(self) -> dict[str, Any]:
        """Return it as JSON data, with the match time in s."""
        return {
            "half": self.half,
            "tick": self.tick,
            "matchtime": s_from_ticks(self.tick),
            "event": self.event,
            "recorded": self.before,
            "judged": self.after,
        }


def rejudge(trajectory: Trajectory, scenario: Scenario) -> Judgement:
    """Judge a recorded match by the rules of a scenario; scores and what is kept pass from half to half by these.

    The poses stay those that were recorded: placements of these rules have no effect on them.

    Raises:
        RcjError: match and scenario have different participants.
    """
    roster = Roster.of(scenario)
    _must_fit(trajectory, scenario, roster)
    carry_over = CarryOver(scenario)
    events: list[dict[str, Any]] = []
    halves: list[JudgedHalf] = []
    over = False
    for track in trajectory.halves[: scenario.match.halves]:
        if track.start is None or over:
            break
        info = _info(track.info, scenario, carry_over)
        referee = Referee(in_half(scenario, info.half), roster, info)
        half, judged, over = _judge_half(track, referee, info)
        halves.append(half)
        # As JSON they can be compared with those of a record.
        events += [json.loads(json_line(event_line(info.half, event))) for event in judged]
        carry_over.add(info, referee)
    all_there = over or len(halves) == scenario.match.halves
    complete = all_there and all(half.complete for half in halves)
    return Judgement(carry_over.scores, carry_over.ranking(), events, tuple(halves), complete)


def recorded(
    trajectory: Trajectory, log: RefereeLog, scores: Mapping[str, Score]
) -> tuple[dict[str, Score], list[dict[str, Any]]]:
    """Return points by team and events, as in ``result.json``, to be compared with a judgement.

    Of a match that was killed, or is still played, poses are written later than the referee's log, and the score when
    a half is over: events and score are taken from the log, up to the last pose. ``scores`` are those in the result.
    """
    points = dict(scores)
    if not trajectory.finished:
        halves = {track.info.half: track for track in trajectory.halves}
        log = log.up_to({half: track.ticks for half, track in halves.items()})
        points = log.score(dict.fromkeys(scores, 0), lambda half: halves[half].info.teams)
    return points, [event_line(one.half, event) for one in log.ticks for event in one.events]


def differences(before: Sequence[Mapping[str, Any]], after: Sequence[Mapping[str, Any]]) -> list[Difference]:
    """Return the events, as in ``result.json``, that are only in one list, or have different payloads, by time."""
    found: list[Difference] = []
    first, second = _by_moment(before), _by_moment(after)
    for half, tick, name in first | second:
        old, new = first.get((half, tick, name), []), second.get((half, tick, name), [])
        for payload in list(old):
            if payload in new:
                old.remove(payload)
                new.remove(payload)
        for place in range(max(len(old), len(new))):
            pair = [many[place] if place < len(many) else None for many in (old, new)]
            found.append(Difference(half, tick, name, *pair))
    return sorted(found, key=lambda one: (one.half, one.tick))


def _by_moment(events: Iterable[Mapping[str, Any]]) -> dict[tuple[int, int, str], list[dict[str, Any]]]:
    return grouped(((event["half"], event["tick"], event["event"]), event["payload"]) for event in events)


def _must_fit(trajectory: Trajectory, scenario: Scenario, roster: Roster) -> None:
    """Compare the participants.

    Raises:
        RcjError: scenario and match have different ones.
    """
    seats = set(scenario.entrants)
    there = (trajectory.entities, trajectory.robots, trajectory.balls, trajectory.things)
    if there != (roster.entities, roster.robots, roster.balls, roster.things):
        what = "robots, balls and obstacles, in their order,"
        raise _misfit(scenario, what, trajectory.things, roster.things)
    played = {seat for track in trajectory.halves for seat in track.info.teams}
    if played and played != seats:
        raise _misfit(scenario, "the entrants", sorted(played), sorted(seats))


def _misfit(scenario: Scenario, what: str, played: Sequence[str], wanted: Sequence[str]) -> RcjError:
    lists = f"the match had {', '.join(played)}, the scenario has {', '.join(wanted)}"
    differ = lists if set(played) != set(wanted) else f"their order differs: {lists}"
    message = f"the scenario {scenario.id!r} cannot judge this match: {what} must be the same; {differ}"
    return RcjError(message, "judge it by the scenario that was played, or one like it", code=RECORD_DOES_NOT_FIT)


def _info(recorded: HalfInfo, scenario: Scenario, carry_over: CarryOver) -> HalfInfo:
    """Return the facts of a half for these rules: the recorded seats, with scores and kept values by these rules."""
    return replace(
        recorded,
        halves=scenario.match.halves,
        ticks=ticks_from_s(half_length_s(scenario.match, recorded.half)),
        scores=by_seat(carry_over.scores, recorded.teams),
        kept=dict(carry_over.kept),
    )


def _judge_half(track: HalfTrack, referee: Referee, info: HalfInfo) -> tuple[JudgedHalf, list[Event], bool]:
    """Judge a half; return its judgement, its events, and whether it ends the match."""
    assert track.start is not None  # noqa: S101 - the caller has looked
    output = referee.start(track.start)
    events = list(events_of(track.start, output))
    tick = 0
    for snapshot in track.snapshots():
        if not should_continue(referee, output, tick, info):
            break
        output = referee.judge(snapshot)
        events += events_of(snapshot, output)
        tick = snapshot.tick
    if should_continue(referee, output, tick, info):
        return JudgedHalf(info.half, tick, None, complete=False), events, False
    closing = referee.finish()
    events += closing.events
    ended = closing.ended if closing.ends_match else output.ended
    return JudgedHalf(info.half, tick, ended, complete=True), events, closing.ends_match
