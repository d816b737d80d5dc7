"""What decides is shown: payloads beside events, the counters that rank during the match, the places at the end."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from rcj_challenges.core.changes import CountersChange
from rcj_challenges.core.play import Event, Firing, RefereeOutput
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.tournament.site.public import read_replay
from rcj_challenges.views.live.encoder import LiveObserver
from rcj_challenges.views.live.feed import Feed
from rcj_challenges.views.live.pace import MAX_SPEED, Pace
from rcj_challenges.views.payloads import extra_payload_text
from rcj_challenges.views.replay import write_replay
from rcj_challenges.views.replay.page import page_text
from rcj_challenges.views.standing import RankingCounters, shows_score
from tests.made_up_runs import half_info, made_up_snapshot, small_header, small_scenario, write_run
from tests.views.browser_stage import NO_WEBGL, settled

TICKS = 40
RANK = [
    {"sum": {"counter": "laps", "entity": "each"}, "better": "more", "says": "More laps are better."},
    {"counter": "best_s", "better": "less", "says": "The shorter time is better."},
]


@pytest.mark.parametrize(
    ("event", "payload", "says", "text"),
    [
        ("BEST", {"best_s": 10.48}, "It is the best attempt so far.", "best 10.48 s"),
        (
            "TIME",
            {"run_s": 8.48, "poles": 2, "counts_s": 12.48},
            "After 8.48 s; 2 s are added.",
            "poles 2, counts 12.48 s",
        ),
        ("TIME", {"run_s": 8.4}, "After 28.4 s.", "run 8.4 s"),
        ("TIME", {"run_s": 8.4}, "After 8.4 seconds.", "run 8.4 s"),
        ("POLE", {"pole": "pole_1"}, "The robot touches pole_1.", ""),
        ("POLE", {"pole": "pole_1"}, "The robot touches pole_12.", "pole pole_1"),
        # Sentences tell names with blanks in place of _.
        ("KNOCKED", {"pin": "pin_1"}, "pin 1 is knocked.", ""),
        ("KNOCKED", {"pin": "pin_1"}, "pin 12 is knocked.", "pin pin_1"),
        ("SAVE", {"number": 1, "seen": False}, "Saved.", "number 1, seen no"),
        ("HIT", {"by": None, "at": [0.5, 0]}, "A hit.", "by none, at [0.5, 0]"),
        ("FOUND", {"robot_name": "Y1"}, "The ball is found.", "robot Y1"),
        ("KICKOFF", {"robot_name": "Y3", "team_name": "Y"}, "Yellow kicks off.", ""),
        ("KICKOFF", {"robot_name": "Y3", "team_name": "Y"}, "", "robot Y3, team Y"),
        ("LACK_OF_PROGRESS", {"type": "robot", "robot_name": "Y3"}, "", "robot Y3"),
        ("MATCH_FINISH", {"score_blue": 1, "total_match_time": 600, "rocks": 3}, "Over.", "rocks 3"),
    ],
)
def test_a_payload_is_shown_if_neither_sentence_nor_scoreboard_has_it(
    event: str, payload: dict[str, Any], says: str, text: str
) -> None:
    assert extra_payload_text(event, payload, says) == text


def _scenario(**more: Any) -> Scenario:
    fields = json.loads(small_scenario(1, 2, TICKS * 0.032).model_dump_json(by_alias=True, exclude_defaults=True))
    counters = {"laps": {"per": "robots"}, "best_s": {"initial": 99, "keep": "match"}}
    fields |= {"schema_version": 2, "counters": counters, "result": {"rank": RANK}, **more}
    return Scenario.model_validate_json(json.dumps(fields))


@pytest.fixture(scope="module")
def run(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A run of two halves; laps are counted for each robot, the best time goes on from half to half."""
    values = {"blue": [2, 57], "yellow": [3, 57]}
    folder = write_run(
        tmp_path_factory.mktemp("runs"),
        _scenario(),
        lambda half: [(made_up_snapshot(tick, 2), _output(half.half, tick)) for tick in range(TICKS + 1)],
        ticks=TICKS,
        halves=2,
        closing=lambda half: _counted(TICKS, {"laps": {"B1": half.half, "Y1": 1}, "best_s": 30 - half.half}),
        ranking=[{"place": at, "team": team, "values": values[team]} for at, team in ((1, "yellow"), (2, "blue"))],
    )
    write_replay(folder)
    return folder


def _counted(tick: int, counters: dict[str, Any]) -> RefereeOutput:
    return RefereeOutput(changes=(CountersChange(tick, counters),))


def _output(half: int, tick: int) -> RefereeOutput:
    best_s = 99 if half == 1 else 29
    if tick == 0:
        return _counted(tick, {"laps": {"B1": 0, "Y1": 0}, "best_s": best_s})
    if tick != 20:
        return RefereeOutput()
    firing = Firing(tick, "goal", "B1", "enters", says="A lap is complete.")
    event = Event(tick, "GOAL", {"lap": half})
    change = CountersChange(tick, {"laps": {"B1": half, "Y1": 0}, "best_s": best_s})
    return RefereeOutput(events=(event,), firings=(firing,), changes=(change,))


def _facts(folder: Path) -> dict[str, Any]:
    page = (folder / "replay.html").read_text(encoding="utf-8")
    found = re.search(r'<script type="application/json" id="facts">(.*?)</script>', page, re.DOTALL)
    assert found is not None
    facts: dict[str, Any] = json.loads(found[1])
    return facts


def test_the_page_has_ranking_counters_of_each_team_at_each_change(run: Path) -> None:
    first, second = _facts(run)["halves"]
    assert first["counted"] == [
        [0, {"blue": [0, 99], "yellow": [0, 99]}],
        [20, {"blue": [1, 99], "yellow": [0, 99]}],
        [TICKS, {"blue": [1, 29], "yellow": [1, 29]}],
    ]
    # Sides were changed: B1 drives for yellow. Laps of both halves are added, the best time was kept.
    assert second["counted"][1] == [20, {"yellow": [3, 29], "blue": [1, 29]}]


def test_the_page_has_the_place_of_each_team_with_its_values(run: Path) -> None:
    facts = _facts(run)
    assert facts["places"] == [
        {"place": "place 1", "team": "Alster", "values": "laps 3, best 57 s"},
        {"place": "place 2", "team": "Hanse", "values": "laps 2, best 57 s"},
    ]
    assert facts["events"][0]["payload_text"] == "lap 1"


def test_a_record_that_lacks_what_was_counted_is_shown_without_it(run: Path) -> None:
    counters = RankingCounters(_scenario())
    counters.begin(half_info(_scenario(), 1, TICKS, small_header(_scenario())))
    assert counters.by_team({"laps": {"B1": 1}}) is None


def test_points_are_shown_where_rules_give_some_or_the_ranking_compares_them() -> None:
    rules = {"goal": {"triggers": [{"trigger": "half_ended"}], "actions": [{"action": "emit", "event": "GOAL"}]}}
    assert shows_score(_scenario())
    assert not shows_score(_scenario(rules=rules))
    assert shows_score(_scenario(rules=rules, result={"rank": [{"score": "each", "better": "less"}]}))


def test_scoreboard_list_and_caption_show_it(show: Callable[..., Any], run: Path) -> None:
    page = show(run, "#h1t19")
    assert page.locator(".counted").all_inner_texts() == ["laps 0\nbest 99 s", "laps 0\nbest 99 s"]
    page.evaluate("replay.seek(1, 20)")
    settled(page)
    assert page.locator(".counted").first.inner_text() == "laps 1\nbest 99 s"
    assert page.locator("#caption").inner_text() == "GOAL: A lap is complete. · lap 1"
    assert page.locator(".event .values").first.inner_text() == "lap 1"
    page.locator(".place a").first.click()
    settled(page)
    assert (
        page.locator("#caption").inner_text() == "place 1: Alster, laps 3, best 57 s\nplace 2: Hanse, laps 2, best 57 s"
    )


def _replay(folder: Path, **more: Any) -> Path:
    """Return the folder of a short run of a scenario with other parts."""
    ticks = [(made_up_snapshot(tick, 2), RefereeOutput()) for tick in range(TICKS + 1)]
    run = write_run(folder, _scenario(**more), lambda _half: ticks, ticks=TICKS)
    write_replay(run)
    return run


def _crosses(gate: str) -> dict[str, Any]:
    return {
        "line": {
            "triggers": [{"trigger": "crosses", "entity": "ball", "gate": gate}],
            "actions": [{"action": "emit", "event": "LINE"}],
        }
    }


def test_gates_by_which_rules_judge_are_shown_at_first(show: Callable[..., Any], run: Path, tmp_path: Path) -> None:
    page = show(run)
    assert not page.locator("[name=gates]").is_checked()
    page = show(_replay(tmp_path, rules=_crosses("half_way")))
    assert page.locator("[name=gates]").is_checked()
    assert page.locator(".label.mark").all_inner_texts() == ["half_way"]


MOUTH = {"from_m": [0.1, -0.05], "to_m": [0.1, 0.05], "anchor": "Y1"}
"""In front of the robot, as wide as the ball and more."""

COLOUR_AT = """([x, y]) => {
  const { app } = replay, { view } = app, { canvas } = view;
  app.draw();
  const [across, down] = view.project(x, y, 0);
  const column = Math.round(across * canvas.width), row = Math.round(down * canvas.height), found = new Uint8Array(4);
  if (view.pen) {
    const copy = Object.assign(document.createElement("canvas"), { width: 1, height: 1 });
    const pen = copy.getContext("2d", { willReadFrequently: true });
    pen.drawImage(canvas, -column, -row);
    return [...pen.getImageData(0, 0, 1, 1).data].slice(0, 3);
  }
  const { gl } = view.painter;
  gl.readPixels(column, canvas.height - row, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, found);
  return [...found].slice(0, 3);
}"""
"""The colour of the picture at a point of the floor, as red, green and blue."""


def _is_pink(colour: list[int]) -> bool:
    return colour[0] > 180 and 70 < colour[1] < 160 and colour[2] > 120


@pytest.mark.parametrize("script", ["", NO_WEBGL], ids=["3-D", "2-D"])
def test_a_gate_that_moves_with_a_robot_is_drawn_where_the_robot_is(
    show: Callable[..., Any], tmp_path: Path, script: str
) -> None:
    page = show(_replay(tmp_path, gates={"mouth": MOUTH}, rules=_crosses("mouth")), script=script)
    assert page.locator("[name=gates]").is_checked()
    page.evaluate("replay.app.look('top')")
    label = page.locator(".label.mark", has_text="mouth")
    places = []
    for tick in (0, TICKS):
        page.evaluate("(tick) => replay.seek(1, tick)", tick)
        settled(page)
        x_m, y_m, yaw_rad = made_up_snapshot(tick, 2).substeps[-1][1]
        ahead = [x_m + 0.1 * math.cos(yaw_rad), y_m + 0.1 * math.sin(yaw_rad)]
        places.append((ahead, label.bounding_box()))
        assert _is_pink(page.evaluate(COLOUR_AT, ahead)), tick
    (first, first_label), (last, last_label) = places
    assert math.dist(first, last) > 0.03
    assert first_label != last_label
    assert not _is_pink(page.evaluate(COLOUR_AT, first)), "it has gone on"


@pytest.mark.parametrize("script", ["", NO_WEBGL], ids=["3-D", "2-D"])
def test_spots_and_circles_around_them_are_drawn_on_the_field(
    show: Callable[..., Any], tmp_path: Path, script: str
) -> None:
    spots = {"seen": {"x_m": 0.3, "y_m": 0.3, "drawn": True, "colour": "red"}, "unseen": {"x_m": 0.3, "y_m": -0.3}}
    ring = {"shape": "circle", "anchor": "unseen", "radius_m": 0.1, "drawn": True, "colour": "red"}
    zones = {name: zone.model_dump() for name, zone in _scenario().zones.items()}
    page = show(_replay(tmp_path, spots=spots, zones=zones | {"ring": ring}), script=script)
    page.evaluate("replay.app.look('top')")
    settled(page)
    at = {point: page.evaluate(COLOUR_AT, list(point)) for point in ((0.3, 0.3), (0.3, -0.3), (0.4, -0.3))}
    assert [red > 180 and green < 60 for red, green, _ in at.values()] == [True, False, True]


@pytest.mark.parametrize("script", ["", NO_WEBGL], ids=["3-D", "2-D"])
def test_a_field_without_walls_has_floor_beyond_its_edges(
    show: Callable[..., Any], tmp_path: Path, script: str
) -> None:
    page = show(_replay(tmp_path, field={"walls": False}, zones={}, rules={}), script=script)
    page.evaluate("replay.app.look('top')")
    settled(page)
    at = [page.evaluate(COLOUR_AT, [x, 0.1]) for x in (0.5, 0.657, 0.7)]
    assert all(green > 100 and red < 80 and blue < 120 for red, green, blue in at), at


def test_the_facts_of_an_older_replay_are_shown(show: Callable[..., Any], run: Path, tmp_path: Path) -> None:
    path = tmp_path / "replay.html"
    data = read_replay((run / "replay.html").read_text("utf-8"))
    del data.facts["field"]["floor_m"]
    for event in data.facts["events"]:
        del event["copy"]
    path.write_text(page_text(data.facts, data.poses), "utf-8")
    page = show(tmp_path)
    page.evaluate("replay.app.look('top')")
    settled(page)
    red, green, blue = page.evaluate(COLOUR_AT, [0.5, 0.1])
    assert green > max(red, blue)
    page.locator("#events .event").first.click()
    assert "undefined" not in page.locator(".details").inner_text()


def test_a_live_match_sends_ranking_counters_when_they_change() -> None:
    scenario, feed = _scenario(), Feed()
    observer = LiveObserver(scenario, feed, Pace(MAX_SPEED))
    half = half_info(scenario, 1, TICKS, small_header(scenario))
    observer.half_started(half)
    for tick in range(TICKS + 1):
        observer.after_tick(made_up_snapshot(tick, 2), _output(1, tick))
    last = Firing(TICKS, "goal", "Y1", "half_ended")
    change = CountersChange(TICKS, {"laps": {"B1": 1, "Y1": 2}, "best_s": 7})
    observer.after_last_tick(RefereeOutput(firings=(last,), changes=(change,)), half)
    feed.close()
    sent = re.findall(rb'"counted":\[\[(\d+),(\{.*?\]\})', feed.read(0, 0.0) or b"")
    assert [(int(tick), json.loads(values)) for tick, values in sent] == [
        (0, {"blue": [0, 99], "yellow": [0, 99]}),
        (20, {"blue": [1, 99], "yellow": [0, 99]}),
        (TICKS, {"blue": [1, 7], "yellow": [2, 7]}),
    ]
