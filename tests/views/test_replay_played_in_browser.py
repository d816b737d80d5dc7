"""The replay page in a real browser as it is played: pace, keys, time line and the address of a moment."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from rcj_challenges.records.testing import write_made_up_run
from rcj_challenges.views.replay import write_replay
from tests.views.browser_stage import NO_WEBGL, settled, shown_moment, until

TICKS = 1500


@pytest.fixture(scope="module")
def run(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = write_made_up_run(tmp_path_factory.mktemp("runs"), ticks=TICKS, halves=2)
    write_replay(folder)
    return folder


def test_play_pause_rewind_and_speed(show: Callable[..., Any], run: Path) -> None:
    page = show(run, "#h1t500")
    page.select_option("#speed", "16")
    page.click("#play")
    until(page, "replay.tick > 700 || replay.half > 1")
    page.click("#play")
    settled(page)
    assert page.get_by_role("button", name="Play", exact=True).count() == 1
    stopped = page.evaluate("replay.place")
    assert stopped == round(stopped)
    page.select_option("#speed", "1")
    page.click("#rewind")
    until(page, f"replay.place < {stopped} - 20")
    page.keyboard.press("k")
    page.keyboard.press("k")
    assert page.evaluate("replay.app.player.playing") is False


@pytest.mark.parametrize(
    "speed", [*(pytest.param(slow, marks=pytest.mark.nightly) for slow in ("0.25", "1")), "4", "16"]
)
def test_time_runs_as_fast_as_was_asked_for(speed: str, show: Callable[..., Any], run: Path) -> None:
    page = show(run, "#h1t100")
    moved = page.evaluate(
        """(speed) => {
          const player = replay.app.player;
          player.speed = Number(speed);
          player.start(1, 1);
          const from = player.place;
          player.advance(0.5);
          player.pause();
          return player.place - from;
        }""",
        speed,
    )
    assert moved == pytest.approx(0.5 * float(speed) / 0.032, abs=0.51)


def test_keys_move_by_frames_seconds_events_and_to_the_ends(show: Callable[..., Any], run: Path) -> None:
    page = show(run, "#h1t450")
    for key, expected in (
        (".", [1, 451]), (",", [1, 450]), ("ArrowRight", [1, 606]), ("ArrowLeft", [1, 450]), ("n", [1, 800]),
        ("p", [1, 400]), ("End", [2, TICKS]), ("Home", [1, 0]),
    ):  # fmt: skip
        page.keyboard.press(key)
        assert shown_moment(page) == expected, key


def test_the_time_line_can_be_dragged_and_says_where_it_is(show: Callable[..., Any], run: Path) -> None:
    page = show(run)
    box = page.locator("#seek").bounding_box()
    page.mouse.move(box["x"] + 9, box["y"] + 28)
    page.mouse.down()
    page.mouse.move(box["x"] + box["width"] * 0.75, box["y"] + 28, steps=5)
    page.mouse.up()
    half, tick = shown_moment(page)
    assert half == 2
    assert abs(tick - TICKS / 2) < 30
    settled(page)
    assert page.get_attribute("#seek", "aria-valuetext").startswith("half 2, 0:2")


def test_over_the_time_line_stands_the_time_to_which_a_click_leads(show: Callable[..., Any], run: Path) -> None:
    page = show(run, "#h1t1", anew=True, script=NO_WEBGL)
    box = page.locator("#seek").bounding_box()
    for share in (0.06, 0.2, 0.9, 0.95):  # no event is near
        page.mouse.move(box["x"] + box["width"] * share, box["y"] + 28)
        told = page.inner_text("#hover")
        page.mouse.down()
        page.mouse.up()
        settled(page)
        assert told == page.inner_text("#clock"), share


def test_the_event_that_has_just_happened_is_in_sight_when_one_comes_back_to_the_list(
    show: Callable[..., Any], run: Path
) -> None:
    page = show(run, "#h1t10", anew=True, script=NO_WEBGL, viewport={"width": 740, "height": 360})

    def in_sight() -> bool:
        page.mouse.move(200, 200)
        settled(page)
        events, current = (page.locator(what).bounding_box() for what in ("#events", "#events [aria-current]"))
        below = current["y"] + current["height"] - events["y"] - events["height"]
        return events["y"] <= current["y"] and below <= 0.5

    page.click("#tab-robots")
    page.evaluate("replay.seek(2, 1400)")
    page.click("#tab-events")
    assert in_sight()
    page.set_viewport_size({"width": 360, "height": 740})  # a phone is turned: upright the whole page scrolls
    settled(page)
    page.set_viewport_size({"width": 740, "height": 360})
    assert in_sight()


def test_an_address_names_a_moment_and_follows_it(show: Callable[..., Any], run: Path) -> None:
    page = show(run, "#h2t123", script=NO_WEBGL)
    assert shown_moment(page) == [2, 123]
    page.evaluate("location.hash = '#h1t77'")
    until(page, "replay.half === 1 && replay.tick === 77")
    page.keyboard.press(".")
    until(page, "location.hash === '#h1t78'")
    page.evaluate("location.hash = '#nonsense'")
    assert shown_moment(page) == [1, 78]


def test_nothing_glides_where_the_referee_put_it(show: Callable[..., Any], run: Path) -> None:
    # After a goal the ball is put on the centre spot: it is in the goal until the next tick, not on its way.
    page = show(run)
    before, between, after = page.evaluate(
        "[400, 400.5, 401].map((tick) => replay.recording.halves[0].pose(6, tick).y)"
    )
    assert before == between != after
    glided = page.evaluate("[402, 402.5, 403].map((tick) => replay.recording.halves[0].pose(6, tick).y)")
    assert glided[1] == pytest.approx((glided[0] + glided[2]) / 2)


def test_on_paper_there_is_the_picture_and_nothing_to_press(show: Callable[..., Any], run: Path) -> None:
    page = show(run)
    page.wait_for_timeout(100)  # the picture has gone to the screen: what is read of it now is empty
    middle = page.evaluate(
        """() => {
          dispatchEvent(new Event("beforeprint"));
          const view = document.getElementById("view"), pen = document.createElement("canvas").getContext("2d");
          pen.drawImage(view, view.width / 2, view.height / 2, 1, 1, 0, 0, 1, 1);
          return [...pen.getImageData(0, 0, 1, 1).data];
        }"""
    )
    assert sum(middle[:3]) > 60, middle
    page.emulate_media(media="print")
    try:
        assert not [button for button in page.get_by_role("button").all() if button.is_visible()]
        assert page.locator("#events .event").first.is_visible()
        assert page.locator("#clock").is_visible()
    finally:
        page.emulate_media(media="screen")


def test_on_paper_that_lies_no_event_is_cut_off(show: Callable[..., Any], run: Path) -> None:
    page = show(run, anew=True, script=NO_WEBGL, viewport={"width": 1123, "height": 400})
    page.emulate_media(media="print")
    try:
        shown_px, whole_px = page.locator("#events").evaluate("list => [list.clientHeight, list.scrollHeight]")
        assert whole_px > 400
        assert shown_px == whole_px
        assert page.evaluate("document.documentElement.scrollHeight") >= whole_px
    finally:
        page.emulate_media(media="screen")


@pytest.mark.parametrize("width_px", [360, 390])
def test_on_a_phone_the_sentences_of_a_match_are_whole(width_px: int, show: Callable[..., Any], run: Path) -> None:
    page = show(run, "#h1t800", viewport={"width": width_px, "height": 740}, script=NO_WEBGL)
    caption = page.locator("#caption")
    for told in (
        "GOAL: The ball is in the yellow goal; the goal counts for blue, whoever touched it last.",
        "LACK_OF_PROGRESS: The ball made no progress or left the field; it is put on a neutral spot.",
        "ROBOT_DAMAGED: Y3 was put back again and again without moving away; it is taken off as damaged.",
    ):
        caption.evaluate("(box, told) => { box.textContent = told; }", told)
        assert caption.evaluate("box => box.scrollHeight <= box.clientHeight + 1"), told
    # The picture leaves room for it below the field.
    floor = page.evaluate("replay.app.camera.below * document.getElementById('view').clientHeight")
    assert caption.bounding_box()["height"] <= floor + 1


def test_the_link_button_says_for_a_moment_that_it_has_copied_and_then_again_what_it_does(
    show: Callable[..., Any], run: Path
) -> None:
    page = show(run, anew=True, script=NO_WEBGL)
    page.evaluate("delete Element.prototype.ariaLabel")  # Firefox has it from 119 on: 115 is the last one for Windows 7
    does = page.get_attribute("#copy", "title")
    page.click("#copy")
    title = "document.getElementById('copy').title"
    until(page, f"{title} !== {does!r}")
    page.click("#copy")
    until(page, f"{title} === {does!r}")
