"""Repairing a submission: everything mechanical, nothing of a program, the same bytes each time."""

from __future__ import annotations

import io
import sys
import zipfile
from collections import Counter
from functools import cache
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rcj_challenges.checker import repair as repairing
from rcj_challenges.checker.archives import Inspection, inspect
from rcj_challenges.checker.repair import Repaired, repair
from rcj_challenges.core.errors import RcjError
from rcj_challenges.core.files import write_new
from rcj_challenges.scenario.load import load
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.submissions.team import open_team
from tests.hostile.archives import pictures
from tests.hostile.archives.building import Member, pack, with_folders
from tests.hostile.archives.cases import ALL, FINE, built
from tests.hostile.archives.making import ENTRY, NAME, OF_2021, PROGRAM, SOUND, below, named, plain

MENDED = [name for name, case in ALL.items() if case.repair]
BEYOND = [name for name, case in ALL.items() if not case.repair and case.level == "error"]
# The standard library gives up on these, or reads fewer entries.
UNREADABLE_ELSEWHERE = ("name_in_no_encoding", "count_of_entries_is_wrong", "name_with_a_null")


@cache
def scenario(name: str = "match") -> Scenario:
    return load(name).scenario


def repaired(folder: Path, data: bytes, name: str = "match") -> tuple[Repaired, Path]:
    path, out = folder / "team.zip", folder / "out" / "team.zip"
    path.write_bytes(data)
    out.parent.mkdir(exist_ok=True)
    out.unlink(missing_ok=True)
    result = repair(path, out, scenario(name))
    assert path.read_bytes() == data
    assert result.out == (out if out.exists() else None)
    assert [file.name for file in out.parent.iterdir()] in ([], ["team.zip"])
    return result, out


def contents(data: bytes | Path) -> dict[str, bytes]:
    with zipfile.ZipFile(io.BytesIO(data) if isinstance(data, bytes) else data) as archive:
        assert archive.testzip() is None
        return {name: archive.read(name) for name in archive.namelist() if not name.endswith("/")}


def programs(files: dict[str, bytes]) -> Counter[bytes]:
    """Return the programs' bytes; empty files are no programs."""
    return Counter(data for name, data in files.items() if name.endswith(".py") and data.strip())


def codes(inspection: Inspection, *levels: str) -> set[str]:
    return {finding.code for stage in inspection.stages for finding in stage.findings if finding.level in levels}


@pytest.mark.parametrize("name", MENDED)
def test_a_mechanical_defect_is_put_right(tmp_path: Path, name: str) -> None:
    case = ALL[name]
    data = built(name)
    result, out = repaired(tmp_path, data, case.scenario)
    after = inspect(out, scenario(case.scenario))
    assert case.code not in codes(after, "passed", "warning", "error")
    assert codes(after, "error") == set()
    assert after.team is not None
    assert result.done
    assert result.left == []
    assert all(line.isprintable() for line in result.done)
    if name not in UNREADABLE_ELSEWHERE:
        assert programs(contents(out)) == programs(contents(data))


@pytest.mark.parametrize("name", BEYOND)
def test_defects_that_need_a_decision_are_listed(tmp_path: Path, name: str) -> None:
    case = ALL[name]
    result, out = repaired(tmp_path, built(name), case.scenario)
    assert result.left
    assert all(line.isprintable() for line in result.left)
    if case.code.startswith("archive."):
        assert result.out is None
    else:
        assert case.code in codes(inspect(out, scenario(case.scenario)), "error")


@pytest.mark.parametrize("name", FINE)
def test_a_sound_archive_is_left_as_it_is(tmp_path: Path, name: str) -> None:
    data = FINE[name]()
    result, out = repaired(tmp_path, data)
    assert (result.done, result.left) == ([], [])
    (tmp_path / "before.zip").write_bytes(data)
    seats = scenario().entrants.values()
    before = open_team(tmp_path / "before.zip", *seats)
    assert {str(path): content for path, content in before.files.items()} == contents(out)
    assert open_team(out, *seats).digest == before.digest


def test_what_was_done_is_listed(tmp_path: Path) -> None:
    files = {
        "My Team/robots/rcj_soccer_team_blue.py": PROGRAM,
        "My Team/teamname.txt": b"\xef\xbb\xbfRobo Cats, the very best of all teams",
        "My Team/logo.png": b"no picture",
        "__MACOSX/._x": b"\0",
    }
    result, out = repaired(tmp_path, plain(files))
    assert result.done == [
        "left out what is none of the team's work (of the system, of editors, records of runs)",
        "renamed the folder My Team/robots to rcj_soccer_team_blue",
        "took everything out of the extra folder My Team",
        "took the team's name from teamname.txt to team_name.txt",
        "rewrote team_name.txt: Robo Cats, the very best of all",
        "left out logo.png: it is not a known kind of picture",
    ]
    assert contents(out) == {ENTRY: PROGRAM, "team_name.txt": b"Robo Cats, the very best of all\n"}


def test_unsafe_names_find_their_place(tmp_path: Path) -> None:
    names = [
        "../../etc/passwd",
        "/abs/a.txt",
        "C:\\b\\c.txt",
        "aux",
        "nul.txt",
        "a?b*.txt",
        "e. ",
        "x\x1b.txt",
        "Ж" * 300,
    ]
    _, out = repaired(tmp_path, pack([*with_folders(SOUND), *(Member(name, b"1") for name in names)]))
    more = sorted(contents(out).keys() - SOUND.keys())
    assert more == sorted(
        ["etc/passwd", "abs/a.txt", "b/c.txt", "_aux", "_nul.txt", "a_b_.txt", "e", "x_.txt", "Ж" * 127]
    )


def numbered(name: str, program: bytes = PROGRAM) -> dict[str, bytes]:
    return {f"{name}{number}/{name}{number}.py": program + b"# %d" % number for number in (1, 2, 3)}


def test_numbered_programs_in_folders_of_their_own_names_are_those_that_are_asked_for(tmp_path: Path) -> None:
    files = {"team_name.txt": b"Cats", "rcj_soccer_player_b1/utils.py": b"x = 1", **numbered("rcj_soccer_player_b")}
    result, out = repaired(tmp_path, plain(files))
    assert result.left == []
    assert contents(out) == {"team_name.txt": b"Cats", "robot1/utils.py": b"x = 1", **numbered("robot")}


def test_two_unsafe_names_for_one_place_need_a_decision(tmp_path: Path) -> None:
    data = pack([*with_folders(SOUND), Member("a?.txt", b"1"), Member("A*.txt", b"2")])
    result, _ = repaired(tmp_path, data)
    assert result.out is None
    assert result.left == ["'A*.txt' would lie where another file is: rename one"]


def test_an_archive_that_still_fails_after_its_repair_is_not_written(tmp_path: Path) -> None:
    folder = next(name for name in SOUND if "/" in name).split("/")[0]
    data = pack([*with_folders(SOUND), Member(f"{folder}.", b"a file where a folder is")])
    result, _ = repaired(tmp_path, data)
    assert result.out is None
    assert result.left
    assert [path.name for path in tmp_path.rglob("*.zip")] == ["team.zip"]


def test_a_folder_is_packed(tmp_path: Path) -> None:
    for name, content in below("team", SOUND).items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_bytes(content)
    result = repair(tmp_path / "team", tmp_path / "out.zip", scenario())
    assert result.done == ["packed the folder as a ZIP archive"]
    assert contents(tmp_path / "out.zip") == SOUND


def test_a_single_program_is_packed_where_it_is_asked_for(tmp_path: Path) -> None:
    (tmp_path / "my_bot.py").write_bytes(PROGRAM)
    result = repair(tmp_path / "my_bot.py", tmp_path / "out.zip", scenario())
    assert result.done == [
        f"packed the program as {ENTRY}",
        "wrote team_name.txt: my_bot, as the team is called by its file's name",
    ]
    assert contents(tmp_path / "out.zip") == {ENTRY: PROGRAM, "team_name.txt": b"my_bot\n"}
    assert result.left == []


def test_nothing_is_ever_overwritten(tmp_path: Path) -> None:
    (tmp_path / "team.zip").write_bytes(plain(SOUND))
    (tmp_path / "out.zip").write_bytes(b"mine")
    for out in ("team.zip", "out.zip", "."):
        with pytest.raises(RcjError, match="exists already"):
            repair(tmp_path / "team.zip", tmp_path / out, scenario())
    assert (tmp_path / "out.zip").read_bytes() == b"mine"
    assert (tmp_path / "team.zip").read_bytes() == plain(SOUND)


def test_a_file_that_appears_meanwhile_is_not_overwritten(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "team.zip").write_bytes(plain(SOUND))
    out = tmp_path / "out.zip"

    zipped = repairing._zipped
    monkeypatch.setattr(repairing, "_zipped", lambda files: out.write_bytes(b"mine") and zipped(files))
    with pytest.raises(RcjError, match="exists already"):
        repair(tmp_path / "team.zip", out, scenario())
    assert out.read_bytes() == b"mine"
    assert sorted(path.name for path in tmp_path.iterdir()) == ["out.zip", "team.zip"]


def test_an_interrupted_repair_leaves_no_file(tmp_path: Path) -> None:
    class Interrupts:
        def __buffer__(self, flags: int) -> memoryview:
            raise KeyboardInterrupt

    with pytest.raises((KeyboardInterrupt, TypeError)):  # before Python 3.12 it is no buffer
        write_new(tmp_path / "out.zip", Interrupts())  # type: ignore[arg-type]
    assert not (tmp_path / "out.zip").exists()


def test_a_logo_of_another_kind_becomes_a_png(tmp_path: Path) -> None:
    pytest.importorskip("PIL")
    kinds = {"jpeg": pictures.jpeg(2600, 1300), "bmp": pictures.bmp(), "gif": pictures.gif()}
    for kind, data in kinds.items():
        _, out = repaired(tmp_path, plain(SOUND | {"logo.png": data}))
        logo = inspect(out, scenario()).logo
        assert logo is not None, kind
        assert int.from_bytes(logo[16:20], "big") == {"jpeg": 1024, "bmp": 4, "gif": 1}[kind]


def test_without_pillow_such_a_logo_is_left_out_with_a_note(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "PIL", None)
    result, out = repaired(tmp_path, plain(SOUND | {"logo.png": pictures.gif()}))
    assert result.done == [
        'left out logo.png: converting it needs the extra [images]: pip install "rcj-challenges[images]"'
    ]
    assert contents(out) == SOUND


@pytest.mark.parametrize("frame", [(5000, 5000), (65_535, 65_535)])
def test_a_gif_with_a_frame_larger_than_declared_is_not_unpacked(tmp_path: Path, frame: tuple[int, int]) -> None:
    pytest.importorskip("PIL")
    result, out = repaired(tmp_path, plain(SOUND | {"logo.png": pictures.gif(frame)}))
    assert len(result.done) == 1
    assert result.done[0].startswith("left out logo.png: it is ")
    assert contents(out) == SOUND


def test_nothing_of_this_computer_or_this_moment_is_in_the_archive(tmp_path: Path) -> None:
    _, out = repaired(tmp_path, plain(SOUND))
    first = out.read_bytes()
    with zipfile.ZipFile(out) as archive:
        assert {entry.date_time for entry in archive.infolist()} == {(1980, 1, 1, 0, 0, 0)}
        assert {entry.create_system for entry in archive.infolist()} == {3}
        assert archive.namelist() == sorted(archive.namelist())
    reordered = pack(reversed(with_folders(SOUND)))
    _, out = repaired(tmp_path, reordered)
    assert out.read_bytes() == first


DEFECTS = {
    "top folder": lambda files: below("Our Team", files),
    "two top folders": lambda files: below("a/b", files),
    "leftovers": lambda files: files | {"__MACOSX/._x": b"\0", ".DS_Store": b"1"},
    "name file": lambda files: {n.replace("team_name.txt", "Team-Name.txt"): data for n, data in files.items()},
    "mark": lambda files: {n: b"\xef\xbb\xbf" + data if "ame.txt" in n else data for n, data in files.items()},
    "long name": lambda files: {n: data * 9 if "ame.txt" in n else data for n, data in files.items()},
    "entry folder": lambda files: {n.replace("rcj_soccer_team_blue/", "soccer/"): data for n, data in files.items()},
    "empty entry": lambda files: files | {"rcj_soccer_team_yellow/rcj_soccer_team_yellow.py": b""},
    "logo": lambda files: files | {"logo.png": pictures.jpeg_head()},
    "unsafe name": lambda files: files | {"notes: final?.txt": b"1"},
}


DEFECTIVE = given(
    st.sampled_from([SOUND, OF_2021, {"robot.py": PROGRAM} | NAME]),
    st.lists(st.sampled_from(sorted(DEFECTS)), unique=True),
    st.booleans(),
)


@DEFECTIVE
def test_any_combination_of_defects_is_put_right_once_and_for_all(
    tmp_path: Path, files: dict[str, bytes], defects: list[str], folders: bool
) -> None:
    for defect in defects:
        files = DEFECTS[defect](files)
    members = with_folders(files) if folders else [Member(name, content) for name, content in files.items()]
    result, out = repaired(tmp_path, pack(members))
    assert programs(contents(out)) == programs(files)
    assert codes(inspect(out, scenario()), "error") == set(), (defects, result)
    first = out.read_bytes()
    again, out = repaired(tmp_path, first)
    assert again.done == []
    assert out.read_bytes() == first


def test_the_name_that_is_kept_is_the_one_that_was_shown(tmp_path: Path) -> None:
    data = named("\u202e<b>Évil</b>\x1b[2J \n and more".encode())
    (tmp_path / "team.zip").write_bytes(data)
    before = inspect(tmp_path / "team.zip", scenario()).opening.name.text
    _, out = repaired(tmp_path, data)
    assert inspect(out, scenario()).opening.name.text == before
    assert contents(out)["team_name.txt"].decode() == f"{before}\n"


@pytest.mark.parametrize("name", [None, b"", b"\n\n"])
def test_a_team_that_is_called_by_its_file_s_name_keeps_it_in_a_file_called_otherwise(
    tmp_path: Path, name: bytes | None
) -> None:
    files = {path: content for path, content in SOUND.items() if path != "team_name.txt"}
    (tmp_path / "hanse 22.zip").write_bytes(plain(files if name is None else files | {"team_name.txt": name}))
    result = repair(tmp_path / "hanse 22.zip", tmp_path / "hanse_fixed.zip", scenario())
    assert result.done == ["wrote team_name.txt: hanse 22, as the team is called by its file's name"]
    assert result.left == []
    assert contents(tmp_path / "hanse_fixed.zip") == files | {"team_name.txt": b"hanse 22\n"}


def test_a_name_in_a_document_is_left_to_the_team(tmp_path: Path) -> None:
    files = {path: content for path, content in SOUND.items() if path != "team_name.txt"} | {"team_name.docx": b"PK"}
    (tmp_path / "hanse.zip").write_bytes(plain(files))
    result = repair(tmp_path / "hanse.zip", tmp_path / "hanse_fixed.zip", scenario())
    assert result.done == []
    assert "save the name as plain text in team_name.txt" in result.left[0]
    assert contents(tmp_path / "hanse_fixed.zip") == files
