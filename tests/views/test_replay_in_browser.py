"""The replay page in a real browser: what it shows, where its buttons lead, and that it fits on any screen."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from rcj_challenges.records.trajectory import Trajectory
from rcj_challenges.views.palette import css_colour
from rcj_challenges.views.replay.browse import open_replay
from tests.views.browser_stage import NARROW, NO_WEBGL, WIDE, picture, settled, shown_moment, until
from tests.views.replay_play import (
    BACK,
    CRASH,
    GOALS,
    HELD,
    REMOVED,
    STUCK,
    TICKS,
    TRACEBACK,
    write_storied_run,
)
from tests.views.sensing_play import ENDLESS, HOSTILE, READINGS_AT_125, TURNED, reading

LYING, SMALL = {"width": 844, "height": 390}, {"width": 360, "height": 740}
ENDLESS_NAME = "\u202e\u2066" + "ح" * 10_000


@pytest.fixture(scope="module")
def run(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return write_storied_run(tmp_path_factory.mktemp("runs"))


def _go(page: Any, half: int, tick: int) -> None:
    page.evaluate("([half, tick]) => replay.seek(half, tick)", [half, tick])
    settled(page)


# --- what is shown -----------------------------------------------------------------------------------------------------


def test_page_opens_from_disk_with_teams_clock_logo_and_a_picture(show: Callable[..., Any], run: Path) -> None:
    page = show(run, "", anew=True)
    assert page.locator(".team .name").all_inner_texts() == ["Hanse", "Alster"]
    assert page.locator("#clock").inner_text() == "0:00.0"
    assert page.locator("#half").inner_text() == "half 1 of 2 · 0:32"
    page.wait_for_selector("img.logo")
    colours = picture(page)
    green = [colour for colour in colours if (colour >> 8 & 255) > 1.3 * max(colour >> 16, colour & 255)]
    assert len(green) > 100  # the field fills the picture
    assert len(set(colours)) > 8


def test_poses_in_the_page_equal_the_trajectory_also_while_a_robot_is_off_the_field(
    show: Callable[..., Any], run: Path
) -> None:
    page = show(run)
    for half in Trajectory.open(run).halves:
        shown = np.array(
            page.evaluate(
                """(half) => {
                  const track = replay.recording.halves[half - 1], poses = [];
                  for (let tick = 1; tick <= track.ticks; tick += 7) {
                    poses.push(replay.recording.entities.map((_, entity) => {
                      const pose = track.pose(entity, tick);
                      return [pose.x, pose.y, pose.z, pose.yaw, pose.tilt];
                    }));
                  }
                  return poses;
                }""",
                half.info.half,
            )
        )
        judged = half.substeps[::7, -1].astype(float)
        assert np.abs(shown[:, :, :2] - judged[:, :, :2]).max() < 2e-4
        assert np.abs(shown[:, :, 2] - half.heights[::7]).max() < 2e-4
        turn = np.remainder(shown[:, :, 3] - judged[:, :, 2] + np.pi, 2 * np.pi) - np.pi
        assert np.degrees(np.abs(turn)).max() < 0.1


def test_nothing_glides_where_the_referee_put_it(show: Callable[..., Any], run: Path) -> None:
    page = show(run)
    y = "[400, 400.5, 401, 402, 402.5, 403].map((tick) => replay.recording.halves[0].pose(6, tick).y)"
    before, between, after, *rolling = page.evaluate(y)
    assert before == between != after
    assert rolling[1] == pytest.approx((rolling[0] + rolling[2]) / 2)


def test_goal_names_and_colours_the_team_that_scored_after_half_time_too(show: Callable[..., Any], run: Path) -> None:
    page, seats = show(run), []
    page.click("#filters >> text=GOAL")
    chips = "[...document.querySelectorAll('.team .chip')].map((chip) => chip.style.background)"
    edges = "[...document.querySelectorAll('#events .goal')].map((row) => row.style.getPropertyValue('--team'))"
    blue, yellow = css_colour("blue"), css_colour("yellow")
    for row, half, team, score, colours in (
        (0, 1, "Alster", ["0", "1"], [yellow, yellow, blue, blue]),  # seen from here Hanse, who scores later, is blue
        (2, 2, "Hanse", ["1", "2"], [blue, blue, yellow, yellow]),
    ):
        goal = page.locator("#events .goal").nth(row)
        goal.locator("a").click()
        settled(page)
        assert shown_moment(page) == [half, GOALS[0]]
        assert [one.inner_text() for one in page.locator(".score").all()] == score
        assert goal.locator(".by").inner_text() == team
        assert team in page.locator("#caption").inner_text()
        assert page.evaluate(edges) == colours
        seats.append(page.evaluate(chips))
    assert seats[0] == seats[1][::-1]
    details = page.locator(".details").inner_text()
    assert "0.76" in details
    assert "0.745" in details


def test_lack_of_progress_shows_what_was_measured(show: Callable[..., Any], run: Path) -> None:
    page = show(run, f"#h1t{STUCK}")
    reason = "B2 made no progress: 0.497 m in 15 s, at least 0.5 m"
    assert page.locator("#caption").inner_text() == f"LACK OF PROGRESS: {reason}"
    assert page.locator("#events [aria-current] .about").inner_text() == reason


def test_crash_is_whole_with_its_line_and_has_one_time_everywhere(show: Callable[..., Any], run: Path) -> None:
    page = show(run, f"#h1t{CRASH}")
    row = page.locator("#events [aria-current]")
    assert row.locator(".when").inner_text() == page.locator("#clock").inner_text() == "0:09.6"
    assert "Y1 crashed at strike.py:31: ZeroDivisionError" in page.locator("#caption").inner_text()
    row.click()
    assert TRACEBACK.rstrip() in page.locator(".details").inner_text()
    page.click("#tab-robots")
    settled(page)
    card = page.locator(".robot .fault:visible").inner_text()
    assert "0:09.6" in card
    assert TRACEBACK.rstrip() in card
    page.click("#tab-output")
    settled(page)
    assert page.locator("#printed .fault .when").inner_text() == "0:09.6"
    assert TRACEBACK.rstrip() in page.locator("#printed .fault").inner_text()


def test_end_has_the_final_score_and_play_starts_again(show: Callable[..., Any], run: Path) -> None:
    page = show(run, f"#h2t{TICKS - 1}")
    assert (page.locator("#phase").inner_text(), page.get_attribute("#play", "aria-label")) == ("in play", "Play")
    _go(page, 2, TICKS)
    assert "Hanse 2 : 2 Alster" in page.locator("#caption").inner_text()
    assert page.locator("#phase").inner_text() == "finished"
    assert page.get_attribute("#play", "aria-label") == "Play again"
    page.click("#play")
    until(page, f"replay.half == 1 && replay.tick < {TICKS}")
    page.keyboard.press("k")


def test_every_event_of_the_list_lands_on_its_tick(show: Callable[..., Any], run: Path) -> None:
    landed = show(run).evaluate(
        """() => [...document.querySelectorAll("a.moment")].map((link, index) => {
          link.click();
          const event = replay.recording.events[index];
          return [replay.half - event.half, replay.tick - event.tick];
        })"""
    )
    assert len(landed) == 12
    assert {tuple(off) for off in landed} == {(0, 0)}


def test_held_robot_and_one_that_is_off_the_field_are_marked(show: Callable[..., Any], run: Path) -> None:
    page = show(run, f"#h1t{HELD}")
    page.click("#tab-robots")
    settled(page)
    cards = page.locator(".robot .numbers")
    assert page.locator("#phase").inner_text() == "B1 held"
    assert cards.first.inner_text().endswith("held")
    for tick, off in ((REMOVED, False), (REMOVED + 1, True), (BACK, True), (BACK + 1, False)):
        _go(page, 1, tick)
        assert (cards.nth(2).inner_text() == "off the field") is off, tick
    page.select_option("#behind", "2")
    _go(page, 1, REMOVED)
    before = page.evaluate("replay.app.camera.pose.target")
    _go(page, 1, REMOVED + 50)
    assert page.evaluate("replay.app.camera.pose.target") == pytest.approx(before, abs=0.1)


def test_zones_gates_spots_and_heat_can_be_shown_in_their_owners_colours(show: Callable[..., Any], run: Path) -> None:
    page = show(run)
    before = picture(page)
    page.keyboard.press("z")
    settled(page)
    assert {"blue_goal", "middle", "half_way", "centre"} <= set(page.locator(".label.mark").all_inner_texts())
    assert picture(page) != before
    zones = {zone["name"]: zone["colour"] for zone in page.evaluate("replay.recording.facts.zones")}
    assert zones["blue_penalty_area"] == zones["blue_goal"] == css_colour("blue")
    assert zones["yellow_penalty_area"] == css_colour("yellow")
    assert zones["middle"] is None
    page.click("#tab-show")
    page.select_option("#heat", label="ball")
    settled(page)
    assert 10 < page.evaluate("replay.app.heat.at(replay.place).shapes.length") < 200
    assert "% of the time" in page.locator("#heat-text").inner_text()


# --- output and sensors ------------------------------------------------------------------------------------------------


def test_output_of_all_robots_stands_beside_the_replay_with_its_time(show: Callable[..., Any], run: Path) -> None:
    page = show(run, "#h1t40")
    page.click("#tab-output")
    until(page, "replay.app.output.of(1)")
    settled(page)
    texts = page.locator("#printed bdi").all_text_contents()
    assert texts == ["ready", "ready", HOSTILE.rstrip(), TURNED.rstrip("\n"), ENDLESS.rstrip()]
    assert "stolen" not in page.title()
    assert page.evaluate("document.documentElement.scrollWidth") <= WIDE["width"]
    page.select_option("#printed-by", "Y2")
    settled(page)
    assert page.locator("#printed .line").all_inner_texts() == ["0:00.0\nY2\nready"]
    page.select_option("#printed-by", "")
    _go(page, 1, 520)
    last = page.locator("#printed .line").last
    assert last.inner_text().split("\n") == ["0:16.0", "B1", "tick 500"]
    last.locator("a").click()
    assert shown_moment(page) == [1, 500]
    _go(page, 2, 10)
    assert page.locator("#no-output").is_visible()


def test_readings_and_rays_are_those_of_the_moment(show: Callable[..., Any], run: Path) -> None:
    page = show(run, "#h1t125")
    page.click("#tab-robots")
    until(page, "replay.app.sensors.half(1)")
    settled(page)
    card = page.locator(".robot", has_text="B1").first
    assert reading(card, "observation") == "frame 125"
    assert {name: reading(card, name) for name in READINGS_AT_125} == READINGS_AT_125
    assert page.locator(".sensing:visible").count() == 2
    page.click("text=Rays >> nth=0")
    settled(page)
    lengths = page.evaluate(
        """() => {
          const pose = replay.recording.pose(0, replay.place);
          return replay.app.frame.trails.map(({ pieces }) => Math.hypot(pieces[0][1][0] - pose.x, pieces[0][1][1] - pose.y));
        }"""
    )
    assert lengths == pytest.approx([0.0375 + 0.375, 0.68, 0.5], abs=1e-3)  # sonar, lidar, ball
    _go(page, 2, 50)
    assert page.locator(".sensing:visible").count() == 0


def test_pictures_and_lights_are_those_of_the_moment(show: Callable[..., Any], run: Path) -> None:
    page = show(run, "#h1t125")
    page.click("#tab-robots")
    for tick, colour, light in ((30, [0, 128, 0], None), (125, [0, 0, 255], [1, 0, 0]), (250, [0, 0, 255], [0, 1, 0])):
        _go(page, 1, tick)
        until(page, "document.querySelectorAll('.camera canvas').length == 2")
        settled(page)
        seen = page.evaluate(
            """() => {
              const pen = document.createElement("canvas").getContext("2d", { willReadFrequently: true });
              pen.drawImage(document.querySelector(".camera canvas"), 0, 0);
              return [[1, 1], [8, 16]].map(([x, y]) => [...pen.getImageData(x, y, 1, 1).data].slice(0, 3));
            }"""
        )
        assert seen == [colour, [255, 255, 255]]  # the second is on the box around the ball
        lights = page.evaluate("replay.app.frame.lights.map(({ index, colour }) => [index, colour])")
        assert lights == ([] if light is None else [[0, light], [4, light]])


# --- playing -----------------------------------------------------------------------------------------------------------


def test_play_wind_and_speed(show: Callable[..., Any], run: Path) -> None:
    page = show(run, "#h1t500")
    page.select_option("#speed", "16")
    page.click("#play")
    until(page, "replay.tick > 700 || replay.half > 1")
    page.click("#play")
    settled(page)
    stopped = page.evaluate("replay.place")
    assert stopped == round(stopped)
    assert page.locator("#winding").is_hidden()
    page.select_option("#speed", "2")
    page.click("#rewind")
    until(page, f"replay.place < {stopped} - 20")
    until(page, "document.querySelector('#winding').innerText === '◀◀ 8 \N{MULTIPLICATION SIGN}'")
    page.keyboard.press("l")  # the page shows it in its next frame
    until(page, "document.querySelector('#winding').innerText === '▶▶ 8 \N{MULTIPLICATION SIGN}'")
    page.keyboard.press("k")
    page.keyboard.press("k")
    assert page.evaluate("replay.app.player.playing") is False


def test_keys_move_by_frames_seconds_events_and_to_the_ends(show: Callable[..., Any], run: Path) -> None:
    page = show(run, "#h1t450")
    for key, expected in (
        (".", [1, 451]), (",", [1, 450]), ("ArrowRight", [1, 606]), ("ArrowLeft", [1, 450]), ("n", [1, 600]),
        ("p", [1, 400]), ("End", [2, TICKS]), ("Home", [1, 0]),
    ):  # fmt: skip
        page.keyboard.press(key)
        assert shown_moment(page) == expected, key
    until(page, "location.hash === '#h1t0'")
    page.evaluate("location.hash = '#h2t77'")
    until(page, "replay.half === 2 && replay.tick === 77")
    page.keyboard.press(".")
    until(page, "location.hash === '#h2t78'")


def test_time_line_shows_where_a_click_leads_and_can_be_dragged(show: Callable[..., Any], run: Path) -> None:
    page = show(run)
    box = page.locator("#seek").bounding_box()
    for share in (0.03, 0.9):  # no event is near
        page.mouse.move(box["x"] + box["width"] * share, box["y"] + 28)
        hovered = page.inner_text("#hover")
        page.mouse.down()
        page.mouse.up()
        settled(page)
        assert hovered == page.inner_text("#clock"), share
    page.mouse.down()
    page.mouse.move(box["x"] + box["width"] * 0.75, box["y"] + 28, steps=3)
    page.mouse.up()
    half, tick = shown_moment(page)
    assert half == 2
    assert abs(tick - TICKS / 2) < 30


def test_each_camera_shows_another_picture_and_a_click_on_a_robot_its_trail(
    show: Callable[..., Any], run: Path
) -> None:
    page = show(run, "#h1t550")
    x, y, _ = page.evaluate(
        "(() => { const p = replay.recording.pose(3, replay.place); return replay.app.view.project(p.x, p.y, p.z); })()"
    )
    box = page.locator("#view").bounding_box()
    page.mouse.click(box["x"] + x * box["width"], box["y"] + y * box["height"])
    assert page.evaluate("[...replay.app.robots.trails]") == [3]
    assert page.evaluate("replay.recording.trail(3, replay.place, 5)[0].length") == pytest.approx(5 / 0.032, abs=3)
    pictures = [picture(page)]
    for key in "2345":
        page.keyboard.press(key)
        settled(page)
        pictures.append(picture(page))
    assert len({tuple(picture) for picture in pictures}) == 5
    assert page.locator("#behind").input_value() == "0"


def test_a_match_starts_by_a_tap_on_the_picture_and_pauses_by_another(show: Callable[..., Any], run: Path) -> None:
    page = show(run, "", viewport=NARROW, script=NO_WEBGL, has_touch=True, is_mobile=True)
    assert page.is_visible("#begin")
    page.tap("#view")  # on the ball in the middle
    until(page, "replay.place > 5")
    assert page.is_hidden("#begin")
    box = page.locator("#view").bounding_box()
    page.touchscreen.tap(box["x"] + 10, box["y"] + box["height"] - 10)
    settled(page)
    assert page.evaluate("[replay.app.player.playing, [...replay.app.robots.trails]]") == [False, []]


def test_a_replay_opened_by_a_command_plays_by_itself(
    show: Callable[..., Any], run: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    opened: list[str] = []
    monkeypatch.setattr("webbrowser.open", lambda address: opened.append(address) or True)
    assert open_replay(run) == (run / "replay.html", True)
    page = show(run, f"#{opened[0].partition('#')[2]}", anew=True)
    until(page, "replay.place > 5")


# --- any screen --------------------------------------------------------------------------------------------------------

CUT_OFF = """() => [...document.querySelectorAll(".team .name, .half, .phase, #caption")]
  .filter((one) => one.scrollWidth > one.clientWidth + 1 && one.clientWidth || one.scrollHeight > one.clientHeight + 1 && one.clientHeight)
  .map((one) => one.textContent)"""


TOO_SMALL = """() => [...document.querySelectorAll("button, select")].filter((one) => one.checkVisibility())
  .map((one) => [one.id || one.textContent, one.getBoundingClientRect()])
  .filter(([, box]) => box.width < 44 || box.height < 44).map(([name]) => name)"""


def test_on_a_phone_the_field_stays_in_sight_and_nothing_is_cut_off(show: Callable[..., Any], run: Path) -> None:
    page = show(run, f"#h1t{GOALS[1]}", viewport=NARROW, script=NO_WEBGL, has_touch=True, is_mobile=True)
    for size in (NARROW, SMALL, LYING):
        shown = ("#view", "#play", "#seek", "#clock", "#panel") + (() if size == LYING else ("#events",))
        page.set_viewport_size(size)
        page.evaluate("document.getElementById('events').scrollTop = 1e6; scrollTo(0, 1e6)")
        settled(page)
        assert page.evaluate("[scrollX, scrollY]") == [0, 0]
        assert page.evaluate("document.documentElement.scrollWidth") <= size["width"]
        for thing in shown:
            box = page.locator(thing).bounding_box()
            assert box["y"] >= 0
            assert box["y"] + box["height"] <= size["height"], thing
        assert page.locator("#events").is_visible() == ("#events" in shown)
        assert page.evaluate(TOO_SMALL) == [], size
        assert page.locator("#view").bounding_box()["height"] >= 0.35 * size["height"]
        assert page.locator("#phase").inner_text() == "goal pause · robots held"
        assert page.evaluate(CUT_OFF) == [], size
        corners = page.evaluate("replay.app.camera.outermost().map((corner) => replay.app.view.project(...corner))")
        assert all(0 <= x <= 1 and 0 <= y <= 1 for x, y, _ in corners), size
    page.tap("#play")
    until(page, f"replay.place > {GOALS[1]} + 5")


def test_names_are_text_whatever_they_contain(show: Callable[..., Any], tmp_path: Path) -> None:
    page = show(write_storied_run(tmp_path, (HOSTILE, ENDLESS_NAME), with_sensors=False), "#h1t420", script=NO_WEBGL)
    assert page.locator(".team .name").first.text_content() == HOSTILE
    assert page.locator(".team .name").last.text_content() == ENDLESS_NAME[:200]
    assert "stolen" not in page.title().split(HOSTILE[:40])[0]
    assert page.evaluate("document.querySelectorAll('img').length") == 0
    assert page.evaluate("document.documentElement.scrollWidth") <= WIDE["width"]
    assert page.locator("#clock").is_visible()
    assert page.evaluate("replay.app.view.name") == "2-D"
    sample = """(() => { const pen = replay.app.view.pen, { width, height } = pen.canvas;
      return [...pen.getImageData(width * 0.45, height * 0.3, 1, 1).data]; })()"""
    red, green, blue, _ = page.evaluate(sample)
    assert green > max(red, blue)


@pytest.mark.nightly
def test_everything_that_can_be_pressed_has_a_name(show: Callable[..., Any], run: Path) -> None:
    page = show(run)
    for tab in ("#tab-robots", "#tab-output", "#tab-show", "#tab-events"):
        page.click(tab)
        nameless = page.evaluate(
            """() => [...document.querySelectorAll("button, select, input, a, canvas[tabindex]")].filter((thing) =>
              thing.checkVisibility() && !(thing.getAttribute("aria-label") || thing.textContent.trim()
              || thing.labels?.[0]?.textContent.trim())).map((thing) => thing.outerHTML)"""
        )
        assert nameless == []
