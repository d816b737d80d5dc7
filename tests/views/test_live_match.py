"""The live view of real matches: it changes nothing, counts for no team, and ends on request."""

import http.client
import json
import os
import signal
import socket
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from typer.testing import CliRunner

from rcj_challenges.cli.commands import load_app
from rcj_challenges.core.errors import RcjError
from rcj_challenges.match.observers import Observer, ObserverGroup
from rcj_challenges.match.runner import MatchPlan, play_match
from rcj_challenges.scenario.load import load
from rcj_challenges.submissions.team import open_team
from rcj_challenges.views.live import MAX_SPEED, LiveShow

DRIVE = """\
import random
from controller import Robot
robot = Robot()
motors = [robot.getDevice(name) for name in ("left wheel motor", "right wheel motor")]
for motor in motors:
    motor.setPosition(float("inf"))
while robot.step(32) != -1:
    for motor in motors:
        motor.setVelocity(random.uniform(-10, 10))
"""
COMMAND = [sys.executable, "-m", "rcj_challenges"]
DUEL = [f"entrants.{seat}.robots.{seat[0].upper()}{number}=null" for seat in ("blue", "yellow") for number in (2, 3)]
"""One robot on each side has a program: nothing here depends on the others, and each half starts fewer processes."""

POSIX = pytest.mark.skipif(os.name != "posix", reason="signals are sent as POSIX has them")


@pytest.fixture
def team(tmp_path: Path) -> Path:
    file = tmp_path / "team.py"
    file.write_text(DRIVE, encoding="utf-8")
    return file


@pytest.fixture
def play(tmp_path: Path, team: Path) -> Callable[..., dict[str, Any]]:
    def run(show: Callable[[Any], LiveShow] | None = None, *overrides: str) -> dict[str, Any]:
        loaded = load("match", ["match.halves=2", "match.half_s=1.6", *DUEL, *overrides])
        seats = tuple(loaded.scenario.entrants.values())
        teams = {seat: open_team(team, *seats) for seat in loaded.scenario.entrants}
        plan = MatchPlan(loaded, teams, {}, seed=7, out=tmp_path / "runs")
        if show is None:
            return play_match(plan).result
        with show(loaded.scenario) as shown:
            return play_match(plan, ObserverGroup(shown.observer)).result

    return run


class Fidget(threading.Thread):
    """Pauses, steps and changes the speed of a match until it is over."""

    def __init__(self, show: LiveShow) -> None:
        super().__init__(daemon=True)
        self._pace = show.pace
        self.over = threading.Event()
        self.acts = 0

    def run(self) -> None:
        speeds = [4.0, 32.0, MAX_SPEED, 1.0]
        while not self.over.is_set():
            self._pace.pause()
            self._pace.step(3)
            self.over.wait(0.02)
            self._pace.set_speed(speeds[self.acts % 4])
            self._pace.resume()
            self.over.wait(0.02)
            self.acts += 1


def test_the_digest_is_the_same_live_paused_and_stepped_as_without(play: Callable[..., dict[str, Any]]) -> None:
    fidgets = []

    def watched(scenario: Any) -> LiveShow:
        return LiveShow(scenario, {}, 7, speed=MAX_SPEED)

    def fidgeted(scenario: Any) -> LiveShow:
        show = LiveShow(scenario, {}, 7, speed=8.0)
        fidgets.append(Fidget(show))
        fidgets[0].start()
        return show

    plain = play()
    live = play(watched)
    fidgety = play(fidgeted)
    fidgets[0].over.set()
    assert fidgets[0].acts > 1
    assert plain["faults"] == live["faults"] == fidgety["faults"] == []
    assert plain["digest"] == live["digest"] == fidgety["digest"]


def test_a_pause_counts_for_no_programs_limits(play: Callable[..., dict[str, Any]]) -> None:
    # Each pause is longer than a program may take for a step, and together they are longer than it may take for a half.
    def paused(scenario: Any) -> LiveShow:
        show = LiveShow(scenario, {}, 7, speed=MAX_SPEED)
        show.pace.pause()
        threading.Thread(target=step_now_and_then, args=(show,), daemon=True).start()
        return show

    def step_now_and_then(show: LiveShow) -> None:
        for _ in range(2):
            time.sleep(1.2)  # this is what is tested: time that passes while the match stands still
            show.pace.step(5)
        show.pace.release()

    result = play(paused, "limits.step_s=1", "limits.half_s=2")
    assert result["faults"] == []
    assert result["complete"]


class Holding(Observer):
    """An observer that delays the first ticks of each half."""

    def before_tick(self, tick: int) -> float:
        if tick > 5:
            return 0.0
        time.sleep(0.1)  # this is what is tested: time that passes while the match stands still
        return 0.1


def test_what_the_match_waits_for_its_steward_is_not_the_time_that_it_took(tmp_path: Path, team: Path) -> None:
    loaded = load("match", ["match.halves=2", "match.half_s=1.6", *DUEL])
    seats = tuple(loaded.scenario.entrants.values())
    plan = MatchPlan(loaded, {seat: open_team(team, *seats) for seat in loaded.scenario.entrants}, {}, out=tmp_path)
    began = time.perf_counter()
    result = play_match(plan, Holding()).result
    took_s = time.perf_counter() - began
    assert 0 < result["wall_s"] < took_s - 0.99
    assert result["real_time_factor"] == pytest.approx(3.2 / result["wall_s"], abs=0.01)


# --- on the command line -----------------------------------------------------------------------------------------------


def short(team: Path, *more: str, duration: str = "1") -> list[str]:
    match = ["match", "--blue", str(team), "--yellow", str(team), *(f"--set={override}" for override in DUEL)]
    return ["run", *match, "--duration", duration, "--halves", "1", *more]


def command(*arguments: str, cwd: Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [*COMMAND, *arguments], cwd=cwd, capture_output=True, text=True, encoding="utf-8", timeout=120, check=False
    )


@pytest.fixture
def started(tmp_path: Path, team: Path) -> Iterator[Callable[..., tuple[subprocess.Popen[str], int, str]]]:
    """Start a live match; gives its process, its port and its token."""
    processes: list[subprocess.Popen[str]] = []

    def start(*more: str, duration: str = "1") -> tuple[subprocess.Popen[str], int, str]:
        process = subprocess.Popen(
            [*COMMAND, *short(team, *more, duration=duration)],
            cwd=tmp_path, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, encoding="utf-8",
        )  # fmt: skip
        processes.append(process)
        line = next(line for line in process.stdout if line.startswith("steer:"))
        address, _, token = line.split()[1].partition("#token=")
        return process, int(address.rstrip("/").rpartition(":")[2]), token

    yield start
    for process in processes:
        process.kill()
        process.wait()
        process.stdout.close()
        process.stderr.close()


def status_of(port: int, path: str) -> int:
    connection = http.client.HTTPConnection("127.0.0.1", port, timeout=120)
    connection.request("GET", path)
    status = connection.getresponse().status
    connection.close()
    return status


def test_json_stays_the_result_and_nothing_else(tmp_path: Path, team: Path) -> None:
    done = command(*short(team, "--json", "--live", "0", "--speed", "max", "--live-for", "0"), cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    assert json.loads(done.stdout)["complete"]
    assert "live:   http://127.0.0.1:" in done.stderr


@pytest.mark.parametrize(
    ("options", "why"),
    [
        (["--speed", "2"], "--speed is for a match that is shown"), (["--live-for", "1"], "--live-for is for a match"),
        (["--open", "--no-replay"], "--open opens the page"), (["--live", "--speed", "0"], "--speed 0"),
        (["--live", "--speed", "nan"], "--speed nan"), (["--live", "--speed", "fast"], "--speed fast"), (["--live", "70000"], "65535"),
    ],
)  # fmt: skip
def test_options_that_make_no_sense_are_refused(
    options: list[str], why: str, tmp_path: Path, team: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    done = CliRunner().invoke(load_app(), short(team, *options))
    error = done.exception
    code, said = (error.exit_code, str(error)) if isinstance(error, RcjError) else (done.exit_code, done.output)
    assert code == 2
    assert why in said
    assert not (tmp_path / "runs").exists()


@POSIX
def test_after_the_match_it_is_served_until_ctrl_c_whoever_is_connected(
    started: Callable[..., Any], tmp_path: Path
) -> None:
    process, port, _ = started("--live", "--speed", "max")
    next(line for line in process.stdout if "the match is over" in line)
    spectator = socket.create_connection(("127.0.0.1", port), timeout=120)  # one that sends no request
    while status_of(port, "/replay.html") != 200:
        pass
    process.send_signal(signal.SIGINT)
    _, complaint = process.communicate(timeout=120)
    assert process.returncode == 0, complaint
    assert complaint == ""
    spectator.close()


@POSIX
def test_ctrl_c_ends_a_paused_match(started: Callable[..., Any], tmp_path: Path) -> None:
    process, port, token = started("--live", duration="100")
    connection = http.client.HTTPConnection("127.0.0.1", port, timeout=120)
    connection.request("POST", "/steer", b'{"do": "pause"}', {"Authorization": f"Bearer {token}"})
    assert connection.getresponse().status == 200
    connection.close()
    process.send_signal(signal.SIGINT)
    _, complaint = process.communicate(timeout=120)
    assert process.returncode == 130, complaint
    assert "Traceback" not in complaint
    assert token not in complaint
