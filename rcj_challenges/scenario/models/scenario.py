"""The whole file: rules, results, limits, tests, and the sections put together."""

from dataclasses import replace
from typing import Annotated, Any, Literal, TypeVar

from pydantic import Field

from rcj_challenges.rules.actions import AnyAction
from rcj_challenges.rules.conditions import AnyCondition
from rcj_challenges.rules.effects import Effect, Moment
from rcj_challenges.rules.fields import DurationS, EventName, Name, Names, Point, Scalar, Strict, described
from rcj_challenges.rules.message import Said
from rcj_challenges.rules.ranked import BY_SCORE, AnyRanked
from rcj_challenges.rules.refs import (
    COUNTER,
    ENTRANT,
    FIXED,
    FLAG,
    KEEP,
    KEEPERS,
    MEMBERS,
    MOVING,
    ONE_ENTITY,
    ONE_ROBOT,
    PHASE,
    ROLE,
    Ref,
    SectionRef,
)
from rcj_challenges.rules.triggers import AnyTrigger
from rcj_challenges.rules.values import Lasts, Value
from rcj_challenges.scenario.models.designs import Guideline
from rcj_challenges.scenario.models.field import Ball, FieldModel, Match, Obstacle
from rcj_challenges.scenario.models.limits import Limits
from rcj_challenges.scenario.models.places import Gate, Layout, Spot, Zone
from rcj_challenges.scenario.models.robots import Entrant, Kit, Robot
from rcj_challenges.scenario.models.state import Counter, Draw, Flag, Phase, Role, Sequence, Timer

SCHEMA_VERSION = 2
MAX_GROUPS = 256
MAX_MEMBERS = 512
MAX_ROWS = 64
"""Bounds far above any challenge, so that resolving groups of groups takes no time worth mentioning."""

_E = TypeVar("_E", bound=Effect)
_M = TypeVar("_M", bound=Moment)

RowValues = Annotated[dict[Name, Scalar | tuple[Scalar, ...]], Field(max_length=MAX_ROWS)]
"""The values of a row of a table by their columns."""

_Times = Annotated[int, Field(ge=1)]

_Counters = Annotated[dict[Name, float | dict[Name, float]], replace(COUNTER, keys=True)]
_Flags = Annotated[dict[Name, bool | dict[Name, bool]], replace(FLAG, keys=True)]
_Roles = Annotated[dict[Name, Name], replace(ROLE, keys=True)]
_Scores = Annotated[dict[Name, float], replace(ENTRANT, keys=True)]
_BY_ROBOT = replace(ONE_ROBOT, keys=True)
_Poses = Annotated[
    dict[Name, Annotated[tuple[float, ...], Field(min_length=2, max_length=3)]],
    replace(ONE_ENTITY, keys=True),
]


class Rule(Strict):
    """A rule: if one of its triggers fires and all its conditions hold, its actions run in order."""

    triggers: tuple[AnyTrigger, ...] = described(..., "moments at which the rule may fire; one is enough", min_length=1)
    conditions: tuple[AnyCondition, ...] = described(
        (), "conditions that must all hold at that moment (for 'or', use any_of)"
    )
    actions: tuple[AnyAction, ...] = described(..., "what happens, in order", min_length=1)
    for_each: Annotated[Name | None, KEEPERS] = described(
        None,
        "entrants, a group of entities, fixed obstacles, zones or gates, or a single one of these: the rule exists "
        "once for each member, and `each` refers to that member; where a thing is needed, an entrant stands for its "
        "robots, and where an entrant is needed, a robot for the one it plays for",
    )
    phases: Annotated[
        Literal["any"] | Annotated[tuple[Name, ...], Field(min_length=1)],
        SectionRef("phase", ("phases",), words=frozenset({"play", "any"})),
    ] = Field(("play",), description="the phases in which the rule is active; any: all of them")
    priority: int = described(
        0,
        "rules with lower numbers fire in an earlier round of the tick; in a round, all conditions are judged before "
        "any action runs, and rules that a time sets off fire after all others",
        ge=-1000,
        le=1000,
    )
    exclusive: Name | None = described(
        None,
        "a name shared by several rules, of which at most one fires per tick; rules with "
        "for_each compete per member and never with rules without it",
    )
    cooldown_s: Lasts | None = described(
        None,
        "time in s after a firing, read then, during which the rule cannot fire again; counted per member with "
        "for_each",
    )
    max_executions: Annotated[
        _Times | Annotated[dict[Name, _Times], Field(min_length=1, max_length=1)] | None, replace(KEEP, keys=True)
    ] = described(
        None,
        "maximum number of firings in a half; or {match: 1}: in the match, {phase: 1}: in a phase, {NAME: 1}: from one "
        "beginning of the phase NAME to the next; counted per member with for_each",
    )
    says: str = described(
        "",
        "what has happened, in a sentence for the referee's log and the replay page, and for the rule sheet if it "
        "has no `sheet`; {entity}, {each}, {other}, {others}, {team}, {measured}, {limit}, {points}, and params, "
        "counters, draws and roles by name, such as {goal_points}, are filled in",
        max_length=500,
    )
    sheet: bool | Annotated[str, Field(min_length=1, max_length=500)] = described(
        True,
        "the sentence for the rule sheet, if it differs from `says`: what is so; false: the rule is left out of it",
    )

    @property
    def for_sheet(self) -> str:
        """The sentence for the rule sheet, its placeholders not filled in yet."""
        return self.sheet if isinstance(self.sheet, str) else self.says if self.sheet else ""

    @property
    def limit(self) -> tuple[str, int | None]:
        """For how long firings are counted, as `keep` says it, and how many there may be; None: any number."""
        most = self.max_executions
        return next(iter(most.items())) if isinstance(most, dict) else ("half", most)

    def effects(self, kind: type[_E]) -> list[_E]:
        """Return the effects of one kind that its actions have."""
        return [one for one in self.all_effects() if isinstance(one, kind)]

    def all_effects(self) -> list[Effect]:
        """Return the effects of its actions, in order."""
        return [one for action in self.actions for one in action.effects()]

    def moments(self, kind: type[_M]) -> list[_M]:
        """Return the moments of one kind that its triggers wait for."""
        return [moment for one in self.triggers if isinstance(moment := one.moment(), kind)]

    def is_active_in(self, phase: str) -> bool:
        """Return whether the rule is active in a phase."""
        return self.phases == "any" or phase in self.phases


class Broadcast(Strict):
    """What programs receive after the official packet: a JSON object on the same channel."""

    fields: dict[Name, Value] = described({}, "values by key, sent to all robots")
    only: Annotated[dict[Name, dict[Name, Value]] | None, replace(_BY_ROBOT, groups=True)] = described(
        None,
        "by the name of a robot or group: values by key that are added to the object for these robots only; if "
        "a robot gets the same key twice, the later one counts",
    )
    every_ticks: int = described(1, "number of ticks from one broadcast to the next", ge=1, le=10_000)


class Result(Strict):
    """How entrants are ranked, with the most important value first."""

    rank: tuple[AnyRanked, ...] = described((BY_SCORE,), "values with `better`; a later one breaks ties", min_length=1)


class Keyframe(Strict):
    """A moment of the script: placements, moves, touches, program faults, messages to the referee."""

    at_s: float = described(..., "time since the start of the half in s", ge=0, le=86_400)
    place: _Poses = described(
        {},
        "entity -> [x, y] or [x, y, yaw] in m and rad: it is there at once; it may enter zones and cross "
        "gates, but it has no speed in that tick, and conditions about speed fail; from off the field it "
        "comes back, as if a rule had placed it",
    )
    move: _Poses = described(
        {},
        "entity -> [x, y] or [x, y, yaw]: it moves there in a straight line from its position at the previous "
        "keyframe (from off the field: it comes back there); if a rule places or removes it meanwhile, it stays "
        "where the rule put it",
    )
    touch: Annotated[
        tuple[tuple[Name, Name], ...],
        Ref("entity or obstacle", MOVING | FIXED | {"walls"}),
    ] = described((), "pairs that touch in this tick")
    touch_lasts_s: DurationS | None = described(
        None, "how long these pairs stay in contact, in s; if omitted: in this tick only"
    )
    tips: Annotated[tuple[Name, ...], ONE_ROBOT] = described((), "robots that lie on their side from this moment on")
    fault: Annotated[tuple[Name, ...], ONE_ROBOT] = described((), "robots whose programs fail at this moment")
    tells: Annotated[dict[Name, Said | Point] | None, _BY_ROBOT] = described(
        None, "robot -> its message to the referee by radio: text, a number, or [x, y] in m"
    )


class ExpectedEvent(Strict):
    """An event, or the firing of a rule, that the test expects."""

    either = ("event", "rule")
    event: EventName | None = described(None, "the event, by its name")
    rule: Annotated[Name | None, SectionRef("rule", ("rules",))] = described(
        None, "the rule that fires, by its name; all its firings must be expected, those of other rules need not be"
    )
    at_s: float | None = described(None, "time in s; if omitted: any time", ge=0)
    tolerance_s: float = described(0.033, "largest permitted deviation in s", ge=0)
    payload: dict[Name, Scalar] = described(
        {}, "the part of the payload that is checked; of a rule: entity (that of each, or of the trigger), place, other"
    )

    @property
    def what(self) -> str:
        """What is expected: the name of an event, or of a rule after the word."""
        return self.event or f"rule {self.rule}"


class Given(Strict):
    """The state at the start of a test, before the first rule, as if part of the match had already been played."""

    score: _Scores = described({}, "entrant -> points; if omitted: 0")
    counters: _Counters = described(
        {},
        "counter -> value (for a per-entity counter: of all members), or {entity: value, …}; if omitted: its "
        "initial value",
    )
    flags: _Flags = described(
        {},
        "flag -> true or false (for a per-entity flag: of all members), or {entity: true or false, …}; if "
        "omitted: its initial value",
    )
    roles: _Roles = described({}, "role -> the member that has it, or none")


Ranking = Annotated[
    tuple[Name | Annotated[tuple[Name, ...], Field(min_length=1)], ...],
    Field(min_length=1),
]
ToldNumbers = Annotated[tuple[float, ...], Field(min_length=2, max_length=3)]
"""A position as sent to programs."""


class Expectation(Strict):
    """A test: scripted poses and touches for the referee, and what it is expected to make of them."""

    seed: int = described(1, "seed of the draws", ge=0)
    half: int = described(1, "the half that is played; entrants keep their names in all halves", ge=1)
    draws: Annotated[
        dict[Name, Scalar | Annotated[tuple[Scalar, ...], Field(min_length=1)]],
        SectionRef("draw or role", ("draws", "roles"), keys=True),
    ] = described(
        {},
        "results of draws, and of roles by chance: a value is kept until a rule draws again; with a list, each draw "
        "takes the next value, and after the last one, draws are random",
    )
    spots: Annotated[
        dict[Name, Point | Annotated[tuple[Point, ...], Field(min_length=1)]] | None,
        Ref("spot", frozenset({"spot"}), keys=True),
    ] = described(
        None,
        "places of spots that are set at random: spot -> [x, y] in m for the first time, or a list for the "
        "first few times; after that they are random (to compare a spot at the end, use poses)",
    )
    given: Given = described(Given.model_construct(), "score, counters and flags when the half begins")
    keyframes: tuple[Keyframe, ...] = described(..., "the script, in chronological order", min_length=1)
    lasts_s: DurationS = described(..., "how long the test lasts, in s")
    events: tuple[ExpectedEvent, ...] | None = described(
        None, "all events in order, except those in `ignore`, and firings of rules; if omitted: not checked"
    )
    ignore: tuple[EventName, ...] = described(
        ("MATCH_START", "KICKOFF", "MATCH_FINISH"),
        "events left out of the comparison, unless they are expected by name; a list replaces this one",
    )
    score: _Scores = described({}, "score by entrant at the end")
    counters: _Counters = described({}, "counters at the end; for a per-entity counter, the sum or {entity: value, …}")
    flags: _Flags = described(
        {}, "flags at the end; for a per-entity flag, whether any is set, or {entity: true or false, …}"
    )
    roles: _Roles = described({}, "role -> the member that has it at the end, or none")
    phase: Annotated[Name | None, PHASE] = described(None, "the phase at the end")
    ranking: Annotated[Ranking | None, ENTRANT] = described(
        None,
        "all entrants, best first, as `result` would rank them if the match were over; entrants in a list "
        "share a place",
    )
    held: Annotated[dict[Name, bool] | None, _BY_ROBOT] = described(
        None, "robot -> true or false: whether a rule or the phase holds it at the end"
    )
    told: Annotated[dict[Name, dict[Name, Scalar | ToldNumbers]] | None, replace(_BY_ROBOT, groups=True)] = described(
        None,
        "robot or group -> key -> the value in its last broadcast (a position is [x, y] or [x, y, yaw]); omitted keys "
        "are not compared",
    )
    ended: Literal["half", "match", "none"] | None = described(
        None,
        "what is over at the end; half: the half was ended by a rule or by time; match: a rule has ended the "
        "match; none: the half continues",
    )
    poses: Annotated[
        dict[Name, tuple[float, float]],
        Ref("entity or spot", MOVING | frozenset({"spot"}), keys=True),
    ] = described({}, "entity or spot -> [x, y] at the end in m; what is off the field is at no place")
    off: Annotated[Names | None, MEMBERS] = described(None, "entities or groups that are off the field at the end")
    tolerance_m: float = described(0.001, "largest permitted deviation of a pose in m", ge=0)
    tolerance_counters: float | None = described(
        None, "largest permitted deviation of a counter, such as one that stores a time; if omitted: none", ge=0
    )


class MatchExpectation(Strict):
    """A test of several halves in a row, in which seats change and scores are carried over as in a match."""

    seed: int = described(1, "seed of the draws", ge=0)
    halves: tuple[Expectation, ...] = described(
        ...,
        "the halves, each a test of its own by the seats in that half, without seed, half and ranking; "
        "each but the last is over after lasts_s",
        min_length=1,
        max_length=MAX_ROWS,
    )
    score: _Scores = described({}, "score at the end by team, which is named by its seat in the first half")
    counters: _Counters = described({}, "counters at the end; for a per-entity counter, the sum or {entity: value, …}")
    tolerance_counters: float | None = described(
        None, "largest permitted deviation of a counter; if omitted: none", ge=0
    )
    ranking: Annotated[Ranking | None, ENTRANT] = described(
        None, "all teams, best first, as `result` ranks them; teams in a list share a place"
    )


class Scenario(Strict):
    """A challenge: field, robots, rules and everything else that decides a result."""

    schema_version: Literal[2] = described(
        ..., "version of this format; errors about a file of version 1 show what to write instead"
    )
    id: Name = described(..., "short name, after which record folders are named")
    title: str = described(..., "title for display", min_length=1, max_length=120)
    description: str = described(
        "",
        "what the challenge is about, for the rule sheet; {NAME} is replaced with the value of that param",
        max_length=4000,
    )
    extends: str | None = described(
        None,
        "the base: a shipped preset (soccersim_v2, soccersim_2021, empty_field), a shipped "
        "scenario (match, …), or a relative path",
    )
    params: dict[Name, Scalar] = described(
        {}, "named values; use {param: NAME} anywhere, or {param: NAME, times: -1, plus: 0.1} to calculate with them"
    )
    tables: dict[Name, Annotated[dict[Name, RowValues], Field(min_length=1, max_length=MAX_ROWS)]] = Field(
        {},
        exclude=True,  # when a scenario has been loaded, what is repeated for their rows stands there
        description="rows with values by column; repeat_for: NAME in an entry of a section, of broadcast.fields or of "
        "a layout copies it for each row: with the rows yellow and blue, goal becomes goal_yellow and goal_blue, and "
        "balls, zones, gates and spots also a group goal; in each copy, {param: this} is the row, {param: COLUMN} its "
        "value, and {param: COLUMN, of: other} that of the other row of two; repeat_for: [A, B] copies it for each row "
        "of A with each row of B, which {param: A} and {param: B} name",
        examples=[{"teams": {"yellow": {"zone": "blue_goal"}, "blue": {"zone": "yellow_goal"}}}],
    )
    match: Match = described(Match.model_construct(), "number and length of the halves")
    field: FieldModel = described(FieldModel.model_construct(), "the field with its walls and goals")
    # Bounds far above any challenge: every pair of bodies is looked at, here and in the physics.
    balls: dict[Name, Ball] = described({}, "balls by name", max_length=64)
    obstacles: dict[Name, Obstacle] = described({}, "obstacles by name", max_length=256)
    kits: dict[Name, Kit] = described({}, "robot kits by name")
    guidelines: dict[Name, Guideline] = described({}, "limits and prices for robots that teams design", max_length=16)
    robots: dict[Name, Robot] = described(..., "robots by name", max_length=64)
    entrants: dict[Name, Entrant] = described(..., "competitors, by the name of their seat")
    zones: dict[Name, Zone] = described({}, "zones by name")
    gates: dict[Name, Gate] = described({}, "gates by name")
    spots: dict[Name, Spot] = described({}, "spots by name")
    groups: dict[Name, Annotated[tuple[Name, ...], Field(min_length=1, max_length=MAX_MEMBERS)]] = described(
        {}, "several robots, balls, obstacles, zones, gates or spots under one name", max_length=MAX_GROUPS
    )
    draws: dict[Name, Draw] = described({}, "random choices")
    roles: dict[Name, Role] = described({}, "names for those that are meant now; rules assign them")
    counters: dict[Name, Counter] = described({}, "numbers that rules change")
    flags: dict[Name, Flag] = described({}, "yes/no values that rules set")
    timers: dict[Name, Timer] = described({}, "clocks that rules start")
    sequences: dict[Name, Sequence] = described({}, "steps that must happen in order")
    placements: dict[Name, Layout] = described({}, "layouts by name")
    phases: dict[Name, Phase] = described({}, "phases other than `play`")
    first_phase: Annotated[Name, PHASE] = described("play", "the phase in which a half begins")
    rules: dict[Name, Rule] = described({}, "the rules, in the order in which they are judged")
    broadcast: Broadcast | None = described(None, "what programs receive in addition to the official packet")
    result: Result = described(Result.model_construct(), "how entrants are ranked")
    limits: Limits = described(Limits.model_construct(), "how much time, memory and disk space a program may use")
    expect: dict[Name, Expectation | MatchExpectation] = described(
        {},
        "tests of the rules, each named after what must happen; `inherited: null` removes those of the base scenario",
    )

    def dumped(self) -> dict[str, Any]:
        """Return the scenario as JSON-able data, as records keep it."""
        return self.model_dump(mode="json", by_alias=True)

    def effects(self, kind: type[_E]) -> list[_E]:
        """Return the effects of one kind that its rules have."""
        return [one for rule in self.rules.values() for one in rule.effects(kind)]
