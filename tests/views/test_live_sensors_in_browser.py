"""Logos, readings, rays and printed lines of a live match in a real browser, also for who comes late."""

import math
from collections.abc import Callable
from typing import Any

import pytest

from tests.views.browser_stage import NARROW, NO_WEBGL, WIDE, settled, until
from tests.views.live_play import MadeUpMatch
from tests.views.sensing_play import ENDLESS, HOSTILE, READINGS_AT_125, TURNED, logo, reading

TICKS = 500


@pytest.fixture
def match(made_up_match: Callable[..., MadeUpMatch]) -> Callable[..., MadeUpMatch]:
    """Return what makes a match whose sensors are recorded, of a team with a logo."""
    return lambda **options: made_up_match(**{"ticks": TICKS, "logos": {"blue": logo(200)}, "sensors": True, **options})


def _shown(page: Any, half: int, tick: int) -> Any:
    """Go to a moment, wait until the page stands still there, and return the card of B1."""
    page.evaluate(f"replay.seek({half}, {tick})")
    until(page, f"replay.half === {half} && replay.tick === {tick}")
    settled(page)
    return page.locator(".robot", has_text="B1").first


@pytest.mark.parametrize("size", [WIDE, pytest.param(NARROW, marks=pytest.mark.nightly)], ids=["wide", "narrow"])
def test_who_comes_late_sees_logos_readings_and_printed_lines_and_can_look_back(
    size: dict[str, int], match: Callable[..., MadeUpMatch], watch: Callable[..., Any]
) -> None:
    played = match()
    played.show.pace.pause()
    played.show.pace.step(400)
    played.start()
    page = watch(played.show.address, viewport=size)
    until(page, "replay.place === 400 && replay.app.sensors.observation(0, 400)?.tick === 400")
    page.wait_for_selector("img.logo")
    assert page.locator("img.logo").count() == 1
    assert page.locator(".team", has_text="Hanse").locator("img.logo").is_visible()
    page.click("#tab-robots")
    card = page.locator(".robot", has_text="B1").first
    settled(page)
    assert reading(card, "observation") == "tick 400"
    assert reading(card, "distancesensor left") == "650.0"
    assert page.locator("#no-sensors").is_hidden()
    page.click("#tab-output")
    settled(page)
    assert page.locator("#printed .line bdi").last.inner_text() == "tick 400"

    _shown(page, 1, 125)
    texts = page.locator("#printed bdi").all_text_contents()
    assert texts == ["ready", "ready", HOSTILE.rstrip(), TURNED.rstrip("\n"), ENDLESS.rstrip(), "tick 100"]
    assert page.title().startswith("Hanse - </script>")
    assert page.evaluate("document.querySelectorAll('#printed img, #printed script').length") == 0
    page.click("#tab-robots")
    card = _shown(page, 1, 125)
    assert {name: reading(card, name) for name in READINGS_AT_125} == READINGS_AT_125
    assert page.evaluate("document.documentElement.scrollWidth") <= size["width"]

    # The match goes on, into the second half; what is looked at stays, until one goes back to now.
    played.show.pace.resume()
    until(page, "replay.recording.over")
    assert page.evaluate("replay.tick") == 125
    card = _shown(page, 2, TICKS)
    assert reading(card, "observation") == f"tick {TICKS}"


def test_it_ends_with_the_readings_and_rays_of_the_replay(
    match: Callable[..., MadeUpMatch], watch: Callable[..., Any]
) -> None:
    played = match().start()
    page = watch(played.show.address, script=NO_WEBGL)
    played.end()
    until(page, "replay.recording.over")
    replay = watch(f"{played.show.address}replay.html", script=NO_WEBGL)
    until(replay, "[1, 2].map((half) => replay.app.sensors.half(half) && replay.app.output.of(half)).every(Boolean)")
    everything = f"""() => [1, 2].map((half) => [...replay.app.sensors.half(half).values()].map((robot) => [
      robot.facts.name, robot.facts.units, robot.facts.devices, [...robot.ticks],
      robot.columns.map((column) => [0, 1, 2, 77, 256, 257, {TICKS}].map((row) => column[row])),
    ]).concat([replay.app.output.of(half)]))"""
    assert page.evaluate(everything) == replay.evaluate(everything)
    rays = f"replay.app.sensors.raysAt({TICKS + 1 + 77}, true)"
    live, recorded = page.evaluate(rays), replay.evaluate(rays)
    assert [ray["colour"] for ray in live] == [ray["colour"] for ray in recorded]
    assert len(live) == 6
    for one, other in zip(_flat(live), _flat(recorded), strict=True):
        assert math.isclose(one, other, abs_tol=2e-4)


def _flat(nested: Any) -> list[float]:
    if isinstance(nested, dict):
        return _flat(nested["pieces"])
    return [number for part in nested for number in _flat(part)] if isinstance(nested, list) else [nested]


def test_each_step_of_a_paused_match_shows_the_readings_of_its_tick(
    match: Callable[..., MadeUpMatch], watch: Callable[..., Any]
) -> None:
    played = match()
    played.show.pace.pause()
    played.show.pace.step(20)
    page = watch(played.start().show.address, script=NO_WEBGL)
    page.click("#tab-robots")
    for tick in range(20, 23):
        until(page, f"replay.place === {tick} && replay.app.sensors.observation(0, {tick})?.tick === {tick}")
        settled(page)
        assert reading(page.locator(".robot", has_text="B1").first, "observation") == f"tick {tick}"
        played.show.pace.step(1)


@pytest.mark.nightly
def test_readings_go_on_after_a_lost_connection(match: Callable[..., MadeUpMatch], watch: Callable[..., Any]) -> None:
    played = match()
    played.show.pace.set_speed(2.0)
    page = watch(played.start().show.address, script=NO_WEBGL)
    until(page, "replay.recording.last > 50")
    page.evaluate("replay.liveClient.feed.reader.cancel()")
    played.end()
    until(page, "replay.recording.over")
    ticks = page.evaluate("[...replay.app.sensors.half(2).get('Y2').ticks]")
    assert ticks == list(range(TICKS + 1))
