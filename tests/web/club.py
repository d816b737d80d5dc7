"""A club with everything that can be looked at: two groups, teams of which one is deleted, submissions with reports."""

from __future__ import annotations

import hashlib
from dataclasses import dataclass
from functools import cache
from typing import TYPE_CHECKING, Any

from rcj_challenges.web.config import SiteConfig, current_site
from tests.web.conftest import NOW, make_team

if TYPE_CHECKING:
    from django.test import Client

REPLAY = "replay-Y-1.html"
ROLES = ("anonymous", "team", "other team", "mentor", "other mentor", "organizer")


def new_client(*, enforce_csrf_checks: bool = False, **options: Any) -> Client:
    """Return a client of the site that this process works on."""
    from django.test import Client

    made = Client(SERVER_NAME="localhost", **options)
    made.handler = _handler(current_site().https, enforce_csrf_checks=enforce_csrf_checks)
    return made


@cache
def _handler(is_https: bool, *, enforce_csrf_checks: bool) -> Any:
    """Return what answers all clients: to make one lists all static files. It reads only this setting when it is made."""
    from django.test.client import ClientHandler

    made = ClientHandler(enforce_csrf_checks=enforce_csrf_checks)
    made.load_middleware()
    return made


@dataclass
class Club:
    """The site, and clients that are signed in.

    Attributes:
        clients: by role.
        teams: ``own`` belongs to the team and the mentor, ``foreign`` to the others, ``deleted`` was the mentor's.
        submissions: of these teams: rejected, with a report and a replay.
        codes: of their cards.
    """

    clients: dict[str, Client]
    teams: dict[str, Any]
    submissions: dict[str, Any]
    codes: dict[str, str]


def report_of(text: str) -> dict[str, Any]:
    """Return a report whose every text is the same."""
    finding = {"code": "sources.syntax", "level": "failure", "message": text, "help": text, "where": text,
               "repair": True, "details": text}  # fmt: skip
    robot = {"robot": "Y1", "output": text}
    return {
        "level": "failure", "cause": text, "team": text, "file": text,
        "stages": [{"name": "sources", "about": text, "level": "failure", "skipped": "", "findings": [finding]}],
        "matches": [{"robots": [robot]}],
    }  # fmt: skip


def make_submission(config: SiteConfig, team: Any, text: str = "Traceback", **fields: Any) -> Any:
    """Store a rejected submission of a team, with report, replay and archive."""
    from rcj_challenges.web.blobs import Blobs
    from rcj_challenges.web.dispatcher import report_folder
    from rcj_challenges.web.models import Season, State, Submission

    data = f"archive of {team.pk}".encode()
    sha256 = hashlib.sha256(data).hexdigest()
    received = Blobs(config.folder).incoming / sha256
    received.write_bytes(data)
    Blobs(config.folder).keep(received, sha256)
    made = Submission.objects.create(
        **{
            "team": team, "season": Season.objects.get(), "sha256": sha256, "size_bytes": len(data), "via": "page",
            "number": Submission.objects.count() + 1, "begun_at": NOW, "received_at": NOW, "state": State.REJECTED,
            "level": "failure", "report": report_of(text), **fields,
        }
    )  # fmt: skip
    folder = report_folder(config.folder, made)
    folder.mkdir(parents=True)
    for name in ("report.html", REPLAY):
        (folder / name).write_text(f"<!doctype html><p>page of {team.name}</p>", encoding="utf-8")
    return made


def make_club(config: SiteConfig) -> Club:
    """Make it on the site that this process works on."""
    from rcj_challenges.web.models import Account, Group, Role

    made = {name: make_team(f"Secret {name}", "School 2" if name == "foreign" else "School 1") for name in _TEAMS}
    teams = {name: team for name, (team, _) in made.items()}
    codes = {name: code for name, (_, code) in made.items()}
    submissions = {name: make_submission(config, team) for name, team in teams.items()}
    clients = {role: new_client() for role in ROLES}
    for role, owner in (("team", "own"), ("other team", "foreign")):
        assert clients[role].post("/enter", {"code": codes[owner]}).status_code == 302
    groups = {"mentor": "School 1", "other mentor": "School 2", "organizer": None}
    for role, label in groups.items():
        group = Group.objects.get(label=label) if label else None
        kind = Role.MENTOR if label else Role.ORGANIZER
        clients[role].force_login(Account.objects.create(name=role, role=kind, group=group, password="!"))  # noqa: S106
    gone = {"confirm": "Secret deleted", "reason": "1"}
    assert clients["mentor"].post(f"/group/teams/{teams['deleted'].pk}/delete", gone).status_code == 302
    return Club(clients, teams, submissions, codes)


_TEAMS = ("own", "foreign", "deleted")
