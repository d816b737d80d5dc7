"""Breakpoints: those of an editor in a program that is debugged, and none in a match."""

# ruff: noqa: PLC0415, T100 - an import costs every program, so this one comes late; it is the debugger that is wanted

from __future__ import annotations

import os
import sys
import time
import types

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


def ignore_breakpoints(robot: str) -> None:
    """Let ``breakpoint()`` do nothing and say so once: several robots may share a program, and one is debugged."""
    printed: list[bool] = []

    def hook(*_: object, **__: object) -> None:
        if not printed:
            printed.append(True)
            print(f"breakpoint() does nothing here; run with --debug {robot} to stop at it", file=sys.stderr)

    sys.breakpointhook = hook


def wait_for_editor(robot: str, folder: str, port: int) -> None:
    """Wait until an editor attaches by the Debug Adapter Protocol, on a port of this computer alone, or a free one.

    debugpy is installed in ``folder``.
    """
    sys.path.append(folder)
    os.environ["PYDEVD_DISABLE_FILE_VALIDATION"] = "1"  # it warns of Python's own files, without breakpoints
    try:
        import debugpy  # type: ignore[import-not-found,unused-ignore]  # an extra

        real_time = types.ModuleType("time")
        real_time.__dict__.update(vars(time))
        try:
            _, port = debugpy.listen(("127.0.0.1", port))
        except (OSError, RuntimeError):
            _, free = debugpy.listen(("127.0.0.1", 0))
            print(f'port {port} is taken: set "port" to {free} in launch.json before you attach', file=sys.stderr)
            port = free
        print(f"{robot} waits for VS Code on port {port}", file=sys.stderr, flush=True)
        debugpy.wait_for_client()
    except KeyboardInterrupt:  # Ctrl-C also interrupts the match, which reports it
        raise SystemExit(1) from None
    finally:
        sys.path.remove(folder)
    # The debugger waits by real time, while the program's stands still at a breakpoint.
    for module in [module for module in sys.modules.values() if _is_below(module, folder)]:
        if vars(module).get("time") is time:
            vars(module)["time"] = real_time


def _is_below(module: Any, folder: str) -> bool:
    file = getattr(module, "__file__", None)
    return (
        isinstance(file, str)
        and file.startswith(folder)
        and module.__name__.startswith(("_pydev", "pydevd", "debugpy"))
    )
