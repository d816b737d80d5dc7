"""Actions and places as sentences."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from rcj_challenges.rules.actions import LastToucher
from rcj_challenges.rules.phrasing import counted, heading, listed, metres, number, plain, quoted, quoted_measure
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
from rcj_challenges.rules.values import CounterValue, ToldValue
from rcj_challenges.scenario.catalogue import BOUND, EACH
from rcj_challenges.views.sheet.mirrored import mirrored_aim_words, mirrored_layout_words, mirrored_words
from rcj_challenges.views.sheet.nouns import Nouns
from rcj_challenges.views.sheet.phrases import amount, lasting, metres_alike, value, within_words


def action_words(nouns: Nouns, action: Any) -> str:
    """Return an action as a clause: ``yellow gets 1 point``."""
    return ACTIONS[action.action](nouns, action)


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


def _place(nouns: Nouns, action: Any) -> str:
    if action.layout is None:
        return placing_words(nouns, action)
    layout = action.layout
    which = quoted(layout) if isinstance(layout, str) else f"the layout drawn as {quoted(layout.draw)}"
    return f"things are put as in {which}{mirrored_layout_words(nouns, action)}"


def _remove(nouns: Nouns, action: Any) -> str:
    who = nouns.all_of(action.entity)
    gone = f"{who.does('is', 'are')} taken off the field"
    if not action.for_s:
        return gone
    back = put_words(nouns, action.back_at, plural=who.plural)
    facing = _facing(nouns, action, action.back_at, plural=who.plural)
    return f"{gone} and after {lasting(nouns, action.for_s)} {back}{facing}"


def _hold(nouns: Nouns, action: Any) -> str:
    who = nouns.all_of(action.entity)
    until = f"until {'they are' if who.plural else 'it is'} let go"
    lasts = until if action.for_s is None else f"for {lasting(nouns, action.for_s)}"
    return f"{who.does('is', 'are')} held still {lasts}"


def _count(nouns: Nouns, action: Any) -> str:
    counter = nouns.every_kept("counter", action.counter, action.entity)
    bounds = bounds_words(action, "counter")
    if action.to is not None:
        return f"{counter} is set to {amount(nouns, action.to)}{bounds}"
    if isinstance(action.by, (int, float)) and action.by < 0:
        return f"{counter} falls by {amount(nouns, -action.by)}{bounds}"
    if taken := _taken(action, action.by):
        return f"{counter} falls by {amount(nouns, taken)}{bounds}"
    return f"{counter} grows by {amount(nouns, 1 if action.by is None else action.by)}{bounds}"


def bounds_words(action: Any, total: str) -> str:
    """Return how much an action pays or counts at least and at most, and how far it takes the total."""
    least, most = action.at_least, action.at_most
    amounts = [f"at {how} {number(one)}" for how, one in (("least", least), ("most", most)) if one is not None]
    ways = (("fall below", action.keeps_at_least), ("rise above", action.keeps_at_most))
    totals = [f"{way} {number(one)}" for way, one in ways if one is not None]
    said = [" and ".join(amounts), f"the {total} does not {' or '.join(totals)} by it" if totals else ""]
    return f" ({'; '.join(filter(None, said))})" if any(said) else ""


def _timer(nouns: Nouns, action: Any) -> str:
    done = {
        "restart": "starts again from 0",
        "start": "starts or goes on, unless it has run out",
        "stop": "is stopped",
        "reset": "is stopped and set to 0",
    }[action.do]
    return f"{nouns.every_kept('timer', action.timer, action.entity)} {done}"


def _draw(nouns: Nouns, action: Any) -> str:
    if action.as_ is None:
        return f"{quoted_measure(action.draw)} is drawn anew"
    who = nouns.drawn(action.draw, action.as_)
    # Of somebody whom the rule is about people say what he becomes.
    return (
        f"{quoted_measure(action.draw)} becomes {who}"
        if who.startswith("“")
        else f"{who} becomes {quoted_measure(action.draw)}"
    )


def _sequence(nouns: Nouns, action: Any) -> str:
    return f"{nouns.every_kept('sequence', action.sequence, action.entity)} begins anew"


def _set_spot(nouns: Nouns, action: Any) -> str:
    if isinstance(action.to, ToldValue):
        where = f"the position that {nouns.thing(action.to.told)} has told the referee"
    elif isinstance(action.to, str):
        of_zone = any(name in nouns.scenario.zones for name in nouns.meant(action.to))
        where = nouns.owned("centre" if of_zone else "place", action.to)
    elif isinstance(action.to, (UniformIn, OnLine)):
        where = AIMS[type(action.to)](nouns, action.to)
    else:
        where = nouns.point(action.to)
    mirrored = mirrored_words(nouns, action.mirror, action.to)
    return f"{where}{mirrored}{',' if mirrored else ''} is remembered as {nouns.thing(action.spot)}"


def _emit(nouns: Nouns, action: Any) -> str:
    told = ", ".join(f"{key}: {value(nouns, entry)}" for key, entry in action.payload.items())
    return f"{action.event} is announced" + (f" ({told})" if told else "")


def receiver_words(nouns: Nouns, entrant: Any) -> str:
    """Return who gets points: ``yellow``, or ``the team of the last to touch the ball``."""
    if isinstance(entrant, LastToucher):
        return f"the team of the last to touch {nouns.thing(entrant.last_touch)}"
    if entrant not in BOUND or entrant in nouns.scenario.entrants:
        return plain(entrant)
    return "its team" if entrant == EACH else f"the team of {nouns.thing(entrant)}"


def points_words(nouns: Nouns, action: Any) -> str:
    """Return how many points an action gives: ``2``, ``20, minus … (at least 5)``."""
    return f"{amount(nouns, action.points)}{bounds_words(action, 'score')}"


def _taken(action: Any, parts: Any) -> tuple[Any, ...]:
    """Return what is taken away, where all parts of a sum are; empty where not, or where the sum is bounded itself."""
    bounded = action.at_least is not None or action.at_most is not None
    if bounded or not isinstance(parts, tuple):
        return ()
    weights = [part if isinstance(part, (int, float)) else part.weight for part in parts]
    if any(weight >= 0 for weight in weights):
        return ()
    return tuple(
        -part if isinstance(part, (int, float)) else part.model_copy(update={"weight": -part.weight}) for part in parts
    )


def _points(nouns: Nouns, action: Any) -> str:
    who, points, bounds = receiver_words(nouns, action.entrant), action.points, bounds_words(action, "score")
    if taken := _taken(action, points):
        return f"{who} loses points: {amount(nouns, taken)}{bounds}"
    if not isinstance(points, (int, float)):
        return f"{who} gets points: {amount(nouns, points)}{bounds}"
    return f"{who} {'loses' if points < 0 else 'gets'} {counted(abs(points), 'point')}{bounds}"


def _flag(nouns: Nouns, action: Any) -> str:
    return nouns.every_kept("flag", action.flag, action.entity)


ACTIONS: dict[str, Callable[[Nouns, Any], str]] = {
    "score": _points,
    "count": _count,
    "set_flag": lambda n, a: f"{_flag(n, a)} is {'set' if a.to else 'cleared'}",
    "toggle_flag": lambda n, a: f"{_flag(n, a)} is turned over",
    "timer": _timer,
    "sequence": _sequence,
    "set_spot": _set_spot,
    "draw": _draw,
    "place": _place,
    "remove": _remove,
    "hold": _hold,
    "release": lambda n, a: f"{n.all_of(a.entity).does('is', 'are')} let go",
    "set_phase": lambda _, a: f"the phase {quoted(a.phase)} begins",
    "emit": _emit,
    "end": lambda _, a: f"the {a.what} ends" + (f" ({a.reason})" if a.reason else ""),
}

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
