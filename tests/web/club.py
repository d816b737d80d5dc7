"""A club with everything that can be looked at: two groups, teams of which one is deleted, submissions with reports."""

from __future__ import annotations

import hashlib
import json
from dataclasses import dataclass
from datetime import timedelta
from functools import cache
from typing import TYPE_CHECKING, Any

from rcj_challenges.web.config import SiteConfig, current_site
from tests.web.conftest import NOW, make_team

if TYPE_CHECKING:
    from django.test import Client

REPLAY = "replay-Y-1.html"
SIDES = ("blue", "yellow")
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
        practice: a match of each of these teams against itself.
        rated: a match of own and foreign.
        event: that is frozen, of both.
        codes: of their cards.
    """

    clients: dict[str, Client]
    teams: dict[str, Any]
    submissions: dict[str, Any]
    practice: dict[str, Any]
    rated: Any
    event: Any
    codes: dict[str, str]


def report_of(text: str) -> dict[str, Any]:
    """Return a report whose every text is the same."""
    finding = {"code": "sources.syntax", "level": "error", "message": text, "help": text, "where": text,
               "repair": True, "details": text}  # fmt: skip
    robot = {"robot": "Y1", "output": text}
    return {
        "level": "error", "cause": text, "team": text, "file": text,
        "stages": [{"name": "sources", "about": text, "level": "error", "skipped": "", "findings": [finding]}],
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
            "level": "error", "report": report_of(text), **fields,
        }
    )  # fmt: skip
    folder = report_folder(config.folder, made)
    folder.mkdir(parents=True)
    for name in ("report.html", REPLAY):
        (folder / name).write_text(f"<!doctype html><p>page of {team.name}</p>", encoding="utf-8")
    return made


def make_match(config: SiteConfig, blue: Any, yellow: Any, kind: str = "rated", number: int = 1) -> Any:
    """Store a match that was played on the basis of the season, with a record in which all robots printed something."""
    from rcj_challenges.web.blobs import record_folder
    from rcj_challenges.web.models import Basis, Match, Season

    basis = Basis.objects.first()
    if basis is None:
        Season.objects.update(begun_at=NOW)
        basis = Basis.objects.create(season=Season.objects.get(), scenario="s", versions={"v": "1"}, made_at=NOW)
    made = Match.objects.create(
        basis=basis, kind=kind, number=number, blue=blue, yellow=yellow, seed=1, made_at=NOW, played_at=NOW,
        blue_goals=2, yellow_goals=1, digest="e" * 64,
        faults=[{"robot": f"{side[0].upper()}1", "team": side, "half": 1, "tick": 3, "kind": "crash"} for side in SIDES],
    )  # fmt: skip
    folder = record_folder(config.folder, made)
    (folder / "logs").mkdir(parents=True)
    halves = [{"half": 1, "sides": {side: side for side in SIDES}, "faults": []}]
    teams = [{"name": side, "title": side, "logo": f"data:{side}"} for side in SIDES]
    facts = json.dumps({"halves": halves, "events": [], "teams": teams, "title": "Match", "about": [["", "Match"]]})
    (folder / "replay.html").write_text(f'<script id="facts">{facts}</script>', encoding="utf-8")
    (folder / "result.json").write_text(json.dumps({"halves": halves}), encoding="utf-8")
    entrants = {side: {"robots": {f"{side[0].upper()}1": None}} for side in SIDES}
    (folder / "scenario.json").write_text(json.dumps({"entrants": entrants}), encoding="utf-8")
    for side, one in (("blue", blue), ("yellow", yellow)):
        (folder / "logs" / f"{side[0].upper()}1.log").write_text(f"Secret of {one.team_id}", encoding="utf-8")
    return made


def make_club(config: SiteConfig) -> Club:
    """Make it on the site that this process works on."""
    from rcj_challenges.web import deadlines, events, jobs
    from rcj_challenges.web.models import Account, Entry, Event, Group, Role

    made = {name: make_team(f"Secret {name}", "School 2" if name == "foreign" else "School 1") for name in _TEAMS}
    teams = {name: team for name, (team, _) in made.items()}
    codes = {name: code for name, (_, code) in made.items()}
    submissions = {name: make_submission(config, team) for name, team in teams.items()}
    practice = {
        name: make_match(config, one, one, "practice", number) for number, (name, one) in enumerate(submissions.items())
    }
    playing = [
        make_submission(config, teams[name], state="accepted", level="passed", digest=64 * name[0], report=None)
        for name in ("own", "foreign")
    ]
    for one in playing:
        Entry.objects.create(team=one.team, season=one.season, active=one)
    rated = make_match(config, *playing)
    event = Event.objects.create(
        season=playing[0].season, title="Cup", deadline=NOW, address="http://club/", finalists=2
    )
    with jobs.writing():
        deadlines.close(NOW + timedelta(seconds=1))
    events.freeze(event, NOW + timedelta(hours=1))
    published = events.event_folder(event) / events.DATA / "site"
    published.mkdir(parents=True)
    (published / "index.html").write_text("Cup", encoding="utf-8")
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
    return Club(clients, teams, submissions, practice, rated, event, codes)


_TEAMS = ("own", "foreign", "deleted")
