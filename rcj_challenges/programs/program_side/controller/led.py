"""The light that a program switches."""

from __future__ import annotations

import math

from ._connection import Connection, complain, number
from .device import Device

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

__all__ = ["LED"]


class LED(Device):
    """A light that a program switches, for people who watch."""

    def _rcj_set_up(self, connection: Connection, spec: dict[str, Any]) -> None:
        super()._rcj_set_up(connection, spec)
        self._rcj_value = 0

    def set(self, value: int) -> None:
        """Light the first colour with 1, the second with 2, and so on; 0 switches it off.

        Raises:
            TypeError: no number was given.

        Example:
            ``led.set(1)``
        """
        asked = int(number(value, f"{self._rcj_name!r}: set takes the number of a colour, such as 1"))
        most = len(self._rcj_facts["colours"])
        if not 0 <= asked <= most:
            complain(f"Warning: {self._rcj_name!r}: there is no colour {asked}; 0 to {most} are possible.")
            return
        self._rcj_value = asked
        self._rcj_connection.command(self._rcj_index, float(asked), math.inf)

    def get(self) -> int:
        """Return the number of the colour that is lit; 0: none."""
        return self._rcj_value

    value = property(get, set)  # noqa: A003 - the method
