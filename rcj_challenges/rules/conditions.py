"""Conditions: levels, what must hold when a trigger fires."""

from collections.abc import Callable, Mapping
from math import pi
from typing import Annotated, Literal

from pydantic import Field, StringConstraints

from rcj_challenges.facts.messages import MOST_LETTERS, READS, is_said
from rcj_challenges.rules.base import Phrases, Word
from rcj_challenges.rules.fields import Name, Names, NotNegative, Point, Scalar, Strict, described
from rcj_challenges.rules.phrasing import listed, number
from rcj_challenges.rules.refs import (
    DRAW,
    ENTITIES,
    FLAG,
    MEASURED_TO,
    MOVING,
    READABLE,
    ROBOTS,
    SEEN,
    SEQUENCE,
    SPOTS,
    THING,
    TIMER,
    WHOSE_OF,
    ZONES,
    DrawnValue,
    Ref,
)
from rcj_challenges.rules.values import Bound, CounterValue, DrawValue, HighestOfOthers, LowestOfOthers

SaidText = Annotated[
    str,
    StringConstraints(min_length=1, max_length=MOST_LETTERS, pattern=r"^[^\s]+( [^\s]+)*$"),
    Field(description="text as a robot says it, with single blanks between its words"),
]
Said = SaidText | int | float
"""What a robot may say."""


class AtLeast(Strict):
    """At least so many of a group."""

    at_least: int = described(..., "how many", ge=1)


Quantifier = Annotated[
    Literal["any", "all", "none"] | AtLeast,
    Field(union_mode="left_to_right", description="how many of a group: any, all, none, {at_least: n}"),
]


class _Condition(Word):
    KEY = "condition"

    negate: bool = described(False, "True: the opposite must hold")

    def about(self) -> Names | None:
        """Return what it is about, if that is one name or list: the entities whose place it reads."""
        return None

    def is_always(self) -> bool:
        """Return whether it holds at any time."""
        return False

    def is_several(self) -> bool:
        """Return whether it is made of more than one condition."""
        return False

    def compares_with_counter(self) -> bool:
        """Return whether it compares with a counter, or with those of others."""
        return False


class _Compared(_Condition):
    at_least: Bound | None = described(
        None, "holds from this value on; a number, {counter: NAME}, {lowest: NAME} or {highest: NAME}"
    )
    at_most: Bound | None = described(
        None, "holds up to this value; a number, {counter: NAME}, {lowest: NAME} or {highest: NAME}"
    )
    equals: Bound | None = described(
        None, "holds at this value only; a number, {counter: NAME}, {lowest: NAME} or {highest: NAME}"
    )

    def compares_with_counter(self) -> bool:
        """Return whether it compares with a counter, or with those of others."""
        bounds = (self.at_least, self.at_most, self.equals)
        return any(isinstance(bound, CounterValue | LowestOfOthers | HighestOfOthers) for bound in bounds)


class InZone(_Condition):
    """Whether an entity's centre is in a zone; off the field it is in none."""

    ASKS_WHERE = True

    condition: Literal["in_zone"]
    entity: Annotated[Names, ENTITIES] = described(..., "an entity, each, or a group with `of`")
    zone: Annotated[Names, ZONES] = described(
        ..., "a zone, each, or a draw's name; with a list or group: in any of them"
    )
    of: Quantifier = described("any", "how many of a group must be in")

    def about(self) -> Names | None:
        """Return what it is about, if that is one name or list: the entities whose place it reads."""
        return self.entity


class Speed(_Compared):
    """How fast an entity's centre moves, in m/s (path of the last tick over its time)."""

    condition: Literal["speed"]
    entity: Annotated[Names, ENTITIES] = described(..., "an entity, each, or a group with `of`")
    of: Quantifier = described("any", "how many of a group must satisfy it")

    def about(self) -> Names | None:
        """Return what it is about, if that is one name or list: the entities whose place it reads."""
        return self.entity


class Distance(_Compared):
    """How far an entity's centre is from another thing, a place or a point, in m; off the field none holds."""

    ASKS_WHERE = True

    condition: Literal["distance"]
    entity: Annotated[
        Names,
        Ref(
            "entity",
            MOVING,
            groups=True,
            each=True,
            instead="name the obstacle in 'to', and in 'entity' who comes near it",
        ),
    ] = described(..., "an entity, each, or a group with `of`")
    to: Annotated[Name | Point, MEASURED_TO] = described(
        ...,
        "an entity, a fixed obstacle (to its centre, to a wall's middle line), each, a spot, a gate or zone (to its "
        "nearest point; inside a zone it is 0), a draw's name, a group (the nearest of it), or [x, y] in m",
    )
    of: Quantifier = described("any", "how many of a group must satisfy it")

    def about(self) -> Names | None:
        """Return what it is about, if that is one name or list: the entities whose place it reads."""
        return self.entity


class WayIs(_Compared):
    """How far an entity has driven or rolled in this half, in m; where rules put it is no way. Also off the field."""

    condition: Literal["way"]
    entity: Annotated[Names, ENTITIES] = described(..., "an entity, each, or a group with `of`")
    of: Quantifier = described("any", "how many of a group must satisfy it")


class Looks(_Condition):
    """Whether a robot looks towards something, or in a direction; off the field nobody looks or is looked at."""

    condition: Literal["looks"]
    entity: Annotated[Names, ROBOTS] = described(..., "a robot, each, or a group with `of`")
    towards: Annotated[Name | Point | None, SEEN] = described(
        None, "an entity, a fixed obstacle, each, a spot, a draw's name, or [x, y] in m"
    )
    heading_rad: float | None = described(
        None, "instead of towards: a direction of the field in rad, counter-clockwise from +x"
    )
    within_rad: float = described(0.2, "how far its front may point past it, to either side, in rad", gt=0, le=pi)
    of: Quantifier = described("any", "how many of a group must do so")

    def about(self) -> Names | None:
        """Return what it is about, if that is one name or list: the entities whose place it reads."""
        return self.entity


class IsHeld(_Condition):
    """Whether a robot is held, by a rule or because the phase holds all robots; also off the field."""

    condition: Literal["held"]
    entity: Annotated[Names, ROBOTS] = described(..., "a robot, each, or a group with `of`")
    of: Quantifier = described("any", "how many of a group must be held")


class CounterIs(_Compared):
    """The value of a counter, or of an entrant's score."""

    condition: Literal["counter"]
    counter: Annotated[Name, READABLE] = described(..., "a counter, or an entrant: its score")
    entity: Annotated[Names | None, WHOSE_OF] = described(
        None,
        "for a counter kept per entity: whose; each: the current one; left out, without for_each: the sum; "
        "with `of` also a group or a list",
    )
    of: Quantifier | None = described(
        None, "how many of a group must satisfy it; entity left out: of all that have one"
    )


class FlagIs(_Condition):
    """Whether a flag is set."""

    condition: Literal["flag"]
    flag: Annotated[Name, FLAG] = described(..., "a flag")
    entity: Annotated[Names | None, WHOSE_OF] = described(
        None,
        "for a flag kept per entity: whose; each: the current one; left out, without for_each: any of them; "
        "with `of` also a group or a list",
    )
    of: Quantifier | None = described(
        None, "how many of a group must satisfy it; entity left out: of all that have one"
    )


class Drawn(_Condition):
    """What a draw decided."""

    condition: Literal["drawn"]
    draw: Annotated[Name, DRAW] = described(..., "a draw")
    equals: Annotated[Scalar, DrawnValue()] = described(
        ...,
        "the value it must have; each: the name of the one for whom the rule is (for_each); other: of the one touched",
    )


class TimerIs(_Compared):
    """How long a timer has run, in s; without a comparison: whether it is running (run out, it is not)."""

    condition: Literal["timer"]
    timer: Annotated[Name, TIMER] = described(..., "a timer")
    entity: Annotated[Names | None, WHOSE_OF] = described(
        None,
        "for a timer kept per entity: whose; each: the current one; left out, without for_each: the longest; "
        "with `of` also a group or a list",
    )
    of: Quantifier | None = described(
        None, "how many of a group must satisfy it; entity left out: of all that have one"
    )


class LastTouch(_Condition):
    """Which robot touched something last, since it was put where it is."""

    condition: Literal["last_touch"]
    entity: Annotated[Name, THING] = described("ball", "what was touched: an entity, a fixed obstacle, or each")
    by: Annotated[Names, ROBOTS] = described(..., "a robot, each, or a group: any of them")

    def about(self) -> Names | None:
        """Return what it is about, if that is one name or list: the entities whose place it reads."""
        return self.entity


class Message(Strict):
    """What a message of a robot must be."""

    text: Said | Annotated[tuple[Said, ...], Field(strict=False, min_length=1)] | DrawValue | None = described(
        None,
        "what it must say: text, a number, a list of which it must be one, or {draw: NAME}: what that has decided; "
        "without the blanks around it; left out: anything",
    )
    is_a: Literal["number", "position"] | None = described(
        None, "number: it must be one number; position: two numbers, x and y in m, 10 at most; left out: anything"
    )

    def matcher(self, draws: Mapping[str, Scalar]) -> Callable[[str], bool]:
        """Return what decides whether a message is as it must be.

        Args:
            draws: the value of each draw; read when a message comes.
        """
        text, parse = self.text, READS[self.is_a]

        def wanted() -> tuple[Scalar, ...]:
            if isinstance(text, DrawValue):
                return (draws[text.draw],)
            return text if isinstance(text, tuple) else (text,) if text is not None else ()

        def matches(message: str) -> bool:
            if parse(message) is None:
                return False
            return text is None or any(is_said(message, one) for one in wanted())

        return matches

    def said(self, phrases: Phrases) -> str:
        """Return what the message must be: ``“FOUND”``, ``2``, ``a number``; an empty text if it may be anything."""
        if isinstance(self.text, DrawValue):
            return phrases.what_drawn(self.text.draw)
        if self.text is not None:
            wanted = self.text if isinstance(self.text, tuple) else (self.text,)
            return listed([number(one) if isinstance(one, int | float) else f"“{one}”" for one in wanted], "or")
        return {None: "", "number": "a number", "position": "a position (two numbers, x and y in m)"}[self.is_a]


class Told(_Condition, Message):
    """What a robot has told the referee by radio, the last time in this half; before that nothing holds.

    Without `text` and `is_a`: whether it has told anything.
    """

    condition: Literal["told"]
    entity: Annotated[Names, ROBOTS] = described(..., "a robot, each, or a group with `of`")
    of: Quantifier = described("any", "how many of a group must have said so")


class SpotFree(_Condition):
    """Whether a spot is free."""

    condition: Literal["spot_free"]
    spot: Annotated[Names, SPOTS] = described(..., "a spot, or a group with `of`")
    of: Quantifier = described("any", "how many of a group must be free")
    clearance_m: NotNegative = described(0.08, "free: no robot's or ball's centre within this, in m")


class SequenceAt(_Condition):
    """At which step a sequence stands."""

    condition: Literal["sequence_at"]
    sequence: Annotated[Name, SEQUENCE] = described(..., "a sequence")
    entity: Annotated[Names | None, ENTITIES] = described(
        None,
        "for a sequence kept per entity: whose; each: the current one; left out, without for_each: any of them; "
        "with `of` also a group or a list",
    )
    of: Quantifier | None = described(
        None, "how many of a group must stand there; entity left out: of all that have one"
    )
    step: Annotated[Name, Ref("zone or gate", frozenset({"zone", "gate"}), each=True)] = described(
        ..., "the zone or gate reached last, or each"
    )


class HalfIs(_Condition):
    """Which half of the match is played."""

    condition: Literal["half"]
    at_least: int | None = described(None, "holds from the half of this number on", ge=1)
    at_most: int | None = described(None, "holds up to the half of this number", ge=1)
    equals: int | None = described(None, "holds in the half of this number only", ge=1)

    def is_always(self) -> bool:
        """Return whether it holds at any time: in some half, as rules say it that count time."""
        return self.at_least == 1 and self.at_most is None and not self.negate


Single = (
    InZone
    | Speed
    | Distance
    | WayIs
    | Looks
    | IsHeld
    | CounterIs
    | FlagIs
    | Drawn
    | TimerIs
    | LastTouch
    | Told
    | SpotFree
    | SequenceAt
    | HalfIs
)


class AnyOf(_Condition):
    """Whether at least one of several conditions holds."""

    condition: Literal["any_of"]
    conditions: "tuple[Annotated[Single | AllOf, Field(discriminator='condition')], ...]" = Field(
        ...,
        strict=False,
        min_length=1,
        description="the conditions, each as in a rule; all_of may be one of them, any_of itself not",
    )

    def is_several(self) -> bool:
        """Return whether it is made of more than one condition."""
        return len(self.conditions) > 1


class AllOf(_Condition):
    """Whether all of several conditions hold; those of a rule must all hold anyway."""

    condition: Literal["all_of"]
    conditions: tuple[Annotated[Single | AnyOf, Field(discriminator="condition")], ...] = Field(
        ...,
        strict=False,
        min_length=1,
        description="the conditions, each as in a rule; any_of may be one of them, all_of itself not",
    )

    def is_several(self) -> bool:
        """Return whether it is made of more than one condition."""
        return len(self.conditions) > 1


Condition = Annotated[Single | AnyOf | AllOf, Field(discriminator="condition")]
