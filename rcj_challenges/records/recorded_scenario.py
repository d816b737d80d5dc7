"""Reads the scenario of a record."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from rcj_challenges.core.amounts import HALF
from rcj_challenges.records.errors import RecordError
from rcj_challenges.records.folder import SCENARIO, UNRESOLVED, read_file
from rcj_challenges.records.lines import parsed
from rcj_challenges.scenario.errors import ScenarioError, place_of
from rcj_challenges.scenario.models.scenario import Scenario


def read_scenario(folder: Path) -> Scenario:
    """Return the scenario as it was played.

    Raises:
        RecordError: it cannot be read, is damaged, or is not a scenario that could have been played.
    """
    from rcj_challenges.scenario.load import load_resolved  # noqa: PLC0415 - it brings YAML, which writing does not need

    try:
        data = parsed(read_file(folder / SCENARIO))
        if not isinstance(data, dict):
            raise TypeError("not an object")
        return load_resolved(data).scenario
    except ScenarioError as error:
        first = error.diagnostics[0]
        what = f"{place_of(first).path}: {first.message}" if place_of(first).path else first.message
        raise RecordError.damaged(f"{folder.name}: {SCENARIO} is not as the run wrote it: {what}") from error
    except (TypeError, ValueError, RecursionError) as error:
        raise RecordError.damaged(f"{folder.name}: {SCENARIO} is damaged: it is not the scenario of a run") from error


def read_period(path: Path) -> str:
    """Return what a half is called in the resolved scenario of a file; ``half`` if that cannot be read."""
    try:
        called = parsed(read_file(path))["match"]["called"]
        return str(called if isinstance(called, str) else called[0])
    except (ValueError, TypeError, LookupError, RecursionError, RecordError):
        return HALF.one


def read_unresolved(folder: Path) -> dict[str, Any]:
    """Return the scenario before its params took their places; empty if the record has none, or a damaged one."""
    try:
        data = parsed(read_file(folder / UNRESOLVED))
    except (ValueError, RecursionError, RecordError):
        return {}
    return data if isinstance(data, dict) else {}
