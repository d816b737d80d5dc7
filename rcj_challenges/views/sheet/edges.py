"""Triggers and conditions as sentences."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from rcj_challenges.rules.values import CounterValue, DrawValue, HighestOfOthers, LowestOfOthers
from rcj_challenges.scenario.catalogue import EACH
from rcj_challenges.scenario.halves import clock_may_stop
from rcj_challenges.views.sheet.comparing import (
    counter_words,
    distance_words,
    flag_words,
    sequence_words,
    speed_words,
    timer_words,
    way_words,
)
from rcj_challenges.views.sheet.meeting import may_meet
from rcj_challenges.views.sheet.nouns import Nouns, listed, quoted, quoted_measure
from rcj_challenges.views.sheet.phrases import degrees, heading, metres, number, seconds, value, within_words


def trigger_words(nouns: Nouns, trigger: Any, each: str | None) -> str:
    """Return a trigger as the part of a sentence that follows ``When``.

    Args:
        nouns: what the names stand for.
        trigger: the trigger.
        each: what its rule goes over.
    """
    if trigger.trigger == "timer_expired":
        return _timer_expired(nouns, trigger, each)
    return TRIGGERS[trigger.trigger](nouns, trigger)


def condition_words(nouns: Nouns, condition: Any) -> str:
    """Return a condition, or the opposite of a negated one, as the part of a sentence that follows ``if``."""
    return CONDITIONS[condition.condition](nouns, condition)


def _phase_entered(_nouns: Nouns, t: Any) -> str:
    return f"the phase {quoted(t.phase)} begins" + (f" after {quoted(t.from_)}" if t.from_ else "")


def _time_reached(nouns: Nouns, t: Any) -> str:
    again = f", and again every {seconds(t.every_s)} until it ends" if t.every_s else ""
    # Where a phase stops the clock, the half lasts longer than that shows.
    stops = clock_may_stop(nouns.scenario)
    return f"the {'clock of the half has reached' if stops else 'half has lasted'} {seconds(t.at_s)}{again}"


def _timer_expired(nouns: Nouns, t: Any, each: str | None = None) -> str:
    per, expand = nouns.scenario.timers[t.timer].per, nouns.roster.expand
    if per is None:
        return f"the timer {quoted(t.timer)} runs out"
    own = each is not None and set(expand(each)) <= set(expand(per))
    return f"{nouns.owned('timer', 'each' if own else per, t.timer)} runs out"


def _sequence(nouns: Nouns, t: Any) -> str:
    """Return the sequence that a trigger hears, with whose it is where each of several has one."""
    owners = nouns.owners("sequence", t.sequence)
    if owners is None:
        return nouns.kept("sequence", t.sequence, t.entity if isinstance(t.entity, str) else None)
    return nouns.owned("sequence", t.entity or owners, t.sequence)


def _enters(nouns: Nouns, t: Any) -> str:
    entered = f"{nouns.any_of(t.entity)} enters {nouns.any_of(t.zone)}"
    # Several zones are judged as one: there is no edge between those that meet. "Each" and a draw are one at a time.
    several = dict.fromkeys(nouns.roster.expand(t.zone))
    if not may_meet([[nouns.scenario.zones[one] for one in nouns.meant(name)] for name in several]):
        return entered
    return f"{entered} from outside {'both' if len(several) == 2 else 'all of them'}"


def _leaves(nouns: Nouns, t: Any) -> str:
    # Of several zones: out of all of them.
    return f"{nouns.any_of(t.entity)} leaves {nouns.all_of(t.zone).text}"


def _touches(nouns: Nouns, t: Any) -> str:
    again = f", and again every {seconds(t.every_s)} while they touch" if t.every_s else ""
    # What stands fast is touched, whichever of the two is written first.
    one, other = (t.other, t.entity) if nouns.stands_fast(t.entity) else (t.entity, t.other)
    return f"{nouns.any_of(one)} touches {nouns.another_of(other, than=one)}{again}"


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
    if t.every_s and _is_always(t.condition):
        # Without for_s it was true before when it begins: it comes for the first time after the first interval.
        return f"{seconds(t.for_s or t.every_s)} have passed, and again every {seconds(t.every_s)}"
    for_s = f"for {seconds(t.for_s)}" if t.for_s else ""
    held = condition_words(nouns, t.condition)
    grace = f" (interruptions of up to {seconds(t.grace_s)} do not count)" if t.grace_s else ""
    again = f", and again every {seconds(t.every_s)} while that lasts" if t.every_s else ""
    # Behind several it would read as if only the last of them had to last, behind a counter as if that said it.
    before = _is_several(t.condition) or _asks_a_counter(t.condition)
    lasting = " ".join(filter(None, (for_s, held) if before else (held, for_s)))
    return f"{lasting}{grace}{again}"


def _is_always(c: Any) -> bool:
    """Return whether a condition asks for nothing: some half, as rules have it that count time."""
    return bool(c.condition == "half" and c.at_least == 1 and c.at_most is None and not c.negate)


def _is(nouns: Nouns, c: Any, names: Any, what: str) -> str:
    """Return that so many of the names are something, or are not."""
    return f"{nouns.quantified(c.of, names, negate=c.negate).does('is', 'are')} {what}"


def _looks(nouns: Nouns, c: Any) -> str:
    who = nouns.of_those_there(c.of, c.entity, negate=c.negate).does("looks", "look")
    way = heading(c.heading_rad) if c.towards is None else f"towards {nouns.point(c.towards)}"
    return f"{who} {way} (to within {degrees(c.within_rad)})"


def _last_touch(nouns: Nouns, c: Any) -> str:
    last, was = f"the last to touch {nouns.thing(c.entity)}", "was not" if c.negate else "was"
    return f"it {was} {last}" if c.by == "each" else f"{last} {was} {nouns.any_of(c.by)}"


def _said(nouns: Nouns, message: Any) -> str:
    """Return what a message must be: ``“FOUND”``, ``2``, ``a number``; an empty text if it may be anything."""
    if isinstance(message.text, DrawValue):
        return value(nouns, message.text)
    if message.text is not None:
        wanted = message.text if isinstance(message.text, tuple) else (message.text,)
        return listed([number(one) if isinstance(one, int | float) else f"“{one}”" for one in wanted], "or")
    return {None: "", "number": "a number", "position": "a position (two numbers, x and y in m)"}[message.is_a]


def _hears(nouns: Nouns, t: Any) -> str:
    return f"the referee hears {_said(nouns, t) or 'a message'} from {nouns.any_of(t.entity)}"


def _heard(nouns: Nouns, c: Any) -> str:
    who, said = nouns.quantified(c.of, c.entity, negate=c.negate), _said(nouns, c)
    if not said:
        return f"{who.does('was', 'were')} heard by the referee before"
    return f"{who.does('has', 'have')} {said} as the last message told"


def _any_of(nouns: Nouns, c: Any) -> str:
    parts = c.conditions
    if c.negate and (len(parts) == 1 or any(_is_negative(one) or _is_several(one) for one in parts)):
        # None of them holds: of each the opposite does.
        return _all_hold(nouns, _opposites(parts))
    if c.negate:
        return "neither " + " nor ".join(condition_words(nouns, one) for one in parts)
    return _one_holds(nouns, parts)


def _all_of(nouns: Nouns, c: Any) -> str:
    # Not all of them hold: of one the opposite does.
    return _one_holds(nouns, _opposites(c.conditions)) if c.negate else _all_hold(nouns, c.conditions)


def _opposites(conditions: Sequence[Any]) -> list[Any]:
    return [one.model_copy(update={"negate": not one.negate}) for one in conditions]


def _all_hold(nouns: Nouns, parts: Sequence[Any]) -> str:
    # Behind a comma it is clear that it does not belong to the alternatives before it.
    joint = ", and " if any(map(_is_several, parts)) else " and "
    return joint.join(condition_words(nouns, one) for one in parts)


def _one_holds(nouns: Nouns, parts: Sequence[Any]) -> str:
    inner = [_as_one(nouns, one) for one in parts]
    if len(inner) == 1:
        return condition_words(nouns, parts[0])
    return "either " + (", or " if any(map(_is_several, parts)) else " or ").join(inner)


def _as_one(nouns: Nouns, c: Any) -> str:
    """Return a condition as one of several; if all of others must hold in it, as ``both … and …``."""
    if not _is_several(c) or c.condition != "all_of" or c.negate:
        return condition_words(nouns, c)
    inner = [condition_words(nouns, one) for one in c.conditions]
    return f"both {inner[0]} and {inner[1]}" if len(inner) == 2 else f"{listed(inner, 'and')} at once"


def _is_several(condition: Any) -> bool:
    """Return whether a condition is made of more than one."""
    return len(getattr(condition, "conditions", ())) > 1


def _asks_a_counter(condition: Any) -> bool:
    """Return whether a condition compares with a counter, or with those of others."""
    limits = (getattr(condition, limit, None) for limit in ("at_least", "at_most", "equals"))
    return any(isinstance(limit, CounterValue | LowestOfOthers | HighestOfOthers) for limit in limits)


def _is_negative(condition: Any) -> bool:
    """Return whether a condition says that something is not so: ``neither`` before it would deny that again."""
    return bool(condition.negate) or getattr(condition, "of", None) == "none"


TRIGGERS: dict[str, Callable[[Nouns, Any], str]] = {
    "half_started": lambda _n, _t: "a half starts",
    "half_ended": lambda _n, _t: "a half is over",
    "phase_entered": _phase_entered,
    "time_reached": _time_reached,
    "timer_expired": _timer_expired,
    "enters": _enters,
    "leaves": _leaves,
    "crosses": _crosses,
    "touches": _touches,
    "displaced": _displaced,
    "no_progress": _no_progress,
    "stays_in": _stays_in,
    "tips_over": lambda n, t: f"{n.any_of(t.entity)} tilts by more than {degrees(t.angle_rad)}",
    "sequence_completed": lambda n, t: f"{_sequence(n, t)} is complete",
    "sequence_broken": lambda n, t: f"{_sequence(n, t)} is broken",
    "event": lambda n, t: f"{t.event} was announced" + (f" of {n.any_of(t.entity)}" if t.entity else ""),
    "tells": _hears,
    "program_fault": lambda n, t: f"{n.owned('program', t.robot)} fails",
    "holds": _holds,
}


def _drawn(nouns: Nouns, c: Any) -> str:
    who, draw, no = nouns.drawn(c.draw, c.equals), quoted_measure(c.draw), "not " if c.negate else ""
    if not nouns.is_set(c.draw):
        return f"{who} was {no}drawn as {draw}"
    return f"{who} is {no}{draw}" if who == nouns.thing(EACH) else f"{draw} is {no}{who}"


def _half(_nouns: Nouns, c: Any) -> str:
    if c.at_least is not None and c.at_least == c.at_most:
        which = f"half {c.at_least}"
    elif c.at_least is not None and c.at_most is not None:
        which = f"one of the halves {c.at_least} to {c.at_most}"
    elif c.at_least is not None:
        which = f"half {c.at_least} or a later one"
    else:
        which = f"half {c.equals}" if c.at_most is None else f"half {c.at_most} or an earlier one"
    return f"it is {'not ' if c.negate else ''}{which}"


CONDITIONS: dict[str, Callable[[Nouns, Any], str]] = {
    "in_zone": lambda n, c: (
        n.of_those_there(c.of, c.entity, negate=c.negate).does("is", "are") + f" in {n.any_of(c.zone)}"
    ),
    "speed": speed_words,
    "distance": distance_words,
    "way": way_words,
    "looks": _looks,
    "held": lambda n, c: _is(n, c, c.entity, "held"),
    "any_of": _any_of,
    "all_of": _all_of,
    "counter": counter_words,
    "flag": flag_words,
    "drawn": _drawn,
    "timer": timer_words,
    "last_touch": _last_touch,
    "told": _heard,
    "spot_free": lambda n, c: _is(n, c, c.spot, "free" + within_words(c.clearance_m)),
    "sequence_at": sequence_words,
    "half": _half,
}
