"""The browser that tests of pages share: it hears every complaint, and no test finds what another left."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from rcj_challenges.records.testing import write_made_up_run
from rcj_challenges.views.replay import write_replay
from tests.views.browser_stage import Stage, settled, shown_moment


@pytest.mark.parametrize(
    ("script", "complaint"),
    [
        ("console.error('no field')", "no field"),
        ("console.warn('no goal')", "no goal"),
        ("throw new Error('no ball')", "no ball"),
        ("new Image().src = 'other.png'", "asked for file:"),
        ("fetch('http://127.0.0.1:9/').catch(() => 0)", "asked for http://127.0.0.1:9/"),
    ],
)
def test_what_a_page_complains_of_or_asks_for_is_heard(
    script: str, complaint: str, watch: Callable[..., Any], browser_stage: Stage, tmp_path: Path
) -> None:
    page = tmp_path / "page.html"
    page.write_text(f"<!doctype html><link rel=icon href='data:,'><p>Here.</p><script>{script}</script>", "utf-8")
    watch(page.as_uri(), ready="p")
    browser_stage.clear()
    assert any(complaint in heard for heard in browser_stage.complaints)
    browser_stage.complaints.clear()


@pytest.mark.nightly
def test_a_replay_is_kept_as_it_was_loaded_or_loaded_anew(
    show: Callable[..., Any], browser_stage: Stage, tmp_path: Path
) -> None:
    folder = write_made_up_run(tmp_path, ticks=60, halves=1)
    write_replay(folder)
    page = show(folder, "#h1t30")
    page.evaluate("window.mark = true")
    page.keyboard.press("2")
    page.keyboard.press("z")
    page.click("#filters >> text=KICKOFF")
    page.click("#tab-robots")
    page.get_by_role("button", name="Trail of Y1").click()
    page.select_option("#speed", "16")
    page.click("#play")
    browser_stage.clear()

    kept = show(folder, "#h1t31")
    assert kept.evaluate("window.mark")
    assert shown_moment(kept) == [1, 31]
    assert kept.evaluate("[replay.app.player.playing, replay.app.player.speed]") == [False, 1]
    assert kept.evaluate("[replay.app.camera.mode, replay.app.frame.trails.length]") == ["overview", 0]
    assert kept.locator("#panel-events").is_visible()
    assert kept.locator("[aria-pressed=true]").all_inner_texts()[1:] == ["All3"]  # after the camera
    kept.click("#theme")  # of this nothing else is the way back
    settled(kept)
    browser_stage.clear()

    anew = show(folder)
    assert anew.evaluate("[window.mark ?? null, document.documentElement.dataset.theme ?? null]") == [None, None]
