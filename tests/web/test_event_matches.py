"""An event is a tournament in a folder: played by the dispatcher, ruled on from the desk, published, verified."""

from __future__ import annotations

import hashlib
import json
import os
import signal
import subprocess
import threading
import time
from collections.abc import Callable
from datetime import timedelta
from pathlib import Path
from typing import Any

import pytest
from django.utils import timezone

from rcj_challenges.tournament.store.store import Store
from rcj_challenges.web import deadlines, dispatcher, events, jobs
from rcj_challenges.web.config import SiteConfig
from rcj_challenges.web.models import Event, Job, JobState, Season, Submission, Team
from tests.checker.small_team import PLAYER
from tests.web.club import new_client
from tests.web.conftest import COMMAND, Served, make_team, use_site
from tests.web.handing_in import hand_in, small_team
from tests.web.test_events import check, frozen, hash_of, make_event
from tests.web.test_organizers import organizer


def tiny(number: int) -> bytes:
    """Return a team whose programs are its own."""
    return small_team(f"{PLAYER}# {number}")


def make_frozen(site: SiteConfig, count: int, **choices: Any) -> Event:
    """Return an event of some teams in matches of two seconds that is ready to be played."""
    for number in range(count):
        check(hand_in(site, make_team(f"Team {number}")[0], tiny(number)))
    Job.objects.update(state=JobState.DONE)
    Season.objects.update(overrides=["match.half_s=1"])
    make_event(**choices)
    assert frozen() is not None
    return Event.objects.get()


def work(site: SiteConfig) -> bool:
    """Let a dispatcher see what is due and do one job."""
    events.attend(timezone.now())
    return dispatcher.Dispatcher(site).do_next()


def tournament(event: Event, *arguments: str) -> subprocess.CompletedProcess[str]:
    """Run a command for tournaments in the folder of an event."""
    command, *rest = arguments
    return subprocess.run(
        [*COMMAND, "tournament", command, events.FILE, *rest], cwd=events.event_folder(event), capture_output=True,
        text=True, check=False,
    )  # fmt: skip


def started(site: SiteConfig, count: int, **choices: Any) -> tuple[Event, Any, str]:
    """Return an event that an organizer has had played, the organizer, and the address of its desk."""
    event = make_frozen(site, count, **choices)
    client, desk = organizer(), f"/desk/events/{event.pk}"
    assert not work(site)  # nothing is played before an organizer starts it
    client.post(f"{desk}/change", {"act": "play"})
    assert work(site)
    event.refresh_from_db()
    assert (event.plays, event.played_at is not None, event.publish_at) == (False, True, None)
    return event, client, desk


def test_event_is_played_and_published_and_a_ruling_is_shown(site: SiteConfig) -> None:
    event, client, desk = started(site, 2, finalists=0)
    anyone = new_client()
    assert not work(site)
    for path in ("index.html", "certificates/groups.html", "schedule.ics", "feed.json", "style.css"):
        assert anyone.get(f"/events/{event.pk}/{path}").getvalue()
    assert event.seed in anyone.get(f"/events/{event.pk}/about.html").getvalue().decode()  # all is over
    for path in (
        ".made_from.json",
        "../store.sqlite",
        "../../tournament.yaml",
        "%2e%2e/store.sqlite",
        "x",
        "matches",
        "%00",
    ):
        assert anyone.get(f"/events/{event.pk}/{path}").status_code == 404
    with use_store(event) as store:
        (match,) = store.played()
    ruling = {"match": match, "kind": "corrected", "score": "7:1", "reason": "the judges saw it"}
    for wrong, status in (("7", 409), ("x", 409), ("1:2:3", 409), (f"{9 * 10**400}:0", 409)):
        assert client.post(f"{desk}/rule", {**ruling, "score": wrong}).status_code == status
    assert client.post(f"{desk}/rule", {**ruling, "reason": ""}).status_code == 409
    team = f"team{event.frozen[0][0]}"
    for kind in ("replay", "corrected", "forfeit"):  # the match was forgotten: the team does not leave for it
        forgotten = {**ruling, "match": "", "team": team, "kind": kind}
        assert client.post(f"{desk}/rule", forgotten).status_code == 400
    assert client.post(f"{desk}/rule", {**ruling, "team": team, "kind": "withdrawn"}).status_code == 400
    assert client.post(f"{desk}/rule", ruling).status_code == 302
    assert b"the judges saw it" in client.get(desk).content
    assert work(site)
    assert b"7 : 1" in anyone.get(f"/events/{event.pk}/index.html").getvalue()
    assert client.post(f"{desk}/rule", {"match": match, "kind": "undone", "reason": "no"}).status_code == 302
    assert work(site)
    assert b"7 : 1" not in anyone.get(f"/events/{event.pk}/index.html").getvalue()
    news = anyone.get("/feed.json").json()
    assert next(item["url"] for item in news["items"]).startswith("http://club/1/matches/")
    days = anyone.get("/calendar.ics").content.decode()
    assert f"UID:event{event.pk}@club.rcj-challenges\r\n" in days
    assert f"DTSTART:{event.deadline:%Y%m%dT%H%M%SZ}\r\n" in days


@pytest.mark.nightly
def test_of_a_team_that_is_deleted_results_stay_and_nothing_else(site: SiteConfig) -> None:
    client = organizer()
    event = make_frozen(site, 3, finalists=0)
    first, second, third = Team.objects.order_by("pk")
    Team.objects.update(is_name_public=True)

    def delete(team: Any) -> int:
        return int(client.post(f"/group/teams/{team.pk}/delete", {"confirm": team.name, "reason": "1"}).status_code)

    assert delete(third) == 302  # before the matches it just does not play
    assert set(frozen()) == {first.pk, second.pk}
    client.post(f"/desk/events/{event.pk}/change", {"act": "play"})
    folder = events.event_folder(event)
    assert work(site)
    with use_store(event) as store:
        before = store.played()
    Event.objects.update(plays=True)
    assert delete(first) == 409
    Event.objects.update(plays=False)
    assert any(first.name.encode() in path.read_bytes() for path in folder.rglob("*") if path.is_file())
    assert delete(first) == 302
    assert work(site), Job.objects.get(event=event).error
    left = [path for path in folder.rglob("*") if path.is_file() and b"Team 0" in path.read_bytes()]
    assert left == []
    assert hash_of(tiny(0)) not in {hash_of(path.read_bytes()) for path in folder.rglob("*.zip")}
    assert f"deleted team {first.pk}" in new_client().get(f"/events/{event.pk}/index.html").getvalue().decode()
    with use_store(event) as store:
        assert store.played() == before


def use_store(event: Event) -> Store:
    return Store(events.event_folder(event) / events.DATA, writing=False)


@pytest.mark.nightly
@pytest.mark.timeout(900)
def test_event_is_verified_and_plays_again_what_was_ruled_on(site: SiteConfig) -> None:
    event, client, desk = started(site, 3, finalists=2)
    verified = tournament(event, "verify", "--json")
    assert verified.returncode == 0, verified.stderr
    verdicts = [one["verdict"] for one in json.loads(verified.stdout)]
    assert (set(verdicts), len(verdicts) >= 4) == ({"same"}, True)
    before = outcomes(event)
    first, last = next(iter(before)), next(one for one in before if one.startswith("finals"))
    replay = {"match": last, "kind": "replay", "reason": "again"}
    assert client.post(f"{desk}/rule", {**replay, "match": first}).status_code == 409  # the finals have begun
    assert client.post(f"{desk}/rule", replay).status_code == 302
    assert work(site)
    assert last not in outcomes(event)
    client.post(f"{desk}/change", {"act": "play"})
    assert work(site)
    assert outcomes(event)[last]["digest"] != before[last]["digest"]
    assert client.post(f"{desk}/rule", {"team": "team1", "kind": "withdrawn", "reason": "ill"}).status_code == 302


@pytest.mark.nightly
def test_archive_that_is_not_the_frozen_one_is_not_played(site: SiteConfig) -> None:
    event = make_frozen(site, 2)
    path = next((events.event_folder(event) / "frozen").iterdir())
    path.write_bytes(tiny(9))
    Event.objects.update(plays=True)
    assert work(site)
    assert path.stem in Job.objects.get(event=event).error
    assert not list((events.event_folder(event) / events.DATA).glob("records/*"))


@pytest.mark.nightly
@pytest.mark.timeout(900)
def test_event_whose_dispatchers_are_killed_ends_as_one_that_nothing_disturbed(
    folder: Callable[..., SiteConfig], serve: Callable[..., Served], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    config = folder()
    with use_site(config):
        event = make_frozen(config, 4, finalists=2)
        Event.objects.update(plays=True)
        seen = set()
        for kill in range(4):
            monkeypatch.setattr(jobs, "LEASE", timedelta(seconds=1))
            worker = subprocess.Popen([*COMMAND, "site", "worker", str(config.folder)], start_new_session=True)
            until = time.monotonic() + 600
            while Event.objects.get().plays and (kill == 3 or (now := progress(event)) in seen):
                assert time.monotonic() < until
                time.sleep(0.05)
            if kill < 3:
                seen.add(now)
                os.kill(worker.pid, signal.SIGKILL)
                worker.wait()
                Job.objects.filter(state=JobState.RUNNING).update(lease_until=timezone.now() - timedelta(seconds=1))
        worker.send_signal(signal.SIGINT)
        worker.wait(60)
        assert len(seen) == 3
        assert Event.objects.get().played_at is not None
        killed = outcomes(event)
        assert len(killed) >= 7
    quiet = tmp_path / "quiet"
    quiet.mkdir()
    for name in ("frozen", events.FILE):
        (quiet / name).symlink_to(events_folder(config) / name)
    done = subprocess.run(
        [*COMMAND, "tournament", "run", events.FILE], cwd=quiet, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    again = subprocess.run(
        [*COMMAND, "tournament", "results", events.FILE, "--json"], cwd=quiet, capture_output=True, check=True
    )
    assert json.loads(again.stdout)["outcomes"] == killed


def events_folder(config: SiteConfig) -> Path:
    return config.folder / "events" / "1"


def progress(event: Event) -> str:
    return str(Job.objects.filter(event=event).values_list("progress", flat=True).first() or "")


def outcomes(event: Event) -> dict[str, Any]:
    return dict(json.loads(tournament(event, "results", "--json").stdout)["outcomes"])


@pytest.mark.nightly
@pytest.mark.timeout(900)
def test_match_is_ruled_on_while_an_event_pauses(
    folder: Callable[..., SiteConfig], serve: Callable[..., Served]
) -> None:
    config = folder()
    with use_site(config):
        event = make_frozen(config, 5, finalists=0)
        client, desk = organizer(), f"/desk/events/{event.pk}"
        client.post(f"{desk}/change", {"act": "play"})
        serve(config)
        until = time.monotonic() + 600
        while not progress(event):
            assert time.monotonic() < until
            time.sleep(0.1)
        ruling = {"match": next(iter(outcomes(event))), "kind": "corrected", "score": "3:0", "reason": "seen"}
        assert client.post(f"{desk}/rule", ruling).status_code == 409  # the run writes
        client.post(f"{desk}/change", {"act": "pause"})
        while client.post(f"{desk}/rule", ruling).status_code == 409:
            assert time.monotonic() < until
            time.sleep(0.5)
        client.post(f"{desk}/change", {"act": "play"})
        while Event.objects.get().played_at is None:
            assert time.monotonic() < until
            time.sleep(0.5)
        found = outcomes(event)
        assert (len(found), found[ruling["match"]]["scores"]) == (10, [3.0, 0.0])


@pytest.mark.timeout(900)
@pytest.mark.nightly
@pytest.mark.parametrize("is_played", [False, True])
def test_event_plays_exactly_the_published_hashes_when_it_is_frozen_while_uploads_run(
    folder: Callable[..., SiteConfig], serve: Callable[..., Served], monkeypatch: pytest.MonkeyPatch, is_played: bool
) -> None:
    config = folder(uploads_per_hour=1000, uploads_per_day=1000)
    monkeypatch.setattr(deadlines, "_SLOW", timedelta(seconds=6))
    with use_site(config):
        teams = [make_team(f"Team {number}") for number in range(4)]
        Season.objects.update(overrides=["match.half_s=1"])
        event = make_event(deadline=timezone.now() + timedelta(seconds=4), finalists=2)
        served = serve(config, "--no-dispatch")
        stopped, receipts = threading.Event(), list[tuple[str, dict[str, Any]]]()

        def upload(code: str, number: int) -> None:
            count = 0
            while not stopped.is_set():
                data = tiny(1000 * number + (count := count + 1))
                status, receipt = served.submit(code, data)
                assert status == 201, receipt
                receipts.append((hash_of(data), receipt))

        uploads = [threading.Thread(target=upload, args=(code, number)) for number, (_, code) in enumerate(teams)]
        for one in uploads:
            one.start()
        until = time.monotonic() + 60
        while Event.objects.get().frozen_at is None:
            assert time.monotonic() < until
            for one in Submission.objects.filter(state="queued").exclude(report__isnull=False):
                check(one, timezone.now())
            events.attend(timezone.now())
            time.sleep(0.05)
        time.sleep(1.0)
        stopped.set()
        for one in uploads:
            one.join()
        served.stop()
        last = {}
        for one in Submission.objects.filter(begun_at__lte=event.deadline).order_by("number"):
            last[one.team_id] = one.sha256
        late = Submission.objects.filter(begun_at__gt=event.deadline)
        assert {one.late_for_id for one in late} == {event.pk}
        assert len(late) >= 4
        playing = frozen(timezone.now())
        assert playing == last
        if not is_played:
            return
        Job.objects.update(state=JobState.DONE)
        Event.objects.update(plays=True)
        assert work(config)
        folder_of = events.event_folder(event) / events.DATA
        kept = {hashlib.sha256(path.read_bytes()).hexdigest() for path in (folder_of / "submissions").iterdir()}
        assert kept == set(playing.values())
        assert Event.objects.get().played_at is not None, Job.objects.get(event=event).error
        assert tournament(event, "verify").returncode == 0
