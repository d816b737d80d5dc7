"""What cannot be on the floor."""

from math import pi

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rcj_challenges.chassis.differential import DifferentialChassis
from rcj_challenges.geometry.polygons import box, is_simple
from rcj_challenges.scenario.outlines import Floor, Outline, Part, disc, extent, overlap
from tests.scenario.writing import complaints, errors, loaded, rule

ROBOT = DifferentialChassis()


def robot_at(x, y, yaw=0.0, chassis=ROBOT):
    return Outline.of(*map(Part, chassis.footprint())).at((x, y, yaw))


# --- outlines ---------------------------------------------------------------------------------------------------------


def test_a_robot_is_ten_centimetres_wide_across_its_wheels_and_seven_and_a_half_long():
    x_0, x_1, y_0, y_1 = extent(robot_at(0, 0))
    assert (x_1 - x_0, y_1 - y_0) == pytest.approx((0.075, 0.1))


def test_robots_side_by_side_touch_with_their_wheels_and_end_to_end_with_their_cubes():
    assert overlap(robot_at(0, 0), robot_at(0, 0.099))
    assert not overlap(robot_at(0, 0), robot_at(0, 0.101))
    assert overlap(robot_at(0, 0), robot_at(0.074, 0))
    assert not overlap(robot_at(0, 0), robot_at(0.076, 0))


@given(st.floats(-0.2, 0.2), st.floats(-0.2, 0.2), st.floats(-pi, pi), st.floats(-pi, pi))
def test_overlap_is_mutual_and_does_not_depend_on_the_frame(x, y, yaw, turn):
    from math import cos, sin

    a, b = robot_at(0, 0, 0.3), robot_at(x, y, yaw)
    gap = (x * x + y * y) ** 0.5
    if abs(gap - 0.075) < 1e-4:
        return
    assert overlap(a, b) == overlap(b, a)
    turned = robot_at(x * cos(turn) - y * sin(turn), x * sin(turn) + y * cos(turn), yaw + turn)
    nearby = robot_at(0, 0, 0.3 + turn)
    grown = DifferentialChassis(size_m=0.0751, wheel_track_m=0.0901)
    if overlap(a, b) == overlap(robot_at(0, 0, 0.3, grown), robot_at(x, y, yaw, grown)):
        assert overlap(nearby, turned) == overlap(a, b)
    if gap < 0.075:
        assert overlap(a, b)
    if gap > 0.125:  # beyond twice the radius of the outline
        assert not overlap(a, b)


@pytest.mark.parametrize(
    ("centre", "radius", "hit"),
    [((0.06, 0), 0.0224, False), ((0.06, 0), 0.0226, True), ((0, 0), 0.001, True), ((0.0475, 0.0475), 0.0141, False),
     ((0.0475, 0.0475), 0.0143, True)],
)  # fmt: skip
def test_a_ball_touches_the_cube_at_its_faces_and_corners(centre, radius, hit):
    assert overlap([Part(box(0.075, 0.075))], disc(radius).at((*centre, 0))) is hit


# --- bodies on the field ----------------------------------------------------------------------------------------------


def robot_b1(x, y, yaw=0.0):
    return f"robots: {{B1: {{start: {{x_m: {x}, y_m: {y}, yaw_rad: {yaw}}}}}}}\n"


@pytest.mark.parametrize(
    "pose",
    [(0.612, 0, 0), (0, 0.699, 0), (0.599, 0.1, pi / 2), (0.5, 0.5, 0.7), (0, 0.79, 0), (0, 0.74, 0.3), (0.15, 0.76, 0),
     (0.545, 0.645, pi / 4)],
)  # fmt: skip
def test_a_robot_may_stand_anywhere_on_the_field_and_in_the_goals(pose):
    assert loaded(robot_b1(*pose))


@pytest.mark.parametrize(
    "pose",
    [
        (0.613, 0, 0),  # the cube in the side wall
        (0.601, 0.1, pi / 2),  # a wheel in the side wall
        (0.3, 0.71, 0),  # the wheels in the end wall
        (0.61, 0.69, 0),  # in the chamfer
        (0, 0.81, 0),  # through the back of the goal
        (0.18, 0.76, 0),  # in the post
        (0.19, 0.9, 0),  # behind the goal
        (0.2, 0.72, pi / 4),  # a corner through the end wall beside the post
        (2, 2, 0),
    ],
)
def test_a_robot_in_a_wall_or_outside_is_refused(pose):
    assert complaints(robot_b1(*pose)) == ["outside-field robots.B1.start"]


@pytest.mark.parametrize("place", ["[0.628, 0.3]", "[-0.1, 0.728]", "[0, 0.8]", "[0.17, 0.75]"])
def test_a_ball_may_lie_anywhere_on_the_field_and_in_the_goals(place):
    assert loaded(f"balls: {{ball: {{start_m: {place}}}}}\n")


@pytest.mark.parametrize("place", ["[0.63, 0.1]", "[0.3, 0.73]", "[0, 0.84]", "[0.19, 0.75]", "[0.62, 0.72]", "[0, 3]"])
def test_a_ball_in_a_wall_is_refused(place):
    assert complaints(f"balls: {{ball: {{start_m: {place}}}}}\n") == ["outside-field balls.ball.start_m"]


def obstacle(text):
    return f"obstacles: {{post: {{{text}}}}}\n"


def test_a_fixed_obstacle_may_reach_into_the_walls_but_not_into_robots():
    assert loaded(obstacle("shape: wall, from_m: [-0.65, 0.1], to_m: [-0.4, 0.1]"))
    assert loaded(obstacle("shape: box, centre_m: [0.65, 0], size_m: [0.1, 0.1]"))
    assert complaints(obstacle("shape: wall, from_m: [-0.65, 0.3], to_m: [-0.3, 0.3]")) == [
        "overlapping-bodies obstacles.post"
    ]


def test_a_movable_obstacle_must_stand_free():
    assert complaints(obstacle("shape: box, centre_m: [0.65, 0], size_m: [0.1, 0.1], movable: true")) == [
        "outside-field obstacles.post"
    ]
    assert complaints(obstacle("shape: box, centre_m: [0.1, 0], size_m: [0.17, 0.02], movable: true")) == [
        "overlapping-bodies obstacles.post"
    ]


def test_a_turned_box_covers_other_ground():
    long_box = "shape: box, centre_m: [0, 0.15], size_m: [0.5, 0.02]"
    assert loaded(obstacle(long_box))
    assert complaints(obstacle(long_box + ", yaw_rad: 1.5707963"))


@pytest.mark.parametrize("end", ["[0, 0]", "[0, 1.0e-200]"])
def test_wall_of_no_length_is_reported_once_and_overlaps_nothing(end):
    body = obstacle(f"shape: wall, from_m: [0, 0], to_m: {end}")  # where the ball lies
    assert complaints(body) == ["empty-shape obstacles.post.to_m"]


def test_all_overlaps_are_reported():
    body = "balls: {a: {start_m: [0, 0.1]}, b: {start_m: [0.01, 0.1]}, c: {start_m: [0.02, 0.1]}}\n"
    assert sorted(complaints(body)) == ["overlapping-bodies balls.b.start_m", "overlapping-bodies balls.c.start_m"]
    assert any("'a', 'b'" in problem.message for problem in errors(body))


# --- shapes -----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("points", "simple"),
    [
        ([(0, 0), (0, 1), (1, 1), (1, 0)], True),
        ([(0, 0), (1, 0), (2, 0), (2, 2)], True),  # a corner on a straight side
        ([(0, 0), (1, 1), (1, 0), (0, 1)], False),  # a bow
        ([(0, 0), (1, 0), (1, 0), (0, 1)], False),  # a corner twice
        ([(0, 0), (2, 0), (2, 2), (1, 0), (0, 2)], False),  # a corner on another side
        ([(0, 0), (2, 0), (1, 0), (1, 2)], False),  # doubles back
    ],
)
def test_a_polygon_must_be_simple(points, simple):
    assert is_simple(points) is simple


@pytest.mark.parametrize(
    ("zone", "expected"),
    [
        ("shape: rect, x_min_m: 0.1, x_max_m: 0.1", "empty-shape zones.z.x_min_m"),
        ("shape: rect, y_min_m: 1, y_max_m: 0", "empty-shape zones.z.y_min_m"),
        ("shape: rect", "missing-key zones.z"),
        ("shape: polygon, points_m: [[0, 0], [1, 0], [2, 0]]", "empty-shape zones.z.points_m"),
        ("shape: polygon, points_m: [[0, 0], [1, 0]]", "wrong-value zones.z.points_m"),
        ("shape: half_plane, through_m: [0, 0], normal: [0, 0]", "empty-shape zones.z.normal"),
        ("shape: circle, centre_m: [0, 0], radius_m: 0", "wrong-value zones.z.radius_m"),
    ],
)
def test_a_zone_has_an_inside(zone, expected):
    assert complaints(f"zones: {{z: {{{zone}}}}}\n") == [expected]


@pytest.mark.parametrize(
    ("zone", "bounded"),
    [
        ("shape: rect, x_min_m: 0, x_max_m: 0.1, y_min_m: 0, y_max_m: 0.1", True),
        ("shape: rect, x_min_m: 0, x_max_m: 0.1, y_min_m: 0", False),
        ("shape: circle, centre_m: [0, 0], radius_m: 0.1", True),
        ("shape: circle, centre_m: [0, 0], radius_m: 0.1, inverted: true", False),
        ("shape: polygon, points_m: [[0, 0], [0.1, 0], [0, 0.1]]", True),
        ("shape: half_plane, through_m: [0, 0], normal: [1, 0]", False),
    ],
)
def test_a_random_point_needs_a_bounded_zone(zone, bounded):
    body = f"zones: {{z: {{{zone}}}}}\n" + rule(action="{action: place, entity: ball, at: {uniform_in: z}}")
    if bounded:
        assert loaded(body)
    else:
        assert complaints(body) == ["unbounded-zone rules.r.actions[0] (place)"]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("field: {corner_cut_m: 0.65}\n", "does-not-fit field.corner_cut_m"),
        ("field: {walls: false}\n", "conflicting-keys field.walls"),
        ("field: {goals: {blue_goal: {width_m: 1.19}}}\n", "does-not-fit field.goals.blue_goal.width_m"),
        ("field: {goals: {blue_goal: {end: negative_y}}}\n", "does-not-fit field.goals.yellow_goal.end"),
        ("gates: {g: {from_m: [1, 1], to_m: [1, 1]}}\n", "empty-shape gates.g.to_m"),
        ("obstacles: {w: {shape: wall, from_m: [0.5, 0], to_m: [0.5, 0]}}\n", "empty-shape obstacles.w.to_m"),
        (
            "obstacles: {w: {shape: box, centre_m: [0.5, 0], size_m: [0.1, -0.1]}}\n",
            "out-of-range obstacles.w.size_m[1]",
        ),
    ],
)
def test_field_gates_and_obstacles_have_extent(text, expected):
    assert complaints(text) == [expected]


@pytest.mark.parametrize(
    ("point", "is_on_floor"),
    [((0.65, 0.75), False), ((-0.65, 0.75), False), ((0.6, -0.75), False), ((0.65, 0.0), True), ((0.2, 0.85), True)],
)
def test_a_point_on_the_edge_is_on_the_floor_but_not_where_the_corner_is_cut(point, is_on_floor):
    assert Floor(loaded("").scenario.field).has(point) == is_on_floor
