"""Each warning is reported at its place for a scenario that has the mistake, and not for one without it."""

from __future__ import annotations

from pathlib import Path

import pytest

from rcj_challenges.scenario.lint.registry import LINT_RULES, lint
from rcj_challenges.scenario.load import load, load_resolved, load_text

SOUND = """schema_version: 2
id: sound
title: Sound
extends: soccersim_v2
match: {half_s: 60}
"""


GOAL = """  goal:
    triggers: [{trigger: enters, entity: ball, zone: blue_goal}]
    actions: [{action: score, entrant: yellow}]
    says: A goal.
"""


def lint_of(*sections, rules=""):
    """Return the warnings about a sound scenario with more sections and rules."""
    text = SOUND + "".join(f"{section}\n" for section in sections) + "rules:\n" + GOAL + rules
    return lint(load_text(text, file="it.yaml"))


def codes(*sections, rules=""):
    """Return the codes of these warnings."""
    return [one.code for one in lint_of(*sections, rules=rules)]


def rule(name, trigger, actions="{action: emit, event: TOLD}", more=""):
    """Return a rule with a sentence."""
    return f"  {name}: {{triggers: [{trigger}], actions: [{actions}], says: It is so.{more}}}\n"


ROOT = Path(__file__).resolve().parents[2]
SHIPPED = sorted((ROOT / "scenarios").rglob("*.yaml"))


@pytest.mark.parametrize("path", SHIPPED, ids=lambda path: path.stem)
def test_shipped_scenario_has_no_warning(path):
    assert [str(one) for one in lint(load(path))] == []


def test_sound_scenario_has_no_warning():
    assert lint_of() == []


def test_warning_has_code_position_message_and_help():
    (found,) = lint_of("phases: {pause: {lasts_s: 3}}")
    assert str(found) == (
        "warning[phase-never-entered]: phase 'pause' is never entered\n"
        "  --> it.yaml:6:10  phases.pause\n"
        "help: enter it by {action: set_phase, phase: pause} in a rule that can fire, or by 'next' of a phase that ends"
    )
    assert found.to_json() == {
        "level": "warning",
        "code": "phase-never-entered",
        "message": "phase 'pause' is never entered",
        "help": found.help,
        "where": {"file": "it.yaml", "line": 6, "column": 10, "path": "phases.pause"},
        "repair": False,
        "details": "",
    }


def test_warnings_come_in_the_order_of_the_file():
    lines = [one.where.line for one in lint_of("phases: {pause: {}}", "counters: {a: {}}", "draws: {b: {values: [1]}}")]
    assert lines == sorted(lines)
    assert len(lines) == 3


def test_scenario_of_a_record_has_no_positions_to_report():
    assert lint(load_resolved(load("match").resolved)) == []


def test_every_check_has_a_unique_code_and_a_page():
    found = [one.code for one in LINT_RULES]
    assert len(set(found)) == len(found)
    assert all(type(one).__doc__ for one in LINT_RULES)


def test_every_check_is_tested_here():
    assert {one.code for one in LINT_RULES} == {code for code, *_ in CASES}


ENTER = rule("rest", "{trigger: time_reached, at_s: 1}", "{action: set_phase, phase: one}")
TOLD = rule("told", "{trigger: half_started}", "{action: emit, event: STARTED}")
EMPTY = ""

CASES = [
    # code, sections and rules with the mistake, sections and rules without it
    ("phase-never-entered", ("phases: {one: {}}", EMPTY),
     ("phases: {one: {lasts_s: 1}}", ENTER)),
    ("phase-never-entered", ("phases: {one: {lasts_s: 1}, two: {}}", ENTER + rule("back", "{trigger: phase_entered, phase: play, from: two}")),
     ("phases: {one: {lasts_s: 1}}", ENTER + rule("back", "{trigger: phase_entered, phase: play, from: one}"))),
    ("rule-never-fires", ("phases: {one: {lasts_s: 1}}", ENTER + rule("begin", "{trigger: half_started}", more=", phases: [one]")),
     ("phases: {one: {lasts_s: 1}}", ENTER + rule("begin", "{trigger: half_started}"))),
    ("rule-never-fires", ("phases: {one: {lasts_s: 1}}", ENTER + rule("wait", "{trigger: phase_entered, phase: one}")),
     ("phases: {one: {lasts_s: 1}}", ENTER + rule("wait", "{trigger: phase_entered, phase: one}", more=", phases: any"))),
    ("event-never-emitted", (EMPTY, TOLD + rule("b", "{trigger: event, event: STARTET}")),
     (EMPTY, TOLD + rule("b", "{trigger: event, event: STARTED}"))),
    ("event-never-emitted", ("expect: {t: {keyframes: [{at_s: 1}], lasts_s: 1, events: [{event: GAOL}]}}", EMPTY),
     ("expect: {t: {keyframes: [{at_s: 1}], lasts_s: 1, events: [{event: STARTED}]}}", TOLD)),
    ("event-loop", (EMPTY, rule("a", "{trigger: event, event: ON}", "{action: emit, event: ON}")),
     (EMPTY, rule("a", "{trigger: event, event: ON}", "{action: emit, event: ON}", ", cooldown_s: 1"))),
    ("missing-says", (EMPTY, "  a: {triggers: [{trigger: half_started}], actions: [{action: emit, event: STARTED}]}\n"),
     (EMPTY, "  a: {triggers: [{trigger: half_started}], actions: [{action: emit, event: STARTED}], sheet: false}\n")),
    ("scores-once", (EMPTY, rule("a", "{trigger: enters, entity: robots, zone: pitch}", "{action: score, entrant: yellow}")),
     (EMPTY, rule("a", "{trigger: enters, entity: each, zone: pitch}", "{action: score, entrant: yellow}", ", for_each: robots"))),
    ("each-of-none", (EMPTY, rule("a", "{trigger: touches, entity: each, other: robots}", more=", for_each: obstacles")),
     (EMPTY, rule("a", "{trigger: touches, entity: each, other: robots}", more=", for_each: balls"))),
    ("each-never-named", (EMPTY, rule("a", "{trigger: half_started}", more=", for_each: robots")),
     (EMPTY, rule("a", "{trigger: enters, entity: each, zone: pitch}", more=", for_each: robots"))),
    ("each-not-in-trigger", (EMPTY, rule("a", "{trigger: enters, entity: robots, zone: pitch}", "{action: place, entity: each, at: start}", ", for_each: robots")),
     (EMPTY, rule("a", "{trigger: enters, entity: each, zone: pitch}", "{action: place, entity: each, at: start}", ", for_each: robots"))),
    ("no-way-to-score", ("result: {rank: [{score: each, better: more}]}", "NO GOAL"),
     ("result: {rank: [{word: time_s, plus: {sum: {counter: n, entity: each}}, better: less, says: T}]}\ncounters: {n: {per: robots}}", "NO GOAL")),
    ("never-read", ("counters: {n: {}}", rule("a", "{trigger: half_started}", "{action: count, counter: n}")),
     ("counters: {n: {}}\nbroadcast: {fields: {n: {counter: n}}}", rule("a", "{trigger: half_started}", "{action: count, counter: n}"))),
    ("never-read", (EMPTY, rule("a", "{trigger: half_started}", "{action: set_spot, spot: mine, to: ball}") + "SPOT"),
     (EMPTY, rule("a", "{trigger: half_started}", "{action: set_spot, spot: mine, to: ball}, {action: place, entity: ball, at: {spot: mine}}") + "SPOT")),
    ("never-written", ("flags: {f: {}}", rule("a", "{trigger: half_started}", more=", conditions: [{flag: f}]")),
     ("flags: {f: {}}", rule("a", "{trigger: half_started}", "{action: set_flag, flag: f}", ", conditions: [{flag: f}]"))),
    ("never-written", ("timers: {t: {lasts_s: 5}}", rule("a", "{trigger: timer_expired, timer: t}")),
     ("timers: {t: {lasts_s: 5, starts: true}}", rule("a", "{trigger: timer_expired, timer: t}"))),
    ("never-used", ("zones: {here: {shape: circle, centre_m: [0, 0], radius_m: 0.1}}", EMPTY),
     ("zones: {here: {shape: circle, centre_m: [0, 0], radius_m: 0.1}}", rule("a", "{trigger: enters, entity: ball, zone: here}"))),
    ("never-used", ("tables: {posts: {left: {}}}", EMPTY),
     ("tables: {posts: {left: {}}}", rule("a", "{trigger: half_started}", more=", repeat_for: posts"))),
    ("never-used", ("tables: {posts: {left: {}}}", EMPTY),
     ("tables: {posts: {left: {}}, teams: {blue: {}}}\nplacements: {l: [{repeat_for: [posts, teams], entity: ball, at: start}]}",
      rule("a", "{trigger: half_started}", "{action: place, layout: l}"))),
    ("never-used", ("params: {far_m: 2}", EMPTY),
     ("params: {at_s: 2}", rule("a", "{trigger: time_reached, at_s: {param: at_s}}"))),
    ("held-forever", (EMPTY, rule("a", "{trigger: half_started}", "{action: hold, entity: Y1}")),
     (EMPTY, rule("a", "{trigger: half_started}", "{action: hold, entity: Y1, for_s: 3}"))),
    ("held-forever", ("expect: {t: {keyframes: [{at_s: 1}], lasts_s: 1, held: {Y1: false}}}", rule("a", "{trigger: half_started}", "{action: hold, entity: yellow}")),
     ("expect: {t: {keyframes: [{at_s: 1}], lasts_s: 1, held: {Y1: true}}}", rule("a", "{trigger: half_started}", "{action: hold, entity: yellow}"))),
    ("limit-too-long", (EMPTY, rule("a", "{trigger: stays_in, entity: ball, zone: pitch, limit_s: 60}")),
     (EMPTY, rule("a", "{trigger: stays_in, entity: ball, zone: pitch, limit_s: 59}"))),
    ("limit-too-long", ("phases: {one: {lasts_s: 1}}", ENTER + rule("a", "{trigger: stays_in, entity: ball, zone: pitch, limit_s: 2}", more=", phases: [one]")),
     ("phases: {one: {lasts_s: 3}}", ENTER + rule("a", "{trigger: stays_in, entity: ball, zone: pitch, limit_s: 2}", more=", phases: [one]"))),
    ("angle-in-degrees", ("robots: {Y1: {start: {x_m: -0.4, y_m: -0.3, yaw_rad: 90}}}", EMPTY),
     ("robots: {Y1: {start: {x_m: -0.4, y_m: -0.3, yaw_rad: 1.57}}}", EMPTY)),
    ("never-reached", (EMPTY, rule("a", "{trigger: displaced, entity: ball, distance_m: 30}")),
     (EMPTY, rule("a", "{trigger: displaced, entity: ball, distance_m: 0.3}"))),
    ("never-reached", (EMPTY, rule("a", "{trigger: holds, conditions: [{speed: Y1, at_least: 20}]}")),
     (EMPTY, rule("a", "{trigger: holds, conditions: [{speed: Y1, at_least: 0.2}]}"))),
    ("never-reached", (EMPTY, rule("a", "{trigger: no_progress, entity: Y1, distance_m: 5, within_s: 10}")),
     (EMPTY, rule("a", "{trigger: no_progress, entity: Y1, distance_m: 0.5, within_s: 10}"))),
    ("exact-measurement", (EMPTY, rule("a", "{trigger: half_started}", more=", conditions: [{speed: ball, equals: 0}]")),
     (EMPTY, rule("a", "{trigger: half_started}", more=", conditions: [{speed: ball, at_most: 0.01}]" ))),
    ("unknown-placeholder", (EMPTY, TOLD.replace("It is so.", "'{entitty} is so.'")),
     ("params: {at_s: 2}", rule("a", "{trigger: time_reached, at_s: {param: at_s}}").replace("It is so.", "'{at_s} s.'"))),
    ("unknown-placeholder", (EMPTY, TOLD.replace("It is so.", "So., sheet: '{entitty} is so.'")),
     ("counters: {n: {}}", TOLD.replace("It is so.", "'{n} so.', sheet: 'After {n}.'"))),
    ("unknown-placeholder", ("description: 'After {at_s} s'", EMPTY),
     ("description: 'Told as {\"light\": 1}'", EMPTY)),
    ("placeholder-of-two", ("params: {n: 3}\ncounters: {n: {}}", TOLD.replace("It is so.", "'{n} so.'") + rule("a", "{trigger: half_started}", "{action: count, counter: n}")),
     ("params: {n: 3}\ncounters: {m: {}}", TOLD.replace("It is so.", "'{n} of {m}.'") + rule("a", "{trigger: half_started}", "{action: count, counter: m}"))),
    ("placeholder-never-filled", (EMPTY, TOLD.replace("It is so.", "'{each} is so.'")),
     (EMPTY, TOLD.replace("It is so.", "'{team} is so.'"))),
    ("placeholder-never-filled", (EMPTY, rule("a", "{trigger: displaced, entity: ball, angle_rad: 1}").replace("It is so.", "'{limit}.'")),
     (EMPTY, rule("a", "{trigger: displaced, entity: ball, distance_m: 1}").replace("It is so.", "'{limit}.'"))),
    ("off-the-field", ("zones: {here: {shape: circle, centre_m: [3, 0], radius_m: 0.1}}", rule("a", "{trigger: enters, entity: ball, zone: here}")),
     ("zones: {here: {shape: circle, centre_m: [0.3, 0], radius_m: 0.1}}", rule("a", "{trigger: enters, entity: ball, zone: here}"))),
    ("robot-without-program", ("entrants: {yellow: {robots: {Y1: null}}}", EMPTY),
     ("entrants: {yellow: {robots: {Y1: null}}}\nrobots: {Y1: {idle: true}}", EMPTY)),
    ("never-on-the-field", (EMPTY, rule("a", "{trigger: half_started}", "{action: remove, entity: Y1}")),
     (EMPTY, rule("a", "{trigger: half_started}", "{action: remove, entity: Y1, for_s: 3}"))),
    ("two-rules-move-one-thing", (EMPTY, 2 * "A"),
     (EMPTY, "AC")),
    ("no-room", ("placements: {l: [{entity: ball, at: {point: [0, 0]}}, {entity: Y1, at: {point: [0, 0]}}]}", "LAYOUT"),
     ("placements: {l: [{entity: ball, at: {point: [0, 0]}}, {entity: Y1, at: {point: [0, 0.3]}}]}", "LAYOUT")),
    ("no-room", (EMPTY, rule("a", "{trigger: half_started}", "{action: place, entity: ball, at: {point: [0.7, 0]}}")),
     (EMPTY, rule("a", "{trigger: half_started}", "{action: place, entity: ball, at: {point: [0.5, 0]}}"))),
    ("inherited-test-left-out", ("extends: match\nmatch: {half_s: 30}", "BASE"),
     ("extends: match", "BASE")),
]  # fmt: skip
BALL_BACK = ("{trigger: enters, entity: ball, zone: blue_goal}", "{action: place, entity: ball, at: {spot: centre}}")
RULES = {
    "AA": rule("a", *BALL_BACK) + rule("b", *BALL_BACK),
    "AC": rule("a", *BALL_BACK, ", exclusive: x") + rule("b", *BALL_BACK, ", exclusive: x"),
    "LAYOUT": rule("a", "{trigger: half_started}", "{action: place, layout: l}"),
}


def codes_of(sections, rules):
    """Return the codes of the sound scenario with more in it; a few marks stand for what the table cannot spell."""
    if rules == "NO GOAL":
        text = SOUND + sections + "\nrules: {a: {triggers: [{trigger: half_ended}], actions: [{action: end}]}}\n"
        return {one.code for one in lint(load_text(text))}
    if rules == "BASE":
        text = SOUND.replace("extends: soccersim_v2\n", "").replace("match: {half_s: 60}\n", "") + sections + "\n"
        return {one.code for one in lint(load_text(text))}
    if rules.endswith("SPOT"):
        return codes("spots: {mine: {x_m: 0, y_m: 0}}", rules=rules.removesuffix("SPOT"))
    return codes(sections, rules=RULES.get(rules, rules))


@pytest.mark.parametrize(("code", "mistake", "sound"), CASES, ids=[f"{code}-{i}" for i, (code, *_) in enumerate(CASES)])
def test_check_reports_the_mistake_and_only_that(code, mistake, sound):
    assert code in codes_of(*mistake)
    assert code not in codes_of(*sound)


def test_misspelt_event_names_the_nearest_one():
    (found,) = lint_of(rules=TOLD + rule("b", "{trigger: event, event: STARTET}"))
    assert "did you mean 'STARTED'?" in found.help


def test_a_placeholder_of_a_scenario_without_params_has_a_help_too():
    (found,) = [one for one in lint_of("description: 'After {at_s} s'", EMPTY) if one.code == "unknown-placeholder"]
    assert "params" in found.help


def test_rules_of_one_repeated_rule_are_reported_once():
    repeated = rule("goal_{param: this}", "{trigger: half_started}").replace("goal_{param: this}", "r")
    repeated = repeated.replace("It is so.", "'{oops}'").replace("}\n", ", repeat_for: teams}\n")
    teams = "tables: {teams: {yellow: {}, blue: {}}}\n"
    assert [one.code for one in lint_of(teams, rules=repeated)].count("unknown-placeholder") == 1
