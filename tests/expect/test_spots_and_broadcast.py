"""Tests of scenarios decide where chance sets spots, and compare what the referee sends to programs."""

import pytest

from rcj_challenges.expect.runner import run_test
from tests.scenario.writing import complaints, loaded

HIDING = """spots: {treasure: {x_m: 0, y_m: 0}, mark: {x_m: 0.1, y_m: 0}}
draws: {way: {values: [left, right]}}
zones: {box: {shape: rect, x_min_m: 0.1, x_max_m: 0.3, y_min_m: -0.4, y_max_m: 0.2}}
broadcast:
  every_ticks: 10
  fields: {near_m: {distance: [Y1, treasure]}, half: {word: halftime}, ball: {position_of: ball}}
  only: {Y1: {way: {draw: way}}, blue: {hot: true}}
rules:
  hide:
    triggers: [{trigger: half_started}]
    actions: [{action: set_spot, spot: treasure, to: {uniform_in: box}}]
  again:
    triggers: [{trigger: time_reached, at_s: 2, every_s: 2}]
    actions: [{action: set_spot, spot: treasure, to: {on_line: [[0, 0.1], [0, 0.5]]}, mirror: {axis: y}}]
  mark:
    triggers: [{trigger: time_reached, at_s: 1}]
    actions: [{action: set_spot, spot: mark, to: treasure}]
"""


def with_test(test, lasts_s=1, keyframe="at_s: 0.5", scenario=HIDING):
    return f"{scenario}expect: {{it: {{keyframes: [{{{keyframe}}}], lasts_s: {lasts_s}, {test}}}}}\n"


def differences(test, lasts_s=1, keyframe="at_s: 0.5"):
    return list(run_test(loaded(with_test(test, lasts_s, keyframe)), "it").differences)


class TestExpectSpots:
    def test_chance_sets_the_spot_where_the_test_has_decided(self):
        assert differences("spots: {treasure: [0.2, -0.3]}, poses: {treasure: [0.2, -0.3]}") == []
        assert differences("poses: {treasure: [0.2, -0.3]}") != []

    def test_several_places_come_one_after_the_other_and_then_chance_decides_again(self):
        # A place is where the spot is in the end, after the mirror.
        places = "spots: {treasure: [[0.2, 0], [0, -0.4], [0, -0.2]]}"
        found = [
            differences(f"{places}, poses: {{treasure: [0, {y}]}}", s) for s, y in ((3, -0.4), (5, -0.2), (7, -0.2))
        ]
        assert [any("expected" in line for line in lines) for lines in found] == [False, False, True]

    def test_where_chance_sets_it_less_often_that_is_noted_beside_what_fails(self):
        lines = differences("spots: {treasure: [[0.2, 0], [0, -0.4], [0, -0.2]]}, score: {yellow: 1}", 3)
        assert lines[-1] == "note: chance set treasure 2 times; spots decides 3 places"
        assert differences("spots: {treasure: [[0.2, 0], [0, -0.4]]}, score: {yellow: 1}")[-1].startswith(
            "note: chance set treasure once;"
        )

    @pytest.mark.parametrize(
        ("spots", "expected"),
        [
            ("{ball: [0, 0]}", "wrong-kind expect.it.spots.ball"),
            ("{treasur: [0, 0]}", "unknown-name expect.it.spots.treasur -> treasure"),
            ("{treasure: centre}", "wrong-value expect.it.spots.treasure"),
        ],
    )
    def test_only_a_spot_can_be_decided(self, spots, expected):
        assert complaints(with_test(f"spots: {spots}")) == [expected]


class TestExpectBroadcast:
    @pytest.mark.parametrize(
        ("told", "lines"),
        [
            ("{Y1: {near_m: 0.5, way: left}, B2: {hot: true}}", []),
            ("{robots: {half: 1}}", []),
            ("{Y1: {ball: [0.1, 0.2]}, B3: {ball: [0.1, 0.2, 0]}}", []),
            (
                "{Y1: {near_m: 0.4, way: right}}",
                ["near_m told to Y1: expected 0.4, is 0.5", "way told to Y1: expected right, is left"],
            ),
            (
                "{Y1: {ball: [0.1, 0.25]}}",
                [
                    "ball told to Y1: expected [0.1, 0.25], is [0.1, 0.2, 0]; up to 0.001 off is allowed, more by tolerance_m"
                ],
            ),
            ("{blue: {hot: false}}", [f"hot told to B{n}: expected false, is true" for n in (1, 2, 3)]),
            (
                "{Y1: {half: [1, 2]}}",
                ["half told to Y1: expected [1, 2], is nothing; up to 0.001 off is allowed, more by tolerance_m"],
            ),
            ("{Y1: {ball: 3}}", ["ball told to Y1: expected 3, is nothing"]),
        ],
    )
    def test_the_last_broadcast_to_each_is_compared_key_by_key(self, told, lines):
        test = f"spots: {{treasure: [0.2, 0.1]}}, draws: {{way: left}}, told: {told}"
        assert differences(test, keyframe="at_s: 0.5, place: {Y1: [0.2, -0.4], ball: [0.1, 0.2]}") == lines

    def test_between_two_broadcasts_the_last_one_counts(self):
        # Ten ticks are 0.32 s: what happens at 0.7 s is sent at 0.96 s.
        test = "told: {Y1: {ball: [0.3, 0.3]}}, spots: {treasure: [0.2, 0]}"
        for lasts_s, count in ((1, 0), (0.9, 1)):
            assert len(differences(test, lasts_s, "at_s: 0.7, place: {ball: [0.3, 0.3]}")) == count

    @pytest.mark.parametrize(
        ("told", "expected"),
        [
            ("{ball: {half: 1}}", "wrong-kind expect.it.told.ball"),
        ],
    )
    def test_only_what_robots_receive_can_be_expected(self, told, expected):
        assert complaints(with_test(f"told: {told}")) == [expected]
