"""Actions that score and count: each word, set off by a rule at tick 10 (or by a fault of B1's program)."""

import pytest

from tests.referee.building import acted, at_tick_10, fail, on_fault, place, rule


class TestActionScore:
    def test_it_gives_points_to_an_entrant(self, stage):
        play = acted(stage(at_tick_10("{action: score, entrant: blue, points: 2}"), scores={"blue": 1, "yellow": 4}))
        assert play.referee.scores == {"blue": 3, "yellow": 4}
        assert play.firings[-1].scored == {"blue": 2}

    def test_points_can_be_a_counter_or_weighted_parts(self, stage):
        state = """
        counters: {streak: {initial: 4}, fouls: {initial: 2}}
        flags: {bonus: {initial: true}, malus: {}}
        """
        play = acted(
            stage(
                state,
                at_tick_10(
                    "{action: score, entrant: blue, points: {counter: streak}}",
                    "{action: score, entrant: yellow, points: {sum: [{counter: streak}, {counter: fouls, times: -0.5}, "
                    "{flag: bonus, times: 10}, {flag: malus, times: 100}]}}",
                ),
            )
        )
        assert play.referee.scores == {"blue": 4, "yellow": 13}
        assert isinstance(play.referee.scores["yellow"], int)

    @pytest.mark.parametrize(
        ("word", "points"),
        # A half of 60 s; tick 10 is at 0.32 s, tick 1000 at 32 s, tick 1010 at 32.32 s.
        [("time_s", [0, 32, 32]), ("time_left_s", [59, 28, 27]), ("total_match_time_s", [60, 60, 60]),
         ("halftime", [2, 2, 2])],
    )  # fmt: skip
    def test_a_time_rounded_down_gives_its_whole_seconds(self, stage, word, points):
        found = []
        for at_s in (0.32, 32, 32.32):
            score = f"{{action: score, entrant: blue, points: {{word: {word}, round: down}}}}"
            play = stage(rule(f"trigger: time_reached, at_s: {at_s}", score), half=2)
            play.play_until(1010)
            found.append(play.referee.scores["blue"])
        assert found == points
        assert all(isinstance(number, int) for number in found)

    def test_what_is_rounded_first_stands_in_a_sum_of_its_own(self, stage):
        whole = "{sum: [{word: time_left_s, round: down}], times: 0.5, plus: {word: halftime}}"
        score = f"{{action: score, entrant: blue, points: {whole}}}"
        assert acted(stage(at_tick_10(score))).referee.scores["blue"] == 30.5

    def test_a_draw_gives_the_number_that_it_decided(self, stage):
        draws = "draws: {bonus: {values: [5, 2.5]}}"
        actions = (
            "{action: score, entrant: blue, points: {draw: bonus}}",
            "{action: score, entrant: yellow, points: {sum: [{draw: bonus, times: 2}]}}",
        )
        found = [acted(stage(draws, at_tick_10(*actions), draws={"bonus": bonus})).referee.scores for bonus in (5, 2.5)]
        assert found == [{"blue": 5, "yellow": 10}, {"blue": 2.5, "yellow": 5}]

    def test_what_was_measured_gives_points_with_its_fraction_and_nothing_measured_none(self, stage):
        play = stage("""
        rules:
          far:
            triggers: [{trigger: displaced, entity: B1, distance_m: 0.25}]
            actions:
              - {action: score, entrant: blue, points: {word: measured}}
              - {action: score, entrant: yellow, points: {sum: [{word: measured, times: 10}, {word: limit, times: -4}]}}
          fails:
            triggers: [{trigger: program_fault}]
            actions: [{action: score, entrant: blue, points: {word: measured}}]
        """)
        place(play, "B1", 0.4, 0.0)
        fail(play, "Y1")
        assert play.referee.scores == {"blue": 0.5, "yellow": 4}

    def test_the_score_of_the_one_concerned_or_of_a_named_entrant(self, stage):
        doubles = ("{action: score, entrant: yellow, points: {word: score}}",
                   "{action: score, entrant: blue, points: {word: score, of: yellow}}")  # fmt: skip
        play = fail(stage(on_fault("Y1", *doubles), scores={"blue": 1, "yellow": 4}))
        assert play.referee.scores == {"blue": 9, "yellow": 8}

    def test_a_weighted_counter_or_flag_kept_per_entity_is_that_entitys_or_as_one(self, stage):
        state = """
        counters: {laps: {per: blue, initial: 3}}
        flags: {home: {per: blue}}
        rules:
          home: {triggers: [{trigger: half_started}], actions: [{action: set_flag, flag: home, entity: B2}]}
          pays:
            for_each: blue
            triggers: [{trigger: time_reached, at_s: 0.32}]
            actions:
              - {action: score, entrant: blue, points: {sum: [{counter: laps, entity: each, times: 10}, {flag: home, entity: each}]}}
              - {action: score, entrant: yellow, points: {sum: [{sum: {counter: laps}}, {highest: {flag: home}}]}}
        """
        play = acted(stage(state))
        paid = [firing.scored for firing in play.firings if firing.rule == "pays"]
        assert paid == [{"blue": 30, "yellow": 7}, {"blue": 31, "yellow": 7}]


class TestActionCount:
    @pytest.mark.parametrize(
        ("how", "expected"),
        [("by: 2.5", 7.5), ("by: -1", 4), ("to: 0", 0), ("to: {counter: other}", 9), ("by: {counter: other}", 14)],
    )
    def test_by_adds_and_to_sets(self, stage, how, expected):
        play = stage(
            "counters: {number: {initial: 5}, other: {initial: 9}}",
            at_tick_10(f"{{action: count, counter: number, {how}}}"),
        )
        assert acted(play).referee.counters["number"] == expected

    @pytest.mark.parametrize(
        ("how", "expected"),
        [
            ("by: {flag: up}", 6),
            ("by: {flag: down}", 5),
            ("to: {flag: seen, entity: Y1}", 0),
            ("by: {word: time_left_s, round: down}", 64),
            ("to: {word: halftime}", 1),
            ("by: {draw: bonus}", 7),
            ("by: {word: measured}", 5.32),
            ("to: {word: limit}", 0.32),
        ],
    )
    def test_a_flag_or_a_word_can_be_counted_too(self, stage, how, expected):
        play = stage(
            "counters: {number: {initial: 5}}",
            "draws: {bonus: {values: [2]}}",
            "flags: {up: {initial: true}, down: {}, seen: {per: robots}}",
            at_tick_10(f"{{action: count, counter: number, {how}}}"),
        )
        assert acted(play).referee.counters["number"] == expected

    def test_one_per_entity_counts_for_one_or_for_all(self, stage):
        play = stage(
            "counters: {calls: {per: blue}}",
            at_tick_10("{action: count, counter: calls, by: 5}", "{action: count, counter: calls, entity: B2}"),
        )
        assert acted(play).referee.counters["calls"] == {"B1": 5, "B2": 6}
