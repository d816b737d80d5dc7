"""Loads single modules of the sample teams, as they lie in ``examples/teams``."""

from __future__ import annotations

import importlib.util
import sys
import types
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

TEAMS = Path(__file__).resolve().parents[2] / "examples" / "teams"
PROGRAM = "rcj_soccer_team_blue"

Load = Callable[[str, str], types.ModuleType]


@pytest.fixture
def load() -> Iterator[Load]:
    """Return a function that loads ``(team, module)`` under a name of its own.

    Programs import ``controller``, which only exists inside a match; here it is a module with an empty ``Robot``. What
    a module imports from its own folder is forgotten again, because the teams use the same names.
    """
    modules, path = dict(sys.modules), list(sys.path)
    controller = types.ModuleType("controller")
    controller.Robot = object  # type: ignore[attr-defined]

    def load_module(team: str, name: str) -> types.ModuleType:
        folder = TEAMS / team / PROGRAM
        for file in TEAMS.glob(f"*/{PROGRAM}/*.py"):
            sys.modules.pop(file.stem, None)
        sys.modules["controller"] = controller
        sys.path[:] = [str(folder), *path]
        spec = importlib.util.spec_from_file_location(f"sample_{team}_{name}", folder / f"{name}.py")
        assert spec is not None
        assert spec.loader is not None
        module = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(module)
        return module

    yield load_module
    sys.path[:] = path
    for name in {"controller", *(file.stem for file in TEAMS.glob(f"*/{PROGRAM}/*.py"))}:
        sys.modules.pop(name, None)
        if name in modules:
            sys.modules[name] = modules[name]
