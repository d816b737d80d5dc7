"""The ladder of a season: what it is played with, its seeds, and its matches from the queue to the result."""

from __future__ import annotations

import secrets
import shutil
from collections import defaultdict
from collections.abc import Iterable, Mapping
from contextlib import suppress
from datetime import datetime
from typing import TYPE_CHECKING, Any

from django.db.models import Max, Q, QuerySet
from django.utils.translation import gettext

from rcj_challenges.records.result import deciding, versions
from rcj_challenges.tournament.seeds import seed_hash
from rcj_challenges.web import jobs
from rcj_challenges.web.blobs import Blobs, match_folder, record_folder
from rcj_challenges.web.codes import NOT_FOR_TWO
from rcj_challenges.web.config import current_site
from rcj_challenges.web.demo import match_samples, zipped
from rcj_challenges.web.errors import SiteError
from rcj_challenges.web.ladder import published
from rcj_challenges.web.models import Basis, Group, Job, Match, MatchKind, Season, Show, State, Submission, Team

if TYPE_CHECKING:
    from rcj_challenges.scenario.models.robots import Entrant

_SECRET_BYTES = 32
_RECORDS_OF_A_TEAM = 20
_RECORD_S = 3600.0
"""How long at least a record is kept, so that one that was made again can be seen, in s."""
_SAMPLES = "Sample programs"
_DELETED = "a team was deleted"
SIDES = ("blue", "yellow")


def own_versions() -> dict[str, str]:
    """The versions that decide the bits of results on this computer."""
    return deciding(versions().model_dump())


def current() -> Season | None:
    """The season that is on, whether its ladder is played or not."""
    return Season.objects.filter(is_current=True).first()


def running() -> Season | None:
    """The season whose ladder is played at this time."""
    return Season.objects.filter(is_current=True, begun_at__isnull=False, ended_at=None).first()


def current_basis(season: Season | None) -> Basis | None:
    """The basis of new matches of a season; None: its ladder has not begun."""
    return Basis.objects.filter(season=season).select_related("season").first()


def shown_basis(season: Season | None) -> Basis | None:
    """Return the basis whose matches make the table."""
    return Basis.objects.filter(season=season, is_whole=True).select_related("season").first()


def programs_of(season: Season) -> dict[str, str | None]:
    """All programs that were accepted in a season, each with the one its team handed in before it."""
    found: dict[str, str | None] = {}
    last: dict[int, str] = {}
    accepted = Submission.objects.filter(season=season, state=State.ACCEPTED).order_by("pk")
    for team, digest in accepted.values_list("team", "digest"):
        found.setdefault(digest, last.get(team))
        last[team] = digest
    return found


def playing_now(season: Season) -> dict[str, list[Submission]]:
    """The submissions that play now, by the digest of their programs."""
    found: dict[str, list[Submission]] = defaultdict(list)
    active = Submission.objects.filter(entry__season=season, team__deleted_at=None).order_by("team")
    for one in active.select_related("team__group").defer("report"):
        found[one.digest].append(one)
    return dict(found)


def begin(season: Season, now: datetime) -> None:
    """Begin the ladder of a season: what it is played with is pinned, and the hash of its secret shown.

    Raises:
        RcjError: its scenario cannot be played, or is not for two teams.
    """
    from rcj_challenges.submissions.team import TeamError, open_team  # noqa: PLC0415 - loads the code of programs

    scenario, entrants = _kept_scenario(season)
    secret = secrets.token_hex(_SECRET_BYTES)
    pinned = {"begun_at": now, "secret": secret, "secret_hash": seed_hash(secret)}
    with jobs.writing():
        if Season.objects.filter(pk=season.pk, begun_at=None).update(**pinned):
            Basis.objects.create(season=season, scenario=scenario, versions=own_versions(), made_at=now)
            group, _ = Group.objects.get_or_create(label=_SAMPLES)
            for folder in match_samples(season.scenario).values():
                with suppress(TeamError):
                    opened = open_team(folder, *entrants)
                    team, _ = group.team_set.get_or_create(name=opened.name, defaults={"is_name_public": True})
                    sha256, size_bytes = Blobs(current_site().folder).keep_bytes(zipped(folder))
                    Submission.objects.create(
                        team=team, season=season, number=1, sha256=sha256, size_bytes=size_bytes, begun_at=now,
                        received_at=now, via="sample", state=State.ACCEPTED, digest=opened.digest,
                    )  # fmt: skip


def end(season: Season, now: datetime) -> None:
    """End the ladder of a season: nothing more is played, and its secret is shown."""
    with jobs.writing():
        if Season.objects.filter(pk=season.pk, begun_at__isnull=False, ended_at=None).update(ended_at=now):
            # A match whose result is being stored is waited for: it has been played.
            list(Job.objects.select_for_update(of=("self",)).filter(match__basis__season=season).values_list("pk"))
            Match.objects.filter(basis__season=season, played_at=None).delete()


def rebase(season: Season, now: datetime) -> None:
    """Play all rated matches of a season again with what this computer has; the table stays until they are done.

    Raises:
        RcjError: its scenario cannot be played any more.
    """
    scenario, _ = _kept_scenario(season)
    with jobs.writing():
        before = Basis.objects.select_for_update().filter(season=season, season__ended_at=None).first()
        if before is None:
            return
        rated = Match.objects.filter(basis=before, kind=MatchKind.RATED).select_related("blue", "yellow")
        matches = list(rated.defer("blue__report", "yellow__report").order_by("number"))
        Match.objects.filter(basis=before, played_at=None, void="").delete()
        Basis.objects.filter(season=season, is_whole=False).delete()
        basis = Basis.objects.create(
            season=season, scenario=scenario, versions=own_versions(), is_whole=False, made_at=now
        )
        Match.objects.bulk_create(
            Match(
                basis=basis, number=one.number, blue=one.blue, yellow=one.yellow, seed=one.seed, made_at=now,
                void=one.void or (_DELETED if one.blue.is_deleted or one.yellow.is_deleted else ""),
            )
            for one in matches
        )  # fmt: skip


def _kept_scenario(season: Season) -> tuple[str, list[Entrant]]:
    """Keep the scenario of a season where matches find it; return its hash and its entrants."""
    from rcj_challenges.scenario.load import load  # noqa: PLC0415 - a process that serves pages loads none else
    from rcj_challenges.web.playing import MatchPlace  # noqa: PLC0415

    loaded = load(season.scenario, [*season.overrides, *season.ladder_overrides])
    if sorted(loaded.scenario.entrants) != sorted(SIDES):
        message = gettext("{scenario} is not played by two teams against each other").format(scenario=season.scenario)
        raise SiteError(message, gettext("choose another scenario for this season"), code=NOT_FOR_TWO)
    return MatchPlace(current_site().folder).keep_scenario(loaded), list(loaded.scenario.entrants.values())


def seed_of(secret: str, kind: str, number: int) -> int:
    """Return the seed of a match."""
    return published.seed_of(secret, str(number) if kind == MatchKind.RATED else f"{kind}/{number}")


def add_matches(
    basis: Basis, kind: MatchKind, pairs: Iterable[tuple[Submission, Submission]], now: datetime
) -> list[Match]:
    """Add matches with the next numbers; called inside `jobs.writing`."""
    same_kind = Match.objects.filter(basis__season=basis.season_id, kind=kind)
    last = same_kind.aggregate(last=Max("number"))["last"] or 0
    return [
        Match.objects.create(
            basis=basis, kind=kind, number=number, blue=blue, yellow=yellow, made_at=now,
            seed=seed_of(basis.season.secret, kind, number),
        )
        for number, (blue, yellow) in enumerate(pairs, last + 1)
    ]  # fmt: skip


def open_rated(basis: Basis | None) -> QuerySet[Match]:
    """Return the rated matches of a basis that are still to be played."""
    return Match.objects.filter(basis=basis, kind=MatchKind.RATED, played_at=None, void="")


def with_sides(found: Any, match: str = "") -> Any:
    """Load the teams of matches with them; ``match`` leads from what was found to its match."""
    sides = [f"{match}{side}" for side in SIDES]
    teams = [f"{side}__team" for side in sides]
    return found.select_related(f"{match}basis__season", *teams).defer(*(f"{side}__report" for side in sides))


def store_result(match: Match, answer: Mapping[str, Any], now: datetime) -> None:
    """Store the result of a match, unless it has one; called inside `jobs.writing`."""
    result = answer["result"]
    blue, yellow = (result["score"][side] for side in SIDES)
    faults = [{key: fault[key] for key in ("robot", "team", "half", "tick", "kind")} for fault in result["faults"]]
    Match.objects.filter(pk=match.pk, played_at=None).update(
        played_at=now, blue_goals=blue, yellow_goals=yellow, digest=result["digest"], faults=faults,
        is_doubtful=answer["is_doubtful"],
    )  # fmt: skip


def fitting_bases(versions_here: Mapping[str, str]) -> list[int]:
    """Return the bases whose matches a computer with these versions can play."""
    return [basis.pk for basis in Basis.objects.all() if basis.versions == versions_here]


def void(matches: QuerySet[Match], reason: str) -> None:
    """Let matches not count, and play those no more that are in the queue; called inside `jobs.writing`."""
    jobs.cancel(Job.objects.filter(match__in=matches))
    matches.update(void=reason)


def drop_records(now: datetime) -> None:
    """Remove records but the last of each team; a match whose record is gone can be played again bit for bit."""
    site = current_site().folder
    kept: set[str] = set()
    for team in Team.objects.filter(deleted_at=None):
        theirs = Match.objects.filter(Q(blue__team=team) | Q(yellow__team=team), played_at__isnull=False)
        kept |= {str(pk) for pk in theirs.order_by("-played_at").values_list("pk", flat=True)[:_RECORDS_OF_A_TEAM]}
    for record in (match_folder(site) / "records").glob("*"):
        if record.name not in kept and record.stat().st_mtime < now.timestamp() - _RECORD_S:
            shutil.rmtree(record, ignore_errors=True)


def forget(team: Team) -> None:
    """Remove what matches show of a team that is deleted; those played still count. Called inside `jobs.writing`."""
    from rcj_challenges.web import stage  # noqa: PLC0415 - which builds on this

    theirs = Match.objects.filter(Q(blue__team=team) | Q(yellow__team=team))
    void(theirs.filter(played_at=None), _DELETED)
    stage.take_off(Show.objects.filter(match__in=theirs))
    for match in theirs:
        shutil.rmtree(record_folder(current_site().folder, match), ignore_errors=True)
