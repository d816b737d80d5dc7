"""One match of many: the command line in a process that ends with its parent, however that ends."""

from __future__ import annotations

import _thread
import json
import os
import signal
import sys
import threading
import time

from rcj_challenges.cli import INTERRUPTED
from rcj_challenges.cli import main as command
from rcj_challenges.core.errors import RcjError

_CLOSE_S = 1.0
"""How long a match may take to close its record after its parent is gone."""


def main() -> None:
    """Run the command line. Standard input is the lifeline: a pipe that ends when the parent does.

    The code of an error goes to standard output as JSON, where the parent expects a result.
    """
    lifeline = os.dup(0)
    # On Windows any call on a pipe blocks while a thread reads from it, so nothing else may use this one.
    nowhere = os.open(os.devnull, os.O_RDONLY)
    os.dup2(nowhere, 0)
    os.close(nowhere)
    _thread.start_new_thread(_end_with_parent, (lifeline,))
    command(_write_code)


def _write_code(error: RcjError) -> None:
    sys.stdout.write(json.dumps({"code": error.code or ""}))
    sys.stdout.flush()


def _end_with_parent(lifeline: int) -> None:
    """Interrupt the command as soon as the lifeline ends, so that its record is closed, then end it in any case."""
    try:
        while os.read(lifeline, 1):
            pass
    finally:
        if os.name == "posix":
            # To the main thread itself: it may be waiting for programs, and only its own signal wakes it.
            signal.pthread_kill(threading.main_thread().ident or 0, signal.SIGTERM)
        else:
            _thread.interrupt_main()
        time.sleep(_CLOSE_S)
        os._exit(INTERRUPTED)
