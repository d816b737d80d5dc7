"""Carries out placements: all are lifted first, then placed in order, so that two never get one spot."""

from __future__ import annotations

import random
from dataclasses import dataclass, replace
from math import sqrt
from typing import TYPE_CHECKING

from rcj_challenges.core.play import Placement, Pose2
from rcj_challenges.referee.bodies import Bodies, PlacementBoard
from rcj_challenges.referee.state import State, float32
from rcj_challenges.rules.placement import RandomFacing, Towards, compile_facing
from rcj_challenges.tracking.bound_rules import BoundRule
from rcj_challenges.tracking.places import CompiledFacing, CompiledKick, PlaceRequest, PlaceResolver, Point

if TYPE_CHECKING:
    from rcj_challenges.rules.binder import Scope
    from rcj_challenges.rules.effects import Places
    from rcj_challenges.rules.placement import Mirror
    from rcj_challenges.rules.placement import Placement as WrittenPlacement

Velocity = tuple[float, float]
"""Of x and y, in m/s."""

AT_REST: Velocity = (0.0, 0.0)

ATTEMPTS_WAITING = 4
"""How often a random place is drawn on each further tick, once all attempts of the first were in vain: a good
hundred in a second. All of them on every tick cost the referee more time than everything else that it does."""


@dataclass(frozen=True)
class PlacementSpec:
    """How one entity is put somewhere.

    Attributes:
        facing: returns the yaw in rad for a point; gets the board, the point and the stream.
        kick: how it rolls away from there; None: it lies still.
    """

    how: WrittenPlacement
    mirrors: tuple[Mirror, ...]
    entity: int
    where: PlaceResolver
    facing: CompiledFacing
    stream: str
    kick: CompiledKick | None = None

    def signs_now(self, state: State) -> Point:
        """Return the signs of x and y (-1 mirrors) with all mirrors as they are now."""
        sign_x, sign_y = 1.0, 1.0
        for mirror in self.mirrors:
            turn_x, turn_y = mirror.signs(state)
            sign_x, sign_y = sign_x * turn_x, sign_y * turn_y
        return sign_x, sign_y

    @property
    def _noises(self) -> list[Point]:
        return [noise for noise in (self.where.noise_m, self.how.noise_m) if noise != (0.0, 0.0)]

    @property
    def is_random(self) -> bool:
        """Whether another attempt can give another pose."""
        return self.where.random or isinstance(self.how.facing, RandomFacing) or bool(self._noises)

    def request(self, board: PlacementBoard, rng: random.Random, signs: Point) -> PlaceRequest:
        """Return with what a place for the entity is looked for."""
        sign_x, sign_y = signs

        def mirrored(point: Point) -> Point:
            return (point[0] * sign_x, point[1] * sign_y)

        def fits(point: Point) -> bool:
            return board.fits(self.entity, self.pose_at(board, point, rng), self.how.min_clearance_m)

        return PlaceRequest(board, self.entity, mirrored, rng, fits)

    def propose(self, board: PlacementBoard, rng: random.Random, job: PlacementJob) -> Pose2 | None:
        """Return a pose at which the entity can stand, or None if all attempts of this tick find none."""
        request, noises = self.request(board, rng, job.signs), self._noises
        attempts = min(self.how.max_attempts, ATTEMPTS_WAITING) if job.is_logged else self.how.max_attempts
        for _ in range(attempts if self.is_random else 1):
            point = self.where.find(request)
            if point is None:
                return None
            for noise_x, noise_y in noises:
                point = (point[0] + rng.uniform(-noise_x, noise_x), point[1] + rng.uniform(-noise_y, noise_y))
            pose = self.pose_at(board, point, rng)
            if board.fits(self.entity, pose, self.how.min_clearance_m):
                return pose
        return None

    def velocity(self, board: PlacementBoard, state: State, signs: Point) -> Velocity | None:
        """Return with which velocity it leaves the place where the board has it; None if it finds nothing to aim at."""
        if self.kick is None:
            return AT_REST
        # A separate stream: with or without a kick, random places are the same.
        request = replace(self.request(board, state.stream(f"{self.stream}/kick"), signs), fits=lambda _point: True)
        aim = self.kick.towards.find(request)
        if aim is None:
            return None
        least, most = self.kick.speeds_mps()
        if most <= 0:
            return AT_REST
        speed = least if least == most else request.rng.uniform(least, most)
        # Places are float32 numbers: put where it is aimed at, it has no way to go.
        x, y, _ = board.poses[self.entity]
        dx, dy = float32(aim[0]) - x, float32(aim[1]) - y
        far = sqrt(dx * dx + dy * dy)
        return (float32(speed * dx / far), float32(speed * dy / far)) if far else AT_REST

    def pose_at(self, board: PlacementBoard, point: Point, rng: random.Random) -> Pose2:
        """Return the pose that the entity has at a point."""
        yaw = self.facing(board, point, rng)
        return (float32(point[0]), float32(point[1]), float32(yaw))


def compile_placement(put: Places, to: Scope, entity: int, stream: str) -> PlacementSpec:
    """Return the placement of an entity, given by its index; its random numbers come from the stream of that name."""
    how = put.how
    return PlacementSpec(
        how=how,
        mirrors=put.mirrors,
        entity=entity,
        where=put.at.compile(to, entity),
        facing=compile_facing(how.facing, to, entity),
        stream=stream,
        kick=None if how.kick is None else how.kick.compile(to, entity),
    )


@dataclass(frozen=True, eq=False)
class PlacementJob:
    """A placement that a rule asked for.

    Attributes:
        spec: how it is set down; None takes it off the field.
        rule: the rule that asked; a retry waits while the rule is inactive. None: the start of the half.
        due: from which tick on it is to be done.
        signs: of x and y, as the mirrors stood when it was asked for; a retry keeps them.
        comes_back: whether it brings back what was taken off for a time: that waits for no phase.
        instead_of: what would have brought the entity back; that goes on to wait if this finds no room and gives up.
        is_logged: whether it found no room before, which is in the log.
        aimless: whether it failed for want of something to kick it at.
    """

    entity: int
    spec: PlacementSpec | None
    rule: BoundRule | None
    due: int = 0
    signs: Point = (1.0, 1.0)
    comes_back: bool = False
    instead_of: PlacementJob | None = None
    is_logged: bool = False
    aimless: bool = False


class PlacementQueue:
    """The placements asked for in this tick, and those still waiting for room or for their time."""

    def __init__(self) -> None:
        self._asked: dict[int, PlacementJob] = {}
        self._waiting: dict[int, PlacementJob] = {}

    @property
    def busy(self) -> bool:
        """Whether any placement is due or waiting."""
        return bool(self._asked) or bool(self._waiting)

    def ask(self, job: PlacementJob) -> None:
        """Queue a placement; the last one queued for an entity wins, also over one that waits."""
        before = self._asked.pop(job.entity, None)
        waited = self._waiting.pop(job.entity, before.instead_of if before is not None else None)
        if waited is not None and waited.comes_back:
            job = replace(job, instead_of=waited)
        self._asked[job.entity] = job

    def ask_later(self, job: PlacementJob) -> None:
        """Note a placement for a later tick; any placement of that entity asked for after this one replaces it."""
        self._waiting[job.entity] = job

    def forget(self, entity: int) -> None:
        """Forget what waits for an entity."""
        self._waiting.pop(entity, None)

    def concerns(self, entity: int) -> bool:
        """Return whether something is asked for the entity."""
        return entity in self._asked or entity in self._waiting

    def take(self, state: State) -> list[PlacementJob]:
        """Return the placements of this tick: those that waited, then the new ones, in order."""
        ready = [
            job
            for job in self._waiting.values()
            if job.due <= state.tick
            and job.entity not in self._asked
            and (job.rule is None or job.comes_back or job.rule.is_active_in(state.phase))
        ]
        for job in ready:
            del self._waiting[job.entity]
        jobs = ready + list(self._asked.values())
        self._asked.clear()
        return jobs


def carry_out(jobs: list[PlacementJob], state: State, bodies: Bodies) -> tuple[list[Placement], list[PlacementJob]]:
    """Carry out placements: update the state, and return what the world has to do, and the jobs without room.

    One that finds no room stays where it is. As others may have counted on its place, everything is then set down
    again around it.
    """
    failed: list[PlacementJob] = []
    while True:
        without = {job.entity for job in failed}
        tried = [job for job in jobs if job.entity not in without]
        done, without_room = _try(tried, state, bodies)
        if without_room is None:
            return apply_placements(done, state), failed
        failed.append(without_room)


_Done = tuple[int, Pose2 | None, Velocity]
"""An entity, where it is now (None: off the field), and how it moves on from there."""


def _try(jobs: list[PlacementJob], state: State, bodies: Bodies) -> tuple[list[_Done], PlacementJob | None]:
    board = PlacementBoard(state, bodies, {job.entity for job in jobs})
    done: list[_Done] = []
    for job in jobs:
        if job.spec is None:
            done.append((job.entity, None, AT_REST))
            continue
        pose = job.spec.propose(board, state.stream(job.spec.stream), job)
        if pose is None:
            return [], job
        board.place(job.entity, pose)
        velocity = job.spec.velocity(board, state, job.signs)
        if velocity is None:
            return [], replace(job, aimless=True)
        done.append((job.entity, pose, velocity))
    return _turned(done, jobs, board, state), None


def _turned(done: list[_Done], jobs: list[PlacementJob], board: PlacementBoard, state: State) -> list[_Done]:
    """Turn those that face something towards where it is now: it may have been put there after them.

    What has no room to turn keeps its facing.
    """
    turned: list[_Done] = []
    for (entity, pose, velocity), job in zip(done, jobs, strict=True):
        if pose is not None and job.spec is not None and isinstance(job.spec.how.facing, Towards):
            other = job.spec.pose_at(board, pose[:2], state.stream(job.spec.stream))
            if other != pose and board.fits(entity, other, job.spec.how.min_clearance_m):
                board.place(entity, other)
                pose = other  # noqa: PLW2901
        turned.append((entity, pose, velocity))
    return turned


def apply_placements(done: list[_Done], state: State) -> list[Placement]:
    """Update the state, and return what the world has to do."""
    poses, uprights = list(state.poses), list(state.uprights)
    placements = []
    for entity, pose, (vx_mps, vy_mps) in done:
        if pose is None:
            state.present[entity] = False
            placements.append(Placement(entity, *poses[entity], parked=True))
            continue
        state.present[entity] = True
        state.placed_at[entity] = pose
        poses[entity] = pose
        uprights[entity] = 1.0
        placements.append(Placement(entity, *pose, vx_mps=vx_mps, vy_mps=vy_mps))
    state.poses, state.uprights = poses, uprights
    return placements
