"""References: every name that a scenario uses must exist, and be of the kind that is needed there.

Walks the tree beside the shapes of the models, so that unknown names come in one report with everything else.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import Any, NamedTuple

from rcj_challenges.core.timing import TICK_S
from rcj_challenges.rules.actions.count import Count
from rcj_challenges.rules.actions.draw import DrawAction
from rcj_challenges.rules.actions.place import Place
from rcj_challenges.rules.actions.score import Score
from rcj_challenges.rules.actions.sequence import SequenceAction
from rcj_challenges.rules.actions.set_flag import SetFlag
from rcj_challenges.rules.actions.timer import TimerAction
from rcj_challenges.rules.actions.toggle_flag import ToggleFlag
from rcj_challenges.rules.conditions.drawn import Drawn
from rcj_challenges.rules.conditions.sequence_at import SequenceAt
from rcj_challenges.rules.fields import LONGEST_S
from rcj_challenges.rules.kick import MAX_KICK_MPS, DrawnSpeed
from rcj_challenges.rules.refs import Ref, Reference, SectionRef, refs_of
from rcj_challenges.rules.triggers.touches import Touches
from rcj_challenges.rules.values.counter import CounterValue
from rcj_challenges.rules.values.draw import DrawnDuration, NumberDraw
from rcj_challenges.rules.values.flag import FlagValue
from rcj_challenges.rules.values.highest import HighestOfOthers
from rcj_challenges.rules.values.lowest import LowestOfOthers
from rcj_challenges.rules.values.term import term_of
from rcj_challenges.rules.values.timer import NumberTimer
from rcj_challenges.scenario.checks.removal import of_removed
from rcj_challenges.scenario.errors import MAX_FOUND, choice_of, listing
from rcj_challenges.scenario.messages.wording import format_node, quoted, spelled
from rcj_challenges.scenario.models import places, state
from rcj_challenges.scenario.models.robots import Entrant, Kit
from rcj_challenges.scenario.models.scenario import Expectation, Rule, Scenario
from rcj_challenges.scenario.roster import BOUND, EACH, OTHER, Roster, texts, touched
from rcj_challenges.scenario.shape import Shape, bare, chosen, fields, is_model, step_into
from rcj_challenges.scenario.tree import Entries, Items, Leaf, Mark, Node, Path, child, format_path, node_at
from rcj_challenges.scenario.walk import Issue

_UNKNOWN = {
    EACH: "'each' can only be used in a rule with for_each",
    OTHER: "'other' can only be used in a rule whose triggers are all touches",
}
_ON_FIELD = ("robots", "balls", "obstacles", "zones", "gates", "spots", "groups")
"""Sections whose names stand for something on the field."""
_KEPT = {"counter": "counters", "flag": "flags", "timer": "timers", "sequence": "sequences"}
"""What may be kept once, or for each member of a group, by the key that names it."""
_WRITES = (
    Count,
    SetFlag,
    ToggleFlag,
    TimerAction,
    SequenceAction,
    *map(term_of, (CounterValue, FlagValue, NumberTimer)),
)
"""Words that are about all members if they name none."""


_Wrong = tuple[str, str, str]


class Scope(NamedTuple):
    """What ``each`` and ``other`` may stand for in a rule; None if the name cannot be used there."""

    each: tuple[str, ...] | None = None
    other: tuple[str, ...] | None = None

    def of(self, name: str) -> tuple[str, ...] | None:
        """Return what one of the two names stands for."""
        return self.each if name == EACH else self.other


def check_references(root: Entries, roster: Roster, removed: Mapping[Path, Mark]) -> list[Issue]:
    """Return what is wrong with the names that a scenario uses.

    Args:
        root: the finished tree.
        roster: the names that it defines.
        removed: where entries of a base were removed.
    """
    walker = _Walker(root, roster, removed)
    walker.walk(root, Scenario, (), Scope())
    return walker.issues


class _Walker:
    def __init__(self, root: Entries, roster: Roster, removed: Mapping[Path, Mark]) -> None:
        self.root = root
        self.roster = roster
        self.removed = removed
        self.issues: list[Issue] = []
        self.reported: set[Path] = set()
        kits = (node_at(root, ("robots", robot, "kit")) for robot in roster.names("robots"))
        self.kits_in_use = {name for kit in kits for name in texts(kit)}

    def walk(self, node: Node, shape: Shape, path: Path, scope: Scope) -> None:
        """Check a value and all that is in it."""
        shape = chosen(shape, node) if shape is not None else None
        if shape is None or len(self.issues) >= MAX_FOUND:
            return  # of an unknown form, which is reported as such; or enough is wrong already
        if isinstance(node, Items):
            for index, item in enumerate(node.items):
                if not isinstance(item, Leaf):
                    self.walk(item, step_into(shape, node, index), (*path, index), scope)
        elif isinstance(node, Entries):
            model = bare(shape).kind
            if is_model(model):
                scope = self._model(model, node, path, scope)
            for key, inner in node.entries.items():
                if not isinstance(inner, Leaf):
                    self.walk(inner, step_into(shape, node, key), (*path, key), scope)

    def add(self, code: str, path: Path, message: str, help_: str = "", *, at_key: bool = False) -> None:
        self.issues.append(Issue(code, path, message, help_, at_key))

    def _add_once(self, code: str, path: Path, message: str, user: Path, help_: str = "") -> None:
        """Add what is wrong with a value of a draw, once for all the words that use it."""
        if (*path, message) not in self.reported:
            self.reported.add((*path, message))
            self.add(code, path, f"{message} (needed by {format_path(self.root, user)})", help_)

    # --- one mapping --------------------------------------------------------------------------------------------------

    def _model(self, model: Any, node: Entries, path: Path, scope: Scope) -> Scope:
        if model is Kit and path[-1] not in self.kits_in_use:
            return scope  # a preset's kit may list robots that this scenario has not
        if model is Entrant and self._is_without_robots(node, path):
            return scope
        if model is Rule:
            scope = self._scope_of(node)
        elif model is state.Timer and texts(node.entries.get("per")):
            # What one of several timers lasts may be what the counter of the same member says.
            scope = Scope(self._members(node.entries["per"], Scope()))
        for key, reference, default in refs_of(model):
            if key in node.entries:
                for name, at in _names_in(node.entries[key], (*path, key), reference):
                    wrong = self._wrong(reference, name, at, scope)
                    if wrong is not None:
                        self._report(*wrong, at, at_key=reference.keys)
            elif isinstance(default, str) and self._wrong(reference, default, path, scope) is not None:
                known = self._known(reference)
                message = f"'{key}' defaults to '{default}', which this scenario does not have"
                self.add("unknown-name", path, message, f"set '{key}'; {choice_of('', known, reference.noun)}")
        self._relations(model, node, path, scope)
        return scope

    def _is_without_robots(self, entrant: Entries, path: Path) -> bool:
        """Report once that all robots of an entrant were removed, and return whether it is so."""
        robots = entrant.entries.get("robots")
        names = tuple(robots.entries) if isinstance(robots, Entries) else ()
        if not names or not all(("robots", name) in self.removed for name in names):
            return False
        at = self.removed["robots", names[0]]
        swaps = node_at(self.root, ("match", "swap_sides"))
        also = ", and 'swap_sides: false' under match" if isinstance(swaps, Leaf) and swaps.value is True else ""
        message = f"all robots of '{path[-1]}' were removed in {at.file}{f':{at.line}' if at.line else ''}"
        self.add("entrant-without-robots", path, message, f"write '{path[-1]}: null' under entrants{also}", at_key=True)
        return True

    def _scope_of(self, rule: Entries) -> Scope:
        group = rule.entries.get("for_each")
        scope = Scope(None if group is None else self._members(group, Scope()))
        triggers = rule.entries.get("triggers")
        listed = triggers.items if isinstance(triggers, Items) else []
        if any(texts(child(trigger, "trigger")) != ("touches",) for trigger in listed):
            return scope
        pairs = [[self._members(child(one, key), scope) for key in ("entity", "other")] for one in listed]
        found = dict.fromkeys(name for one, other in pairs for name in other if name in touched(one, other))
        return scope._replace(other=tuple(found))

    def _members(self, names: Node | None, scope: Scope) -> tuple[str, ...]:
        """Return what names stand for: groups expanded, ``each`` and ``other`` replaced."""
        found = ((scope.of(name) or ()) if name in BOUND else self.roster.expand(name) for name in texts(names))
        return tuple(one for members in found for one in members)

    # --- one name -----------------------------------------------------------------------------------------------------

    def _report(self, code: str, message: str, help_: str, path: Path, *, at_key: bool) -> None:
        if code == "mixed-group":  # the group is what is wrong: once for each rule that names it
            if (*path[:2], message) in self.reported:
                return
            self.reported.add((*path[:2], message))
            code = "wrong-kind"
        self.add(code, path, message, help_, at_key=at_key)

    def _wrong(self, reference: Reference, name: str, path: Path, scope: Scope) -> _Wrong | None:  # noqa: PLR0911
        """Return code, message and help about a name that cannot stand here; None if it can."""
        roster, kind = self.roster, self.roster.kinds.get(name)
        if name in reference.words:
            return None
        if isinstance(reference, SectionRef):
            is_known = any(name in roster.names(section) for section in reference.sections)
            return None if is_known else self._unknown(reference, name, path)
        if name in BOUND:
            return self._wrong_bound(reference, name, path, scope)
        if kind is None and name not in roster.groups:
            if not reference.drawn or name not in roster.names("draws"):
                return self._unknown(reference, name, path)
            self._check_drawn(reference, name, path)
        elif kind in (None, "walls") and kind not in reference.kinds:
            return self._wrong_group(reference, name)
        elif kind not in reference.kinds:
            message = f"'{name}' is {_a(str(kind))}; expected {_a(reference.noun)}"
            return "wrong-kind", message, self._instead(reference, str(kind))
        return None

    def _wrong_bound(self, reference: Ref, name: str, path: Path, scope: Scope) -> _Wrong | None:
        members = scope.of(name)
        if name == OTHER and path[2:3] == ("triggers",):
            return "unbound-name", "'other' is what was touched", "a trigger says what may be, by name or group"
        if not reference.each:
            return "unbound-name", f"'{name}' cannot be used here", f"name {_a(reference.noun)}"
        if members is None:
            per = "'each' can only be used in a timer with per"
            return "unbound-name", per if path[0] == "timers" and name == EACH else _UNKNOWN[name], ""
        kinds = self.roster.kinds
        wrong = next((one for one in members if one in kinds and kinds[one] not in reference.kinds), None)
        if wrong is None:
            return None  # what has no kind does not exist, which is reported where it is written
        message = f"'{name}' stands for '{wrong}', {_a(kinds[wrong])}; expected {_a(reference.noun)}"
        return "wrong-kind", message, self._instead(reference, kinds[wrong])

    def _wrong_group(self, reference: Ref, group: str) -> _Wrong | None:
        kinds, members = self.roster.kinds, self.roster.groups[group]
        stranger = next((one for one in members if one in kinds and kinds[one] not in reference.kinds), None)
        if not reference.groups:
            return (
                "wrong-kind",
                f"'{group}' is a group; expected {_a(reference.noun)}",
                f"name one of {listing(members)}",
            )
        if stranger is None:
            return None
        what = f"'{group}' is" if group == stranger else f"group '{group}' contains '{stranger}',"
        message = f"{what} {_a(kinds[stranger])}; expected {_a(reference.noun)}"
        return "mixed-group", message, self._instead(reference, kinds[stranger])

    def _instead(self, reference: Ref, kind: str) -> str:
        """Return what to write in place of something of the wrong kind."""
        if reference.instead and kind in reference.instead_of:
            return reference.instead
        if kind == "fixed obstacle" and "obstacle" in reference.kinds:
            return "with movable: true it is an entity"
        return ""

    def _known(self, reference: Reference) -> list[str]:
        """Return the names that may stand for a reference."""
        roster = self.roster
        if isinstance(reference, SectionRef):
            words = sorted(reference.words - {"any", *BOUND})
            return [*words, *(name for section in reference.sections for name in roster.names(section))]
        groups = roster.groups.items() if reference.groups else ()
        fitting = (group for group, all_ in groups if all_ and self._wrong_group(reference, group) is None)
        draws = roster.drawn.items() if reference.drawn else ()
        deciding = (
            draw for draw, all_ in draws if all_ and all(roster.kinds.get(one) in reference.kinds for one in all_)
        )
        return list(dict.fromkeys([*roster.of_kinds(reference.kinds), *fitting, *deciding]))

    def _unknown(self, reference: Reference, name: str, path: Path) -> _Wrong | None:
        sections = reference.sections if isinstance(reference, SectionRef) else _ON_FIELD
        if not all(isinstance(self.root.entries.get(section, self.root), Entries) for section in sections):
            return None  # that the section is none is reported; what might stand in it is unknown
        kind = self.roster.kind_of(name)
        which = f", which is {_a(kind)}" if kind else ""
        help_ = of_removed(name, sections, path, self.root, self.removed)
        help_ = help_ or choice_of(name, self._known(reference), reference.noun)
        if kind == "param":
            help_ = f"what a param holds is written {{param: {name}}}"
        elif name == "this" and path[0] == "rules":
            help_ = "in a rule with repeat_for its name is written {param: this}"
        return "unknown-name", f"unknown {reference.noun} '{name[:64]}'{which}", help_

    def _values_of(self, draw: Node | None) -> list[tuple[Path, Leaf]]:
        """Return the values among which a draw decides, with their places."""
        path = ("draws", *texts(draw)[:1], "values")
        values = node_at(self.root, path)
        listed = enumerate(values.items if isinstance(values, Items) else ())
        return [((*path, i), one) for i, one in listed if isinstance(one, Leaf) and one.value is not None]

    def _check_drawn(self, reference: Reference, draw: str, user: Path) -> None:
        """Check that all that a draw may decide can stand where its name is used."""
        plain = Ref(reference.noun, reference.kinds) if isinstance(reference, Ref) else reference
        for at, value in self._values_of(Leaf(draw, self.root.mark)):
            if not isinstance(value.value, str):
                self._add_once("wrong-value", at, f"expected {_a(reference.noun)}, found {format_node(value)}", user)
            elif wrong := self._wrong(plain, value.value, at, Scope()):
                self._add_once(wrong[0], at, wrong[1], user, wrong[2])

    def _decided(self, node: Entries, path: Path, scope: Scope) -> None:
        """Check the value of a draw that a rule asks for or sets: ``each`` and ``other`` are names if it has them."""
        key = "as" if "as" in node.entries else "equals"
        draw, value, at = node.entries.get("draw"), node.entries.get(key), (*path, key)
        known = [one.value for _, one in self._values_of(draw)]
        name = str(value.value) if isinstance(value, Leaf) else ""
        members = scope.of(name) if name in BOUND else None
        if name not in BOUND or (name in known and members is None):
            self._among_values(draw, value, at)
        elif members is None:
            self.add("unbound-name", at, _UNKNOWN[name])
        elif name in known:
            message = f"'{name}' is a value of the draw and a name that this rule has"
            self.add("name-taken", at, message, "give the value another name")
        else:
            strangers = [one for one in members if one not in known and one in self.roster.kinds]
            # To ask whether it is drawn, it suffices that one of them can be; to be set, each must.
            if known and strangers and (key == "as" or len(strangers) == len(members)):
                message = f"'{name}' stands for '{strangers[0]}', which is never drawn"
                self.add("never-drawn", at, message, choice_of("", map(spelled, known)))

    def _among_values(self, draw: Node | None, value: Node | None, path: Path) -> None:
        known = [one.value for _, one in self._values_of(draw)]
        if not known or not isinstance(value, Leaf) or value.value is None:
            return
        if not any(type(value.value) is type(one) and value.value == one for one in known):
            names = [quoted(one) if isinstance(one, str) else spelled(one) for one in known]
            help_ = choice_of(spelled(value.value), names)
            self.add("never-drawn", path, f"{format_node(value)} is never drawn", help_)

    # --- what a reference cannot say ----------------------------------------------------------------------------------

    def _relations(self, model: Any, node: Entries, path: Path, scope: Scope) -> None:
        """Check how the names of one mapping go together."""
        if key := next((key for key in _KEPT if "entity" in fields(model) and key in fields(model)), None):
            self._owner(key, model, node, path, scope)
        if model in (Place, places.Placing):
            self._put(node, path, scope)
        if model in _DRAWN_NUMBERS:
            for at, value in self._values_of(node.entries.get("draw")):
                if message := _DRAWN_NUMBERS[model](value):
                    self._add_once("wrong-value", at, message, path)
        check = _RELATIONS.get(model)
        if check is not None:
            check(self, node, path, scope)

    def _put(self, node: Entries, path: Path, scope: Scope) -> None:
        kinds = self.roster.kinds
        for layout in texts(child(node.entries.get("layout"), "draw")):
            self._check_drawn(SectionRef("layout", ("placements",)), layout, (*path, "layout"))
        names = self._members(node.entries.get("entity"), scope) if "kick" in node.entries else ()
        if name := next((one for one in names if kinds.get(one, "ball") != "ball"), None):
            self.add("wrong-kind", (*path, "kick"), f"only balls roll: '{name}' is {_a(kinds[name])}")

    def _of_others(self, node: Entries, path: Path, _scope: Scope) -> None:
        """Check that a counter is kept for several, if one of them is compared with the others."""
        for key in ("lowest", "highest"):
            for name in texts(node.entries.get(key)):
                counter = node_at(self.root, ("counters", name))
                if counter is not None and child(counter, "per") is None:
                    message = f"counter '{name}' is not kept per entity: there are no others"
                    help_ = f"give it per: robots, or write {{counter: {name}}}"
                    self.add("not-per-entity", (*path, key), message, help_)

    def _decided_beforehand(self, test: Entries, path: Path, _scope: Scope) -> None:
        """Check the values of draws that a test decides: one, or several in order."""
        for name, value in _entries(test.entries.get("draws")):
            at = (*path, "draws", name)
            self._among_values(Leaf(name, value.mark), value, at)
            for index, one in enumerate(value.items if isinstance(value, Items) else ()):
                self._among_values(Leaf(name, value.mark), one, (*at, index))

    def _owner(self, key: str, model: Any, node: Entries, path: Path, scope: Scope) -> None:
        """Check ``entity`` beside something that may be kept for each member of a group, or its absence."""
        names, whose = texts(node.entries.get(key)), node.entries.get("entity")
        entry = node_at(self.root, (_KEPT[key], *names[:1]))
        per = child(entry, "per")
        groups = texts(per)
        if not names or (isinstance(per, Leaf) and not groups):
            return
        if not groups:
            surplus = next((one for one in ("entity", "of") if one in node.entries), None)
            if surplus is not None and (entry is not None or names[0] in self.roster.names("entrants")):
                message = f"{key} '{names[0]}' is not kept per entity"
                self.add("not-per-entity", (*path, surplus), message, f"leave '{surplus}' out, or give the {key} 'per'")
            return
        if groups[0] not in self.roster.groups and groups[0] not in self.roster.kinds:
            return  # an unknown group is reported where it is written
        owners, is_counted = self.roster.expand(groups[0]), "of" in node.entries
        kinds = self.roster.kinds
        if whose is None:
            is_about_one = any(one in owners or kinds.get(one) not in ("zone", "gate") for one in scope.each or ())
            if is_about_one and not is_counted and model not in _WRITES:
                message = f"{key} '{names[0]}' is kept per {groups[0]}"
                self.add("missing-entity", (*path, key), message, "say whose with 'entity', such as entity: each")
            return
        is_several = isinstance(whose, Items) or any(
            one in self.roster.groups and one not in kinds for one in texts(whose)
        )
        if "of" in fields(model) and not is_counted and is_several:
            help_ = "name one entity, or say with 'of' how many of them: any, all, none, {at_least: n}"
            self.add("missing-entity", (*path, "entity"), "these are several", help_)
            return
        stranger = next((one for one in self._members(whose, scope) if one not in owners and one in kinds), None)
        if stranger is not None:
            message = f"{key} '{names[0]}' is kept per {groups[0]}, and '{stranger}' is not among them"
            self.add("wrong-kind", (*path, "entity"), message)

    def _two_that_touch(self, touch: Entries, path: Path, scope: Scope) -> None:
        one, other = (self._members(touch.entries.get(key), scope) for key in ("entity", "other"))
        kinds = self.roster.kinds
        written = {name for key in ("entity", "other") for name in texts(touch.entries.get(key))}
        is_itself = len(written) == 1 and "other" in touch.entries and (written <= kinds.keys() | {EACH})
        if is_itself and touch.entries.keys() >= {"entity", "other"}:
            message = f"'{next(iter(written))}' never touches itself"
            self.add(
                "never-touches", (*path, "other"), message, "name in other what it touches, such as robots or walls"
            )
        elif one and other and all(kinds.get(name) in ("fixed obstacle", "walls") for name in (*one, *other)):
            message = f"'{one[0]}' and '{other[0]}' never move, so that they never touch"
            self.add("never-touches", (*path, "other"), message, "name a robot or a ball")

    def _receiver(self, node: Entries, path: Path, scope: Scope) -> None:
        """Check that ``each`` or ``other`` stands for robots that an entrant drives, if points are given to it."""
        path = (*path, "entrant")
        name = next(iter(texts(node.entries.get("entrant"))), "")
        if name not in BOUND or name in self.roster.names("entrants"):
            return
        members = scope.of(name)
        if members is None:
            self.add("unbound-name", path, _UNKNOWN[name])
            return
        robots = (node_at(self.root, ("entrants", one, "robots")) for one in self.roster.names("entrants"))
        driven = {robot for node in robots for robot, _ in _entries(node)}
        idle = next((one for one in members if one in self.roster.kinds and one not in driven), None)
        if idle is not None:
            message = f"'{name}' stands for '{idle}', {_a(self.roster.kinds[idle])} that no entrant drives"
            self.add("wrong-kind", path, message)

    def _among_steps(self, node: Entries, path: Path, scope: Scope) -> None:
        sequence, step = texts(node.entries.get("sequence")), texts(node.entries.get("step"))
        steps = node_at(self.root, ("sequences", *sequence[:1], "steps"))
        if not isinstance(steps, Items) or not step:
            return
        known = [text for part in steps.items for text in texts(child(part, "any_of") or part)]
        members = (scope.each or ()) if step[0] == EACH else step
        # Of several that `each` stands for it suffices that one is a step.
        if members and all(self.roster.kinds.get(one) in ("zone", "gate") and one not in known for one in members):
            self.add(
                "unknown-name", (*path, "step"), f"'{members[0]}' is not a step of it", choice_of(members[0], known)
            )


_RELATIONS: dict[Any, Callable[[_Walker, Entries, Path, Scope], None]] = {
    Score: _Walker._receiver,  # noqa: SLF001 - its own
    Drawn: _Walker._decided,  # noqa: SLF001
    DrawAction: _Walker._decided,  # noqa: SLF001
    Expectation: _Walker._decided_beforehand,  # noqa: SLF001
    SequenceAt: _Walker._among_steps,  # noqa: SLF001
    LowestOfOthers: _Walker._of_others,  # noqa: SLF001
    HighestOfOthers: _Walker._of_others,  # noqa: SLF001
    Touches: _Walker._two_that_touch,  # noqa: SLF001
}


def _no_number(value: Leaf) -> str:
    return f"expected a number, found {format_node(value)}" if isinstance(value.value, (str, bool)) else ""


def _within(least: float, most: float, what: str) -> Callable[[Leaf], str]:
    def wrong(value: Leaf) -> str:
        is_within = isinstance(value.value, int | float) and least <= value.value <= most
        return _no_number(value) or ("" if is_within else f"{what}, found {format_node(value)}")

    return wrong


_DRAWN_NUMBERS: dict[Any, Callable[[Leaf], str]] = {
    NumberDraw: _no_number,
    term_of(NumberDraw): _no_number,
    DrawnDuration: _within(
        TICK_S, LONGEST_S, f"a duration must be at least one tick ({TICK_S} s), at most {LONGEST_S} s"
    ),
    DrawnSpeed: _within(5e-324, MAX_KICK_MPS, f"a kick's speed is over 0 and at most {MAX_KICK_MPS} m/s"),
}
"""By model: what is wrong with a value of a draw whose name stands for a number; an empty text if nothing is."""


def _names_in(node: Node, path: Path, reference: Reference) -> Iterator[tuple[str, Path]]:
    """Yield the names of a field, each with its place."""
    if reference.keys:
        yield from ((name, (*path, name)) for name in (node.entries if isinstance(node, Entries) else ()))
    elif isinstance(node, Leaf) and isinstance(node.value, str):
        yield node.value, path
    elif isinstance(node, Items):
        for index, item in enumerate(node.items):
            yield from _names_in(item, (*path, index), reference)


def _entries(node: Node | None) -> Iterable[tuple[str, Node]]:
    return node.entries.items() if isinstance(node, Entries) else ()


def _a(noun: str) -> str:
    if noun == "walls":
        return "the walls"
    return f"an {noun}" if noun[0] in "aeiou" else f"a {noun}"
