"""Logos, readings and printed lines of the live view, without a browser: the same as in the replay."""

import base64
import json
import struct
import zlib
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from rcj_challenges.core.play import HalfInfo
from rcj_challenges.match.observers import ObserverGroup
from rcj_challenges.match.runner import MatchPlan, play_match
from rcj_challenges.records.sensors import SensorWriter, read_sensors
from rcj_challenges.scenario.load import load
from rcj_challenges.submissions.team import open_team
from rcj_challenges.views.live import MAX_SPEED, LiveShow, Pace
from rcj_challenges.views.live.encoder import LiveObserver
from rcj_challenges.views.live.feed import Feed
from rcj_challenges.views.live.sensor_feed import HalfSensorFeed
from rcj_challenges.views.replay.sensor_blocks import output_block, sensor_block, sensor_facts
from tests.made_up_runs import (
    half_info,
    made_up_play,
    small_header,
    small_scenario,
    write_made_up_run,
)
from tests.views.sensing_play import ENDLESS, HOSTILE, SENSED, TURNED, logo, sense

SCENARIO = small_scenario(halves=2, half_s=60.0)
HEADER = small_header(SCENARIO)
ROBOTS = len(SCENARIO.robots)
TICKS = 130

Table = list[list[int]]


# --- reading the feed ----------------------------------------------------------------------------------------------


class Received:
    """What a spectator has received from all of a feed."""

    def __init__(self, feed: Feed) -> None:
        self.order: list[Any] = []
        self.tables: dict[tuple[int, str], Table] = {}
        self.lines: list[Any] = []
        self.facts: dict[int, Any] = {}
        data = b""
        while piece := feed.read(len(data), 0.0):
            data += piece
        while data:
            kind, length = struct.unpack_from("<BI", data)
            self._take(kind, data[5 : 5 + length])
            data = data[5 + length :]

    def _take(self, kind: int, body: bytes) -> None:
        if kind == 1:
            message = json.loads(body)
            self.order.append(message["say"])
            if message["say"] == "sensors":
                self.facts[message["half"]] = message["facts"]
            elif message["say"] == "printed":
                self.lines += [[message["half"], *line] for line in message["lines"]]
        elif kind == 2:
            self.order.append(("poses", struct.unpack_from("<HI", body)[1]))
        else:
            half, robot, rows = struct.unpack_from("<HHI", body)
            facts = self.facts[half]["robots"][robot]
            table = self.tables.setdefault((half, facts["name"]), [])
            table += np.frombuffer(body[8:], "<i4").reshape(rows, 1 + len(facts["units"])).tolist()
            self.order.append(("sensed", table[-1][0]))


def replayed(half: Any) -> dict[str, Table]:
    """Return what the replay page has of a half, as rows of tick and columns, by robot."""
    data = zlib.decompress(base64.b64decode(sensor_block(half)))
    tables, at = {}, 0
    for robot in sensor_facts(half)["robots"]:
        rows = robot["rows"]
        columns = []
        for _ in range(1 + len(robot["units"])):
            planes = np.frombuffer(data[at : at + 4 * rows], np.uint8).reshape(4, rows).T.copy()
            columns.append(np.cumsum(planes.view("<i4")[:, 0], dtype=np.int32).tolist())
            at += 4 * rows
        tables[robot["name"]] = [list(row) for row in zip(*columns, strict=True)]
    assert at == len(data)
    return tables


# --- a half that is recorded and sent ------------------------------------------------------------------------------------


def received(folder: Path, ticks: int = TICKS, every: int = 7, sensors: bool = True) -> Received:
    """Play a half without physics; the feed is flushed every so many ticks."""
    feed = Feed()
    observer = LiveObserver(SCENARIO, feed, Pace(MAX_SPEED))
    half = half_info(SCENARIO, 1, ticks, HEADER)
    observer.half_started(half)
    writer = SensorWriter(folder, 1, SENSED)
    if sensors:
        writer.set_listeners(ObserverGroup(observer).sensing(half, SENSED))
    for snapshot, output in made_up_play(ROBOTS, ticks):
        observer.after_tick(snapshot, output)
        sense(writer, snapshot.tick)
        if snapshot.tick % every == 0:
            observer.flush()
    writer.record_output(0, "last words\n")  # after the half was closed, as a program's last output comes
    writer.close()
    observer.flush()
    return Received(feed)


@pytest.mark.parametrize("every", [1, 7, 1000])
def test_spectators_receive_the_readings_of_the_replay(every: int, tmp_path: Path) -> None:
    live = received(tmp_path, every=every)
    half = read_sensors(tmp_path)[1]
    recorded = replayed(half)
    assert len(recorded["B1"]) == TICKS + 1
    assert {name: live.tables[1, name] for name in recorded} == recorded
    facts = [{**robot, "rows": 0} for robot in sensor_facts(half)["robots"]]
    assert live.facts[1]["robots"] == json.loads(json.dumps(facts))


@pytest.mark.parametrize("every", [1, 1000])
def test_printed_lines_are_those_of_the_replay_whatever_they_contain(every: int, tmp_path: Path) -> None:
    live = received(tmp_path, every=every)
    recorded = json.loads(zlib.decompress(base64.b64decode(output_block(read_sensors(tmp_path)[1]))))
    for robot in ("B1", "Y2"):
        assert [line[1:] for line in live.lines if line[1] == robot] == [line for line in recorded if line[0] == robot]
    said = [text for _, robot, _, text in live.lines if robot == "B1"]
    assert said == ["ready\n", HOSTILE, TURNED, ENDLESS, "tick 100\n", "last words\n"]


def test_what_is_read_of_a_moment_comes_after_the_moment(tmp_path: Path) -> None:
    order = received(tmp_path).order
    assert order.index("half") < order.index("sensors") < order.index(("poses", 0)) < order.index(("sensed", 0))
    known = -1
    for entry in order:
        if isinstance(entry, tuple) and entry[0] == "poses":
            known = entry[1]
        elif isinstance(entry, tuple):
            assert known >= 0
            assert entry[1] - known <= 7


def test_half_of_a_surrogate_pair_does_not_break_the_feed() -> None:
    senses = HalfSensorFeed(HalfInfo(1, 1, 10, 1, 0, {}, {}, {}, {}), SENSED)
    senses.on_output((0, 3, "\ud800 \x00 \u2028\n"))
    feed = Feed()
    feed.append(senses.announcement + senses.messages())
    assert Received(feed).lines == [[1, "B1", 3, "\ud800 \x00 \u2028\n"]]


# --- logos -------------------------------------------------------------------------------------------------------------


def facts_of(show: LiveShow) -> Any:
    return json.loads(show._server.page.decode().partition('id="facts">')[2].partition("</script>")[0])


def test_logos_are_in_the_page_before_the_match_begins() -> None:
    with LiveShow(SCENARIO, dict(HEADER.team_names), 1, logos={"blue": logo(200)}) as show:
        by_team = {team["name"]: team for team in facts_of(show)["teams"]}
    assert base64.b64decode(by_team["blue"]["logo"].removeprefix("data:image/png;base64,")) == logo(200)
    assert "logo" not in by_team["yellow"]


def test_the_reason_why_a_logo_is_not_shown_is_printed_in_full(tmp_path: Path) -> None:
    folder = write_made_up_run(tmp_path, ticks=50, halves=1)
    logos = {"blue": b"GIF89a<script>alert(1)</script>", "nobody": logo(1)}
    with LiveShow(SCENARIO, dict(HEADER.team_names), 1, logos=logos) as show:
        facts = facts_of(show)
        show.match_over(folder)
        over = show._feed.read(0, 0.0)
    assert all("logo" not in team for team in facts["teams"])
    why = ["logo", f"that of {HEADER.team_names['blue']} is not shown: it is a GIF"]
    assert why in facts["about"]
    assert over is not None
    assert json.dumps(why, separators=(",", ":")).encode() in over


# --- a real match ------------------------------------------------------------------------------------------------------

CHATTY = """\
from controller import Robot
robot = Robot()
motors = [robot.getDevice(name) for name in ("left wheel motor", "right wheel motor")]
sonar = robot.getDevice("distancesensor front")
sonar.enable(32)
for motor in motors:
    motor.setPosition(float("inf"))
while robot.step(32) != -1:
    motors[0].setVelocity(5)
    print("front", sonar.getValue())
"""


@pytest.fixture
def chatty(tmp_path: Path) -> Callable[..., MatchPlan]:
    folder = tmp_path / "team"
    folder.mkdir()
    (folder / "robot.py").write_text(CHATTY, encoding="utf-8")
    (folder / "logo.png").write_bytes(logo(9))

    def plan(**more: Any) -> MatchPlan:
        alone = [f"entrants.{seat}.robots.{robot}=null" for seat, robot in (("blue", "B3"), ("yellow", "Y3"))]
        loaded = load("match", ["match.halves=2", "match.half_s=1.6", *alone])
        seats = tuple(loaded.scenario.entrants.values())
        teams = {seat: open_team(folder, *seats) for seat in loaded.scenario.entrants}
        return MatchPlan(loaded, teams, {}, seed=7, out=tmp_path / "runs", **more)

    return plan


def test_live_match_sends_all_of_its_recording(chatty: Callable[..., MatchPlan]) -> None:
    plan = chatty(record_sensors=True)
    with LiveShow(plan.loaded.scenario, {}, 7, logos=plan.logos, speed=MAX_SPEED) as show:
        played = play_match(plan, ObserverGroup(show.observer))
        show.match_over(played.folder)
        live = Received(show._feed)
        assert all(team["logo"] for team in facts_of(show)["teams"])
    halves = read_sensors(played.folder)
    assert sorted(halves) == [1, 2]
    for number, half in halves.items():
        for name, rows in replayed(half).items():
            assert live.tables[number, name] == rows
            lines = [(tick, text) for at, robot, tick, text in live.lines if (at, robot) == (number, name)]
            assert tuple(lines) == half.robots[name].output
            assert len(lines) > 20
    assert played.result["digest"] == play_match(chatty()).result["digest"]
