"""The ways of an organizer, a mentor and a team in a real browser, with a real check."""

from __future__ import annotations

import io
import re
import shutil
import zipfile
from collections.abc import Iterator
from importlib.resources import files
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

from tests.checker.small_team import PLAYER
from tests.web.conftest import Served, make_folder, use_site

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Page

PASSWORD = "correct horse 7"
CHECK_MS = 60_000
PHONE = {"width": 360, "height": 740}
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


@pytest.fixture(scope="module")
def served(tmp_path_factory: pytest.TempPathFactory, migrated: Path) -> Iterator[Served]:
    """A site with short rehearsals, and the link for its first organizer."""
    from rcj_challenges.web.models import Season

    config = make_folder(tmp_path_factory.mktemp("browser") / "club")
    shutil.copy(migrated, config.folder / "site.sqlite3")
    with use_site(config):
        Season.objects.create(title="Spring", overrides=["match.half_s=2"])
    made = Served(config)
    yield made
    made.stop()


class Visitor:
    """Somebody with a browser of their own, whose every complaint is kept."""

    def __init__(self, browser: Browser, address: str, **options: Any) -> None:
        self.context = browser.new_context(base_url=address, **options)
        self.page: Page = self.context.new_page()
        self.complaints: list[str] = []
        self.page.on("pageerror", lambda error: self.complaints.append(str(error)))
        self.page.on("dialog", lambda dialog: self.complaints.append(f"dialog {dialog.message}"))
        self.page.on("console", lambda said: self.complaints.append(said.text) if said.type == "error" else None)
        self.page.on("request", lambda one: None if one.url.startswith(address) else self.complaints.append(one.url))

    def look(self) -> Page:
        """Return the page that is open; it must not be wider than the screen."""
        assert self.page.evaluate("document.documentElement.scrollWidth - innerWidth") <= 0, self.page.url
        return self.page

    def leave(self) -> None:
        """Close it; it may not have complained."""
        self.context.close()
        assert self.complaints == []


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
def codes(served: Served, browser: Browser) -> dict[str, str]:
    """Return the codes of cards, made as an organizer and a mentor make them."""
    assert served.process.stdout is not None
    first_link = served.process.stdout.readline().rsplit(": ", 1)[1].strip()
    organizer, mentor = Visitor(browser, served.address), Visitor(browser, served.address, viewport=PHONE)
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
    organizer.leave()
    mentor.leave()
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
def test_page_without_barriers(served: Served, browser: Browser, codes: dict[str, str], width: int, theme: Any):
    made = {name: Visitor(browser, served.address, viewport={"width": width, "height": 740}, color_scheme=theme)
            for name in ("anonymous", "team", "mentor", "chief")}  # fmt: skip
    made["team"].page.goto(f"/enter#{codes['Robo Rangers']}")
    made["team"].page.press("#code", "Enter")
    made["team"].page.wait_for_url("**/my")
    hand_in(made["team"].page, BROKEN)
    submission = made["team"].page.url
    for name in ("mentor", "chief"):
        sign_in(made[name].page, name)
    addresses = {"anonymous": ["/", "/enter", "/login", "/help", "/privacy"], "team": ["/my", submission],
                 "mentor": ["/group", submission], "chief": ["/desk", "/group"]}  # fmt: skip
    for name, some in addresses.items():
        for address in some:
            made[name].page.goto(address)
            assert barriers(made[name].look()) == [], address
    made["mentor"].page.goto("/group")
    made["mentor"].page.get_by_role("link", name="A name that").click()
    assert barriers(made["mentor"].look()) == []
    for visitor in made.values():
        visitor.leave()


def test_barriers_are_found(browser: Browser):
    page = browser.new_page()
    page.set_content("<html lang=en><title>x</title><main><h1>x</h1><input></main>")
    assert [one.split(":")[0] for one in barriers(page)] == ["label"] * (find_spec("axe_playwright_python") is not None)
    page.close()


def test_team_hands_in_reads_the_report_repairs_and_plays(served: Served, browser: Browser, codes: dict[str, str]):
    team = Visitor(browser, served.address, viewport=PHONE)
    team.page.goto("/enter")
    team.page.fill("#code", codes["Robo Rangers"].lower())
    team.page.get_by_role("button", name="Enter").click()
    hand_in(team.page, BROKEN)
    assert team.look().locator(".finding.failure code").inner_text().startswith("robot.py:2:")
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
    team.leave()


@pytest.mark.nightly
def test_team_hands_in_with_scripts_switched_off(served: Served, browser: Browser, codes: dict[str, str]):
    team = Visitor(browser, served.address, java_script_enabled=False)
    team.page.goto("/enter")
    team.page.fill("#code", codes["Blue Foxes"])
    team.page.get_by_role("button", name="Enter").click()
    hand_in(team.page, BROKEN)  # the page loads itself again
    assert team.page.locator(".finding.failure code").inner_text().startswith("robot.py:2:")
    hand_in(team.page, MISNAMED)
    team.page.get_by_role("button", name="Repair it").click()
    team.page.locator("text=Repaired:").locator("a").click(timeout=CHECK_MS)
    team.page.wait_for_selector(".state.accepted", timeout=CHECK_MS)
    team.page.get_by_role("button", name="Sign out").click()
    team.page.goto("/my")
    assert team.page.url.endswith("/enter")
    team.leave()


def test_mentor_replaces_a_lost_card(served: Served, browser: Browser, codes: dict[str, str]):
    mentor, team = Visitor(browser, served.address), Visitor(browser, served.address)
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
    mentor.leave()
    team.leave()


def test_form_of_another_site_does_nothing(served: Served, browser: Browser, codes: dict[str, str]):
    team = Visitor(browser, served.address)
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
    team.complaints.clear()  # that of the refusal may come later than the answer
    team.leave()
