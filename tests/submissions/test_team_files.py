"""Opening what a team hands in: a folder, a ZIP, a file; sound, odd or hostile."""

from __future__ import annotations

import errno
import io
import os
import sys
import unicodedata
import zipfile
from collections.abc import Callable
from pathlib import Path, PurePosixPath
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rcj_challenges.scenario.models.robots import Entrant
from rcj_challenges.submissions import archive
from rcj_challenges.submissions.team import TeamError, missing_programs, open_team
from rcj_challenges.submissions.team_name import safe_name

ENTRY = "rcj_soccer_team_blue/rcj_soccer_team_blue.py"
BLUE = Entrant(
    robots={f"B{n}": (ENTRY, f"robot{n}/robot{n}.py", "robot.py") for n in (1, 2, 3)},
)
YELLOW = Entrant(robots={f"Y{n}": (ENTRY, f"robot{n}/robot{n}.py", "robot.py") for n in (1, 2, 3)})
PRESENT = {ENTRY: b"present", "rcj_soccer_team_blue/utils.py": b"utils", "team_name.txt": b"Phase Moon"}
OF_2021 = {f"robot{n}/robot{n}.py": b"%d" % n for n in (1, 2, 3)} | {"team_name.txt": b"Old"}


def folder_of(root: Path, files: dict[str, bytes]) -> Path:
    for name, content in files.items():
        path = root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)
    return root


def zip_of(path: Path, files: dict[str, bytes]) -> Path:
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as file:
        for name, content in files.items():
            file.writestr(name, content)
    return path


def inside(prefix: str, files: dict[str, bytes]) -> dict[str, bytes]:
    return {f"{prefix}/{name}": content for name, content in files.items()}


@pytest.mark.parametrize("files", [PRESENT, OF_2021, {"robot.py": b"r", "team_name.txt": b"R"}])
def test_a_folder_and_its_zip_are_the_same_team(tmp_path: Path, files: dict[str, bytes]) -> None:
    from_folder = open_team(folder_of(tmp_path / "team", files), BLUE, YELLOW)
    from_zip = open_team(zip_of(tmp_path / "team.zip", files), BLUE, YELLOW)
    assert from_folder.digest == from_zip.digest
    assert from_folder.name == from_zip.name == files["team_name.txt"].decode()
    assert [from_zip.entries[robot] for robot in BLUE.robots] == [from_folder.entries[robot] for robot in BLUE.robots]
    (tmp_path / "copy").mkdir()
    from_zip.unpack(tmp_path / "copy")
    assert (tmp_path / "copy" / from_zip.entries["Y2"]).read_bytes() == files[from_zip.entries["Y2"]]


def test_records_of_runs_that_lie_in_a_folder_or_zip_are_no_part_of_it(tmp_path: Path) -> None:
    record = inside("runs/20210618-001159-match", {"result.json": b"{}", "logs/Y1.log": b"", "trajectory.chunks": b""})
    with_record = open_team(folder_of(tmp_path / "played", PRESENT | record), BLUE)
    without = open_team(folder_of(tmp_path / "team", PRESENT), BLUE)
    packed = open_team(zip_of(tmp_path / "team.zip", inside("team", PRESENT | record)), BLUE)
    assert with_record.digest == without.digest == packed.digest
    problems = archive.read_contents(tmp_path / "team.zip").problems
    (reported,) = [problem for problem in problems if problem.code == "archive.leftovers"]
    assert "runs/20210618-001159-match" in reported.message


def test_the_record_of_a_run_that_was_killed_before_its_first_tick_is_no_part_of_a_zip_either(tmp_path: Path) -> None:
    """Its folders are there already, and no log is in them yet."""
    record = inside("team/runs/20210618-001159-match", {"result.json": b"{}", "logs/": b"", "trajectory.chunks": b""})
    packed = open_team(zip_of(tmp_path / "team.zip", inside("team", PRESENT) | record), BLUE)
    assert packed.digest == open_team(folder_of(tmp_path / "team", PRESENT), BLUE).digest


@pytest.mark.parametrize(
    ("beside", "names"),
    [
        ("rcj_soccer_team_blue", ("trajectory.chunks", "plan.json")),
        ("rcj_soccer_team_blue", ("logs/of_us.txt",)),
        ("rcj_soccer_team_blue", ("trajectory.chunks", "logs/a.txt")),
        ("rcj_soccer_team_blue/data", ("trajectory.chunks", "plan.json")),
        ("rcj_soccer_team_blue/data", ("logs/of_us.txt",)),
    ],
)
def test_what_only_looks_like_a_record_stays(tmp_path: Path, beside: str, names: tuple[str, ...]) -> None:
    """A program's own folder, or one of data."""
    files = PRESENT | inside(beside, dict.fromkeys(names, b"ours"))
    for team in (folder_of(tmp_path / "team", files), zip_of(tmp_path / "team.zip", files)):
        copy = folder_of(tmp_path / f"copy of {team.name}", {"x": b""})
        open_team(team, BLUE).unpack(copy)
        assert all((copy / beside / name).read_bytes() == b"ours" for name in names)


@pytest.mark.parametrize("around", ["", "team"])
def test_no_program_is_lost_with_what_lies_around_it_like_a_record(tmp_path: Path, around: str) -> None:
    files = PRESENT | {"logs/own.txt": b"", "trajectory.chunks": b""}
    for team in (
        folder_of(tmp_path / "folder", inside(around, files) if around else files),
        zip_of(tmp_path / "team.zip", inside(around, files) if around else files),
    ):
        assert open_team(team, BLUE).entries["B1"] == ENTRY


def test_the_first_entry_point_that_exists_is_taken(tmp_path: Path) -> None:
    assert open_team(folder_of(tmp_path, OF_2021), BLUE).entries["B2"] == "robot2/robot2.py"
    assert open_team(folder_of(tmp_path, PRESENT), BLUE).entries["B2"] == ENTRY


@pytest.mark.parametrize("prefix", ["My Team", "a/b", "team-x/submission"])
def test_extra_top_folders_are_looked_through(tmp_path: Path, prefix: str) -> None:
    junk = {"__MACOSX/x/._robot.py": b"\0", ".DS_Store": b"\0"}
    team = open_team(zip_of(tmp_path / "t.zip", inside(prefix, PRESENT) | junk), BLUE)
    assert team.entries["B1"] == ENTRY
    assert team.name == "Phase Moon"
    assert team.digest == open_team(folder_of(tmp_path / "plain", PRESENT), BLUE).digest


def test_the_programs_own_folder_will_do_whatever_it_is_called(tmp_path: Path) -> None:
    files = {"rcj_soccer_team_blue.py": b"x", "utils.py": b"u"}
    team = open_team(folder_of(tmp_path / "robots", files), BLUE)
    assert team.entries["B1"] == ENTRY
    (tmp_path / "copy").mkdir()
    team.unpack(tmp_path / "copy")
    assert (tmp_path / "copy" / "rcj_soccer_team_blue" / "utils.py").read_bytes() == b"u"


@pytest.mark.parametrize(("given", "entry"), [("my_bot.py", "my_bot.py"), ("ROBOT.PY", "ROBOT.py")])
def test_a_single_file_drives_all_robots(tmp_path: Path, given: str, entry: str) -> None:
    (tmp_path / given).write_bytes(b"x")
    team = open_team(tmp_path / given, BLUE, YELLOW)
    assert {team.entries[robot] for robot in (*BLUE.robots, *YELLOW.robots)} == {entry}
    assert team.name == given[:-3]


def test_what_tools_leave_behind_is_ignored(tmp_path: Path) -> None:
    junk = {
        ".git/config": b"g",
        "rcj_soccer_team_blue/__pycache__/utils.cpython-311.pyc": b"p",
        "rcj_soccer_team_blue/.DS_Store": b"d",
        "Icon\r": b"i",
    }
    if sys.platform == "win32":
        del junk["Icon\r"]
    plain = open_team(folder_of(tmp_path / "plain", PRESENT), BLUE)
    assert open_team(folder_of(tmp_path / "junk", PRESENT | junk), BLUE).digest == plain.digest


def test_any_change_of_a_name_or_a_byte_changes_the_digest(tmp_path: Path) -> None:
    digests = {
        open_team(folder_of(tmp_path / str(number), files), BLUE).digest
        for number, files in enumerate(
            [PRESENT, PRESENT | {ENTRY: b"changed"}, PRESENT | {"x": b""}, PRESENT | {"y": b""}]
        )
    }
    assert len(digests) == 4


def test_the_file_of_designs_is_not_taken_for_a_program() -> None:
    files = {PurePosixPath("robot.yaml"): b""}
    assert "did you mean" not in missing_programs(files, {"B1": ("robot.py",)})


def test_a_missing_program_is_reported_with_what_was_looked_for_what_is_there_and_the_nearest(tmp_path: Path) -> None:
    with pytest.raises(TeamError) as caught:
        open_team(folder_of(tmp_path, {"rcj_soccer_team_blue/rcj_soccer_team_bleu.py": b"x"}), BLUE)
    reported = str(caught.value)
    assert "B1: looked for rcj_soccer_team_blue/rcj_soccer_team_blue.py or robot1/robot1.py or robot.py" in reported
    assert "found: rcj_soccer_team_blue/rcj_soccer_team_bleu.py" in reported
    assert f"did you mean rcj_soccer_team_blue/rcj_soccer_team_bleu.py to be {ENTRY}?" in reported
    assert "\n" not in reported


def test_a_program_of_another_number_is_not_suggested() -> None:
    """Whoever forgot the program itself has three others left, and none of them is another one misspelled."""
    missing = {"B1": ("rcj_soccer_team_blue/rcj_soccer_team_blue.py", "robot1/robot1.py", "robot.py")}
    files = {PurePosixPath(f"rcj_soccer_team_blue/robot{number}.py"): b"1" for number in (2, 3)}
    assert "did you mean" not in missing_programs(files, missing)
    files[PurePosixPath("rcj_soccer_team_blue/robot1.py")] = b"1"
    assert missing_programs(files, missing).endswith(
        "did you mean rcj_soccer_team_blue/robot1.py to be robot1/robot1.py?"
    )


def test_one_of_three_programs_missing_is_reported_for_that_robot_only(tmp_path: Path) -> None:
    files = {name: content for name, content in OF_2021.items() if name != "robot2/robot2.py"}
    with pytest.raises(TeamError, match=r"no program for B2: looked for") as caught:
        open_team(folder_of(tmp_path, files), BLUE)
    assert "B1:" not in str(caught.value)


@pytest.mark.parametrize(
    ("content", "name", "notes"),
    [
        (b"Phase Moon\r\n", "Phase Moon", 0),
        (b"\xef\xbb\xbfBOM Team", "BOM Team", 0),
        ("Öko ⚽".encode(), "Öko ⚽", 0),
        (b'"Quotes"; a.b!', '"Quotes"; a.b!', 0),
        (b"x" * 40, "x" * 32, 1),
        (b"  \n\n", "team", 1),
        (b"a\x1b[31m\x07b", "a [31m b", 1),
        ("left\u202eright".encode(), "left right", 1),
        (b"\xff\xfe", "team", 1),
        ("Größenwahn".encode("cp1252"), "Größenwahn", 1),
        ("„Équipe“ · €5".encode("cp1252"), "„Équipe“ · €5", 1),
        ("Größenwahn".encode("utf-16"), "Größenwahn", 0),
        ("Größenwahn\r\n".encode("utf-16")[:-1], "Größenwahn", 0),
        ("Gr\udcffßenwahn ⚽".encode("utf-8", "surrogateescape"), "Gr�ßenwahn ⚽", 1),  # UTF-8 with one bad byte
        (b"Team \x8f\x90", "Team ��", 1),  # two of the five that Windows-1252 has not
        (("⚽\n" * 30_000).encode(), "⚽", 1),  # more than is read, which ends within a letter
    ],
)
def test_a_team_has_a_name_that_can_be_shown(tmp_path: Path, content: bytes, name: str, notes: int) -> None:
    team = open_team(folder_of(tmp_path / "team", PRESENT | {"team_name.txt": content}), BLUE)
    assert (team.name, len(team.notes)) == (name, notes)


def test_without_a_name_file_the_name_is_the_archives(tmp_path: Path) -> None:
    team = open_team(zip_of(tmp_path / "Robo Cats.zip", {ENTRY: b"x"}), BLUE)
    assert team.name == "Robo Cats"
    assert "team_name.txt" in team.notes[0]


@pytest.mark.parametrize("form", ["NFC", "NFD"])
def test_a_name_with_accents_has_as_many_letters_as_one_sees(tmp_path: Path, form: str) -> None:
    """Some programs take letters apart (o and ¨), and so does macOS in the names of files."""
    name = "Ü" * 32
    own = {"team_name.txt": unicodedata.normalize(form, name).encode(), ENTRY: b"x"}
    team = open_team(zip_of(tmp_path / "team.zip", own), BLUE)
    assert (team.name, team.notes) == (name, ())
    nameless = open_team(zip_of(tmp_path / f"{unicodedata.normalize(form, name)}.zip", {ENTRY: b"x"}), BLUE)
    assert nameless.name == name


@given(st.text(max_size=60))
def test_a_name_is_one_printable_line_of_at_most_32_letters(text: str) -> None:
    name = safe_name(text)
    assert len(name) <= 32
    assert len(name.splitlines()) <= 1
    assert all(letter.isprintable() or letter == "\u200d" or letter.isspace() for letter in name)
    assert safe_name(name) == name


def refusal(path: Path) -> str:
    with pytest.raises(TeamError) as caught:
        open_team(path, BLUE)
    assert "\n" not in str(caught.value)
    return "; ".join(filter(None, (str(caught.value), caught.value.help)))


def test_a_path_that_does_not_exist_is_reported(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    assert refusal(tmp_path / "nothing").endswith("nothing: there is no such file or folder")
    with monkeypatch.context() as windows:
        windows.setattr(os, "sep", "\\")
        assert refusal(tmp_path / 'my team" --blue x').endswith("file or folder; remove the backslash at its end")
    (tmp_path / "empty").mkdir()
    assert "there are no files in it" in refusal(tmp_path / "empty")


@pytest.mark.parametrize("unread", [".", "robots", "robots/robot1.py"])
def test_an_unreadable_file_in_a_folder_is_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, unread: str) -> None:
    folder = tmp_path / "team"
    (folder / "robots").mkdir(parents=True)
    (folder / "robots" / "robot1.py").write_bytes(b"x")
    (folder / "robot1.py").write_bytes(b"x")
    where = str(folder / unread)

    def refuses(what: Callable[..., Any]) -> Callable[..., Any]:
        def asked(path: Any, *rest: Any, **named: Any) -> Any:
            if str(path) == where:
                raise PermissionError(errno.EACCES, "Permission denied", where)
            return what(path, *rest, **named)

        return asked

    for holder, name in ((os, "scandir"), (Path, "read_bytes")):
        monkeypatch.setattr(holder, name, refuses(getattr(holder, name)))
    said = refusal(folder)
    assert said.endswith("cannot be read: Permission denied")
    assert Path(where).name in said
    assert "no files" not in said


@pytest.mark.skipif(sys.platform == "win32", reason="links need a privilege on Windows")
def test_links_that_lead_out_of_a_folder_are_refused_and_others_followed(tmp_path: Path) -> None:
    folder = folder_of(tmp_path / "team", PRESENT)
    (folder / "again.py").symlink_to(folder / "rcj_soccer_team_blue" / "utils.py")
    assert open_team(folder, BLUE).files[PurePosixPath("again.py")] == PRESENT["rcj_soccer_team_blue/utils.py"]
    (tmp_path / "outside.txt").write_bytes(b"secret")
    (folder / "secret.txt").symlink_to(tmp_path / "outside.txt")
    assert "secret.txt is a link that leads out of the folder" in refusal(folder)


def test_a_zip_bomb_is_stopped_by_what_comes_out_of_it(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(archive, "MAX_UNPACKED_BYTES", 1_000_000)
    path = zip_of(tmp_path / "t.zip", PRESENT | {"zeros": bytes(3_000_000)})
    assert path.stat().st_size < 10_000
    assert "unpacked, it is more than 1 MB" in refusal(path)


def test_too_large_an_archive_too_many_files_and_colliding_names_are_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert "are one file on some computers" in refusal(zip_of(tmp_path / "c.zip", PRESENT | {"A.py": b"", "a.PY": b""}))
    monkeypatch.setattr(archive, "MAX_FILES", 2)
    assert "more than 2 files" in refusal(zip_of(tmp_path / "n.zip", PRESENT))
    assert "is this the folder of the robot programs?" in refusal(folder_of(tmp_path / "n", PRESENT))
    monkeypatch.setattr(archive, "MAX_PACKED_BYTES", 100)
    assert "is more than the" in refusal(zip_of(tmp_path / "l.zip", PRESENT))


SOUND = io.BytesIO()
with zipfile.ZipFile(SOUND, "w", zipfile.ZIP_DEFLATED) as _file:
    for _name, _content in PRESENT.items():
        _file.writestr(_name, _content * 10)


@given(st.data())
def test_a_damaged_archive_gives_a_team_or_a_message_never_more(tmp_path: Path, data: st.DataObject) -> None:
    content = bytearray(SOUND.getvalue())
    for _ in range(data.draw(st.integers(1, 6))):
        content[data.draw(st.integers(0, len(content) - 1))] = data.draw(st.integers(0, 255))
    content = content[: data.draw(st.sampled_from([len(content), len(content) - 30, len(content) // 2]))]
    (tmp_path / "t.zip").write_bytes(content)
    try:
        open_team(tmp_path / "t.zip", BLUE)
    except TeamError as error:
        assert str(error).startswith(str(tmp_path))  # noqa: PT017 - the property is about every error


@pytest.mark.parametrize("packed", [True, False], ids=["archive", "folder"])
def test_letters_that_a_mac_takes_apart_are_put_together(tmp_path: Path, packed: bool) -> None:
    """Python composes the names that it imports; macOS does not care, and every other system does."""
    apart, whole = (unicodedata.normalize(form, "rcj_soccer_team_blue/größe.py") for form in ("NFD", "NFC"))
    make, name = (zip_of, "team.zip") if packed else (folder_of, "team")
    team = open_team(make(tmp_path / name, PRESENT | {apart: b"x = 1"}), BLUE)
    assert PurePosixPath(whole) in team.files
    assert PurePosixPath(apart) not in team.files


@pytest.mark.skipif(sys.platform == "darwin", reason="there both names are one file")
def test_of_two_files_that_are_one_on_a_mac_the_composed_one_is_read_and_the_other_reported(tmp_path: Path) -> None:
    apart, whole = (unicodedata.normalize(form, "größe.py") for form in ("NFD", "NFC"))
    folder = folder_of(tmp_path / "team", {"robot.py": b"x = 1", apart: b"x = 2", whole: b"x = 3"})
    contents = archive.read_contents(folder)
    assert contents.files[PurePosixPath(whole)] == b"x = 3"
    (problem,) = [problem for problem in contents.problems if problem.code == "archive.collision"]
    assert problem.level == "warning"
    assert "größe.py" in problem.message
