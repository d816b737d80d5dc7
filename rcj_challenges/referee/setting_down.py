"""Carrying out placements: all are lifted first, then set down in order, so that two never get one spot."""

from __future__ import annotations

import random
import sys
from collections.abc import Callable
from dataclasses import dataclass, replace
from math import sqrt

from rcj_challenges.facts.play import Placement, Pose2
from rcj_challenges.referee.bodies import Bodies
from rcj_challenges.referee.state import State, float32
from rcj_challenges.tracking.bound_rules import BoundRule

Point = tuple[float, float]
Velocity = tuple[float, float]
"""Of x and y, in m/s."""

_ALL_ATTEMPTS = sys.maxsize
_AT_REST: Velocity = (0.0, 0.0)

ATTEMPTS_WAITING = 4
"""How often a random place is drawn on each further tick, once all attempts of the first were in vain: a good
hundred in a second. All of them on every tick cost the referee more time than everything else that it does."""


class Board:
    """The field while things are set down.

    Attributes:
        poses: by entity, where it is: set down already, or not moved, or (lifted) where it was.
        standing: those that stand on the field now, by index: not moved, or set down already.
    """

    def __init__(self, state: State, bodies: Bodies, lifted: set[int]) -> None:
        self._state = state
        self._bodies = bodies
        self.poses = list(state.poses)
        self.standing = {
            index: pose for index, pose in enumerate(state.poses) if state.present[index] and index not in lifted
        }
        self._judged = state.roster.robots + state.roster.balls

    def put(self, entity: int, pose: Pose2) -> None:
        """Set an entity down."""
        self.poses[entity] = pose
        self.standing[entity] = pose

    def free(self, spot: Point, clearance_m: float, entity: int | None) -> bool:
        """Return whether no robot's or ball's centre is nearer to a spot than the clearance.

        Args:
            spot: [x, y] in m.
            clearance_m: strict limit in m.
            entity: the one that is to be put there, if any: its own present place counts as well.
        """
        centres = [pose for index, pose in self.standing.items() if index < self._judged and index != entity]
        if entity is not None and entity < self._judged and self._state.present[entity]:
            centres.append(self._state.poses[entity])
        limit = clearance_m * clearance_m
        return all((x - spot[0]) ** 2 + (y - spot[1]) ** 2 >= limit for x, y, _ in centres)

    def fits(self, entity: int, pose: Pose2, clearance_m: float) -> bool:
        """Return whether an entity can stand at a pose without overlapping anything."""
        others = {index: other for index, other in self.standing.items() if index != entity}
        return self._bodies.fits(entity, pose, others, clearance_m)


Mirrored = Callable[[Point], Point]


@dataclass(frozen=True, slots=True)
class Request:
    """What a place is looked for: passed to the compiled words of ``at``.

    Attributes:
        board: the field now.
        entity: index of what is to be put there.
        mirrored: mirrors a point as the scenario asks (or not).
        rng: the stream of this use.
        fits: whether the entity can stand at a point, with the facing it will have.
    """

    board: Board
    entity: int
    mirrored: Mirrored
    rng: random.Random
    fits: Callable[[Point], bool]


@dataclass(frozen=True)
class Where:
    """A compiled word of ``at``.

    Attributes:
        find: returns a point, or None if there is none (no free spot).
        random: whether another attempt can give another point.
        noise_m: half widths of noise that the place itself brings along (a start pose's).
    """

    find: Callable[[Request], Point | None]
    random: bool = False
    noise_m: Point = (0.0, 0.0)


@dataclass(frozen=True)
class Kick:
    """How a ball rolls away from where it is put.

    Attributes:
        towards: the compiled place that it is aimed at.
        speeds_mps: returns the least and the most as they are now; every speed between is equally likely, and at 0 or
            less it lies still.
    """

    towards: Where
    speeds_mps: Callable[[], tuple[float, float]]

    def velocity(self, request: Request, here: Point) -> Velocity | None:
        """Return the velocity at a point; None if there is nothing to aim at (no free spot)."""
        aim = self.towards.find(request)
        if aim is None:
            return None
        least, most = self.speeds_mps()
        if most <= 0:
            return _AT_REST
        speed = least if least == most else request.rng.uniform(least, most)
        # Places are float32 numbers: put where it is aimed at, it has no way to go.
        dx, dy = float32(aim[0]) - here[0], float32(aim[1]) - here[1]
        far = sqrt(dx * dx + dy * dy)
        return (float32(speed * dx / far), float32(speed * dy / far)) if far else _AT_REST


@dataclass(frozen=True)
class Putting:
    """How one entity is put somewhere.

    Attributes:
        entity: its index.
        where: the compiled place.
        facing: returns the yaw in rad for a point; gets the board, the entity, the point and the stream.
        spins: whether the facing is random, so that another attempt can fit where this one did not.
        follows: whether it faces something that may be put elsewhere in the same tick.
        noise_m: half widths of the uniform noise on x and y, in m.
        flips: each returns the signs of x and y (-1 mirrors).
        clearance_m: smallest gap to any other body.
        attempts: how often a random place is drawn at first.
        retry: whether it is tried again on every tick while there is no room, `ATTEMPTS_WAITING` times at most.
        stream: name of the random stream.
        kick: how it rolls away from there; None: it lies still.
    """

    entity: int
    where: Where
    facing: Callable[[Board, int, Point, random.Random], float]
    spins: bool
    follows: bool
    noise_m: Point
    flips: tuple[Callable[[], Point], ...]
    clearance_m: float
    attempts: int
    retry: bool
    stream: str
    kick: Kick | None = None

    def signs(self) -> Point:
        """Return the signs of x and y with all mirrors as they are now."""
        sign_x, sign_y = 1.0, 1.0
        for flip in self.flips:
            flip_x, flip_y = flip()
            sign_x, sign_y = sign_x * flip_x, sign_y * flip_y
        return sign_x, sign_y

    @property
    def _noises(self) -> list[Point]:
        return [noise for noise in (self.where.noise_m, self.noise_m) if noise != (0.0, 0.0)]

    @property
    def is_random(self) -> bool:
        """Whether another attempt can give another pose."""
        return self.where.random or self.spins or bool(self._noises)

    def request(self, board: Board, rng: random.Random, signs: Point) -> Request:
        """Return with what a place for the entity is looked for."""
        sign_x, sign_y = signs

        def mirrored(point: Point) -> Point:
            return (point[0] * sign_x, point[1] * sign_y)

        def fits(point: Point) -> bool:
            return board.fits(self.entity, self.pose_at(board, point, rng), self.clearance_m)

        return Request(board, self.entity, mirrored, rng, fits)

    def propose(self, board: Board, rng: random.Random, signs: Point, most_attempts: int) -> Pose2 | None:
        """Return a pose at which the entity can stand, or None if so many attempts find none."""
        request, noises = self.request(board, rng, signs), self._noises
        for _ in range(min(self.attempts, most_attempts) if self.is_random else 1):
            point = self.where.find(request)
            if point is None:
                return None
            for noise_x, noise_y in noises:
                point = (point[0] + rng.uniform(-noise_x, noise_x), point[1] + rng.uniform(-noise_y, noise_y))
            pose = self.pose_at(board, point, rng)
            if board.fits(self.entity, pose, self.clearance_m):
                return pose
        return None

    def set_off(self, board: Board, state: State, signs: Point) -> Velocity | None:
        """Return with which velocity it leaves the place where the board has it; None if it finds nothing to aim at."""
        if self.kick is None:
            return _AT_REST
        # A stream of its own: with or without a kick, chance puts things at the same places.
        request = self.request(board, state.stream(f"{self.stream}/kick"), signs)
        x, y, _ = board.poses[self.entity]
        return self.kick.velocity(replace(request, fits=lambda _point: True), (x, y))

    def pose_at(self, board: Board, point: Point, rng: random.Random) -> Pose2:
        """Return the pose that the entity has at a point."""
        yaw = self.facing(board, self.entity, point, rng)
        return (float32(point[0]), float32(point[1]), float32(yaw))


@dataclass(frozen=True, eq=False)
class Job:
    """A placement that a rule asked for.

    Attributes:
        entity: index of the entity.
        putting: how it is set down; None takes it off the field.
        rule: the rule that asked; a retry waits while the rule does not live. None: the start of the half.
        due: from which tick on it is to be done.
        signs: of x and y, as the mirrors stood when it was asked for; a retry keeps them.
        comes_back: whether it brings back what was taken off for a time: that waits for no phase.
        instead_of: what would have brought the entity back; that goes on to wait if this finds no room and gives up.
        told: whether it found no room already, and the log says so.
        aimless: whether it failed for want of something to kick it at.
    """

    entity: int
    putting: Putting | None
    rule: BoundRule | None
    due: int = 0
    signs: Point = (1.0, 1.0)
    comes_back: bool = False
    instead_of: Job | None = None
    told: bool = False
    aimless: bool = False

    @property
    def most_attempts(self) -> int:
        """How often a random place may be drawn for it in this tick, however many its placement allows."""
        return ATTEMPTS_WAITING if self.told else _ALL_ATTEMPTS


class Queue:
    """The placements asked for in this tick, and those still waiting for room or for their time."""

    def __init__(self) -> None:
        self._asked: dict[int, Job] = {}
        self._waiting: dict[int, Job] = {}

    @property
    def busy(self) -> bool:
        """Whether there is anything to do or to wait for."""
        return bool(self._asked) or bool(self._waiting)

    def ask(self, job: Job) -> None:
        """Queue a placement; the last one queued for an entity wins, also over one that waits."""
        before = self._asked.pop(job.entity, None)
        waited = self._waiting.pop(job.entity, before.instead_of if before is not None else None)
        if waited is not None and waited.comes_back:
            job = replace(job, instead_of=waited)
        self._asked[job.entity] = job

    def ask_later(self, job: Job) -> None:
        """Note a placement for a later tick; any placement of that entity asked for after this one replaces it."""
        self._waiting[job.entity] = job

    def concerns(self, entity: int) -> bool:
        """Return whether something is asked for the entity."""
        return entity in self._asked or entity in self._waiting

    def take(self, state: State) -> list[Job]:
        """Return what is to be done in this tick: what waited first, then what was asked for, in order."""
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


def set_down(jobs: list[Job], state: State, bodies: Bodies) -> tuple[list[Placement], list[Job]]:
    """Carry out placements: update the state, and return what the world has to do, and the jobs without room.

    One that finds no room stays where it is. As others may have counted on its place, everything is then set down
    again around it.
    """
    failed: list[Job] = []
    while True:
        without = {job.entity for job in failed}
        tried = [job for job in jobs if job.entity not in without]
        done, without_room = _try(tried, state, bodies)
        if without_room is None:
            return _apply(done, state), failed
        failed.append(without_room)


_Done = tuple[int, Pose2 | None, Velocity]
"""An entity, where it is now (None: off the field), and how it moves on from there."""


def _try(jobs: list[Job], state: State, bodies: Bodies) -> tuple[list[_Done], Job | None]:
    board = Board(state, bodies, {job.entity for job in jobs})
    done: list[_Done] = []
    for job in jobs:
        if job.putting is None:
            done.append((job.entity, None, _AT_REST))
            continue
        pose = job.putting.propose(board, state.stream(job.putting.stream), job.signs, job.most_attempts)
        if pose is None:
            return [], job
        board.put(job.entity, pose)
        velocity = job.putting.set_off(board, state, job.signs)
        if velocity is None:
            return [], replace(job, aimless=True)
        done.append((job.entity, pose, velocity))
    return _turned(done, jobs, board, state), None


def _turned(done: list[_Done], jobs: list[Job], board: Board, state: State) -> list[_Done]:
    """Turn those that face something towards where it is now: it may have been put there after them.

    Who has no room to turn goes on to look where it was.
    """
    turned: list[_Done] = []
    for (entity, pose, velocity), job in zip(done, jobs, strict=True):
        if pose is not None and job.putting is not None and job.putting.follows:
            other = job.putting.pose_at(board, pose[:2], state.stream(job.putting.stream))
            if other != pose and board.fits(entity, other, job.putting.clearance_m):
                board.put(entity, other)
                pose = other  # noqa: PLW2901
        turned.append((entity, pose, velocity))
    return turned


def _apply(done: list[_Done], state: State) -> list[Placement]:
    poses, uprights = list(state.poses), list(state.uprights)
    placements = []
    for entity, pose, (vx_mps, vy_mps) in done:
        if pose is None:
            state.present[entity] = False
            placements.append(Placement(entity, *poses[entity], parked=True))
            continue
        state.present[entity] = True
        state.put_at[entity] = (pose[0], pose[1])
        poses[entity] = pose
        uprights[entity] = 1.0
        placements.append(Placement(entity, *pose, vx_mps=vx_mps, vy_mps=vy_mps))
    state.poses, state.uprights = poses, uprights
    return placements
