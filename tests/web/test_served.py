"""A site as it runs: real processes, real archives."""

from __future__ import annotations

import time
from collections.abc import Callable

from rcj_challenges.web.config import SiteConfig
from tests.web.conftest import Served, make_team, use_site
from tests.web.handing_in import small_team


def wait_for(served: Served, code: str, pk: int, timeout_s: float = 100.0) -> dict[str, object]:
    until = time.monotonic() + timeout_s
    while True:
        state = served.state(code, pk)
        if state["state"] not in {"queued", "checking"}:
            return state
        assert time.monotonic() < until, state
        time.sleep(0.1)


def test_what_is_handed_in_is_checked_by_playing_and_then_plays(
    folder: Callable[..., SiteConfig], serve: Callable[..., Served]
) -> None:
    config = folder()
    with use_site(config):
        _, code = make_team()
    served = serve(config)
    status, receipt = served.submit(code, small_team())
    assert status == 201
    state = wait_for(served, code, receipt["id"])
    assert (state["state"], state["is_active"]) == ("accepted", True), state
    assert served.submit(code, small_team())[1]["number"] == 2
