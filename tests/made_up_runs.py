"""Makes records without a match: invented play for tests of modules that read records."""

from __future__ import annotations

import json
import math
import struct
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import lru_cache
from pathlib import Path

from rcj_challenges.core.amounts import Score, round_score
from rcj_challenges.core.changes import ChangeTracker
from rcj_challenges.core.play import Event, Fault, Firing, HalfInfo, Placement, Pose2, RefereeOutput, Snapshot
from rcj_challenges.core.timing import TICK_S
from rcj_challenges.records.writer import RecordWriter, RunHeader
from rcj_challenges.scenario.halves import teams_by_seat
from rcj_challenges.scenario.models.scenario import Scenario

GOAL_EVERY_TICKS = 400
_HELD, _HELD_IN_TICKS, _NOBODY = frozenset({0}), (200, 260), frozenset[int]()
_SEATS = ("blue", "yellow")


def small_scenario(robots_per_team: int = 3, halves: int = 2, half_s: float = 600.0) -> Scenario:
    """Return a scenario of two teams with a goal each, a penalty area, a spot, a gate and an obstacle."""
    robots = {
        f"{seat[0].upper()}{number}": {
            "colour": seat,
            "number": number,
            "kit": "v2",
            "start": {"x_m": 0.3 * (number - 2), "y_m": 0.3 * side, "yaw_rad": -1.57 * side},
        }
        for seat, side in zip(_SEATS, (1, -1), strict=True)
        for number in range(1, robots_per_team + 1)
    }
    goals = {
        f"{seat}_goal": {"end": end, "colour": colour}
        for seat, end, colour in zip(_SEATS, ("positive_y", "negative_y"), ("#2563eb", "#eab308"), strict=True)
    }
    fields = {
        "schema_version": 2,
        "id": "small",
        "title": "A small match",
        "match": {"halves": halves, "half_s": half_s, "swap_sides": True},
        "field": {"goals": goals},
        "balls": {"ball": {}},
        "obstacles": {"post": {"shape": "cylinder", "radius_m": 0.02, "centre_m": [0.5, 0.0]}},
        "kits": {"v2": {}},
        "robots": robots,
        "entrants": {
            seat: {
                "robots": {name: "robot.py" for name, robot in robots.items() if robot["colour"] == seat},
                "radio_channel": channel,
            }
            for channel, seat in enumerate(_SEATS, start=1)
        },
        "zones": {
            "blue_goal": {
                "shape": "rect", "x_min_m": -0.2, "x_max_m": 0.2, "y_min_m": 0.745, "y_max_m": 0.849,
            },
            "penalty_area": {"shape": "rect", "x_min_m": -0.35, "x_max_m": 0.35, "y_min_m": 0.59, "drawn": True},
            "middle": {"shape": "circle", "centre_m": [0, 0], "radius_m": 0.2},
        },
        "gates": {"half_way": {"from_m": [-0.65, 0], "to_m": [0.65, 0]}},
        "spots": {"centre": {"x_m": 0, "y_m": 0}},
        "phases": {"play": {}, "goal_pause": {"lasts_s": 3, "robots": "held"}},
        "rules": {
            "goal": {
                "triggers": [{"trigger": "enters", "entity": "ball", "zone": "blue_goal"}],
                "actions": [
                    {"action": "score", "entrant": "yellow", "points": 1},
                    {"action": "emit", "event": "GOAL", "payload": {"team_name": "yellow"}},
                ],
            }
        },
    }  # fmt: skip
    return Scenario.model_validate_json(json.dumps(fields))


def small_header(scenario: Scenario, names: tuple[str, str] = ("Hanse", "Alster")) -> RunHeader:
    """Return the header of a run of that scenario."""
    teams = dict(zip(scenario.entrants, names, strict=False))
    return RunHeader(scenario, 1, teams, dict.fromkeys(teams, "0" * 64))


def half_info(
    scenario: Scenario, half: int, ticks: int, header: RunHeader, score: dict[str, int | float] | None = None
) -> HalfInfo:
    """Return the facts of a half. ``score`` is by team, as it stands when the half begins."""
    teams = teams_by_seat(scenario, half)
    return HalfInfo(
        half=half,
        halves=scenario.match.halves,
        ticks=ticks,
        match_seed=header.seed,
        match_id=0,
        team_names={seat: header.team_names[team] for seat, team in teams.items()},
        teams=teams,
        scores={seat: (score or {}).get(team, 0) for seat, team in teams.items()},
    )


def made_up_snapshot(tick: int, robots: int, *, faults: tuple[Fault, ...] = ()) -> Snapshot:
    """Return robots that drive on circles and a ball that rolls to and fro between the goals."""
    substeps = [list(_poses(tick * TICK_S - TICK_S * (3 - sub) / 4, robots)) for sub in range(4)]
    touches = ((), (), ((0, robots),), ((0, robots), (1, robots + 2))) if tick % 50 == 7 else ((), (), (), ())
    return Snapshot(
        tick=tick,
        substeps=substeps,
        heights=[_float32(0.0375)] * robots + [_float32(0.0209)],
        uprights=[1.0] * (robots + 1),
        touches=touches,
        faults=faults,
    )


def made_up_play(
    robots: int, ticks: int, scores: Mapping[str, Score] | None = None
) -> Iterator[tuple[Snapshot, RefereeOutput]]:
    """Yield tick 0 and on: a goal and a kick-off now and then, a robot held for a time, a fault at tick 300.

    Args:
        robots: of both teams.
        ticks: of the half.
        scores: by seat, as the half begins; left out: nothing was scored yet.
    """
    return with_changes(_made_up_ticks(robots, ticks), scores or dict.fromkeys(_SEATS, 0))


def _made_up_ticks(robots: int, ticks: int) -> Iterator[tuple[Snapshot, RefereeOutput]]:
    for tick in range(ticks + 1):
        fault = Fault("Y1", "crash", tick, 1, "ZeroDivisionError: division by zero", "Traceback …\n  robot.py, 7")
        snapshot = made_up_snapshot(tick, robots, faults=(fault,) if tick == 300 else ())
        yield snapshot, _output(tick, robots)


def with_changes(
    play: Iterable[tuple[Snapshot, RefereeOutput]], scores: Mapping[str, Score]
) -> Iterator[tuple[Snapshot, RefereeOutput]]:
    """Yield outputs with the changes that a referee would have found; those that an output has come first.

    Args:
        play: ticks of a half.
        scores: by seat, as the half begins; what firings score is added.
    """
    tracker, standing = ChangeTracker(scores), dict(scores)
    for snapshot, output in play:
        for firing in output.firings:
            for seat, points in firing.scored.items() if firing.suppressed is None else ():
                standing[seat] = round_score(standing.get(seat, 0) + points)
        changes = tracker.update(
            snapshot.tick,
            phase=(output.phase, output.waiting_for_kickoff),
            scores=standing,
            counters={},
            held=tuple(f"B{robot + 1}" for robot in sorted(output.held)),
        )
        yield snapshot, replace(output, changes=(*output.changes, *changes))


def write_run(
    out: Path,
    scenario: Scenario,
    play: Callable[[HalfInfo], Iterable[tuple[Snapshot, RefereeOutput]]],
    *,
    ticks: int,
    halves: int = 1,
    names: tuple[str, str] = ("Hanse", "Alster"),
    closing: Callable[[HalfInfo], RefereeOutput] = lambda _half: RefereeOutput(),
    ranking: Sequence[Mapping[str, object]] = (),
) -> Path:
    """Write the record of a run whose ticks are given by half; returns its folder."""
    header = small_header(scenario, names)
    writer = RecordWriter(out, header)
    for number in range(1, halves + 1):
        half = half_info(scenario, number, ticks, header, writer.result["score"])
        writer.begin_half(half)
        for snapshot, output in play(half):
            writer.tick(snapshot, output, struct.pack("<d", snapshot.substeps[-1][0][0]))
        writer.end_half(closing(half))
    return writer.finish({"wall_s": 1.0, "ranking": ranking})


def write_made_up_run(
    out: Path,
    *,
    ticks: int = 1500,
    halves: int = 2,
    names: tuple[str, str] = ("Hanse", "Alster"),
    robots_per_team: int = 3,
) -> Path:
    """Write the record of a made-up match; returns its folder."""
    scenario = small_scenario(robots_per_team, halves, ticks * TICK_S)
    robots = len(scenario.robots)
    return write_run(
        out,
        scenario,
        lambda half: made_up_play(robots, ticks, half.scores),
        ticks=ticks,
        halves=halves,
        names=names,
        closing=finish_event,
    )


def finish_event(half: HalfInfo) -> RefereeOutput:
    """Return the output of the rules at the end of a half."""
    return RefereeOutput(events=(Event(half.ticks, "MATCH_FINISH", {"total_match_time": half.ticks * TICK_S}),))


def begun_run(out: Path, ticks: int) -> RecordWriter:
    """Return the writer of a run in its first half, with one robot a team: whoever kills a run leaves such a folder."""
    scenario = small_scenario(1, 1)
    header = small_header(scenario)
    writer = RecordWriter(out, header)
    writer.begin_half(half_info(scenario, 1, 10 * ticks, header))
    for snapshot, output in made_up_play(2, ticks):
        writer.tick(snapshot, output, b"")
    return writer


def _output(tick: int, robots: int) -> RefereeOutput:
    if tick == 0:
        return RefereeOutput(
            events=(Event(0, "KICKOFF", {"robot_name": "B3", "team_name": "B"}), Event(0, "MATCH_START"))
        )
    if tick % GOAL_EVERY_TICKS == 0:
        firing = Firing(tick, "goal", None, "enters", 0.76, 0.745, {"yellow": 1}, None, "The ball is in the goal.")
        return RefereeOutput(
            events=(Event(tick, "GOAL", {"team_name": "Alster"}),),
            firings=(firing,),
            placements=(Placement(robots, 0.0, 0.0, 0.0),),
            phase="goal_pause",
            waiting_for_kickoff=True,
        )
    pausing = tick > GOAL_EVERY_TICKS and tick % GOAL_EVERY_TICKS < 94
    held = _HELD if _HELD_IN_TICKS[0] <= tick < _HELD_IN_TICKS[1] else _NOBODY
    return RefereeOutput(phase="goal_pause" if pausing else "play", waiting_for_kickoff=pausing, held=held)


@lru_cache(maxsize=8192)  # two thousand ticks: every half, and most made-up matches, are the same
def _poses(time_s: float, robots: int) -> tuple[Pose2, ...]:
    circles = [
        (0.25 + 0.05 * robot, 2 * math.pi * robot / robots + 0.15 * time_s * (1 + robot / 10))
        for robot in range(robots)
    ]
    poses = [
        _pose(radius * math.cos(angle), radius * math.sin(angle), angle + math.pi / 2) for radius, angle in circles
    ]
    return (*poses, _pose(0.1 * math.sin(time_s), 0.6 * math.sin(time_s / 3), 0.0))


def _pose(x_m: float, y_m: float, yaw_rad: float) -> Pose2:
    wrapped = math.remainder(yaw_rad, 2 * math.pi)
    return (_float32(x_m), _float32(y_m), _float32(wrapped))


def _float32(value: float) -> float:
    """Return the nearest number that float32 holds: a trajectory's precision."""
    return float(struct.unpack("<f", struct.pack("<f", value))[0])
