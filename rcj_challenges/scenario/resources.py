"""Where the shipped files lie: presets, scenarios, sample teams, schemas.

Presets are part of the package. Scenarios, teams and schemas are package data in a wheel; in a checkout they are the
folders that people edit, beside the package.
"""

from __future__ import annotations

import os
from pathlib import Path

_PACKAGE = Path(__file__).resolve().parent.parent


def data_folder(packaged: str, checked_out: str) -> Path:
    """Return a folder of package data or, in a checkout, the one beside the package."""
    in_wheel = _PACKAGE / "data" / packaged
    return in_wheel if in_wheel.is_dir() else _PACKAGE.parent / checked_out


PRESETS_FOLDER = _PACKAGE / "scenario" / "presets"
"""The presets that ``extends`` knows by name."""
STARTERS_FOLDER = _PACKAGE / "scenario" / "starters"
"""What ``new`` writes: a scenario and a program for each preset."""
SCENARIOS_FOLDER = data_folder("scenarios", "scenarios")
TOURNAMENTS_FOLDER = data_folder("tournaments", "tournaments")
TEAMS_FOLDER = data_folder("teams", "examples/teams")
SCHEMAS_FOLDER = data_folder("schemas", "schemas")


def shipped_scenarios() -> dict[str, Path]:
    """Return the files of all shipped scenarios by their bare names: the challenges, then examples and variants."""
    folders = (SCENARIOS_FOLDER, *(SCENARIOS_FOLDER / kind for kind in ("examples", "variants")))
    return {name: folder / f"{name}.yaml" for folder in folders for name in names_in(folder)}


def own_of_that_name(shipped: Path, folder: Path) -> Path | None:
    """Return the file in a folder that is called like a shipped example or variant, and is another one; None: none is.

    The names of challenges and presets are not asked about: they always mean the shipped ones.
    """
    if shipped.parent.parent != SCENARIOS_FOLDER:
        return None
    for own in (folder / shipped.name, folder / f"{shipped.stem}.yml"):
        try:
            if own.is_file() and not own.samefile(shipped):
                return own
        except OSError:  # the folder cannot be read
            return None
    return None


def shipped_teams() -> dict[str, Path]:
    """Return the folders of all sample teams by their names."""
    folders = TEAMS_FOLDER.iterdir() if _is_folder(TEAMS_FOLDER) else ()
    return {team.name: team for team in sorted(folders) if team.is_dir() and not team.name.startswith((".", "_"))}


def names_in(folder: Path) -> list[str]:
    """Return the names of the YAML files of a folder, without the suffix, sorted."""
    return sorted(path.stem for path in folder.glob("*.yaml")) if _is_folder(folder) else []


def _is_folder(path: Path) -> bool:
    return os.path.isdir(path)  # noqa: PTH112 - that of pathlib raises for names that are too long
