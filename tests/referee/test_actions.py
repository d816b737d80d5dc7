"""Actions but for scoring and counting: each word, set off by a rule at tick 10 (or by a fault of B1's program)."""

from itertools import pairwise

import pytest

from tests.referee.building import acted, at_tick_10, event_ticks, fail, hears, on_fault, once, place


class TestActionTimer:
    @pytest.mark.parametrize(
        ("do", "more", "expired"),
        [
            ("restart", "starts: true", [40]), ("start", "starts: true", [30]), ("stop", "starts: true", []),
            ("reset", "starts: true", []), ("start", "", [40]),
        ],
    )  # fmt: skip
    def test_what_it_does_to_a_timer(self, stage, do, more, expired):
        timer = f"timers: {{egg: {{lasts_s: 0.96, {more}}}}}"
        play = stage(timer, hears("timer_expired, timer: egg"), at_tick_10(f"{{action: timer, timer: egg, do: {do}}}"))
        play.play(100)
        assert event_ticks(play) == expired

    def test_it_expires_once_until_restarted(self, stage):
        again = once(50, "{action: timer, timer: egg, do: start}", name="again")
        play = stage("timers: {egg: {lasts_s: 0.096}}", hears("timer_expired, timer: egg"), again,
                     at_tick_10("{action: timer, timer: egg}"))  # fmt: skip
        play.play(100)
        assert event_ticks(play) == [13]


class TestActionDraw:
    def drawn_one_after_the_other(self, stage, draw, more, **facts):
        """Return the value at the start and those of so many draws, and the referee."""
        play = stage(f"draws: {{gate: {draw}}}", on_fault("B1", "{action: draw, draw: gate}"), **facts)
        values = [play.referee.draws["gate"]]
        for _ in range(more):
            fail(play, "B1")
            values.append(play.referee.draws["gate"])
        return values, play.referee

    def test_it_draws_a_new_value_never_the_same_twice_running_if_asked(self, stage):
        values, _ = self.drawn_one_after_the_other(stage, "{values: [a, b, c], not_last: true}", 60)
        assert all(one != other for one, other in pairwise(values))
        assert set(values) == {"a", "b", "c"}

    @pytest.mark.parametrize("seed", range(1, 5))
    def test_without_repetition_all_come_once_in_a_drawn_order_before_any_comes_again(self, stage, seed):
        draw = "{values: [a, b, c, d], not_again: half}"
        values, _ = self.drawn_one_after_the_other(stage, draw, 11, seed=seed)
        assert [sorted(values[first : first + 4]) for first in (0, 4, 8)] == [["a", "b", "c", "d"]] * 3
        assert values == self.drawn_one_after_the_other(stage, draw, 11, seed=seed)[0]

    @pytest.mark.parametrize("seed", range(1, 5))
    def test_without_repetition_and_never_twice_running_a_round_begins_with_another_than_the_last(self, stage, seed):
        draw = "{values: [a, b, c], not_again: half, not_last: true}"
        values, _ = self.drawn_one_after_the_other(stage, draw, 14, seed=seed)
        assert all(one != other for one, other in pairwise(values))
        assert [sorted(values[first : first + 3]) for first in range(0, 15, 3)] == [["a", "b", "c"]] * 5

    def test_what_a_test_decides_or_a_rule_sets_has_been_drawn(self, stage):
        values, _ = self.drawn_one_after_the_other(stage, "{values: [a, b], not_again: half}", 2, draws={"gate": "b"})
        assert values[:2] == ["b", "a"]
        play = stage(
            "draws: {gate: {values: [a, b, c], not_again: half}}",
            at_tick_10("{action: draw, draw: gate, as: b}", "{action: draw, draw: gate}"),
            draws={"gate": "a"},
        )
        assert acted(play).referee.draws == {"gate": "c"}

    def test_of_several_values_that_a_test_decides_each_draw_takes_the_next_and_then_chance_decides_again(self, stage):
        draw, decided = "{values: [a, b, c, d]}", {"gate": ("c", "c", "a")}
        orders = {
            tuple(self.drawn_one_after_the_other(stage, draw, 6, seed=seed, draws=decided)[0]) for seed in range(1, 9)
        }
        assert {order[:3] for order in orders} == {("c", "c", "a")}
        assert len({order[3:] for order in orders}) > 4

    def test_what_a_rule_sets_takes_no_value_of_those_that_a_test_decides(self, stage):
        play = stage(
            "draws: {gate: {values: [a, b, c]}}",
            at_tick_10("{action: draw, draw: gate, as: b}", "{action: draw, draw: gate}"),
            draws={"gate": ("a", "c")},
        )
        assert (play.referee.draws, play.referee.undecided()) == ({"gate": "a"}, {"gate": ["c"]})
        assert (acted(play).referee.draws, play.referee.undecided()) == ({"gate": "c"}, {})

    @pytest.mark.parametrize("seed", range(1, 5))
    def test_without_repetition_in_the_match_the_next_half_draws_from_what_is_left(self, stage, seed):
        first, referee = self.drawn_one_after_the_other(stage, "{values: [a, b, c], not_again: match}", 1, seed=seed)
        second, _ = self.drawn_one_after_the_other(
            stage, "{values: [a, b, c], not_again: match}", 0, seed=seed, half=2, kept=referee.kept
        )
        assert sorted(first + second) == ["a", "b", "c"]

    def test_without_repetition_in_the_half_the_next_half_draws_from_all(self, stage):
        _, referee = self.drawn_one_after_the_other(stage, "{values: [a, b], not_again: half}", 0)
        assert "undrawn" not in referee.kept
        values, _ = self.drawn_one_after_the_other(
            stage, "{values: [a, b], not_again: half}", 1, half=2, kept=referee.kept
        )
        assert sorted(values) == ["a", "b"]

    @pytest.mark.parametrize("reach", ["half", "match"])
    def test_a_value_that_lives_on_in_the_next_half_has_been_drawn_there(self, stage, reach):
        draw = f"{{values: [a, a, b], not_again: {reach}, keep: match}}"
        first, referee = self.drawn_one_after_the_other(stage, draw, 0, draws={"gate": "a"})
        second, _ = self.drawn_one_after_the_other(stage, draw, 2, half=2, kept=referee.kept)
        assert (first, sorted(second)) == (["a"], ["a", "a", "b"])

    def test_adding_a_draw_shifts_no_other(self, stage):
        one = stage("draws: {side: {values: [1, 2, 3, 4, 5, 6, 7, 8, 9]}}", seed=5)
        two = stage("draws: {new: {values: [1, 2]}, side: {values: [1, 2, 3, 4, 5, 6, 7, 8, 9]}}", seed=5)
        assert one.referee.draws["side"] == two.referee.draws["side"]

    def test_a_value_it_cannot_have_is_refused(self, stage):
        with pytest.raises(ValueError, match=r"draws\.side: 'd' is not one of its values"):
            stage("draws: {side: {values: [a, b]}}", draws={"side": "d"})


class TestActionPlace:
    def test_a_layout_is_an_ordered_list_and_a_later_one_may_refer_to_an_earlier(self, stage):
        play = stage(
            """
            placements:
              duel:
                - {entity: ball, at: {point: [0.1, 0.2]}}
                - {entity: B1, at: {relative_to: ball, offset_m: [0, 0.1]}}
            """,
            at_tick_10("{action: place, layout: duel}"),
        )
        assert acted(play).pose("B1")[:2] == pytest.approx((0.1, 0.3))

    def test_a_layout_can_be_mirrored_while_a_flag_is_set(self, stage):
        sections = (
            "flags: {turned: {}}\nplacements: {one: [{entity: B1, at: {point: [0.2, 0.4]}}]}",
            at_tick_10(
                "{action: place, layout: one, mirror: {axis: y, when: turned}}",
                "{action: set_flag, flag: turned, to: opposite}",
            ),
        )
        assert acted(stage(*sections)).pose("B1")[:2] == pytest.approx((0.2, 0.4))  # as it was when asked for
        turned = stage(*sections, "flags: {turned: {initial: true}}")
        assert acted(turned).pose("B1")[:2] == pytest.approx((0.2, -0.4))

    def test_on_failure_stay_gives_up(self, stage):
        play = stage(at_tick_10("{action: place, entity: ball, at: {point: [0, 0.3]}, on_failure: stay}"))
        place(play, "B1", 0.0, 0.3, ticks=11)
        place(play, "B1", 0.5, 0.5, ticks=20)
        assert play.pose("ball")[:2] == (0.0, 0.0)

    def test_a_waiting_placement_is_cancelled_by_another_of_that_entity(self, stage):
        play = stage(
            at_tick_10("{action: place, entity: ball, at: {point: [0, 0.3]}}"),
            once(20, "{action: place, entity: ball, at: {point: [0.2, -0.2]}}", name="other"),
        )
        place(play, "B1", 0.0, 0.3, ticks=25)
        place(play, "B1", 0.5, 0.5, ticks=20)
        assert play.pose("ball")[:2] == pytest.approx((0.2, -0.2))


class TestActionRemove:
    def test_it_takes_off_and_brings_back_after_a_time(self, stage):
        play = stage(at_tick_10("{action: remove, entity: B1, for_s: 0.64, back_at: {spot: centre}}"))
        place(play, "ball", 0.5, 0.0, ticks=10)
        assert [(tick, placement.parked) for tick, placement in play.placements] == [(10, True)]
        play.play(20)
        assert [(tick, placement.parked) for tick, placement in play.placements] == [(10, True), (30, False)]
        assert play.pose("B1") == pytest.approx((0.0, 0.0, -1.57))


class TestActionEnd:
    def test_it_can_end_the_match(self, stage):
        play = stage(at_tick_10("{action: end, what: match}"))
        output = play.play(10)
        assert (output.ended, output.ends_match) == ("act", True)

    def test_the_reason_of_the_rule_that_ends_the_match_goes_before_that_of_one_that_ends_the_half(self, stage):
        play = stage(at_tick_10("{action: end, reason: half}", "{action: end, what: match, reason: match}"))
        assert play.play(10).ended == "match"
        play = stage(at_tick_10("{action: end, what: match, reason: match}", "{action: end, reason: half}"))
        assert play.play(10).ended == "match"
