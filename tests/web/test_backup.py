"""A backup that is made while teams hand in is a site that goes on where the other was."""

from __future__ import annotations

import subprocess
import threading
from collections.abc import Callable
from pathlib import Path

import pytest

from rcj_challenges.tournament.store.store import Store
from rcj_challenges.web import dispatcher, jobs, seasons
from rcj_challenges.web.backup import back_up, problems
from rcj_challenges.web.blobs import Blobs
from rcj_challenges.web.config import SiteConfig, load_site
from rcj_challenges.web.models import Basis, Job, JobState, Match, MatchKind, Submission
from rcj_challenges.web.tables import standings_of
from tests.checker.small_team import PLAYER
from tests.web.conftest import COMMAND, NOW, Served, make_team, use_site
from tests.web.test_matches import accepted, add, begun

MANY = {"uploads_per_hour": 1000, "uploads_per_day": 1000}


@pytest.mark.nightly
def test_next_match_of_a_restored_site_is_played_and_ends_as_on_the_other(
    folder: Callable[..., SiteConfig], tmp_path: Path, serve: Callable[..., Served]
) -> None:
    config = folder(**MANY)
    with use_site(config):
        basis = begun(config)
        played, waiting = add(basis, *[(accepted(config, "One"), accepted(config, "Other", "# other\n" + PLAYER))] * 2)
        assert dispatcher.Dispatcher(config, lambda: NOW).do_next()
        codes = [make_team(f"Team {number}")[1] for number in range(4)]
    served = serve(config, "--no-dispatch")
    receipts = []

    def hand_in(code: str) -> None:
        receipts.extend(served.submit(code, f"{code} {number}".encode())[1] for number in range(5))

    teams = [threading.Thread(target=hand_in, args=(code,)) for code in codes]
    for team in teams:
        team.start()
    copied = tmp_path / "elsewhere"
    ran = subprocess.run(
        [*COMMAND, "site", "backup", str(config.folder), str(copied)], check=False, capture_output=True
    )
    assert ran.returncode == 0, ran.stderr
    for team in teams:
        team.join()
    assert len(receipts) == 20
    served.stop()
    assert subprocess.run([*COMMAND, "site", "doctor", str(copied)], check=False).returncode == 0
    digests = []
    for site in (load_site(copied), config):
        with use_site(site):
            assert list(problems(site)) == []
            Job.objects.exclude(match=waiting).update(state=JobState.DONE)
            assert dispatcher.Dispatcher(site, lambda: NOW).do_next()
            digests.append({one.number: one.digest for one in Match.objects.all()})
            assert seasons.shown_basis(basis.season) == basis
            assert len(standings_of(basis).published.matches) == 2
    assert digests[0] == digests[1]
    assert played.pk != waiting.pk


def test_tournament_of_an_event_is_copied_as_it_is_at_this_moment(site: SiteConfig, tmp_path: Path) -> None:
    data = site.folder / "events" / "1" / "tournament_data"
    (data.parent / "frozen").mkdir(parents=True)
    (data.parent / "frozen" / "team1.zip").write_bytes(b"x")
    with Store(data, writing=True) as store:
        store.keep_drawn({"seed": 1})
        back_up(site, tmp_path / "copy")
        store.keep_drawn({"seed": 2})
    with Store(tmp_path / "copy" / "events" / "1" / "tournament_data", writing=False) as copy:
        assert copy.drawn() == {"seed": 1}
    assert (tmp_path / "copy" / "events" / "1" / "frozen" / "team1.zip").read_bytes() == b"x"


def test_what_is_missing_damaged_or_stuck_is_found(site: SiteConfig, tmp_path: Path) -> None:
    begun(site)
    one, other = accepted(site, "One"), accepted(site, "Other", "# other\n" + PLAYER)
    blobs = Blobs(site.folder)
    Job.objects.create(kind="check", key="check/1", state=JobState.STUCK, not_before=NOW, created_at=NOW)
    blobs.path(one.sha256).unlink()
    blobs.path(other.sha256).write_bytes(b"other")
    (tmp_path / "left").write_bytes(b"left")
    blobs.keep((tmp_path / "left"), "f" * 64)
    (site.folder / "matches" / "scenarios" / f"{Basis.objects.get().scenario}.json").unlink()
    assert len(list(problems(site))) == 5
    ran = subprocess.run(
        [*COMMAND, "site", "doctor", str(site.folder)], check=False, capture_output=True, text=True
    )  # fmt: skip
    assert (ran.returncode, ran.stderr.startswith("error[site-problems]")) == (2, True)


def test_backup_is_made_into_a_new_folder_only(site: SiteConfig, tmp_path: Path) -> None:
    (tmp_path / "full").mkdir()
    (tmp_path / "full" / "file").write_bytes(b"")
    command = [*COMMAND, "site", "backup", str(site.folder), str(tmp_path / "full")]
    ran = subprocess.run(command, check=False, capture_output=True, text=True)
    assert (ran.returncode, ran.stderr.startswith("error[site-exists]")) == (2, True)
    back_up(site, tmp_path / "new")
    with use_site(load_site(tmp_path / "new")):
        assert not Submission.objects.exists()
        with jobs.writing():
            assert not Match.objects.filter(kind=MatchKind.RATED).exists()
