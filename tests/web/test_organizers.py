"""What organizers can do about what goes wrong: typos in a season, lost passwords, archives that are missing."""

from __future__ import annotations

import io
import json
import subprocess
import zipfile
from collections.abc import Callable
from datetime import timedelta
from typing import Any

import pytest
from django.core.exceptions import ValidationError

from rcj_challenges.match.worker_pool import python_command
from rcj_challenges.web import dispatcher, jobs
from rcj_challenges.web.config import SiteConfig
from tests.web.club import make_submission, new_client
from tests.web.conftest import COMMAND, NOW, make_team, use_site
from tests.web.handing_in import hand_in


def organizer(name: str = "chief") -> Any:
    from rcj_challenges.web.models import Account, Role

    client = new_client()
    client.force_login(Account.objects.create(name=name, role=Role.ORGANIZER, password="!"))  # noqa: S106
    return client


def test_season_with_a_typo_is_refused_and_one_that_came_in_is_named_by_the_check(site: SiteConfig) -> None:
    from rcj_challenges.web.models import Season

    Season(title="Right", scenario="match", overrides=["match.half_s=2"]).clean()
    for wrong in (Season(title="Wrong", scenario="mathc"), Season(title="Wrong", overrides=["match.half=2"])):
        with pytest.raises(ValidationError):
            wrong.clean()
    request = {"scenario": "mathc", "overrides": [], "path": "x.zip", "kind": "check"}
    pipes: dict[str, Any] = {"stdin": subprocess.PIPE, "stdout": subprocess.PIPE}
    with subprocess.Popen(python_command(dispatcher._START), text=True, **pipes) as process:
        assert process.stdin is not None
        assert process.stdout is not None
        process.stdin.write(json.dumps(request) + "\n")
        process.stdin.flush()
        assert "mathc" in json.loads(process.stdout.readline())["error"]


@pytest.mark.parametrize("time", ["2026-10-25 02:30:00", "2027-03-28 02:30:00"])  # it comes twice; it does not come
def test_deadline_that_comes_twice_or_never_when_clocks_change_is_refused(
    folder: Callable[..., SiteConfig], time: str
) -> None:
    from rcj_challenges.web.models import Season

    config = folder(time_zone="Europe/Berlin")
    with use_site(config):
        make_team()
        season, client = Season.objects.get(), organizer()
        address = f"/admin/web/season/{season.pk}/change/"
        day, hour = time.split()
        form = {"title": "Season", "scenario": "match", "overrides": '["match.half_s=2"]', "is_current": "on",
                "closes_at_0": day}  # fmt: skip
        answer = client.post(address, {**form, "closes_at_1": hour})
        assert answer.status_code == 200
        assert b"errorlist" in answer.content
        assert Season.objects.get().closes_at is None
        assert client.post(address, {**form, "closes_at_1": "12:30:00"}).status_code == 302
        assert Season.objects.get().closes_at is not None


def test_error_of_the_check_process_is_that_of_the_job(site: SiteConfig, monkeypatch: pytest.MonkeyPatch) -> None:
    from rcj_challenges.web.models import Job

    monkeypatch.setattr(dispatcher.Dispatcher, "_read", staticmethod(lambda *_: {"error": "no such scenario"}))
    hand_in(site, make_team()[0], b"x")
    assert dispatcher.Dispatcher(site, lambda: NOW).do_next()
    assert Job.objects.get().error == "no such scenario"


def test_lease_that_ran_out_leaves_a_reason(site: SiteConfig) -> None:
    from rcj_challenges.web.models import Job

    hand_in(site, make_team()[0], b"x")
    assert jobs.claim("one", NOW) is not None
    jobs.return_expired(NOW + jobs.LEASE + timedelta(seconds=1))
    assert Job.objects.get().error


def test_account_is_ended_and_changed_in_no_other_way(site: SiteConfig) -> None:
    from rcj_challenges.web.models import Account

    chief, other = organizer(), organizer("other")
    account = Account.objects.get(name="other")
    address = f"/admin/web/account/{account.pk}/change/"
    assert chief.post(address, {"name": "renamed", "role": "mentor"}).status_code == 302
    account.refresh_from_db()
    assert (account.name, account.role, account.is_active) == ("other", "organizer", False)
    assert other.get("/desk").status_code == 302


def test_new_link_for_an_organizer_is_printed(folder: Callable[..., SiteConfig]) -> None:
    config = folder()
    done = subprocess.run(
        [*COMMAND, "site", "invite", config.folder, "--address", "http://club.lan/"],
        capture_output=True, text=True, check=True,
    )  # fmt: skip
    with use_site(config):
        path = done.stdout.strip().removeprefix("http://club.lan")
        assert new_client().get(path).status_code == 200


@pytest.mark.parametrize(
    ("hosts", "address", "is_warned"),
    [
        (["localhost"], "http://localhost:8000/enter", True),
        (["localhost", ".club.org", "club.lan"], "http://club.lan:8000/enter", False),
    ],
)
def test_cards_have_an_address_that_other_computers_reach_or_a_warning(
    folder: Callable[..., SiteConfig], hosts: list[str], address: str, is_warned: bool
) -> None:
    with use_site(folder(hosts=hosts)):
        given = {"names": "Blue Foxes", "group": "School 1"}
        page = organizer().post("/group/teams/new", given, SERVER_PORT="8000").content.decode()
        assert f">{address}<" in page
        assert ("works on this computer only" in page) == is_warned


def test_archive_that_is_missing_is_not_found_and_noted_in_the_export(site: SiteConfig) -> None:
    from rcj_challenges.web.models import Entry

    team, _ = make_team()
    found = make_submission(site, team)
    Entry.objects.create(team=team, season=found.season, active=found)
    next(site.folder.glob("blobs/*/*.zip")).unlink()
    chief = organizer()
    assert chief.get(f"/my/submissions/{found.pk}/archive").status_code == 404
    with zipfile.ZipFile(io.BytesIO(chief.get("/desk/export").getvalue())) as archive:
        assert archive.namelist() == ["hashes.txt"]
        assert f"team{team.pk}.zip" in archive.read("hashes.txt").decode()


def test_zero_bytes_are_no_error_of_the_server(any_site: SiteConfig) -> None:
    team, _ = make_team()
    assert new_client().post("/login", {"name": "\0", "password": "x"}).status_code == 403
    assert organizer().post(f"/group/teams/{team.pk}/card", {"reason": "\0"}).status_code == 200


def test_what_has_expired_is_removed(site: SiteConfig) -> None:
    from rcj_challenges.web.accounts import invite
    from rcj_challenges.web.models import Invite, Role, Worker

    for ago_days in (0, 8):
        invite(Role.ORGANIZER, None, NOW - timedelta(days=ago_days))
        Worker.objects.create(name=f"{ago_days}", seen_at=NOW - timedelta(days=ago_days), lanes=1)
    jobs.clean_up(NOW)
    assert (Invite.objects.count(), Worker.objects.get().name) == (1, "0")
