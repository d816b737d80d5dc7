"""Starting a process with pipes, and ending it with all that it started.

The seam between platforms: POSIX has sessions and process groups, Windows has job objects.
"""

from __future__ import annotations

import contextlib
import functools
import math
import os
import py_compile
import signal
import subprocess
import sys
from collections.abc import Sequence
from importlib.util import cache_from_source
from pathlib import Path
from typing import Any

from rcj_challenges.programs import bubblewrap, memory_addresses, process_stats, scratch
from rcj_challenges.programs.time_budget import ProcessTimes

if sys.platform == "win32":
    import msvcrt

    from rcj_challenges.programs.windows_job import Job, startup_info

PROGRAM_SIDE = Path(__file__).parent / "program_side"
_START = "import sys; sys.path.insert(0, sys.argv[4]); from controller._boot import main; main()"
_DUMP_S = 1.0
_STATUS_OF_SIGNALS, _MAX_SIGNALS = 128, 64  # a process that starts others reports an end by signal n as 128 + n
_NEARLY = 0.9  # of the CPU time that is allowed, because it is checked only now and then
_EXCEPTIONS_FROM, _NEGATIVE_FROM = 0xC0000000, 0xFFFF0000  # Windows reports exit(-1) as 0xffffffff

NEEDS_LIFELINE = sys.platform != "linux"
"""True where the kernel does not end children with their parent."""


class Process:
    """A running program, and everything that it starts."""

    def __init__(
        self, popen: subprocess.Popen[bytes], job: Any, *, own_session: bool, sandbox_fd: int | None = None
    ) -> None:
        self._popen = popen
        self._job = job
        self._own_session = own_session
        self._wrapped = sandbox_fd is not None
        self._sandbox_fd = sandbox_fd  # read end of a pipe that ends with the last process of bubblewrap's
        self._looked_at_pid: int | None = None

    def exit_status(self, timeout_s: float) -> int | None:
        """Wait for its end up to ``timeout_s``; return its exit status (negative: minus a signal), None if it runs.

        On POSIX 128 + n also means signal n, as in shells, so that it means the same with and without bubblewrap. If a
        program exits with a negative number, Windows reports the same as POSIX: 255 for -1.
        """
        try:
            status = self._popen.wait(timeout_s)
        except subprocess.TimeoutExpired:
            return None
        if sys.platform == "win32":
            return status & 0xFF if status >= _NEGATIVE_FROM else status
        by_signal = status - _STATUS_OF_SIGNALS
        return -by_signal if 0 < by_signal <= _MAX_SIGNALS else status

    def has_ended(self) -> bool:
        """Return whether it is over."""
        return self._popen.poll() is not None

    def has_lost_main_thread(self) -> bool:
        """Return whether its main thread has ended and others run on (Linux); waits while the process may be ending."""
        return process_stats.has_lost_main_thread(self._pid_to_look_at()) and self.exit_status(_DUMP_S) is None

    def remember_program(self) -> None:
        """Find the program's process and remember it. Called when the program has sent something, so it exists."""
        self._looked_at_pid = self._innermost_pid()

    def threads(self) -> int:
        """Return its number of threads; 0 if that is unknown."""
        return process_stats.threads_of(self._pid_to_look_at()) if sys.platform == "linux" else 0

    def times(self) -> ProcessTimes | None:
        """Return the kernel's counts for it until now; None if they are unknown."""
        if sys.platform == "win32":
            with contextlib.suppress(OSError):
                return ProcessTimes(self._job.computed_s(), None)
            return None
        return process_stats.process_times(self._pid_to_look_at())

    def is_runnable(self, thread: int) -> bool:
        """Return whether one of its threads runs or waits for a processor at this moment (Linux)."""
        return process_stats.is_runnable(self._pid_to_look_at(), thread)

    def suspend(self) -> None:
        """Stop all its threads until `resume` (POSIX)."""
        self._signal("SIGSTOP")

    def resume(self) -> None:
        """Let its threads go on."""
        self._signal("SIGCONT")

    def _signal(self, name: str) -> None:
        number = getattr(signal, name, None)
        if number is not None and not self.has_ended():
            with contextlib.suppress(ProcessLookupError):
                os.kill(self._innermost_pid(), number)

    def nameless_bytes(self, output_fd: int, folder: Path, *, in_memory: bool) -> float:
        """Return the size of files that it has deleted and still uses (`scratch.nameless_bytes`).

        Infinite if it has lost its main thread: then the system does not show its open files.
        """
        if self.has_lost_main_thread():
            return math.inf
        return scratch.nameless_bytes(self._pid_to_look_at(), output_fd, folder, in_memory=in_memory)

    def dump_traceback(self, lifeline_fd: int | None) -> None:
        """Let it write its present traceback to its log and end. It may refuse, so `kill` afterwards.

        A signal asks for it (POSIX); or its watch, by ``lifeline_fd``, the parent's end of its lifeline.
        """
        if lifeline_fd is not None:
            with contextlib.suppress(OSError):
                os.write(lifeline_fd, b"?")
            self.exit_status(_DUMP_S)
        if sys.platform != "win32" and not self.has_ended():
            with contextlib.suppress(ProcessLookupError):
                os.kill(self._innermost_pid(), signal.SIGABRT)
                os.kill(self._innermost_pid(), signal.SIGCONT)  # it may have stopped itself
            self.exit_status(_DUMP_S)

    def kill(self) -> None:
        """End it and all its descendants at once, and wait until it is gone."""
        if self._wrapped:
            bubblewrap.kill_innermost(self._popen.pid)
        if sys.platform == "win32":
            self._job.terminate()
        elif self._own_session:
            with contextlib.suppress(ProcessLookupError, PermissionError):
                os.killpg(self._popen.pid, signal.SIGKILL)
        with contextlib.suppress(OSError):
            self._popen.kill()
        self._popen.wait()
        if self._sandbox_fd is not None:
            bubblewrap.wait_for_exit(self._sandbox_fd)
            os.close(self._sandbox_fd)
            self._sandbox_fd = None

    def _pid_to_look_at(self) -> int:
        """Return the program's process, which may have ended, so do not kill by this id. The search takes long."""
        return self._innermost_pid() if self._looked_at_pid is None else self._looked_at_pid

    def _innermost_pid(self) -> int:
        return bubblewrap.innermost(self._popen.pid) if self._wrapped else self._popen.pid


def start(
    cwd: Path,
    environment: dict[str, str],
    log_fd: int | None,
    memory_bytes: int | None,
    *,
    lifeline: bool,
    prefix: Sequence[str] = (),
) -> tuple[Process, int, int, int | None]:
    """Start the program that the first message will describe.

    Return it with the parent's ends of three pipes: for frames from it, for frames to it, and its lifeline. It notices
    when the last closes, and writes its traceback when that is written to; None where the kernel ends it and a signal
    requests the traceback.

    Args:
        cwd: where it starts.
        environment: all of its environment variables.
        log_fd: where its output goes; None: it has this process's terminal, for debugging.
        memory_bytes: limit that the platform sets from outside (Windows); None: no limit.
        lifeline: whether it gets a pipe by which it notices the end of this process.
        prefix: of `bubblewrap.prefix`, the command that starts it; empty: it is started directly.

    Raises:
        OSError: it cannot be started.
    """
    _compile_program_side()
    with contextlib.ExitStack() as undo:
        theirs_read, write_fd = _pipe(undo)
        read_fd, theirs_write = _pipe(undo)
        theirs_life, lifeline_fd = _pipe(undo) if lifeline else (None, None)
        sandbox_fd, theirs_sync = _pipe(undo) if prefix else (None, None)
        inherited = [fd for fd in (theirs_read, theirs_write, theirs_life, theirs_sync) if fd is not None]
        wrapping = prefix if theirs_sync is None else bubblewrap.held_open_until_exit(theirs_sync, prefix)
        arguments = [*_handles(theirs_read, theirs_write, theirs_life), str(PROGRAM_SIDE)]
        process = _popen(
            [*wrapping, python(), "-s", "-S", "-P", "-B", "-X", "utf8", "-X", "faulthandler", "-c", _START, *arguments],
            inherited,
            {"cwd": cwd, "env": environment},
            log_fd,
            memory_bytes,
            sandbox_fd=sandbox_fd,
        )
        undo.pop_all()
    for fd in inherited:
        os.close(fd)
    return process, read_fd, write_fd, lifeline_fd


def _pipe(undo: contextlib.ExitStack) -> tuple[int, int]:
    read_fd, write_fd = os.pipe()
    undo.callback(os.close, read_fd)
    undo.callback(os.close, write_fd)
    return read_fd, write_fd


def _popen(
    command: list[str],
    inherited: list[int],
    place: dict[str, Any],
    log_fd: int | None,
    memory_bytes: int | None,
    *,
    sandbox_fd: int | None,
) -> Process:
    streams: dict[str, Any] = {}
    if log_fd is not None:
        streams = {"stdin": subprocess.DEVNULL, "stdout": log_fd, "stderr": log_fd}
    if sys.platform == "win32":
        # A window of its own for each program would cover the pupil's screen.
        flags = 0 if log_fd is None else subprocess.CREATE_NO_WINDOW | subprocess.CREATE_NEW_PROCESS_GROUP
        job = Job(memory_bytes)
        popen = subprocess.Popen(command, creationflags=flags, startupinfo=startup_info(inherited), **place, **streams)
        try:
            job.add(popen)
        except OSError:
            popen.kill()
            raise
        return Process(popen, job, own_session=True)
    # A session of its own: Ctrl-C reaches only the match, and all that it starts can be ended together. A program that
    # is debugged stays in ours, where the terminal is.
    own_session = log_fd is not None
    with memory_addresses.fixed():
        popen = subprocess.Popen(
            command, pass_fds=inherited, start_new_session=own_session, restore_signals=True, **place, **streams
        )
    return Process(popen, None, own_session=own_session, sandbox_fd=sandbox_fd)


def _handles(*fds: int | None) -> list[str]:
    if sys.platform == "win32":
        return [str(-1 if fd is None else msvcrt.get_osfhandle(fd)) for fd in fds]
    return [str(-1 if fd is None else fd) for fd in fds]


def python() -> str:
    """Return the interpreter. On Windows that of a virtual environment only starts the real one: return that."""
    if sys.platform == "win32":
        return str(getattr(sys, "_base_executable", sys.executable))
    return sys.executable


@functools.cache
def _compile_program_side() -> None:
    """Byte-compile what every program imports: programs themselves write no byte code."""
    for source in sorted((PROGRAM_SIDE / "controller").glob("*.py")):
        compiled = Path(cache_from_source(str(source)))
        with contextlib.suppress(OSError, py_compile.PyCompileError):
            if not compiled.exists() or compiled.stat().st_mtime < source.stat().st_mtime:
                py_compile.compile(str(source), doraise=True)


@functools.cache
def site_folders() -> list[str]:
    """Return the folders from which programs may import what is installed: those that hold numpy or scipy."""
    return [
        entry
        for entry in sys.path
        if entry and any((Path(entry) / package / "__init__.py").is_file() for package in ("numpy", "scipy"))
    ]


def is_crash(status: int) -> bool:
    """Return whether an exit status means that the system ended the process (a signal; an exception on Windows)."""
    return status < 0 or status >= _EXCEPTIONS_FROM


def is_cpu_limit(status: int, cpu_s: float, limit_s: float) -> bool:
    """Return whether the kernel ended a process for its CPU time: by SIGXCPU, and by SIGKILL if it ignored that."""
    if sys.platform == "win32":
        return False
    return status == -signal.SIGXCPU or (status == -signal.SIGKILL and cpu_s > _NEARLY * limit_s)


def describe_status(status: int) -> str:
    """Return the meaning of the exit status of a crash in words."""
    if status < 0:
        with contextlib.suppress(ValueError):
            name = signal.Signals(-status).name
            why = ": it used more processor time than it may" if name == "SIGXCPU" else ""
            return f"the signal {name}{why}"
        return f"signal {-status}"
    return f"the exception {status:#010x}"
