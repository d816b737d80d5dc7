"""Programs that attack the match, handed in on a site: each gets its verdict, and no other team waits for them."""

from __future__ import annotations

import time
from collections.abc import Callable

import pytest

from rcj_challenges.web.config import SiteConfig
from tests.web.conftest import Served, make_team, use_site
from tests.web.handing_in import HOSTILE, check_all, one_program, small_team, wait_for

SLOW = ("loops_in_play", "never_listens", "sleeps_in_every_other_step")
MOST_LATE_S = 30.0


@pytest.mark.nightly
@pytest.mark.timeout(5400)
def test_each_hostile_program_gets_its_verdict(folder: Callable[..., SiteConfig], serve: Callable[..., Served]) -> None:
    assert len(HOSTILE) > 50
    check_all(HOSTILE, serve(folder()))


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
    served.submit(hostile, one_program(next(program for program in HOSTILE if program.stem == name)))
    assert checked_within_s(second) < 2 * alone_s + MOST_LATE_S  # two checks share the processors
