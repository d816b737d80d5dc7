"""The base of all effects: what they are built from, and when they act."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.roster import Roster
from rcj_challenges.world.tables import WorldTables


@dataclass(frozen=True)
class Scene:
    """A compiled world: MuJoCo's ``model`` and ``data``, with up-to-date poses of geoms, and what it was built from."""

    model: Any
    data: Any
    tables: WorldTables
    scenario: Scenario
    roster: Roster


class Effect:
    """A physical effect that MuJoCo lacks, or computes differently. Each hook is optional; not every world needs it."""

    is_needed = True

    def reset(self) -> None:
        """Reset commands at the beginning of a half."""

    def before_substep(self, substep: int) -> None:
        """Act on the state from which MuJoCo steps; sub-steps are 0 to 3 within the tick."""

    def after_substep(self, pattern: bytes) -> None:
        """Act on the state to which MuJoCo has stepped.

        ``pattern`` is the geoms of all contacts, as `data.contact.geom` has them in its memory.
        """
