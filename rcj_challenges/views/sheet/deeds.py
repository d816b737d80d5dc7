"""Actions and places as sentences."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from rcj_challenges.scenario.models import places
from rcj_challenges.views.sheet.phrases import amount, metres, named, place, seconds, value


def action_words(action: Any) -> str:
    """Return an action as a clause: ``yellow gets 1 point``."""
    return ACTIONS[action.action](action)


def at_words(at: Any) -> str:
    """Return a place in words: ``on a random one of the 3 nearest free neutral spots``."""
    return PLACES[type(at)](at)


def placing_words(placing: Any) -> str:
    """Return a placement as a clause."""
    noise = f" ± {metres(placing.noise_m[0])}, {metres(placing.noise_m[1])}" if any(placing.noise_m) else ""
    mirror = ""
    if placing.mirror is not None:
        mirror = f", mirrored in {placing.mirror.axis}"
        mirror += f" while {named(placing.mirror.when)}" if placing.mirror.when else ""
    return f"{named(placing.entity)} is put {at_words(placing.at)}{noise}{mirror}"


def _free(how: str, spots: Any, among: int, of: Any) -> str:
    which = f"the {how} free one" if among == 1 else f"a random one of the {among} {how} free"
    near = "" if of is None else f" {'to' if how == 'nearest' else 'from'} {place(of)}"
    return f"on {which} of {named(spots)}{near}"


def _place(action: Any) -> str:
    if action.layout is None:
        return placing_words(action)
    drawn = action.layout if isinstance(action.layout, str) else None
    what = f"everything of {named(drawn)}" if drawn else f"the drawn {named(action.layout.draw)}"
    mirror = ""
    if action.mirror is not None:
        mirror = f", mirrored in {action.mirror.axis}" + (
            f" while {named(action.mirror.when)}" if action.mirror.when else ""
        )
    return f"{what} is put in its place{mirror}"


def _remove(action: Any) -> str:
    back = f" for {seconds(action.for_s)}, then put {at_words(action.back_at)}" if action.for_s else ""
    return f"{named(action.entity)} is taken off the field{back}"


def _count(action: Any) -> str:
    whose = f" of {named(action.entity)}" if action.entity else ""
    if action.to is not None:
        return f"{named(action.counter)}{whose} is set to {amount(action.to)}"
    return f"{named(action.counter)}{whose} grows by {amount(1 if action.by is None else action.by)}"


def _emit(action: Any) -> str:
    told = ", ".join(f"{key}: {value(entry)}" for key, entry in action.payload.items())
    return f"{action.event} is announced" + (f" ({told})" if told else "")


def _points(action: Any) -> str:
    points = amount(action.points)
    return f"{named(action.entrant)} gets {points} point{'' if points in ('1', '-1') else 's'}"


ACTIONS: dict[str, Callable[[Any], str]] = {
    "score": _points,
    "count": _count,
    "set_flag": lambda a: f"{named(a.flag)} is {'set' if a.to else 'cleared'}",
    "toggle_flag": lambda a: f"{named(a.flag)} is turned over",
    "timer": lambda a: (
        f"the timer {named(a.timer)} is {a.do}ed" if a.do != "stop" else f"the timer {named(a.timer)} stops"
    ),
    "draw": lambda a: f"{named(a.draw)} is drawn" + ("" if a.as_ is None else f" as {value(a.as_)}"),
    "place": _place,
    "remove": _remove,
    "set_phase": lambda a: f"{named(a.phase)} begins",
    "emit": _emit,
    "end": lambda a: f"the {a.what} ends" + (f": {a.reason}" if a.reason else ""),
}

PLACES: dict[type, Callable[[Any], str]] = {
    str: lambda _: "at its start",
    places.Start: lambda _: "at its start",
    places.AtPoint: lambda a: f"at {place(a.point)}",
    places.AtSpot: lambda a: f"on the spot {named(a.spot)}",
    places.UniformIn: lambda a: f"anywhere in {named(a.uniform_in)}",
    places.OnLine: lambda a: f"anywhere on the line from {place(a.on_line[0])} to {place(a.on_line[1])}",
    places.Choice: lambda a: "on one of " + ", ".join(place(entry) for entry in a.choice),
    places.NearestFree: lambda a: _free("nearest", a.nearest_free, a.choose_among, a.to),
    places.FurthestFree: lambda a: _free("furthest", a.furthest_free, a.choose_among, a.from_),
    places.RelativeTo: lambda a: f"beside {named(a.relative_to)}, {place(a.offset_m)} from it",
}
