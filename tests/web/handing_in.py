"""Archives for the tests, and how they come in without a server."""

from __future__ import annotations

import hashlib
import io
import itertools
import time
import zipfile
from datetime import datetime
from pathlib import Path
from typing import Any

from rcj_challenges.web.config import SiteConfig
from tests.checker.small_team import PLAYER
from tests.web.conftest import NOW, Served, make_team, use_site

HOSTILE = sorted((Path(__file__).parents[1] / "hostile" / "programs").glob("*.py"))
"""Programs that attack the match."""
_COUNT = itertools.count()


def small_team(program: str = PLAYER) -> bytes:
    """Return a ZIP with one program for all robots."""
    made = io.BytesIO()
    with zipfile.ZipFile(made, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("robot.py", program)
        archive.writestr("team_name.txt", "Hanse")
    return made.getvalue()


def one_program(program: Path) -> bytes:
    """Return a ZIP with a program of one robot."""
    made = io.BytesIO()
    with zipfile.ZipFile(made, "w") as archive:
        archive.writestr("rcj_soccer_team_blue/rcj_soccer_team_blue.py", program.read_bytes())
    return made.getvalue()


def hand_in(site: SiteConfig, team: Any, data: bytes, now: datetime = NOW, begun_at: datetime | None = None) -> Any:
    """Take an archive as the pages do; return the submission."""
    from rcj_challenges.web.models import Season, Submission
    from rcj_challenges.web.receiving import receive

    received = site.folder / "incoming" / f"test-{next(_COUNT)}"
    received.write_bytes(data)
    sha256 = hashlib.sha256(data).hexdigest()
    new = Submission(
        team=team, season=Season.objects.get(), sha256=sha256, size_bytes=len(data), begun_at=begun_at or now,
        received_at=now, via="api",
    )  # fmt: skip
    return receive(received, new)


def wait_for(served: Served, code: str, pk: int, timeout_s: float = 100.0) -> dict[str, Any]:
    """Wait until a submission is checked; return its state."""
    until = time.monotonic() + timeout_s
    while True:
        state = served.state(code, pk)
        if state["state"] not in {"queued", "checking"}:
            return state
        assert time.monotonic() < until, state
        time.sleep(0.1)


def check_all(programs: list[Path], served: Served) -> None:
    """Hand programs in, each for a team of its own: each is accepted or rejected, and the site is well."""
    with use_site(served.config):
        codes = [make_team(program.stem[:40], "School 1")[1] for program in programs]
    receipts = [served.submit(code, one_program(one))[1] for code, one in zip(codes, programs, strict=True)]
    states = [wait_for(served, code, one["id"], 900.0)["state"] for code, one in zip(codes, receipts, strict=True)]
    assert set(states) <= {"accepted", "rejected"}, dict(zip((one.stem for one in programs), states, strict=True))
    assert served.get("/healthz")[0] == 200
