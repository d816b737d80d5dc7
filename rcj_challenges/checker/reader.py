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
_CATCHES_UNREADABLE = frozenset({"SyntaxError", "IndentationError"})
"""What is raised for a file that exists and cannot be read: only running it can show whether that happens."""

_IMPORTS = (ast.Import, ast.ImportFrom)
_FUNCTIONS = (ast.FunctionDef, ast.AsyncFunctionDef)
_MAY_NOT_BE_RUN = (
    *(*_FUNCTIONS, ast.Lambda, ast.If, ast.While, ast.For, ast.match_case, ast.IfExp, ast.BoolOp),
    *(ast.ListComp, ast.SetComp, ast.DictComp, ast.GeneratorExp),
)
_MAX_WORDS = 500

_CODING = re.compile(rb"[ \t\f]*#.*?coding[:=][ \t]*([-_.a-zA-Z0-9]+)")
_BLANK_OR_COMMENT = re.compile(rb"[ \t\f]*(?:#|$)")
_LINE_END = re.compile(rb"\r\n?|\n")
# Those that decode in time proportional to the length, as they are called by `codecs`: punycode and idna do not.
_ENCODINGS = re.compile(
    r"utf-8(-sig)?|ascii|iso8859-\d+|cp\d+|koi8-[rtu]|mac-\w+|gbk|gb2312|gb18030|big5(hkscs)?|shift_jis\w*|euc_\w+"
    r"|iso2022_\w+|hz|johab|tis-620|kz1048|ptcp154|hp-roman8"
)


_LEAVES = frozenset({ast.Name, ast.Constant, ast.Load, ast.Store, ast.Del, ast.Pass, ast.Break, ast.Continue})
"""What most of a file consists of, with nothing inside."""


class _Spot(NamedTuple):
    """A part of a file.

    Attributes:
        node: which.
        guarded: whether a failed import there is caught.
        certain: whether running the file from its beginning comes there.
    """

    node: ast.AST
    guarded: bool
    certain: bool


def main() -> None:
    """Read all files and say what is in them."""
    limit_itself()
    gc.disable()  # trees have no cycles, and looking for some doubles the time
    warnings.simplefilter("ignore")  # a strange escape in a string is no reason to complain here
    source = sys.stdin.buffer
    asked = json.loads(source.readline())
    left = asked["max_imports"]
    for name, size in asked["files"]:
        said = read_source(source.read(size), name, left)
        left -= sum(map(amount_of, said.get("imports", ())))
        sys.stdout.write(json.dumps(said) + "\n")
        sys.stdout.flush()


def amount_of(found: dict[str, Any]) -> int:
    """Return the count of an import: the module and each name taken from it."""
    return 1 + len(found["names"])


def read_source(source: bytes, name: str, max_imports: int = sys.maxsize) -> dict[str, Any]:
    """Return ``{"error": …}`` or ``{"imports": […], "moves_path": …, "empty": …}`` of a file.

    Args:
        source: the file as it is.
        name: how error messages call it.
        max_imports: modules and names that it may import.
    """
    wrong = _wrong(source, name)
    if wrong is not None:
        return {"error": wrong}
    try:
        tree = compile(source, name, "exec", ast.PyCF_ONLY_AST, dont_inherit=True)
        imports = []
        for found in _imports(tree):
            max_imports -= amount_of(found)
            if max_imports < 0:
                return {"error": {"kind": "imports", "said": "", "line": found["line"], "column": found["column"]}}
            imports.append(found)
        return {
            "imports": imports,
            "moves_path": _moves_path(tree),
            "empty": not next(ast.iter_child_nodes(tree), None),
        }
    except (RecursionError, MemoryError):
        # It can be run, only its tree is too much: then its imports are not known.
        return {"imports": [], "moves_path": True, "empty": False}


def _wrong(source: bytes, name: str) -> dict[str, Any] | None:
    """Return why a file is not valid Python; None if it is."""
    line, declared = _declared_encoding(source)
    encoding = _codec_of(declared)
    if encoding and not _ENCODINGS.fullmatch(encoding):
        return {"kind": "odd_encoding", "said": declared, "line": line, "column": 0}
    try:
        compile(source, name, "exec", dont_inherit=True)
    except SyntaxError as error:
        return _place(error)
    except (RecursionError, MemoryError):
        return {"kind": "depth", "said": "", "line": 0, "column": 0}
    except (ValueError, OverflowError) as error:  # null bytes, before Python 3.12
        return {"kind": "ValueError", "said": str(error)[:_MAX_WORDS], "line": 0, "column": 0}
    return _not_utf8(source) if encoding.startswith("utf-8") else None


def _not_utf8(source: bytes) -> dict[str, Any] | None:
    """Return where a file is not UTF-8. Python refuses it when it runs the file; `compile` overlooks it in comments."""
    try:
        source.decode()
    except UnicodeDecodeError as error:
        line = len(_LINE_END.findall(source[: error.start])) + 1
        said = f"Non-UTF-8 code starting with '\\x{source[error.start]:02x}'"
        return {"kind": "SyntaxError", "said": said, "line": line, "column": 0}
    return None


def _declared_encoding(source: bytes) -> tuple[int, str]:
    """Return the line that names the file's encoding, and the name; 0 and UTF-8 if none does."""
    first, *rest = _LINE_END.split(source, 2)
    lines = [first, *rest[:1]] if _BLANK_OR_COMMENT.match(first) else [first]
    for number, line in enumerate(lines, 1):
        named = _CODING.match(line.removeprefix(codecs.BOM_UTF8))
        if named is not None:
            return number, named[1].decode("ascii")[:_MAX_WORDS]
    return 0, "utf-8"


def _codec_of(encoding: str) -> str:
    """Return what `codecs` calls an encoding; empty if there is none, which Python says itself."""
    try:
        return codecs.lookup(encoding).name
    except LookupError:
        return ""


def _place(error: SyntaxError) -> dict[str, Any]:
    return {
        "kind": type(error).__name__,
        "said": str(error.msg)[:_MAX_WORDS],
        "line": error.lineno or 0,
        "column": error.offset or 0,
    }


def _imports(tree: ast.AST) -> Iterator[dict[str, Any]]:
    """Yield what a file imports, wherever it does, each with whether failing is caught, and whether it comes there."""
    stack = [_Spot(tree, guarded=False, certain=True)]
    while stack:
        spot = stack.pop()
        node = spot.node
        if isinstance(node, ast.Import):
            for alias in node.names:
                yield _import(node, spot, alias.name)
        elif isinstance(node, ast.ImportFrom):
            yield _import(node, spot, node.module or "", [alias.name for alias in node.names], node.level)
        elif isinstance(node, ast.Call) and (module := _called_import(node)):
            yield _import(node, spot, module)
        stack += reversed(_below(spot))


def _import(
    node: ast.stmt | ast.expr, spot: _Spot, module: str, names: Sequence[str] = (), level: int = 0
) -> dict[str, Any]:
    return {
        "module": module,
        "names": list(names),
        "level": level,
        "line": node.lineno,
        "column": node.col_offset + 1,
        "guarded": spot.guarded,
        "certain": spot.certain,
    }


def _below(spot: _Spot) -> list[_Spot]:
    """Return what is inside a node."""
    node = spot.node
    if isinstance(node, ast.Try | ast.TryStar):
        return _tried(spot, node)
    if isinstance(node, ast.With):
        if not any(_is_suppress(item.context_expr) for item in node.items):
            return _one_after_the_other(spot, node.body)
        return _first_imports(_ready_for(spot, _suppressed(node)), node.body)
    if isinstance(node, ast.If) and _name(node.test) == "TYPE_CHECKING":
        return _one_after_the_other(spot, node.orelse)
    if isinstance(node, ast.Module | ast.ClassDef):
        return _one_after_the_other(spot, list(ast.iter_child_nodes(node)))
    return _each(spot, ast.iter_child_nodes(node), certain=not isinstance(node, _MAY_NOT_BE_RUN))


def _tried(spot: _Spot, node: ast.Try | ast.TryStar) -> list[_Spot]:
    caught = [handler.type for handler in node.handlers]
    return [
        *_first_imports(_ready_for(spot, caught), node.body),
        *_each(spot, [*node.handlers, *node.orelse], certain=False),
        *_each(spot, node.finalbody, certain=not any(map(_holds_while, node.body))),
    ]


def _each(spot: _Spot, nodes: Iterable[ast.AST], *, certain: bool) -> list[_Spot]:
    guarded, certain = spot.guarded, spot.certain and certain
    return [_Spot(node, guarded, certain) for node in nodes if type(node) not in _LEAVES]


def _one_after_the_other(spot: _Spot, nodes: Sequence[ast.AST]) -> list[_Spot]:
    """Return statements in a row. A ``while`` may be the program's main loop: what follows is run after the match."""
    loop = next((place for place, node in enumerate(nodes) if _holds_while(node)), len(nodes))
    return _each(spot, nodes[: loop + 1], certain=True) + _each(spot, nodes[loop + 1 :], certain=False)


def _first_imports(spot: _Spot, nodes: Sequence[ast.AST]) -> list[_Spot]:
    """Return statements of which any may be the last, because what goes wrong is caught.

    Each import is reported by itself, so those at the beginning count as carried out.
    """
    first = next((place for place, node in enumerate(nodes) if not isinstance(node, _IMPORTS)), len(nodes))
    return _each(spot, nodes[: first + 1], certain=True) + _each(spot, nodes[first + 1 :], certain=False)


def _holds_while(tree: ast.AST) -> bool:
    """Return whether running a node may come to a ``while``; one in a function is not run where it stands."""
    stack = [tree]
    while stack:
        node = stack.pop()
        if isinstance(node, ast.While):
            return True
        if isinstance(node, ast.stmt) and not isinstance(node, _FUNCTIONS):
            stack += ast.iter_child_nodes(node)
        elif isinstance(node, ast.ExceptHandler | ast.match_case):
            stack += node.body
    return False


def _ready_for(spot: _Spot, caught: Sequence[ast.expr | None]) -> _Spot:
    """Return a part of a file inside of something that catches these errors."""
    return spot._replace(
        guarded=spot.guarded or any(_catches(one, _CATCHES) for one in caught),
        certain=spot.certain and not any(_catches(one, _CATCHES_UNREADABLE) for one in caught if one is not None),
    )


def _catches(caught: ast.expr | None, errors: frozenset[str]) -> bool:
    if caught is None:
        return True
    classes = caught.elts if isinstance(caught, ast.Tuple) else [caught]
    return any(_name(one) in errors for one in classes)


def _is_suppress(context: ast.expr) -> bool:
    return isinstance(context, ast.Call) and _name(context.func) == "suppress"


def _suppressed(node: ast.With) -> list[ast.expr | None]:
    contexts = (item.context_expr for item in node.items)
    return [error for one in contexts if isinstance(one, ast.Call) and _is_suppress(one) for error in one.args]


def _name(expression: ast.expr) -> str:
    """Return the last part of a dotted name; nothing of anything else."""
    if isinstance(expression, ast.Name):
        return expression.id
    return expression.attr if isinstance(expression, ast.Attribute) else ""


def _called_import(call: ast.Call) -> str:
    """Return the module of ``import_module("…")`` or ``__import__("…")``."""
    if _name(call.func) not in ("import_module", "__import__") or len(call.args) != 1:
        return ""
    (argument,) = call.args
    named = argument.value if isinstance(argument, ast.Constant) else None
    return named if isinstance(named, str) and named.replace(".", "").isidentifier() else ""


def _moves_path(tree: ast.AST) -> bool:
    """Return whether the file uses ``sys.path``, or runs another one that may: modules lie where only it knows."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Call) and _name(node.func) == "exec":
            return True
        if isinstance(node, ast.Import) and any(alias.name == "sys" and alias.asname for alias in node.names):
            return True
        if (
            isinstance(node, ast.Attribute)
            and node.attr in ("path", "addsitedir")
            and _name(node.value) in _PATH_OWNERS
        ):
            return True
        if isinstance(node, ast.ImportFrom) and node.module == "sys" and "path" in {alias.name for alias in node.names}:
            return True
    return False


_PATH_OWNERS = frozenset({"sys", "site"})


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
