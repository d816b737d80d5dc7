"""What a rule sheet says, section by section."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from collections.abc import Set as AbstractSet

from rcj_challenges.devices.team_emitter import TeamEmitterDevice
from rcj_challenges.robots.channels import entrant_of
from rcj_challenges.rules.actions.draw import DrawAction
from rcj_challenges.rules.actions.hold import Hold
from rcj_challenges.rules.actions.place import Place
from rcj_challenges.rules.actions.score import Score
from rcj_challenges.rules.actions.sequence import SequenceAction
from rcj_challenges.rules.actions.set_phase import SetPhase
from rcj_challenges.rules.bounds import bounds_words
from rcj_challenges.rules.phrasing import counted, listed, number, plain, quoted, quoted_measure, seconds
from rcj_challenges.rules.placement import placement_words
from rcj_challenges.rules.triggers.no_progress import NoProgress
from rcj_challenges.rules.values import amount_words, duration_words, value_words
from rcj_challenges.rules.values.counter import CounterValue
from rcj_challenges.scenario.blanks import description_of
from rcj_challenges.scenario.catalogue import EACH
from rcj_challenges.scenario.followed import followed, phases_of
from rcj_challenges.scenario.halves import clock_may_stop, half_lengths_s
from rcj_challenges.scenario.models.scenario import (
    Limits,
    RankByCounter,
    RankByScore,
    RankByTime,
    Result,
    Rule,
    Scenario,
)
from rcj_challenges.scenario.models.state import Draw, Phase, Sequence, Timer
from rcj_challenges.scenario.roster import Roster
from rcj_challenges.views.drawing.areas import layouts_of
from rcj_challenges.views.sheet.blocks import Block, Heading, Items, Paragraph, Table, as_html, as_markdown
from rcj_challenges.views.sheet.ground import field_blocks
from rcj_challenges.views.sheet.machines import has, robot_blocks
from rcj_challenges.views.sheet.nouns import Nouns
from rcj_challenges.views.sheet.rules import rule_blocks, when_words
from rcj_challenges.views.sheet.spoken import spoken
from rcj_challenges.views.sheet.told import told_blocks

_OFFICIAL_FOLDER = "rcj_soccer_team_blue"
"""Where the original looks for the program of every team, of both colours."""


_NEITHER = "is neither the last reached nor the next"
"""What a wrong step is where one place makes each step."""


def sheet_markdown(scenario: Scenario, roster: Roster, picture: str | None = None) -> str:
    """Return the rule sheet as Markdown; ``picture`` is what stands for the drawing, None: itself, as inline SVG."""
    return as_markdown(sheet_blocks(scenario, roster), picture)


def sheet_html(scenario: Scenario, roster: Roster) -> str:
    """Return the rule sheet as one self-contained HTML page."""
    return as_html(scenario.title, sheet_blocks(scenario, roster))


def sheet_blocks(scenario: Scenario, roster: Roster) -> list[Block]:
    """Return all sections of the sheet, in order."""
    sections = (_goal, field_blocks, robot_blocks, _course, _scoring, rule_blocks, _places, told_blocks, _submission)
    nouns = Nouns(scenario, roster)
    return [block for section in sections for block in section(scenario, nouns)]


def _goal(scenario: Scenario, _nouns: Nouns) -> Iterator[Block]:
    yield Heading(1, scenario.title)
    if scenario.description:
        yield Paragraph(description_of(scenario))


def _course(scenario: Scenario, nouns: Nouns) -> Iterator[Block]:
    match = scenario.match
    yield Heading(2, "Course")
    lengths_s = half_lengths_s(match)
    halves = "One half" if match.halves == 1 else f"{match.halves} halves"
    of = seconds(lengths_s[0]) if len(set(lengths_s)) == 1 else listed([seconds(one) for one in lengths_s], "and")
    swap = "; the teams change sides between halves" if match.swap_sides and match.halves > 1 else ""
    first = f" A half begins in the phase {quoted(scenario.first_phase)}." if scenario.first_phase != "play" else ""
    yield Paragraph(
        f"{halves} of {of}{swap}.{first} Everything is judged on every tick of 32 ms; a time is over on the first tick "
        "on which it has passed."
    )
    entries = [
        *(_phase_words(nouns, name, phase) for name, phase in scenario.phases.items()),
        *_anew_words(scenario),
        *(_timer_words(nouns, name, timer) for name, timer in scenario.timers.items()),
        *_held_words(nouns),
        *_beginnings(scenario, nouns),
        *(_draw_words(nouns, name, draw) for name, draw in scenario.draws.items()),
        *(_sequence_words(nouns, name, sequence) for name, sequence in scenario.sequences.items()),
    ]
    if entries:
        yield Items(tuple(entries))


def _timer_words(nouns: Nouns, name: str, timer: Timer) -> str:
    counted = timer.lasts_s if isinstance(timer.lasts_s, CounterValue) else None
    starts = "; it starts with the half." if timer.starts else "."
    if timer.per and counted is not None and counted.entity == EACH:
        lasts = f"which lasts as many s as its counter {quoted_measure(counted.counter)} says when it starts"
        return f"There is a timer {quoted(name)} for {nouns.each_of(timer.per)}, {lasts}{starts}"
    lasts = f"lasts {duration_words(nouns, timer.lasts_s)}{' when it starts' if counted else ''}"
    one_for_each = f"; there is one for {nouns.each_of(timer.per)}" if timer.per else ""
    return f"The timer {quoted(name)} {lasts}{one_for_each}{starts}"


def _phase_words(nouns: Nouns, name: str, phase: Phase) -> str:
    begun = " when it begins" if isinstance(phase.lasts_s, CounterValue) else ""
    lasts = (
        f"lasts {duration_words(nouns, phase.lasts_s)}{begun}, then {quoted(phase.next)} follows"
        if phase.lasts_s
        else ("lasts until a rule begins another")
    )
    told = "; meanwhile a kick-off is awaited" if phase.waiting_for_kickoff else ""
    clock = "goes on" if phase.clock == "runs" else f"stands still{', timers go on' * bool(nouns.scenario.timers)}"
    held = " All robots are held meanwhile: their wheels stand still, whatever their programs say."
    return f"The phase {quoted(name)} {lasts}; the clock {clock}{told}.{held if phase.robots == 'held' else ''}"


def _anew_words(scenario: Scenario) -> Iterator[str]:
    """Return what a rule does that begins the phase in which it is judged, where one does."""
    if any(
        isinstance(action, SetPhase) and (rule.phases == "any" or action.phase in rule.phases)
        for rule in scenario.rules.values()
        for action in rule.actions
    ):
        yield (
            "Where a rule begins the phase that is on already, that phase begins anew: with all of its time, and what "
            "must last for a time, or move within one, is measured anew."
        )


def _held_words(nouns: Nouns) -> Iterator[str]:
    """Return what it means to be held, where rules hold robots."""
    rules = nouns.scenario.rules.values()
    if any(isinstance(action, Hold) for rule in rules for action in rule.actions):
        judged = any(isinstance(trigger, NoProgress) for rule in rules for trigger in rule.triggers)
        yield (
            "A robot that is held still stands with braked wheels, whatever its program says, until its time is over "
            f"or it is let go.{' That it does not move counts only from then on.' if judged else ''}"
        )


def _beginnings(scenario: Scenario, nouns: Nouns) -> Iterator[str]:
    """Return what counters and flags begin at, where that is not 0 or unset, and which of them outlive a half.

    Whose they are, the sentences that name them tell.
    """
    told: set[str] = set()
    for name, counter in scenario.counters.items():
        stays = counter.keep == "match" and scenario.match.halves > 1
        if counter.initial or stays:
            told.add("counter")
            when = "the match starts; it goes on from half to half" if stays else "a half starts"
            yield f"{_kept_words(nouns, 'counter', name)} {number(counter.initial)} when {when}."
    for name, flag in scenario.flags.items():
        stays = flag.keep == "match" and scenario.match.halves > 1
        if flag.initial or stays:
            told.add("flag")
            what = "set" if flag.initial else "not set"
            when = "the match starts; it stays as it is from half to half" if stays else "a half starts"
            yield f"{_kept_words(nouns, 'flag', name)} {what} when {when}."
    if scenario.match.halves > 1:
        yield from _anew(scenario, told)


def _anew(scenario: Scenario, told: AbstractSet[str]) -> Iterator[str]:
    """Return that what has no sentence of its own begins anew in every half; ``told``: of which kinds some have one."""
    words = {
        "counter": "begins at 0 in every half.",
        "flag": "is not set when a half starts.",
    }
    plain = {
        "counter": any(one.keep != "match" and not one.initial for one in scenario.counters.values()),
        "flag": any(one.keep != "match" and not one.initial for one in scenario.flags.values()),
    }
    said = [f"{'Any other' if kind in told else 'A'} {kind} {words[kind]}" for kind in words if plain[kind]]
    if said:
        yield " ".join(said)


def _kept_words(nouns: Nouns, kind: str, name: str) -> str:
    owners, which = nouns.owners(kind, name), quoted_measure(name) if kind == "counter" else quoted(name)
    if owners is None:
        return f"The {kind} {which} is"
    return f"There is a {kind} {which} for {nouns.each_of(owners)}; it is"


def _draw_words(nouns: Nouns, name: str, draw: Draw) -> str:
    # As they are written: a program may be told them, or have to tell them.
    times = Counter(value_words(nouns, entry) for entry in draw.values)
    if nouns.is_set(name):
        return f"{quoted_measure(name)} is {listed(list(times), 'or')}, as rules set it."
    often = len(times) < len(draw.values)
    cases = [f"{word} ({_often(draw, count)})" if often else word for word, count in times.items()]
    values = listed(cases, "or")
    # A half that draws anew knows nothing of what was drawn last in the one before.
    forgets = nouns.scenario.match.halves > 1 and draw.keep != "match"
    again = f", {'in a half ' * forgets}never the same twice running" if draw.not_last else ""
    if draw.not_again is not None:
        where = "in a half" if draw.not_again == "half" else "in the match"
        again += f"; {where} none comes {'more often' if often else 'again'} before all have been drawn"
    if name in _drawn_by_rules(nouns, anew=True):
        keep = f"when {'the match' if draw.keep == 'match' else 'a half'} starts, and again when a rule says so"
    else:
        keep = "once a match" if draw.keep == "match" else "when a half starts"
    also = "; rules set it as well" if name in _drawn_by_rules(nouns, anew=False) else ""
    return f"Chance decides {quoted_measure(name)} {keep}: {values}{again}{also}."


def _often(draw: Draw, count: int) -> str:
    """Return how often a value comes that is written so many times; a share only where each draw is like the first."""
    if draw.not_again is not None:
        return {1: "once", 2: "twice"}.get(count, f"{count} times")
    if draw.not_last:
        return f"with {count} chance{'s' if count > 1 else ''}"
    return f"in {count} of {len(draw.values)} cases"


def _drawn_by_rules(nouns: Nouns, *, anew: bool) -> set[str]:
    """Return what rules draw anew, or what they set to a value."""
    actions = (action for rule in nouns.scenario.rules.values() for action in rule.actions)
    return {action.draw for action in actions if isinstance(action, DrawAction) and (action.as_ is None) == anew}


def _sequence_words(nouns: Nouns, name: str, sequence: Sequence) -> str:
    places = sequence.places()
    way = ", then ".join(map(nouns.any_of, places)) + (" and back to the first" if sequence.cyclic else "")
    owners, made = nouns.owners("sequence", name), _step_words(nouns, [name for step in places for name in step])
    who = nouns.all_of(followed(sequence)).text if owners is None else f"that {nouns.kinds_of(owners)}"
    if sequence.wrong_step == "break":
        # Of a step that several places satisfy none of the others is wrong while it is the last one.
        several = any(len(nouns.roster.expand(tuple(step))) > 1 for step in places)
        right = "belongs neither to the step reached last nor to the next" if several else _NEITHER
        wrong = f"after the first step, {made} which {right} breaks it: it begins anew"
        also = "also "
    else:
        wrong, also = f"{made} out of turn changes nothing", ""
    causes = [] if sequence.cyclic else ["when it is complete"]
    causes += _resets(nouns, name)
    placed = f"when a rule puts {who} somewhere or takes it off the field"
    goes_on = sequence.when_placed == "goes_on"
    causes += [] if goes_on else [placed]
    # The end of a round is the first step of the next one: nothing is lost there.
    rounds = "Back at the first step it is complete, and the next round has begun. " if sequence.cyclic else ""
    before_last = ", ".join(causes[:-1]) + ", and " if len(causes) > 1 else ""
    again = f"{rounds}It begins anew {also}{before_last}{causes[-1]}. " if causes else rounds
    again += f"{placed[:1].upper()}{placed[1:]}, the steps made so far are kept." if goes_on else ""
    when = _followed_words(nouns, name)
    whose = f"The sequence {quoted(name)} is the way of {who}"
    if owners is not None:
        each = nouns.each_of(owners)
        whose = f"{each[:1].upper()}{each[1:]} has a sequence {quoted(name)} of its own"
    return f"{whose}: {way}; {wrong}. {again.strip()}{when}"


def _resets(nouns: Nouns, name: str) -> list[str]:
    """Return when rules make a sequence begin anew, if any do."""
    rules = [
        f"[{rule_name}]"
        for rule_name, rule in nouns.scenario.rules.items()
        if any(isinstance(action, SequenceAction) and action.sequence == name for action in rule.actions)
    ]
    return [f"when the rule {listed(rules, 'or')} says so"] if rules else []


def _followed_words(nouns: Nouns, name: str) -> str:
    """Return in which phases a sequence is followed, if not in all: those of the rules that name it."""
    everywhere = dict.fromkeys(("play", *nouns.scenario.phases))
    lives = phases_of(nouns.scenario, name)
    if not lives or lives.issuperset(everywhere):
        return ""
    where = listed([quoted(phase) for phase in everywhere if phase in lives], "or")
    return f" It is followed in the phase {where} only, and begins anew after every other phase."


def _step_words(nouns: Nouns, names: list[str]) -> str:
    """Return what makes a step: zones are entered, gates are crossed forward."""
    gates = {place in nouns.scenario.gates for place in nouns.roster.expand(tuple(names))}
    if gates == {True}:
        return "crossing one of these forward"
    return "entering one of these or crossing it forward" if True in gates else "entering one of these"


def _scoring(scenario: Scenario, nouns: Nouns) -> Iterator[Block]:
    # Rules that say the same, one for each side of the field, are the same rows for the reader.
    of_rules = dict.fromkeys(_points_rows(nouns, rule) for rule in scenario.rules.values())
    rows = [row for rows in of_rules for row in rows]
    yield Heading(2, "Scoring")
    if rows:
        yield Table(("when", "who", "points"), tuple(rows))
    else:
        yield Paragraph("No rule gives points.")
    if rows or scenario.result != Result():
        criteria = "; if that is equal, ".join(_criterion_words(nouns, one) for one in scenario.result.rank)
        yield Paragraph(f"The better one has {criteria}.")


def _points_rows(nouns: Nouns, rule: Rule) -> tuple[tuple[str, str, str], ...]:
    """Return who gets how many points by a rule: one row for each who does, all that he gets in it."""
    points: dict[str, list[str]] = {}
    nouns = nouns.within(rule)
    for action in rule.actions:
        if isinstance(action, Score):
            given = f"{amount_words(nouns, action.points)}{bounds_words(action, 'score')}"
            points.setdefault(action.receiver(nouns), []).append(given)
    when = spoken(nouns, rule) or when_words(rule, nouns)
    first = dict.fromkeys(list(points)[:1], when)
    return tuple((first.get(who, "at the same time"), who, ", plus ".join(parts)) for who, parts in points.items())


def _criterion_words(nouns: Nouns, criterion: RankByScore | RankByTime | RankByCounter) -> str:
    if isinstance(criterion, RankByScore):
        return "more points" if criterion.score == "descending" else "fewer points"
    if isinstance(criterion, RankByCounter):
        larger = "larger" if criterion.order == "descending" else "smaller"
        return f"a {larger} value of {_own_counter(nouns, criterion.counter)}{_added_up(nouns, criterion.counter)}"
    stops = clock_may_stop(nouns.scenario)
    how = [
        *(["of all halves together"] if nouns.scenario.match.halves > 1 else []),
        *(["also counted while the clock stands still"] if stops else []),
    ]
    halves = f" ({', '.join(how)})" if how else ""
    time = f"a {'shorter' if criterion.time == 'ascending' else 'longer'} time{halves}"
    changes = [
        f"{seconds(abs(part.weight))} {'taken off' if part.weight < 0 else 'added'} for each count of "
        f"{_own_counter(nouns, part.counter)}"
        for part in criterion.plus
    ]
    return f"{time}, with {listed(changes, 'and')}" if changes else time


def _added_up(nouns: Nouns, name: str) -> str:
    """Return that what was counted in each half is added; a counter that is kept goes on by itself."""
    several = nouns.scenario.match.halves > 1 and nouns.scenario.counters[name].keep != "match"
    return " (all halves added up)" if several else ""


def _own_counter(nouns: Nouns, name: str) -> str:
    """Return what of a counter counts for one who competes: of one kept per robot, the sum of those of its robots."""
    owners = nouns.owners("counter", name)
    if owners is None or not set(nouns.scenario.robots) & set(nouns.roster.expand(owners)):
        return nouns.kept("counter", name, None)
    return f"the sum of the counters {quoted_measure(name)} of its own robots"


def _places(scenario: Scenario, nouns: Nouns) -> Iterator[Block]:
    actions = [action for rule in scenario.rules.values() for action in rule.actions if isinstance(action, Place)]
    used = {name for action in actions for name in layouts_of(scenario, action)}
    if used:
        yield Heading(2, "Where things are put")
    for name, layout in scenario.placements.items():
        if name not in used:
            continue
        placed = (placement_words(nouns, placing.entity, placing.at, placing) for placing in layout)
        yield Paragraph(f"{quoted(name)}: {'; '.join(placed)}.")


def _entry_words(scenario: Scenario) -> Iterator[Block]:
    """Return what several places of one program mean, and that a folder named after a colour is everybody's."""
    places = {
        (robot, place)
        for entrant in scenario.entrants.values()
        for robot, entries in entrant.robots.items()
        for place in (entries if isinstance(entries, tuple) else (entries,))
    }
    if any(isinstance(entries, tuple) for one in scenario.entrants.values() for entries in one.robots.values()):
        yield Paragraph(
            "Where several places are named for a program, it lies in one of them: the first that exists is taken."
        )
    official = f"{_OFFICIAL_FOLDER}/"
    if any(place.startswith(official) and scenario.robots[robot].colour != "blue" for robot, place in places):
        yield Paragraph(f"The folder {_OFFICIAL_FOLDER} has this name for every team, whichever colour it plays.")


def _submission(scenario: Scenario, _nouns: Nouns) -> Iterator[Block]:
    yield Heading(2, "What to hand in")
    rows = [
        (plain(seat), plain(robot), " or ".join(entries) if isinstance(entries, tuple) else entries)
        for seat, entrant in scenario.entrants.items()
        for robot, entries in entrant.robots.items()
    ]
    yield Table(("who", "robot", "program"), tuple(rows))
    yield from _entry_words(scenario)
    asked = [set(entrant.robots.values()) for entrant in scenario.entrants.values()]
    if scenario.match.swap_sides and scenario.match.halves > 1 and any(one != asked[0] for one in asked):
        yield Paragraph("As the teams change sides, each of them hands in all these programs.")
    yield Paragraph(_limit_words(scenario.limits))
    if any(has(scenario, robot, TeamEmitterDevice) for robot in entrant_of(scenario)):
        yield Paragraph(f"A radio packet of more than {number(scenario.limits.message_kb)} kB is not sent.")


def _limit_words(limits: Limits) -> str:
    """Return what a program may use; the limit of CPU time is named if it was set."""
    computing = f"{seconds(limits.processor_s)} of processor time in a half, " if limits.processor_s is not None else ""
    threads = f"{counted(limits.processes, 'thread')} beside its first one"
    return (
        f"Limits: {seconds(limits.start_s)} to the first step, {seconds(limits.step_s)} for a step "
        f"and {seconds(limits.half_s)} in all in a half (its own CPU time and idle time), {computing}"
        f"{limits.memory_mb} MB of memory, {number(limits.output_mb)} MB of output, "
        f"{number(limits.scratch_mb)} MB of files in its own folder and {threads}. "
        "A program that exceeds one stops for the rest of the half."
    )
