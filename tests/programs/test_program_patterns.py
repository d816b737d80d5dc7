"""What real teams' programs do (reference, section 4.3), each as a small program in a real process."""

from __future__ import annotations

import struct
import sys
from pathlib import Path

import pytest
from fake_match import INDEX, FakeMatch, packet, robot_spec, supervisor_every_tick

from rcj_challenges.submissions.team import open_team

LEFT, RIGHT = INDEX["left wheel motor"], INDEX["right wheel motor"]
INFINITE = float("inf")


def test_a_program_reads_what_its_robot_senses_and_drives(either_match: FakeMatch) -> None:
    played = either_match.play("patterns/drives_by_what_it_senses", ticks=3)
    assert played.fault is None
    assert played.said == [
        "first [nan, nan, nan] nan Y1 32.0",
        "0.032 [1.0, 0.5, 0.0375] [0.0, 1.0, 0.0] 500.0 0.1",
        "0.064 [2.0, 0.5, 0.0375] [0.0, 1.0, 0.0] 500.0 0.2",
        "over",
    ]
    assert played.motors() == [
        (LEFT, 0.0, INFINITE),
        (RIGHT, 0.0, INFINITE),
        (LEFT, 5.0, INFINITE),
        (RIGHT, -0.032, INFINITE),
        (RIGHT, -0.064, INFINITE),
    ]
    wanted = {(INDEX[name], 1) for name in ("gps", "compass", "distancesensor front", "left wheel sensor")}
    assert set(played.requests[0][1].sampling) == wanted


def test_a_function_that_calls_itself_to_continue_gets_a_warning_before_python_ends_it(match: FakeMatch) -> None:
    program = """
from controller import Robot
import sys
robot = Robot()
sys.setrecursionlimit(LIMIT)
def run():
    if robot.step(32) != -1:
        run()
run()
"""
    played = match.play(program.replace("LIMIT", "1000"), 200)
    (reported,) = played.said
    assert reported.startswith("Warning: step was called 20")
    assert reported.endswith("Python ends the program, after about 31 s; write a while loop.")
    assert [note.help for note in played.notes] == ["write a while loop"], "the end of a half is not too late"
    assert match.play(program.replace("LIMIT", "100000"), 200).said == []
    assert match.play(program.replace("LIMIT", "1000"), 100).said == []


def test_a_program_that_steps_64_ms_and_reads_one_of_two_packets_lags_more_and_more(match: FakeMatch) -> None:
    played = match.play("patterns/steps_of_64_ms", 11, lambda tick: [packet("ball receiver", str(tick).encode())])
    assert played.said == ["2 1 2", "4 2 3", "6 3 4", "8 4 5", "10 5 6"]
    assert [request.advance_ticks for _, request in played.requests] == [2] * 6
    assert played.requests[0][1].sampling == ((INDEX["ball receiver"], 2),)


def test_a_program_may_read_without_asking_how_many_packets_there_are(match: FakeMatch) -> None:
    def air(tick: int) -> list:
        return (
            [packet("supervisor receiver", struct.pack("ddd?", tick, 0, 0, True))] if tick % 2 == 0 and tick > 2 else []
        )

    played = match.play("patterns/reads_without_asking", 8, air)
    assert played.fault is None
    assert played.said[1:] == ["(4.0, 0.0, 0.0, True)", "(6.0, 0.0, 0.0, True)"]


def test_draining_the_queue_gives_all_packets_in_order_and_then_nothing(match: FakeMatch) -> None:
    def air(tick: int) -> list:
        return [packet("team receiver", f"{tick}{letter}".encode(), 0.25) for letter in "ab"] if tick == 1 else []

    played = match.play("patterns/drains_the_queue", 3, air)
    assert played.said == [
        "1a 0.25 [1.0, 0.0, 0.0] 2",
        "1b 0.25 [1.0, 0.0, 0.0] 2",
        "newest 1b 0 -1 nan",
        "newest None 0 -1 nan",
    ]


def test_several_radio_packets_per_tick_are_sent_in_order(match: FakeMatch) -> None:
    played = match.play(
        "patterns/several_radio_packets", 3, lambda _: [packet("team receiver", struct.pack("ii", 2, 5))]
    )
    expected = [struct.pack("ii", 1, 1), struct.pack("ii", 1, 2), "Grüße".encode(), struct.pack("2d", 0.5, 2)]
    assert played.sent() == expected * 2
    assert played.said == ["{2: [5, 5]} 3 10.0 3"]


def test_a_program_that_sleeps_misses_ticks(match: FakeMatch) -> None:
    # 0.2 s are 6 whole ticks and a bit.
    played = match.play("patterns/sleeps_in_the_loop", 16)
    assert [(tick, r.missed_ticks, r.advance_ticks) for tick, r in played.requests] == [
        (0, 0, 1),
        (1, 6, 1),
        (8, 6, 1),
        (15, 6, 1),
    ]
    assert played.said == ["1 0.20", "8 0.20", "15 0.20"]


def test_a_busy_wait_for_the_clock_misses_ticks_too(match: FakeMatch) -> None:
    played = match.play("patterns/busy_waits", 9)
    assert [(tick, r.missed_ticks) for tick, r in played.requests] == [(0, 0), (1, 3), (5, 3)]


def test_a_catch_all_except_round_the_whole_loop_works(match: FakeMatch) -> None:
    played = match.play("patterns/catches_everything", 5)
    assert played.fault is None
    assert played.said[-1] == "caught 4"
    assert "getData was called with an empty queue" in played.said[0]


def test_prints_on_every_tick_reach_the_log_as_utf_8_whatever_they_hold(match: FakeMatch) -> None:
    played = match.play("patterns/prints_on_every_tick", 4)
    line = "Höhe 7.5 ボール ⚽ \\udc80"
    assert played.said == [line] * 3


def test_properties_in_snake_case_do_what_the_methods_do(match: FakeMatch) -> None:
    played = match.play("patterns/uses_properties", 2, supervisor_every_tick)
    assert played.said == [
        "Y1 0.032 32.0 2.0 10.0 left wheel motor",
        "[1.0, 0.5, 0.0375] 32 1000.0 1000.0",
        "1 b'\\x00' 1 1.0 1",
        "3 10.0 13 [<class 'controller.motor.Motor'>, <class 'controller.sensors.GPS'>, <class 'controller.sensors.DistanceSensor'>]",
    ]
    assert played.motors() == [(LEFT, 2.0, INFINITE)]


@pytest.mark.parametrize("getdata_returns", ["bytes", "text"])
def test_text_of_a_packet_includes_its_zero_bytes(match: FakeMatch, getdata_returns: str) -> None:
    def air(tick: int) -> list:
        return [packet("team receiver", struct.pack("<i", 2))] if tick == 1 else []

    spec = robot_spec(getdata_returns=getdata_returns)
    played = match.play("patterns/packs_numbers_as_text", 2, air, spec=spec)
    data = "bytes 2" if getdata_returns == "bytes" else "str 2"
    assert played.fault is None
    assert played.said == ["str 2", "str 2", data, data]
    assert played.sent()[0] == struct.pack("<i", 1)


def test_imports_work_by_name_and_only_what_robots_lack_is_refused_on_use(match: FakeMatch) -> None:
    played = match.play("patterns/imports_a_lot", 2)
    assert played.fault is None
    assert played.said == [
        "5.0 controllers 1",
        "NotImplementedError there is no Radar on these robots",
        "Error: only one Robot can be made: this second Supervisor is the same robot.",
        "Error: only one Robot can be made: this second Robot is the same robot.",
        "? no keyboard",
    ]


def test_clock_and_calendar_show_simulated_time(match: FakeMatch) -> None:
    played = match.play("patterns/asks_the_time", 95)
    assert played.fault is None
    assert played.said[0].startswith("1000 2024-01-01 00:00:00 2024 1970 Mon Jan  1 00:00:00 2024")
    assert played.said[1].startswith("2024-01-01 00:00:00.0320")
    assert played.said[1].endswith("+00:00")
    assert played.said[2] == "3.0 True True True"
    assert played.said[3] == "3.032 3.032 3.032 3.032"
    assert played.said[4] == "sleep length must be non-negative"
    assert len(played.said) == 6
    # 3 s are 93.75 ticks; the readings add some microseconds.
    assert [r.missed_ticks for _, r in played.requests] == [0, 93]


def test_dice_fall_alike_for_one_seed_and_differently_for_robots_halves_and_seeds(match: FakeMatch) -> None:
    first = match.play("patterns/throws_dice", 2).said
    again = match.play("patterns/throws_dice", 2).said
    others = [
        match.play("patterns/throws_dice", 2, spec=robot_spec("Y2")).said,
        match.play("patterns/throws_dice", 2, half=2).said,
        match.play("patterns/throws_dice", 2, match_seed=2).said,
    ]
    assert len(first) == 2
    assert first == again
    numbers = first[0].split()[:7]
    assert len(set(numbers)) == 7
    for other in others:
        assert not set(numbers) & set(other[0].split()[:7])
        assert other[1] == first[1]  # a seed of the program's own is honoured


def test_locks_and_queues_with_a_timeout_do_not_hang(match: FakeMatch) -> None:
    assert match.play("patterns/threads_unused", 3).said == ["empty", "empty"]


def test_files_with_windows_line_ends_and_a_byte_order_mark_run(match: FakeMatch, tmp_path: Path) -> None:
    source = "from controller import Robot\nrobot = Robot()\nwhile robot.step(32) != -1:\n    print('tick')\n"
    (tmp_path / "crlf.py").write_bytes(b"\xef\xbb\xbf" + source.replace("\n", "\r\n").encode())
    assert match.play(open_team(tmp_path / "crlf.py"), 3).said == ["tick", "tick"]


def test_a_step_shorter_than_a_tick_is_rounded_up(match: FakeMatch) -> None:
    program = (
        "from controller import Robot\nrobot = Robot()\nfor ms in (16, 32, 33, 64, 0, 1e12):\n    robot.step(ms)\n"
    )
    played = match.play(program, 9)
    assert [r.advance_ticks for _, r in played.requests] == [1, 1, 2, 2, 1, 2**31 - 1]


def test_the_first_of_2021s_folders_is_the_current_one_and_the_shared_libraries_are_found(
    match: FakeMatch, tmp_path: Path
) -> None:
    team = tmp_path / "team"
    for number in (1, 2):
        (team / f"robot{number}").mkdir(parents=True)
        (team / f"robot{number}" / f"robot{number}.py").write_text(
            "import os, sys\n"
            "from controller import Robot\n"
            "import helper\n"
            "sys.path.append('/app/controllers')\n"
            "sys.path.append(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))\n"
            "from team_AB_libraries.robot1 import NAME\n"
            "robot = Robot()\n"
            "print(os.path.basename(os.getcwd()), helper.WHO, NAME, open('data.txt').read(), __file__ == sys.argv[0])\n"
            "robot.step(32)\n",
            encoding="utf-8",
        )
        (team / f"robot{number}" / "helper.py").write_text(f"WHO = {number}\n", encoding="utf-8")
        (team / f"robot{number}" / "data.txt").write_text(f"data{number}", encoding="utf-8")
    (team / "team_AB_libraries").mkdir()
    (team / "team_AB_libraries" / "robot1.py").write_text("NAME = 'shared'\n", encoding="utf-8")
    for number in (1, 2):
        played = match.play(open_team(team), 1, entry=f"robot{number}/robot{number}.py")
        assert played.fault is None
        assert played.said == [f"robot{number} {number} shared data{number} True"]


@pytest.mark.parametrize("name", ["random", "resource"])  # the match itself has used the second one
def test_a_file_of_the_team_may_have_the_name_of_a_standard_module(match: FakeMatch, tmp_path: Path, name: str) -> None:
    (tmp_path / "team").mkdir()
    (tmp_path / "team" / f"{name}.py").write_text("SPEED = 5\n", encoding="utf-8")
    program = f"import {name}\nfrom controller import Robot\nprint({name}.SPEED)\nRobot().step(32)\n1 / 0\n"
    (tmp_path / "team" / "main.py").write_text(program, encoding="utf-8")
    played = match.play(open_team(tmp_path / "team"), 3, entry="main.py")
    assert played.said[0] == "5"
    assert played.fault is not None
    assert played.fault.detail == "ZeroDivisionError: division by zero (main.py, line 5)"


def test_writing_into_the_current_folder_changes_nothing_of_the_teams(match: FakeMatch, tmp_path: Path) -> None:
    program = "from controller import Robot\nrobot = Robot()\nopen('notes.txt', 'w').write('x')\nrobot.step(32)\nprint(open('notes.txt').read())\nrobot.step(32)\n"
    (tmp_path / "team").mkdir()
    (tmp_path / "team" / "robot.py").write_text(program, encoding="utf-8")
    assert match.play(open_team(tmp_path / "team"), 2).said == ["x"]
    assert [path.name for path in (tmp_path / "team").iterdir()] == ["robot.py"]


def test_programs_see_none_of_the_parents_environment(match: FakeMatch, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("SECRET_OF_THE_PARENT", "42")
    program = "import os\nfrom controller import Robot\nrobot = Robot()\nprint(os.environ.get('SECRET_OF_THE_PARENT'), os.environ['TZ'])\nrobot.step(32)\n"
    assert match.play(program, 1).said == ["None UTC"]


def test_after_the_match_a_program_may_clean_up(match: FakeMatch) -> None:
    program = """
import atexit, sys
from controller import Robot
robot = Robot()
atexit.register(lambda: print("bye"))
while robot.step(32) != -1:
    pass
print(robot.step(32), robot.step(32))
sys.exit(1)
"""
    played = match.play(program, 3)
    assert played.fault is None
    assert played.said == ["-1 -1", "bye"]


def test_nothing_printed_is_lost_when_a_program_replaces_its_output(match: FakeMatch) -> None:
    program = """
import io, sys
from controller import Robot
robot = Robot()
print("one, ", end="")
sys.stdout = io.TextIOWrapper(sys.stdout.buffer, encoding="utf-8")
print("two")
while robot.step(32) != -1:
    pass
"""
    assert match.play(program, 3).said == ["one, two"]


@pytest.mark.skipif(sys.platform != "linux", reason="what the start needs differs between systems")
def test_what_would_be_half_of_a_programs_start_is_loaded_only_by_programs_that_use_it(match: FakeMatch) -> None:
    program = """
import sys
heavy = {"typing", "collections", "re", "enum", "functools", "contextlib"}
print("before:", sorted(heavy & set(sys.modules)))
from controller import Robot
robot = Robot()
print("after:", sorted(heavy & set(sys.modules)))
robot.step(32)
"""
    assert match.play(program, 1).said == ["before: []", "after: []"]


@pytest.mark.parametrize("again", ["importlib.reload(controller)", "del sys.modules['controller']; import controller"])
def test_the_module_may_be_loaded_again(match: FakeMatch, again: str) -> None:
    """Also where the team has a file of that name: it never counts."""
    program = f"""
import importlib, sys
import controller
robot = controller.Robot()
robot.step(32)
{again}
from controller import Motor
print(isinstance(robot.getDevice("left wheel motor"), Motor), isinstance(robot, controller.Robot))
robot.step(32)
"""
    team = match.folder / "team"
    team.mkdir()
    (team / "robot.py").write_text(program, encoding="utf-8")
    (team / "controller.py").write_text("raise SystemExit('not this one')\n", encoding="utf-8")
    played = match.play(open_team(team), 2, entry="robot.py")
    assert played.fault is None
    assert played.said == ["True True"]
