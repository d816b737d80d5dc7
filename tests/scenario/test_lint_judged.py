"""Lint of attempts that two rules judge, because the rule that ends them hears of it only one tick later."""

from __future__ import annotations

import pytest

from rcj_challenges.scenario.lint.table import Finding, lint
from rcj_challenges.scenario.load import load_text

HEAD = (
    "schema_version: 1\nid: it\ntitle: It\nextends: soccersim_v2\nmatch: {half_s: 60}\n"
    "timers: {attempt: {lasts_s: 15, starts: true}}\nflags: {judged: {}}\n"
    "phases: {ready: {lasts_s: 3, next: play}}\nrules:\n"
)
IN_TIME, LATE = "{event: IN_TIME, trigger: event}", "{event: LATE, trigger: event}"
RUNS = "{condition: timer, timer: attempt}"
RESTART, STOP = "{action: timer, timer: attempt, do: restart}", "{action: timer, timer: attempt, do: stop}"
READY = "{action: set_phase, phase: ready}"


def there(*more: str, conditions: str = "", phases: str = "[play]") -> str:
    actions = ", ".join(("{action: score, entrant: yellow}", *more, "{action: emit, event: IN_TIME}"))
    return (
        f"  there: {{phases: {phases}, triggers: [{{trigger: enters, entity: ball, zone: blue_goal}}], "
        f"conditions: [{conditions}], actions: [{actions}], says: There.}}\n"
    )


def late(*more: str, conditions: str = "", told: str = "{action: emit, event: LATE}") -> str:
    actions = ", ".join(one for one in ("{action: score, entrant: yellow, points: -1}", *more, told) if one)
    return (
        "  late: {triggers: [{trigger: timer_expired, timer: attempt}], "
        f"conditions: [{conditions}], actions: [{actions}], says: Late.}}\n"
    )


def after(*actions: str, triggers: str = f"{IN_TIME}, {LATE}") -> str:
    return f"  after: {{triggers: [{triggers}], actions: [{', '.join(actions)}]}}\n"


def found(rules: str) -> list[Finding]:
    return [one for one in lint(load_text(HEAD + rules, file="it.yaml")) if one.kind == "judged_twice"]


def rules_of(rules: str) -> list[str]:
    return [one.problem.path.removeprefix("rules.") for one in found(rules)]


class TestTheTimerRunsOutInTheTickBetween:
    def test_the_timer_is_restarted_by_the_rule_that_hears_the_outcome(self):
        (one,) = found(there() + late(told="") + after(RESTART, triggers=IN_TIME))
        assert str(one) == (
            "it.yaml:10:3: warning: rules.there: it judges, and 'after', which hears IN_TIME one tick later, ends the "
            "attempt: the timer 'attempt' may run out in that tick, and then 'late' judges too; end it in this rule: "
            "{action: timer, timer: attempt, do: stop}, or set_phase [judged_twice]"
        )

    def test_the_phase_is_left_by_the_rule_that_hears_both(self):
        assert rules_of(there() + late() + after(READY)) == ["there", "late"]

    def test_a_rule_that_counts_judges_as_well(self):
        counts = there().replace("{action: score, entrant: yellow}", "{action: count, counter: hits}")
        section = HEAD.replace("rules:\n", "counters: {hits: {}}\nrules:\n")
        text = section + counts + late(told="") + after(RESTART, triggers=IN_TIME)
        assert [one.kind for one in lint(load_text(text))].count("judged_twice") == 1

    @pytest.mark.parametrize("ends", [STOP, RESTART, READY, "{action: end}"])
    def test_an_outcome_that_ends_the_attempt_itself_is_judged_once(self, ends):
        assert rules_of(there(ends) + late(told="") + after(RESTART, triggers=IN_TIME)) == []

    def test_so_is_one_whose_moment_another_rule_hears_that_stops_the_timer(self):
        stops = there(STOP).replace("  there:", "  stops:").replace("IN_TIME", "STOPPED")
        assert rules_of(there() + stops + late(told="") + after(RESTART, triggers=IN_TIME)) == []

    def test_leaving_a_phase_for_another_reason_than_the_time_is_none_of_it(self):
        assert rules_of(there() + late(told="") + after(READY, triggers=IN_TIME)) == []

    def test_rules_that_never_live_in_one_phase(self):
        assert rules_of(there(phases="[ready]") + late(told="") + after(RESTART, triggers=IN_TIME)) == []

    @pytest.mark.parametrize(
        ("ends", "reported"),
        # What counts an attempt that has ended its phase comes in the phase after it, wherever else it may live.
        [((READY,), []), ((), ["counted"])],
    )
    def test_a_rule_that_hears_the_outcome_judges_in_the_phase_that_comes_with_it(self, ends, reported):
        rules = (
            f"  there: {{triggers: [{{trigger: enters, entity: ball, zone: blue_goal}}], actions: "
            f"[{', '.join(('{action: emit, event: IN_TIME}', *ends))}], says: There.}}\n"
            f"  counted: {{phases: any, triggers: [{IN_TIME}], says: Counted., actions: "
            "[{action: score, entrant: yellow}, {action: emit, event: COUNTED}]}\n"
            "  over: {phases: any, triggers: [{trigger: event, event: COUNTED}], actions: [{action: end}]}\n"
        )
        assert rules_of(rules + late(READY, told="")) == reported

    @pytest.mark.parametrize(
        ("first", "then"),
        [
            (
                "{condition: in_zone, entity: Y1, zone: pitch}",
                "{condition: in_zone, entity: Y1, zone: pitch, negate: true}",
            ),
            ("{condition: timer, timer: attempt, at_most: 10}", ""),
        ],
    )
    def test_conditions_that_exclude_each_other(self, first, then):
        assert (
            rules_of(there(conditions=first) + late(conditions=then, told="") + after(RESTART, triggers=IN_TIME)) == []
        )

    @pytest.mark.parametrize(
        ("sets", "asked"),
        [
            ("{action: set_flag, flag: judged}", "{condition: flag, flag: judged, negate: true}"),
            ("{action: toggle_flag, flag: judged}", "{condition: flag, flag: judged, negate: true}"),
            ("{action: count, counter: judgements}", "{condition: counter, counter: judgements, equals: 0}"),
            ("{action: draw, draw: open}", "{condition: drawn, draw: open, equals: left}"),
            (
                "{action: count, counter: judgements}",
                (
                    "{condition: any_of, conditions: [{condition: half, equals: 2}, "
                    "{condition: counter, counter: judgements, equals: 0}]}"
                ),
            ),
        ],
    )
    def test_what_the_outcome_changes_and_the_other_rule_asks(self, sets, asked):
        kept = "counters: {judgements: {}}\ndraws: {open: {values: [left, right]}}\n"
        rules = late(conditions=asked, told="") + after(RESTART, triggers=IN_TIME)
        loaded = [load_text(kept + HEAD + outcome + rules, file="it.yaml") for outcome in (there(sets), there())]
        assert [[one.kind for one in lint(one)].count("judged_twice") for one in loaded] == [0, 1]


class TestTheOutcomeComesInTheTickAfterTheTimeWasUp:
    def test_it_is_said_of_the_rule_of_the_time(self):
        (one,) = found(there(STOP) + late() + after(RESTART))
        assert str(one).removeprefix("it.yaml:11:3: warning: ") == (
            "rules.late: it judges, and 'after', which hears LATE one tick later, ends the attempt: in that tick 'there' "
            "may judge too; let that rule ask {condition: timer, timer: attempt}, which holds while the timer runs, or "
            "set_phase in this one [judged_twice]"
        )

    def test_an_outcome_that_counts_only_while_the_timer_runs_is_judged_once(self):
        assert rules_of(there(STOP, conditions=RUNS) + late() + after(RESTART)) == []

    def test_that_it_runs_is_not_enough_for_the_tick_before(self):
        assert rules_of(there(conditions=RUNS) + late() + after(RESTART)) == ["there"]

    @pytest.mark.parametrize("ends", [RESTART, READY])
    def test_so_is_an_attempt_that_the_rule_of_the_time_ends_itself(self, ends):
        assert rules_of(there(STOP) + late(ends) + after(RESTART)) == []


class TestWhatHasHeldAsksForTheTimerItself:
    """The condition of ``holds`` is asked in the tick in which it fires, as those of the rule are."""

    @staticmethod
    def outcome(condition: str, *, grace: str = "") -> list[str]:
        holds = f"{{trigger: holds, for_s: 0.5{grace}, condition: {condition}}}"
        rule = there(STOP).replace("{trigger: enters, entity: ball, zone: blue_goal}", holds)
        return rules_of(rule + late() + after(RESTART))

    def test_of_a_running_timer_nothing_is_judged_when_it_has_run_out(self):
        in_goal = "{condition: in_zone, entity: ball, zone: blue_goal}"
        assert self.outcome(f"{{condition: all_of, conditions: [{in_goal}, {RUNS}]}}") == []
        assert self.outcome(RUNS) == []

    def test_who_does_not_ask_for_it_is_judged_twice(self):
        in_goal = "{condition: in_zone, entity: ball, zone: blue_goal}"
        assert self.outcome(in_goal) == ["late"]
        assert self.outcome(f"{{condition: any_of, conditions: [{in_goal}, {RUNS}]}}") == ["late"]

    @pytest.mark.parametrize(("at_most", "judged"), [("10", []), ("15", ["there"])])
    def test_who_asks_for_a_time_well_before_the_end_is_not_judged_twice_by_it(self, at_most, judged):
        in_time = f"{{condition: timer, timer: attempt, at_most: {at_most}}}"
        holds = f"{{trigger: holds, for_s: 0.5, condition: {in_time}}}"
        rule = there().replace("{trigger: enters, entity: ball, zone: blue_goal}", holds)
        assert rules_of(rule + late(told="") + after(RESTART, triggers=IN_TIME)) == judged

    def test_an_interruption_that_counts_as_holding_reaches_past_its_end(self):
        assert self.outcome(RUNS, grace=", grace_s: 0.2") == ["late"]

    def test_another_trigger_of_the_rule_may_still_come(self):
        holds = f"{{trigger: holds, for_s: 0.5, condition: {RUNS}}}, {{trigger: enters, entity: ball, zone: blue_goal}}"
        rule = there(STOP).replace("{trigger: enters, entity: ball, zone: blue_goal}", holds)
        assert rules_of(rule + late() + after(RESTART)) == ["late"]
