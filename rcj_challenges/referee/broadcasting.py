"""The scenario's broadcast: values sent to all programs, or to single robots, beyond the official packet."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from rcj_challenges.referee.compiling import CompileContext
from rcj_challenges.rules.values import Value, compile_value
from rcj_challenges.scenario.models.scenario import Broadcast
from rcj_challenges.tracking.bound_rules import NO_FIRING, Reader

Told = dict[str, Any]


class Broadcasting:
    """Reads the values of a scenario's broadcast."""

    def __init__(self, broadcast: Broadcast, context: CompileContext) -> None:
        """Compile it.

        Args:
            broadcast: of the scenario.
            context: whose state the values are read from.
        """
        self._every_ticks = broadcast.every_ticks
        self._to_all = _readers(broadcast.fields, context)
        self._to_some: dict[int, dict[str, Reader]] = {}
        for name, fields in (broadcast.only or {}).items():
            readers = _readers(fields, context)
            for robot in context.roster.expand(name) if readers else ():
                self._to_some.setdefault(context.roster.index[robot], {}).update(readers)

    def values_at(self, tick: int) -> tuple[Told | None, dict[int, Told] | None]:
        """Return the values sent to all robots at a tick, and to single ones besides, by index; None: nothing."""
        if tick % self._every_ticks:
            return None, None
        to_some = {robot: _read(readers) for robot, readers in self._to_some.items()}
        return _read(self._to_all), to_some or None


def _readers(fields: Mapping[str, Value], context: CompileContext) -> dict[str, Reader]:
    return {key: compile_value(value, context.names) for key, value in fields.items()}


def _read(readers: Mapping[str, Reader]) -> Told:
    return {key: read(NO_FIRING) for key, read in readers.items()}
