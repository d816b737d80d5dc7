"""Archives for the tests, and how they come in without a server."""

from __future__ import annotations

import hashlib
import io
import itertools
import zipfile
from datetime import datetime
from typing import Any

from rcj_challenges.web.config import SiteConfig
from tests.checker.small_team import PLAYER
from tests.web.conftest import NOW

_COUNT = itertools.count()


def small_team(program: str = PLAYER) -> bytes:
    """Return a ZIP with one program for all robots."""
    made = io.BytesIO()
    with zipfile.ZipFile(made, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("robot.py", program)
        archive.writestr("team_name.txt", "Hanse")
    return made.getvalue()


def hand_in(site: SiteConfig, team: Any, data: bytes, now: datetime = NOW, begun_at: datetime | None = None) -> Any:
    """Take an archive as the pages do; return the submission."""
    from rcj_challenges.web.models import Season
    from rcj_challenges.web.receiving import receive

    received = site.folder / "incoming" / f"test-{next(_COUNT)}"
    received.write_bytes(data)
    sha256 = hashlib.sha256(data).hexdigest()
    return receive(team, Season.objects.get(), received, sha256, len(data), begun_at or now, now, "api")
