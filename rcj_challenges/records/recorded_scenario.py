"""Reading the scenario of a record."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from rcj_challenges.facts.errors import format_error
from rcj_challenges.records.errors import RecordError
from rcj_challenges.records.folder import SCENARIO, UNRESOLVED, read_file
from rcj_challenges.records.lines import parsed
from rcj_challenges.rules.fields import AS_RECORDED
from rcj_challenges.scenario.models.scenario import Scenario


def read_scenario(folder: Path) -> Scenario:
    """Return the scenario as it was played.

    Raises:
        RecordError: it is missing, damaged, or no scenario.
    """
    try:
        data = parsed(read_file(folder / SCENARIO))
        if not isinstance(data, dict):
            raise TypeError("no object")
        return Scenario.model_validate_json(json.dumps(data), context=AS_RECORDED)
    except FileNotFoundError:
        raise RecordError(f"{folder.name}: {SCENARIO} is missing") from None
    except OSError as error:
        raise RecordError(f"{folder.name}: {SCENARIO} cannot be read: {format_error(error)}") from error
    except (TypeError, ValueError, RecursionError) as error:
        raise RecordError(f"{folder.name}: {SCENARIO} is damaged: it is not the scenario of a run") from error


def read_unresolved(folder: Path) -> dict[str, Any]:
    """Return the scenario before its params took their places; empty if the record has none, or a damaged one."""
    try:
        data = parsed(read_file(folder / UNRESOLVED))
    except (OSError, ValueError, RecursionError, RecordError):
        return {}
    return data if isinstance(data, dict) else {}
