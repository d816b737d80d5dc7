"""How far something has driven or rolled in the half: asked by conditions, told as a value, counted and paid."""

import pytest

from tests.referee.building import emitting, payload

TOLD = emitting("{y1: {way: Y1}, ball: {way: ball}}")


def asking(condition: str) -> str:
    return f"""
    rules:
      asked: {{triggers: [{{trigger: program_fault, robot: B1}}], conditions: [{condition}],
               actions: [{{action: emit, event: TRUE_NOW}}]}}
    """


def drive(play, entity: str, *to: tuple[float, float], ticks: int = 10) -> None:
    """Let something glide from point to point."""
    for point in to:
        play.glide(entity, point, ticks)
        play.play(ticks)


class TestValueWay:
    def test_it_is_the_length_of_the_way_there_and_back(self, stage):
        play = stage(TOLD)
        drive(play, "Y1", (-0.4, -0.2), (-0.4, -0.5), (-0.1, -0.5))
        assert payload(play) == {"y1": 0.9, "ball": 0}

    def test_it_is_told_to_the_millimetre(self, stage):
        play = stage(TOLD)
        play.place("ball", 0.12345, 0.0)
        assert payload(play) == {"y1": 0, "ball": 0.123}

    def test_where_a_rule_puts_it_is_no_way_and_takes_none_away(self, stage):
        put = """
        rules:
          put: {triggers: [{trigger: time_reached, at_s: 0.32}],
                actions: [{action: place, entity: ball, at: {point: [0.5, 0.5]}}]}
        """
        play = stage(TOLD, put)
        drive(play, "ball", (0.3, 0.0))
        assert play.pose("ball")[0] == 0.5
        drive(play, "ball", (0.5, 0.4))
        assert payload(play)["ball"] == 0.4

    def test_off_the_field_it_stays_what_it_was_and_the_way_back_is_none(self, stage):
        gone = """
        rules:
          gone: {triggers: [{trigger: time_reached, at_s: 0.32}],
                 actions: [{action: remove, entity: ball, for_s: 0.32, back_at: {point: [-0.5, 0]}}]}
        """
        play = stage(TOLD, gone)
        drive(play, "ball", (0.3, 0.0))
        play.play(5)
        assert payload(play)["ball"] == 0.3
        play.play_until(22)
        drive(play, "ball", (-0.5, 0.1))
        assert payload(play)["ball"] == 0.4

    def test_each_half_begins_at_0(self, stage):
        assert payload(stage(TOLD, half=2)) == {"y1": 0, "ball": 0}

    def test_nobodys_way_is_added_up_if_nobody_asks(self, stage):
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
        play = stage("counters: {budget: {initial: 0.55}}", asking(f"{{condition: way, entity: Y1, {compared}}}"))
        drive(play, "Y1", (-0.4, -0.2), (-0.4, -0.5))
        assert ask(play) is holds

    def test_who_is_off_the_field_has_come_as_far_as_before(self, stage, ask):
        gone = (
            "rules: {gone: {triggers: [{trigger: time_reached, at_s: 0.64}], actions: [{action: remove, entity: Y1}]}}"
        )
        play = stage(asking("{condition: way, entity: Y1, at_least: 0.2}"), gone)
        drive(play, "Y1", (-0.4, -0.2))
        play.play_until(25)
        assert ask(play)

    def test_a_rule_waits_until_the_budget_is_used_up_also_if_the_robot_is_put_back(self, stage):
        budget = """
        rules:
          back: {triggers: [{trigger: time_reached, at_s: 0.32}], actions: [{action: place, entity: Y1, at: start}]}
          used_up:
            for_each: robots
            triggers: [{trigger: holds, condition: {condition: way, entity: each, at_least: 0.49}}]
            actions: [{action: emit, event: USED_UP, payload: {who: {word: robot_name}}}]
        """
        play = stage(budget)
        drive(play, "Y1", (-0.4, -0.2), (-0.4, -0.1), ticks=10)
        told = [(event.tick, event.payload) for event in play.events_named("USED_UP")]
        assert told == [(15, {"who": "Y1"})]
