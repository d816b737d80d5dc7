"""A bar, what was measured against it, and the table of them."""

from __future__ import annotations

import argparse
import json
import os
import platform
import sys
from collections.abc import Sequence
from dataclasses import asdict, dataclass


@dataclass(frozen=True)
class Row:
    """One bar: what was measured, against what it is held."""

    what: str
    measured: float
    unit: str
    must: float | None
    aim: float | None = None
    more_is_better: bool = False

    @property
    def output(self) -> str:
        """Whether the bar is reached."""
        if self.must is None:
            return ""
        sign = -1 if self.more_is_better else 1
        if sign * self.measured > sign * self.must:
            return "MISSED"
        return "aim" if self.aim is not None and sign * self.measured <= sign * self.aim else "must"


def parser(about: str) -> argparse.ArgumentParser:
    """Return a parser that knows ``--json``."""
    made = argparse.ArgumentParser(description=about)
    made.add_argument("--json", action="store_true")
    return made


def show(rows: Sequence[Row], *, as_json: bool) -> int:
    """Print the table; returns 1 if a must is missed."""
    if as_json:
        print(json.dumps([asdict(row) | {"output": row.output} for row in rows], indent=2))
    else:
        # How it was built decides a quarter of the speed: a distribution's own is optimized, a hand-made one often not.
        print(f"{platform.python_implementation()} {sys.version}")
        print(f"{'what':46} {'measured':>10} {'unit':9} {'must':>8} {'aim':>8}")
        for row in rows:
            must = "" if row.must is None else f"{row.must:g}"
            aim = "" if row.aim is None else f"{row.aim:g}"
            print(f"{row.what:46} {row.measured:10g} {row.unit:9} {must:>8} {aim:>8}  {row.output}")
    return 1 if any(row.output == "MISSED" for row in rows) else 0


def as_users_have_it() -> dict[str, str]:
    """Return the environment for a command: with byte code on the disk, and imports from the installed package."""
    return {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}
