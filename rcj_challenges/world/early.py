"""The first sub-step of a tick, begun before it is known what robots are commanded in it.

Where bodies stand, what touches, and how all that is held together does not depend on commands: these only set how fast
wheels turn, and how much grip they have. It is a third of a sub-step, and programs think meanwhile (ADR 10).
"""

from __future__ import annotations

from collections.abc import Callable, Collection
from typing import Any

import mujoco


class EarlyStep:
    """`mujoco.mj_step` in two parts, with the same bits."""

    def __init__(self, model: Any, data: Any) -> None:
        self._model, self._data = model, data
        self._row_of_tendon: Any = ()
        self._limits_n: Any = ()
        self._row_in_islands: Any = ()
        self._limits_in_islands_n: Any = ()

    def begin(self) -> None:
        """Do what depends on `qpos` and on the coefficients of tendons, which may not be changed until `finish`."""
        model, data = self._model, self._data
        mujoco.mj_step1(model, data)
        # Taken now, as it is not known yet whether they are needed: MuJoCo lays them out anew in each sub-step.
        self._row_of_tendon, self._limits_n = memoryview(data.tendon_efcadr), memoryview(data.efc_frictionloss)
        if data.nisland:
            self._row_in_islands = memoryview(data.map_efc2iefc)
            self._limits_in_islands_n = memoryview(data.iefc_frictionloss)

    def finish(self, changed: Collection[int], grip_n: Callable[[int], float]) -> None:
        """Do the rest, with `qvel` as it is now.

        Args:
            changed: tendons whose friction is another one than at `begin`. A tendon that had none then has none now.
            grip_n: tells the friction of a tendon.
        """
        model, data = self._model, self._data
        for tendon in changed:
            row = self._row_of_tendon[tendon]
            if row >= 0:
                self._limits_n[row] = grip_n(tendon)
                if data.nisland:
                    self._limits_in_islands_n[self._row_in_islands[row]] = grip_n(tendon)
        mujoco.mj_fwdVelocity(model, data)
        mujoco.mj_step2(model, data)
