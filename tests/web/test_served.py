"""A site as it runs: real processes, real archives."""

from __future__ import annotations

import contextlib
import os
import shutil
import signal
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from django.core.files.uploadedfile import SimpleUploadedFile

from rcj_challenges.web import dispatcher
from rcj_challenges.web.models import Job, State, Submission
from tests.checker.small_team import PLAYER
from tests.hostile.archives.cases import ALL, built
from tests.web.club import new_client
from tests.web.conftest import Served, make_folder, make_team, use_site
from tests.web.handing_in import HOSTILE, check_all, small_team, wait_for


@pytest.fixture(scope="module")
def served(tmp_path_factory: pytest.TempPathFactory, migrated: Path) -> Iterator[Served]:
    """A site that checks."""
    config = make_folder(tmp_path_factory.mktemp("served") / "club")
    shutil.copy(migrated, config.folder / "site.sqlite3")
    made = Served(config)
    yield made
    made.stop()


def test_what_is_handed_in_is_checked_by_playing_and_then_plays(served: Served) -> None:
    with use_site(served.config):
        _, code = make_team()
    status, receipt = served.submit(code, small_team())
    assert status == 201
    state = wait_for(served, code, receipt["id"])
    assert (state["state"], state["is_active"]) == ("accepted", True), state
    status, receipt = served.submit(code, small_team())
    assert receipt["number"] == 2
    wait_for(served, code, receipt["id"])


def check_processes(served: Served, *, players: bool = False) -> list[int]:
    """Return the processes that check for the site, or those that they have started: players, programs."""
    parents, checks = {}, []
    for folder in Path("/proc").glob("[0-9]*"):
        with contextlib.suppress(OSError):
            pid = int(folder.name)
            parents[pid] = int((folder / "stat").read_text(encoding="utf-8").rpartition(")")[2].split()[1])
            if dispatcher._START.encode() in (folder / "cmdline").read_bytes():
                checks.append(pid)

    def is_below(pid: int, top: int) -> bool:
        return pid == top or (pid in parents and is_below(parents[pid], top))

    checks = [pid for pid in checks if is_below(pid, served.process.pid)]
    below = [pid for pid in parents for top in checks if pid != top and is_below(pid, top)]
    return below if players else checks


def wait_until(condition: Callable[[], bool]) -> None:
    """Return when this holds, a minute from now at the latest."""
    until = time.monotonic() + 60
    while not condition():
        assert time.monotonic() < until
        time.sleep(0.02)


def test_a_check_whose_process_is_killed_is_made_again_and_costs_the_team_nothing(served: Served) -> None:
    with use_site(served.config):
        _, code = make_team("Killed")
    wait_until(lambda: not check_processes(served))  # that of an earlier check may still be ending
    status, receipt = served.submit(code, small_team("# another\n" + PLAYER))
    assert status == 201
    wait_until(lambda: bool(check_processes(served)))
    for pid in check_processes(served):
        with contextlib.suppress(ProcessLookupError):
            os.kill(pid, signal.SIGKILL)
    assert wait_for(served, code, receipt["id"])["state"] == "accepted"
    with use_site(served.config):
        assert Job.objects.get(submission=receipt["id"]).tries == 2


def test_a_check_whose_players_are_killed_ends_with_a_verdict(served: Served) -> None:
    with use_site(served.config):
        _, code = make_team("Killed players")
    receipt = served.submit(code, small_team("# one more\n" + PLAYER))[1]
    wait_until(lambda: bool(check_processes(served, players=True)))
    for pid in check_processes(served, players=True):
        with contextlib.suppress(ProcessLookupError):
            os.kill(pid, signal.SIGKILL)
    assert wait_for(served, code, receipt["id"])["state"] in {"accepted", "rejected"}
    assert served.get("/healthz")[0] == 200


@pytest.mark.parametrize("count", [3, pytest.param(1000, marks=pytest.mark.nightly)])
def test_archives_that_deceive_come_by_the_form_and_get_their_verdict(served: Served, count: int) -> None:
    names = sorted(name for name in ALL if not name.startswith(("bomb", "hundred", "six_", "eleven")))
    chosen = names[:: max(1, len(names) // count)][:count]
    with use_site(served.config):
        for name in chosen:
            team, code = make_team(name[:40], "School 2")
            client = new_client()
            assert client.post("/enter", {"code": code}).status_code == 302
            sent = client.post("/my/upload", {"archive": SimpleUploadedFile("team.zip", built(name))})
            assert sent.status_code == 302, (name, sent.content)
            until = time.monotonic() + 300
            while Submission.objects.get(team=team).state in {State.QUEUED, State.CHECKING}:
                assert time.monotonic() < until, name
                time.sleep(0.1)
            assert Submission.objects.get(team=team).state in {State.ACCEPTED, State.REJECTED}, name
    assert served.get("/healthz")[0] == 200


def test_programs_that_attack_the_match_get_their_verdict(served: Served) -> None:
    by_name = {program.stem: program for program in HOSTILE}
    check_all([by_name["floods_its_output"], by_name["forges_the_lines_of_the_match"]], served)
