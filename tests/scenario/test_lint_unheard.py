"""Lint of what comes in the very tick in which another phase begins, so that a rule does not hear it."""

from __future__ import annotations

import pytest

from rcj_challenges.referee.trials import try_expectation
from rcj_challenges.scenario.lint.table import Finding, lint
from rcj_challenges.scenario.load import load_text

HEAD = (
    "schema_version: 1\nid: it\ntitle: It\nextends: soccersim_v2\nmatch: {half_s: 60}\n"
    "phases: {pause: {lasts_s: 1}, other: {}}\ncounters: {goals: {}}\nflags: {up: {}}\ndraws: {d: {values: [a, b]}}\n"
)
BALL_AT_1_S = (
    "expect: {it: {keyframes: [{at_s: 1, place: {ball: [0, 0.8]}}], lasts_s: 10, events: [{event: GOAL}%s]}}\n"
)
GOAL = (
    "  goal: {triggers: [{trigger: enters, entity: ball, zone: blue_goal}], actions: [{action: emit, event: GOAL}, %s],"
    " says: A goal.}\n"
)
SET_PAUSE = "{action: set_phase, phase: pause}"
SCORE, COUNT = "{action: score, entrant: yellow}", "{action: count, counter: goals}"
ON_GOAL = "{trigger: event, event: GOAL}"


def holds(condition: str, more: str = "") -> str:
    return f"{{trigger: holds, condition: {{{condition}}}{more}}}"


SCORE_IS_1 = holds("condition: counter, counter: yellow, at_least: 1")
COUNTER_IS_1 = holds("condition: counter, counter: goals, at_least: 1")
FLAG_IS_UP = holds("condition: flag, flag: up")


def told(trigger: str, phases: str = "", name: str = "told") -> str:
    where = f"phases: {phases}, " if phases else ""
    return f"  {name}: {{{where}triggers: [{trigger}], actions: [{{action: emit, event: TOLD}}], says: Told.}}\n"


def found(rules: str) -> list[Finding]:
    findings = lint(load_text(f"{HEAD}rules:\n{rules}", file="it.yaml"))
    return [one for one in findings if one.kind in ("moment_may_be_missed", "rule_never_fires")]


def kinds(rules: str) -> list[str]:
    return [one.kind for one in found(rules)]


def fires(rules: str) -> bool:
    """Return whether TOLD is announced after a goal at 1 s."""
    loaded = load_text(f"{HEAD}{BALL_AT_1_S % ', {event: TOLD}'}rules:\n{rules}", file="it.yaml")
    return try_expectation(loaded, "it").differences == ()


class TestWhatComesWithAnotherPhase:
    @pytest.mark.parametrize(
        ("change", "trigger"),
        [
            (SCORE, SCORE_IS_1),
            (COUNT, COUNTER_IS_1),
            ("{action: set_flag, flag: up}", FLAG_IS_UP),
            ("{action: toggle_flag, flag: up}", FLAG_IS_UP),
            (SCORE, ON_GOAL),
        ],
        ids=["score", "counter", "flag", "flag turned over", "event"],
    )
    def test_who_hears_it_in_play_alone_never_fires(self, change, trigger):
        rules = GOAL % f"{change}, {SET_PAUSE}" + told(trigger)
        assert kinds(rules) == ["rule_never_fires"]
        assert not fires(rules)
        for phases in ("any", "[play, pause]"):
            heard = GOAL % f"{change}, {SET_PAUSE}" + told(trigger, phases)
            assert kinds(heard) == []
            assert fires(heard)

    def test_the_finding_of_an_event_says_which_rule_enters_which_phase(self):
        (one,) = found(GOAL % f"{SCORE}, {SET_PAUSE}" + told(ON_GOAL))
        assert str(one) == (
            "it.yaml:12:21: warning: rules.told.triggers[0] (event): an event is heard one tick later; "
            "with rule 'goal' phase pause begins, in which this rule does not live; "
            "write phases: [play, pause], or phases: any [rule_never_fires]"
        )

    def test_the_finding_of_a_condition_says_when_it_comes_true(self):
        (one,) = found(GOAL % f"{SCORE}, {SET_PAUSE}" + told(SCORE_IS_1))
        assert "holds without for_s fires only in the moment in which its condition comes true" in one.problem.message
        assert "with rule 'goal' phase pause begins, in which this rule does not live" in one.problem.message
        assert one.remedy == "write phases: [play, pause], or phases: any"

    def test_what_must_hold_for_a_time_or_is_paid_again_and_again_counts_anew_in_play(self):
        for more in (", for_s: 0.5", ", every_s: 1"):
            rules = GOAL % f"{SCORE}, {SET_PAUSE}" + told(
                holds("condition: counter, counter: yellow, at_least: 1", more)
            )
            assert kinds(rules) == []

    def test_an_event_is_heard_if_the_phase_is_over_by_then(self):
        rules = GOAL % f"{SCORE}, {SET_PAUSE}" + told(ON_GOAL)
        short = HEAD.replace("pause: {lasts_s: 1}", "pause: {lasts_s: 0.032}")
        findings = lint(load_text(f"{short}rules:\n{rules}", file="it.yaml"))
        assert [one for one in findings if one.kind == "rule_never_fires"] == []
        back = (
            "  back: {phases: any, triggers: [{trigger: enters, entity: ball, zone: blue_goal}], "
            "actions: [{action: set_phase, phase: play}]}\n"
        )
        assert kinds(rules + back) == []
        assert fires(rules + back)

    @pytest.mark.parametrize(
        ("change", "missed"),
        [("to: 0", False), ("to: 1", True), ("to: [0, {word: halftime}]", True), ("to: 0, at_least: 1", True)],
    )
    def test_what_sets_the_counter_back_does_not_make_it_reach_a_limit(self, change, missed):
        set_back = GOAL % f"{{action: count, counter: goals, {change}}}, {SET_PAUSE}"
        counts = "  counts: {triggers: [{trigger: touches, entity: Y1, other: ball}], actions: [{action: count, counter: goals}]}\n"
        assert kinds(counts + set_back + told(COUNTER_IS_1)) == (["moment_may_be_missed"] if missed else [])
        under = holds("condition: counter, counter: goals, at_least: 1, negate: true")
        assert (kinds(set_back + told(under)) != []) == (
            change in ("to: 0", "to: [0, {word: halftime}]", "to: 0, at_least: 1")
        )

    def test_what_changes_only_while_the_rule_does_not_live(self):
        rules = (
            GOAL % SET_PAUSE
            + told(COUNTER_IS_1)
            + "  again: {phases: [pause], triggers: [{trigger: phase_entered, phase: pause}], actions: [%s]}\n"
        )
        assert kinds(rules % COUNT) == ["rule_never_fires"]
        assert kinds(rules % f"{COUNT}, {{action: set_phase, phase: play}}") == ["rule_never_fires"]
        assert not fires(rules % COUNT)

    def test_a_phase_entered_anew_begins_anew_what_lives_in_it(self):
        rules = GOAL % f"{SCORE}, {{action: set_phase, phase: play}}"
        assert kinds(rules + told(SCORE_IS_1)) == ["rule_never_fires"]
        assert not fires(rules + told(SCORE_IS_1))
        assert kinds(rules + told(ON_GOAL)) == []
        assert fires(rules + told(ON_GOAL))


class TestWhatIsAnnouncedInAnotherPhase:
    """The rule that announces it enters no phase: a tick later its own still goes on, or what follows at once."""

    LEAVES = GOAL % "{action: set_phase, phase: other}"
    CHEERS = (
        "  cheers: {phases: [other], triggers: [{trigger: phase_entered, phase: other}], "
        "actions: [{action: emit, event: CHEER}], says: Cheers.}\n"
    )
    ON_CHEER = "{trigger: event, event: CHEER}"

    def fires(self, rules: str) -> bool:
        text = f"{HEAD}{BALL_AT_1_S % ', {event: CHEER}, {event: TOLD}'}rules:\n{self.LEAVES}{self.CHEERS}{rules}"
        return try_expectation(load_text(text, file="it.yaml"), "it").differences == ()

    def test_who_lives_in_play_alone_never_hears_it(self):
        rules = told(self.ON_CHEER)
        (one,) = found(self.LEAVES + self.CHEERS + rules)
        assert one.kind == "rule_never_fires"
        assert "an event is heard one tick later; rule 'cheers' brings that about in a phase in which" in str(one)
        assert "write phases: [play, other], or phases: any" in str(one)
        assert not self.fires(rules)

    @pytest.mark.parametrize("phases", ["[other]", "[play, other]", "any"])
    def test_who_lives_in_that_phase_hears_it(self, phases):
        rules = told(self.ON_CHEER, phases)
        assert found(self.LEAVES + self.CHEERS + rules) == []
        assert self.fires(rules)

    def test_who_lives_in_a_phase_that_may_follow_at_once_may_hear_it(self):
        back = "  back: {phases: [other], triggers: [{trigger: phase_entered, phase: other}], actions: [{action: set_phase, phase: play}]}\n"
        rules = back + told(self.ON_CHEER)
        assert found(self.LEAVES + self.CHEERS + rules) == []
        assert self.fires(rules)

    def test_two_phases_farther_on_nobody_hears_it_but_who_lives_in_both(self):
        on = "  on: {phases: [other], triggers: [{trigger: touches, entity: Y1, other: ball}], actions: [{action: set_phase, phase: pause}]}\n"
        assert [one.kind for one in found(self.LEAVES + self.CHEERS + on + told(self.ON_CHEER))] == ["rule_never_fires"]
        at_once = (
            on.replace("[other], triggers", "[other, pause], triggers")
            .replace("  on:", "  out:")
            .replace("pause}]", "play}]")
        )
        assert found(self.LEAVES + self.CHEERS + on + at_once + told(self.ON_CHEER)) == []


class TestWhatComesWithTheEnd:
    OVER = "  over: {phases: any, triggers: [{trigger: half_ended}], actions: [{action: emit, event: GOAL}], says: Over.}\n"

    @pytest.mark.parametrize("trigger", [ON_GOAL, SCORE_IS_1, FLAG_IS_UP], ids=["an event", "a score", "a flag"])
    def test_after_the_end_of_the_half_nobody_hears_anything(self, trigger):
        rules = GOAL % f"{SCORE}, {{action: set_flag, flag: up}}, {{action: end}}" + told(trigger, "any")
        (one,) = found(rules)
        assert one.kind == "rule_never_fires"
        assert "with rule 'goal' the half is over" in one.problem.message
        assert one.remedy == "do it in rule 'goal' itself, or wait for half_ended"
        assert not fires(rules)

    def test_what_the_end_of_the_half_announces_is_heard_by_nobody(self):
        (one,) = found(self.OVER + told(ON_GOAL, "any"))
        assert one.kind == "rule_never_fires"
        assert "with rule 'over' the half is over" in one.problem.message

    def test_if_it_also_comes_before_the_end_the_end_needs_no_word(self):
        assert kinds(GOAL % SCORE + self.OVER + told(ON_GOAL)) == []


class TestWhatMayAlsoComeOtherwise:
    PENALTY = "  penalty: {triggers: [{trigger: touches, entity: Y1, other: walls}], actions: [%s], says: A penalty.}\n"

    @pytest.mark.parametrize(
        ("change", "trigger"), [(SCORE, SCORE_IS_1), ("{action: emit, event: GOAL}", ON_GOAL)], ids=["score", "event"]
    )
    def test_of_several_ways_one_may_be_missed(self, change, trigger):
        both = GOAL % f"{SCORE}, {SET_PAUSE}" + self.PENALTY % change
        assert kinds(both + told(trigger)) == ["moment_may_be_missed"]
        assert kinds(both + told(trigger, "[play]")) == []  # whoever writes phases has thought of it
        assert kinds(both + told(trigger) + told(trigger, "any", "other")) == []

    @pytest.mark.parametrize(
        ("other_way", "condition"),
        [
            ("{action: score, entrant: yellow, points: -1}", "condition: counter, counter: yellow, at_most: -3"),
            ("{action: set_flag, flag: up, to: false}", "condition: flag, flag: up, negate: true"),
            ("{action: draw, draw: d, as: b}", "condition: drawn, draw: d, equals: b"),
        ],
        ids=["points less", "flag cleared", "draw set to another value"],
    )
    def test_a_change_that_cannot_make_it_true_does_not_count(self, other_way, condition):
        ways = f"{SCORE}, {{action: set_flag, flag: up}}, {{action: draw, draw: d, as: a}}, {SET_PAUSE}"
        assert kinds(GOAL % ways + self.PENALTY % other_way + told(holds(condition))) == []

    def test_of_what_also_depends_on_places_nothing_is_said(self):
        several = (
            "condition: all_of, conditions: [{condition: flag, flag: up}, "
            "{condition: in_zone, entity: Y1, zone: blue_penalty_area}]"
        )
        assert kinds(GOAL % f"{{action: set_flag, flag: up}}, {SET_PAUSE}" + told(holds(several))) == []

    def test_several_conditions_on_what_rules_remember_are_looked_into(self):
        several = (
            "condition: any_of, conditions: [{condition: flag, flag: up}, "
            "{condition: counter, counter: goals, at_least: 3}]"
        )
        rules = GOAL % f"{{action: set_flag, flag: up}}, {COUNT}, {SET_PAUSE}"
        assert kinds(rules + told(holds(several))) == ["rule_never_fires"]
