"""Floors and ceilings of what is paid and counted, and of scores and counters."""

import pytest

STATE = "counters: {n: {initial: 5}, computed: {initial: %s}, own: {per: robots}}"


def played(stage, action: str, computed: float = 0, **facts):
    """Return a play in which a rule has acted twice, at ticks 10 and 20."""
    again = "{trigger: time_reached, at_s: 0.32}, {trigger: time_reached, at_s: 0.64}"
    play = stage(STATE % computed, f"rules: {{act: {{triggers: [{again}], actions: [{action}]}}}}", **facts)
    play.play(25)
    return play


class TestHowMuchIsPaid:
    LATE = "{action: score, entrant: blue, points: {lowest: [{highest: [%s, 5]}, 12]}}"
    LATE %= "{counter: computed, times: -1, plus: 20}"

    @pytest.mark.parametrize(("computed", "points"), [(30, 5), (16, 5), (15, 5), (12.5, 7.5), (8, 12), (0, 12)])
    def test_it_is_no_less_and_no_more_whatever_was_computed(self, stage, computed, points):
        play = played(stage, self.LATE, computed)
        assert [firing.scored for firing in play.firings] == [{"blue": points}] * 2
        assert play.referee.scores["blue"] == 2 * points


class TestHowFarAScoreGoes:
    FOUL = "{action: score, entrant: blue, points: %s, keeps_at_least: 0, keeps_at_most: 10}"

    @pytest.mark.parametrize(
        ("before", "points", "given", "after"),
        [
            (5, -3, [-3, -2], 0),
            (0, -3, [0, 0], 0),
            (9, 3, [1, 0], 10),
            # What lies beyond already stays: losing points gains nothing, and what comes back counts in full.
            (-4, -3, [0, 0], -4),
            (-4, 3, [3, 3], 2),
            (14, 3, [0, 0], 14),
            (14, -3, [-3, -3], 8),
            (0.3, -0.1, [-0.1, -0.1], 0.1),
            (0.1, -0.3, [-0.1, 0], 0),
        ],
    )
    def test_a_change_goes_as_far_as_the_bound(self, stage, before, points, given, after):
        play = played(stage, self.FOUL % points, scores={"blue": before, "yellow": 0})
        assert [firing.scored["blue"] for firing in play.firings] == given
        assert play.referee.scores["blue"] == after

    def test_the_points_really_taken_are_reported(self, stage):
        play = stage(
            "rules: {foul: {triggers: [{trigger: time_reached, at_s: 0.32}], says: '{points}', "
            "actions: [{action: score, entrant: blue, points: -5, keeps_at_least: 0}]}}",
            scores={"blue": 2, "yellow": 0},
        )
        play.play(12)
        assert [firing.says for firing in play.firings] == ["-2"]


class TestHowMuchIsCounted:
    @pytest.mark.parametrize(
        ("how", "computed", "after"),
        [
            ("by: {highest: [{counter: computed}, 2]}", 1, 9),
            ("by: {lowest: [{counter: computed}, 2]}", 7, 9),
            ("by: {lowest: [{highest: [{counter: computed}, 2]}, 4]}", 3, 11),
            ("to: {highest: [{counter: computed}, 2]}", 1, 2),
            ("to: {lowest: [{counter: computed}, 2]}", 7, 2),
            ("to: {highest: [{counter: computed}, 2]}", 3, 3),
            ("by: -3, keeps_at_least: 0", 0, 0),
            ("by: 3, keeps_at_most: 7", 0, 7),
            ("by: 3, keeps_at_most: 4", 0, 5),
            ("keeps_at_most: 6", 0, 6),
        ],
    )
    def test_amounts_and_counters_have_bounds_as_scores_have(self, stage, how, computed, after):
        play = played(stage, f"{{action: count, counter: n, {how}}}", computed)
        assert play.referee.counters["n"] == after

    def test_each_of_those_that_are_counted_at_once_has_its_own(self, stage):
        alone = "{action: count, counter: own, entity: Y1, by: 2}, "
        play = played(stage, alone + "{action: count, counter: own, by: 2, keeps_at_most: 5}")
        assert play.referee.counters["own"] == {"B1": 4, "B2": 4, "Y1": 6, "Y2": 4}
