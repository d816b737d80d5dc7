"""The tick contract of what is put somewhere, taken off and sensed then: one test for each sentence, see `test_tick_contract`."""

import pytest

from tests.referee.building import EMIT, IN_MIDDLE, event_ticks, once, place


class TestLine6:
    def test_6_1_the_last_placement_queued_for_an_entity_wins(self, stage):
        play = stage(once(5, *(f"{{action: place, entity: {name}, at: {{point: [{x}, 0.2]}}}}"
                               for name, x in (("B1", 0.1), ("B2", 0.3), ("B1", -0.1)))))  # fmt: skip
        play.play(5)
        assert [placement.entity for _, placement in play.placements] == [1, 0]
        assert play.pose("B1")[0] == pytest.approx(-0.1)

    def test_6_2_all_are_lifted_first_then_set_down_in_order(self, stage):
        play = stage(once(5, "{action: place, entity: B1, at: {point: [-0.4, 0.5]}}",
                          "{action: place, entity: B2, at: {point: [0.4, 0.5]}}"))  # fmt: skip
        play.play(5)
        assert (play.pose("B1")[0], play.pose("B2")[0]) == pytest.approx((-0.4, 0.4))

    def test_6_3_two_robots_never_get_one_spot(self, stage):
        play = stage(once(5, *(f"{{action: place, entity: {name}, at: {{nearest_free: neutral_spots, to: middle_blue}}}}"
                               for name in ("B1", "B2", "Y1"))))  # fmt: skip
        play.play(5)
        assert len({play.pose(name)[:2] for name in ("B1", "B2", "Y1")}) == 3

    def test_6_4_equal_distances_go_by_file_order(self, stage):
        play = stage(
            once(5, "{action: place, entity: ball, at: {nearest_free: [corner_yellow_left, corner_blue_right]}}")
        )
        play.play(5)
        assert play.pose("ball")[:2] == pytest.approx((-0.3, -0.3))

    def test_6_5_each_use_draws_from_a_stream_of_its_own(self, stage):
        line = "{action: place, entity: %s, at: {on_line: [[-0.5, %s], [0.5, %s]]}}"
        ball = line % ("ball", 0, 0)
        alone = stage(once(5, ball), seed=9)
        beside = stage(once(5, line % ("B1", 0.3, 0.3), ball), seed=9)
        elsewhere = stage(once(5, ball, name="other"), seed=9)
        second = stage(once(5, ball), seed=9, half=2)
        for play in (alone, beside, elsewhere, second):
            play.play(5)
        assert alone.pose("ball") == beside.pose("ball")
        assert len({play.pose("ball") for play in (alone, elsewhere, second)}) == 3

    def test_6_6_what_finds_no_room_is_tried_again_without_repeating_events(self, stage):
        play = stage(once(5, EMIT, "{action: place, entity: ball, at: {point: [0, 0.3]}}"))
        place(play, "B1", 0.0, 0.3, ticks=20)
        assert (play.placements, event_ticks(play)) == ([], [5])
        place(play, "B1", 0.5, 0.5)
        assert ([tick for tick, _ in play.placements], event_ticks(play)) == ([21], [5])


class TestLine7:
    def test_7_2_a_placed_entity_stands_on_its_wheels_and_overlaps_nothing(self, stage):
        play = stage(
            "rules: {fell: {triggers: [{trigger: tips_over, entity: B1}], "
            "actions: [{action: place, entity: B1, at: {nearest_free: neutral_spots}}, {action: emit, event: TOLD}]}}"
        )
        play.tip("B1")
        play.play(10)
        play.tip("B1")
        play.play(10)
        assert event_ticks(play) == [1, 11]
        assert play.pose("B1")[:2] != pytest.approx((0.0, 0.0))  # where the ball lies

    def test_7_3_nothing_fires_because_it_was_already_true(self, stage):
        play = stage(
            f"rules: {{came: {{triggers: [{IN_MIDDLE}, {{trigger: displaced, entity: ball, from: [0.5, 0], distance_m: 0.1}}], actions: [{EMIT}]}}}}",
            "balls: {ball: {start_m: [0.5, 0]}}",
            once(5, "{action: place, entity: ball, at: {point: [0, 0]}}"),
        )
        play.play(20)
        assert event_ticks(play) == []

    def test_7_4_the_jump_is_neither_path_nor_enters_nor_leaves_nor_a_crossing(self, stage):
        edges = ("{trigger: enters, entity: ball, zone: middle}", "{trigger: leaves, entity: ball, zone: right}",
                 "{trigger: crosses, entity: ball, gate: halfway}")  # fmt: skip
        play = stage(
            f"rules: {{edge: {{triggers: [{', '.join(edges)}], actions: [{EMIT}]}}, "
            "stuck: {triggers: [{trigger: no_progress, entity: ball, distance_m: 0.3, within_s: 0.32}], "
            "actions: [{action: emit, event: STUCK}]}}",
            "balls: {ball: {start_m: [0.5, 0.2]}}",
            once(5, "{action: place, entity: ball, at: {point: [0, -0.05]}}"),
        )
        play.play(20)
        assert (event_ticks(play), event_ticks(play, "STUCK")) == ([], [16])

    def test_7_5_windows_and_stays_start_again(self, stage):
        play = stage(
            "rules: {stuck: {triggers: [{trigger: no_progress, entity: ball, distance_m: 0.3, within_s: 0.32}], "
            "actions: [{action: emit, event: STUCK}]}, "
            "stays: {triggers: [{trigger: stays_in, entity: ball, zone: right, limit_s: 0.32}], actions: [{action: emit, event: STAYS}]}}",
            "balls: {ball: {start_m: [0.5, 0.2]}}",
            once(5, "{action: place, entity: ball, at: {point: [0.4, 0.2]}}"),
        )
        play.play(30)
        assert (event_ticks(play, "STUCK"), event_ticks(play, "STAYS")) == ([16], [16])


class TestLine8:
    def test_8_3_a_removed_robot_is_invisible_to_rules_and_its_place_is_free(self, stage):
        play = stage(
            "rules: {seen: {for_each: robots, triggers: [{trigger: leaves, entity: each, zone: pitch}], "
            "actions: [{action: emit, event: SEEN}]}}",
            once(5, "{action: remove, entity: B1}", "{action: place, entity: Y1, at: {point: [0.4, 0.5]}}"),
        )
        play.play(10)
        assert event_ticks(play, "SEEN") == []
        assert play.pose("Y1")[:2] == pytest.approx((0.4, 0.5))

    def test_8_5_any_place_brings_it_back(self, stage):
        play = stage(
            once(5, "{action: remove, entity: B1, for_s: 60}"),
            once(9, "{action: place, entity: B1, at: start}", name="back"),
        )
        play.play(10)
        assert [(tick, placed.parked) for tick, placed in play.placements] == [(5, True), (9, False)]


class TestLine9:
    def test_9_2_flag_and_broadcast_are_those_after_the_actions(self, stage):
        play = stage(
            "phases: {pause: {waiting_for_kickoff: true, lasts_s: 0.096}}\n"
            "broadcast: {fields: {phase: {word: phase}, ball: {position_of: ball}}}",
            once(5, "{action: set_phase, phase: pause}", "{action: place, entity: ball, at: {point: [0.25, 0]}}"),
        )
        outputs = [play.play() for _ in range(9)]
        assert [output.waiting_for_kickoff for output in outputs] == [False] * 4 + [True] * 3 + [False] * 2
        assert outputs[4].broadcast == {"phase": "pause", "ball": [0.25, 0.0, 0.0]}
