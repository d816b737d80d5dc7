"""The referee alone on the record of a match, without physics and programs: it must say again what it said."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from rcj_challenges.records.reflog import events_of, reflog_lines
from rcj_challenges.records.trajectory import Trajectory
from rcj_challenges.referee.engine import Referee
from rcj_challenges.scenario.load import load_resolved


def judged_again(folder: Path) -> list[dict[str, Any]]:
    """Return the reflog that the referee writes of a record, without times of day; what it places is as recorded."""
    loaded = load_resolved(json.loads((folder / "scenario.json").read_text("utf-8")))
    lines: list[dict[str, Any]] = []
    for half in Trajectory.open(folder).halves:
        referee = Referee(loaded.scenario, loaded.roster, half.info)
        verdict = referee.start(half.start)
        events = list(events_of(half.start, verdict))
        placements = {0: verdict.placements}
        for snapshot in half.snapshots():
            verdict = referee.judge(snapshot)
            events += events_of(snapshot, verdict)
            placements[snapshot.tick] = verdict.placements
        events += referee.finish().events
        assert {tick: placed for tick, placed in placements.items() if placed} == half.placements
        lines += [json.loads(line) for line in reflog_lines(events, "").splitlines()]
    return [_without_time_of_day(line) for line in lines]


def reflog_of(folder: Path) -> list[dict[str, Any]]:
    """Return the reflog of a record, without times of day."""
    lines = (folder / "reflog.jsonl").read_text("utf-8").split("\n")[:-1]
    return [_without_time_of_day(json.loads(line)) for line in lines]


def _without_time_of_day(line: dict[str, Any]) -> dict[str, Any]:
    return {key: value for key, value in line.items() if key != "datetime"}
