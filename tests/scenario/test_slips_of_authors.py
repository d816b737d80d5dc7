"""Slips that authors make: the message leads to what was meant, and never to its opposite."""

from __future__ import annotations

import pytest

from tests.scenario.writing import complaints, loaded, rule

COUNTED = "{trigger: holds, condition: {condition: in_zone, entity: robots, zone: pitch, of: %s}}"


@pytest.mark.parametrize(
    ("written", "told"),
    [
        ("one", "found 'one'; did you mean 'any'?"),
        ("some", "found 'some'; did you mean 'any'?"),
        ("both", "found 'both'; did you mean 'all'?"),
        ("each", "found 'each'; did you mean 'all'?"),
        ("every", "found 'every'; did you mean 'all'?"),
        ("nobody", "found 'nobody'; did you mean 'none'?"),
        ("0", "found 0; did you mean 'none'?"),
        ("2", "found 2; so many or more are written {at_least: 2}"),
    ],
)
def test_how_many_of_a_group_are_meant(written, told):
    assert complaints(rule(COUNTED % written))[0].endswith(told)


def test_an_order_has_nothing_of_how_many():
    rank = "result: {rank: [{score: both}]}\n"
    assert complaints(rank + rule())[0].endswith("expected ascending or descending, found 'both'")


@pytest.mark.parametrize(
    ("action", "told"),
    [
        ("{action: score, entrant: blue, points: [60, {time_s: 1, weight: -1}]}", "; its value is written {word: time_s}"),
        ("{action: emit, event: E, payload: {at: {time_s: 1}}}", "; its value is written {word: time_s}"),
        ("{action: emit, event: E, payload: {on: {other: name}}}", "; the name of the other one is written {word: other_name}"),
        ("{action: emit, event: E, payload: {by: {robot: name}}}", "; the name of the robot is written {word: robot_name}"),
    ],
)  # fmt: skip
def test_a_word_is_written_behind_its_key(action, told):
    text = complaints(rule(action=action))[0]
    assert text.endswith(told)
    assert "did you mean" not in text


@pytest.mark.parametrize("word", ["robot_name", "phase", "match_id", "time_left_s"])
def test_what_is_told_may_be_any_word(word):
    text = complaints(rule(action=f"{{action: emit, event: E, payload: {{it: {{{word}: 1}}}}}}"))[0]
    assert text.endswith(f"; its value is written {{word: {word}}}")
    assert loaded(rule(action=f"{{action: emit, event: E, payload: {{it: {{word: {word}}}}}}}"))


def test_a_broadcast_is_about_nobody():
    broadcast = "broadcast: {fields: {it: %s}}\n"
    for about in ("robot: Y1", "entity: ball", "other: 1", "robot_name: 1", "measured: 1"):
        assert "is written" not in complaints(broadcast % f"{{{about}}}" + rule())[0]
    assert complaints(broadcast % "{team: yellow}" + rule())[0].endswith(
        "; the name of the team is written {word: team_name, of: yellow}"
    )
    assert complaints(broadcast % "{time_left_s: 1}" + rule())[0].endswith("; its value is written {word: time_left_s}")


@pytest.mark.parametrize(
    "action",
    ["{action: score, entrant: blue, points: {entity: Y1}}", "{action: place, entity: ball, at: {robot: Y1}}"],
)
def test_a_number_or_a_place_is_no_name(action):
    assert "_name}" not in complaints(rule(action=action))[0]


@pytest.mark.parametrize("word", ["none", "None", "nothing", "no", "'null'", "removed"])
def test_what_is_not_wanted_is_written_null(word):
    text = complaints(f"robots: {{B3: {word}}}\n" + rule())[0]
    assert text.endswith("; what is not wanted is taken away by null: B3: null")


def test_so_it_is_with_who_drives_it_and_with_goals():
    text = complaints("entrants: {blue: {robots: {B3: none}}}\n" + rule())[0]
    assert text.endswith("; what is not wanted is taken away by null: B3: null")
    text = complaints("field: {goals: {blue_goal: none}}\n" + rule())[0]
    assert text.endswith("; what is not wanted is taken away by null: blue_goal: null")


@pytest.mark.parametrize(
    ("section", "name"),
    [
        ("zones: {blue_penalty_area: none}", "blue_penalty_area"),
        ("kits: {v2: {devices: {gps: none}}}", "gps"),
        ("groups: {penalty_areas: none}", "penalty_areas"),
    ],
)
def test_so_it_is_with_all_that_has_a_name_of_its_own(section, name):
    text = complaints(f"{section}\n" + rule())[0]
    assert text.endswith(f"; what is not wanted is taken away by null: {name}: null")


@pytest.mark.parametrize(
    "section",
    ["match: {halves: none}", "match: {swap_sides: none}", "field: {corner_cut_m: none}", "limits: {step_s: none}"],
)
def test_of_what_null_does_not_take_away_it_is_not_said(section):
    assert "null" not in complaints(f"{section}\n" + rule())[0]


def test_a_device_of_the_kit_is_taken_from_a_robot_by_without():
    text = complaints("robots: {Y1: {devices: {gps: none}}}\n" + rule())[0]
    assert text.endswith("; a device of the robot's kit is taken away by 'without: [gps]'")


def test_any_other_word_there_is_not_taken_for_it():
    assert complaints("robots: {B3: big}\n" + rule())[0] == "robots.B3: expected a mapping, found 'big'"


FLAG = "flags: {armed: {}}\n"
ASKED = "    conditions: [{condition: %s}]\n"


@pytest.mark.parametrize(
    ("condition", "told"),
    [
        ("flag, flag: armed, to: false", "; the opposite of a condition is written negate: true"),
        ("held, entity: Y1, is: false", "; the opposite of a condition is written negate: true"),
        ("drawn, draw: d, not_equals: a", "; the opposite of a condition is written negate: true"),
        ("in_zone, entity: Y1, not_in: pitch", "; the opposite of a condition is written negate: true"),
        ("speed, entity: Y1, faster_than: 0.1", "; 'at_least' holds from that value on"),
        ("distance, entity: Y1, to: ball, nearer_than: 0.1", "; 'at_most' holds up to that value"),
        ("in_zone, entity: robots, zone: pitch, at_least: 2", "; how many of them is written of: {at_least: 2}"),
    ],
)
def test_a_condition_is_turned_over_compared_and_counted(condition, told):
    body = FLAG + "draws: {d: {values: [a, b]}}\n" + rule(rest=ASKED % condition)
    assert any(told in text and "unknown key" in text for text in complaints(body))


def test_a_key_for_a_value_that_is_not_false_is_nothing_of_the_opposite():
    assert "negate: true" not in complaints(FLAG + rule(rest=ASKED % "flag, flag: armed, to: true"))[0]


def test_how_long_it_must_hold_stands_beside_the_condition():
    holds = "{trigger: holds, condition: {condition: in_zone, entity: ball, zone: pitch, for_s: 2}}"
    assert complaints(rule(holds))[0].endswith(
        "; it stands beside 'condition', in the trigger: {trigger: holds, condition: {…}, for_s: …}"
    )


def test_a_rule_that_fires_once():
    assert complaints(rule(rest="    once: true\n"))[0].endswith("; a rule that fires once has max_executions: 1")


@pytest.mark.parametrize(
    ("section", "key"),
    [("teams: {}", "entrants"), ("areas: {}", "zones"), ("variables: {}", "counters"), ("tests: {}", "expect"), ("name: A", "title")],
)  # fmt: skip
def test_what_others_call_a_section(section, key):
    assert complaints(section + "\n" + rule())[0].endswith(f"; it is called '{key}' here")


@pytest.mark.parametrize("key", ["x_m", "x"])
def test_a_rect_has_bounds(key):
    text = complaints(f"zones: {{a: {{shape: rect, {key}: [0, 0.1], y_max_m: 0.2}}}}\n" + rule())[0]
    assert text.endswith("; its bounds are x_min_m and x_max_m, and each may be left out")


def test_how_long_something_must_last_is_no_part_of_an_edge():
    text = complaints(rule("{trigger: enters, entity: ball, zone: pitch, for_s: 1}"))[0]
    assert text.endswith("; what must last for a time is {trigger: holds, condition: {…}, for_s: …}")


@pytest.mark.parametrize(
    ("body", "told"),
    [
        ("match: {periods: 2, half_s: 60}\n" + rule(), "; it is called 'halves' here"),
        ("phases: {nap: {lasts_s: 1}}\nfirst_phase: nap\n" + rule("{trigger: phase_entered, phase: play, after: nap}"),
         "; it is called 'from' here"),
        ("counters: {n: {}}\n" + rule(action="{action: count, counter: n, set: 0}"), "; it is called 'to' here"),
    ],
)  # fmt: skip
def test_what_others_call_it(body, told):
    assert complaints(body)[0].endswith(told)


SPOTS = "draws: {mark: {values: [centre, middle_blue]}}\n"


@pytest.mark.parametrize(
    ("at", "told"),
    [
        ("{draw: mark}", "; a spot that a draw decides is written {spot: mark}"),
        ("{zone: pitch}", "; a random point of a zone is {uniform_in: pitch}"),
    ],
)
def test_where_chance_puts_something_in_a_layout_and_in_an_action(at, told):
    layout = f"placements: {{l: [{{entity: ball, at: {at}}}]}}\n"
    assert complaints(SPOTS + layout + rule(action="{action: place, layout: l}"))[0].endswith(told)
    assert complaints(SPOTS + rule(action=f"{{action: place, entity: ball, at: {at}}}"))[0].endswith(told)
    assert loaded(SPOTS + rule(action="{action: place, entity: ball, at: {spot: mark}}"))


WHO = """
draws:
  who: {values: [B1, Y1, ball]}
  any: {values: [B1, centre]}
  hot: {values: [pitch, blue_goal]}
  n: {values: [1, 2]}
groups: {corners: [corner_blue_left, corner_blue_right]}
obstacles:
  post: {shape: cylinder, centre_m: [0.3, 0], radius_m: 0.05}
  crate: {shape: box, centre_m: [-0.3, 0], size_m: [0.1, 0.1], movable: true}
"""


class TestPlacesOfNames:
    """A name stands where a place is expected: the message says how the place of just that thing is written."""

    @pytest.mark.parametrize(
        ("written", "told"),
        [
            ("who", "{relative_to: who, offset_m: [0.1, 0]}"),
            ("{draw: who}", "{relative_to: who, offset_m: [0.1, 0]}"),
            ("Y1", "{relative_to: Y1, offset_m: [0.1, 0]}"),
            ("{entity: Y1}", "{relative_to: Y1, offset_m: [0.1, 0]}"),
            ("{draw: who, offset_m: [0, 0.2]}", "{relative_to: who, offset_m: [0.1, 0]}"),
            ("any", "{relative_to: any, offset_m: [0.1, 0]}"),
            ("crate", "{relative_to: crate, offset_m: [0.1, 0]}"),
            ("centre", "{spot: centre}"),
            ("pitch", "{uniform_in: pitch}"),
            ("corners", "{choice: [corners]}"),
        ],
    )
    def test_where_something_is_put(self, written, told):
        (text,) = complaints(WHO + rule(action=f"{{action: place, entity: Y2, at: {written}}}"))
        assert told in text
        assert "did you mean" not in text
        assert loaded(WHO + rule(action=f"{{action: place, entity: Y2, at: {told}}}"))

    @pytest.mark.parametrize(
        ("written", "told"),
        [("who", "{relative_to: who}"), ("{draw: who}", "{relative_to: who}"), ("B1", "{relative_to: B1}")],
    )
    def test_where_a_ball_is_kicked_to(self, written, told):
        kick = "{action: place, entity: ball, at: {spot: centre}, kick: {towards: %s, speed_mps: 1}}"
        assert complaints(WHO + rule(action=kick % written))[0].endswith(
            f"; at where {_it(written)} is, is written {told}"
        )
        assert loaded(WHO + rule(action=kick % told))

    @pytest.mark.parametrize("written", ["post", "{obstacle: post}"])
    def test_a_fixed_obstacle_is_no_place(self, written):
        (text,) = complaints(WHO + rule(action=f"{{action: place, entity: Y2, at: {written}}}"))
        assert text.endswith("; 'post' is a fixed obstacle: a spot of the same place, or beside it, can stand for it")

    @pytest.mark.parametrize("written", ["hot", "{draw: hot}", "{draw: n}"])
    def test_a_draw_that_decides_among_no_places_can_decide_among_layouts(self, written):
        told = "where a draw decides the place, give it layouts as values: {action: place, layout: {draw: "
        assert told in complaints(WHO + rule(action=f"{{action: place, entity: Y2, at: {written}}}"))[0]

    @pytest.mark.parametrize("written", ["{draw: who}", "{spot: centre}", "{entity: B1}", "{relative_to: who}"])
    @pytest.mark.parametrize(
        "action",
        [
            "{action: place, entity: Y2, at: start, facing: {towards: %s}}",
            "{action: place, entity: Y2, at: {nearest_free: corners, to: %s}}",
            "{action: set_spot, spot: middle_blue, to: %s}",
        ],
    )
    def test_where_a_name_is_expected_it_stands_alone(self, action, written):
        name = written.strip("{}").partition(": ")[2]
        assert complaints(WHO + rule(action=action % written))[0].endswith(f"its name stands alone: {name}")
        assert loaded(WHO + rule(action=action % name))

    @pytest.mark.parametrize("name", ["who", "any", "crate", "centre"])
    def test_what_one_can_look_at(self, name):
        facing = "{action: place, entity: Y2, at: start, facing: %s}"
        assert complaints(WHO + rule(action=facing % name))[0].endswith(f"to look at it is written {{towards: {name}}}")
        assert loaded(WHO + rule(action=facing % f"{{towards: {name}}}"))
        assert "to look at" not in complaints(WHO + rule(action=facing % "post"))[0]
        assert "to look at" not in complaints(WHO + rule(action=facing % "hot"))[0]

    def test_a_name_like_start_is_not_taken_for_it(self):
        draw = "draws: {target: {values: [B1, Y1]}}\n"
        assert "'start'" not in complaints(draw + rule(action="{action: place, entity: ball, at: target}"))[0]
        assert "did you mean 'start'?" in complaints(rule(action="{action: place, entity: ball, at: strat}"))[0]

    def test_a_misspelt_word_stays_one(self):
        text = complaints(WHO + rule(action="{action: place, entity: Y2, at: {nearest_fre: corners}}"))[0]
        assert text.endswith("; did you mean 'nearest_free'?")

    @pytest.mark.parametrize("name", ["who", "B1"])
    def test_a_robot_is_no_spot(self, name):
        text = complaints(WHO + rule(action=f"{{action: place, entity: Y2, at: {{spot: {name}}}}}"))[0]
        assert "'B1' is a robot; expected a spot; beside what moves is {relative_to: NAME, offset_m: [0.1, 0]}" in text

    def test_one_of_a_group_of_spots(self):
        text = complaints(WHO + rule(action="{action: place, entity: Y2, at: {spot: corners}}"))[0]
        assert text.endswith(
            "'corners' is a group; name one spot; one of them by chance is written {choice: [corners]}"
        )
        assert loaded(WHO + rule(action="{action: place, entity: Y2, at: {choice: [corners]}}"))

    def test_of_a_spot_that_is_set_no_chance_is_told(self):
        text = complaints(WHO + rule(action="{action: set_spot, spot: corners, to: ball}"))[0]
        assert text.endswith("'corners' is a group; name one spot")


def _it(written: str) -> str:
    return "the one drawn" if "who" in written else "it"


def test_a_layout_that_a_draw_decides():
    which = "draws: {which: {values: [a, b]}}\n" + "placements: {a: [%s], b: [%s]}\n" % (
        ("{entity: ball, at: start}",) * 2
    )
    text = complaints(which + rule(action="{action: place, layout: which}"))[0]
    assert text.endswith(
        "unknown layout 'which', which is a draw; there are a, b; the one drawn is written layout: {draw: which}"
    )
    assert loaded(which + rule(action="{action: place, layout: {draw: which}}"))


@pytest.mark.parametrize("key", ["equals", "at_least", "at_most"])
def test_a_score_is_compared_with_another_score(key):
    text = complaints(rule(rest=ASKED % f"counter, counter: yellow, {key}: blue"))[0]
    assert text.endswith(", found 'blue'; its value is written {counter: blue}")
    assert loaded(rule(rest=ASKED % f"counter, counter: yellow, {key}: {{counter: blue}}"))


@pytest.mark.parametrize(
    ("trigger", "told"),
    [
        ("{trigger: GOAL}", "; an event is heard by {trigger: event, event: GOAL}"),
        ("{trigger: enters, entity: this, zone: pitch}",
         "unknown entity 'this'; in a rule with repeat_for the name for which it is repeated is written {param: this}"),
        ("{trigger: enters, entity: Y1 Y2, zone: pitch}",
         "; in a name no blank stands: Y1_Y2; several names have commas between them: Y1, Y2"),
        ("{trigger: enters, entity: robot 1, zone: pitch}", "at most 64; in a name no blank stands: robot_1"),
        ("{trigger: enters, entity: 'Y1, Y2', zone: pitch}", "; several names are a list: [Y1, Y2]"),
        ("{trigger: ENTERS, entity: Y1, zone: pitch}", "; did you mean 'enters'?"),
    ],
)  # fmt: skip
def test_what_is_heard_and_of_whom(trigger, told):
    assert complaints(rule(trigger))[0].endswith(told)


@pytest.mark.parametrize(
    ("action", "told"),
    [
        ("{action: GOAL}", "; an event is announced by {action: emit, event: GOAL}"),
        ("{action: SCORE, entrant: yellow}", "; did you mean 'score'?"),
        ("{action: set, counter: n, to: 3}",
         ("; a flag is set by set_flag, a spot by set_spot, a draw by draw with as; a counter changes by {action: count, "
         "counter: NAME, by: 1}, or is set: {action: count, counter: NAME, to: 0}")),
    ],
)  # fmt: skip
def test_what_is_announced_and_set(action, told):
    assert complaints("counters: {n: {}}\n" + rule(action=action))[0].endswith(told)


def test_how_far_a_lidar_sees_is_not_where_it_begins_to():
    lidar = "robots: {Y1: {devices: {lidar: {device: lidar, range_m: 1}}}}\n"
    assert complaints(lidar + rule())[0].endswith("; it is called 'max_range_m' here")


CRATES = "balls: {ball: {start_m: [0.5, 0]}}\nobstacles:\n" + "".join(
    f"  crate_{n}: {{shape: box, centre_m: [{n / 5 - 0.4:.1f}, 0.05], size_m: [0.1, 0.1], movable: true}}\n" for n in (1, 2, 3)
)  # fmt: skip


def test_the_plural_of_several_names_is_a_group():
    text = complaints(CRATES + rule(action="{action: place, entity: crates, at: start}"))[0]
    assert text.endswith(
        "unknown entity 'crates'; several under one name are a group: groups: {crates: [crate_1, crate_2, crate_3]}"
    )
    text = complaints(CRATES + "counters: {n: {per: Crates}}\n" + rule())[0]
    assert text.endswith("groups: {Crates: [crate_1, crate_2, crate_3]}")
    assert loaded(CRATES + "groups: {Crates: [crate_1, crate_2, crate_3]}\ncounters: {n: {per: Crates}}\n" + rule())


def test_where_only_one_is_meant_the_plural_is_a_slip_of_the_pen():
    text = complaints(
        CRATES + rule("{trigger: time_reached, at_s: 1}", "{action: place, entity: ball, at: {relative_to: crates}}")
    )[0]
    assert "did you mean 'crate_3'?" in text
    assert "group" not in text


def test_a_packet_that_still_lists_a_robot_is_written_anew_and_not_the_whole_kit():
    head = "schema_version: 1\nid: a\ntitle: A\nextends: soccersim_2021\n"
    body = "robots: {B1: null}\nentrants: {blue: {robots: {B1: null}}}\n"
    text = next(text for text in complaints(body + rule(), head=head) if "packet_lists" in text)
    assert text.endswith("; write kits.legacy_2021.packet_lists anew without it")


def test_where_there_is_no_group_yet_it_is_told_all_the_same():
    rooms = "".join(f"  room_{n}: {{shape: circle, centre_m: [0, {n}.0e-1], radius_m: 0.1}}\n" for n in (1, 2))
    body = "zones:\n" + rooms + rule("{trigger: enters, entity: Y1, zone: Rooms}")
    (text,) = complaints(body, head="schema_version: 1\nid: a\ntitle: A\nextends: empty_field\n")
    assert text.endswith("; several under one name are a group: groups: {Rooms: [room_1, room_2]}")
