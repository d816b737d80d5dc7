"""Diagnostic a scenario by path or by the name of a shipped one."""

from __future__ import annotations

from contextlib import suppress
from pathlib import Path, PureWindowsPath
from stat import S_ISREG

from rcj_challenges.scenario.codes import AMBIGUOUS_NAME, NO_SUCH_FILE, UNREADABLE_FILE
from rcj_challenges.scenario.errors import ScenarioError, listing, nearest
from rcj_challenges.scenario.resources import names_in, own_of_that_name, scenarios_folder, shipped_scenarios
from rcj_challenges.scenario.tree import Mark


def find_scenario(source: str | Path) -> Path:
    """Return the file that ``source`` stands for: a path, or the bare name of a shipped scenario.

    Raises:
        ScenarioError: there is no such file, with the names of the shipped ones; or the name of an example or a
            variant is also that of a file in the current folder.
    """
    path, mark, problem = Path(source), Mark(str(source)[:200]), ""
    try:
        if S_ISREG(path.stat().st_mode):
            return path
        problem = "this is not a file"
    except PermissionError as error:  # the folder may be another user's
        problem = f"cannot be read: {error.strerror}"
    except (OSError, ValueError):  # there is none; a name too long, or with a zero byte
        pass
    shipped = shipped_scenarios()
    if str(source) in shipped:
        # An author who makes a challenge of a shipped name, and leaves out .yaml, must not be shown another one.
        own = own_of_that_name(shipped[str(source)], Path())
        if own is None:
            return shipped[str(source)]
        message = f"a shipped scenario has this name, and {own} lies here"
        help_ = f"write {own} for that, or go to another folder"
        raise ScenarioError([mark.error(AMBIGUOUS_NAME, message, help_)])
    if problem:
        raise ScenarioError([mark.error(UNREADABLE_FILE, problem, "give a scenario in YAML")])
    hint = _nearest_file(path, shipped)
    folders = {kind: listing(names_in(scenarios_folder() / kind)) for kind in ("", "examples", "variants")}
    known = "; ".join(f"{kind} {names}".strip() for kind, names in folders.items())
    message = "no such file, and no shipped scenario of that name"
    help_ = f"did you mean '{hint}'? " if hint else ""
    raise ScenarioError([mark.error(NO_SUCH_FILE, message, f"{help_}shipped are {known}")])


def _nearest_file(path: Path, shipped: dict[str, Path]) -> str | None:
    stem = PureWindowsPath(path).stem  # documents may have been read on Windows: both kinds of slashes count
    files: dict[str, Path] = {}
    with suppress(OSError, ValueError):
        files = {found.stem: found for found in sorted(path.parent.glob("*.y*ml"), reverse=True)}
    own, other = nearest(stem, files), nearest(stem, shipped)
    # A name alone stands for a shipped one, unless a file is called just so.
    is_own = own is not None and (own == stem or other is None or path.parent != Path())
    return files[own].as_posix() if own is not None and is_own else other
