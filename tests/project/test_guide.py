"""What the authoring guide says of presets, clocks and halves is so."""

from dataclasses import replace
from pathlib import Path
from textwrap import dedent

import pytest

from rcj_challenges.core.timing import s_from_ticks, ticks_from_s
from rcj_challenges.expect.runner import run_test
from rcj_challenges.expect.scripted_match import ScriptedMatch, half_of
from rcj_challenges.scenario.lint.registry import lint
from rcj_challenges.scenario.load import Loaded, load, load_text
from rcj_challenges.scenario.resources import PRESETS_FOLDER, names_in

GUIDE = Path(__file__).parents[2] / "docs" / "authoring.md"
HEAD = "schema_version: 2\nid: guide\ntitle: Guide\nextends: soccersim_v2\n"
STOPPED = (
    HEAD
    + """match: {half_s: 10}
phases: {pause: {lasts_s: 5, clock: stops}}
timers: {cooking: {lasts_s: 4, starts: true}}
rules:
  whistle:
    triggers: [{trigger: time_reached, at_s: 2}]
    actions: [{action: set_phase, phase: pause}, {action: emit, event: PAUSE}]
  on_the_clock:
    phases: any
    triggers: [{trigger: time_reached, at_s: 4}]
    actions: [{action: emit, event: CLOCK, payload: {time_s: {word: time_s}, left_s: {word: time_left_s}}}]
  cooked:
    phases: any
    triggers: [{trigger: timer_expired, timer: cooking}]
    actions: [{action: emit, event: COOKED}]
  held:
    phases: any
    triggers: [{trigger: holds, conditions: [{entity: ball, in: pitch}], for_s: 6}]
    actions: [{action: emit, event: HELD}]
  lazy:
    phases: any
    triggers: [{trigger: no_progress, entity: ball, distance_m: 1, within_s: 6.5}]
    actions: [{action: emit, event: LAZY}]
"""
)
KEPT = HEAD + "match: {halves: 2, half_s: 5, swap_sides: true}\nflags: {done: {per: robots, keep: match}}\n"
KEPT += "rules: {r: {triggers: [{trigger: time_reached, at_s: 1}], actions: [{action: set_flag, flag: done, entity: Y1}]}}\n"


def row(section: str) -> str:
    """Return the row of a section in the guide's table."""
    (found,) = (line for line in GUIDE.read_text("utf-8").splitlines() if line.startswith(f"| `{section}` |"))
    return found


def played(loaded: Loaded, lasts_s: float) -> ScriptedMatch:
    play = ScriptedMatch(loaded.scenario, loaded.roster)
    play.play_until(ticks_from_s(lasts_s))
    return play


@pytest.mark.parametrize("preset", names_in(PRESETS_FOLDER))
def test_the_guide_names_all_that_a_preset_brings(preset):
    scenario = load(PRESETS_FOLDER / f"{preset}.yaml").scenario
    brought = {"field.goals": scenario.field.goals, "kits": scenario.kits}
    sections = ("balls", "robots", "entrants", "zones", "spots", "groups")
    brought |= {section: getattr(scenario, section) for section in sections}
    assert [name for section, names in brought.items() for name in names if f"`{name}`" not in row(section)] == []


def test_a_disallowed_goal_is_taken_away():
    lines = ("field: {goals: {blue_goal: null}}", "zones: {blue_goal: null}", "groups: {in_play: [pitch, yellow_goal]}")
    assert all(f"`{line}`" in GUIDE.read_text("utf-8") for line in lines)
    scenario = load_text("\n".join((HEAD, *lines, "rules: {}"))).scenario
    assert (list(scenario.field.goals), "blue_goal" in scenario.zones) == (["yellow_goal"], False)


def test_a_stopped_clock_stops_neither_timers_nor_holds_nor_no_progress():
    came = {event.name: event for event in played(load_text(STOPPED), 10).events}
    at_s = {name: s_from_ticks(event.tick) for name, event in came.items()}
    assert at_s == pytest.approx({"PAUSE": 2, "COOKED": 4, "HELD": 6, "LAZY": 6.5, "CLOCK": 9}, abs=0.11)
    reported = came["CLOCK"].payload
    assert [round(reported[name], 1) for name in ("time_s", "left_s")] == [4.0, 6.0]


def test_rule_of_the_phase_play_restarts_after_a_pause_and_misses_a_timer_that_expired_meanwhile():
    came = {event.name: event.tick for event in played(load_text(STOPPED.replace("    phases: any\n", "")), 15).events}
    at_s = {name: s_from_ticks(tick) for name, tick in came.items()}
    assert at_s == pytest.approx({"PAUSE": 2, "CLOCK": 9, "HELD": 7 + 6, "LAZY": 7 + 6.5}, abs=0.11)


def test_a_flag_that_is_kept_stays_with_the_seat_when_the_teams_change_sides():
    loaded = load_text(KEPT)
    first = played(loaded, 2)
    second = replace(half_of(loaded.scenario, 2), kept=first.referee.kept)
    assert second.teams == {"blue": "yellow", "yellow": "blue"}
    after = ScriptedMatch(loaded.scenario, loaded.roster, second)
    assert [name for name, done in after.referee.flags["done"].items() if done] == ["Y1"]


def test_the_rule_of_the_fifth_step_gives_two_points_if_y3_touched_the_ball_last():
    _, begins, rest = GUIDE.read_text("utf-8").partition("   rules:\n     goal:\n")
    play = "{keyframes: [{at_s: 1, touch: [[%s, ball]]}, {at_s: 2, place: {ball: [0, 0.8]}}], lasts_s: 3, score: {yellow: %d}}"
    tests = "expect:\n" + f"  yes: {play % ('Y3', 2)}\n" + f"  no: {play % ('Y2', 0)}\n"
    loaded = load_text(HEAD + dedent((begins + rest).partition("```")[0]) + tests)
    assert [run_test(loaded, name).differences for name in loaded.scenario.expect] == [(), ()]
    assert lint(loaded) == []


def test_the_example_that_extends_the_match_passes_its_own_test_and_lint():
    _, begins, rest = GUIDE.read_text("utf-8").partition("schema_version: 2\nid: quick_match\n")
    loaded = load_text((begins + rest).partition("```")[0])
    assert loaded.scenario.match.half_s == 180
    assert lint(loaded) == []
    (name,) = loaded.scenario.expect
    assert run_test(loaded, name).differences == ()


def test_the_example_of_places_that_follow_from_one_number_is_symmetric_whatever_the_number():
    _, begins, rest = GUIDE.read_text("utf-8").partition("params: {gap_m: 0.15}\n")
    text = HEAD + dedent((begins + rest).partition("```")[0])
    for gap_m, overrides in ((0.15, ()), (0.2, ("gap_m=0.2",))):
        scenario = load_text(text, overrides).scenario
        assert (scenario.zones["west"].x_max_m, scenario.zones["east"].x_min_m) == (-gap_m, gap_m)
        (left, _), (right, _) = scenario.gates["between"].from_m, scenario.gates["between"].to_m
        assert -left == right == round(gap_m - 0.02, 9)
