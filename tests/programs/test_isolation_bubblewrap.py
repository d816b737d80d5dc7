"""Bubblewrap, where it is installed: what it adds, and that nothing else changes."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from pathlib import Path

import pytest
from attempts import BASE, only, outcomes
from fake_match import SPEC, FakeMatch, Played, play_on, values_at
from test_program_endings import exists, gone_within

from rcj_challenges.core.errors import RcjError
from rcj_challenges.programs import bubblewrap, isolation, processes, visible_files
from rcj_challenges.programs.private_folders import PREFIX
from rcj_challenges.core.traffic import Observation

installed = sys.platform == "linux" and bubblewrap.works(processes.python(), visible_files.readable())
needs_bubblewrap = pytest.mark.skipif(not installed, reason="bubblewrap is not installed, or may not make name spaces")
needs_linux = pytest.mark.skipif(sys.platform != "linux", reason="a program of Linux")

IN_PLAY = "from controller import Robot\nrobot = Robot()\nrobot.step(32)\n"


@pytest.fixture
def probed_anew() -> Iterator[None]:
    bubblewrap.failure.cache_clear()
    yield
    bubblewrap.failure.cache_clear()


def environment_of(pid: int) -> bytes:
    """Return the environment of a process; none when its memory is given back already, or it is gone."""
    try:
        return Path(f"/proc/{pid}/environ").read_bytes()
    except OSError:
        return b""


@needs_bubblewrap
def test_what_is_outside_has_no_name(tmp_path: Path) -> None:
    secret = tmp_path / "reflog.jsonl"
    secret.touch()
    temporary = os.path.realpath(os.environ.get("TMPDIR", "/tmp"))
    seen = {
        "the record": f"os.path.exists({str(secret)!r})",
        "who has an account": "os.path.exists('/etc/passwd')",
        "homes": "os.path.exists('/home')",
        # Python itself may be there as well.
        "matches": f"len([name for name in os.listdir({temporary!r}) if name.startswith({PREFIX!r})])",
        "private folders": "[name[:7] for name in os.listdir(os.path.dirname(os.environ['HOME']))]",
        "its parent": "os.getppid()",
        "processes": "len([name for name in os.listdir('/proc') if name.isdigit()])",
        "networks": "[name for _, name in socket.if_nameindex()]",
        "the environment": "sorted(set(os.environ) - {'LC_CTYPE'})",
        "its folder": "os.path.basename(os.getcwd())",
        "permissions of Python": "os.chmod(os.__file__, 0o644)",
        "the folder of all folders": "open('/memory', 'w')",
        "shared memory": "open('/dev/shm/memory', 'w')",
    }
    with only("no_new_privileges", "bubblewrap"):
        reported = outcomes(tmp_path, seen)
    assert reported == {
        "the record": "False",
        "who has an account": "False",
        "homes": reported["homes"] if sys.prefix.startswith("/home") else "False",
        "matches": "1",
        "private folders": "['rcj-Y1-']",
        "its parent": "1",
        "processes": "2",
        "networks": "['lo']",
        "the environment": str(sorted(isolation.environment(tmp_path))),
        "its folder": "controllers",
        "permissions of Python": "EROFS",
        "the folder of all folders": "EROFS",
        "shared memory": "EROFS",
    }


@needs_bubblewrap
@pytest.mark.parametrize(
    "ending",
    [
        "os._exit(3)",
        "os.abort()",
        "os.kill(os.getpid(), 9)",
        "os._exit(139)",
        "import ctypes; ctypes.string_at(0)",
        "raise ValueError('x')",
        "print(*sorted(os.environ))",
        "print(os.getcwd().split('/')[-1], __file__.split('/')[-1], sys.argv[0].split('/')[-1], sys.executable)",
    ],
)
def test_a_program_plays_and_ends_the_same_with_bubblewrap_and_without(tmp_path: Path, ending: str) -> None:
    layers = tuple(layer for layer in isolation.active_layers("auto") if layer not in (*BASE, "bubblewrap"))
    played = []
    for extra in ((), ("bubblewrap",)):
        with only(*layers, *extra):
            played.append(FakeMatch(tmp_path).play(f"import os, sys\n{IN_PLAY}{ending}\n", 3))
    assert played[0].requests == played[1].requests
    assert played[0].said == played[1].said
    assert played[0].fault == played[1].fault


@needs_bubblewrap
def test_a_hang_is_reported_with_its_place(tmp_path: Path) -> None:
    with only("resource_limits", "no_new_privileges", "filesystem", "system_calls", "bubblewrap"):
        played = FakeMatch(tmp_path, step_s=0.5).play(f"{IN_PLAY}while True:\n    pass\n", 3)
    assert played.fault is not None
    assert played.fault.kind == "step_timeout"
    assert any(line.startswith('  File "robot.py", line ') for line in played.said)


@needs_bubblewrap
def test_nothing_of_it_is_left_when_the_match_has_ended_the_program(tmp_path: Path) -> None:
    match = FakeMatch(tmp_path)
    with only("bubblewrap"), match.pool() as pool:
        program = pool.add(SPEC, match.team(f"{IN_PLAY}while True:\n    pass\n"), "robot.py")
        pool.launch()
        play_on(program, Played(), 1)
        assert program._process is not None
        outer = program._process._popen.pid
        inner = bubblewrap.innermost(outer)
        assert inner != outer
        assert exists(inner)
        program.kill()
        assert not exists(inner)
        assert gone_within([outer], 10)


@needs_bubblewrap
@pytest.mark.parametrize("by_itself", [True, False], ids=["by itself", "by the match"])
def test_bubblewraps_own_processes_end_with_the_program(tmp_path: Path, by_itself: bool) -> None:
    match = FakeMatch(tmp_path)
    with only("bubblewrap"), match.pool() as pool:
        program = pool.add(SPEC, match.team(IN_PLAY), "robot.py")
        pool.launch()
        play_on(program, Played(), 0)
        assert program._process is not None
        outer = program._process._popen.pid
        inside = int(Path(f"/proc/{outer}/task/{outer}/children").read_text(encoding="ascii"))
        assert b"HOME=" in environment_of(inside)
        if by_itself:
            program.finish(Observation(1, values_at(1), [], over=True))
            program.wait_until(time.perf_counter() + 10)
        program.kill()
        assert environment_of(inside) == b""


@needs_linux
def test_the_end_of_a_program_is_waited_for_until_bubblewraps_last_process_is_gone() -> None:
    read_fd, write_fd = os.pipe()
    process = processes.Process(subprocess.Popen(["sleep", "60"]), None, own_session=False, sandbox_fd=read_fd)
    killing = threading.Thread(target=process.kill)
    killing.start()
    killing.join(0.1)
    assert killing.is_alive(), "somebody still holds the pipe"
    os.close(write_fd)
    killing.join(30)
    assert not killing.is_alive()
    process.kill()


@needs_bubblewrap
def test_auto_and_strict_take_it(tmp_path: Path) -> None:
    assert "bubblewrap" in isolation.active_layers("auto")
    assert "bubblewrap" not in isolation.active_layers("off")


@pytest.fixture(params=["echo 'no name spaces' >&2; exit 1", "sleep 60"], ids=["fails", "hangs"])
def broken_bubblewrap(request: pytest.FixtureRequest, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> str:
    """A bubblewrap that does not work comes first on the path; returns the reason."""
    broken = tmp_path / "bin" / "bwrap"
    broken.parent.mkdir()
    broken.write_text(f"#!/bin/sh\n{request.param}\n", encoding="utf-8")
    broken.chmod(0o755)
    monkeypatch.setenv("PATH", f"{broken.parent}:{os.environ['PATH']}")
    monkeypatch.setattr(bubblewrap, "_PROBE_S", 0.5)
    assert shutil.which("bwrap") == str(broken)
    return "within 0.5 s" if "sleep" in request.param else "no name spaces"


@needs_linux
@pytest.mark.usefixtures("probed_anew")
def test_a_bubblewrap_that_does_not_work_is_dropped_with_the_reason_and_strict_refuses(broken_bubblewrap: str) -> None:
    assert "bubblewrap" not in isolation.active_layers("auto")
    assert broken_bubblewrap in isolation.dropped_layers("auto")["bubblewrap"]
    with pytest.raises(RcjError, match=f"bubblewrap.*{broken_bubblewrap}"):
        isolation.active_layers("strict")
    assert isolation.dropped_layers("off") == {}


@needs_linux
@pytest.mark.usefixtures("probed_anew")
def test_a_layer_that_is_not_installed_is_not_dropped(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(shutil, "which", lambda _: None)
    assert "bubblewrap" not in (*isolation.active_layers("auto"), *isolation.dropped_layers("auto"))
