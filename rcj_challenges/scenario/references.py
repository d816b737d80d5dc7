"""Which fields of the models name something, and what: one visible table. A test checks that it is complete."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import Any

from pydantic import BaseModel

from rcj_challenges.scenario.models import actions, conditions, places, robots, scenario, state, triggers


@dataclass(frozen=True)
class Field:
    """A reference to something on the field: entities, zones, gates, spots, or groups of them.

    Attributes:
        noun: what is named, for messages.
        kinds: what it may be.
        groups: whether a group's name may stand for its members.
        each: whether ``each`` may stand there, within a rule with ``for_each``, and ``other``, within one of touches.
        drawn: whether a draw's name may stand for what it decided.
        words: words that are no names.
        keys: True if the names are the keys of the mapping.
        instead: what to write in place of what is of these kinds, such as of an obstacle, where something that moves or
            tips is needed; empty: the usual.
        instead_of: those kinds.
    """

    noun: str
    kinds: frozenset[str]
    groups: bool = False
    each: bool = False
    drawn: bool = False
    words: frozenset[str] = frozenset()
    keys: bool = False
    instead: str = ""
    instead_of: frozenset[str] = frozenset({"obstacle", "fixed obstacle"})


@dataclass(frozen=True)
class Named:
    """A reference to an entry of some sections: a counter, a phase, a kit.

    Attributes:
        noun: what is named, for messages.
        sections: where it may be defined.
        words: names that exist without being defined.
        keys: True if the names are the keys of the mapping.
    """

    noun: str
    sections: tuple[str, ...]
    words: frozenset[str] = frozenset()
    keys: bool = False


Reference = Field | Named

_MOVING = frozenset({"robot", "ball", "obstacle"})
_FIXED = frozenset({"fixed obstacle"})
_ROBOT = frozenset({"robot"})
_ZONE, _GATE, _SPOT = frozenset({"zone"}), frozenset({"gate"}), frozenset({"spot"})

_ENTITIES = Field("entity", _MOVING, groups=True, each=True)
_ENTITY = Field("entity", _MOVING, each=True)
_ONE_ENTITY = Field("entity", _MOVING)
_THINGS = Field("entity or obstacle", _MOVING | _FIXED, groups=True, each=True)
_THING = Field("entity or obstacle", _MOVING | _FIXED, each=True)
_TOUCHED = Field("entity or obstacle", _MOVING | _FIXED | {"walls"}, groups=True, each=True)
_ROBOTS = Field("robot", _ROBOT, groups=True, each=True)
_TIPPING = Field(
    "robot",
    _ROBOT,
    groups=True,
    each=True,
    instead="an obstacle does not tip over: of a movable one 'displaced' tells that it was pushed away",
)
_ONE_ROBOT = Field("robot", _ROBOT, each=True)
_ZONES = Field("zone", _ZONE, groups=True, each=True, drawn=True)
_PUT_IN = Field("zone", _ZONE, groups=True)
_GATES = Field("gate", _GATE, groups=True, each=True, drawn=True)
_SPOTS = Field("spot", _SPOT, groups=True)
_MEASURED_TO = Field(
    "entity, obstacle, spot, zone or gate", _MOVING | _FIXED | _SPOT | _ZONE | _GATE, groups=True, each=True, drawn=True
)
_COMES_NEAR = Field(
    "entity", _MOVING, groups=True, each=True, instead="name the obstacle in 'to', and in 'entity' who comes near it"
)
_SEEN = Field("entity, obstacle or spot", _MOVING | _FIXED | _SPOT, each=True, drawn=True)
_ANCHOR = Field("entity or spot", _MOVING | _SPOT, each=True, drawn=True)
_KEEPING = _MOVING | _FIXED | _ZONE | _GATE
"""Of what there may be a rule, a counter, a flag or a timer each."""
_WHOSE = Field("entity", _KEEPING, each=True)
_WHOSE_OF = Field("entity", _KEEPING, groups=True, each=True)
_KEEPERS = Field("entity, obstacle, zone or gate", _KEEPING, groups=True)
_ABOUT = Field("entity, obstacle, zone or gate", _KEEPING, groups=True, each=True)
_MEMBERS = Field("entity", _MOVING, groups=True)
_STEP = Field("zone or gate", _ZONE | _GATE)
_MADE_STEP = Field("zone or gate", _ZONE | _GATE, each=True)

_COUNTER = Named("counter", ("counters",))
_READABLE = Named("counter or entrant", ("counters", "entrants"))
_FLAG = Named("flag", ("flags",))
_TIMER = Named("timer", ("timers",))
_DRAW = Named("draw", ("draws",))
_PHASE = Named("phase", ("phases",), words=frozenset({"play"}))
_PHASES = Named("phase", ("phases",), words=frozenset({"play", "any"}))
_SEQUENCE = Named("sequence", ("sequences",))
_LAYOUT = Named("layout", ("placements",))
_ENTRANT = Named("entrant", ("entrants",))
_RECEIVER = Named("entrant", ("entrants",), words=frozenset({"each", "other"}))

REFERENCES: dict[tuple[type[BaseModel], str], Reference] = {
    # triggers
    (triggers.PhaseEntered, "phase"): _PHASE,
    (triggers.PhaseEntered, "from"): _PHASE,
    (triggers.TimerExpired, "timer"): _TIMER,
    (triggers.Enters, "entity"): _ENTITIES,
    (triggers.Enters, "zone"): _ZONES,
    (triggers.Leaves, "entity"): _ENTITIES,
    (triggers.Leaves, "zone"): _ZONES,
    (triggers.Crosses, "entity"): _ENTITIES,
    (triggers.Crosses, "gate"): _GATES,
    (triggers.Touches, "entity"): _THINGS,
    (triggers.Touches, "other"): _TOUCHED,
    (triggers.Displaced, "entity"): _ENTITIES,
    (triggers.NoProgress, "entity"): _ENTITIES,
    (triggers.StaysIn, "entity"): _ENTITIES,
    (triggers.StaysIn, "zone"): _ZONES,
    (triggers.TipsOver, "entity"): _TIPPING,
    (triggers.SequenceCompleted, "sequence"): _SEQUENCE,
    (triggers.SequenceCompleted, "entity"): _ENTITIES,
    (triggers.SequenceBroken, "sequence"): _SEQUENCE,
    (triggers.SequenceBroken, "entity"): _ENTITIES,
    (triggers.ProgramFault, "robot"): _ROBOTS,
    (triggers.OnEvent, "entity"): _ABOUT,
    (triggers.Tells, "entity"): _ROBOTS,
    # conditions
    (conditions.InZone, "entity"): _ENTITIES,
    (conditions.InZone, "zone"): _ZONES,
    (conditions.Speed, "entity"): _ENTITIES,
    (conditions.Distance, "entity"): _COMES_NEAR,
    (conditions.Distance, "to"): _MEASURED_TO,
    (conditions.WayIs, "entity"): _ENTITIES,
    (conditions.Looks, "entity"): _ROBOTS,
    (conditions.Looks, "towards"): _SEEN,
    (conditions.IsHeld, "entity"): _ROBOTS,
    (conditions.CounterIs, "counter"): _READABLE,
    (conditions.CounterIs, "entity"): _WHOSE_OF,
    (conditions.FlagIs, "flag"): _FLAG,
    (conditions.FlagIs, "entity"): _WHOSE_OF,
    (conditions.Drawn, "draw"): _DRAW,
    (conditions.TimerIs, "timer"): _TIMER,
    (conditions.TimerIs, "entity"): _WHOSE_OF,
    (conditions.LastTouch, "entity"): _THING,
    (conditions.LastTouch, "by"): _ROBOTS,
    (conditions.Told, "entity"): _ROBOTS,
    (conditions.SpotFree, "spot"): _SPOTS,
    (conditions.SequenceAt, "sequence"): _SEQUENCE,
    (conditions.SequenceAt, "entity"): _ENTITIES,
    (conditions.SequenceAt, "step"): _MADE_STEP,
    # actions
    (actions.Score, "entrant"): _RECEIVER,
    (actions.LastToucher, "last_touch"): _THING,
    (actions.Count, "counter"): _COUNTER,
    (actions.Count, "entity"): _WHOSE,
    (actions.SetFlag, "flag"): _FLAG,
    (actions.SetFlag, "entity"): _WHOSE,
    (actions.ToggleFlag, "flag"): _FLAG,
    (actions.ToggleFlag, "entity"): _WHOSE,
    (actions.TimerAction, "timer"): _TIMER,
    (actions.TimerAction, "entity"): _WHOSE,
    (actions.SequenceAction, "sequence"): _SEQUENCE,
    (actions.SequenceAction, "entity"): _ENTITY,
    (actions.SetSpot, "spot"): Field("spot", _SPOT),
    (actions.SetSpot, "to"): Field(
        "entity, obstacle, spot or zone", _MOVING | _FIXED | _SPOT | _ZONE, each=True, drawn=True
    ),
    (actions.DrawAction, "draw"): _DRAW,
    (actions.Place, "layout"): _LAYOUT,
    (actions.Place, "entity"): _ENTITIES,
    (actions.Remove, "entity"): _ENTITIES,
    (actions.Hold, "entity"): _ROBOTS,
    (actions.Release, "entity"): _ROBOTS,
    (actions.SetPhase, "phase"): _PHASE,
    # values
    (state.CounterValue, "counter"): _READABLE,
    (state.CounterValue, "entity"): _WHOSE,
    (state.LowestOfOthers, "lowest"): _COUNTER,
    (state.HighestOfOthers, "highest"): _COUNTER,
    (state.FlagValue, "flag"): _FLAG,
    (state.FlagValue, "entity"): _WHOSE,
    (state.DrawValue, "draw"): _DRAW,
    (state.WordValue, "of"): _ENTRANT,
    (state.PositionValue, "position_of"): _SEEN,
    (state.DistanceValue, "distance"): _MEASURED_TO,
    (state.WayValue, "way"): _ENTITY,
    (state.TimerValue, "timer"): _TIMER,
    (state.TimerValue, "entity"): _WHOSE,
    (state.HeldValue, "held"): Field("robot", _ROBOT, each=True),
    (state.LastTouchValue, "last_touch"): _THING,
    (state.ToldValue, "told"): _ONE_ROBOT,
    (state.NumberDraw, "draw"): _DRAW,
    (state.DrawnDuration, "draw"): _DRAW,
    (state.NumberWord, "of"): _ENTRANT,
    (state.NumberTimer, "timer"): _TIMER,
    (state.NumberTimer, "entity"): _WHOSE,
    (state.WeightedCounter, "counter"): _READABLE,
    (state.WeightedCounter, "entity"): _WHOSE,
    (state.WeightedFlag, "flag"): _FLAG,
    (state.WeightedFlag, "entity"): _WHOSE,
    (state.WeightedDraw, "draw"): _DRAW,
    (state.WeightedWord, "of"): _ENTRANT,
    (state.WeightedDistance, "distance"): _MEASURED_TO,
    (state.WeightedWay, "way"): _ENTITY,
    (state.NumberTold, "told"): _ONE_ROBOT,
    (state.WeightedTold, "told"): _ONE_ROBOT,
    (state.WeightedTimer, "timer"): _TIMER,
    (state.WeightedTimer, "entity"): _WHOSE,
    # state
    (state.Counter, "per"): _KEEPERS,
    (state.Flag, "per"): _KEEPERS,
    (state.Timer, "per"): _KEEPERS,
    (state.AnyStep, "any_of"): _STEP,
    (state.Sequence, "entity"): _ONE_ENTITY,
    (state.Sequence, "per"): _MEMBERS,
    (state.Sequence, "steps"): _STEP,
    (state.Phase, "next"): _PHASE,
    # places
    (places.Gate, "anchor"): _ONE_ENTITY,
    (places.AtSpot, "spot"): Field(
        "spot",
        _SPOT,
        drawn=True,
        instead="beside what moves is {relative_to: NAME, offset_m: [0.1, 0]}",
        instead_of=_MOVING,
    ),
    (places.UniformIn, "uniform_in"): _PUT_IN,
    (places.Choice, "choice"): Field("spot", _SPOT, groups=True, drawn=True),
    (places.NearestFree, "nearest_free"): _SPOTS,
    (places.NearestFree, "to"): _ANCHOR,
    (places.FurthestFree, "furthest_free"): _SPOTS,
    (places.FurthestFree, "from"): _ANCHOR,
    (places.RelativeTo, "relative_to"): _ANCHOR,
    (places.Towards, "towards"): _ANCHOR,
    (places.Mirror, "when"): _FLAG,
    (places.DrawnSpeed, "draw"): _DRAW,
    (places.Placing, "entity"): _MEMBERS,
    # robots
    (robots.Kit, "packet_lists"): Field("robot", _ROBOT),
    (robots.Robot, "kit"): Named("kit", ("kits",)),
    (robots.Entrant, "robots"): Field("robot", _ROBOT, keys=True),
    # the file
    (scenario.Rule, "for_each"): _KEEPERS,
    (scenario.Rule, "phases"): _PHASES,
    (scenario.PlusPart, "counter"): _COUNTER,
    (scenario.RankByCounter, "counter"): _COUNTER,
    (scenario.Broadcast, "only"): Field("robot", _ROBOT, groups=True, keys=True),
    (scenario.Keyframe, "place"): Field("entity", _MOVING, keys=True),
    (scenario.Keyframe, "move"): Field("entity", _MOVING, keys=True),
    (scenario.Keyframe, "touch"): Field("entity or obstacle", _MOVING | _FIXED | {"walls"}),
    (scenario.Keyframe, "tips"): Field("robot", _ROBOT),
    (scenario.Keyframe, "fault"): Field("robot", _ROBOT),
    (scenario.Keyframe, "tells"): Field("robot", _ROBOT, keys=True),
    (scenario.Expectation, "draws"): Named("draw", ("draws",), keys=True),
    (scenario.Given, "score"): Named("entrant", ("entrants",), keys=True),
    (scenario.Given, "counters"): Named("counter", ("counters",), keys=True),
    (scenario.Given, "flags"): Named("flag", ("flags",), keys=True),
    (scenario.Expectation, "spots"): Field("spot", _SPOT, keys=True),
    (scenario.Expectation, "score"): Named("entrant", ("entrants",), keys=True),
    (scenario.Expectation, "counters"): Named("counter", ("counters",), keys=True),
    (scenario.Expectation, "flags"): Named("flag", ("flags",), keys=True),
    (scenario.Expectation, "phase"): _PHASE,
    (scenario.Expectation, "ranking"): _ENTRANT,
    (scenario.Expectation, "told"): Field("robot", _ROBOT, groups=True, keys=True),
    (scenario.Expectation, "held"): Field("robot", _ROBOT, keys=True),
    (scenario.Expectation, "poses"): Field("entity or spot", _MOVING | _SPOT, keys=True),
    (scenario.Scenario, "first_phase"): _PHASE,
}

DRAWN_NAMES: frozenset[tuple[type[BaseModel], str]] = frozenset[tuple[type[BaseModel], str]](
    {(conditions.Drawn, "equals"), (actions.DrawAction, "as")}
)
"""Fields with a value of a draw: any text, so that no table says what it names; `each` and `other` name somebody."""

DEFINITIONS: frozenset[tuple[type[BaseModel], str]] = frozenset[tuple[type[BaseModel], str]](
    {
        *((scenario.Scenario, name) for name in scenario.Scenario.model_fields if name != "first_phase"),
        (robots.Robot, "colour"),
        (scenario.Rule, "exclusive"),
        (scenario.Rule, "repeat_for"),
        (actions.Emit, "payload"),
        (scenario.Broadcast, "fields"),
        (scenario.ExpectedEvent, "payload"),
    }
)
"""Fields whose names are chosen there. The section ``groups`` names things too; its checks are in `naming`."""


@cache
def references_of(model: type[BaseModel]) -> list[tuple[str, Reference, Any]]:
    """Return the fields of a model that name something: the key in the file, what it may name, and the default."""
    keyed = ((info.alias or name, info.default) for name, info in model.model_fields.items())
    return [(key, REFERENCES[model, key], default) for key, default in keyed if (model, key) in REFERENCES]
