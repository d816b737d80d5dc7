"""What a program may use, what it may not be, and which layers a run has."""

from __future__ import annotations

import math
import os
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import pytest
from attempts import only, outcomes
from fake_match import FakeMatch

from rcj_challenges.core.errors import RcjError
from rcj_challenges.programs import isolation, process_stats, processes, visible_files
from rcj_challenges.programs.program_side.controller import _landlock, _seccomp
from rcj_challenges.scenario.models.limits import Limits

needs_linux = pytest.mark.skipif(sys.platform != "linux", reason="layers of Linux")
is_root = sys.platform == "linux" and os.geteuid() == 0

IN_A_LOOP = "\nwhile True:\n    pass\n"


@pytest.fixture
def probed_anew() -> Iterator[None]:
    """What this machine can do is found out once; here it is found out again, and again afterwards."""
    isolation._missing_on_linux.cache_clear()
    yield
    isolation._missing_on_linux.cache_clear()


@needs_linux
def test_memory_descriptors_and_privileges_are_limited(tmp_path: Path) -> None:
    with only("resource_limits", "no_new_privileges"):
        reported = outcomes(
            tmp_path,
            {
                "take memory": "bytearray(300 << 20)",
                "write a large file": "[file.write(bytes(1 << 20)) for _ in range(20)]",
                "give the room back": "file.truncate(0)",  # or it is ended for what lies in its folder
                "raise a limit": "resource.setrlimit(resource.RLIMIT_AS, (1 << 40, 1 << 40))",
                "privileges": "int([line for line in open('/proc/self/status') if 'CapEff' in line][0].split()[1], 16)",
                "new ones": "[line.split()[1] for line in open('/proc/self/status') if 'NoNewPrivs' in line]",
                "processor time": "resource.getrlimit(resource.RLIMIT_CPU)[0]",
                "open files": "[os.open('/dev/null', os.O_RDONLY) for _ in range(300)]",
            },
            before="signal.signal(signal.SIGXFSZ, signal.SIG_IGN)\nfile = open('large', 'wb', buffering=0)\n",
            memory_mb=256,
            scratch_mb=9,
            output_mb=1,
            start_s=20,
            half_s=10,
        )
    assert reported == {
        "take memory": "MemoryError",
        "open files": "EMFILE",
        "write a large file": "EFBIG",
        "give the room back": "0",
        "raise a limit": "ValueError",  # how the module tells a refusal
        # Root may still read what root may read (Python may be in a folder of root's), and nothing more.
        "privileges": str(1 << 2) if is_root else "0",
        "new ones": "['1']",
        "processor time": "40",
    }


SIGNAL_SLOTS = """
def timers():
    for made in range(1000):
        try:
            syscall(222, 107, 1, None, ctypes.create_string_buffer(8))
        except BlockingIOError:
            return made
    return made

def signals():
    signal.pthread_sigmask(signal.SIG_BLOCK, [signal.SIGRTMIN])
    for _ in range(1000):
        os.kill(os.getpid(), signal.SIGRTMIN)
"""


@needs_linux
@pytest.mark.parametrize("taken_by", ["timers()", "signals()"])
def test_a_program_leaves_signal_slots_to_the_other_processes_of_its_user(tmp_path: Path, taken_by: str) -> None:
    attempts = {"take all": taken_by, "more": "timers()", "limit": "resource.getrlimit(resource.RLIMIT_SIGPENDING)"}
    with only("resource_limits"):
        reported = outcomes(tmp_path, attempts, SIGNAL_SLOTS)
    assert (reported["more"], reported["limit"]) == ("0", "(64, 64)")


@needs_linux
def test_a_program_that_uses_up_its_processor_time_is_ended(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(isolation, "processor_s", lambda _: 1)
    fault = FakeMatch(tmp_path).play("from controller import Robot\nRobot().step(32)" + IN_A_LOOP, 2).fault
    assert fault is not None
    assert (fault.kind, fault.tick, fault.timed) == ("crash", 1, True)
    assert fault.detail == "the program was ended by the signal SIGXCPU: it used more processor time than it may"


def test_the_limit_of_cpu_time_leaves_as_much_outside_the_steps_as_in_them() -> None:
    limits = Limits(start_s=30, half_s=120)
    assert isolation.processor_s(limits) == 30 + 2 * 120
    assert isolation.processor_s(limits.model_copy(update={"processor_s": 2.5})) == 3


@pytest.mark.skipif(sys.platform != "linux" or is_root, reason="root has no limit on threads")
def test_the_user_keeps_room_for_threads_outside() -> None:
    reported = isolation._user_tasks(Limits(processes=10))
    assert reported == process_stats.tasks_of_user() + 160
    assert process_stats.tasks_of_user() >= process_stats.threads_of(os.getpid()) >= 1


WITHOUT_MAIN_THREAD = """
import ctypes, platform, threading
threading.Thread(target=threading.Event().wait).start()
exit = {"x86_64": 60, "aarch64": 93}[platform.machine()]
ctypes.CDLL(None).syscall(ctypes.c_long(exit), ctypes.c_long(0))
"""


@needs_linux
def test_open_files_of_a_process_without_main_thread_are_more_than_any_limit_allows(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(processes, "_DUMP_S", 0.1)
    process = processes.Process(subprocess.Popen([sys.executable, "-c", WITHOUT_MAIN_THREAD]), None, own_session=False)
    try:
        give_up = time.perf_counter() + 30
        while not process.has_lost_main_thread() and time.perf_counter() < give_up:
            assert process.nameless_bytes(-1, tmp_path, in_memory=True) in (0, math.inf)
        assert process.nameless_bytes(-1, tmp_path, in_memory=True) == math.inf
    finally:
        process.kill()
    assert not process.has_lost_main_thread()
    assert process.nameless_bytes(-1, tmp_path, in_memory=True) == 0


@needs_linux
@pytest.mark.usefixtures("probed_anew")
def test_what_cannot_be_had_is_named_and_auto_goes_without(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(_landlock, "is_available", lambda: False)
    monkeypatch.setattr(_seccomp, "is_available", lambda: False)
    assert not {"filesystem", "system_calls"} & set(isolation.active_layers("auto"))
    with pytest.raises(RcjError) as reported:
        isolation.active_layers("strict")
    assert "filesystem (no sight of files" in str(reported.value)
    assert "no Landlock (Linux 5.13" in str(reported.value)
    assert "system_calls (no network" in str(reported.value)
    assert "x86_64 and aarch64" in str(reported.value)


@needs_linux
@pytest.mark.usefixtures("probed_anew")
def test_files_are_not_hidden_where_python_itself_lives_among_them(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    (tmp_path / "home" / "me").mkdir(parents=True)
    monkeypatch.setattr(visible_files, "standard_library", lambda: [str(tmp_path / "home")])
    monkeypatch.setenv("HOME", str(tmp_path / "home" / "me"))
    assert "filesystem" not in isolation.active_layers("auto")
    with pytest.raises(RcjError, match="Python's own folder holds a home folder"):
        isolation.active_layers("strict")


@pytest.mark.skipif(
    not (_landlock.is_available() and _seccomp.is_available()), reason="this kernel lacks Landlock or seccomp"
)
def test_a_strict_run_has_every_layer(tmp_path: Path) -> None:
    assert set(isolation.active_layers("strict")) >= set(isolation.LAYERS)
    assert FakeMatch(tmp_path).play("patterns/keeps_state_at_module_level", 3, sandbox="strict").fault is None


@pytest.mark.parametrize("platform", ["darwin", "win32", "freebsd14"])
def test_other_platforms_report_missing_isolation(platform: str) -> None:
    assert set(isolation.missing_layers(platform)) == {"no_new_privileges", "filesystem", "system_calls"}
    always = {"clean_environment", "private_folder", "ends_with_parent"}
    assert set(isolation.active_layers("off", platform)) == always
    assert set(isolation.active_layers("auto", platform)) == always | {"resource_limits"}
    with pytest.raises(RcjError) as raised:
        isolation.active_layers("strict", platform)
    assert raised.value.code == "isolation-missing"


@needs_linux
@pytest.mark.parametrize(
    ("folder", "wide"),
    [("/", True), ("/home", True), ("/home/me", True), ("/home/me/.venv/lib", False), ("/usr/lib", False)],
)
def test_a_folder_that_holds_a_hidden_one_is_too_wide(folder: str, wide: bool) -> None:
    assert visible_files.is_too_wide(folder, ("/", "/home/me/project", "/tmp")) is wide


@needs_linux
def test_threads_that_wait_take_no_memory_worth_speaking_of(tmp_path: Path) -> None:
    program = """
import threading
from controller import Robot
robot = Robot()
for _ in range(30):
    threading.Thread(target=threading.Event().wait, daemon=True).start()
print(len(bytearray(400 << 20)) >> 20, threading.active_count())
while robot.step(32) != -1:
    pass
"""
    played = FakeMatch(tmp_path).play(program, 3)
    assert played.fault is None
    assert played.said == ["400 31"]
