"""A scenario as plain data, as records keep it."""

from __future__ import annotations

import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from rcj_challenges.scenario.models.scenario import Scenario


def dumped(scenario: Scenario) -> dict[str, Any]:
    """Return a resolved scenario as JSON-able data."""
    with _interrupts_later():
        return scenario.model_dump(mode="json", by_alias=True)


@contextmanager
def _interrupts_later() -> Iterator[None]:
    """Let a Ctrl-C wait: pydantic asks our functions which kind of value it has, and swallows what they raise."""
    usual = signal.getsignal(signal.SIGINT)
    if threading.current_thread() is not threading.main_thread() or not callable(usual):
        yield
        return
    came: list[int] = []
    signal.signal(signal.SIGINT, lambda number, _frame: came.append(number))
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, usual)
        if came:
            signal.raise_signal(signal.SIGINT)
