"""Numbers that are computed when they are needed: how fast a ball is kicked, and how much is counted."""

import pytest

from rcj_challenges.scenario.errors import ScenarioError
from rcj_challenges.scenario.load import load_text
from tests.referee.building import kick, kicking, touch

TO_THE_RIGHT = "{towards: {point: [0.4, 0]}, speed_mps: %s}"
HEAD = "schema_version: 2\nid: it\ntitle: It\nextends: soccersim_v2\n"


def speed(play) -> float:
    vx, vy = kick(play)
    assert vy == 0
    return vx


class TestKicksAsFastAsADrawSays:
    DRAWS = "draws: {power: {values: [0.5, 1.25]}}\n"

    def play(self, stage, **more):
        return stage(self.DRAWS, kicking("{point: [0, 0]}", TO_THE_RIGHT % "{draw: power}"), **more)

    @pytest.mark.parametrize("decided", [0.5, 1.25])
    def test_it_is_what_was_drawn(self, stage, decided):
        assert speed(self.play(stage, draws={"power": decided})) == pytest.approx(decided)

    @pytest.mark.parametrize(
        ("values", "said"),
        [
            ("[0.5, 3.5]", "expected a number from 0.001 to 3, found 3.5"),
            ("[0, 1]", "expected a number from 0.001 to 3, found 0"),
            ("[fast, 1]", "expected a number from 0.001 to 3, found 'fast'"),
        ],
    )
    def test_a_draw_of_anything_else_is_refused(self, values, said):
        rule = (
            "rules: {go: {triggers: [{trigger: half_started}], actions: [{action: place, entity: ball, at: start, "
            "kick: {towards: {spot: middle_blue}, speed_mps: {draw: power}}}]}}\n"
        )
        with pytest.raises(ScenarioError) as caught:
            load_text(f"{HEAD}draws: {{power: {{values: {values}}}}}\n{rule}", file="it.yaml")
        assert said in str(caught.value)


class TestKicksAsFastAsACounterSays:
    @pytest.mark.parametrize(("counted", "rolls"), [(0.75, 0.75), (3, 3), (3.01, 3), (1000, 3), (0, 0), (-2, 0)])
    def test_more_than_3_is_3_and_at_0_or_less_it_lies_still(self, stage, counted, rolls):
        counter = f"counters: {{power: {{initial: {counted}}}}}\n"
        play = stage(counter, kicking("{point: [0, 0]}", TO_THE_RIGHT % "{counter: power}"))
        assert speed(play) == pytest.approx(rolls)

    def test_a_counter_of_each_is_its_own(self, stage):
        rule = """
        counters: {power: {per: yellow, initial: 1}}
        rules:
          second: {triggers: [{trigger: half_started}], actions: [{action: count, counter: power, entity: Y2, to: 2}]}
          shot:
            for_each: yellow
            triggers: [{trigger: touches, entity: each, other: ball}]
            actions:
              - action: place
                entity: ball
                at: {relative_to: ball}
                kick: {towards: {point: [0, 0.7]}, speed_mps: {counter: power, entity: each}}
        """
        for robot, rolls in (("Y1", 1), ("Y2", 2)):
            play = stage(rule)
            touch(play, robot, "ball")
            ((_, placement),) = [one for one in play.placements if one[1].vy_mps]
            assert placement.vy_mps == pytest.approx(rolls)


class TestComputedCounts:
    def counted(self, stage, change, more=""):
        play = stage(
            "counters: {sum: {initial: 2}, laps: {initial: 4}}\nflags: {bonus: {initial: true}}\n" + more,
            f"rules: {{it: {{triggers: [{{trigger: time_reached, at_s: 3.2}}], actions: [{{action: count, counter: sum, {change}}}]}}}}",
        )
        play.play(101)
        return play.referee.counters["sum"]

    def test_to_a_sum_with_weights(self, stage):
        change = "to: {sum: [1, {counter: laps, times: 0.5}, {flag: bonus, times: 10}, {sum: [{word: time_s, round: down}], times: -1}]}"
        assert self.counted(stage, change) == 1 + 2 + 10 - 3

    def test_by_a_sum_of_which_its_own_old_value_may_be_a_part(self, stage):
        assert self.counted(stage, "by: {sum: [{counter: sum, times: 0.5}, -0.1]}") == 2.9

    def test_first_to_then_by(self, stage):
        assert self.counted(stage, "to: {sum: [1, {counter: laps}]}") == 5

    def test_the_sum_of_many_kept_ones(self, stage):
        more = "draws: {times: {values: [3]}}\n"
        assert self.counted(stage, "to: {sum: [{draw: times, times: 2}, {distance: [B1, B2], times: 10}]}", more) == 14
