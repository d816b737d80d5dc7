"""Bubblewrap, if installed (Linux): gives a program its own file system, process list and network.

It adds to the layers that a process sets itself (``program_side/controller/_confine.py``): those refuse to open a
file, here the file has no name; all folders but the program's own are read-only; other processes are invisible.
https://github.com/containers/bubblewrap
"""

from __future__ import annotations

import contextlib
import functools
import os
import select
import shutil
import signal
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path

from rcj_challenges.core.sanitize import sanitize

_PROBE_S = 10.0
_GONE_S = 1.0
_DEEPEST = 4  # bubblewrap, its first process inside, the program


def works(python: str, readable: tuple[str, ...]) -> bool:
    """Return whether bubblewrap is installed and can start this Python."""
    return _is_installed() and failure(python, readable) is None


def _is_installed() -> bool:
    return sys.platform == "linux" and shutil.which("bwrap") is not None


@functools.cache
def failure(python: str, readable: tuple[str, ...]) -> str | None:
    """Return the reason why the installed bubblewrap cannot start this Python; None if it can, or is not installed.

    It needs user name spaces, or root; and it hangs if this process ignores SIGCHLD, because it then does so too.
    """
    if not _is_installed():
        return None
    command = [*prefix(python, readable, None), python, "-s", "-S", "-c", "pass"]
    try:
        probe = subprocess.run(command, capture_output=True, timeout=_PROBE_S, check=False)
    except subprocess.TimeoutExpired:
        return f"bwrap did not start Python within {_PROBE_S:g} s"
    except OSError as error:
        return f"bwrap cannot be started: {error.strerror}"
    if probe.returncode == 0:
        return None
    lines = probe.stderr.decode("utf-8", "replace").splitlines()
    return sanitize(f"bwrap cannot start Python: {lines[-1] if lines else f'exit code {probe.returncode}'}")


def prefix(python: str, readable: tuple[str, ...], private: Path | None) -> list[str]:
    """Return the arguments that precede the command of a program.

    Files and folders that are ``readable`` are shown, read-only; a program may write to its ``private`` folder, if any.
    """
    # Of a virtual environment, Python looks for this file next to the folder that it is in.
    shown = [*readable, python, str(Path(python).parent.parent / "pyvenv.cfg")]
    command = [shutil.which("bwrap") or "bwrap", "--unshare-pid", "--unshare-ipc", "--unshare-net", "--new-session"]
    command += ["--die-with-parent", "--proc", "/proc", "--dev", "/dev"]
    # Outer folders first: what is mounted later lies on top.
    for path in sorted(path for path in shown if not path.startswith("/proc/")):
        command += ["--ro-bind-try", path, path]
    if private is not None:
        command += ["--bind", str(private), str(private)]
    # What holds the mounts is in memory, without a limit: nothing may be written there.
    return [*command, "--remount-ro", "/dev", "--remount-ro", "/", "--"]


def held_open_until_exit(fd: int, command: Sequence[str]) -> list[str]:
    """Return a command of `prefix` so that bubblewrap keeps a file open as long as one of its own processes lives."""
    return [command[0], "--sync-fd", str(fd), *command[1:]]


def wait_for_exit(fd: int) -> None:
    """Wait until no process of bubblewrap's lives any more; the program and the outermost one must have ended.

    The outermost one does not wait for the first one inside, which lives up to a few hundredths of a second longer on
    a busy machine. ``fd`` reads the pipe whose write end `held_open_until_exit` was given, or is that of a process.
    """
    poll = select.poll()
    poll.register(fd, select.POLLIN)
    poll.poll(_GONE_S * 1000)


def innermost(pid: int) -> int:
    """Return the process that bubblewrap started, as this process sees it; that of bubblewrap itself if it is gone."""
    for _ in range(_DEEPEST):
        try:
            with open(f"/proc/{pid}/task/{pid}/children", "rb", buffering=0) as file:  # noqa: PTH123 - a match waits
                children = file.read().split()
        except OSError:
            break
        if not children:
            break
        pid = int(children[0])
    return pid


def kill_innermost(pid: int) -> None:
    """End the process that bubblewrap started, and wait until it is gone: bubblewrap does not."""
    if sys.platform != "linux" or (inner := innermost(pid)) == pid:
        return
    with contextlib.suppress(OSError):
        fd = os.pidfd_open(inner)
        try:
            signal.pidfd_send_signal(fd, signal.SIGKILL)
            wait_for_exit(fd)
        finally:
            os.close(fd)
