"""Names that a program uses and has not: what it forgot to import, or calls in another way than it is defined."""

from __future__ import annotations

import importlib
import importlib.util
import math
import re
import sys
from collections.abc import Mapping
from pathlib import Path, PurePosixPath
from typing import Any

from rcj_challenges.checker.advice.crash_lines import CrashLine, crash_line, text_of
from rcj_challenges.checker.modules import REFUSED
from rcj_challenges.facts.shown import shown

_DO_SOMETHING = frozenset({"antigravity", "this"})  # when they are imported
_MOST_NAME = 100  # letters
_TEXT = re.compile(r"[ \t]*[bfru]{0,2}[\"']", re.IGNORECASE)
"""How a text begins: who writes ``log("kick-off")`` means no function of ``math``."""


def on_unknown_name(name: str, detail: str, files: Mapping[PurePosixPath, bytes]) -> str:
    """Return what to do about a name that is not defined; nothing if that does not show.

    Args:
        name: which.
        detail: the last line of what the program told of its end, and its place.
        files: of the team.
    """
    line = crash_line(detail, files)
    if line is None:
        return ""
    at_the_top = f"at the top of {shown(line.file.name)}"
    attributes = re.findall(rf"(?<![\w.]){name}\.(\w{{1,{_MOST_NAME}}})", line.code)
    if attributes:
        imported = _import_of(name, attributes[0])
        return f'write "{imported}" {at_the_top}' if imported else ""
    if not (called := re.search(rf"(?<![\w.]){name}\((?P<with>.{{0,4}})", line.code)):
        return ""
    programs = {path: text_of(content) for path, content in files.items() if path.suffix == ".py" or path == line.file}
    if any(re.search(rf"\b(?:def|class)[ \t]{{1,4}}{name}\b", program) for program in programs.values()):
        return _on_own(name, line, programs)
    is_of_math = callable(getattr(math, name, None)) and not _TEXT.match(called["with"])
    return f'write "from math import {name}" {at_the_top}' if is_of_math else ""


def _import_of(name: str, attribute: str) -> str:
    """Return the line that gives a program ``name.attribute`` of a library; nothing if no match has any such."""
    if name in ("np", "numpy"):
        return "import numpy as np" if name == "np" else "import numpy"
    if name not in sys.stdlib_module_names or name in _DO_SOMETHING or name in REFUSED:
        return ""
    if not _is_of_python(name):
        return ""
    try:
        module: Any = importlib.import_module(name)
    except ImportError:  # a Python that was built without it, or another system
        return ""
    if hasattr(module, attribute):
        return f"import {name}"
    # `datetime.now()` is of the class.
    return f"from {name} import {name}" if hasattr(getattr(module, name, None), attribute) else ""


def _is_of_python(name: str) -> bool:
    """Return whether a module is that of Python: not of another system, nor a file of this name in the current folder.

    With ``python -m`` that folder comes first, and a team's files may lie in it: they are never run here.
    """
    try:
        spec = importlib.util.find_spec(name)
    except (ImportError, ValueError):
        return False
    if spec is None or spec.origin is None:
        return False
    return spec.origin in ("built-in", "frozen") or Path(spec.origin).resolve().is_relative_to(
        Path(sys.base_prefix).resolve()
    )


def _on_own(name: str, line: CrashLine, programs: Mapping[PurePosixPath, str]) -> str:
    """Tell of a function or a class of the team's: below the call, in a class, or in the file beside this one."""
    own = programs[line.file]
    if found := re.search(rf"^(?P<kind>def|class)[ \t]{{1,4}}{name}\b", own, re.MULTILINE):
        defined = own.count("\n", 0, found.start()) + 1
        return (
            f"line {line.number} uses {name} before Python has read line {defined}, where it is defined: move that up"
            if defined > line.number
            else ""
        )
    if re.search(rf"^[ \t]{{1,40}}def[ \t]{{1,4}}{name}[ \t]{{0,4}}\([ \t]{{0,4}}self\b", own, re.MULTILINE):
        return f"{name} is a method: within its class it is called self.{name}(…), elsewhere as that of an object"
    return _on_another_file(name, line, programs)


def _on_another_file(name: str, line: CrashLine, programs: Mapping[PurePosixPath, str]) -> str:
    """Tell of a function or a class that stands in the file beside this one."""
    folder = {path: program for path, program in programs.items() if path.parent == line.file.parent}
    beside = [path for path, program in folder.items() if _defines(name, program)]
    if len(beside) != 1 or _imports(line.file.stem, folder[beside[0]]):  # else they would import each other
        return ""
    stem = beside[0].stem
    alias = rf"(?:[ \t]{{1,4}}as[ \t]{{1,4}}(\w{{1,{_MOST_NAME}}}))?"
    as_a_whole = rf"^[ \t]{{0,40}}import[ \t]{{1,4}}{re.escape(stem)}{alias}[ \t]{{0,40}}$"
    if found := re.search(as_a_whole, folder[line.file], re.MULTILINE):
        return f"{name} is in {shown(beside[0].name)}: write {found[1] or stem}.{name}(…)"
    # In a package its files have other names.
    if not any(_imports(known, program) for known in (stem, line.file.stem) for program in folder.values()):
        return ""
    return f'write "from {stem} import {name}" at the top of {shown(line.file.name)}'


def _defines(name: str, program: str) -> bool:
    return re.search(rf"^(?:def|class)[ \t]{{1,4}}{name}\b", program, re.MULTILINE) is not None


def _imports(module: str, program: str) -> bool:
    words = rf"^[ \t]{{0,40}}(?:from|import)[ \t]{{1,4}}{re.escape(module)}\b"
    return re.search(words, program, re.MULTILINE) is not None
