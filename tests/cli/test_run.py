"""``rcj-challenge run`` as its users meet it: real processes, exit codes, nothing half written."""

import errno
import io
import json
import os
import re
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from rcj_challenges.records.result import RunResult, read_result
from rcj_challenges.records.trajectory import Trajectory
from rcj_challenges.views.replay.browse import playing_address
from tests.cli.conftest import STAND
from tests.cli.in_this_process import here

COMMAND = [sys.executable, "-m", "rcj_challenges"]
POSIX = pytest.mark.skipif(os.name != "posix", reason="signals are sent as POSIX has them")


@pytest.fixture
def team(tmp_path):
    file = tmp_path / "team.py"
    file.write_text(STAND, encoding="utf-8")
    return str(file)


def command(*arguments, cwd, **more):
    return subprocess.run(
        [*COMMAND, *arguments],
        cwd=cwd,
        capture_output=True,
        text=True,
        encoding="utf-8",
        timeout=120,
        check=False,
        **more,
    )


def short(team, *more, duration="1"):
    return ["run", "match", "--blue", team, "--yellow", team, "--duration", duration, "--halves", "1", *more]


DUEL = [
    f"--set=entrants.{seat}.robots.{robot}=null"
    for seat, others in (("blue", ("B2", "B3")), ("yellow", ("Y1", "Y3")))
    for robot in others
]
"""One robot on each side has a program, for what does not depend on the others: that starts fewer processes."""


@pytest.mark.parametrize(
    ("scenario", "files", "help_"),
    [
        (
            "match",
            ["foxes/foxes.py", "foxes/robot1.py", "team_name.txt"],
            (
                "rename the folder foxes to rcj_soccer_team_blue, rename the file rcj_soccer_team_blue/foxes.py to "
                "rcj_soccer_team_blue/rcj_soccer_team_blue.py; rcj-challenge check … --fix NEW.zip makes such a copy"
            ),
        ),
        (
            "match",
            ["code/score_goal/score_goal.py"],
            "it looks like one for fast_shooter or precision_lidar: ",
        ),
        (
            "match_2021",
            [f"rcj_soccer_player_b{number}/rcj_soccer_player_b{number}.py" for number in (1, 2, 3)],
            "rename the folder rcj_soccer_player_b1 to robot1, ",
        ),
    ],
)
def test_message_about_misnamed_programs_proposes_a_renaming(tmp_path, monkeypatch, capsys, scenario, files, help_):
    for name in files:
        (tmp_path / "mine" / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / "mine" / name).write_text("import robot1\n" if name == files[0] else "x = 1\n", encoding="utf-8")
    assert here(monkeypatch, tmp_path, "run", scenario, "--yellow", "mine") == 2
    printed = capsys.readouterr()
    assert help_ in printed.err + printed.out
    assert "did you mean" not in printed.err + printed.out


def test_json_prints_the_result_and_nothing_else(tmp_path, team):
    done = command(*short(team, "--json", *DUEL), cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    result = json.loads(done.stdout)
    assert result["complete"]
    assert result["score"] == {"blue": 0, "yellow": 0}
    assert result["simulated_s"] == 1.024
    assert done.stderr == ""
    RunResult.model_validate(result)
    folder = result.pop("folder")
    assert result.pop("hints") == []
    assert Path(folder).parts[:-1] == ("runs",)
    assert json.loads((tmp_path / folder / "result.json").read_bytes()) == result


def test_in_a_terminal_that_a_debugged_program_has_too_nothing_is_written_over_what_it_prints(tmp_path, team):
    terminal = os.environ | {"FORCE_COLOR": "1", "TERM": "xterm-256color"}
    ends = [*short(team, "--no-replay"), *DUEL]
    scoreboard = "0:00.0 / 0:01.0"
    assert scoreboard in command(*ends, cwd=tmp_path, env=terminal).stdout
    said = command(*ends, "--debug", "B1", cwd=tmp_path, env=terminal | {"PYTHONBREAKPOINT": "pdb.set_trace"}).stdout
    assert scoreboard not in said
    assert "\x1b[1A" not in said  # a line up
    assert "half 1 of 1" in said
    assert "kicks off" in said


def test_json_is_not_mixed_with_what_a_debugged_program_prints(tmp_path, monkeypatch, capsys, team):
    """The program has the terminal: what it prints, and the debugger, would stand within the JSON."""
    assert here(monkeypatch, tmp_path, *short(team, "--json", "--debug", "B1")) == 2
    said = capsys.readouterr()
    assert said.out == ""
    assert "--debug" in said.err
    assert "--json" in said.err
    assert not (tmp_path / "runs").exists()


def test_robots_whose_programs_fail_alike_are_reported_in_one_line(tmp_path, monkeypatch, capsys):
    program = "from controller import Robot\nrobot = Robot()\nrobot.step(32)\nname = robot.getName()\n"
    (tmp_path / "team.py").write_text(program + "if name == 'Y2': robot.step(32)\n1 / 0\n", encoding="utf-8")
    ends = ["run", "match", "--blue", "team.py", "--yellow", "team.py", "--duration", "1", "--halves", "2"]
    assert here(monkeypatch, tmp_path, *ends, "--quiet", "--no-replay", *DUEL) == 0
    printed = [line for line in capsys.readouterr().out.splitlines() if line.startswith("program fault")]
    what = "ZeroDivisionError: division by zero (team.py, line 6)"
    assert printed == [
        f"program fault: B1 crash at tick 1: {what} (logs/B1.log)",
        f"program fault: Y2 crash at tick 2: {what} (logs/Y2.log)",
    ]
    (tmp_path / "team.py").write_text(program + "1 / 0\n", encoding="utf-8")
    assert here(monkeypatch, tmp_path, *ends, "--quiet", "--no-replay", *DUEL) == 0
    printed = [line for line in capsys.readouterr().out.splitlines() if line.startswith("program fault")]
    assert printed == [f"program fault: B1, Y2 crash at tick 1: {what.replace('6', '5')} (logs/B1.log)"]


OVER_AT_ONCE = "{over: {triggers: [{trigger: half_started}], actions: [{action: end, what: match}], says: Over.}}"


def test_a_match_that_a_rule_ends_before_its_first_tick_was_played_and_has_no_page(tmp_path, monkeypatch, capsys, team):
    monkeypatch.setattr("webbrowser.open", lambda address: pytest.fail(f"{address} was opened"))
    (tmp_path / "over.yaml").write_text(
        "schema_version: 2\nid: over\ntitle: Over\nextends: soccersim_v2\nrules: " + OVER_AT_ONCE, encoding="utf-8"
    )
    at_once = ["over.yaml" if one == "match" else one for one in short(team, "--quiet", "--open", *DUEL)]
    assert here(monkeypatch, tmp_path, *at_once) == 0
    said = capsys.readouterr()
    assert said.err == ""
    assert said.out.splitlines()[-1] == "watch:  there is nothing to show, the match was over before its first tick"
    (folder,) = tmp_path.glob("runs/*")
    assert read_result(folder).complete
    assert here(monkeypatch, tmp_path, "replay", str(folder)) == 2
    assert "the match was over before its first tick: there is nothing to show" in capsys.readouterr().err


@pytest.mark.parametrize("there_is_a_browser", [True, False])
def test_open_shows_the_page_when_the_match_is_over(tmp_path, monkeypatch, capsys, team, there_is_a_browser):
    opened = []
    monkeypatch.setattr("webbrowser.open", lambda address: opened.append(address) or there_is_a_browser)
    assert here(monkeypatch, tmp_path, *short(team, "--quiet", "--open", *DUEL)) == 0
    (page,) = tmp_path.glob("runs/*/replay.html")
    assert opened == [playing_address(page)]
    assert ("no browser could be started" in capsys.readouterr().out) is not there_is_a_browser


@pytest.mark.parametrize("how", ["--json", "--quiet"])
def test_result_is_printed_when_the_disk_is_full_for_the_replay_page(tmp_path, monkeypatch, capsys, team, how):
    def full(folder):
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC), str(folder / "replay.html"))

    monkeypatch.setattr("rcj_challenges.views.replay.write_replay", full)
    assert here(monkeypatch, tmp_path, *short(team, how, *DUEL)) == 2
    printed, complaint = capsys.readouterr()
    assert complaint.startswith("error[disk-full]: ")
    assert f"replay.html: {os.strerror(errno.ENOSPC)}\nhelp: make room there" in complaint
    assert "its record is whole: runs" in complaint
    if how == "--json":
        assert json.loads(printed)["complete"]
    else:
        assert " 0 : 0 " in printed
        assert "replay.html" not in printed


class Filling(io.StringIO):
    """A file on a disk that is full after some lines."""

    def write(self, text: str) -> int:
        if self.getvalue().count("\n") >= 3:
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
        return super().write(text)


def test_full_disk_for_printed_lines_does_not_end_a_match(tmp_path, monkeypatch, capsys, team):
    """``run match > told.txt``: output may be lost, the match counts."""
    monkeypatch.setattr(sys, "stdout", Filling())
    assert here(monkeypatch, tmp_path, *short(team, *DUEL)) == 2
    complaint = capsys.readouterr().err
    (folder,) = tmp_path.glob("runs/*")
    assert read_result(folder).complete
    assert (folder / "replay.html").exists()
    assert complaint.startswith("error[cannot-write-output]: ")
    assert str(folder.relative_to(tmp_path)) in complaint


def test_show_output_shows_what_a_robot_prints(tmp_path, monkeypatch, capsys, team):
    Path(team).write_text(STAND.replace("    pass", "    print('schön', robot.getName())"), encoding="utf-8")
    assert here(monkeypatch, tmp_path, *short(team, "--show-output", "Y2", "--no-replay", *DUEL)) == 0
    said = capsys.readouterr().out
    assert "Y2 | schön Y2" in said
    assert "B1 |" not in said


WRONG = {
    "no such scenario": (["run", "matsch"], "match"),
    "no such file": (["run", "nowhere/thing.yaml"], "thing.yaml"),
    "no such team": (["run", "match", "--blue", "nowhere"], "nowhere"),
    "a zip that is none": (["run", "match", "--blue", "broken.zip"], "broken.zip"),
    "a folder without entry point": (["run", "match", "--blue", "empty"], "rcj_soccer_team_blue"),
    "a path that a script left empty": (["run", "match", "--yellow", ""], "error[bad-option]: --team yellow="),
    "no such entrant": (["run", "match", "--team", "bleu=x"], "did you mean 'blue'"),
    "an entrant given twice": (["run", "match", "--blue", "x", "--team", "blue=x"], "error[option-given-twice]"),
    "two debugged programs": (["run", "match", "--debug", "Y2", "--debug", "B1"], "error[option-given-twice]"),
    "no such robot": (["run", "match", "--show-output", "Y7"], "B1, B2, B3"),
    "no such value": (["run", "match", "--set", "half_z=3"], "half_z"),
    "a wrong option": (["run", "match", "--duratoin", "5"], "duratoin"),
    "no such sandbox": (["run", "match", "--sandbox", "maybe"], "strict"),
    "a robot outside": (["run", "match", "--set", "robots.B1.start.x_m=3"], "B1"),
}


AS_A_PROCESS = {"no such scenario", "a wrong option"}
"""The others are printed by the same code in this process, which is quicker."""


@pytest.mark.parametrize("wrong", WRONG)
def test_wrong_input_is_reported_without_traceback_and_leaves_nothing(tmp_path, monkeypatch, capsys, wrong):
    (tmp_path / "broken.zip").write_bytes(b"PK\x03\x04 no zip")
    (tmp_path / "empty").mkdir()
    (tmp_path / "empty" / "notes.txt").write_text("later", encoding="utf-8")
    arguments, printed = WRONG[wrong]
    if wrong in AS_A_PROCESS:
        done = command(*arguments, cwd=tmp_path)
        exit_code, stderr = done.returncode, done.stderr
    else:
        exit_code, stderr = here(monkeypatch, tmp_path, *arguments), capsys.readouterr().err
    assert exit_code == 2, stderr
    assert printed in stderr
    assert "Traceback" not in stderr
    assert not (tmp_path / "runs").exists()


def started(tmp_path, team, *more):
    """Start a match; returns when it is played, which on a busy machine is later than the report of its start."""
    Path(team).write_text(STAND.replace("while", "robot.step(32)\nprint('plays')\nwhile"), encoding="utf-8")
    process = subprocess.Popen(
        [*COMMAND, *short(team, "--real-time", "--no-replay", "--show-output", "Y2", *more, duration="600")],
        cwd=tmp_path, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, start_new_session=True,
    )  # fmt: skip
    for line in process.stdout:
        if "Y2 | plays" in line:
            return process
    raise AssertionError(process.stderr.read())


# Ctrl-C; the end of a service, or of a time limit; a terminal that is closed.
@POSIX
@pytest.mark.parametrize(
    "name", ["SIGINT", *(pytest.param(n, marks=pytest.mark.nightly) for n in ("SIGTERM", "SIGHUP"))]
)
def test_interrupted_match_exits_with_130_and_leaves_a_readable_record(tmp_path, team, name):
    process = started(tmp_path, team, *DUEL)
    pids = children_of(process.pid)
    process.send_signal(getattr(signal, name))
    printed, complaint = process.communicate(timeout=120)
    assert process.returncode == 130, complaint
    assert "Traceback" not in complaint
    (folder,) = (tmp_path / "runs").iterdir()
    assert f"record: {folder.relative_to(tmp_path)}" in printed
    assert re.search(r"^interrupted in half 1 of 1 at \d:\d\d\.\d: .* 0 : 0 ", printed, re.MULTILINE), printed
    result = read_result(folder)
    assert not result.complete
    assert result.stopped == "KeyboardInterrupt"
    (half,) = Trajectory.open(folder).halves
    assert [one.ticks for one in result.halves] == [half.ticks]
    assert result.wall_s >= result.start_up_s > 0
    assert_gone(pids)


@POSIX
def test_a_signal_that_comes_twice_ends_a_match_as_one_does(tmp_path, team, monkeypatch):
    """A terminal that is closed: the system tells it, and so does the shell."""
    temporary = tmp_path / "temporary"
    temporary.mkdir()
    monkeypatch.setenv("TMPDIR", str(temporary))
    process = started(tmp_path, team, *DUEL)
    for name in ("SIGHUP", "SIGHUP", "SIGTERM"):
        process.send_signal(getattr(signal, name))
        time.sleep(0.02)
    printed, complaint = process.communicate(timeout=120)
    assert process.returncode == 130, complaint
    assert "interrupted in half 1 of 1" in printed
    assert complaint == ""
    (folder,) = (tmp_path / "runs").iterdir()
    assert read_result(folder).stopped == "KeyboardInterrupt"
    assert Trajectory.open(folder).finished
    assert not list(temporary.iterdir())


@POSIX
def test_too_few_open_files_are_no_fault_of_a_team(tmp_path, team):
    def few_files():
        import resource

        resource.setrlimit(resource.RLIMIT_NOFILE, (40, 40))

    done = command(*short(team, "--no-replay"), cwd=tmp_path, preexec_fn=few_files)
    assert done.returncode == 2, done.stderr
    assert "cannot" in done.stderr
    assert "Too many open files" in done.stderr
    assert str(tmp_path) not in done.stderr
    assert "Traceback" not in done.stderr
    assert not any(read_result(folder).complete for folder in tmp_path.glob("runs/*"))


@POSIX
def test_a_killed_match_leaves_a_readable_record_and_no_process(tmp_path, team):
    process = started(tmp_path, team, *DUEL)
    pids = children_of(process.pid)
    assert len(pids) == 2
    process.kill()
    process.communicate(timeout=120)
    (folder,) = (tmp_path / "runs").iterdir()
    assert not read_result(folder).complete
    assert Trajectory.open(folder).halves[0].ticks >= 0
    assert_gone(pids)


def children_of(pid):
    listed = subprocess.run(["ps", "-A", "-o", "pid=,ppid="], capture_output=True, text=True, check=True).stdout
    return [int(line.split()[0]) for line in listed.splitlines() if line.split()[1] == str(pid)]


def assert_gone(pids):
    until = time.monotonic() + 60
    while time.monotonic() < until:
        listed = subprocess.run(["ps", "-A", "-o", "pid="], capture_output=True, text=True, check=True).stdout.split()
        if not {str(pid) for pid in pids} & set(listed):
            return
        time.sleep(0.05)
    raise AssertionError(f"still there: {pids}")


def test_a_fault_of_ours_leaves_a_report_and_exit_code_3(tmp_path, monkeypatch, capsys, team):
    monkeypatch.setattr("rcj_challenges.match.runner.play_match", None)
    assert here(monkeypatch, tmp_path, *short(team)) == 3
    (report,) = tmp_path.glob("rcj-challenge-report-*.txt")
    assert "Traceback" in report.read_text("utf-8")
    complaint = capsys.readouterr().err
    assert report.name in complaint
    assert "Traceback" not in complaint
