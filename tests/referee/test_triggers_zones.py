"""Triggers about places: enters, leaves, stays_in, displaced."""

import pytest

from tests.referee.building import IN_MIDDLE, event_ticks, feed, hears, once, payloads, place, rule

IN, OUT = (0.3, 0.0), (0.0, 0.0)
"""In the zone `right`, and in the middle."""


def seen(play, *ball_at: tuple[float, float]) -> None:
    """Judge one tick in which the ball is seen at these places, and leave it at the last."""
    feed(play, *ball_at)
    play.place("ball", *ball_at[-1])


class TestTriggerEnters:
    CAME = hears(IN_MIDDLE[len("{trigger: ") : -1])

    def test_it_fires_once_when_the_centre_comes_in(self, stage):
        play = stage(self.CAME)
        place(play, "ball", *IN, ticks=3)
        assert event_ticks(play) == []
        place(play, "ball", 0.05, 0.0, ticks=5)
        assert event_ticks(play) == [4]

    @pytest.mark.parametrize(("x_m", "ticks"), [(0.25, []), (0.2501, [1])])
    def test_a_centre_on_the_line_is_not_in(self, stage, x_m, ticks):
        play = stage("zones: {half: {shape: rect, x_min_m: 0.25}}", hears("enters, entity: ball, zone: half"))
        place(play, "ball", x_m, 0.0)
        assert event_ticks(play) == ticks

    def test_from_one_zone_of_a_list_into_another_is_no_entering(self, stage):
        zones = "zones: {a: {shape: rect, x_min_m: 0.1, x_max_m: 0.3}, b: {shape: rect, x_min_m: 0.2, x_max_m: 0.5}}"
        play = stage(zones, hears("enters, entity: ball, zone: [a, b]"))
        for x in (0.15, 0.25, 0.4):
            place(play, "ball", x, 0.0)
        assert event_ticks(play) == [1]

    def test_a_visit_of_one_sub_step_is_not_missed(self, stage):
        play = stage(self.CAME)
        place(play, "ball", *IN)
        seen(play, (0.2, 0.0), (0.05, 0.0), (0.2, 0.0), IN)
        assert event_ticks(play) == [2]

    def test_of_a_group_the_first_entity_is_named(self, stage):
        named = "{action: emit, event: TOLD, payload: {who: {word: entity_name}}}"
        play = stage(rule("trigger: enters, entity: robots, zone: middle", named))
        play.place("Y1", 0.05, 0.0)
        place(play, "B2", -0.05, 0.0)
        assert (payloads(play), play.firings[0].entity) == ([{"who": "B2"}], "B2")


class TestTriggerLeaves:
    WENT = hears("leaves, entity: ball, zone: [middle, right]")

    def test_it_fires_when_the_centre_leaves_all_of_them(self, stage):
        play = stage(self.WENT)
        play.play()
        place(play, "ball", 0.2, 0.0)  # out of the middle, but now on the right
        place(play, "ball", -0.3, 0.0, ticks=3)
        assert event_ticks(play) == [3]

    def test_an_absence_of_one_sub_step_is_not_missed(self, stage):
        play = stage(self.WENT)
        play.play()  # in the middle
        seen(play, (-0.05, 0.0), (-0.15, 0.0), (-0.05, 0.0), OUT)
        assert event_ticks(play) == [2]


STAYS = rule(
    "trigger: stays_in, entity: ball, zone: right, limit_s: 1.6, grace_s: 0.32",  # 50 ticks, grace 10 ticks
    "{action: emit, event: TOLD, payload: {measured: {word: measured}, limit: {word: limit}}}",
)


class TestTriggerStaysIn:
    def test_it_fires_once_when_the_stay_is_longer_than_the_limit(self, stage):
        play = stage(STAYS)
        play.play(9)
        place(play, "ball", *IN, ticks=200)  # in from tick 10 on
        assert (event_ticks(play), payloads(play)) == ([61], [{"measured": 1.632, "limit": 1.6}])

    @pytest.mark.parametrize(
        ("sections", "course", "ticks"),
        [
            pytest.param([], [(IN, 45), (OUT, 10), (IN, 5)], [56], id="a short absence counts, it fires inside only"),
            pytest.param([], [(IN, 45), (OUT, 11), (IN, 52)], [108], id="after a longer absence a new stay begins"),
            pytest.param(["phases: {warm_up: {lasts_s: 0.64}}\nfirst_phase: warm_up"], [(IN, 100)], [71],
                         id="it counts from when the rule becomes active"),
        ],
    )  # fmt: skip
    def test_which_absence_ends_a_stay(self, stage, sections, course, ticks):
        play = stage(STAYS, *sections)
        for where, count in course:
            place(play, "ball", *where, ticks=count)
        assert event_ticks(play) == ticks

    def test_the_position_at_the_end_of_a_tick_decides_whether_it_is_inside(self, stage):
        play = stage(STAYS)
        seen(play, OUT, OUT, OUT, IN)
        play.play(44)
        seen(play, IN, IN, IN, OUT)  # outside from tick 46 on: ten ticks are no absence
        play.play(9)
        seen(play, OUT, OUT, OUT, IN)
        assert [one["measured"] for one in payloads(play)] == [55 * 0.032]

    def test_without_grace_one_sub_step_outside_begins_a_new_stay(self, stage):
        play = stage(STAYS.replace(", grace_s: 0.32", ""))
        place(play, "ball", *IN, ticks=30)
        seen(play, IN, (0.05, 0.0), IN, IN)
        play.play(60)
        assert event_ticks(play) == [82]

    def test_a_limit_that_ends_within_a_tick_is_passed_at_the_end_of_that_tick(self, stage):
        play = stage(STAYS.replace("limit_s: 1.6", "limit_s: 1.59"))
        place(play, "ball", *IN, ticks=60)  # in from tick 1 on
        assert (event_ticks(play), payloads(play)[0]["measured"]) == ([51], 1.6)


def displaced(more: str = "") -> str:
    reported = "{action: emit, event: TOLD, payload: {by: {word: measured}}}"
    return rule(f"trigger: displaced, entity: B1, distance_m: 0.05{more}", reported, name="moved")


class TestTriggerDisplaced:
    """B1 starts at (0.4, 0.5)."""

    @pytest.mark.parametrize(
        ("more", "places", "ticks"),
        [
            pytest.param("", [(0.4, 0.549), (0.4, 0.5502), (0.4, 0.5502)], [2], id="beyond the distance, once"),
            pytest.param("", [(0.44, 0.54)], [1], id="0.04 on each axis are 0.057 straight"),
            pytest.param(", axis: either", [(0.44, 0.54)], [], id="each axis measured by itself"),
            pytest.param("", [(0.5, 0.5), (0.4, 0.5), (0.5, 0.5)], [1, 3], id="again after coming back"),
            pytest.param(", from: [0.4, 0.48]", [(0.4, 0.529), (0.4, 0.531)], [2], id="from a point"),
        ],
    )
    def test_it_fires_where_it_has_been_moved_away(self, stage, more, places, ticks):
        play = stage(displaced(more))
        for where in places:
            place(play, "B1", *where)
        assert event_ticks(play) == ticks

    def test_it_measures_how_far(self, stage):
        play = stage(displaced())
        place(play, "B1", 0.4, 0.5502)
        assert payloads(play) == [{"by": pytest.approx(0.0502, abs=1e-6)}]

    def test_a_placement_is_the_new_origin(self, stage):
        play = stage(displaced(), once(2, "{action: place, entity: B1, at: {point: [0, 0.3]}}"))
        place(play, "B1", 0.4, 0.6, ticks=3)
        place(play, "B1", 0.0, 0.34, ticks=2)
        assert event_ticks(play) == [1]
        place(play, "B1", 0.0, 0.36)
        assert event_ticks(play) == [1, 6]


def turned(more: str) -> str:
    return rule(
        f"trigger: displaced, entity: B1, {more}", "{action: emit, event: TOLD, payload: {by: {word: measured}}}"
    )


class TestTriggerDisplacedByAnAngle:
    """B1 starts at (0.4, 0.5), facing -1.57."""

    @pytest.mark.parametrize(
        ("more", "poses", "ticks"),
        [
            pytest.param("angle_rad: 0.5", [(0.4, 0.5, -1.08), (0.4, 0.5, -1.06), (0.4, 0.5, -1.0)], [2], id="once"),
            pytest.param("angle_rad: 0.5", [(0.4, 0.5, -2.06), (0.4, 0.5, -2.08)], [2], id="the other way"),
            pytest.param("angle_rad: 2", [(0.4, 0.5, 3.0), (0.4, 0.5, 2.0)], [2], id="the shorter way around"),
            pytest.param("angle_rad: 0.5", [(0.9, 0.9, -1.57)], [], id="it may be anywhere"),
            pytest.param("angle_rad: 0.5, distance_m: 0.05", [(0.5, 0.5, -1.57)], [1], id="either: the distance"),
            pytest.param("angle_rad: 0.5, distance_m: 0.05", [(0.4, 0.5, 0.0)], [1], id="either: the angle"),
            pytest.param("angle_rad: 0.5, distance_m: 0.05", [(0.4, 0.5, 0.0), (0.5, 0.5, 0.0)], [1], id="both: once"),
            pytest.param("angle_rad: 0.5, from: [0, 0]", [(0.4, 0.5, 0.0)], [1], id="from where it was put"),
        ],
    )
    def test_it_fires_where_it_has_turned_away(self, stage, more, poses, ticks):
        play = stage(turned(more))
        for pose in poses:
            place(play, "B1", *pose)
        assert event_ticks(play) == ticks

    def test_a_placement_is_the_new_direction(self, stage):
        play = stage(
            turned("angle_rad: 0.5"),
            once(2, "{action: place, entity: B1, at: {point: [0, 0.3]}, facing: 1}", name="put"),
        )
        play.play(2)
        place(play, "B1", 0.0, 0.3, 0.6)
        assert event_ticks(play) == []
        place(play, "B1", 0.0, 0.3, 0.4)
        assert event_ticks(play) == [4]

    def test_only_a_distance_is_measured(self, stage):
        play = stage(turned("angle_rad: 0.5, distance_m: 0.05"))
        place(play, "B1", 0.4, 0.52, 0.0)
        place(play, "B1", 0.4, 0.5, -1.57)
        place(play, "B1", 0.4, 0.6, 0.0)
        assert [one["by"] for one in payloads(play)] == [None, pytest.approx(0.1)]
