"""What asyncio had in Python 3.8, for programs that import it."""

from __future__ import annotations

import functools
import inspect
import threading
import types

from ._methods import restore_methods

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

_TOLD_A_LOOP = ("sleep", "gather", "wait_for", "shield", "as_completed")
_OF_A_LOOP = ("Lock", "Event", "Condition", "Semaphore", "BoundedSemaphore", "Queue")


def restore_old_names(asyncio: Any) -> None:
    """Give asyncio its coroutines of generators, ``loop=`` and what tasks told; and the main thread its loop."""

    def coroutine(func: Any) -> Any:
        if inspect.iscoroutinefunction(func):
            return func
        real = types.coroutine(func)

        @functools.wraps(func)
        async def coro(*given: Any, **named: Any) -> Any:
            made = real(*given, **named)
            return await made if inspect.isawaitable(made) else made

        return coro

    vars(asyncio).setdefault("coroutine", coroutine)
    _make_loops(asyncio)
    _take_loops(asyncio)
    _wait_for_coroutines(asyncio)
    told = {name: staticmethod(getattr(asyncio, name)) for name in ("all_tasks", "current_task")}
    restore_methods(asyncio.Task, told)


def _make_loops(asyncio: Any) -> None:
    """Let the main thread's first question for an event loop make one, which ended with Python 3.14."""
    present = asyncio.get_event_loop

    def get_event_loop() -> Any:
        try:
            return present()
        except RuntimeError:
            if threading.current_thread() is not threading.main_thread():
                raise
            asyncio.set_event_loop(asyncio.new_event_loop())
            return present()

    asyncio.get_event_loop = get_event_loop


def _take_loops(asyncio: Any) -> None:
    """Let functions and locks be told the loop that runs: they find it themselves."""
    for name in _TOLD_A_LOOP:
        setattr(asyncio, name, _told_a_loop(getattr(asyncio, name)))
    for name in _OF_A_LOOP:
        kind = getattr(asyncio, name)
        kind.__init__ = _told_a_loop(kind.__init__)


def _told_a_loop(real: Callable[..., Any]) -> Callable[..., Any]:
    @functools.wraps(real)
    def function(*given: Any, loop: Any = None, **named: Any) -> Any:  # noqa: ARG001 - as it was
        return real(*given, **named)

    return function


def _wait_for_coroutines(asyncio: Any) -> None:
    real = asyncio.wait

    async def wait(fs: Any, *, loop: Any = None, **named: Any) -> Any:  # noqa: ARG001 - as it was
        """Wait for coroutines too, not for tasks alone."""
        return await real({asyncio.ensure_future(one) for one in set(fs)}, **named)

    asyncio.wait = wait
