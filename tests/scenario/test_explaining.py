"""One mistake, one sentence, in the words of authors."""

import json

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rcj_challenges.rules.facing import Facing
from rcj_challenges.rules.fields import Name, Names, Point
from rcj_challenges.rules.places import At
from rcj_challenges.rules.values import Points
from rcj_challenges.scenario.load import load_text
from rcj_challenges.scenario.messages.wording import expectation
from tests.scenario.writing import HEAD, complaints, problems_of, rule

TRIGGERS = (
    "half_started, half_ended, phase_entered, time_reached, timer_expired, enters, leaves, crosses, touches, displaced, "
    "no_progress, stays_in, tips_over, sequence_completed, sequence_broken, event, program_fault, tells, holds"
)


def place(text):
    return rule(action=f"{{action: place, entity: ball, {text}}}")


WHEEL = "kits: {v2: {devices: {left wheel motor: {direction: %s}}}}\n"
CASES = [
    (rule("{trigger: enterz}"), f"rules.r.triggers[0] (enterz): unknown trigger 'enterz'; there are {TRIGGERS}; did you mean 'enters'?"),
    (rule("{entity: ball}"), f"rules.r.triggers[0]: 'trigger' is missing; it is one of {TRIGGERS}"),
    (rule("{trigger: [enters]}"), f"rules.r.triggers[0]: unknown trigger 'a list of 1'; there are {TRIGGERS}"),
    (
        rule("half_started"),
        "rules.r.triggers[0]: expected a mapping with 'trigger', found 'half_started'; write {trigger: half_started}",
    ),
    (rule("{trigger: half_started, at: 3}"), "rules.r.triggers[0] (half_started): unknown key 'at'; allowed are trigger"),
    (rule("{trigger: enters, entity: ball}"),
     "rules.r.triggers[0] (enters): 'zone' is missing: a zone, each, or a draw's name; with a list or group: into any of them from none of them"),
    (rule("{trigger: enters, entity: ball, zoen: pitch}"),
     "rules.r.triggers[0] (enters): unknown key 'zoen'; allowed are trigger, entity, zone; did you mean 'zone'?"),
    (rule("{trigger: enters, entity: [1, ball], zone: pitch}"), "rules.r.triggers[0] (enters).entity[0]: expected a name, found 1"),
    (rule("{trigger: enters, entity: [], zone: pitch}"),
     "rules.r.triggers[0] (enters).entity: must have at least 1 entry, found an empty list"),
    (rule("{trigger: enters, entity: {name: ball}, zone: pitch}"),
     "rules.r.triggers[0] (enters).entity: expected a name or a list of names, found a mapping with name; its name stands alone: ball"),
    (rule("{trigger: displaced, entity: ball, distance_m: 1, from: last}"),
     "rules.r.triggers[0] (displaced).from: expected last_placement or two numbers [x, y], found 'last'; did you mean 'last_placement'?"),
    (rule("{trigger: displaced, entity: ball, distance_m: 1, from: [1]}"),
     "rules.r.triggers[0] (displaced).from: expected last_placement or two numbers [x, y], found a list of 1"),
    (rule("{trigger: displaced, entity: ball, distance_m: 1, from: [1, x]}"),
     "rules.r.triggers[0] (displaced).from[1]: expected a number, found 'x'"),
    (rule("{trigger: tips_over, entity: B1, angle_rad: 4}"), "rules.r.triggers[0] (tips_over).angle_rad: must be less than 3.1416, found 4"),
    (rule("{trigger: holds, condition: {condition: speed, entity: ball, at_least: fast}}"),
     "rules.r.triggers[0] (holds).condition.at_least: expected a number, {counter: …}, {lowest: …} or {highest: …}, found 'fast'"),
    (rule("{trigger: holds, condition: {condition: speed, entity: ball, at_least: {timer: t}}}"),
     ("rules.r.triggers[0] (holds).condition.at_least: expected a number, {counter: …}, {lowest: …} or {highest: …}, found a mapping with timer; "
      "what is measured is counted before, {action: count, counter: …, to: {timer: …}}, and {counter: …} stands here")),
    (rule("{trigger: holds, condition: [{condition: flag, flag: f}, {condition: flag, flag: g}]}"),
     ("rules.r.triggers[0] (holds).condition: expected a mapping with 'condition', found a list of 2; it takes a single one of in_zone, "
      "speed, distance, way, looks, held, counter, flag, drawn, timer, last_touch, told, spot_free, sequence_at, half, any_of, all_of (its opposite by negate: true); for "
      "several write {condition: all_of, conditions: […]}; what else must hold when the rule fires stands in its 'conditions'")),
    (rule("{trigger: holds, condition: {condition: any_of, conditions: [{condition: any_of, conditions: []}]}}"),
     ("rules.r.triggers[0] (holds).condition.conditions[0] (any_of): unknown condition 'any_of'; there are in_zone, speed, distance, way, looks, held, "
      "counter, flag, drawn, timer, last_touch, told, spot_free, sequence_at, half, all_of; 'any_of' cannot stand in itself: write all "
      "conditions into one list")),
    (rule("{trigger: event, event: Goal}"), "rules.r.triggers[0] (event).event: 'Goal' is no event's name: capitals, digits and _, such as GOAL"),
    (rule(rest="    phases: all\n"), "rules.r.phases: expected any or a list of names, found 'all'; did you mean any?"),
    (rule(rest="    phases: [play, 3]\n"), "rules.r.phases[1]: expected a name, found 3"),
    (rule(rest="    for_each: [B1]\n"), ("rules.r.for_each: expected a name, found a list of 1; for several, name a group "
     "of them, or write the rule once for each name with repeat_for")),
    (rule(rest=f"    says: {'x' * 501}\n"), f"rules.r.says: must have at most 500 characters, found '{'x' * 60}…'"),
    (place("at: centre"), ("rules.r.actions[0] (place).at: expected start, {start: …}, {point: …}, {spot: …}, {uniform_in: …}, {on_line: …}, "
     "{choice: …}, {nearest_free: …}, {furthest_free: …} or {relative_to: …}, found 'centre'; a spot is written {spot: centre}")),
    (place("at: middle"), ("rules.r.actions[0] (place).at: expected start, {start: …}, {point: …}, {spot: …}, {uniform_in: …}, {on_line: …}, "
     "{choice: …}, {nearest_free: …}, {furthest_free: …} or {relative_to: …}, found 'middle'; a spot is written {spot: middle}, "
     "a random point of a zone {uniform_in: middle}, beside a robot or a ball {relative_to: middle}")),
    (place("at: {spot: [centre]}"), "rules.r.actions[0] (place).at.spot: expected a name, found a list of 1"),
    (place("at: {point: [0, 0], spot: centre}"), "rules.r.actions[0] (place).at: unknown key 'spot'; allowed are point; 'point' is given already, in line 8"),
    (place("at: {on_line: [[0, 0], [1]]}"), "rules.r.actions[0] (place).at.on_line[1]: expected two numbers [x, y], found a list of 1"),
    (place("at: {on_line: [[0, 0]]}"), "rules.r.actions[0] (place).at.on_line: expected 2 points, each [x, y], found a list of 1"),
    (place("at: start, facing: north"),
     "rules.r.actions[0] (place).facing: expected start or keep, a number, {towards: …} or {random: …}, found 'north'"),
    (place("at: start, facing: {random: false}"), "rules.r.actions[0] (place).facing.random: expected true, found false"),
    (place("at: start, facing: {towards: [0]}"),
     "rules.r.actions[0] (place).facing.towards: expected a name or two numbers [x, y], found a list of 1"),
    (place("at: start, mirror: x"), "rules.r.actions[0] (place).mirror: expected {axis: …}, found 'x'"),
    (rule(action="{action: score, entrant: blue, points: [{weight: 2}]}"),
     ("rules.r.actions[0] (score).points[0]: expected a number, {counter: …}, {flag: …}, {draw: …}, {word: …}, {distance: …}, {way: …}, {timer: …} or {told: …}, "
      "found a mapping with weight")),
    (rule(action="{action: score, entrant: blue, points: [5, '3']}"),
     ("rules.r.actions[0] (score).points[1]: expected a number, {counter: …}, {flag: …}, {draw: …}, {word: …}, {distance: …}, {way: …}, {timer: …} or {told: …}, "
      "found '3'; leave the quotes out")),
    (rule(action="{action: score, entrant: blue, points: {distance: [ball]}}"),
     "rules.r.actions[0] (score).points.distance: expected a list of 2, found a list of 1"),
    (rule(action="{action: score, entrant: blue, points: {position_of: ball}}"), ("rules.r.actions[0] (score).points: expected a number, "
     "{counter: …}, {flag: …}, {draw: …}, {word: …}, {distance: …}, {way: …}, {timer: …}, {told: …} or a list, found a mapping with position_of")),
    (rule(action="{action: score, entrant: blue, points: {word: phase}}"), ("rules.r.actions[0] (score).points.word: expected score, halftime, "
     "total_match_time_s, time_s, time_left_s, measured or limit, found 'phase'")),
    (rule(action="{action: count, counter: c, by: {word: time_lft_s}}") + "counters: {c: {}}\n",
     ("rules.r.actions[0] (count).by.word: expected score, halftime, total_match_time_s, time_s, time_left_s, measured or limit, "
      "found 'time_lft_s'; did you mean 'time_left_s'?")),
    (rule(action="{action: emit, event: E, payload: {a: {}}}"), ("rules.r.actions[0] (emit).payload.a: expected a text, a number or "
     "true/false, {counter: …}, {flag: …}, {draw: …}, {word: …}, {position_of: …}, {distance: …}, {way: …}, {timer: …}, {held: …}, {last_touch: …} or {told: …}, "
     "found an empty mapping")),
    (rule(action="{action: emit, event: E, payload: {a: {word: scor}}}"),
     ("rules.r.actions[0] (emit).payload.a.word: expected robot_name, entity_name, each_name, other_name, team_name, entrant, score, halftime, match_id, "
     "total_match_time_s, time_s, time_left_s, measured, limit, phase or seed_id, found 'scor'; did you mean 'score'?")),
    (rule(rest="    conditions: [{condition: in_zone, entity: robots, zone: pitch, of: {at_least: 0}}]\n"),
     "rules.r.conditions[0] (in_zone).of.at_least: must be at least 1, found 0"),
    ("result: {rank: [{tim: ascending}]}\n", "result.rank[0]: unknown key 'tim'; allowed are time, plus; did you mean 'time'?"),
    ("result: {rank: [{order: ascending}]}\n", "result.rank[0]: 'counter' is missing: a counter"),
    ("result: {rank: score}\n", "result.rank: expected a list, found 'score'"),
    ("rules: [1]\n", "rules: expected a mapping by name, found a list of 1; each entry begins with its name and ':', not with '-'"),
    ("zones: {1st: {shape: rect, x_min_m: 0}}\n", "zones.1st: '1st' is no name: letters, digits and _, not beginning with a digit, at most 64"),
    ("zones: {Hügel_süß: {shape: rect, x_min_m: 0}}\n",
     ("zones.Hügel_süß: 'Hügel_süß' is no name: letters, digits and _, not beginning with a digit, at most 64; letters are "
      "those from a to z: Huegel_suess")),
    ("id: café\n", "id: 'café' is no name: letters, digits and _, not beginning with a digit, at most 64; letters are those from a to z: cafe"),
    ("id: ход\n", "id: 'ход' is no name: letters, digits and _, not beginning with a digit, at most 64; letters are those from a to z"),
    (rule(action="{action: emit, event: TOR_FÜR}"),
     "rules.r.actions[0] (emit).event: 'TOR_FÜR' is no event's name: capitals, digits and _, such as GOAL; letters are those from A to Z: TOR_FUER"),
    ("rules: {r: {repeat_for: [blau, weiß], triggers: [{trigger: half_started}], actions: [{action: emit, event: GO, payload: {who: {param: this}}}]}}\n",
     "rules.r.repeat_for[1]: 'weiß' is no name: letters, digits and _, not beginning with a digit, at most 64; letters are those from a to z: weiss"),
    ("broadcast: {only: {Y1: {a: 1}}}\n", "broadcast: 'fields' is missing: values by key, which all robots are told; write fields: {} for none"),
    ("match: {halves: 11}\n", "match.halves: must be at most 10, found 11"),
    ("match: {half_s: 60, half: 30}\n", "match: unknown key 'half'; allowed are halves, half_s, swap_sides; 'half_s' is given already, in line 5"),
    ("zones: {pitch: {x_min: -0.5}}\n",
     ("zones.pitch: unknown key 'x_min'; allowed are inverted, drawn, colour, shape, x_min_m, x_max_m, y_min_m, y_max_m; "
      "did you mean 'x_min_m'?")),
    ("match:\n  half_s:{param: x}\n", ("match: unknown key 'half_s:{param'; allowed are halves, half_s, swap_sides; "
     "a blank comes after the ':', half_s: {param")),
    ("match: {halves: true}\n", "match.halves: expected a whole number, found true"),
    ("match: {swap_sides: on}\n", "match.swap_sides: expected true/false, found 'on'; did you mean true?"),
    ("match: {half_s: '60'}\n", "match.half_s: expected a number or a list, found '60'; leave the quotes out"),
    ("match: {half_s: 1e9}\n", "match.half_s: must be at most 86400, found 1000000000.0"),
    ("title: ''\n", "title: must have at least 1 character, found ''"),
    ("title: 2021\n", "title: expected a text, found 2021"),
    ("id: fast-shooter\n", "id: 'fast-shooter' is no name: letters, digits and _, not beginning with a digit, at most 64"),
    ("schema_version: 0\n", "schema_version: expected 1, found 0"),
    ("schema_version: '1'\n", "schema_version: expected 1, found '1'; leave the quotes out"),
    ("schema_version: true\n", "schema_version: expected 1, found true"),
    (WHEEL % "true", "kits.v2.devices.left wheel motor.direction: expected 1 or -1, found true"),
    (WHEEL % "'-1'", "kits.v2.devices.left wheel motor.direction: expected 1 or -1, found '-1'; leave the quotes out"),
    (place("at: {start: 'true'}"), "rules.r.actions[0] (place).at.start: expected true, found 'true'; leave the quotes out"),
    (place("at: {start: 1}"), "rules.r.actions[0] (place).at.start: expected true, found 1"),
    (place("at: start, facing: {random: 1}"), "rules.r.actions[0] (place).facing.random: expected true, found 1"),
    ("robots: {B1: {colour: 3}}\n", "robots.B1.colour: expected a name, found 3"),
    ("robots: {B1: {start: {x_m: a}}}\n", "robots.B1.start.x_m: expected a number, found 'a'"),
    ("robots: {N1: {colour: blue, number: 7, kit: v2}}\n", "robots.N1: 'start' is missing: where it starts"),
    ("entrants: {blue: {robots: {B1: 7}}}\n", "entrants.blue.robots.B1: expected a path to a .py file or a list, found 7"),
    ("entrants: {blue: {robots: {B1: [x.txt]}}}\n",
     "entrants.blue.robots.B1[0]: 'x.txt' is no entry point: a relative path with / to a .py file"),
    ("expect: {t: {lasts_s: 1, keyframes: [{at_s: 0, place: {ball: [1]}}]}}\n",
     "expect.t.keyframes[0].place.ball: must have at least 2 entries, found a list of 1"),
    ("expect: {t: {lasts_s: 1, keyframes: [{at_s: 0, touch: [[ball]]}]}}\n", "expect.t.keyframes[0].touch[0]: expected a list of 2, found a list of 1"),
    ("balls: {ball: {colour: 'red;'}}\n", "balls.ball.colour: 'red;' is no colour: a CSS colour name or #rrggbb"),
    ("draws: {d: {values: [[1]]}}\n", "draws.d.values[0]: expected a text, a number or true/false, found a list of 1"),
    ("groups: {g: B1}\n", "groups.g: expected a list of names, found 'B1'; a list of one is written [B1]"),
    ("zones: {z: {shape: 3}}\n", "zones.z: unknown shape '3'; there are rect, circle, polygon, half_plane"),
    ("zones: {z: {inverted: true}}\n", "zones.z: 'shape' is missing; it is one of rect, circle, polygon, half_plane"),
]  # fmt: skip


@pytest.mark.parametrize(("body", "message"), CASES, ids=[case[1][:60] for case in CASES])
def test_one_mistake_gives_one_sentence(body, message):
    key = body.partition(":")[0]
    head = "".join(line + "\n" for line in HEAD.splitlines() if not line.startswith(f"{key}:"))
    assert complaints(body, head=head) == [message]


@pytest.mark.parametrize("points", ["{gate: t}", "{seconds: 3, gate: t}"])
def test_points_that_cannot_be_read_give_one_sentence_that_says_what_can(points):
    (message,) = complaints(rule(action=f"{{action: score, entrant: blue, points: {points}}}"))
    assert message.startswith("rules.r.actions[0] (score).points: expected a number, {counter: …}")
    assert ", found a mapping with" in message


def test_two_mistakes_in_one_mapping_give_two_sentences():
    assert len(complaints(rule("{trigger: enters, entity: 3, zoen: pitch, distance: 4}"))) == 3


@pytest.mark.parametrize(
    ("shape", "words"),
    [
        (Name, "a name"),
        (Names, "a name or a list of names"),
        (Point, "two numbers [x, y]"),
        (Name | None, "a name"),
        (
            Points,
            "a number, {counter: …}, {flag: …}, {draw: …}, {word: …}, {distance: …}, {way: …}, {timer: …}, {told: …} or a list",
        ),
        (Facing, "start or keep, a number, {towards: …} or {random: …}"),
        (float, "a number"),
        (int | float, "a number"),
        (tuple[float, ...], "a list"),
        (dict[str, int], "a mapping by name"),
    ],
)
def test_what_is_expected_in_words(shape, words):
    assert expectation(shape) == words
    assert expectation(At).startswith("start, {start: …}, {point: …}")


VALUES = st.recursive(
    st.none() | st.booleans() | st.integers(-5, 5) | st.floats(allow_nan=False, allow_infinity=False) | st.text("ab1_", max_size=3),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.sampled_from(["spot", "a", "shape", "word", "param"]), inner, max_size=3),
    max_leaves=6,
)  # fmt: skip
PLACES = ["match", "match.half_s", "zones.z", "groups.g", "rules.r.phases", "rules.r.triggers", "broadcast.fields.f",
          "result.rank", "robots.B1.start", "draws.d", "sequences.s", "placements.p", "expect.t", "entrants.blue.robots.B1",
          "title", "extends", "params.p", "field.goals"]  # fmt: skip


@settings(max_examples=120, deadline=None)
@given(st.sampled_from(PLACES), VALUES)
def test_whatever_stands_anywhere_is_explained_without_a_traceback(where, value):
    data = {"schema_version": 1, "id": "a", "title": "A", "extends": "soccersim_v2"}
    holder = data
    *above, last = where.split(".")
    for key in above:
        holder = holder.setdefault(key, {})
    holder[last] = value
    found = problems_of(load_text, json.dumps(data))
    assert all(problem.message and "nput should" not in problem.message for problem in found)


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
def test_a_text_that_nobody_can_read_is_cut(body):
    complaint = "".join(complaints(body))
    assert LONG[:60] in complaint
    assert LONG[:70] not in complaint


def test_a_key_without_a_letter_is_told_in_quotes():
    (complaint,) = complaints(rule("{trigger: enters, entity: ball, zone: {'': pitch}}"))
    assert complaint.endswith("expected a name or a list of names, found a mapping with ''")
    (complaint,) = complaints("match: {'': {halves: []}}\n")
    assert complaint.startswith("match: unknown key ''")
