"""What the reference says of words at their edges, each as the referee has it."""

import pytest

from rcj_challenges.expect.scripted_match import ScriptedMatch
from tests.referee.building import at_tick_10, place


def hears(condition: str, more: str = "") -> str:
    """Return a rule that says when a condition holds."""
    heard = f"{{trigger: holds, condition: {condition}{more}}}"
    return f"rules: {{hears: {{triggers: [{heard}], actions: [{{action: emit, event: HEARD}}]}}}}"


def ticks(play: ScriptedMatch, event: str = "HEARD") -> list[int]:
    """Return when an event came."""
    return [one.tick for one in play.events_named(event)]


class TestHolds:
    @pytest.mark.parametrize("condition", [
        "{condition: in_zone, entity: ball, zone: right}",
        "{condition: distance, entity: ball, to: centre, at_least: 0.3}",
    ])  # fmt: skip
    def test_where_a_rule_puts_something_is_not_heard(self, stage, condition):
        play = stage(at_tick_10("{action: place, entity: ball, at: {point: [0.4, 0]}}"), hears(condition))
        play.play_until(20)
        assert ticks(play) == []

    def test_that_a_rule_makes_a_spot_free_is_heard_one_tick_later(self, stage):
        away = at_tick_10("{action: place, entity: ball, at: {point: [0.4, 0]}}")
        play = stage(away, hears("{condition: spot_free, spot: centre}"))
        play.play_until(20)
        assert ticks(play) == [11]

    def test_that_a_placement_loses_the_steps_of_a_sequence_is_heard_one_tick_later(self, stage):
        at_first = "{condition: sequence_at, sequence: way, step: left, negate: true}"
        play = stage(
            "sequences: {way: {entity: Y1, steps: [left, right]}}",
            at_tick_10("{action: place, entity: Y1, at: {point: [0.4, 0]}}"),
            hears(at_first),
        )
        play.play_until(20)
        assert ticks(play) == [11]

    def test_that_nobody_lower_is_left_on_the_field_is_heard_one_tick_later(self, stage):
        play = stage(
            "counters: {visits: {per: robots}}",
            at_tick_10("{action: remove, entity: [B1, B2]}"),
            "rules: {one: {triggers: [{trigger: half_started}], actions: "
            "[{action: count, counter: visits, entity: Y1}, {action: count, counter: visits, entity: Y2}]}}",
            hears("{condition: counter, counter: visits, entity: Y1, at_most: {lowest: visits}}"),
        )
        play.play_until(20)
        assert ticks(play) == [11]


class TestAPhaseEntered:
    def test_the_present_one_begins_anew_when_a_rule_enters_it(self, stage):
        play = stage(
            "phases: {rest: {lasts_s: 0.64}}\nfirst_phase: rest",
            "rules: {again: {phases: any, triggers: [{trigger: time_reached, at_s: 0.32}], "
            "actions: [{action: set_phase, phase: rest}]}}",
        )
        play.play_until(29)
        assert play.referee.phase == "rest"
        play.play()
        assert play.referee.phase == "play"


class TestDisplaced:
    def test_it_is_measured_from_where_noise_has_put_it(self, stage):
        put = "{action: place, entity: ball, at: {point: [0, 0]}, noise_m: [0.3, 0]}"
        play = stage(
            at_tick_10(put),
            "rules: {moved: {triggers: [{trigger: displaced, entity: ball, distance_m: 0.02}], "
            "actions: [{action: emit, event: HEARD}]}}",
        )
        play.play_until(12)
        x, y, _ = play.pose("ball")
        assert abs(x) > 0.02
        place(play, "ball", x, y + 0.019)
        assert ticks(play) == []
        place(play, "ball", x, y + 0.021)
        assert ticks(play) == [14]


class TestWaitingForRoom:
    RULES = """
phases: {rest: {lasts_s: 1.6}}
rules:
  put:
    %s
    triggers: [{trigger: time_reached, at_s: 0.32}]
    actions: [{action: place, entity: B1, at: {point: [0, 0]}}, {action: set_phase, phase: rest}]
"""

    @pytest.mark.parametrize(
        ("phases", "there_at_30"), [("", False), ("phases: any", True), ("phases: [play, rest]", True)]
    )
    def test_it_is_tried_again_in_the_phases_of_its_rule(self, stage, phases, there_at_30):
        play = stage(self.RULES % phases)  # the ball lies there
        play.play_until(20)
        play.place("ball", 0.5, 0)
        play.play_until(30)
        assert (play.pose("B1")[:2] == (0, 0)) is there_at_30
        play.play_until(62)
        assert play.pose("B1")[:2] == (0, 0)


class TestWhenAPlaceIsRead:
    """Which layout and whether mirrored: when the action runs; where that is: when all actions of the tick have run."""

    SIDES = "draws: {side: {values: [middle_blue, middle_yellow]}}"
    AS = "{action: draw, draw: side, as: middle_yellow}"

    def test_where_a_drawn_spot_is_as_it_is_after_all_actions(self, stage):
        rule = at_tick_10("{action: place, entity: B1, at: {spot: side}}", self.AS)
        play = stage(self.SIDES, rule, draws={"side": "middle_blue"})
        play.play_until(10)
        assert play.pose("B1")[:2] == pytest.approx((0, -0.2))

    def test_a_spot_that_a_rule_sets_too(self, stage):
        rule = at_tick_10("{action: place, entity: B1, at: {spot: middle_blue}}",
                          "{action: set_spot, spot: middle_blue, to: [0.5, 0.1]}")  # fmt: skip
        play = stage(rule)
        play.play_until(10)
        assert play.pose("B1")[:2] == pytest.approx((0.5, 0.1))

    def test_a_mirror_is_as_its_flag_is_when_the_action_runs(self, stage):
        rule = at_tick_10(
            "{action: place, entity: B1, at: {point: [0.4, 0.1]}, mirror: {axis: x, when: changed}}",
            "{action: set_flag, flag: changed}",
        )
        play = stage("flags: {changed: {}}", rule)
        play.play_until(10)
        assert play.pose("B1")[:2] == pytest.approx((0.4, 0.1))

    def test_a_layout_is_the_one_drawn_when_the_action_runs(self, stage):
        layouts = "placements: {a: [{entity: B1, at: {point: [0.4, 0.1]}}], b: [{entity: B1, at: {point: [0, 0.4]}}]}"
        rule = at_tick_10("{action: place, layout: {draw: form}}", "{action: draw, draw: form, as: b}")
        play = stage("draws: {form: {values: [a, b]}}", layouts, rule, draws={"form": "a"})
        play.play_until(10)
        assert play.pose("B1")[:2] == pytest.approx((0.4, 0.1))


class TestATimerThatHasRunOut:
    @pytest.mark.parametrize(("comparison", "holds"), [
        ("at_least: 5", True), ("at_most: 5", False), ("equals: 5", False), ("at_most: 5.024", True),
    ])  # fmt: skip
    def test_it_stands_at_its_length_in_whole_ticks(self, stage, comparison, holds):
        play = stage(
            "timers: {five: {lasts_s: 5, starts: true}}",
            "rules: {over: {triggers: [{trigger: time_reached, at_s: 8}], conditions: "
            f"[{{condition: timer, timer: five, {comparison}}}], actions: [{{action: emit, event: HEARD}}]}}}}",
        )
        play.play_until(260)
        assert bool(ticks(play)) is holds


class TestRemove:
    def removals(self, stage, first: str, second: str) -> list[int]:
        """Return when B1 was put back that is taken off at tick 10 and again at tick 20."""
        again = (
            f"{{triggers: [{{trigger: time_reached, at_s: 0.64}}], actions: [{{action: remove, entity: B1{second}}}]}}"
        )
        play = stage(at_tick_10(f"{{action: remove, entity: B1{first}}}"), f"rules: {{again: {again}}}")
        play.play_until(200)
        return [tick for tick, placed in play.placements if tick and not placed.parked]

    @pytest.mark.parametrize(("first", "second", "back"), [
        (", for_s: 3.2", ", for_s: 0.64", [40]),
        (", for_s: 0.64", ", for_s: 3.2", [120]),
        (", for_s: 3.2", "", []),
        ("", ", for_s: 0.64", [40]),
    ])  # fmt: skip
    def test_who_is_off_already_comes_back_as_the_later_one_says(self, stage, first, second, back):
        assert self.removals(stage, first, second) == back
