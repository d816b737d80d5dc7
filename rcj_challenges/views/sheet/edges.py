"""Triggers and conditions as sentences."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from rcj_challenges.views.sheet.nouns import Nouns, Subject, plain, quoted
from rcj_challenges.views.sheet.phrases import amount, compared, degrees, heading, metres, number, seconds, value


def trigger_words(nouns: Nouns, trigger: Any) -> str:
    """Return a trigger as the part of a sentence that follows ``When``."""
    return TRIGGERS[trigger.trigger](nouns, trigger)


def condition_words(nouns: Nouns, condition: Any) -> str:
    """Return a condition, or the opposite of a negated one, as the part of a sentence that follows ``if``."""
    return CONDITIONS[condition.condition](nouns, condition)


def _phase_entered(_nouns: Nouns, t: Any) -> str:
    return f"the phase {quoted(t.phase)} begins" + (f" after {quoted(t.from_)}" if t.from_ else "")


def _leaves(nouns: Nouns, t: Any) -> str:
    # Of several zones: out of all of them.
    return f"{nouns.any_of(t.entity)} leaves {nouns.all_of(t.zone).text}"


def _displaced(nouns: Nouns, t: Any) -> str:
    origin = "where it was put" if t.from_ == "last_placement" else nouns.point(t.from_)
    how = "" if t.axis == "distance" else " in x or in y"
    return f"{nouns.any_of(t.entity)} is more than {metres(t.distance_m)}{how} from {origin}"


def _no_progress(nouns: Nouns, t: Any) -> str:
    way = f"less than {metres(t.distance_m)} in all over the last {seconds(t.within_s)}"
    return f"{nouns.any_of(t.entity)} has moved {way}"


def _stays_in(nouns: Nouns, t: Any) -> str:
    grace = f" (leaving for up to {seconds(t.grace_s)} does not count)" if t.grace_s else ""
    stay = f"has been in {nouns.any_of(t.zone)} for more than {seconds(t.limit_s)}{grace}"
    return f"{nouns.any_of(t.entity)} {stay}"


def _crosses(nouns: Nouns, t: Any) -> str:
    way = {"either": "", "forward": " forward", "backward": " backward"}[t.direction]
    return f"{nouns.any_of(t.entity)} crosses {nouns.any_of(t.gate)}{way}"


def _holds(nouns: Nouns, t: Any) -> str:
    for_s = f"for {seconds(t.for_s)}" if t.for_s else ""
    held = condition_words(nouns, t.condition)
    grace = f" (interruptions of up to {seconds(t.grace_s)} do not count)" if t.grace_s else ""
    again = f", and again every {seconds(t.every_s)} while that lasts" if t.every_s else ""
    # Behind several it would read as if only the last of them had to last.
    several = len(getattr(t.condition, "conditions", ())) > 1
    lasting = " ".join(filter(None, (for_s, held) if several else (held, for_s)))
    return f"{lasting}{grace}{again}"


def _is(nouns: Nouns, c: Any, names: Any, what: str) -> str:
    """Return that so many of the names are something, or are not."""
    return f"{nouns.quantified(c.of, names, negate=c.negate).does('is', 'are')} {what}"


def _kept(nouns: Nouns, kind: str, name: str, c: Any) -> Subject:
    """Return whose counter, flag or timer is asked: of one, or of so many of several."""
    together = c.of is None and c.entity is None and kind != "counter" and nouns.owners(kind, name) is not None
    if (c.of is None and not together) or c.entity == "each":
        return Subject(nouns.kept(kind, name, c.entity), negated=c.negate)
    names = c.entity or getattr(nouns.scenario, f"{kind}s")[name].per
    who = nouns.quantified(c.of or "any", names, negate=c.negate)
    return Subject(f"the {kind} {quoted(name)} of {who.text}", negated=who.negated)


def _timer(nouns: Nouns, c: Any) -> str:
    timer, limits = _kept(nouns, "timer", c.timer, c), compared(nouns, c, " s")
    if not limits:
        return f"{timer.does('is', 'are')} running"
    owners = nouns.owners("timer", c.timer)
    if c.of is None and c.entity is None and owners is not None:
        longest = f"the longest running timer {quoted(c.timer)} of {nouns.all_of(owners).text}"
        timer = Subject(longest, negated=c.negate)
    return f"{timer.text} has{' not' if timer.negated else ''} run for {limits}"


def _speed(nouns: Nouns, c: Any) -> str:
    who = nouns.quantified(c.of, c.entity, negate=c.negate)
    limits = [limit for limit in (c.at_least, c.at_most, c.equals) if limit is not None]
    if who.negated and len(limits) == 1 and c.equals is None:
        how = "slower" if c.at_most is None else "faster"
        return f"{who.text} moves {how} than {amount(nouns, limits[0])} m/s"
    return f"{who.does('moves', 'move')} at a speed of {compared(nouns, c, ' m/s')}"


def _looks(nouns: Nouns, c: Any) -> str:
    who = nouns.quantified(c.of, c.entity, negate=c.negate).does("looks", "look")
    way = heading(c.heading_rad) if c.towards is None else f"towards {nouns.point(c.towards)}"
    return f"{who} {way} (to within {degrees(c.within_rad)})"


def _any_of(nouns: Nouns, c: Any) -> str:
    parts = c.conditions
    if c.negate and (len(parts) == 1 or any(map(_is_negative, parts))):
        # None of them holds: of each the opposite does.
        opposites = [one.model_copy(update={"negate": not one.negate}) for one in parts]
        return " and ".join(condition_words(nouns, one) for one in opposites)
    inner = [condition_words(nouns, one) for one in parts]
    if len(inner) == 1:
        return inner[0]
    first, last = ("neither ", " nor ") if c.negate else ("either ", " or ")
    return first + last.join(inner)


def _is_negative(condition: Any) -> bool:
    """Return whether a condition says that something is not so: ``neither`` before it would deny that again."""
    return bool(condition.negate) or getattr(condition, "of", None) == "none"


TRIGGERS: dict[str, Callable[[Nouns, Any], str]] = {
    "half_started": lambda _n, _t: "a half starts",
    "half_ended": lambda _n, _t: "a half is over",
    "phase_entered": _phase_entered,
    "time_reached": lambda _, t: f"the half has lasted {seconds(t.at_s)}",
    "timer_expired": lambda _, t: f"the timer {quoted(t.timer)} runs out",
    "enters": lambda n, t: f"{n.any_of(t.entity)} enters {n.any_of(t.zone)}",
    "leaves": _leaves,
    "crosses": _crosses,
    "touches": lambda n, t: f"{n.any_of(t.entity)} touches {n.any_of(t.other)}",
    "displaced": _displaced,
    "no_progress": _no_progress,
    "stays_in": _stays_in,
    "tips_over": lambda n, t: f"{n.any_of(t.entity)} tilts by more than {number(round(t.angle_rad * 57.29578))}°",
    "sequence_completed": lambda _, t: f"the sequence {quoted(t.sequence)} is complete",
    "sequence_broken": lambda _, t: f"the sequence {quoted(t.sequence)} is broken",
    "event": lambda _, t: f"{t.event} was announced",
    "program_fault": lambda n, t: f"{n.owned('program', t.robot)} fails",
    "holds": _holds,
}

CONDITIONS: dict[str, Callable[[Nouns, Any], str]] = {
    "in_zone": lambda n, c: _is(n, c, c.entity, f"in {n.any_of(c.zone)}"),
    "speed": _speed,
    "distance": lambda n, c: _is(n, c, c.entity, f"{compared(n, c, ' m')} from {n.point(c.to)}"),
    "looks": _looks,
    "any_of": _any_of,
    "counter": lambda n, c: f"{_kept(n, 'counter', c.counter, c).does('is', 'are')} {compared(n, c)}",
    "flag": lambda n, c: f"{_kept(n, 'flag', c.flag, c).does('is', 'are')} set",
    "drawn": lambda n, c: f"“{plain(value(n, c.equals))}” was {'not ' if c.negate else ''}drawn as {quoted(c.draw)}",
    "timer": _timer,
    "last_touch": lambda n, c: (
        f"the last to touch {n.thing(c.entity)} was {'not ' if c.negate else ''}{n.any_of(c.by)}"
    ),
    "spot_free": lambda n, c: _is(n, c, c.spot, "free"),
    "sequence_at": lambda n, c: (
        f"the sequence {quoted(c.sequence)} {'does not stand' if c.negate else 'stands'} at {n.thing(c.step)}"
    ),
}
