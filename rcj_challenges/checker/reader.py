"""Reads Python files of strangers: whether each is Python, and what it imports.

A program of its own (``python -I reader.py``), standard library only: source that makes Python's parser eat all memory
or crash takes this process with it and nothing else. Nothing of what is read is ever run.

On standard input: one line of JSON, ``[[name, size], …]``, then the contents one after the other. On standard output:
one line of JSON for each file, in order, as soon as it is known.
"""

from __future__ import annotations

import ast
import json
import sys
import warnings
from collections.abc import Iterator
from typing import Any

MEMORY_BYTES = 2_000_000_000
"""Far above what any honest file needs; where the system lets us, Python gets no more."""

_CATCHES = frozenset({"ImportError", "ModuleNotFoundError", "Exception", "BaseException"})
_MOST_IMPORTS = 2_000  # of one file; no program has so many
_MOST_WORDS = 500


def main() -> None:
    """Read all files and say what is in them."""
    _limit_memory()
    warnings.simplefilter("ignore")  # a strange escape in a string is no reason to complain here
    source = sys.stdin.buffer
    for name, size in json.loads(source.readline()):
        said = json.dumps(read_source(source.read(size), name))
        sys.stdout.write(said + "\n")
        sys.stdout.flush()


def read_source(source: bytes, name: str) -> dict[str, Any]:
    """Return ``{"error": …}`` or ``{"imports": […], "moves_path": …, "empty": …}`` of a file.

    Args:
        source: the file as it is.
        name: how error messages call it.
    """
    try:
        compile(source, name, "exec", dont_inherit=True)
    except SyntaxError as error:
        return {"error": _place(error)}
    except RecursionError:
        return {"error": {"kind": "depth", "said": "", "line": 0, "column": 0}}
    except MemoryError:
        return {"error": {"kind": "depth", "said": "", "line": 0, "column": 0}}
    except (ValueError, OverflowError) as error:  # null bytes, before Python 3.12
        return {"error": {"kind": "ValueError", "said": str(error)[:_MOST_WORDS], "line": 0, "column": 0}}
    try:
        tree = compile(source, name, "exec", ast.PyCF_ONLY_AST, dont_inherit=True)
        imports = []
        for found in _imports(tree):
            imports.append(found)
            if len(imports) >= _MOST_IMPORTS:
                break
        return {
            "imports": imports,
            "moves_path": _moves_path(tree),
            "empty": not next(ast.iter_child_nodes(tree), None),
        }
    except (RecursionError, MemoryError):
        # It can be run, only its tree is too much: then its imports are not known.
        return {"imports": [], "moves_path": True, "empty": False}


def _place(error: SyntaxError) -> dict[str, Any]:
    return {
        "kind": type(error).__name__,
        "said": str(error.msg)[:_MOST_WORDS],
        "line": error.lineno or 0,
        "column": error.offset or 0,
    }


def _imports(tree: ast.AST) -> Iterator[dict[str, Any]]:
    """Yield what a file imports, wherever it does; whether it is ready for a failure stands with it."""
    stack: list[tuple[ast.AST, bool]] = [(tree, False)]
    while stack:
        node, guarded = stack.pop()
        if isinstance(node, ast.Import):
            for alias in node.names:
                yield _import(node, alias.name, [], 0, guarded=guarded)
        elif isinstance(node, ast.ImportFrom):
            names = [alias.name for alias in node.names]
            yield _import(node, node.module or "", names, node.level, guarded=guarded)
        elif isinstance(node, ast.Call) and (module := _called_import(node)):
            yield _import(node, module, [], 0, guarded=guarded)
        stack += reversed(_below(node, guarded=guarded))


def _import(node: ast.stmt | ast.expr, module: str, names: list[str], level: int, *, guarded: bool) -> dict[str, Any]:
    return {
        "module": module,
        "names": names,
        "level": level,
        "line": node.lineno,
        "column": node.col_offset + 1,
        "guarded": guarded,
    }


def _below(node: ast.AST, *, guarded: bool) -> list[tuple[ast.AST, bool]]:
    """Return what is inside a node, each with whether a failed import there is caught."""
    if isinstance(node, ast.Try):
        caught = guarded or any(_catches(handler.type) for handler in node.handlers)
        rest: list[ast.AST] = [*node.handlers, *node.orelse, *node.finalbody]
        return [(child, caught) for child in node.body] + [(child, guarded) for child in rest]
    if isinstance(node, ast.With):
        caught = guarded or any(_suppresses(item.context_expr) for item in node.items)
        return [(child, caught) for child in node.body]
    if isinstance(node, ast.If) and _name(node.test) == "TYPE_CHECKING":
        return [(child, guarded) for child in node.orelse]
    return [(child, guarded) for child in ast.iter_child_nodes(node)]


def _catches(caught: ast.expr | None) -> bool:
    if caught is None:
        return True
    classes = caught.elts if isinstance(caught, ast.Tuple) else [caught]
    return any(_name(one) in _CATCHES for one in classes)


def _suppresses(context: ast.expr) -> bool:
    return isinstance(context, ast.Call) and _name(context.func) == "suppress" and any(map(_catches, context.args))


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
    """Return whether the file uses ``sys.path``: then modules may lie where only the program knows."""
    for node in ast.walk(tree):
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


def _limit_memory() -> None:
    try:
        import resource  # noqa: PLC0415 - not on every system

        resource.setrlimit(resource.RLIMIT_AS, (MEMORY_BYTES, MEMORY_BYTES))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    except (ImportError, OSError, ValueError):
        return


if __name__ == "__main__":
    main()
