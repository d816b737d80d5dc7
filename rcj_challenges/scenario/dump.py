"""A scenario as plain data, as records keep it."""

from __future__ import annotations

import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from rcj_challenges.scenario.models.scenario import Scenario

_INTERRUPTS = ("SIGINT", "SIGTERM", "SIGHUP", "SIGBREAK")


def dumped(scenario: Scenario) -> dict[str, Any]:
    """Return a resolved scenario as JSON-able data."""
    with _interrupts_later():
        return scenario.model_dump(mode="json", by_alias=True)


@contextmanager
def _interrupts_later() -> Iterator[None]:
    """Let a Ctrl-C, or what means the same, wait: pydantic asks our functions, and swallows what they raise."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    usual = {number: signal.getsignal(number) for name in _INTERRUPTS if (number := getattr(signal, name, None))}
    usual = {number: handler for number, handler in usual.items() if callable(handler)}
    came: list[int] = []
    for number in usual:
        signal.signal(number, lambda number, _frame: came.append(number))
    try:
        yield
    finally:
        for number, handler in usual.items():
            signal.signal(number, handler)
        if came:
            signal.raise_signal(came[0])
