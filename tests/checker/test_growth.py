"""What programs print and write is scaled up from a short match to a half, and compared with what they may."""

from __future__ import annotations

import re
import zipfile

import pytest

from rcj_challenges.checker.check import CheckOptions, check_file
from rcj_challenges.checker.growth import Growth
from rcj_challenges.scenario.load import load
from tests.checker.alone import ONE_EACH, alone

pytestmark = pytest.mark.usefixtures("sources_read_here")

ENTRY = "rcj_soccer_team_blue/rcj_soccer_team_blue.py"
DUEL = load("match", ONE_EACH)
ALONE = alone()
BEGIN = """\
from controller import Robot
robot = Robot()
for name in ("left wheel motor", "right wheel motor"):
    robot.getDevice(name).setPosition(float("inf"))
"""
LOOP = "while robot.step(32) != -1:\n"


@pytest.fixture
def much(tmp_path):
    def found(program, scenario=ALONE, play_s=4.2, *, plays=True, **files):
        path = tmp_path / "team.zip"
        with zipfile.ZipFile(path, "w") as archive:
            archive.writestr(ENTRY, program)
            for name, content in files.items():
                archive.writestr(name, content)
        report = check_file(path, scenario, CheckOptions(play_s=play_s))
        assert (report.level != "failure") is plays
        told = report.stages[5].findings
        much = [finding for finding in told if finding.code.endswith("_much")]
        assert much[:1] in ([], told[:1])  # what may be as it should comes later
        return much

    return found


def numbers(finding, words):
    return [float(number) for number in re.search(words, finding.message).groups()]


def test_a_program_that_would_fill_its_folder_before_the_half_is_over_is_warned_of_when_and_what_to_do(much):
    # Python 3.14 writes in pieces of 128 kB unless it is told otherwise, which is coarse for a play of 4 s.
    told = much(BEGIN + 'file = open("log.txt", "a", 8192)\n' + LOOP + '    file.write("x" * 5000 + "\\n")\n', DUEL)
    assert [(finding.code, finding.level, finding.where) for finding in told] == [
        ("play.writes_much", "warning", "B1"),
        ("play.writes_much", "warning", "Y1"),
    ]
    assert told[0].message.startswith("as blue, writes 0.")
    assert " MB into its folder in 4.1 s of play, that is about " in told[0].message
    whole_mb, ended_s = numbers(told[0], r"about (\d+) MB in a half; 64 MB are allowed: .* after about (\d+) s")
    assert (whole_mb, ended_s) == (pytest.approx(94, abs=4), pytest.approx(410, abs=20))
    assert "every 30th step" in told[0].remedy


def test_a_program_that_would_print_too_much_is_warned(much):
    told = much(BEGIN + LOOP + '    print("x" * 2500)\n')
    assert [finding.code for finding in told] == ["play.prints_much"]
    whole_mb, ended_s = numbers(told[0], r"about (\d+) MB in a half; 32 MB are allowed: .* after about (\d+) s")
    assert (whole_mb, ended_s) == (pytest.approx(47, abs=2), pytest.approx(409, abs=20))
    assert told[0].remedy.startswith("print less")


def test_a_program_that_would_be_ended_before_the_middle_of_a_half_does_not_play(much):
    told = much(BEGIN + LOOP + '    print("x" * 4000)\n', plays=False)
    assert [(finding.code, finding.level, finding.where) for finding in told] == [
        ("play.prints_much", "failure", "B1"),
    ]
    (ended_s,) = numbers(told[0], r"it would be ended after about (\d+) s")
    assert ended_s == pytest.approx(256, abs=10)


@pytest.mark.nightly
def test_of_several_robots_each_is_told_by_its_own_amount(much):
    """One would be ended soon, one late, one never."""
    lengths = '{"B1": 4000, "B2": 2500}.get(robot.getName(), 1)'
    told = much(BEGIN + LOOP + f'    print("x" * {lengths})\n', load("match"), plays=False)
    assert [(finding.level, finding.where) for finding in told] == [("failure", "B1"), ("warning", "B2")]


def test_a_program_that_comes_near_the_limit_is_warned_and_not_told_that_it_ends(much):
    (told,) = much(BEGIN + LOOP + '    print("x" * 1200)\n')
    assert numbers(told, r"about (\d+) MB in a half; 32 MB are allowed$") == [pytest.approx(23, abs=1)]
    assert "ended" not in told.message


def test_what_is_printed_or_written_once_at_the_start_does_not_count_again(much):
    once = 'open("table.bin", "wb").write(bytes(5_000_000))\nprint("x" * 3_000_000)\n'
    assert much(BEGIN + once + LOOP + '    print("ordinary", robot.getTime())\n') == []


def test_a_teams_own_large_files_are_nothing_that_it_writes(much):
    assert much(BEGIN + LOOP + "    pass\n", alone("limits.scratch_mb=1"), table=bytes(900_000)) == []


def test_a_short_half_allows_what_a_long_one_does_not(much):
    program = BEGIN + 'file = open("log.txt", "a")\n' + LOOP + '    file.write("x" * 5000 + "\\n")\n'
    assert much(program, alone("match.half_s=60")) == []


def test_an_amount_goes_on_as_it_grew_lately():
    growth = Growth()
    assert (growth.total_bytes, growth.at_bytes(1000)) == (0, 0)
    growth.note(0, 500)
    assert growth.at_bytes(1000) == 500
    for tick, total in ((100, 10_000), (200, 10_100), (300, 10_200)):
        growth.note(tick, total)
    assert growth.at_bytes(1300) == 11_200
    assert growth.reaches_s(11_200) == pytest.approx(1300 * 0.032)
    growth.note(400, 0)  # it has deleted its file
    assert growth.at_bytes(1000) == 0
