"""Modules of Python that are there before a program begins: a team's file of such a name is never read."""

from __future__ import annotations

import functools
import sys
from collections.abc import Iterable
from pathlib import PurePosixPath

from rcj_challenges.checker.modules import Library, Module, places_of
from rcj_challenges.controllers.crew import Crew, CrewPlan
from rcj_challenges.controllers.private_folders import PrivateFolders
from rcj_challenges.controllers.team import open_team
from rcj_challenges.core.errors import RcjError
from rcj_challenges.core.traffic import RobotSpec
from rcj_challenges.scenario.models.limits import Limits

_MARK = "loaded:"
# What is in memory, and what the import system finds within the interpreter before it looks into any folder.
_PROBE = f"""\
import sys
found = set(sys.modules)
from importlib.machinery import BuiltinImporter, FrozenImporter
for name in sys.stdlib_module_names:
    if BuiltinImporter.find_spec(name) or FrozenImporter.find_spec(name):
        found.add(name)
print("{_MARK}", *sorted(found))
"""
_ROBOT = RobotSpec("probe", (), 0, "bytes")


def never_read(files: Iterable[PurePosixPath], entry: PurePosixPath, sandbox: str) -> dict[str, PurePosixPath]:
    """Return the files that a program would import if Python had no module of that name in memory, by that name.

    Args:
        files: paths of all files of the submission.
        entry: the program.
        sandbox: ``auto``, ``strict`` or ``off``.
    """
    library = Library(files, places_of(entry))
    of_pythons = [name for name in library.names() if name in sys.stdlib_module_names]
    found = {name: _first_file(library.tops(name)) for name in of_pythons if name in preloaded_modules(sandbox)}
    return {name: path for name, path in found.items() if path is not None}


def _first_file(modules: Iterable[Module]) -> PurePosixPath | None:
    return next((module.file for module in modules if module.file is not None), None)


@functools.cache
def preloaded_modules(sandbox: str) -> frozenset[str]:
    """Return the modules of Python's library that no file of a team can stand for.

    A program is started as in a match and asked: what the start needs differs between systems and versions. Where none
    can be started, it is at least what is built into the interpreter.

    Args:
        sandbox: ``auto``, ``strict`` or ``off``: layers of the isolation load modules too.
    """
    try:
        loaded = _read_from_program(sandbox)
    except (OSError, RcjError):
        loaded = frozenset()
    return (loaded or frozenset(sys.builtin_module_names)) & sys.stdlib_module_names


def _read_from_program(sandbox: str) -> frozenset[str]:
    """Return the names that are taken when a program starts; none if it does not report them."""
    with PrivateFolders() as folders:
        folder = folders.place
        probe = folder / "probe.py"
        probe.write_text(_PROBE, encoding="utf-8")
        plan = CrewPlan(limits=Limits(), half=1, match_seed=0, logs=folder, sandbox=sandbox)
        with open_team(probe) as team, Crew(plan) as crew:
            program = crew.add(_ROBOT, team, probe.name)
            crew.launch()
            program.collect()
            program.keep_output()
            said = program.new_output()
    line = next((line for line in said.splitlines() if line.startswith(_MARK)), "")
    return frozenset(line.split()[1:])
