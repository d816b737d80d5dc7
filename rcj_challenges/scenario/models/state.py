"""Sections ``draws``, ``counters``, ``flags``, ``timers``, ``sequences``, ``phases``; and the values rules can name."""

from typing import Annotated, Any, Literal

from pydantic import Discriminator, Field, Tag

from rcj_challenges.scenario.models.base import DurationS, Name, Scalar, Strict, described


class Draw(Strict):
    """What chance decides at the start of a half, and again on every ``draw`` action."""

    values: tuple[Scalar, ...] = Field(..., strict=False, min_length=1, description="the values, equally likely")
    not_last: bool = described(False, "True: never the same value twice running")
    keep: Literal["half", "match"] = described("half", "match: the value lives on in the next half, undrawn")


class Counter(Strict):
    """A number that rules count up and down. Scores are readable like counters, under the entrant's name.

    Both are exact to 9 decimals, as on paper: three times 0.1 is 0.3.
    """

    initial: float = described(0.0, "value at the start of a half")
    per: Name | None = described(None, "a group: one counter for each of its members")


class Flag(Strict):
    """A yes or no that rules set."""

    initial: bool = described(False, "value at the start")
    per: Name | None = described(None, "a group: one flag for each of its members")
    keep: Literal["half", "match"] = described("half", "match: the value lives on in the next half")


class Timer(Strict):
    """A clock that rules start and stop; it expires once when it reaches its length."""

    lasts_s: DurationS = described(..., "its length in s")
    per: Name | None = described(None, "a group: one timer for each of its members")
    starts: bool = described(False, "True: it runs from the start of the half")


class AnyStep(Strict):
    """A step that several places satisfy."""

    any_of: tuple[Name, ...] = Field(..., strict=False, min_length=1, description="zones or gates")


class Sequence(Strict):
    """Steps to be made in order: zones are entered, gates are crossed forward.

    It begins anew when it is complete (a cyclic one goes on), when the action `sequence` says so, and when a rule puts
    its entity somewhere or takes it off the field.
    """

    entity: Name = described(..., "whose way is followed")
    steps: tuple[Name | AnyStep, ...] = Field(..., strict=False, min_length=2, description="zones or gates in order")
    cyclic: bool = described(False, "True: complete on re-entering the first step, and begins again there")
    wrong_step: Literal["break", "ignore"] = described(
        "ignore",
        "what another of its steps does that is neither the last reached nor the next: ignore: nothing; "
        "break: after the first step, the sequence begins anew",
    )


class Phase(Strict):
    """A time in which only the rules that live in it run. ``play`` always exists."""

    lasts_s: DurationS | None = described(
        None, "after this time in s the next phase is entered; left out: until a rule"
    )
    next: Name = described("play", "the phase that follows")
    waiting_for_kickoff: bool = described(False, "what programs are told meanwhile")
    clock: Literal["runs", "stops"] = described("runs", "whether the time of the half goes on")


class CounterValue(Strict):
    """The value of a counter, or an entrant's score."""

    counter: Name = described(..., "a counter, or an entrant: its score")
    entity: Name | None = described(
        None, "for a counter kept per entity: whose; each: the current one; left out, without for_each: the sum"
    )


class FlagValue(Strict):
    """The value of a flag, true or false."""

    flag: Name = described(..., "a flag")
    entity: Name | None = described(
        None, "for a flag kept per entity: whose; each: the current one; left out, without for_each: any of them"
    )


class DrawValue(Strict):
    """What a draw decided."""

    draw: Name = described(..., "a draw")


class WordValue(Strict):
    """A fact of the match by its word."""

    word: Literal[
        "robot_name", "entity_name", "team_name", "entrant", "score", "halftime", "match_id", "total_match_time_s",
        "time_s", "time_left_s", "measured", "limit", "phase", "seed_id",
    ] = described(..., "the word; measured and limit are those of the trigger (of holds: in s)")  # fmt: skip
    of: Name | None = described(None, "for team_name and score: the entrant; left out: that of the current entity")


class PositionValue(Strict):
    """Where an entity is when the rule fires: [x, y, yaw] in m and rad; null while it is off the field.

    Placements are carried out after all actions of the tick: what this rule places is told where it was before.
    """

    position_of: Name = described(..., "an entity")


def _which_value(value: Any) -> str | None:
    keys = ("counter", "flag", "draw", "word", "position_of")
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
    | Annotated[PositionValue, Tag("position_of")],
    Discriminator(_which_value),
]


class NumberDraw(DrawValue):
    """What a draw decided, for a draw whose values are all numbers."""

    draw: Name = described(..., "a draw of numbers")


class NumberWord(WordValue):
    """A number of the match by its word; times count in whole seconds, rounded down, so that scores stay exact."""

    word: Literal[
        "score", "halftime", "total_match_time_s", "time_s", "time_left_s", "measured", "limit"
    ] = described(..., "the word; measured and limit keep their fraction, 0 if nothing was measured")  # fmt: skip
    of: Name | None = described(None, "for score: the entrant; left out: that of the current entity")


class WeightedCounter(CounterValue):
    """A part of a score: the value of a counter times a weight."""

    counter: Name = described(..., "a counter, or an entrant: its score")
    entity: Name | None = described(
        None, "for a counter kept per entity: whose; each: the current one; left out: the sum"
    )
    weight: float = described(1.0, "points for each")


class WeightedFlag(FlagValue):
    """A part of a score: points if a flag is set."""

    flag: Name = described(..., "a flag")
    entity: Name | None = described(
        None, "for a flag kept per entity: whose; each: the current one; left out: any of them"
    )
    weight: float = described(1.0, "points if it is true")


class WeightedDraw(NumberDraw):
    """A part of a score: the number that a draw decided times a weight."""

    weight: float = described(1.0, "points for each")


class WeightedWord(NumberWord):
    """A part of a score: a number of the match times a weight; times in whole seconds, rounded down."""

    weight: float = described(1.0, "points for each")


def _which_part(value: Any) -> str | None:
    which = _which_value(value)
    return which if which in ("counter", "flag", "draw", "word") else None


Part = Annotated[
    Annotated[WeightedCounter, Tag("counter")]
    | Annotated[WeightedFlag, Tag("flag")]
    | Annotated[WeightedDraw, Tag("draw")]
    | Annotated[WeightedWord, Tag("word")],
    Discriminator(_which_part),
]


def _which_number(value: Any) -> str | None:
    if isinstance(value, (list, tuple)):
        return "parts"
    which = _which_value(value)
    return "number" if which == "literal" else which


Bound = Annotated[
    Annotated[int | float, Tag("number")] | Annotated[CounterValue, Tag("counter")],
    Discriminator(lambda value: "counter" if isinstance(value, (dict, CounterValue)) else "number"),
]
"""What is compared with."""
Amount = Annotated[
    Annotated[int | float, Tag("number")]
    | Annotated[CounterValue, Tag("counter")]
    | Annotated[FlagValue, Tag("flag")]
    | Annotated[NumberDraw, Tag("draw")]
    | Annotated[NumberWord, Tag("word")],
    Discriminator(_which_number),
]
"""How much is counted."""
Points = Annotated[
    Annotated[int | float, Tag("number")]
    | Annotated[CounterValue, Tag("counter")]
    | Annotated[FlagValue, Tag("flag")]
    | Annotated[NumberDraw, Tag("draw")]
    | Annotated[NumberWord, Tag("word")]
    | Annotated[tuple[Part, ...], Field(strict=False), Tag("parts")],
    Discriminator(_which_number),
]
"""How many points are given."""
