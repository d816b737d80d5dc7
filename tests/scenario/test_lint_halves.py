"""Lint of times that a half is too short for, where halves have lengths of their own."""

from __future__ import annotations

import pytest

from rcj_challenges.scenario.lint.table import lint
from rcj_challenges.scenario.load import load_text

HEAD = "schema_version: 1\nid: it\ntitle: It\nextends: soccersim_v2\n"
RULE = (
    "rules:\n  told:\n    phases: any\n    triggers: [{trigger: time_reached, at_s: %s}]\n%s"
    "    actions: [{action: emit, event: TOLD}]\n    says: Told.\n"
)
KINDS = ("time_not_in_every_half", "rule_never_fires")


def found(at_s: float, half_s: str = "[60, 30]", condition: str = "", overrides: tuple[str, ...] = ()) -> list[str]:
    """Return what is said of a rule that waits for a time."""
    halves = half_s.count(",") + 1
    asked = f"    conditions: [{condition}]\n" if condition else ""
    text = f"{HEAD}match: {{halves: {halves}, half_s: {half_s}}}\n{RULE % (at_s, asked)}"
    return [str(one) for one in lint(load_text(text, overrides, file="it.yaml")) if one.kind in KINDS]


class TestTimesThatAShorterHalfDoesNotReach:
    def test_the_second_half_is_over_before(self):
        assert found(45) == [
            (
                "it.yaml:9:16: warning: rules.told.triggers[0] (time_reached): half 2 is over before 45 s: it does not fire "
                "there; correct the time, or say which halves are meant: {condition: half, …} [time_not_in_every_half]"
            )
        ]

    @pytest.mark.parametrize(("at_s", "half_s"), [(30, "[60, 30]"), (45, "[60, 45]"), (45, "60"), (45, "[60, 60]")])
    def test_every_half_reaches_it(self, at_s, half_s):
        assert found(at_s, half_s) == []

    @pytest.mark.parametrize(
        "condition",
        [
            "{condition: half, equals: 1}",
            "{condition: half, at_least: 2, negate: true}",
            "{condition: any_of, conditions: [{condition: half, at_most: 1}]}",
        ],
    )
    def test_whoever_asks_for_the_half_has_thought_of_it(self, condition):
        assert found(45, condition=condition) == []

    def test_in_the_half_that_is_asked_for_it_never_comes(self):
        (one,) = found(45, condition="{condition: half, equals: 2}")
        assert (
            "half 2 is over before 45 s, and the rule asks for no other: it never fires; correct the time, or the half"
            in one
        )
        assert one.endswith("[rule_never_fires]")

    def test_halves_that_are_asked_for_in_part(self):
        (one,) = found(45, "[60, 30, 60, 20]", "{condition: half, at_least: 2}")
        assert "halves 2, 4 are over before 45 s" in one

    def test_of_a_half_that_is_not_played_something_else_is_said(self):
        assert found(45, condition="{condition: half, equals: 3}") == []

    def test_lengths_of_the_command_line_are_for_one_run(self):
        assert found(45, "60", overrides=("match.half_s=20",)) == []


class TestWhatIsHeardAfterTheEnd:
    RULES = (
        "rules:\n  bell:\n    triggers: [%s]\n%s    actions: [{action: emit, event: BELL}]\n    says: The bell.\n"
        "  pays: {triggers: [{trigger: event, event: %s}], actions: [{action: score, entrant: yellow}], says: Paid.}\n"
    )

    def said(
        self, trigger: str, half_s: str = "60", condition: str = "", event: str = "BELL", more: str = ""
    ) -> list[str]:
        halves = half_s.count(",") + 1
        asked = f"    conditions: [{condition}]\n" if condition else ""
        text = f"{HEAD}match: {{halves: {halves}, half_s: {half_s}}}\n{more}{self.RULES % (trigger, asked, event)}"
        return [str(one) for one in lint(load_text(text, file="it.yaml")) if one.kind == "heard_after_the_end"]

    def test_an_event_of_the_last_tick(self):
        assert self.said("{trigger: time_reached, at_s: 60}") == [
            (
                "it.yaml:8:16: warning: rules.bell.triggers[0] (time_reached): 60 s is the last tick of the half; BELL, for "
                "which 'pays' waits, would be heard one tick later: nobody hears it; do it in this rule itself, let the other "
                "one wait for half_ended, or choose an earlier time [heard_after_the_end]"
            )
        ]

    def test_each_half_has_a_last_tick_of_its_own(self):
        assert len(self.said("{trigger: time_reached, at_s: 30}", "[60, 30]")) == 1
        assert self.said("{trigger: time_reached, at_s: 30}", "[60, 30]", "{condition: half, equals: 1}") == []

    def test_a_timer_that_starts_with_the_half_and_is_as_long(self):
        timers = "timers: {whole: {lasts_s: 60, starts: true}}\n"
        expired = "{trigger: timer_expired, timer: whole}"
        assert len(self.said(expired, more=timers)) == 1
        assert self.said(expired, more=timers + "phases: {pause: {lasts_s: 3, clock: stops}}\n") == []

    def test_what_comes_a_tick_sooner_or_is_waited_for_by_nobody(self):
        assert self.said("{trigger: time_reached, at_s: 59.968}") == []
        assert self.said("{trigger: time_reached, at_s: 60}", event="OTHER") == []


class TestHalvesThatAreOverAsTheyBegin:
    RULE = "rules:\n  over:\n    triggers: [{trigger: half_started}]\n%s    actions: [%s]\n    says: It is over.\n"

    def found(self, more: str = "", actions: str = "{action: end}", rest: str = "", halves: int = 2) -> list[str]:
        """Return what is said of a rule that ends the half as it begins."""
        text = f"{HEAD}match: {{halves: {halves}, half_s: 60}}\n{self.RULE % (more, actions)}{rest}"
        return [str(one) for one in lint(load_text(text, file="it.yaml")) if one.kind == "over_as_it_begins"]

    def test_every_half_is_over_at_once(self):
        (one,) = self.found()
        assert one == (
            "it.yaml:8:16: warning: rules.over.triggers[0] (half_started): it ends each half as it begins: nothing can "
            "be played; wait for something that happens in play, or say by a condition when it is over [over_as_it_begins]"
        )

    def test_of_one_half_and_of_the_match(self):
        assert "it ends the half as it begins: nothing can be played" in self.found(halves=1)[0]
        (one,) = self.found(actions="{action: score, entrant: blue}, {action: end, what: match}")
        assert "it ends the match as it begins: nothing can be played" in one

    def test_a_half_that_is_asked_for(self):
        (one,) = self.found("    conditions: [{condition: half, equals: 2}]\n")
        assert "it ends half 2 as it begins: nothing can be played in it" in one
        (one,) = self.found(
            "    conditions: [{condition: half, at_least: 2}]\n", "{action: end, what: match}", halves=3
        )
        assert "it ends the match as half 2 begins: nothing can be played in it" in one

    @pytest.mark.parametrize(
        ("more", "actions", "rest"),
        [
            ("    conditions: [{condition: counter, counter: blue, at_least: 1}]\n", "{action: end}", ""),
            ("    conditions: [{condition: half, equals: 3}]\n", "{action: end}", ""),
            ("", "{action: score, entrant: blue}", ""),
            # Only the first of them counts, or enters a phase in which the second one does not live.
            ("    exclusive: one\n", "{action: end}", ""),
            ("    for_each: obstacles\n", "{action: end}", ""),
            (
                "    phases: [later]\n",
                "{action: end}",
                (
                    "  go: {triggers: [{trigger: time_reached, at_s: 9}], actions: [{action: set_phase, phase: later}]}\n"
                    "phases: {later: {}}\n"
                ),
            ),
        ],
    )
    def test_whether_it_is_over_at_once_is_not_known(self, more, actions, rest):
        assert self.found(more, actions, rest) == []

    def test_a_rule_that_enters_another_phase_first_may_stop_it(self):
        first = "  first: {triggers: [{trigger: half_started}], priority: -1, actions: [{action: set_phase, phase: later}]}\n"
        assert self.found(rest=f"{first}phases: {{later: {{}}}}\n") == []
