"""Lint of rules against each other: two that move one thing on one edge, exclusive groups whose rules never meet."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations, product
from typing import Any, NamedTuple

from rcj_challenges.scenario.errors import listing, nearest
from rcj_challenges.scenario.followed import heard
from rcj_challenges.scenario.lint.logic import Way, exclude, ways_to_hold, with_each
from rcj_challenges.scenario.lint.suspect import Subject, Suspect, lives_in
from rcj_challenges.scenario.models.actions import SetPhase
from rcj_challenges.scenario.models.conditions import InZone
from rcj_challenges.scenario.models.scenario import Rule
from rcj_challenges.scenario.models.triggers import Crosses, PhaseEntered, SequenceBroken, SequenceCompleted, Trigger
from rcj_challenges.scenario.other import for_other, has_other, names_other, others_of
from rcj_challenges.scenario.tree import file_of

_NAMES = ("entity", "zone", "gate", "other", "robot")
_WHOSE = ("entity", "zone", "gate")
"""What of a trigger may be the one for whom a rule is."""
_WHERE = ("enters", "leaves")
"""Edges that say where their entity is."""

_Edge = tuple[Any, ...]
"""A trigger's word, what else it says, and then pairs of what is named and its name."""


class _Mover(NamedTuple):
    """A rule that moves something on an edge.

    Attributes:
        rule: the rule, with the one touched for ``other``.
        each: for whom it fires, if the edge tells.
    """

    rule: Rule
    each: str | None = None


def check_edges(subject: Subject) -> Iterator[Suspect]:
    """Rules that fire at one moment and put one thing to two places: the one that fires last wins."""
    rules = subject.scenario.rules
    order = {name: (rule.priority, number) for number, (name, rule) in enumerate(rules.items())}
    reported: set[tuple[str, str]] = set()
    for edge, found in _movers(subject).items():
        for first, second in combinations(sorted(found, key=order.__getitem__), 2):
            one, other = found[first], found[second]
            both = _moved(one, subject) & _moved(other, subject)
            if not both or _takes_off_a_part(one, other, both, subject):
                continue
            if (first, second) not in reported and _can_both_fire(one, other, edge, subject):
                reported.add((first, second))
                yield Suspect(
                    "two_rules_move_one_thing",
                    ("rules", second),
                    f"it moves {listing(sorted(both))} on the same edge ({edge[0]}) as rule '{first}'; of two "
                    "placements in one tick the later one wins",
                    _how_to_part(rules[first], rules[second], subject),
                    at_key=True,
                )


def _movers(subject: Subject) -> dict[_Edge, dict[str, _Mover]]:
    """Return the rules that move something, by the edges on which they do."""
    found: dict[_Edge, dict[str, _Mover]] = {}
    for name, rule in subject.standing():
        if not _moved(_Mover(rule), subject):
            continue
        for trigger in rule.triggers:
            for edge in _edges(trigger, rule, subject):
                named = dict(edge[2:])
                if "other" in named and named["other"] == named["entity"]:
                    continue  # nothing touches itself
                each = next((named[key] for key in _WHOSE if getattr(trigger, key, None) == "each"), None)
                one = for_other(rule, named["other"]) if has_other(rule) else rule
                found.setdefault(edge, {}).setdefault(name, _Mover(one, each))
    return found


def _how_to_part(first: Rule, second: Rule, subject: Subject) -> str:
    if _share_exclusive(first, second, subject):
        return "give both the same exclusive:, or conditions of which only one can hold"
    if first.for_each is not None is not second.for_each:
        return "give them conditions of which only one can hold; exclusive: counts per entity, and theirs differ"
    return (
        "give them conditions of which only one can hold, or a for_each to both (one entity will do), since exclusive: "
        "counts per entity, and then the same exclusive:"
    )


def check_exclusive_groups(subject: Subject) -> Iterator[Suspect]:
    """Rules of one exclusive group that never exclude each other, since it counts per ``for_each`` entity."""
    groups: dict[str, list[str]] = {}
    for name, rule in subject.standing():
        if rule.exclusive is not None:
            groups.setdefault(rule.exclusive, []).append(name)
    for group, names in groups.items():
        if len(names) == 1 and _stops_nothing(names[0], subject):
            for_each = subject.scenario.rules[names[0]].for_each
            yield Suspect(
                "exclusive_never_meets",
                ("rules", names[0], "exclusive"),
                f"no other rule is in the group '{group}', and of one rule for each of '{for_each}' it stops none: "
                f"exclusive counts per entity{nearest(group, groups.keys() - {group})}",
                "to let only one of them count in a tick leave for_each out and name the group in the trigger; else "
                "give another rule the same exclusive, or leave it out",
            )
        elif (
            len(names) == 1
            and _is_alone_for_nothing(names[0], subject)
            and (meant := nearest(group, groups.keys() - {group}, _NEARLY))
        ):
            yield Suspect(
                "exclusive_never_meets",
                ("rules", names[0], "exclusive"),
                f"no other rule is in the group '{group}', so that nothing is stopped by it{meant}",
                "correct its name, give another rule the same exclusive, or leave it out",
            )
        pair = _strangers(names, subject)
        if pair is not None and not all(_meets_itself(subject.scenario.rules[name], subject) for name in pair):
            first, second = pair
            yield Suspect(
                "exclusive_never_meets",
                ("rules", second, "exclusive"),
                f"exclusive counts per entity: this rule {_for_whom(second, subject)}, rule '{first}' of the same "
                f"group {_for_whom(first, subject)}, and neither ever stops the other",
                _meant_by_repeating(first, second, subject)
                or "give both a for_each (one entity will do), or neither, or conditions of which only one can hold",
            )


def _meant_by_repeating(first: str, second: str, subject: Subject) -> str:
    """Return what to do where one repeated rule over members should count for one of them only; else nothing."""
    came_from = [subject.repeated[name].rule for name in (first, second) if name in subject.repeated]
    if subject.scenario.rules[first].for_each is None or len(came_from) < 2 or len(set(came_from)) > 1:
        return ""
    return (
        "leave it out; for only one of several to count in a tick each makes itself the value of a draw, "
        "{action: draw, draw: …, as: each}, which the last one keeps, and a rule that hears an event asks who that is"
    )


_NEARLY = 0.8
"""How like another group's name one must be to be taken for it, misspelt."""


def _is_alone_for_nothing(name: str, subject: Subject) -> bool:
    """Return whether a rule of the author's own is alone in its group, and is not stopped at a second touch either."""
    rule = subject.scenario.rules[name]
    own = file_of(subject.tree, "rules", name) == subject.tree.mark.file
    return own and not names_other(rule, subject.scenario)


def _stops_nothing(name: str, subject: Subject) -> bool:
    """Return whether a rule that is alone in its group, and for each of several, can never be stopped by itself."""
    rule = subject.scenario.rules[name]
    members = subject.members("each", rule) if rule.for_each is not None else frozenset()
    own = file_of(subject.tree, "rules", name) == subject.tree.mark.file
    return own and len(members) > 1 and not _meets_itself(rule, subject)


def _meets_itself(rule: Rule, subject: Subject) -> bool:
    """Return whether a rule for each of a group can stop itself: of two that it touches at once the second."""
    if rule.for_each is None or not names_other(rule, subject.scenario):
        return False
    return any(len(others_of(rule, one, subject.roster)) > 1 for one in subject.members("each", rule))


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


def _moved(mover: _Mover, subject: Subject) -> frozenset[str]:
    """Return the entities that a rule may put elsewhere or take off."""
    return subject.moved(_for_one(mover))


def _for_one(mover: _Mover) -> Rule:
    """Return the rule of a mover; where it is known for whom it fires, `each` is that one and no other."""
    return mover.rule if mover.each is None else mover.rule.model_copy(update={"for_each": mover.each})


def _takes_off_a_part(first: _Mover, second: _Mover, both: frozenset[str], subject: Subject) -> bool:
    """Return whether the first rule puts several and the second, which fires later, takes some of them off.

    Nobody writes that by mistake: it does what it says, in the order of the rules, and of what the first puts the rest
    stays. Where nothing is left of it, the first rule puts in vain.
    """
    earlier, later = _for_one(first), _for_one(second)
    only_put = both & subject.put(earlier) - subject.taken_off(earlier)
    only_taken_off = both & subject.taken_off(later) - subject.put(later)
    return only_put == both == only_taken_off and both < subject.put(earlier)


def _edges(trigger: Trigger, rule: Rule, subject: Subject) -> Iterator[_Edge]:
    """Yield the single edges that a trigger waits for, so that equal ones are equal."""
    data = {key: value for key, value in trigger if key != "trigger"}
    if isinstance(trigger, SequenceCompleted | SequenceBroken):
        data["entity"] = heard(trigger, subject.scenario)
    axes = [[(key, name) for name in sorted(subject.members(data.pop(key), rule))] for key in _NAMES if data.get(key)]
    if isinstance(trigger, Crosses) and data.pop("direction"):
        ways = ("forward", "backward") if trigger.direction == "either" else (trigger.direction,)
        axes.append([("direction", way) for way in ways])
    data.pop("every_s", None)  # that it is heard again makes no other edge of its beginning
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


def _can_both_fire(one: _Mover, other: _Mover, edge: _Edge, subject: Subject) -> bool:
    first, second = one.rule, other.rule
    if not any(lives_in(first, phase) and lives_in(second, phase) for phase in subject.reached):
        return False
    if first.exclusive is not None and first.exclusive == second.exclusive:
        return not _share_exclusive(first, second, subject)
    if any(isinstance(action, SetPhase) and not lives_in(second, action.phase) for action in first.actions):
        return False  # the second is suppressed by the phase that the first one enters
    ways, other_ways = _ways(one, edge), _ways(other, edge)
    if ways is None or other_ways is None:
        return True
    return any(_can_hold(way, other_way, (first, second), subject) for way, other_way in product(ways, other_ways))


def _share_exclusive(first: Rule, second: Rule, subject: Subject) -> bool:
    """Return whether one exclusive group for both would help: it counts per ``for_each`` entity."""
    if (first.for_each is None) != (second.for_each is None):
        return False
    return _meet(_owners(first, subject), _owners(second, subject))


def _ways(mover: _Mover, edge: _Edge) -> list[Way] | None:
    """Return the ways in which a rule's conditions can hold on an edge, with what the edge itself says."""
    ways = ways_to_hold(mover.rule.conditions)
    if ways is None:
        return None
    told: Way = ()
    if edge[0] in _WHERE:
        named = dict(edge[2:])
        told = (InZone(condition="in_zone", entity=named["entity"], zone=named["zone"], negate=edge[0] == "leaves"),)
    return [(*told, *(with_each(condition, mover.each) for condition in way)) for way in ways]


def _can_hold(way: Way, other: Way, rules: tuple[Rule, Rule], subject: Subject) -> bool:
    both = [*((condition, rules[0]) for condition in way), *((condition, rules[1]) for condition in other)]
    return not any(exclude(a, b, (rule_a, rule_b), subject) for (a, rule_a), (b, rule_b) in combinations(both, 2))
