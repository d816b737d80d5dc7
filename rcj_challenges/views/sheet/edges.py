"""Triggers and conditions as sentences."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from rcj_challenges.views.sheet.phrases import compared, metres, named, number, place, quantified, seconds


def trigger_words(trigger: Any) -> str:
    """Return a trigger as the part of a sentence that follows ``When``."""
    return TRIGGERS[trigger.trigger](trigger)


def condition_words(condition: Any) -> str:
    """Return a condition as the part of a sentence that follows ``if``."""
    words = CONDITIONS[condition.condition](condition)
    return f"not ({words})" if condition.negate else words


def _displaced(t: Any) -> str:
    origin = "where it was put" if t.from_ == "last_placement" else place(t.from_)
    how = "" if t.axis == "distance" else " in x or in y"
    return f"{named(t.entity)} is more than {metres(t.distance_m)}{how} from {origin}"


def _stays_in(t: Any) -> str:
    grace = f" (leaving it for up to {seconds(t.grace_s)} does not count)" if t.grace_s else ""
    return f"{named(t.entity)} is in {named(t.zone)} for more than {seconds(t.limit_s)}{grace}"


def _crosses(t: Any) -> str:
    way = {"either": "", "forward": " forward", "backward": " backward"}[t.direction]
    return f"{named(t.entity)} crosses {named(t.gate)}{way}"


def _holds(t: Any) -> str:
    for_s = f" for {seconds(t.for_s)}" if t.for_s else ""
    again = f", and again every {seconds(t.every_s)}" if t.every_s else ""
    grace = f" (interruptions of up to {seconds(t.grace_s)} do not count)" if t.grace_s else ""
    return f"{condition_words(t.condition)}{for_s}{grace}{again}"


TRIGGERS: dict[str, Callable[[Any], str]] = {
    "half_started": lambda _: "a half starts",
    "half_ended": lambda _: "a half is over",
    "phase_entered": lambda t: f"{named(t.phase)} begins" + (f" after {named(t.from_)}" if t.from_ else ""),
    "time_reached": lambda t: f"{seconds(t.at_s)} of the half are over",
    "timer_expired": lambda t: f"the time of {named(t.timer)} is over",
    "enters": lambda t: f"{named(t.entity)} enters {named(t.zone)}",
    "leaves": lambda t: f"{named(t.entity)} leaves {named(t.zone)}",
    "crosses": _crosses,
    "touches": lambda t: f"{named(t.entity)} touches {named(t.other)}",
    "displaced": _displaced,
    "no_progress": lambda t: (
        f"{named(t.entity)} has moved less than {metres(t.distance_m)} in all over the last {seconds(t.within_s)}"
    ),
    "stays_in": _stays_in,
    "tips_over": lambda t: f"{named(t.entity)} tilts by more than {number(round(t.angle_rad * 57.29578))}°",
    "sequence_completed": lambda t: f"the sequence {named(t.sequence)} is complete",
    "sequence_broken": lambda t: f"the sequence {named(t.sequence)} is broken",
    "event": lambda t: f"{t.event} was announced",
    "program_fault": lambda t: f"the program of {named(t.robot)} fails",
    "holds": _holds,
}

CONDITIONS: dict[str, Callable[[Any], str]] = {
    "in_zone": lambda c: f"{quantified(c.of, c.entity)} is in {named(c.zone)}",
    "speed": lambda c: f"{quantified(c.of, c.entity)} moves with {compared(c, ' m/s')}",
    "distance": lambda c: f"{quantified(c.of, c.entity)} is {compared(c, ' m')} from {place(c.to)}",
    "counter": lambda c: f"{named(c.counter)}{f' of {named(c.entity)}' if c.entity else ''} is {compared(c)}",
    "flag": lambda c: f"{named(c.flag)}{f' of {named(c.entity)}' if c.entity else ''} is set",
    "drawn": lambda c: f"{named(c.draw)} was drawn as {named(str(c.equals))}",
    "timer": lambda c: f"{named(c.timer)} is {compared(c, ' s') or 'running'}",
    "last_touch": lambda c: f"{named(c.by)} touched {named(c.entity)} last",
    "spot_free": lambda c: f"{quantified(c.of, c.spot)} is free",
    "sequence_at": lambda c: f"{named(c.sequence)} stands at {named(c.step)}",
}
