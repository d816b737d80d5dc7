"""Finding a scenario by path or by the name of a shipped one."""

from __future__ import annotations

from pathlib import Path, PureWindowsPath

from rcj_challenges.scenario.errors import Problem, ScenarioError, listing, nearest
from rcj_challenges.scenario.resources import names_in, own_of_that_name, scenarios_folder, shipped_scenarios


def find_scenario(source: str | Path) -> Path:
    """Return the file that ``source`` means: a path, or the bare name of a shipped scenario.

    Raises:
        ScenarioError: there is no such file, with the names of the shipped ones; or the name of an example or a
            variant is also that of a file in the current folder.
    """
    path = Path(source)
    try:
        if path.is_file():
            return path
        exists = path.exists()
    except (OSError, ValueError):  # a name too long, or with a zero byte
        exists = False
    shipped = shipped_scenarios()
    if str(source) in shipped:
        return _not_one_of_yours(shipped[str(source)])
    if exists:
        raise ScenarioError([Problem(str(source), 0, 0, "", "this is no file; expected a scenario in YAML")])
    stem = PureWindowsPath(source).stem  # documents may have been read on Windows: both kinds of slashes count
    hint = nearest(stem, shipped) or nearest(stem, names_in(path.parent))
    more = "; ".join(f"{kind} {listing(names_in(scenarios_folder() / kind))}" for kind in ("examples", "variants"))
    known = f"{listing(names_in(scenarios_folder()))}; {more}"
    message = f"no such file, and no shipped scenario of that name; shipped are {known}{hint}"
    raise ScenarioError([Problem(str(source)[:200], 0, 0, "", message)])


def _not_one_of_yours(shipped: Path) -> Path:
    """Return the file of a shipped scenario, unless it may be one of the current folder that is meant.

    Who makes a challenge of a shipped name, as the guide does, and leaves out ``.yaml``, must not be shown another one.
    """
    own = own_of_that_name(shipped, Path())
    if own is None:
        return shipped
    message = f"a shipped scenario has this name, and {own} lies here: write {own} for that, or go to another folder"
    raise ScenarioError([Problem(shipped.stem, 0, 0, "", message)])
