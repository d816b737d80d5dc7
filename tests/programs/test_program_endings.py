"""No program outlives its match, however the match ends; and what a pool leaves behind: logs, nothing else."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from fake_match import PROGRAMS, SPEC, FakeMatch, Played, play_on, values_at

from rcj_challenges.core.errors import RcjError
from rcj_challenges.programs import isolation
from rcj_challenges.programs.pool import PoolPlan, ProgramPool
from rcj_challenges.core.traffic import Observation
from rcj_challenges.scenario.models.limits import Limits

posix = pytest.mark.skipif(sys.platform == "win32", reason="by signals and process ids of POSIX")


def exists(pid: int) -> bool:
    try:
        os.kill(pid, 0)
    except ProcessLookupError:
        return False
    # A killed process whose new parent has not looked after it yet is a zombie: gone, but listed.
    stat = Path(f"/proc/{pid}/stat")
    try:
        return not stat.exists() or stat.read_text(encoding="utf-8").rsplit(")", 1)[1].split()[0] != "Z"
    except (FileNotFoundError, ProcessLookupError):
        return False


def gone_within(pids: list[int], seconds: float) -> bool:
    until = time.perf_counter() + seconds
    while any(map(exists, pids)):
        if time.perf_counter() > until:
            return False
        time.sleep(0.01)
    return True


MATCH = """
import os, sys, time
sys.path.insert(0, {tests!r})
from pathlib import Path
from fake_match import FakeMatch, robot_spec
match = FakeMatch(Path({folder!r}), portable={portable!r})
team = match.team({program!r})
try:
    with match.pool() as pool:
        programs = [pool.add(robot_spec(name), team, team.single) for name in ("Y1", "Y2")]
        pool.launch()
        programs[0].collect()
        print(*(program._process._popen.pid for program in programs), flush=True)
        if {hangs!r}:
            programs[0].release({observation})
            programs[0].collect()
        while True:
            time.sleep(1)
except KeyboardInterrupt:
    print("interrupted", flush=True)
    sys.exit(130)
"""


def run_match(folder: Path, *, portable: bool, program: str, hangs: bool) -> tuple[subprocess.Popen[str], list[int]]:
    source = MATCH.format(
        tests=str(Path(__file__).parent),
        folder=str(folder),
        portable=portable,
        program=program,
        hangs=hangs,
        observation="__import__('fake_match').Observation(1, __import__('fake_match').values_at(1), [])",
    )
    parent = subprocess.Popen(
        [sys.executable, "-c", source], stdout=subprocess.PIPE, text=True, cwd=PROGRAMS.parents[1]
    )
    assert parent.stdout is not None
    return parent, [int(pid) for pid in parent.stdout.readline().split()]


@posix
@pytest.mark.parametrize(
    ("program", "portable"),
    [("faults/hangs_in_play", False), ("patterns/keeps_state_at_module_level", True)],
    ids=["by the kernel", "by a watch"],
)
def test_no_program_outlives_a_killed_match(tmp_path: Path, portable: bool, program: str) -> None:
    parent, pids = run_match(tmp_path, portable=portable, program=program, hangs=False)
    with parent:
        assert len(pids) == 2
        assert all(map(exists, pids))
        parent.kill()
        parent.wait()
        assert gone_within(pids, 60)


@posix
def test_ctrl_c_in_the_middle_of_a_hang_ends_the_match_and_its_programs(tmp_path: Path) -> None:
    hang = "from controller import Robot\nRobot().step(32)\nwhile True:\n    pass\n"
    parent, pids = run_match(tmp_path, portable=False, program=hang, hangs=True)
    with parent:
        parent.send_signal(signal.SIGINT)
        assert parent.wait(120) == 130
        assert gone_within(pids, 60)


@posix
def test_what_a_program_started_ends_with_it(tmp_path: Path) -> None:
    match = FakeMatch(tmp_path, step_s=0.4)
    with match.pool(sandbox="off") as pool:  # elsewhere it could start nothing
        team = match.team("faults/starts_others")
        program = pool.add(SPEC, team, "starts_others.py")
        pool.launch()
        play_on(program, Played(), 2)
        pid = int(program.new_output().splitlines()[-1])
        assert exists(pid)
    assert gone_within([pid], 60)


def test_the_second_half_is_appended_to_the_log_of_the_first(match: FakeMatch) -> None:
    match.play("patterns/keeps_state_at_module_level", 2)
    second = match.play("patterns/keeps_state_at_module_level", 3, half=2)
    lines = (match.folder / "logs" / "Y1.log").read_text(encoding="utf-8").splitlines()
    assert lines == [
        "--- half 1: keeps_state_at_module_level.py ---",
        "1 1 __main__",
        "--- half 2: keeps_state_at_module_level.py ---",
        "2 2 __main__",
    ]
    assert second.said == ["2 2 __main__"]


def test_output_can_be_followed_while_it_is_written(match: FakeMatch) -> None:
    team = match.team("patterns/prints_on_every_tick")
    with match.pool() as pool:
        program = pool.add(SPEC, team, "prints_on_every_tick.py")
        pool.launch()
        program.collect()
        assert program.new_output() == "--- half 1: prints_on_every_tick.py ---\n"
        for tick in (1, 2):
            program.release(Observation(tick, values_at(tick), []))
            program.collect()
            assert program.new_output() == "Höhe 7.5 ボール ⚽ \\udc80\n"
        assert program.new_output() == ""


def test_a_large_observation_reaches_a_program_whose_pipe_is_small(either_match: FakeMatch) -> None:
    from fake_match import packet

    program = """
from controller import Robot
robot = Robot()
team = robot.getDevice("team receiver")
emitter = robot.getDevice("team emitter")
team.enable(32)
while robot.step(32) != -1:
    print(team.getDataSize())
    emitter.send(team.getBytes())
    team.nextPacket()
"""
    played = either_match.play(program, 4, lambda tick: [packet("team receiver", bytes([tick]) * 900_000)])
    assert played.said == ["900000"] * 3
    assert [(len(data), data[0]) for data in played.sent()] == [(900_000, 1), (900_000, 2), (900_000, 3)]


def test_an_unknown_sandbox_is_refused(tmp_path: Path) -> None:
    with pytest.raises(RcjError) as raised:
        ProgramPool(PoolPlan(Limits(), 1, 1, tmp_path, sandbox="on"))
    assert raised.value.code == "unknown-sandbox"


@pytest.mark.skipif(sys.platform != "linux", reason="as Linux tells it")
@pytest.mark.parametrize(("sandbox", "privileges", "files"), [("auto", "1", "256"), ("off", "0", None)])
def test_layers_are_in_place_before_the_programs_first_line(
    match: FakeMatch, sandbox: str, privileges: str, files: str | None
) -> None:
    program = """
import os
from controller import Robot
robot = Robot()
status = dict(line.split(":", 1) for line in open("/proc/self/status"))
limits = {line[:25].strip(): line[26:].split()[0] for line in open("/proc/self/limits")}
handed_down = [fd for fd in os.listdir("/proc/self/fd") if os.path.lexists("/proc/self/fd/" + fd)]
handed_down = [fd for fd in handed_down if "libffi" not in os.readlink("/proc/self/fd/" + fd)]  # it holds itself open
print(status["NoNewPrivs"].strip(), limits["Max open files"], os.getsid(0) in (os.getpid(), 1), len(handed_down))
robot.step(32)
"""
    said = match.play(program, 1, sandbox=sandbox).said[0].split()
    assert said[0] == privileges
    assert files is None or said[1] == files
    # A session of its own (1 is bubblewrap's). Input, output, error, and the two pipes: nothing else is inherited.
    assert said[2:] == ["True", "5"]


def read_until(terminal: int, wanted: bytes) -> None:
    seen = b""
    while wanted not in seen:
        try:
            chunk = os.read(terminal, 4096)
        except OSError:  # how Linux tells the end of a terminal
            chunk = b""
        assert chunk, seen
        seen += chunk


@pytest.mark.skipif(sys.platform == "win32", reason="by a pseudo-terminal")
def test_a_program_that_is_debugged_has_the_terminal_and_no_limits(tmp_path: Path) -> None:
    import pty

    source = f"""
import sys
sys.path.insert(0, {str(Path(__file__).parent)!r})
from pathlib import Path
from fake_match import FakeMatch
match = FakeMatch(Path({str(tmp_path)!r}), start_s=0.1, step_s=0.1, half_s=0.1)
program = '''
from controller import Robot
robot = Robot()
robot.step(32)
answer = 41
breakpoint()
robot.step(32)
'''
played = match.play(program, 2, debug=frozenset({{"Y1"}}))
print("fault:", played.fault)
"""
    ours, theirs = pty.openpty()
    with subprocess.Popen(
        [sys.executable, "-c", source],
        stdin=theirs,
        stdout=theirs,
        stderr=theirs,
        start_new_session=True,
        cwd=PROGRAMS.parents[1],
        env=os.environ | {"PYTHONBREAKPOINT": "pdb.set_trace"},
    ) as parent:
        os.close(theirs)
        read_until(ours, b"(Pdb)")
        time.sleep(0.3)  # longer than all limits: there are none
        os.write(ours, b"p answer + 1\n")
        read_until(ours, b"42")
        os.write(ours, b"continue\n")
        read_until(ours, b"fault: None")
        parent.wait(120)
    os.close(ours)
