"""Geometry of zones, gates and outlines, against naive computation."""

import math

import pytest
from hypothesis import assume, example, given
from hypothesis import strategies as st

from rcj_challenges.chassis.differential import DifferentialChassis
from rcj_challenges.geometry.polygons import box, distance_to_segment_m
from rcj_challenges.geometry.regions import cell_beside_square, crossing
from rcj_challenges.referee.bodies import Bodies
from rcj_challenges.referee.zones import region_of
from rcj_challenges.scenario.models.places import CircleZone, HalfPlaneZone, PolygonZone, RectZone
from rcj_challenges.scenario.outlines import Outline, Part, closer_than, gap_m
from rcj_challenges.scenario.roster import Roster

number = st.floats(-1, 1, allow_subnormal=False).map(lambda value: round(value, 3))
point = st.tuples(number, number)
zones = st.one_of(
    st.builds(lambda a, b, inv: RectZone(shape="rect", x_min_m=min(a[0], b[0]), x_max_m=max(a[0], b[0]),
                                         y_min_m=min(a[1], b[1]), y_max_m=max(a[1], b[1]), inverted=inv),
              point, point, st.booleans()),
    st.builds(lambda x, inv: RectZone(shape="rect", x_min_m=x, inverted=inv), number, st.booleans()),
    st.builds(lambda c, r, inv: CircleZone(shape="circle", centre_m=c, radius_m=r, inverted=inv),
              point, st.floats(0.01, 1), st.booleans()),
    st.builds(lambda c, n, inv: HalfPlaneZone(shape="half_plane", through_m=c, normal=n, inverted=inv),
              point, point.filter(lambda p: p != (0, 0)), st.booleans()),
    st.builds(lambda ps, inv: PolygonZone(shape="polygon", points_m=tuple(ps), inverted=inv),
              st.lists(point, min_size=3, max_size=6, unique=True), st.booleans()),
)  # fmt: skip


@given(zones, point, st.floats(-1, 1), st.floats(-1, 1))
@example(PolygonZone(shape="polygon", points_m=((0.0, -1.0), (0.438, 0.0), (-1.0, 0.0))), (0.0, 0.0), 0.0, -1.0)
def test_within_a_cell_the_answer_is_the_same(zone, here, along_x, along_y):
    region = region_of(zone)
    assume(not 0 < region.outline_m(*here) < 1e-12)  # on the line but for rounding
    x_low, x_high, y_low, y_high = region.cell(*here)
    assume(x_low < here[0] < x_high and y_low < here[1] < y_high)

    def towards(middle: float, low: float, high: float, share: float) -> float:
        edge = high if share > 0 else low
        return middle + abs(share) * 0.999 * (max(-5.0, min(5.0, edge)) - middle)

    there = (towards(here[0], x_low, x_high, along_x), towards(here[1], y_low, y_high, along_y))
    assert region.contains(*there) == region.contains(*here)


@given(zones, point)
def test_a_cell_holds_the_point_from_which_it_was_asked_unless_that_is_on_the_line(zone, here):
    """Else nothing would be judged wrongly, but everything looked at on every tick."""
    region = region_of(zone)
    assume(region.outline_m(*here) > 1e-6)
    x_low, x_high, y_low, y_high = region.cell(*here)
    assert x_low <= here[0] <= x_high
    assert y_low <= here[1] <= y_high


@given(point, point, st.floats(0.01, 1))
def test_a_cell_beside_a_square_holds_its_point_too(here, centre, half_m):
    across = max(abs(here[0] - centre[0]), abs(here[1] - centre[1]))
    assume(abs(across - half_m) > 1e-6)
    x_low, x_high, y_low, y_high = cell_beside_square(*here, centre, half_m)
    assert x_low <= here[0] <= x_high
    assert y_low <= here[1] <= y_high
    beyond = x_low > centre[0] or x_high < centre[0] or y_low > centre[1] or y_high < centre[1]
    assert beyond is (across > half_m)


@given(point, st.floats(0.05, 0.5))
def test_limits_are_strict(centre, half):
    x, y = centre
    rect = region_of(RectZone(shape="rect", x_min_m=x - half, x_max_m=x + half, y_min_m=y - half, y_max_m=y + half))
    corners = ((x - half, y - half), (x + half, y - half), (x + half, y + half), (x - half, y + half))
    polygon = region_of(PolygonZone(shape="polygon", points_m=corners))
    for region in (rect, polygon):
        assert region.contains(x, y)
        for edge in ((x - half, y), (x + half, y), (x, y - half), (x, y + half), *corners):
            assert not region.contains(*edge)


@given(point, point, point, point)
@example((0.1, -0.5), (0.1, 0.5), (0.65, 0.0), (-0.65, 0.0))
def test_a_way_there_and_back_crosses_a_gate_as_often_in_both_directions(start, end, post_a, post_b):
    assume(post_a != post_b)
    assume(all(distance_to_segment_m(*post, *start, *end) > 1e-6 for post in (post_a, post_b)))  # not just at a post
    there, back = crossing(start, end, post_a, post_b), crossing(end, start, post_a, post_b)
    assert there == -back


@given(point, point, st.floats(0.05, 0.95))
def test_a_way_cut_in_two_crosses_as_often_as_the_whole(start, end, share):
    post_a, post_b = (-3.0, 0.1), (3.0, 0.1)  # wider than any way, so that only the cut can matter
    middle = (start[0] + share * (end[0] - start[0]), start[1] + share * (end[1] - start[1]))
    whole = crossing(start, end, post_a, post_b)
    assert crossing(start, middle, post_a, post_b) + crossing(middle, end, post_a, post_b) == whole


def test_distance_to_a_segment_is_to_its_nearest_point():
    assert distance_to_segment_m(0, 1, -1, 0, 1, 0) == 1
    assert distance_to_segment_m(4, 4, -1, 0, 1, 0) == 5
    assert distance_to_segment_m(3, 4, 0, 0, 0, 0) == 5


class TestOutlines:
    ROBOT = Outline.of(*map(Part, DifferentialChassis().footprint()))

    def gap(self, yaw_a: float, x: float, y: float, yaw_b: float) -> float:
        parts = self.ROBOT.at((0.0, 0.0, yaw_a)), self.ROBOT.at((x, y, yaw_b))
        return min(gap_m(a, b) for a in parts[0] for b in parts[1])

    def test_a_robot_is_a_tenth_of_a_metre_wide_and_a_cube_long(self):
        assert self.gap(0.0, 0.2, 0.0, 0.0) == pytest.approx(0.2 - 0.075)
        assert self.gap(0.0, 0.0, 0.2, 0.0) == pytest.approx(0.2 - 0.1)
        assert self.gap(0.0, 0.0, 0.2, math.pi / 2) == pytest.approx(0.2 - 0.05 - 0.0375)

    def test_neighbours_of_the_lidar_formations_fit(self):
        assert self.gap(1.57, 0.105, 0.0, 1.57) == pytest.approx(0.005, abs=1e-4)
        assert self.gap(1.57, 0.099, 0.0, 1.57) < 0

    @given(st.floats(-0.3, 0.3), st.floats(-0.3, 0.3), st.floats(-4, 4), st.floats(0, 0.1))
    @example(0.12, 0.17, 0.0, 0.03)  # beyond a corner, which is further than either side
    def test_the_quick_answer_is_that_of_the_gap(self, x, y, yaw, limit):
        square, disc = Part(box(0.1, 0.2)), Part(((x, y),), 0.05)
        turned = Part(box(0.15, 0.05)).at((x, y, yaw))
        for other in (disc, turned):
            gap = gap_m(square, other)
            assume(abs(gap - limit) > 1e-12)
            assert closer_than(square, other, limit) == (gap < limit)
            assert closer_than(other, square, limit) == (gap < limit)

    @given(st.floats(-0.3, 0.3), st.floats(-0.3, 0.3), st.floats(-4, 4))
    def test_two_rectangles_overlap_just_if_they_share_a_point(self, x, y, yaw):
        square, other = Part(box(0.1, 0.2)), Part(box(0.15, 0.05)).at((x, y, yaw))
        gap = gap_m(square, other)
        c, s = math.cos(yaw), math.sin(yaw)
        shares = any(
            abs(x + c * u - s * v) < 0.05 and abs(y + s * u + c * v) < 0.1
            for u in (i * 0.0075 - 0.075 for i in range(21))
            for v in (i * 0.0025 - 0.025 for i in range(21))
        )
        if shares:
            assert gap < 0
        if gap > 0.01:
            assert not shares

    @pytest.mark.parametrize(
        ("pose", "fits"),
        [
            ((0.0, 0.7, 1.57), True),
            ((0.6, 0.0, 0.0), True),
            ((0.62, 0.0, 0.0), False),  # into the side wall
            ((0.6, 0.67, 0.0), False),  # into the corner wall
            ((0.0, 0.8, 1.57), True),  # in the goal
            ((0.0, 0.83, 1.57), False),  # into its back
            ((0.18, 0.78, 1.57), False),  # into its side
            ((0.4, 0.74, 1.57), False),  # into the end wall
            ((0.0, 1.5, 1.57), False),  # outside, and no distance is free again
            ((9.0, 0.0, 0.0), False),
            ((10.5, 11.0, 0.0), False),
            ((1e6, 0.0, 0.0), False),
        ],
    )
    def test_walls_and_goals_are_solid_on_all_sides_alike(self, small, pose, fits):
        scenario = small()
        bodies, (x, y, yaw) = Bodies(scenario, Roster.of(scenario)), pose
        alike = ((x, y, yaw), (-x, y, -yaw), (x, -y, -yaw), (-x, -y, yaw))
        assert [bodies.fits(0, mirrored, {}, 0.0) for mirrored in alike] == [fits] * 4

    def test_fixed_obstacles_are_bodies(self, small):
        scenario = small("""
        obstacles:
          box: {shape: box, centre_m: [0, 0.3], size_m: [0.1, 0.1], yaw_rad: 0.785}
          wall: {shape: wall, from_m: [-0.3, -0.2], to_m: [0.3, -0.2]}
        """)
        bodies, roster = Bodies(scenario, Roster.of(scenario)), Roster.of(scenario)
        ball = roster.index["ball"]
        assert not bodies.fits(ball, (0.08, 0.3, 0.0), {}, 0.0)
        assert bodies.fits(ball, (0.08, 0.35, 0.0), {}, 0.0)
        assert not bodies.fits(ball, (0.2, -0.18, 0.0), {}, 0.0)
        assert bodies.fits(ball, (0.2, -0.17, 0.0), {}, 0.0)
        assert not bodies.fits(ball, (0.2, -0.17, 0.0), {}, 0.01)

    @pytest.mark.parametrize(
        "ends", ["from_m: [-0.3, -0.3], to_m: [0.3, 0.3]", "from_m: [0.3, 0.3], to_m: [-0.3, -0.3]"]
    )
    def test_an_oblique_wall_has_its_declared_thickness_and_length(self, small, ends):
        scenario = small(f"obstacles: {{wall: {{shape: wall, {ends}, thickness_m: 0.04}}}}")
        bodies, roster = Bodies(scenario, Roster.of(scenario)), Roster.of(scenario)

        def fits(along_m: float, beside_m: float) -> bool:
            x, y = (along_m - beside_m) / math.sqrt(2), (along_m + beside_m) / math.sqrt(2)
            return bodies.fits(roster.index["ball"], (x, y, 0.0), {}, 0.0)

        end_m = 0.3 * math.sqrt(2)
        for beside in (1, -1):  # half its thickness and the ball's radius of 0.021 away
            assert [fits(along * 0.4, beside * 0.040) for along in (1, 0, -1)] == [False] * 3
            assert [fits(along * 0.4, beside * 0.042) for along in (1, 0, -1)] == [True] * 3
            assert not fits(beside * (end_m + 0.020), 0.0)
            assert fits(beside * (end_m + 0.022), 0.0)
