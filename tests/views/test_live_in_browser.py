"""The live view in a real browser: watch, come late, look back, steer, and end as a replay."""

from collections.abc import Callable
from typing import Any

import pytest

from rcj_challenges.core.timing import TICK_S
from tests.made_up_runs import made_up_snapshot, small_scenario
from tests.views.browser_stage import NARROW, NO_WEBGL, until
from tests.views.live_play import HOSTILE, TICKS, MadeUpMatch
from tests.views.sensing_play import logo


def test_a_spectator_sees_the_match_go_on_while_it_is_played_and_finds_no_wheel(
    made_up_match: Callable[..., MadeUpMatch], watch: Callable[..., Any]
) -> None:
    played = made_up_match(speed=2.0).start()
    page = watch(played.show.address)
    assert page.locator(".team .name").all_inner_texts() == ["Hanse", HOSTILE]
    assert page.title().startswith("Hanse - </script>")
    first = page.evaluate("replay.place")
    until(page, f"replay.place > {first} + 40")
    assert page.get_attribute("#live", "aria-pressed") == "true"
    until(page, "replay.recording.last - replay.place < 40")
    assert page.evaluate("replay.recording.span") == 2 * (TICKS + 1) - 1  # as long as the match is planned
    # Without the token nothing steers.
    assert page.locator(".match-controls").count() == 0
    assert page.evaluate("sessionStorage.length") == 0


def test_live_page_ends_with_all_that_the_replay_has(
    made_up_match: Callable[..., MadeUpMatch], watch: Callable[..., Any]
) -> None:
    played = made_up_match(logos={"blue": logo(200)}, sensors=True).start()
    page = watch(played.show.address, script=NO_WEBGL)
    played.end()
    until(page, "replay.recording.over")
    replay = watch(f"{played.show.address}replay.html", script=NO_WEBGL)
    until(replay, "[1, 2].map((half) => replay.app.sensors.half(half) && replay.app.output.of(half)).every(Boolean)")
    for same in (
        "[replay.recording.last, replay.recording.span, replay.recording.events]",
        """replay.recording.halves.map(({ facts }) =>
          [facts.scores, facts.score_changes, facts.phases, facts.held, facts.faults, facts.sides])""",
        """replay.recording.halves.map((track) => replay.recording.entities.map((_, entity) => [...track.jumps[entity]]))""",
        """[1, 2].map((half) => [...replay.app.sensors.half(half).values()].map((robot) => [
          robot.facts.name, robot.facts.units, robot.facts.devices, [...robot.ticks],
          robot.columns.map((column) => [0, 1, 2, 77, 256, 257, 1000].map((row) => column[row])),
        ]).concat([replay.app.output.of(half)]))""",
    ):
        assert page.evaluate(same) == replay.evaluate(same)
    for close in (
        """replay.recording.halves.map((track) => [0, 1, 399, 400, 401, 1000].map((tick) =>
          replay.recording.entities.map((_, entity) => Object.values(track.pose(entity, tick)))))""",
        f"replay.app.sensors.raysAt({TICKS + 1 + 77}, true).map((ray) => ray.pieces)",
    ):
        live, recorded = page.evaluate(close), replay.evaluate(close)
        assert live
        for one, other in zip(_flat(live), _flat(recorded), strict=True):
            assert one == pytest.approx(other, abs=2e-4)
    page.click("#tab-show")
    assert "digest" in page.locator("#about").inner_text()
    assert page.locator(".keep").get_attribute("href") == "replay.html"
    until(page, "!replay.app.player.playing")
    assert page.locator("#live").text_content() == "Over"
    assert page.locator("#live").is_disabled()


def _flat(nested: Any) -> list[float]:
    return [number for part in nested for number in _flat(part)] if isinstance(nested, list) else [nested]


def test_who_has_the_token_pauses_steps_and_sets_the_speed_on_a_phone_too(
    made_up_match: Callable[..., MadeUpMatch], watch: Callable[..., Any]
) -> None:
    played = made_up_match(speed=1.0).start()
    page = watch(played.show.steering_address, viewport=NARROW, script=NO_WEBGL)
    assert "token" not in page.url  # a link that is passed on gives no control
    assert _is_wholly_on_the_screen(page, NARROW)
    page.click("#match-pause")
    until(page, "replay.liveClient.pace.paused")
    until(page, "replay.place === replay.recording.last")
    stood = page.evaluate("replay.recording.last")
    page.click("#match-step")
    until(page, f"replay.place === {stood + 1}")
    assert page.evaluate("replay.recording.last") == stood + 1
    assert "paused" in page.locator("#live").inner_text()
    page.select_option("#match-speed", "max")
    page.click("#match-pause")
    until(page, "replay.recording.over")
    assert page.locator(".match-controls").is_hidden()


def test_a_lost_connection_is_found_again(made_up_match: Callable[..., MadeUpMatch], watch: Callable[..., Any]) -> None:
    played = made_up_match(speed=1.0).start()
    page = watch(played.show.address, script=NO_WEBGL)
    last = page.evaluate("replay.recording.last")
    page.evaluate("replay.liveClient.feed.reader.cancel()")
    until(page, f"replay.recording.last > {last} + 20")
    robots = len(small_scenario(halves=2, half_s=TICKS * TICK_S).robots)
    for tick in (last, last + 1, last + 20):
        x, y = page.evaluate(
            f"(() => {{ const p = replay.recording.halves[0].pose(0, {tick}); return [p.x, p.y]; }})()"
        )
        assert (x, y) == pytest.approx(made_up_snapshot(tick, robots).substeps[-1][0][:2], abs=2e-4)


def _is_wholly_on_the_screen(page: Any, size: dict[str, int]) -> bool:
    for part in ("#live", "#match-pause", "#match-step", "#match-speed", "#clock", "#play"):
        box = page.locator(part).bounding_box()
        assert box["x"] >= 0, part
        assert box["x"] + box["width"] <= size["width"], part
    return page.evaluate("document.documentElement.scrollWidth") <= size["width"]
