"""Places as sentences."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from rcj_challenges.rules.phrasing import heading, listed, metres, number, quoted_measure
from rcj_challenges.rules.places import (
    MAX_KICK_MPS,
    AtPoint,
    AtSpot,
    Choice,
    DrawnSpeed,
    FurthestFree,
    NearestFree,
    OnLine,
    RandomFacing,
    RelativeTo,
    Start,
    Towards,
    UniformIn,
)
from rcj_challenges.rules.values import CounterValue
from rcj_challenges.views.sheet.mirrored import mirrored_aim_words, mirrored_words
from rcj_challenges.views.sheet.phrases import amount, metres_alike, within_words

if TYPE_CHECKING:
    from rcj_challenges.views.sheet.nouns import Nouns


def put_words(nouns: Nouns, at: Any, *, plural: bool) -> str:
    """Return where something is put: ``put on the spot “centre”``.

    Args:
        nouns: what the names stand for.
        at: the place.
        plural: whether several are put there: ``put at their starts``, ``each put on the spot “centre”``.
    """
    if plural and _at_start(at):
        return "put at their starts"
    return f"{'each ' if plural else ''}put {PLACES[type(at)](nouns, at)}"


def placing_words(nouns: Nouns, placing: Any) -> str:
    """Return a placement as a clause."""
    wide = zip("xy", metres_alike(placing.noise_m), placing.noise_m, strict=True)
    noise = ", ".join(f"± {words} in {axis}" for axis, words, wide_m in wide if wide_m)
    who = nouns.all_of(placing.entity)
    if _stays(placing) and placing.kick is not None and not noise:
        return f"{who.does('rolls', 'roll')} on from where it is, {_rolling(nouns, placing)}{_clear(placing)}"
    put = put_words(nouns, placing.at, plural=who.plural)
    parts = [
        _as_beside_itself(put, nouns.thing(placing.at.relative_to)) if _is_beside_itself(placing) else put,
        f" ({noise})" if noise else "",
        mirrored_words(nouns, placing.mirror, placing.at),
        _facing(nouns, placing, placing.at, plural=who.plural),
        _clear(placing),
        _kicked(nouns, placing, several=who.plural),
    ]
    return f"{who.does('is', 'are')} {''.join(parts)}"


def _stays(placing: Any) -> bool:
    """Return whether a thing is put right where it is."""
    return _is_beside_itself(placing) and not any(placing.at.offset_m)


def _is_beside_itself(placing: Any) -> bool:
    return isinstance(placing.at, RelativeTo) and placing.at.relative_to == placing.entity


def _as_beside_itself(words: str, thing: str) -> str:
    """Return the words for a place beside a thing where that thing itself is put there: “of where it is”."""
    for of_thing, of_itself in (
        ("right at {}", "right where it is"),
        (" of {}", " of where it is"),
        ("as {} is", "as it is"),
    ):
        words = words.replace(of_thing.format(thing), of_itself)
    return words


def _at_start(at: Any) -> bool:
    return at == "start" or isinstance(at, Start)


def _facing(nouns: Nouns, action: Any, at: Any, *, plural: bool) -> str:
    """Return which way it looks afterwards, if not the way it looks at its start."""
    facing = action.facing
    if facing == "start":
        return ""
    if isinstance(facing, Towards):
        way = nouns.point(facing.towards)
    elif isinstance(facing, RandomFacing):
        way = "a random way"
    else:
        way = "the way it did before" if facing == "keep" else heading(facing)
    return f", {'each ' if plural and _at_start(at) else ''}facing {way}"


def _clear(placing: Any) -> str:
    """Return how much room it needs, and what happens if there is none."""
    gap = f", at least {metres(placing.min_clearance_m)} from everything but the walls"
    stay = ", or left where it is if there is no room"
    return (gap if placing.min_clearance_m else "") + (stay if placing.on_failure == "stay" else "")


def _kicked(nouns: Nouns, placing: Any, *, several: bool) -> str:
    """Return that it rolls off, how fast and where to."""
    if placing.kick is None:
        return ""
    return f", and {'each rolls' if several else 'rolls'} {_rolling(nouns, placing)}"


def _rolling(nouns: Nouns, placing: Any) -> str:
    """Return how fast it rolls off, and where to."""
    kick = placing.kick
    aim = AIMS[type(kick.towards)](nouns, kick.towards)
    return f"{_how_fast(nouns, kick.speed_mps)} towards {aim}{mirrored_aim_words(nouns, placing)}"


def _how_fast(nouns: Nouns, speed: Any) -> str:
    if isinstance(speed, DrawnSpeed):
        drawn = sorted({float(mps) for mps in nouns.scenario.draws[speed.draw].values})
        return f"at {listed([number(mps) for mps in drawn], 'or')} m/s, as {quoted_measure(speed.draw)} is drawn,"
    if isinstance(speed, CounterValue):
        return f"at as many m/s as {amount(nouns, speed)} tells, {MAX_KICK_MPS} at most,"
    speeds = speed if isinstance(speed, tuple) else (speed,)
    return f"at {' to '.join(dict.fromkeys(map(number, speeds)))} m/s"


def _beside(nouns: Nouns, at: Any) -> str:
    """Return a place that is told by how far it is from something."""
    who = nouns.thing(at.relative_to)
    ways = (("to the front", "to the back"), ("to the left", "to the right"))
    if not at.turns:
        ways = (("towards +x", "towards -x"), ("towards +y", "towards -y"))
    how_far = metres_alike([abs(far) for far in at.offset_m])
    steps = [
        f"{words} {way[0] if far > 0 else way[1]}"
        for far, words, way in zip(at.offset_m, how_far, ways, strict=True)
        if far
    ]
    if not steps:
        return f"right at {who}"
    return f"{listed(steps, 'and')} of {who}" + (f", as {who} is turned" if at.turns else "")


def _aim_beside(nouns: Nouns, at: Any) -> str:
    where = _beside(nouns, at)
    return f"the point {where}" if any(at.offset_m) else nouns.thing(at.relative_to)


def _aim_on(nouns: Nouns, at: Any) -> str:
    return PLACES[type(at)](nouns, at).removeprefix("on ")


def _free(nouns: Nouns, how: str, spots: Any, at: Any, of: Any) -> str:
    own = f" ({gap.strip()})" if (gap := within_words(at.clearance_m)) else ""
    those = f"that free one{own} of {nouns.all_of(spots).text} which is"
    if at.choose_among > 1:
        those = f"a random one of those {at.choose_among} free ones{own} of {nouns.all_of(spots).text} which are"
    near = "where it is" if of is None else nouns.point(of)
    return f"on {those} {how} {'to' if how == 'nearest' else 'from'} {near}"


def put_back_words(nouns: Nouns, removal: Any) -> str:
    """Return where what is removed comes back to, and which way it looks."""
    plural = nouns.all_of(removal.entity).plural
    facing = _facing(nouns, removal, removal.back_at, plural=plural)
    return f"{put_words(nouns, removal.back_at, plural=plural)}{facing}"


PLACES: dict[type, Callable[[Nouns, Any], str]] = {
    str: lambda _n, _a: "at its start",
    Start: lambda _n, _a: "at its start",
    AtPoint: lambda n, a: f"at {n.point(a.point)}",
    AtSpot: lambda n, a: f"on {n.thing(a.spot)}",
    UniformIn: lambda n, a: f"anywhere in {n.any_of(a.uniform_in)}",
    OnLine: lambda n, a: f"anywhere on the line from {n.point(a.on_line[0])} to {n.point(a.on_line[1])}",
    Choice: lambda n, a: (
        f"on {listed([n.any_of(one) if isinstance(one, str) else n.point(one) for one in a.choice], 'or')}"
    ),
    NearestFree: lambda n, a: _free(n, "nearest", a.nearest_free, a, a.to),
    FurthestFree: lambda n, a: _free(n, "furthest", a.furthest_free, a, a.from_),
    RelativeTo: _beside,
}

AIMS: dict[type, Callable[[Nouns, Any], str]] = {
    str: lambda _n, _a: "its start",
    Start: lambda _n, _a: "its start",
    AtPoint: lambda n, a: n.point(a.point),
    AtSpot: lambda n, a: n.thing(a.spot),
    UniformIn: lambda n, a: f"a random point of {n.any_of(a.uniform_in)}",
    OnLine: lambda n, a: f"a random point of the line from {n.point(a.on_line[0])} to {n.point(a.on_line[1])}",
    Choice: _aim_on,
    NearestFree: _aim_on,
    FurthestFree: _aim_on,
    RelativeTo: _aim_beside,
}
"""The same places as what a kick is aimed at."""
