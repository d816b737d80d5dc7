"""What is checked and what is left out, what it is called, and that no team sees the pages of another."""

from __future__ import annotations

import sys
import zipfile
from pathlib import Path

import pytest

from rcj_challenges.checker.many_given import called, in_folders


@pytest.fixture
def folder(tmp_path):
    """A folder as organizers have it: two archives, and much that is none."""
    for name in ("A.ZIP", "b.rar", ".hidden.zip", "._A.ZIP", "no_ending", "notes.txt", "stray.py"):
        (tmp_path / name).write_bytes(b"PK")
    (tmp_path / "folder.zip").mkdir()
    (tmp_path / "team").mkdir()
    (tmp_path / "team" / "robot.py").write_text("x = 1\n", encoding="utf-8")
    if sys.platform != "win32":  # where only administrators make links
        (tmp_path / "gone.zip").symlink_to("nowhere.zip")
    return tmp_path


def test_what_lies_beside_archives_is_named_with_the_reason_why_it_is_not_looked_at(folder):
    given = in_folders([folder])
    assert [path.name for path in given.paths] == ["A.ZIP", "b.rar"]
    reasons = {Path(other.file).name: other.reason for other in given.left_out}
    if sys.platform != "win32":
        assert "leads nowhere" in reasons.pop("gone.zip")
    assert reasons.keys() == {
        ".hidden.zip", "._A.ZIP", "no_ending", "notes.txt", "stray.py", "folder.zip", "team"
    }  # fmt: skip
    assert "dot" in reasons[".hidden.zip"]
    assert "folder" in reasons["folder.zip"]
    assert "folder" in reasons["team"]
    assert ".zip" in reasons["no_ending"]
    assert "program" in reasons["stray.py"]


def test_what_is_given_by_its_name_is_looked_at_whatever_it_is_and_never_twice(folder):
    given = in_folders([folder, folder / "team", folder / "no_ending", folder / "team" / ".." / "A.ZIP"])
    assert [path.name for path in given.paths] == ["A.ZIP", "b.rar", "team", "no_ending"]
    assert not {"team", "no_ending"} & {Path(other.file).name for other in given.left_out}


def test_one_old_archive_in_a_teams_own_folder_is_named_with_the_program_that_decided(tmp_path):
    (tmp_path / "robot.py").write_text("x = 1\n", encoding="utf-8")
    (tmp_path / "old.zip").write_bytes(b"PK")
    given = in_folders([tmp_path])
    assert given.paths == [tmp_path]
    (other,) = given.left_out
    assert other.file.endswith("old.zip")
    assert "because of robot.py" in other.reason


def test_a_folder_without_anything_to_check_is_a_submission_and_what_looks_like_one_is_named(tmp_path):
    (tmp_path / ".hidden.zip").write_bytes(b"PK")
    given = in_folders([tmp_path])
    assert given.paths == [tmp_path]
    assert [Path(other.file).name for other in given.left_out] == [".hidden.zip"]


def test_submissions_of_the_same_file_name_are_told_apart_by_their_folders():
    names = [one.name for one in called([Path("/x/a/team.zip"), Path("/x/b/team.zip"), Path("/x/b/other.zip")])]
    assert names == ["a/team.zip", "b/team.zip", "other.zip"]
    deep = called([Path("/x/a/sub/team.zip"), Path("/x/b/sub/team.zip")])
    assert [one.name for one in deep] == ["a/sub/team.zip", "b/sub/team.zip"]


def test_no_two_submissions_have_the_same_name_or_the_same_pages():
    long = "y" * 250
    paths = [
        "a/team.zip",
        "b/team.zip",
        "team.zip",
        "c/team",
        "d/TEAM.zip",
        "e/ü.zip",
        f"{long}1{long}",
        f"{long}2{long}",
    ]
    found = called([Path("/x", path) for path in paths])
    assert len({one.name for one in found}) == len(paths)
    assert len({one.slug.casefold() for one in found}) == len(paths)


def test_a_single_submission_is_called_as_its_file_is(tmp_path, monkeypatch):
    with zipfile.ZipFile(tmp_path / "team.zip", "w") as archive:
        archive.writestr("robot.py", "")
    (tmp_path / "link.zip").symlink_to("team.zip")
    assert [(one.name, one.slug) for one in called([tmp_path / "team.zip"])] == [("team.zip", "team")]
    assert called([tmp_path / "link.zip"])[0].name == "link.zip"
    monkeypatch.chdir(tmp_path)
    assert called([Path()])[0].name == tmp_path.name
