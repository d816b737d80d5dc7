"""The command ``rcj-challenge``.

Belongs here: options, exit codes, and which room is called. Does not belong here: work. Every command imports what it
needs when it runs, so that ``validate`` loads no physics and ``--help`` loads nothing.

Exit codes: 0 done, 1 a negative verdict, 2 wrong input, 3 a fault of ours (with a report file), 130 interrupted.
"""

from __future__ import annotations

import copy
import gc
import os
import sys
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


def main() -> None:
    """Run the command line and exit with its code."""
    _start_quickly()
    _end_gently()
    try:
        sys.exit(_exit_code())
    finally:
        # At its end the interpreter would look through all objects for garbage, 80 ms, just before it gives all back.
        gc.freeze()


def _exit_code() -> int:
    """Run the command line; returns its exit code."""
    from rcj_challenges.cli.app import app

    try:
        code = _of_one_command(app, sys.argv[1:2])(standalone_mode=False)
    except BrokenPipeError:
        return OK  # the reader of our output has seen enough
    except (Exception, KeyboardInterrupt) as error:  # noqa: BLE001 - the last line of defence
        return _told(error)
    return code if isinstance(code, int) else OK


def _told(error: BaseException) -> int:
    """Say what ended a command; returns its exit code. What is unexpected becomes a report."""
    from rcj_challenges.cli.faults import report_our_fault
    from rcj_challenges.facts.errors import RcjError, is_of_the_host, told_of

    if isinstance(error, RcjError):
        _complain(str(error))
        return error.exit_code
    if _is_interruption(error):
        _complain("interrupted")
        return INTERRUPTED
    if is_of_the_host(error):
        where = f": {error.filename}" if isinstance(error, OSError) and error.filename else ""
        _complain(f"this computer cannot go on: {told_of(error)}{where}")
        return WRONG_INPUT
    return _usage_error(error) or report_our_fault(error)


def _is_interruption(error: BaseException | None) -> bool:
    """Return whether somebody interrupted us: in the middle of an import that comes out as an error of the import."""
    return error is not None and (isinstance(error, KeyboardInterrupt) or _is_interruption(error.__context__))


def _end_gently() -> None:
    """Let what ends a service or a closed terminal end a command as Ctrl-C does: with its record closed."""
    import signal

    for name in ("SIGTERM", "SIGHUP"):
        number = getattr(signal, name, None)
        # Who starts us under nohup wants us to go on.
        if number is not None and signal.getsignal(number) is signal.SIG_DFL:
            signal.signal(number, signal.default_int_handler)


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
    print(message, file=sys.stderr)  # noqa: T201 - this is the terminal
