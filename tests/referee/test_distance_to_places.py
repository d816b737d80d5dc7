"""How far things are from zones and gates: the geometry against its outline point by point, then the words."""

from math import cos, dist, pi, sin

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rcj_challenges.referee.zones import region_of
from rcj_challenges.scenario.models.places import CircleZone, HalfPlaneZone, PolygonZone, RectZone, Zone
from tests.referee.building import ASKING, TAKEN_OFF, acted, at_tick_10, emitting, hears, payload, place
from tests.referee.test_regions import point, zones

Point = tuple[float, float]
WIDE_M = 4.0
"""Open sides and lines without an end are looked at so far: further than any point of these tests can be from them."""
STEPS = 400


def _along(a: Point, b: Point) -> list[Point]:
    shares = [k / STEPS for k in range(STEPS + 1)]
    return [(a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1])) for s in shares]


def outline(zone: Zone) -> tuple[list[Point], float]:
    """Return points of a zone's outline, and how far they are apart at most."""
    if isinstance(zone, CircleZone):
        (x, y), r = zone.centre_m, zone.radius_m
        turns = [2 * pi * k / STEPS for k in range(STEPS)]
        return [(x + r * cos(t), y + r * sin(t)) for t in turns], 2 * pi * r / STEPS
    if isinstance(zone, HalfPlaneZone):
        (x, y), (nx, ny) = zone.through_m, zone.normal
        far = WIDE_M / dist((0, 0), (nx, ny))
        sides = [((x - ny * far, y + nx * far), (x + ny * far, y - nx * far))]
    elif isinstance(zone, PolygonZone):
        sides = list(zip(zone.points_m, (*zone.points_m[1:], zone.points_m[0]), strict=True))
    else:
        x0 = -WIDE_M if zone.x_min_m is None else zone.x_min_m
        x1 = WIDE_M if zone.x_max_m is None else zone.x_max_m
        y0 = -WIDE_M if zone.y_min_m is None else zone.y_min_m
        y1 = WIDE_M if zone.y_max_m is None else zone.y_max_m
        drawn = {
            "x_min_m": ((x0, y0), (x0, y1)), "x_max_m": ((x1, y0), (x1, y1)),
            "y_min_m": ((x0, y0), (x1, y0)), "y_max_m": ((x0, y1), (x1, y1)),
        }  # fmt: skip
        sides = [side for key, side in drawn.items() if getattr(zone, key) is not None]
    points = [one for a, b in sides for one in _along(a, b)]
    return points, max(dist(a, b) for a, b in sides) / STEPS


half_open = st.builds(
    lambda sides, inverted: RectZone(shape="rect", inverted=inverted, **sides),
    st.fixed_dictionaries(
        {}, optional={"x_min_m": st.floats(-1, -0.1), "x_max_m": st.floats(0.1, 1), "y_min_m": st.floats(-1, -0.1)}
    ).filter(bool),
    st.booleans(),
)


class TestGeometry:
    @given(zones | half_open, point)
    def test_outside_it_is_as_far_as_the_nearest_point_of_the_outline_and_inside_it_is_0(self, zone, here):
        region = region_of(zone)
        points, step_m = outline(zone)
        nearest = min(dist(here, one) for one in points)
        assert nearest - step_m / 2 - 1e-9 <= region.outline_m(*here) <= nearest + 1e-9
        assert region.away_m(*here) == (0.0 if region.contains(*here) else region.outline_m(*here))

    @given(zones | half_open, point, st.lists(point, max_size=30))
    def test_no_point_of_the_zone_is_nearer(self, zone, here, others):
        region = region_of(zone)
        assert all(region.away_m(*here) <= dist(here, one) + 1e-9 for one in others if region.contains(*one))

    def test_from_a_corner_it_is_the_straight_line_and_an_open_side_is_no_outline(self):
        corner = region_of(RectZone(shape="rect", x_min_m=1, y_min_m=1))
        assert corner.away_m(-2, -3) == 5
        assert corner.away_m(50, 0) == 1
        assert corner.outline_m(50, 3) == 2


PLACES = """
zones:
  house: {shape: circle, centre_m: [0, 0.5], radius_m: 0.1}
  band: {shape: rect, y_max_m: -0.4}
  field: {shape: rect, x_min_m: -0.6, x_max_m: 0.6, y_min_m: -0.7, y_max_m: 0.7, inverted: true}
  bay: {shape: polygon, points_m: [[-0.3, 0], [0.3, 0], [0.3, 0.3], [0.2, 0.3], [0.2, 0.1], [-0.3, 0.1]]}
  slope: {shape: half_plane, through_m: [0, 0.6], normal: [0, 2]}
gates:
  line: {from_m: [-0.3, 0.2], to_m: [0.3, 0.2]}
  nose: {from_m: [0.1, -0.05], to_m: [0.1, 0.05], anchor: Y1}
groups: {goals: [house, band], lines: [line, nose]}
"""


class TestConditionDistanceToPlaces:
    @pytest.mark.parametrize(
        ("to", "at", "far"),
        [
            ("house", (0.0, 0.45), 0.0),
            ("house", (0.0, 0.2), 0.2),
            ("band", (0.3, -0.1), 0.3),
            ("band", (0.3, -0.6), 0.0),
            ("field", (0.5, 0.0), 0.1),
            ("field", (0.65, 0.0), 0.0),
            ("bay", (0.0, 0.15), 0.05),
            ("bay", (0.1, 0.25), 0.1),
            ("slope", (0.2, 0.35), 0.25),
            ("line", (0.0, 0.3), 0.1),
            ("line", (0.4, 0.2), 0.1),
            ("goals", (0.0, 0.3), 0.1),
            ("goals", (0.0, -0.35), 0.05),
        ],
    )
    def test_it_is_that_to_the_nearest_point(self, stage, ask, to, at, far):
        limits = f"at_least: {far - 0.0001}, at_most: {far + 0.0001}"
        play = stage(PLACES, ASKING % f"{{distance: [ball, {to}], {limits}}}")
        play.place("ball", *at)
        assert ask(play)

    def test_a_gate_turns_with_its_robot(self, stage, ask):
        play = stage(PLACES, ASKING % "{distance: [ball, nose], at_most: 0.0501}")
        play.place("Y1", 0.0, 0.0, 0.0)
        play.place("ball", 0.15, 0.0)
        assert ask(play)
        play.place("Y1", 0.0, 0.0, pi / 2)
        assert not ask(play)
        play.place("ball", 0.05, 0.15)
        assert ask(play)

    @pytest.mark.parametrize("limit", ["at_most: 9", "at_least: 0"])
    def test_while_its_robot_is_off_the_field_a_gate_is_nowhere(self, stage, ask, limit):
        play = stage(PLACES, ASKING % f"{{distance: [ball, nose], {limit}}}", TAKEN_OFF % "Y1")
        assert ask(play)
        play.play_until(15)
        assert not ask(play)

    def test_nothing_is_measured_to_the_gate_that_moves_with_it(self, stage, ask):
        play = stage(PLACES, ASKING % "{distance: [yellow, nose], at_most: 0.12}")
        assert not ask(play)
        play.place("Y2", *_beside(play.pose("Y1"), 0.2))
        assert ask(play)

    def test_what_a_rule_makes_near_by_moving_the_robot_of_the_gate_was_so_before(self, stage):
        near = hears("holds, conditions: [{distance: [ball, nose], at_most: 0.45}]")
        play = stage(PLACES, near, at_tick_10("{action: place, entity: Y1, at: {point: [0.3, 0]}}"))
        play.place("Y1", 0.6, 0.6, 0.0)
        play.play_until(20)
        assert play.names() == []
        place(play, "Y1", 0.6, 0.6, 0.0)
        place(play, "Y1", 0.3, 0.0, 0.0)
        assert play.names() == ["TOLD"]


def _beside(pose: tuple[float, float, float], ahead_m: float) -> Point:
    x, y, yaw = pose
    return (x + ahead_m * cos(yaw), y + ahead_m * sin(yaw))


class TestValueDistanceToPlaces:
    @pytest.mark.parametrize(
        ("ends", "far"),
        [
            ("[ball, line]", 0.1),
            ("[line, ball]", 0.1),
            ("[lines, ball]", 0.1),
            ("[house, ball]", 0.3),
            ("[ball, goals]", 0.3),
            ("[centre, line]", 0.2),
            ("[[0, -0.3], band]", 0.1),
            ("[balls, field]", 0.6),
        ],
    )
    def test_it_is_that_to_the_nearest_point_whichever_comes_first(self, stage, ends, far):
        play = stage(PLACES, emitting(f"{{far: {{distance: {ends}}}}}"))
        play.place("ball", 0.0, 0.1)
        assert payload(play) == {"far": far}

    def test_on_the_line_itself_it_is_0_without_a_sign(self, stage):
        play = stage(PLACES, emitting("{far: {distance: [ball, band]}, in: {distance: [ball, field]}}"))
        play.place("ball", 0.6, -0.4)
        assert str(payload(play)) == "{'far': 0.0, 'in': 0.0}"

    @pytest.mark.parametrize("off", ["ball", "Y1"])
    def test_while_the_ball_or_the_robot_of_the_gate_is_off_the_field_there_is_none(self, stage, off):
        play = stage(PLACES, emitting("{far: {distance: [ball, nose]}}"), TAKEN_OFF % off)
        play.play_until(15)
        assert payload(play) == {"far": None}


class TestActionSetSpotToAZone:
    @pytest.mark.parametrize(("zone", "centre"), [("house", (0.0, 0.5)), ("room", (0.2, -0.1))])
    def test_the_spot_is_its_centre(self, stage, zone, centre):
        room = "zones: {room: {shape: rect, x_min_m: 0.1, x_max_m: 0.3, y_min_m: -0.4, y_max_m: 0.2}}"
        found = "spots: {found: {x_m: 0.3, y_m: 0.3}}"
        play = acted(stage(PLACES, room, found, at_tick_10(f"{{action: set_spot, spot: found, to: {zone}}}")))
        assert play.referee.spots["found"] == pytest.approx(centre)


CURLING = """
spots: {button: {x_m: 0, y_m: 0}}
counters: {of_blue_m: {}, of_yellow_m: {}, blue_points: {}, yellow_points: {}}
rules:
  measured:
    triggers: [{trigger: program_fault, robot: Y1}]
    actions:
      - {action: count, counter: of_blue_m, to: {distance: [B2, button]}}
      - {action: count, counter: of_yellow_m, to: {distance: [Y2, button]}}
      - {action: emit, event: MEASURED}
  blue:
    triggers: [{trigger: event, event: MEASURED}]
    conditions: [{distance: [B2, button], at_least: {counter: of_yellow_m}, negate: true}]
    actions: [{action: count, counter: blue_points}]
  yellow:
    triggers: [{trigger: event, event: MEASURED}]
    conditions: [{distance: [Y2, button], at_least: {counter: of_blue_m}, negate: true}]
    actions: [{action: count, counter: yellow_points}]
"""


class TestWhatIsComparedWithACounter:
    @pytest.mark.parametrize(
        ("blue_m", "yellow_m", "points"),
        [
            (0.2996, 0.2998, (0, 0)),  # both are 0.3 m off, to the millimetre: neither is nearer
            (0.2984, 0.2998, (1, 0)),
            (0.3012, 0.2998, (0, 1)),
        ],
    )
    def test_of_two_that_are_measured_to_the_millimetre_at_most_one_is_nearer(self, stage, blue_m, yellow_m, points):
        play = stage(CURLING)
        play.place("B2", blue_m, 0.0)
        play.place("Y2", 0.0, yellow_m)
        play.fail("Y1")
        play.play(2)
        counters = play.referee.counters
        assert (counters["blue_points"], counters["yellow_points"]) == points
