"""The sentences of the referee's log: what a rule says when it fires, and why something found no room."""

from __future__ import annotations

import random
import re

from rcj_challenges.core.amounts import add_up, distinct_decimals, number_words, round_score
from rcj_challenges.referee.bodies import Bodies, PlacementBoard
from rcj_challenges.referee.placement import PlacementJob, PlacementSpec
from rcj_challenges.referee.state import State
from rcj_challenges.rules.phrasing import plain, spelled
from rcj_challenges.rules.values.word import team_name_of
from rcj_challenges.scenario.placeholders import counted
from rcj_challenges.tracking.bound_rules import Firing

_DECIMALS = 3


def fill_blanks(says: str, state: State, firing: Firing) -> str:
    """Return the sentence with what is known only when a rule fires; counters, draws and roles as it leaves them."""
    if "{" not in says:
        return says
    points = str(round_score(add_up(firing.scored.values())))
    decimals = distinct_decimals(firing.measured, firing.limit, _DECIMALS)
    filled = {
        "entity": plain(firing.subject or ""),
        "each": plain(firing.rule.each or ""),
        "other": plain(firing.rule.other or ""),
        "others": " and ".join(map(plain, firing.rule.others)),
        "team": team_name_of(state, firing, None),
        "measured": _format_number(firing.measured, decimals),
        "limit": _format_number(firing.limit, decimals),
        "points": points,
    }

    def fill(found: re.Match[str]) -> str:
        name, after = found.groups()
        if name not in filled:
            is_known = name in state.draws or name in state.counters
            return f"{_named(name, state, firing)}{after}" if is_known else found[0]
        return counted(points) if after and name == "points" else f"{filled[name]}{after}"

    # One pass from left to right, so that a team called "{limit}" stays just that.
    return re.sub(r"\{(\w+)\}((?: points\b)?)", fill, says)


def _named(name: str, state: State, firing: Firing) -> str:
    """Return what a counter, a draw or a role is now: of a counter that each has, that of the rule's own."""
    if name in state.draws:
        drawn = state.draws[name]
        return "none" if drawn is None else plain(spelled(drawn))
    kept = state.counters[name]
    owned = kept if isinstance(kept, dict) else {}
    owner = next((one for one in (firing.rule.each, firing.rule.entrant, firing.subject) if one in owned), None)
    return _format_number(state.counter(name, owner), _DECIMALS) or "none"


def _format_number(number: float | None, decimals: int) -> str:
    return "" if number is None else number_words(number, decimals)


def no_room_sentence(job: PlacementJob, spec: PlacementSpec, state: State, bodies: Bodies) -> str:
    """Return the sentence about an entity that could not be set down, and why, once all others are set down."""
    name = state.names[job.entity]
    stays = "where it is" if state.present[job.entity] else "off the field"
    what = "waits for room" if spec.how.on_failure == "retry" else f"stays {stays} for want of room"
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
        return f"chance found none in {spec.how.max_attempts} attempts"
    pose = spec.pose_at(board, point, rng)
    if not bodies.fits(job.entity, pose, {}, spec.how.min_clearance_m):
        return "a wall or a fixed obstacle is there"
    found = [
        other
        for other, there in sorted(board.on_field.items())
        if other != job.entity and not bodies.fits(job.entity, pose, {other: there}, spec.how.min_clearance_m)
    ]
    if not found:
        return "there was none when it was put"
    names = [state.names[entity] for entity in found]
    are = "is" if len(names) == 1 else "are"
    gap_m = spec.how.min_clearance_m
    where = f"nearer than {gap_m:g} m" if gap_m else "there"
    return f"{' and '.join(names)} {are} {where}"
