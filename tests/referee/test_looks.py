"""Conditions that ask which way a robot looks, and those that ask for one of several."""

import math

import pytest

from tests.referee.building import ASKING, fail, hears, on_fault, place, rule


class TestConditionLooks:
    @pytest.mark.parametrize(("yaw", "holds"), [(0.0, True), (0.19, True), (-0.19, True), (0.21, False), (3.1, False)])
    def test_towards_an_entity_it_may_be_off_by_so_much(self, stage, ask, yaw, holds):
        play = stage(ASKING % "{entity: Y1, looks: ball}")
        play.place("Y1", -0.4, 0.0, yaw)
        assert ask(play) is holds

    @pytest.mark.parametrize("towards", ["B2", "middle_blue", "[0, 0.5]"])
    def test_towards_a_robot_a_spot_or_a_point(self, stage, ask, towards):
        play = stage(ASKING % f"{{entity: Y1, looks: {towards}, within_rad: 0.1}}")
        play.place("Y1", 0.0, -0.2, math.pi / 2)
        play.place("B2", 0.0, 0.4)
        assert ask(play)
        play.place("Y1", 0.0, -0.2, -math.pi / 2)
        assert not ask(play)

    @pytest.mark.parametrize(("decided", "holds"), [("middle_blue", True), ("B2", False), ("Y1", False)])
    def test_towards_what_a_draw_has_decided_and_never_towards_itself(self, stage, ask, decided, holds):
        draws = "draws: {goal: {values: [middle_blue, B2, Y1]}}"
        play = stage(ASKING % "{entity: Y1, looks: goal}", draws, draws={"goal": decided})
        play.place("Y1", 0.0, -0.2, math.pi / 2)
        play.place("B2", 0.4, -0.2)
        assert ask(play) is holds

    @pytest.mark.parametrize(("yaw", "holds"), [(3.1, True), (-3.1, True), (2.9, False), (0.0, False)])
    def test_in_a_direction_also_where_angles_turn_over(self, stage, ask, yaw, holds):
        play = stage(ASKING % "{entity: Y1, looks: 3.14159, within_rad: 0.2}")
        play.place("Y1", 0.0, 0.0, yaw)
        assert ask(play) is holds

    @pytest.mark.parametrize("front", ["+x", "-x"])
    def test_direction_is_the_yaw_whichever_end_is_shown_as_the_front(self, stage, ask, front):
        kit = f"kits: {{v2: {{looks_along: '{front}'}}}}"
        play = stage(ASKING % "{entity: Y1, looks: 0}", kit)
        play.place("Y1", 0.0, 0.0, 0.0)
        assert ask(play)

    def test_no_robot_looks_at_itself(self, stage, ask):
        for robots in ("Y1", "yellow"):
            play = stage(ASKING % f"{{entity: {robots}, looks: Y1}}")
            play.place("Y1", -0.4, 0.0, 0.0)
            assert not ask(play)

    def test_off_the_field_no_robot_looks_or_is_looked_at(self, stage, ask):
        for off in ("Y1", "ball"):
            gone = on_fault("B2", f"{{action: remove, entity: {off}}}")
            play = stage(ASKING % "{entity: Y1, looks: ball}", gone)
            play.place("Y1", -0.4, 0.0, 0.0)
            assert ask(play)
            fail(play, "B2")
            assert not ask(play)

    def test_held_for_a_time_it_is_about_the_robot_and_starts_again_where_that_is_put_elsewhere(self, stage):
        stares = rule(
            "trigger: holds, conditions: [{entity: Y1, looks: 1.57}], for_s: 0.32",
            "{action: emit, event: STARES, payload: {who: {word: robot_name}}}",
            name="stares",
        )
        play = stage(stares, on_fault("B1", "{action: place, entity: Y1, at: {point: [-0.4, -0.4]}}"))
        play.play_until(5)
        play.fail("B1")
        play.play_until(14)
        assert play.events == []
        play.play_until(17)
        assert [event.payload for event in play.events] == [{"who": "Y1"}]

    @pytest.mark.parametrize(("by", "names"), [("a rule", []), ("a robot", ["TOLD"])])
    def test_what_a_rule_puts_before_its_eyes_has_not_come_there(self, stage, by, names):
        sees = hears("holds, conditions: [{entity: Y1, looks: ball}]")
        play = stage(sees, on_fault("B1", "{action: place, entity: ball, at: {point: [-0.4, 0.2]}}"))
        play.play_until(5)
        if by == "a rule":
            play.fail("B1")
        else:
            play.place("ball", -0.4, 0.2)
        play.play_until(20)
        assert play.pose("ball")[:2] == pytest.approx((-0.4, 0.2))
        assert play.names() == names


TWO = "{entity: ball, in: left}, {entity: Y1, in: right}"
LAST = "{entity: B2, in: right}"
EITHER, BOTH = f"any_of: [{TWO}]", f"any_of: [[{TWO}]]"


class TestConditionAnyOf:
    @pytest.mark.parametrize(("ball", "robot", "other"), [(b, y, o) for b in (0, 1) for y in (0, 1) for o in (0, 1)])
    @pytest.mark.parametrize(
        ("condition", "holds"),
        [
            (f"{{{EITHER}}}", lambda ball, robot, _: ball or robot),
            (f"{{{EITHER}, negate: true}}", lambda ball, robot, _: not (ball or robot)),
            (f"{{{BOTH}}}", lambda ball, robot, _: ball and robot),
            (f"{{{BOTH}, negate: true}}", lambda ball, robot, _: not (ball and robot)),
            (
                f"{{any_of: [[{TWO}], {LAST}]}}",
                lambda ball, robot, other: (ball and robot) or other,
            ),
            (
                f"{{{EITHER}}}, {LAST}",
                lambda ball, robot, other: (ball or robot) and other,
            ),
        ],
    )
    def test_one_or_all_must_hold_also_one_within_the_other(self, stage, ask, condition, holds, ball, robot, other):
        play = stage(ASKING % condition)
        play.place("ball", -0.3 * ball, 0.0)
        play.place("Y1", 0.4 if robot else -0.4, -0.4)
        play.place("B2", 0.4 if other else -0.4, 0.4)
        assert ask(play) is bool(holds(ball, robot, other))

    def test_a_sequence_that_only_it_asks_for_is_followed(self, stage, ask):
        play = stage(
            "sequences: {way: {entity: ball, steps: [left, right]}}",
            ASKING % "{any_of: [{sequence: way, equals: left}]}",
        )
        assert not ask(play)
        place(play, "ball", -0.3, 0.0)
        assert ask(play)
