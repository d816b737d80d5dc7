"""The queue: what is handed in is checked once, in a fair order, however its workers end."""

from __future__ import annotations

import threading
from datetime import UTC, datetime, timedelta
from typing import Any
from zoneinfo import ZoneInfo

import pytest
from django.db import connection, transaction
from hypothesis import given
from hypothesis import strategies as st

from rcj_challenges.web import jobs
from rcj_challenges.web.blobs import Blobs
from rcj_challenges.web.config import SiteConfig
from rcj_challenges.web.models import Entry, Job, JobState, Season, State, Submission
from rcj_challenges.web.receiving import RefusedError, ensure_may_upload
from tests.web.club import new_client
from tests.web.conftest import NOW, make_team, use_site
from tests.web.handing_in import hand_in

ACCEPTED = jobs.Verdict(State.ACCEPTED, "passed", "d" * 64, {"level": "passed"})
AFTER_THE_LEASE = jobs.LEASE + timedelta(seconds=1)


def claimed(worker: str = "one", now: datetime = NOW) -> Job:
    job = jobs.claim(worker, now)
    assert job is not None
    return job


def accept(job: Job, now: datetime = NOW, lane_s: float = 1.0) -> bool:
    assert job.submission is not None
    submission = Submission.objects.get(pk=job.submission.pk)
    return jobs.finish(job, now, lane_s, lambda _: jobs.store_verdict(submission, ACCEPTED))


def state_of(submission: Any) -> str:
    return str(Submission.objects.get(pk=submission.pk).state)


def test_a_job_is_leased_to_one_worker_and_its_state_is_that_of_its_submission(any_site: SiteConfig) -> None:
    team, _ = make_team()
    submission = hand_in(any_site, team, b"x")
    assert state_of(submission) == State.QUEUED
    job = claimed()
    assert job.submission_id == submission.pk
    assert jobs.claim("two", NOW) is None
    assert state_of(submission) == State.CHECKING
    assert accept(job)
    assert state_of(submission) == State.ACCEPTED
    assert Entry.objects.get().active_id == submission.pk


def test_a_lease_that_ran_out_gives_the_job_to_another_and_the_late_result_is_dropped(any_site: SiteConfig) -> None:
    team, _ = make_team()
    hand_in(any_site, team, b"x")
    first, later = claimed("one"), NOW + AFTER_THE_LEASE
    second = claimed("two", later)
    assert jobs.renew("one", [(first.pk, first.attempt)], later) == set()
    assert jobs.renew("two", [(second.pk, second.attempt)], later) == {(second.pk, second.attempt)}
    assert not accept(first, later)
    assert not jobs.fail(first, later, 1.0, "too late")
    assert accept(second, later)
    assert Job.objects.get().state == JobState.DONE


def test_a_lease_that_is_renewed_does_not_run_out(site: SiteConfig) -> None:
    team, _ = make_team()
    hand_in(site, team, b"x")
    job = claimed()
    for second in range(30, 300, 30):
        now = NOW + timedelta(seconds=second)
        assert jobs.claim("two", now) is None
        assert jobs.renew("one", [(job.pk, job.attempt)], now)
    assert accept(job, now)


def test_after_three_tries_it_is_an_alarm_and_not_the_teams_fault_and_can_be_tried_again(site: SiteConfig) -> None:
    team, _ = make_team()
    submission = hand_in(site, team, b"x")
    now = NOW
    for _ in range(jobs.MAX_TRIES):
        assert jobs.fail(claimed(now=now), now, 1.0, "broken host")
        now += timedelta(minutes=1)
    stuck = Job.objects.get()
    submission.refresh_from_db()
    assert (stuck.state, stuck.error) == (JobState.STUCK, "broken host")
    assert (submission.state, submission.is_counted) == (State.UNCHECKED, False)
    assert jobs.claim("one", now) is None
    jobs.try_again(stuck, now)
    assert state_of(submission) == State.QUEUED
    assert accept(claimed(now=now), now)


def test_a_worker_that_is_stopped_costs_no_try(site: SiteConfig) -> None:
    team, _ = make_team()
    hand_in(site, team, b"x")
    for _ in range(5):
        assert jobs.fail(claimed(), NOW, 1.0, "stopped", is_try=False)
    assert Job.objects.get().state == JobState.QUEUED


def test_a_row_that_a_suspended_worker_has_locked_holds_up_no_other(any_site: SiteConfig) -> None:
    if connection.vendor == "sqlite":
        pytest.skip("SQLite has one writer at a time")
    teams = [make_team(f"Team {index}")[0] for index in range(2)]
    submissions = [hand_in(any_site, team, f"{team}".encode()) for team in teams]
    first = claimed("one")
    assert first.submission_id == submissions[0].pk
    is_locked, is_tried = threading.Event(), threading.Event()

    def hold() -> None:
        with transaction.atomic():
            Job.objects.filter(pk=first.pk).update(progress="about to finish")
            is_locked.set()
            assert is_tried.wait(30)
        connection.close()

    holder = threading.Thread(target=hold)
    holder.start()
    assert is_locked.wait(30)
    second = claimed("two", NOW + AFTER_THE_LEASE)
    is_tried.set()
    holder.join()
    assert second.submission_id == submissions[1].pk
    assert claimed("two", NOW + AFTER_THE_LEASE).pk == first.pk


def test_the_team_that_had_least_time_goes_first_and_one_that_had_its_share_waits(any_site: SiteConfig) -> None:
    slow, quick, new, greedy = (make_team(name)[0] for name in ("Slow", "Quick", "New", "Greedy"))
    for team, lane_s in ((slow, 300.0), (quick, 20.0), (greedy, 3600.0)):
        hand_in(any_site, team, f"first of {team.pk}".encode())
        assert accept(claimed(), NOW, lane_s)
    for team in (greedy, slow, quick, new):
        hand_in(any_site, team, f"second of {team.pk}".encode())
    order = [claimed().team_id for _ in range(3)]
    assert order == [new.pk, quick.pk, slow.pk]
    assert jobs.claim("one", NOW) is None
    assert claimed(now=NOW + timedelta(hours=25)).team_id == greedy.pk


def test_time_that_was_spent_on_our_faults_counts_for_the_order_too(site: SiteConfig) -> None:
    unlucky, other = make_team("Unlucky")[0], make_team("Other")[0]
    hand_in(site, unlucky, b"kills its host")
    assert jobs.fail(claimed(), NOW, 400.0, "no report")
    hand_in(site, other, b"x")
    assert claimed().team_id == other.pk


def test_of_queued_checks_of_a_team_only_the_newest_is_done_and_the_older_are_not_counted(any_site: SiteConfig) -> None:
    team, _ = make_team()
    running = hand_in(any_site, team, b"0")
    job = claimed()
    waiting = [hand_in(any_site, team, f"{index}".encode()) for index in range(1, 4)]
    assert [state_of(one) for one in waiting] == [State.SUPERSEDED, State.SUPERSEDED, State.QUEUED]
    assert [one.is_counted for one in Submission.objects.order_by("number")] == [True, False, False, True]
    assert accept(job)
    assert Entry.objects.get().active_id == running.pk
    assert accept(claimed())
    assert Entry.objects.get().active_id == waiting[-1].pk
    assert jobs.claim("one", NOW) is None


def test_an_older_check_that_ends_later_takes_nothing_away(site: SiteConfig) -> None:
    team, _ = make_team()
    hand_in(site, team, b"old")
    old = claimed("one")
    newer = hand_in(site, team, b"new")
    assert accept(claimed("two"))
    assert accept(old)
    assert Entry.objects.get().active_id == newer.pk


def test_the_same_bytes_get_the_earlier_verdict_with_its_pages_at_once(site: SiteConfig) -> None:
    team, _ = make_team()
    first = hand_in(site, team, b"x")
    assert accept(claimed())
    pages = site.folder / "reports" / str(first.pk)
    pages.mkdir()
    (pages / "report.html").write_text("all is well", encoding="utf-8")
    second = hand_in(site, team, b"x")
    assert (second.state, second.is_counted, second.number) == (State.ACCEPTED, False, 2)
    assert (site.folder / "reports" / str(second.pk) / "report.html").read_text(encoding="utf-8") == "all is well"
    assert Entry.objects.get().active_id == second.pk


@pytest.mark.parametrize("ago_s", [0, 119, 300])  # the last: it had to wait for a slot
def test_what_counts_for_the_deadline_is_when_the_upload_began(site: SiteConfig, ago_s: int) -> None:
    team, _ = make_team()
    Season.objects.update(closes_at=NOW)
    after = NOW + timedelta(seconds=ago_s)
    assert not hand_in(site, team, b"in time", now=after, begun_at=NOW).is_late
    assert hand_in(site, team, b"late", now=after, begun_at=NOW + timedelta(seconds=0.1)).is_late


def test_a_clock_that_is_set_back_loses_nothing_and_numbers_go_on(any_site: SiteConfig) -> None:
    teams = [make_team(f"Team {index}")[0] for index in range(3)]
    dead = hand_in(any_site, teams[0], b"0")
    claimed("dies")
    hand_in(any_site, teams[1], b"1")
    before = NOW - timedelta(hours=1)
    queued = claimed("two", before)  # an hour ahead
    assert queued.team_id == teams[1].pk
    assert accept(queued, before)
    later = hand_in(any_site, teams[0], b"2", now=before)
    assert later.number == dead.number + 1
    first = claimed("two", before + AFTER_THE_LEASE)
    second = claimed("two", before + AFTER_THE_LEASE)
    assert {first.submission_id, second.submission_id} == {dead.pk, later.pk}
    assert accept(second, before)
    assert accept(first, before)
    assert Entry.objects.get(team=teams[0]).active_id == later.pk


def test_a_clock_that_is_set_back_while_a_job_runs_does_not_take_it_away(site: SiteConfig) -> None:
    team, _ = make_team()
    hand_in(site, team, b"x")
    job, before = claimed("one"), NOW - timedelta(hours=1)
    assert jobs.claim("two", before) is None
    assert accept(job, before)


@pytest.mark.parametrize(
    ("closes", "last"),
    [
        # The night in which 2:00 becomes 3:00, and that in which 3:00 becomes 2:00.
        (datetime(2026, 3, 29, 3, 0, tzinfo=ZoneInfo("Europe/Berlin")), datetime(2026, 3, 29, 1, 0, tzinfo=UTC)),
        (datetime(2026, 10, 25, 3, 0, tzinfo=ZoneInfo("Europe/Berlin")), datetime(2026, 10, 25, 2, 0, tzinfo=UTC)),
        (
            datetime(2026, 10, 25, 2, 30, fold=1, tzinfo=ZoneInfo("Europe/Berlin")),
            datetime(2026, 10, 25, 1, 30, tzinfo=UTC),
        ),
    ],
)
def test_a_deadline_across_summer_time_is_one_moment_in_the_zone_of_the_site(
    any_site: SiteConfig, closes: datetime, last: datetime
) -> None:
    team, _ = make_team()
    Season.objects.update(closes_at=closes)
    assert not hand_in(any_site, team, b"in time", now=last).is_late
    assert hand_in(any_site, team, b"late", now=last + timedelta(microseconds=1000)).is_late


def test_before_a_season_opens_and_beyond_the_quotas_nothing_is_taken(site: SiteConfig) -> None:
    team, _ = make_team()
    season = Season.objects.get()
    season.opens_at = NOW
    with pytest.raises(RefusedError) as refused:
        ensure_may_upload(team, season, NOW - timedelta(seconds=1))
    assert (refused.value.status, refused.value.code) == (409, "not-open")
    for index in range(site.uploads_per_hour):
        ensure_may_upload(team, season, NOW)
        hand_in(site, team, f"{index}".encode())
        assert accept(claimed())
    with pytest.raises(RefusedError) as refused:
        ensure_may_upload(team, season, NOW)
    assert (refused.value.status, refused.value.code) == (429, "too-often")
    ensure_may_upload(team, season, NOW + timedelta(hours=1, seconds=1))


STEPS = st.lists(
    st.tuples(
        st.sampled_from(["hand in", "claim", "finish", "fail", "renew", "die", "wait", "clock"]), st.integers(0, 2)
    ),
    max_size=40,
)


@given(STEPS)
def test_in_whatever_order_things_happen_each_submission_ends_once(  # noqa: C901, PLR0912 - a branch for each step
    site: SiteConfig, steps: list[Any]
) -> None:
    for model in (Entry, Job, Submission):
        model.objects.all().delete()
    teams = [make_team(f"Team {index}")[0] for index in range(3)]
    now, held, ended = NOW, {}, []
    for number, (act, index) in enumerate(steps):
        worker = f"worker {index}"
        if act == "hand in":
            hand_in(site, teams[index], f"{number} {id(steps)}".encode(), now=now)
        elif act == "claim":
            job = jobs.claim(worker, now)
            if job is not None:
                held[worker] = job
        elif act == "wait":
            now += timedelta(seconds=25)
        elif act == "clock":
            now -= timedelta(minutes=30)
        elif worker in held and act == "renew":
            jobs.renew(worker, [(held[worker].pk, held[worker].attempt)], now)
        elif worker in held and act in {"finish", "fail", "die"}:
            job = held.pop(worker)
            if act == "fail":
                jobs.fail(job, now, 1.0, "fault")
            elif act == "finish" and accept(job, now):
                ended.append(job.pk)
        running = list(Job.objects.filter(state=JobState.RUNNING))
        assert len(running) == len({job.submission_id for job in running})
    for _ in range(3 * Job.objects.count() + 3):
        now += AFTER_THE_LEASE
        job = jobs.claim("last", now)
        if job is not None and accept(job, now):
            ended.append(job.pk)
    assert len(ended) == len(set(ended))
    final = {State.ACCEPTED: JobState.DONE, State.UNCHECKED: JobState.STUCK, State.SUPERSEDED: JobState.DONE}
    for submission in Submission.objects.all():
        assert [job.state for job in submission.job_set.all()] == [final[State(submission.state)]]
    for entry in Entry.objects.all():
        newest = Submission.objects.filter(team=entry.team, state=State.ACCEPTED).order_by("-number").first()
        assert entry.active == newest


def test_bytes_of_submissions_that_are_not_counted_fill_the_limit_and_their_number_has_one(folder: Any) -> None:
    with use_site(config := folder(upload_bytes_per_day=1000, uploads_per_day=1)):
        team, _ = make_team()
        big, small = hand_in(config, team, b"x" * 999), hand_in(config, make_team("Other")[0], b"0")
        Submission.objects.update(is_counted=False)
        hand_in(config, team, b"y")
        Submission.objects.update(is_counted=False)
        with pytest.raises(RefusedError) as refused:  # under the team's lock, too
            hand_in(config, team, b"z")
        assert (refused.value.status, refused.value.code) == (429, "too-much")
        assert len(list(config.folder.glob("blobs/*/*.zip"))) == 3
        assert big.team_id == team.pk
        for index in range(1, 5):
            hand_in(config, small.team, f"{index}".encode())
            Submission.objects.update(is_counted=False)
        with pytest.raises(RefusedError) as refused:
            ensure_may_upload(small.team, small.season, NOW)
        assert (refused.value.status, refused.value.code) == (429, "too-often")


def test_a_failed_try_does_not_make_a_submission_count(site: SiteConfig) -> None:
    team, _ = make_team()
    submission = hand_in(site, team, b"x")
    Submission.objects.update(is_counted=False)
    assert jobs.fail(claimed(), NOW, 1.0, "fault")
    submission.refresh_from_db()
    assert (submission.state, submission.is_counted) == (State.QUEUED, False)


def test_bytes_that_went_with_another_team_at_the_same_moment_are_not_receipted(
    site: SiteConfig, monkeypatch: pytest.MonkeyPatch
) -> None:
    team, _ = make_team()
    monkeypatch.setattr(Blobs, "keep", lambda *_: None)
    with pytest.raises(RefusedError) as refused:
        hand_in(site, team, b"x")
    assert refused.value.status == 503
    assert not Submission.objects.exists()


def test_late_submission_plays_only_where_there_is_none_in_time(site: SiteConfig) -> None:
    team, _ = make_team()
    Season.objects.update(closes_at=NOW)
    after = NOW + timedelta(seconds=1)
    in_time = hand_in(site, team, b"in time")
    slow = claimed("one")
    late = hand_in(site, team, b"late", now=after)
    assert accept(claimed("two", after), after)
    assert Entry.objects.get().active_id == late.pk
    assert accept(slow, after)
    assert Entry.objects.get().active_id == in_time.pk
    hand_in(site, team, b"later", now=after)
    assert accept(claimed(now=after), after)
    assert Entry.objects.get().active_id == in_time.pk


def test_choice_of_the_team_is_kept_until_it_hands_in_again(site: SiteConfig) -> None:
    team, code = make_team()
    first = hand_in(site, team, b"1")
    assert accept(claimed())
    hand_in(site, team, b"2")
    second = claimed()  # its check ends only after the choice
    client = new_client()
    client.post("/enter", {"code": code})
    assert client.post(f"/my/submissions/{first.pk}/activate").status_code == 302
    assert accept(second)
    assert Entry.objects.get().active_id == first.pk
    third = hand_in(site, team, b"3")
    assert accept(claimed())
    assert Entry.objects.get().active_id == third.pk
