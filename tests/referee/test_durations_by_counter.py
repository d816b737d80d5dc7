"""Timers and phases that last as long as a counter says when they begin."""

import pytest

RUN_OUT = """
rules:
  go: {triggers: [{trigger: time_reached, at_s: 0.32}], actions: [{action: timer, timer: egg, do: restart}]}
  over: {triggers: [{trigger: timer_expired, timer: egg}], actions: [{action: emit, event: OVER, payload: {after_s: {word: measured}}}]}
"""
PAUSE = """
rules:
  rest:
    triggers: [{trigger: time_reached, at_s: 0.32}]
    actions: [{action: count, counter: long_s, by: 0.32}, {action: set_phase, phase: rest}]
  more: {phases: [rest], triggers: [{trigger: phase_entered, phase: rest}], actions: [{action: count, counter: long_s, by: 10}]}
  again: {triggers: [{trigger: phase_entered, phase: play}], actions: [{action: emit, event: AGAIN}]}
"""


def ticks(play, count=100):
    play.play(count)
    return [event.tick for event in play.events]


class TestATimerThatLastsAsLongAsACounterSays:
    def test_the_counter_is_read_when_it_starts_from_0_also_within_the_rule_that_counts(self, stage):
        play = stage(
            "counters: {long_s: {initial: 9}}",
            "timers: {egg: {lasts_s: {counter: long_s}}}",
            RUN_OUT,
            """
            rules:
              go:
                triggers: [{trigger: time_reached, at_s: 0.32}]
                actions: [{action: count, counter: long_s, to: 0.64}, {action: timer, timer: egg, do: restart}]
              later: {triggers: [{trigger: time_reached, at_s: 0.48}], actions: [{action: count, counter: long_s}]}
            """,
        )
        assert ticks(play) == [30]
        assert play.events[0].payload == {"after_s": 0.64}

    @pytest.mark.parametrize(
        ("initial", "starts", "over"),
        [
            (0.16, ", starts: true", [5, 15]),  # with the half, and again
            (0, "", [11]), (-5, "", [11]), (0.01, "", [11]),  # less than a tick is a tick
            (1.0e15, "", []),
        ],
    )  # fmt: skip
    def test_it_lasts_what_the_counter_is_at_first_but_at_least_a_tick(self, stage, initial, starts, over):
        counter = f"counters: {{long_s: {{initial: {initial:.2e}}}}}"
        play = stage(counter, f"timers: {{egg: {{lasts_s: {{counter: long_s}}{starts}}}}}", RUN_OUT)
        assert ticks(play) == over

    def test_of_one_kept_for_each_that_of_the_same_one_counts(self, stage):
        play = stage("""
        counters: {long_s: {per: robots, initial: 0.64}}
        timers: {egg: {per: robots, lasts_s: {counter: long_s, entity: each}}}
        rules:
          longer: {triggers: [{trigger: half_started}], actions: [{action: count, counter: long_s, entity: Y1, to: 1.28}]}
          go: {triggers: [{trigger: time_reached, at_s: 0.32}], actions: [{action: timer, timer: egg}]}
          over:
            for_each: robots
            triggers: [{trigger: timer_expired, timer: egg}]
            actions: [{action: emit, event: OVER, payload: {who: {word: robot_name}}}]
        """)
        assert ticks(play) == [30, 30, 30, 50]
        assert play.events[-1].payload == {"who": "Y1"}


class TestAPhaseThatLastsAsLongAsACounterSays:
    def test_the_counter_is_read_when_the_phase_is_entered_and_not_after(self, stage):
        play = stage("counters: {long_s: {initial: 0.32}}", "phases: {rest: {lasts_s: {counter: long_s}}}", PAUSE)
        assert ticks(play) == [30]  # entered in tick 10, over after 20 ticks

    def test_the_first_phase_lasts_what_the_counter_is_at_first(self, stage):
        play = stage(
            "counters: {long_s: {initial: 0.64}}",
            "phases: {rest: {lasts_s: {counter: long_s}}}\nfirst_phase: rest",
            PAUSE,
        )
        assert ticks(play) == [20]
