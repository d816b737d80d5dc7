"""A spot that rules set: it remembers where something was, and is there wherever a spot can stand."""

import pytest

from tests.referee.building import ASKING, emitting, once, payload, place

PITCH = "spots: {found: {x_m: 0, y_m: 0.2}, other: {x_m: 0.5, y_m: -0.8}}\ngroups: {both: [found, other]}\n"
EVERY_TICK = "rules: {set: {triggers: [{trigger: time_reached, at_s: 0.032, every_s: 0.032}], actions: [%s]}}"
FAR = emitting("{far: {distance: [ball, found]}}")


def set_to(what: str, more: str = "") -> str:
    return f"{{action: set_spot, spot: found, to: {what}{more}}}"


def put(what: str, at: str, more: str = "") -> str:
    return f"{{action: place, entity: {what}, at: {at}{more}}}"


def remembering(stage, *sections: str, **facts):
    """Return a play in which the ball lay at (0.3, 0.1) when the spot was set, and now lies at (-0.3, 0.1)."""
    play = stage(PITCH, once(10, set_to("ball")), *sections, **facts)
    play.place("ball", 0.3, 0.1)
    play.play_until(10)
    place(play, "ball", -0.3, 0.1)
    return play


def found(stage, action: str, *sections: str, **facts) -> tuple[float, float]:
    """Return where the spot is after a rule has set it."""
    play = stage(PITCH, *sections, once(10, action), **facts)
    play.play_until(12)
    return play.referee.spots["found"]


class TestActionSetSpot:
    def test_the_spot_has_its_position_in_the_file_in_each_half_until_a_rule_sets_it(self, stage):
        play = stage(PITCH, once(300, set_to("ball")), FAR)
        play.place("ball", 0.3, 0.2)
        assert payload(play) == {"far": 0.3}
        left = remembering(stage).referee
        assert left.spots["found"] != (0.0, 0.2)
        assert stage(PITCH, half=2, kept=left.kept).referee.spots["found"] == (0.0, 0.2)

    def test_it_stays_where_the_ball_was_when_the_ball_rolls_on(self, stage):
        play = remembering(stage, FAR)
        assert payload(play) == {"far": 0.6}
        assert play.referee.spots["found"] == pytest.approx((0.3, 0.1))
        assert play.referee.spots["other"] == (0.5, -0.8)

    @pytest.mark.parametrize(
        ("to", "there"),
        [
            ("Y1", (-0.4, -0.5)),
            ("other", (0.5, -0.8)),
            ("[0.1, 0.2]", (0.1, 0.2)),
            ("Y1, mirror: {axis: x}", (0.4, -0.5)),
            ("Y1, mirror: {axis: y}", (-0.4, 0.5)),
            ("Y1, mirror: {axis: both}", (0.4, 0.5)),
            ("{on_line: [[2, 2], [3, 3]]}", (0.0, 0.2)),  # none of its points is on the floor, so it stays
        ],
    )
    def test_it_can_be_set_to_a_robot_another_spot_a_point_or_a_mirror_image(self, stage, to, there):
        assert found(stage, set_to(to)) == pytest.approx(there)

    @pytest.mark.parametrize(("decided", "there"), [("other", (0.5, -0.8)), ("Y1", (-0.4, -0.5))])
    def test_it_can_be_set_to_what_a_draw_has_decided(self, stage, decided, there):
        draws = "draws: {hidden: {values: [other, Y1]}}"
        assert found(stage, set_to("hidden"), draws, draws={"hidden": decided}) == pytest.approx(there)

    @pytest.mark.parametrize("off", ["ball", "Y1"])
    def test_what_is_off_the_field_leaves_it_where_it_is(self, stage, off):
        gone = once(5, f"{{action: remove, entity: {off}}}", name="gone")
        assert found(stage, set_to(off), gone) == (0.0, 0.2)

    def test_the_mirror_image_of_a_middle_is_a_plain_0(self, stage):
        assert str(found(stage, set_to("[0, 0]", ", mirror: {axis: both}"))) == "(0.0, 0.0)"

    def test_chance_may_set_it_anywhere_in_a_zone_again_and_again(self, stage):
        box = "zones: {box: {shape: rect, x_min_m: 0.1, x_max_m: 0.3, y_min_m: -0.4, y_max_m: 0.2}}"
        play, again = (stage(PITCH, box, EVERY_TICK % set_to("{uniform_in: box}")) for _ in range(2))
        points = []
        for _ in range(400):
            play.play()
            points.append(play.referee.spots["found"])
        xs, ys = zip(*points, strict=True)
        assert len(set(points)) == 400
        assert 0.1 <= min(xs) < 0.11
        assert 0.29 < max(xs) <= 0.3
        assert -0.4 <= min(ys) < -0.38
        assert 0.18 < max(ys) <= 0.2
        again.play()
        assert again.referee.spots["found"] == points[0]

    def test_chance_may_set_it_anywhere_on_a_line_and_to_the_mirror_image_of_that(self, stage):
        line = "{on_line: [[0.1, 0.2], [0.3, 0.4]]}"
        x, y = found(stage, set_to(line))
        assert 0.1 < x < 0.3
        assert y == pytest.approx(x + 0.1)
        assert found(stage, set_to(line, ", mirror: {axis: y}")) == pytest.approx((x, -y))

    @pytest.mark.parametrize(
        "zone",
        [
            "shape: rect, x_min_m: 0.4, x_max_m: 1.2, y_min_m: 0.5, y_max_m: 1.5",
            "shape: circle, centre_m: [0.64, 0.74], radius_m: 0.04",  # behind the chamfer, but a bit
        ],
    )
    def test_chance_sets_it_nowhere_outside_the_walls(self, stage, zone):
        play = stage(PITCH, f"zones: {{box: {{{zone}}}}}", EVERY_TICK % set_to("{uniform_in: box}"))
        for _ in range(200):
            play.play()
            x, y = play.referee.spots["found"]
            assert x <= 0.65
            assert y <= 0.75
            assert (0.65 - x) + (0.75 - y) >= 0.06 - 1e-9  # the chamfer

    def test_what_the_same_rule_places_was_elsewhere_before(self, stage):
        play = stage(PITCH, once(10, put("ball", "{point: [0.5, 0.5]}"), set_to("ball")))
        play.place("ball", 0.3, 0.1)
        play.play_until(12)
        assert play.referee.spots["found"] == pytest.approx((0.3, 0.1))
        assert play.pose("ball")[:2] == pytest.approx((0.5, 0.5))

    def test_actions_after_it_read_the_new_place_and_conditions_of_the_tick_the_old_one(self, stage):
        near = "conditions: [{distance: [ball, found], at_most: 0.01}],"
        paid = "{action: score, entrant: yellow, points: {distance: [ball, found]}}"
        later = once(10, "{action: score, entrant: blue}", name="later", more=near)
        play = stage(PITCH, once(10, paid, set_to("ball"), paid), later)
        play.place("ball", 0.3, 0.2)
        play.play_until(12)
        assert play.referee.scores == {"yellow": 0.3, "blue": 0}


class TestWhereARememberedPlaceStands:
    @pytest.mark.parametrize(
        ("condition", "before", "after"),
        [
            ("{distance: [ball, found], at_most: 0.05}", False, True),
            ("{distance: [ball, both], at_most: 0.05}", False, True),
            ("{spot_free: found}", True, False),
            ("{spot_free: both, of: all}", True, False),
            ("{entity: Y1, looks: found, within_rad: 0.05}", False, True),
        ],
    )
    def test_conditions_ask_for_where_it_is_now(self, stage, ask, condition, before, after):
        play = stage(PITCH, ASKING % condition, once(30, set_to("ball")))
        play.place("ball", 0.3, 0.1)
        play.place("Y1", -0.4, 0.1, 0.0)
        assert ask(play) is before
        play.play_until(31)
        assert ask(play) is after

    @pytest.mark.parametrize(
        "at",
        [
            "{spot: found}", "{spot: drawn}", "{choice: [found]}", "{choice: [drawn]}",
            "{nearest_free: both, to: [0.2, 0.1]}", "{furthest_free: both, from: other}", "{relative_to: found}",
            "{nearest_free: both, to: found}",
        ],
    )  # fmt: skip
    def test_things_are_put_where_it_is_now(self, stage, at):
        play = remembering(stage, "draws: {drawn: {values: [found]}}", once(20, put("Y1", at), name="later"))
        play.play_until(22)
        assert play.pose("Y1")[:2] == pytest.approx((0.3, 0.1))

    def test_a_robot_faces_it_and_a_ball_is_kicked_there(self, stage):
        robot = put("Y1", "{point: [0.3, -0.4]}", ", facing: {towards: found}")
        ball = put("ball", "{point: [0, 0.1]}", ", kick: {towards: {spot: found}, speed_mps: 1}")
        play = remembering(stage, once(20, robot, ball, name="later"))
        play.play_until(19)
        placements = play.play().placements
        assert placements[0].yaw_rad == pytest.approx(1.5708, abs=1e-4)
        assert (placements[1].vx_mps, placements[1].vy_mps) == pytest.approx((1.0, 0.0))

    def test_what_waits_for_room_goes_where_the_spot_is_then(self, stage):
        play = stage(PITCH, once(10, put("Y1", "{spot: found}")), once(20, set_to("[0.3, -0.2]"), name="later"))
        play.place("ball", 0.0, 0.2)
        play.play_until(15)
        assert play.pose("Y1")[:2] == pytest.approx((-0.4, -0.5))
        play.play_until(22)
        assert play.pose("Y1")[:2] == pytest.approx((0.3, -0.2))
