"""Reading records of older versions: each version has one function that makes the next one of it, in memory.

A version is raised only when an older reader would misread what is new; a file or field more that may be missing raises
none. The table below then gets an entry, and ``tests/records/version-<n>`` keeps a record of each version that was ever
written: all of them must be readable for as long as this package is.
"""

from __future__ import annotations

import json
import warnings
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from rcj_challenges.facts.errors import told_of
from rcj_challenges.records.errors import RecordError
from rcj_challenges.records.folder import RECORD_VERSION, SCENARIO
from rcj_challenges.records.lines import parsed
from rcj_challenges.scenario.models.base import AS_RECORDED
from rcj_challenges.scenario.models.scenario import Scenario

Change = Callable[[dict[str, Any]], dict[str, Any]]


class OldRecordWarning(UserWarning):
    """A record of an older version was read; what it could not know yet is missing."""


def same(data: dict[str, Any]) -> dict[str, Any]:
    """Return data as it is: a part that did not change between two versions."""
    return data


@dataclass(frozen=True)
class Upgrade:
    """From one version to the next.

    Attributes:
        result: of ``result.json``.
        scenario: of ``scenario.json``.
        header: of the trajectory's header.
    """

    result: Change = same
    scenario: Change = same
    header: Change = same


UPGRADES: Mapping[int, Upgrade] = {}
"""By the version that is upgraded. Version 1 is the first, so there is none yet."""


def upgraded(part: str, data: dict[str, Any], record: int, folder: Path) -> dict[str, Any]:
    """Return a part (``result``, ``scenario``, ``header``) of a record as the present version has it.

    Raises:
        RecordError: the record is newer than this package, or from no version that there was.
    """
    if record > RECORD_VERSION:
        raise RecordError(
            f"{folder.name}: its record has version {record}, this package reads up to {RECORD_VERSION}: "
            "it needs a newer rcj-challenges"
        )
    for version in range(record, RECORD_VERSION):
        if version not in UPGRADES:
            raise RecordError(f"{folder.name}: its record has version {record}, which no rcj-challenges has written")
        data = getattr(UPGRADES[version], part)(data)
    if record < RECORD_VERSION and part == "result":
        warnings.warn(
            f"{folder.name}: a record of version {record} is read as version {RECORD_VERSION}",
            OldRecordWarning,
            stacklevel=3,
        )
    return data


def read_scenario(folder: Path, record: int = RECORD_VERSION) -> Scenario:
    """Return the scenario as it was played; ``record`` is the version of the run's record.

    Raises:
        RecordError: it is missing, damaged, or no scenario.
    """
    try:
        data = parsed((folder / SCENARIO).read_bytes())
        if not isinstance(data, dict):
            raise TypeError("no object")
        text = json.dumps(upgraded("scenario", data, record, folder))
        return Scenario.model_validate_json(text, context=AS_RECORDED)
    except FileNotFoundError:
        raise RecordError(f"{folder.name}: {SCENARIO} is missing") from None
    except OSError as error:
        raise RecordError(f"{folder.name}: {SCENARIO} cannot be read: {told_of(error)}") from error
    except (TypeError, ValueError, RecursionError) as error:
        raise RecordError(f"{folder.name}: {SCENARIO} is damaged: it is not the scenario of a run") from error
