"""What tests of pages in a browser share."""

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

from rcj_challenges.views.drawing.field import Picture
from rcj_challenges.views.drawing.paper import Paper
from tests.views.browser_stage import WIDE, Stage
from tests.views.live_play import MadeUpMatch


@pytest.fixture(scope="session")
def browser_stage(browser: Any) -> Stage:
    """The tabs of the browser."""
    return Stage(browser)


@pytest.fixture
def without_drawing(monkeypatch: pytest.MonkeyPatch) -> None:
    """For tests of what a rule sheet says: its drawing takes ten times as long as all the rest."""
    empty = Picture(Paper((0.0, 0.0, 1.0, 1.0), 1.0), "", [])
    monkeypatch.setattr("rcj_challenges.views.sheet.page.picture_of", lambda *_: empty)


@pytest.fixture
def watch(browser_stage: Stage, request: pytest.FixtureRequest) -> Iterator[Callable[..., Any]]:
    """Opens pages by their address; afterwards none of them may have asked anybody else, or complained."""
    failed_before = request.session.testsfailed
    browser_stage.complaints.clear()
    yield browser_stage.open
    browser_stage.clear(close=request.session.testsfailed > failed_before)
    assert browser_stage.complaints == []


@pytest.fixture
def show(browser_stage: Stage, watch: Callable[..., Any]) -> Callable[..., Any]:
    """Opens the replay page of a record's folder, anew if it is asked for in a way of its own.

    Else it is as it was when it was loaded, but a test before may have looked at it.
    """

    def open_replay(
        folder: Path, fragment: str = "#h1t0", *, anew: bool = False, viewport: dict[str, int] = WIDE, **options: Any
    ) -> Any:
        address = (folder / "replay.html").as_uri()
        if anew or options or viewport != WIDE:
            return watch(address + fragment, viewport=viewport, **options)
        half, tick = fragment.removeprefix("#h").split("t")
        return browser_stage.look_at(address, int(half), int(tick))

    return open_replay


@pytest.fixture
def made_up_match(tmp_path: Path) -> Iterator[Callable[..., MadeUpMatch]]:
    """Makes live matches; afterwards they are stopped wherever they are."""
    played: list[MadeUpMatch] = []

    def make(**options: Any) -> MadeUpMatch:
        played.append(MadeUpMatch(tmp_path, **options))
        return played[-1]

    yield make
    for one in played:
        one.close()
