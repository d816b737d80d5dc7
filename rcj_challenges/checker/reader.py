"""Reads untrusted Python files: whether each is valid Python, and what it imports.

A program of its own (``python -I reader.py``), standard library only: source that makes Python's parser eat all memory
or crash takes this process with it and nothing else. Nothing of what is read is ever run.

On standard input: one line of JSON, ``{"files": [[name, size], …], "max_imports": n}``, then the contents one after the
other. On standard output: one line of JSON for each file, in order, as soon as it is known.
"""

from __future__ import annotations

import ast
import codecs
import contextlib
import gc
import json
import re
import sys
import warnings
from collections.abc import Iterable, Iterator, Sequence
from typing import Any, NamedTuple

MEMORY_BYTES = 2_000_000_000
"""Far above what any honest file needs; where the system lets us, Python gets no more."""
PROCESSOR_S = 30
"""Longer than the check waits for an answer: this process ends even if its parent is gone."""

_CATCHES = frozenset({"ImportError", "ModuleNotFoundError", "Exception", "BaseException"})
_MAY_NOT_BE_RUN = (
    *(ast.FunctionDef, ast.AsyncFunctionDef, ast.Lambda, ast.If, ast.While, ast.For, ast.match_case, ast.IfExp),
    *(ast.BoolOp, ast.ListComp, ast.SetComp, ast.DictComp, ast.GeneratorExp),
)
_MAX_WORDS = 500

_CODING = re.compile(rb"[ \t\f]*#.*?coding[:=][ \t]*([-_.a-zA-Z0-9]+)")
_BLANK_OR_COMMENT = re.compile(rb"[ \t\f]*(?:#|$)")
_LINE_END = re.compile(rb"\r\n?|\n")
_MOVES_PATH = re.compile(rb"\bsys\.path\b|\bsys[ \t]+import\b[^\n]*\bpath\b|\baddsitedir\b|\bexec[ \t]*\(")
"""The file changes ``sys.path``, or runs another one that may."""
# Those that decode in time proportional to the length, as they are called by `codecs`: punycode and idna do not.
_ENCODINGS = re.compile(
    r"utf-8(-sig)?|ascii|iso8859-\d+|cp\d+|koi8-[rtu]|mac-\w+|gbk|gb2312|gb18030|big5(hkscs)?|shift_jis\w*|euc_\w+"
    r"|iso2022_\w+|hz|johab|tis-620|kz1048|ptcp154|hp-roman8"
)
_LEAVES = frozenset({ast.Name, ast.Constant, ast.Load, ast.Store, ast.Del, ast.Pass, ast.Break, ast.Continue})
"""What most of a file consists of, with nothing inside."""


class _Spot(NamedTuple):
    """A part of a file: whether a failed import there is caught, and whether running the file certainly reaches it."""

    node: ast.AST
    guarded: bool
    certain: bool


def main() -> None:
    """Read all files and report what is in them."""
    limit_itself()
    gc.disable()  # trees have no cycles, and looking for some doubles the time
    warnings.simplefilter("ignore")  # a strange escape in a string is no reason to complain here
    source = sys.stdin.buffer
    request = json.loads(source.readline())
    left = request["max_imports"]
    for name, size in request["files"]:
        found = read_source(source.read(size), name, left)
        left -= sum(map(_amount_of, found.get("imports", ())))
        sys.stdout.write(json.dumps(found) + "\n")
        sys.stdout.flush()


def _amount_of(found: dict[str, Any]) -> int:
    """Return the count of an import: the module and each name taken from it."""
    return 1 + len(found["names"])


def read_source(source: bytes, name: str, max_imports: int = sys.maxsize) -> dict[str, Any]:
    """Return the fields of a `reading.Source`: of a file that is not Python what is wrong, else what is in it.

    Args:
        source: the file as it is.
        name: how error messages call it.
        max_imports: modules and names that it may import.
    """
    error = _find_error(source, name)
    if error is not None:
        return error
    try:
        tree = compile(source, name, "exec", ast.PyCF_ONLY_AST, dont_inherit=True)
        imports = []
        for found in _imports(tree):
            max_imports -= _amount_of(found)
            if max_imports < 0:
                return {**_error("imports", line=found["line"], column=found["column"]), "moves_path": True}
            imports.append(found)
        empty = not next(ast.iter_child_nodes(tree), None)
        return {"imports": imports, "moves_path": bool(_MOVES_PATH.search(source)), "empty": empty}
    except (RecursionError, MemoryError):
        # It can be run, only its tree is too much: then its imports are not known.
        return {"imports": [], "moves_path": True, "empty": False}


def _find_error(source: bytes, name: str) -> dict[str, Any] | None:
    """Return why a file is not valid Python; None if it is."""
    line, declared = _declared_encoding(source)
    try:
        encoding = codecs.lookup(declared).name
    except LookupError:  # Python's own message is better
        encoding = ""
    if encoding and not _ENCODINGS.fullmatch(encoding):
        return _error("odd_encoding", declared, line)
    try:
        compile(source, name, "exec", dont_inherit=True)
    except SyntaxError as error:
        return _error(type(error).__name__, str(error.msg), error.lineno or 0, error.offset or 0)
    except (RecursionError, MemoryError):
        return _error("depth")
    except (ValueError, OverflowError) as error:  # null bytes, before Python 3.12
        return _error("ValueError", str(error))
    if encoding.startswith("utf-8"):  # Python refuses other letters when it runs the file, `compile` not in comments
        try:
            source.decode()
        except UnicodeDecodeError as error:
            line = len(_LINE_END.findall(source[: error.start])) + 1
            return _error("SyntaxError", f"Non-UTF-8 code starting with '\\x{source[error.start]:02x}'", line)
    return None


def _error(kind: str, message: str = "", line: int = 0, column: int = 0) -> dict[str, Any]:
    return {"wrong": kind, "message": message[:_MAX_WORDS], "line": line, "column": column}


def _declared_encoding(source: bytes) -> tuple[int, str]:
    """Return the line that names the file's encoding, and the name; 0 and UTF-8 if none does."""
    first, *rest = _LINE_END.split(source, 2)
    lines = [first, *rest[:1]] if _BLANK_OR_COMMENT.match(first) else [first]
    for number, line in enumerate(lines, 1):
        named = _CODING.match(line.removeprefix(codecs.BOM_UTF8))
        if named is not None:
            return number, named[1].decode("ascii")[:_MAX_WORDS]
    return 0, "utf-8"


def _imports(tree: ast.AST) -> Iterator[dict[str, Any]]:
    """Yield what a file imports, wherever it does, each with whether failing is caught, and whether it is reached."""
    stack = [_Spot(tree, guarded=False, certain=True)]
    while stack:
        spot = stack.pop()
        node = spot.node
        if isinstance(node, ast.Import):
            for alias in node.names:
                yield _import(node, spot, alias.name)
        elif isinstance(node, ast.ImportFrom):
            yield _import(node, spot, node.module or "", [alias.name for alias in node.names], node.level)
        stack += reversed(_below(spot))


def _import(node: ast.stmt, spot: _Spot, module: str, names: Sequence[str] = (), level: int = 0) -> dict[str, Any]:
    return {
        "module": module,
        "names": list(names),
        "level": level,
        "line": node.lineno,
        "column": node.col_offset + 1,
        "risk": "caught" if spot.guarded else "certain" if spot.certain else "possible",
    }


def _below(spot: _Spot) -> list[_Spot]:
    """The nodes inside a node. What follows a ``while`` at the top, maybe the main loop, may not be reached."""
    node = spot.node
    if isinstance(node, ast.Try | ast.TryStar):
        guarded = spot.guarded or any(_catches(handler.type) for handler in node.handlers)
        return [
            *_each(spot._replace(guarded=guarded), node.body, certain=False),
            *_each(spot, [*node.handlers, *node.orelse], certain=False),
            *_each(spot, node.finalbody, certain=True),
        ]
    if isinstance(node, ast.With) and any(_name(item.context_expr) == "suppress" for item in node.items):
        return _each(spot._replace(guarded=True), node.body, certain=True)
    children = list(ast.iter_child_nodes(node))
    if isinstance(node, ast.Module):
        loop = next((place for place, child in enumerate(children) if isinstance(child, ast.While)), len(children))
        return _each(spot, children[: loop + 1], certain=True) + _each(spot, children[loop + 1 :], certain=False)
    return _each(spot, children, certain=not isinstance(node, _MAY_NOT_BE_RUN))


def _each(spot: _Spot, nodes: Iterable[ast.AST], *, certain: bool) -> list[_Spot]:
    return [_Spot(node, spot.guarded, spot.certain and certain) for node in nodes if type(node) not in _LEAVES]


def _catches(caught: ast.expr | None) -> bool:
    """Return whether an ``except`` catches a failed import."""
    if caught is None:
        return True
    classes = caught.elts if isinstance(caught, ast.Tuple) else [caught]
    return any(_name(one) in _CATCHES for one in classes)


def _name(expression: ast.expr) -> str:
    """Return the last part of a dotted name, or of what is called; nothing of anything else."""
    if isinstance(expression, ast.Call):
        return _name(expression.func)
    if isinstance(expression, ast.Name):
        return expression.id
    return expression.attr if isinstance(expression, ast.Attribute) else ""


def limit_itself() -> None:
    """Limit the memory and the processor time of this process, and let it leave no dump, as far as the system does."""
    try:
        import resource  # noqa: PLC0415 - not on every system
    except ImportError:
        return
    for kind, limit in (
        (resource.RLIMIT_AS, MEMORY_BYTES),
        (resource.RLIMIT_CPU, PROCESSOR_S),
        (resource.RLIMIT_CORE, 0),
    ):
        with contextlib.suppress(OSError, ValueError):  # not on every system, or there is a lower one
            resource.setrlimit(kind, (limit, limit))


if __name__ == "__main__":
    main()
