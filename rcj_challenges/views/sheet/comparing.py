"""Conditions that compare: counters, timers, distances, ways and speeds with numbers or counters, as sentences."""

from __future__ import annotations

from typing import Any

from rcj_challenges.rules.phrasing import Subject, number, plain, quoted, quoted_measure
from rcj_challenges.rules.values import CounterValue
from rcj_challenges.views.sheet.nouns import Nouns
from rcj_challenges.views.sheet.phrases import amount


def counter_words(nouns: Nouns, c: Any) -> str:
    """Return a condition on a counter or a score."""
    if isinstance(c.equals, CounterValue):
        return _equal(nouns, c)
    who = _asked(nouns, "counter", c.counter, c)
    if who is not None:
        return f"{who.does('has', 'have')} a counter {quoted_measure(c.counter)} of {compared(nouns, c)}"
    counter = nouns.kept("counter", c.counter, c.entity)
    limit = _only_limit(c) if c.negate else None
    if limit is not None:
        return f"{counter} is {'less' if c.at_most is None else 'more'} than {amount(nouns, limit)}"
    return f"{counter} is {'not ' if c.negate else ''}{compared(nouns, c)}"


def flag_words(nouns: Nouns, c: Any) -> str:
    """Return a condition on a flag."""
    who = _asked(nouns, "flag", c.flag, c)
    if who is not None:
        return f"{who.does('has', 'have')} the flag {quoted(c.flag)} set"
    return f"{nouns.kept('flag', c.flag, c.entity)} is {'not ' if c.negate else ''}set"


def timer_words(nouns: Nouns, c: Any) -> str:
    """Return a condition on a timer: whether it runs, or for how long."""
    who, run_for = _asked(nouns, "timer", c.timer, c), compared(nouns, c, " s")
    timer, no = nouns.kept("timer", c.timer, c.entity), " not" if c.negate else ""
    if not run_for and who is None:
        return f"{timer} is{no} running"
    if who is not None and (c.of is not None or not run_for):
        article, state = ("a", f"that has run for {run_for}") if run_for else ("the", "running")
        return f"{who.does('has', 'have')} {article} timer {quoted(c.timer)} {state}"
    owners = nouns.owners("timer", c.timer)
    if who is not None and owners is not None:
        timer = f"the longest running timer {quoted(c.timer)} of {nouns.all_of(owners).text}"
    limit = _only_limit(c) if c.negate else None
    if limit is None:
        return f"{timer} has{no} run for {run_for}"
    if isinstance(limit, (int, float)):
        return f"{timer} has run for {'less' if c.at_most is None else 'more'} than {number(limit)} s"
    how = "shorter" if c.at_most is None else "longer"
    return f"{timer} has run {how} than {amount(nouns, limit)} says in s"


def sequence_words(nouns: Nouns, c: Any) -> str:
    """Return a condition on the step at which a sequence stands."""
    who, step = _asked(nouns, "sequence", c.sequence, c), nouns.thing(c.step)
    sequence = nouns.scenario.sequences[c.sequence]
    *before, last = map(nouns.roster.expand, sequence.places())
    if not sequence.cyclic and c.step in last:
        # It begins anew when it is complete, but what it stands at is the step that was reached last.
        also = "also when it is " if any(c.step in places for places in before) else ""
        step += f" ({also}complete, until its next step)"
    if who is not None:
        return f"{who.does('has', 'have')} a sequence {quoted(c.sequence)} that stands at {step}"
    stands = "does not stand" if c.negate else "stands"
    return f"{nouns.kept('sequence', c.sequence, c.entity)} {stands} at {step}"


def distance_words(nouns: Nouns, c: Any) -> str:
    """Return a condition on how far things are apart."""
    who, to = nouns.of_those_there(c.of, c.entity, negate=c.negate), nouns.point(c.to, c.entity)
    limit = _only_limit(c) if who.negated else None
    if limit is None:
        return f"{who.does('is', 'are')} {compared(nouns, c, ' m', f' from {to}')}"
    # Of who is off the field nothing is measured: then the opposite of it holds.
    off = _off(nouns, c)
    if isinstance(limit, (int, float)):
        return f"{who.text} is {'less' if c.at_most is None else 'more'} than {number(limit)} m from {to}{off}"
    how = "nearer to" if c.at_most is None else "further from"
    return f"{who.text} is {how} {to} than {amount(nouns, limit)} says in m{off}"


def _off(nouns: Nouns, c: Any) -> str:
    """Return who need only be off the field for the opposite of a distance to hold."""
    itself, target = nouns.may_be_off(c.entity), nouns.off_as_a_whole(c.to, c.entity)
    if target is None:
        return " or off the field" if itself else ""
    if not itself:
        return f", or {target.does('is', 'are')} off the field"
    return (
        f", or off the field, or {target.does('is', 'are')}"
        if target.plural
        else ", or one of the two is off the field"
    )


def way_words(nouns: Nouns, c: Any) -> str:
    """Return a condition on how far things have come."""
    who = nouns.quantified(c.of, c.entity, negate=c.negate)
    limit = _only_limit(c) if who.negated else None
    if limit is None:
        return f"{who.does('has', 'have')} a way in this half of {compared(nouns, c, ' m')}"
    if isinstance(limit, (int, float)):
        return f"{who.text} has a way in this half of {'less' if c.at_most is None else 'more'} than {number(limit)} m"
    how = "shorter" if c.at_most is None else "longer"
    return f"{who.text} has a {how} way in this half than {amount(nouns, limit)} says in m"


def speed_words(nouns: Nouns, c: Any) -> str:
    """Return a condition on how fast things move."""
    who = nouns.of_those_there(c.of, c.entity, negate=c.negate)
    limit = _only_limit(c) if who.negated else None
    if limit is None:
        return f"{who.does('moves', 'move')} at a speed of {compared(nouns, c, ' m/s')}"
    how = "slower" if c.at_most is None else "faster"
    fast = f"{number(limit)} m/s" if isinstance(limit, (int, float)) else f"{amount(nouns, limit)} says in m/s"
    off = " or is off the field" if nouns.may_be_off(c.entity) else ""
    return f"{who.text} moves {how} than {fast}{off}"


def compared(nouns: Nouns, model: Any, unit: str = "", where: str = "") -> str:
    """Return the comparison of a condition: ``at least 3 and at most 5``, ``at most 0.5 m from the ball``.

    Args:
        nouns: what the names stand for.
        model: the condition.
        unit: what follows the numbers.
        where: what follows the unit.
    """
    bounds = (("at least", model.at_least), ("at most", model.at_most), ("exactly", model.equals))
    limits = [(words, limit) for words, limit in bounds if limit is not None]
    if all(isinstance(limit, (int, float)) for _, limit in limits):
        numbers = " and ".join(f"{words} {number(limit)}{unit}" for words, limit in limits)
        return f"{numbers}{where}" if numbers else ""
    return " and ".join(
        f"{words} {amount(nouns, limit)}{unit}{where}"
        if isinstance(limit, (int, float)) or not unit
        else f"{words} as many{unit}{where} as {amount(nouns, limit)} says"
        for words, limit in limits
    )


def _only_limit(model: Any) -> Any:
    """Return the limit of a comparison that has one to one side; None if it has not."""
    limits = [limit for limit in (model.at_least, model.at_most) if limit is not None]
    return limits[0] if len(limits) == 1 and model.equals is None else None


def _equal(nouns: Nouns, c: Any) -> str:
    """Return whether a counter is what another one is."""
    entrants = nouns.scenario.entrants
    if c.counter in entrants and c.equals.counter in entrants:
        scores = f"the scores of {plain(c.counter)} and {plain(c.equals.counter)}"
        return f"{scores} {'differ' if c.negate else 'are equal'}"
    who, other = _asked(nouns, "counter", c.counter, c), amount(nouns, c.equals)
    if who is not None:
        return f"{who.does('has', 'have')} a counter {quoted_measure(c.counter)} equal to {other}"
    return f"{nouns.kept('counter', c.counter, c.entity)} {'differs from' if c.negate else 'is equal to'} {other}"


def _asked(nouns: Nouns, kind: str, name: str, c: Any) -> Subject | None:
    """Return which of several are asked for what each of them has; None where one is asked, or all in one."""
    together = c.of is None and c.entity is None and kind != "counter" and nouns.owners(kind, name) is not None
    if (c.of is None and not together) or c.entity == "each":
        return None
    names = c.entity or getattr(nouns.scenario, f"{kind}s")[name].per
    return nouns.quantified(c.of or "any", names, negate=c.negate)
