"""Sequences kept per entity: each member of a group makes its own steps, and fields select the owner."""

import pytest

from tests.referee.building import A_LOW, ASKING, B_LOW, C_LOW, A, B, C, fail, touch, walk

RACE = """
zones:
  a: {shape: circle, centre_m: [-0.4, 0], radius_m: 0.1}
  b: {shape: circle, centre_m: [0, 0], radius_m: 0.1}
  c: {shape: circle, centre_m: [0.4, 0], radius_m: 0.1}
gates:
  high: {from_m: [-0.1, 0.3], to_m: [0.1, 0.3]}
sequences:
  way: {per: %s, steps: %s}
"""
HEARD = """
rules:
  done:
    for_each: robots
    triggers: [{trigger: sequence_completed, sequence: way, entity: each}]
    actions: [{action: score, entrant: each}, {action: emit, event: DONE,
               payload: {who: {word: robot_name}, took: {word: measured}}}]
  wrong:
    for_each: robots
    triggers: [{trigger: sequence_broken, sequence: way, entity: each}]
    actions: [{action: emit, event: WRONG, payload: {who: {word: robot_name}}}]
"""
PLAIN = RACE % ("robots", "[a, b, c]")
BREAKS = RACE % ("robots", "[a, b, c], wrong_step: break")


def said(play):
    """Return the events, each with its robot."""
    return [(event.name, event.payload["who"]) for event in play.events]


class TestEachMakesItsOwnSteps:
    def test_steps_of_one_are_no_steps_of_another(self, stage):
        play = stage(PLAIN, HEARD)
        walk(play, "Y1", A, B)
        walk(play, "B1", C)
        assert said(play) == []
        walk(play, "Y1", C)
        assert said(play) == [("DONE", "Y1")]
        assert play.referee.scores == {"blue": 0, "yellow": 1}

    def test_several_can_be_complete_in_one_tick_and_each_is_reported(self, stage):
        play = stage(PLAIN, HEARD)
        for place in (A, B, C):
            for robot in ("Y2", "B1"):
                play.place(robot, *place)
            play.play()
        assert said(play) == [("DONE", "B1"), ("DONE", "Y2")]
        assert play.referee.scores == {"blue": 1, "yellow": 1}

    def test_each_has_its_own_time(self, stage):
        play = stage(PLAIN, HEARD)
        for robot, wait in (("Y1", 10), ("Y2", 20)):
            for place in (A, B):
                play.place(robot, *place)
                play.play(wait)
            play.place(robot, *C)
            play.play()
        assert [event.payload["took"] for event in play.events] == [0.64, 1.28]

    def test_a_wrong_step_breaks_that_of_its_robot_only(self, stage):
        play = stage(BREAKS, HEARD)
        walk(play, "Y1", A, B)
        walk(play, "B1", A, A_LOW, C_LOW, C)
        assert said(play) == [("WRONG", "B1")]
        walk(play, "Y1", C)
        assert said(play) == [("WRONG", "B1"), ("DONE", "Y1")]

    @pytest.mark.parametrize(("more", "done"), [("begins_anew", []), ("goes_on", [("DONE", "Y1")])])
    def test_a_placed_robot_loses_or_keeps_its_own_steps(self, stage, more, done):
        back = (
            "rules: {back: {for_each: robots, triggers: [{trigger: tips_over, entity: each}], "
            "actions: [{action: place, entity: each, at: {point: [0, -0.6]}}]}}"
        )
        play = stage(RACE % ("robots", f"[a, b, c], when_placed: {more}"), HEARD, back)
        for robot in ("Y1", "B1"):
            walk(play, robot, A, B)
        play.tip("Y1")
        play.play(2)
        walk(play, "Y1", C)
        walk(play, "B1", C)
        assert said(play) == [*done, ("DONE", "B1")]


WHOSE = """
rules:
  done:
    triggers: [{trigger: sequence_completed, sequence: way%s}]
    actions: [{action: emit, event: DONE, payload: {who: {word: robot_name}}}]
"""


class TestTriggersSequenceCompletedAndBroken:
    @pytest.mark.parametrize(
        ("whose", "heard"),
        [
            ("", ["B1", "Y1", "Y2"]),
            (", entity: yellow", ["Y1", "Y2"]),
            (", entity: Y2", ["Y2"]),
            (", entity: [B1, Y2]", ["B1", "Y2"]),
        ],
    )
    def test_entity_selects_the_sequence_and_without_it_any_matches(self, stage, whose, heard):
        completed, broken = stage(PLAIN, WHOSE % whose), stage(BREAKS, (WHOSE % whose).replace("completed", "broken"))
        for robot in ("B1", "Y1", "Y2"):
            walk(completed, robot, A, B, C)
            walk(broken, robot, A, A_LOW, C_LOW, C)
        for play in (completed, broken):
            assert [who for _, who in said(play)] == heard

    def test_a_rule_over_zones_or_gates_reacts_to_sequences_of_all_robots(self, stage):
        over = "groups: {places: [a, c]}\n" + (WHOSE % "").replace("done:", "done:\n    for_each: places")
        play = stage(PLAIN, over)
        walk(play, "Y1", A, B, C)
        assert said(play) == [("DONE", "Y1"), ("DONE", "Y1")]


class TestConditionSequenceAt:
    @pytest.mark.parametrize(
        ("whose", "answers"),
        [
            ("", [False, True, True]),
            (", negate: true", [True, False, False]),
            (", entity: Y1", [False, True, True]),
            (", entity: B2", [False, False, True]),
            (", of: {at_least: 2}", [False, False, True]),
            (", of: all", [False, False, False]),
            (", of: none", [True, False, False]),
            (", of: all, entity: [Y1, B2]", [False, False, True]),
            (", of: any, entity: blue", [False, False, True]),
        ],
    )
    def test_step_of_the_selected_sequence_is_tested(self, stage, ask, whose, answers):
        play = stage(PLAIN, ASKING % f"{{sequence: way, equals: a{whose}}}")
        found = [ask(play)]
        for robot in ("Y1", "B2"):
            play.place(robot, *A)
            found.append(ask(play))
        assert found == answers

    def test_each_is_the_current_one_and_other_the_one_touched(self, stage):
        meets = (
            "rules: {meets: {for_each: yellow, triggers: [{trigger: touches, entity: each, other: blue}], conditions: "
            "[{sequence: way, entity: each, equals: a}, {sequence: way, "
            "entity: other, equals: b}], actions: [{action: emit, event: MET}]}}"
        )
        play = stage(PLAIN, meets)
        walk(play, "Y1", A)
        walk(play, "B1", A, B)
        for one, other in (("Y2", "B1"), ("Y1", "B2"), ("Y1", "B1")):
            assert play.names() == []
            touch(play, one, other)
        assert play.names() == ["MET"]


class TestActionSequence:
    @pytest.mark.parametrize(("whose", "done"), [("", ["Y1"]), (", entity: Y1", ["B1"]), (", entity: robots", [])])
    def test_that_of_the_member_restarts_or_those_that_are_named(self, stage, whose, done):
        restarts = (
            "rules: {restarts: {for_each: blue, triggers: [{trigger: program_fault, robot: each}], "
            f"actions: [{{action: reset, sequence: way{whose}}}]}}}}"
        )
        play = stage(PLAIN, HEARD, restarts)
        for robot in ("Y1", "B1"):
            walk(play, robot, A, B, B_LOW)
        fail(play, "B1")
        for robot in ("Y1", "B1"):
            walk(play, robot, C_LOW, C)
        assert [who for _, who in said(play)] == done


class TestPhasesInWhichASequenceIsFollowed:
    def test_also_those_of_a_rule_that_asks_for_it_within_conditions_within_conditions(self, stage):
        deep = "{sequence: way, equals: a}"
        for _ in range(3):
            deep = f"{{any_of: [[{deep}]]}}"
        pause = (
            "phases: {play: {}, pause: {lasts_s: 1, next: play}}\n"
            "rules: {fell: {triggers: [{trigger: tips_over, entity: B2}], actions: [{action: set_phase, phase: pause}]},"
            f" asks: {{phases: [pause], triggers: [{{trigger: half_ended}}], conditions: [{deep}], "
            "actions: [{action: emit, event: ASKED}]}}"
        )
        play = stage(PLAIN, HEARD, pause)
        walk(play, "Y1", A, B)
        play.tip("B2")
        play.play(40)
        walk(play, "Y1", C)
        assert said(play) == [("DONE", "Y1")]
