"""The ladder as it is shown and published: anyone can recompute the table."""

from __future__ import annotations

import json
import random
import subprocess
from datetime import timedelta
from pathlib import Path
from typing import Any

import pytest
from django.utils import timezone

from rcj_challenges.web import jobs, seasons, tables
from rcj_challenges.web.blobs import match_folder, record_folder
from rcj_challenges.web.config import SiteConfig
from rcj_challenges.web.ladder.published import Results, fit_of, table_of
from rcj_challenges.web.models import Basis, Entry, Job, JobState, Match, MatchKind, Season, State, Submission
from tests.web.club import make_match, new_client
from tests.web.conftest import COMMAND, NOW, make_team


def handed_in(index: int, digest: str = "") -> Submission:
    """Store an accepted submission of a new team, which plays."""
    team, _ = make_team(f"Team {index}")
    made = Submission.objects.create(
        team=team, season=Season.objects.get(), number=1, sha256=f"{index:064}", size_bytes=1, begun_at=NOW,
        received_at=NOW, via="page", state=State.ACCEPTED, digest=digest or f"{index:02}" * 32,
    )  # fmt: skip
    Entry.objects.create(team=team, season=made.season, active=made)
    return made


def played(programs: list[Submission], matches: int, seed: int = 1) -> None:
    """Begin a season and store results: the earlier programs are the stronger ones."""
    season = Season.objects.get()
    seasons.begin(season, NOW)
    season.refresh_from_db()
    basis = seasons.current_basis(season)
    assert basis is not None
    chance = random.Random(seed)  # noqa: S311 - no secret
    with jobs.writing():
        for match in seasons.add_matches(
            basis, MatchKind.RATED, [chance.sample(programs, 2) for _ in range(matches)], NOW
        ):
            lead = match.yellow_id - match.blue_id + chance.randrange(-6, 7)
            Match.objects.filter(pk=match.pk).update(
                played_at=NOW, blue_goals=max(lead, 0), yellow_goals=max(-lead, 0), digest=f"{match.pk:064}"
            )


@pytest.fixture
def ladder(site: SiteConfig) -> list[Submission]:
    """Return the programs of a season with many results."""
    make_team("First")
    programs = [handed_in(index) for index in range(8)]
    played(programs, 160)
    return programs


def results() -> dict[str, Any]:
    answer = new_client().get("/api/v1/seasons/1/results")
    assert answer.status_code == 200
    return dict(json.loads(answer.content))


def rate(tmp_path: Path, changed: dict[str, Any], *options: str) -> tuple[int, str]:
    file = tmp_path / "results.json"
    file.write_text(json.dumps(changed), encoding="utf-8")
    ran = subprocess.run([*COMMAND, "site", "rate", str(file), *options], capture_output=True, text=True, check=False)
    return ran.returncode, ran.stderr.partition("]")[0] + "]" if ran.returncode else ran.stdout


def test_table_shows_ranks_and_their_intervals_and_follows_from_what_is_published(
    ladder: list[Submission], tmp_path: Path
) -> None:
    published = Results.model_validate(results())
    assert published.table == table_of(published, fit_of(published))
    assert [row.rank for row in published.table] == list(range(1, 9))
    page = new_client().get("/ladder").content.decode()
    for row, one in zip(published.table, ladder, strict=True):
        assert (row.digest, row.games) == (one.digest, sum(row.digest in (m.blue, m.yellow) for m in published.matches))
        assert f"<strong>{row.rank}</strong>" in page
        assert row.low == row.high or f"({row.low}\u2013{row.high})" in page
    assert rate(tmp_path, results(), "--check") == (0, "as published: 8 programs, 160 matches\n")
    assert rate(tmp_path, results())[1].count("\n") == 8


def test_changed_results_or_seeds_are_found(ladder: list[Submission], tmp_path: Path) -> None:
    true = results()
    better = json.loads(json.dumps(true))
    better["table"][0]["value"] += 1
    shorter = {**true, "table": true["table"][:-1]}
    fewer = {**true, "matches": true["matches"][40:]}
    for changed in (better, shorter, fewer):
        assert rate(tmp_path, changed, "--check") == (2, "error[table-differs]")
    seasons.end(Season.objects.get(), NOW)
    ended = results()
    assert rate(tmp_path, ended, "--check")[0] == 0
    other_seed = json.loads(json.dumps(ended))
    other_seed["matches"][3]["seed"] += 1
    for changed in (other_seed, {**ended, "secret": "0" * 64}):
        assert rate(tmp_path, changed, "--check") == (2, "error[seeds-differ]")
    assert rate(tmp_path, {"table": []}) == (2, "error[bad-results]")


def test_secret_is_published_at_the_end_only(ladder: list[Submission]) -> None:
    secret = Season.objects.get().secret
    for address in ("/ladder", "/seasons/1", "/api/v1/seasons/1/results"):
        assert secret.encode() not in new_client().get(address).content
    seasons.end(Season.objects.get(), NOW)
    for address in ("/ladder", "/seasons/1", "/api/v1/seasons/1/results"):
        assert secret.encode() in new_client().get(address).content


def test_season_without_a_ladder_has_no_results(site: SiteConfig) -> None:
    make_team()
    assert new_client().get("/api/v1/seasons/1/results").status_code == 404
    assert new_client().get("/api/v1/seasons/9/results").status_code == 404
    assert new_client().get("/ladder").status_code == 200
    assert new_client().get("/seasons/9").status_code == 404


def test_match_that_an_organizer_voids_does_not_count_and_all_read_why(ladder: list[Submission]) -> None:
    from tests.web.test_organizers import organizer

    match = Match.objects.filter(blue=ladder[0]).first()
    assert match is not None
    before, client = results()["table"], organizer()
    assert client.post(f"/desk/matches/{match.pk}/void", {"reason": " "}).status_code == 400
    assert client.post(f"/desk/matches/{match.pk}/void", {"reason": "the ball was lost"}).status_code == 302
    after = results()
    assert after["table"] != before
    assert [one["void"] for one in after["matches"] if one["number"] == match.number] == ["the ball was lost"]
    assert "the ball was lost" in new_client().get(f"/matches/{match.pk}").content.decode()
    assert sum(row["games"] for row in after["table"]) == sum(row["games"] for row in before) - 2


def test_same_program_of_twenty_teams_has_one_row_and_handing_it_in_again_changes_nothing(
    ladder: list[Submission],
) -> None:
    before = results()
    for index in range(20):
        handed_in(20 + index, ladder[2].digest)
    again = Submission.objects.create(
        team=ladder[0].team, season=ladder[0].season, number=2, sha256="a" * 64, size_bytes=1, begun_at=NOW,
        received_at=NOW, via="page", state=State.ACCEPTED, digest=ladder[0].digest,
    )  # fmt: skip
    Entry.objects.filter(team=again.team).update(active=again)
    assert results()["table"] == before["table"]
    assert new_client().get("/ladder").content.decode().count('href="/teams/') > 28


def test_next_program_of_a_team_starts_from_its_last_and_both_stay_in_its_history(ladder: list[Submission]) -> None:
    best = ladder[0]
    newer = Submission.objects.create(
        team=best.team, season=best.season, number=2, sha256="a" * 64, size_bytes=1, begun_at=NOW, received_at=NOW,
        via="page", state=State.ACCEPTED, digest="f" * 64,
    )  # fmt: skip
    value = next(row["value"] for row in results()["table"] if row["digest"] == best.digest)
    Entry.objects.filter(team=best.team).update(active=newer)
    row = next(row for row in results()["table"] if row["digest"] == newer.digest)
    assert (row["value"], row["rank"], row["games"]) == (value, None, 0)
    page = new_client().get(f"/teams/{best.team_id}").content.decode()
    assert str(value) in page
    assert new_client().get("/ladder").content.decode().count("placing</span>") == 1


def test_long_table_is_divided_into_pages(site: SiteConfig) -> None:
    make_team("First")
    programs = [handed_in(index, f"{index:064}") for index in range(130)]
    played(programs, 130)
    first, second = (new_client().get(f"/ladder?page={number}").content for number in (1, 2))
    shown = [sum(page.count(f'/teams/{one.team_id}"'.encode()) > 0 for one in programs) for page in (first, second)]
    assert len(first) < 80_000
    assert shown[0] >= 100
    assert shown[1] >= 30
    for wrong in ("0", "-1", "x", "9999", "٣"):
        assert new_client().get("/ladder", {"page": wrong}).status_code == 200


def test_replay_that_is_gone_is_made_again_when_somebody_asks_but_not_too_many(
    site: SiteConfig, ladder: list[Submission]
) -> None:
    match = Match.objects.first()
    assert match is not None
    client = new_client()
    assert client.get(f"/matches/{match.pk}/replay").status_code == 404
    for _ in range(2):
        assert client.post(f"/matches/{match.pk}/again").status_code == 302
    job = Job.objects.get()
    assert (job.kind, job.match_id, job.state) == ("again", match.pk, JobState.QUEUED)
    Job.objects.update(state=JobState.DONE, tries=3)
    client.post(f"/matches/{match.pk}/again")
    job.refresh_from_db()
    assert (job.state, job.tries) == (JobState.QUEUED, 0)
    codes = [client.post(f"/matches/{one.pk}/again").status_code for one in Match.objects.all()[:25]]
    assert (codes.count(302), codes.count(409)) == (20, 5)
    Job.objects.all().delete()
    for model, changed in (
        (Submission, {"is_deleted": True}),
        (Basis, {"versions": {"numpy": "0.1"}}),
        (Match, {"is_doubtful": True}),  # it may end differently once more, which would look like a fault of the site
    ):
        assert client.post(f"/matches/{match.pk}/again").status_code == 302
        Job.objects.all().delete()
        before = list(model.objects.values_list("pk", *changed))
        model.objects.update(**changed)
        assert client.post(f"/matches/{match.pk}/again").status_code == 409
        assert b"/again" not in client.get(f"/matches/{match.pk}").content
        for pk, value in before:
            model.objects.filter(pk=pk).update(**dict.fromkeys(changed, value))


def test_of_each_team_the_last_records_are_kept_and_those_just_made(site: SiteConfig) -> None:
    make_team("First")
    one, other, third = (handed_in(index) for index in range(3))
    old = [make_match(site, one, other, number=number) for number in range(1, 26)]
    rare = make_match(site, third, other, number=26)
    Match.objects.filter(pk=rare.pk).update(played_at=NOW.replace(year=2020))
    for number, match in enumerate(old):
        Match.objects.filter(pk=match.pk).update(played_at=NOW.replace(minute=number))
    seasons.drop_records(NOW)
    assert all(record_folder(site.folder, match).exists() for match in old)  # they were just made
    seasons.drop_records(timezone.now() + timedelta(hours=2))
    assert [record_folder(site.folder, match).exists() for match in old] == [False] * 5 + [True] * 20
    assert record_folder(site.folder, rare).exists()


def test_fault_has_its_team_and_leads_to_its_moment_and_an_own_one_is_marked(site: SiteConfig) -> None:
    from tests.web.test_organizers import organizer

    team, code = make_team("Own")
    one, other = handed_in(1), handed_in(2)
    Submission.objects.filter(pk=one.pk).update(team=team)
    one.refresh_from_db()
    match = make_match(site, one, other)
    client = new_client()
    client.post("/enter", {"code": code})
    page = client.get(f"/matches/{match.pk}").content.decode()
    assert page.count(f"/matches/{match.pk}/replay#h1t3") == 2
    assert page.count("yours</span>") == 1
    for stranger in (new_client(), organizer()):
        page = stranger.get(f"/matches/{match.pk}").content.decode()
        assert "yours</span>" not in page
        faults = page[page.index("<h2>Faults") :]
        # Sides change at half-time, so the robot alone does not show whose fault it was.
        assert [faults.count(f'href="/teams/{one.team_id}"') for one in (match.blue, match.yellow)] == [1, 1]


def test_fault_is_in_a_period_by_its_name(site: SiteConfig) -> None:
    match = make_match(site, handed_in(1), handed_in(2))
    kept = match_folder(site.folder) / "scenarios" / f"{match.basis.scenario}.json"
    for called, name in ((None, "half"), ("round", "round"), (["inning", "innings"], "inning")):
        kept.parent.mkdir(exist_ok=True)
        kept.write_text(json.dumps({"match": {"called": called}}), encoding="utf-8")
        page = new_client().get(f"/matches/{match.pk}").content.decode()
        assert page.count(f"{name} 1, 0:00.1") == 2


def test_table_is_computed_anew_only_after_a_change(ladder: list[Submission], monkeypatch: pytest.MonkeyPatch) -> None:
    first = results()["table"]
    monkeypatch.setattr(tables, "fit_of", lambda _: pytest.fail("computed again"))
    assert results()["table"] == first
    monkeypatch.undo()
    Match.objects.filter(number=1).update(void="x")
    assert results()["table"] != first


def test_results_that_are_read_while_a_match_ends_are_those_of_their_table(
    ladder: list[Submission], monkeypatch: pytest.MonkeyPatch
) -> None:
    fit_then = tables.fit_of

    def fit_while_a_match_ends(published: Results) -> Any:
        monkeypatch.undo()
        Match.objects.filter(number__lte=20).update(void="void now")
        return fit_then(published)

    monkeypatch.setattr(tables, "fit_of", fit_while_a_match_ends)
    published = Results.model_validate(results())
    assert published.table == table_of(published, fit_of(published))
    assert Results.model_validate(results()).table != published.table


@pytest.mark.parametrize("kind", MatchKind.values)
def test_match_that_cannot_be_played_is_voided_on_the_desk(ladder: list[Submission], kind: str) -> None:
    from tests.web.test_organizers import organizer

    match = Match.objects.get(number=1)
    Match.objects.filter(pk=match.pk).update(kind=kind, played_at=None, blue_goals=None, yellow_goals=None)
    with jobs.writing():
        jobs.enqueue("ladder", match, NOW)
    Job.objects.update(state=JobState.STUCK)
    client = organizer()
    assert f"/desk/matches/{match.pk}/void" in client.get("/desk").content.decode()
    assert client.post(f"/desk/matches/{match.pk}/void", {"reason": "it could not be played"})["Location"] == "/desk"
    assert Job.objects.get().state == JobState.DONE
    assert f"/desk/matches/{match.pk}/void" not in client.get("/desk").content.decode()
    assert not seasons.open_rated(match.basis).exists()
