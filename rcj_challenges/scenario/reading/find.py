"""Finding a scenario by path or by the name of a shipped one."""

from __future__ import annotations

from contextlib import suppress
from pathlib import Path, PureWindowsPath

from rcj_challenges.scenario.errors import ScenarioError, listing, nearest
from rcj_challenges.scenario.resources import names_in, own_of_that_name, scenarios_folder, shipped_scenarios
from rcj_challenges.scenario.tree import Mark


def find_scenario(source: str | Path) -> Path:
    """Return the file that ``source`` stands for: a path, or the bare name of a shipped scenario.

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
        return _unless_own(shipped[str(source)])
    mark = Mark(str(source)[:200])
    if exists:
        raise ScenarioError([mark.error("unreadable-file", "this is not a file", "give a scenario in YAML")])
    if reason := _why_unreadable(path):
        raise ScenarioError([mark.error("unreadable-file", f"cannot be read: {reason}")])
    stem = PureWindowsPath(source).stem  # documents may have been read on Windows: both kinds of slashes count
    own = _own_files(path.parent)
    own_name = nearest(stem, own)
    hints = [own[own_name].as_posix() if own_name is not None else None, nearest(stem, shipped)]
    # A name alone stands for a shipped one, unless a file is called just so.
    hint = next(filter(None, hints if path.parent != Path() or stem in own else reversed(hints)), None)
    folders = {kind: listing(names_in(scenarios_folder() / kind)) for kind in ("", "examples", "variants")}
    known = "; ".join(f"{kind} {names}".strip() for kind, names in folders.items())
    message = "no such file, and no shipped scenario of that name"
    help_ = f"did you mean '{hint}'? " if hint else ""
    raise ScenarioError([mark.error("no-such-file", message, f"{help_}shipped are {known}")])


def _why_unreadable(path: Path) -> str:
    """Return why it is not known whether there is such a file: the folder may be another user's. Empty: it is known."""
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


def _unless_own(shipped: Path) -> Path:
    """Return the file of a shipped scenario, unless one of the same name is in the current folder.

    An author who makes a challenge of a shipped name, and leaves out ``.yaml``, must not be shown another one.
    """
    own = own_of_that_name(shipped, Path())
    if own is None:
        return shipped
    message = f"a shipped scenario has this name, and {own} lies here"
    help_ = f"write {own} for that, or go to another folder"
    raise ScenarioError([Mark(shipped.stem).error("ambiguous-name", message, help_)])
