"""The whole file: rules, results, limits, tests, and the sections put together."""

from typing import Annotated, Literal

from pydantic import Field

from rcj_challenges.rules.actions import AnyAction
from rcj_challenges.rules.conditions import AnyCondition
from rcj_challenges.rules.fields import DurationS, EventName, Name, One, Point, Scalar, Strict, described
from rcj_challenges.rules.message import Said
from rcj_challenges.rules.refs import COUNTER, ENTRANT, FIXED, KEEPERS, MOVING, ONE_ROBOT, PHASE, Ref, SectionRef
from rcj_challenges.rules.triggers import AnyTrigger
from rcj_challenges.rules.values import Value
from rcj_challenges.scenario.models.field import Ball, FieldModel, Match, Obstacle
from rcj_challenges.scenario.models.limits import Limits
from rcj_challenges.scenario.models.places import Gate, Layout, Spot, Zone
from rcj_challenges.scenario.models.robots import Entrant, Kit, Robot
from rcj_challenges.scenario.models.state import Counter, Draw, Flag, Phase, Sequence, Timer

SCHEMA_VERSION = 1
MAX_GROUPS = 256
MAX_MEMBERS = 512
MAX_ROWS = 64
"""Bounds far above any challenge, so that resolving groups of groups takes no time worth mentioning."""

RowValues = Annotated[dict[Name, Scalar | tuple[Scalar, ...]], Field(max_length=MAX_ROWS)]
"""What stands beside one of the names for which a rule is repeated."""

_COUNTERS = SectionRef("counter", ("counters",), keys=True)
_FLAGS = SectionRef("flag", ("flags",), keys=True)
_SCORES = SectionRef("entrant", ("entrants",), keys=True)


class Rule(Strict):
    """One trigger suffices, all conditions must hold, the actions run in order."""

    triggers: tuple[AnyTrigger, ...] = Field(..., strict=False, min_length=1, description="edges; one suffices")
    conditions: tuple[AnyCondition, ...] = Field((), strict=False, description="levels; all must hold (any_of is 'or')")
    actions: tuple[AnyAction, ...] = Field(..., strict=False, min_length=1, description="what happens, in order")
    for_each: Annotated[Name | None, KEEPERS] = described(
        None,
        "a group of entities, fixed obstacles, zones or gates, or one of them: the rule exists once for each member, "
        "named `each`",
    )
    repeat_for: (
        Annotated[tuple[Name, ...], Field(strict=False, min_length=1, max_length=MAX_ROWS)]
        | Annotated[dict[Name, RowValues], Field(min_length=1, max_length=MAX_ROWS)]
        | None
    ) = Field(
        None,
        exclude=True,  # when a scenario has been loaded, the rules that came of it stand in its place
        description="names: the rule is repeated for each name, called NAME_yellow and NAME_blue; "
        "{param: this} in it is that name, {param: KEY} is its value for KEY",
        examples=[["yellow", "blue"], {"yellow": {"zone": "blue_goal"}, "blue": {"zone": "yellow_goal"}}],
    )
    phases: Annotated[
        Literal["any"] | Annotated[tuple[Name, ...], Field(strict=False, min_length=1)],
        SectionRef("phase", ("phases",), words=frozenset({"play", "any"})),
    ] = Field(("play",), description="the phases in which it is active; any: all of them")
    priority: int = described(0, "lower fires first; equal ones in the order of the file", ge=-1000, le=1000)
    exclusive: Name | None = described(
        None,
        "of the rules of one such group only the first fires in a tick: with for_each for each member, else in all; "
        "per-member and global rules never exclude each other",
    )
    cooldown_s: DurationS | None = described(
        None, "after firing it cannot fire again for this long, in s: with for_each for this member, else for all"
    )
    max_executions: int | None = described(
        None, "how often it may fire in a half: with for_each for each member, else in all", ge=1
    )
    says: str = described("", "the sentence for the sheet, the referee's log and the page; {entity}, {each}, {other}, "
                          "{team}, {measured}, {limit}, {points} and params by name, {goal_points}, are filled in",
                          max_length=500)  # fmt: skip
    sheet: bool = described(True, "False: the rule is left out of the rule sheet")


class Broadcast(Strict):
    """What programs receive after the official packet: one JSON object a tick on the same channel."""

    fields: dict[Name, Value] = described(..., "values by key, sent to all robots")
    only: Annotated[
        dict[Name, dict[Name, Value]] | None, Ref("robot", frozenset({"robot"}), groups=True, keys=True)
    ] = described(
        None,
        "values by key that are added to the same object for one robot, or the robots of a group, only: by the "
        "name of the robot or group; for the same robot and key the later one wins",
    )
    every_ticks: int = described(1, "sent every this many ticks", ge=1, le=10_000)


class RankByScore(Strict):
    """Rank by score."""

    score: Literal["ascending", "descending"] = described(..., "which is better first")


class PlusPart(Strict):
    """Seconds added to a time for each count of a counter."""

    counter: Annotated[Name, COUNTER] = described(..., "a counter")
    weight: float = described(..., "seconds for each count")


class RankByTime(Strict):
    """Rank by the time at which the half ended, summed over halves, plus penalties."""

    time: Literal["ascending", "descending"] = described(..., "which is better first")
    plus: tuple[PlusPart, ...] = Field((), strict=False, description="seconds added by counters")


class RankByCounter(Strict):
    """Rank by a counter: kept per entity by the sum over the team's robots, summed over halves."""

    counter: Annotated[Name, COUNTER] = described(..., "a counter")
    order: Literal["ascending", "descending"] = described("descending", "which is better first")


class Result(Strict):
    """How entrants are ranked, first criterion first."""

    rank: tuple[RankByScore | RankByTime | RankByCounter, ...] = Field(
        (RankByScore(score="descending"),), strict=False, min_length=1, description="criteria; a later one breaks ties"
    )


class Keyframe(Strict):
    """A moment of a scripted play: placements by hand, touches, faults of programs, messages to the referee."""

    at_s: float = described(..., "time in the half in s", ge=0, le=86_400)
    place: Annotated[
        dict[Name, Annotated[tuple[float, ...], Field(strict=False, min_length=2, max_length=3)]],
        Ref("entity", MOVING, keys=True),
    ] = described(
        {},
        "entity -> [x, y] or [x, y, yaw] in m and rad: it is there at once; it comes into zones and through gates, "
        "but the jump does not count as speed; speed conditions fail in that tick",
    )
    move: Annotated[
        dict[Name, Annotated[tuple[float, ...], Field(strict=False, min_length=2, max_length=3)]],
        Ref("entity", MOVING, keys=True),
    ] = described(
        {},
        "entity -> [x, y] or [x, y, yaw]: it glides there in a straight line from its position at the previous "
        "keyframe; if a rule places it meanwhile, it stays there",
    )
    touch: Annotated[
        tuple[Annotated[tuple[Name, Name], Field(strict=False)], ...],
        Ref("entity or obstacle", MOVING | FIXED | {"walls"}),
    ] = Field((), strict=False, description="pairs that touch in this tick")
    touch_lasts_s: DurationS | None = described(
        None, "how long these pairs go on touching, in s; left out: in this tick only"
    )
    tips: Annotated[tuple[Name, ...], ONE_ROBOT] = Field(
        (), strict=False, description="robots that lie on their side from here on"
    )
    fault: Annotated[tuple[Name, ...], ONE_ROBOT] = Field(
        (), strict=False, description="robots whose program fails here"
    )
    tells: Annotated[dict[Name, Said | Point] | None, Ref("robot", frozenset({"robot"}), keys=True)] = described(
        None, "robot -> its message to the referee by radio: text, a number, or [x, y] in m"
    )


class ExpectedEvent(Strict):
    """An event that the test expects."""

    event: EventName = described(..., "its name")
    at_s: float | None = described(None, "when, in s; left out: any time", ge=0)
    tolerance_s: float = described(0.033, "how far off it may be, in s", ge=0)
    payload: dict[Name, Scalar] = described({}, "the part of its payload that is checked")


class Given(Strict):
    """What a test finds when its half begins, before the first rule: as if a half or a long play had come before."""

    score: Annotated[dict[Name, float], _SCORES] = described({}, "entrant -> points; left out: 0")
    counters: Annotated[dict[Name, float | dict[Name, float]], _COUNTERS] = described(
        {},
        "counter -> value, for a per-entity counter for each of them, or {entity: value, …}; left out: its initial "
        "value",
    )
    flags: Annotated[dict[Name, bool | dict[Name, bool]], _FLAGS] = described(
        {},
        "flag -> true or false, for a per-entity flag for each of them, or {entity: true or false, …}; left out: its "
        "initial value",
    )


ToldNumbers = Annotated[tuple[float, ...], Field(strict=False, min_length=2, max_length=3)]
"""A position as sent to programs."""


class Expectation(Strict):
    """A test inside the file: scripted poses and touches fed straight to the referee, and what must follow."""

    seed: int = described(1, "seed of the draws", ge=0)
    half: int = described(1, "which half is played; teams keep their seats' names in all", ge=1)
    draws: Annotated[
        dict[Name, Scalar | Annotated[tuple[Scalar, ...], Field(strict=False, min_length=1)]],
        SectionRef("draw", ("draws",), keys=True),
    ] = described(
        {},
        "draws decided beforehand: a value stands until a rule draws again; with a list, each draw takes the next "
        "value; afterwards draws are random",
    )
    spots: Annotated[
        dict[Name, Point | Annotated[tuple[Point, ...], Field(strict=False, min_length=1)]] | None,
        Ref("spot", frozenset({"spot"}), keys=True),
    ] = described(
        None,
        "where randomly set spots go, fixed beforehand: spot -> [x, y] in m for the first time, or a list of them for "
        "the first times; then chance decides again (where a spot is at the end is compared under poses)",
    )
    given: Given = described(Given(), "score, counters and flags when the half begins")
    keyframes: tuple[Keyframe, ...] = Field(..., strict=False, min_length=1, description="the script, in order of time")
    lasts_s: DurationS = described(..., "how long it is played, in s")
    events: tuple[ExpectedEvent, ...] | None = Field(
        None, strict=False, description="all events but those in `ignore`, in order; left out: not checked"
    )
    ignore: tuple[EventName, ...] = Field(
        ("MATCH_START", "KICKOFF", "MATCH_FINISH"),
        strict=False,
        description="events left out of the comparison, unless they are expected by name; a list replaces this one",
    )
    score: Annotated[dict[Name, float], _SCORES] = described({}, "score by entrant at the end")
    counters: Annotated[dict[Name, float | dict[Name, float]], _COUNTERS] = described(
        {}, "counters at the end; for a per-entity counter the sum, or {entity: value, …}"
    )
    flags: Annotated[dict[Name, bool | dict[Name, bool]], _FLAGS] = described(
        {}, "flags at the end; for a per-entity flag whether any is set, or {entity: true or false, …}"
    )
    phase: Annotated[Name | None, PHASE] = described(None, "the phase at the end")
    ranking: Annotated[
        Annotated[
            tuple[Name | Annotated[tuple[Name, ...], Field(strict=False, min_length=1)], ...],
            Field(strict=False, min_length=1),
        ]
        | None,
        ENTRANT,
    ] = described(
        None,
        "all entrants, the best first, as `result` ranks them if the match is over then; those in a list share a place",
    )
    held: Annotated[dict[Name, bool] | None, Ref("robot", frozenset({"robot"}), keys=True)] = described(
        None, "robot -> whether it is held at the end, true or false, by a rule or by the phase"
    )
    told: Annotated[
        dict[Name, dict[Name, Scalar | ToldNumbers]] | None, Ref("robot", frozenset({"robot"}), groups=True, keys=True)
    ] = described(
        None,
        "robot or group -> key -> the value in its last broadcast, [x, y] or [x, y, yaw] of a position; "
        "keys that are left out are not compared",
    )
    ended: Literal["half", "match", "none"] | None = described(
        None,
        "what is over at the end: half: the half, by a rule or by its time; match: a rule has ended the match; none: "
        "the half goes on",
    )
    poses: Annotated[
        dict[Name, Annotated[tuple[float, float], Field(strict=False)]],
        Ref("entity or spot", MOVING | frozenset({"spot"}), keys=True),
    ] = described({}, "entity or spot -> [x, y] at the end in m")
    tolerance_m: float = described(0.001, "how far off a pose may be, in m", ge=0)
    tolerance_counters: float | None = described(
        None, "how far off a counter may be, such as one that keeps a time; left out: not at all", ge=0
    )


class Scenario(Strict):
    """A challenge: field, robots, rules and everything else that decides a result."""

    schema_version: One = described(..., "version of this format: 1")
    id: Name = described(..., "short name, also of the records' folders")
    title: str = described(..., "what people call it", min_length=1, max_length=120)
    description: str = described(
        "", "what it is about, for the rule sheet; {NAME} is the value of that param", max_length=4000
    )
    extends: str | None = described(
        None, "a shipped preset (soccersim_v2, soccersim_2021, empty_field) or scenario (match, …), or a relative path"
    )
    params: dict[Name, Scalar] = described(
        {}, "named values; {param: NAME} stands for them anywhere, {param: NAME, times: -1, plus: 0.1} for one computed"
    )
    match: Match = described(Match(), "halves and their length")
    field: FieldModel = described(FieldModel(), "the field, its walls and goals")
    # Bounds far above any challenge: every pair of bodies is looked at, here and in the physics.
    balls: dict[Name, Ball] = described({}, "balls by name", max_length=64)
    obstacles: dict[Name, Obstacle] = described({}, "obstacles by name", max_length=256)
    kits: dict[Name, Kit] = described({}, "robot kits by name")
    robots: dict[Name, Robot] = described(..., "robots by name", max_length=64)
    entrants: dict[Name, Entrant] = described(..., "who competes, by the name of the seat")
    zones: dict[Name, Zone] = described({}, "zones by name")
    gates: dict[Name, Gate] = described({}, "gates by name")
    spots: dict[Name, Spot] = described({}, "spots by name")
    groups: dict[Name, Annotated[tuple[Name, ...], Field(strict=False, min_length=1, max_length=MAX_MEMBERS)]] = (
        described({}, "several robots, balls, obstacles, zones, gates or spots under one name", max_length=MAX_GROUPS)
    )
    draws: dict[Name, Draw] = described({}, "what chance decides")
    counters: dict[Name, Counter] = described({}, "numbers that rules count")
    flags: dict[Name, Flag] = described({}, "what rules remember")
    timers: dict[Name, Timer] = described({}, "clocks that rules start")
    sequences: dict[Name, Sequence] = described({}, "orders in which things must happen")
    placements: dict[Name, Layout] = described({}, "layouts by name")
    phases: dict[Name, Phase] = described({}, "phases besides play")
    first_phase: Annotated[Name, PHASE] = described("play", "the phase in which a half begins")
    rules: dict[Name, Rule] = described({}, "the rules, in the order in which they are judged")
    broadcast: Broadcast | None = described(None, "what programs receive in addition to the official packet")
    result: Result = described(Result(), "how entrants are ranked")
    limits: Limits = described(Limits(), "what a program may use")
    expect: dict[Name, Expectation] = described(
        {}, "tests of the rules, by a name that says what must happen; 'inherited: null' removes all of the base"
    )
