"""Lint of rules against each other: two that move one thing on one edge, exclusive groups whose rules never meet."""

from __future__ import annotations

from collections.abc import Hashable, Iterator
from itertools import combinations, product

from rcj_challenges.scenario.errors import listing
from rcj_challenges.scenario.lint_suspect import Subject, Suspect, lives_in
from rcj_challenges.scenario.models.actions import Place, Remove, SetPhase
from rcj_challenges.scenario.models.conditions import Condition, CounterIs, Drawn
from rcj_challenges.scenario.models.scenario import Rule
from rcj_challenges.scenario.models.state import DrawValue
from rcj_challenges.scenario.models.triggers import Crosses, PhaseEntered, Trigger

_NAMES = ("entity", "zone", "gate", "other", "robot")


def check_edges(subject: Subject) -> Iterator[Suspect]:
    """Rules that fire at one moment and put one thing to two places: the one that fires last wins."""
    by_edge: dict[Hashable, list[str]] = {}
    rules = subject.scenario.rules
    order = {name: (rule.priority, number) for number, (name, rule) in enumerate(rules.items())}
    moves = {name: _moved(rule, subject) for name, rule in subject.standing()}
    for name, moved in moves.items():
        if not moved:
            continue
        for trigger in rules[name].triggers:
            for edge in _edges(trigger, rules[name], subject):
                by_edge.setdefault(edge, []).append(name)
    reported: set[tuple[str, str]] = set()
    for edge, names in by_edge.items():
        for pair in combinations(sorted(set(names), key=order.__getitem__), 2):
            first, second = pair
            both = moves[first] & moves[second]
            if pair not in reported and both and _can_both_fire(rules[first], rules[second], subject):
                reported.add(pair)
                yield Suspect(
                    "two_rules_move_one_thing",
                    ("rules", second),
                    f"it moves {listing(sorted(both))} on the same edge ({_word(edge)}) as rule '{first}'; of two "
                    "placements in one tick the later one wins",
                    "give both the same exclusive:, or conditions of which only one can hold",
                    at_key=True,
                )


def check_exclusive_groups(subject: Subject) -> Iterator[Suspect]:
    """Rules of one exclusive group that never exclude each other, since it counts per ``for_each`` entity."""
    groups: dict[str, list[str]] = {}
    for name, rule in subject.standing():
        if rule.exclusive is not None:
            groups.setdefault(rule.exclusive, []).append(name)
    for names in groups.values():
        pair = _strangers(names, subject)
        if pair is not None:
            first, second = pair
            yield Suspect(
                "exclusive_never_meets",
                ("rules", second, "exclusive"),
                f"exclusive counts per entity: this rule {_for_whom(second, subject)}, rule '{first}' of the same "
                f"group {_for_whom(first, subject)}, and neither ever stops the other",
                "give both the same for_each, or neither, or conditions of which only one can hold",
            )


def _strangers(names: list[str], subject: Subject) -> tuple[str, str] | None:
    """Return two rules of a group that never meet: one with ``for_each`` and one without, or one that meets nobody."""
    owners = {name: _owners(subject.scenario.rules[name], subject) for name in names}
    for first, second in combinations(names, 2):
        if (owners[first] is None) != (owners[second] is None):
            return first, second
    for name in reversed(names):
        others = [other for other in names if other != name]
        if others and all(not _meet(owners[name], owners[other]) for other in others):
            first, second = sorted((others[0], name), key=names.index)
            return first, second
    return None


def _owners(rule: Rule, subject: Subject) -> frozenset[str] | None:
    return None if rule.for_each is None else subject.members("each", rule)


def _meet(one: frozenset[str] | None, other: frozenset[str] | None) -> bool:
    return one is None or other is None or bool(one & other)


def _for_whom(name: str, subject: Subject) -> str:
    for_each = subject.scenario.rules[name].for_each
    return "has no for_each" if for_each is None else f"is for each of '{for_each}'"


def _word(edge: Hashable) -> str:
    return str(edge[0]) if isinstance(edge, tuple) else ""


def _moved(rule: Rule, subject: Subject) -> frozenset[str]:
    """Return the entities that a rule may put elsewhere or take off."""
    moved: set[str] = set()
    for action in rule.actions:
        if isinstance(action, Place | Remove) and action.entity is not None:
            moved |= subject.members(action.entity, rule)
        if isinstance(action, Place) and action.layout is not None:
            for layout in _layouts(action.layout, subject):
                for placing in subject.scenario.placements.get(layout, ()):
                    moved |= subject.members(placing.entity, rule)
    return frozenset(moved)


def _layouts(layout: str | DrawValue, subject: Subject) -> tuple[str, ...]:
    if isinstance(layout, str):
        return (layout,)
    draw = subject.scenario.draws.get(layout.draw)
    return tuple(str(value) for value in draw.values) if draw is not None else ()


def _edges(trigger: Trigger, rule: Rule, subject: Subject) -> Iterator[Hashable]:
    """Yield the single edges that a trigger waits for, so that equal ones are equal."""
    data = {key: value for key, value in trigger if key != "trigger"}
    axes = [[(key, name) for name in sorted(subject.members(data.pop(key), rule))] for key in _NAMES if key in data]
    if isinstance(trigger, Crosses) and data.pop("direction"):
        ways = ("forward", "backward") if trigger.direction == "either" else (trigger.direction,)
        axes.append([("direction", way) for way in ways])
    if isinstance(trigger, PhaseEntered):
        came_from = data.pop("from_")
        axes.append(
            [
                ("from", left)
                for left, entered in sorted(subject.transitions)
                if entered == trigger.phase and came_from in (None, left)
            ]
        )
    rest = tuple((key, repr(value)) for key, value in sorted(data.items()))
    yield from ((trigger.trigger, rest, *combination) for combination in product(*axes))


def _can_both_fire(first: Rule, second: Rule, subject: Subject) -> bool:
    if not any(lives_in(first, phase) and lives_in(second, phase) for phase in subject.reached):
        return False
    if first.exclusive is not None and first.exclusive == second.exclusive:
        # Exclusive groups count per `for_each` entity.
        return (first.for_each is None) != (second.for_each is None)
    if any(isinstance(action, SetPhase) and not lives_in(second, action.phase) for action in first.actions):
        return False  # the second is suppressed by the phase that the first one enters
    return not any(_exclude(one, other) for one, other in product(first.conditions, second.conditions))


def _exclude(one: Condition, other: Condition) -> bool:
    """Return whether two conditions can never hold together."""
    if type(one) is type(other) and one == other.model_copy(update={"negate": not other.negate}):
        return True
    if one.negate or other.negate:
        return False
    if isinstance(one, Drawn) and isinstance(other, Drawn):
        return one.draw == other.draw and one.equals != other.equals
    if isinstance(one, CounterIs) and isinstance(other, CounterIs):
        (low, high), (lower, higher) = _range(one), _range(other)
        return (one.counter, one.entity) == (other.counter, other.entity) and (high < lower or higher < low)
    return False


def _range(condition: CounterIs) -> tuple[float, float]:
    """Return between which numbers a counter must be, as far as they stand in the file."""
    low, high = condition.at_least, condition.at_most
    if isinstance(condition.equals, int | float):
        return condition.equals, condition.equals
    return (
        low if isinstance(low, int | float) else float("-inf"),
        high if isinstance(high, int | float) else float("inf"),
    )
