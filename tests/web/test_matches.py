"""Matches of a ladder: what they are played with is pinned, and each has one result, however processes end."""

from __future__ import annotations

import hashlib
import os
import signal
import threading
import time
from datetime import timedelta
from pathlib import Path
from typing import Any

import pytest

from rcj_challenges.match.runner import PlayedMatch
from rcj_challenges.tournament import playing as tournament_playing
from rcj_challenges.web import dispatcher, jobs, matchmaking, playing, seasons
from rcj_challenges.web.blobs import Blobs, record_folder
from rcj_challenges.web.config import SiteConfig
from rcj_challenges.web.errors import SiteError
from rcj_challenges.web.models import Basis, Entry, Job, JobState, Match, MatchKind, Season, State, Submission
from rcj_challenges.web.tables import standings_of
from tests.checker.small_team import PLAYER
from tests.web.club import new_client
from tests.web.conftest import NOW, make_team
from tests.web.handing_in import small_team

SLOW = PLAYER + "\nimport time\ntime.sleep(2.0)\n"


def accepted(config: SiteConfig, name: str, program: str = PLAYER, number: int = 1) -> Submission:
    """Return an accepted submission of a new team, which plays."""
    from rcj_challenges.submissions.team import open_team

    team, _ = make_team(name)
    path = Blobs(config.folder).incoming / "new"
    path.write_bytes(small_team(program))
    digest = open_team(path.rename(path.with_suffix(".zip")), *_entrants()).digest
    sha256, size = Blobs(config.folder).keep_bytes(path.with_suffix(".zip").read_bytes())
    season = Season.objects.get()
    made = Submission.objects.create(
        team=team, season=season, number=number, sha256=sha256, size_bytes=size, begun_at=NOW, received_at=NOW,
        via="page", state=State.ACCEPTED, level="passed", digest=digest,
    )  # fmt: skip
    Entry.objects.create(team=team, season=season, active=made)
    return made


def _entrants() -> Any:
    from rcj_challenges.scenario.load import load

    return load("match").scenario.entrants.values()


def begun(config: SiteConfig) -> Basis:
    """Begin the ladder of the season with very short halves."""
    make_team("First")
    Season.objects.update(ladder_overrides=[])
    seasons.begin(Season.objects.get(), NOW)
    return Basis.objects.get()


def add(basis: Basis, *pairs: tuple[Submission, Submission]) -> list[Match]:
    with jobs.writing():
        matches = seasons.add_matches(basis, MatchKind.RATED, pairs, NOW)
        for match in matches:
            jobs.enqueue("ladder", match, NOW)
    return matches


@pytest.fixture
def basis(site: SiteConfig) -> Basis:
    """Return the basis of a season that has begun on the site of this process."""
    return begun(site)


def test_season_that_begins_shows_the_hash_of_its_secret_from_which_the_seeds_follow(basis: Basis) -> None:
    season = Season.objects.get()
    assert season.secret_hash == hashlib.sha256(season.secret.encode()).hexdigest()
    assert seasons.seed_of("ab", "rated", 7) == 0x7F201D72  # echo -n 7 | openssl dgst -sha256 -hmac ab
    assert len({seasons.seed_of(season.secret, "rated", number) for number in range(100)}) == 100
    assert seasons.seed_of(season.secret, "practice", 1) != seasons.seed_of(season.secret, "rated", 1)
    seasons.begin(season, NOW + timedelta(days=1))  # it has begun
    assert Season.objects.get().secret == season.secret
    assert Basis.objects.count() == 1


def test_secret_is_on_no_page_of_an_organizer(basis: Basis) -> None:
    from tests.web.test_organizers import organizer

    client, season = organizer(), Season.objects.get()
    for address in (f"/admin/web/season/{season.pk}/change/", "/admin/web/season/", "/desk"):
        assert season.secret.encode() not in client.get(address).content


def test_season_whose_scenario_is_not_for_two_teams_has_no_ladder(site: SiteConfig) -> None:
    make_team()
    Season.objects.update(scenario="search", overrides=[], ladder_overrides=[])
    with pytest.raises(SiteError) as refused:
        seasons.begin(Season.objects.get(), NOW)
    assert refused.value.code == "not-for-two"
    assert not Basis.objects.exists()


def test_match_is_played_with_its_seed_and_again_bit_for_bit_when_its_record_is_gone(
    site: SiteConfig, basis: Basis
) -> None:
    one, other = accepted(site, "One"), accepted(site, "Other", "# other\n" + PLAYER)
    (match,) = add(basis, (one, other))
    worker = dispatcher.Dispatcher(site, lambda: NOW)
    assert worker.do_next()
    match.refresh_from_db()
    assert (match.played_at, match.is_doubtful, Job.objects.get().state) == (NOW, False, JobState.DONE)
    assert match.blue_goals is not None
    assert len(match.digest) == 64
    replay = record_folder(site.folder, match) / "replay.html"
    first = replay.read_text(encoding="utf-8")
    replay.unlink()
    with jobs.writing():
        jobs.enqueue("again", match, NOW)
    assert worker.do_next()
    again = Match.objects.get()
    assert (again.digest, again.blue_goals, again.played_at) == (match.digest, match.blue_goals, NOW)
    assert len(replay.read_text(encoding="utf-8")) == pytest.approx(len(first), abs=100)
    assert list(Blobs(site.folder).incoming.glob("job-*")) == []


def test_match_that_ends_differently_when_it_is_played_again_is_a_fault_of_the_site(
    site: SiteConfig, basis: Basis
) -> None:
    (match,) = add(basis, (accepted(site, "One"), accepted(site, "Other", "# other\n" + PLAYER)))
    Match.objects.update(played_at=NOW, digest="0" * 64, blue_goals=1, yellow_goals=0)
    assert dispatcher.Dispatcher(site, lambda: NOW).do_next()
    assert Job.objects.get().error == "the match ended differently from the first time"
    assert Match.objects.get(pk=match.pk).digest == "0" * 64
    assert not record_folder(site.folder, match).exists()


@pytest.mark.nightly
def test_dispatcher_with_other_versions_takes_no_match_but_checks(
    site: SiteConfig, basis: Basis, monkeypatch: pytest.MonkeyPatch
) -> None:
    from tests.web.handing_in import hand_in

    add(basis, (accepted(site, "One"), accepted(site, "Other", "# other\n" + PLAYER)))
    monkeypatch.setattr(seasons, "own_versions", lambda: {**basis.versions, "numpy": "0.1"})
    other = dispatcher.Dispatcher(site, lambda: NOW)
    assert not other.do_next()
    hand_in(site, make_team("Third")[0], b"x")
    assert other.do_next()
    assert set(Job.objects.values_list("kind", "state")) == {("ladder", "queued"), ("check", "done")}


def test_check_goes_before_matches_that_wait_longer(site: SiteConfig, basis: Basis) -> None:
    from tests.web.handing_in import hand_in

    one, other = accepted(site, "One"), accepted(site, "Other", "# other\n" + PLAYER)
    add(basis, (one, other), (other, one))
    hand_in(site, make_team("Third")[0], b"x", NOW)
    order = [jobs.claim("one", NOW, bases=[basis.pk]) for _ in range(3)]
    assert [job.kind for job in order if job is not None] == ["check", "ladder", "ladder"]


@pytest.mark.nightly
def test_match_whose_process_is_killed_is_played_again_and_has_the_result_of_one_that_was_not(
    site: SiteConfig, basis: Basis
) -> None:
    one, other = accepted(site, "One", SLOW), accepted(site, "Other", "# other\n" + SLOW)
    killed, quiet = add(basis, (one, other), (one, other))
    Match.objects.update(seed=5)
    now = [NOW]
    worker = dispatcher.Dispatcher(site, lambda: now[0])
    with_kill = threading.Thread(target=_kill_child, args=(worker,))
    with_kill.start()
    assert worker.do_next()
    with_kill.join()
    assert Job.objects.get(match=killed).state == JobState.QUEUED
    now[0] += timedelta(minutes=1)
    assert worker.do_next()
    assert worker.do_next()
    results = {one.pk: (one.blue_goals, one.yellow_goals, one.faults) for one in Match.objects.all()}
    assert results[killed.pk] == results[quiet.pk]
    assert Job.objects.get(match=killed).tries == 2


def _kill_child(worker: dispatcher.Dispatcher) -> None:
    until = time.monotonic() + 60
    while not worker._processes:
        assert time.monotonic() < until
        time.sleep(0.01)
    time.sleep(1.0)
    for process in list(worker._processes.values()):
        os.kill(process.pid, signal.SIGKILL)


@pytest.mark.parametrize(
    ("fault", "digests", "is_doubtful"),
    [
        ({"kind": "crash", "timed": False, "traceback": "File robot.py"}, "a", False),
        ({"kind": "step_timeout", "timed": True, "traceback": ""}, "aa", False),
        ({"kind": "crash", "timed": False, "traceback": ""}, "ab", True),  # a signal
    ],
)
def test_match_in_which_a_program_was_ended_from_outside_is_repeated_and_the_second_time_counts(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, fault: dict[str, Any], digests: str, is_doubtful: bool
) -> None:
    left = list(digests)

    def play_job(*_: object) -> PlayedMatch:
        folder = tmp_path / "record"
        folder.mkdir()
        return PlayedMatch(folder, {"digest": left.pop(0), "faults": [fault]})

    monkeypatch.setattr(tournament_playing, "play_job", play_job)
    job = {"scenario": "", "seats": {}, "names": {}, "seed": 1, "versions": {}}
    answer = playing.play({"job": job, "site": str(tmp_path), "folder": str(tmp_path)})
    assert (answer["result"]["digest"], answer["is_doubtful"], left) == (digests[-1], is_doubtful, [])


def test_result_of_a_lease_that_ran_out_is_dropped(any_site: SiteConfig) -> None:
    basis = begun(any_site)
    (match,) = add(basis, (accepted(any_site, "One"), accepted(any_site, "Other", "# other\n" + PLAYER)))
    first = jobs.claim("one", NOW, bases=[basis.pk])
    later = NOW + jobs.LEASE + timedelta(seconds=1)
    second = jobs.claim("two", later, bases=[basis.pk])
    assert first is not None
    assert second is not None
    for job, goals, counts in ((first, 1, False), (second, 2, True)):
        result = {"score": {"blue": goals, "yellow": 0}, "digest": str(goals) * 64, "faults": []}
        answer = {"result": result, "is_doubtful": False}
        done = jobs.finish(job, later, 1.0, lambda _, answer=answer: seasons.store_result(match, answer, later))
        assert done is counts
    assert Match.objects.get().blue_goals == 2


def test_after_a_change_of_versions_all_is_played_again_while_the_old_table_stays(
    site: SiteConfig, basis: Basis, monkeypatch: pytest.MonkeyPatch
) -> None:
    one, other = accepted(site, "One"), accepted(site, "Other", "# other\n" + PLAYER)
    played, voided, waiting = add(basis, (one, other), (other, one), (one, other))
    Match.objects.exclude(pk=waiting.pk).update(played_at=NOW, digest="1" * 64, blue_goals=1, yellow_goals=0)
    Match.objects.filter(pk=voided.pk).update(void="the ball was lost")
    monkeypatch.setattr(seasons, "own_versions", lambda: {**basis.versions, "numpy": "99"})
    season = Season.objects.get()
    seasons.rebase(season, NOW)
    new = seasons.current_basis(season)
    assert new is not None
    assert seasons.shown_basis(season) == basis
    assert (new.versions["numpy"], new.is_whole) == ("99", False)
    again = Match.objects.filter(basis=new).order_by("number")
    assert [(m.number, m.seed, m.void) for m in again] == [
        (1, played.seed, ""), (2, voided.seed, "the ball was lost"), (3, waiting.seed, ""),
    ]  # fmt: skip
    assert list(seasons.open_rated(new)) == [again[2], again[0]]
    assert not seasons.open_rated(basis).exists()
    seasons.rebase(season, NOW)  # once more, before the first has ended: it takes its place
    assert Basis.objects.count() == 2
    assert Match.objects.count() == 5


def test_match_that_is_voided_while_all_is_played_again_does_not_count_then_either(
    site: SiteConfig, basis: Basis, monkeypatch: pytest.MonkeyPatch
) -> None:
    from tests.web.test_organizers import organizer

    one, other = accepted(site, "One"), accepted(site, "Other", "# other\n" + PLAYER)
    first, second = add(basis, (one, other), (other, one))
    Match.objects.update(played_at=NOW, digest="1" * 64, blue_goals=1, yellow_goals=0)
    monkeypatch.setattr(seasons, "own_versions", lambda: {**basis.versions, "numpy": "99"})
    season = Season.objects.get()
    seasons.rebase(season, NOW)
    new = seasons.current_basis(season)
    assert new is not None
    assert fill(new) == 2
    with jobs.writing():
        (practice,) = seasons.add_matches(new, MatchKind.PRACTICE, [(one, other)], NOW)
    assert practice.number == first.number
    organizer().post(f"/desk/matches/{first.pk}/void", {"reason": "the ball was lost"})
    assert [one.number for one in seasons.open_rated(new)] == [second.number]
    assert Match.objects.get(basis=new, kind=MatchKind.RATED, number=first.number).void == "the ball was lost"
    assert Match.objects.filter(void="").count() == 3


def test_season_that_ends_plays_no_more(site: SiteConfig, basis: Basis) -> None:
    one, other = accepted(site, "One"), accepted(site, "Other", "# other\n" + PLAYER)
    played, _ = add(basis, (one, other), (other, one))
    Match.objects.filter(pk=played.pk).update(played_at=NOW)
    seasons.end(Season.objects.get(), NOW)
    assert list(Match.objects.all()) == [played]
    assert Season.objects.get().ended_at == NOW


def test_of_a_team_that_is_deleted_results_stay_and_records_and_open_matches_go(site: SiteConfig, basis: Basis) -> None:
    from rcj_challenges.web.models import Account, Role

    one, other = accepted(site, "One"), accepted(site, "Other", "# other\n" + PLAYER)
    played, waiting = add(basis, (one, other), (other, one))
    Match.objects.filter(pk=played.pk).update(played_at=NOW, blue_goals=1, yellow_goals=0)
    Job.objects.filter(match=played).update(state=JobState.DONE)
    running = jobs.claim("one", NOW, bases=[basis.pk])
    record = record_folder(site.folder, played)
    record.mkdir(parents=True)
    mentor = new_client()
    mentor.force_login(Account.objects.create(name="m", role=Role.MENTOR, group=one.team.group, password="!"))  # noqa: S106
    assert mentor.post(f"/group/teams/{one.team_id}/delete", {"confirm": "One"}).status_code == 302
    assert not record.exists()
    assert dict(Match.objects.values_list("pk", "void")) == {played.pk: "", waiting.pk: "a team was deleted"}
    assert not Job.objects.exclude(state=JobState.DONE).exists()
    assert running is not None
    assert not jobs.finish(running, NOW, 1.0, lambda _: None)


# --- the queue is filled ----------------------------------------------------------------------------------------------


def four_teams(config: SiteConfig) -> list[Submission]:
    return [accepted(config, f"Team {index}", f"# {index}\n{PLAYER}") for index in range(4)]


def fill(basis: Basis, lanes: int = 2) -> int:
    return matchmaking.fill(lanes, NOW, [basis.pk])


def test_queue_is_filled_when_half_of_it_is_gone(any_site: SiteConfig) -> None:
    basis = begun(any_site)
    assert fill(basis) == 0  # nothing plays yet
    four_teams(any_site)
    assert fill(basis) == 8
    assert set(Job.objects.values_list("kind", flat=True)) == {"placement"}
    assert fill(basis) == 0
    for _ in range(4):
        job = jobs.claim("one", NOW, bases=[basis.pk])
        assert job is not None
        assert jobs.finish(job, NOW, 1.0, lambda _: None)
    assert fill(basis) == 4
    assert sorted(Match.objects.values_list("number", flat=True)) == list(range(1, 13))
    assert [m.seed for m in Match.objects.all()] == [
        seasons.seed_of(Season.objects.get().secret, "rated", m.number) for m in Match.objects.all()
    ]
    assert fill(basis, 100) == 6  # each of the six pairs meets three times
    assert fill(basis, 100) == 0


def test_same_program_of_many_teams_is_one_that_plays(site: SiteConfig, basis: Basis) -> None:
    first, *_ = [accepted(site, f"Copy {index}") for index in range(4)]
    assert fill(basis) == 0
    other = accepted(site, "Other", "# other\n" + PLAYER)
    assert fill(basis) == 3
    assert {one for match in Match.objects.all() for one in (match.blue, match.yellow)} == {first, other}


def test_queue_is_not_filled_by_dispatchers_that_do_not_fit_nor_after_the_end(site: SiteConfig, basis: Basis) -> None:
    four_teams(site)
    assert matchmaking.fill(2, NOW, []) == 0
    seasons.end(Season.objects.get(), NOW)
    assert fill(basis) == 0


def test_program_that_had_its_lane_time_of_a_day_waits(site: SiteConfig, basis: Basis) -> None:
    slow, *others = four_teams(site)
    add(basis, (slow, accepted(site, "Gone", "# gone\n" + PLAYER)))
    Entry.objects.filter(team__name="Gone").delete()
    Job.objects.update(state=JobState.DONE, finished_at=NOW, lane_s=float(site.lane_s_per_day))
    Match.objects.update(played_at=NOW, blue_goals=0, yellow_goals=0)
    assert fill(basis) == 8
    assert slow.pk not in {pk for one in open_matches(basis) for pk in (one.blue_id, one.yellow_id)}
    assert len(others) == 3
    assert matchmaking.fill(8, NOW + timedelta(days=2), [basis.pk]) > 0
    assert slow.pk in {pk for one in open_matches(basis) for pk in (one.blue_id, one.yellow_id)}


def open_matches(basis: Basis) -> list[Match]:
    return list(seasons.open_rated(basis))


def test_all_matches_are_queued_again_and_then_the_table_changes(
    site: SiteConfig, basis: Basis, monkeypatch: pytest.MonkeyPatch
) -> None:
    season = Season.objects.get()
    four_teams(site)
    fill(basis)
    Job.objects.update(state=JobState.DONE)
    Match.objects.update(played_at=NOW, blue_goals=1, yellow_goals=0)
    monkeypatch.setattr(seasons, "own_versions", lambda: {**basis.versions, "numpy": "99"})
    seasons.rebase(season, NOW)
    new = seasons.current_basis(season)
    assert new is not None
    assert fill(new, 1) == 4
    assert fill(new, 2) == 4
    assert seasons.shown_basis(season) == basis
    assert len(standings_of(basis).published.matches) == 8
    Match.objects.filter(basis=new).update(played_at=NOW, blue_goals=0, yellow_goals=1)
    Job.objects.update(state=JobState.DONE)
    assert fill(new) == 0
    assert seasons.shown_basis(season) == new
    assert fill(new) == 8  # the season goes on
    assert min(seasons.open_rated(new).values_list("number", flat=True)) == 9


def test_programs_that_follow_another_are_those_of_the_team_that_had_them_first(site: SiteConfig) -> None:
    make_team("First")
    season = Season.objects.get()

    def hand_over(team: Any, digest: str, state: str = State.ACCEPTED) -> None:
        number = Submission.objects.count() + 1
        Submission.objects.create(
            team=team, season=season, number=number, sha256=f"{number:064}", size_bytes=1, begun_at=NOW,
            received_at=NOW, via="page", state=state, digest=digest,
        )  # fmt: skip

    one, other = make_team("One")[0], make_team("Other")[0]
    for team, digest in ((one, "a"), (other, "b"), (one, "c"), (other, "c"), (other, "d"), (one, "a"), (one, "e")):
        hand_over(team, digest)
    hand_over(one, "f", State.REJECTED)
    assert seasons.programs_of(season) == {"a": None, "b": None, "c": "a", "d": "c", "e": "a"}


def test_organizer_begins_and_ends_the_ladder_on_the_desk(site: SiteConfig) -> None:
    from tests.web.test_organizers import organizer

    make_team()
    client, season = organizer(), Season.objects.get()
    assert b'value="begin"' in client.get("/desk").content
    assert client.post("/desk/season", {"act": "begin"}).status_code == 302
    assert b'value="rebase"' not in client.get("/desk").content
    Basis.objects.update(versions={"numpy": "0.1"})
    assert b'value="rebase"' in client.get("/desk").content
    assert client.post("/desk/season", {"act": "end", "confirm": "wrong"}).status_code == 400
    assert client.post("/desk/season", {"act": "end", "confirm": season.title}).status_code == 302
    assert Season.objects.get().ended_at is not None
