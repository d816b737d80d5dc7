"""What is checked and what is left out, what it is called, and that no team sees the pages of another."""

from __future__ import annotations

import re
import sys
from pathlib import Path

import pytest

from rcj_challenges.checker.discovery import file_slug, find_submissions, name_submissions


@pytest.fixture
def folder(tmp_path):
    """A folder as organizers have it: two archives, and other things."""
    for name in ("A.ZIP", "b.rar", ".hidden.zip", "no_ending", "notes.txt", "stray.py"):
        (tmp_path / name).write_bytes(b"PK")
    (tmp_path / "folder.zip").mkdir()
    (tmp_path / "team").mkdir()
    (tmp_path / "team" / "robot.py").write_text("x = 1\n", encoding="utf-8")
    if sys.platform != "win32":  # where only administrators make links
        (tmp_path / "gone.zip").symlink_to("nowhere.zip")
    return tmp_path


def test_everything_beside_archives_is_listed_as_left_out(folder):
    found = find_submissions([folder])
    assert [path.name for path in found.paths] == ["A.ZIP", "b.rar"]
    left_out = {Path(other.file).name for other in found.left_out}
    expected = {".hidden.zip", "no_ending", "notes.txt", "stray.py", "folder.zip", "team"}
    assert left_out == expected | ({"gone.zip"} if sys.platform != "win32" else set())
    assert all(other.reason for other in found.left_out)


def test_paths_given_by_name_are_checked_once(folder):
    found = find_submissions([folder, folder / "team", folder / "no_ending", folder / "team" / ".." / "A.ZIP"])
    assert [path.name for path in found.paths] == ["A.ZIP", "b.rar", "team", "no_ending"]
    assert not {"team", "no_ending"} & {Path(other.file).name for other in found.left_out}


def test_old_archive_in_a_teams_own_folder_is_left_out(tmp_path):
    (tmp_path / "robot.py").write_text("x = 1\n", encoding="utf-8")
    (tmp_path / "old.zip").write_bytes(b"PK")
    found = find_submissions([tmp_path])
    assert found.paths == [tmp_path]
    assert [Path(other.file).name for other in found.left_out] == ["old.zip"]


def test_folder_without_archives_and_programs_is_a_submission(tmp_path):
    (tmp_path / ".hidden.zip").write_bytes(b"PK")
    found = find_submissions([tmp_path])
    assert found.paths == [tmp_path]
    assert [Path(other.file).name for other in found.left_out] == [".hidden.zip"]


def test_submissions_of_the_same_file_name_are_named_with_their_folders():
    paths = [Path("/x/a/team.zip"), Path("/x/b/team.zip"), Path("/x/b/other.zip")]
    assert [one.name for one in name_submissions(paths)] == ["a/team.zip", "b/team.zip", "other.zip"]


def test_no_two_submissions_have_the_same_name_or_the_same_pages():
    long = "y" * 250
    names = ["a/team.zip", "b/team.zip", "team.zip", "c/team", "d/TEAM.zip", "e/ü.zip", "a/s/team.zip", "b/s/team.zip"]
    found = name_submissions([Path("/x", name) for name in [*names, f"{long}1{long}", f"{long}2{long}"]])
    assert len({one.name for one in found}) == len(names) + 2
    assert len({one.slug.casefold() for one in found}) == len(names) + 2


def test_single_submission_has_the_name_of_its_file(tmp_path, monkeypatch):
    assert [(one.name, one.slug) for one in name_submissions([tmp_path / "team.zip"])] == [("team.zip", "team")]
    monkeypatch.chdir(tmp_path)
    assert name_submissions([Path()])[0].name == tmp_path.name


def test_names_of_replays_are_legal_everywhere_and_never_the_same():
    names = ["team.zip", "a/../b", "ü.zip", "ö.zip", "con trol", "x" * 200 + ".zip", "x" * 199 + "y.zip", ".zip"]
    slugs = [file_slug(name) for name in names]
    assert len(set(slugs)) == len(names)
    assert slugs[0] == "team"
    assert all(re.fullmatch(r"[A-Za-z0-9_-]{1,80}", slug) for slug in slugs)
