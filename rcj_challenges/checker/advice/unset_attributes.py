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
    sets = re.compile(rf"[^#\n]{{0,200}}(?<![\w.])self\.{name}[ \t]{{0,20}}(?::[^=\n]{{1,100}})?=(?!=)")
    classes: dict[str, str] = {}  # what each is made from
    places: dict[str, str] = {}  # by class, the first line that sets it
    for path, program in _programs(files):
        inside = ""
        for number, line in enumerate(program.split("\n"), start=1):
            if (begun := _CLASS.match(line)) is not None:
                inside = begun[1]
                classes.setdefault(inside, begun[2] or "")
            elif sets.match(line) is not None:
                places.setdefault(inside, f"line {number} of {shown(path)}")
    if owner in places:
        return (
            f'{places[owner]} sets "{name}", and the program had not come there yet: give it a first value at the '
            f"beginning of __init__ of {owner}"
        )
    base = next((base for base in re.findall(r"\w+", classes.get(owner, "")) if base in places), None)
    if base is None:
        return ""
    return f'{places[base]}, in {base}, sets "{name}": call super().__init__() at the beginning of __init__ of {owner}'


def _programs(files: Mapping[PurePosixPath, bytes]) -> Iterator[tuple[PurePosixPath, str]]:
    for path, content in files.items():
        if path.suffix == ".py" and len(content) <= _MOST_BYTES:
            yield path, text_of(content)
