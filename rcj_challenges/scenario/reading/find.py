"""Finding a scenario by path or by the name of a shipped one."""

from __future__ import annotations

from pathlib import Path, PureWindowsPath

from rcj_challenges.scenario.errors import Problem, ScenarioError, listing, nearest
from rcj_challenges.scenario.resources import names_in, scenarios_folder


def find_scenario(source: str | Path) -> Path:
    """Return the file that ``source`` means: a path, or the bare name of a shipped scenario.

    Raises:
        ScenarioError: there is no such file, with the names of the shipped ones.
    """
    path = Path(source)
    try:
        if path.is_file():
            return path
        exists = path.exists()
    except (OSError, ValueError):  # a name too long, or with a zero byte
        exists = False
    shipped = {found.stem: found for found in sorted(scenarios_folder().glob("*.yaml"))}
    if str(source) in shipped:
        return shipped[str(source)]
    if exists:
        raise ScenarioError([Problem(str(source), 0, 0, "", "this is no file; expected a scenario in YAML")])
    stem = PureWindowsPath(source).stem  # documents may have been read on Windows: both kinds of slashes count
    hint = nearest(stem, shipped) or nearest(stem, names_in(path.parent))
    message = f"no such file, and no shipped scenario of that name; shipped are {listing(shipped)}{hint}"
    raise ScenarioError([Problem(str(source)[:200], 0, 0, "", message)])
