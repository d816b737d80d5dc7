"""What a rule sheet says, section by section."""

from __future__ import annotations

from collections.abc import Iterator

from rcj_challenges.scenario.models.actions import Score
from rcj_challenges.scenario.models.scenario import RankByCounter, RankByScore, RankByTime, Result, Scenario
from rcj_challenges.scenario.models.state import AnyStep, Draw, Phase, Sequence
from rcj_challenges.scenario.roster import Roster
from rcj_challenges.views.sheet.blocks import Block, Heading, Items, Paragraph, Table, as_html, as_markdown
from rcj_challenges.views.sheet.deeds import placing_words
from rcj_challenges.views.sheet.ground import field_blocks
from rcj_challenges.views.sheet.machines import robot_blocks
from rcj_challenges.views.sheet.nouns import Nouns, listed, plain, quoted
from rcj_challenges.views.sheet.phrases import amount, seconds
from rcj_challenges.views.sheet.rules import rule_blocks, when_words
from rcj_challenges.views.sheet.spoken import spoken
from rcj_challenges.views.sheet.told import told_blocks


def sheet_markdown(scenario: Scenario, roster: Roster) -> str:
    """Return the rule sheet as Markdown."""
    return as_markdown(sheet_blocks(scenario, roster))


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
        yield Paragraph(scenario.description)


def _course(scenario: Scenario, nouns: Nouns) -> Iterator[Block]:
    match = scenario.match
    yield Heading(2, "Course")
    halves = "One half" if match.halves == 1 else f"{match.halves} halves"
    swap = "; the teams change sides between halves" if match.swap_sides and match.halves > 1 else ""
    first = f" A half begins in the phase {quoted(scenario.first_phase)}." if scenario.first_phase != "play" else ""
    yield Paragraph(f"{halves} of {seconds(match.half_s)}{swap}.{first} Everything is judged on every tick of 32 ms.")
    entries = [
        *(_phase_words(name, phase) for name, phase in scenario.phases.items()),
        *(
            f"The timer {quoted(name)} lasts {seconds(timer.lasts_s)}"
            + (f"; there is one for {nouns.each_of(timer.per)}" if timer.per else "")
            + ("; it starts with the half." if timer.starts else ".")
            for name, timer in scenario.timers.items()
        ),
        *(_draw_words(name, draw) for name, draw in scenario.draws.items()),
        *(_sequence_words(nouns, name, sequence) for name, sequence in scenario.sequences.items()),
    ]
    if entries:
        yield Items(tuple(entries))


def _phase_words(name: str, phase: Phase) -> str:
    lasts = f"lasts {seconds(phase.lasts_s)}" if phase.lasts_s else "lasts until a rule ends it"
    told = "; meanwhile a kick-off is awaited" if phase.waiting_for_kickoff else ""
    clock = "goes on" if phase.clock == "runs" else "stands still"
    return f"The phase {quoted(name)} {lasts}, then {quoted(phase.next)} follows; the clock {clock}{told}."


def _draw_words(name: str, draw: Draw) -> str:
    values = listed([plain(str(entry)) for entry in draw.values], "or")
    again = ", never the same twice running" if draw.not_last else ""
    keep = "once a match" if draw.keep == "match" else "when a half starts"
    return f"Chance decides {quoted(name)} {keep}: {values}{again}."


def _sequence_words(nouns: Nouns, name: str, sequence: Sequence) -> str:
    steps = [nouns.any_of(step.any_of if isinstance(step, AnyStep) else step) for step in sequence.steps]
    back = " and back to the first" if sequence.cyclic else ""
    wrong = "breaks it" if sequence.wrong_step == "break" else "changes nothing"
    way = ", then ".join(steps)
    return (
        f"The sequence {quoted(name)} is the way of {nouns.thing(sequence.entity)}: {way}{back}; a wrong step {wrong}."
    )


def _scoring(scenario: Scenario, nouns: Nouns) -> Iterator[Block]:
    rows = [
        (spoken(nouns, rule) or when_words(rule, nouns), plain(action.entrant), amount(nouns, action.points))
        for rule in scenario.rules.values()
        for action in rule.actions
        if isinstance(action, Score)
    ]
    yield Heading(2, "Scoring")
    if rows:
        # Rules that say the same, one for each side of the field, are one row for the reader.
        yield Table(("when", "who", "points"), tuple(dict.fromkeys(rows)))
    else:
        yield Paragraph("No rule gives points.")
    if scenario.result != Result():
        criteria = "; if that is equal, ".join(_criterion_words(nouns, one) for one in scenario.result.rank)
        yield Paragraph(f"The better one has {criteria}.")


def _criterion_words(nouns: Nouns, criterion: RankByScore | RankByTime | RankByCounter) -> str:
    if isinstance(criterion, RankByScore):
        return "more points" if criterion.score == "descending" else "fewer points"
    if isinstance(criterion, RankByCounter):
        larger = "larger" if criterion.order == "descending" else "smaller"
        return f"a {larger} value of {nouns.kept('counter', criterion.counter, None)}"
    added = "".join(
        f", with {seconds(part.weight)} added for each count of {nouns.kept('counter', part.counter, None)}"
        for part in criterion.plus
    )
    return f"a {'shorter' if criterion.time == 'ascending' else 'longer'} time{added}"


def _places(scenario: Scenario, nouns: Nouns) -> Iterator[Block]:
    if scenario.placements:
        yield Heading(2, "Where things are put")
    for name, layout in scenario.placements.items():
        yield Paragraph(f"{quoted(name)}: {'; '.join(placing_words(nouns, placing) for placing in layout)}.")


def _submission(scenario: Scenario, _nouns: Nouns) -> Iterator[Block]:
    yield Heading(2, "What to hand in")
    rows = [
        (plain(seat), plain(robot), " or ".join(entries) if isinstance(entries, tuple) else entries)
        for seat, entrant in scenario.entrants.items()
        for robot, entries in entrant.robots.items()
    ]
    yield Table(("who", "robot", "program"), tuple(rows))
    limits = scenario.limits
    yield Paragraph(
        f"Limits: {seconds(limits.start_s)} to the first step, {seconds(limits.step_s)} for a step "
        f"and {seconds(limits.half_s)} in all in a half (only the waiting for that program counts), "
        f"{limits.memory_mb} MB of memory, {limits.output_mb:g} MB of output. "
        "A program that exceeds one stops for the rest of the half."
    )
