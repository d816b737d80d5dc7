"""Actions and places as sentences."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from rcj_challenges.scenario.models import places
from rcj_challenges.views.sheet.nouns import Nouns, listed, plain, quoted
from rcj_challenges.views.sheet.phrases import amount, metres, seconds, value


def action_words(nouns: Nouns, action: Any) -> str:
    """Return an action as a clause: ``yellow gets 1 point``."""
    return ACTIONS[action.action](nouns, action)


def put_words(nouns: Nouns, at: Any, *, plural: bool = False) -> str:
    """Return where something is put: ``put on the spot “centre”``.

    Args:
        nouns: what the names stand for.
        at: the place.
        plural: whether several are put there: ``put at their starts``, ``each put on the spot “centre”``.
    """
    if plural and (at == "start" or isinstance(at, places.Start)):
        return "put at their starts"
    return f"{'each ' if plural else ''}put {PLACES[type(at)](nouns, at)}"


def placing_words(nouns: Nouns, placing: Any) -> str:
    """Return a placement as a clause."""
    x, y = placing.noise_m
    noise = f" (± {metres(x)} in x, ± {metres(y)} in y)" if x or y else ""
    who = nouns.all_of(placing.entity)
    where = put_words(nouns, placing.at, plural=who.plural)
    return f"{who.does('is', 'are')} {where}{noise}{_mirrored(nouns, placing.mirror)}"


def _mirrored(nouns: Nouns, mirror: Any) -> str:
    if mirror is None:
        return ""
    turned = listed([f"{axis} becomes -{axis}" for axis in ("x", "y") if mirror.axis in (axis, "both")], "and")
    return f", mirrored ({turned})" + (f" if {nouns.kept('flag', mirror.when, None)} is set" if mirror.when else "")


def _free(nouns: Nouns, how: str, spots: Any, among: int, of: Any) -> str:
    those = f"that free one of {nouns.all_of(spots).text} which is"
    if among > 1:
        those = f"a random one of those {among} free ones of {nouns.all_of(spots).text} which are"
    near = "where it is" if of is None else nouns.point(of)
    return f"on {those} {how} {'to' if how == 'nearest' else 'from'} {near}"


def _place(nouns: Nouns, action: Any) -> str:
    if action.layout is None:
        return placing_words(nouns, action)
    layout = action.layout
    which = quoted(layout) if isinstance(layout, str) else f"the layout drawn as {quoted(layout.draw)}"
    return f"things are put as in {which}{_mirrored(nouns, action.mirror)}"


def _remove(nouns: Nouns, action: Any) -> str:
    who = nouns.all_of(action.entity)
    gone = f"{who.does('is', 'are')} taken off the field"
    if not action.for_s:
        return gone
    return f"{gone} and after {seconds(action.for_s)} {put_words(nouns, action.back_at, plural=who.plural)}"


def _count(nouns: Nouns, action: Any) -> str:
    counter = nouns.every_kept("counter", action.counter, action.entity)
    if action.to is not None:
        return f"{counter} is set to {amount(nouns, action.to)}"
    if isinstance(action.by, (int, float)) and action.by < 0:
        return f"{counter} falls by {amount(nouns, -action.by)}"
    return f"{counter} grows by {amount(nouns, 1 if action.by is None else action.by)}"


def _timer(nouns: Nouns, action: Any) -> str:
    done = {
        "restart": "starts again from 0",
        "start": "goes on",
        "stop": "is stopped",
        "reset": "is stopped and set to 0",
    }[action.do]
    return f"{nouns.every_kept('timer', action.timer, action.entity)} {done}"


def _draw(nouns: Nouns, action: Any) -> str:
    if action.as_ is None:
        return f"{quoted(action.draw)} is drawn anew"
    return f"{quoted(action.draw)} becomes “{plain(value(nouns, action.as_))}”"


def _emit(nouns: Nouns, action: Any) -> str:
    told = ", ".join(f"{key}: {value(nouns, entry)}" for key, entry in action.payload.items())
    return f"{action.event} is announced" + (f" ({told})" if told else "")


def _points(nouns: Nouns, action: Any) -> str:
    who, points = plain(action.entrant), action.points
    if not isinstance(points, (int, float)):
        return f"{who} gets points: {amount(nouns, points)}"
    number = amount(nouns, abs(points))
    return f"{who} {'loses' if points < 0 else 'gets'} {number} point{'' if number == '1' else 's'}"


def _flag(nouns: Nouns, action: Any) -> str:
    return nouns.every_kept("flag", action.flag, action.entity)


ACTIONS: dict[str, Callable[[Nouns, Any], str]] = {
    "score": _points,
    "count": _count,
    "set_flag": lambda n, a: f"{_flag(n, a)} is {'set' if a.to else 'cleared'}",
    "toggle_flag": lambda n, a: f"{_flag(n, a)} is turned over",
    "timer": _timer,
    "draw": _draw,
    "place": _place,
    "remove": _remove,
    "set_phase": lambda _, a: f"the phase {quoted(a.phase)} begins",
    "emit": _emit,
    "end": lambda _, a: f"the {a.what} ends" + (f" ({a.reason})" if a.reason else ""),
}

PLACES: dict[type, Callable[[Nouns, Any], str]] = {
    str: lambda _n, _a: "at its start",
    places.Start: lambda _n, _a: "at its start",
    places.AtPoint: lambda n, a: f"at {n.point(a.point)}",
    places.AtSpot: lambda n, a: f"on {n.thing(a.spot)}",
    places.UniformIn: lambda n, a: f"anywhere in {n.thing(a.uniform_in)}",
    places.OnLine: lambda n, a: f"anywhere on the line from {n.point(a.on_line[0])} to {n.point(a.on_line[1])}",
    places.Choice: lambda n, a: (
        f"on {listed([n.any_of(one) if isinstance(one, str) else n.point(one) for one in a.choice], 'or')}"
    ),
    places.NearestFree: lambda n, a: _free(n, "nearest", a.nearest_free, a.choose_among, a.to),
    places.FurthestFree: lambda n, a: _free(n, "furthest", a.furthest_free, a.choose_among, a.from_),
    places.RelativeTo: lambda n, a: (
        f"at {n.point(a.offset_m)} from {n.thing(a.relative_to)}" + (", x forward and y to its left" if a.turns else "")
    ),
}
