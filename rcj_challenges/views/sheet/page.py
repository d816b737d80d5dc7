"""What a rule sheet contains, section by section."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cache

from rcj_challenges.core.amounts import Noun
from rcj_challenges.core.grouping import grouped
from rcj_challenges.devices.team_emitter import TeamEmitterDevice
from rcj_challenges.robots.channels import entrant_of
from rcj_challenges.rules.effects import PlacesLayout
from rcj_challenges.rules.phrasing import counted, listed, number, plain, quoted, seconds
from rcj_challenges.rules.placement import placement_words
from rcj_challenges.rules.values import value_words
from rcj_challenges.scenario.load import load
from rcj_challenges.scenario.models.limits import Limits
from rcj_challenges.scenario.models.scenario import Result, Rule, Scenario
from rcj_challenges.scenario.placeholders import filled
from rcj_challenges.scenario.resources import PRESETS_FOLDER, names_in
from rcj_challenges.scenario.roster import ENTRANTS, Roster
from rcj_challenges.scenario.rule_effects import layouts_of
from rcj_challenges.views.drawing.field import picture_of
from rcj_challenges.views.sheet.course import course_blocks, length_words
from rcj_challenges.views.sheet.document import Block, Items, Section, Sheet, Table, beyond
from rcj_challenges.views.sheet.field import field_blocks
from rcj_challenges.views.sheet.guidelines import guideline_sections
from rcj_challenges.views.sheet.phrasebook import Phrasebook
from rcj_challenges.views.sheet.programs import program_sections
from rcj_challenges.views.sheet.robots import has, robot_blocks
from rcj_challenges.views.sheet.rules import general_notes, rule_blocks, rules_on_sheet, when_words
from rcj_challenges.views.sheet.says import as_sentence, says_sentence


def sheet_of(scenario: Scenario, roster: Roster) -> Sheet:
    """Return the rule sheet of a scenario; of one without rules, such as a preset, all of it is the lead."""
    phrases, rules = Phrasebook(scenario, roster), rules_on_sheet(scenario)
    title, description, full = scenario.title, filled(scenario.description, scenario.params), _full(scenario, roster)
    setting = [
        Section("Field", (picture_of(scenario, roster),)),
        Section("Programs", tuple(_submission(scenario))),
        *guideline_sections(scenario),
    ]
    if not scenario.rules:
        return Sheet(title, description, (Section("The match", (length_words(scenario),)), *setting, *full))
    scoring = tuple(_scoring(phrases, rules))
    lead = [
        Section("How to win", tuple(_winning(scenario, is_scored=bool(scoring)))),
        Section("Scoring", scoring or ("No rule gives points.",)),
    ]
    shown = {words for block in scoring for words, _ in block.rows}
    sentences = dict.fromkeys(says_sentence(phrases, rule) for name, rule in scenario.rules.items() if name in rules)
    if texts := tuple(one for one in sentences if one and one not in shown and one not in description):
        lead.append(Section("Rules", (Items(texts),)))
    beside = {name: tuple(beyond(full, base)) for name, base in _presets().items()}
    base = min(beside, key=lambda name: len(repr(beside[name])))
    return Sheet(title, description, (*lead, *setting), beside[base], base)


@cache
def _presets() -> dict[str, tuple[Section, ...]]:
    """Return what there is to know of each preset."""
    loaded = {name: load(PRESETS_FOLDER / f"{name}.yaml") for name in names_in(PRESETS_FOLDER)}
    return {name: _full(one.scenario, one.roster) for name, one in loaded.items()}


def _full(scenario: Scenario, roster: Roster) -> tuple[Section, ...]:
    """Return every number and every rule."""
    phrases, rules = Phrasebook(scenario, roster), rules_on_sheet(scenario)
    sections = [
        Section("Rules in full", tuple(rule_blocks(phrases, rules))),
        Section("Ranking in full", tuple(_ranking(phrases))),
        Section("Where things are put", tuple(_layouts(phrases, rules))),
        Section("Course", tuple(course_blocks(scenario, phrases))),
        Section("Field in full", tuple(field_blocks(scenario, phrases))),
        Section("Robots", tuple(robot_blocks(scenario))),
        *program_sections(scenario, phrases),
        Section("How rules are judged", (Items(tuple(general_notes())),)),
        Section("Limits of programs", tuple(_limits(scenario))),
    ]
    return tuple(section for section in sections if section.blocks)


def _winning(scenario: Scenario, *, is_scored: bool) -> Iterator[Block]:
    if is_scored or scenario.result != Result():
        by_score = {"more": "The team with more points wins.", "less": "The team with fewer points wins."}
        said = (filled(one.says or by_score[one.better], scenario.params) for one in scenario.result.rank)
        yield " ".join(map(as_sentence, said))
    yield length_words(scenario)


def _scoring(phrases: Phrasebook, rules: Mapping[str, Rule]) -> Iterator[Table]:
    # What rules say that are copies of one, for each side of the field, is the same row for the reader.
    rows: dict[str, dict[str, dict[str, None]]] = {}
    for rule in rules.values():
        own = phrases.within(rule)
        points = grouped(filter(None, (action.points_row(own) for action in rule.actions)))
        for receiver, parts in points.items():
            when = says_sentence(phrases, rule) or f"{when_words(rule, phrases)}."
            rows.setdefault(when, {}).setdefault(", plus ".join(parts), {})[receiver] = None
    seats = set(map(plain, phrases.scenario.entrants))
    if rows:
        yield Table(("when", "points"), tuple((when, _points_words(given, seats)) for when, given in rows.items()))


def _points_words(given: Mapping[str, Mapping[str, None]], seats: set[str]) -> str:
    """Return what different receivers get; without their names if there is one team, or all get the same."""
    is_same = len(given) == 1 and (len(seats) == 1 or set(*given.values()) >= seats)
    if is_same:
        return next(iter(given))
    rows = ((points, listed([*receivers], "or")) for points, receivers in given.items())
    return "; ".join(f"{to}: {points}" if " " in points else f"{points} for {to}" for points, to in rows)


def _ranking(phrases: Phrasebook) -> Iterator[Items]:
    rank, halves = phrases.scenario.result.rank, phrases.period.many
    if rank == Result().rank:
        return
    own = phrases.of_each(ENTRANTS)
    over = {"sum": "", "best": f", the best of the {halves}", "worst": f", the worst of the {halves}"}
    words = (
        f"{value_words(own, one.value)}{over.get(one.over, ', when the match is over')}; {one.better} is better"
        for one in rank
    )
    yield Items(tuple(words), "For each team, each counts only if those before it are equal:", numbered=True)


def _layouts(phrases: Phrasebook, rules: Mapping[str, Rule]) -> Iterator[str]:
    scenario = phrases.scenario
    placed = [one for rule in rules.values() for one in rule.effects(PlacesLayout)]
    used = {name for one in placed for name in layouts_of(scenario, one)}
    for name, layout in scenario.placements.items():
        if name in used:
            words = (placement_words(phrases, placing.entity, placing.at, placing) for placing in layout)
            yield f"{quoted(name)}: {'; '.join(words)}."


def _submission(scenario: Scenario) -> Iterator[Block]:
    robots: dict[tuple[str, ...], dict[str, str]] = {}
    for seat, entrant in scenario.entrants.items():
        for robot, entries in entrant.robots.items():
            robots.setdefault(entries if isinstance(entries, tuple) else (entries,), {})[plain(robot)] = plain(seat)
    rows = (
        (listed([*names], "and"), listed([*dict.fromkeys(names.values())], "and"), ", else ".join(paths))
        for entries, names in robots.items()
        for paths in [_own_paths(entries, {*names.values()})]
    )
    yield Table(("robot", "team", "program"), tuple(rows))
    if scenario.match.swap_sides and scenario.match.halves > 1:
        programs = {frozenset(entrant.robots.values()) for entrant in scenario.entrants.values()}
        if len(programs) > 1:
            yield "As the teams change sides, each of them hands in the programs of both."


def _own_paths(entries: tuple[str, ...], seats: set[str]) -> tuple[str, ...]:
    """Return the places of a program that are not called after another colour than those of its teams, if there are."""
    others = {"blue", "yellow"} - seats
    return tuple(path for path in entries if not any(colour in path for colour in others)) or entries


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
