"""Fail if code that decides a match adds floats in a way that depends on the version of Python or on a library.

``sum`` rounds otherwise from Python 3.12 on, and the helpers below promise no last bit at all. Floats are added by
``+`` or by `rcj_challenges.core.amounts.add_up`. A sum of whole numbers is allowed on a line that ends
with ``# integers``.

Usage: ``python scripts/check_float_sums.py [FOLDER]``; exit status 0 or 1.
"""

from __future__ import annotations

import ast
import sys
from collections.abc import Iterator
from pathlib import Path

DECIDING = (
    "core", "devices", "geometry", "match", "referee", "robots", "rules", "scenario/outlines.py", "tracking", "world",
)  # fmt: skip
"""Of the package: what floats of a match go through."""
HELPERS = {"sum", "fsum", "sumprod", "nansum", "cumsum", "mean", "fmean", "average"}
MODULE_HELPERS = {"math": {"dist", "fma"}, "statistics": None}
"""By module: None stands for all that it has."""
MARK = "# integers"


def checked_files(root: Path) -> Iterator[Path]:
    """Yield, in a fixed order, the files that decide a match."""
    for path in (root / "rcj_challenges" / name for name in DECIDING):
        yield from sorted(path.rglob("*.py")) if path.is_dir() else [path]


def used_helpers(tree: ast.AST) -> Iterator[tuple[ast.expr | ast.stmt, str]]:
    """Yield the uses of helpers, with their names."""
    for node in ast.walk(tree):
        match node:
            case ast.Name(id=name, ctx=ast.Load()) | ast.Call(func=ast.Attribute(attr=name)) if name in HELPERS:
                yield node, name
            case ast.Attribute(value=ast.Name(id=module), attr=name) if _is_banned(module, name):
                yield node, f"{module}.{name}"
            case ast.Import(names=names) if "statistics" in [one.name for one in names]:
                yield node, "statistics"
            case ast.ImportFrom(module=str() as module, names=names):
                banned = [one.name for one in names if one.name in HELPERS or _is_banned(module, one.name)]
                yield from ((node, f"{module}.{name}") for name in banned)


def _is_banned(module: str, name: str) -> bool:
    helpers = MODULE_HELPERS.get(module, set())
    return helpers is None or name in helpers


def complaints(root: Path) -> list[str]:
    """Return one line for each use of a helper that is not marked."""
    found = []
    for path in checked_files(root):
        text = path.read_text(encoding="utf-8")
        lines = text.splitlines()
        for node, name in used_helpers(ast.parse(text)):
            if not lines[node.lineno - 1].endswith(MARK):
                found.append(f"{path.relative_to(root).as_posix()}:{node.lineno}: {name}; use add_up or +")
    return found


def main() -> int:
    """Print the complaints; return the exit status."""
    found = complaints(Path(sys.argv[1] if len(sys.argv) > 1 else ".").resolve())
    print("\n".join(found) or "floats of a match are added in one way")
    return 1 if found else 0


if __name__ == "__main__":
    raise SystemExit(main())
