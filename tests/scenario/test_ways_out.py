"""Errors of who takes one thing for another say what it is, and how what was meant is written."""

from __future__ import annotations

import pytest

from tests.scenario.writing import complaints, loaded, rule

PLACE = "{action: place, entity: ball, at: %s}"


def test_a_point_is_written_with_its_word():
    assert complaints(rule(action=PLACE % "[0.1, -0.2]"))[0].endswith(
        "found a list of 2; a point is written {point: [0.1, -0.2]}"
    )
    assert complaints(rule(action=PLACE % "[0.1]"))[0].endswith("found a list of 1")
    assert complaints(rule(action=PLACE % "[centre, ball]"))[0].endswith("found a list of 2")


@pytest.mark.parametrize(
    ("action", "more", "told"),
    [
        ("{action: set_spot, spot: centre, to: place}", "draws: {place: {values: [centre]}}\n",
         "unknown entity, obstacle, spot or zone 'place', which is a draw; there are"),
        ("{action: score, entrant: Y1}", "", "unknown entrant 'Y1', which is a robot; there are blue, yellow"),
        ("{action: set_flag, flag: n}", "flags: {f: {}}\ncounters: {n: {}}\n", "unknown flag 'n', which is a counter; there is only f"),
        ("{action: set_phase, phase: nap}", "timers: {nap: {lasts_s: 1}}\n", "unknown phase 'nap', which is a timer; there is only play"),
        ("{action: place, layout: in_play}", "placements: {a: [{entity: ball, at: start}]}\n",
         "unknown layout 'in_play', which is a group; there is only a"),
        ("{action: score, entrant: nobody}", "", "unknown entrant 'nobody'; there are blue, yellow"),
    ],
)  # fmt: skip
def test_a_name_of_something_else_is_told_to_be_one(action, more, told):
    assert any(told in complaint for complaint in complaints(more + rule(action=action)))


def test_a_rule_for_each_team_is_written_once_and_repeated():
    for_each = "rules:\n  r: {for_each: entrants, triggers: [{trigger: half_started}], actions: [{action: end}]}\n"
    assert complaints(for_each)[0].endswith(
        "unknown entity, obstacle, zone or gate 'entrants': a rule for each team is written with repeat_for: [blue, yellow], "
        "where {param: this} is the team and the colour of all its robots; in for_each: robots entrant: each is the team "
        "of each of them"
    )
    assert complaints("counters: {streak: {per: teams}}\n")[0].endswith(
        "unknown entity, obstacle, zone or gate 'teams': nothing is kept for each team; give each team one under a name "
        "of its own (a rule with repeat_for can name them), or, to rank by it, keep it per: robots and count it for one robot of the team"
    )


@pytest.mark.parametrize("names", ["[yellow, blue]", "{yellow: {zone: blue_goal}}"])
def test_a_rule_for_each_of_several_names_is_one_for_a_group_or_repeated(names):
    (complaint,) = complaints(rule(rest=f"    for_each: {names}\n"))
    assert complaint.endswith(
        "; for several, name a group of them, or write the rule once for each name with repeat_for"
    )


def test_who_has_a_group_of_that_name_is_not_told_so():
    groups = "groups: {teams: [Y1, B1]}\ncounters: {streak: {per: teams}}\n"
    assert loaded(groups).scenario.counters["streak"].per == "teams"


@pytest.mark.parametrize("action", ["{action: set_flag, flag: away, entity: chair}", "{action: remove, entity: chair}"])
def test_what_was_drawn_is_acted_on_by_a_rule_for_each(action):
    more = "flags: {away: {per: robots}}\ndraws: {chair: {values: [Y1, B1]}}\n"
    assert any(
        "'chair', which is a draw; there are" in one
        and one.endswith(
            "; to do it to the one drawn: for_each, {condition: drawn, draw: chair, equals: each}, and 'each' here"
        )
        for one in complaints(more + rule(action=action))
    )


@pytest.mark.parametrize(
    ("section", "timer", "since", "then"),
    [("timers", "p", "", ""), ("phases", "…", " that runs since then", " and set_phase")],
)
def test_what_lasts_as_long_as_a_counter_says_is_a_rule(section, timer, since, then):
    condition = f"{{condition: timer, timer: {timer}, at_least: {{counter: n}}}}"
    assert complaints(f"counters: {{n: {{}}}}\n{section}: {{p: {{lasts_s: {{counter: n}}}}}}\n")[0].endswith(
        f"found a mapping with counter; as long as a counter says: a long timer{since}, and a rule with "
        f"{{trigger: holds, condition: {condition}}}{then}"
    )


@pytest.mark.parametrize(
    ("trigger", "action", "told"),
    [
        ("{trigger: every, every_s: 10}", "{action: end}", "; every 5 s is {trigger: time_reached, at_s: 5, every_s: 5}"),
        ("{trigger: half_started}", "{action: wait, for_s: 2}", "; a pause is a phase, and what comes later waits for a timer"),
        ("{trigger: half_started}", "{action: freeze, entity: Y1}", "; 'hold' keeps a robot where it is, for_s or until 'release'"),
        ("{trigger: half_started}", "{action: let_go, entity: Y1}", "; 'release' lets a robot go that 'hold' holds"),
        ("{trigger: hold}", "{action: end}", "; what waits for a condition is 'holds'; 'hold' is an action that keeps robots still"),
        ("{trigger: half_started}", "{action: if}", "; what depends on something is a rule of its own, with conditions"),
    ],
)  # fmt: skip
def test_a_word_of_other_languages_leads_to_the_one_here(trigger, action, told):
    assert complaints(rule(trigger, action))[0].endswith(told)


@pytest.mark.parametrize("told", ["{timer: attempt, fraction: true}", "{word: time_s, fraction: true}"])
def test_times_that_are_told_have_their_fraction_anyway(told):
    (complaint,) = complaints(f"timers: {{attempt: {{lasts_s: 5}}}}\nbroadcast: {{fields: {{run: {told}}}}}\n")
    assert complaint.endswith("; a payload and the broadcast tell times with their fraction anyway: leave it out")
