"""The command ``rcj-challenge``.

Belongs here: options, exit codes, and which room is called. Does not belong here: work. Every command imports what it
needs when it runs, so that ``validate`` loads no physics and ``--help`` loads nothing.

Exit codes: 0 done, 1 a negative verdict, 2 wrong input, 3 a fault of ours (with a report file), 130 interrupted.
"""

from __future__ import annotations

import contextlib
import copy
import gc
import math
import os
import sys
import time
from typing import TYPE_CHECKING

from rcj_challenges.facts.letters import READABLE

if TYPE_CHECKING:
    from typer import Typer
    from typer.models import CommandInfo

OK = 0
NEGATIVE = 1
WRONG_INPUT = 2
OUR_FAULT = 3
INTERRUPTED = 130

_OBJECTS_BETWEEN_COLLECTIONS = 50_000
"""Some MB at most; Python's own 700 means a hundred collections until the first command begins."""

_ONE_AND_THE_SAME_S = 1.0
"""Signals that follow each other faster mean one thing."""


def main() -> None:
    """Run the command line and exit with its code."""
    from rcj_challenges.cli.says import open_what_is_closed

    open_what_is_closed()
    _start_quickly()
    heard = _end_gently()
    try:
        code = _exit_code()
        if code == INTERRUPTED:
            _hear_no_more(heard)
        sys.exit(code)
    finally:
        # At its end the interpreter would look through all objects for garbage, 80 ms, just before it gives all back.
        gc.freeze()


def _exit_code() -> int:
    """Run the command line; returns its exit code."""
    from rcj_challenges.cli.says import say_no_more

    code: object = OK
    try:
        from rcj_challenges.cli.app import app

        code = _of_one_command(app, sys.argv[1:2])(standalone_mode=False)
        sys.stdout.flush()
    except BrokenPipeError:
        say_no_more(sys.stdout)  # the reader of our output has seen enough
    except SystemExit as error:
        # The library of the command line makes that of a broken pipe, with the status of a negative verdict.
        return OK if isinstance(error.__context__, BrokenPipeError) else _status(error.code)
    except (Exception, KeyboardInterrupt) as error:  # noqa: BLE001 - the last line of defence
        return _told(error)
    return _status(code)


def _status(code: object) -> int:
    return code if isinstance(code, int) else OK


def _told(error: BaseException) -> int:
    """Say what ended a command; returns its exit code. What is unexpected becomes a report."""
    from rcj_challenges.cli.faults import report_our_fault
    from rcj_challenges.facts.errors import RcjError, interruption_behind, is_of_the_host, told_of

    if isinstance(error, RcjError):
        _complain(str(error))
        return error.exit_code
    if interruption_behind(error) is not None:
        _complain("interrupted")
        return INTERRUPTED
    if is_of_the_host(error):
        where = f": {error.filename}" if isinstance(error, OSError) and error.filename else ""
        _complain(f"this computer cannot go on: {told_of(error)}{where}")
        return WRONG_INPUT
    return _usage_error(error) or report_our_fault(error)


def _end_gently() -> list[int]:
    """Let what ends a service or a closed terminal end a command as Ctrl-C does: with its record closed.

    Such signals often come twice: a closed terminal tells its shell, and the shell its commands. The second does not
    disturb what the first began; who wants to go at once waits a second until he says so again.

    Returns:
        The signals that we hear from now on.
    """
    import signal

    interrupted_at_s = -math.inf

    def interrupt(*_: object) -> None:
        nonlocal interrupted_at_s
        now_s = time.monotonic()
        if now_s - interrupted_at_s > _ONE_AND_THE_SAME_S:
            interrupted_at_s = now_s
            raise KeyboardInterrupt

    heard = []
    for name in ("SIGINT", "SIGTERM", "SIGHUP"):
        number = getattr(signal, name, None)
        # Who starts us under nohup wants us to go on.
        if number is not None and signal.getsignal(number) in (signal.SIG_DFL, signal.default_int_handler):
            signal.signal(number, interrupt)
            heard.append(number)
    return heard


def _hear_no_more(heard: list[int]) -> None:
    """Let no second signal change the exit code: while it ends, the interpreter would take it as a sudden death."""
    import signal

    for number in heard:
        signal.signal(number, signal.SIG_IGN)


def _start_quickly() -> None:
    """Spare the start what it does not need."""
    # Pydantic would look for plug-ins in the metadata of every installed package.
    os.environ.setdefault("PYDANTIC_DISABLE_PLUGINS", "__all__")
    # numpy would start a thread for each further core, and nothing here multiplies large matrices.
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    # Imports make tens of thousands of objects that stay: to look for garbage among them again and again is in vain.
    gc.set_threshold(_OBJECTS_BETWEEN_COLLECTIONS, *gc.get_threshold()[1:])


def _of_one_command(app: Typer, asked: list[str]) -> Typer:
    """Return the app with the command asked for alone: to read the options of all of them takes 20 ms.

    If it is none of the commands, the app is returned as it is: it knows what to say.
    """
    commands = [one for one in app.registered_commands if [_name_of(one)] == asked]
    if not commands:
        return app
    quick = copy.copy(app)
    quick.registered_commands, quick.registered_groups = commands, []
    return quick


def _name_of(command: CommandInfo) -> str:
    return command.name or (command.callback.__name__.replace("_", "-") if command.callback else "")


def _usage_error(error: BaseException) -> int | None:
    """Show a wrong option as the command line's own words; None if the error is something else."""
    show = getattr(error, "show", None)
    code = getattr(error, "exit_code", None)
    if show is not None and isinstance(code, int):
        with contextlib.suppress(OSError):
            show()
        return WRONG_INPUT
    if type(error).__name__ == "Abort":
        _complain("interrupted")
        return INTERRUPTED
    return None


def _complain(message: str) -> None:
    for stream in (sys.stdout, sys.stderr):
        reconfigure = getattr(stream, "reconfigure", None)
        if reconfigure is not None:
            reconfigure(errors=READABLE)
    with contextlib.suppress(OSError):  # a full disk, or nobody there: the exit code still tells
        print(message, file=sys.stderr, flush=True)  # noqa: T201 - this is the terminal
