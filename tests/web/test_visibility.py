"""Each address shows what it may to those who may see it, and to others not even that there is something.

The table is compared with the routes: a new route needs a line in it.
"""

from __future__ import annotations

from typing import Any

import pytest
from django.urls import URLPattern, URLResolver, get_resolver, reverse

from rcj_challenges.web.config import SiteConfig
from tests.web.club import REPLAY, ROLES, Club, make_club, new_client

ALL, NONE = set(ROLES), set[str]()
TEAMS, MENTORS, ORGANIZER = {"team", "other team"}, {"mentor", "other mentor", "organizer"}, {"organizer"}
READERS, MANAGERS, OWNER = {"team", "mentor", "organizer"}, {"mentor", "organizer"}, {"team"}

TABLE: dict[str, tuple[str, str, set[str]]] = {
    # name: method, kind of object in the address, roles that may open it for an object of team and mentor
    "home": ("GET", "", ALL),
    "style": ("GET", "", ALL),
    "enter": ("GET", "", ALL),
    "login": ("GET", "", ALL),
    "invited": ("GET", "code", NONE),
    "privacy": ("GET", "", ALL),
    "help": ("GET", "", ALL),
    "healthz": ("GET", "", ALL),
    "ladder": ("GET", "", ALL),
    "season": ("GET", "season", ALL),
    "ladder_team": ("GET", "team", ALL),
    "match": ("GET", "practice", READERS),
    "match_replay": ("GET", "practice", READERS),
    "match_log": ("GET", "practice", READERS),
    "match_again": ("POST", "practice", READERS),
    "events": ("GET", "", ALL),
    "event": ("GET", "event", ALL),
    "event_site": ("GET", "event", ALL),
    "event_file": ("GET", "event", ALL),
    "calendar": ("GET", "", ALL),
    "feed": ("GET", "", ALL),
    "rule": ("POST", "event", ORGANIZER),
    "event_hashes": ("GET", "event", ALL),
    "new_event": ("GET", "", ORGANIZER),
    "desk_event": ("GET", "event", ORGANIZER),
    "change_event": ("POST", "event", ORGANIZER),
    "void_match": ("POST", "match", ORGANIZER),
    "live": ("GET", "", ALL),
    "live_page": ("GET", "show", ALL),
    "desk_stage": ("GET", "", ORGANIZER),
    "put_on_stage": ("POST", "match", ORGANIZER),
    "take_off_stage": ("POST", "show", ORGANIZER),
    "my": ("GET", "", TEAMS),
    "upload": ("POST", "", TEAMS),
    "submission": ("GET", "submission", READERS),
    "submission_state": ("GET", "submission", READERS),
    "report": ("GET", "submission", READERS),
    "archive": ("GET", "submission", READERS),
    "replay": ("GET", "submission", READERS),
    "repair": ("POST", "submission", OWNER),
    "activate": ("POST", "submission", OWNER),
    "practice": ("GET", "", TEAMS),
    "new_practice": ("POST", "", TEAMS),
    "allow_practice": ("POST", "", TEAMS),
    "group": ("GET", "", MENTORS),
    "new_teams": ("POST", "", MENTORS),
    "team": ("GET", "team", MANAGERS),
    "new_card": ("POST", "team", MANAGERS),
    "delete_team": ("POST", "team", MANAGERS),
    "desk": ("GET", "", ORGANIZER),
    "job_again": ("POST", "job", ORGANIZER),
    "release_name": ("POST", "team", ORGANIZER),
    "change_season": ("POST", "", ORGANIZER),
    "new_invite": ("POST", "", ORGANIZER),
    "export": ("GET", "", ORGANIZER),
    "leave": ("POST", "", ALL),
}
INTERFACE = {"api-root", "openapi-json", "hand_in", "look_up", "me", "season_results"}
MIRRORED = {"team": "other team", "mentor": "other mentor"}
"""Roles as seen from an object of the foreign team."""


def routes() -> list[tuple[str, str]]:
    """Return namespace and name of all routes."""

    def walk(patterns: list[Any], space: str) -> list[tuple[str, str]]:
        found = []
        for one in patterns:
            if isinstance(one, URLResolver):
                found += walk(one.url_patterns, one.namespace or space)
            elif isinstance(one, URLPattern):
                found.append((space, one.name or str(one.pattern)))
        return found

    return walk(get_resolver("rcj_challenges.web.urls").url_patterns, "")


@pytest.fixture
def club(site: SiteConfig) -> Club:
    """Return a club on the site of this process."""
    return make_club(site)


def test_every_route_has_a_line_in_the_table_and_every_line_a_route(site: SiteConfig):
    named = routes()
    assert {name for space, name in named if not space} == {*TABLE, "admin/login/"}
    assert {name for space, name in named if space not in {"", "admin"}} == INTERFACE


def answered(club: Club, role: str, name: str, owner: str) -> tuple[bool, Any]:
    """Return whether an address lets a role pass, and the answer."""
    method, kind, _ = TABLE[name]
    one = {"submission": club.submissions, "team": club.teams, "practice": club.practice}.get(kind)
    others = {"match": club.rated, "event": club.event}
    pk = one[owner].pk if one is not None else others[kind].pk if kind in others else 1
    arguments = {"code": {"code": "AAAA"}, "": {}}.get(kind, {"pk": pk})
    if name == "replay":
        arguments["name"] = REPLAY
    if name == "event_file":
        arguments["path"] = "index.html"
    if name == "match_log":
        arguments["robot"] = "B1"
    client = club.clients[role]
    answer = client.generic(method, reverse(name, kwargs=arguments))
    sent_away = answer.status_code == 302 and answer["Location"] in {"/enter", "/login"}
    is_denied = sent_away or answer.status_code in {401, 403, 404, 405}
    return not is_denied, answer


@pytest.mark.parametrize("name", TABLE)
def test_route_opens_for_the_roles_of_the_table_only(club: Club, name: str):
    from rcj_challenges.web.blobs import record_folder, stage_folder
    from rcj_challenges.web.config import current_site
    from rcj_challenges.web.models import Job, Show
    from tests.web.conftest import NOW

    Job.objects.create(pk=1, kind="check", key="k", not_before=NOW, created_at=NOW)
    Show.objects.create(pk=1, match=club.rated, begins_at=NOW, ends_at=NOW, is_chosen=True, goals=[])
    (record_folder(current_site().folder, club.rated) / "replay.html").unlink()
    shown = stage_folder(current_site().folder) / "1"
    shown.mkdir(parents=True)
    (shown / "page.html").write_text("<!doctype html>", encoding="utf-8")
    kind, roles = TABLE[name][1:]
    owners = ("own", "foreign", "deleted") if kind in {"team", "submission", "practice"} else ("own",)
    for owner in owners:
        is_mirrored = owner == "foreign" and roles != ALL
        seen_as = {MIRRORED.get(role, role) for role in roles} if is_mirrored else roles
        expected = NONE if owner == "deleted" else seen_as
        opened = set()
        for role in ROLES if name != "leave" else ("anonymous",):
            passes, answer = answered(club, role, name, owner)
            body = b"".join(answer) if answer.streaming else answer.content
            answer.close()
            if passes:
                opened.add(role)
            elif kind:
                assert b"Secret" not in body, (role, owner)
                assert club.submissions[owner].sha256.encode() not in body, (role, owner)
        assert opened == (expected if name != "leave" else {"anonymous"}), owner


def test_rated_match_is_for_all_and_what_programs_printed_for_their_own_team_only(club: Club):
    match = club.rated
    readers = {"blue": READERS, "yellow": {"other team", "other mentor", "organizer"}}
    for role, client in club.clients.items():
        page = client.get(f"/matches/{match.pk}")
        replay = client.get(f"/matches/{match.pk}/replay")
        assert (page.status_code, replay.status_code) == (200, 200)
        assert b"Secret" not in page.content
        assert b"data:blue" not in replay.content  # the name and the logo are not released
        assert "sandbox allow-scripts" in replay["Content-Security-Policy"]
        for side, robot in (("blue", "B1"), ("yellow", "Y1")):
            answer = client.get(f"/matches/{match.pk}/log/{robot}")
            assert answer.status_code == (200 if role in readers[side] else 404)
            assert (f"/log/{robot}".encode() in page.content) == (role in readers[side])


def test_other_lists_show_no_team_of_another_group_and_no_name_that_is_not_released(club: Club):
    team = f"/teams/{club.teams['own'].pk}"
    for address in ("/", "/ladder", team, f"/matches/{club.practice['own'].pk}"):
        pages = {role: client.get(address).content for role, client in club.clients.items()}
        assert [role for role, body in pages.items() if b"Secret" in body] == []
    assert b"Secret foreign" not in club.clients["mentor"].get("/group").content
    assert b"Secret foreign" in club.clients["organizer"].get("/group").content
    assert b"Secret deleted" not in club.clients["organizer"].get("/group").content


def test_lists_of_organizers_open_for_organizers_only_and_delete_nothing(club: Club):
    names = [name for space, name in routes() if space == "admin" and name not in {"login", "logout"}]
    assert len(names) > 20
    opened: dict[str, set[str]] = {}
    for name in names:
        for arguments in ([], [1], [1, 1], ["web"]):
            try:
                address = reverse(f"admin:{name}", args=arguments)
            except Exception:  # noqa: BLE001, S112 - takes other arguments
                continue
            for role in ("anonymous", "mentor", "organizer"):
                status = club.clients[role].get(address).status_code
                assert status != 500, address
                if status == 200:
                    opened.setdefault(role, set()).add(name)
            break
    # The catalogue of the calendar's words is in every copy of the library.
    assert {role: found for role, found in opened.items() if role != "organizer" and found != {"jsi18n"}} == {}
    assert {"web_match_changelist", "web_submission_changelist", "web_submission_change", "web_season_add"} <= opened[
        "organizer"
    ]
    assert [name for name in opened["organizer"] if name.endswith("_delete")] == []
    assert [name for name in opened["organizer"] if name.startswith("web_submission") and "add" in name] == []


def test_code_of_a_card_opens_the_submissions_of_its_team_only(club: Club):
    for owner in ("own", "foreign"):
        for target in ("own", "foreign", "deleted"):
            card = {"Authorization": f"Bearer {club.codes[owner]}"}
            answer = new_client().get(f"/api/v1/submissions/{club.submissions[target].pk}", headers=card)
            assert answer.status_code == (200 if owner == target else 404)
    for code in ("", "AAAA-AAAA-AAAA", club.codes["deleted"]):
        for path in (f"submissions/{club.submissions['own'].pk}", "me"):
            assert new_client().get(f"/api/v1/{path}", headers={"Authorization": f"Bearer {code}"}).status_code == 401
    assert club.clients["team"].get("/api/v1/me").status_code == 401  # a session is no card
