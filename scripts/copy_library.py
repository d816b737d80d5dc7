"""Copies the library of the champions (examples/library) into each of their teams: a submission is self-contained.

``python scripts/copy_library.py`` copies; with ``--check`` it writes nothing and exits with 1 if a copy is stale.
"""

from __future__ import annotations

import sys
from pathlib import Path

EXAMPLES = Path(__file__).resolve().parents[1] / "examples"
SOURCE = EXAMPLES / "library" / "driving"
NEEDED = {
    "fast_shooter/score_goal/driving": ("body.py", "field.py", "moves.py", "shots.py"),
    "pass_the_ball/driving": ("body.py", "field.py", "moves.py", "shots.py"),
    "precision_lidar/score_goal/driving": ("body.py", "field.py", "moves.py"),
}
"""By the place of a copy: what its team uses."""


def stale_copies() -> dict[Path, bytes]:
    """Return the copies that are missing or differ, with what should be in them."""
    wanted = {
        EXAMPLES / "teams" / place / name: (SOURCE / name).read_bytes()
        for place, names in NEEDED.items()
        for name in names
    }
    return {path: data for path, data in wanted.items() if not path.is_file() or path.read_bytes() != data}


def main() -> int:
    """Copy or check; returns the exit code."""
    stale = stale_copies()
    if "--check" in sys.argv:
        for path in stale:
            print(f"{path.relative_to(EXAMPLES)} is stale: python scripts/copy_library.py")
        return 1 if stale else 0
    for path, data in stale.items():
        path.parent.mkdir(exist_ok=True)
        path.write_bytes(data)
    return 0


if __name__ == "__main__":
    sys.exit(main())
