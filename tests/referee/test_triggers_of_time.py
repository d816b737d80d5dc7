"""Triggers at moments, about bodies, and holds."""

import pytest

from rcj_challenges.core.timing import ticks_from_s
from rcj_challenges.expect.scripted_match import ScriptedMatch


def emitting(trigger: str, more: str = "") -> str:
    """Return a rule that says when it was triggered."""
    return f"rules: {{told: {{triggers: [{trigger}], {more} actions: [{{action: emit, event: TOLD}}]}}}}"


def told(play: ScriptedMatch) -> list[int]:
    """Return the ticks at which the rule fired."""
    return [event.tick for event in play.events_named("TOLD")]


class TestTriggerHalfStarted:
    def test_it_fires_at_tick_0_after_the_draws(self, stage):
        play = stage("""
        draws: {side: {values: [left]}}
        rules:
          begin:
            triggers: [{trigger: half_started}]
            conditions: [{condition: drawn, draw: side, equals: left}]
            actions: [{action: emit, event: TOLD}]
        """)
        play.play(5)
        assert told(play) == [0]


class TestTriggerHalfEnded:
    def test_it_fires_once_after_the_last_tick(self, stage):
        play = stage(emitting("{trigger: half_ended}"))
        play.play(10)
        assert told(play) == []
        play.finish()
        assert told(play) == [10]


class TestTriggerPhaseEntered:
    PHASES = """
    phases: {pause: {lasts_s: 0.32}, other: {}}
    rules:
      pauses: {triggers: [{trigger: time_reached, at_s: 0.16}], actions: [{action: set_phase, phase: pause}]}
    """

    def test_it_fires_in_the_tick_in_which_the_phase_before_ran_out(self, stage):
        play = stage(self.PHASES, emitting("{trigger: phase_entered, phase: play}"))
        play.play(40)
        assert told(play) == [15]

    def test_it_fires_one_tick_after_a_rule_entered_it(self, stage):
        play = stage(self.PHASES, emitting("{trigger: phase_entered, phase: pause}", "phases: any,"))
        play.play(40)
        assert told(play) == [6]

    def test_it_can_ask_where_from(self, stage):
        play = stage(self.PHASES, emitting("{trigger: phase_entered, phase: play, from: other}"))
        play.play(40)
        assert told(play) == []

    def test_how_long_a_phase_lasts_may_be_drawn_and_counts_as_drawn_when_it_is_entered(self, stage):
        play = stage(
            "draws: {long: {values: [0.32, 0.64]}}",
            "phases: {pause: {lasts_s: {draw: long}}}\nfirst_phase: pause",
            """
            rules:
              drawn_too_late:
                phases: any
                triggers: [{trigger: half_started}]
                actions: [{action: draw, draw: long, as: 0.64}]
              once_more:
                triggers: [{trigger: phase_entered, phase: play, from: pause}]
                actions: [{action: set_phase, phase: pause}]
                max_executions: 1
              over:
                triggers: [{trigger: phase_entered, phase: play}]
                actions: [{action: emit, event: OVER}]
            """,
            draws={"long": 0.32},
        )
        play.play(60)
        # 10 ticks as drawn before the half, then 20 ticks.
        assert [event.tick for event in play.events_named("OVER")] == [30]

    def test_the_first_phase_of_a_half_is_not_entered(self, stage):
        play = stage(emitting("{trigger: phase_entered, phase: play}"))
        play.play(5)
        assert told(play) == []


class TestTriggerTimeReached:
    def test_it_fires_when_the_clock_reaches_the_time(self, stage):
        play = stage(emitting("{trigger: time_reached, at_s: 0.5}"))  # 15.6 ticks
        play.play(40)
        assert told(play) == [16]

    def test_the_time_in_which_the_clock_stood_does_not_count(self, stage):
        play = stage(
            "phases: {warm_up: {lasts_s: 0.32, clock: stops}}\nfirst_phase: warm_up",
            emitting("{trigger: time_reached, at_s: 0.5}"),
        )
        play.play(40)
        assert told(play) == [26]


class TestATimeThatComesAgain:
    def test_it_fires_again_after_each_interval_until_the_half_ends(self, stage):
        play = stage("match: {half_s: 3.2}", emitting("{trigger: time_reached, at_s: 0.64, every_s: 0.96}"))
        play.play(100)
        assert told(play) == [20, 50, 80]

    def test_intervals_that_are_no_whole_ticks_do_not_add_up_to_a_delay(self, stage):
        play = stage(emitting("{trigger: time_reached, at_s: 0.1, every_s: 0.1}"))
        play.play(320)
        ticks = told(play)
        assert len(ticks) == 102  # 10.2 s of 10.24 s; with each rounded up it would be 80
        assert ticks == [ticks_from_s(times / 10) for times in range(1, 103)]

    def test_every_tick_is_the_shortest_interval(self, stage):
        play = stage(emitting("{trigger: time_reached, at_s: 0.05, every_s: 0.032}"))
        play.play(40)
        assert told(play) == list(range(2, 41))

    def test_while_the_clock_stands_none_comes(self, stage):
        play = stage(
            "phases: {rest: {lasts_s: 1.6, clock: stops}}",
            "rules: {rests: {triggers: [{trigger: time_reached, at_s: 0.32}], actions: [{action: set_phase, phase: rest}]}}",
            emitting("{trigger: time_reached, at_s: 0.32, every_s: 0.32}", "phases: any,"),
        )
        play.play(80)
        assert told(play) == [10, 70, 80]

    def test_what_comes_in_a_phase_in_which_the_rule_does_not_live_is_past(self, stage):
        play = stage(
            "phases: {rest: {lasts_s: 0.5}}",
            "rules: {rests: {triggers: [{trigger: time_reached, at_s: 0.4}], actions: [{action: set_phase, phase: rest}]}}",
            emitting("{trigger: time_reached, at_s: 0.32, every_s: 0.32}"),
        )
        play.play(50)
        assert told(play) == [10, 30, 40, 50]

    def test_it_measures_the_time_that_has_come_and_its_limit_is_the_first(self, stage):
        play = stage(
            "rules: {told: {triggers: [{trigger: time_reached, at_s: 0.1, every_s: 0.1}], "
            "actions: [{action: emit, event: TOLD, payload: {at: {word: measured}, limit: {word: limit}}}], "
            "says: '{measured} of {limit}'}}"
        )
        play.play(10)
        assert [event.payload for event in play.events_named("TOLD")] == [
            {"at": 0.1, "limit": 0.1},
            {"at": 0.2, "limit": 0.1},
            {"at": 0.3, "limit": 0.1},
        ]
        assert [firing.says for firing in play.firings] == ["0.1 of 0.1", "0.2 of 0.1", "0.3 of 0.1"]


class TestTriggerTimerExpired:
    def test_it_fires_when_a_started_timer_reaches_its_length(self, stage):
        play = stage(
            "timers: {egg: {lasts_s: 0.32}}",
            emitting("{trigger: timer_expired, timer: egg}"),
            "rules: {go: {triggers: [{trigger: time_reached, at_s: 0.64}], actions: [{action: timer, timer: egg}]}}",
        )
        play.play(60)
        assert told(play) == [30]

    def test_one_that_starts_with_the_half_needs_no_action(self, stage):
        play = stage("timers: {egg: {lasts_s: 0.32, starts: true}}", emitting("{trigger: timer_expired, timer: egg}"))
        play.play(60)
        assert told(play) == [10]

    @pytest.mark.parametrize("lasts_s", ["1", "{draw: long}"])
    def test_its_limit_is_what_the_author_wrote_and_whole_ticks_are_measured(self, stage, lasts_s):
        play = stage(
            "draws: {long: {values: [1]}}",
            f"timers: {{egg: {{lasts_s: {lasts_s}, starts: true}}}}",
            emitting("{trigger: timer_expired, timer: egg}", "says: 'After {limit} s ({measured} s).',"),
        )
        play.play(60)
        (fired,) = play.firings
        assert (fired.limit, fired.measured, fired.says) == (1, 1.024, "After 1 s (1.024 s).")

    @pytest.mark.parametrize("do", ["restart", "start"])
    def test_a_drawn_length_counts_as_it_is_drawn_when_the_timer_starts_from_0(self, stage, do):
        play = stage(
            "draws: {long: {values: [0.32, 0.64, 0.96]}}",
            "timers: {clock: {lasts_s: {draw: long}}}",
            f"""
            rules:
              begun:
                triggers: [{{trigger: time_reached, at_s: 0.32}}]
                actions: [{{action: draw, draw: long, as: 0.64}}, {{action: timer, timer: clock, do: {do}}}]
              drawn_while_it_runs:
                triggers: [{{trigger: time_reached, at_s: 0.48}}]
                actions:
                  - {{action: draw, draw: long, as: 0.96}}
                  - {{action: timer, timer: clock, do: stop}}
                  - {{action: timer, timer: clock, do: start}}
              over:
                triggers: [{{trigger: timer_expired, timer: clock}}]
                actions: [{{action: emit, event: OVER}}]
            """,
            draws={"long": 0.32},
        )
        play.play(60)
        assert [event.tick for event in play.events] == [30]

    def test_of_a_timer_per_entity_that_of_each_counts(self, stage):
        play = stage("""
        timers: {egg: {lasts_s: 0.32, per: robots}}
        rules:
          go: {triggers: [{trigger: time_reached, at_s: 0.64}], actions: [{action: timer, timer: egg, entity: Y1}]}
          told:
            for_each: robots
            triggers: [{trigger: timer_expired, timer: egg}]
            actions: [{action: emit, event: TOLD, payload: {who: {word: robot_name}}}]
          any:
            triggers: [{trigger: timer_expired, timer: egg}]
            actions: [{action: emit, event: ANY, payload: {who: {word: robot_name}}}]
        """)
        play.play(60)
        assert [(event.name, event.tick, event.payload) for event in play.events] == [
            ("TOLD", 30, {"who": "Y1"}), ("ANY", 30, {"who": "Y1"}),
        ]  # fmt: skip


class TestTriggerEvent:
    def test_it_fires_one_tick_after_the_event(self, stage):
        play = stage(
            emitting("{trigger: event, event: FIRST}"),
            "rules: {first: {triggers: [{trigger: time_reached, at_s: 0.32}], actions: [{action: emit, event: FIRST}]}}",
        )
        play.play(30)
        assert [(event.name, event.tick) for event in play.events] == [("FIRST", 10), ("TOLD", 11)]


class TestTriggerEventOfOne:
    STRUCK = """
    rules:
      hit:
        for_each: robots
        triggers: [{trigger: program_fault, robot: each}]
        actions: [{action: emit, event: HIT}]
      told:
        %s
        triggers: [{trigger: event, event: HIT%s}]
        actions: [{action: emit, event: TOLD, payload: {who: {word: robot_name}}}]
    """

    @pytest.mark.parametrize(
        ("each", "entity", "told"),
        [
            ("for_each: robots", ", entity: each", ["B2", "Y1"]),
            ("for_each: yellow", ", entity: each", ["Y1"]),
            ("for_each: robots", "", ["B1", "B2", "Y1", "Y2"]),
            ("", ", entity: Y1", ["Y1"]),
            ("", ", entity: [Y2, blue]", ["B2"]),
            ("", ", entity: Y2", []),
            ("", "", [""]),
        ],
    )
    def test_it_is_heard_of_whom_it_is_about(self, stage, each, entity, told):
        play = stage(self.STRUCK % (each, entity))
        for robot in ("Y1", "B2"):
            play.fail(robot)
        play.play(2)
        assert [event.payload["who"] for event in play.events_named("TOLD")] == told

    def test_of_a_rule_without_for_each_it_is_about_whom_the_trigger_found(self, stage):
        play = stage(
            "rules: {hit: {triggers: [{trigger: touches, entity: blue, other: walls}], actions: [{action: emit, event: HIT}]}}",
            "rules: {told: {for_each: blue, triggers: [{trigger: event, event: HIT, entity: each}], "
            "actions: [{action: emit, event: TOLD, payload: {who: {word: robot_name}}}]}}",
        )
        play.touch("B2", "walls")
        play.play(2)
        assert [event.payload.get("who") for event in play.events] == [None, "B2"]


class TestTriggerProgramFault:
    def test_it_fires_when_a_program_failed_and_names_its_robot(self, stage):
        play = stage("""
        rules:
          told:
            triggers: [{trigger: program_fault}]
            actions: [{action: emit, event: TOLD, payload: {who: {word: robot_name}}}]
        """)
        play.play(3)
        play.fail("Y2")
        play.play(3)
        assert [(event.tick, event.payload) for event in play.events] == [(4, {"who": "Y2"})]

    def test_another_robots_fault_is_not_its_own(self, stage):
        play = stage(emitting("{trigger: program_fault, robot: B1}"))
        play.fail("Y2")
        play.play()
        assert told(play) == []


class TestTriggerTouches:
    def test_it_fires_when_they_come_into_contact_not_while_they_stay_so(self, stage):
        play = stage(emitting("{trigger: touches, entity: ball, other: robots}"))
        for tick in range(1, 10):
            if tick in {3, 4, 5, 8}:
                play.touch("ball", "B1")
            play.play()
        assert told(play) == [3, 8]

    def test_walls_are_a_thing_too(self, stage):
        play = stage(emitting("{trigger: touches, entity: [B1, ball], other: walls}"))
        play.touch("ball", "walls")
        play.touch("Y1", "walls")
        play.play(2)
        assert told(play) == [1]
        assert play.firings[0].entity == "ball"

    def test_a_placed_entity_has_no_contacts(self, stage):
        play = stage(
            emitting("{trigger: touches, entity: ball, other: B1}"),
            "rules: {back: {triggers: [{trigger: time_reached, at_s: 0.064}], "
            "actions: [{action: place, entity: ball, at: {point: [0, 0.2]}}]}}",
        )
        for _ in range(4):
            play.touch("ball", "B1")
            play.play()
        assert told(play) == [1, 3]


class TestTriggerTipsOver:
    def test_it_fires_when_a_robot_falls_and_again_only_after_it_stood(self, stage):
        play = stage(emitting("{trigger: tips_over, entity: robots, angle_rad: 1.0}"))
        play.play(3)
        play.tip("B2")
        play.play(5)
        assert told(play) == [4]
        assert play.firings[0].measured == pytest.approx(1.5708, abs=1e-4)
        play.place("B2", 0.0, 0.3)
        play.play()
        play.tip("B2")
        play.play()
        assert told(play) == [4, 10]


class TestTriggerHolds:
    def rules(self, more: str) -> str:
        return emitting(f"{{trigger: holds, condition: {{condition: in_zone, entity: ball, zone: right}}, {more}}}")

    def inside(self, play: ScriptedMatch, *, inside: bool, ticks: int) -> None:
        play.place("ball", 0.3 if inside else 0.0, 0.0)
        play.play(ticks)

    def test_it_fires_once_after_the_condition_held_for_a_time(self, stage):
        play = stage(self.rules("for_s: 0.32"))
        self.inside(play, inside=False, ticks=4)
        self.inside(play, inside=True, ticks=50)  # from tick 5 on
        assert told(play) == [15]

    def test_it_fires_again_at_intervals(self, stage):
        play = stage(self.rules("for_s: 0.32, every_s: 0.64"))
        self.inside(play, inside=True, ticks=55)
        assert told(play) == [11, 31, 51]

    def test_what_pays_by_the_second_pays_a_minute_sixty_times(self, stage):
        play = stage(self.rules("for_s: 1, every_s: 1"))
        self.inside(play, inside=True, ticks=1 + 60 * 1000 // 32)
        assert told(play)[:3] == [33, 64, 95]  # 32, 63 and 94 ticks after tick 1: 1, 2 and 3 s, each rounded up
        assert len(told(play)) == 60

    def test_a_short_interruption_counts_as_holding(self, stage):
        play = stage(self.rules("for_s: 0.32, grace_s: 0.064"))
        self.inside(play, inside=True, ticks=9)  # since tick 1, due at 11
        self.inside(play, inside=False, ticks=2)
        self.inside(play, inside=True, ticks=1)
        assert told(play) == [12]

    def test_a_longer_one_begins_anew(self, stage):
        play = stage(self.rules("for_s: 0.32, grace_s: 0.064"))
        self.inside(play, inside=True, ticks=9)
        self.inside(play, inside=False, ticks=3)
        self.inside(play, inside=True, ticks=20)
        assert told(play) == [23]

    @pytest.mark.parametrize(("for_s", "heard"), [(0, []), (0.05, [4])])
    def test_what_a_removal_makes_true_is_heard_by_what_must_last(self, stage, for_s, heard):
        empty = "{condition: in_zone, entity: [ball, Y1], zone: right, of: none}"
        play = stage(
            emitting(f"{{trigger: holds, condition: {empty}, for_s: {for_s}}}"),
            "rules: {gone: {triggers: [{trigger: touches, entity: Y2, other: ball}], "
            "actions: [{action: remove, entity: ball}]}}",
        )
        self.inside(play, inside=True, ticks=1)
        play.touch("Y2", "ball")  # in tick 2, at whose end it is taken off
        play.play(9)
        assert told(play) == heard

    def test_without_a_time_it_fires_when_the_condition_comes_true(self, stage):
        play = stage(self.rules("for_s: 0"))
        self.inside(play, inside=True, ticks=3)
        self.inside(play, inside=False, ticks=3)
        self.inside(play, inside=True, ticks=3)
        assert told(play) == [1, 7]

    def test_what_was_true_when_the_rule_came_to_life_does_not_fire(self, stage):
        play = stage("balls: {ball: {start_m: [0.3, 0]}}", self.rules("for_s: 0"))
        play.play(10)
        assert told(play) == []

    def test_a_placement_begins_anew(self, stage):
        play = stage(
            self.rules("for_s: 0.32"),
            "rules: {back: {triggers: [{trigger: time_reached, at_s: 0.16}], "
            "actions: [{action: place, entity: ball, at: {point: [0.3, 0.1]}}]}}",
        )
        self.inside(play, inside=True, ticks=30)
        assert told(play) == [15]
