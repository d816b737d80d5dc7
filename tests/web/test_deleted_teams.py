"""What a deleted team had is gone, and no job that was under way brings it back."""

from __future__ import annotations

from typing import Any

import pytest

from rcj_challenges.web import jobs
from rcj_challenges.web.blobs import Blobs
from rcj_challenges.web.config import SiteConfig
from tests.web.club import new_client
from tests.web.conftest import NOW, make_team
from tests.web.handing_in import hand_in


def delete(team: Any) -> None:
    from rcj_challenges.web.models import Account, Role

    client = new_client()
    client.force_login(Account.objects.get_or_create(name="chief", role=Role.ORGANIZER, password="!")[0])  # noqa: S106
    answer = client.post(f"/group/teams/{team.pk}/delete", {"confirm": team.name, "reason": "left"})
    assert answer.status_code == 302


@pytest.mark.parametrize("kind", ["check", "repair"])
def test_result_that_comes_after_the_team_was_deleted_is_dropped_with_its_files(
    site: SiteConfig, monkeypatch: pytest.MonkeyPatch, kind: str
) -> None:
    from rcj_challenges.web.dispatcher import Dispatcher
    from rcj_challenges.web.models import Job, JobState, Submission

    team, _ = make_team()
    hand_in(site, team, b"x")
    Job.objects.update(kind=kind)

    def answer(_self: Dispatcher, job: Job, _claim: Any, _request: dict[str, Any]) -> dict[str, Any]:
        made = Blobs(site.folder).working(job) / "made"
        made.write_text("a report, or what is repaired", encoding="utf-8")
        delete(team)
        return {"report": {"level": "passed", "digest": "d", "blocked_by": ""}, "host": False, "repaired": str(made)}

    monkeypatch.setattr(Dispatcher, "_answer", answer)
    assert Dispatcher(site, lambda: NOW).do_next()
    assert [one.report for one in Submission.objects.all()] == [None]
    assert Job.objects.get().state == JobState.DONE
    for folder in ("reports", "blobs", "incoming"):
        assert [path for path in (site.folder / folder).rglob("*") if path.is_file()] == []
    assert not [*(site.folder / "reports").iterdir(), *(site.folder / "incoming").iterdir()]


def test_deleted_team_hands_in_nothing_and_its_queued_jobs_end(site: SiteConfig) -> None:
    from rcj_challenges.web.models import Audit, Job
    from rcj_challenges.web.receiving import RefusedError

    team, _ = make_team("Blue Foxes")
    hand_in(site, team, b"x")
    left = Blobs(site.folder).working(Job(pk=Job.objects.get().pk, attempt=1))
    left.mkdir()
    delete(team)
    assert not left.exists()
    assert jobs.claim("one", NOW) is None
    with pytest.raises(RefusedError) as refused:
        hand_in(site, team, b"y")
    assert (refused.value.status, refused.value.code) == (409, "no-team")
    assert not list(site.folder.glob("blobs/*/*.zip"))
    assert "Blue Foxes" not in str(list(Audit.objects.values()))
