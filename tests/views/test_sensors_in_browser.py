"""Readings, rays, output, logos and heat maps in a real browser, and pages of damaged records."""

import math
import shutil
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from rcj_challenges.records.logos import logo_path
from rcj_challenges.records.sensors import SensorWriter
from rcj_challenges.records.testing import write_made_up_run
from rcj_challenges.views.replay import write_replay
from tests.views.browser_stage import NARROW, NO_WEBGL, WIDE, settled, until
from tests.views.sensing_play import ENDLESS, HOSTILE, READINGS_AT_125, SENSED, TURNED, logo, reading, sense

TICKS = 500


@pytest.fixture(scope="module")
def run(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Two halves; B1 and Y2 are recorded in the first. Both teams have logos, one of which is none."""
    folder = write_made_up_run(tmp_path_factory.mktemp("runs"), ticks=TICKS, halves=2)
    writer = SensorWriter(folder, 1, SENSED)
    for tick in range(TICKS + 1):
        sense(writer, tick)
    writer.close()
    logo_path(folder, "blue").write_bytes(logo(200))
    logo_path(folder, "yellow").write_bytes(b"GIF89a<script>alert(1)</script>")
    write_replay(folder)
    return folder


def _robots(page: Any) -> Any:
    page.click("#tab-robots")
    until(page, "replay.app.sensors.half(replay.half)")  # read when it is first wanted
    settled(page)
    return page.locator(".robot", has_text="B1").first


# --- readings and output -------------------------------------------------------------------------------------------------


def test_readings_are_those_of_the_moment(show: Callable[..., Any], run: Path) -> None:
    page = show(run, "#h1t125")
    card = _robots(page)
    assert reading(card, "observation") == "tick 125"
    assert {name: reading(card, name) for name in READINGS_AT_125} == READINGS_AT_125
    assert reading(card, "lidar").startswith("0.680 to 0.858 m")
    page.keyboard.press(".")
    settled(page)
    assert reading(card, "distancesensor left") == "376.0"
    assert reading(card, "ball") == "not heard"


def test_only_robots_whose_programs_were_recorded_have_readings(show: Callable[..., Any], run: Path) -> None:
    page = show(run, "#h1t50")
    _robots(page)
    assert page.locator(".sensing:visible").count() == 2
    assert page.get_by_role("button", name="Rays of the sensors of").count() == 2
    page.evaluate("replay.seek(2, 50)")  # the second half has none
    settled(page)
    assert page.locator(".sensing:visible").count() == 0


@pytest.mark.nightly
def test_printed_lines_come_with_their_time_and_only_when_they_were_printed(
    show: Callable[..., Any], run: Path
) -> None:
    page = show(run, "#h1t9")
    card = _robots(page)
    assert card.locator(".printed .line").all_inner_texts() == ["0:00.0 ready"]
    page.evaluate("replay.seek(1, 400)")
    settled(page)
    lines = card.locator(".printed .line").all_inner_texts()
    assert lines[-1] == "0:12.8 tick 400"
    assert len(lines) == 8


@pytest.mark.parametrize("size", [WIDE, pytest.param(NARROW, marks=pytest.mark.nightly)], ids=["wide", "narrow"])
def test_printed_text_is_text_whatever_it_contains(size: dict, show: Callable[..., Any], run: Path) -> None:
    page = show(run, "#h1t40", viewport=size)
    card = _robots(page)
    texts = card.locator(".printed bdi").all_text_contents()
    assert texts[1:] == [HOSTILE.rstrip(), TURNED.rstrip("\n"), ENDLESS.rstrip()]
    assert "stolen" not in page.title()
    assert page.evaluate("document.querySelectorAll('.printed img, .printed script').length") == 0
    assert page.evaluate("document.documentElement.scrollWidth") <= size["width"]
    box = card.locator(".printed").bounding_box()
    assert box["height"] < 300
    # A mark that turns the direction of text stays in its own line: the time stands before it.
    line = card.locator(".printed .line").nth(2)
    assert line.locator(".when").bounding_box()["x"] < line.locator("bdi").bounding_box()["x"]


@pytest.mark.nightly
def test_a_page_without_sensors_offers_no_rays(show: Callable[..., Any], tmp_path: Path) -> None:
    folder = write_made_up_run(tmp_path, ticks=60, halves=1)
    write_replay(folder)
    page = show(folder)
    page.click("#tab-show")
    assert page.locator("input[name=rays]").is_disabled()
    assert page.get_by_role("button", name="Rays").count() == 0


# --- rays ----------------------------------------------------------------------------------------------------------------


@pytest.mark.nightly
def test_rays_reach_as_far_as_the_readings_say_in_the_robots_frame(show: Callable[..., Any], run: Path) -> None:
    page = show(run, "#h1t125")
    _robots(page)
    page.click("text=Rays >> nth=0")
    settled(page)
    found = page.evaluate(
        """() => {
          const pose = replay.recording.pose(0, replay.place), rays = replay.app.sensors.raysAt(replay.place, false);
          const turned = ([x, y]) => [Math.hypot(x - pose.x, y - pose.y), Math.atan2(y - pose.y, x - pose.x) - pose.yaw];
          return rays.map(({ pieces }) => [pieces.length, ...turned(pieces[0][1])]);
        }"""
    )
    (sonars, sonar_m, sonar_rad), (rays, first_m, first_rad), (balls, ball_m, ball_rad) = found
    assert (sonars, rays, balls) == (1, 90, 1)  # every second of 180 lidar cells that see something
    assert sonar_m == pytest.approx(0.0375 + 0.375, abs=1e-3)
    assert math.remainder(sonar_rad - math.pi / 2, 2 * math.pi) == pytest.approx(0, abs=1e-3)
    assert first_m == pytest.approx(0.68, abs=1e-3)
    assert math.remainder(first_rad - math.pi, 2 * math.pi) == pytest.approx(0, abs=1e-3)
    assert ball_m == pytest.approx(0.5, abs=1e-3)
    assert math.remainder(ball_rad, 2 * math.pi) == pytest.approx(0, abs=1e-3)


@pytest.mark.nightly
def test_rays_are_drawn_when_they_are_asked_for(show: Callable[..., Any], run: Path) -> None:
    page = show(run, "#h1t125")
    count = "replay.app.frame.trails.length"
    until(page, "replay.app.sensors.half(1)")
    settled(page)
    assert page.evaluate(count) == 0
    page.click("#tab-show")
    page.check("input[name=rays]")
    settled(page)
    assert page.evaluate(count) == 6
    page.uncheck("input[name=rays]")
    assert page.evaluate(count) == 0


# --- heat map and logos --------------------------------------------------------------------------------------------------


def test_a_heat_map_is_warm_where_somebody_was(show: Callable[..., Any], run: Path) -> None:
    page = show(run)
    page.click("#tab-show")
    assert page.locator("#heat option").all_inner_texts()[-3:] == ["ball", "Hanse", "Alster"]
    page.select_option("#heat", label="ball")
    settled(page)
    inside = page.evaluate(
        """() => {
          const { shapes } = replay.app.heat.at(replay.place), track = replay.recording.halves[0];
          const holds = (shape, x, y) => x >= shape.points[0][0] && x < shape.points[2][0] && y >= shape.points[0][1] && y < shape.points[2][1];
          const seen = [1, 100, 300, 500].map((tick) => track.pose(6, tick));
          return [shapes.length, seen.every(({ x, y }) => shapes.some((shape) => holds(shape, x, y)))];
        }"""
    )
    assert 10 < inside[0] < 200
    assert inside[1]
    assert "% of the time" in page.locator("#heat-text").inner_text()
    page.select_option("#heat", label="nobody")
    settled(page)
    assert page.evaluate("replay.app.heat.at(replay.place).shapes.length") == 0


@pytest.mark.nightly
def test_a_heat_map_of_a_team_follows_it_to_the_other_side(show: Callable[..., Any], run: Path) -> None:
    page = show(run)
    page.click("#tab-show")
    page.select_option("#heat", label="Hanse")
    chosen = "replay.recording.halves.map((track) => replay.app.heat.chosen(track))"
    assert page.evaluate(chosen) == [[0, 1, 2], [3, 4, 5]]


def test_a_logo_is_on_the_scoreboard_and_on_the_robots_of_its_team(show: Callable[..., Any], run: Path) -> None:
    page = show(run, "#h1t50")
    page.wait_for_selector("img.logo")
    settled(page)
    assert page.locator("img.logo").count() == 1  # the other one is no PNG
    assert page.locator(".team", has_text="Hanse").locator("img.logo").is_visible()
    who = "[50, 550].map((place) => replay.app.logos.at(place).map((picture) => Boolean(picture)))"
    first, second = page.evaluate(who)
    assert first == [True] * 3 + [False] * 4
    assert second == [False] * 3 + [True] * 3 + [False]
    page.click("#tab-show")
    assert "that of Alster is not shown: it is a GIF" in page.locator("#about").inner_text()


@pytest.mark.nightly
def test_logos_are_drawn_without_webgl_too(show: Callable[..., Any], run: Path) -> None:
    page = show(run, "#h1t50", script=NO_WEBGL)
    page.wait_for_selector("img.logo")
    settled(page)
    violet = page.evaluate(
        """() => {
          const { pen, canvas } = replay.app.view;
          const all = pen.getImageData(0, 0, canvas.width, canvas.height).data;
          let found = 0;
          for (let at = 0; at < all.length; at += 4) found += all[at] > 180 && all[at] < 220 && all[at + 1] < 20 && all[at + 2] > 240;
          return found;
        }"""
    )
    assert violet > 50


# --- damaged records -----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("share", "says"),
    [
        pytest.param(0.7, "ticks of them could be read", marks=pytest.mark.nightly),
        (0.0, "everything stands at its start"),
    ],
)
def test_of_a_damaged_trajectory_the_page_shows_what_is_left_and_says_so(
    share: float, says: str, show: Callable[..., Any], run: Path, tmp_path: Path
) -> None:
    folder = tmp_path / "run"
    shutil.copytree(run, folder)
    data = (folder / "trajectory.npz").read_bytes()
    (folder / "trajectory.npz").write_bytes(data[: int(len(data) * share)])
    sensors = folder / "sensors" / "half-1.sensors"
    sensors.write_bytes(sensors.read_bytes()[:-100])
    page = show(write_replay(folder).parent, script=NO_WEBGL)
    notice = page.locator("#problem").inner_text()
    assert says in notice
    assert "sensor recording of half 1 is damaged" in notice
    page.locator("a.moment", has_text="GOAL").first.click()
    assert page.evaluate("[replay.half, replay.tick]") == [1, 400]
    settled(page)
    assert [score.inner_text() for score in page.locator(".score").all()] == ["0", "1"]
