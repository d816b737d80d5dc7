"""Actions: what a rule does when it fires."""

from typing import Annotated, Literal

from pydantic import Field

from rcj_challenges.rules.fields import EventName, Name, Names, Point, Scalar, Strict, described
from rcj_challenges.rules.places import (
    At,
    Attempts,
    ClearanceM,
    Facing,
    MayKick,
    Mirror,
    NoiseM,
    OnLine,
    Roll,
    UniformIn,
    WithoutRoom,
)
from rcj_challenges.rules.refs import (
    COUNTER,
    DRAW,
    ENTITIES,
    ENTITY,
    FIXED,
    FLAG,
    MOVING,
    PHASE,
    ROBOTS,
    SEQUENCE,
    SPOT,
    THING,
    TIMER,
    WHOSE,
    DrawnValue,
    Ref,
    SectionRef,
)
from rcj_challenges.rules.values import DrawValue, Lasts, Points, ToldValue, Value

_RECEIVER = SectionRef("entrant", ("entrants",), words=frozenset({"each", "other"}))


class LastToucher(Strict):
    """The entrant of the robot that touched something last, since it was put where it is."""

    last_touch: Annotated[Name, THING] = described(..., "what was touched: an entity, a fixed obstacle, or each")


class Score(Strict):
    """Give points to an entrant."""

    action: Literal["score"]
    entrant: Annotated[Name | LastToucher, _RECEIVER] = described(
        ...,
        "who gets them (the seat as played in this half); each: who drives the robot of for_each; other: who drives "
        "the robot touched; "
        "{last_touch: ball}: who drives the robot that touched it last since it was put where it is, else nobody",
        union_mode="left_to_right",
    )
    points: Points = described(
        1,
        "how many: a number, {counter, flag, draw, timer, way or word: NAME}, {distance: [A, B]}, or a list of which "
        "all is added: numbers, and these with weights",
    )
    at_least: float | None = described(None, "no fewer points are given than this, whatever was reckoned")
    at_most: float | None = described(None, "no more points are given than this, whatever was reckoned")
    keeps_at_least: float | None = described(
        None, "points taken away do not take the entrant's score below this; what lies below it already stays"
    )
    keeps_at_most: float | None = described(
        None, "points given do not take the entrant's score above this; what lies above it already stays"
    )


class Count(Strict):
    """Change a counter."""

    action: Literal["count"]
    counter: Annotated[Name, COUNTER] = described(..., "the counter")
    entity: Annotated[Name | None, WHOSE] = described(
        None, "for a counter kept per entity: whose; each; left out: all of them"
    )
    by: Points | None = described(
        None,
        "what is added, a number, {counter, flag, draw, timer, way or word: NAME} or {distance: [A, B]}, or a list "
        "that is added up, each with a weight; 1 if neither `by` nor `to` is given",
    )
    to: Points | None = described(
        None,
        "what it is set to, a number, {counter, flag, draw, timer, way or word: NAME} or {distance: [A, B]}, or a list "
        "that is added up, each with a weight",
    )
    at_least: float | None = described(None, "`by` or `to` is no less than this, whatever was reckoned")
    at_most: float | None = described(None, "`by` or `to` is no more than this, whatever was reckoned")
    keeps_at_least: float | None = described(
        None, "with `by`: the counter does not fall below this; what lies below it already stays"
    )
    keeps_at_most: float | None = described(
        None, "with `by`: the counter does not rise above this; what lies above it already stays"
    )


Bounded = Score | Count
"""Actions with floors and ceilings: of the amount, and of what becomes of it."""


class SetFlag(Strict):
    """Set or clear a flag."""

    action: Literal["set_flag"]
    flag: Annotated[Name, FLAG] = described(..., "the flag")
    entity: Annotated[Name | None, WHOSE] = described(
        None, "for a flag kept per entity: whose; each; left out: all of them"
    )
    to: bool = described(True, "the new value")


class ToggleFlag(Strict):
    """Turn a flag over."""

    action: Literal["toggle_flag"]
    flag: Annotated[Name, FLAG] = described(..., "the flag")
    entity: Annotated[Name | None, WHOSE] = described(
        None, "for a flag kept per entity: whose; each; left out: all of them"
    )


class TimerAction(Strict):
    """Start, stop or reset a timer."""

    action: Literal["timer"]
    timer: Annotated[Name, TIMER] = described(..., "the timer")
    entity: Annotated[Name | None, WHOSE] = described(
        None, "for a timer kept per entity: whose; each; left out: all of them"
    )
    do: Literal["restart", "start", "stop", "reset"] = described(
        "restart", "restart: from 0; start: go on; stop: hold; reset: to 0 and stopped"
    )


class SequenceAction(Strict):
    """Begin a sequence anew: the steps made so far are forgotten."""

    action: Literal["sequence"]
    sequence: Annotated[Name, SEQUENCE] = described(..., "the sequence")
    entity: Annotated[Name | None, ENTITY] = described(
        None, "for a sequence kept per entity: whose; each; left out: all of them"
    )
    do: Literal["reset"] = described("reset", "reset: it stands before its first step, or at it if the entity is in it")


class SetSpot(Strict):
    """Set a spot to where something is now, and so remember that place; each half begins with that of the file.

    What is off the field leaves it where it is, and so does a message that is no position. What is placed in the same
    tick is still where it was before.
    """

    action: Literal["set_spot"]
    spot: Annotated[Name, SPOT] = described(..., "the spot")
    to: Annotated[
        Name | Point | ToldValue | UniformIn | OnLine,
        Ref(
            "entity, obstacle, spot or zone",
            MOVING | FIXED | frozenset({"spot"}) | frozenset({"zone"}),
            each=True,
            drawn=True,
        ),
    ] = described(
        ...,
        "an entity, each, a spot, a zone with a centre (a circle, a rect with four sides), a draw's name, [x, y] in m, "
        "{told: NAME}: the position that a robot has told by radio, {uniform_in: ZONES} or {on_line: [[x, y], [x, y]]}"
        ", a point of chance",
    )
    mirror: Mirror | None = described(None, "set it to the mirror image of that place")


class DrawAction(Strict):
    """Draw anew, or set a draw to a value."""

    action: Literal["draw"]
    draw: Annotated[Name, DRAW] = described(..., "the draw")
    as_: Annotated[Scalar | None, DrawnValue()] = Field(
        None,
        alias="as",
        description="set it to this value instead of drawing; each: to the name of the one for whom the rule is "
        "(for_each); other: of the one touched",
    )


class Place(MayKick):
    """Put entities somewhere: either one placement, or a layout by its name."""

    action: Literal["place"]
    layout: Annotated[Name | DrawValue | None, SectionRef("layout", ("placements",))] = described(
        None, "a layout of `placements`, or {draw: NAME} whose values are"
    )
    entity: Annotated[Names | None, ENTITIES] = described(None, "what is put there: entities, groups, or each")
    at: At | None = described(None, "where")
    facing: Facing = described("start", "which way it looks afterwards")
    noise_m: NoiseM = (0.0, 0.0)
    mirror: Mirror | None = described(
        None, "mirror the place, and what a kick is aimed at; with a layout: all its places and aims"
    )
    min_clearance_m: ClearanceM = 0.0
    max_attempts: Attempts = 100
    on_failure: WithoutRoom = "retry"
    kick: Roll = None


class Remove(Strict):
    """Take an entity off the field: parked, silent, invisible; any later placement brings it back."""

    action: Literal["remove"]
    entity: Annotated[Names, ENTITIES] = described(..., "what is taken off: entities, groups, or each")
    for_s: Lasts | None = described(
        None,
        "it comes back after this time, in s: a number, {draw: NAME} or {counter: NAME}, read in that moment (0 or "
        "less: one tick); left out: when a rule places it; who is off already comes back as the later action says",
    )
    back_at: At = described("start", "where it comes back to")
    facing: Facing = described("start", "which way it looks when it comes back")


class Hold(Strict):
    """Hold robots: from the next tick on their wheels stand braked, whatever their programs command.

    Programs run on, and the last command acts when they are let go. Who is held already stays so until the later of
    the two ends. Being put elsewhere or taken off the field ends nothing, and the time runs on; a new half begins with
    nobody held. What a phase with `robots: held` does is another matter: a robot stands as long as either holds it.
    """

    action: Literal["hold"]
    entity: Annotated[Names, ROBOTS] = described(..., "who is held: robots, groups, or each")
    for_s: Lasts | None = described(
        None,
        "how long, in s, also while it is off the field: a number, {draw: NAME} or {counter: NAME}, read in that "
        "moment (0 or less: not at all); left out: until a rule lets it go (release); who is held already stays so "
        "until the later of the two ends",
    )


class Release(Strict):
    """Let robots go that rules hold: they drive again from the next tick on; who is not held stays as it is.

    What a phase with `robots: held` holds stays held until the phase is over.
    """

    action: Literal["release"]
    entity: Annotated[Names, ROBOTS] = described(..., "who is let go: robots, groups, or each")


class SetPhase(Strict):
    """Enter a phase at once; the one that it is already begins anew."""

    action: Literal["set_phase"]
    phase: Annotated[Name, PHASE] = described(..., "the phase")


class Emit(Strict):
    """Write an event to the reflog, for people and other rules (which see it one tick later)."""

    action: Literal["emit"]
    event: EventName = described(..., "its name")
    payload: dict[Name, Value] = described(
        {}, "what is told with it: literals, or {counter: NAME} and the other values"
    )


class End(Strict):
    """End the half after the last firing of this tick."""

    action: Literal["end"]
    what: Literal["half", "match"] = described(
        "half", "half: the next one still follows; match: none follows, also if a half is over already (half_ended)"
    )
    reason: str = described("", "why, for the record", max_length=200)


Action = Annotated[
    Score
    | Count
    | SetFlag
    | ToggleFlag
    | TimerAction
    | SequenceAction
    | SetSpot
    | DrawAction
    | Place
    | Remove
    | Hold
    | Release
    | SetPhase
    | Emit
    | End,
    Field(discriminator="action"),
]
