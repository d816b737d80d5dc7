"""How far something has driven or rolled in the half: in conditions and as a value, counted and paid."""

import pytest

from tests.referee.building import ASKING, at_tick_10, emitting, once, payload, walk

TOLD = emitting("{y1: {way: Y1}, ball: {way: ball}}")


class TestValueWay:
    def test_it_is_the_length_of_the_way_there_and_back(self, stage):
        play = stage(TOLD)
        walk(play, "Y1", (-0.4, -0.2), (-0.4, -0.5), (-0.1, -0.5), ticks=10)
        assert payload(play) == {"y1": 0.9, "ball": 0}

    def test_it_is_rounded_to_the_millimetre(self, stage):
        play = stage(TOLD)
        play.place("ball", 0.12345, 0.0)
        assert payload(play) == {"y1": 0, "ball": 0.123}

    def test_where_a_rule_puts_it_is_no_way_and_takes_none_away(self, stage):
        play = stage(TOLD, at_tick_10("{action: place, entity: ball, at: {point: [0.5, 0.5]}}"))
        walk(play, "ball", (0.3, 0.0), ticks=10)
        assert play.pose("ball")[0] == 0.5
        walk(play, "ball", (0.5, 0.4), ticks=10)
        assert payload(play)["ball"] == 0.4

    def test_off_the_field_it_stays_what_it_was_and_the_way_back_is_none(self, stage):
        gone = "{action: remove, entity: ball, for_s: 0.32, back_at: {point: [-0.5, 0]}}"
        play = stage(TOLD, at_tick_10(gone))
        walk(play, "ball", (0.3, 0.0), ticks=10)
        play.play(5)
        assert payload(play)["ball"] == 0.3
        play.play_until(22)
        walk(play, "ball", (-0.5, 0.1), ticks=10)
        assert payload(play)["ball"] == 0.4

    def test_each_half_begins_at_0(self, stage):
        assert payload(stage(TOLD, half=2)) == {"y1": 0, "ball": 0}

    def test_way_is_summed_only_if_a_rule_uses_it(self, stage):
        play = stage(emitting("{y1: {way: Y1}}"))
        assert play.referee._state.ways.keys() == {play.roster.index["Y1"]}
        assert stage().referee._state.ways == {}


class TestConditionWay:
    @pytest.mark.parametrize(
        ("compared", "holds"),
        [
            ("at_least: 0.5", True), ("at_least: 0.7", False), ("at_most: 0.7", True), ("at_most: 0.5", False),
            ("at_least: 0.5, at_most: 0.7", True), ("at_least: 0.5, negate: true", False),
            ("at_least: {counter: budget}", True),
        ],
    )  # fmt: skip
    def test_it_compares_the_way_of_an_entity(self, stage, ask, compared, holds):
        play = stage("counters: {budget: {initial: 0.55}}", ASKING % f"{{way: Y1, {compared}}}")
        walk(play, "Y1", (-0.4, -0.2), (-0.4, -0.5), ticks=10)
        assert ask(play) is holds

    def test_a_robot_off_the_field_has_come_as_far_as_before(self, stage, ask):
        gone = once(20, "{action: remove, entity: Y1}")
        play = stage(ASKING % "{way: Y1, at_least: 0.2}", gone)
        walk(play, "Y1", (-0.4, -0.2), ticks=10)
        play.play_until(25)
        assert ask(play)

    def test_a_rule_waits_until_the_budget_is_used_up_also_if_the_robot_is_put_back(self, stage):
        budget = """
        rules:
          back: {triggers: [{trigger: time_reached, at_s: 0.32}], actions: [{action: place, entity: Y1, at: start}]}
          used_up:
            for_each: robots
            triggers: [{trigger: holds, conditions: [{way: each, at_least: 0.49}]}]
            actions: [{action: emit, event: USED_UP, payload: {who: {word: robot_name}}}]
        """
        play = stage(budget)
        walk(play, "Y1", (-0.4, -0.2), (-0.4, -0.1), ticks=10)
        used_up = [(event.tick, event.payload) for event in play.events_named("USED_UP")]
        assert used_up == [(15, {"who": "Y1"})]
