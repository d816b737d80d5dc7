"""Reading a file and all that it extends."""

from __future__ import annotations

import os
import re
from collections.abc import Mapping
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path, PurePosixPath, PureWindowsPath
from stat import S_ISREG
from typing import Any

from rcj_challenges import __version__
from rcj_challenges.core.code import Code
from rcj_challenges.core.files import open_regular
from rcj_challenges.scenario import codes
from rcj_challenges.scenario.errors import ScenarioError, choice_of, did_you_mean, listing, nearest
from rcj_challenges.scenario.models.scenario import SCHEMA_VERSION
from rcj_challenges.scenario.reading.version_1 import new_texts, to_version_2
from rcj_challenges.scenario.reading.yaml_strict import MAX_BYTES, parse_bytes, parse_text, refuse_size
from rcj_challenges.scenario.resources import (
    PRESETS_FOLDER,
    SCENARIOS_FOLDER,
    names_in,
    own_of_that_name,
    shipped_scenarios,
)
from rcj_challenges.scenario.tree import Entries, Items, Leaf, Mark, Node, in_names

MAX_CHAIN = 5
"""How many base files may stand behind each other."""

_BARE_NAME = re.compile(r"[A-Za-z0-9_-]+")


@dataclass(frozen=True)
class Source:
    """A file's tree."""

    tree: Entries
    shown: str
    path: Path

    @classmethod
    def of_file(cls, path: Path, shown: str) -> Source:
        """Read a file.

        Raises:
            ScenarioError: it cannot be read, or is not strict YAML.
        """
        try:
            with open_regular(path) as file:
                data = file.read(MAX_BYTES + 1)
                size = max(len(data), os.fstat(file.fileno()).st_size)
        except OSError as error:
            message = f"cannot be read: {error.strerror or error}"
            raise ScenarioError([Mark(shown).error(codes.UNREADABLE_FILE, message)]) from None
        refuse_size(size, shown)
        return cls(_mapping(parse_bytes(data, shown)), shown, path)

    @classmethod
    def of_text(cls, text: str, shown: str) -> Source:
        """Read a text, which stands beside the shipped scenarios: files of the current folder are not its own.

        Raises:
            ScenarioError: it is not strict YAML.
        """
        return cls(_mapping(parse_text(text, shown)), shown, SCENARIOS_FOLDER / shown)


def _mapping(node: Node) -> Entries:
    if isinstance(node, Entries):
        return node
    found = "a list" if isinstance(node, Items) else "nothing" if node.value is None else "a single value"
    help_ = "a scenario is a mapping of sections: schema_version, id, title, …"
    raise ScenarioError([node.mark.error(codes.WRONG_VALUE, f"expected a mapping, found {found}", help_)])


def tree_of(data: Mapping[str, Any], shown: str) -> Entries:
    """Return plain data as a tree; everything in it stands at the same place: the data as a whole."""
    tree = _mapping(_wrapped(data, Mark(shown)))
    to_version_2(tree)
    return tree


def _wrapped(data: Any, mark: Mark) -> Node:
    if isinstance(data, Mapping):
        # None stands for "left out" in the models, and in what they write.
        entries = {str(key): _wrapped(value, mark) for key, value in data.items() if value is not None}
        return Entries(entries, mark, dict.fromkeys(entries, mark))
    if isinstance(data, (list, tuple)):
        return Items([_wrapped(value, mark) for value in data], mark)
    return Leaf(data, mark)


def read_chain(source: Source) -> list[Source]:
    """Return a file and all that it extends, the outermost base first.

    Raises:
        ScenarioError: a base is unknown, unreadable, extends itself, or the chain is too long; or a file has forms of
            version 1.
    """
    chain = [source]
    _refuse_newer(source)
    while (leaf := chain[-1].tree.entries.get("extends")) is not None:
        mark = leaf.mark
        if not isinstance(leaf, Leaf) or not isinstance(leaf.value, str):
            raise _refused(mark, "expected a text", _FORMS)
        if len(chain) > MAX_CHAIN:
            files = " → ".join(part.shown for part in chain)
            raise _refused(mark, f"too many bases behind each other: {files}", f"at most {MAX_CHAIN} are read")
        base = _base(leaf.value, chain[-1], mark)
        if base.path.resolve() in [part.path.resolve() for part in chain]:
            files = " → ".join([*(part.shown for part in chain), base.shown])
            raise _refused(mark, f"a file cannot extend itself: {files}")
        _refuse_newer(base)
        chain.append(base)
    problems = [
        mark.error(codes.OLD_LANGUAGE, _old(part), f"write {text}", in_names(part.tree, path))
        for at, part in enumerate(chain)
        for mark, (path, text) in new_texts(part.tree, [base.tree for base in chain[at + 1 :]]).items()
    ]
    if problems:
        raise ScenarioError(problems)
    return chain[::-1]


def _old(source: Source) -> str:
    message = "this form is of version 1 of the language"
    return message if "schema_version" in source.tree.entries else f"{message}, as is a file without schema_version"


_FORMS = (
    "write the name of a shipped preset or scenario, or a relative path with / to a .yaml file, with '..' at its "
    "beginning only"
)


def _refuse_newer(source: Source) -> None:
    """Refuse a file of a later format before anything else in it is called wrong."""
    version = source.tree.entries.get("schema_version")
    if isinstance(version, Leaf) and isinstance(version.value, int) and version.value > SCHEMA_VERSION:
        message = f"version {version.value} needs a newer rcj-challenges; {__version__} reads version {SCHEMA_VERSION}"
        help_ = "pip install --upgrade rcj-challenges"
        raise ScenarioError([version.mark.error(codes.NEWER_VERSION, message, help_, "schema_version")])


def _refused(mark: Mark, message: str, help_: str = "", code: Code = codes.WRONG_EXTENDS) -> ScenarioError:
    return ScenarioError([mark.error(code, message, help_, "extends")])


def _base(name: str, user: Source, mark: Mark) -> Source:
    if _BARE_NAME.fullmatch(name):
        return _shipped(name, user, mark)
    parts = PurePosixPath(name).parts
    # Checked as text on every platform alike: what Windows takes for absolute must not pass on Linux either.
    is_foreign = name.startswith(("/", "~")) or re.search(r"[\\:\x00-\x1f]", name)
    is_upwards_later = ".." in parts[len([part for part in parts if part == ".."]) :]
    if is_foreign or is_upwards_later or not name.endswith((".yaml", ".yml")):
        raise _refused(mark, f"'{name[:120]}' is not a relative path to a .yaml file", _FORMS)
    path = user.path.parent.joinpath(*parts)
    beside = _scenarios_in(path.parent)
    # Compared with the folder's listing: a name in other case works on some machines only.
    if path.name not in beside or not path.is_file():
        near = nearest(path.name, [found for found in beside if path.parent / found != user.path])
        help_ = f"did you mean '{PurePosixPath(*parts).with_name(near).as_posix()}'?" if near else ""
        if path.stem in _shipped_files():
            help_ = f"what is shipped is extended by its name alone: {path.stem}"
        raise _refused(mark, f"there is no file '{name[:120]}' beside {user.shown}", help_, codes.UNKNOWN_BASE)
    shown = PurePosixPath(user.shown.replace("\\", "/")).parent / PurePosixPath(*parts)
    return Source.of_file(path, os.path.normpath(shown).replace("\\", "/"))


def _shipped(name: str, user: Source, mark: Mark) -> Source:
    """Return the shipped scenarios and presets that are extended by their bare names."""
    shipped = _shipped_files()
    if name in shipped:
        own = own_of_that_name(shipped[name], user.path.parent)
        # A file of the name that it extends does not extend itself.
        if own is not None and not own.samefile(user.path):
            message = f"a shipped scenario has this name, and {own.name} lies beside {user.shown}"
            raise _refused(mark, message, f"write {own.name} for that, or give it another name", codes.AMBIGUOUS_NAME)
        # A file that extends the match may be called match.yaml: errors must distinguish the two.
        shown = f"{name}.yaml" if PurePosixPath(user.shown).name != f"{name}.yaml" else f"shipped {name}.yaml"
        return Source.of_file(shipped[name], shown)
    own_files = [found for found in _scenarios_in(user.path.parent) if found != user.path.name]
    hint = did_you_mean(name.replace("-", "_"), [*own_files, *shipped])
    known = choice_of("", [*names_in(SCENARIOS_FOLDER), *names_in(PRESETS_FOLDER)])
    message = f"no preset or scenario '{name[:64]}' is shipped"
    raise _refused(mark, message, f"{hint}{' ' if hint else ''}{known}", codes.UNKNOWN_BASE)


def _shipped_files() -> dict[str, Path]:
    return {**shipped_scenarios(), **{name: PRESETS_FOLDER / f"{name}.yaml" for name in names_in(PRESETS_FOLDER)}}


def _scenarios_in(folder: Path) -> list[str]:
    """Return the names of a folder's scenarios; of one that cannot be read, or is none, nothing."""
    with suppress(OSError):
        return sorted(found.name for found in folder.glob("*.y*ml"))
    return []


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
        raise ScenarioError([mark.error(codes.AMBIGUOUS_NAME, message, help_)])
    if problem:
        raise ScenarioError([mark.error(codes.UNREADABLE_FILE, problem, "give a scenario in YAML")])
    hint = _nearest_file(path, shipped)
    folders = {kind: listing(names_in(SCENARIOS_FOLDER / kind)) for kind in ("", "examples", "variants")}
    known = "; ".join(f"{kind} {names}".strip() for kind, names in folders.items())
    message = "no such file, and no shipped scenario of that name"
    help_ = f"did you mean '{hint}'? " if hint else ""
    raise ScenarioError([mark.error(codes.NO_SUCH_FILE, message, f"{help_}shipped are {known}")])


def _nearest_file(path: Path, shipped: dict[str, Path]) -> str | None:
    stem = PureWindowsPath(path).stem  # documents may have been read on Windows: both kinds of slashes count
    files: dict[str, Path] = {}
    with suppress(OSError, ValueError):
        files = {found.stem: found for found in sorted(path.parent.glob("*.y*ml"), reverse=True)}
    own, other = nearest(stem, files), nearest(stem, shipped)
    # A name alone stands for a shipped one, unless a file is called just so.
    is_own = own is not None and (own == stem or other is None or path.parent != Path())
    return files[own].as_posix() if own is not None and is_own else other
