"""What is well formed and contradicts itself."""

import pytest

from rcj_challenges.core.diagnostics import InFile
from tests.scenario.writing import complaints, errors, loaded, rule


def condition(text):
    return rule(rest=f"    conditions: [{{{text}}}]\n")


def expectation(text):
    return f"expect:\n  t: {{lasts_s: 3, {text}}}\n"


GOOD = [
    rule(action="{action: place, entity: ball, at: start}"),
    condition("speed: ball, at_least: 0"),
    condition("speed: ball, at_least: 0.1, at_most: 0.1"),
    condition("score: blue, equals: 3"),
    "timers: {t: {lasts_s: 1}}\n" + condition("timer: t"),
    rule("{trigger: time_reached, at_s: 600}"),
    rule("{trigger: holds, conditions: [{speed: ball, at_most: 1}], for_s: 0, grace_s: 0.032}"),
    "draws: {d: {values: [1, 2], not_last: true}}\n",
    "draws: {d: {values: [1, true], not_last: true}}\n",
    "draws: {d: {values: [1, 1, 2], not_last: true, not_again: half}}\n",
    condition("word: halftime, at_least: 1, at_most: 1"),
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
    (rule(action="{action: place}"), "missing-key rules.r.actions[0] (place)"),
    (rule(action="{action: place, entity: ball}"), "missing-key rules.r.actions[0] (place)"),
    (rule(action="{action: place, at: start}"), "missing-key rules.r.actions[0] (place)"),
    ("placements: {l: [{entity: ball, at: start}]}\n" + rule(action="{action: place, layout: l, at: start}"),
     "conflicting-keys rules.r.actions[0] (place)"),
    ("counters: {c: {}}\n" + rule(action="{action: count, counter: c, by: 1, to: 1}"),
     "conflicting-keys rules.r.actions[0] (count)"),
    (condition("distance: [ball, B1]"), "missing-key rules.r.conditions[0] (distance)"),
    (condition("score: blue"), "missing-key rules.r.conditions[0] (score)"),
    (rule("{trigger: displaced, entity: ball, axis: either}"), "missing-key rules.r.triggers[0] (displaced)"),
    (rule("{trigger: holds, conditions: [{speed: ball}]}"),
     "missing-key rules.r.triggers[0] (holds).conditions[0] (speed)"),
    (condition("word: halftime"), "missing-key rules.r.conditions[0] (word)"),
    (condition("word: halftime, at_least: 2, at_most: 1"), "empty-range rules.r.conditions[0] (word)"),
    ("draws: {d: {values: [1, 1], not_again: half}}\n", "conflicting-keys draws.d.not_again"),
    (condition("speed: ball, equals: 1, at_least: 1"), "conflicting-keys rules.r.conditions[0] (speed)"),
    (condition("speed: ball, at_least: 2, at_most: 1"), "empty-range rules.r.conditions[0] (speed)"),
    (condition("spot_free: neutral_spots, of: {at_least: 8}"), "never-holds rules.r.conditions[0] (spot_free)"),
    (condition("entity: [blue, B1], in: pitch, of: {at_least: 4}"), "never-holds rules.r.conditions[0] (entity)"),
    ("flags: {f: {per: robots}}\n" + condition("flag: f, entity: yellow, of: {at_least: 4}"),
     "never-holds rules.r.conditions[0] (flag)"),
    ("sequences: {s: {steps: [pitch, blue_goal]}}\n",
     "missing-key sequences.s"),
    ("sequences: {s: {entity: ball, per: robots, steps: [pitch, blue_goal]}}\n",
     "conflicting-keys sequences.s.per"),
    (rule("{trigger: time_reached, at_s: 600.1}"), "too-late rules.r.triggers[0] (time_reached)"),
    (rule("{trigger: stays_in, entity: ball, zone: pitch, limit_s: 3, grace_s: 0.03}"),
     "wrong-value rules.r.triggers[0] (stays_in)"),
    (rule("{trigger: no_progress, entity: ball, distance_m: 1, within_s: 0.031}"),
     "wrong-value rules.r.triggers[0] (no_progress).within_s"),
    (rule(rest="    cooldown_s: 0\n"), "wrong-value rules.r.cooldown_s"),
    ("draws: {d: {values: [x, x], not_last: true}}\n", "conflicting-keys draws.d.not_last"),
    ("counters: {laps: {}}\n" + expectation("keyframes: [{at_s: 1}], counters: {laps: {Y1: 2}}"),
     "not-per-entity expect.t.counters.laps"),
    ("counters: {laps: {per: robots}}\n" + expectation("keyframes: [{at_s: 1}], counters: {laps: {}}"),
     "wrong-value expect.t.counters.laps"),
    ("draws: {d: {values: [1, 2], not_last: true}}\n" + expectation("keyframes: [{at_s: 1}], draws: {d: [1, 1]}"),
     "never-drawn expect.t.draws.d[1]"),
    ("spots: {s: {x_m: 0, y_m: 0}}\n" + expectation("keyframes: [{at_s: 1}], spots: {s: [0.1, 0.1]}"),
     "never-drawn expect.t.spots.s"),
    ("robots: {B1: null, B2: null, B3: null}\nentrants: {blue: {title: B}}\n", "entrant-without-robots entrants.blue.robots"),
    ("flags: {out: {per: yellow}}\n" + expectation("keyframes: [{at_s: 1}], given: {flags: {out: {B1: true}}}"),
     "unknown-name expect.t.given.flags.out.B1"),
    (expectation("keyframes: [{at_s: 1}, {at_s: 1}]"), "too-early expect.t.keyframes[1].at_s"),
    (expectation("keyframes: [{at_s: 3.5}]"), "too-late expect.t.keyframes[0].at_s"),
    (expectation("keyframes: [{at_s: 1}], events: [{event: E, at_s: 4}]"), "too-late expect.t.events[0].at_s"),
    (expectation("keyframes: [{at_s: 1}], half: 2"), "too-late expect.t.half"),
    ("match: {half_s: 2}\n" + expectation("keyframes: [{at_s: 1}]"), "too-late expect.t.lasts_s"),
    ("robots: {B1: {without: [lidar]}}\n", "unknown-name robots.B1.without[0]"),
    ("robots: {B1: {devices: {l: {device: lidar, min_range_m: 3}}}}\n", "wrong-value robots.B1.devices.l.min_range_m"),
    ("robots: {B1: {idle: true}}\n", "driven-twice robots.B1.idle"),
    ("entrants: {yellow: {robots: {B1: x.py}}}\n", "driven-twice entrants.yellow.robots.B1"),
    ("entrants: {blue: {robots: {B1: null, B2: null, B3: null}}}\n", "entrant-without-robots entrants.blue.robots"),
    ("entrants: {blue: {radio_channel: 3}}\n", "same-channel entrants.blue.radio_channel"),
    ("entrants: {blue: {robots: {B1: a/../b.py}}}\n", "wrong-value entrants.blue.robots.B1"),
    ("entrants: {blue: {robots: {B1: [a.py, b//c.py]}}}\n", "wrong-value entrants.blue.robots.B1[1]"),
    ("match: {swap_sides: true}\nentrants: {blue: null}\n", "cannot-swap match.swap_sides"),
    ("counters: {c: {per: entrants, keeps: lowest, keep: match, initial: 9}}\nresult: {rank: [{counter: c, over: best, better: less, says: C}]}\n",
     "wrong-value result.rank[0]"),
    ("counters: {c: {per: entrants, initial: none, keep: match}}\nresult: {rank: [{counter: c, otherwise: 60, better: less, says: C}]}\n",
     "wrong-value result.rank[0]"),
]  # fmt: skip


@pytest.mark.parametrize(("body", "expected"), BAD)
def test_contradiction_is_refused_where_it_stands(body, expected):
    assert complaints(body) == [expected]


def test_what_a_preset_and_a_scenario_do_wrong_together_is_reported_in_the_scenario():
    (problem,) = errors("robots: {B3: {idle: true}}\n")
    assert (problem.code, problem.where) == ("driven-twice", InFile("a.yaml", 5, 21, "robots.B3.idle"))
