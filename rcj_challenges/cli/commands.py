"""All commands, in the order in which ``--help`` lists them below each heading; each is a module of its name."""

from __future__ import annotations

import copy
from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from rcj_challenges.cli.app import App

COMMANDS = (
    "run", "validate", "test", "explain", "new", "schema", "draw", "sheet", "simulate", "compare", "teams", "view",
    "replay", "check", "judge", "stats", "video", "snapshot", "tournament", "site", "submit", "verify",
)  # fmt: skip


def load_app(command: str = "") -> App:
    """Return the command line with one command alone, or with all of them if none has that name.

    All of them take 80 ms to import and to read their options.
    """
    from rcj_challenges.cli.app import app

    if command not in COMMANDS:
        for name in COMMANDS:
            import_module(f"rcj_challenges.cli.{name}")
        return app
    import_module(f"rcj_challenges.cli.{command}")
    quick = copy.copy(app)
    quick.registered_commands = [
        one for one in app.registered_commands if command in (one.name, getattr(one.callback, "__name__", ""))
    ]
    quick.registered_groups = [one for one in app.registered_groups if one.name == command]
    return quick
