"""Formats the traceback of a crashed program: only its own lines, with paths relative to the team's folder."""

# ruff: noqa: PTH120, PLC0415, SIM105 - each import costs every program, so there are few, and late ones

from __future__ import annotations

import os
import sys

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

_COMMON_DEPTH = 2  # of /usr/local: so many separators

_real_name = type.__dict__["__name__"].__get__  # whatever the class's own class says


def short_names(team_root: str, site_folders: list[str]) -> list[tuple[str, str]]:
    """Return folders of this computer, which no record may contain, with their replacements; inner ones first."""
    slashed = team_root.replace(os.sep, "/")
    shown = [(team_root + os.sep, ""), (slashed + "/", ""), (team_root, "."), (os.path.dirname(team_root), "~")]
    ours = os.path.dirname(os.path.dirname(__file__))  # where `controller` is; not always installed
    shown += [(folder, "site-packages") for folder in (ours, *site_folders) if folder]  # '' is in everything
    shown += [(place, "python") for place in (os.path.dirname(os.__file__), sys.executable) if place]
    # In /usr or C:\Python311 it reveals nothing about this computer, and is a part of too many other paths.
    shown += [(place, "python") for place in (sys.prefix, sys.base_prefix) if place.count(os.sep) > _COMMON_DEPTH]
    # The debugger writes them in lower case on Windows.
    shown += [(small, short) for path, short in shown if (small := os.path.normcase(path)) != path]
    # Errors quote paths, and there backslashes are doubled.
    return shown + [(path.replace("\\", "\\\\"), short) for path, short in shown if "\\" in path]


def describe(error: BaseException, team_root: str, names: list[tuple[str, str]]) -> tuple[str, str]:
    """Return the error in one line, and the traceback of the program's own lines."""
    try:
        report = _with_standard_library(_describe, error, team_root + os.sep)
        for path, short in names:
            report = report[0].replace(path, short), report[1].replace(path, short)
    except BaseException:  # noqa: BLE001 - a program may break everything that is used here; the fault must be reported
        return _plainly(error, team_root + os.sep), ""
    return report


def _plainly(error: BaseException, inside: str) -> str:
    """Format an error with only the interpreter's own means."""
    report: str = _real_name(type(error))
    try:
        given = BaseException.args.__get__(error)  # type: ignore[attr-defined]  # whatever its class calls so
        if given and type(given[0]) is str:
            report += f": {given[0][:1_000]}"
        return report + _place(error, inside)
    except BaseException:  # noqa: BLE001 - an audit hook of the program's sees even this
        return report


def _place(error: BaseException, inside: str) -> str:
    place = ""
    step = BaseException.__traceback__.__get__(error)  # type: ignore[union-attr]
    while step is not None:
        code = step.tb_frame.f_code
        if code.co_filename.startswith(inside):
            place = f" ({code.co_filename.removeprefix(inside).replace(os.sep, '/')}, line {step.tb_lineno})"
        step = step.tb_next
    return place


def _describe(error: BaseException, inside: str) -> tuple[str, str]:
    import traceback

    if sys.version_info < (3, 12):  # from then on the library does it
        try:
            _suggest_name(error)
        except BaseException:  # noqa: BLE001, S110 - this calls the program's own methods; the hint is optional
            pass
    report = traceback.TracebackException(type(error), error, error.__traceback__, compact=True)
    _keep_own_frames(report, inside)
    where = ""
    if isinstance(error, SyntaxError) and error.filename:
        report.filename = _slashed(error.filename, inside)
        if error.lineno is None or error.lineno < 1:  # of an encoding that there is not, which stands at the beginning
            report.lineno = "1"
        where = f" ({report.filename}, line {report.lineno})"
    elif report.stack:
        where = f" ({report.stack[-1].filename}, line {report.stack[-1].lineno})"
    last = list(report.format_exception_only())[-1].strip()
    summary = f"{type(error).__name__}: {error.msg}" if isinstance(error, SyntaxError) else " ".join(last.split())
    return summary[:1_000] + where + _on_encoding(error), "".join(report.format())


def _on_encoding(error: BaseException) -> str:
    """Return help for a Python file that is not saved as UTF-8, about which Python's message is obscure."""
    said = str(error) if isinstance(error, (SyntaxError, ValueError)) else ""
    if any(words in said for words in ("cannot contain null bytes", "(unicode error) 'utf-8'", "Non-UTF-8 code")):
        return "; save the file as UTF-8 text in your editor"
    return ""


def _slashed(filename: str, inside: str) -> str:
    return filename.replace(os.sep, "/") if filename.startswith(inside) else filename


def _keep_own_frames(report: Any, inside: str) -> None:
    """Drop the frames of everything but the program, in the exception and in those it came from."""
    seen = set()
    todo = [report]
    while todo:
        entry = todo.pop()
        if entry is None or id(entry) in seen:
            continue
        seen.add(id(entry))
        entry.stack[:] = [frame for frame in entry.stack if frame.filename.startswith((inside, "<string>"))]
        for frame in entry.stack:
            frame.filename = _slashed(frame.filename, inside)
        todo += [entry.__cause__, entry.__context__, *(getattr(entry, "exceptions", None) or ())]


def _suggest_name(error: BaseException) -> None:
    """Add what Python itself adds in a terminal: ``Did you mean: 'setVelocity'?``."""
    name = getattr(error, "name", None)
    if not isinstance(error, (AttributeError, NameError)) or not isinstance(name, str):
        return
    if isinstance(error, AttributeError):
        known = dir(error.obj)
    else:
        last = error.__traceback__
        while last is not None and last.tb_next is not None:
            last = last.tb_next
        frame = None if last is None else last.tb_frame
        known = [] if frame is None else [*frame.f_locals, *frame.f_globals, *frame.f_builtins]
    import difflib

    near = difflib.get_close_matches(name, known, n=1)
    if near and near[0] != name:
        error.args = (f"{error}. Did you mean: '{near[0]}'?",)


def _with_standard_library(call: Callable[[BaseException, str], tuple[str, str]], *of: Any) -> tuple[str, str]:
    """Call what uses modules of the standard library, which import others when they like: none of the team's files."""
    standard = os.path.dirname(os.__file__)
    kept = sys.path[:]
    sys.path[:] = [path for path in kept if isinstance(path, str) and path.startswith(standard)]
    theirs = {key: sys.modules.pop(key) for key in [*sys.modules] if _is_in_the_way(key, standard)}
    try:
        return call(*of)
    finally:
        sys.path[:] = kept
        sys.modules.update(theirs)


def _is_in_the_way(name: str, standard: str) -> bool:
    """Return whether a file of the team stands in the place of a module of the standard library."""
    if name.partition(".")[0] not in sys.stdlib_module_names:
        return False
    file = getattr(sys.modules[name], "__file__", None)
    return isinstance(file, str) and not file.startswith(standard)
