"""What is well formed and cannot be meant."""

import pytest

from tests.scenario.writing import complaints, loaded, rule


def condition(text):
    return rule(rest=f"    conditions: [{{condition: {text}}}]\n")


def expectation(text):
    return f"expect:\n  t: {{lasts_s: 3, {text}}}\n"


GOOD = [
    rule(action="{action: place, entity: ball, at: start}"),
    condition("speed, entity: ball, at_least: 0"),
    condition("speed, entity: ball, at_least: 0.1, at_most: 0.1"),
    condition("counter, counter: blue, equals: 3"),
    "timers: {t: {lasts_s: 1}}\n" + condition("timer, timer: t"),
    rule("{trigger: time_reached, at_s: 600}"),
    rule("{trigger: holds, condition: {condition: speed, entity: ball, at_most: 1}, for_s: 0, grace_s: 0.032}"),
    "draws: {d: {values: [1, 2], not_last: true}}\n",
    "draws: {d: {values: [1, true], not_last: true}}\n",
    "draws: {d: {values: [1, 1, 2], not_last: true, not_again: half}}\n",
    "draws: {d: {values: [a, b], not_last: true}}\n" + expectation("keyframes: [{at_s: 0}], draws: {d: [a, b, a]}"),
    "draws: {d: {values: [a, b, c], not_again: half}}\n"
    + expectation("keyframes: [{at_s: 0}], draws: {d: [a, c, b, b, a]}"),
    # What a rule sets in between makes it possible.
    "draws: {d: {values: [a, b], not_last: true}}\n"
    + rule(action="{action: draw, draw: d, as: b}", rest=expectation("keyframes: [{at_s: 0}], draws: {d: [a, a]}")),
    condition("half, at_least: 1, at_most: 1"),
    expectation("keyframes: [{at_s: 0}, {at_s: 3}], events: [{event: E, at_s: 3}]"),
    "sequences: {s: {per: robots, steps: [pitch, blue_goal]}}\n",
    "robots: {B1: {without: [gps], devices: {lidar: {device: lidar}}}}\n",
    "match: {halves: 2, swap_sides: true}\n",
    "match: {halves: 2, swap_sides: true}\nentrants: {blue: {robots: {B1: null}}}\n",
    "entrants: {blue: {robots: {B1: a/b.py, B2: [a.py, b/c-d.py]}}}\n",
]


@pytest.mark.parametrize("body", GOOD)
def test_what_makes_sense_is_taken(body):
    assert loaded(body)


BAD = [
    ("draws: {d: {values: [a, b], not_last: true}}\n" + expectation("keyframes: [{at_s: 0}], draws: {d: [a, b, b]}"),
     "expect.t.draws.d[2]: 'b' is not drawn twice running (not_last)"),
    ("draws: {d: {values: [1, 2, 3], not_again: half}}\n" + expectation("keyframes: [{at_s: 0}], draws: {d: [1, 2, 1]}"),
     "expect.t.draws.d[2]: 1 is not drawn again before all have been drawn (not_again)"),
    (rule(action="{action: place}"), "rules.r.actions[0] (place): 'entity and at' missing"),
    (rule(action="{action: place, entity: ball}"), "rules.r.actions[0] (place): 'at' missing"),
    (rule(action="{action: place, at: start}"), "rules.r.actions[0] (place): 'entity' missing"),
    ("placements: {l: [{entity: ball, at: start}]}\n" + rule(action="{action: place, layout: l, at: start}"),
     "rules.r.actions[0] (place): place needs either a layout, or entity and at, not both"),
    ("counters: {c: {}}\n" + rule(action="{action: count, counter: c, by: 1, to: 1}"),
     "rules.r.actions[0] (count): count needs either 'by' or 'to'"),
    (rule(action="{action: score, entrant: yellow, points: {word: score, fraction: true}}"),
     "rules.r.actions[0] (score): 'score' is never rounded; leave fraction out, it is for times"),
    (condition("distance, entity: ball, to: B1"), "rules.r.conditions[0] (distance): nothing to compare with"),
    (condition("counter, counter: blue"), "rules.r.conditions[0] (counter): nothing to compare with"),
    (rule("{trigger: holds, condition: {condition: speed, entity: ball}}"), "rules.r.triggers[0] (holds): nothing to compare"),
    (condition("half"), "rules.r.conditions[0] (half): nothing to compare with"),
    (condition("half, at_least: 2, at_most: 1"), "rules.r.conditions[0] (half): nothing is at least 2 and at most 1"),
    (condition("half, equals: 0"), "rules.r.conditions[0] (half).equals: must be at least 1, found 0"),
    ("draws: {d: {values: [1, 1], not_again: half}}\n", "draws.d.not_again: one value alone comes again every time"),
    (condition("speed, entity: ball, equals: 1, at_least: 1"), "rules.r.conditions[0] (speed): equals says all"),
    (condition("speed, entity: ball, at_least: 2, at_most: 1"), "rules.r.conditions[0] (speed): nothing is at least 2"),
    (condition("spot_free, spot: neutral_spots, of: {at_least: 8}"), "rules.r.conditions[0] (spot_free): at least 8 of 7"),
    (condition("in_zone, entity: [blue, B1], zone: pitch, of: {at_least: 4}"), "rules.r.conditions[0] (in_zone): at least 4 of 3"),
    ("flags: {f: {per: robots}}\n" + condition("flag, flag: f, entity: yellow, of: {at_least: 4}"),
     "rules.r.conditions[0] (flag): at least 4 of 3"),
    ("sequences: {s: {steps: [pitch, blue_goal]}}\n",
     "sequences.s: whose way? give 'entity', or 'per': a group, with a sequence for each of its members"),
    ("sequences: {s: {entity: ball, per: robots, steps: [pitch, blue_goal]}}\n",
     "sequences.s.per: a sequence has either 'entity' or 'per', not both; leave one of them out"),
    (rule("{trigger: time_reached, at_s: 600.1}"), "rules.r.triggers[0] (time_reached): 600.1 s is never reached"),
    (rule("{trigger: stays_in, entity: ball, zone: pitch, limit_s: 3, grace_s: 0.03}"),
     "rules.r.triggers[0] (stays_in): a duration must be 0 or at least one tick (0.032 s), found 0.03"),
    (rule("{trigger: no_progress, entity: ball, distance_m: 1, within_s: 0.031}"),
     "rules.r.triggers[0] (no_progress).within_s: a duration must be at least one tick (0.032 s), found 0.031"),
    (rule(rest="    cooldown_s: 0\n"), "rules.r.cooldown_s: a duration must be at least one tick (0.032 s), found 0"),
    ("draws: {d: {values: [x, x], not_last: true}}\n", "draws.d.not_last: one value alone"),
    ("counters: {laps: {}}\n" + expectation("keyframes: [{at_s: 1}], counters: {laps: {Y1: 2}}"),
     "expect.t.counters.laps: counter 'laps' is one for all; write its value alone"),
    ("counters: {laps: {per: robots}}\n" + expectation("keyframes: [{at_s: 1}], counters: {laps: {}}"),
     "expect.t.counters.laps: names nobody; write {entity: value, …}, or leave it out"),
    ("flags: {out: {per: yellow}}\n" + expectation("keyframes: [{at_s: 1}], given: {flags: {out: {B1: true}}}"),
     "expect.t.given.flags.out.B1: there is no flag 'out' of 'B1'; it is kept for Y1, Y2, Y3"),
    (expectation("keyframes: [{at_s: 1}, {at_s: 1}]"), "expect.t.keyframes[1].at_s: 1 s does not come after 1 s"),
    (expectation("keyframes: [{at_s: 3.5}]"), "expect.t.keyframes[0].at_s: 3.5 s comes after the end, 3 s"),
    (expectation("keyframes: [{at_s: 1}], events: [{event: E, at_s: 4}]"), "expect.t.events[0].at_s: 4 s comes after the end"),
    (expectation("keyframes: [{at_s: 1}], half: 2"), "expect.t.half: there is no half 2; 1 are played"),
    ("match: {half_s: 2}\n" + expectation("keyframes: [{at_s: 1}]"), "expect.t.lasts_s: 3 s is longer than a half, 2 s"),
    ("robots: {B1: {without: [lidar]}}\n", "robots.B1.without[0]: kit 'v2' has no device 'lidar'"),
    ("robots: {B1: {devices: {l: {device: lidar, min_range_m: 3}}}}\n", "robots.B1.devices.l.min_range_m: must be less than"),
    ("robots: {B1: {idle: true}}\n", "robots.B1.idle: 'B1' is idle; no program drives it"),
    ("entrants: {yellow: {robots: {B1: x.py}}}\n", "entrants.yellow.robots.B1: 'B1' is driven by 'blue' already"),
    ("entrants: {blue: {robots: {B1: null, B2: null, B3: null}}}\n", "entrants.blue.robots: an entrant drives at least one robot"),
    ("entrants: {blue: {radio_channel: 3}}\n", "entrants."),
    ("entrants: {blue: {robots: {B1: a/../b.py}}}\n", "entrants.blue.robots.B1: 'a/../b.py' is no plain path"),
    ("entrants: {blue: {robots: {B1: [a.py, b//c.py]}}}\n", "entrants.blue.robots.B1[1]: 'b//c.py' is no plain path"),
    ("match: {swap_sides: true}\nentrants: {blue: null}\n", "match.swap_sides: only two entrants can change sides; there is 1"),
]  # fmt: skip


@pytest.mark.parametrize(("body", "says"), BAD, ids=[case[1][:70] for case in BAD])
def test_what_cannot_be_meant_is_refused(body, says):
    (line,) = complaints(body)
    assert line.startswith(says)


def test_a_contradiction_through_a_param_names_the_param():
    (line,) = complaints("params: {late_s: 700}\n" + rule("{trigger: time_reached, at_s: {param: late_s}}"))
    assert line.endswith("700 s is never reached; a half lasts 600 s (param 'late_s')")


def test_what_a_preset_and_a_scenario_do_wrong_together_is_reported_in_the_scenario():
    from rcj_challenges.scenario.errors import ScenarioError

    with pytest.raises(ScenarioError) as caught:
        loaded("robots: {B3: {idle: true}}\n")
    assert str(caught.value) == "a.yaml:5:21: robots.B3.idle: 'B3' is idle; no program drives it"
