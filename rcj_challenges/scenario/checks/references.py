"""References: every name that a scenario uses must exist, and be of the kind that is needed there.

Walks the tree beside the shapes of the models, so that unknown names come in one report with everything else.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from math import inf, isnan, nan
from typing import Any, NamedTuple

from rcj_challenges.core.code import Code
from rcj_challenges.core.diagnostics import Diagnostic, issue
from rcj_challenges.rules.base import Condition, Trigger
from rcj_challenges.rules.phrasing import spelled
from rcj_challenges.rules.refs import ROBOTS, Ref, Reference, SectionRef, drawn_value, refs_of
from rcj_challenges.rules.triggers import TRIGGERS
from rcj_challenges.rules.values import FOLDS
from rcj_challenges.scenario import codes
from rcj_challenges.scenario.checks.naming import removal_help
from rcj_challenges.scenario.errors import MAX_FOUND, choice_of, cut, listing
from rcj_challenges.scenario.messages.wording import format_node
from rcj_challenges.scenario.models.robots import Kit
from rcj_challenges.scenario.models.scenario import Expectation, Result, Rule, Scenario
from rcj_challenges.scenario.models.state import Sequence, Timer
from rcj_challenges.scenario.roster import BOUND, EACH, ENTRANTS, OTHER, OTHERS, WALLS, Roster, texts, touched
from rcj_challenges.scenario.shape import Shape, bare, chosen, fields, is_model, step_into
from rcj_challenges.scenario.tree import (
    Entries,
    Items,
    Leaf,
    Mark,
    Node,
    Path,
    child,
    entries_of,
    format_path,
    items_of,
    node_at,
    value_of,
)

_ON_FIELD = ("robots", "balls", "obstacles", "zones", "gates", "spots", "groups")
"""Sections whose names stand for something on the field."""
_KEPT = {"counter": "counters", "flag": "flags", "timer": "timers", "sequence": "sequences"}
"""What may be kept once, or for each member of a group, by the key that names it."""
_BOUNDS = frozenset({"at_least", "at_most", "above", "below"})
_ONLY_ROBOTS: dict[str, Any] = {"noun": ROBOTS.noun, "kinds": ROBOTS.kinds}
_Wrong = tuple[Code, str, str]


class Scope(NamedTuple):
    """What ``each`` and ``other`` may stand for in a rule; None if the name cannot be used there.

    Attributes:
        group: the group that ``each`` is of; of ``entrants`` it stands for their robots.
    """

    each: tuple[str, ...] | None = None
    other: tuple[str, ...] | None = None
    group: str | None = None

    def of(self, name: str) -> tuple[str, ...] | None:
        """Return the names that ``each``, ``others`` or ``other`` may stand for."""
        return self.other if name == OTHER else self.each


def check_references(root: Entries, roster: Roster, removed: Mapping[Path, Mark]) -> list[Diagnostic]:
    """Return the mistakes in the names that a scenario uses."""
    walker = _Walker(root, roster, removed)
    walker.walk(root, Scenario, (), Scope())
    return list(walker.issues.values())


class _Walker:
    def __init__(self, root: Entries, roster: Roster, removed: Mapping[Path, Mark]) -> None:
        self.root = root
        self.roster = roster
        self.removed = removed
        # A value of a draw may be wrong for several words that use it: it is reported once.
        self.issues: dict[tuple[str, Path], Diagnostic] = {}
        kits = [node_at(root, ("robots", robot, "kit")) for robot in roster.names("robots")]
        kits += [node_at(root, ("entrants", entrant, "kits")) for entrant in roster.names("entrants")]
        self.kits_in_use = {name for kit in kits for name in texts(kit)}

    def walk(self, node: Node, shape: Shape, path: Path, scope: Scope) -> None:
        """Check a value and all that is in it."""
        shape = chosen(shape, node) if shape is not None else None
        if shape is None or len(self.issues) >= MAX_FOUND:
            return  # of an unknown form, which is reported as such; or enough is wrong already
        if isinstance(node, Entries) and is_model(model := bare(shape).kind):
            scope = self._model(model, node, path, scope)
        for step, inner in enumerate(node.items) if isinstance(node, Items) else entries_of(node).items():
            if not isinstance(inner, Leaf):
                self.walk(inner, step_into(shape, node, step), (*path, step), scope)

    def add(self, code: Code, path: Path, message: str, help_: str = "", *, at_key: bool = False) -> None:
        self.issues.setdefault((code, path), issue(code, path, message, help_, at_key))

    def _model(self, model: Any, node: Entries, path: Path, scope: Scope) -> Scope:
        """Check the names of one mapping, and return what ``each`` and ``other`` stand for in it."""
        if model is Kit and path[-1] not in self.kits_in_use:
            return scope  # a preset's kit may list robots that this scenario has not
        if model is Rule:
            scope = self._scope_of(node)
        # What one of several timers lasts may be what the counter of the same member says.
        group = node.entries.get("per") if model is Timer else Leaf(ENTRANTS, node.mark) if model is Result else None
        if texts(group):
            scope = self._scope_of_group(group)
        for key, reference in self._refs_of(model, node, path):
            named = node.entries[key]
            if isinstance(named, Items) and step_into(fields(model)[key], named, 0) is None:
                continue  # a list where one name is expected, which is reported as such
            self._values(reference, named, (*path, key), path)
            for name, at in _names_in(named, (*path, key), reference):
                if wrong := self._wrong(reference, name, at, scope):
                    self.add(wrong[0], at, wrong[1], wrong[2], at_key=reference.keys)
        self._relations(model, node, path, scope)
        return scope

    def _scope_of(self, rule: Entries) -> Scope:
        group = rule.entries.get("for_each")
        scope = Scope() if group is None else self._scope_of_group(group)
        listed = items_of(rule.entries.get("triggers"))
        binding = [(word.name(),) for word in TRIGGERS.words() if issubclass(word, Trigger) and word.BINDS_OTHER]
        if any(texts(child(trigger, "trigger")) not in binding for trigger in listed):
            return scope
        pairs = [[self._members(child(one, key), scope) for key in ("entity", "other")] for one in listed]
        found = dict.fromkeys(name for one, other in pairs for name in other if name in touched(one, other))
        return scope._replace(other=tuple(found))

    def _scope_of_group(self, group: Node | None) -> Scope:
        return Scope(self._members(group, Scope()), group=next(iter(texts(group)), None))

    def _members(self, names: Node | None, scope: Scope) -> tuple[str, ...]:
        """Return the members that names stand for: groups expanded, ``each`` and ``other`` replaced."""
        found = ((scope.of(name) or ()) if self._is_bound(name) else self.roster.may_be(name) for name in texts(names))
        return tuple(one for members in found for one in members)

    # --- one name -----------------------------------------------------------------------------------------------------

    def _wrong(self, reference: Reference, name: str, path: Path, scope: Scope) -> _Wrong | None:  # noqa: PLR0911
        """Return code, message and help about a name that cannot stand here; None if it can."""
        roster = self.roster
        if name in reference.words:
            return self._receiver(name, scope.of(name)) if self._is_bound(name) else None
        if name in roster.roles and (isinstance(reference, Ref) or EACH in reference.words):
            return self._role(reference, name, path)
        if isinstance(reference, SectionRef):
            is_known = any(name in roster.names(section) for section in reference.sections)
            return None if is_known else self._unknown(reference, name, path)
        if self._is_bound(name):
            unbound = self._unbound(reference, name, path, scope)
            if unbound:
                return codes.UNBOUND_NAME, unbound, ""
            return self._team(reference, name, scope) or self._wrong_kind(reference, name, scope.of(name) or ())
        if roster.kinds.get(name) in reference.kinds or ("entrant" in reference.kinds and name in roster.teams):
            return None
        if name not in {*roster.groups, *roster.kinds}:
            if not reference.drawn or name not in roster.names("draws"):
                return self._unknown(reference, name, path)
            self._drawn(reference, name, path)
            return None
        if name in roster.groups and not reference.groups:
            message = f"'{name}' is a group; expected {_with_a(reference.noun)}"
            return codes.WRONG_KIND, message, f"name one of {listing(roster.groups[name])}"
        return self._wrong_kind(reference, name, roster.groups.get(name, (name,)))

    def _role(self, reference: Reference, name: str, path: Path) -> _Wrong | None:
        """Return the mistake of a role that stands for a name."""
        members = self.roster.roles[name]
        if path[0] not in ("rules", "broadcast") and path[2:3] not in (("while",), ("anchor",)):
            return codes.UNBOUND_NAME, f"the role '{name}' can only be used in rules and broadcasts", ""
        if isinstance(reference, SectionRef):
            return self._receiver(name, members)
        is_of_entrants = bool(set(members) & set(self.roster.teams)) and "entrant" not in reference.kinds
        if not reference.takes_roles or is_of_entrants:
            group = next(iter(texts(node_at(self.root, ("roles", name, "of")))), "")
            group = ENTRANTS if is_of_entrants else group if group in self.roster.groups else "GROUP"
            condition = f"{{role: {name}, equals: each}}"
            help_ = f"write for_each: {group}, a condition {condition}, and 'each' for the one that has it"
            return codes.WRONG_KIND, f"'{name}' is a role; expected {_with_a(reference.noun)}", help_
        return self._wrong_kind(reference, name, members)

    def _is_bound(self, name: str) -> bool:
        return name in BOUND or self.roster.is_others(name)

    def _wrong_kind(self, reference: Ref, name: str, members: tuple[str, ...]) -> _Wrong | None:
        kinds = self.roster.kinds
        # What has no kind does not exist, which is reported where it is written.
        wrong = next((one for one in members if kinds.get(one, "") not in {"", *reference.kinds}), None)
        if wrong is None:
            return None
        what = f"'{name}' is" if name == wrong else f"'{name}' stands for '{wrong}',"
        help_ = reference.instead if kinds[wrong] in reference.instead_of else ""
        if kinds[wrong] == "fixed obstacle" and "obstacle" in reference.kinds:
            help_ = help_ or "with movable: true it is an entity"
        return codes.WRONG_KIND, f"{what} {_with_a(kinds[wrong])}; expected {_with_a(reference.noun)}", help_

    def _team(self, reference: Ref, name: str, scope: Scope) -> _Wrong | None:
        """Return the mistake of an entrant with several robots where one thing is needed; None if it is none."""
        is_one = reference.groups or "entrant" in reference.kinds or scope.group != ENTRANTS or name == OTHER
        if is_one or all(len(robots) == 1 for robots in self.roster.teams.values()):
            return None
        message = f"'{name}' stands for all robots of an entrant; expected {_with_a(reference.noun)}"
        return codes.WRONG_KIND, message, "write for_each: robots, or a name"

    def _unbound(self, reference: Ref, name: str, path: Path, scope: Scope) -> str:
        members = scope.of(name)
        is_opponent = "entrant" in reference.kinds and scope.group == ENTRANTS and len(self.roster.teams) == 2
        if name == OTHER and path[2:3] == ("triggers",):
            return "'other' is what was touched: a trigger says what may be, by name or group"
        if not reference.each or (name == OTHERS and not reference.groups and not is_opponent):
            return f"'{name}' cannot be used here"
        if members is None and path[0] == "timers" and name == EACH:
            return "'each' can only be used in a timer with per"
        return _unknown_bound(name) if members is None else ""

    def _known(self, reference: Reference) -> list[str]:
        """Return the names that may stand for a reference."""
        roster = self.roster
        if isinstance(reference, SectionRef):
            words = sorted(reference.words - {"any", *BOUND})
            return [*words, *(name for section in reference.sections for name in roster.names(section))]
        several = {**(roster.groups if reference.groups else {}), **(roster.drawn if reference.drawn else {})}
        several |= roster.roles if reference.takes_roles else {}
        fitting = (
            name
            for name, members in several.items()
            if members and all(roster.kinds.get(one) in reference.kinds for one in members)
        )
        of_its_kinds = (name for name, kind in roster.kinds.items() if kind in reference.kinds)
        return list(dict.fromkeys([*of_its_kinds, *fitting]))

    def _unknown(self, reference: Reference, name: str, path: Path) -> _Wrong | None:
        sections = reference.sections if isinstance(reference, SectionRef) else _ON_FIELD
        if not all(isinstance(self.root.entries.get(section, self.root), Entries) for section in sections):
            return None  # that the section is none is reported; what might stand in it is unknown
        kind = self.roster.kind_of(name)
        which = f", which is {_with_a(kind)}" if kind else ""
        help_ = removal_help(name, sections, self.removed) or choice_of(name, self._known(reference), reference.noun)
        if kind == "param":
            help_ = f"what a param holds is written {{param: {name}}}"
        elif name == "this" and path[0] == "rules":
            help_ = "in a rule with repeat_for its name is written {param: this}"
        elif name == WALLS:
            help_ = "this field is without walls"
        return codes.UNKNOWN_NAME, f"unknown {reference.noun} '{name[:64]}'{which}", help_

    # --- values of draws ----------------------------------------------------------------------------------------------

    def _values_of(self, draw: Node | None) -> list[tuple[Path, Leaf]]:
        """Return the values among which a draw decides, with their places, or the members of a role."""
        name = next(iter(texts(draw)), "")
        if name in self.roster.roles:
            return [(("roles", name), Leaf(one, self.root.mark)) for one in self.roster.roles[name]]
        path = ("draws", name, "values")
        listed = enumerate(items_of(node_at(self.root, path)))
        return [((*path, i), one) for i, one in listed if isinstance(one, Leaf) and one.value is not None]

    def _drawn(self, reference: Reference, draw: str, user: Path) -> None:
        """Check that all that a draw may decide can stand where its name is used."""
        plain = Ref(reference.noun, reference.kinds) if isinstance(reference, Ref) else reference
        needed_by = f"(needed by {format_path(self.root, user)})"
        for at, value in self._values_of(Leaf(draw, self.root.mark)):
            if not isinstance(value.value, str):
                message = f"expected {_with_a(reference.noun)}, found {format_node(value)} {needed_by}"
                self.add(codes.WRONG_VALUE, at, message)
            elif wrong := self._wrong(plain, value.value, at, Scope()):
                self.add(wrong[0], at, f"{wrong[1]} {needed_by}", wrong[2])

    def _values(self, reference: Reference, node: Node, path: Path, user: Path) -> None:
        """Check all that a draw may decide where it stands for a name, or for a number."""
        for draw in texts(child(node, "draw")):
            self._drawn(reference, draw, path)
        least, most = getattr(reference, "numbers", None) or (nan, nan)
        bounds = "" if least == -inf else f" from {least:g} to {most:g}"
        for at, value in () if isnan(least) else self._values_of(node):
            number = value.value
            if not isinstance(number, int | float) or isinstance(number, bool) or not least <= number <= most:
                message = f"expected a number{bounds}, found {format_node(value)}"
                self.add(codes.WRONG_VALUE, at, f"{message} (needed by {format_path(self.root, user)})")

    def _decided(self, key: str, node: Entries, path: Path, scope: Scope, *, is_set: bool) -> None:
        """Check the value of a draw that a rule asks for or sets: ``each`` and ``other`` are names if it has them."""
        value, at = node.entries.get(key), (*path, key)
        role = node.entries.get("role")
        known = [one.value for _, one in self._values_of(role or node.entries.get("draw"))]
        known += ["none", "next"][: 1 + is_set] if role is not None else []
        name = str(value_of(value))
        members = tuple(self.roster.teams) if scope.group == ENTRANTS and name != OTHER else scope.of(name)
        is_opponent = name == OTHERS and scope.group == ENTRANTS and len(self.roster.teams) == 2
        what = next((f"can never have the role '{one}'" for one in texts(role)), "is never drawn")
        if name in known or not (name in BOUND or is_opponent):
            self._among(known, value, at, what)
        elif members is None:
            self.add(codes.UNBOUND_NAME, at, _unknown_bound(name))
        # To ask whether it is drawn, it suffices that one of them can be; to be set, each must.
        elif known and members and not (all if is_set else any)(one in known for one in members):
            stranger = next(one for one in members if one not in known)
            message = f"'{name}' stands for '{stranger}', which {what}"
            self.add(codes.NEVER_DRAWN, at, message, choice_of("", (cut(spelled(one)) for one in known)))

    def _decided_by_test(self, test: Entries, path: Path) -> None:
        """Check the values of draws that a test decides: one, or several in order."""
        for at, block in ((path, test), ((*path, "given"), test.entries.get("given"))):
            for name, value in entries_of(child(block, "roles")).items():
                members = [*self.roster.roles[name], "none"] if name in self.roster.roles else []
                self._among(members, value, (*at, "roles", name), f"can never have the role '{name}'")
        for name, value in entries_of(test.entries.get("draws")).items():
            known = [one.value for _, one in self._values_of(Leaf(name, value.mark))]
            at = (*path, "draws", name)
            for index, one in enumerate(items_of(value)):
                self._among(known, one, (*at, index))
            self._among(known, value, at)

    def _among(self, known: list[Any], value: Node | None, path: Path, what: str = "is never drawn") -> None:
        if not known or not isinstance(value, Leaf) or value.value is None:
            return
        if not any(type(value.value) is type(one) and value.value == one for one in known):
            help_ = choice_of(spelled(value.value), (cut(spelled(one)) for one in known))
            self.add(codes.NEVER_DRAWN, path, f"{format_node(value)} {what}", help_)

    def _refs_of(self, model: Any, node: Entries, path: Path) -> Iterator[tuple[str, Reference]]:
        """Yield the keys that name something: of a condition, or a value read of several, also groups."""
        over = getattr(model, "OVER", "") if _is_folded(path) or issubclass(model, Condition) else ""
        is_of_robots = any(key in node.entries for key in getattr(model, "OF_ROBOTS", ()))
        robots = getattr(model, "OWNER", "") if is_of_robots else ""
        is_bounded = "draw" in node.entries and not _BOUNDS.isdisjoint(node.entries)
        for _, key, reference in refs_of(model):
            if key not in node.entries:
                continue
            one = replace(reference, **_ONLY_ROBOTS) if key == robots and isinstance(reference, Ref) else reference
            one = replace(one, groups=True) if key == over and isinstance(one, Ref) else one
            one = replace(one, numbers=(-inf, inf)) if is_bounded and isinstance(one, SectionRef) else one
            if isinstance(one, Ref) and "entrant" in one.kinds and not self._is_per_entrants(node):
                one = replace(one, kinds=one.kinds - {"entrant"})
            yield key, one

    def _is_per_entrants(self, node: Entries) -> bool:
        """Return whether a mapping names a counter, flag or timer that each entrant has."""
        kept = ((section, name) for key, section in _KEPT.items() for name in texts(node.entries.get(key)))
        return any(ENTRANTS in texts(child(node_at(self.root, path), "per")) for path in kept)

    # --- what a reference cannot say ----------------------------------------------------------------------------------

    def _relations(self, model: Any, node: Entries, path: Path, scope: Scope) -> None:
        owner = getattr(model, "OWNER", "entity")
        kept = ((key, name) for key in _KEPT if key in fields(model) for name in texts(node.entries.get(key)))
        for key, name in kept if owner in fields(model) else ():
            self._owner(key, name, owner, model, node, path, scope)
        for name, info in model.model_fields.items() if {"draw", "role"} & node.entries.keys() else ():
            if (mark := drawn_value(model, name)) is not None:
                self._decided(info.alias or name, node, path, scope, is_set=mark.is_set)
        over = getattr(model, "OVER", "")
        is_own = over != "entity" or hasattr(model, "OWNER")  # of what is kept the owner is checked
        if over and is_own and not _is_folded(path) and not issubclass(model, Condition):
            self._one_only(over, node.entries.get(over), path, scope)
        if _is_folded(path) and not over:
            self.add(codes.WRONG_KIND, path, "this value names no group", "write a list of numbers: [{…}, {…}]")
        if model is Expectation:
            self._decided_by_test(node, path)
        if issubclass(model, Trigger) and model.BINDS_OTHER:
            self._touch(node, path, scope)
        if "kick" in node.entries:
            self._kick(node, path, scope)
        if model is not Sequence and "sequence" in node.entries and "equals" in node.entries:
            self._among_steps(node, path, scope)

    def _kick(self, node: Entries, path: Path, scope: Scope) -> None:
        kinds = self.roster.kinds
        names = self._members(node.entries.get("entity"), scope)
        if name := next((one for one in names if kinds.get(one, "ball") != "ball"), None):
            self.add(codes.WRONG_KIND, (*path, "kick"), f"only balls roll: '{name}' is {_with_a(kinds[name])}")

    def _owner(self, key: str, name: str, owner: str, model: Any, node: Entries, path: Path, scope: Scope) -> None:
        """Check ``entity`` beside something that may be kept for each member of a group, or its absence."""
        roster, kinds = self.roster, self.roster.kinds
        whose = node.entries.get(owner)
        entry = node_at(self.root, (_KEPT[key], name))
        group = next(iter(texts(child(entry, "per"))), "")
        if entry is None or group not in {"", *roster.groups, *kinds}:
            return  # an unknown name is reported where it is written
        if not group:
            surplus = next((one for one in ("entity", "of") if one in node.entries), None)
            message = f"{key} '{name}' is not kept per entity"
            if surplus is not None:
                help_ = f"leave '{surplus}' out, or give the {key} 'per'"
                self.add(codes.NOT_PER_ENTITY, (*path, surplus), message, help_)
            elif _is_folded(path) or owner != "entity":
                self.add(codes.NOT_PER_ENTITY, (*path, key), f"{message}: it is one alone", f"give the {key} 'per'")
            return
        owners = roster.expand(group)
        if whose is None:
            is_about_one = any(one in owners or kinds.get(one) not in ("zone", "gate") for one in scope.each or ())
            is_of_all = "of" in node.entries or _is_folded(path)
            if is_about_one and not is_of_all and not roster.keeps(scope.group, group):
                message = f"{key} '{name}' is kept per {group}"
                help_ = f"say whose with 'entity', such as entity: {group}"
                if path[0] == "result":
                    help_ = f"write {{sum: {{{key}: {name}, entity: each}}}}, highest or lowest"
                self.add(codes.MISSING_ENTITY, (*path, key), message, help_)
            return
        is_several = isinstance(whose, Items) or any(
            one in roster.groups and one not in kinds and not (group == ENTRANTS and one in roster.teams)
            for one in texts(whose)
        )
        reads_one = owner == "entity" and hasattr(model, "OVER") and not issubclass(model, Condition)
        if is_several and reads_one and not _is_folded(path):
            help_ = f"name one, or write what is meant of several: {{sum: {{{key}: {name}, …}}}}, highest or lowest"
            self.add(codes.MISSING_ENTITY, (*path, "entity"), "these are several", help_)
            return
        stranger = next((one for one in self._members(whose, scope) if one not in owners and one in kinds), None)
        if stranger is not None and not (scope.group == ENTRANTS and _is_folded(path)):  # of a team: those that have it
            message = f"{key} '{name}' is kept per {group}, and '{stranger}' is not among them"
            self.add(codes.WRONG_KIND, (*path, "entity"), message)

    def _one_only(self, key: str, names: Node | None, path: Path, scope: Scope) -> None:
        """Check that one thing is named where a number is read of one."""
        several = next(iter(items_of(names)), names) if key == "distance" else names
        is_listed = any(map(texts, items_of(several)))
        name = next(iter(texts(names)), "") if key == "score" else ""
        others = len(self.roster.keepers(scope.group)) - 1 if scope.group and self.roster.is_others(name) else 1
        if is_listed or ((others != 1 or name == ENTRANTS) and name not in self.roster.teams):
            help_ = f"name one, or write what is meant of several: {{sum: {{{key}: …}}}}, highest or lowest"
            self.add(codes.MISSING_ENTITY, (*path, key), "these are several", help_)

    def _touch(self, touch: Entries, path: Path, scope: Scope) -> None:
        """Check that two things can touch: one of them moves, and they are not the same."""
        keys = ("entity", "other")
        one, other = (self._members(touch.entries.get(key), scope) for key in keys)
        written = [texts(touch.entries.get(key)) for key in keys]
        kinds = self.roster.kinds
        is_itself = written[0] == written[1] and len(written[0]) == 1 and written[0][0] in {EACH, *kinds}
        never_move = all(kinds.get(name) in ("fixed obstacle", "walls") for name in (*one, *other))
        if is_itself or (one and other and never_move):
            why = "a thing never touches itself" if is_itself else "neither of them ever moves"
            self.add(codes.NEVER_TOUCHES, (*path, "other"), why, "name what it touches, such as robots or walls")

    def _receiver(self, name: str, members: tuple[str, ...] | None) -> _Wrong | None:
        """Return the mistake in a role, ``each``, ``others`` or ``other`` as entrants: those of robots."""
        kinds, driven = self.roster.kinds, self.roster.expand(ENTRANTS)
        if name in self.roster.teams:
            return None
        if members is None:
            return codes.UNBOUND_NAME, _unknown_bound(name), ""
        idle = next((one for one in members if one in kinds and one not in driven), "")
        message = f"'{name}' stands for '{idle}', {_with_a(kinds[idle])} that no entrant drives" if idle else ""
        return (codes.WRONG_KIND, message, "") if idle else None

    def _among_steps(self, node: Entries, path: Path, scope: Scope) -> None:
        sequence, step = texts(node.entries.get("sequence")), texts(node.entries.get("equals"))
        steps = items_of(node_at(self.root, ("sequences", *sequence[:1], "steps")))
        known = [text for part in steps for text in texts(child(part, "any_of") or part)]
        members = (scope.each or ()) if step[:1] == (EACH,) else step
        # Of several that `each` stands for it suffices that one is a step.
        if (
            steps
            and members
            and all(self.roster.kinds.get(one) in ("zone", "gate") and one not in known for one in members)
        ):
            message = f"'{members[0]}' is not a step of it"
            self.add(codes.UNKNOWN_NAME, (*path, "equals"), message, choice_of(members[0], known))


def _is_folded(path: Path) -> bool:
    """Return whether a value is one of which those of several are read."""
    return bool(path) and path[-1] in FOLDS


def _unknown_bound(name: str) -> str:
    where = "with for_each" if name != OTHER else "whose triggers are all touches"
    return f"'{name}' can only be used in a rule {where}"


def _names_in(node: Node, path: Path, reference: Reference) -> Iterator[tuple[str, Path]]:
    """Yield the names of a field, each with its place."""
    if reference.keys:
        yield from ((name, (*path, name)) for name in entries_of(node))
    elif isinstance(node, Leaf) and isinstance(node.value, str):
        yield node.value, path
    elif isinstance(node, Items):
        for index, item in enumerate(node.items):
            yield from _names_in(item, (*path, index), reference)


def _with_a(noun: str) -> str:
    return "the walls" if noun == "walls" else f"{'an' if noun[0] in 'aeiou' else 'a'} {noun}"
