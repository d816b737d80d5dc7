"""One mistake gives one error, with its code and its path."""

import pytest

from tests.scenario.writing import HEAD, complaints, errors, in_short, rule


def place(text):
    return rule(action=f"{{action: place, entity: ball, {text}}}")


WHEEL = "kits: {v2: {devices: {left wheel motor: {direction: %s}}}}\n"
CASES = [
    (rule("{entity: ball}"), "missing-key rules.r.triggers[0]"),
    (rule("{trigger: [enters]}"), "unknown-word rules.r.triggers[0]"),
    (
        rule("half_started"),
        "wrong-value rules.r.triggers[0]",
    ),
    (rule("{trigger: enters, entity: ball}"),
     "missing-key rules.r.triggers[0] (enters)"),
    (rule("{trigger: enters, entity: [1, ball], zone: pitch}"), "wrong-value rules.r.triggers[0] (enters).entity[0]"),
    (rule("{trigger: enters, entity: [], zone: pitch}"),
     "wrong-value rules.r.triggers[0] (enters).entity"),
    (rule("{trigger: enters, entity: {name: ball}, zone: pitch}"),
     "wrong-value rules.r.triggers[0] (enters).entity"),
    (rule("{trigger: displaced, entity: ball, distance_m: 1, from: last}"),
     "wrong-value rules.r.triggers[0] (displaced).from -> last_placement"),
    (rule("{trigger: displaced, entity: ball, distance_m: 1, from: [1]}"),
     "wrong-value rules.r.triggers[0] (displaced).from"),
    (rule("{trigger: holds, conditions: [{speed: ball, at_least: fast}]}"),
     "wrong-value rules.r.triggers[0] (holds).conditions[0] (speed).at_least"),
    (rule("{trigger: holds, conditions: [{any_of: [{any_of: []}]}]}"),
     "wrong-value rules.r.triggers[0] (holds).conditions[0] (any_of).any_of[0] (any_of).any_of"),
    (rule(rest="    phases: all\n"), "wrong-value rules.r.phases"),
    (rule(rest="    for_each: [B1]\n"), "wrong-value rules.r.for_each"),
    (rule(rest=f"    says: {'x' * 501}\n"), "wrong-value rules.r.says"),
    (place("at: centre"), "wrong-value rules.r.actions[0] (place).at"),
    (place("at: {spot: [centre]}"), "wrong-value rules.r.actions[0] (place).at.spot"),
    (place("at: {spot: [centre, x]}"), "wrong-value rules.r.actions[0] (place).at.spot"),
    ("counters: {c: {per: [robots, x]}}\n", "wrong-value counters.c.per"),
    (place("at: {point: [0, 0], spot: centre}"), "unknown-key rules.r.actions[0] (place).at"),
    (place("at: {on_line: [[0, 0], [1]]}"), "wrong-value rules.r.actions[0] (place).at.on_line[1]"),
    (place("at: start, facing: {towards: [0]}"),
     "wrong-value rules.r.actions[0] (place).facing.towards"),
    (place("at: start, mirror: x"), "wrong-value rules.r.actions[0] (place).mirror"),
    (rule(action="{action: score, entrant: blue, points: {sum: [{times: 2}]}}"),
     "wrong-value rules.r.actions[0] (score).points.sum[0]"),
    (rule(action="{action: score, entrant: blue, points: {sum: [5, '3']}}"),
     "wrong-value rules.r.actions[0] (score).points.sum[1]"),
    (rule(action="{action: score, entrant: blue, points: {position_of: ball}}"), "wrong-value rules.r.actions[0] (score).points"),
    (rule(action="{action: count, counter: c, by: {word: time_lft_s}}") + "counters: {c: {}}\n",
     "wrong-value rules.r.actions[0] (count).by.word -> time_left_s"),
    (rule(action="{action: emit, event: E, payload: {a: {}}}"), "wrong-value rules.r.actions[0] (emit).payload.a"),
    ("result: {rank: [{scor: each, better: more}]}\n", "unknown-word result.rank[0] -> score"),
    ("result: {rank: [{score: each}]}\n", "missing-key result.rank[0]"),
    ("result: {rank: [{word: time_s, better: less}]}\n", "missing-key result.rank[0]"),
    ("result: {rank: [{score: each, better: more}, {score: descending}]}\n", "old-language result.rank[1]"),
    ("result: {rank: score}\n", "wrong-value result.rank"),
    ("zones: {1st: {shape: rect, x_min_m: 0}}\n", "wrong-name zones.1st"),
    ("tables: {r: {blau: {}, weiß: {}}}\nrules: {r: {repeat_for: r, triggers: [{trigger: half_started}], actions: [{action: emit, event: GO, payload: {who: {param: this}}}]}}\n",
     "wrong-name tables.r.weiß"),
    ("match: {half_s: 60, half: 30}\n", "unknown-key match -> halves"),
    ("zones: {pitch: {x_min: -0.5}}\n",
     "unknown-key zones.pitch -> x_min_m"),
    ("match:\n  half_s:{param: x}\n", "unknown-key match -> half_s"),
    ("title: ''\n", "wrong-value title"),
    ("id: fast-shooter\n", "wrong-value id"),
    ("schema_version: '1'\n", "wrong-value schema_version"),
    (WHEEL % "true", "wrong-value kits.v2.devices.left wheel motor.direction"),
    (WHEEL % "'-1'", "wrong-value kits.v2.devices.left wheel motor.direction"),
    (place("at: {start: 'true'}"), "wrong-value rules.r.actions[0] (place).at.start"),
    ("robots: {N1: {colour: blue, number: 7, kit: v2}}\n", "missing-key robots.N1"),
    ("entrants: {blue: {robots: {B1: [x.txt]}}}\n",
     "wrong-value entrants.blue.robots.B1[0]"),
    ("expect: {t: {lasts_s: 1, keyframes: [{at_s: 0, place: {ball: [1]}}]}}\n",
     "wrong-value expect.t.keyframes[0].place.ball"),
    ("expect: {t: {lasts_s: 1, keyframes: [{at_s: 0}], events: [{at_s: 1}]}}\n", "missing-key expect.t.events[0]"),
    ("expect: {t: {lasts_s: 1, keyframes: [{at_s: 0}], events: [{rule: r, event: E}]}}\n" + rule(), "conflicting-keys expect.t.events[0].rule"),
    ("expect: {t: {lasts_s: 1, keyframes: [{at_s: 0}], events: [{rule: rr}]}}\n" + rule(), "unknown-name expect.t.events[0].rule -> r"),
    ("expect: {t: {lasts_s: 1, keyframes: [{at_s: 0, touch: [[ball]]}]}}\n", "wrong-value expect.t.keyframes[0].touch[0]"),
]  # fmt: skip


@pytest.mark.parametrize(("body", "expected"), CASES)
def test_one_mistake_gives_one_error(body, expected):
    key = body.partition(":")[0]
    head = "".join(line + "\n" for line in HEAD.splitlines() if not line.startswith(f"{key}:"))
    assert complaints(body, head=head) == [expected]


@pytest.mark.parametrize("points", ["{gate: t}", "{seconds: 3, gate: t}"])
def test_points_of_an_unknown_form_give_one_error(points):
    (problem,) = errors(rule(action=f"{{action: score, entrant: blue, points: {points}}}"))
    assert in_short(problem) == "wrong-value rules.r.actions[0] (score).points"
    assert "{counter: …}" in problem.message


LONG = "x" * 900


@pytest.mark.parametrize(
    "body",
    [
        rule(f"{{trigger: {LONG}}}"),
        rule(f"{{trigger: enters, entity: ball, zone: {{{LONG}: start}}}}"),
        f"draws: {{d: {{values: [{LONG}]}}}}\n" + rule(action="{action: draw, draw: d, as: b}"),
        f"zones: {{pitch: {{x_min_m: {{param: {LONG}}}}}}}\n",
        f"zones: {{pitch: {{x_min_m:{LONG}}}}}\n",
        rule(f"{{trigger: half_started, {LONG}}}"),
    ],
)
def test_long_texts_are_cut(body):
    message = "".join(problem.message + problem.help for problem in errors(body))
    assert LONG[:70] not in message
