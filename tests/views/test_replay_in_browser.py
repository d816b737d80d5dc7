"""The replay page in a real browser: it opens from disk, plays, and every event is a link to its moment."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import rcj_challenges
from rcj_challenges.records.testing import write_made_up_run
from rcj_challenges.records.trajectory import Trajectory
from rcj_challenges.views.replay import write_replay
from tests.views.browser_stage import NARROW, NO_WEBGL, WIDE, Stage, picture, settled, shown_moment, until

HOSTILE = "</script><script>document.title='stolen'</script><img src=x onerror=\"document.title='stolen'\">"
TICKS = 1500
PARTS_OF_THE_FLOOR = ("maths", "colours", "mesh", "ground")


@pytest.fixture(scope="module")
def run(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = write_made_up_run(tmp_path_factory.mktemp("runs"), ticks=TICKS, halves=2)
    write_replay(folder)
    return folder


# --- what is shown -----------------------------------------------------------------------------------------------------


def test_the_page_opens_from_disk_with_teams_clock_and_a_picture(show: Callable[..., Any], run: Path) -> None:
    page = show(run, "", anew=True)
    assert page.locator(".team .name").all_inner_texts() == ["Hanse", "Alster"]
    assert page.locator("#clock").inner_text() == "0:00.0"
    assert page.locator("#half").inner_text() == "half 1 of 2 · 0:48"
    colours = picture(page)
    green = [colour for colour in colours if (colour >> 8 & 255) > 1.3 * max(colour >> 16, colour & 255)]
    assert len(green) > 100  # the field fills the picture
    assert len(set(colours)) > 8


def test_poses_in_the_page_equal_the_trajectory(show: Callable[..., Any], run: Path) -> None:
    page = show(run)
    halves = Trajectory.open(run).halves
    assert len(halves) == 2
    for half in halves:
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
        tilt = np.arccos(np.clip(half.uprights[::7].astype(float), -1, 1))
        assert np.degrees(np.abs(shown[:, :, 4] - tilt)).max() < 0.1


@pytest.mark.nightly
def test_the_ball_rolls_without_slipping(show: Callable[..., Any], run: Path) -> None:
    # Over one tick the turn is the way rolled over the radius, about the axis to the left of the way.
    page = show(run)
    turn, way = page.evaluate(
        """() => {
          const track = replay.recording.halves[0], [i, j, k, w] = track.spin(6, 100), [a, b, c, d] = track.spin(6, 101);
          const from = track.pose(6, 100), to = track.pose(6, 101);
          const dot = Math.min(1, Math.abs(i * a + j * b + k * c + w * d));
          return [2 * Math.acos(dot), Math.hypot(to.x - from.x, to.y - from.y)];
        }"""
    )
    assert turn == pytest.approx(way / 0.021, rel=0.05)


def test_a_second_goal_is_in_sight_after_the_filter_and_one_click_lands_on_it(
    show: Callable[..., Any], run: Path
) -> None:
    page = show(run)
    page.click("#filters >> text=GOAL")
    second = page.locator("a.moment", has_text="GOAL").nth(1)
    box = second.bounding_box()
    assert box["y"] > 0
    assert box["y"] + box["height"] < WIDE["height"]
    second.click()
    settled(page)
    assert shown_moment(page) == [1, 800]
    assert page.locator("#clock").inner_text() == "0:25.6"
    assert page.locator("#phase").inner_text() == "goal pause · robots held"
    assert [score.inner_text() for score in page.locator(".score").all()] == ["0", "2"]
    assert "GOAL" in page.locator("#caption").inner_text()


def test_an_event_unfolds_what_the_referee_measured(show: Callable[..., Any], run: Path) -> None:
    page = show(run)
    page.click("#filters >> text=GOAL")
    page.locator("a.moment").first.click()
    details = page.locator(".details").inner_text()
    for words in ("0.76", "0.745", "goal (enters)", "The ball is in the goal."):
        assert words in details
    page.click("text=from 3 s before")
    until(page, "replay.tick > 310")
    assert 306 <= shown_moment(page)[1] < 400


def test_every_event_of_the_list_lands_on_its_tick(show: Callable[..., Any], run: Path) -> None:
    page = show(run)
    landed = page.evaluate(
        """() => [...document.querySelectorAll("a.moment")].map((link, index) => {
          link.click();
          const event = replay.recording.events[index];
          return [replay.half - event.half, replay.tick - event.tick];
        })"""
    )
    assert len(landed) == 14
    assert {tuple(off) for off in landed} == {(0, 0)}


def test_teams_change_colours_at_half_time_and_keep_their_goals(show: Callable[..., Any], run: Path) -> None:
    page = show(run, "#h1t1499")
    chips = "[...document.querySelectorAll('.team .chip')].map((chip) => chip.style.background)"
    blue, yellow = page.evaluate(chips)
    page.evaluate("replay.seek(2, 500)")
    settled(page)
    assert page.evaluate(chips) == [yellow, blue]
    assert [score.inner_text() for score in page.locator(".score").all()] == ["1", "3"]


# --- looking -----------------------------------------------------------------------------------------------------------


def test_each_camera_shows_another_picture(show: Callable[..., Any], run: Path) -> None:
    page = show(run, "#h1t450")
    pictures = [picture(page)]
    for key in "2345":
        page.keyboard.press(key)
        settled(page)
        pictures.append(picture(page))
    assert len({tuple(picture) for picture in pictures}) == 5
    assert page.locator("#behind").input_value() == "0"
    page.click("[data-camera=top]")
    assert page.get_attribute("[data-camera=top]", "aria-pressed") == "true"
    settled(page)
    assert page.evaluate("replay.app.camera.pose.elevation") > 1.56


@pytest.mark.nightly
def test_the_camera_behind_a_robot_follows_it(show: Callable[..., Any], run: Path) -> None:
    page = show(run, "#h1t10")
    page.select_option("#behind", label="Y2")
    for tick in (10, 700):
        page.evaluate(f"replay.seek(1, {tick})")
        until(page, "!replay.app.waiting")
        x, y = page.evaluate("(() => { const p = replay.recording.pose(4, replay.place); return [p.x, p.y]; })()")
        target = page.evaluate("replay.app.camera.pose.target")
        assert np.hypot(target[0] - x, target[1] - y) == pytest.approx(0.16, abs=0.01)


@pytest.mark.nightly
def test_the_whole_field_is_in_the_picture_on_any_screen(show: Callable[..., Any], run: Path) -> None:
    for size in (WIDE, NARROW, {"width": 844, "height": 390}, {"width": 820, "height": 1180}):
        page = show(run, viewport=size)
        corners = page.evaluate("replay.app.camera.outermost().map((corner) => replay.app.view.project(...corner))")
        assert all(0 <= x <= 1 and 0 <= y <= 1 for x, y, _ in corners), size
        spread = np.ptp(np.array(corners)[:, :2], axis=0)
        assert spread.max() > 0.85, size


@pytest.mark.parametrize("size", [(1280, 800), (1024, 600), (360, 740)], ids=str)
def test_the_buttons_of_the_cameras_cover_no_part_of_the_field(
    size: tuple[int, int], show: Callable[..., Any], run: Path
) -> None:
    page = show(run, viewport={"width": size[0], "height": size[1]})
    for camera in ("overview", "top"):
        page.click(f"[data-camera={camera}]")
        settled(page)
        highest, lower_edge = page.evaluate(
            """() => {
              const stage = document.querySelector(".stage").getBoundingClientRect();
              const floor = replay.app.camera.outermost().filter(([x, y, z]) => z === 0);
              const heights = floor.map((corner) => replay.app.view.project(...corner)[1] * stage.height);
              return [Math.min(...heights), document.getElementById("cameras").getBoundingClientRect().bottom - stage.top];
            }"""
        )
        assert highest >= lower_edge, camera


@pytest.mark.nightly
def test_drag_turns_wheel_zooms_and_shift_drag_moves(show: Callable[..., Any], run: Path) -> None:
    page = show(run)
    pose = "(() => { const p = replay.app.camera.pose; return [p.azimuth, p.distance, p.target[0], p.target[1]]; })()"
    first = page.evaluate(pose)
    page.mouse.move(400, 400)
    page.mouse.down()
    page.mouse.move(500, 400)
    page.mouse.up()
    turned = page.evaluate(pose)
    assert turned[0] == pytest.approx(first[0] - 0.6)
    page.mouse.wheel(0, -100)
    until(page, f"replay.app.camera.pose.distance < {first[1]}")
    page.keyboard.down("Shift")
    page.mouse.down()
    page.mouse.move(600, 400)
    page.mouse.up()
    page.keyboard.up("Shift")
    moved = page.evaluate(pose)
    assert moved[0] == turned[0]
    assert np.hypot(moved[2] - turned[2], moved[3] - turned[3]) > 0.05
    page.mouse.dblclick(400, 300)
    settled(page)
    assert page.evaluate("replay.app.camera.mode") == "overview"


def test_a_click_on_a_robot_shows_its_trail(show: Callable[..., Any], run: Path) -> None:
    page = show(run, "#h1t600")
    x, y, _ = page.evaluate(
        "(() => { const p = replay.recording.pose(3, replay.place); return replay.app.view.project(p.x, p.y, p.z); })()"
    )
    box = page.locator("#view").bounding_box()
    page.mouse.click(box["x"] + x * box["width"], box["y"] + y * box["height"])
    assert page.evaluate("[...replay.app.robots.trails]") == [3]
    page.click("#tab-robots")
    assert page.get_by_role("button", name="Trail of Y1").get_attribute("aria-pressed") == "true"
    trail = page.evaluate("replay.recording.trail(3, replay.place, 5)")
    assert len(trail) == 1
    assert len(trail[0]) == pytest.approx(5 / 0.032, abs=3)
    assert page.evaluate("replay.app.frame.trails.length") == 1


@pytest.mark.nightly
def test_a_failed_program_is_said_on_the_robots_card(show: Callable[..., Any], run: Path) -> None:
    page = show(run, "#h1t299")
    page.click("#tab-robots")
    settled(page)
    card = page.locator(".robot", has_text="Y1")
    assert "failed" not in card.inner_text()
    page.keyboard.press(".")
    settled(page)
    assert "program failed at 0:09.6: crash: ZeroDivisionError" in card.inner_text()


def test_a_robot_that_a_rule_holds_is_told_beside_the_clock_and_on_its_card(
    show: Callable[..., Any], run: Path
) -> None:
    page = show(run, "#h1t199")
    page.click("#tab-robots")
    settled(page)
    assert page.locator("#phase").is_hidden()
    page.keyboard.press(".")
    settled(page)
    assert page.locator("#phase").inner_text() == "B1 held"
    assert [card.split()[-1] == "held" for card in page.locator(".robot .numbers").all_inner_texts()] == [True] + 6 * [
        False
    ]


def test_without_a_recording_of_sensors_the_page_says_how_to_get_one(show: Callable[..., Any], run: Path) -> None:
    page = show(run)
    page.click("#tab-robots")
    assert "--record sensors" in page.locator("#no-sensors").inner_text()
    assert page.get_by_role("button", name="Rays").count() == 0
    page.click("#tab-show")
    assert page.locator("input[name=rays]").is_disabled()


def test_a_zone_that_has_a_colour_is_shown_in_it(show: Callable[..., Any], run: Path) -> None:
    viewer = Path(rcj_challenges.__file__).parent / "views" / "replay" / "viewer"
    parts = "\n".join((viewer / f"{name}.js").read_text(encoding="utf-8") for name in PARTS_OF_THE_FLOOR)
    colours = show(run).evaluate(
        "() => {"
        + parts
        + """
          const field = { width_m: 1.3, length_m: 1.5, corner_cut_m: 0.06, goals: [] };
          const zone = { shape: "circle", centre_m: [0, 0], radius_m: 0.2, inverted: false, drawn: true };
          const facts = { field, zones: [{ ...zone, name: "plain" }, { ...zone, name: "base", colour: "red" }] };
          const lines = [...Ground.field(facts), ...Ground.marks(facts, { zones: true })].filter((one) => one.line);
          return lines.map((one) => one.line.join());
        }"""
    )
    assert colours.count("1,0,0") == 2
    assert len(colours) == 5  # the edge of the field, and each zone as a line and as a mark


@pytest.mark.parametrize(
    ("zone", "ends"),
    [
        ("x_min_m: -0.35, x_max_m: 0.35, y_min_m: 0.59, y_max_m: null", [-0.35, 0.35, 0.59, 0.75]),  # to the wall
        ("x_min_m: null, x_max_m: null, y_min_m: null, y_max_m: 0", [-0.65, 0.65, -0.75, 0]),
        ("x_min_m: -0.2, x_max_m: 0.2, y_min_m: 0.745, y_max_m: 0.849", [-0.2, 0.2, 0.745, 0.849]),  # nothing is open
        ("x_min_m: null, x_max_m: null, y_min_m: 0.8, y_max_m: null", [-0.81, 0.81, 0.8, 0.91]),  # behind the floor
    ],
)
def test_a_zone_with_an_open_side_ends_where_the_floor_does(
    zone: str, ends: list[float], show: Callable[..., Any], run: Path
) -> None:
    # As in the drawing of the rule sheet: a penalty area reaches to the wall, not into the goal and beyond.
    viewer = Path(rcj_challenges.__file__).parent / "views" / "replay" / "viewer"
    parts = "\n".join((viewer / f"{name}.js").read_text(encoding="utf-8") for name in PARTS_OF_THE_FLOOR)
    found = show(run).evaluate(
        "() => {"
        + parts
        + f"""
          const field = {{ width_m: 1.3, length_m: 1.5, corner_cut_m: 0.06, goals: [] }};
          const points = Ground.zone({{ shape: "rect", {zone} }}, field);
          const [xs, ys] = [0, 1].map((axis) => points.map((point) => point[axis]));
          return [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
        }}"""
    )
    assert found == pytest.approx(ends)


def test_zones_gates_and_spots_can_be_shown(show: Callable[..., Any], run: Path) -> None:
    page = show(run)
    before = picture(page)
    page.keyboard.press("z")
    settled(page)
    assert {"penalty_area", "middle", "half_way", "centre"} <= set(page.locator(".label.mark").all_inner_texts())
    assert picture(page) != before


# --- everybody ---------------------------------------------------------------------------------------------------------


@pytest.mark.nightly
def test_everything_that_can_be_pressed_has_a_name(show: Callable[..., Any], run: Path) -> None:
    page = show(run)
    for tab in ("#tab-robots", "#tab-show", "#tab-events"):
        page.click(tab)
        nameless = page.evaluate(
            """() => [...document.querySelectorAll("button, select, input, a, canvas[tabindex]")].filter((thing) =>
              thing.checkVisibility() && !(thing.getAttribute("aria-label") || thing.textContent.trim()
              || thing.labels?.[0]?.textContent.trim())).map((thing) => thing.outerHTML)"""
        )
        assert nameless == []


def test_who_opens_a_link_to_a_late_moment_sees_the_event_that_has_just_happened_in_the_list(
    show: Callable[..., Any], run: Path
) -> None:
    page = show(run, "#h2t1400", anew=True)
    settled(page)
    current = page.locator("#events [aria-current]").bounding_box()
    events = page.locator("#events").bounding_box()
    assert page.evaluate("document.getElementById('events').scrollHeight") > events["height"]  # not all fit in
    assert events["y"] <= current["y"]
    assert current["y"] + current["height"] <= events["y"] + events["height"]


def test_the_tab_key_reaches_the_time_line_and_its_buttons_before_the_hundreds_of_events(
    show: Callable[..., Any], run: Path
) -> None:
    page = show(run)
    page.focus("#behind")
    page.keyboard.press("Tab")
    assert page.evaluate("document.activeElement.id") == "seek"
    page.focus("#speed")
    page.keyboard.press("Tab")
    assert page.evaluate("document.activeElement.id") == "tab-events"


@pytest.mark.nightly
def test_tabs_are_walked_with_the_arrow_keys(show: Callable[..., Any], run: Path) -> None:
    page = show(run)
    page.focus("#tab-events")
    page.keyboard.press("ArrowRight")
    assert page.locator("#panel-robots").is_visible()
    assert not page.locator("#panel-events").is_visible()
    assert page.evaluate("document.activeElement.id") == "tab-robots"


@pytest.mark.nightly
def test_the_page_is_light_or_dark_as_the_reader_likes_it(show: Callable[..., Any], run: Path) -> None:
    ground = "getComputedStyle(document.body).backgroundColor"
    light = show(run, color_scheme="light").evaluate(ground)
    page = show(run, color_scheme="dark")
    assert page.evaluate(ground) != light
    page.click("#theme")
    assert page.evaluate(ground) == light


def test_on_a_phone_the_picture_and_the_keys_are_in_sight_and_nothing_is_cut_off(
    show: Callable[..., Any], run: Path
) -> None:
    page = show(run, viewport=NARROW, has_touch=True, is_mobile=True)
    assert page.evaluate("document.documentElement.scrollWidth") <= NARROW["width"]
    for thing in ("#view", "#play", "#seek", "#clock"):
        box = page.locator(thing).bounding_box()
        assert box["y"] >= 0
        assert box["y"] + box["height"] <= NARROW["height"], thing
    page.tap("#play")
    until(page, "replay.place > 5")


WHOLE = """() => [...document.querySelectorAll(".team .name, .half, .phase:not([hidden])")]
  .filter((one) => one.scrollWidth > one.clientWidth + 1 && one.clientWidth || one.scrollHeight > one.clientHeight + 1 && one.clientHeight)
  .map((one) => one.textContent)"""
"""Names and words of the scoreboard of which something is cut off."""


@pytest.mark.parametrize(
    ("size", "names"),
    [
        ({"width": 360, "height": 740}, ("Roles and Radio", "All Sensors")),
        ({"width": 844, "height": 390}, ("Roles and Radio", "All Sensors")),
        ({"width": 900, "height": 700}, ("Roles and Radio", "All Sensors")),
        ({"width": 1280, "height": 800}, ("Good Old Days (blue first)", "Good Old Days (yellow first)")),
    ],
    ids=["phone", "phone that lies", "tablet that lies", "laptop"],
)
def test_the_scoreboard_cuts_off_nothing_for_which_there_is_room(
    size: dict[str, int], names: tuple[str, str], show: Callable[..., Any], tmp_path: Path
) -> None:
    folder = write_made_up_run(tmp_path, ticks=TICKS, halves=1, names=names)
    write_replay(folder)
    page = show(folder, "#h1t800", viewport=size, script=NO_WEBGL)
    assert page.locator("#phase").inner_text() == "goal pause · robots held"
    assert page.evaluate(WHOLE) == []
    tools = page.locator(".tools").bounding_box()
    words = page.locator("#phase").bounding_box()
    assert words["x"] + words["width"] <= tools["x"]


def test_of_a_long_caption_whole_lines_are_shown(show: Callable[..., Any], run: Path) -> None:
    # Text is cut off where the border begins: in a padding the upper half of a third line could be seen.
    page = show(run, "#h1t800", viewport={"width": 360, "height": 740}, script=NO_WEBGL)
    caption = page.locator("#caption")
    assert "GOAL" in caption.inner_text()
    caption.evaluate("box => { box.textContent = 'whoever touched it last '.repeat(9); }")
    shown_px, line_px = caption.evaluate("box => [box.clientHeight, parseFloat(getComputedStyle(box).lineHeight)]")
    assert shown_px == pytest.approx(3 * line_px, abs=1)


@pytest.mark.parametrize("size", [WIDE, pytest.param(NARROW, marks=pytest.mark.nightly)], ids=["wide", "narrow"])
def test_names_are_text_whatever_they_contain(size: dict[str, int], show: Callable[..., Any], tmp_path: Path) -> None:
    endless = "\u202e\u2066" + "ح" * 10_000
    folder = write_made_up_run(tmp_path, ticks=500, halves=1, names=(HOSTILE, endless))
    write_replay(folder)
    page = show(folder, "#h1t420", viewport=size, script=NO_WEBGL)
    assert page.locator(".team .name").first.inner_text() == HOSTILE
    assert page.locator(".team .name").last.text_content() == endless
    assert "stolen" not in page.title().split(HOSTILE[:40])[0]
    assert page.evaluate("document.querySelectorAll('img').length") == 0
    assert page.evaluate("document.documentElement.scrollWidth") <= size["width"]
    assert page.locator("#clock").is_visible()


def test_without_webgl_the_field_is_drawn_from_above(show: Callable[..., Any], run: Path) -> None:
    page = show(run, "#h1t450", script=NO_WEBGL)
    assert page.evaluate("replay.app.view.name") == "2-D"
    sample = """(() => { const pen = replay.app.view.pen, { width, height } = pen.canvas;
      return [...pen.getImageData(width * 0.45, height * 0.3, 1, 1).data]; })()"""
    red, green, blue, _ = page.evaluate(sample)
    assert green > red
    assert green > blue
    pixels = "replay.app.view.canvas.toDataURL()"
    before = page.evaluate(pixels)
    page.keyboard.press("ArrowRight")
    settled(page)
    assert page.evaluate(pixels) != before


def test_a_page_whose_poses_are_damaged_says_so(
    show: Callable[..., Any], browser_stage: Stage, run: Path, tmp_path: Path
) -> None:
    text = (run / "replay.html").read_text("utf-8")
    at = text.index('id="half-1">') + 400
    (tmp_path / "replay.html").write_text(text[:at] + "AAAA" + text[at + 4 :], "utf-8")
    page = show(tmp_path, ready="#problem:not([hidden])")
    assert "cannot be shown" in page.locator("#problem").inner_text()
    assert len(browser_stage.complaints) == 1  # this one
    browser_stage.complaints.clear()
