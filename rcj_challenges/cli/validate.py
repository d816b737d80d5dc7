"""``rcj-challenge validate``: says of each file that it is in order, or everything that is wrong with it."""

from __future__ import annotations

import sys
from collections.abc import Sequence

from rcj_challenges.scenario.errors import ScenarioError
from rcj_challenges.scenario.load import Loaded, load


def validate_files(paths: Sequence[str], overrides: Sequence[str]) -> int:
    """Check scenario files and print a line for each that is in order, and each problem of the others.

    Args:
        paths: files, or names of shipped scenarios.
        overrides: ``PATH=VALUE`` each, applied to every file.

    Returns:
        0 if all are in order, else 2.
    """
    code = 0
    for path in paths:
        try:
            loaded = load(path, overrides)
        except ScenarioError as error:
            _print(str(error), sys.stderr)
            code = ScenarioError.exit_code
        else:
            _print(f"ok  {path}: {_summary(loaded)}", sys.stdout)
    return code


def _summary(loaded: Loaded) -> str:
    """Return what stands in a scenario: title, how much of what, how long."""
    scenario = loaded.scenario
    halves = f"{scenario.match.halves} x " if scenario.match.halves > 1 else ""
    counts = ", ".join(
        (
            _count(len(scenario.robots), "robot"),
            _count(len(scenario.entrants), "entrant"),
            _count(len(scenario.rules), "rule"),
            _count(len(scenario.expect), "test"),
        )
    )
    return f"{scenario.title} ({counts}; {halves}{scenario.match.half_s:g} s)"


def _count(number: int, noun: str) -> str:
    return f"{number} {noun}{'' if number == 1 else 's'}"


def _print(text: str, stream: object) -> None:
    # A terminal that cannot show a character must not hide the whole message.
    write = getattr(stream, "write")  # noqa: B009 - sys.stdout may be replaced by anything that writes
    encoding = getattr(stream, "encoding", None) or "utf-8"
    write(text.encode(encoding, "replace").decode(encoding) + "\n")
