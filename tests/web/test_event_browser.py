"""An event in a real browser, from its form to the certificates."""

from __future__ import annotations

import io
import re
import shutil
import time
import zipfile
from collections.abc import Iterator
from datetime import timedelta
from itertools import cycle, islice
from pathlib import Path
from typing import TYPE_CHECKING

import pytest
from django.utils import timezone

from rcj_challenges.web import events
from rcj_challenges.web.demo import match_samples, zipped
from rcj_challenges.web.models import Event, Job, JobState, Season, State, Submission, Team
from tests.web.conftest import Served, make_folder, make_team, use_site
from tests.web.handing_in import hand_in, wait_for
from tests.web.test_browser import barriers, make_account
from tests.web.test_event_matches import tiny
from tests.web.test_events import check
from tests.web.visitors import PHONE, WIDE, Visitors

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Page

_FORM_TIME = "%Y-%m-%dT%H:%M"


@pytest.fixture
def served(tmp_path: Path, migrated: Path) -> Iterator[Served]:
    """A site with very short matches, which plays."""
    config = make_folder(tmp_path / "club", lanes=3, time_zone="Europe/Berlin")
    shutil.copy(migrated, config.folder / "site.sqlite3")
    with use_site(config):
        Season.objects.create(title="Spring", overrides=["match.half_s=1"])
    made = Served(config)
    yield made
    made.stop()


def variation(sample: Path, number: int) -> bytes:
    """Return a sample team that is not the same as the others."""
    made = io.BytesIO(zipped(sample))
    with zipfile.ZipFile(made, "a") as archive:
        archive.writestr("rcj_soccer_team_blue/variation.py", f"NUMBER = {number}\n")
    return made.getvalue()


def make_teams(served: Served, archives: list[bytes], *, is_checked: bool) -> None:
    """Hand archives in, an hour ago."""
    with use_site(served.config):
        now = timezone.now()
        if not is_checked:
            for number, archive in enumerate(archives):
                check(hand_in(served.config, make_team(f"Team {number}")[0], archive, now))
            Job.objects.update(state=JobState.DONE)
            Submission.objects.update(state=State.ACCEPTED)  # the site may have begun to check some
        else:
            codes = [make_team(f"Team {number}")[1] for number in range(len(archives))]
            receipts = [served.submit(code, one)[1] for code, one in zip(codes, archives, strict=True)]
            states = [
                wait_for(served, code, one["id"], 600)["state"] for code, one in zip(codes, receipts, strict=True)
            ]
            assert set(states) == {"accepted"}
        Team.objects.update(is_name_public=True)
        Submission.objects.update(begun_at=now - timedelta(hours=1))


def make_event(page: Page, served: Served, **fields: str) -> None:
    """Fill the form of a new event, let its deadline have been five minutes ago, and wait until it is frozen."""
    page.goto("/desk")
    page.get_by_role("link", name="New event").click()
    assert barriers(page) == []
    with use_site(served.config):
        deadline = timezone.localtime(timezone.now() + timedelta(minutes=5)).strftime(_FORM_TIME)
    for name, value in {"title": "Spring cup", "deadline": deadline, **fields}.items():
        page.fill(f"#id_{name}", value)
    page.get_by_role("button", name="Make the event").click()
    page.wait_for_url(re.compile(r"/desk/events/\d+"))
    with use_site(served.config):
        Event.objects.update(deadline=timezone.now() - timedelta(minutes=5))
    wait_until(page, "programs were frozen")
    assert barriers(page) == []


def wait_until(page: Page, text: str, timeout_s: float = 600.0) -> None:
    """Load a page again until it has a text."""
    until = time.monotonic() + timeout_s
    while text not in page.inner_text("main"):
        assert time.monotonic() < until, page.inner_text("main")
        time.sleep(0.5)
        page.reload()


def chief(served: Served, visitors: Visitors) -> Page:
    """Return the browser of the first organizer."""
    assert served.process.stdout is not None
    page = visitors.come(WIDE).page
    make_account(page, served.process.stdout.readline().rsplit(": ", 1)[1].strip(), "chief")
    return page


def begin_premiere(served: Served, ago: timedelta) -> None:
    """Let the premiere of the event have begun in the minute of some time ago."""
    with use_site(served.config):
        event, now = Event.objects.get(), timezone.now()
        event.premiere = now - ago
        event.publish_at = now
        event.save()


@pytest.mark.nightly
@pytest.mark.timeout(900)
def test_event_has_a_premiere_and_then_results_and_certificates(served: Served, browser: Browser) -> None:
    visitors = Visitors(browser, served.address)
    page, spectator = chief(served, visitors), visitors.come(PHONE, "dark")
    make_teams(served, [tiny(0), tiny(1)], is_checked=False)
    with use_site(served.config):
        Season.objects.update(overrides=["match.half_s=40"])
    tomorrow = (timezone.now() + timedelta(days=1)).strftime(_FORM_TIME)
    make_event(page, served, finalists="0", premiere=tomorrow)
    page.get_by_role("button", name="Play").click()
    wait_until(page, "All is played")
    assert barriers(page) == []
    spectator.page.goto("/events")
    spectator.look().get_by_role("link", name="Spring cup").click()
    assert barriers(spectator.look()) == []
    spectator.page.get_by_role("link", name="Results").click()
    assert "Nothing is played yet." in spectator.look().inner_text("main")
    coming = spectator.page.locator("main a[href*='premiere/']").first
    coming.click()
    spectator.page.wait_for_selector("#countdown")
    site = served.config.folder / "events" / "1" / "tournament_data" / "site"
    begin_premiere(served, timedelta(0))
    until = time.monotonic() + 300
    while not (recordings := list((site / "premiere").glob("*.js"))):
        assert time.monotonic() < until
        time.sleep(0.5)
    spectator.page.goto(f"/events/1/premiere/{recordings[0].stem}.html")
    spectator.page.wait_for_selector("body.ready", timeout=60_000)
    begin_premiere(served, timedelta(hours=1))
    certificates = f"{served.address}/events/1/certificates/groups.html"
    while spectator.page.request.get(certificates).status != 200:
        assert time.monotonic() < until
        time.sleep(1.0)
    spectator.page.goto(certificates)
    assert spectator.look().locator(".certificate").count() == 2
    spectator.page.goto("/events/1/")
    spectator.look().locator("main a[href*='matches/']").first.click()
    spectator.page.get_by_role("link", name="replay").first.click()
    spectator.page.wait_for_selector("body.ready")
    assert [one for one in visitors.leave() if "404" not in one] == []  # the page looked for its recording
    visitors.close()


@pytest.mark.nightly
@pytest.mark.timeout(3000)
def test_event_of_twelve_variations_of_sample_teams_runs_from_the_freeze_to_the_certificates(
    served: Served, browser: Browser
) -> None:
    visitors = Visitors(browser, served.address)
    page = chief(served, visitors)
    samples = [match_samples()[name] for name in ("ball_chaser", "roles_and_radio", "all_sensors")]
    make_teams(
        served, [variation(one, number) for number, one in enumerate(islice(cycle(samples), 12))], is_checked=True
    )
    make_event(page, served, groups="4", finalists="1")
    assert "12 programs were frozen" in page.inner_text("main")
    page.get_by_role("button", name="Play").click()
    wait_until(page, "All is played", 2000)
    page.select_option("#match", page.locator("#match option[value^='finals/final']").first.get_attribute("value"))
    page.select_option("#kind", "corrected")
    page.fill("#score", "5:0")
    page.fill("#reason", "two goals were not counted")
    page.get_by_role("button", name="Decide").click()
    wait_until(page, "two goals were not counted")
    page.goto("/events")
    page.get_by_role("link", name="Spring cup").click()
    page.get_by_role("link", name="Results").click()
    wait_until(page, "5 : 0")
    page.get_by_role("link", name="Finals").first.click()
    page.get_by_role("link", name="Certificates").first.click()
    assert page.locator(".certificate").count() == 4
    page.emulate_media(media="print")
    page.screenshot(path=served.config.folder / "certificates.png")
    with use_site(served.config):
        folder = events.event_folder(Event.objects.get())
    assert len({path.read_bytes() for path in (folder / "frozen").iterdir()}) == 12
    assert visitors.leave() == []
    visitors.close()
