"""Kicks: a ball that is put somewhere sets off from there."""

import math

import pytest

from tests.referee.building import kick, kicking, place


class TestKick:
    @pytest.mark.parametrize(
        ("towards", "way"),
        [
            ("{spot: middle_blue}", (0, 1)),
            ("{relative_to: B1}", (0.4, 0.5)),
            ("{relative_to: ball, offset_m: [-0.1, 0]}", (-1, 0)),
            ("{relative_to: B1, offset_m: [0, -0.5]}", (1, 0)),
            ("{nearest_free: [middle_yellow], to: B1}", (0, -1)),
            ("{choice: [[0.3, 0.3]]}", (1, 1)),
        ],
    )
    def test_it_is_aimed_at_any_word_of_at(self, stage, towards, way):
        vx, vy = kick(stage(kicking("{point: [0, 0]}", f"{{towards: {towards}, speed_mps: 0.5}}")))
        length = math.hypot(*way)
        assert (vx, vy) == pytest.approx((0.5 * way[0] / length, 0.5 * way[1] / length), abs=1e-6)

    @pytest.mark.parametrize("towards", ["{point: [0.3, -0.4]}", "{relative_to: ball}"])
    def test_a_ball_that_is_where_it_is_aimed_at_lies_still(self, stage, towards):
        assert kick(stage(kicking("{point: [0.3, -0.4]}", f"{{towards: {towards}, speed_mps: 0.5}}"))) == (0.0, 0.0)

    def test_a_random_aim_is_drawn_each_time_and_lies_on_its_line(self, stage):
        play = stage(kicking("{point: [0, 0]}", "{towards: {on_line: [[-0.3, 0.6], [0.3, 0.6]]}, speed_mps: 1}"))
        aims = [0.6 * vx / vy for vx, vy in (kick(play) for _ in range(60))]
        assert all(abs(x) <= 0.3 + 1e-6 for x in aims)
        assert min(aims) < -0.2
        assert max(aims) > 0.2

    def test_of_two_speeds_every_one_between_is_drawn(self, stage):
        play = stage(kicking("{point: [0, 0]}", "{towards: {point: [0, 0.5]}, speed_mps: [0.4, 0.8]}"))
        speeds = [kick(play)[1] for _ in range(60)]
        assert all(0.4 <= speed <= 0.8 for speed in speeds)
        assert min(speeds) < 0.5
        assert max(speeds) > 0.7

    def test_with_a_kick_chance_puts_things_where_it_did_without(self, stage):
        line = "{on_line: [[-0.3, 0], [0.3, 0]]}"
        aimed = stage(kicking(line, "{towards: {on_line: [[-0.3, 0.6], [0.3, 0.6]]}, speed_mps: 1}"))
        still = stage(kicking(line, "null"))
        for play in (aimed, still):
            [kick(play) for _ in range(5)]
        assert [(p.x_m, p.y_m) for _, p in aimed.placements] == [(p.x_m, p.y_m) for _, p in still.placements]

    @pytest.mark.parametrize(("axis", "way"), [("x", (-1, 1)), ("y", (1, -1)), ("both", (-1, -1))])
    def test_a_mirror_turns_the_way_over_with_the_place(self, stage, axis, way):
        kick_there = "{towards: {point: [0.4, 0.5]}, speed_mps: 1}"
        vx, vy = kick(stage(kicking("{point: [0.1, 0.2]}", kick_there, f", mirror: {{axis: {axis}}}")))
        assert (vx, vy) == pytest.approx((way[0] / math.sqrt(2), way[1] / math.sqrt(2)))

    def test_a_layout_kicks_too_and_its_mirror_counts(self, stage):
        play = stage("""
        placements:
          shot: [{entity: ball, at: {point: [0, 0.1]}, kick: {towards: {point: [0, 0.8]}, speed_mps: 0.6}}]
        rules:
          kick_off:
            triggers: [{trigger: program_fault, robot: Y1}]
            actions: [{action: place, layout: shot, mirror: {axis: y}}]
        """)
        assert kick(play) == pytest.approx((0.0, -0.6))

    def test_with_nothing_to_aim_at_it_waits_as_without_room(self, stage):
        play = stage(
            "spots: {only: {x_m: 0.5, y_m: 0}}",
            kicking("{point: [0, 0.3]}", "{towards: {nearest_free: [only]}, speed_mps: 1}"),
        )
        play.place("B1", 0.5, 0.0)
        play.fail("Y1")
        play.play(3)
        assert play.placements == []
        place(play, "B1", 0.4, 0.5, ticks=2)
        assert len(play.placements) == 1
