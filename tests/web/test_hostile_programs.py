"""Programs that attack the match, handed in on a site: each gets its verdict, and no other team waits for them."""

from __future__ import annotations

import io
import time
import zipfile
from collections.abc import Callable
from pathlib import Path

import pytest

from rcj_challenges.web.config import SiteConfig
from tests.web.conftest import Served, make_team, use_site
from tests.web.handing_in import small_team
from tests.web.test_served import wait_for

PROGRAMS = sorted((Path(__file__).parents[1] / "hostile" / "programs").glob("*.py"))
ENTRY = "rcj_soccer_team_blue/rcj_soccer_team_blue.py"
BY_DAY = ("aborts", "floods_its_output", "forges_the_lines_of_the_match", "talks_nonsense")
SLOW = ("loops_in_play", "never_listens", "sleeps_in_every_other_step")
MOST_LATE_S = 30.0


def zipped(program: Path) -> bytes:
    made = io.BytesIO()
    with zipfile.ZipFile(made, "w") as archive:
        archive.writestr(ENTRY, program.read_bytes())
    return made.getvalue()


def check_all(programs: list[Path], config: SiteConfig, serve: Callable[..., Served]) -> None:
    with use_site(config):
        codes = [make_team(program.stem[:40], "School 1")[1] for program in programs]
    served = serve(config)
    receipts = [served.submit(code, zipped(one))[1] for code, one in zip(codes, programs, strict=True)]
    states = [wait_for(served, code, one["id"], 900.0)["state"] for code, one in zip(codes, receipts, strict=True)]
    assert set(states) <= {"accepted", "rejected"}, dict(zip((one.stem for one in programs), states, strict=True))
    assert served.get("/healthz")[0] == 200


def test_programs_that_attack_the_match_get_their_verdict(
    folder: Callable[..., SiteConfig], serve: Callable[..., Served]
) -> None:
    check_all([program for program in PROGRAMS if program.stem in BY_DAY], folder(), serve)


@pytest.mark.nightly
@pytest.mark.timeout(5400)
def test_each_hostile_program_gets_its_verdict(folder: Callable[..., SiteConfig], serve: Callable[..., Served]) -> None:
    assert len(PROGRAMS) > 50
    check_all(PROGRAMS, folder(), serve)


@pytest.mark.nightly
@pytest.mark.timeout(1800)
@pytest.mark.parametrize("name", SLOW)
def test_a_slow_program_delays_no_other_team(
    name: str, folder: Callable[..., SiteConfig], serve: Callable[..., Served]
) -> None:
    config = folder()
    with use_site(config):
        hostile, first, second = (make_team(team)[1] for team in ("Hostile", "First", "Second"))
    served = serve(config)

    def checked_within_s(code: str) -> float:
        began_s = time.monotonic()
        assert wait_for(served, code, served.submit(code, small_team())[1]["id"])["state"] == "accepted"
        return time.monotonic() - began_s

    alone_s = checked_within_s(first)
    served.submit(hostile, zipped(next(program for program in PROGRAMS if program.stem == name)))
    assert checked_within_s(second) < 2 * alone_s + MOST_LATE_S  # two checks share the processors
