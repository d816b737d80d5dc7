"""Data that the physics hands to the referee, and the referee's output.

Frame everywhere: x along the short side, y along the long side, z up, origin at the centre of the field; metres,
radians, yaw counter-clockwise from +x.

An *entity* is a thing that can move and has a name: robots, balls, movable obstacles, in this order, each kind in
the order of the scenario. A *thing* is an entity, then a fixed obstacle, then (last) ``walls``; touches are pairs of
things. Both orders are fixed once by `rcj_challenges.scenario.roster.Roster`.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, NamedTuple

if TYPE_CHECKING:
    from rcj_challenges.core.changes import Change

Pose2 = tuple[float, float, float]
"""x in m, y in m, yaw in rad."""


@dataclass(frozen=True, slots=True)
class Fault:
    """A program's failure: from ``tick`` on it sends nothing and its wheels are commanded 0.

    Attributes:
        robot: the robot's name, ``Y1``.
        kind: ``crash``, ``exit``, ``start_timeout``, ``step_timeout``, ``half_timeout``, ``memory``, ``protocol``,
            ``output_flood`` or ``start`` (the process could not be started).
        tick: the tick of the half from which its wheels are commanded 0 (0: before the first tick).
        half: 1-based.
        detail: one line for the team, deterministic (no times of day, no addresses).
        traceback: the program's own traceback where there is one.
        timed: whether a limit of time was reached. Such a fault may differ from run to run.
    """

    robot: str
    kind: str
    tick: int
    half: int
    detail: str
    traceback: str = ""
    timed: bool = False


class Snapshot(NamedTuple):
    """Everything that the referee may see of one tick. The trajectory stores exactly this, for judging again.

    Attributes:
        tick: 1 for the tick that the first four sub-steps lead to.
        substeps: ``[sub-step][entity] -> (x, y, yaw)``; the last sub-step holds the judged poses. All numbers are
            float32 values (the trajectory's precision), as Python floats.
        heights: ``[entity] -> z`` of the body's centre in m.
        uprights: ``[entity] -> `` cosine of the tilt (the body's z axis on the world's); 1.0 is upright. 1.0 for balls.
        touches: ``[sub-step] -> `` pairs of thing indices, the smaller first, that touched in this sub-step.
        faults: programs that failed since the last snapshot.
        messages: radio messages to the referee since the last snapshot: (entity, text), in the order of robots, at
            most one of each. Empty if no rule uses them.
    """

    tick: int
    substeps: list[list[Pose2]]
    heights: list[float]
    uprights: list[float]
    touches: tuple[tuple[tuple[int, int], ...], ...]
    faults: tuple[Fault, ...] = ()
    messages: tuple[tuple[int, str], ...] = ()


@dataclass(frozen=True, slots=True)
class Placement:
    """Where an entity is put after the referee's output: standing, contact memory cleared, at rest but for a kick.

    Attributes:
        entity: index of the entity.
        x_m, y_m, yaw_rad: the pose; z follows from the body.
        parked: True takes it off the field instead (its pose is then the world's parking place).
        vx_mps, vy_mps: the velocity with which a ball sets off, rolling without slipping; 0 for anything else.
    """

    entity: int
    x_m: float
    y_m: float
    yaw_rad: float
    parked: bool = False
    vx_mps: float = 0.0
    vy_mps: float = 0.0


@dataclass(frozen=True, slots=True)
class Event:
    """One line of the reflog. ``tick`` counts within the half; payload keeps the order of the scenario."""

    tick: int
    name: str
    payload: dict[str, Any] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class Firing:
    """Why something happened: a rule that fired, or would have.

    Attributes:
        entity: the entity that ``each`` (or the trigger) bound, else None.
        place: the zone or gate that ``each`` bound, else None.
        settling: the number of the settling pass after the last tick in which it fired; 0: it fired in the tick.
        other: what it touched, in a rule that names ``other``, else None.
        measured: what was measured (m, s, m/s or a count; None where the word measures nothing).
        limit: the limit it was compared with, in the same unit.
        scored: points by entrant that this firing gave.
        suppressed: None if its actions ran, else why not (``exclusive``, ``cooldown``, ``max_executions``, ``phase``,
            ``no_room``: what was to be placed waits, ``phase_taken``: a rule before it set another phase, or
            ``unsettled``: it would fire after the last settling pass).
        says: the sentence for screen and log, with names filled in.
        copy: of a firing that was read from a log, the row for which its rule is repeated, else empty.
    """

    tick: int
    rule: str
    entity: str | None
    trigger: str
    measured: float | None = None
    limit: float | None = None
    scored: dict[str, int | float] = field(default_factory=dict)
    suppressed: str | None = None
    says: str = ""
    other: str | None = None
    place: str | None = None
    settling: int = 0
    copy: str = field(default="", compare=False)


@dataclass(frozen=True, slots=True)
class RefereeOutput:
    """The referee's output for one snapshot.

    Attributes:
        events: for the reflog, in order.
        firings: for the referee's own log, in order.
        placements: to be carried out now: all things are lifted first, then placed in this order.
        waiting_for_kickoff: the flag sent to programs, after the actions.
        ends_match: True if that action ended the whole match: no half follows.
        broadcast: the JSON object sent to programs in addition to the official packet, or None.
        private_broadcasts: by index of a robot, the values sent to it alone; None: nothing.
        robots_held: whether the phase holds all robots: their wheels stand braked from the next tick on, whatever
            programs command.
        held: indices of the robots that rules hold, in the same way; the same object as long as nothing changes.
        changes: what is different since the output before; of the first one, phase and counters.
    """

    events: tuple[Event, ...] = ()
    firings: tuple[Firing, ...] = ()
    placements: tuple[Placement, ...] = ()
    phase: str = "play"
    waiting_for_kickoff: bool = False
    ended: str | None = None
    ends_match: bool = False
    broadcast: dict[str, Any] | None = None
    private_broadcasts: dict[int, dict[str, Any]] | None = None
    robots_held: bool = False
    held: frozenset[int] = frozenset()
    changes: tuple[Change, ...] = ()


@dataclass(frozen=True, slots=True)
class HalfInfo:
    """What makes one half different from another.

    Attributes:
        half: 1-based.
        halves: how many are played.
        ticks: how many ticks this half judges.
        match_seed: seed of the whole match; streams add the half to their names.
        match_id: as printed in MATCH_START.
        team_names: by entrant (the side played *now*): the name of the team in that seat.
        teams: by entrant (the side played now): which entrant that team was in the first half. Identity in half 1,
            exchanged in half 2 of a match with ``swap_sides``.
        scores: points by entrant (side played now) at the start of the half.
        kept: what is marked ``keep: match``, as the previous half left it, how often rules that the match
            limits have fired, and what is left to be drawn of draws marked ``not_again: match``.
    """

    half: int
    halves: int
    ticks: int
    match_seed: int
    match_id: int
    team_names: dict[str, str]
    teams: dict[str, str]
    scores: dict[str, int | float]
    kept: dict[str, Any] = field(default_factory=dict)
