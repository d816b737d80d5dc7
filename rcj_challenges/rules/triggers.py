"""Triggers: edges, moments at which a rule may fire."""

from typing import Annotated, Literal

from pydantic import Field

from rcj_challenges.rules.conditions import Condition, Message
from rcj_challenges.rules.fields import (
    DurationS,
    EventName,
    Name,
    Names,
    NotNegative,
    Point,
    Positive,
    Strict,
    described,
)
from rcj_challenges.rules.refs import (
    ENTITIES,
    FIXED,
    GATES,
    KEEPING,
    MOVING,
    PHASE,
    ROBOTS,
    SEQUENCE,
    THINGS,
    TIMER,
    ZONES,
    Ref,
)

_ENTITY = "whose: an entity (a robot, a ball or a movable obstacle), a group (any of them), or each"
_WHOSE_SEQUENCE = (
    "for a sequence kept per entity: whose; each: the current one; a group: any of them; left out, without for_each: "
    "any that has one"
)


class HalfStarted(Strict):
    """Fires at tick 0 of every half, after the draws."""

    trigger: Literal["half_started"]


class HalfEnded(Strict):
    """Fires once after the last tick of a half."""

    trigger: Literal["half_ended"]


class PhaseEntered(Strict):
    """Fires when a phase is entered, after `set_phase` one tick later; not for the first of a half (`half_started`)."""

    trigger: Literal["phase_entered"]
    phase: Annotated[Name, PHASE] = described(..., "the phase entered")
    from_: Annotated[Name | None, PHASE] = Field(None, alias="from", description="only when it comes from this phase")


class TimeReached(Strict):
    """Fires when the clock of the half reaches a time, and again every so often if asked."""

    trigger: Literal["time_reached"]
    at_s: DurationS = described(..., "time since the start of the half in s")
    every_s: DurationS | None = described(
        None, "fires again after each of these times in s, counted from at_s, until the half ends; left out: once"
    )


class TimerExpired(Strict):
    """Fires when a timer reaches its length."""

    trigger: Literal["timer_expired"]
    timer: Annotated[Name, TIMER] = described(
        ..., "the timer; of one kept per entity: with for_each over those that of the current one, else any of them"
    )


class Enters(Strict):
    """Fires when an entity's centre comes into a zone it was not in."""

    trigger: Literal["enters"]
    entity: Annotated[Names, ENTITIES] = described(..., _ENTITY)
    zone: Annotated[Names, ZONES] = described(
        ..., "a zone, each, or a draw's name; with a list or group: into any of them from none of them"
    )


class Leaves(Strict):
    """Fires when an entity's centre leaves a zone it was in."""

    trigger: Literal["leaves"]
    entity: Annotated[Names, ENTITIES] = described(..., _ENTITY)
    zone: Annotated[Names, ZONES] = described(
        ..., "a zone, each, or a draw's name; with a list or group: from any of them to none of them"
    )


class Crosses(Strict):
    """Fires when an entity's centre crosses a gate."""

    trigger: Literal["crosses"]
    entity: Annotated[Names, ENTITIES] = described(..., _ENTITY)
    gate: Annotated[Names, GATES] = described(..., "a gate, each, a draw's name, or several: any of them")
    direction: Literal["forward", "backward", "either"] = described("either", "which way, seen from the gate")


class Touches(Strict):
    """Fires when two bodies come into contact that were not in the sub-step before."""

    trigger: Literal["touches"]
    entity: Annotated[Names, THINGS] = described(
        ...,
        "whose: an entity (a robot, a ball or a movable obstacle), a fixed obstacle, a group (any of them), or each",
    )
    other: Annotated[Names, Ref("entity or obstacle", MOVING | FIXED | {"walls"}, groups=True, each=True)] = described(
        ...,
        "what it touches: entities, obstacles, walls, or a group; where all triggers of a rule are touches, its "
        "conditions and actions can name the one touched: other, as each",
    )
    every_s: DurationS | None = described(
        None, "fires again after each of these times in s while they go on touching; left out: when it begins only"
    )


class Displaced(Strict):
    """Fires when an entity has been moved further than a distance from where it was put."""

    trigger: Literal["displaced"]
    entity: Annotated[Names, ENTITIES] = described(..., _ENTITY)
    from_: Literal["last_placement"] | Point = Field(
        "last_placement",
        alias="from",
        description="measured from where it was last put (noise included), or from [x, y] in m",
    )
    distance_m: Positive = described(..., "fires beyond this, in m")
    axis: Literal["either", "distance"] = described(
        "distance", "distance: the straight line; either: the larger of the shifts in x and in y"
    )


class NoProgress(Strict):
    """Fires when the length of an entity's path over a sliding window falls short; a window that is not full cannot.

    A robot that a rule holds (action `hold`) is not judged meanwhile; its window begins when it is let go.
    """

    trigger: Literal["no_progress"]
    entity: Annotated[Names, ENTITIES] = described(..., _ENTITY)
    distance_m: Positive = described(..., "path length that is expected, in m")
    within_s: DurationS = described(
        ..., "length of the window in s; of a robot that a rule holds it begins when it is let go"
    )


class StaysIn(Strict):
    """Fires while inside, once the stay is longer than a limit; short excursions count as inside."""

    trigger: Literal["stays_in"]
    entity: Annotated[Names, ENTITIES] = described(..., _ENTITY)
    zone: Annotated[Names, ZONES] = described(
        ..., "a zone, each, or a draw's name; with a list or group: in any of them"
    )
    limit_s: DurationS = described(..., "fires as soon as the stay is longer than this, in s")
    grace_s: NotNegative = described(0.0, "an absence of up to this time counts as inside, in s")


class TipsOver(Strict):
    """Fires when a robot tilts further than an angle."""

    trigger: Literal["tips_over"]
    entity: Annotated[
        Names,
        Ref(
            "robot",
            frozenset({"robot"}),
            groups=True,
            each=True,
            instead="an obstacle does not tip over: of a movable one 'displaced' tells that it was pushed away",
        ),
    ] = described(..., "whose: a robot, a group of robots (any of them), or each")
    angle_rad: Positive = described(0.7854, "tilt of its vertical axis in rad", lt=3.1416)


class SequenceCompleted(Strict):
    """Fires when the last step of a sequence is made."""

    trigger: Literal["sequence_completed"]
    sequence: Annotated[Name, SEQUENCE] = described(..., "the sequence")
    entity: Annotated[Names | None, ENTITIES] = described(None, _WHOSE_SEQUENCE)


class SequenceBroken(Strict):
    """Fires when a wrong step is made in a sequence with ``wrong_step: break``: it begins anew.

    Before the first step, none is wrong; afterwards all are but the last reached and the next.
    """

    trigger: Literal["sequence_broken"]
    sequence: Annotated[Name, SEQUENCE] = described(..., "the sequence")
    entity: Annotated[Names | None, ENTITIES] = described(None, _WHOSE_SEQUENCE)


class OnEvent(Strict):
    """Fires one tick after an event was emitted."""

    trigger: Literal["event"]
    event: EventName = described(..., "the event")
    entity: Annotated[Names | None, Ref("entity, obstacle, zone or gate", KEEPING, groups=True, each=True)] = described(
        None,
        "only if it is about this one (whom the rule that emits it is for, or its trigger found): an entity, a fixed "
        "obstacle, a zone or gate that the rule is for, a group (any of them), or each; left out: whatever it is about",
    )


class ProgramFault(Strict):
    """Fires when a robot's program has failed."""

    trigger: Literal["program_fault"]
    robot: Annotated[Names, ROBOTS] = described("robots", "which robot, a group, or each")


class Tells(Message):
    """Fires when a robot has told the referee something by radio, on the channel on which the referee speaks.

    One message of each robot in a tick, in the order sent. In messages and sentences ``measured`` is the number told.
    """

    trigger: Literal["tells"]
    entity: Annotated[Names, ROBOTS] = described("robots", "whose: a robot, a group (any of them), or each")


class Holds(Strict):
    """Fires when a condition has held for a time, and again at intervals if asked."""

    trigger: Literal["holds"]
    condition: Condition = described(..., "the condition")
    for_s: NotNegative = described(
        0.0,
        "how long it must hold, in s; 0: when it comes true, and not if it was true when the rule came to life, or a "
        "rule made it true that puts things somewhere or takes them off (spot_free, sequence_at, and a counter beside "
        "the lowest or highest of others hear that one tick later)",
    )
    grace_s: NotNegative = described(0.0, "an interruption of up to this time counts as holding, in s")
    every_s: DurationS | None = described(
        None,
        "fires again after each of these times in s while it goes on, counted from when for_s was full; left out: once",
    )


Trigger = Annotated[
    HalfStarted
    | HalfEnded
    | PhaseEntered
    | TimeReached
    | TimerExpired
    | Enters
    | Leaves
    | Crosses
    | Touches
    | Displaced
    | NoProgress
    | StaysIn
    | TipsOver
    | SequenceCompleted
    | SequenceBroken
    | OnEvent
    | ProgramFault
    | Tells
    | Holds,
    Field(discriminator="trigger"),
]
