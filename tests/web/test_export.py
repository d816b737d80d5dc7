"""The organizer's export is what a tournament is played with."""

from __future__ import annotations

import hashlib
import io
import subprocess
import zipfile
from pathlib import Path

import pytest

from rcj_challenges.web.config import SiteConfig
from tests.web.club import make_club
from tests.web.conftest import COMMAND, NOW, make_team
from tests.web.handing_in import small_team

CUP = """\
tournament_version: 1
title: Club cup
seed: drawn after the deadline
teams_folder: submissions
set: {match.half_s: 2}
stages:
  groups: {stage: round_robin, title: Groups}
"""


@pytest.mark.parametrize("command", ["plan", pytest.param("run", marks=pytest.mark.nightly)])
def test_export_is_a_folder_that_a_tournament_takes(site: SiteConfig, tmp_path: Path, command: str):
    from rcj_challenges.web.blobs import Blobs
    from rcj_challenges.web.models import Entry, Season, State, Submission

    club = make_club(site)
    Entry.objects.all().delete()
    blobs = Blobs(site.folder)
    teams = [make_team(f"Team {letter}")[0] for letter in "ABC"]
    for number, team in enumerate(teams):
        received = blobs.incoming / str(number)
        received.write_bytes(small_team())
        sha256, size = blobs.keep_bytes(received.read_bytes())
        submission = Submission.objects.create(
            team=team, season=Season.objects.get(), number=1, sha256=sha256, size_bytes=size, begun_at=NOW,
            received_at=NOW, via="page", state=State.ACCEPTED,
        )  # fmt: skip
        Entry.objects.create(team=team, season=submission.season, active=submission if number < 2 else None)
    answer = club.clients["organizer"].get("/desk/export")
    with zipfile.ZipFile(io.BytesIO(answer.getvalue())) as archive:
        archive.extractall(tmp_path)
    names = [f"team{team.pk}.zip" for team in teams[:2]]  # that of the third does not play
    assert sorted(path.name for path in (tmp_path / "submissions").iterdir()) == names
    for line in (tmp_path / "hashes.txt").read_text(encoding="utf-8").splitlines():
        sha256, path = line.split("  ")
        assert hashlib.sha256((tmp_path / path).read_bytes()).hexdigest() == sha256
    (tmp_path / "cup.yaml").write_text(CUP, encoding="utf-8")
    done = subprocess.run(
        [*COMMAND, "tournament", command, "cup.yaml"],
        cwd=tmp_path,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    assert all(name.removesuffix(".zip") in done.stdout for name in names)
