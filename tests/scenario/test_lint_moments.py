"""Lint of moments that a rule cannot hear because it does not live then."""

from __future__ import annotations

import pytest

from rcj_challenges.referee.trials import try_expectation
from rcj_challenges.scenario.lint.table import Finding, lint
from rcj_challenges.scenario.load import load_text

HEAD = "schema_version: 1\nid: it\ntitle: It\nextends: soccersim_v2\nmatch: {half_s: 60}\n"
GOAL = (
    "  goal: {triggers: [{trigger: enters, entity: ball, zone: blue_goal}], "
    "actions: [{action: score, entrant: yellow}, %s], says: A goal.}\n"
)
TO_PAUSE = GOAL % "{action: set_phase, phase: pause}"
TOLD = "  %s: {%striggers: [%s], actions: [{action: emit, event: TOLD}], says: Told.}\n"


def rule(trigger: str, phases: str = "", name: str = "told") -> str:
    return TOLD % (name, f"phases: {phases}, " if phases else "", trigger)


def found(sections: str, rules: str) -> list[Finding]:
    """Return what is said of rules that wait for what they cannot hear."""
    findings = lint(load_text(f"{HEAD}{sections}\nrules:\n{rules}", file="it.yaml"))
    return [one for one in findings if one.kind in ("moment_may_be_missed", "rule_never_fires")]


def kinds(sections: str, rules: str) -> list[str]:
    return [one.kind for one in found(sections, rules)]


AT_10_S = "{trigger: time_reached, at_s: 10}"
PAUSE = "phases: {pause: {lasts_s: 3}}"


class TestMomentsThatMayBeMissed:
    def test_a_time_that_may_come_in_the_pause_after_a_goal(self):
        (one,) = found(PAUSE, TO_PAUSE + rule(AT_10_S))
        assert str(one) == (
            "it.yaml:9:21: warning: rules.told.triggers[0] (time_reached): it lives in play only, and 10 s may also come in "
            "phase pause: then it never fires; write phases: [play, pause], or phases: any; if that is meant, phases: "
            "[play] [moment_may_be_missed]"
        )

    def test_who_waits_for_more_than_one_time_may_miss_one(self):
        assert found(PAUSE, TO_PAUSE + rule("{trigger: time_reached, at_s: 10, every_s: 10}")) == []

    def test_a_phase_that_is_entered_again_and_again_may_be_any_time(self):
        again = "  rests: {triggers: [{trigger: time_reached, at_s: 5, every_s: 12}], actions: [{action: set_phase, phase: pause}]}\n"
        assert kinds(PAUSE, again + rule("{trigger: time_reached, at_s: 18}")) == ["moment_may_be_missed"]

    @pytest.mark.parametrize("phases", ["[play]", "[play, pause]", "any"])
    def test_whoever_writes_phases_has_thought_of_it(self, phases):
        assert found(PAUSE, TO_PAUSE + rule(AT_10_S, phases)) == []

    def test_what_another_rule_hears_in_the_pause_is_not_missed(self):
        assert found(PAUSE, TO_PAUSE + rule(AT_10_S) + rule(AT_10_S, "[pause]", "other")) == []

    def test_in_a_pause_that_stops_the_clock_no_time_comes(self):
        assert found("phases: {pause: {lasts_s: 3, clock: stops}}", TO_PAUSE + rule(AT_10_S)) == []

    def test_a_phase_that_is_over_before_or_begins_with_that_rule_or_later_does_not_count(self):
        first = "phases: {warm_up: {lasts_s: 3}}\nfirst_phase: warm_up"
        assert found(first, GOAL % "{action: end}" + rule(AT_10_S)) == []
        enters = (
            "  late: {triggers: [{trigger: time_reached, at_s: %s}], actions: [{action: set_phase, phase: pause}]}\n"
        )
        for at_s, phases in (("10", "pause: {}"), ("20", "pause: {lasts_s: 3}")):
            assert found(f"phases: {{{phases}}}", GOAL % "{action: end}" + enters % at_s + rule(AT_10_S)) == []
        assert kinds("phases: {pause: {}}", GOAL % "{action: end}" + enters % "9" + rule(AT_10_S)) == [
            "moment_may_be_missed"
        ]

    def test_a_timer_of_the_half_is_a_time_and_one_that_rules_start_is_not(self):
        timer = "timers: {t: {lasts_s: 10, starts: true}}\n"
        expired = rule("{trigger: timer_expired, timer: t}")
        assert kinds(timer + PAUSE, TO_PAUSE + expired) == ["moment_may_be_missed"]
        again = GOAL % "{action: timer, timer: t}, {action: set_phase, phase: pause}"
        assert found(timer + PAUSE, again + expired) == []

    def test_phases_that_take_turns_all_the_time_are_followed(self):
        turns = "phases: {a: {lasts_s: 4, next: b}, b: {lasts_s: 6, next: a}}\nfirst_phase: a"
        assert kinds(turns, rule("{trigger: time_reached, at_s: 22}", "[b]")) == ["rule_never_fires"]
        assert found(turns, rule("{trigger: time_reached, at_s: 22}", "[a]")) == []

    def test_of_times_that_come_again_one_must_come_while_the_rule_lives(self):
        turns = "phases: {a: {lasts_s: 4, next: b}, b: {lasts_s: 6, next: a}}\nfirst_phase: a"
        every = "{trigger: time_reached, at_s: 2, every_s: %s}"
        assert kinds(turns, rule(every % "10", "[b]")) == ["rule_never_fires"]
        assert found(turns, rule(every % "9", "[b]")) == []  # 2, 11, 20, 29: the last is in b
        assert found(turns, rule(every % "10", "[a]")) == []

    def test_of_very_many_turns_nothing_is_said(self):
        turns = "phases: {a: {lasts_s: 0.04, next: b}, b: {lasts_s: 0.04, next: a}}\nfirst_phase: a"
        assert found(turns, rule("{trigger: time_reached, at_s: 50}", "[b]")) == []
        assert found(turns, rule("{trigger: time_reached, at_s: 50}", "[a]")) == []


class TestMomentsThatNeverCome:
    FIRST = "phases: {toss: {lasts_s: 2}}\nfirst_phase: toss\ntimers: {t: {lasts_s: 4, starts: true}}"

    @pytest.mark.parametrize("trigger", ["{trigger: time_reached, at_s: 5}", "{trigger: timer_expired, timer: t}"])
    def test_a_time_after_the_end_of_a_phase_that_never_comes_back(self, trigger):
        (one,) = found(self.FIRST, GOAL % "{action: end}" + rule(trigger, "[toss]"))
        assert one.kind == "rule_never_fires"
        assert "it lives only in phase toss, which at " in one.problem.message
        assert one.problem.message.endswith("s is not going on; what may be then is play")
        assert one.remedy == "write phases: [play], or phases: any"

    def test_a_time_before_a_phase_can_begin(self):
        early = rule("{trigger: time_reached, at_s: 1}")
        assert kinds(self.FIRST, GOAL % "{action: end}" + early) == ["rule_never_fires"]
        assert found(self.FIRST, GOAL % "{action: set_phase, phase: toss}" + rule(AT_10_S, "[toss]")) == []

    @pytest.mark.parametrize(("lasts_s", "never"), [(2, True), (1, False)])
    def test_of_a_drawn_length_the_shortest_and_the_longest_count(self, lasts_s, never):
        drawn = (
            f"draws: {{d: {{values: [{lasts_s}, 3]}}}}\nphases: {{toss: {{lasts_s: {{draw: d}}}}}}\nfirst_phase: toss"
        )
        early = rule("{trigger: time_reached, at_s: 1.5}", "[play]")
        assert kinds(drawn, GOAL % "{action: end}" + early) == ["rule_never_fires"] * never

    def test_what_lint_calls_never_never_comes(self):
        test = "expect: {it: {keyframes: [{at_s: 0}], lasts_s: 20, events: []}}\n"
        loaded = load_text(
            f"{HEAD}{self.FIRST}\n{test}rules:\n" + rule("{trigger: time_reached, at_s: 5}", "[toss]"), file="it.yaml"
        )
        assert try_expectation(loaded, "it").differences == ()


class TestTimersThatHaveRunOut:
    TIMERS = "timers: {t: {lasts_s: 3, starts: true}, own: {lasts_s: 3, per: yellow, starts: true}}"

    @pytest.mark.parametrize(
        ("timer", "asked", "for_each", "never"),
        [
            ("t", "", False, True),
            ("t", "negate: true", False, False),
            ("t", "at_most: 2", False, True),
            ("t", "at_most: 3", False, True),  # 3 s are 3.008 s in whole ticks
            ("t", "at_most: 4", False, False),
            ("t", "at_least: 3", False, False),
            ("t", "at_least: 2, negate: true", False, True),
            ("t", "at_most: {counter: yellow}", False, False),
            ("own", "", False, False),
            ("own", "entity: Y1", False, False),
            ("own", "entity: each", True, True),
            ("own", "entity: each, negate: true", True, False),
        ],
    )
    def test_a_condition_on_the_timer_whose_end_is_waited_for(self, timer, asked, for_each, never):
        condition = f"{{condition: timer, timer: {timer}{', ' if asked else ''}{asked}}}"
        expired = TOLD % (
            "r",
            f"{'for_each: yellow, ' if for_each else ''}conditions: [{condition}], ",
            f"{{trigger: timer_expired, timer: {timer}}}",
        )
        assert kinds(self.TIMERS, GOAL % "{action: end}" + expired) == ["rule_never_fires"] * never

    def test_the_finding_says_that_it_runs_no_longer(self):
        for several in ("all_of", "any_of"):
            condition = f"{{condition: {several}, conditions: [{{condition: timer, timer: t}}]}}"
            expired = TOLD % ("r", f"conditions: [{condition}], ", "{trigger: timer_expired, timer: t}")
            (one,) = found(self.TIMERS, GOAL % "{action: end}" + expired)
            assert one.problem.message.startswith("when it fires the timer has run out and stands at its length")
            assert one.remedy.endswith("a timer that has run out is running no longer")
