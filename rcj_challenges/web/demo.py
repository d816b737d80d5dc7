"""A club to look at: four sample teams that have handed in."""

from __future__ import annotations

import hashlib
import io
import zipfile
from collections.abc import Iterator, Mapping
from pathlib import Path

from django.utils import timezone

from rcj_challenges.web import jobs
from rcj_challenges.web.accounts import give_card
from rcj_challenges.web.blobs import Blobs
from rcj_challenges.web.config import current_site
from rcj_challenges.web.models import Group, Season, Submission, Team
from rcj_challenges.web.receiving import receive

_MATCH_FOLDER = "rcj_soccer_team_blue"
"""What the sample teams for a match have; those for challenges have others."""


def match_samples(scenario: str = "match") -> dict[str, Path]:
    """Return the folders of the sample teams for matches, by name.

    One whose name begins with that of a scenario is made for the robots of that one.
    """
    from rcj_challenges.scenario.resources import shipped_scenarios, shipped_teams  # noqa: PLC0415 - loads scenarios

    def is_for(name: str) -> str:
        return max((one for one in shipped_scenarios() if name.startswith(one)), key=len, default=scenario)

    found = {name: team for name, team in shipped_teams().items() if (team / _MATCH_FOLDER).is_dir()}
    return {name: team for name, team in found.items() if is_for(name) == scenario}


def make_demo(samples: Mapping[str, Path]) -> Iterator[str]:
    """Make a team for each sample, hand its programs in, and yield a line with the code of its card.

    Args:
        samples: by the name of a team, the folder with its programs.
    """
    blobs, now = Blobs(current_site().folder), timezone.now()
    with jobs.writing():
        season = Season.objects.create(title="Demo season")
        group = Group.objects.create(label="Sample teams")
        teams = {name: Team.objects.create(group=group, name=name, is_name_public=True) for name in samples}
        codes = {name: give_card(team) for name, team in teams.items()}
    for name, folder in samples.items():
        received = blobs.incoming / f"demo-{teams[name].pk}"
        data = zipped(folder)
        received.write_bytes(data)
        new = Submission(
            team=teams[name], season=season, sha256=hashlib.sha256(data).hexdigest(), size_bytes=len(data),
            begun_at=now, received_at=now, via="page",
        )  # fmt: skip
        receive(received, new)
        yield f"{name}: {codes[name]}"


def zipped(folder: Path) -> bytes:
    """Return the programs of a sample team as it would hand them in."""
    made = io.BytesIO()
    with zipfile.ZipFile(made, "w", zipfile.ZIP_DEFLATED) as archive:
        for path in sorted(folder.rglob("*")):
            if path.is_file() and "__pycache__" not in path.parts:
                archive.write(path, path.relative_to(folder).as_posix())
    return made.getvalue()
