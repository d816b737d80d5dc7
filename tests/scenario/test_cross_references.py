"""Every name that a scenario uses must exist, and be of the kind that is needed."""

import pytest

from tests.scenario.writing import complaints, loaded, problems_of, rule

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
    return [f"{p.path}: {p.message}" for p in problems_of(loaded, world + body)]


def trigger(text, for_each=""):
    rest = f"    for_each: {for_each}\n" if for_each else ""
    return refers(rule(f"{{trigger: {text}}}", rest=rest))


def condition(text, for_each=""):
    rest = f"    for_each: {for_each}\n" if for_each else ""
    return refers(rule(rest=f"    conditions: [{{condition: {text}}}]\n{rest}"))


def action(text, for_each=""):
    rest = f"    for_each: {for_each}\n" if for_each else ""
    return refers(rule(action=f"{{action: {text}}}", rest=rest))


GOOD = [
    (trigger, "phase_entered, phase: pause, from: play", ""),
    (trigger, "timer_expired, timer: clock", ""),
    (trigger, "enters, entity: ball, zone: [pitch, penalty_areas]", ""),
    (trigger, "leaves, entity: movers, zone: in_play", ""),
    (trigger, "leaves, entity: each, zone: in_play", "balls"),
    (trigger, "crosses, entity: ball, gate: doors", ""),
    (trigger, "touches, entity: robots, other: [walls, stones, ball, yellow]", ""),
    (trigger, "displaced, entity: [B1, crate], distance_m: 1, from: [0, 0]", ""),
    (trigger, "no_progress, entity: each, distance_m: 1, within_s: 3", "movers"),
    (trigger, "stays_in, entity: blue, zone: pitch, limit_s: 3", ""),
    (trigger, "tips_over, entity: each", "robots"),
    (trigger, "sequence_broken, sequence: round", ""),
    (trigger, "sequence_broken, sequence: race", ""),
    (trigger, "sequence_broken, sequence: race", "doors"),
    (trigger, "sequence_completed, sequence: race, entity: [blue, crate]", ""),
    (trigger, "sequence_completed, sequence: race, entity: each", "blue"),
    (condition, "sequence_at, sequence: race, step: door", ""),
    (condition, "sequence_at, sequence: race, step: door, entity: each", "movers"),
    (condition, "sequence_at, sequence: race, step: door, entity: ball", "robots"),
    (condition, "sequence_at, sequence: race, step: door, entity: [blue, ball], of: all", ""),
    (condition, "sequence_at, sequence: race, step: door, of: none", "robots"),
    (action, "sequence, sequence: race", "robots"),
    (action, "sequence, sequence: race, entity: each", "movers"),
    (trigger, "program_fault", ""),
    (trigger, "program_fault, robot: [blue, Y1]", ""),
    (trigger, "holds, condition: {condition: in_zone, entity: each, zone: pitch}", "robots"),
    (condition, "in_zone, entity: robots, zone: pitch, of: {at_least: 6}", ""),
    (condition, "distance, entity: ball, to: B1, at_most: 1", ""),
    (condition, "distance, entity: ball, to: centre, at_most: 1", ""),
    (condition, "distance, entity: each, to: [0, 1], at_most: 1", "robots"),
    (condition, "counter, counter: yellow, at_least: {counter: goals}", ""),
    (condition, "counter, counter: pushes, entity: each, at_least: 1", "blue"),
    (condition, "counter, counter: pushes, at_least: 1", ""),
    (condition, "flag, flag: seen, entity: crate", ""),
    (condition, "drawn, draw: corner, equals: centre", ""),
    (condition, "drawn, draw: number, equals: 2", ""),
    (trigger, "crosses, entity: ball, gate: each", "doors"),
    (trigger, "enters, entity: ball, zone: each", "penalty_areas"),
    (trigger, "stays_in, entity: blue, zone: [each, pitch], limit_s: 3", "penalty_areas"),
    (condition, "in_zone, entity: ball, zone: each", "penalty_areas"),
    (condition, "sequence_at, sequence: round, step: each", "doors"),
    (condition, "timer, timer: own, entity: B1, at_least: 1", ""),
    (condition, "timer, timer: clock", ""),
    (condition, "last_touch, by: each", "robots"),
    (condition, "last_touch, entity: second, by: blue", ""),
    (condition, "spot_free, spot: all_spots, of: all", ""),
    (condition, "sequence_at, sequence: round, step: door", ""),
    (action, "score, entrant: yellow, points: [{counter: goals, weight: 2}, {flag: armed}]", ""),
    (action, "count, counter: goals, by: {counter: blue}", ""),
    (action, "count, counter: pushes", ""),
    (action, "count, counter: goals, by: {flag: seen, entity: crate}", ""),
    (action, "score, entrant: yellow, points: {flag: seen, entity: each}", "movers"),
    (action, "score, entrant: yellow, points: [{word: time_left_s, weight: 2}]", ""),
    (action, "score, entrant: yellow, points: {distance: [ball, centre]}", ""),
    (action, "score, entrant: yellow, points: [5, {distance: [each, [0, 0]], weight: -1}, {distance: [robots, second]}]", "movers"),
    (action, "score, entrant: yellow, points: [{timer: clock, weight: -1}, {timer: own, entity: each}]", "robots"),
    (action, "count, counter: goals, to: {timer: own}", ""),
    (action, "emit, event: E, payload: {a: {last_touch: each}, b: {timer: own, entity: B1}, c: {distance: [each, blue]}}", "movers"),
    (action, "score, entrant: yellow, points: {draw: number}", ""),
    (action, "count, counter: goals, to: {draw: number}", ""),
    (action, "score, entrant: yellow, points: [{draw: number, weight: 2}, {word: score, of: blue}]", ""),
    (action, "score, entrant: yellow, points: [{counter: pushes, entity: each}, {flag: seen, entity: crate}]", "robots"),
    (action, "score, entrant: yellow, points: [{counter: pushes}]", "robots"),
    (condition, "flag, flag: seen, entity: [blue, crate], of: none", ""),
    (condition, "counter, counter: pushes, entity: yellow, of: {at_least: 2}, at_least: 1", ""),
    (condition, "counter, counter: pushes, of: all, at_least: 1", "robots"),
    (condition, "timer, timer: own, entity: [each, B1], of: all", "robots"),
    (action, "set_flag, flag: seen, entity: each", "movers"),
    (action, "toggle_flag, flag: armed", ""),
    (action, "timer, timer: own, entity: Y3, do: stop", ""),
    (condition, "distance, entity: ball, to: pitch, at_most: 1", ""),
    (condition, "distance, entity: [ball, B1], to: doors, at_most: 1, of: all", ""),
    (condition, "distance, entity: ball, to: each, at_most: 1", "in_play"),
    (action, "emit, event: E, payload: {a: {distance: [in_play, ball]}, b: {distance: [centre, door]}}", ""),
    (action, "set_spot, spot: centre, to: blue_goal", ""),
    (action, "draw, draw: corner, as: centre", ""),
    (action, "place, layout: wide", ""),
    (action, "place, layout: {draw: formation}, mirror: {axis: y, when: armed}", ""),
    (action, "place, entity: each, at: {nearest_free: all_spots, to: ball}, facing: {towards: centre}", "robots"),
    (action, "place, entity: ball, at: {spot: corner}", ""),
    (action, "place, entity: ball, at: {choice: [centre, corner, neutral_spots, [0, 1]]}", ""),
    (action, "place, entity: ball, at: {furthest_free: centre, from: corner}", ""),
    (action, "place, entity: ball, at: {relative_to: B1}", ""),
    (action, "place, entity: ball, at: {uniform_in: pitch}", ""),
    (action, "place, entity: ball, at: {uniform_in: in_play}", ""),
    (action, "remove, entity: [each, crate], back_at: {spot: centre}", "robots"),
    (action, "hold, entity: [each, blue, Y1], for_s: 1", "robots"),
    (action, "release, entity: robots", ""),
    (condition, "held, entity: yellow, of: {at_least: 2}", ""),
    (action, "emit, event: E, payload: {a: {held: each}, b: {held: Y1}}", "robots"),
    (action, "set_phase, phase: play", ""),
    (action, ("emit, event: E, payload: {a: {counter: pushes, entity: B1}, b: {word: score, of: blue}, "
             "c: {position_of: crate}, f: {position_of: centre}, d: {draw: corner}, e: {flag: armed}}"), ""),
]  # fmt: skip


@pytest.mark.parametrize(("write", "text", "for_each"), GOOD, ids=[case[1][:48] for case in GOOD])
def test_names_that_exist_are_taken(write, text, for_each):
    assert write(text, for_each) == []


BAD = [
    (trigger, "phase_entered, phase: paus", "", "unknown phase 'paus'; did you mean 'pause'?"),
    (trigger, "phase_entered, phase: play, from: x", "", "unknown phase 'x'; there are play, pause"),
    (trigger, "timer_expired, timer: goals", "", "unknown timer 'goals', which is a counter; there are clock, own"),
    (trigger, "enters, entity: post, zone: pitch", "", "'post' is a fixed obstacle; expected an entity"),
    (trigger, "enters, entity: stones, zone: pitch", "", "group 'stones' contains 'post', a fixed obstacle; expected an entity"),
    (trigger, "enters, entity: walls, zone: pitch", "", "'walls' is the walls; expected an entity"),
    (trigger, "enters, entity: obstacles, zone: pitch", "", "group 'obstacles' contains 'post', a fixed obstacle; expected an entity"),
    (action, "hold, entity: ball", "", "'ball' is a ball; expected a robot"),
    (action, "hold, entity: each", "movers", "'each' stands for 'ball', a ball; expected a robot"),
    (action, "hold, entity: movers", "", "group 'movers' contains 'ball', a ball; expected a robot"),
    (action, "hold, entity: other", "", "'other' is known only in a rule whose triggers are all touches; give what else sets it off its own rule"),
    (action, "release, entity: crate", "", "'crate' is an obstacle; expected a robot"),
    (condition, "held, entity: Y9", "", "unknown robot 'Y9'; there are B1, B2, B3, Y1, Y2, Y3, robots, blue, yellow"),
    (action, "emit, event: E, payload: {a: {held: blue}}", "", "'blue' is a group; name one robot"),
    (trigger, "enters, entity: ball, zone: door", "", "'door' is a gate; expected a zone"),
    (trigger, "enters, entity: ball, zone: each", "", "'each' is known only in a rule with for_each"),
    (trigger, "enters, entity: ball, zone: each", "robots", "'each' stands for 'B1', a robot; expected a zone"),
    (trigger, "crosses, entity: each, gate: door", "doors", "'each' stands for 'door', a gate; expected an entity"),
    (trigger, "crosses, entity: ball, gate: each", "penalty_areas", "'each' stands for 'blue_penalty_area', a zone; expected a gate"),
    (action, "score, entrant: each", "doors", "'each' stands for 'door', a gate, which no entrant drives"),
    (action, "place, entity: ball, at: {uniform_in: each}", "penalty_areas", "'each' cannot stand here; name a zone"),
    (trigger, "enters, entity: each, zone: pitch", "", "'each' is known only in a rule with for_each"),
    (trigger, "crosses, entity: ball, gate: pitch", "", "'pitch' is a zone; expected a gate"),
    (trigger, "touches, entity: ball, other: centre", "", "'centre' is a spot; expected an entity or obstacle"),
    (trigger, "tips_over, entity: ball", "", "'ball' is a ball; expected a robot"),
    (action, "place, entity: ball, at: {relative_to: each}", "houses", ("'each' stands for 'house', a zone; "
     "expected an entity or spot, and a spot can stand for its centre: {action: set_spot, spot: NAME, to: each}")),
    (trigger, "tips_over, entity: each", "movers", "'each' stands for 'ball', a ball; expected a robot"),
    (trigger, "program_fault, robot: each", "balls", "'each' stands for 'ball', a ball; expected a robot"),
    (trigger, "holds, condition: {condition: in_zone, entity: bal, zone: pitch}", "", "unknown entity 'bal'; did you mean 'ball'?"),
    (condition, "in_zone, entity: ball, zone: pitsch", "", "unknown zone 'pitsch'; did you mean 'pitch'?"),
    (condition, "distance, entity: ball, to: walls, at_most: 1", "", "'walls' is the walls; expected an entity, obstacle, spot, zone or gate"),
    (condition, "distance, entity: pitch, to: ball, at_most: 1", "", "'pitch' is a zone; expected an entity"),
    (condition, "counter, counter: goal, at_least: 1", "", "unknown counter or entrant 'goal'; did you mean 'goals'?"),
    (condition, "counter, counter: goals, at_least: {counter: x_}", "", ("unknown counter or entrant 'x_'; there are goals, pushes, "
     "blue_pushes, blue, yellow")),
    (condition, "counter, counter: pushes, at_least: 1", "robots", ("counter 'pushes' is kept per robots: say whose with 'entity', "
     "such as entity: each")),
    (condition, "counter, counter: goals, entity: B1, at_least: 1", "", "counter 'goals' is not kept per entity; leave 'entity' out"),
    (condition, "counter, counter: yellow, entity: B1, at_least: 1", "", "counter 'yellow' is not kept per entity; leave 'entity' out"),
    (condition, "counter, counter: blue_pushes, entity: each, at_least: 1", "robots", ("counter 'blue_pushes' is kept per blue, and "
     "'Y1' is not among them")),
    (condition, "counter, counter: pushes, entity: blue, at_least: 1", "", "'blue' is a group; name one entity"),
    (condition, "flag, flag: seen, entity: blue", "", ("'blue' is a group; name one entity, or say with 'of' how many of them: "
     "any, all, none, {at_least: n}")),
    (condition, "timer, timer: own, entity: [B1, B2]", "", "these are several; name one entity, or say with 'of' how many of them"),
    (condition, "flag, flag: seen, entity: yellow, of: all", "", "flag 'seen' is kept per movers, and 'Y1' is not among them"),
    (condition, "flag, flag: armed, of: all", "", "flag 'armed' is not kept per entity; leave 'of' out"),
    (condition, "flag, flag: clock", "", "unknown flag 'clock', which is a timer; there are armed, seen"),
    (condition, "drawn, draw: cornr, equals: centre", "", "unknown draw 'cornr'; did you mean 'corner'?"),
    (condition, "drawn, draw: corner, equals: middle_blue", "", "'middle_blue' is never drawn; it draws from centre, corner_blue_left"),
    (condition, "drawn, draw: text, equals: 1", "", "1 is never drawn; write it in quotes: '1'"),
    (condition, "drawn, draw: number, equals: '1'", "", "'1' is never drawn; leave the quotes out"),
    (condition, "drawn, draw: truth, equals: 'true'", "", "'true' is never drawn; leave the quotes out"),
    (condition, "drawn, draw: text, equals: true", "", "true is never drawn; write it in quotes: 'true'"),
    (condition, "last_touch, by: ball", "", "'ball' is a ball; expected a robot"),
    (condition, "spot_free, spot: pitch", "", "'pitch' is a zone; expected a spot"),
    (condition, "sequence_at, sequence: round, step: hatch", "", "'hatch' is no step of it; its steps are pitch, door, blue_goal"),
    (condition, "sequence_at, sequence: round, step: each", "hatch", ("'each' stands for 'hatch', which is no step of it; its "
     "steps are pitch, door, blue_goal")),
    (condition, "sequence_at, sequence: round, step: x_", "", ("unknown zone or gate 'x_'; there are pitch, blue_goal, yellow_goal, "
     "blue_penalty_area, yellow_penalty_area, house, barn, yard, outside, door, hatch")),
    (trigger, "sequence_completed, sequence: round, entity: each", "balls", ("sequence 'round' is not kept per entity; leave "
     "'entity' out, or keep one for each: give it 'per', a group, in place of entity: ball")),
    (trigger, "sequence_completed, sequence: race", "blue", ("sequence 'race' is kept per movers: say whose with 'entity', "
     "such as entity: each")),
    (trigger, "sequence_broken, sequence: race, entity: each", "robots", ("sequence 'race' is kept per movers, and 'Y1' is not "
     "among them")),
    (trigger, "sequence_broken, sequence: race, entity: [ball, Y2]", "", ("sequence 'race' is kept per movers, and 'Y2' is not "
     "among them")),
    (trigger, "sequence_completed, sequence: race, entity: each", "", "'each' is known only in a rule with for_each"),
    (trigger, "sequence_completed, sequence: race, entity: bleu", "", "unknown entity 'bleu'; did you mean 'blue'?"),
    (condition, "sequence_at, sequence: race, step: door", "movers", ("sequence 'race' is kept per movers: say whose with "
     "'entity', such as entity: each")),
    (condition, "sequence_at, sequence: race, step: door, entity: blue", "", ("'blue' is a group; name one entity, or say with "
     "'of' how many of them: any, all, none, {at_least: n}")),
    (condition, "sequence_at, sequence: race, step: door, of: all, entity: robots", "", ("sequence 'race' is kept per movers, "
     "and 'Y1' is not among them")),
    (condition, "sequence_at, sequence: race, step: door, of: {at_least: 6}, entity: movers", "", "at least 6 of 5 can never hold"),
    (condition, "sequence_at, sequence: round, step: door, of: all", "", ("sequence 'round' is not kept per entity; leave 'of' "
     "out, or keep one for each: give it 'per', a group, in place of entity: ball")),
    (action, "sequence, sequence: race, entity: blue", "", "'blue' is a group; name one entity"),
    (action, "sequence, sequence: race, entity: Y1", "", "sequence 'race' is kept per movers, and 'Y1' is not among them"),
    (action, "sequence, sequence: round, entity: ball", "", ("sequence 'round' is not kept per entity; leave 'entity' out, or "
     "keep one for each: give it 'per', a group, in place of entity: ball")),
    (action, "score, entrant: yelow", "", "unknown entrant 'yelow'; did you mean 'yellow'?"),
    (action, "score, entrant: yellow, points: {counter: x_}", "", ("unknown counter or entrant 'x_'; there are goals, pushes, "
     "blue_pushes, blue, yellow")),
    (action, "score, entrant: yellow, points: [{flag: arm}]", "", "unknown flag 'arm'; did you mean 'armed'?"),
    (action, "score, entrant: yellow, points: {flag: arm}", "", "unknown flag 'arm'; did you mean 'armed'?"),
    (action, "score, entrant: yellow, points: {flag: armed, entity: B1}", "", ("flag 'armed' is not kept per entity; leave 'entity' "
     "out")),
    (action, "score, entrant: yellow, points: {flag: seen}", "movers", ("flag 'seen' is kept per movers: say whose with 'entity', "
     "such as entity: each")),
    (action, "count, counter: goals, by: {flag: seen, entity: Y1}", "", "flag 'seen' is kept per movers, and 'Y1' is not among them"),
    (action, "score, entrant: yellow, points: {draw: numbr}", "", "unknown draw 'numbr'; did you mean 'number'?"),
    (action, "score, entrant: yellow, points: [{counter: pushes, entity: ball}]", "", ("counter 'pushes' is kept per robots, and "
     "'ball' is not among them")),
    (action, "score, entrant: yellow, points: {word: score, of: B1}", "", "unknown entrant 'B1', which is a robot; there are blue, yellow"),
    (action, "count, counter: yellow", "", "unknown counter 'yellow', which is an entrant; there are goals, pushes, blue_pushes"),
    (action, "timer, timer: clock, entity: B1", "", "timer 'clock' is not kept per entity; leave 'entity' out"),
    (action, "set_flag, flag: seen, entity: Y1", "", "flag 'seen' is kept per movers, and 'Y1' is not among them"),
    (action, "draw, draw: corner, as: pitch", "", "'pitch' is never drawn; it draws from centre, corner_blue_left"),
    (action, "place, layout: wid", "", "unknown layout 'wid'; did you mean 'wide'?"),
    (action, "place, layout: wide, mirror: {axis: x, when: goals}", "", "unknown flag 'goals', which is a counter; there are armed, seen"),
    (action, "place, entity: ball, at: {spot: formation}", "", None),
    (action, "place, entity: ball, at: {nearest_free: corner}", "", "unknown spot 'corner', which is a draw; did you mean"),
    (action, "place, entity: ball, at: {uniform_in: [pitch, doors]}", "", "group 'doors' contains 'door', a gate; expected a zone"),
    (action, "place, entity: ball, at: {relative_to: pitch}", "", ("'pitch' is a zone; expected an entity or spot, "
     "and a spot can stand for its centre: {action: set_spot, spot: NAME, to: pitch}")),
    (action, "place, entity: ball, at: start, facing: {towards: doors}", "", "'doors' is a group; name one entity or spot"),
    (action, "remove, entity: post", "", "'post' is a fixed obstacle; expected an entity"),
    (action, "set_phase, phase: any", "", "unknown phase 'any'; there are play, pause"),
    (action, "emit, event: E, payload: {a: {word: score, of: B1}}", "", "unknown entrant 'B1', which is a robot; there are blue, yellow"),
    (action, "emit, event: E, payload: {a: {position_of: pitch}}", "", ("'pitch' is a zone; expected an entity, obstacle "
     "or spot, and a spot can stand for its centre: {action: set_spot, spot: NAME, to: pitch}")),
    (action, "emit, event: E, payload: {a: {position_of: all_spots}}", "", "'all_spots' is a group; name one entity, obstacle or spot"),
]  # fmt: skip


@pytest.mark.parametrize(("write", "text", "for_each", "message"), BAD, ids=[case[1][:48] for case in BAD])
def test_names_that_do_not_fit_are_refused_where_they_stand(write, text, for_each, message):
    found = write(text, for_each)
    if message is None:  # a draw of layouts used as a spot: each of its values is wrong
        assert [line.partition(": ")[0] for line in found] == ["draws.formation.values[0]", "draws.formation.values[1]"]
        assert all(line.endswith("(needed by rules.r.actions[0] (place))") for line in found)
        return
    (line,) = found
    word = text.partition(",")[0]
    part = {trigger: "triggers", condition: "conditions", action: "actions"}[write]
    assert line.startswith(f"rules.r.{part}[0] ({word}): {message}")


@pytest.mark.parametrize("zone", ["yard", "outside", "blue_penalty_area", "each"])
def test_of_a_zone_without_a_centre_none_is_promised(zone):
    (said,) = action(f"place, entity: ball, at: {{relative_to: {zone}}}", "places" if zone == "each" else "")
    assert said.endswith("a zone; expected an entity or spot")


@pytest.mark.parametrize("text", ["score, entrant: yellow, points: {draw: mixed}", "count, counter: goals, by: {draw: mixed}",
                                  "score, entrant: yellow, points: [{draw: mixed, weight: 2}]"])  # fmt: skip
def test_a_draw_that_gives_points_draws_numbers_only(text):
    found = refers(rule(action=f"{{action: {text}}}"))
    word = text.partition(",")[0]
    assert found == [
        f"draws.mixed.values[2]: expected a number, found 'three' (needed by rules.r.actions[0] ({word}))",
        f"draws.mixed.values[3]: expected a number, found true (needed by rules.r.actions[0] ({word}))",
    ]


@pytest.mark.parametrize(("section", "user"), [("timers: {wait: {lasts_s: {draw: long}}}", "timers.wait.lasts_s"),
                                               ("phases: {wait: {lasts_s: {draw: long}}}", "phases.wait.lasts_s")])  # fmt: skip
def test_a_draw_that_says_how_long_something_lasts_draws_durations_only(section, user):
    draw = "draws: {long: {values: [5, 0.032, short, true, 0, 0.03, 86401]}}\n"
    found = complaints(f"{draw}{section}\n")
    assert found == [
        f"draws.long.values[2]: expected a number, found 'short' (needed by {user})",
        f"draws.long.values[3]: expected a number, found true (needed by {user})",
        f"draws.long.values[4]: a duration must be at least one tick (0.032 s), found 0 (needed by {user})",
        f"draws.long.values[5]: a duration must be at least one tick (0.032 s), found 0.03 (needed by {user})",
        f"draws.long.values[6]: must be at most 86400, found 86401 (needed by {user})",
    ]
    assert complaints(f"{section}\n") == [f"{user}.draw: unknown draw 'long'; this scenario has no draw"]


SECTIONS = [
    ("gates: {door: {anchor: pitch}}\n", "gates.door.anchor: 'pitch' is a zone; expected an entity"),
    ("counters: {goals: {per: neutral_spots}}\n", ("counters.goals.per: group 'neutral_spots' contains 'centre', a spot; "
     "expected an entity, obstacle, zone or gate")),
    ("timers: {clock: {per: bleu}}\n", "timers.clock.per: unknown entity, obstacle, zone or gate 'bleu'; did you mean 'blue'?"),
    ("sequences: {round: {entity: balls}}\n", "sequences.round.entity: 'balls' is a group; name one entity"),
    ("sequences: {race: {per: neutral_spots}}\n", ("sequences.race.per: group 'neutral_spots' contains 'centre', a spot; "
     "expected an entity")),
    ("sequences: {race: {per: stones}}\n", ("sequences.race.per: group 'stones' contains 'post', a fixed obstacle; expected "
     "an entity, which can move: with movable: true it is one")),
    ("sequences: {race: {per: bleu}}\n", "sequences.race.per: unknown entity 'bleu'; did you mean 'blue'?"),
    ("sequences: {round: {steps: [pitch, centre]}}\n", "sequences.round.steps[1]: 'centre' is a spot; expected a zone or gate"),
    ("sequences: {round: {steps: [pitch, {any_of: [dor]}]}}\n", ("sequences.round.steps[1].any_of[0]: unknown zone or gate 'dor'; "
     "did you mean 'door'?")),
    ("phases: {pause: {next: paus}}\n", "phases.pause.next: unknown phase 'paus'; did you mean 'pause'?"),
    ("first_phase: paus\n", "first_phase: unknown phase 'paus'; did you mean 'pause'?"),
    ("placements: {wide: [{entity: each, at: start}]}\n", "placements.wide[0].entity: 'each' cannot stand here; name an entity"),
    ("robots: {B1: {kit: v1}}\n", "robots.B1.kit: unknown kit 'v1'; there is only v2"),
    ("kits: {v2: {packet_lists: [B1, X9]}}\n", "kits.v2.packet_lists[1]: unknown robot 'X9'; there are B1, B2, B3, Y1, Y2, Y3"),
    ("entrants: {blue: {robots: {ball: robot.py}}}\n", "entrants.blue.robots.ball: 'ball' is a ball; expected a robot"),
    ("result: {rank: [{counter: goal}]}\n", "result.rank[0].counter: unknown counter 'goal'; did you mean 'goals'?"),
    ("result: {rank: [{time: ascending, plus: [{counter: goal, weight: 1}]}]}\n", ("result.rank[0].plus[0].counter: unknown "
     "counter 'goal'; did you mean 'goals'?")),
    ("broadcast: {fields: {a: {flag: armd}}}\n", "broadcast.fields.a.flag: unknown flag 'armd'; did you mean 'armed'?"),
    ("broadcast: {fields: {a: {position_of: each}}}\n", "broadcast.fields.a.position_of: 'each' is known only in a rule with for_each"),
    ("rules: {r: {for_each: robts, triggers: [{trigger: half_started}], actions: [{action: end}]}}\n",
     "rules.r.for_each: unknown entity, obstacle, zone or gate 'robts'; did you mean 'robots'?"),
]  # fmt: skip


@pytest.mark.parametrize(("body", "message"), SECTIONS, ids=[case[0][:40] for case in SECTIONS])
def test_sections_that_name_something_unknown(body, message, tmp_path):
    (tmp_path / "base.yaml").write_text(
        "extends: soccersim_v2\nschema_version: 1\nid: b\ntitle: B\n" + WORLD, encoding="utf-8"
    )
    (tmp_path / "mine.yaml").write_text("extends: base.yaml\n" + body, encoding="utf-8")
    from rcj_challenges.scenario.errors import ScenarioError
    from rcj_challenges.scenario.load import load

    with pytest.raises(ScenarioError) as caught:
        load(tmp_path / "mine.yaml")
    assert [f"{p.path}: {p.message}" for p in caught.value.problems] == [message]


def test_a_test_in_the_file_names_what_exists():
    body = WORLD + (
        "expect:\n  t:\n    lasts_s: 2\n    phase: paus\n    draws: {corner: pitch, x_: 1, formation: [pitch, 5]}\n    score: {yellw: 1}\n"
        "    counters: {goal: 1}\n    flags: {armd: true}\n    poses: {bal: [0, 0]}\n"
        "    keyframes: [{at_s: 1, place: {bal: [0, 0]}, touch: [[ball, wals]], tips: [ball], fault: [B9]}]\n"
    )
    paths = [line.partition(": ")[0] for line in complaints(body)]
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
def test_a_group_of_for_each_that_is_misspelt_is_told_where_it_is_written_only(uses):
    groups = "zones: {a: {shape: circle, centre_m: [0, 0], radius_m: 0.1}}\ngroups: {doors: [a]}\n"
    rule = f"rules:\n  r: {{for_each: dors, triggers: [{uses}], actions: [{{action: end}}]}}\n"
    assert complaints(groups + rule) == [
        "rules.r.for_each: unknown entity, obstacle, zone or gate 'dors'; did you mean 'doors'?"
    ]


def test_a_default_that_names_something_is_checked_too():
    body = "balls: {ball: null, puck: {start_m: [0, 0]}}\n" + rule(
        rest="    conditions: [{condition: last_touch, by: B1}]\n"
    )
    assert complaints(body) == [
        "rules.r.conditions[0] (last_touch): 'entity' is left out and then means 'ball', which is not here any more; write entity: puck"
    ]


def test_a_kit_that_nobody_uses_may_list_robots_that_are_not_there():
    assert loaded("kits: {old: {packet_lists: [X1]}}\n")


def test_mistakes_of_form_and_unknown_names_come_together():
    found = complaints("match: {halves: 0}\n" + rule("{trigger: enters, entity: bal, zone: gaol, x: 1}"))
    assert [line.partition(": ")[2].partition(";")[0] for line in found] == [
        "must be at least 1, found 0", "unknown entity 'bal'", "unknown zone 'gaol'", "unknown key 'x'",
    ]  # fmt: skip


def test_names_in_a_section_that_is_none_are_not_called_unknown():
    assert complaints("zones: 3\n" + rule("{trigger: enters, entity: ball, zone: pitch}"))[0] == (
        "zones: expected a mapping by name, found 3"
    )
    assert len(complaints("zones: 3\n" + rule("{trigger: enters, entity: ball, zone: pitch}"))) == 1


# --- groups and namespaces --------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("body", "messages"),
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
        ("counters: {blue: {}}\n", ["counters.blue"]),
        ("phases: {any: {}}\n", ["phases.any"]),
        ("flags: {B1: {}, pitch: {}, goals: {}}\ncounters: {B1: {}, goals: {}}\ntimers: {goals: {lasts_s: 1}}\n", []),
    ],
)
def test_what_lies_on_the_field_shares_one_namespace_and_groups_hold_one_kind(body, messages):
    if messages:
        assert [line.partition(": ")[0] for line in complaints(body)] == messages
    else:
        assert loaded(body)
