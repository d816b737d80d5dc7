"""Telling a record whose scenario somebody has changed from a fault of ours."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from rcj_challenges.records.errors import RecordError
from rcj_challenges.records.folder import SCENARIO
from rcj_challenges.scenario.dump import dumped
from rcj_challenges.scenario.errors import ScenarioError
from rcj_challenges.scenario.models.scenario import Scenario

_BROKEN = (ArithmeticError, AttributeError, LookupError, TypeError, ValueError)
"""What work with a scenario ends in that names what it has not."""


@contextmanager
def refusing_changes(folder: Path, scenario: Scenario) -> Iterator[None]:
    """Work with a record by its scenario; if that fails, say what of the scenario could not have been played.

    It is not looked at before something fails: what an older version took may be refused today.

    Args:
        folder: of the record.
        scenario: as its file says.

    Raises:
        RecordError: something failed, and the scenario is one that nobody could have played: what is wrong with it
            first. Whatever else fails is raised as it is.
    """
    try:
        yield
    except _BROKEN as error:
        what = _what_is_wrong(scenario)
        if what is None:
            raise
        raise RecordError(f"{folder.name}: {SCENARIO} is not as the run wrote it: {what}") from error


def _what_is_wrong(scenario: Scenario) -> str | None:
    from rcj_challenges.scenario.load import load_resolved  # noqa: PLC0415 - with it comes YAML, which no page needs

    try:
        load_resolved(dumped(scenario))
    except ScenarioError as refused:
        first = refused.problems[0]
        return f"{first.path}: {first.message}" if first.path else first.message
    return None
