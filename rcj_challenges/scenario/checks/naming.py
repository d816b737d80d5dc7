"""Names among themselves: one namespace for all that is on the field, reserved words, groups."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

from rcj_challenges.core.colours import CSS_COLOURS, hex_colour
from rcj_challenges.core.diagnostics import Diagnostic, issue
from rcj_challenges.core.files import is_device_of_windows
from rcj_challenges.scenario.codes import GROUP_IN_ITSELF, MIXED_GROUP, NAME_TAKEN, UNKNOWN_NAME, WRONG_VALUE
from rcj_challenges.scenario.errors import choice_of, did_you_mean
from rcj_challenges.scenario.models.scenario import MAX_MEMBERS
from rcj_challenges.scenario.roster import ALWAYS, BOUND, Roster, texts
from rcj_challenges.scenario.tree import Entries, Items, Mark, Path, mark_of, node_at

_SECTIONS = ("robots", "balls", "obstacles", "zones", "gates", "spots", "groups", "roles")
"""What a group may gather, and groups: wherever one of them is named, another may be."""
_RESERVED = frozenset({*ALWAYS, *BOUND})
_FAMILIES = dict.fromkeys(("robot", "ball", "obstacle", "fixed obstacle", "walls"), "robot, ball or obstacle")
"""Kinds that may share a group; the others keep to themselves."""


def check_naming(root: Entries, roster: Roster, removed: Mapping[Path, Mark]) -> Iterator[Diagnostic]:
    """Yield what is wrong with the names that a scenario defines."""
    yield from _namespace(root, roster)
    yield from _colours(roster, root)
    for name in set(roster.names("roles")) & set(roster.names("draws")):
        yield issue(NAME_TAKEN, ("roles", name), f"'{name}' is a draw already", "choose another name", at_key=True)
    if "any" in roster.names("phases"):
        yield issue(NAME_TAKEN, ("phases", "any"), "'any' means all phases", "choose another name", at_key=True)
    yield from _groups(root, roster, removed)


def _namespace(root: Entries, roster: Roster) -> Iterator[Diagnostic]:
    seen: dict[str, Path] = {}
    for section in _SECTIONS:
        for name in roster.names(section):
            path = (section, name)
            first = seen.setdefault(name.casefold(), path)
            message = ""
            if name in _RESERVED:
                message = f"'{name}' is reserved"
            elif first is not path:
                line = mark_of(root, first, at_key=True).line
                how = "is" if first[1] == name else f"differs only in case from '{first[1]}',"
                message = f"'{name}' {how} a name in {first[0]} already{f' (line {line})' if line else ''}"
            elif section == "robots" and is_device_of_windows(name):  # each robot has a log of its name
                message = f"'{name}' is a device on Windows, where no log can have that name"
            if message:
                yield issue(NAME_TAKEN, path, message, "choose another name", at_key=True)


def _colours(roster: Roster, root: Entries) -> Iterator[Diagnostic]:
    taken = {name.casefold() for section in _SECTIONS for name in roster.names(section)} | _RESERVED
    for robot in roster.names("robots"):
        path = ("robots", robot, "colour")
        for colour in texts(node_at(root, path)):
            if colour.casefold() in taken:
                message = f"colour '{colour}' is a name already, and a colour is a group of its robots"
                yield issue(NAME_TAKEN, path, message, "choose another colour")
            elif hex_colour(colour) is None:
                help_ = did_you_mean(colour, CSS_COLOURS) or "write a CSS colour name"
                yield issue(WRONG_VALUE, path, f"'{colour[:64]}' is not a colour", help_)


def _groups(root: Entries, roster: Roster, removed: Mapping[Path, Mark]) -> Iterator[Diagnostic]:
    known = {**roster.kinds, **roster.groups}
    inside = _groups_inside(root, roster)
    are_all_known = all(isinstance(root.entries.get(section, root), Entries) for section in _SECTIONS)
    for group in roster.names("groups"):
        members = node_at(root, ("groups", group))
        families: dict[str, str] = {}
        for index, item in enumerate(members.items[:MAX_MEMBERS] if isinstance(members, Items) else ()):
            path = ("groups", group, index)
            for name in texts(item):
                if name not in known:
                    help_ = removal_help(name, _SECTIONS, removed) or choice_of(name, known)
                    if are_all_known:
                        yield issue(UNKNOWN_NAME, path, f"unknown name '{name[:64]}'", help_)
                elif name == group or group in inside.get(name, ()):
                    yield issue(
                        GROUP_IN_ITSELF, path, f"'{name}' leads back to '{group}': a group cannot contain itself"
                    )
                else:
                    kinds = (roster.kinds[one] for one in roster.expand(name) if one in roster.kinds)
                    for family in sorted({_FAMILIES.get(kind, kind) for kind in kinds} - families.keys()):
                        families[family] = name
                        if len(families) == 2:
                            (one, first), (other, second) = families.items()
                            message = f"a group holds one kind of thing: '{first}' is a {one}, '{second}' a {other}"
                            yield issue(MIXED_GROUP, path, message, "make a group for each kind")


def _groups_inside(root: Entries, roster: Roster) -> dict[str, set[str]]:
    """Return by group all groups to which its members lead."""
    groups = set(roster.names("groups"))
    direct = {group: groups & set(texts(node_at(root, ("groups", group)))[:MAX_MEMBERS]) for group in groups}
    inside: dict[str, set[str]] = {}
    for group in groups:
        found: set[str] = set()
        left = [group]
        while left:
            new = direct[left.pop()] - found
            found |= new
            left += new
        inside[group] = found
    return inside


def removal_help(name: str, sections: Iterable[str], removed: Mapping[Path, Mark]) -> str:
    """Return a help text about a name that was removed from a base; empty if it was not removed."""
    at = next((removed[section, name] for section in sections if (section, name) in removed), None)
    if at is None:
        return ""
    where = f"{at.file}:{at.line}" if at.line else at.file
    return f"'{name}' was removed in {where}; name another one here, or remove this too ('{name}: null' if it is a key)"
