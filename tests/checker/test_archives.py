"""What a check says of an archive, of its layout, and of the team's name and logo."""

from __future__ import annotations

import subprocess
import sys
import time
import tracemalloc
import unicodedata
import zlib
from functools import cache
from pathlib import Path, PurePosixPath

import pytest

from rcj_challenges.checker.archives import Inspection, inspect
from rcj_challenges.checker.check import CheckOptions, check_file
from rcj_challenges.checker.images import Picture, identify
from rcj_challenges.core.code import Code
from rcj_challenges.core.diagnostics import Diagnostic
from rcj_challenges.scenario.load import load, load_text
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.submissions.team import TeamError, open_team
from tests.hostile.archives import pictures
from tests.hostile.archives.building import Member, pack, with_folders
from tests.hostile.archives.case import Case
from tests.hostile.archives.cases import ALL, FINE, IMPORTS, SEEN, built
from tests.hostile.archives.large import SOURCES
from tests.hostile.archives.making import ENTRY, NAME, OF_2021, PROGRAM, SOUND, named, plain

loaded = cache(load)


def scenario(name: str = "match") -> Scenario:
    return loaded(name).scenario


def inspected(folder: Path, data: bytes, name: str = "match") -> Inspection:
    path = folder / "team.zip"
    path.write_bytes(data)
    return inspect(path, scenario(name))


def findings(inspection: Inspection) -> list[Diagnostic]:
    return [finding for stage in inspection.stages for finding in stage.findings]


def harmless(text: str) -> bool:
    return all(unicodedata.category(letter)[0] != "C" or letter == "\u200d" for letter in text)


@pytest.mark.parametrize("name", ALL)
def test_each_defect_is_named_with_help_and_a_match_refuses_the_same_archives(tmp_path: Path, name: str) -> None:
    case = ALL[name]
    inspection = inspected(tmp_path, built(name), case.scenario)
    found = [finding for finding in findings(inspection) if finding.code == case.code]
    assert found, [finding.code for finding in findings(inspection)]
    assert found[0].level == case.level
    assert any(case.says in finding.message for finding in found), [finding.message for finding in found]
    assert all(finding.repair for finding in found) == case.repair
    assert found[0].help or case.level == "passed"
    assert all(harmless(finding.message + finding.where + finding.help) for finding in findings(inspection))
    assert all(len(finding.message) < 1000 for finding in findings(inspection))
    assert harmless(inspection.opening.name.text)
    try:
        team = open_team(tmp_path / "team.zip", *scenario(case.scenario).entrants.values())
    except TeamError as error:
        assert inspection.team is None
        assert "error" in {finding.level for finding in findings(inspection)}
        assert harmless(str(error))  # noqa: PT017 - what is refused is refused in words
    else:
        assert inspection.team is not None
        assert (inspection.team.digest, inspection.opening.name.text) == (team.digest, team.name)


@pytest.mark.parametrize("case", (SEEN | IMPORTS | SOURCES).values(), ids=SEEN | IMPORTS | SOURCES)
def test_the_whole_check_names_each_defect_of_real_submissions(tmp_path: Path, case: Case) -> None:
    path = tmp_path / "team.zip"
    path.write_bytes(case.build())
    report = check_file(path, loaded(case.scenario), CheckOptions(play=False))
    stage = next(stage for stage in report.stages if stage.name == case.code.partition(".")[0])
    found = [finding for finding in stage.findings if finding.code == case.code]
    assert [finding.level for finding in found] == [case.level] * max(1, len(found))
    assert any(case.says in finding.message for finding in found), [finding.message for finding in found]
    assert {finding.repair for finding in found} == {case.repair}
    assert all(finding.help for finding in found) or case.level == "passed"
    assert case.level != "error" or report.level == "error"


@pytest.mark.parametrize("build", FINE.values(), ids=FINE)
def test_a_flawless_archive_passes_without_advice(tmp_path: Path, build) -> None:
    inspection = inspected(tmp_path, build())
    assert [stage.name for stage in inspection.stages] == ["archive", "layout", "identity"]
    assert {finding.code for finding in findings(inspection) if finding.level != "passed"} == set()
    assert not any(finding.help for finding in findings(inspection))
    assert inspection.team is not None


def test_many_of_one_kind_are_counted(tmp_path: Path) -> None:
    data = pack([*with_folders(SOUND), *(Member(f"{n}?.txt", b"1") for n in range(500))])
    found = [finding for finding in findings(inspected(tmp_path, data)) if finding.code == "archive.name_forbidden"]
    assert len(found) == 11
    assert found[-1].message == "and 490 more of this kind (archive.name_forbidden)"


def test_an_unreadable_archive_skips_later_stages_with_a_note(tmp_path: Path) -> None:
    stages = inspected(tmp_path, plain(SOUND)[:-40]).stages
    assert [stage.skipped for stage in stages] == ["", *["the archive could not be read"] * 2]
    assert [stage.failed for stage in stages] == [True, False, False]


def test_each_robot_is_named_with_its_program(tmp_path: Path) -> None:
    inspection = inspected(tmp_path, plain(OF_2021))
    messages = {finding.message for finding in findings(inspection) if finding.code == "layout.program"}
    assert messages == {f"B{n}, Y{n}: robot{n}/robot{n}.py" for n in (1, 2, 3)}
    assert inspection.team is not None
    assert inspection.team.entries["Y2"] == "robot2/robot2.py"


@pytest.mark.parametrize(
    ("name", "files"),
    [
        ("fast_shooter", {"score_goal/score_goal.py": PROGRAM} | NAME),
        ("precision_lidar", {"score_goal/score_goal.py": PROGRAM} | NAME),
        ("pass_the_ball", {f"pass_ball_{side}/pass_ball_{side}.py": PROGRAM for side in ("blue", "yellow")} | NAME),
    ],
)
def test_a_challenge_asks_for_its_own_programs(tmp_path: Path, name: str, files: dict[str, bytes]) -> None:
    inspection = inspected(tmp_path, plain(files), name)
    assert inspection.team is not None
    assert all(stage.level == "passed" for stage in inspection.stages)


def test_where_teams_keep_their_sides_one_of_them_is_enough(tmp_path: Path) -> None:
    text = """
schema_version: 2
id: sides
title: Sides
extends: soccersim_v2
match: {halves: 1, half_s: 10, swap_sides: false}
entrants:
  blue: {robots: {B1: keeper/keeper.py, B2: null, B3: null}}
  yellow: {robots: {Y1: shooter/shooter.py, Y2: null, Y3: null}}
robots: {B2: null, B3: null, Y2: null, Y3: null}
"""
    path = tmp_path / "team.zip"
    path.write_bytes(plain({"shooter/shooter.py": PROGRAM} | NAME))
    inspection = inspect(path, load_text(text).scenario)
    assert inspection.team is not None
    assert [list(seat.robots) for seat in inspection.seats] == [["Y1"]]


@pytest.mark.parametrize(
    ("content", "name"),
    [
        (b"Phase Moon", "Phase Moon"),
        (b"\xef\xbb\xbfPhase Moon\r\n", "Phase Moon"),
        ("Phase Moon".encode("utf-16"), "Phase Moon"),
        (b"\n\n  Phase   Moon  \n", "Phase Moon"),
        ('«Фаза» "Луна"'.encode(), '«Фаза» "Луна"'),
        ("👩‍🚀 ⚽ 🇨🇿".encode(), "👩‍🚀 ⚽ 🇨🇿"),
        (b"../..\\C:\\con.txt", "../..\\C:\\con.txt"),
        (b"a\x00b\x1b]0;owned\x07c", "a b ]0;owned c"),
        ("\u202emooN esahP".encode(), "mooN esahP"),
        (b"<b>&amp;</b>", "<b>&amp;</b>"),
        ("\u2028one\u2029two".encode(), "one"),
        (b"", "team"),
    ],
)
def test_a_name_is_one_line_and_changes_no_files_place(tmp_path: Path, content: bytes, name: str) -> None:
    inspection = inspected(tmp_path, named(content))
    assert inspection.opening.name.text == name
    assert inspection.team is not None
    copy = tmp_path / "copy"
    copy.mkdir()
    inspection.team.unpack(copy)
    written = {PurePosixPath(path.relative_to(copy).as_posix()) for path in copy.rglob("*") if path.is_file()}
    assert written == {PurePosixPath(ENTRY), PurePosixPath(ENTRY).with_name("utils.py"), PurePosixPath("team_name.txt")}


def test_a_logo_is_shown_without_what_no_picture_needs(tmp_path: Path) -> None:
    comment = pictures.chunk(b"tEXt", b"Comment\0<script>")
    assert inspected(tmp_path, plain(SOUND | {"logo.png": pictures.png(extra=comment)})).logo == pictures.png()
    assert inspected(tmp_path, plain(SOUND | {"logo.png": pictures.gif()})).logo is None
    assert inspected(tmp_path, plain(SOUND)).logo is None


def test_a_folder_is_checked_as_its_archive(tmp_path: Path) -> None:
    for name, content in (SOUND | {"rcj_soccer_team_blue/__pycache__/x.pyc": b"1"}).items():
        path = tmp_path / "team" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)
    from_folder = inspect(tmp_path / "team", scenario())
    assert all(stage.level == "passed" for stage in from_folder.stages)
    assert from_folder.team.digest == inspected(tmp_path, plain(SOUND)).team.digest


def team_folder(folder: Path) -> Path:
    for name, content in SOUND.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)
    return folder


links = pytest.mark.skipif(sys.platform == "win32", reason="links are a privilege on Windows")


@links
def test_a_folder_that_is_a_link_out_of_the_submission_is_refused_by_its_name(tmp_path: Path) -> None:
    team = team_folder(tmp_path / "team")
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine" / "rcj_soccer_team_blue").symlink_to(team / "rcj_soccer_team_blue", target_is_directory=True)
    archive = inspect(tmp_path / "mine", scenario()).stages[0]
    (found,) = archive.findings
    assert (found.code, found.level, found.where) == ("archive.link", "error", "rcj_soccer_team_blue")
    assert found.message == "rcj_soccer_team_blue is a link that leads out of the folder"
    assert found.help == "copy the folder instead"
    with pytest.raises(TeamError, match="rcj_soccer_team_blue is a link that leads out of the folder"):
        open_team(tmp_path / "mine", *scenario().entrants.values())


@links
def test_links_in_a_circle_are_refused_by_their_names(tmp_path: Path) -> None:
    team = team_folder(tmp_path / "team")
    (team / "first").symlink_to("second")
    (team / "second").symlink_to("first")
    archive = inspect(team, scenario()).stages[0]
    assert {(found.code, found.where) for found in archive.findings if found.level == "error"} == {
        ("archive.link", "first"),
        ("archive.link", "second"),
    }


def test_a_path_that_cannot_be_opened_is_the_only_error(tmp_path: Path) -> None:
    with pytest.raises(TeamError, match="there is no such file or folder"):
        inspect(tmp_path / "nothing.zip", scenario())
    with pytest.raises(TeamError, match=r"a\\nb\\x1b: there is no such"):
        inspect(tmp_path / "a\nb\x1b", scenario())


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no such files in folders")
def test_what_is_neither_file_nor_folder_is_not_waited_for(tmp_path: Path) -> None:
    import os

    os.mkfifo(tmp_path / "pipe.zip")
    with pytest.raises(TeamError, match="neither a file nor a folder"):
        inspect(tmp_path / "pipe.zip", scenario())


@pytest.mark.nightly
@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no paths of this length")
def test_a_record_with_folders_too_deep_to_be_searched_is_an_error(tmp_path: Path) -> None:
    import os

    record = tmp_path / "team" / "runs"
    record.mkdir(parents=True)
    (record / "logs").mkdir()
    (record / "trajectory.chunks").touch()
    levels = 1500
    inside = os.open(record, os.O_RDONLY)
    for _ in range(levels):  # longer than a path may be: made step by step
        os.mkdir("d", dir_fd=inside)
        deeper = os.open("d", os.O_RDONLY, dir_fd=inside)
        os.close(inside)
        inside = deeper
    os.close(inside)
    try:
        with pytest.raises(TeamError, match="cannot be read"):
            inspect(tmp_path / "team", scenario())
    finally:
        subprocess.run(["rm", "-rf", str(record)], check=True)  # pytest's own clearing is recursive


@pytest.mark.parametrize(
    "name", ["bomb_of_zeros", "bomb_in_many_files", "bomb_that_claims_to_be_small", "hundred_thousand_entries_denied"]
)
def test_the_worst_archives_cost_little_memory_and_time(tmp_path: Path, name: str) -> None:
    data = built(name)
    tracemalloc.start()
    began = time.process_time()
    inspected(tmp_path, data)
    spent_s, peak = time.process_time() - began, tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert peak < 200_000_000
    assert spent_s < 5


def test_the_largest_honest_archive_costs_little_memory(tmp_path: Path) -> None:
    text = b"".join(b"%06d a line of a robot's log\n" % n for n in range(100_000)) * 14
    packer = zlib.compressobj(1, zlib.DEFLATED, -zlib.MAX_WBITS)
    log = Member("log.txt", text, packed=packer.compress(text) + packer.flush())
    data = pack([*with_folders(SOUND), log])
    assert len(data) < 10_000_000
    del text, log
    tracemalloc.start()
    inspection = inspected(tmp_path, data)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert inspection.team is not None
    assert peak < 200_000_000


def test_looking_at_an_archive_needs_no_physics() -> None:
    program = (
        "import sys, rcj_challenges.checker.archives, rcj_challenges.checker.repair; print('mujoco' in sys.modules)"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, encoding="utf-8", check=True)
    assert done.stdout.strip() == "False"


def test_every_code_has_the_level_of_its_cases_and_whether_they_are_repaired() -> None:
    cases = (ALL | IMPORTS | SOURCES).values()
    for name in {case.code for case in cases}:
        of_code, code = [case for case in cases if case.code == name], Code.named(name)
        assert code.level in {case.level for case in of_code}, name
        assert code.repair.startswith("yes") == any(case.repair for case in of_code), name


@pytest.mark.parametrize(
    ("data", "picture"),
    [
        (pictures.png(30, 20), Picture("PNG", 30, 20)),
        (pictures.animated_png(), Picture("PNG", 8, 8, animated=True)),
        (pictures.jpeg_head(30, 20), Picture("JPEG")),
        (pictures.gif(), Picture("GIF")),
        (pictures.bmp(30, 20), Picture("BMP")),
        (b"RIFF\0\0\0\0WEBPVP8X" + bytes(8), Picture("WebP")),
        (b"RIFF\0\0\0\0WAVEfmt " + bytes(8), None),
        (b"\x89PNG\r\n\x1a\n", None),
        (b"", None),
    ],
)
def test_the_kind_of_a_picture_is_read_from_its_first_bytes(data: bytes, picture: Picture | None) -> None:
    assert identify(data) == picture
