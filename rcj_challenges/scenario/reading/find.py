"""Finding a scenario by path or by the name of a shipped one."""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import suppress
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
    if kept_back := _why_kept_back(path):
        raise ScenarioError([Problem(str(source)[:200], 0, 0, "", f"cannot be read: {kept_back}")])
    stem = PureWindowsPath(source).stem  # documents may have been read on Windows: both kinds of slashes count
    own = _own_files(path.parent)
    hints = [_own_alike(stem, own), nearest(stem, shipped)]
    # A name alone means a shipped one, unless a file is called just so.
    hint = next(filter(None, hints if path.parent != Path() or stem in own else reversed(hints)), "")
    more = "; ".join(f"{kind} {listing(names_in(scenarios_folder() / kind))}" for kind in ("examples", "variants"))
    known = f"{listing(names_in(scenarios_folder()))}; {more}"
    message = f"no such file, and no shipped scenario of that name; shipped are {known}{hint}"
    raise ScenarioError([Problem(str(source)[:200], 0, 0, "", message)])


def _why_kept_back(path: Path) -> str:
    """Return why nobody tells whether there is such a file: the folder may be another user's. Empty: it is told."""
    try:
        path.stat()
    except PermissionError as error:
        return error.strerror or "it is not permitted"
    except (OSError, ValueError):
        pass
    return ""


def _own_files(folder: Path) -> dict[str, Path]:
    """Return the YAML files of a folder by their names without the ending; of what is none, nothing."""
    with suppress(OSError, ValueError):
        return {found.stem: found for found in sorted(folder.glob("*.y*ml"), reverse=True)}
    return {}


def _own_alike(stem: str, own: Mapping[str, Path]) -> str:
    """Return which file of the author's may be meant, as it is written; empty: none."""
    hint = nearest(stem, own)
    near = next((name for name in own if hint == nearest(name, [name])), None)
    return f"; did you mean '{own[near].as_posix()}'?" if near is not None else ""


def _not_one_of_yours(shipped: Path) -> Path:
    """Return the file of a shipped scenario, unless it may be one of the current folder that is meant.

    Who makes a challenge of a shipped name, as the guide does, and leaves out ``.yaml``, must not be shown another one.
    """
    own = own_of_that_name(shipped, Path())
    if own is None:
        return shipped
    message = f"a shipped scenario has this name, and {own} lies here: write {own} for that, or go to another folder"
    raise ScenarioError([Problem(shipped.stem, 0, 0, "", message)])
