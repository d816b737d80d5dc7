"""Every name that a scenario uses must exist, and be of the kind that is needed."""

import pytest

from rcj_challenges.scenario.errors import place_of
from rcj_challenges.scenario.load import load
from tests.scenario.writing import complaints, errors, in_short, loaded, problems_of, rule

WORLD = """\
balls: {second: {start_m: [0, -0.1]}}
obstacles:
  crate: {shape: box, centre_m: [0.5, 0], size_m: [0.05, 0.05], movable: true}
  post: {shape: cylinder, centre_m: [-0.5, 0], radius_m: 0.02}
zones:
  house: {shape: circle, centre_m: [0.2, 0.2], radius_m: 0.1}
  barn: {shape: rect, x_min_m: 0, x_max_m: 0.1, y_min_m: 0, y_max_m: 0.1}
  yard: {shape: polygon, points_m: [[0, 0], [0.1, 0], [0, 0.1]]}
  outside: {shape: circle, centre_m: [0.2, 0.2], radius_m: 0.1, inverted: true}
gates: {door: {from_m: [0, 0], to_m: [0, 0.1]}, hatch: {from_m: [0, 0], to_m: [0.1, 0], anchor: B1}}
groups:
  doors: [door, hatch]
  houses: [house, barn]
  places: [house, yard]
  stones: [crate, post]
  movers: [blue, ball, crate]
  all_spots: [neutral_spots, centre]
draws:
  corner: {values: [centre, corner_blue_left]}
  formation: {values: [wide, narrow]}
  number: {values: [1, 2]}
  text: {values: ['1', '2', 'true']}
  truth: {values: [true, false]}
placements:
  wide: [{entity: ball, at: start}]
  narrow: [{entity: movers, at: {spot: corner}}]
counters: {goals: {}, pushes: {per: robots}, blue_pushes: {per: blue}}
flags: {armed: {}, seen: {per: movers}}
timers: {clock: {lasts_s: 5}, own: {lasts_s: 5, per: robots}}
sequences:
  round: {entity: ball, steps: [pitch, {any_of: [door, blue_goal]}]}
  race: {per: movers, steps: [pitch, door]}
phases: {pause: {lasts_s: 3, next: play}}
"""


def refers(body):
    """Whether a scenario over the world above is in order; else what is said."""
    world = WORLD.replace("draws:\n", "draws:\n  mixed: {values: [1, 2.5, three, true]}\n")
    return [in_short(problem) for problem in problems_of(loaded, world + body)]


def trigger(text, for_each=""):
    rest = f"    for_each: {for_each}\n" if for_each else ""
    return refers(rule(f"{{trigger: {text}}}", rest=rest))


def condition(text, for_each=""):
    rest = f"    for_each: {for_each}\n" if for_each else ""
    return refers(rule(rest=f"    conditions: [{{{text}}}]\n{rest}"))


def action(text, for_each=""):
    rest = f"    for_each: {for_each}\n" if for_each else ""
    return refers(rule(action=f"{{action: {text}}}", rest=rest))


GOOD = [
    (trigger, "enters, entity: ball, zone: [pitch, penalty_areas]", ""),
    (trigger, "leaves, entity: movers, zone: in_play", ""),
    (trigger, "leaves, entity: each, zone: in_play", "balls"),
    (trigger, "crosses, entity: ball, gate: doors", ""),
    (trigger, "touches, entity: robots, other: [walls, stones, ball, yellow]", ""),
    (trigger, "no_progress, entity: each, distance_m: 1, within_s: 3", "movers"),
    (trigger, "tips_over, entity: each", "robots"),
    (trigger, "sequence_broken, sequence: race", ""),
    (trigger, "sequence_broken, sequence: race", "doors"),
    (trigger, "sequence_completed, sequence: race, entity: [blue, crate]", ""),
    (trigger, "sequence_completed, sequence: race, entity: each", "blue"),
    (condition, "sequence: race, equals: door", ""),
    (condition, "sequence: race, equals: door, entity: each", "movers"),
    (condition, "sequence: race, equals: door, entity: ball", "robots"),
    (condition, "sequence: race, equals: door, entity: [blue, ball], of: all", ""),
    (condition, "counter: pushes, entity: blue, at_least: 1", ""),
    (condition, "flag: seen, entity: blue", ""),
    (condition, "timer: own, entity: [B1, B2]", ""),
    (condition, "sequence: race, equals: door, of: none", "robots"),
    (action, "reset, sequence: race", "movers"),
    (action, "reset, sequence: race, entity: blue", ""),
    (action, "reset, sequence: race, entity: each", "movers"),
    (trigger, "program_fault, robot: [blue, Y1]", ""),
    (trigger, "holds, conditions: [{entity: each, in: pitch}]", "robots"),
    (condition, "entity: robots, in: pitch, of: {at_least: 6}", ""),
    (condition, "distance: [each, [0, 1]], at_most: 1", "robots"),
    (condition, "score: yellow, at_least: {counter: goals}", ""),
    (condition, "counter: pushes, entity: each, at_least: 1", "blue"),
    (condition, "flag: seen, entity: crate", ""),
    (trigger, "crosses, entity: ball, gate: each", "doors"),
    (trigger, "enters, entity: ball, zone: each", "penalty_areas"),
    (trigger, "stays_in, entity: blue, zone: [each, pitch], limit_s: 3", "penalty_areas"),
    (condition, "entity: ball, in: each", "penalty_areas"),
    (condition, "sequence: round, equals: each", "doors"),
    (condition, "timer: own, entity: B1, at_least: 1", ""),
    (condition, "last_touch: ball, equals: each", "robots"),
    (condition, "spot_free: all_spots, of: all", ""),
    (action, "score, entrant: yellow, points: {sum: [{counter: goals, times: 2}, {flag: armed}]}", ""),
    (action, "count, counter: pushes", ""),
    (action, "count, counter: goals, by: {flag: seen, entity: crate}", ""),
    (action, "score, entrant: yellow, points: {flag: seen, entity: each}", "movers"),
    (action, "score, entrant: yellow, points: {sum: [5, {distance: [each, [0, 0]], times: -1}, {distance: [robots, second]}]}", "movers"),
    (action, "score, entrant: yellow, points: {sum: [{timer: clock, times: -1}, {timer: own, entity: each}]}", "robots"),
    (action, "count, counter: goals, to: {timer: own}", ""),
    (action, "emit, event: E, payload: {a: {last_touch: each}, b: {timer: own, entity: B1}, c: {distance: [each, blue]}}", "movers"),
    (action, "score, entrant: yellow, points: {sum: [{draw: number, times: 2}, {score: blue}]}", ""),
    (action, "score, entrant: yellow, points: {sum: [{counter: pushes, entity: each}, {flag: seen, entity: crate}]}", "robots"),
    (action, "score, entrant: yellow, points: {sum: {counter: pushes}}", "robots"),
    (condition, "flag: seen, entity: [blue, crate], of: none", ""),
    (condition, "counter: pushes, entity: yellow, of: {at_least: 2}, at_least: 1", ""),
    (condition, "counter: pushes, of: all, at_least: 1", "robots"),
    (condition, "timer: own, entity: [each, B1], of: all", "robots"),
    (action, "set_flag, flag: seen, entity: each", "movers"),
    (condition, "distance: [[ball, B1], doors], at_most: 1, of: all", ""),
    (condition, "distance: [ball, each], at_most: 1", "in_play"),
    (action, "emit, event: E, payload: {a: {distance: [in_play, ball]}, b: {distance: [centre, door]}}", ""),
    (action, "place, layout: {draw: formation}, mirror: {axis: y, when: armed}", ""),
    (action, "place, entity: each, at: {nearest_free: all_spots, to: ball}, facing: {towards: centre}", "robots"),
    (action, "place, entity: ball, at: {spot: corner}", ""),
    (action, "place, entity: ball, at: {choice: [centre, corner, neutral_spots, [0, 1]]}", ""),
    (action, "place, entity: ball, at: {furthest_free: centre, from: corner}", ""),
    (action, "remove, entity: [each, crate], back_at: {spot: centre}", "robots"),
    (action, "emit, event: E, payload: {a: {entity: each, held: true}, b: {entity: Y1, held: true}}", "robots"),
    (action, ("emit, event: E, payload: {a: {counter: pushes, entity: B1}, b: {score: blue}, "
             "c: {position_of: crate}, f: {position_of: centre}, d: {draw: corner}, e: {flag: armed}}"), ""),
]  # fmt: skip


@pytest.mark.parametrize(("write", "text", "for_each"), GOOD, ids=[case[1][:48] for case in GOOD])
def test_names_that_exist_are_taken(write, text, for_each):
    assert write(text, for_each) == []


BAD = [
    (trigger, "phase_entered, phase: paus", "", "unknown-name rules.r.triggers[0] (phase_entered) -> pause"),
    (trigger, "phase_entered, phase: play, from: x", "", "unknown-name rules.r.triggers[0] (phase_entered)"),
    (trigger, "timer_expired, timer: goals", "", "unknown-name rules.r.triggers[0] (timer_expired)"),
    (trigger, "enters, entity: post, zone: pitch", "", "wrong-kind rules.r.triggers[0] (enters)"),
    (trigger, "enters, entity: stones, zone: pitch", "", "wrong-kind rules.r.triggers[0] (enters)"),
    (action, "hold, entity: ball", "", "wrong-kind rules.r.actions[0] (hold)"),
    (action, "hold, entity: each", "movers", "wrong-kind rules.r.actions[0] (hold)"),
    (action, "hold, entity: other", "", "unbound-name rules.r.actions[0] (hold)"),
    (action, "emit, event: E, payload: {a: {entity: blue, held: true}}", "", "wrong-kind rules.r.actions[0] (emit)"),
    (trigger, "enters, entity: ball, zone: each", "", "unbound-name rules.r.triggers[0] (enters)"),
    (trigger, "enters, entity: ball, zone: each", "robots", "wrong-kind rules.r.triggers[0] (enters)"),
    (trigger, "crosses, entity: each, gate: door", "doors", "wrong-kind rules.r.triggers[0] (crosses)"),
    (trigger, "crosses, entity: ball, gate: each", "penalty_areas", "wrong-kind rules.r.triggers[0] (crosses)"),
    (action, "score, entrant: each", "doors", "wrong-kind rules.r.actions[0] (score)"),
    (action, "place, entity: ball, at: {uniform_in: each}", "penalty_areas", "unbound-name rules.r.actions[0] (place)"),
    (trigger, "enters, entity: each, zone: pitch", "", "unbound-name rules.r.triggers[0] (enters)"),
    (action, "place, entity: ball, at: {relative_to: each}", "houses", "wrong-kind rules.r.actions[0] (place)"),
    (trigger, "tips_over, entity: each", "movers", "wrong-kind rules.r.triggers[0] (tips_over)"),
    (trigger, "program_fault, robot: each", "balls", "wrong-kind rules.r.triggers[0] (program_fault)"),
    (condition, "distance: [ball, walls], at_most: 1", "", "wrong-kind rules.r.conditions[0] (distance)"),
    (condition, "counter: goals, at_least: {counter: x_}", "", "unknown-name rules.r.conditions[0] (counter)"),
    (condition, "counter: pushes, at_least: 1", "balls", "missing-entity rules.r.conditions[0] (counter)"),
    (condition, "counter: goals, entity: B1, at_least: 1", "", "not-per-entity rules.r.conditions[0] (counter)"),
    (condition, "counter: goals, entity: B1, at_least: 1", "", "not-per-entity rules.r.conditions[0] (counter)"),
    (condition, "counter: blue_pushes, entity: each, at_least: 1", "robots", "wrong-kind rules.r.conditions[0] (counter)"),
    (condition, "flag: seen, entity: yellow, of: all", "", "wrong-kind rules.r.conditions[0] (flag)"),
    (condition, "flag: armed, of: all", "", "not-per-entity rules.r.conditions[0] (flag)"),
    (condition, "draw: corner, equals: middle_blue", "", "never-drawn rules.r.conditions[0] (draw)"),
    (condition, "draw: text, equals: 1", "", "never-drawn rules.r.conditions[0] (draw) -> 1"),
    (condition, "draw: text, equals: true", "", "never-drawn rules.r.conditions[0] (draw) -> true"),
    (condition, "last_touch: ball, equals: ball", "", "wrong-kind rules.r.conditions[0] (last_touch)"),
    (condition, "sequence: round, equals: hatch", "", "unknown-name rules.r.conditions[0] (sequence) -> pitch"),
    (condition, "sequence: round, equals: each", "hatch", "unknown-name rules.r.conditions[0] (sequence) -> pitch"),
    (trigger, "sequence_completed, sequence: round, entity: each", "balls", "not-per-entity rules.r.triggers[0] (sequence_completed)"),
    (trigger, "sequence_completed, sequence: race", "robots", "missing-entity rules.r.triggers[0] (sequence_completed)"),
    (trigger, "sequence_broken, sequence: race, entity: each", "robots", "wrong-kind rules.r.triggers[0] (sequence_broken)"),
    (trigger, "sequence_broken, sequence: race, entity: [ball, Y2]", "", "wrong-kind rules.r.triggers[0] (sequence_broken)"),
    (trigger, "sequence_completed, sequence: race, entity: each", "", "unbound-name rules.r.triggers[0] (sequence_completed)"),
    (trigger, "sequence_completed, sequence: race, entity: bleu", "", "unknown-name rules.r.triggers[0] (sequence_completed) -> blue"),
    (condition, "sequence: race, equals: door", "robots", "missing-entity rules.r.conditions[0] (sequence)"),
    (condition, "sequence: race, equals: door, of: all, entity: robots", "", "wrong-kind rules.r.conditions[0] (sequence)"),
    (condition, "sequence: race, equals: door, of: {at_least: 6}, entity: movers", "", "never-holds rules.r.conditions[0] (sequence)"),
    (condition, "sequence: round, equals: door, of: all", "", "not-per-entity rules.r.conditions[0] (sequence)"),
    (action, "reset, sequence: race, entity: yellow", "", "wrong-kind rules.r.actions[0] (reset)"),
    (action, "reset, flag: [seen], entity: Y1", "", "wrong-kind rules.r.actions[0] (reset)"),
    (action, "reset, flag: seen, sequence: round, entity: B1", "", "not-per-entity rules.r.actions[0] (reset)"),
    (action, "score, entrant: yellow, points: {flag: armed, entity: B1}", "", "not-per-entity rules.r.actions[0] (score)"),
    (action, "score, entrant: yellow, points: {flag: seen}", "robots", "missing-entity rules.r.actions[0] (score)"),
    (action, "count, counter: goals, by: {flag: seen, entity: Y1}", "", "wrong-kind rules.r.actions[0] (count)"),
    (action, "score, entrant: yellow, points: {sum: [{counter: pushes, entity: ball}]}", "", "wrong-kind rules.r.actions[0] (score)"),
    (action, "score, entrant: yellow, points: {score: B1}", "", "unknown-name rules.r.actions[0] (score)"),
    (action, "timer, timer: clock, entity: B1", "", "not-per-entity rules.r.actions[0] (timer)"),
    (action, "set_flag, flag: seen, entity: Y1", "", "wrong-kind rules.r.actions[0] (set_flag)"),
    (action, "draw, draw: corner, as: pitch", "", "never-drawn rules.r.actions[0] (draw)"),
    (action, "place, entity: ball, at: {spot: formation}", "", "unknown-name draws.formation.values[0] + unknown-name draws.formation.values[1]"),
    (action, "place, entity: ball, at: {nearest_free: corner}", "", "unknown-name rules.r.actions[0] (place) -> corner_blue_right"),
    (action, "place, entity: ball, at: {relative_to: pitch}", "", "wrong-kind rules.r.actions[0] (place)"),
    (action, "place, entity: ball, at: start, facing: {towards: doors}", "", "wrong-kind rules.r.actions[0] (place)"),
    (action, "emit, event: E, payload: {a: {score: B1}}", "", "unknown-name rules.r.actions[0] (emit)"),
    (action, "emit, event: E, payload: {a: {position_of: pitch}}", "", "wrong-kind rules.r.actions[0] (emit)"),
    (action, "emit, event: E, payload: {a: {position_of: all_spots}}", "", "wrong-kind rules.r.actions[0] (emit)"),
]  # fmt: skip


@pytest.mark.parametrize(("write", "text", "for_each", "expected"), BAD, ids=[case[1][:48] for case in BAD])
def test_names_that_do_not_fit_are_refused_where_they_stand(write, text, for_each, expected):
    assert " + ".join(write(text, for_each)) == expected


@pytest.mark.parametrize("text", ["score, entrant: yellow, points: {draw: mixed}", "count, counter: goals, by: {draw: mixed}",
                                  "score, entrant: yellow, points: {sum: [{draw: mixed, times: 2}]}"])  # fmt: skip
def test_a_draw_that_gives_points_draws_numbers_only(text):
    found = refers(rule(action=f"{{action: {text}}}"))
    assert found == ["wrong-value draws.mixed.values[2]", "wrong-value draws.mixed.values[3]"]


@pytest.mark.parametrize(
    "section", ["timers: {wait: {lasts_s: {draw: long}}}", "phases: {wait: {lasts_s: {draw: long}}}"]
)
def test_a_draw_that_decides_how_long_something_lasts_draws_durations_only(section):
    draw = "draws: {long: {values: [5, 0.032, short, true, 0, 0.03, 86401]}}\n"
    assert complaints(f"{draw}{section}\n") == [f"wrong-value draws.long.values[{index}]" for index in range(2, 7)]
    assert "needed by" in errors(f"{draw}{section}\n")[0].message
    assert [line.partition(" ")[0] for line in complaints(f"{section}\n")] == ["unknown-name"]


SECTIONS = [
    ("gates: {door: {anchor: pitch}}\n", "wrong-kind gates.door.anchor"),
    ("counters: {goals: {per: neutral_spots}}\n", "wrong-kind counters.goals.per"),
    ("timers: {clock: {per: bleu}}\n", "unknown-name timers.clock.per -> blue"),
    ("sequences: {round: {entity: balls}}\n", "wrong-kind sequences.round.entity"),
    ("sequences: {race: {per: neutral_spots}}\n", "wrong-kind sequences.race.per"),
    ("sequences: {race: {per: stones}}\n", "wrong-kind sequences.race.per"),
    ("sequences: {race: {per: bleu}}\n", "unknown-name sequences.race.per -> blue"),
    ("sequences: {round: {steps: [pitch, centre]}}\n", "wrong-kind sequences.round.steps[1]"),
    ("sequences: {round: {steps: [pitch, {any_of: [dor]}]}}\n", "unknown-name sequences.round.steps[1].any_of[0] -> door"),
    ("phases: {pause: {next: paus}}\n", "unknown-name phases.pause.next -> pause"),
    ("first_phase: paus\n", "unknown-name first_phase -> pause"),
    ("placements: {wide: [{entity: each, at: start}]}\n", "unbound-name placements.wide[0].entity"),
    ("robots: {B1: {kit: v1}}\n", "unknown-name robots.B1.kit"),
    ("kits: {v2: {packet_lists: [B1, X9]}}\n", "unknown-name kits.v2.packet_lists[1]"),
    ("entrants: {blue: {robots: {ball: robot.py}}}\n", "wrong-kind entrants.blue.robots.ball"),
    ("result: {rank: [{counter: goal, better: more, says: G}]}\n", "unknown-name result.rank[0].counter -> goals"),
    ("result: {rank: [{word: time_s, plus: {counter: goal}, better: less, says: T}]}\n", "unknown-name result.rank[0].plus.counter -> goals"),
    ("result: {rank: [{counter: pushes, better: less, says: P}]}\n", "missing-entity result.rank[0].counter"),
    ("result: {rank: [{counter: pushes, entity: each, better: less, says: P}]}\n", "wrong-kind result.rank[0].entity"),
    ("broadcast: {fields: {a: {flag: armd}}}\n", "unknown-name broadcast.fields.a.flag -> armed"),
    ("broadcast: {fields: {a: {position_of: each}}}\n", "unbound-name broadcast.fields.a.position_of"),
    ("timers: {x: {lasts_s: {counter: m}}}\n", "unknown-name timers.x.lasts_s.counter"),
    ("phases: {x: {lasts_s: {counter: m}}}\n", "unknown-name phases.x.lasts_s.counter"),
    ("timers: {x: {per: balls, lasts_s: {counter: pushes}}}\n", "missing-entity timers.x.lasts_s.counter"),
    ("timers: {x: {lasts_s: {counter: pushes, entity: each}}}\n", "unbound-name timers.x.lasts_s.entity"),
    ("timers: {x: {per: balls, lasts_s: {counter: pushes, entity: each}}}\n", "wrong-kind timers.x.lasts_s.entity"),
    ("timers: {x: {per: robots, lasts_s: {counter: pushes, entity: each}}}\n", ""),
    ("rules: {r: {for_each: robts, triggers: [{trigger: half_started}], actions: [{action: end}]}}\n",
     "unknown-name rules.r.for_each -> robots"),
]  # fmt: skip


@pytest.mark.parametrize(("body", "expected"), SECTIONS, ids=[case[0][:40] for case in SECTIONS])
def test_sections_that_name_something_unknown(body, expected, tmp_path):
    (tmp_path / "base.yaml").write_text(
        "extends: soccersim_v2\nschema_version: 2\nid: b\ntitle: B\n" + WORLD, encoding="utf-8"
    )
    (tmp_path / "mine.yaml").write_text("extends: base.yaml\n" + body, encoding="utf-8")
    assert " + ".join(in_short(problem) for problem in problems_of(load, tmp_path / "mine.yaml")) == expected


def test_a_test_in_the_file_names_what_exists():
    body = WORLD + (
        "expect:\n  t:\n    lasts_s: 2\n    phase: paus\n    draws: {corner: pitch, x_: 1, formation: [pitch, 5]}\n    score: {yellw: 1}\n"
        "    counters: {goal: 1}\n    flags: {armd: true}\n    poses: {bal: [0, 0]}\n"
        "    keyframes: [{at_s: 1, place: {bal: [0, 0]}, touch: [[ball, wals]], tips: [ball], fault: [B9]}]\n"
    )
    paths = [place_of(problem).path for problem in errors(body)]
    assert sorted(paths) == sorted(
        [
            "expect.t.phase", "expect.t.draws.corner", "expect.t.draws.x_", "expect.t.draws.formation[0]", "expect.t.draws.formation[1]", "expect.t.score.yellw", "expect.t.counters.goal",
            "expect.t.flags.armd", "expect.t.poses.bal", "expect.t.keyframes[0].place.bal", "expect.t.keyframes[0].touch[0][1]",
            "expect.t.keyframes[0].tips[0]", "expect.t.keyframes[0].fault[0]",
        ]
    )  # fmt: skip


@pytest.mark.parametrize(
    "uses",
    [
        "{trigger: enters, entity: ball, zone: each}",
        "{trigger: crosses, entity: ball, gate: each}",
        "{trigger: enters, entity: each, zone: pitch}",
    ],
)
def test_misspelt_group_of_for_each_is_reported_only_where_it_is_written(uses):
    groups = "zones: {a: {shape: circle, centre_m: [0, 0], radius_m: 0.1}}\ngroups: {doors: [a]}\n"
    rule = f"rules:\n  r: {{for_each: dors, triggers: [{uses}], actions: [{{action: end}}]}}\n"
    assert complaints(groups + rule) == ["unknown-name rules.r.for_each -> doors"]


def test_unused_kit_may_list_unknown_robots():
    assert loaded("kits: {old: {packet_lists: [X1]}}\n")


def test_mistakes_of_form_and_unknown_names_come_together():
    found = errors("match: {halves: 0}\n" + rule("{trigger: enters, entity: bal, zone: gaol, x: 1}"))
    assert [one.code for one in found] == ["wrong-value", "unknown-name", "unknown-name", "unknown-key"]


def test_names_in_a_section_that_is_malformed_are_not_called_unknown():
    assert complaints("zones: 3\n" + rule("{trigger: enters, entity: ball, zone: pitch}")) == ["wrong-value zones"]


# --- groups and namespaces --------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("body", "paths"),
    [
        ("groups: {g: [B1, ball]}\n", []),
        ("groups: {g: [blue, balls, walls]}\n", []),
        ("groups: {g: [h], h: [k], k: [g]}\n", ["groups.g[0]", "groups.h[0]", "groups.k[0]"]),
        ("groups: {g: [g]}\n", ["groups.g[0]"]),
        ("groups: {g: [B1, pitch]}\n", ["groups.g[1]"]),
        ("groups: {g: [penalty_areas, neutral_spots]}\n", ["groups.g[1]"]),
        ("groups: {g: [each]}\n", ["groups.g[0]"]),
        ("groups: {balls: [ball]}\n", ["groups.balls"]),
        ("groups: {blue: [B1]}\n", ["robots.B1.colour", "robots.B2.colour", "robots.B3.colour"]),
        ("zones: {each: {shape: rect, x_min_m: 0}}\n", ["zones.each"]),
        ("gates: {B1: {from_m: [0, 0], to_m: [0, 1]}}\n", ["gates.B1"]),
        ("spots: {b1: {x_m: 0, y_m: 0}}\n", ["spots.b1"]),
        ("phases: {any: {}}\n", ["phases.any"]),
        ("flags: {B1: {}, pitch: {}, goals: {}}\ncounters: {B1: {}, goals: {}}\ntimers: {goals: {lasts_s: 1}}\n", []),
    ],
)
def test_what_lies_on_the_field_shares_one_namespace_and_groups_hold_one_kind(body, paths):
    if paths:
        assert [place_of(problem).path for problem in errors(body)] == paths
    else:
        assert loaded(body)
