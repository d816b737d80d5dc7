"""Names among themselves: one namespace for all that lies on the field, reserved words, groups."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from rcj_challenges.facts.colours import CSS_COLOURS, hex_colour
from rcj_challenges.facts.file_names import is_device_of_windows
from rcj_challenges.scenario.catalogue import ALWAYS, BOUND, EACH, FAMILIES, OTHER, Catalogue, texts
from rcj_challenges.scenario.checks.removal import removal_of
from rcj_challenges.scenario.errors import Problem, listing, nearest
from rcj_challenges.scenario.messages.taken_away import without
from rcj_challenges.scenario.models.scenario import MAX_MEMBERS
from rcj_challenges.scenario.tree import Items, Mark, Path, child, in_names, mark_of, node_at

_SECTIONS = ("robots", "balls", "obstacles", "zones", "gates", "spots", "groups")
"""What a group may gather, and groups: in any of the places where one of them is named, so may be another."""
_MEANINGS = {EACH: "names the current entity of a rule", OTHER: "names what is touched in a rule"}


def check_names(catalogue: Catalogue, removed: Mapping[Path, Mark]) -> list[Problem]:
    """Return what is wrong with the names that a scenario defines.

    Args:
        catalogue: the names.
        removed: where entries of a base were removed, for the message to groups that still name them.
    """
    return [*_namespace(catalogue), *_other_sections(catalogue), *_groups(catalogue, removed)]


def _problem(catalogue: Catalogue, path: Path, message: str, *, at_key: bool = False) -> Problem:
    return mark_of(catalogue.root, path, at_key=at_key).problem(in_names(catalogue.root, path), message)


def _namespace(catalogue: Catalogue) -> Iterator[Problem]:
    seen: dict[str, tuple[str, str, Mark]] = {}
    for section in _SECTIONS:
        for name in catalogue.names(section):
            path = (section, name)
            mark = mark_of(catalogue.root, path, at_key=True)
            if name in (*ALWAYS, *BOUND):
                what = _MEANINGS.get(name, "is a group that always exists")
                yield _problem(catalogue, path, f"'{name}' {what}; choose another name", at_key=True)
            elif name.casefold() in seen:
                known, where, first = seen[name.casefold()]
                line = f" (line {first.line})" if first.line and first.file == mark.file else ""
                if known == name:
                    message = f"'{name}' is a name in {where} already{line}; all on the field share one namespace"
                else:
                    message = f"'{name}' differs from '{known}' in {where}{line} only in upper and lower case"
                    message += "; choose another name"
                yield _problem(catalogue, path, message, at_key=True)
            seen.setdefault(name.casefold(), (name, section, mark))
    for robot in catalogue.names("robots"):
        if is_device_of_windows(robot):  # each robot has a log of its name
            message = f"'{robot}' is a device on Windows, where no log can have that name; choose another name"
            yield _problem(catalogue, ("robots", robot), message, at_key=True)
        colour = catalogue.leaf("robots", robot, "colour")
        if isinstance(colour, str) and (colour in (*ALWAYS, *BOUND) or colour.casefold() in seen):
            where = "reserved" if colour in (*ALWAYS, *BOUND) else f"a name in {seen[colour.casefold()][1]} already"
            message = f"colour '{colour}' is {where}; a colour is a group of its robots"
            yield _problem(catalogue, ("robots", robot, "colour"), message)
        elif isinstance(colour, str) and hex_colour(colour) is None:
            message = f"'{colour[:64]}' is no colour: a CSS colour name{nearest(colour, CSS_COLOURS)}"
            yield _problem(catalogue, ("robots", robot, "colour"), message)


def _other_sections(catalogue: Catalogue) -> Iterator[Problem]:
    for name in catalogue.names("counters"):
        if name in catalogue.names("entrants"):
            message = f"'{name}' is an entrant, whose score is read under this name; choose another"
            yield _problem(catalogue, ("counters", name), message, at_key=True)
    if "any" in catalogue.names("phases"):
        yield _problem(catalogue, ("phases", "any"), "'any' means all phases; choose another name", at_key=True)


def _groups(catalogue: Catalogue, removed: Mapping[Path, Mark]) -> Iterator[Problem]:
    own = () if "groups" in catalogue.broken else catalogue.names("groups")
    known = {**catalogue.kinds, **catalogue.groups}
    for group in own:
        members = node_at(catalogue.root, ("groups", group))
        if not isinstance(members, Items):
            continue
        families: dict[str, str] = {}
        for index, item in enumerate(members.items[:MAX_MEMBERS]):
            for name in texts(item):
                path: Path = ("groups", group, index)
                if name not in known:
                    hint = _instead_of(name, path, item.mark, known, catalogue, removed)
                    if not catalogue.broken.intersection(_SECTIONS):
                        yield _problem(catalogue, path, f"unknown name '{name[:64]}'{hint}")
                    continue
                if _leads_to(catalogue, name, group):
                    yield _problem(catalogue, path, f"a group cannot contain itself: '{name}' leads back to '{group}'")
                    continue
                kinds = {catalogue.kinds[member] for member in catalogue.expand(name) if member in catalogue.kinds}
                for kind in sorted(kinds):
                    family = FAMILIES.get(kind, kind)
                    families.setdefault(family, name)
                if len(families) > 1:
                    (one, first), (other, second) = list(families.items())[:2]
                    message = f"a group holds one kind of thing: '{first}' is {_of(one)}, '{second}' {_of(other)}"
                    yield _problem(catalogue, path, message)
                    families.popitem()


def _instead_of(
    name: str, path: Path, mark: Mark, known: Mapping[str, object], catalogue: Catalogue, removed: Mapping[Path, Mark]
) -> str:
    """Return what to do about a member of a group that does not exist."""
    hint = nearest(name, known) or f"; there are {listing(known)}"
    removal = removal_of(name, _SECTIONS, removed, mark, catalogue.root)
    if removal is None:
        return hint
    if removal.is_by_base:
        return f": {removal.told}{hint}"
    is_of_base = mark.file != mark_of(catalogue.root, ("id",)).file
    return f": {removal.told}{without(name, path)}" + (f", or '{path[1]}: null'" if is_of_base else "")


def _of(family: str) -> str:
    return "a robot, ball or obstacle" if family == "thing" else f"a {family}"


def _leads_to(catalogue: Catalogue, name: str, group: str) -> bool:
    """Return whether following a member leads back to the group."""
    todo, seen = [name], set()
    while todo:
        current = todo.pop()
        if current == group:
            return True
        if current not in seen and child(catalogue.section("groups"), current) is not None:
            seen.add(current)
            todo += catalogue.parts(current)
    return False
