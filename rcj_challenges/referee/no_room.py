"""Explains why something found no room: the sentence for the referee's log, once for each placement."""

from __future__ import annotations

import random

from rcj_challenges.core.play import Pose2
from rcj_challenges.referee.bodies import Bodies
from rcj_challenges.referee.placement import PlacementJob, PlacementSpec
from rcj_challenges.referee.placement_board import PlacementBoard
from rcj_challenges.referee.state import State


def no_room_sentence(job: PlacementJob, spec: PlacementSpec, state: State, bodies: Bodies) -> str:
    """Return what happens to an entity that could not be set down, and why.

    Args:
        job: the placement that found no room.
        spec: how it was to be set down.
        state: after all others were set down.
        bodies: outlines.
    """
    name = state.roster.entities[job.entity]
    stays = "where it is" if state.present[job.entity] else "off the field"
    what = "waits for room" if spec.retry else f"stays {stays} for want of room"
    return f"{name} {what}: {_reason(job, spec, PlacementBoard(state, bodies, set()), state, bodies)}"


def _reason(job: PlacementJob, spec: PlacementSpec, board: PlacementBoard, state: State, bodies: Bodies) -> str:
    # A separate random stream: the search for a reason must not change later draws.
    rng = random.Random(0)  # noqa: S311 - decides nothing
    point = spec.where.find(spec.request(board, rng, job.signs))
    if point is None:
        return "no spot is free"
    if job.aimless:
        return "its kick finds nothing to aim at"
    if spec.is_random:
        return f"chance found none in {spec.attempts} attempts"
    pose = spec.pose_at(board, point, rng)
    if not bodies.fits(job.entity, pose, {}, spec.clearance_m):
        return "a wall or a fixed obstacle is there"
    found = _in_the_way(job.entity, pose, spec.clearance_m, board, bodies)
    if not found:
        return "there was none when it was put"
    names = [state.roster.entities[entity] for entity in found]
    are = "is" if len(names) == 1 else "are"
    where = f"nearer than {spec.clearance_m:g} m" if spec.clearance_m else "there"
    return f"{' and '.join(names)} {are} {where}"


def _in_the_way(entity: int, pose: Pose2, clearance_m: float, board: PlacementBoard, bodies: Bodies) -> list[int]:
    return [
        other
        for other, there in sorted(board.standing.items())
        if other != entity and not bodies.fits(entity, pose, {other: there}, clearance_m)
    ]
