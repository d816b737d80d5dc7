"""The queue: what is handed in is checked once, whoever dies meanwhile."""

from __future__ import annotations

from datetime import timedelta

from rcj_challenges.web import jobs
from rcj_challenges.web.config import SiteConfig
from rcj_challenges.web.models import Job, JobState, Season, State, Submission
from rcj_challenges.web.receiving import receive
from tests.web.conftest import NOW, make_team


def hand_in(site: SiteConfig, team: object, data: bytes, **options: object) -> Submission:
    import hashlib

    received = site.folder / "incoming" / "one"
    received.write_bytes(data)
    season = Season.objects.get()
    times = {"begun_at": NOW, "now": NOW, **options}
    return receive(team, season, received, hashlib.sha256(data).hexdigest(), len(data), via="api", **times)


def test_what_is_handed_in_waits_and_is_leased_to_one_worker(any_site: SiteConfig) -> None:
    team, _ = make_team()
    submission = hand_in(any_site, team, b"x")
    job = jobs.claim("one", NOW)
    assert job is not None
    assert job.submission_id == submission.pk
    assert jobs.claim("two", NOW) is None
    assert Submission.objects.get().state == State.CHECKING


def test_a_lease_that_ran_out_gives_the_job_to_another_and_the_late_result_is_dropped(any_site: SiteConfig) -> None:
    team, _ = make_team()
    hand_in(any_site, team, b"x")
    first = jobs.claim("one", NOW)
    later = NOW + jobs.LEASE + timedelta(seconds=10)
    second = jobs.claim("two", later)
    assert first is not None
    assert second is not None
    stored: list[str] = []
    assert not jobs.finish(first, later, 1.0, lambda _: stored.append("one"))
    assert jobs.finish(second, later, 1.0, lambda _: stored.append("two"))
    assert stored == ["two"]
    assert Job.objects.get().state == JobState.DONE
