"""Cross references: every name that a scenario uses must exist, and be of the kind that is needed there.

Walks the tree beside the shapes of the models, so that unknown names come in one report with everything else.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import replace
from typing import Any

from rcj_challenges.rules.actions.draw import DrawAction
from rcj_challenges.rules.actions.place import Place
from rcj_challenges.rules.actions.score import Score
from rcj_challenges.rules.conditions.drawn import Drawn
from rcj_challenges.rules.conditions.sequence_at import SequenceAt
from rcj_challenges.rules.refs import Ref, Reference, SectionRef, refs_of
from rcj_challenges.rules.triggers.touches import Touches
from rcj_challenges.rules.values.highest import HighestOfOthers
from rcj_challenges.rules.values.lowest import LowestOfOthers
from rcj_challenges.scenario.catalogue import BOUND, EACH, OTHER, Catalogue, texts
from rcj_challenges.scenario.checks.bound import Bound
from rcj_challenges.scenario.checks.drawn_numbers import DRAWN_NUMBERS
from rcj_challenges.scenario.checks.removal import removal_of
from rcj_challenges.scenario.checks.whose import NAMING_ONE, check_whose, touching_itself
from rcj_challenges.scenario.errors import MAX_FOUND, Problem, cut, known_text, listing, nearest
from rcj_challenges.scenario.messages.taken_away import without
from rcj_challenges.scenario.messages.ways_out import (
    for_group,
    for_other_kind,
    for_plural,
    for_spots,
    for_teams,
    for_word,
)
from rcj_challenges.scenario.messages.wording import found_text, spelled
from rcj_challenges.scenario.models import places, state
from rcj_challenges.scenario.models.robots import Kit
from rcj_challenges.scenario.models.scenario import Expectation, Rule, Scenario
from rcj_challenges.scenario.shape import Shape, bare, chosen, is_model, step_into
from rcj_challenges.scenario.tree import Entries, Items, Leaf, Mark, Node, Path, child, in_names, mark_of, node_at

_UNKNOWN = {
    EACH: "'each' is known only in a rule with for_each",
    OTHER: "'other' is known only in a rule whose triggers are all touches; give what else sets it off its own rule",
}
_EACH_TIMER = "'each' is known only in a timer with per: there is one for each of a group"
_WORDED = ("triggers", "conditions", "actions")
_OF_OTHERS: dict[Any, str] = {LowestOfOthers: "lowest", HighestOfOthers: "highest"}
_PLACES = ("zone", "gate")
_STANDING = ("fixed obstacle", "walls")
_ON_FIELD = ("robots", "balls", "obstacles", "zones", "gates", "spots", "groups")
"""Sections whose names stand for something on the field."""


def check_references(catalogue: Catalogue, removed: Mapping[Path, Mark]) -> list[Problem]:
    """Return what is wrong with the names that a scenario uses.

    Args:
        catalogue: the names that it defines.
        removed: where entries of a base were removed, for the message to who still names them.
    """
    walker = _Walker(catalogue, removed)
    walker.walk(catalogue.root, Scenario, (), Bound())
    return walker.problems


def shown_path(root: Node, path: Path) -> str:
    """Return a path in names that ends, within a rule, at the trigger, condition or action."""
    worded = [i for i in range(1, len(path)) if isinstance(path[i], int) and path[i - 1] in _WORDED]
    return in_names(root, path[: worded[-1] + 1] if worded and path[0] == "rules" else path)


class _Walker:
    def __init__(self, catalogue: Catalogue, removed: Mapping[Path, Mark]) -> None:
        self.names = catalogue
        self.root = catalogue.root
        self.removed = removed
        self.problems: list[Problem] = []
        self.told: set[Path] = set()
        self.kits_in_use = {catalogue.leaf("robots", robot, "kit") for robot in catalogue.names("robots")}

    def walk(self, node: Node, shape: Shape, path: Path, bound: Bound) -> None:
        """Check a value and all that is in it."""
        shape = chosen(shape, node) if shape is not None else None
        if shape is None or len(self.problems) >= MAX_FOUND:
            return  # not of any known form, which is reported as such; or enough is wrong already
        if isinstance(node, Items):
            for index, item in enumerate(node.items):
                if not isinstance(item, Leaf):  # in which nothing is
                    self.walk(item, step_into(shape, node, index), (*path, index), bound)
        elif isinstance(node, Entries):
            model = bare(shape).kind
            if is_model(model):
                bound = self._model(model, node, path, bound)
            for key, inner in node.entries.items():
                if not isinstance(inner, Leaf):
                    self.walk(inner, step_into(shape, node, key), (*path, key), bound)

    def add(self, path: Path, mark: Mark, message: str) -> None:
        self.problems.append(mark.problem(shown_path(self.root, path), message))

    def _add_once(self, where: Path, path: Path, mark: Mark, message: str, needed: str = "") -> None:
        """Add a problem, unless the same has been said of ``where``, which has it for several reasons."""
        if (*where, message) not in self.told:
            self.told.add((*where, message))
            self.add(path, mark, message + needed)

    # --- one mapping ------------------------------------------------------------------------------------------------

    def _model(self, model: Any, node: Entries, path: Path, bound: Bound) -> Bound:
        if model is Rule:
            bound = self._bound_in(node)
        elif model is state.Timer and texts(node.entries.get("per")):
            # What one of several timers lasts may be what the counter of the same one says.
            bound = Bound(tuple(one for text in texts(node.entries["per"]) for one in self.names.expand(text)))
        if model is Kit and path[-1] not in self.kits_in_use:
            return bound  # a preset's kit may list robots that this scenario has not
        for key, reference, default in refs_of(model):
            if key in node.entries:
                for text, at, mark in self._named_in(reference, node, key, path):
                    self._check(reference, text, at, mark, bound)
            elif isinstance(default, str) and not self._says_that_it_is_gone(reference, key, default, path):
                self._check(reference, default, path, mark_of(self.root, path), bound)
        self._special(model, node, path, bound)
        self._whom(model, node, path, bound)
        return bound

    def _says_that_it_is_gone(self, reference: Reference, key: str, default: str, path: Path) -> bool:
        """Say which key to write in a file whose author took away what the key means where it is left out."""
        sections = reference.sections if isinstance(reference, SectionRef) else _ON_FIELD
        section = next((one for one in sections if (one, default) in self.removed), None)
        mark = mark_of(self.root, path)
        is_own = mark.file == mark_of(self.root, ("id",)).file
        if section is None or not is_own:
            return False
        if default in reference.words or default in self.names.kinds or default in self.names.names(section):
            return False
        others = self.names.names(section)
        way_out = f"write {key}: {', or '.join(others)}" if 0 < len(others) < 4 else f"write '{key}'"
        message = f"'{key}' is left out and then means '{default}', which is not here any more; {way_out}"
        self.add(path, mark, message)
        return True

    def _whom(self, model: Any, node: Entries, path: Path, bound: Bound) -> None:
        """Check whether it can be for those whom it names: one of several, who gets points, what is kicked."""
        if model in NAMING_ONE:
            for wrong in check_whose(model, node, path, bound, self.names):
                self.add(*wrong)
        if model is Score:
            self._receiver(node.entries.get("entrant"), (*path, "entrant"), bound)
        if model in (Place, places.Placing) and "kick" in node.entries:
            self._only_balls(node.entries.get("entity"), (*path, "kick"), bound)

    def _bound_in(self, rule: Entries) -> Bound:
        group = rule.entries.get("for_each")
        bound = Bound(None if group is None else tuple(one for text in texts(group) for one in self.names.expand(text)))
        triggers = rule.entries.get("triggers")
        listed = triggers.items if isinstance(triggers, Items) else ()
        if any(texts(child(trigger, "trigger")) != ("touches",) for trigger in listed):
            return bound
        return bound._replace(
            other=tuple(dict.fromkeys(one for touch in listed for one in self._touched(touch, bound)))
        )

    def _touched(self, touch: Node, bound: Bound) -> Iterator[str]:
        """Yield what may be touched; nothing touches itself."""
        entities = bound.meant(child(touch, "entity"), self.names)
        return (one for one in bound.meant(child(touch, "other"), self.names) if {*entities} != {one})

    def _named_in(self, reference: Reference, node: Entries, key: str, path: Path) -> Iterator[tuple[str, Path, Mark]]:
        """Yield the names of a field, each with its place."""
        value, at = node.entries[key], (*path, key)
        if reference.keys:
            if isinstance(value, Entries):
                yield from ((name, (*at, name), value.key_marks[name]) for name in value.entries)
            return
        yield from _leaves(value, at)

    # --- one name ---------------------------------------------------------------------------------------------------

    def _check(self, reference: Reference, name: str, path: Path, mark: Mark, bound: Bound) -> None:
        if name in reference.words:
            return
        if isinstance(reference, SectionRef):
            known = [*(known for section in reference.sections for known in self.names.names(section))]
            if name not in known:
                words = [*(reference.words - {"any", *BOUND}), *known]
                self._unknown(reference.noun, name, words, reference.sections, path, mark)
        elif name in BOUND:
            self._check_bound(reference, name, path, mark, bound)
        else:
            self._check_on_field(reference, name, path, mark)

    def _check_bound(self, reference: Ref, name: str, path: Path, mark: Mark, bound: Bound) -> None:
        members = bound.of(name)
        if name == OTHER and path[2:3] == ("triggers",):
            self.add(path, mark, "'other' is the one that was touched: a trigger says who may be, by name or group")
        elif not reference.each:
            self.add(path, mark, f"'{name}' cannot stand here; name {_a(reference.noun)}")
        elif members is None:
            self.add(path, mark, _EACH_TIMER if path[0] == "timers" and name == EACH else _UNKNOWN[name])
        else:
            kinds = self.names.kinds
            # What has no kind is a name that does not exist, which is reported where it is written.
            wrong = next((one for one in members if one in kinds and kinds[one] not in reference.kinds), None)
            if wrong is not None:
                way_out = self._to_its_centre(name, members, reference) or _way_out(kinds[wrong], reference)
                wanted = f"{_a(reference.noun)}{way_out}"
                self.add(path, mark, f"'{name}' stands for '{wrong}', {_a(kinds[wrong])}; expected {wanted}")

    def _to_its_centre(self, name: str, members: Iterable[str], reference: Ref) -> str:
        """Return what to write where a zone is taken for a point; empty if one of those meant has no centre."""
        names, is_point = self.names, "spot" in reference.kinds and len(reference.kinds) > 1 and not reference.keys
        if not is_point or not all(names.kinds.get(one) == "zone" and names.has_centre(one) for one in members):
            return ""
        return f", and a spot can stand for its centre: {{action: set_spot, spot: NAME, to: {name}}}"

    def _check_on_field(self, reference: Ref, name: str, path: Path, mark: Mark) -> None:
        names = self.names
        kind = names.kinds.get(name)
        if kind is not None and (kind in reference.kinds or name not in names.groups):
            if kind not in reference.kinds:
                way_out = self._to_its_centre(name, (name,), reference) or _way_out(kind, reference)
                wanted = f"{_a(reference.noun)}{way_out}"
                self.add(path, mark, f"'{name}' is {_a(kind)}; expected {wanted}")
        elif name in names.groups:
            self._check_group(reference, name, path, mark)
        elif reference.drawn and name in names.names("draws"):
            self._check_drawn(replace(reference, groups=False, each=False, drawn=False), name, path)
        else:
            known = names.of_kind(reference.kinds)
            if reference.groups:
                known += [
                    group for group, all_ in names.groups.items() if all_ and self._stranger(reference, group) is None
                ]
            if reference.drawn:
                known += [draw for draw in names.names("draws") if self._may_decide(draw, reference)]
            known = list(dict.fromkeys(known))  # `walls` is a kind of thing and a group
            self._unknown(reference.noun, name, known, _ON_FIELD, path, mark, reference)

    def _may_decide(self, draw: str, reference: Ref) -> bool:
        """Return whether all values of a draw are of a kind that is needed."""
        values = texts(node_at(self.root, ("draws", draw, "values")))
        return bool(values) and all(self.names.kinds.get(value) in reference.kinds for value in values)

    def _stranger(self, reference: Ref, group: str) -> str | None:
        """Return a member of a group that is of no kind that is needed; members that do not exist are no strangers."""
        kinds = self.names.kinds
        return next((m for m in self.names.groups[group] if m in kinds and kinds[m] not in reference.kinds), None)

    def _check_group(self, reference: Ref, name: str, path: Path, mark: Mark) -> None:
        stranger = self._stranger(reference, name)
        if not reference.groups:
            way_out = for_group(name, path, self.root, self.names)
            self.add(path, mark, f"'{name}' is a group; name one {reference.noun}{way_out}")
        elif stranger is not None:
            kind = self.names.kinds[stranger]
            alike = sum(self.names.kinds.get(one) == kind for one in self.names.groups[name])
            way_out = _way_out(kind, reference)
            more = f", and {alike - 1} more of them" if way_out and alike > 1 else ""
            what = f"'{name}' is" if name == stranger else f"group '{name}' contains '{stranger}',"
            wanted = f"{_a(reference.noun)}{way_out}"
            wanted += for_spots(path, self.names.groups[name]) if kind == "spot" else ""
            # The group is what is wrong: once for each rule that names it is enough.
            self._add_once(path[:2], path, mark, f"{what} {_a(kind)}{more}; expected {wanted}")

    def _check_drawn(self, reference: Reference, draw: str, user: Path) -> None:
        """Check that all that a draw may decide can stand where its name is used."""
        values = node_at(self.root, ("draws", draw, "values"))
        before = len(self.problems)
        for index, value in enumerate(values.items if isinstance(values, Items) else ()):
            at: Path = ("draws", draw, "values", index)
            text = value.value if isinstance(value, Leaf) else None
            if isinstance(text, str):
                self._check(reference, text, at, value.mark, Bound())
            else:
                self.add(at, value.mark, f"expected {_a(reference.noun)}, found {found_text(value)}")
        needed = f" (needed by {shown_path(self.root, user)})"
        found, self.problems[before:] = self.problems[before:], []
        for problem in found:
            known: Path = (problem.path, problem.message)
            if known not in self.told:
                self.told.add(known)
                self.problems.append(replace(problem, message=problem.message + needed))

    def _unknown(
        self, noun: str, name: str, known: list[str], sections: tuple[str, ...], path: Path, mark: Mark,
        reference: Ref | None = None,
    ) -> None:  # fmt: skip
        if any(section in self.names.broken for section in sections):
            return  # that the section is none is reported; what might stand in it is unknown
        removal = removal_of(name, sections, self.removed, mark, self.root)
        if removal is not None:
            # What a base takes away and this file names is no remnant of that base.
            way_out = nearest(name, known) or known_text(known, noun) if removal.is_by_base else without(name, path)
            self.add(path, mark, f"unknown {noun} '{name}': {removal.told}{way_out}")
            return
        if teams := for_teams(name, path, self.names.names("entrants")):
            self.add(path, mark, f"unknown {noun} '{name}': {teams}")
            return
        kind = self.names.known_as(name)
        plural = for_plural(name, known) if reference is not None and reference.groups else ""
        alike = for_word(name, path) or plural or nearest(name, known) or known_text(known, noun)
        hint = alike + for_other_kind(name, kind, path, each=reference is not None and reference.each)
        which = f", which is {_a(kind)}" if kind else ""
        self.add(path, mark, f"unknown {noun} '{name[:64]}'{which}{hint}")

    # --- what a table cannot say ------------------------------------------------------------------------------------

    def _special(self, model: Any, node: Entries, path: Path, bound: Bound) -> None:
        if model is Place:
            layout = node.entries.get("layout")
            drawn = child(layout, "draw")
            if isinstance(drawn, Leaf) and drawn.value in self.names.names("draws"):
                self._check_drawn(SectionRef("layout", ("placements",)), str(drawn.value), (*path, "layout"))
        elif model in DRAWN_NUMBERS:
            self._values(node.entries.get("draw"), path, DRAWN_NUMBERS[model])
        elif model is Drawn:
            self._decided(node, "equals", path, bound)
        elif model is DrawAction:
            self._decided(node, "as", path, bound)
        elif model is Expectation:
            self._decided_beforehand(node.entries.get("draws"), (*path, "draws"))
        elif model is SequenceAt:
            self._among_steps(node, path, bound)
        elif model in _OF_OTHERS:
            self._of_several(node, _OF_OTHERS[model], path)
        elif model is Touches:
            self._who_moves(node, path, bound)

    def _of_several(self, node: Entries, key: str, path: Path) -> None:
        """Check that a counter is kept for several, where one of them is compared with the others."""
        name = node.entries.get(key)
        if not isinstance(name, Leaf):
            return
        counter = child(node_at(self.root, ("counters",)), str(name.value))
        if counter is not None and child(counter, "per") is None:
            message = f"counter '{name.value}' is not kept per entity: there are no others; give it per: robots"
            self.add((*path, key), name.mark, f"{message}, or write {{counter: {name.value}}}")

    def _who_moves(self, touch: Entries, path: Path, bound: Bound) -> None:
        """Check that one of the two that touch can come to the other."""
        entity, other = (bound.meant(touch.entries.get(key), self.names) for key in ("entity", "other"))
        message = touching_itself(touch, self.names)
        if entity and other and all(self.names.kinds.get(one) in _STANDING for one in (*entity, *other)):
            message = f"'{entity[0]}' and '{other[0]}' never move, so that they never touch; name a robot or a ball"
        if message:
            self.add((*path, "other"), mark_of(self.root, (*path, "other")), message)

    def _decided_beforehand(self, draws: Node | None, path: Path) -> None:
        """Check the values of draws that a test decides: one, or several in order."""
        for name, value in draws.entries.items() if isinstance(draws, Entries) else ():
            draw = Leaf(name, value.mark)
            self._among_values(draw, value, (*path, name))
            for index, one in enumerate(value.items if isinstance(value, Items) else ()):
                self._among_values(draw, one, (*path, name, index))

    def _receiver(self, entrant: Node | None, path: Path, bound: Bound) -> None:
        """Check that ``each`` or ``other`` stands for robots that somebody drives, where points are given to it."""
        name = entrant.value if isinstance(entrant, Leaf) else None
        if not isinstance(entrant, Leaf) or name not in BOUND or name in self.names.names("entrants"):
            return
        members = bound.of(str(name))
        if members is None:
            self.add(path, entrant.mark, _UNKNOWN[str(name)])
            return
        stranger = next((one for one in members if self.names.kinds.get(one, "robot") != "robot"), None)
        if stranger is not None:
            message = f"'{name}' stands for '{stranger}', {_a(self.names.kinds[stranger])}, which no entrant drives"
            self.add(path, entrant.mark, message)
            return
        driven = {
            robot
            for name in self.names.names("entrants")
            if isinstance(robots := node_at(self.root, ("entrants", name, "robots")), Entries)
            for robot in robots.entries
        }
        idle = next((one for one in members if one in self.names.kinds and one not in driven), None)
        if idle is not None:
            self.add(path, entrant.mark, f"'{name}' stands for '{idle}' too, which no entrant drives")

    def _only_balls(self, entity: Node | None, path: Path, bound: Bound) -> None:
        """Check that only balls are kicked."""
        other = next(
            (one for one in bound.meant(entity, self.names) if self.names.kinds.get(one, "ball") != "ball"), None
        )
        if other is not None:
            message = f"only balls roll: '{other}' is {_a(self.names.kinds[other])}"
            self.add(path, mark_of(self.root, path), message)

    def _values(self, draw: Node | None, user: Path, wrong: Callable[[Leaf], str]) -> None:
        """Check that nothing is wrong with what a draw may decide, where its name stands for a number."""
        values = node_at(self.root, ("draws", str(draw.value), "values")) if isinstance(draw, Leaf) else None
        for index, value in enumerate(values.items if isinstance(values, Items) else ()):
            message = wrong(value) if isinstance(value, Leaf) else ""
            if message:
                at: Path = ("draws", str(draw.value), "values", index) if isinstance(draw, Leaf) else user
                self._add_once(at, at, value.mark, message, f" (needed by {shown_path(self.root, user)})")

    def _decided(self, node: Entries, key: str, path: Path, bound: Bound) -> None:
        """Check the value of a draw that a rule asks for or sets: ``each`` and ``other`` are names if it has them."""
        draw, value, at = node.entries.get("draw"), node.entries.get(key), (*path, key)
        name = value.value if isinstance(value, Leaf) else None
        known = self._values_of(draw)
        if name not in BOUND or known is None or not isinstance(value, Leaf):
            self._among_values(draw, value, at)
            return
        members = bound.of(str(name))
        if name in known and members is not None:
            message = f"'{name}' is a value of the draw and a name that this rule has; give the value another name"
            self.add(at, value.mark, message)
        elif name not in known and members is None:
            self.add(at, value.mark, _UNKNOWN[str(name)])
        elif members:
            # What has no kind is a name that does not exist, which is reported where it is written.
            strangers = [one for one in members if one not in known and one in self.names.kinds]
            # To ask whether it is drawn, it suffices that one of them can be; to be set, each must.
            if strangers and (key == "as" or len(strangers) == len(members)):
                message = f"'{name}' stands for '{strangers[0]}', which is never drawn; it draws from "
                self.add(at, value.mark, message + listing(cut(spelled(one)) for one in known))

    def _values_of(self, draw: Node | None) -> list[object] | None:
        """Return what a draw may decide; None if there is no such draw."""
        values = node_at(self.root, ("draws", str(draw.value), "values")) if isinstance(draw, Leaf) else None
        if not isinstance(values, Items):
            return None
        return [item.value for item in values.items if isinstance(item, Leaf) and item.value is not None]

    def _among_values(self, draw: Node | None, value: Node | None, path: Path) -> None:
        known = self._values_of(draw)
        if not known or not isinstance(value, Leaf) or value.value is None:
            return  # that a draw has no values is said where it stands
        if not any(type(value.value) is type(one) and value.value == one for one in known):
            shown, own = [spelled(one) for one in known], spelled(value.value)
            if own in shown:  # as another kind of value
                quotes = f"write it in quotes: '{own}'"
                hint = f"; {'leave the quotes out' if isinstance(value.value, str) else quotes}"
            else:
                hint = nearest(own, shown) or f"; it draws from {listing(map(cut, shown))}"
            self.add(path, value.mark, f"{found_text(value)} is never drawn{hint}")

    def _among_steps(self, node: Entries, path: Path, bound: Bound) -> None:
        sequence, step = node.entries.get("sequence"), node.entries.get("step")
        steps = node_at(self.root, ("sequences", str(sequence.value), "steps")) if isinstance(sequence, Leaf) else None
        if not isinstance(steps, Items) or not isinstance(step, Leaf) or not isinstance(step.value, str):
            return
        known = [text for part in steps.items for text in texts(child(part, "any_of") or part)]
        members = (bound.each or ()) if step.value == EACH else (step.value,)
        # Of several that `each` stands for it suffices that one is a step.
        if members and all(self.names.kinds.get(one) in _PLACES and one not in known for one in members):
            what = f"'each' stands for '{members[0]}', which" if step.value == EACH else f"'{step.value}'"
            self.add((*path, "step"), step.mark, f"{what} is no step of it; its steps are {listing(known)}")


def _leaves(node: Node, path: Path) -> Iterator[tuple[str, Path, Mark]]:
    if isinstance(node, Leaf) and isinstance(node.value, str):
        yield node.value, path, node.mark
    elif isinstance(node, Items):
        for index, item in enumerate(node.items):
            yield from _leaves(item, (*path, index))


def _way_out(kind: str, reference: Ref) -> str:
    """Return what to write where an obstacle is taken for something that moves or tips, or a robot for a spot."""
    if reference.instead and kind in reference.instead_of:
        return f"; {reference.instead}"
    if kind != "fixed obstacle" or "obstacle" not in reference.kinds:
        return ""
    if "spot" in reference.kinds:
        return ": with movable: true it is an entity, and a spot of the same place can stand for it"
    return ", which can move: with movable: true it is one"


def _a(noun: str) -> str:
    if noun == "walls":
        return "the walls"
    return f"an {noun}" if noun[0] in "aeiou" else f"a {noun}"
