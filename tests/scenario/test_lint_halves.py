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
