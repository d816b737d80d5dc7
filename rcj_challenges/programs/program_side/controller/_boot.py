"""Starts a team's program: the first code that runs in its process."""

# ruff: noqa: PTH120, PTH123, PLC0415, SIM105 - each import costs every program, so there are few, and late ones

from __future__ import annotations

import builtins
import os
import sys
import types  # on Linux the layers need it: so a team's own `types.py` is never read on any system

from . import _blocking_calls, _clock, _confine, _connection, _debugger, _legacy, _seeding, _signals, _traceback
from ._hooks import AfterImport
from ._output import Output
from ._wire import HELLO, Wire, fault_frame, leave

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from ._hooks import Patch

_RESERVE_BYTES = 4 << 20  # of addresses, never touched; Python 3.14 needs more than 1 MB to report an error
_MAX_CHARACTERS = 2_000
_SWITCH_S = 0.000_2
"""How long a thread may compute while the stepping thread is ready to run, which happens twice in a step. With Python's
default of 5 ms, a thread that computes for ever would use up more than a half allows."""


class Boot:
    """One program, from its first line to its last."""

    def __init__(self, wire: Wire, hello: dict[str, Any]) -> None:
        self._wire = wire
        self._hello = hello
        self._limits: dict[str, Any] = hello["limits"]
        self._root: str = hello["program"]["root"]
        self._library = sys.path[:]
        self._clock = _clock.Clock(hello["tick_ms"] * 1_000_000)
        self._names = _traceback.short_names(self._root, hello["program"]["site"])
        self._output: Any = types.SimpleNamespace(printed_bytes=0)  # nothing is counted
        if not hello["debug"]:
            _debugger.ignore_breakpoints(hello["robot"]["name"])
            self._output = Output(self._limits["output_bytes"], self._flooded, self._names)
        self._connection = _connection.Connection(wire, hello, self._clock, self._output)
        self._connection.root = self._root

    def confine(self) -> None:
        """Isolate this process while it has only one thread: everything that it starts inherits the layers."""
        try:
            _confine.confine(self._hello["layers"], self._limits)
        except OSError as error:
            self._end("start", f"the program could not be isolated: {error}")
        sys.modules.pop("resource", None)  # a team may have a file of that name, which it then imports

    def run(self) -> None:
        """Run the program and report its end to the match, unless the match ended it."""
        _connection.connect(self._connection)
        sys.setswitchinterval(_SWITCH_S)
        if debugger := self._hello.get("debugger"):
            _debugger.wait_for_editor(self._hello["robot"]["name"], **debugger)
        self._prepare_modules()
        reserve = bytearray(_RESERVE_BYTES)  # released before a lack of memory is reported
        try:
            self._run_entry()
            _wait_for_threads()
        except SystemExit as left:
            if _debugger_quit(left):
                self._crashed("crash", sys.modules["bdb"].BdbQuit().with_traceback(left.__traceback__))
            else:
                self._left(left)
        except MemoryError as error:
            del reserve
            self._crashed("memory", error)
        except BaseException as error:  # noqa: BLE001 - whatever a program raises ends it, KeyboardInterrupt too
            self._crashed("crash", error)
        else:
            self._ended("exit", "the program came to its end while the match goes on: it has to call step in a loop")
        _flush_output()

    def out_of_memory(self) -> None:
        """The program holds more memory than it may (called by the watch)."""
        self._end("memory", "the program takes more memory than it may")

    def _run_entry(self) -> None:
        entry: str = self._hello["program"]["entry"]
        folder = os.path.dirname(entry)
        os.chdir(folder)
        sys.argv = [entry]
        # The program's folder first, as Python does; then the folder that holds all of the team's programs.
        outer = [os.path.dirname(folder)] if folder != self._root else []
        sys.path[:] = [folder, *outer, *self._library, *self._hello["program"]["site"]]
        with open(entry, "rb") as file:
            source = file.read()
        program = type(sys)("__main__")
        program.__dict__.update(__file__=entry, __builtins__=builtins, __cached__=None)
        sys.modules["__main__"] = program
        exec(_compiled(source, entry), program.__dict__)  # noqa: S102 - the team's program

    def _prepare_modules(self) -> None:
        _clock.show_simulated_time(self._clock)
        _signals.hold_interrupts(self._connection)
        seeds = [_seeding.Seeds(self._hello["seed"] + number) for number in range(3)]
        patches: dict[str, Patch] = {
            "datetime": _clock.dates_of(self._clock),
            "random": _seeding.seed_random(seeds[0]),
            "numpy.random.bit_generator": _seeding.seed_numpy_entropy(seeds[1]),
            "numpy.random": _seeding.seed_numpy_global(seeds[2]),
            "signal": lambda signal: _signals.make_patient(signal, self._connection),
        }
        if not self._hello.get("debugger"):  # whose threads really wait
            patches |= _blocking_calls.BlockingCalls(self._clock).patches()
        for module, patch in _legacy.PATCHES.items():
            patches[module] = _in_turn(patches[module], patch) if module in patches else patch
        AfterImport(patches, self._root + os.sep).install()
        # What `site` adds; the interpreter runs without it.
        import _sitebuiltins

        for name in ("exit", "quit"):
            setattr(builtins, name, _sitebuiltins.Quitter(name, "Ctrl-D (i.e. EOF)"))
        builtins.help = _sitebuiltins._Helper()  # noqa: SLF001 - it is what programs know by that name

    def _left(self, left: SystemExit) -> None:
        code = left.code
        if type(code) is str:
            _print_quietly(code)
            self._ended("exit", f"the program called sys.exit: {code[:_MAX_CHARACTERS]}")
        else:
            self._ended("exit", f"the program called sys.exit({'' if code is None else _text_of(code)})")

    def _ended(self, kind: str, detail: str) -> None:
        if not self._connection.over:
            self._end(kind, detail)

    def _crashed(self, kind: str, error: BaseException) -> None:
        if self._hello["debug"] and type(error) is getattr(sys.modules.get("bdb"), "BdbQuit", None):
            self._ended("exit", "the program was ended in the debugger")
            return
        detail, trace = _traceback.describe(error, self._root, self._names)
        if self._connection.over:
            _print_quietly(trace or detail)
        else:
            self._end(kind, detail, trace)

    def _flooded(self) -> None:
        limit_mb = self._limits["output_bytes"] / 1e6
        self._wire.send(fault_frame("output_flood", f"the program printed more than {limit_mb:g} MB"))
        leave(1)

    def _end(self, kind: str, detail: str, trace: str = "") -> None:
        """Report the reason for the end to the match, after all output is written. Never returns."""
        _flush_output()
        self._wire.send(self._connection.take_notes_with(fault_frame(kind, detail, trace)))
        leave(1)


def _compiled(source: bytes, entry: str) -> types.CodeType:
    try:
        return compile(source, entry, "exec", dont_inherit=True)
    except SyntaxError as error:
        error.filename = error.filename or entry  # Python names none where it finds no text
        raise
    except ValueError as error:  # the same before Python 3.11.4
        named = SyntaxError(*error.args)
        named.filename = entry
        raise named from None


def _flush_output() -> None:
    """Write what is printed and waits for the end of its line: first to the streams that a program has replaced."""
    for stream in (sys.__stdout__, sys.__stderr__, sys.stdout, sys.stderr):
        try:
            stream.flush()  # type: ignore[union-attr]  # whatever it is
        except BaseException:  # noqa: BLE001, S110 - a program may have put anything there
            pass


def _in_turn(first: Patch, then: Patch) -> Patch:
    def patch(module: Any) -> None:
        first(module)
        then(module)

    return patch


def _wait_for_threads() -> None:
    """Wait for the threads that the program has started and not joined, as the interpreter does at its end."""
    threading: Any = sys.modules.get("threading")
    if hasattr(threading, "enumerate"):  # the library's, or a file of the team with that name
        for call in reversed(getattr(threading, "_threading_atexits", ())):
            call()  # makes the workers of pools end
        for thread in threading.enumerate():
            if thread is not threading.current_thread() and not thread.daemon:
                thread.join()


def _print_quietly(text: str) -> None:
    try:
        print(text, file=sys.stderr)
    except BaseException:  # noqa: BLE001, S110 - a program may have closed it, or put anything in its place
        pass


def _debugger_quit(left: SystemExit) -> bool:
    """Return whether it was the debugger that left: until Python 3.13 it raises an error of its own there."""
    trace = left.__traceback__
    while trace is not None and trace.tb_next is not None:
        trace = trace.tb_next
    where = None if trace is None else (trace.tb_frame.f_globals.get("__name__"), trace.tb_frame.f_code.co_name)
    return where == ("pdb", "do_quit") and hasattr(sys.modules.get("bdb"), "BdbQuit")


def _text_of(code: object) -> str:
    try:
        return str(code)[:_MAX_CHARACTERS]
    except BaseException:  # noqa: BLE001 - it may raise anything
        return "…"


def _parsed(text: str) -> dict[str, Any]:
    """Return the parent's JSON as Python data.

    JSON as Python writes it, without escapes beyond Python's, is a Python expression; importing ``json`` would cost
    each program 9 ms at its start. The text comes from the match, never from a team.
    """
    names = {"__builtins__": {}, "true": True, "false": False, "null": None}
    return eval(text, names)  # type: ignore[no-any-return]  # noqa: S307 - see above


def _fd(number: int, flags: int) -> int:
    """Return the file descriptor for what the parent handed over: itself, or a handle on Windows."""
    if sys.platform == "win32":
        import msvcrt

        return msvcrt.open_osfhandle(number, flags)
    return number


def main() -> None:
    """Start the program that the parent describes in its first message.

    Arguments of the process: read end, write end and lifeline, as file descriptors (handles on Windows; -1: none); then
    the folder from which this code was imported, which is hidden from the program.
    """
    sys.path.remove(sys.argv[4])
    read_end, write_end, lifeline = (int(argument) for argument in sys.argv[1:4])
    binary = getattr(os, "O_BINARY", 0)
    wire = Wire(_fd(read_end, os.O_RDONLY | binary), _fd(write_end, os.O_WRONLY | binary))
    frame = wire.receive()
    if frame[4] != HELLO:
        leave(1)
    hello = _parsed(frame[5:].decode())
    boot = Boot(wire, hello)
    boot.confine()
    if lifeline >= 0:
        watched = hello["limits"]["memory_bytes"] if hello["limits"]["watch_memory"] else 0
        _confine.watch(_fd(lifeline, os.O_RDONLY | binary), watched, boot.out_of_memory)
    boot.run()
