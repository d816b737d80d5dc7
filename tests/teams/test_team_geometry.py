"""The sample teams' arithmetic: where the ball is, where to go, which wheel turns faster."""

from __future__ import annotations

import math
import struct

import pytest
from hypothesis import given
from hypothesis import strategies as st

WHEEL_RADIUS_M = 0.02
WHEEL_TRACK_M = 0.09
TICK_S = 0.032
ON_FIELD_X = st.floats(-0.55, 0.55)
ON_FIELD_Y = st.floats(-0.65, 0.65)
ANGLE = st.floats(-math.pi, math.pi)
TEAMS_WITH_DRIVING = ["roles_and_radio", "all_sensors"]
TEAMS_WITH_RADIO = [("roles_and_radio", "team_radio"), ("all_sensors", "team")]

# The fixture only loads files; it is the same for every example.


def drive(pose, left_motor, right_motor):
    """Move a robot without inertia for one tick; the left motor sits on the right side."""
    x, y, heading = pose
    speed = WHEEL_RADIUS_M * (left_motor + right_motor) / 2
    turn = WHEEL_RADIUS_M * (left_motor - right_motor) / WHEEL_TRACK_M
    heading += turn * TICK_S / 2
    x, y = x + speed * TICK_S * math.cos(heading), y + speed * TICK_S * math.sin(heading)
    return x, y, heading + turn * TICK_S / 2


def ball_receiver_reading(robot, ball):
    """Return what a receiver on ``(x, y, yaw)`` says: direction in the robot's frame, strength."""
    dx, dy, dz = ball[0] - robot[0], ball[1] - robot[1], -0.0166
    distance = math.sqrt(dx * dx + dy * dy + dz * dz)
    sine, cosine = math.sin(robot[2]), math.cos(robot[2])
    ahead, left = dx * cosine + dy * sine, -dx * sine + dy * cosine
    return (ahead / distance, left / distance, dz / distance), 1 / distance**2


@pytest.mark.parametrize(("team", "module"), [("roles_and_radio", "senses"), ("all_sensors", "body")])
@given(x=ON_FIELD_X, y=ON_FIELD_Y, heading=ANGLE, ball_x=ON_FIELD_X, ball_y=ON_FIELD_Y)
def test_the_ball_is_found_from_direction_and_strength(load, team, module, x, y, heading, ball_x, ball_y):
    direction, strength = ball_receiver_reading((x, y, heading), (ball_x, ball_y))
    found = load(team, module).ball_position(x, y, heading, direction, strength)
    assert math.dist(found, (ball_x, ball_y)) < 1e-6


def test_the_worked_example_of_the_ball_receiver(load):
    found = load("roles_and_radio", "senses").ball_position(0.2, -0.4, 2.0, (0.986, 0.158, -0.046), 7.68)
    assert found == pytest.approx((0.0, -0.1), abs=1e-3)


@pytest.mark.parametrize("team", TEAMS_WITH_DRIVING)
@given(x=ON_FIELD_X, y=ON_FIELD_Y, heading=ANGLE, target_x=ON_FIELD_X, target_y=ON_FIELD_Y)
def test_a_robot_gets_to_any_place_in_time(load, team, x, y, heading, target_x, target_y):
    wheels_to_point = load(team, "driving").wheels_to_point
    pose = (x, y, heading)
    # The straight way at 0.2 m/s, and 1.5 s for turning and braking.
    ticks = math.ceil((math.dist((x, y), (target_x, target_y)) / 0.2 + 1.5) / TICK_S)
    for _ in range(ticks):
        pose = drive(pose, *wheels_to_point(*pose, target_x, target_y))
    assert math.dist(pose[:2], (target_x, target_y)) < 0.02


@pytest.mark.parametrize("team", TEAMS_WITH_DRIVING)
@given(x=ON_FIELD_X, y=ON_FIELD_Y, heading=ANGLE, target_x=ON_FIELD_X, target_y=ON_FIELD_Y)
def test_no_motor_is_commanded_beyond_its_limit(load, team, x, y, heading, target_x, target_y):
    left, right = load(team, "driving").wheels_to_point(x, y, heading, target_x, target_y)
    assert max(abs(left), abs(right)) <= 10 + 1e-9


@pytest.mark.parametrize("degrees", [-170, -60, -10, 10, 60, 170])
def test_the_ball_chaser_turns_to_the_side_of_the_ball(load, degrees):
    left, right = load("ball_chaser", "rcj_soccer_team_blue").wheel_speeds(math.radians(degrees))
    _, _, heading = drive((0, 0, 0), left, right)
    assert math.copysign(1, heading) == math.copysign(1, degrees)
    assert max(abs(left), abs(right)) <= 10


def test_the_ball_chaser_goes_straight_at_a_ball_that_lies_towards_the_other_goal(load):
    chaser = load("ball_chaser", "rcj_soccer_team_blue")
    north = math.pi / 2
    assert chaser.angle_past_the_ball(0.2, 0.4, north + 0.2, north) == 0.2


@pytest.mark.parametrize("side", [-1, 1])
def test_the_ball_chaser_passes_a_ball_that_it_would_push_home(load, side):
    chaser = load("ball_chaser", "rcj_soccer_team_blue")
    north, distance = math.pi / 2, 0.4
    heading_of_ball = -math.pi / 2 + side * 0.3  # it lies towards the own goal
    angle = chaser.angle_past_the_ball(0.0, distance, heading_of_ball, north)
    passes_at = distance * math.sin(abs(angle))
    assert passes_at == pytest.approx(0.15, abs=0.005)


@pytest.mark.parametrize(("team", "module"), TEAMS_WITH_RADIO)
@given(number=st.integers(1, 3), x=ON_FIELD_X, y=ON_FIELD_Y, ball=st.none() | st.tuples(ON_FIELD_X, ON_FIELD_Y))
def test_a_message_arrives_as_it_was_sent(load, team, module, number, x, y, ball):
    radio = load(team, module)
    place = (x, y) if team == "all_sensors" else None
    data = radio.pack_message(number, place, ball) if place else radio.pack_message(number, x, y, ball)
    unpacked = radio.unpack_message(data)
    heard_number, heard_ball = unpacked[0], unpacked[-1]
    heard_place = unpacked[1] if place else unpacked[1:3]
    assert heard_number == number
    assert heard_place == pytest.approx((x, y), abs=1e-6)
    assert (heard_ball is None) == (ball is None)
    if ball is not None:
        assert heard_ball == pytest.approx(ball, abs=1e-6)


def test_foreign_bytes_on_the_radio_are_ignored(load):
    team = load("all_sensors", "team")
    assert team.unpack_message(struct.pack("<d", 1.0)) is None


@given(
    a=st.tuples(ON_FIELD_X, ON_FIELD_Y),
    b=st.tuples(ON_FIELD_X, ON_FIELD_Y),
    ball=st.tuples(ON_FIELD_X, ON_FIELD_Y),
)
def test_there_is_always_a_striker_among_the_two_field_players(load, a, b, ball):
    choose_role = load("roles_and_radio", "roles").choose_role
    two = choose_role(2, a, {3: b}, ball, "support")
    three = choose_role(3, b, {2: a}, ball, "striker")
    assert "striker" in (two, three)


@pytest.mark.parametrize("place", [(0.02, 0.15), (-0.2, 0.3), (0.3, 0.05)])
def test_a_striker_before_the_ball_gets_behind_it_without_touching_it(load, place):
    attack = load("all_sensors", "plan").attack
    wheels_to_point = load("all_sensors", "driving").wheels_to_point
    ball, aim, pose = (0.0, 0.0), (0.0, 0.8), (*place, 0.3)
    nearest = math.inf
    for _ in range(150):
        if pose[1] < -0.07 and abs(pose[0]) < 0.035:
            break
        nearest = min(nearest, math.dist(pose[:2], ball))
        direction = attack(pose[:2], ball, (0.0, 0.0), aim)
        target = (pose[0] + 0.2 * math.cos(direction), pose[1] + 0.2 * math.sin(direction))
        pose = drive(pose, *wheels_to_point(*pose, *target, full_speed=True))
    else:
        pytest.fail(f"after 5 s it is still at {pose}")
    assert nearest > 0.05


def test_the_striker_behind_the_ball_drives_through_it(load):
    attack = load("all_sensors", "plan").attack
    assert attack((0.0, -0.1), (0.0, 0.0), (0.0, 0.0), (0.0, 0.8)) == pytest.approx(math.pi / 2)


def test_the_striker_makes_up_for_a_ball_that_rolls_sideways(load):
    attack = load("all_sensors", "plan").attack
    direction = attack((0.0, -0.1), (0.0, 0.0), (-0.1, 0.0), (0.0, 0.8))  # it rolls to the left
    assert direction < math.pi / 2  # so we push to the right


@given(ball=st.tuples(ON_FIELD_X, ON_FIELD_Y))
def test_the_goalie_stays_out_of_the_penalty_area(load, ball):
    roles = load("roles_and_radio", "roles")
    _, y = roles.goalie_place((0.0, -0.3), ball, 0.0)
    assert y > -0.59 or y == ball[1]


def test_the_ball_s_way_is_continued_until_the_goalie_s_line(load):
    tracker = load("all_sensors", "ball").BallTracker()
    for tick in range(6):
        tracker.update(tick * TICK_S, (0.1 + 0.1 * tick * TICK_S, -0.2 * tick * TICK_S))
    vx, vy = tracker.velocity
    assert (vx, vy) == pytest.approx((0.1, -0.2))
    x, y = tracker.place_in(1.0)
    assert (x, y) == pytest.approx((0.1 + 0.1 * (5 * TICK_S + 1), -0.2 * (5 * TICK_S + 1)))


def test_a_ball_that_was_put_elsewhere_has_no_speed(load):
    tracker = load("all_sensors", "ball").BallTracker()
    for tick in range(5):
        tracker.update(tick * TICK_S, (0.3, 0.3))
    tracker.update(5 * TICK_S, (0.0, 0.0))
    assert tracker.velocity == (0.0, 0.0)
    assert tracker.place == (0.0, 0.0)


@pytest.mark.parametrize(
    ("x", "y", "direction", "expected"),
    [(0.0, 0.0, 0.0, 0.65), (0.0, 0.0, math.pi / 2, 0.75), (0.25, 0.0, math.pi, 0.90), (0.0, -0.5, -math.pi / 2, 0.25)],
)
def test_the_distance_to_the_walls_is_known(load, x, y, direction, expected):
    assert load("all_sensors", "body").wall_distance(x, y, direction) == pytest.approx(expected)
