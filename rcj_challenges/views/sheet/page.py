"""What a rule sheet contains, section by section."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from rcj_challenges.core.amounts import Noun
from rcj_challenges.devices.team_emitter import TeamEmitterDevice
from rcj_challenges.robots.channels import entrant_of
from rcj_challenges.rules.effects import PlacesLayout
from rcj_challenges.rules.phrasing import counted, listed, number, plain, quoted, seconds
from rcj_challenges.rules.placement import placement_words
from rcj_challenges.scenario.models.limits import Limits
from rcj_challenges.scenario.models.scenario import Result, Rule, Scenario
from rcj_challenges.scenario.placeholders import description_of, filled
from rcj_challenges.scenario.roster import Roster
from rcj_challenges.scenario.rule_effects import layouts_of
from rcj_challenges.views.drawing.field import picture_of
from rcj_challenges.views.sheet.course import course_blocks, length_words
from rcj_challenges.views.sheet.document import Block, Items, Section, Sheet, Table
from rcj_challenges.views.sheet.field import field_blocks
from rcj_challenges.views.sheet.guidelines import guideline_sections
from rcj_challenges.views.sheet.phrasebook import Phrasebook
from rcj_challenges.views.sheet.programs import program_sections
from rcj_challenges.views.sheet.robots import has, robot_blocks
from rcj_challenges.views.sheet.rules import rule_blocks, rules_on_sheet, when_words
from rcj_challenges.views.sheet.says import says_sentence


def sheet_of(scenario: Scenario, roster: Roster) -> Sheet:
    """Return the rule sheet of a scenario."""
    phrases, rules = Phrasebook(scenario, roster), rules_on_sheet(scenario)
    lead = [
        Section("The match", tuple(_match(scenario))),
        Section("Scoring", tuple(_scoring(scenario, phrases, rules))),
    ]
    sentences = dict.fromkeys(says_sentence(phrases, rule) for name, rule in scenario.rules.items() if name in rules)
    if texts := tuple(filter(None, sentences)):
        lead.append(Section("Rules", (Items(texts),)))
    lead.append(Section("What to hand in", tuple(_submission(scenario))))
    lead += guideline_sections(scenario)
    appendix = [
        Section("Field", tuple(field_blocks(scenario, phrases))),
        Section("Robots", tuple(robot_blocks(scenario, phrases))),
        Section("Course", tuple(course_blocks(scenario, phrases))),
        Section("Rules in full", tuple(rule_blocks(scenario, phrases, rules))),
    ]
    if places := tuple(_layouts(phrases, rules)):
        appendix.append(Section("Where things are put", places))
    appendix += program_sections(scenario, phrases, rules)
    appendix.append(Section("Limits of programs", tuple(_limits(scenario))))
    return Sheet(scenario.title, description_of(scenario), picture_of(scenario, roster), tuple(lead), tuple(appendix))


def _match(scenario: Scenario) -> Iterator[Block]:
    teams = [
        f"{plain(seat)} ({listed(list(map(plain, one.robots)), 'and')})" for seat, one in scenario.entrants.items()
    ]
    drivers = f" Programs drive {listed(teams, 'and')}." if teams else ""
    yield f"{length_words(scenario)}{drivers}"


def _scoring(scenario: Scenario, phrases: Phrasebook, rules: Mapping[str, Rule]) -> Iterator[Block]:
    # Rules that say the same, one for each side of the field, are the same rows for the reader.
    rows = dict.fromkeys(row for rule in rules.values() for row in _points_rows(phrases, rule))
    yield Table(("when", "who", "points"), tuple(rows)) if rows else "No rule gives points."
    if rows or scenario.result != Result():
        yield how_to_win(scenario)


def _points_rows(phrases: Phrasebook, rule: Rule) -> Iterator[tuple[str, str, str]]:
    points: dict[str, list[str]] = {}
    own = phrases.within(rule)
    for receiver, words in filter(None, (action.points_row(own) for action in rule.actions)):
        points.setdefault(receiver, []).append(words)
    when = says_sentence(own, rule) or f"{when_words(rule, phrases)}."
    yield from ((when, receiver, ", plus ".join(parts)) for receiver, parts in points.items())


def how_to_win(scenario: Scenario) -> str:
    """Return the sentences of the ranking, one behind the other."""
    by_score = {"more": "More points are better.", "less": "Fewer points are better."}
    said = (filled(one.says, scenario.params) or by_score[one.better] for one in scenario.result.rank)
    return " ".join(said)


def _layouts(phrases: Phrasebook, rules: Mapping[str, Rule]) -> Iterator[str]:
    scenario = phrases.scenario
    placed = [one for rule in rules.values() for one in rule.effects(PlacesLayout)]
    used = {name for one in placed for name in layouts_of(scenario, one)}
    for name, layout in scenario.placements.items():
        if name in used:
            words = (placement_words(phrases, placing.entity, placing.at, placing) for placing in layout)
            yield f"{quoted(name)}: {'; '.join(words)}."


def _submission(scenario: Scenario) -> Iterator[Block]:
    rows = [
        (plain(seat), plain(robot), " or ".join(entries) if isinstance(entries, tuple) else entries)
        for seat, entrant in scenario.entrants.items()
        for robot, entries in entrant.robots.items()
    ]
    yield Table(("team", "robot", "program"), tuple(rows))
    if any(isinstance(entries, tuple) for one in scenario.entrants.values() for entries in one.robots.values()):
        yield "Of several places of a program the first that exists is taken."
    programs = {frozenset(entrant.robots.values()) for entrant in scenario.entrants.values()}
    if scenario.match.swap_sides and scenario.match.halves > 1 and len(programs) > 1:
        yield "As the teams change sides, each of them hands in the programs of both."


def _limits(scenario: Scenario) -> Iterator[str]:
    yield _limit_words(scenario.limits, scenario.match.period)
    if any(has(scenario, robot, TeamEmitterDevice) for robot in entrant_of(scenario)):
        yield f"A radio packet of more than {number(scenario.limits.message_kb)} kB is not sent."


def _limit_words(limits: Limits, period: Noun) -> str:
    half = period.a
    computing = "" if limits.processor_s is None else f"{seconds(limits.processor_s)} of processor time in {half}, "
    return (
        f"A program may take {seconds(limits.start_s)} to the first step, {seconds(limits.step_s)} for a step "
        f"and {seconds(limits.half_s)} in all in {half} (its own CPU time and idle time), {computing}"
        f"{limits.memory_mb} MB of memory, {number(limits.output_mb)} MB of output, "
        f"{number(limits.scratch_mb)} MB of files in its own folder and {counted(limits.processes, 'thread')} beside "
        f"its first one. A program that exceeds one of these stops for the rest of the {period}."
    )
