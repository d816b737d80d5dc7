"""Texts of teams and of their programs are shown as texts: no script of theirs runs, also not on the pages of organizers."""

from __future__ import annotations

import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from itertools import product
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

from rcj_challenges.checker.report import FileReport, check_report
from rcj_challenges.checker.report_html import html_page
from tests.web.club import Club, make_club, make_submission, new_client
from tests.web.conftest import NOW, Served, make_folder, use_site

if TYPE_CHECKING:
    from playwright.sync_api import Browser, BrowserContext, Page

RUN = "window.ran=1"
_BEFORE = (
    "",
    "'>",
    '">',
    "</title>",
    "</textarea>",
    "</pre>",
    "--></script>",
    "]]>",
    "{{",
    "\u202e",
    "<!--",
    "\\",
    "`",
    "%22>",
)
_TAGS = (
    "<script>{}</script>", "<img src=x onerror={}>", "<svg onload={}>", "<svg><script>{}</script></svg>",
    "<a href=javascript:{}>x</a>", "<iframe srcdoc='<script>top.{}</script>'></iframe>", "<body onload={}>",
    "<details open ontoggle={}>", "<math><mi xlink:href=javascript:{}>", "<style>@import'javascript:{}'</style>",
    "<input autofocus onfocus={}>", "<meta http-equiv=refresh content='0;url=javascript:{}'>", "<base href=//evil.example>",
    "<link rel=stylesheet href=//evil.example/x.css>", "{{{{constructor.constructor('{}')()}}}}", "${{{}}}",
    "<object data=javascript:{}></object>", "<form action=javascript:{}><button>", "<x onclick={}>", "&lt;script&gt;{}",
)  # fmt: skip
_SPELLINGS = (str, str.upper, lambda text: text.replace(" ", "/"), lambda text: text.replace(" ", "\t"),
              lambda text: text.replace("<", "<\0", 1), lambda text: text.replace("=", " = "),
              lambda text: text.replace("script", "scr\nipt"), lambda text: text.replace("<", "\uff1c"),
              lambda text: text + text, lambda text: text.encode("utf-7").decode(), lambda text: f"<{text}",
              lambda text: text.replace("<", "&#60;"), lambda text: text.replace("<", "\\u003c"),
              lambda text: text.replace("'", '"'), lambda text: text.replace(">", ""))  # fmt: skip
ALL = [spell(before + tag.format(RUN)) for spell, before, tag in product(_SPELLINGS, _BEFORE, _TAGS)]
DAILY = ALL[: len(_BEFORE) * len(_TAGS) : 7]

# What a replay would do if it could; its page's title is what came of it.
PRYING = """<!doctype html><title>?</title><script>
const attempt = (act) => { try { return String(act()); } catch (error) { return error.name; } };
const found = [attempt(() => document.cookie), attempt(() => localStorage.length), attempt(() => parent.document.title), origin];
fetch("/my", {credentials: "include"}).then((answer) => answer.text(), (error) => error.name).then((text) => {
  document.title = [...found, text].join(" ");
});
</script>"""


def sign_in(context: BrowserContext, address: str, client: Any) -> None:
    """Sign a browser in as a client is."""
    context.clear_cookies()
    context.add_cookies([{"name": name, "value": one.value, "url": address} for name, one in client.cookies.items()])


@contextmanager
def watched(browser: Browser, address: str) -> Iterator[tuple[Page, list[str]]]:
    """Open a page, and a list of what scripts do in it."""
    context, done = browser.new_context(base_url=address), list[str]()
    context.expose_function("violated", lambda what: done.append(f"violation {what}"))
    context.add_init_script(
        "addEventListener('securitypolicyviolation', (event) => violated(event.violatedDirective + event.sample))"
    )
    context.on("request", lambda one: None if one.url.startswith(address) else done.append(one.url))
    context.on("dialog", lambda _: done.append("dialog"))
    yield context.new_page(), done
    context.close()


@pytest.fixture(scope="module")
def hostile_site(tmp_path_factory: pytest.TempPathFactory, migrated: Path) -> Any:
    """A served site with a club, on which this process works, too."""
    config = make_folder(tmp_path_factory.mktemp("hostile") / "club")
    shutil.copy(migrated, config.folder / "site.sqlite3")
    served = Served(config, "--no-dispatch")
    with use_site(config):
        yield served, make_club(config)
    served.stop()


def spread(served: Served, club: Club, texts: list[str]) -> list[tuple[str, str]]:
    """Put texts into every place that a team can write into; return roles and pages that show them."""
    from rcj_challenges.web.dispatcher import report_folder
    from rcj_challenges.web.models import Audit, Entry, Group, Job, Match, Submission, Team

    Entry.objects.all().delete()
    Job.objects.all().delete()
    Audit.objects.all().delete()
    Submission.objects.filter(number__gt=100).delete()
    Team.objects.filter(pk__gt=100).delete()
    own = club.teams["own"]
    Group.objects.filter(pk=own.group_id).update(label=texts[0][:60])
    shown = make_submission(served.config, own, "".join(texts[::2]), number=101)
    playing = make_submission(served.config, own, number=102, state="accepted", digest="a" * 64, report=None)
    Match.objects.filter(pk=club.rated.pk).update(void="".join(texts)[:200])
    stage = shown.report["stages"][0]
    stage["findings"] = [
        {**stage["findings"][0], **dict.fromkeys(("message", "help", "where", "details"), text)} for text in texts
    ]
    shown.save()
    for number, text in enumerate(texts):
        team = Team.objects.create(pk=101 + number, group=own.group, name=text[:40], is_name_public=number % 2 == 0)
        Entry.objects.create(team=team, season=shown.season, active=playing)
        Audit.objects.create(at=NOW, actor=text[:60], act="new card", about=text[:120], reason=text[:200])
        Job.objects.create(kind="check", key=text[:100] + str(number), state="stuck", team=team, error=text[:400],
                           not_before=NOW, created_at=NOW, progress=text[:40])  # fmt: skip
    files = [
        FileReport(file=text[:60], level="error", cause=text, team=text, digest="", repaired=[text], matches=[], wall_s=1,
                   stages=[{"name": "sources", "about": "x", "level": "error", "skipped": "",
                            "findings": [finding]}])
        for text, finding in zip(texts, stage["findings"], strict=True)
    ]  # fmt: skip
    folder = report_folder(served.config.folder, shown)
    page = html_page(check_report("match", texts[0], "strict", files, []), folder)
    (folder / "report.html").write_text(page, encoding="utf-8")
    return [
        ("anonymous", "/"), ("anonymous", "/ladder"), ("anonymous", "/teams/101"),
        ("anonymous", f"/matches/{club.rated.pk}"), ("organizer", "/admin/web/match/"), ("team", f"/my/submissions/{shown.pk}"), ("team", f"/my/submissions/{shown.pk}/report"),
        ("mentor", "/group"), ("mentor", "/group/teams/101"), ("organizer", "/desk"), ("organizer", "/group"),
        ("organizer", "/admin/web/team/"), ("organizer", "/admin/web/job/"), ("organizer", "/admin/web/audit/"),
        ("organizer", f"/admin/web/submission/{shown.pk}/change/"), ("organizer", "/admin/web/team/101/change/"),
    ]  # fmt: skip


@pytest.mark.parametrize("texts", [DAILY, pytest.param(ALL, marks=pytest.mark.nightly)], ids=["daily", "all"])
def test_no_script_in_a_text_runs(browser: Browser, hostile_site: Any, texts: list[str]):
    served, club = hostile_site
    with watched(browser, served.address) as (page, done):
        for start in range(0, len(texts), 100):
            for role, address in spread(served, club, texts[start : start + 100]):
                sign_in(page.context, served.address, club.clients[role])
                answer = page.goto(address)
                assert answer is not None
                assert answer.status == 200, address
                assert page.evaluate("window.ran") is None, address
                assert (page.url, done) == (served.address + address, []), address


def test_replay_reads_no_cookie_no_storage_and_no_page_of_the_team(browser: Browser, hostile_site: Any):
    from rcj_challenges.web.dispatcher import report_folder

    served, club = hostile_site
    own = club.submissions["own"]
    (report_folder(served.config.folder, own) / "replay-Y-1.html").write_text(PRYING, encoding="utf-8")
    client = new_client()
    assert client.post("/enter", {"code": club.codes["own"]}).status_code == 302
    with watched(browser, served.address) as (page, _):
        sign_in(page.context, served.address, client)
        page.goto(f"/my/submissions/{own.pk}/replay-Y-1.html")
        page.wait_for_function("document.title !== '?'")
        assert page.title() == "SecurityError SecurityError ? null TypeError"
