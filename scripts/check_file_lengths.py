"""Fail if a Python or JavaScript file is longer than a reader can hold: 500 lines.

Exempt are data, goldens and generated pages: what nobody reads from top to bottom.

Usage: ``python scripts/check_file_lengths.py [FOLDER]``; exit status 0 or 1.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator
from pathlib import Path

MAX_LINES = 500
SUFFIXES = {".py", ".js", ".mjs"}
EXEMPT_FOLDERS = {"data", "goldens", "generated", "build", "dist", "node_modules", "runs", "__pycache__"}


def checked_files(root: Path) -> Iterator[Path]:
    """Yield, in a fixed order, the files below ``root`` that count; hidden folders are not ours."""
    for path in sorted(root.iterdir()):
        if path.is_symlink() or path.name.startswith(".") or path.name in EXEMPT_FOLDERS:
            continue
        if path.is_dir():
            yield from checked_files(path)
        elif path.suffix in SUFFIXES:
            yield path


def too_long(root: Path) -> list[str]:
    """Return one line of complaint for each file below ``root`` that is over its limit."""
    complaints = []
    for path in checked_files(root):
        lines = len(path.read_bytes().splitlines())
        if lines > MAX_LINES:
            complaints.append(f"{path.relative_to(root).as_posix()}: {lines} lines, at most {MAX_LINES} are allowed")
    return complaints


def main() -> int:
    """Print the complaints; return the exit status."""
    root = Path(sys.argv[1] if len(sys.argv) > 1 else ".").resolve()
    complaints = too_long(root)
    for complaint in complaints:
        print(complaint)
    if not complaints:
        print("every file is within its limit")
    return 1 if complaints else 0


if __name__ == "__main__":
    raise SystemExit(main())
