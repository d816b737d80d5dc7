"""The command that hands in: what is mistyped is named, and a site that starts again is waited for."""

from __future__ import annotations

from typing import Any

import pytest

from rcj_challenges.cli import submit
from rcj_challenges.cli.codes import SITE_UNREACHABLE
from rcj_challenges.cli.submit import _Site
from rcj_challenges.core.errors import RcjError


@pytest.mark.parametrize(
    ("address", "code", "error"),
    [
        ("http://club.lan:8x", "7H3K", "bad-option"),
        ("http://club.lan:99999", "7H3K", "bad-option"),
        ("http://[club", "7H3K", "bad-option"),
        ("club.lan", "7H3K", "bad-option"),
        ("http://club.lan", "7H3Ж", "wrong-card"),
        ("http://club.lan", "7H3K\nX: y", "wrong-card"),
    ],
)
def test_mistyped_address_or_code_is_named(address: str, code: str, error: str) -> None:
    with pytest.raises(RcjError) as caught:
        _Site(address, code)
    assert caught.value.code == error


@pytest.mark.parametrize("away_s", [50.0, 70.0])
def test_site_that_is_away_for_a_minute_after_the_receipt_is_waited_for(
    monkeypatch: pytest.MonkeyPatch, away_s: float
) -> None:
    clock_s = [0.0]

    def request(*_: Any) -> dict[str, Any]:
        if clock_s[0] < away_s:
            raise RcjError("away", "wait", code=SITE_UNREACHABLE)
        return {"state": "accepted"}

    monkeypatch.setattr(_Site, "_request", request)
    monkeypatch.setattr(submit.time, "monotonic", lambda: clock_s[0])
    monkeypatch.setattr(submit.time, "sleep", lambda wait_s: clock_s.__setitem__(0, clock_s[0] + wait_s))
    site = _Site("http://club.lan", "7H3K")
    if away_s < submit._AWAY_S:
        assert site.wait(1, quiet=True) == {"state": "accepted"}
    else:
        with pytest.raises(RcjError) as caught:
            site.wait(1, quiet=True)
        assert caught.value.code == "site-unreachable"


def test_what_was_not_checked_does_not_pass() -> None:
    assert submit._EXIT_CODES == {"accepted": 0, "rejected": 1, "unchecked": 2, "superseded": 2}
