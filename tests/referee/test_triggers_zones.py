"""Triggers about places: enters, leaves, stays_in, displaced."""

import pytest

from rcj_challenges.core.play import Snapshot
from rcj_challenges.expect.scripted_match import ScriptedMatch


def feed(play: ScriptedMatch, *ball_at: tuple[float, float]) -> None:
    """Judge one tick in which the ball is seen at these places, one a sub-step."""
    poses = [play.pose(name) for name in play.roster.entities]
    ball = play.roster.index["ball"]
    substeps = []
    for x, y in ball_at:
        poses = list(poses)
        poses[ball] = (x, y, 0.0)
        substeps.append(poses)
    play.tick += 1
    count = len(poses)
    play._take(play.referee.judge(Snapshot(play.tick, substeps, [0.04] * count, [1.0] * count, ((),) * len(ball_at))))
    play.place("ball", *ball_at[-1])


class TestTriggerEnters:
    RULES = """
    rules:
      came: {triggers: [{trigger: enters, entity: ball, zone: middle}], actions: [{action: emit, event: CAME}]}
    """

    def test_it_fires_once_when_the_centre_comes_in(self, stage):
        play = stage(self.RULES)
        play.place("ball", 0.3, 0.0)
        play.play(3)
        assert play.names() == []
        play.place("ball", 0.05, 0.0)
        play.play(5)
        assert [(event.name, event.tick) for event in play.events] == [("CAME", 4)]

    def test_what_is_in_at_the_start_does_not_enter(self, stage):
        play = stage(self.RULES)
        play.play(5)
        assert play.names() == []

    def test_a_centre_on_the_line_is_not_in(self, stage):
        play = stage("""
        zones: {half: {shape: rect, x_min_m: 0.25}}
        rules:
          came: {triggers: [{trigger: enters, entity: ball, zone: half}], actions: [{action: emit, event: CAME}]}
        """)
        play.place("ball", 0.25, 0.0)
        play.play()
        assert play.names() == []
        play.place("ball", 0.2501, 0.0)
        play.play()
        assert play.names() == ["CAME"]

    def test_from_one_zone_of_a_list_into_another_is_no_entering(self, stage):
        play = stage("""
        zones: {a: {shape: rect, x_min_m: 0.1, x_max_m: 0.3}, b: {shape: rect, x_min_m: 0.2, x_max_m: 0.5}}
        rules:
          came: {triggers: [{trigger: enters, entity: ball, zone: [a, b]}], actions: [{action: emit, event: CAME}]}
        """)
        for x in (0.15, 0.25, 0.4):
            play.place("ball", x, 0.0)
            play.play()
        assert play.names() == ["CAME"]

    def test_a_visit_of_one_sub_step_is_not_missed(self, stage):
        play = stage(self.RULES)
        play.place("ball", 0.3, 0.0)
        play.play()
        feed(play, (0.2, 0.0), (0.05, 0.0), (0.2, 0.0), (0.3, 0.0))
        assert play.names() == ["CAME"]

    def test_of_a_group_the_first_entity_is_named(self, stage):
        play = stage("""
        rules:
          came:
            triggers: [{trigger: enters, entity: robots, zone: middle}]
            actions: [{action: emit, event: CAME, payload: {who: {word: entity_name}}}]
        """)
        play.place("ball", 0.5, 0.0)
        play.place("Y1", 0.05, 0.0)
        play.place("B2", -0.05, 0.0)
        play.play()
        assert [event.payload for event in play.events] == [{"who": "B2"}]
        assert play.firings[0].entity == "B2"


class TestTriggerLeaves:
    RULES = """
    rules:
      went: {triggers: [{trigger: leaves, entity: ball, zone: [middle, right]}], actions: [{action: emit, event: WENT}]}
    """

    def test_it_fires_when_the_centre_leaves_all_of_them(self, stage):
        play = stage(self.RULES)
        play.play()
        play.place("ball", 0.2, 0.0)  # out of the middle, but now on the right
        play.play()
        assert play.names() == []
        play.place("ball", -0.3, 0.0)
        play.play(3)
        assert [event.tick for event in play.events] == [3]

    def test_what_was_never_in_cannot_leave(self, stage):
        play = stage(self.RULES)
        play.place("ball", -0.3, 0.0)
        play.play()
        before = len(play.events)
        play.place("ball", -0.4, 0.2)
        play.play(2)
        assert len(play.events) == before == 1

    def test_an_absence_of_one_sub_step_is_not_missed(self, stage):
        play = stage(self.RULES)
        play.play()  # in the middle
        feed(play, (-0.05, 0.0), (-0.15, 0.0), (-0.05, 0.0), (0.0, 0.0))
        assert play.names() == ["WENT"]


class TestTriggerStaysIn:
    RULES = """
    rules:
      long:
        triggers: [{trigger: stays_in, entity: ball, zone: right, limit_s: 1.6, grace_s: 0.32}]
        actions: [{action: emit, event: LONG, payload: {measured: {word: measured}, limit: {word: limit}}}]
    """  # 50 ticks, grace 10 ticks; the 51st is more than that

    def test_it_fires_once_when_the_stay_is_longer_than_the_limit(self, stage):
        play = stage(self.RULES)
        play.play(9)
        play.place("ball", 0.3, 0.0)
        play.play(200)  # in from tick 10 on
        assert [(event.tick, event.payload) for event in play.events] == [(61, {"measured": 1.632, "limit": 1.6})]

    def test_a_short_absence_counts_as_inside_and_it_fires_only_inside(self, stage):
        play = stage(self.RULES)
        play.place("ball", 0.3, 0.0)
        play.play(45)  # in from tick 1 on; at 52 it is longer than the limit
        play.place("ball", 0.0, 0.0)
        play.play(10)
        assert play.names() == []
        play.place("ball", 0.3, 0.0)
        play.play(5)
        assert [event.tick for event in play.events] == [56]

    def test_a_longer_absence_begins_a_new_stay(self, stage):
        play = stage(self.RULES)
        play.place("ball", 0.3, 0.0)
        play.play(45)
        play.place("ball", 0.0, 0.0)
        play.play(11)
        play.place("ball", 0.3, 0.0)
        play.play(50)
        assert play.names() == []
        play.play(2)
        assert [event.tick for event in play.events] == [108]

    def test_where_it_is_at_the_end_of_a_tick_says_whether_it_is_inside(self, stage):
        play = stage(self.RULES)
        feed(play, (0.0, 0.0), (0.0, 0.0), (0.0, 0.0), (0.3, 0.0))
        play.play(44)
        feed(play, (0.3, 0.0), (0.3, 0.0), (0.3, 0.0), (0.0, 0.0))  # outside from tick 46 on: ten ticks are no absence
        play.play(9)
        feed(play, (0.0, 0.0), (0.0, 0.0), (0.0, 0.0), (0.3, 0.0))
        assert [event.payload["measured"] for event in play.events] == [55 * 0.032]

    def test_without_grace_one_sub_step_outside_begins_a_new_stay(self, stage):
        play = stage(self.RULES.replace(", grace_s: 0.32", ""))
        play.place("ball", 0.3, 0.0)
        play.play(30)
        feed(play, (0.3, 0.0), (0.05, 0.0), (0.3, 0.0), (0.3, 0.0))
        play.play(50)
        assert play.names() == []
        play.play(1)
        assert [event.tick for event in play.events] == [82]

    def test_a_stay_that_goes_on_when_the_rule_comes_to_life_counts_from_then(self, stage):
        play = stage(
            """
        phases: {warm_up: {lasts_s: 0.64}}
        first_phase: warm_up
        """,
            self.RULES,
        )
        play.place("ball", 0.3, 0.0)
        play.play(100)
        assert [event.tick for event in play.events] == [71]

    def test_a_limit_that_ends_within_a_tick_is_passed_at_the_end_of_that_tick(self, stage):
        play = stage(self.RULES.replace("limit_s: 1.6", "limit_s: 1.59"))
        play.place("ball", 0.3, 0.0)
        play.play(60)  # in from tick 1 on
        assert [(event.tick, event.payload["measured"]) for event in play.events] == [(51, 1.6)]


class TestTriggerDisplaced:
    def rules(self, more: str = "") -> str:
        return f"""
        rules:
          moved:
            triggers: [{{trigger: displaced, entity: B1, distance_m: 0.05{more}}}]
            actions: [{{action: emit, event: MOVED, payload: {{by: {{word: measured}}}}}}]
        """

    def test_it_fires_beyond_the_distance_from_where_it_was_put(self, stage):
        play = stage(self.rules())
        play.place("B1", 0.4, 0.549)
        play.play()
        assert play.names() == []
        play.place("B1", 0.4, 0.5502)
        play.play(3)
        assert len(play.events) == 1
        assert play.events[0].payload["by"] == pytest.approx(0.0502, abs=1e-6)

    def test_either_axis_is_measured_by_itself(self, stage):
        straight, either = stage(self.rules()), stage(self.rules(", axis: either"))
        for play in (straight, either):
            play.place("B1", 0.44, 0.54)  # 0.04 on each axis, 0.057 straight
            play.play()
        assert straight.names() == ["MOVED"]
        assert either.names() == []

    def test_it_fires_again_after_coming_back(self, stage):
        play = stage(self.rules())
        for x in (0.5, 0.4, 0.5):
            play.place("B1", x, 0.5)
            play.play()
        assert play.names() == ["MOVED", "MOVED"]

    def test_a_placement_is_the_new_origin(self, stage):
        play = stage(
            self.rules(),
            """
        rules:
          back:
            triggers: [{trigger: event, event: MOVED}]
            actions: [{action: place, entity: B1, at: {point: [0, 0.3]}}]
        """,
        )
        play.place("B1", 0.4, 0.6)
        play.play(3)
        assert play.pose("B1")[:2] == pytest.approx((0.0, 0.3), abs=1e-6)
        play.place("B1", 0.0, 0.34)
        play.play(2)
        assert play.names() == ["MOVED"]
        play.place("B1", 0.0, 0.36)
        play.play(1)
        assert play.names() == ["MOVED", "MOVED"]

    def test_it_can_be_measured_from_a_point(self, stage):
        play = stage(self.rules(", from: [0.4, 0.48]"))
        play.place("B1", 0.4, 0.529)
        play.play()
        assert play.names() == []
        play.place("B1", 0.4, 0.531)
        play.play()
        assert play.names() == ["MOVED"]
