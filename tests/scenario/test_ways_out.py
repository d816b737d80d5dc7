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
        ("{action: set_flag, flag: place}", "flags: {f: {}}\ndraws: {place: {values: [centre]}}\n",
         "unknown flag 'place', which is a draw; there is only f"),
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


def test_the_name_that_a_param_holds_is_written_with_its_word():
    winner = "params: {winner: blue}\n"
    assert complaints(winner + rule(action="{action: score, entrant: winner}"))[0].endswith(
        "unknown entrant 'winner', which is a param; there are blue, yellow; what a param holds is written {param: winner}"
    )
    assert loaded(winner + rule(action="{action: score, entrant: {param: winner}}"))


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


LIMITS = {
    "{trigger: stays_in, entity: Y1, zone: pitch, limit_s: {counter: n}}": "r.triggers[0] (stays_in).limit_s",
    "{trigger: no_progress, entity: Y1, distance_m: 1, within_s: {counter: n}}": "r.triggers[0] (no_progress).within_s",
    "{trigger: holds, condition: {condition: held, entity: Y1}, for_s: {draw: n}}": "r.triggers[0] (holds).for_s",
    "{trigger: time_reached, at_s: {draw: n}}": "r.triggers[0] (time_reached).at_s",
}


@pytest.mark.parametrize(("trigger", "where"), LIMITS.items(), ids=list(LIMITS.values()))
def test_a_time_that_is_no_number_in_a_rule_is_that_of_a_timer(trigger, where):
    kind = "draw" if "draw" in trigger else "counter"
    (complaint,) = complaints(f"counters: {{n: {{}}}}\ndraws: {{n: {{values: [1]}}}}\n{rule(trigger)}")
    assert complaint == (
        f"rules.{where}: expected a number, found a mapping with {kind}; a time that is drawn or reckoned is that of a "
        f"timer: lasts_s: {{{kind}: n}} there, and {{trigger: timer_expired, timer: …}} here"
    )


def test_a_rest_that_is_no_number_is_a_timer_that_a_condition_asks():
    (complaint,) = complaints(f"counters: {{n: {{}}}}\n{rule(rest='    cooldown_s: {counter: n}')}")
    assert complaint.endswith(
        "expected a number, found a mapping with counter; a rest that is drawn or reckoned is a timer that the rule "
        "starts: lasts_s: {counter: n} there, and {condition: timer, timer: …, negate: true} here"
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


HEAD_OF_ALL = (
    "counters: {n: {}, m: {}}\ndraws: {x: {values: [blue_goal]}, y: {values: [blue_goal, yellow_goal]}}\n"
    "timers: {clock: {lasts_s: 5}}\n"
)
ASKING = "    conditions: [%s]\n"
COUNTED_BEFORE = (
    "; what is reckoned is counted before, {action: count, counter: …, to: [{counter: n, weight: 2}, 1]}, and that "
    "counter stands here"
)


@pytest.mark.parametrize(
    ("condition", "told"),
    [
        (
            "{condition: counter, counter: n, at_least: {score: yellow}}",
            "; a score is read like a counter: {counter: yellow}",
        ),
        (
            "{condition: counter, counter: n, at_most: {entrant: blue}}",
            "; a score is read like a counter: {counter: blue}",
        ),
        ("{condition: counter, counter: n, equals: {counter: n, plus: 1}}", COUNTED_BEFORE),
        ("{condition: counter, counter: n, at_least: {counter: n, times: 2}}", COUNTED_BEFORE),
        (
            "{condition: distance, entity: ball, to: centre, at_most: {timer: clock}}",
            "; what is measured is counted before, {action: count, counter: …, to: {timer: …}}, and {counter: …} stands here",
        ),
        (
            "{condition: drawn, draw: x, equals: {draw: y}}",
            "for_each over those it decides among, {condition: drawn, draw: y, equals: each}, and 'each' here",
        ),
        (
            "{condition: told, entity: Y1, text: {counter: n}}",
            "{action: count, counter: …, to: {told: …}} and an event, and the rule that hears it compares the two counters",
        ),
    ],
)
def test_what_is_reckoned_or_measured_in_a_condition_is_counted_before(condition, told):
    (complaint,) = complaints(HEAD_OF_ALL + rule(rest=ASKING % condition))
    assert complaint.endswith(told)


@pytest.mark.parametrize(
    ("action", "told"),
    [
        ("{action: count, counter: n, by: {counter: m, times: 2}}", "added up: [{counter: m, weight: 2}, 1]"),
        ("{action: score, entrant: yellow, points: {counter: m, plus: 2}}", "added up: [{counter: m, weight: 2}, 1]"),
        ("{action: hold, entity: Y1, for_s: {timer: clock}}", "to: {timer: …}}, and {counter: …} stands here"),
        ("{action: draw, draw: x, as: {draw: y}}", "{condition: drawn, draw: y, equals: each}, and 'each' here"),
        (
            "{action: place, entity: ball, at: {zone: blue_goal}}",
            "; a random point of a zone is {uniform_in: blue_goal}",
        ),
        (
            "{action: place, entity: ball, at: {uniform_in: y}}",
            "; where a draw decides the place, give it layouts as values: {action: place, layout: {draw: y}}",
        ),
    ],
)
def test_what_an_action_cannot_reckon_is_told_as_it_is_written(action, told):
    (complaint,) = complaints(HEAD_OF_ALL + rule(action=action))
    assert complaint.endswith(told)


@pytest.mark.parametrize(
    ("body", "told"),
    [
        (
            rule(rest="    conditions: [{condition: looks, entity: Y1, towards: ball, within_rad: 20}]\n"),
            "must be at most 3.14159, found 20; angles are in rad: if degrees are meant, write 0.3491",
        ),
        (
            rule("{trigger: tips_over, entity: Y1, angle_rad: 45}"),
            "must be less than 3.1416, found 45; angles are in rad: if degrees are meant, write 0.7854",
        ),
        (
            "robots: {Y1: {devices: {laser: {device: lidar, field_of_view_rad: 360}}}}\n",
            "found 360; angles are in rad: if degrees are meant, write 6.2832",
        ),
        ("match: {halves: 20}\n", "must be at most 10, found 20"),
        (rule("{trigger: tips_over, entity: Y1, angle_rad: -1}"), "must be greater than 0, found -1"),
    ],
)
def test_an_angle_beyond_its_bounds_was_hardly_meant_in_rad(body, told):
    (complaint,) = complaints(body)
    assert complaint.endswith(told)


def test_where_a_spot_is_chance_decides_by_a_draw():
    (complaint,) = complaints(rule(action="{action: set_spot, spot: centre, to: {choice: [centre]}}"))
    assert complaint.endswith(
        "found a mapping with choice; chance decides among spots of the file by a draw, draws: {hidden: {values: "
        "[a, b, c]}}: its name stands for the spot drawn, in distance, {spot: hidden} and {relative_to: hidden}"
    )


def test_something_is_put_beside_the_current_one():
    written = "    for_each: robots\n"
    (complaint,) = complaints(rule(action="{action: place, entity: ball, at: each}", rest=written))
    assert complaint.endswith("found 'each'; beside a robot or a ball {relative_to: each}")


def test_a_rule_for_each_spot_is_repeated():
    (complaint,) = complaints("groups: {marks: [centre, middle_blue]}\n" + rule(rest="    for_each: marks\n"))
    assert complaint.endswith(
        "; spots are not gone over: repeat_for: [centre, middle_blue] writes the rule once for each, {param: this}"
    )


@pytest.mark.parametrize(
    "counter", ["{counter: {a: 1}, plus: 1}", "{counter: [n], times: 2}", "{counter: null, plus: 2}"]
)
def test_what_is_no_counter_gets_no_way_out(counter):
    assert complaints(HEAD_OF_ALL + rule(action=f"{{action: count, counter: n, by: {counter}}}"))


OBSTACLES = (
    "obstacles:\n  pin: {shape: cylinder, centre_m: [0.5, 0], radius_m: 0.02, movable: true}\n"
    "  post: {shape: cylinder, centre_m: [-0.5, 0], radius_m: 0.02}\ngroups: {pins: [pin]}\n"
)


@pytest.mark.parametrize("name", ["pin", "post", "pins"])
def test_who_waits_for_an_obstacle_to_tip_over_is_told_what_tells_that_it_was_pushed(name):
    complaint = next(iter(complaints(OBSTACLES + rule(trigger=f"{{trigger: tips_over, entity: {name}}}"))))
    assert "expected a robot" in complaint
    assert complaint.endswith(
        "; an obstacle does not tip over: of a movable one 'displaced' tells that it was pushed away"
    )


def test_of_a_ball_nothing_is_said_of_obstacles():
    assert complaints(rule(trigger="{trigger: tips_over, entity: ball}"))[0].endswith(
        "'ball' is a ball; expected a robot"
    )


TOLD = {
    "{condition: distance, entity: Y1, to: ball, at_most: 0.1}": "a condition cannot be told: let rules set a flag, and tell {flag: NAME}",
    "{score: yellow}": "a score is read like a counter: {counter: yellow}",
}


@pytest.mark.parametrize("value", TOLD)
@pytest.mark.parametrize("where", ["fields", "only", "payload"])
def test_what_cannot_be_told_is_told_otherwise(value, where):
    text = {
        "fields": f"broadcast: {{fields: {{key: {value}}}}}\n" + rule(),
        "only": f"broadcast: {{fields: {{}}, only: {{Y1: {{key: {value}}}}}}}\n" + rule(),
        "payload": rule(action=f"{{action: emit, event: SEEN, payload: {{key: {value}}}}}"),
    }[where]
    (complaint,) = complaints(text)
    assert complaint.endswith(f"; {TOLD[value]}")


@pytest.mark.parametrize("key", ["weights", "weight", "probabilities"])
def test_who_wants_a_value_to_come_more_often_is_told_to_write_it_more_than_once(key):
    (complaint,) = complaints(f"draws: {{prize: {{values: [a, b], {key}: [3, 1]}}}}\n" + rule())
    assert complaint.endswith("; a value that shall come more often is written more than once: values: [a, a, a, b]")


KEPT = "counters: {n: {per: robots}, all: {}}\nflags: {f: {per: yellow}}\ntimers: {t: {per: robots, lasts_s: 1}}\n"


@pytest.mark.parametrize(
    ("action", "way_out"),
    [
        (
            "{action: score, entrant: yellow, points: [5, {counter: n, entity: yellow}]}",
            (
                "; of several a list is added up, with a part for each: [{counter: n, entity: Y1}, {counter: n, entity: Y2}, "
                "{counter: n, entity: Y3}]"
            ),
        ),
        (
            "{action: count, counter: all, to: {timer: t, entity: blue}}",
            (
                "; of several a list is added up, with a part for each: [{timer: t, entity: B1}, {timer: t, entity: B2}, "
                "{timer: t, entity: B3}]"
            ),
        ),
        (
            "{action: count, counter: n, entity: yellow}",
            "; for several write the action once for each of them, entity: Y1, entity: Y2, entity: Y3",
        ),
        ("{action: set_flag, flag: f, entity: yellow}", "; leave 'entity' out: then each of them is meant"),
        ("{action: timer, timer: t, entity: robots}", "; leave 'entity' out: then each of them is meant"),
        ("{action: emit, event: E, payload: {n: {counter: n, entity: yellow}}}", ""),
    ],
)
def test_whoever_means_several_of_what_each_has_learns_how_it_is_said(action, way_out):
    (text,) = complaints(KEPT + rule(action=action))
    assert text.partition("is a group; ")[2] == f"name one entity{way_out}"


def test_the_start_is_no_spot():
    (text,) = complaints(rule(action=PLACE % "{spot: start}"))
    assert text.endswith("unknown spot 'start'; where it began is written at: start")
    (text,) = complaints(rule(action="{action: remove, entity: ball, for_s: 1, back_at: {spot: start}}"))
    assert text.endswith("unknown spot 'start'; where it began is written back_at: start")
