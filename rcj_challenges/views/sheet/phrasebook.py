"""How the names of a scenario are written in sentences: one thing, one of several, all of several."""

from __future__ import annotations

from typing import Any

from rcj_challenges.core.amounts import Noun
from rcj_challenges.rules.effects import Removes
from rcj_challenges.rules.fields import Names, Scalar
from rcj_challenges.rules.phrasing import Subject, listed, plain, quoted, quoted_measure, spelled, what_drawn
from rcj_challenges.rules.quantifier import HowMany
from rcj_challenges.scenario.halves import clock_may_stop
from rcj_challenges.scenario.models.scenario import Rule, Scenario
from rcj_challenges.scenario.roster import BOUND, ENTRANTS, OTHER, WALLS, Roster, as_tuple, with_each
from rcj_challenges.scenario.rule_effects import names_other

_MEASURED_BY_SEVERAL = "what was measured"
"""Written where triggers of one rule measure different things."""

_SHORT = 2
"""A name of so few characters does not stand after an article: `a`, `nw`."""

_GROUPS_OF_ALL = ("robots", "balls", "obstacles")
_WITHOUT_ARTICLE = frozenset(
    "a all an any around at behind beside every in inside near off on our out outside over under".split()  # noqa: SIM905
)
"""First words of names before which no article fits: ``outside_the_circle``."""


class Phrasebook:
    """Writes the names of a scenario with the articles that belong to them.

    The rule decides what ``each`` and ``other`` are.
    """

    def __init__(self, scenario: Scenario, roster: Roster, rule: Rule | None = None) -> None:
        self.scenario = scenario
        self.roster = roster
        self.period = scenario.match.period
        self.each = None if rule is None else rule.for_each
        measured = {trigger.MEASURED or _MEASURED_BY_SEVERAL for trigger in rule.triggers} if rule is not None else ()
        self.measured = next(iter(measured)) if len(measured) == 1 else _MEASURED_BY_SEVERAL
        self.other = self._touched(rule) if rule is not None and names_other(rule, scenario) else "what is touched"

    def within(self, rule: Rule) -> Phrasebook:
        """Return the phrasebook of one rule."""
        return Phrasebook(self.scenario, self.roster, rule)

    def of_each(self, group: str | None) -> Phrasebook:
        """Return the phrasebook of what stands in no rule, and is read for each of a group."""
        return self.within(Rule.model_construct(for_each=group, triggers=(), actions=()))

    # --- names -------------------------------------------------------------------------------------------------------

    def thing(self, name: str) -> str:
        if name in ("each", OTHER, WALLS):
            return {"each": "its robot" if self.is_team("each") else "it", OTHER: self.other}.get(name, "a wall")
        if name in self.scenario.draws and not _kind(self.scenario, name):
            kind = self.one_kind(self.roster.drawn.get(name, ()))
            return f"the {kind} drawn as {quoted(name)}" if kind else what_drawn(name)
        kind, first = _kind(self.scenario, name), name.lower().partition("_")[0]
        if name in self.scenario.roles:
            kind = self.one_kind(self.roster.roles[name])
            return f"the {plain(name)}" if kind in ("", "robot") else f"the {kind} {quoted(name)}"
        if kind in ("", "robot"):
            return plain(name)
        is_bare = kind != "zone" and kind not in name.lower()
        if is_bare or len(name) <= _SHORT or first in _WITHOUT_ARTICLE:
            return f"the {kind} {quoted(name)}"
        is_proper = first == "the" or any(character.isdigit() for character in name)
        return plain(name) if is_proper else f"the {plain(name)}"

    def any_of(self, names: Names) -> str:
        parts = [f"one of {self._group(one)}" if self.is_several(one) else self._one(one) for one in as_tuple(names)]
        return listed(parts, "or")

    def a_member(self, name: str) -> str:
        """Return any one of several: ``a yellow robot``, ``a team``, ``one of the doors``; of one itself."""
        if name == ENTRANTS:
            return "a team"
        if not name or not self.is_several(name) or name in self.scenario.groups or self.is_team(name):
            return self.any_of(name) if name else ""
        if name in _GROUPS_OF_ALL:
            return Noun(name.removesuffix("s"), name).a
        return Noun(f"{plain(name)} robot", "").a

    def another_of(self, names: Names, than: Names) -> str:
        return "another of them" if names == than and self.is_several(as_tuple(names)[0]) else self.any_of(names)

    def all_of(self, names: Names) -> Subject:
        if isinstance(names, str) and self.is_team(names):
            return Subject(self._group(names), plural=names == "each" or len(self.roster.teams) > 2)
        if isinstance(names, str) and self.roster.is_others(names):
            own = self.roster.expand(self.each or ())[:1]
            where = " on the field" if own and own[0] in self.roster.entities else ""
            return Subject(f"all others{where}", plural=True)
        parts = [self._group(name) if self.is_several(name) else self._one(name) for name in as_tuple(names)]
        return Subject(listed(parts, "and"), plural=len(parts) > 1 or self.is_several(as_tuple(names)[0]))

    def each_of(self, names: str) -> str:
        """Return the ones that a rule is repeated for: ``each of the robots``; of a group of one its only member."""
        if self.is_team(names) and names != "each" and len(self.roster.teams) == 2:
            return self._group(names)
        return f"each of {self._group(names)}" if self.is_several(names) else self._one(names)

    def quantified(self, of: Any, names: Names, *, negate: bool) -> Subject:
        row = as_tuple(names)
        if len(row) == 1 and not self.is_several(row[0]):
            return Subject(self._one(row[0]), negated=negate != (of == "none"))
        several = self.all_of(names).text
        if isinstance(of, HowMany):
            return Subject(f"{of.describe(negate=negate)} of {several}", plural=True)
        if of == "all":
            return Subject(f"{'not all' if negate else 'all'} of {several}", plural=True)
        return Subject(f"{'any' if (of == 'any') != negate else 'none'} of {several}")

    def point(self, at: Any, measured_from: Any = None) -> str:
        if not isinstance(at, str):
            return f"({at[0] + 0.0:g}, {at[1] + 0.0:g})"  # adding 0 makes no -0
        if not self.is_several(at):
            return self._one(at)
        own = {one for name in as_tuple(measured_from or ()) for one in self.may_be(name)} & set(self.may_be(at))
        return f"the nearest {'other one ' if own else ''}of {self._group(at)}"

    def owned(self, what: str, names: Names, name: str = "") -> str:
        thing = f"{what} {quoted(name)}" if name else what
        return f"its {thing}" if names == "each" else f"the {thing} of {self.any_of(names)}"

    def kinds_of(self, names: Names) -> str:
        """Return of what kind one of several is: ``robot``, or ``robot or ball``."""
        kinds = dict.fromkeys(_kind(self.scenario, name) for name in self.roster.expand(names))
        return listed([kind for kind in kinds if kind], "or")

    def one_kind(self, names: Names) -> str:
        """Return of what kind things are; an empty text if they are of several, or of none."""
        kinds = {_kind(self.scenario, name) for name in self.roster.expand(names)}
        return kinds.pop() if len(kinds) == 1 else ""

    def may_be(self, at: Any) -> tuple[str, ...]:
        """Return the names for which a name may stand; none for a point."""
        return self.roster.may_be(with_each(at, self.each)) if isinstance(at, str) else ()

    def is_on_field(self, name: str) -> bool:
        """Return whether a name stands for robots, balls or obstacles: zones, gates and empty groups do not."""
        return any(member in self.roster.things for member in self.roster.expand(name)[:1])

    def entrant(self, name: str) -> str:
        if name in self.scenario.entrants:
            return plain(name)
        if name == ENTRANTS:
            return "each team"
        if name in self.scenario.roles:
            is_team = set(self.roster.roles[name]) <= set(self.roster.teams)
            return self.thing(name) if is_team else f"the team of {self.thing(name)}"
        if self.each != ENTRANTS and self.roster.is_others(name):
            return "the other team" if len(self.scenario.entrants) == 2 else "each other team"
        if self.each != ENTRANTS or name == OTHER:
            return "its team" if name == "each" else f"the team of {self.thing(name)}"
        return "this team" if name == "each" else self._group(name)

    def is_team(self, name: str) -> bool:
        """Return whether a name of the rule stands for an entrant or for several, and so for their robots."""
        return self.each == ENTRANTS and (name == "each" or self.roster.is_others(name))

    def may_be_zone(self, name: str) -> bool:
        return any(one in self.scenario.zones for one in self.may_be(name))

    def is_entity(self, name: str) -> bool:
        members = self.roster.expand(name)
        return not any(member in self.scenario.spots or member in self.scenario.draws for member in members)

    def may_be_off(self) -> bool:
        return bool(self.scenario.effects(Removes))

    def clock_may_stop(self) -> bool:
        return clock_may_stop(self.scenario)

    # --- counters, flags, timers and sequences ------------------------------------------------------------------------

    def kept(self, kind: str, name: str, entity: Names | None) -> str:
        """Return a counter, flag, timer or sequence with whose it is: ``the counter “laps” of Y1``, ``its flag “out”``.

        Without an entity, what is kept for each of several is read as one: counters as their sum, flags as any of them.
        """
        if kind == "counter" and name in self.scenario.entrants:
            return f"the score of {plain(name)}"
        which = quoted_measure(name) if kind == "counter" else quoted(name)
        if entity is None and self.one_of_owners(kind, name) == "each":
            entity = "each"
        if entity is not None:
            if entity == "each":
                return f"its {kind} {which}"
            seats = self.scenario.entrants if self.keepers(kind, name) == ENTRANTS else ()
            owners = [plain(one) if one in seats else self.each_of(one) for one in as_tuple(entity)]
            return f"the {kind} {which} of {listed(owners, 'and')}"
        per = self.owners(kind, name)
        if per is None:
            return f"the {kind} {which}"
        several = self.all_of(per).text
        each = "the sum of the counters {} of {}" if kind == "counter" else f"the {kind} {{}} of any of {{}}"
        return each.format(which, several)

    def every_kept(self, kind: str, name: str, entity: Names | None) -> str:
        owners = None if entity or self.one_of_owners(kind, name) == "each" else self.keepers(kind, name)
        if owners is None:
            return self.kept(kind, name, entity)
        which = quoted_measure(name) if kind == "counter" else quoted(name)
        return f"the {kind} {which} of {self.each_of(owners)}"

    def keepers(self, kind: str, name: str) -> str | None:
        one = getattr(self.scenario, f"{kind}s").get(name)
        return None if one is None or one.per is None else str(one.per)

    def owners(self, kind: str, name: str) -> str | None:
        per = self.keepers(kind, name)
        return per if per is not None and self.is_several(per) else None

    def is_one_owner(self, kind: str, name: str, entity: Names) -> bool:
        if not isinstance(entity, str):
            return False
        is_opponent = self.is_team(entity) and entity != "each" and len(self.roster.teams) == 2
        is_seat = self.keepers(kind, name) == ENTRANTS and (entity in self.scenario.entrants or is_opponent)
        return is_seat or not self.is_several(entity)

    def one_of_owners(self, kind: str, name: str) -> str | None:
        per = self.keepers(kind, name)
        if per is None:
            return None
        return "each" if self.roster.keeps(self.each, per) else per

    def sequence_of(self, sequence: str) -> str:
        return self.scenario.sequences[sequence].followed

    def timer_of(self, timer: str) -> str | None:
        per = self.scenario.timers[timer].per
        return per if per is not None and self.is_on_field(per) else None

    def timer_length_s(self, timer: str) -> float | None:
        lasts_s = self.scenario.timers[timer].lasts_s
        return lasts_s if isinstance(lasts_s, int | float) else None

    # --- roles and draws ----------------------------------------------------------------------------------------------

    def holder(self, role: str, name: str) -> str:
        is_team = set(self.roster.roles[role]) <= set(self.roster.teams)
        return self.entrant(name) if is_team and name != OTHER else self.thing(name)

    def drawn(self, draw: str, written: Scalar) -> str:
        if isinstance(written, str) and written in BOUND and written not in self.scenario.draws[draw].values:
            return self.thing(written)
        return quoted(spelled(written))

    def draw_values(self, draw: str) -> tuple[Scalar, ...]:
        return self.scenario.draws[draw].values

    def phases(self) -> tuple[str, ...]:
        return tuple(dict.fromkeys(("play", *self.scenario.phases)))

    # --- what a name stands for in a rule ----------------------------------------------------------------------------

    def _touched(self, rule: Rule) -> str:
        """Return the words for ``other`` in a rule: ``the robot it touches``."""
        others = self.roster.others(rule, None)
        if len(others) == 1:
            return self.thing(others[0])
        is_touching = all(getattr(trigger, "entity", None) == "each" for trigger in rule.triggers)
        thing = f"the {self.one_kind(others)}" if self.one_kind(others) else "what" if is_touching else "what is"
        return f"{thing} {'it touches' if is_touching else 'touched'}"

    def is_several(self, name: str) -> bool:
        if self.is_team(name):
            return name != "each" or any(len(robots) > 1 for robots in self.roster.teams.values())
        return name == ENTRANTS or self.roster.is_others(name) or len(self.roster.expand(name)) > 1

    def _one(self, name: str) -> str:
        members = self.roster.expand(name)
        return self.thing(members[0] if len(members) == 1 else name)

    def _group(self, name: str) -> str:
        if self.is_team(name):
            return "its robots" if name == "each" else f"the other team{'s' if len(self.roster.teams) > 2 else ''}"
        if name == ENTRANTS:
            return "the teams"
        if self.roster.is_others(name):
            return "the others"
        if name in self.scenario.groups:
            kind, first = self.one_kind(name), name.lower().partition("_")[0]
            if kind and (not name.endswith("s") or first in _WITHOUT_ARTICLE):
                return f"the {kind}s {quoted(name)}"
            return plain(name) if first == "the" else f"the {plain(name)}"
        return f"the {plain(name)}" if name in _GROUPS_OF_ALL else f"the {plain(name)} robots"


def _kind(scenario: Scenario, name: str) -> str:
    kinds = ("robot", "ball", "obstacle", "gate", "spot", "zone")
    return next((kind for kind in kinds if name in getattr(scenario, f"{kind}s")), "")
