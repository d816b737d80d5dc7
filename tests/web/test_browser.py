"""The ways of an organizer, a mentor and a team in a real browser, with a real check."""

from __future__ import annotations

import io
import re
import shutil
import time
import zipfile
from collections.abc import Iterator
from importlib.resources import files
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

from tests.checker.small_team import PLAYER
from tests.web.conftest import Served, make_folder, make_team, use_site
from tests.web.handing_in import small_team, wait_for
from tests.web.visitors import PHONE, Visitor, Visitors

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Page

PASSWORD = "correct horse 7"
CHECK_MS = 60_000
BROKEN = {"robot.py": PLAYER.replace("Robot()", "Robot(")}
MISNAMED = {"main.py": PLAYER}
AXE_OPTIONS = "{resultTypes: ['violations']}"


def archive(contents: dict[str, str]) -> dict[str, Any]:
    """Return a ZIP as a form takes it."""
    made = io.BytesIO()
    with zipfile.ZipFile(made, "w") as target:
        for name, text in contents.items():
            target.writestr(name, text)
    return {"name": "team.zip", "mimeType": "application/zip", "buffer": made.getvalue()}


LATE_CRASH = PLAYER.replace("pass", "assert robot.getTime() < 3, 'late'")
"""Plays the rehearsals to their end, and fails in the longer matches of the ladder."""


@pytest.fixture(scope="module")
def served(tmp_path_factory: pytest.TempPathFactory, migrated: Path) -> Iterator[Served]:
    """A site with short rehearsals, and the link for its first organizer."""
    from rcj_challenges.web.models import Season

    config = make_folder(tmp_path_factory.mktemp("browser") / "club")
    shutil.copy(migrated, config.folder / "site.sqlite3")
    with use_site(config):
        Season.objects.create(title="Spring", overrides=["match.half_s=2"], ladder_overrides=["match.half_s=4"])
    made = Served(config)
    yield made
    made.stop()


@pytest.fixture(scope="module")
def tabs(served: Served, browser: Browser) -> Iterator[Visitors]:
    """Visitors of the site, who come and leave."""
    made = Visitors(browser, served.address)
    yield made
    made.close()


@pytest.fixture
def visitors(tabs: Visitors, codes: dict[str, str]) -> Iterator[Visitors]:
    """Visitors of a site with cards; when they leave, they may not have complained."""
    yield tabs
    assert tabs.leave() == []


def barriers(page: Page) -> list[str]:
    """Return what axe-core finds wrong; nothing where it is not installed or the page may not run scripts."""
    if find_spec("axe_playwright_python") is None:
        return []
    page.evaluate(files("axe_playwright_python").joinpath("axe.min.js").read_text("utf-8"))
    found = page.evaluate(f"axe.run(document, {AXE_OPTIONS})")["violations"]
    return [f"{one['id']}: {node['html']}" for one in found for node in one["nodes"]]


def sign_in(page: Page, name: str) -> None:
    """Sign in with a password."""
    page.goto("/login")
    page.fill("#name", name)
    page.fill("#password", PASSWORD)
    page.get_by_role("button", name="Sign in").click()


def hand_in(page: Page, contents: dict[str, str]) -> None:
    """Hand an archive in, and wait for its report."""
    page.goto("/my")
    page.set_input_files("#archive", archive(contents))
    page.get_by_role("button", name="Hand in").click()
    page.wait_for_url("**/my/submissions/*")
    page.wait_for_selector(".state.accepted, .state.rejected, .state.unchecked", timeout=CHECK_MS)


@pytest.fixture(scope="module")
def codes(served: Served, tabs: Visitors) -> dict[str, str]:
    """Return the codes of cards, made as an organizer and a mentor make them."""
    assert served.process.stdout is not None
    first_link = served.process.stdout.readline().rsplit(": ", 1)[1].strip()
    organizer, mentor = tabs.come(), tabs.come(PHONE)
    make_account(organizer.page, first_link, "chief")
    assert organizer.page.url.endswith("/desk")
    organizer.look().fill("#group", "School 3")
    organizer.page.get_by_role("button", name="Invite a mentor").click()
    make_account(mentor.page, organizer.look().inner_text("main code"), "mentor")
    mentor.look().fill("#names", "Robo Rangers\nBlue Foxes\nA name that is as long as a name can be")
    mentor.page.get_by_role("button", name="Make teams and cards").click()
    cards = mentor.look().locator(".team-card")
    codes = dict(zip(cards.locator("h2").all_inner_texts(), cards.locator(".code").all_inner_texts(), strict=True))
    assert list(codes)[:2] == ["Robo Rangers", "Blue Foxes"]
    mentor.page.emulate_media(media="print")
    assert not mentor.page.locator(".top").is_visible()
    assert cards.locator(".qr svg").first.is_visible()
    assert tabs.leave() == []
    return codes


def make_account(page: Page, link: str, name: str) -> None:
    """Open an invitation and make the account."""
    page.goto(link)
    page.fill("#name", name)
    page.fill("#password", PASSWORD)
    page.get_by_role("button", name="Make the account").click()


@pytest.mark.nightly
@pytest.mark.parametrize("theme", ["light", "dark"])
@pytest.mark.parametrize("width", [360, 1280])
def test_page_without_barriers(visitors: Visitors, codes: dict[str, str], width: int, theme: str):
    screen = {"width": width, "height": 740}
    made = {name: visitors.come(screen, theme) for name in ("anonymous", "team", "mentor", "chief")}
    made["team"].page.goto(f"/enter#{codes['Robo Rangers']}")
    made["team"].page.press("#code", "Enter")
    made["team"].page.wait_for_url("**/my")
    hand_in(made["team"].page, BROKEN)
    submission = made["team"].page.url
    for name in ("mentor", "chief"):
        sign_in(made[name].page, name)
    addresses = {"anonymous": ["/", "/enter", "/login", "/help", "/privacy", "/ladder", "/teams/1"],
                 "team": ["/my", "/my/practice", submission],
                 "mentor": ["/group", submission], "chief": ["/desk", "/group"]}  # fmt: skip
    for name, some in addresses.items():
        for address in some:
            made[name].page.goto(address)
            assert barriers(made[name].look()) == [], address
    made["mentor"].page.goto("/group")
    made["mentor"].page.get_by_role("link", name="A name that").click()
    assert barriers(made["mentor"].look()) == []


def test_barriers_are_found(visitors: Visitors):
    page = visitors.come().page
    page.set_content("<html lang=en><title>x</title><main><h1>x</h1><input></main>")
    assert [one.split(":")[0] for one in barriers(page)] == ["label"] * (find_spec("axe_playwright_python") is not None)


def test_team_hands_in_reads_the_report_repairs_and_plays(visitors: Visitors, codes: dict[str, str]):
    team = visitors.come(PHONE)
    team.page.goto("/enter")
    team.page.fill("#code", codes["Robo Rangers"].lower())
    team.page.get_by_role("button", name="Enter").click()
    hand_in(team.page, BROKEN)
    assert team.look().locator(".finding.error code").inner_text().startswith("robot.py:2:")
    assert team.page.get_by_role("button", name="Repair it").count() == 0
    hand_in(team.page, MISNAMED)
    team.look().get_by_role("button", name="Repair it").click()
    team.page.locator("text=Repaired:").locator("a").click(timeout=CHECK_MS)
    team.page.wait_for_selector(".state.accepted", timeout=CHECK_MS)
    assert "Repaired from submission 2" in team.look().inner_text("main")
    assert barriers(team.page) == []
    assert team.page.locator(".mark", has_text="plays").is_visible()
    replay = team.page.get_by_role("link", name="Replay 1").get_attribute("href")
    team.page.goto(replay)
    team.page.wait_for_selector("body.ready", timeout=CHECK_MS)
    team.page.goto("/")
    assert "Robo Rangers" not in team.look().inner_text("main")  # no person has released the name


@pytest.mark.nightly
def test_team_hands_in_with_scripts_switched_off(served: Served, browser: Browser, codes: dict[str, str]):
    team = Visitor(browser, served.address, java_script_enabled=False)
    team.page.goto("/enter")
    team.page.fill("#code", codes["Blue Foxes"])
    team.page.get_by_role("button", name="Enter").click()
    hand_in(team.page, BROKEN)  # the page loads itself again
    assert team.page.locator(".finding.error code").inner_text().startswith("robot.py:2:")
    hand_in(team.page, MISNAMED)
    team.page.get_by_role("button", name="Repair it").click()
    team.page.locator("text=Repaired:").locator("a").click(timeout=CHECK_MS)
    team.page.wait_for_selector(".state.accepted", timeout=CHECK_MS)
    team.page.get_by_role("button", name="Sign out").click()
    team.page.goto("/my")
    assert team.page.url.endswith("/enter")
    team.context.close()
    assert team.complaints == []


def test_mentor_replaces_a_lost_card(visitors: Visitors, codes: dict[str, str]):
    mentor, team = visitors.come(), visitors.come()
    sign_in(mentor.page, "mentor")
    mentor.look().get_by_role("link", name="A name that").click()
    mentor.look().get_by_role("button", name="Replace the card").click()
    new = mentor.look().inner_text(".team-card .code")
    old = next(code for name, code in codes.items() if name.startswith("A name"))
    team.page.goto(f"/enter#{old}")
    team.page.press("#code", "Enter")  # a link alone signs nothing in
    team.page.wait_for_selector("[role=alert]")
    assert team.complaints == ["Failed to load resource: the server responded with a status of 403 (Forbidden)"]
    team.complaints.clear()
    team.look().fill("#code", new)
    team.page.get_by_role("button", name="Enter").click()
    assert team.page.url.endswith("/my")


def test_form_of_another_site_does_nothing(served: Served, visitors: Visitors, codes: dict[str, str]):
    team = visitors.come()
    team.page.goto(f"/enter#{codes['Robo Rangers']}")
    team.page.press("#code", "Enter")
    team.page.wait_for_url("**/my")
    form = f'<form method="post" action="{served.address}/leave"><button>x</button></form>'
    team.page.route("http://evil.example/", lambda route: route.fulfill(body=form, content_type="text/html"))
    team.page.goto("http://evil.example/")
    with team.page.expect_response("**/leave") as answer:
        team.page.click("button")
    assert answer.value.status == 403
    team.page.goto("/my")
    assert re.search("/my$", team.page.url)
    team.page.unroute("http://evil.example/")
    team.complaints.clear()


@pytest.fixture(scope="module")
def ladder(served: Served, tabs: Visitors, codes: dict[str, str]) -> None:
    """Three other teams, and the ladder begun by the organizer."""
    organizer = tabs.come()
    sign_in(organizer.page, "chief")
    for number in range(3):
        with use_site(served.config):
            _, code = make_team(f"Opponent {number}", "School 9")
        receipt = served.submit(code, small_team(f"# {number}\n{PLAYER}"))[1]
        assert wait_for(served, code, receipt["id"])["state"] == "accepted"
    organizer.page.goto("/desk")
    organizer.look().get_by_role("button", name="Begin the ladder").click()
    assert organizer.look().get_by_role("button", name="End the ladder").is_visible()
    assert tabs.leave() == []


@pytest.mark.nightly
@pytest.mark.parametrize("has_scripts", [True, False])
def test_team_comes_from_its_card_to_its_rank_and_to_the_moment_of_its_fault(
    served: Served, browser: Browser, codes: dict[str, str], ladder: None, has_scripts: bool
) -> None:
    name = "Robo Rangers" if has_scripts else "Blue Foxes"
    team = Visitor(browser, served.address, java_script_enabled=has_scripts, viewport=PHONE)
    page = team.page
    page.goto("/enter")
    page.fill("#code", codes[name])
    page.get_by_role("button", name="Enter").click()
    hand_in(page, {"robot.py": LATE_CRASH.replace("Robot()", "Robot(") + f"# {name}"})
    assert page.locator(".finding.error code").inner_text().startswith("robot.py:")
    hand_in(page, {"main.py": f"{LATE_CRASH}# {name}"})
    page.get_by_role("button", name="Repair it").click()
    page.locator("text=Repaired:").locator("a").click(timeout=CHECK_MS)
    page.wait_for_selector(".state.accepted", timeout=CHECK_MS)
    page.goto("/my")
    page.get_by_role("link", name="My programs in the ladder").click()
    own = page.url
    row = page.locator(".ranks tr", has=page.locator(f"a[href='{own.removeprefix(served.address)}']"))
    until = time.monotonic() + 20 * CHECK_MS / 1000
    while True:  # the placements
        page.goto("/ladder")
        if row.locator("td strong").count():
            break
        assert time.monotonic() < until
        time.sleep(1.0)
    assert re.fullmatch(r"\d+ \(\d+\u2013\d+\)|\d+", row.locator("td").first.inner_text())
    assert not has_scripts or barriers(team.look()) == []
    page.goto(own)
    page.locator("td a[href^='/matches/']").first.click()
    fault = page.locator("li", has_text="yours").first
    assert "crashed" in fault.inner_text()
    assert not has_scripts or barriers(team.look()) == []
    log = page.locator("a[href*='/log/']").first.get_attribute("href")
    if has_scripts:
        fault.get_by_role("link", name="half").click()
        page.wait_for_selector("body.ready", timeout=CHECK_MS)
        assert re.search(r"/replay#h[12]t9\d$", page.url)
        assert "late" in page.inner_text("body")
    assert log is not None
    assert "AssertionError: late" in page.request.get(log).text()
    team.context.close()
    assert team.complaints == []
