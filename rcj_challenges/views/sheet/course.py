"""How a match goes, for a rule sheet: halves, phases, timers, draws and sequences."""

from __future__ import annotations

from collections import Counter as Tally
from collections.abc import Iterator

from rcj_challenges.rules.effects import Draws
from rcj_challenges.rules.phrasing import listed, number, quoted, quoted_measure, seconds
from rcj_challenges.rules.several_conditions import as_one
from rcj_challenges.rules.values import duration_words, is_calculated, value_words
from rcj_challenges.scenario.halves import half_lengths_s
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.models.state import Counter, Draw, Flag, Phase, Role, Sequence, Timer
from rcj_challenges.views.sheet.document import Block, Items
from rcj_challenges.views.sheet.phrasebook import Phrasebook


def length_words(scenario: Scenario) -> str:
    """Return the length of a match: ``2 halves of 10 min; the teams change sides between halves``, as a sentence."""
    match, lengths_s = scenario.match, half_lengths_s(scenario.match)
    halves = f"One {match.period}" if match.halves == 1 else match.period.counted(match.halves)
    of = seconds(lengths_s[0]) if len(set(lengths_s)) == 1 else listed([seconds(one) for one in lengths_s], "and")
    swap = f"; the teams change sides between {match.period.many}" if match.swap_sides and match.halves > 1 else ""
    return f"{halves} of {of}{swap}."


def course_blocks(scenario: Scenario, phrases: Phrasebook) -> Iterator[Block]:
    """Yield the course of a half besides the rules."""
    if scenario.phases:
        yield f"{scenario.match.period.a.capitalize()} begins in the phase {quoted(scenario.first_phase)}."
    entries = [
        *(_phase_words(phrases, name, phase) for name, phase in scenario.phases.items()),
        *(_timer_words(phrases, name, timer) for name, timer in scenario.timers.items()),
        *(_kept_words(phrases, "counter", name, one) for name, one in scenario.counters.items()),
        *(_kept_words(phrases, "flag", name, one) for name, one in scenario.flags.items()),
        *(_draw_words(phrases, name, draw) for name, draw in scenario.draws.items()),
        *(_role_words(phrases, name, role) for name, role in scenario.roles.items()),
        *(_sequence_words(phrases, name, sequence) for name, sequence in scenario.sequences.items()),
    ]
    if entries:
        yield Items(tuple(filter(None, entries)))


def _phase_words(phrases: Phrasebook, name: str, phase: Phase) -> str:
    lasts = "lasts until a rule begins another"
    if phase.lasts_s:
        begun = " when it begins" if is_calculated(phase.lasts_s) else ""
        lasts = f"lasts {duration_words(phrases, phase.lasts_s)}{begun}, then {quoted(phase.next)} follows"
    kickoff = "; meanwhile a kick-off is awaited" if phase.waiting_for_kickoff else ""
    clock = "goes on" if phase.clock == "runs" else "stands still, timers go on"
    held = " All robots are held meanwhile." if phase.robots == "held" else ""
    return f"The phase {quoted(name)} {lasts}; the clock {clock}{kickoff}.{held}"


def _timer_words(phrases: Phrasebook, name: str, timer: Timer) -> str:
    one_for_each = f"; there is one for {phrases.each_of(timer.per)}" if timer.per else ""
    starts = f"; it starts with the {phrases.period}" if timer.starts else ""
    if timer.keep not in (None, "half"):
        starts = f"; it {'starts' if timer.starts else 'is 0'} when {_begin_words(phrases, timer.keep)}"
    own = phrases.of_each(timer.per)
    lasts = "has no end" if timer.lasts_s is None else f"lasts {duration_words(own, timer.lasts_s)}"
    held = "" if timer.while_ is None else f"; it runs while {as_one(timer.while_).describe(own)}"
    return f"The timer {quoted(name)} {lasts}{one_for_each}{starts}{held}."


def _kept_words(phrases: Phrasebook, kind: str, name: str, one: Counter | Flag) -> str:
    """Return the first value of a counter or flag, if that is not 0 or unset in each half."""
    is_only_one = one.keep == "match" and phrases.scenario.match.halves == 1
    is_usual = not one.first and one.first is not None
    keeps = one.keeps if isinstance(one, Counter) else None
    if is_usual and not keeps and (one.keep in (None, "half") or is_only_one):
        return ""
    initial = "has no value" if one.first is None else f"is {number(one.first)}"
    if isinstance(one, Flag):
        initial = "is set" if one.first else "is not set"
    which = quoted_measure(name) if kind == "counter" else quoted(name)
    owners = phrases.owners(kind, name)
    of = f" of {phrases.each_of(owners)}" if owners else ""
    best = f"; of the values that it is given, the {keeps} counts" if keeps else ""
    return f"The {kind} {which}{of} {initial} when {_begin_words(phrases, one.keep)}{best}."


def _begin_words(phrases: Phrasebook, keep: str | None) -> str:
    """The moment at which something is reset that is kept for so long."""
    half, halves = phrases.period, phrases.scenario.match.halves
    if keep == "match" and halves > 1:
        return f"the match starts, and goes on from {half} to {half}"
    known = {"half": f"{half.a} starts", "match": "the match starts", "phase": "a phase begins"}
    return known.get(keep or "half", f"the phase {quoted(str(keep))} begins")


def _draw_words(phrases: Phrasebook, name: str, draw: Draw) -> str:
    times = Tally(value_words(phrases, entry) for entry in draw.values)
    often = len(times) < len(draw.values)
    values = listed(
        [f"{word} ({count} of {len(draw.values)})" if often else word for word, count in times.items()], "or"
    )
    again = _again_words(phrases, draw)
    keep = "once a match" if draw.keep == "match" else f"when {phrases.period.a} starts"
    by_rules = {one.value is None for one in phrases.scenario.effects(Draws) if one.draw == name}
    also = "".join(
        (", and again when a rule says so" if True in by_rules else "", "; rules also set it" * (False in by_rules))
    )
    return f"Chance decides {quoted_measure(name)} {keep}{also}: {values}{again}."


def _again_words(phrases: Phrasebook, drawn: Draw | Role) -> str:
    again = ", never the same twice running" if drawn.not_last else ""
    if drawn.not_again is not None:
        again += (
            f"; in {phrases.period.a if drawn.not_again == 'half' else 'the match'} all come before one comes again"
        )
    return again


def _role_words(phrases: Phrasebook, name: str, role: Role) -> str:
    members = [phrases.thing(one) for one in phrases.roster.roles[name]]
    which, begins = quoted_measure(name), _begin_words(phrases, role.keep)
    if role.initial is not None:
        chance = f", or let chance decide{_again_words(phrases, role)}" if role.order == "random" else ""
        return f"Nothing is {which} when {begins}; rules say when that is {listed(members, 'or')}{chance}."
    if role.order == "listed":
        after = "and again from the first" if role.cyclic else "then nothing"
        return f"When {begins}, {which} is {members[0]}; rules say when the next one is: {', '.join(members)}, {after}."
    again = _again_words(phrases, role)
    return f"Chance decides {which} when {begins}, and whenever rules say so: {listed(members, 'or')}{again}."


def _sequence_words(phrases: Phrasebook, name: str, sequence: Sequence) -> str:
    places = [phrases.any_of(step) for step in sequence.places()]
    way = ", then ".join(places) if sequence.order is None else f"{listed(places, 'and')}, in any order"
    back = f"{',' if sequence.order else ''} and back to the first" if sequence.cyclic else ""
    wrong = "breaks it: it starts again" if sequence.wrong_step == "break" else "changes nothing"
    turn = f" A step out of turn {wrong}." if sequence.order is None else ""
    owners = phrases.owners("sequence", name)
    followers = phrases.all_of(sequence.followed).text if owners is None else phrases.each_of(owners)
    placed = "goes on" if sequence.when_placed == "goes_on" else "starts again"
    return (
        f"The sequence {quoted(name)} of {followers}: {way}{back}.{turn} It {placed} when a rule puts "
        f"{'it' if owners else followers} somewhere or takes it off the field."
    )
