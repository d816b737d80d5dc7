"""The folder in which teams hand in: what is no submission in it is refused, and nothing waits or reads without end."""

import os
import subprocess
import sys
import zipfile

import pytest

from rcj_challenges.scenario.errors import ScenarioError
from rcj_challenges.tournament.admission import keep_submission
from rcj_challenges.tournament.load import load_tournament

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="pipes and links as on POSIX")

CUP = """
tournament_version: 1
title: Cup
seed: 1
teams_folder: {folder}
stages: {{league: {{stage: round_robin}}}}
"""


@pytest.fixture
def cup(tmp_path):
    """Return the codes of a tournament whose teams hand in here."""
    (tmp_path / "teams").mkdir()
    for team in ("ada", "bee"):
        with zipfile.ZipFile(tmp_path / "teams" / f"{team}.zip", "w") as archive:
            archive.writestr("robot.py", "")
    file = tmp_path / "cup.yaml"

    def codes(folder="teams"):
        file.write_text(CUP.format(folder=folder), "utf-8")
        try:
            load_tournament(file)
        except ScenarioError as error:
            return [one.code for one in error.diagnostics]
        return []

    return codes


@pytest.mark.parametrize("folder", ["/", "/proc"])
def test_a_folder_of_the_system_is_no_folder_of_submissions(cup, folder):
    if not os.path.isdir(folder) or len(os.listdir(folder)) < 15:  # noqa: PTH112, PTH208
        pytest.skip("another system")
    assert cup(folder) == ["teams-folder"]


def test_a_link_may_lead_to_another_zip_of_the_folder(cup, tmp_path):
    (tmp_path / "teams" / "cid.zip").symlink_to("ada.zip")
    assert cup() == []


@pytest.mark.parametrize("target", ["private.zip", "/dev/zero", "private", "nowhere.zip"])
def test_a_link_out_of_the_folder_is_refused(cup, tmp_path, target):
    (tmp_path / "private").mkdir()
    (tmp_path / "private.zip").write_bytes((tmp_path / "teams" / "ada.zip").read_bytes())
    (tmp_path / "teams" / "cid.zip").symlink_to(tmp_path / target)
    assert cup() == ["teams-folder"]


def test_a_pipe_is_refused_and_nothing_waits_for_it(cup, tmp_path):
    os.mkfifo(tmp_path / "teams" / "cid.zip")
    assert cup() == ["teams-folder"]
    with pytest.raises(OSError, match="pipe"):
        keep_submission(tmp_path / "teams" / "cid.zip", tmp_path)


def test_validate_does_not_wait_for_a_pipe_or_read_a_device_without_end(tmp_path):
    os.mkfifo(tmp_path / "pipe.yaml")
    (tmp_path / "endless.yaml").symlink_to("/dev/zero")
    command = [sys.executable, "-m", "rcj_challenges", "validate", "pipe.yaml", "endless.yaml"]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, timeout=60, check=False)
    assert done.returncode == 2
    assert done.stderr.count("error[unreadable-file]") == 2
