"""A touch that goes on: a rule may hear it again and again, until the two let go of each other."""

import pytest

from rcj_challenges.core.timing import ticks_from_s
from rcj_challenges.expect.runner import run_test
from rcj_challenges.scenario.load import load_text
from tests.referee.building import event_ticks, touch

BUMPS = """
phases: {pause: {}}
rules:
  bump:
    triggers: [{trigger: touches, entity: yellow, other: ball, every_s: 0.5}]
    actions: [{action: emit, event: BUMP}]
  stop:
    triggers: [{trigger: event, event: NEVER}]
    actions: [{action: set_phase, phase: pause}]
"""


def stay_together(play, first, second, seconds):
    for _ in range(ticks_from_s(seconds)):
        touch(play, first, second)


class TestTouchThatLasts:
    def test_lasting_touch_fires_when_it_begins_and_at_each_interval_after(self, stage):
        play = stage(BUMPS)
        stay_together(play, "Y1", "ball", 2)
        # 0.5 s are 15.6 ticks, and that does not add up.
        assert event_ticks(play, "BUMP") == [1, 17, 33, 48]

    def test_after_letting_go_it_starts_again(self, stage):
        play = stage(BUMPS)
        stay_together(play, "Y1", "ball", 0.32)
        play.play(20)
        stay_together(play, "Y1", "ball", 0.64)
        assert event_ticks(play, "BUMP") == [1, 31, 47]

    def test_each_pair_has_its_own_time(self, stage):
        play = stage(BUMPS)
        stay_together(play, "Y1", "ball", 0.32)
        for _ in range(16):
            play.touch("Y1", "ball")
            touch(play, "Y2", "ball")
        # Y1 at 1 and 17, Y2 at 11.
        assert event_ticks(play, "BUMP") == [1, 11, 17]

    def test_lasting_touch_does_not_fire_in_another_phase_and_restarts_after_it(self, stage):
        play = stage("""
phases: {pause: {lasts_s: 0.64, next: play}}
rules:
  bump:
    triggers: [{trigger: touches, entity: yellow, other: ball, every_s: 0.96}]
    actions: [{action: emit, event: BUMP}]
  stop:
    triggers: [{trigger: time_reached, at_s: 0.32}]
    actions: [{action: set_phase, phase: pause}]
""")
        stay_together(play, "Y1", "ball", 3)
        assert event_ticks(play, "BUMP") == [1, 60, 90]


class TestTouchInATest:
    FILE = """
schema_version: 2
id: it
title: It
extends: soccersim_v2
match: {half_s: 60}
timers: {untouched: {lasts_s: 1}}
rules:
  touched:
    triggers: [{trigger: touches, entity: robots, other: ball, every_s: 0.2}]
    actions: [{action: timer, timer: untouched, do: restart}]
  lost:
    triggers: [{trigger: timer_expired, timer: untouched}]
    actions: [{action: emit, event: LOST}]
expect:
  the_ball_is_lost_a_second_after_the_robot_let_go:
    keyframes: [{at_s: 1, touch: [[Y1, ball]], touch_lasts_s: 3}%s]
    lasts_s: 10
    events: [{event: LOST, at_s: %s, tolerance_s: 0.25}]
"""

    @pytest.mark.parametrize(
        ("also", "lost_s"),
        [("", 5), (", {at_s: 2}", 5), (", {at_s: 3, touch: [[Y1, ball]], touch_lasts_s: 2}", 6)],
    )
    def test_a_hand_may_hold_two_together_for_a_time(self, also, lost_s):
        loaded = load_text(self.FILE % (also, lost_s))
        assert run_test(loaded, *loaded.scenario.expect).differences == ()

    def test_what_a_rule_puts_elsewhere_is_out_of_the_hand(self, stage):
        play = stage("""
rules:
  put_back:
    triggers: [{trigger: touches, entity: yellow, other: ball}]
    actions: [{action: place, entity: ball, at: {point: [0, 0.3]}}, {action: emit, event: PUT}]
""")
        play.touch("Y1", "ball", 50)
        play.play(60)
        assert event_ticks(play, "PUT") == [1]
