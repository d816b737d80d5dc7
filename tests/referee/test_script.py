"""The stage itself, the `expect` blocks, and that every word has its tests."""

import time
from pathlib import Path

import pytest

from rcj_challenges.expect.runner import run_test
from rcj_challenges.scenario.load import Loaded, load
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.roster import Roster

SCENARIOS = sorted((Path(__file__).parents[2] / "scenarios").glob("*.yaml"))

RULES = """
zones: {goal: {shape: rect, y_min_m: 0.7}}
rules:
  goal:
    triggers: [{trigger: enters, entity: ball, zone: goal}]
    actions:
      - {action: score, entrant: yellow}
      - {action: emit, event: GOAL, payload: {who: yellow, points: 1, good: true}}
      - {action: place, entity: ball, at: {point: [0, 0.25]}}
  hit: {triggers: [{trigger: touches, entity: ball, other: B1}], actions: [{action: emit, event: HIT}]}
  fell: {triggers: [{trigger: tips_over, entity: B1}], actions: [{action: emit, event: FELL}]}
  broke: {triggers: [{trigger: program_fault, robot: B1}], actions: [{action: emit, event: BROKE}]}
counters: {goals: {initial: 2}}
flags: {up: {}}
"""


@pytest.fixture
def differences(small):
    def run(block: str) -> list[str]:
        scenario: Scenario = small(RULES, f"expect: {{it: {{lasts_s: 2, {block}}}}}")
        return list(run_test(Loaded(scenario, Roster.of(scenario), "test", None, {}), "it").differences)

    return run


GOAL = "keyframes: [{at_s: 0.32, place: {ball: [0, 0.75]}}]"


class TestExpect:
    def test_what_comes_as_expected_makes_no_difference(self, differences):
        assert differences(
            GOAL + ", events: [{event: GOAL, at_s: 0.32, payload: {points: 1, good: true}}], score: {yellow: 1, blue: 0}, "
            "counters: {goals: 2}, flags: {up: false}, phase: play, poses: {ball: [0, 0.25]}"
        ) == []  # fmt: skip

    def test_every_difference_is_told_in_words(self, differences):
        found = differences(
            GOAL + ", events: [{event: GOAL, at_s: 1, payload: {who: blue, good: false}}, {event: HIT, at_s: 0.5}], "
            "score: {yellow: 2}, counters: {goals: 3}, flags: {up: true}, phase: pause, poses: {ball: [0, 0.3]}"
        )
        assert found == [
            "differs: event 1 (GOAL): expected at 1 s, came at 0.32 s; up to 0.033 s off is allowed, more by tolerance_s beside at_s",
            "differs: event 1 (GOAL): expected who blue, is yellow",
            "differs: event 1 (GOAL): expected good false, is true",
            "missing: HIT at 0.5 s, event 2 of the test",
            "score of yellow: expected 2, is 1",
            "counter goals: expected 3, is 2",
            "flag up: expected true, is false",
            "phase: expected pause, is play",
            "ball: expected at (0, 0.3), is at (0, 0.25), 0.05 m off; up to 0.001 m off is allowed, more by tolerance_m",
        ]

    def test_who_is_held_at_the_end_is_compared_robot_by_robot(self, small):
        hold = "rules: {hold: {triggers: [{trigger: touches, entity: Y1, other: ball}], actions: [{action: hold, entity: Y1, for_s: 1}]}}"

        def compared(lasts_s, held, more="{}"):
            block = f"{{lasts_s: {lasts_s}, keyframes: [{{at_s: 1, touch: [[Y1, ball]]}}], held: {held}}}"
            scenario = small(hold, more, f"expect: {{it: {block}}}")
            return list(run_test(Loaded(scenario, Roster.of(scenario), "test", None, {}), "it").differences)

        assert compared(1.9, "{Y1: true, Y2: false}") == []
        assert compared(1.9, "{Y1: false, Y2: true}") == [
            "Y1 held: expected false, is true",
            "Y2 held: expected true, is false",
        ]
        assert compared(2.1, "{Y1: false}") == []
        assert compared(2.1, "{Y1: true}", "phases: {play: {robots: held}}") == []

    def test_a_late_event_says_what_the_test_allowed(self, differences):
        assert differences(GOAL + ", events: [{event: GOAL, at_s: 1, tolerance_s: 0.5}]") == [
            "differs: event 1 (GOAL): expected at 1 s, came at 0.32 s; up to 0.5 s off is allowed, more by tolerance_s beside at_s"
        ]
        assert differences(GOAL + ", events: [{event: GOAL, at_s: 1, tolerance_s: 0.68}]") == []

    def test_an_event_that_nobody_expected_is_a_difference_unless_ignored(self, differences):
        assert differences(GOAL + ", events: []") == ["superfluous: GOAL at 0.32 s (who yellow, points 1, good true)"]
        assert differences(GOAL + ", events: [], ignore: [GOAL]") == []
        assert differences(GOAL + ", events: [{event: GOAL}], ignore: [GOAL]") == []

    def test_things_glide_in_a_straight_line_from_the_keyframe_before(self, differences):
        glide = "keyframes: [{at_s: 0.32, place: {ball: [0.4, 0]}}, {at_s: 0.96, move: {ball: [0.4, 0.4, 1]}}]"
        assert differences(glide + ", poses: {ball: [0.4, 0.4]}") == []
        assert differences(glide.replace("lasts_s: 2", "") + ", events: []") == []

    def test_a_glide_enters_on_its_way_and_ends_where_the_referee_puts_the_thing(self, differences):
        assert differences(
            "keyframes: [{at_s: 0.32}, {at_s: 0.96, move: {ball: [0, 0.8]}}], "
            "events: [{event: GOAL, at_s: 0.88, tolerance_s: 0.05}], poses: {ball: [0, 0.25]}"
        ) == []  # fmt: skip

    def test_touches_tilts_and_faults_are_scripted_too(self, differences):
        assert differences(
            "keyframes: [{at_s: 0.64, touch: [[ball, B1]]}, {at_s: 0.96, tips: [B1]}, {at_s: 1.28, fault: [B1]}], "
            "events: [{event: HIT, at_s: 0.64}, {event: FELL, at_s: 0.96}, {event: BROKE, at_s: 1.28}]"
        ) == []  # fmt: skip

    def test_a_keyframe_at_0_is_seen_in_the_first_tick(self, differences):
        assert (
            differences("keyframes: [{at_s: 0, place: {ball: [0, 0.75]}}], events: [{event: GOAL, at_s: 0.032}]") == []
        )

    def test_draws_can_be_decided(self, small):
        scenario = small(
            "draws: {side: {values: [left, right]}}",
            "rules: {told: {triggers: [{trigger: half_started}], actions: [{action: emit, event: TOLD, payload: {side: {draw: side}}}]}}",
            "expect: {it: {lasts_s: 1, keyframes: [{at_s: 0}], draws: {side: right}, events: [{event: TOLD, payload: {side: right}}]}}",
        )
        assert list(run_test(Loaded(scenario, Roster.of(scenario), "test", None, {}), "it").differences) == []

    SERIES = (
        "draws: {side: {values: [left, right]}}",
        (
            "rules: {told: {triggers: [{trigger: touches, entity: Y1, other: ball}], "
            "actions: [{action: draw, draw: side}, {action: emit, event: TOLD, payload: {side: {draw: side}}}]}}"
        ),
    )

    def series(self, small, decided, sides, touches=(0.1, 0.2, 0.3)):
        frames = ", ".join(f"{{at_s: {at_s}, touch: [[Y1, ball]]}}" for at_s in touches)
        events = ", ".join(f"{{event: TOLD, payload: {{side: {side}}}}}" for side in sides)
        scenario = small(
            *self.SERIES,
            f"expect: {{it: {{lasts_s: 1, draws: {{side: {decided}}}, keyframes: [{frames}], events: [{events}]}}}}",
        )
        return list(run_test(Loaded(scenario, Roster.of(scenario), "test", None, {}), "it").differences)

    @pytest.mark.parametrize(
        "sides", [["left", "left", "right"], ["right", "left", "right"], ["left", "right", "left"]]
    )
    def test_all_draws_of_one_name_can_be_decided_one_after_the_other(self, small, sides):
        assert self.series(small, f"[left, {', '.join(sides)}]", sides) == []

    def test_where_a_test_fails_it_is_told_that_a_draw_was_not_drawn_as_often_as_it_decides(self, small):
        assert self.series(small, "[left, right, left, left]", ["left", "left"], (0.1, 0.2)) == [
            "differs: event 1 (TOLD): expected side left, is right",
            "note: side was drawn 3 times; draws decides 4 values",
        ]

    def test_score_and_counters_and_flags_can_be_given(self, differences):
        assert differences(
            "given: {score: {yellow: 3}, counters: {goals: 7}, flags: {up: true}}, "
            + GOAL
            + ", score: {yellow: 4, blue: 0}, counters: {goals: 7}, flags: {up: true}"
        ) == []  # fmt: skip
        assert differences("given: {score: {blue: 2.5}}, " + GOAL + ", score: {yellow: 1, blue: 2.5}") == []

    def test_what_is_kept_for_each_of_several_can_be_told_one_by_one(self, small):
        def run(block: str) -> list[str]:
            scenario = small(
                "counters: {laps: {per: robots, initial: 1}}",
                "flags: {out: {per: robots}}",
                "rules: {lap: {triggers: [{trigger: touches, entity: Y1, other: ball}], "
                "actions: [{action: count, counter: laps, entity: Y1}, {action: set_flag, flag: out, entity: Y1}]}}",
                f"expect: {{it: {{lasts_s: 1, keyframes: [{{at_s: 0.5, touch: [[Y1, ball]]}}], {block}}}}}",
            )
            return list(run_test(Loaded(scenario, Roster.of(scenario), "test", None, {}), "it").differences)

        given = "given: {counters: {laps: {B2: 7}}, flags: {out: {B2: true}}}"
        assert (
            run(f"{given}, counters: {{laps: {{Y1: 2, B2: 7, B1: 1}}}}, flags: {{out: {{B2: true, B1: false}}}}") == []
        )
        assert run(f"{given}, counters: {{laps: 11}}, flags: {{out: true}}") == []
        assert run("counters: {laps: {Y1: 3, B1: 1}}, flags: {out: {B1: true}}") == [
            "counter laps of Y1: expected 3, is 2",
            "flag out of B1: expected true, is false",
        ]

    def test_what_is_given_stands_before_the_first_rule_and_for_each_entity(self, small):
        scenario = small(
            "counters: {laps: {per: yellow}}",
            "flags: {handed_over: {keep: match}, out: {per: yellow}}",
            "rules: {told: {triggers: [{trigger: half_started}], conditions: [{condition: flag, flag: handed_over}], "
            "actions: [{action: emit, event: TOLD, payload: {laps: {counter: laps, entity: Y1}, out: {flag: out, entity: Y1}}}]}}",
            "expect: {it: {half: 2, given: {counters: {laps: 4}, flags: {handed_over: true, out: true}}, lasts_s: 1, "
            "keyframes: [{at_s: 0}], events: [{event: TOLD, payload: {laps: 4, out: true}}]}}",
        )
        assert list(run_test(Loaded(scenario, Roster.of(scenario), "test", None, {}), "it").differences) == []


@pytest.mark.parametrize("path", SCENARIOS, ids=lambda path: path.stem)
def test_the_tests_written_in_the_shipped_scenarios_pass(path):
    loaded = load(path)
    assert {name: found for name in loaded.scenario.expect if (found := list(run_test(loaded, name).differences))} == {}


def test_a_script_plays_at_200_times_real_time(match_play):
    play = match_play()
    play.play(100)
    best = min(_timed(play, 250) for _ in range(8))
    assert best < 250 * 0.032 / 200


def _timed(play, ticks: int) -> float:
    began = time.process_time()
    play.play(ticks)
    return time.process_time() - began
