"""Attributes of a team's own objects that are used before anything has set them, and members that no Enum has."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from pathlib import PurePosixPath

from rcj_challenges.checker.advice.crash_lines import text_of
from rcj_challenges.facts.shown import shown

_MOST_BYTES = 1_000_000  # of a file; a longer one is no program by hand
_MOST_NAME = 100  # letters
_UNSET = re.compile(
    rf"^AttributeError: '(?P<owner>\w{{1,{_MOST_NAME}}})' object has no attribute "
    rf"'(?P<name>\w{{1,{_MOST_NAME}}})'(?!\. Did)"
)
_NO_MEMBER = re.compile(rf"^AttributeError: \w{{1,{_MOST_NAME}}}(?: \(|$)")  # up to Python 3.11 of an Enum
_ENUM = re.compile(r"\bimport\b.{0,200}\bEnum\b|\bimport enum\b")
_CLASS = re.compile(rf"[ \t]{{0,80}}class[ \t]{{1,8}}(\w{{1,{_MOST_NAME}}})[ \t]{{0,8}}(?:\(([^)\n]{{0,300}})\))?")
_METHOD = re.compile(rf"[ \t]{{0,80}}(?:async[ \t]{{1,8}})?def[ \t]{{1,8}}(\w{{1,{_MOST_NAME}}})")


def on_unset_attribute(detail: str, files: Mapping[PurePosixPath, bytes]) -> str:
    """Return what to do about an attribute that is set in a line to which the program had not come; nothing if none is.

    Args:
        detail: the last line of what the program told of its end.
        files: of the team.
    """
    if _NO_MEMBER.match(detail) and any(_ENUM.search(program) for _, program in _programs(files)):
        return "the Enum has no such name: write it as it stands there, capital and small letters count"
    found = _UNSET.match(detail)
    if found is None:
        return ""
    owner, name = found["owner"], found["name"]
    seen = _Classes(name)
    for path, program in _programs(files):
        seen.read(path, program)
    if owner in seen.sets:
        return _late(seen.sets[owner][0], name, owner)
    base = next((base for base in re.findall(r"\w+", seen.bases.get(owner, "")) if base in seen.sets), None)
    if base is None:
        return ""
    place, is_at_once = f"{seen.sets[base][0]}, in {base},", seen.sets[base][1]
    if owner in seen.have_init and is_at_once:
        return f'{place} sets "{name}": call super().__init__() at the beginning of __init__ of {owner}'
    return _late(place, name, owner if owner in seen.have_init else base)


class _Classes:
    """What the classes of a team have to do with an attribute.

    Attributes:
        bases: by class, what it is made from, as it is written.
        have_init: classes with an ``__init__`` of their own.
        sets: by class, the first line that sets the attribute, and whether that is in ``__init__``.
    """

    def __init__(self, attribute: str) -> None:
        self.bases: dict[str, str] = {}
        self.have_init: set[str] = set()
        self.sets: dict[str, tuple[str, bool]] = {}
        self._sets = re.compile(rf"[^#\n]{{0,200}}(?<![\w.])self\.{attribute}[ \t]{{0,20}}(?::[^=\n]{{1,100}})?=(?!=)")

    def read(self, path: PurePosixPath, program: str) -> None:
        """Look at the lines of a program."""
        inside, method = "", ""
        for number, line in enumerate(program.split("\n"), start=1):
            if (begun := _CLASS.match(line)) is not None:
                inside, method = begun[1], ""
                self.bases.setdefault(inside, begun[2] or "")
            elif (begun := _METHOD.match(line)) is not None:
                inside, method = inside if line[0] in " \t" else "", begun[1]
                if method == "__init__":
                    self.have_init.add(inside)
            if inside and self._sets.match(line) is not None:
                self.sets.setdefault(inside, (f"line {number} of {shown(path)}", method == "__init__"))


def _late(place: str, name: str, owner: str) -> str:
    return (
        f'{place} sets "{name}", and the program had not come there yet: give it a first value at the beginning of '
        f"__init__ of {owner}"
    )


def _programs(files: Mapping[PurePosixPath, bytes]) -> Iterator[tuple[PurePosixPath, str]]:
    for path, content in files.items():
        if path.suffix == ".py" and len(content) <= _MOST_BYTES:
            yield path, text_of(content)
