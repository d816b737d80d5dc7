"""Reads a team's Python files in a separate process (see ``reader.py``)."""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path, PurePosixPath
from typing import Any, Literal

from rcj_challenges.core.grouping import grouped

Risk = Literal["certain", "caught", "possible"]
"""The effect of an import that fails: the program ends, catches the error, or ends if it reaches the import."""

MAX_BYTES = 64_000
"""A longer Python file is not looked into: for some the time that Python takes grows with the square of the length,
such as calls with thousands of named arguments or f-strings with thousands of braces."""
MAX_ALL_BYTES = 192_000
"""Of the Python files of a submission together, equal ones counted once: those beyond are not looked into."""
MAX_IMPORTS = 5_000
"""Modules and names that the files together may import; those beyond are not looked into."""

_READER = Path(__file__).with_name("reader.py")
PATIENCE_S = 20.0
"""Timeout for an answer about files that are read together: the last resort beside the bounds above."""
_MAX_ROUNDS = 8
"""How often reading restarts with the remaining files, after one that ends the reading process."""


@dataclass(frozen=True)
class Import:
    """One import in a file.

    Attributes:
        module: what is imported, with dots; without the leading ones.
        names: what is taken from it (``from module import names``).
        level: how many leading dots.
        line, column: where, from 1.
        risk: what happens if it fails.
    """

    module: str
    names: tuple[str, ...]
    level: int
    line: int
    column: int
    risk: Risk


@dataclass(frozen=True)
class Source:
    """What is in one Python file.

    Attributes:
        imports: in order.
        moves_path: it uses ``sys.path``, so modules may be found in places that only the program knows.
        empty: there is nothing in it but comments.
        wrong: why it is not Python: the kind of error, ``depth``, ``crash``, ``slow``, ``odd_encoding``, ``large``,
            ``imports`` or ``unread``; empty if it is.
        message: Python's own message about that.
        line, column: where; 0 if that is not known.
    """

    imports: tuple[Import, ...] = ()
    moves_path: bool = False
    empty: bool = False
    wrong: str = ""
    message: str = ""
    line: int = 0
    column: int = 0


def read_sources(
    files: Mapping[PurePosixPath, bytes], first: Collection[PurePosixPath] = ()
) -> dict[PurePosixPath, Source]:
    """The contents of each of the Python files, whatever they are.

    Args:
        files: contents by path; only the ``.py`` files are looked at.
        first: those that matter most, in case that not all are looked into.
    """
    found: dict[PurePosixPath, Source] = {}
    programs = sorted((path for path in files if path.suffix == ".py"), key=lambda path: path not in first)
    alike = grouped((files[path], path) for path in programs)
    left: list[PurePosixPath] = []
    room = MAX_ALL_BYTES
    for content, (path, *_) in alike.items():
        if len(content) > min(room, MAX_BYTES):
            found[path] = Source(wrong="large" if len(content) > MAX_BYTES else "unread", moves_path=True)
        else:
            left.append(path)
            room -= len(content)
    imports_left = MAX_IMPORTS
    for _ in range(_MAX_ROUNDS):
        if not left:
            break
        answers, ended = _ask(left, files, imports_left)
        imports_left -= sum(1 + len(one.names) for answer in answers for one in answer.imports)
        found |= dict(zip(left, answers, strict=False))
        left = left[len(answers) :]
        # At the timeout any of many files may be in progress: one is slow only if it alone took all the time.
        if left and not (ended == "slow" and answers):
            found[left.pop(0)] = Source(wrong=ended)
    found |= dict.fromkeys(left, Source(wrong="unread", moves_path=True))
    found |= {path: found[first_one] for first_one, *others in alike.values() for path in others}
    return {path: found[path] for path in files if path in found}


def _ask(
    paths: Sequence[PurePosixPath], files: Mapping[PurePosixPath, bytes], max_imports: int
) -> tuple[list[Source], str]:
    """The reader's reports on the files until it ends, and why if it ended too early."""
    index = [(path.name.encode("utf-8", "replace").decode(), len(files[path])) for path in paths]
    request = json.dumps({"files": index, "max_imports": max_imports}).encode() + b"\n"
    command = [sys.executable, "-I", "-S", "-B", "-X", "utf8", str(_READER)]
    ended = "crash"
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL) as process:
        try:
            output, _ = process.communicate(request + b"".join(files[path] for path in paths), PATIENCE_S)
        except subprocess.TimeoutExpired:
            process.kill()
            output, _ = process.communicate()
            ended = "slow"
        except BaseException:  # the check was interrupted
            process.kill()
            raise
    lines = output.split(b"\n")[:-1]  # what follows the last line break was never finished
    return [_source(json.loads(line)) for line in lines[: len(paths)]], ended


def _source(answer: dict[str, Any]) -> Source:
    imports = tuple(Import(**{**one, "names": tuple(one["names"])}) for one in answer.pop("imports", ()))
    return Source(imports, **answer)
