"""What a scenario's names stand for, as parts of sentences: one thing, one of several, all of several."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from rcj_challenges.rules.fields import Names, Scalar
from rcj_challenges.rules.phrasing import Subject, listed, plain, quoted, quoted_measure
from rcj_challenges.rules.quantifier import AtLeast
from rcj_challenges.scenario.catalogue import BOUND, OTHER
from rcj_challenges.scenario.followed import followed
from rcj_challenges.scenario.halves import clock_may_stop
from rcj_challenges.scenario.models.scenario import Rule, Scenario
from rcj_challenges.scenario.other import names_other, others_of
from rcj_challenges.scenario.roster import WALLS, Roster, row_of, written_for
from rcj_challenges.scenario.set_draws import set_from_the_start
from rcj_challenges.views.sheet.absent import taken_off
from rcj_challenges.views.sheet.meeting import may_meet
from rcj_challenges.views.sheet.mirrored import mirrored_layout_words

_MEASURED_BY_SEVERAL = "what was measured"
"""Said where triggers of one rule measure different things."""

_MOST_NAMED = 4
"""Of a draw that decides among more places than this the sheet's list of draws says which."""

_LETTERS = 2
"""A name of so few letters is no word that an article could stand before: `a`, `nw`."""

_GROUPS_OF_ALL = ("robots", "balls", "obstacles")
_WITHOUT_ARTICLE = frozenset(
    ("a", "above", "all", "an", "another", "any", "around", "at", "behind", "below", "beside", "between", "beyond",
     "both", "each", "every", "far", "here", "in", "inside", "my", "near", "no", "not", "off", "on", "our", "out",
     "outside", "over", "some", "that", "this", "under")
)  # fmt: skip
"""What a name may begin with so that no article fits before it: ``outside_the_circle``, ``another_corner``."""


def _quoted_kept(kind: str, name: str) -> str:
    return quoted_measure(name) if kind == "counter" else quoted(name)


class Nouns:
    """Knows of each name of a scenario what it names, and says it with the article that belongs to it.

    Args:
        scenario: the scenario; its references have been checked.
        roster: its roster.
        other: what ``other`` is in the rule that is told.
        each: over what that rule goes, or None.
        measured: what the triggers of that rule measure.
        set_draws: what `set_from_the_start` finds, if that is known.
    """

    def __init__(
        self,
        scenario: Scenario,
        roster: Roster,
        other: str = "what is touched",
        each: str | None = None,
        measured: str = _MEASURED_BY_SEVERAL,
        set_draws: frozenset[str] | None = None,
    ) -> None:
        self.scenario = scenario
        self.roster = roster
        self.other = other
        self.each = each
        self.measured = measured
        self._set_draws = set_from_the_start(scenario) if set_draws is None else set_draws

    def within(self, rule: Rule) -> Nouns:
        """Return the nouns of one rule, which know what ``each``, ``other`` and ``measured`` are there."""
        other = self._touched(rule) if names_other(rule, self.scenario) else self.other
        measured = {trigger.MEASURED or _MEASURED_BY_SEVERAL for trigger in rule.triggers}
        only = measured.pop() if len(measured) == 1 else _MEASURED_BY_SEVERAL
        return Nouns(self.scenario, self.roster, other, rule.for_each, only, self._set_draws)

    def _touched(self, rule: Rule) -> str:
        """Return what ``other`` is in a rule: ``the robot it touches``."""
        others = others_of(rule, rule.for_each, self.roster)
        if len(others) == 1:
            return self.thing(others[0])
        kind = self.one_kind(others)
        # "It" is whom a rule goes over. Where somebody else touches, nobody is.
        active = all(getattr(trigger, "entity", None) == "each" for trigger in rule.triggers)
        if active and rule.for_each is not None and self.stands_fast(rule.for_each):
            return f"{f'the {kind} that' if kind else 'what'} touches it"
        thing = f"the {kind}" if kind else "what" if active else "what is"
        return f"{thing} {'it touches' if active else 'touched'}"

    def stands_fast(self, names: Names) -> bool:
        """Return whether names stand for nothing but fixed obstacles; ``each`` is what the rule goes over."""
        members = self.roster.expand(written_for(names, self.each))
        return all(name in self.scenario.obstacles and name not in self.roster.entities for name in members)

    def one_kind(self, names: Names) -> str:
        """Return of what kind things are; an empty text if they are of several, or of none."""
        kinds = {_kind(self.scenario, name) for name in self.roster.expand(names)}
        return kinds.pop() if len(kinds) == 1 else ""

    def thing(self, name: str) -> str:
        """Return one thing: ``Y1``, ``the ball``, ``gate 1``, ``the spot “centre”``; ``each`` is ``it``."""
        scenario = self.scenario
        if name == "each":
            return "it"
        if name == OTHER:
            return self.other
        if name == WALLS:
            return "a wall"
        kind = _kind(scenario, name)
        first = name.lower().partition("_")[0]
        bare = kind in ("ball", "obstacle", "gate", "spot") and kind not in name.lower()
        bare = bare or (len(name) <= _LETTERS and kind not in ("", "robot"))
        if bare or (kind not in ("", "robot") and first in _WITHOUT_ARTICLE) or self._one_like_others(name, kind):
            return f"the {kind} {quoted(name)}"
        if name in scenario.draws:
            return self._place_drawn(name) or self.what_drawn(name)
        # A name with a number, as most robots have one, is said without article.
        proper = kind in ("", "robot") or first == "the" or any(character.isdigit() for character in name)
        return plain(name) if proper else f"the {plain(name)}"

    def is_set(self, draw: str) -> bool:
        """Return whether a draw is what rules set, from the start of each half, and nothing that chance decides."""
        return draw in self._set_draws

    def what_drawn(self, draw: str) -> str:
        """Return what a draw decided: ``what was drawn as “target”``, of one that rules set ``what “king” is``."""
        name = quoted_measure(draw)
        return f"what {name} is" if self.is_set(draw) else f"what was drawn as {name}"

    def _place_drawn(self, draw: str) -> str:
        """Return what a draw decides on: ``the gate drawn as “door” (gate 1 or gate 2)``, ``the spot drawn as “a”``."""
        among = self.roster.drawn.get(draw, ())
        kind, drawn = self.one_kind(among), f"{'that is' if self.is_set(draw) else 'drawn as'} {quoted(draw)}"
        if kind not in ("zone", "gate"):
            return f"the {kind} {drawn}" if kind else ""
        named = f" ({listed([self.thing(one) for one in among], 'or')})" if len(among) <= _MOST_NAMED else ""
        return f"the {kind} {drawn}{named}"

    def drawn(self, draw: str, written: Scalar) -> str:
        """Return a value of a draw: ``“west”``; of a name that the rule has whom it stands for: ``it``."""
        if isinstance(written, str) and written in BOUND and written not in self.scenario.draws[draw].values:
            return self.thing(written)
        return quoted(str(written).lower() if isinstance(written, bool) else str(written))

    def any_of(self, names: Names) -> str:
        """Return the one of several that a rule is about: ``one of the robots``, ``Y1 or Y2``."""
        return listed([f"one of {self._group(name)}" if self._several(name) else self._one(name)
                       for name in row_of(names)], "or")  # fmt: skip

    def another_of(self, names: Names, than: Names) -> str:
        """Return the one of several that somebody else meets: ``another of the robots``, if that is a robot as well."""
        group, first = row_of(names), {member for name in row_of(than) for member in self.meant(name)}
        if len(group) > 1 or not first or not first <= set(self.meant(group[0])) or not self._several(group[0]):
            return self.any_of(names)
        same = first == set(self.meant(group[0]))
        return f"another of {'them' if same else self._group(group[0])}"

    def all_of(self, names: Names) -> Subject:
        """Return several together: ``the blue robots and Y3``, which is plural."""
        parts = [self._group(name) if self._several(name) else self._one(name) for name in row_of(names)]
        return Subject(listed(parts, "and"), plural=len(parts) > 1 or self._several(row_of(names)[0]))

    def each_of(self, names: str) -> str:
        """Return what a rule goes over: ``each of the robots``; of a group of one its only member."""
        return f"each of {self._group(names)}" if self._several(names) else self._one(names)

    def quantified(self, of: Any, names: Names, *, negate: bool) -> Subject:
        """Return how many of several must do something: ``none of the robots``; negated, the opposite of it."""
        single = names if isinstance(names, str) else names[0] if len(names) == 1 else None
        if single is not None and not self._several(single):
            return Subject(self._one(single), negated=negate != (of == "none"))
        several = self.all_of(names).text
        if isinstance(of, AtLeast):
            return Subject(f"{'fewer than' if negate else 'at least'} {of.at_least} of {several}", plural=True)
        if isinstance(names, tuple) and len(names) == 2 and not any(map(self._several, names)):
            return self._of_two(of, names, negate=negate)
        if of == "all":
            return Subject(f"{'not all' if negate else 'all'} of {several}", plural=True)
        return Subject(f"{'any' if (of == 'any') != negate else 'none'} of {several}")

    def of_those_there(self, of: Any, names: Names, *, negate: bool) -> Subject:
        """Return the same where nothing is asked of who is off the field: “all” is all that are on it."""
        who = self.quantified(of, names, negate=negate)
        if of != "all" or not who.plural or not self.may_be_off(names):
            return who
        two = isinstance(names, tuple) and len(names) == 2 and not any(map(self._several, names))
        return replace(who, text=f"{who.text} {'(of those on the field)' if two else 'on the field'}")

    def may_be_off(self, names: Any) -> bool:
        """Return whether a rule takes any of what names stand for off the field; of a point none does."""
        return not self._all_meant(names).isdisjoint(taken_off(self.scenario, self.roster))

    def _all_meant(self, names: Any) -> set[str]:
        return {one for name in row_of(names) for one in self.meant(name)} if names is not None else set()

    def _of_two(self, of: str, names: Names, *, negate: bool) -> Subject:
        """Return how many of two single things must do something: ``both the ball and Y1``, ``neither Y1 nor Y2``."""
        first, second = map(self._one, names)
        if of == "all":
            return Subject(f"{'not ' if negate else ''}both {first} and {second}", plural=True)
        return Subject(f"{first} or {second}" if (of == "any") != negate else f"neither {first} nor {second}")

    def point(self, at: Any, measured_from: Any = None) -> str:
        """Return a named thing or a point ``(x, y)``; of a group the nearest of it is meant.

        Args:
            at: the thing, the group or the point.
            measured_from: whose distance to it is told; nothing is measured to itself.
        """
        if not isinstance(at, str):
            return f"({at[0] + 0.0:g}, {at[1] + 0.0:g})"  # adding 0 makes no -0
        if not self._several(at):
            return self._one(at)
        own = self._all_meant(measured_from) & set(self.meant(at))
        return f"the nearest {'other one ' if own else ''}of {self._group(at)}"

    def off_as_a_whole(self, at: Any, measured_from: Any = None) -> Subject | None:
        """Return what must be off the field for nothing to be measured to it; None: some of it is always on it.

        Args:
            at: the thing, the group or the point; of a group any other one counts.
            measured_from: whose distance to it is told.
        """
        meant, own = set(self.meant(at)), self._all_meant(measured_from)
        others = meant - own if len(own) == 1 else meant
        gone = taken_off(self.scenario, self.roster)
        if not isinstance(at, str) or others.isdisjoint(gone):
            return None
        if not self._several(at):
            return Subject(self._one(at))
        if not others <= gone:
            return None
        return Subject(f"all of {'the others' if own & meant else self._group(at)}", plural=True)

    def meant(self, at: Any) -> tuple[str, ...]:
        """Return the names for which a name may stand; none for a point."""
        if not isinstance(at, str):
            return ()
        return self.roster.may_be(written_for(at, self.each))

    def owned(self, what: str, names: Names, name: str = "") -> str:
        """Return what belongs to one of several: ``its program``, ``the timer “rest” of one of the robots``."""
        thing = f"{what} {quoted(name)}" if name else what
        return f"its {thing}" if names == "each" else f"the {thing} of {self.any_of(names)}"

    def kept(self, kind: str, name: str, entity: str | None) -> str:
        """Return a counter, flag, timer or sequence with whose it is: ``the counter “laps” of Y1``, ``its flag “out”``.

        Without an entity, what is kept for each of several is read as one: counters as their sum, flags as any of them.
        """
        if kind == "counter" and name in self.scenario.entrants:
            return f"the score of {plain(name)}"
        if entity == "each":
            return f"its {kind} {_quoted_kept(kind, name)}"
        owners = None if entity else self.owners(kind, name)
        if owners is not None:
            of = self.all_of(owners).text
            return (
                f"the sum of the counters {_quoted_kept(kind, name)} of {of}"
                if kind == "counter"
                else (f"the {kind} {_quoted_kept(kind, name)} of any of {of}")
            )
        return f"the {kind} {_quoted_kept(kind, name)}" + (f" of {self.thing(entity)}" if entity else "")

    def owners(self, kind: str, name: str) -> str | None:
        """Return the group of which each has a counter, flag, timer or sequence of its own; None for a single one."""
        one = getattr(self.scenario, f"{kind}s").get(name)
        return one.per if one is not None and one.per is not None and self._several(one.per) else None

    def one_of_owners(self, kind: str, name: str) -> str | None:
        """Return whose of several it is: ``each`` if the rule is for each of its owners, else the group; or None."""
        per = getattr(self.scenario, f"{kind}s")[name].per
        if per is None:
            return None
        is_own = self.each is not None and set(self.roster.expand(self.each)) <= set(self.roster.expand(per))
        return "each" if is_own else str(per)

    def sequence_of(self, sequence: str) -> str:
        """Return what a sequence follows: an entity, or the group of which each member has one of its own."""
        return followed(self.scenario.sequences[sequence])

    def timer_of(self, timer: str) -> str | None:
        """Return the group of entities of which each has a timer of its own; None where it is not kept for such."""
        per = self.scenario.timers[timer].per
        return per if per is not None and self.is_on_field(per) else None

    def timer_length_s(self, timer: str) -> float | None:
        """Return the length of a timer; None if a draw or a counter decides it."""
        lasts_s = self.scenario.timers[timer].lasts_s
        return lasts_s if isinstance(lasts_s, int | float) else None

    def is_on_field(self, name: str) -> bool:
        """Return whether a name stands for robots, balls or obstacles: zones, gates and empty groups do not."""
        return any(member in self.roster.things for member in self.roster.expand(name)[:1])

    def meeting_zones(self, names: Names) -> int:
        """Return how many zones names stand for if any two of them may meet, else 0; ``each`` and a draw are one."""
        several = dict.fromkeys(self.roster.expand(names))
        zones = [[self.scenario.zones[one] for one in self.meant(name)] for name in several]
        return len(several) if may_meet(zones) else 0

    def clock_may_stop(self) -> bool:
        """Return whether a phase stops the clock of the half."""
        return clock_may_stop(self.scenario)

    def is_entrant(self, name: str) -> bool:
        """Return whether a name is that of an entrant."""
        return name in self.scenario.entrants

    def keepers(self, kind: str, name: str) -> str:
        """Return the group of which each has a counter, flag, timer or sequence of its own."""
        return str(getattr(self.scenario, f"{kind}s")[name].per)

    def sequence_step(self, sequence: str, step: str) -> str:
        """Return a step of a sequence, with what it means if it is the last."""
        model, written = self.scenario.sequences[sequence], self.thing(step)
        *before, last = map(self.roster.expand, model.places())
        if model.cyclic or step not in last:
            return written
        # It begins again when it is complete, but what it stands at is the step that was reached last.
        also = "also when it is " if any(step in places for places in before) else ""
        return f"{written} ({also}complete, until its next step)"

    def every_kept(self, kind: str, name: str, entity: str | None) -> str:
        """Return the same for an action, where no entity means all of them."""
        one = getattr(self.scenario, f"{kind}s").get(name)
        if entity or one is None or one.per is None:
            return self.kept(kind, name, entity)
        return f"the {kind} {_quoted_kept(kind, name)} of {self.each_of(one.per)}"

    def all_but_each(self, counter: str) -> str:
        """Return whose lowest or highest counter is meant: ``all others on the field``; without ``each`` of all."""
        per = self.scenario.counters[counter].per or ""
        owners = self.roster.expand(per)
        goes_over = () if self.each is None else self.roster.expand(self.each)
        who = self.all_of(per).text if set(owners).isdisjoint(goes_over) else "all others"
        return f"{who} on the field" if owners[0] in self.roster.entities else who

    def may_be_zone(self, name: str) -> bool:
        """Return whether a name may stand for a zone."""
        return any(one in self.scenario.zones for one in self.meant(name))

    def draw_values(self, draw: str) -> tuple[Scalar, ...]:
        """Return the values of a draw."""
        return self.scenario.draws[draw].values

    def is_entity(self, name: str) -> bool:
        """Return whether a name stands for an entity, and not for a spot or a draw."""
        members = self.roster.expand(name)
        return not any(member in self.scenario.spots or member in self.scenario.draws for member in members)

    def mirrored_layout(self, action: Any) -> str:
        """Return how all places of a layout are mirrored, and what its kicks are aimed at."""
        return mirrored_layout_words(self, action)

    def kinds_of(self, names: Names) -> str:
        """Return of what kind one of several is: ``robot``, or ``robot or ball``."""
        kinds = dict.fromkeys(_kind(self.scenario, name) for name in self.roster.expand(names))
        return listed([kind for kind in kinds if kind], "or")

    def members(self, group: str) -> str:
        """Return the members of a group by name."""
        return ", ".join(map(plain, self.roster.expand(group)))

    def _one_like_others(self, name: str, kind: str) -> bool:
        """Return whether a thing is called what each of several is: “the ball” alone would be any of the balls."""
        return name.lower().removeprefix("the_") == kind and len(getattr(self.scenario, f"{kind}s")) > 1

    def _several(self, name: str) -> bool:
        return len(self.roster.expand(name)) > 1

    def _one(self, name: str) -> str:
        members = self.roster.expand(name)
        return self.thing(members[0] if len(members) == 1 else name)

    def _group(self, name: str) -> str:
        if name in self.scenario.groups:
            kind = next((_kind(self.scenario, member) for member in self.roster.expand(name)), "")
            first = name.lower().partition("_")[0]
            said = not kind or (name.endswith("s") and first not in _WITHOUT_ARTICLE)
            article = "" if first == "the" else "the "
            return f"{article}{plain(name)}" if said else f"the {kind}s {quoted(name)}"
        return f"the {plain(name)}" if name in _GROUPS_OF_ALL else f"the {plain(name)} robots"


def _kind(scenario: Scenario, name: str) -> str:
    """Return of what kind a thing of the field is; an empty text for what is none."""
    kinds = ("robot", "ball", "obstacle", "gate", "spot", "zone")
    return next((kind for kind in kinds if name in getattr(scenario, f"{kind}s")), "")
