"""The stage in real browsers, served by a real process: one moment for all."""

from __future__ import annotations

import shutil
import threading
import time
import urllib.request
from collections.abc import Iterator
from datetime import timedelta
from itertools import pairwise
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest
from django.utils import timezone

from rcj_challenges.core.timing import TICK_S
from rcj_challenges.views.replay import write_replay
from rcj_challenges.web import stage
from rcj_challenges.web.blobs import record_folder
from rcj_challenges.web.models import Show, Team
from tests.made_up_runs import write_made_up_run
from tests.web.club import Club, make_club
from tests.web.conftest import Served, make_folder, use_site
from tests.web.test_browser import barriers
from tests.web.test_stage import happenings
from tests.web.visitors import Visitor, Visitors

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Frame, Page

READY_MS = 60_000
TICKS = 1000


@pytest.fixture(scope="module")
def club(tmp_path_factory: pytest.TempPathFactory, migrated: Path) -> Iterator[tuple[Served, Club]]:
    """A served club whose rated match has the replay of a match without physics; this process works on it, too."""
    config = make_folder(tmp_path_factory.mktemp("stage") / "club")
    shutil.copy(migrated, config.folder / "site.sqlite3")
    served = Served(config, "--no-dispatch")
    replay = write_replay(write_made_up_run(tmp_path_factory.mktemp("run") / "run", ticks=TICKS))
    with use_site(config):
        made = make_club(config)
        Team.objects.filter(pk=made.teams["own"].pk).update(
            is_name_public=True, name="A name that is as long as a name can be"
        )
        shutil.copy(replay, record_folder(config.folder, made.rated))
        yield served, made
    served.stop()


def put(club: Club, monkeypatch: pytest.MonkeyPatch, in_s: float) -> Show:
    """Put the match on the stage, alone, in so many seconds."""
    monkeypatch.setattr(stage, "LEAD", timedelta(seconds=in_s))
    stage.take_off(Show.objects.all())
    show = stage.schedule(club.rated, timezone.now(), timezone.now(), is_chosen=True)
    assert show is not None
    return show


def shown(page: Page) -> Frame:
    """Return the frame with the match, once it is shown."""
    page.wait_for_selector("#stage iframe", state="visible", timeout=READY_MS)
    frame = next(one for one in page.frames if "/page" in one.url)
    frame.wait_for_selector("body.ready", timeout=READY_MS)
    return frame


def raw_bytes(address: str, received: list[tuple[float, bytes]]) -> None:
    with urllib.request.urlopen(address, timeout=30) as answer:  # noqa: S310 - our own server
        while body := answer.read1(65536):
            received.append((time.time(), body))


@pytest.mark.nightly
def test_all_windows_show_the_same_moment_and_no_byte_comes_before_it(
    club: tuple[Served, Club], browser: Browser, monkeypatch: pytest.MonkeyPatch
) -> None:
    served, made = club
    show = put(made, monkeypatch, 4.0)
    received: list[tuple[float, bytes]] = []
    address = f"{served.address}/live/{show.pk}/feed?from=0"
    reader = threading.Thread(target=raw_bytes, args=(address, received), daemon=True)
    reader.start()
    early, late = Visitor(browser, served.address), Visitor(browser, served.address)
    early.page.goto("/live")
    assert early.page.locator("#left").is_visible()
    first = shown(early.page)
    time.sleep(3.0)
    late.page.goto("/live")
    second = shown(late.page)
    time.sleep(1.5)
    begins_s = show.begins_at.timestamp()
    places = []
    for _ in range(20):
        places.append((first.evaluate("replay.place"), second.evaluate("replay.place"), time.time() - begins_s))
        time.sleep(0.2)
    for one, other, since_s in places:
        assert abs(one - other) * TICK_S < 1.0
        assert max(one, other) * TICK_S <= since_s
        assert min(one, other) * TICK_S > since_s - 6.0
    moves = [after[0] - before[0] for before, after in pairwise(places)]
    assert min(moves) >= 0
    assert sum(move > 0 for move in moves) > len(moves) * 0.8  # not in jumps
    stage.take_off(Show.objects.all())
    reader.join(10)
    happens = iter(list(happenings(b"".join(body for _, body in received))))
    end, happens_s, total = 0, 0.0, 0
    for at_s, body in received:
        total += len(body)
        while end <= total and (found := next(happens, None)):
            end, happens_s = found
            assert end > total or happens_s <= at_s - begins_s
    assert [one for one in early.complaints + late.complaints if "autofocusing" not in one] == []
    early.context.close()
    late.context.close()


@pytest.mark.nightly
@pytest.mark.parametrize("theme", ["light", "dark"])
@pytest.mark.parametrize("width", [360, 1280])
def test_stage_without_barriers(
    club: tuple[Served, Club], browser: Browser, monkeypatch: pytest.MonkeyPatch, width: int, theme: Any
) -> None:
    served, made = club
    visitors = Visitors(browser, served.address)
    put(made, monkeypatch, 30.0)
    stage.schedule(made.rated, timezone.now(), timezone.now(), is_chosen=True)
    page = visitors.come({"width": width, "height": 740}, theme).page
    session = made.clients["organizer"].cookies["session"].value
    for address in ("/live", "/live?stage=1", "/desk/stage"):
        page.context.add_cookies([{"name": "session", "value": session, "url": served.address}])
        page.goto(address)
        assert page.evaluate("document.documentElement.scrollWidth - innerWidth") <= 0
        assert barriers(page) == [], address
    put(made, monkeypatch, 1.0)
    page.goto("/live")
    shown(page)
    assert barriers(page) == []
    visitors.close()


def test_page_without_scripts_says_what_is_on(
    club: tuple[Served, Club], browser: Browser, monkeypatch: pytest.MonkeyPatch
) -> None:
    served, made = club
    put(made, monkeypatch, 0.0)
    one = Visitor(browser, served.address, java_script_enabled=False)
    one.page.goto("/live")
    text = one.page.inner_text("#stage")
    assert "On now" in text
    assert "A name that is as long" in text
    assert not one.page.locator("#stage iframe").is_visible()
    assert one.page.locator("noscript meta[http-equiv=refresh]").count() == 1
    one.context.close()


def test_page_for_obs_is_the_picture_alone(
    club: tuple[Served, Club], browser: Browser, monkeypatch: pytest.MonkeyPatch
) -> None:
    served, made = club
    put(made, monkeypatch, 0.0)
    camera = Visitor(browser, served.address, viewport={"width": 1920, "height": 1080})
    camera.page.goto("/live?stage=1")
    frame = shown(camera.page)
    assert camera.page.locator("#stage iframe").bounding_box() == {"x": 0, "y": 0, "width": 1920, "height": 1080}
    assert [one.is_visible() for one in frame.locator("button, input, select").all()].count(True) == 0
    assert frame.locator("#clock").is_visible()
    assert not camera.page.locator(".top").is_visible()
    camera.context.close()
