"""Lint of phases that hold the robots."""

from __future__ import annotations

import pytest

from rcj_challenges.scenario.lint import lint
from rcj_challenges.scenario.load import load_text

HEAD = "schema_version: 1\nid: it\ntitle: It\nextends: soccersim_v2\nmatch: {half_s: 60}\n"
KINDS = ("hold_without_effect", "robots_never_free", "held_robot_makes_no_progress")
COUNTDOWN = "phases: {countdown: {lasts_s: %s, robots: held}}\nfirst_phase: countdown\n"
LAZY = (
    "rules:\n  lazy:\n    phases: %s\n"
    "    triggers: [{trigger: no_progress, entity: %s, distance_m: 0.1, within_s: 5}]\n"
    "    actions: [{action: score, entrant: blue}]\n    says: Nobody drives.\n"
)
NOBODY = "entrants: {blue: null, yellow: null}\n"


def found(text: str) -> list[str]:
    """Return what is said about phases that hold the robots."""
    return [str(one) for one in lint(load_text(HEAD + text, file="it.yaml")) if one.kind in KINDS]


class TestPhasesThatHoldRobots:
    def test_a_countdown_is_fine(self):
        assert found(COUNTDOWN % 3) == []

    def test_nobody_drives(self):
        assert found(COUNTDOWN % 3 + NOBODY) == [
            (
                "it.yaml:6:42: warning: phases.countdown.robots: no robot has a program, and so none drives; leave it out, or "
                "name who drives under entrants: [hold_without_effect]"
            )
        ]

    def test_the_robots_are_never_free(self):
        assert found("phases: {play: {robots: held}, pause: {lasts_s: 1, robots: held}}\n") == [
            (
                "it.yaml:6:25: warning: phases.play.robots: robots are held in every phase that is ever entered, play, so that "
                "none ever drives; enter a phase in which they are free: give this one lasts_s, or a rule that sets another "
                "[robots_never_free]"
            )
        ]
        assert found("phases: {wait: {robots: held}}\nfirst_phase: wait\n") != []

    def test_a_phase_that_is_never_entered_is_told_as_that_only(self):
        assert found("phases: {wait: {robots: held}}\n") == []


class TestHeldRobotsThatMustMove:
    @pytest.mark.parametrize("lasts", ["5", "8"])
    def test_a_window_as_long_as_the_phase(self, lasts):
        assert found(COUNTDOWN % lasts + LAZY % ("any", "yellow")) == [
            (
                "it.yaml:11:16: warning: rules.lazy.triggers[0] (no_progress): phase 'countdown' holds the robots for as long as "
                "the 5 s of this window or longer, and the rule lives in it: it finds robots that may not move; leave "
                "'countdown' out of its phases [held_robot_makes_no_progress]"
            )
        ]

    @pytest.mark.parametrize(
        ("lasts", "phases", "entity"),
        [("4.9", "any", "yellow"), ("8", "[play]", "yellow"), ("8", "any", "ball")],
        ids=["a shorter phase", "a rule that does not live in it", "the ball"],
    )
    def test_what_may_well_be_meant(self, lasts, phases, entity):
        assert found(COUNTDOWN % lasts + LAZY % (phases, entity)) == []

    def test_the_longest_that_a_draw_may_decide_counts(self):
        drawn = "draws: {wait: {values: [2, 6]}}\n" + COUNTDOWN % "{draw: wait}"
        assert len(found(drawn + LAZY % ("any", "robots"))) == 1
