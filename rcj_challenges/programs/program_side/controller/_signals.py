"""Signal handlers: an exception raised during a step's exchange is delayed until the step is over.

A handler may run between any two instructions. One that raised between sending a request and keeping the answer would
lose the answer, and program and match would be at different ticks.
"""

from __future__ import annotations

import _signal  # type: ignore[import-not-found]  # what `signal` is made of, without its enums

from ._connection import Connection

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

_EXCHANGE = Connection.exchange_in_turn.__code__


class Patient:
    """A handler; what it raises in the middle of an exchange is raised at its end."""

    def __init__(self, handler: Any, connection: Connection) -> None:
        self.handler = handler
        self._connection = connection

    def __call__(self, number: int, frame: Any) -> None:
        """Handle the signal, as the interpreter asks for."""
        if not _is_exchanging(frame):
            self.handler(number, frame)
            return
        try:
            self.handler(number, frame)
        except BaseException as error:  # noqa: BLE001 - whatever it is
            self._connection.raised = error


def _is_exchanging(frame: Any) -> bool:
    while frame is not None:
        if frame.f_code is _EXCHANGE:
            return True
        frame = frame.f_back
    return False


def hold_interrupts(connection: Connection) -> None:
    """Also delay the exception of Ctrl-C: its handler is set before any program runs."""
    if _signal.getsignal(_signal.SIGINT) is _signal.default_int_handler:
        _signal.signal(_signal.SIGINT, Patient(_signal.default_int_handler, connection))


def make_patient(module: Any, connection: Connection) -> None:
    """Let ``signal.signal`` keep handlers in this form; a program sees its own."""
    real_signal, real_getsignal = module.signal, module.getsignal

    def shown(handler: Any) -> Any:
        return handler.handler if isinstance(handler, Patient) else handler

    def signal(signalnum: int, handler: Any) -> Any:
        return shown(real_signal(signalnum, Patient(handler, connection) if callable(handler) else handler))

    def getsignal(signalnum: int) -> Any:
        return shown(real_getsignal(signalnum))

    module.signal, module.getsignal = signal, getsignal
