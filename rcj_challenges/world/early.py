"""The first sub-step of a tick, begun before it is known what robots are commanded in it.

Where bodies stand, what touches, and how all that is held together does not depend on commands: these only set how fast
wheels turn, and how much grip they have. It is a third of a sub-step, and programs think meanwhile (ADR 10).
"""

from __future__ import annotations

from collections.abc import Callable, Collection
from typing import Any

import mujoco

from rcj_challenges.world.tables import one_by_one


class EarlyStep:
    """`mujoco.mj_step` in two parts, with the same bits."""

    def __init__(self, model: Any, data: Any) -> None:
        self._model, self._data = model, data

    def begin(self) -> None:
        """Do what depends on `qpos` and on the coefficients of tendons, which may not be changed until `finish`."""
        model, data = self._model, self._data
        mujoco.mj_checkPos(model, data)
        mujoco.mj_checkVel(model, data)
        mujoco.mj_fwdPosition(model, data)

    def finish(self, changed: Collection[int], grip_n: Callable[[int], float]) -> None:
        """Do the rest, with `qvel` as it is now.

        Args:
            changed: tendons whose friction is another one than at `begin`. A tendon that had none then has none now.
            grip_n: tells the friction of a tendon.
        """
        model, data = self._model, self._data
        if changed:
            self._change_limits(changed, grip_n)
        mujoco.mj_fwdVelocity(model, data)
        mujoco.mj_step2(model, data)

    def _change_limits(self, changed: Collection[int], grip_n: Callable[[int], float]) -> None:
        """Write other limits of friction into the rows of constraints, and into those of the islands they belong to."""
        data = self._data
        row_of_tendon, limits_n = memoryview(data.tendon_efcadr), one_by_one(data.efc_frictionloss)
        rows = [(row_of_tendon[tendon], grip_n(tendon)) for tendon in changed]
        for row, limit_n in rows:
            if row >= 0:
                limits_n[row] = limit_n
        if data.nisland:
            row_in_islands, limits_n = memoryview(data.map_efc2iefc), one_by_one(data.iefc_frictionloss)
            for row, limit_n in rows:
                if row >= 0:
                    limits_n[row_in_islands[row]] = limit_n
