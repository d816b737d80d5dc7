"""All pages: texts can be translated, times have their zone, nothing is large or from elsewhere."""

from __future__ import annotations

import re
from datetime import timedelta
from html.parser import HTMLParser
from typing import Any

import pytest

from rcj_challenges.web import receiving
from rcj_challenges.web.config import SiteConfig, current_site
from tests.web.club import Club, make_club, make_submission, new_client
from tests.web.conftest import NOW, use_site

MAX_BYTES = 100_000
STATES = ("queued", "checking", "accepted", "rejected", "unchecked", "superseded")


class _Texts(HTMLParser):
    """Collects what a reader sees or hears, and the addresses that are loaded."""

    def __init__(self) -> None:
        super().__init__()
        self.texts: list[str] = []
        self.addresses: list[str] = []
        self._code = 0

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self._code += tag in {"code", "bdi", "pre"}
        for name, value in attrs:
            if name in {"aria-label", "placeholder", "title", "alt"}:
                self.texts.append(value or "")
            if name in {"href", "src", "action"}:
                self.addresses.append(value or "")

    def handle_endtag(self, tag: str) -> None:
        self._code -= tag in {"code", "bdi", "pre"}

    def handle_data(self, data: str) -> None:
        if not self._code:
            self.texts.append(data)


def read(text: str) -> _Texts:
    parser = _Texts()
    parser.feed(text)
    return parser


@pytest.fixture
def club(folder: Any) -> Any:
    """Return a club in Berlin, where something happens on every page."""
    from django.contrib.auth import get_user_model

    from rcj_challenges.web.models import Audit, Job, Worker

    config = folder(time_zone="Europe/Berlin")
    with use_site(config):
        made = make_club(config)
        assert get_user_model().objects.count() == 3
        for state in STATES:
            make_submission(config, made.teams["own"], state=state, level="warning", is_late=True)
        for number, state in enumerate(("queued", "running", "stuck")):
            Job.objects.create(kind="check", key=str(number), state=state, team=made.teams["own"], not_before=NOW,
                               created_at=NOW, submission=made.submissions["own"])  # fmt: skip
        Worker.objects.create(name="0-1", seen_at=NOW, lanes=2)
        Audit.objects.create(at=NOW, actor="x", act="delete team", about="team 3")
        yield made


def pages(club: Club) -> dict[str, str]:
    """Return the text of every page, by role and address."""
    from rcj_challenges.web.models import Submission

    own = club.teams["own"].pk
    rated = f"/matches/{club.rated.pk}"
    mine = [f"/my/submissions/{one.pk}" for one in Submission.objects.filter(team=own)]
    addresses = {
        "anonymous": [
            "/",
            "/enter",
            "/login",
            "/help",
            "/privacy",
            "/nowhere",
            "/invite/x",
            "/ladder",
            f"/teams/{own}",
            rated,
        ],
        "team": ["/", "/my", "/my/practice", rated, f"/matches/{club.practice['own'].pk}", *mine],
        "mentor": ["/group", f"/group/teams/{own}", mine[0]],
        "organizer": ["/desk", "/group", rated],
    }
    found = {f"{role} {one}": club.clients[role].get(one) for role, some in addresses.items() for one in some}
    found["mentor cards"] = club.clients["mentor"].post("/group/teams/new", {"names": "0\n1"})
    found["organizer invite"] = club.clients["organizer"].post("/desk/invite", {"group": "9"})
    assert {answer.status_code for answer in found.values()} == {200, 404}
    return {name: answer.content.decode() for name, answer in found.items()}


def test_every_text_passes_through_the_translation(club: Club, monkeypatch: pytest.MonkeyPatch):
    from django.utils import translation

    monkeypatch.setattr(translation._trans, "gettext", lambda text: f"⟦{text}⟧", raising=False)
    shown = pages(club)
    assert sum(text.count("⟦") for text in shown.values()) > 300
    data = re.compile(
        r"⟦.*?⟧|half \d|SHA-256|XXXX-XXXX-XXXX|Test club|Traceback|\bUTC|CES?T|\b[kM]B\b|Secret \w+|School \d|Team \d|https?:\S*|[0-9A-Z]{4}(-[0-9A-Z]{4})+",
        re.DOTALL,
    )
    texts = {name: data.sub("", "\n".join(read(text).texts)) for name, text in shown.items()}
    left = {name: re.findall(r"[A-Za-z]{2,}[\w ]*", text) for name, text in texts.items()}
    assert {name: words for name, words in left.items() if words} == {}


def test_output_of_a_robot_names_the_match_in_which_it_played(club: Club):
    own = club.submissions["own"]
    robots = [[{"robot": f"{side}{number}", "output": "seen"} for number in (1, 2)] for side in "BY"]
    own.report = {**own.report, "matches": [{"robots": of_match} for of_match in robots]}
    own.save()
    text = club.clients["team"].get(f"/my/submissions/{own.pk}").content.decode()
    assert re.findall(r"<summary>[^<]*?([BY]\d)[^<]*?(\d)</summary>", text) == [
        ("B1", "1"),
        ("B2", "1"),
        ("Y1", "2"),
        ("Y2", "2"),
    ]


def test_every_refusal_of_an_upload_passes_through_the_translation(club: Club, monkeypatch: pytest.MonkeyPatch):
    from django.utils import translation

    from rcj_challenges.web import blobs
    from rcj_challenges.web.models import Season, Team
    from rcj_challenges.web.receiving import RefusedError, ensure_may_upload

    monkeypatch.setattr(translation._trans, "gettext", lambda text: f"⟦{text}⟧", raising=False)
    team, season = Team.objects.get(name="Secret own"), Season.objects.get()
    refused = []

    def refuse(season_or_none: Season | None) -> None:
        with pytest.raises(RefusedError) as caught:
            ensure_may_upload(team, season_or_none, NOW)
        refused.append((caught.value.code, str(caught.value)))

    refuse(None)
    season.opens_at = NOW + timedelta(days=1)
    refuse(season)
    season.opens_at = None
    for quota in ("uploads_per_hour", "uploads_per_day", "upload_bytes_per_day"):
        with monkeypatch.context() as changed:
            changed.setattr(receiving, "current_site", lambda quota=quota: current_site().model_copy(update={quota: 0}))
            refuse(season)
    monkeypatch.setattr(blobs.Blobs, "has_room", lambda _: False)
    refuse(season)
    assert [code for code, _ in refused] == ["no-season", "not-open", "too-often", "too-often", "too-much", "disk-full"]
    assert all(text.startswith("⟦") and text.endswith("⟧") for _, text in refused)


def test_every_time_has_the_zone_of_the_site(club: Club):
    shown = "\n".join(pages(club).values())
    for path in ("submission/", "job/", "audit/", f"submission/{club.submissions['own'].pk}/change/"):
        shown += club.clients["organizer"].get(f"/admin/web/{path}").content.decode()
    times = re.findall(r"\d\d:\d\d(?::\d\d)?.{0,5}|[ap]\.m\..{0,5}", shown)
    assert len(times) > 20
    assert [time for time in times if not re.fullmatch(r"\d\d:\d\d:\d\d CES?T.?", time)] == []


def test_pages_are_small_and_ask_this_host_only(club: Club):
    client = new_client()
    for name, text in pages(club).items():
        found = read(text)
        assert [one for one in found.addresses if not re.match(r"/(?!/)|#", one)] == [], name
        loaded = re.findall(r'(?:src|stylesheet" href)="([^"]+)"', text)
        with_parts = len(text.encode()) + sum(len(client.get(one).getvalue()) for one in loaded)
        assert with_parts < MAX_BYTES, name


def test_second_load_of_a_page_for_all_takes_no_bytes(club: Club):
    client = new_client()
    for address in ("/", "/help", "/privacy", "/style.css", "/static/upload.js"):
        first = client.get(address)
        first.close()
        tag = {name: first[name] for name in ("ETag", "Last-Modified") if first.has_header(name)}
        assert tag, address
        again = {"ETag": "If-None-Match", "Last-Modified": "If-Modified-Since"}
        assert client.get(address, headers={again[name]: value for name, value in tag.items()}).status_code == 304


def test_page_of_a_signed_in_team_is_not_kept_by_the_browser(club: Club):
    assert club.clients["team"].get("/my")["Cache-Control"] == "no-store"


def test_every_page_forbids_what_is_inline_or_from_elsewhere(club: Club):
    for role, address in (
        ("anonymous", "/"),
        ("anonymous", "/nowhere"),
        ("organizer", "/desk"),
        ("organizer", "/admin/web/team/"),
    ):
        answer = club.clients[role].get(address)
        parts = {part.split()[0]: part.split()[1:] for part in answer["Content-Security-Policy"].split(";") if part}
        assert parts["default-src"] == ["'none'"]
        assert parts["script-src"] == parts["style-src"] == ["'self'"]
        assert parts["frame-ancestors"] == ["'none'"]
        assert ("require-trusted-types-for" in parts) == (not address.startswith("/admin"))
        assert answer["X-Content-Type-Options"] == "nosniff"


def test_replay_has_an_origin_of_its_own(club: Club):
    pk = club.submissions["own"].pk
    for name in ("report", "replay-Y-1.html"):
        answer = club.clients["team"].get(f"/my/submissions/{pk}/{name}")
        assert "sandbox allow-scripts;" in answer["Content-Security-Policy"].replace("scripts ", "scripts;") + ";"
        answer.close()


def test_names_of_settings_are_those_of_the_library(site: SiteConfig):
    from django.conf import global_settings

    from rcj_challenges.web.settings import settings_for

    own = {"CONTENT_SECURITY_POLICY", "WHITENOISE_USE_FINDERS", "WHITENOISE_ALLOW_ALL_ORIGINS", "ROOT_URLCONF"}
    assert {name for name in settings_for(site, "x") if not hasattr(global_settings, name)} <= own
