"""The interface for programs: ``rcj-challenge submit`` and whatever a school writes for itself."""

from __future__ import annotations

import base64
import json
from datetime import datetime
from typing import Any

from django.http import HttpRequest
from django.utils import timezone
from ninja import NinjaAPI, Schema, Status
from ninja.security import HttpBearer

from rcj_challenges.web import seasons
from rcj_challenges.web.accounts import team_of_code
from rcj_challenges.web.codes import NO_FILE, NO_LADDER
from rcj_challenges.web.ladder.published import Results
from rcj_challenges.web.models import Entry, Season, Submission, Team
from rcj_challenges.web.receiving import RefusedError, ensure_may_upload, receive
from rcj_challenges.web.tables import standings_of
from rcj_challenges.web.views.team import begun, progress_of


class Receipt(Schema):
    """What a team gets for an upload."""

    id: int
    number: int
    sha256: str
    begun_at: datetime
    received_at: datetime
    is_late: bool
    address: str


class SubmissionState(Receipt):
    """Where a submission stands, with the report of its check."""

    state: str
    stage: str
    place: int
    estimate_s: int | None
    is_active: bool
    report: dict[str, Any] | None


class Me(Schema):
    """What a code opens."""

    team: str
    season: str | None
    closes_at: datetime | None


class Problem(Schema):
    """Why something is refused."""

    code: str
    message: str


class _Card(HttpBearer):
    def authenticate(self, request: HttpRequest, token: str) -> Team | None:
        """Return the team of a code."""
        return team_of_code(token[:60], timezone.now())


api = NinjaAPI(title="RCJ Challenges", version="1", auth=_Card(), docs_url=None, openapi_url="openapi.json")


def _receipt(found: Submission) -> dict[str, Any]:
    return {
        "id": found.pk,
        "number": found.number,
        "sha256": found.sha256,
        "begun_at": found.begun_at,
        "received_at": found.received_at,
        "is_late": found.is_late,
        "address": f"/my/submissions/{found.pk}",
    }


_REFUSALS = dict.fromkeys((400, 409, 429, 503, 507), Problem)


@api.post("submissions", response={201: Receipt, **_REFUSALS})
def hand_in(request: HttpRequest) -> Status[dict[str, Any]]:
    """Hand in the archive that is the body. `Content-Digest: sha-256=:…:` is compared, if sent."""
    team: Team = request.auth  # type: ignore[attr-defined]  # set by the library
    given = getattr(request, "scope", {}).get("rcj.upload")
    if given is None:
        return Status(400, {"code": NO_FILE, "message": "send the ZIP as the body"})
    path, sha256, size = given
    wanted = request.headers.get("Content-Digest", "")
    digest = base64.b64encode(bytes.fromhex(sha256)).decode()
    if wanted and wanted != f"sha-256=:{digest}:":
        return Status(
            400, {"code": "damaged", "message": "the bytes that came are not those of Content-Digest; send it again"}
        )
    begun_at = begun(request)
    try:
        season = ensure_may_upload(team, seasons.current(), begun_at)
        new = Submission(
            team=team, season=season, sha256=sha256, size_bytes=size, begun_at=begun_at, received_at=timezone.now(),
            via="api",
        )  # fmt: skip
        return Status(201, _receipt(receive(path, new)))
    except RefusedError as refused:
        return Status(refused.status, {"code": refused.code, "message": str(refused)})


@api.get("submissions/{pk}", response={200: SubmissionState, 404: Problem})
def look_up(request: HttpRequest, pk: int) -> Status[dict[str, Any]]:
    """Return where a submission of the team stands."""
    team: Team = request.auth  # type: ignore[attr-defined]  # set by the library
    found = Submission.objects.filter(pk=pk, team=team, is_deleted=False).select_related("season").first()
    if found is None:
        return Status(404, {"code": "unknown-submission", "message": "this team has no submission with this number"})
    is_active = Entry.objects.filter(active=found).exists()
    return Status(200, {**_receipt(found), **progress_of(found), "is_active": is_active, "report": found.report})


@api.get("seasons/{pk}/results", auth=None, response={200: Results, 404: Problem})
def season_results(request: HttpRequest, pk: int) -> Status[Results | dict[str, str]]:  # noqa: ARG001 - the name is the library's
    """Return all that the table of a season follows from, and the table."""
    basis = seasons.shown_basis(Season.objects.filter(pk=pk).first())
    if basis is None:
        return Status(404, {"code": NO_LADDER, "message": "there is no season with this number that has begun"})
    return Status(200, standings_of(basis).published)


@api.get("me", response=Me)
def me(request: HttpRequest) -> dict[str, Any]:
    """Return the team of the code, and what it can hand in for."""
    team: Team = request.auth  # type: ignore[attr-defined]  # set by the library
    season = seasons.current()
    return {
        "team": team.name,
        "season": season.title if season else None,
        "closes_at": season.closes_at if season else None,
    }


def openapi_text() -> str:
    """Return the description of the interface, as committed."""
    return json.dumps(api.get_openapi_schema(), indent=2, sort_keys=True) + "\n"
