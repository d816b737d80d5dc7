"""Values that rules can name: what is remembered, measured, drawn or told."""

from typing import Annotated, Any, Literal

from pydantic import Discriminator, Field, Tag

from rcj_challenges.rules.fields import DurationS, Name, Point, Scalar, Strict, described
from rcj_challenges.rules.refs import (
    COUNTER,
    DRAW,
    ENTITY,
    ENTRANT,
    FLAG,
    MEASURED_TO,
    READABLE,
    ROBOT,
    SEEN,
    THING,
    TIMER,
    WHOSE,
    Ref,
)


class DrawnDuration(Strict):
    """The duration that a draw decided."""

    draw: Annotated[Name, DRAW] = described(..., "a draw whose values are durations in s")


class CounterValue(Strict):
    """The value of a counter, or an entrant's score."""

    counter: Annotated[Name, READABLE] = described(..., "a counter, or an entrant: its score")
    entity: Annotated[Name | None, WHOSE] = described(
        None, "for a counter kept per entity: whose; each: the current one; left out, without for_each: the sum"
    )


def _which_lasts(value: Any) -> str:
    if isinstance(value, dict):
        return "counter" if "counter" in value else "draw"
    return "counter" if isinstance(value, CounterValue) else "draw" if isinstance(value, DrawnDuration) else "number"


Lasts = Annotated[
    Annotated[DurationS, Tag("number")]
    | Annotated[DrawnDuration, Tag("draw")]
    | Annotated[CounterValue, Tag("counter")],
    Discriminator(_which_lasts),
]
"""How long something lasts: a timer, a phase, or what a rule does for a time."""


class FlagValue(Strict):
    """The value of a flag, true or false."""

    flag: Annotated[Name, FLAG] = described(..., "a flag")
    entity: Annotated[Name | None, WHOSE] = described(
        None, "for a flag kept per entity: whose; each: the current one; left out, without for_each: any of them"
    )


class DrawValue(Strict):
    """What a draw decided."""

    draw: Annotated[Name, DRAW] = described(..., "a draw")


class WordValue(Strict):
    """A fact of the match by its word."""

    word: Literal[
        "robot_name", "entity_name", "each_name", "other_name", "team_name", "entrant", "score", "halftime", "match_id",
        "total_match_time_s", "time_s", "time_left_s", "measured", "limit", "phase", "seed_id",
    ] = described(..., "the word; times have fractions; measured, limit: the trigger's (of holds: in s); each_name: "
                  "of the member of for_each; other_name: of the one touched, in a rule of touches")  # fmt: skip
    of: Annotated[Name | None, ENTRANT] = described(
        None, "for team_name and score: the entrant; left out: that of the current entity"
    )


class PositionValue(Strict):
    """Where an entity is when the rule fires: [x, y, yaw] in m and rad; null while it is off the field.

    Placements are carried out after all actions of the tick: what this rule places is told where it was before. A spot
    looks no way: [x, y] in m, where it is in that moment if rules set it.
    """

    position_of: Annotated[Name, SEEN] = described(..., "an entity, a fixed obstacle, each, a spot, or a draw's name")


class DistanceValue(Strict):
    """How far the centres of two things are apart, in m to the millimetre; null while one of them is off the field."""

    distance: Annotated[tuple[Name | Point, Name | Point], Field(strict=False), MEASURED_TO] = described(
        ...,
        "two of: an entity, a fixed obstacle, each, a spot, a draw's name, a group (the nearest of it), [x, y] in m; "
        "one of them may be a wall, a gate or a zone, of which the nearest point counts: inside a zone it is 0",
    )


class WayValue(Strict):
    """How far an entity has driven or rolled in this half, in m to the millimetre, from tick to tick.

    Where rules put it is no way. Since a moment: this less a counter that was set to it then.
    """

    way: Annotated[Name, ENTITY] = described(..., "an entity, or each")


class TimerValue(Strict):
    """How long a timer has run, in s with its fraction; its length less this is left, run out up to a tick under 0."""

    timer: Annotated[Name, TIMER] = described(..., "a timer")
    entity: Annotated[Name | None, WHOSE] = described(
        None, "for a timer kept per entity: whose; each: the current one; left out, without for_each: the longest"
    )


class HeldValue(Strict):
    """Whether a robot is held, by a rule or because the phase holds all robots: true or false."""

    held: Annotated[Name, Ref("robot", frozenset({"robot"}), each=True)] = described(..., "a robot, or each")


class LastTouchValue(Strict):
    """The name of the robot that touched something last since it was put where it is; null if none has."""

    last_touch: Annotated[Name, THING] = described(..., "what was touched: an entity, a fixed obstacle, or each")


class ToldValue(Strict):
    """What a robot has told the referee by radio, the last time in this half: its text; null if nothing yet."""

    told: Annotated[Name, ROBOT] = described(..., "a robot, or each")


def _which_value(value: Any) -> str | None:
    keys = ("counter", "flag", "draw", "word", "position_of", "distance", "way", "timer", "held", "last_touch", "told")
    if isinstance(value, dict):
        return next((key for key in keys if key in value), None)
    if isinstance(value, Strict):
        return next((key for key in keys if hasattr(value, key)), None)
    return "literal"


Value = Annotated[
    Annotated[Scalar, Tag("literal")]
    | Annotated[CounterValue, Tag("counter")]
    | Annotated[FlagValue, Tag("flag")]
    | Annotated[DrawValue, Tag("draw")]
    | Annotated[WordValue, Tag("word")]
    | Annotated[PositionValue, Tag("position_of")]
    | Annotated[DistanceValue, Tag("distance")]
    | Annotated[WayValue, Tag("way")]
    | Annotated[TimerValue, Tag("timer")]
    | Annotated[HeldValue, Tag("held")]
    | Annotated[LastTouchValue, Tag("last_touch")]
    | Annotated[ToldValue, Tag("told")],
    Discriminator(_which_value),
]


class NumberDraw(DrawValue):
    """What a draw decided, for a draw whose values are all numbers."""

    draw: Annotated[Name, DRAW] = described(..., "a draw of numbers")


class NumberWord(WordValue):
    """A number of the match by its word; times count in whole seconds, rounded down, or with their fraction."""

    word: Literal[
        "score", "halftime", "total_match_time_s", "time_s", "time_left_s", "measured", "limit"
    ] = described(..., "the word; measured and limit keep their fraction, 0 if nothing was measured")  # fmt: skip
    of: Annotated[Name | None, ENTRANT] = described(
        None, "for score: the entrant; left out: that of the current entity"
    )
    fraction: bool | None = described(
        None, "for times: True: with their fraction; left out: whole seconds, rounded down"
    )


class NumberTimer(TimerValue):
    """How long a timer has run, in whole seconds, rounded down, or with its fraction."""

    fraction: bool | None = described(
        None, "True: with its fraction, to the tick; left out: whole seconds, rounded down"
    )


class NumberTold(ToldValue):
    """The number that a robot has told the referee by radio, the last time in this half; 0 if it was none."""


class WeightedCounter(CounterValue):
    """A part of a score: the value of a counter times a weight."""

    counter: Annotated[Name, READABLE] = described(..., "a counter, or an entrant: its score")
    entity: Annotated[Name | None, WHOSE] = described(
        None, "for a counter kept per entity: whose; each: the current one; left out: the sum"
    )
    weight: float = described(1.0, "points for each")


class WeightedFlag(FlagValue):
    """A part of a score: points if a flag is set."""

    flag: Annotated[Name, FLAG] = described(..., "a flag")
    entity: Annotated[Name | None, WHOSE] = described(
        None, "for a flag kept per entity: whose; each: the current one; left out: any of them"
    )
    weight: float = described(1.0, "points if it is true")


class WeightedDraw(NumberDraw):
    """A part of a score: the number that a draw decided times a weight."""

    weight: float = described(1.0, "points for each")


class WeightedWord(NumberWord):
    """A part of a score: a number of the match times a weight; times in whole seconds or with their fraction."""

    weight: float = described(1.0, "points for each")


class WeightedDistance(DistanceValue):
    """A part of a score: a distance times a weight; nothing while one of the two is off the field."""

    weight: float = described(1.0, "points for each metre")


class WeightedWay(WayValue):
    """A part of a score: how far an entity has driven or rolled in this half times a weight."""

    weight: float = described(1.0, "points for each metre")


class WeightedTimer(NumberTimer):
    """A part of a score: how long a timer has run, in whole seconds or with its fraction, times a weight."""

    timer: Annotated[Name, TIMER] = described(..., "a timer")
    entity: Annotated[Name | None, WHOSE] = described(
        None, "for a timer kept per entity: whose; each: the current one; left out: the longest"
    )
    weight: float = described(1.0, "points for each second")


class WeightedTold(NumberTold):
    """A part of a score: the number that a robot has told the referee by radio times a weight."""

    weight: float = described(1.0, "points for each")


def _which_part(value: Any) -> str | None:
    which = _which_value(value)
    return "number" if which == "literal" else which


Part = Annotated[
    Annotated[int | float, Tag("number")]
    | Annotated[WeightedCounter, Tag("counter")]
    | Annotated[WeightedFlag, Tag("flag")]
    | Annotated[WeightedDraw, Tag("draw")]
    | Annotated[WeightedWord, Tag("word")]
    | Annotated[WeightedDistance, Tag("distance")]
    | Annotated[WeightedWay, Tag("way")]
    | Annotated[WeightedTimer, Tag("timer")]
    | Annotated[WeightedTold, Tag("told")],
    Discriminator(_which_part),
]


def _which_number(value: Any) -> str | None:
    return "parts" if isinstance(value, (list, tuple)) else _which_part(value)


class LowestOfOthers(Strict):
    """The lowest value that a counter kept per entity has of all others.

    Who is off the field does not count. Where nobody else is left, or `each` is off the field, no comparison holds, and
    each that is negated does.
    """

    lowest: Annotated[Name, COUNTER] = described(
        ..., "a counter kept per entity: the lowest of all but `each`; without for_each: of all"
    )


class HighestOfOthers(Strict):
    """The highest value that a counter kept per entity has of all others; see the lowest."""

    highest: Annotated[Name, COUNTER] = described(
        ..., "a counter kept per entity: the highest of all but `each`; without for_each: of all"
    )


def _which_bound(value: Any) -> str:
    if isinstance(value, dict):
        return next((key for key in ("lowest", "highest") if key in value), "counter")
    if isinstance(value, CounterValue):
        return "counter"
    if isinstance(value, LowestOfOthers):
        return "lowest"
    return "highest" if isinstance(value, HighestOfOthers) else "number"


Bound = Annotated[
    Annotated[int | float, Tag("number")]
    | Annotated[CounterValue, Tag("counter")]
    | Annotated[LowestOfOthers, Tag("lowest")]
    | Annotated[HighestOfOthers, Tag("highest")],
    Discriminator(_which_bound),
]
"""What is compared with."""
Points = Annotated[
    Annotated[int | float, Tag("number")]
    | Annotated[CounterValue, Tag("counter")]
    | Annotated[FlagValue, Tag("flag")]
    | Annotated[NumberDraw, Tag("draw")]
    | Annotated[NumberWord, Tag("word")]
    | Annotated[DistanceValue, Tag("distance")]
    | Annotated[WayValue, Tag("way")]
    | Annotated[NumberTimer, Tag("timer")]
    | Annotated[NumberTold, Tag("told")]
    | Annotated[tuple[Part, ...], Field(strict=False), Tag("parts")],
    Discriminator(_which_number),
]
"""How many points are given, and how much is counted."""
