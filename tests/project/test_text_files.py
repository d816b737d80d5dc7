"""Text files are UTF-8 on every system: whoever opens one says so. Windows would take cp1252, and fail at one letter."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
FOLDERS = ("rcj_challenges", "tests", "scripts", "benchmarks")
OTHERS = ("tests/hostile/programs", "tests/programs", "tests/teams")
"""Programs of teams: they run with UTF-8 whatever the system has."""


def leaves_the_encoding_to_the_system(call: ast.Call) -> bool:
    """Return whether a call opens, reads or writes a text file and does not say in which encoding."""
    function = call.func
    name = function.attr if isinstance(function, ast.Attribute) else getattr(function, "id", "")
    given = [word.arg for word in call.keywords]
    if {"encoding", "fileobj", None} & set(given):
        return False
    if name == "read_text":
        return not call.args
    if name == "write_text":
        return len(call.args) == 1
    if name != "open":
        return False
    first = 0 if isinstance(function, ast.Attribute) else 1  # of a path, or the builtin one
    modes = [word.value for word in call.keywords if word.arg == "mode"] + call.args[first : first + 1]
    if not modes:
        return len(call.args) == first
    return isinstance(modes[0], ast.Constant) and bool(re.fullmatch(r"[rwax]t?\+?t?", str(modes[0].value)))


def calls(source: bytes) -> Iterator[ast.Call]:
    if any(name in source for name in (b"open", b"read_text", b"write_text")):  # to parse all of them takes seconds
        yield from (node for node in ast.walk(ast.parse(source)) if isinstance(node, ast.Call))


def sources() -> Iterator[Path]:
    for folder in FOLDERS:
        for path in sorted((ROOT / folder).rglob("*.py")):
            if not path.relative_to(ROOT).as_posix().startswith(OTHERS):
                yield path


def test_text_files_are_opened_with_an_explicit_encoding() -> None:
    silent = [
        f"{path.relative_to(ROOT).as_posix()}:{call.lineno}"
        for path in sources()
        for call in calls(path.read_bytes())
        if leaves_the_encoding_to_the_system(call)
    ]
    assert silent == []


@pytest.mark.parametrize(
    ("source", "silent"),
    [
        ("path.read_text()", True),
        ("path.write_text(text)", True),
        ("open(path)", True),
        ("path.open('w')", True),
        ("open(path, mode='a')", True),
        ("path.read_text(encoding='utf-8')", False),
        ("path.write_text(text, 'utf-8')", False),
        ("open(path, 'rb')", False),
        ("path.open('xb', buffering=0)", False),
        ("webbrowser.open(page)", False),
    ],
)
def test_such_a_call_is_found(source: str, silent: bool) -> None:
    (call,) = calls(source.encode())
    assert leaves_the_encoding_to_the_system(call) is silent
