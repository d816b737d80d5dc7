"""Points that a rule gives without announcing an event: the page and the live view say for what all the same."""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

from rcj_challenges.core.play import Event, Firing, RefereeOutput, Snapshot
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.views.replay import write_replay
from tests.made_up_runs import made_up_snapshot, small_scenario, with_changes, write_run

TICKS = 40
SCORE = {"action": "score", "entrant": "yellow"}
EMIT = {"action": "emit", "event": "GOAL"}
RULES = {
    "second": {"triggers": [{"trigger": "half_ended"}], "actions": [SCORE]},
    "goal": {"triggers": [{"trigger": "half_ended"}], "actions": [SCORE, EMIT]},
}
SAYS = "A second as king: 1 point."


def _scenario() -> Scenario:
    fields = json.loads(small_scenario(1, 1, TICKS * 0.032).model_dump_json(by_alias=True, exclude_defaults=True))
    return Scenario.model_validate_json(json.dumps({**fields, "schema_version": 2, "rules": RULES}))


def _second(tick: int, points: float = 1) -> Firing:
    return Firing(tick, "second", None, "holds", scored={"yellow": points}, says=SAYS)


def _output(tick: int) -> RefereeOutput:
    if tick == 10:
        return RefereeOutput(firings=(_second(tick),))
    if tick == 20:
        goal = Firing(tick, "goal", "Y1", "enters", scored={"yellow": 3}, says="A goal.")
        return RefereeOutput(events=(Event(tick, "GOAL", {}),), firings=(_second(tick, -0.5), goal))
    return RefereeOutput(firings=(_second(tick, 0),)) if tick == 30 else RefereeOutput()


def _ticks(output: Callable[[int], RefereeOutput], ticks: int) -> Iterator[tuple[Snapshot, RefereeOutput]]:
    play = ((made_up_snapshot(tick, 2), output(tick)) for tick in range(ticks + 1))
    return with_changes(play, {"yellow": 0, "blue": 0})


def _page(folder: Path, output: Any = _output, ticks: int = TICKS) -> dict[str, Any]:
    record = write_run(folder, _scenario(), lambda _half: _ticks(output, ticks), ticks=ticks)
    write_replay(record)
    found = re.search(r'id="facts">(.*?)</script>', (record / "replay.html").read_text(encoding="utf-8"), re.DOTALL)
    assert found is not None
    facts: dict[str, Any] = json.loads(found[1])
    return facts


@pytest.fixture(scope="module")
def events(tmp_path_factory: pytest.TempPathFactory) -> list[dict[str, Any]]:
    return _page(tmp_path_factory.mktemp("runs"))["events"]


def test_the_page_shows_time_reason_and_score_of_points(events: list[dict[str, Any]]) -> None:
    first = events[0]
    assert (first["tick"], first["name"], first["about"], first["standing"]) == (10, "POINTS", SAYS, "0 : 1")
    assert first["payload_text"] == "Alster +1"
    assert first["rule"] == "second"


def test_points_with_an_event_are_listed_once_and_before_points_without_one(events: list[dict[str, Any]]) -> None:
    assert [(event["tick"], event["name"]) for event in events] == [(10, "POINTS"), (20, "GOAL"), (20, "POINTS")]
    assert events[2]["payload_text"] == "Alster -0.5"


def test_points_that_are_lost_are_no_goal_and_no_points_at_all_are_neither(tmp_path: Path) -> None:
    def output(tick: int) -> RefereeOutput:
        scored = {10: {"yellow": -1}, 20: {"yellow": -1, "blue": 2}, 30: {"yellow": 0}}.get(tick)
        if scored is None:
            return RefereeOutput()
        firing = Firing(tick, "goal", "Y1", "enters", scored=scored, says="The ball is in a goal.")
        return RefereeOutput(events=(Event(tick, "GOAL", {}),), firings=(firing,))

    lost, both, nothing = _page(tmp_path, output)["events"]
    assert [event["kind"] for event in (lost, both, nothing)] == ["loss", "goal", "call"]
    assert (lost["standing"], both["standing"]) == ("0 : -1", "2 : -2")
    # Where one gains and another loses, it has the colour of the team that gains.
    assert None is not lost["colour"] != both["colour"] is not None
