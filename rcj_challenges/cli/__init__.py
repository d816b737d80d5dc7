"""The command ``rcj-challenge``.

Belongs here: options, exit codes, and which room is called. Does not belong here: work. Every command imports what it
needs when it runs, so that ``validate`` loads no physics and ``--help`` loads nothing.

Exit codes: 0 done, 1 a negative verdict, 2 wrong input, 3 a fault of ours (with a report file), 130 interrupted.
"""

# Until `main` handles Ctrl-C, Python prints a traceback for it, so slow imports come later.
from __future__ import annotations

import gc
import os
import sys
import time
from types import ModuleType

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable

    from rcj_challenges.core.errors import RcjError

OK = 0
WRONG_INPUT = 2
OUR_FAULT = 3
INTERRUPTED = 130

_OBJECTS_BETWEEN_COLLECTIONS = 500_000
"""Some tens of MB at most. A command imports 100 000 objects that stay: a collection among them takes 35 ms in vain."""

_SAME_SIGNAL_S = 1.0
"""Signals that follow each other faster mean one thing."""


class CommandInterruptedError(BaseException):
    """Ctrl-C while a command worked.

    Not a KeyboardInterrupt, which the library of the command line handles itself, ending silently.
    """


def main(on_error: Callable[[RcjError], None] | None = None) -> None:
    """Run the command line and exit with its code; ``on_error`` is called with what was printed as its error."""
    handled: list[int] = []
    try:
        code = _exit_code(handled, on_error)
        if code == INTERRUPTED:
            _ignore_signals(handled)
        sys.exit(code)
    finally:
        # At its end the interpreter would look through all objects for garbage, 80 ms, just before it gives all back.
        gc.freeze()


def _exit_code(handled: list[int], on_error: Callable[[RcjError], None] | None) -> int:
    """Run the command line; return its exit code. ``handled`` receives the signals that are handled from now on."""
    begun: list[object] = []
    interrupted_at_s: list[float] = []
    code: object = OK
    try:
        handled += _install_signal_handlers(interrupted_at_s)
        from rcj_challenges.cli.stdio import (
            detect_closed_pipes,
            discard_output,
            open_closed_streams,
            replace_unencodable,
        )

        open_closed_streams()
        if sys.platform == "win32":
            detect_closed_pipes()
        replace_unencodable()
        _speed_up_start()
        from rcj_challenges.cli.commands import load_app

        code = load_app(*sys.argv[1:2])(standalone_mode=False, obj=begun)
        sys.stdout.flush()
    except BrokenPipeError:
        discard_output(sys.stdout)  # the reader of our output has closed it
    except SystemExit as error:
        # The library of the command line makes that of a broken pipe, with the status of a negative verdict.
        return OK if isinstance(error.__context__, BrokenPipeError) else _status(error.code)
    except (Exception, KeyboardInterrupt, CommandInterruptedError) as error:  # noqa: BLE001 - the last line of defence
        just_now = any(time.monotonic() - at_s <= _SAME_SIGNAL_S for at_s in interrupted_at_s)
        return _report_error(error, on_error, begun=bool(begun), interrupted=just_now)
    if code == INTERRUPTED and not begun:  # the library caught it while it read the options
        return _report_error(KeyboardInterrupt(), on_error, begun=False)
    return _status(code)


def _status(code: object) -> int:
    return code if isinstance(code, int) else OK


def _report_error(
    error: BaseException, on_error: Callable[[RcjError], None] | None, *, begun: bool, interrupted: bool = False
) -> int:
    """Print what ended a command that had ``begun`` to work, or not; return its exit code.

    Unexpected errors become a report, unless a signal ``interrupted`` the command just before: libraries that are not
    written in Python may make an error of their own of it, behind which nothing else can be seen.
    """
    from rcj_challenges.cli.crash_report import write_crash_report
    from rcj_challenges.cli.stdio import as_host_error, discard_output, is_output_error
    from rcj_challenges.core.diagnostics import render_error
    from rcj_challenges.core.errors import RcjError, interruption_behind

    error = _as_missing_package(error)
    if isinstance(error, RcjError) and error.exit_code != OUR_FAULT:
        _print_error(render_error(error))
        if on_error is not None:
            on_error(error)
        return error.exit_code
    interruption = interruption_behind(error)
    if interruption is not None:
        reason = str(interruption) if begun else "nothing had begun"
        _print_error(f"interrupted: {reason}" if reason else "interrupted")
        return INTERRUPTED
    host_error = as_host_error(error)
    if host_error is not None:
        if is_output_error(error):
            discard_output(sys.stdout)  # else the interpreter reports it again
        _print_error(render_error(host_error))
        return WRONG_INPUT
    usage = _usage_error(error)
    if usage is None and interrupted:
        return _report_error(KeyboardInterrupt(), on_error, begun=begun)
    return write_crash_report(error) if usage is None else usage


def _as_missing_package(error: BaseException) -> BaseException:
    """The error unchanged, or with help if a package is missing."""
    package = (error.name or "").partition(".")[0] if isinstance(error, ModuleNotFoundError) else ""
    if package in ("", __name__.partition(".")[0], *sys.stdlib_module_names):
        return error
    from rcj_challenges.cli.codes import MISSING_PACKAGE
    from rcj_challenges.core.errors import HostError

    return HostError(
        f"the package {package!r} is missing: this Python does not have all that rcj-challenge needs",
        "install it as the README says, or start the Python in which it is installed",
        code=MISSING_PACKAGE,
    )


def _install_signal_handlers(interrupted_at_s: list[float]) -> list[int]:
    """Handle the signals that end a service or a closed terminal like Ctrl-C: the record is closed.

    Such signals often come twice: from a closed terminal and from its shell. A second one within a second is ignored.
    ``interrupted_at_s`` takes the times of the others.

    Returns:
        The signals that are handled from now on.
    """
    import signal

    def interrupt(*_: object) -> None:
        now_s = time.monotonic()
        if not interrupted_at_s or now_s - interrupted_at_s[-1] > _SAME_SIGNAL_S:
            interrupted_at_s.append(now_s)
            raise KeyboardInterrupt

    if sys.platform != "win32":
        # Some services start commands that ignore it: the exit codes of programs would be lost, and Bubblewrap hangs.
        signal.signal(signal.SIGCHLD, signal.SIG_DFL)
    handled = []
    for name in ("SIGINT", "SIGTERM", "SIGHUP", "SIGBREAK"):  # the last one is Ctrl-Break on Windows
        number = getattr(signal, name, None)
        # Under nohup the command should go on.
        if number is not None and signal.getsignal(number) in (signal.SIG_DFL, signal.default_int_handler):
            signal.signal(number, interrupt)
            handled.append(number)
    return handled


def _ignore_signals(handled: list[int]) -> None:
    """Ignore further signals while the interpreter ends: they would change the exit code."""
    import signal

    for number in handled:
        signal.signal(number, signal.SIG_IGN)


class _NoPlugins(ModuleType):
    """Stands in for pydantic's search for plug-ins, which imports 35 modules even if it is switched off."""

    get_plugins = staticmethod(tuple)

    def __getattr__(self, name: str) -> object:
        """What another version of pydantic has there, from the module itself."""
        if name.startswith("__"):
            raise AttributeError(name)
        del sys.modules[self.__name__]
        return getattr(__import__(self.__name__, fromlist=[name]), name)


def _speed_up_start() -> None:
    """Skip work that the start does not need."""
    sys.modules.setdefault("pydantic.plugin._loader", _NoPlugins("pydantic.plugin._loader"))
    # Pydantic would look for plug-ins in the metadata of every installed package.
    os.environ.setdefault("PYDANTIC_DISABLE_PLUGINS", "__all__")
    # numpy would start a thread for each further core, and nothing here multiplies large matrices.
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    # Imports make tens of thousands of objects that stay: to look for garbage among them again and again is in vain.
    gc.set_threshold(_OBJECTS_BETWEEN_COLLECTIONS, *gc.get_threshold()[1:])


def _usage_error(error: BaseException) -> int | None:
    """Print what is wrong with options; returns the exit code, None if the error is something else."""
    import contextlib

    from rcj_challenges.core.diagnostics import Diagnostic

    show, context = getattr(error, "show", None), getattr(error, "ctx", None)
    if show is not None and type(error).__name__ == "NoArgsIsHelpError":
        with contextlib.suppress(OSError):
            show()
        return WRONG_INPUT
    format_message = getattr(error, "format_message", None)
    if format_message is not None:
        from rcj_challenges.cli.codes import BAD_ARGUMENTS

        command = getattr(context, "command_path", "rcj-challenge")
        _print_error(str(Diagnostic(BAD_ARGUMENTS, format_message(), f"{command} --help")))
        return WRONG_INPUT
    if type(error).__name__ == "Abort":
        _print_error("interrupted")
        return INTERRUPTED
    return None


def _print_error(message: str) -> None:
    from rcj_challenges.cli.stdio import discard_output
    from rcj_challenges.core.letters import READABLE
    from rcj_challenges.core.sanitize import sanitize_lines

    for stream in (sys.stdout, sys.stderr):
        reconfigure = getattr(stream, "reconfigure", None)
        if reconfigure is not None:
            reconfigure(errors=READABLE)
    try:
        print(sanitize_lines(message), file=sys.stderr, flush=True)  # noqa: T201 - this is the terminal
    except OSError:  # a full disk or a closed stream: the exit code still shows it
        discard_output(sys.stderr)
