"""``other``: the one that is touched, asked about and acted upon by name."""

import pytest

from rcj_challenges.records.referee_log import firing_line
from tests.referee.building import touch

TAG = """
flags: {catcher: {per: robots}}
rules:
  begins:
    triggers: [{trigger: half_started}]
    actions: [{action: set_flag, flag: catcher, entity: Y1}]
  caught:
    for_each: robots
    triggers: [{trigger: touches, entity: each, other: robots}]
    conditions:
      - {flag: catcher, entity: each}
      - {flag: catcher, entity: other, negate: true}
    actions:
      - {action: set_flag, flag: catcher, entity: other}
      - {action: set_flag, flag: catcher, entity: each, to: false}
      - {action: emit, event: CAUGHT, payload: {by: {word: robot_name}, who: {word: other_name}}}
    says: '{entity} has caught {other}.'
"""


def caught(play):
    return [(event.payload["by"], event.payload["who"]) for event in play.events_named("CAUGHT")]


class TestTag:
    @pytest.mark.parametrize("runner", ["Y2", "B1", "B2"])
    def test_the_robot_that_the_catcher_touches_is_the_catcher_now(self, stage, runner):
        play = stage(TAG)
        play.play()
        touch(play, runner, "Y1")
        assert caught(play) == [("Y1", runner)]
        assert [name for name, is_one in play.referee.flags["catcher"].items() if is_one] == [runner]

    def test_a_touch_that_goes_on_does_not_catch_back(self, stage):
        play = stage(TAG)
        play.play()
        for _ in range(20):
            touch(play, "Y1", "B2")
        play.play(7)
        touch(play, "Y1", "B2")
        assert caught(play) == [("Y1", "B2"), ("B2", "Y1")]

    def test_the_log_names_both(self, stage):
        play = stage(TAG)
        play.play()
        touch(play, "Y1", "B2")
        (firing,) = [firing for firing in play.firings if firing.rule == "caught"]
        assert (firing.entity, firing.other, firing.says) == ("Y1", "B2", "Y1 has caught B2.")
        assert firing_line(1, firing)["other"] == "B2"


BUMPS = """
counters: {bumped: {per: robots}}
rules:
  bump:
    for_each: robots
    triggers: [{trigger: touches, entity: each, other: robots}]
    actions:
      - {action: count, counter: bumped, entity: other}
      - {action: emit, event: BUMP, payload: {who: {word: robot_name}, other: {word: other_name}}}
    %s
"""


def bumps(play):
    return [(event.payload["who"], event.payload["other"]) for event in play.events]


class TestSeveralAtOnce:
    def touched(self, stage, extra=""):
        play = stage(BUMPS % extra)
        play.play()
        play.touch("Y2", "B1")
        play.touch("Y1", "B2")
        touch(play, "B1", "Y1")
        return play

    def test_it_fires_once_for_each_of_them_in_their_order(self, stage):
        play = self.touched(stage)
        assert bumps(play) == [("B1", "Y1"), ("B1", "Y2"), ("B2", "Y1"), ("Y1", "B1"), ("Y1", "B2"), ("Y2", "B1")]
        assert play.referee.counters["bumped"] == {"B1": 2, "B2": 1, "Y1": 2, "Y2": 1}

    @pytest.mark.parametrize(("extra", "stopped_by"), [("cooldown_s: 1", "cooldown"), ("exclusive: one", "exclusive")])
    def test_a_cooldown_or_an_exclusive_group_lets_only_the_first_of_them_count(self, stage, extra, stopped_by):
        play = self.touched(stage, extra)
        assert bumps(play) == [("B1", "Y1"), ("B2", "Y1"), ("Y1", "B1"), ("Y2", "B1")]
        stopped = [(f.entity, f.other, f.suppressed) for f in play.firings if f.suppressed]
        assert stopped == [("B1", "Y2", stopped_by), ("Y1", "B2", stopped_by)]

    def test_each_of_them_is_one_of_the_times_it_may_fire(self, stage):
        play = self.touched(stage, "max_executions: 1")
        play.play()
        play.touch("B1", "Y2")
        touch(play, "B2", "Y2")
        assert bumps(play) == [("B1", "Y1"), ("B2", "Y1"), ("Y1", "B1"), ("Y2", "B1")]


def test_a_cooldown_may_be_a_number_of_the_one_that_was_touched(stage):
    limit = "cooldown_s: {counter: bumped, entity: other}"
    play = stage(BUMPS.replace("{per: robots}", "{per: robots, initial: 2}") % limit)
    play.play()
    touch(play, "B1", "Y1")
    play.play(40)
    touch(play, "B1", "Y1")
    assert bumps(play) == [("B1", "Y1"), ("Y1", "B1")]
    play.play(80)
    touch(play, "B1", "Y1")
    assert bumps(play) == [("B1", "Y1"), ("Y1", "B1")] * 2


class TestWhatItMayStandFor:
    def test_without_for_each_it_is_the_one_that_was_touched(self, stage):
        play = stage("""
        rules:
          out:
            triggers: [{trigger: touches, entity: ball, other: robots}]
            actions: [{action: place, entity: other, at: {relative_to: ball, offset_m: [0, 0.3]}, facing: keep}]
        """)
        play.play()
        touch(play, "Y2", "ball")
        assert play.pose("Y2")[:2] == pytest.approx((0.0, 0.3))
        assert play.pose("Y1")[:2] == pytest.approx((-0.4, -0.5))

    @pytest.mark.parametrize(
        ("wall", "tells"), [("walls", "Y1 has touched walls."), ("post", "Y1 has touched post."), ("B1", "")]
    )
    def test_walls_and_fixed_obstacles_are_named(self, stage, wall, tells):
        play = stage("""
        obstacles: {post: {shape: cylinder, radius_m: 0.05, height_m: 0.1, centre_m: [0, 0.3]}}
        rules:
          foul:
            for_each: yellow
            triggers: [{trigger: touches, entity: each, other: [walls, post]}]
            actions: [{action: emit, event: FOUL}]
            says: '{entity} has touched {other}.'
        """)
        play.play()
        play.touch("Y1", wall)
        assert "".join(firing.says for firing in play.play().firings) == tells

    def test_each_of_several_triggers_finds_its_own(self, stage):
        play = stage("""
        rules:
          bump:
            for_each: yellow
            triggers:
              - {trigger: touches, entity: each, other: B1}
              - {trigger: touches, entity: ball, other: each}
            actions: [{action: emit, event: BUMP, payload: {who: {word: robot_name}, other: {word: other_name}}}]
        """)
        play.play()
        play.touch("Y1", "B1")
        play.touch("Y2", "ball")
        touch(play, "Y1", "B2")
        assert bumps(play) == [("Y1", "B1"), ("Y2", "Y2")]

    def test_the_only_toucher_needs_no_counter_of_its_own(self, stage):
        play = stage("""
        groups: {runners: [Y2, Y3, B1, B2, B3]}
        counters: {caught: {per: runners}}
        rules:
          tag:
            triggers: [{trigger: touches, entity: Y1, other: robots}]
            actions: [{action: count, counter: caught, entity: other}]
        """)
        play.play()
        touch(play, "Y1", "B2")
        assert play.referee.counters["caught"] == {"Y2": 0, "Y3": 0, "B1": 0, "B2": 1, "B3": 0}

    def test_points_go_to_the_entrant_that_drives_it(self, stage):
        play = stage("""
        rules:
          pushed:
            for_each: robots
            triggers: [{trigger: touches, entity: each, other: robots}]
            conditions: [{entity: each, looks: other, within_rad: 0.3}]
            actions: [{action: score, entrant: other, points: -1}]
        """)
        play.play()
        play.place("Y1", 0.0, 0.0, 1.57)
        play.place("B1", 0.0, 0.16, 1.57)
        play.touch("Y1", "B1")
        (firing,) = play.play().firings
        assert (firing.entity, firing.other, firing.scored) == ("Y1", "B1", {"blue": -1})

    def test_what_is_measured_of_it_is_emitted_and_paid(self, stage):
        play = stage("""
        counters: {weight: {per: robots, initial: 3}}
        rules:
          heavy:
            for_each: yellow
            triggers: [{trigger: touches, entity: each, other: blue}]
            conditions:
              - any_of:
                  - {distance: [each, other], at_most: 0.3}
                  - {entity: other, in: middle}
            actions:
              - {action: score, entrant: yellow, points: {counter: weight, entity: other, times: 2}}
              - action: emit
                event: BUMP
                payload: {at: {position_of: other}, far: {distance: [each, other]}}
        """)
        play.play()
        play.touch("Y1", "B1")
        assert not play.play().events
        play.play(7)
        play.place("Y1", -0.2, 0.0)
        play.place("B1", 0.0, 0.0, 0.5)
        play.touch("Y1", "B1")
        (event,) = play.play().events
        assert event.payload == {"at": [0.0, 0.0, 0.5], "far": 0.2}
        assert play.referee.scores["yellow"] == 6
