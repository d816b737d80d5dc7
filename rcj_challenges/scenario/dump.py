"""A scenario as plain data, as records keep it."""

from __future__ import annotations

from typing import Any

from rcj_challenges.scenario.models.scenario import Scenario


def dumped(scenario: Scenario) -> dict[str, Any]:
    """Return a resolved scenario as JSON-able data."""
    return scenario.model_dump(mode="json", by_alias=True)
