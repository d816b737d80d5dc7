"""Lint of what a scenario changes of its base, and of what no longer fits: places, goals, sentences, kits, robots."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from rcj_challenges.scenario.errors import listing
from rcj_challenges.scenario.lint.suspect import Subject, Suspect, on_field
from rcj_challenges.scenario.models.actions import Emit
from rcj_challenges.scenario.models.field import Goal
from rcj_challenges.scenario.models.places import RectZone
from rcj_challenges.scenario.models.scenario import Rule
from rcj_challenges.scenario.models.triggers import NoProgress, StaysIn
from rcj_challenges.scenario.tree import Entries, Items, Leaf, Mark, Node, Path, child, mark_of, node_at

_MOST_NAMES = 12
"""More names than this in one sentence help nobody."""

_AXES = {"width_m": 0, "length_m": 1}
"""Sizes of the field, and the axis along which each runs."""
_ON_AXIS = (("x_min_m", "x_max_m", "x_m"), ("y_min_m", "y_max_m", "y_m"))
"""Keys of zones and spots whose number lies on an axis."""
_POINTS = ("centre_m", "through_m", "from_m", "to_m")
"""Keys of zones and gates that hold a point."""
_ENTITIES = ("robots", "balls", "obstacles")

_BESIDE_OPENING_M = 0.01
"""How far a zone's side may be from the goal's: less than a ball's radius, so that it decides nothing."""
BEFORE_END_M = 0.05
"""How far before or behind the end of the field a goal's zone may begin; the preset's begins 5 mm before it."""
_ROUNDING_M = 1e-9


# --- the own file -----------------------------------------------------------------------------------------------------


def _is_own(mark: Mark, subject: Subject) -> bool:
    return mark.file == subject.tree.mark.file


def _is_inherited(mark: Mark, subject: Subject) -> bool:
    """Return whether something stands in a base; what the command line sets stands in no file at all."""
    return not _is_own(mark, subject) and not mark.file.startswith("--set")


def _where_set(path: Path, subject: Subject) -> Path:
    """Return where the own file sets a single value: there, or in ``params``; an empty path if it does not."""
    node = node_at(subject.tree, path)
    if node is None:
        return ()
    return path if _is_own(node.mark, subject) else _own_param(node, subject)


def _own_param(node: Node, subject: Subject) -> Path:
    """Return the param for which a value stands and which the own file sets, or an empty path."""
    params = subject.tree.entries.get("params")
    if isinstance(node, Leaf) and isinstance(params, Entries):
        mark = params.key_marks.get(node.param)
        if mark is not None and _is_own(mark, subject):
            return ("params", node.param)
    return ()


def _some(names: Iterable[str]) -> str:
    known = list(names)
    more = f" and {len(known) - _MOST_NAMES} more" if len(known) > _MOST_NAMES else ""
    return ", ".join(known[:_MOST_NAMES]) + more


# --- a field of another size ------------------------------------------------------------------------------------------


def check_field_size(subject: Subject) -> Iterator[Suspect]:
    """A field of another size whose inherited zones, gates and spots stay where they were."""
    changed = [(key, path) for key in _AXES if (path := _where_set(("field", key), subject))]
    axes = [_AXES[key] for key, _ in changed]
    left: list[tuple[str, str]] = []
    for section, name, node in _used_places(subject):
        behind = [axis for axis in axes if _stays_behind(node, axis, subject)]
        # Of what the author has moved along one axis it is the other one that was forgotten, or is meant to stay.
        moved = any(_is_own_number(number, subject) for axis in _AXES.values() for number in _numbers(node, axis))
        if behind:
            left.append((section, f"{name} in {' and '.join('xy'[axis] for axis in behind)}" if moved else name))
    if left:
        sections = " and ".join(dict.fromkeys(section for section, _ in left))
        yield Suspect(
            "zones_of_another_field",
            changed[0][1],
            f"{' and '.join(key for key, _ in changed)} changed, and what is inherited stays where it was: "
            f"{_some(name for _, name in left)}",
            f"give them new numbers in {sections} too; those that are to stay, write again as they are",
            at_key=True,
        )


def _used_places(subject: Subject) -> Iterator[tuple[str, str, Node]]:
    """Yield zones, gates and spots that something names; the zones of goals have a check of their own."""
    used = _used_names(subject)
    for section in ("zones", "gates", "spots"):
        entries = subject.tree.entries.get(section)
        for name, node in entries.entries.items() if isinstance(entries, Entries) else ():
            is_goal = section == "zones" and _rect_of_goal(name, subject) is not None
            if name in used and not is_goal and child(node, "anchor") is None:
                yield section, name, node


def _used_names(subject: Subject) -> frozenset[str]:
    """Return what rules, sequences and layouts name on the field, the members of groups included."""
    draws = subject.scenario.draws
    named = {use.name for use in subject.uses if on_field(use)}
    # A draw may decide among spots.
    named |= {str(value) for name in named & draws.keys() for value in draws[name].values}
    return frozenset(subject.roster.expand(tuple(named)))


def _stays_behind(node: Node, axis: int, subject: Subject) -> bool:
    """Return whether a place has a number on an axis, and the own file none of them; the middle stays the middle."""
    numbers = list(_numbers(node, axis))
    return any(number.value for number in numbers) and not any(_is_own_number(number, subject) for number in numbers)


def _is_own_number(number: Leaf, subject: Subject) -> bool:
    return not _is_inherited(number.mark, subject) or bool(_own_param(number, subject))


def _numbers(node: Node, axis: int) -> Iterator[Leaf]:
    """Yield the numbers of a zone, gate or spot that lie on an axis."""
    found = [child(node, key) for key in _ON_AXIS[axis]]
    normal = child(child(node, "normal"), axis)
    if not isinstance(normal, Leaf) or normal.value:  # a half plane along the axis has no end on it
        found += [child(child(node, key), axis) for key in _POINTS]
    corners = child(node, "points_m")
    found += [child(point, axis) for point in corners.items] if isinstance(corners, Items) else []
    return (number for number in found if isinstance(number, Leaf))


# --- goals ------------------------------------------------------------------------------------------------------------


def check_goals(subject: Subject) -> Iterator[Suspect]:
    """Goals whose hole in the wall is not where their zone is; a zone that nobody names decides nothing."""
    used = _used_names(subject)
    for name, goal in subject.scenario.field.goals.items():
        zone = _rect_of_goal(name, subject)
        path = _goal_changed_at(name, subject)
        if zone is None or name not in used or not path:
            continue
        reasons = [*_beside_opening(goal, zone), *_before_end(goal, zone, subject.scenario.field.length_m)]
        if reasons:
            yield Suspect(
                "goal_and_zone_differ",
                path,
                f"the hole of goal '{name}' and zone '{name}' are not at the same place: {'; '.join(reasons)}",
                f"give field.goals.{name} and zones.{name} the same place; the zone is what counts",
                at_key=True,
            )


def _rect_of_goal(name: str, subject: Subject) -> RectZone | None:
    zone = subject.scenario.zones.get(name) if name in subject.scenario.field.goals else None
    return zone if isinstance(zone, RectZone) and not zone.inverted else None


def _goal_changed_at(name: str, subject: Subject) -> Path:
    """Return what of the own file has to do with where a goal or its zone is, or an empty path."""
    numbers: tuple[tuple[Path, tuple[str, ...]], ...] = (
        (("field", "goals", name), ("end", "width_m")),
        (("zones", name), ("shape", *_ON_AXIS[0], *_ON_AXIS[1])),
    )
    for entry, keys in numbers:
        for key in keys:
            path = _where_set((*entry, key), subject)
            if path:
                return entry if path[0] == entry[0] else path
    return _where_set(("field", "length_m"), subject)


def _beside_opening(goal: Goal, zone: RectZone) -> Iterator[str]:
    # A side that is left out is open, and the wall beside the hole closes it.
    sides = (("from", zone.x_min_m, -goal.width_m / 2), ("to", zone.x_max_m, goal.width_m / 2))
    for word, x_m, edge_m in sides:
        if x_m is not None and abs(x_m - edge_m) > _BESIDE_OPENING_M + _ROUNDING_M:
            yield f"the zone goes {word} x {x_m:g}, the hole {word} {edge_m:g}"


def _before_end(goal: Goal, zone: RectZone, length_m: float) -> Iterator[str]:
    y_m, end_m = (zone.y_min_m, length_m / 2) if goal.end == "positive_y" else (zone.y_max_m, -length_m / 2)
    if y_m is None:
        yield f"the zone has no side towards the field, which ends at y {end_m:g}"
    elif abs(y_m - end_m) > BEFORE_END_M + _ROUNDING_M:
        yield f"the zone begins at y {y_m:g}, the field ends at {end_m:g}"


# --- sentences and kits -----------------------------------------------------------------------------------------------


def check_inherited_sentences(subject: Subject) -> Iterator[Suspect]:
    """Rules that do something else than in the base, and say the same."""
    for name, rule in subject.scenario.rules.items():
        path: Path = ("rules", name)
        says = node_at(subject.tree, (*path, "says"))
        if not rule.says or says is None or not _is_inherited(says.mark, subject):
            continue
        parts = [key for key in ("triggers", "conditions", "actions") if _is_written_here((*path, key), subject)]
        if parts:
            yield Suspect(
                "sentence_of_the_base",
                path,
                f"its {' and '.join(parts)} are written here, and its sentence is inherited ({says.mark.file}:"
                f"{says.mark.line}): what sheet and record say may be untrue now",
                "write its says: anew, even if it stays the same",
                at_key=True,
            )


def check_inherited_texts(subject: Subject) -> Iterator[Suspect]:
    """Things that the own file took away, and of which the events of inherited rules still tell."""
    scenario = subject.scenario
    gone = {
        str(path[1])
        for path, mark in subject.removed.items()
        if len(path) == 2 and path[0] in _ENTITIES and _is_own(mark, subject)
    } - {name for section in _ENTITIES for name in getattr(scenario, section)}
    told: dict[str, list[str]] = {}
    for name, rule in scenario.rules.items() if gone else ():
        for text, mark in _texts_of_events(name, rule, subject):
            if text in gone and _is_inherited(mark, subject):
                told.setdefault(text, []).append(f"{name} ({mark.file}:{mark.line})")
    for entity, rules in told.items():
        section = next(section for section in _ENTITIES if (section, entity) in subject.removed)
        yield Suspect(
            "text_names_what_is_gone",
            (section,),
            f"'{entity}' is gone, and events of inherited rules still tell of it: {_some(rules)}",
            "write the actions of these rules anew, or name in their payload what is there",
            at_key=True,
        )


def _texts_of_events(name: str, rule: Rule, subject: Subject) -> Iterator[tuple[str, Mark]]:
    """Yield the texts that a rule writes into its events, each with its place."""
    for index, action in enumerate(rule.actions):
        for key, value in action.payload.items() if isinstance(action, Emit) else ():
            if isinstance(value, str):
                yield value, mark_of(subject.tree, ("rules", name, "actions", index, "payload", key))


def _is_written_here(path: Path, subject: Subject) -> bool:
    """Return whether the own file writes a list; one that only holds a param which it sets is not written by it."""
    node = node_at(subject.tree, path)
    return node is not None and _is_own(node.mark, subject)


def check_kits(subject: Subject) -> Iterator[Suspect]:
    """Kits that the own file writes, or changes, and no robot has."""
    robots = subject.scenario.robots.values()
    used = dict.fromkeys(robot.kit for robot in robots)
    kits = subject.tree.entries.get("kits")
    for name in subject.scenario.kits:
        if name in used or not isinstance(kits, Entries) or not _is_own(mark_of(kits, (name,), at_key=True), subject):
            continue
        instead = f"change the one that robots have ({listing(used)}), " if used else ""
        yield Suspect(
            "kit_never_used",
            ("kits", name),
            f"no robot has kit '{name}': what is written here changes nothing",
            f"give it to robots by {{kit: {name}}}, {instead}or remove it",
            at_key=True,
        )


# --- robots that nobody drives ----------------------------------------------------------------------------------------


def check_idle_robots(subject: Subject) -> Iterator[Suspect]:
    """Rules that expect a robot to move which cannot."""
    idle = {name for name, robot in subject.scenario.robots.items() if robot.idle}
    inherited: dict[str, list[str]] = {}
    for name, rule in subject.standing() if idle else ():
        found, path = _expected_to_move(name, rule, idle, subject)
        # Of an inherited rule and a robot that is idle here, only the robot stands where the author can mend it.
        if found and not _is_own(mark_of(subject.tree, path), subject):
            for robot in [robot for robot in found if _where_set(("robots", robot, "idle"), subject)]:
                inherited.setdefault(robot, []).append(name)
                found.remove(robot)
        if found:
            itself = f"'{found[0]}' is idle and cannot move by itself"
            themselves = f"{_some(found)} are idle and cannot move by themselves"
            reason = f"{itself if len(found) == 1 else themselves}: this fires again and again"
            yield _idle(path, reason, "name a group without what is idle")
    for robot, rules in inherited.items():
        reason = (
            f"'{robot}' cannot move by itself, and what expects that it moves fires again and again: "
            f"rule{'s' if len(rules) > 1 else ''} {_some(rules)}"
        )
        yield _idle(("robots", robot, "idle"), reason, "give such a rule a group without it")


def _expected_to_move(name: str, rule: Rule, idle: set[str], subject: Subject) -> tuple[list[str], Path]:
    """Return the idle robots from which a rule expects that they move, and where it names them."""
    for index, trigger in enumerate(rule.triggers):
        if not isinstance(trigger, NoProgress | StaysIn):
            continue
        found = subject.members(trigger.entity, rule) & idle
        if found:
            named_by: Path = ("for_each",) if trigger.entity == "each" else ("triggers", index, "entity")
            return [robot for robot in subject.roster.entities if robot in found], ("rules", name, *named_by)
    return [], ()


def _idle(path: Path, reason: str, remedy: str) -> Suspect:
    return Suspect(
        "idle_robot_makes_no_progress",
        path,
        reason,
        remedy,
    )
