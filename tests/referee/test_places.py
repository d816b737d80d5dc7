"""Where things go: each word of `at`, facing, noise, mirrors, and that nothing ever overlaps."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rcj_challenges.expect.scripted_match import ScriptedMatch, half_of
from rcj_challenges.referee.bodies import Bodies
from rcj_challenges.scenario.roster import Roster
from tests.referee.building import fail, on_fault


def placing(entity: str, at: str, more: str = "") -> str:
    """Return a rule that puts an entity somewhere whenever Y1's program fails."""
    return on_fault("Y1", f"{{action: place, entity: {entity}, at: {at}{more}}}")


def put(play: ScriptedMatch, entity: str = "ball") -> tuple[float, float]:
    """Let the rule fire, and return where the entity then is."""
    fail(play, "Y1")
    return play.pose(entity)[:2]


def many(play: ScriptedMatch, entity: str = "ball", times: int = 60) -> list[tuple[float, float]]:
    """Return where it is put again and again."""
    return [put(play, entity) for _ in range(times)]


class TestPlaceStart:
    B1 = """
    robots: {B1: {colour: blue, number: 1, kit: v2, start: {x_m: 0.3, y_m: 0.3, yaw_rad: -1.57, noise_m: [0.05, 0]}}}
    """

    def test_it_is_the_own_start_with_its_noise(self, stage):
        play = stage(self.B1, placing("[ball, B1]", "start"))
        xs = [x for x, y in many(play, "B1")]
        assert 0.25 <= min(xs) < 0.27
        assert 0.33 < max(xs) <= 0.35
        assert play.pose("B1")[1] == pytest.approx(0.3)
        assert play.pose("ball")[:2] == (0.0, 0.0)

    def test_a_start_with_noise_is_scattered_at_tick_0_even_without_a_rule(self, stage):
        assert [(tick, placement.entity) for tick, placement in stage(self.B1).placements] == [(0, 0)]


@pytest.mark.parametrize("at", ["{spot: where}", "{choice: [where]}"])
def test_a_draw_can_name_the_spot(stage, at):
    draws = "draws: {where: {values: [middle_blue, centre]}}"
    assert put(stage(draws, placing("ball", at), draws={"where": "middle_blue"})) == pytest.approx((0.0, 0.2))


class TestPlaceUniformIn:
    @pytest.mark.parametrize(
        ("zone", "inside"),
        [
            ("{shape: rect, x_min_m: 0.1, x_max_m: 0.3, y_min_m: -0.2, y_max_m: 0.2}",
             lambda x, y: 0.1 < x < 0.3 and -0.2 < y < 0.2),
            ("{shape: circle, centre_m: [0.2, 0], radius_m: 0.2}", lambda x, y: math.hypot(x - 0.2, y) < 0.2001),
            ("{shape: polygon, points_m: [[0, 0], [0.4, 0], [0, 0.4]]}", lambda x, y: x > 0 and y > 0 and x + y < 0.4),
        ],
    )  # fmt: skip
    def test_every_place_is_inside_and_they_cover_the_zone(self, stage, zone, inside):
        play = stage(f"zones: {{area: {zone}}}", placing("ball", "{uniform_in: area}"))
        places = many(play)
        assert all(inside(x, y) for x, y in places)
        assert max(x for x, _ in places) - min(x for x, _ in places) > 0.12

    def test_a_zone_without_end_is_refused(self, stage):
        with pytest.raises(ValueError, match="'left' is not bounded"):
            stage(placing("ball", "{uniform_in: left}"))

    def test_several_zones_are_one_in_which_every_point_is_equally_likely(self, stage):
        # Six equal parts; the fourth from the west belongs to both.
        sections = """
        zones:
          west: {shape: rect, x_min_m: -0.4, x_max_m: 0, y_min_m: -0.1, y_max_m: 0.1}
          east: {shape: polygon, points_m: [[-0.1, -0.1], [0.2, -0.1], [0.2, 0.1], [-0.1, 0.1]]}
          north: {shape: circle, centre_m: [0.4, 0.4], radius_m: 0.1}
        groups: {pair: [west, east]}
        """
        sixths = [
            int((x + 0.4) / 0.1) for x, _ in many(stage(sections, placing("ball", "{uniform_in: pair}")), times=1200)
        ]
        assert set(sixths) == set(range(6))
        assert all(165 < sixths.count(part) < 235 for part in range(6))
        listed = many(stage(sections, placing("ball", "{uniform_in: [west, north]}")), times=400)
        in_north = [math.hypot(x - 0.4, y - 0.4) < 0.1001 for x, y in listed]
        assert all(there or (-0.4 < x < 0 and -0.1 < y < 0.1) for there, (x, y) in zip(in_north, listed, strict=True))
        assert 0.2 < sum(in_north) / len(in_north) < 0.36  # 0.0314 of 0.1114 m²


def test_on_line_is_between_both_ends(stage):
    places = many(stage(placing("ball", "{on_line: [[-0.4, 0.1], [0.4, -0.1]]}")))
    assert all(y == pytest.approx(-x / 4, abs=1e-6) and abs(x) <= 0.4 for x, y in places)
    assert max(x for x, _ in places) > 0.25
    assert min(x for x, _ in places) < -0.25


def test_choice_is_one_of_them(stage):
    places = many(stage(placing("ball", "{choice: [centre, [0.1, 0.1], middle_yellow]}")))
    assert {(round(x, 3), round(y, 3)) for x, y in places} == {(0.0, 0.0), (0.1, 0.1), (0.0, -0.2)}


class TestPlaceNearestFree:
    def test_it_is_the_nearest_spot_that_is_free(self, stage):
        play = stage(placing("ball", "{nearest_free: neutral_spots}"))
        play.place("ball", 0.02, 0.2)  # its own present place makes middle_blue taken
        assert put(play) == pytest.approx((0.0, 0.0))
        play.place("ball", 0.1, 0.21)
        assert put(play) == pytest.approx((0.0, 0.2))

    def test_a_spot_just_at_the_clearance_is_free(self, stage):
        # 0.0800000 in float32 lies a little above 0.08.
        play = stage(placing("ball", "{nearest_free: [centre, middle_blue], to: centre}"))
        play.place("ball", 0.5, 0.0)
        play.place("B1", 0.0, -0.0800001)
        assert put(play) == (0.0, 0.0)
        play.place("ball", 0.5, 0.0)
        play.place("B1", 0.0, -0.0799)
        assert put(play) == pytest.approx((0.0, 0.2))

    def test_one_of_so_many_nearest_is_drawn(self, stage):
        play = stage(placing("ball", "{nearest_free: neutral_spots, choose_among: 3}"))
        found = set()
        for _ in range(60):
            play.place("ball", 0.55, 0.55)
            play.play()
            found.add(tuple(round(number, 3) for number in put(play)))
        assert found == {(0.3, 0.3), (0.0, 0.2), (0.0, 0.0)}  # the next would be (0.3, -0.3)

    def test_a_body_must_fit_there(self, stage):
        play = stage(
            "obstacles: {post: {shape: cylinder, centre_m: [0, 0.25], radius_m: 0.02}}",
            placing("B1", "{nearest_free: [middle_blue, middle_yellow], to: middle_blue}"),
        )
        assert put(play, "B1") == pytest.approx((0.0, -0.2))  # the post leaves no room beside the spot


class TestPlacesApart:
    @pytest.mark.parametrize(
        ("at", "expected"),
        [
            ("{nearest_free: [middle_blue, middle_yellow], to: [Y1, Y2]}", (0.0, -0.2)),
            ("{furthest_free: [middle_blue, middle_yellow], from: yellow}", (0.0, 0.2)),
            ("{furthest_free: [middle_blue, middle_yellow], from: [B1, middle_blue]}", (0.0, -0.2)),
            ("{furthest_free: [middle_blue, middle_yellow], from: [0, 0.3]}", (0.0, -0.2)),
        ],
    )
    def test_of_several_the_nearest_counts(self, stage, at, expected):
        play = stage(placing("ball", at))
        play.place("Y2", 0.5, 0.6)  # further from both spots than Y1
        play.place("Y1", -0.3, -0.2)
        assert put(play) == pytest.approx(expected)

    def test_what_is_off_the_field_and_what_is_placed_do_not_count(self, stage):
        removed = "rules: {off: {triggers: [{trigger: half_started}], actions: [{action: remove, entity: Y2}]}}"
        put_back = placing("Y1", "{furthest_free: [middle_blue, middle_yellow], from: yellow, clearance_m: 0}")
        play = stage(removed, put_back)
        play.place("Y1", 0.0, 0.3)
        assert put(play, "Y1") == pytest.approx((0.0, 0.2))  # none is left: the first

    @pytest.mark.parametrize(
        "at", ["uniform_in: area", "on_line: [[-0.4, 0.1], [0.4, 0.1]]", "choice: [[0.1, 0.1], [0.3, 0.1]]"]
    )
    @pytest.mark.parametrize(("names", "centres"), [("[0, 0]", [(0, 0)]), ("[B1, Y1]", [(0.0, 0.1), (-0.2, 0.1)])])
    def test_random_place_is_so_far_from_all(self, stage, at, names, centres):
        area = "zones: {area: {shape: rect, x_min_m: -0.4, x_max_m: 0.4, y_min_m: 0, y_max_m: 0.2}}"
        play = stage(area, placing("ball", f"{{{at}, from: {names}, at_least_m: 0.2}}"))
        play.place("B1", 0.0, 0.1)
        play.place("Y1", -0.2, 0.1)
        places = many(play)
        assert all(math.dist(place, centre) >= 0.2 for place in places for centre in centres)

    def test_without_such_a_place_nothing_is_placed(self, stage):
        play = stage(placing("ball", "{on_line: [[-0.1, 0.1], [0.1, 0.1]], from: centre, at_least_m: 0.3}"))
        play.place("ball", 0.5, 0.5)
        assert put(play) == pytest.approx((0.5, 0.5))
        assert [(one.rule, one.suppressed) for one in play.firings if one.suppressed] == [("act", "no_room")]

    def test_spot_is_set_so_far_from_them(self, stage):
        rule = on_fault(
            "Y1", "{action: set_spot, spot: centre, to: {on_line: [[-0.4, 0], [0.4, 0]], from: ball, at_least_m: 0.2}}"
        )
        play = stage(rule)
        found = []
        for _ in range(40):
            fail(play, "Y1")
            found.append(play.referee.spots["centre"])
        assert all(math.dist(one, (0, 0)) >= 0.2 for one in found)


class TestPlaceFurthestFree:
    def test_it_is_the_furthest_free_spot(self, stage):
        play = stage(placing("B1", "{furthest_free: neutral_spots}"))
        assert put(play, "B1") == pytest.approx((-0.3, -0.3))
        play = stage(placing("B1", "{furthest_free: neutral_spots, from: ball}"))
        play.place("ball", -0.5, 0.5)
        assert put(play, "B1") == pytest.approx((0.3, -0.3))


@pytest.mark.parametrize(
    ("at", "pose", "where"),
    [
        ("{relative_to: B1, offset_m: [0.1, -0.2]}", (0.4, 0.5), (0.5, 0.3)),
        ("{relative_to: middle_blue, offset_m: [0.1, 0]}", (0.4, 0.5), (0.1, 0.2)),
        ("{relative_to: B1, offset_m: [0.2, 0.1], turns: true}", (0.0, 0.2, math.pi / 2), (-0.1, 0.4)),
        ("{relative_to: B1, offset_m: [0, -0.2]}, mirror: {axis: y}", (0.4, 0.2), (0.4, 0.4)),
        ("{point: [0.1, 0.2]}, mirror: {axis: x}", (0.4, 0.5), (-0.1, 0.2)),
        ("{point: [0.1, 0.2]}, mirror: {axis: y}", (0.4, 0.5), (0.1, -0.2)),
        ("{point: [0.1, 0.2]}, mirror: {axis: both}", (0.4, 0.5), (-0.1, -0.2)),
        ("{point: [0, 1.2]}", (0.4, 0.5), (0.0, 0.0)),  # a point outside the field
    ],
)
def test_offsets_and_mirrors(stage, at, pose, where):
    play = stage(placing("ball", at))
    play.place("B1", *pose)
    assert put(play) == pytest.approx(where)


class TestFacing:
    @pytest.mark.parametrize(
        ("facing", "yaw"),
        [
            ("start", -1.57),
            ("keep", 0.5),
            ("1.25", 1.25),
            ("{towards: ball}", -math.pi / 2),
            ("{towards: [0.3, 0.3]}", 0.0),
        ],
    )
    def test_which_way_it_looks_afterwards(self, stage, facing, yaw):
        play = stage(placing("B1", "{point: [0, 0.3]}", f", facing: {facing}"))
        play.place("B1", 0.4, 0.4, 0.5)
        put(play)
        assert play.pose("B1")[2] == pytest.approx(yaw, abs=1e-6)

    @pytest.mark.parametrize("order", ["B1, ball", "ball, B1"])
    def test_it_looks_at_where_a_thing_is_afterwards_whichever_is_put_first(self, stage, order):
        things = {
            "B1": "{entity: B1, at: {point: [0, 0.3]}, facing: {towards: ball}}",
            "ball": "{entity: ball, at: {point: [0, 0]}}",
        }
        shot = ", ".join(things[name] for name in order.split(", "))
        play = stage(f"placements: {{shot: [{shot}]}}", on_fault("Y1", "{action: place, layout: shot}"))
        play.place("ball", 0, 0.7)
        put(play)
        assert play.pose("B1") == pytest.approx((0, 0.3, -math.pi / 2), abs=1e-6)

    def test_a_robot_without_room_to_turn_looks_where_the_thing_was(self, stage):
        shot = """
        placements:
          shot:
            - {entity: B1, at: {point: [0, 0.3]}, facing: {towards: ball}}
            # Turned to the ball's new place, the corner of B1 would be in Y1.
            - {entity: Y1, at: {point: [0.09, 0.3]}, facing: 1.5708}
            - {entity: ball, at: {point: [0.4, -0.1]}}
        """
        play = stage(shot, on_fault("Y1", "{action: place, layout: shot}"))
        play.place("ball", 0.4, 0.3)
        put(play)
        assert play.pose("Y1")[:2] == pytest.approx((0.09, 0.3))
        assert play.pose("B1")[2] == pytest.approx(0, abs=1e-6)

    def test_it_can_be_random(self, stage):
        play = stage(placing("B1", "{point: [0, 0.3]}", ", facing: {random: true}"))
        yaws = [put(play) and play.pose("B1")[2] for _ in range(40)]
        assert min(yaws) < -2
        assert max(yaws) > 2


class TestNoiseAndClearance:
    def test_noise_is_uniform_within_its_half_widths(self, stage):
        places = many(stage(placing("ball", "{point: [0, 0]}", ", noise_m: [0.1, 0.02]")))
        assert all(abs(x) <= 0.1 and abs(y) <= 0.02 for x, y in places)
        assert min(x for x, _ in places) < -0.07
        assert max(x for x, _ in places) > 0.07
        assert min(y for _, y in places) < -0.014
        assert max(y for _, y in places) > 0.014

    def test_a_random_place_keeps_clear_of_other_bodies(self, stage):
        play = stage(placing("ball", "{on_line: [[-0.4, 0.4], [0.4, 0.4]]}", ", min_clearance_m: 0.1"))
        play.place("B1", 0.0, 0.4, 0.0)
        for x, _ in many(play):
            assert abs(x) >= 0.0375 + 0.1 + 0.021 - 1e-5

    @pytest.mark.parametrize(
        "round_one",
        [
            "balls: {second: {start_m: [0, 0.5]}}",
            "obstacles: {post: {shape: cylinder, radius_m: 0.021, centre_m: [0, 0.5]}}",
        ],
    )
    @pytest.mark.parametrize(("gap_m", "put_there"), [(0.018, True), (0.022, False)])
    def test_a_ball_keeps_clear_of_another_ball_and_of_a_post(self, stage, round_one, gap_m, put_there):
        # 0.06 lie between the middles of two whose radii are 0.021, and so 0.018 between them.
        play = stage(round_one, placing("ball", "{point: [0.036, 0.548]}", f", min_clearance_m: {gap_m - 1e-4}"))
        assert (put(play) != (0.0, 0.0)) is put_there


def test_what_finds_no_room_keeps_its_place_and_others_do_not_get_it(stage):
    swap = (
        f"{{action: place, entity: {robot}, at: {{point: {to}}}}}"
        for robot, to in (("B1", "[-0.4, 0.5]"), ("B2", "[0.4, -0.5]"))
    )
    play = stage(on_fault("Y1", *swap))
    put(play)  # Y2 stands where B2 is to go, so B2 stays, so B1 has no room
    assert play.placements == []


@given(
    seed=st.integers(0, 2**32),
    spots=st.lists(st.tuples(st.floats(-0.5, 0.5), st.floats(-0.6, 0.6)), min_size=1, max_size=8, unique=True),
    crowd=st.lists(st.tuples(st.floats(-0.5, 0.5), st.floats(-0.6, 0.6)), min_size=3, max_size=3),
    at=st.sampled_from(
        ["{nearest_free: any_spot, choose_among: 3}", "{furthest_free: any_spot}", "{uniform_in: area}", "start"]
    ),
)
def test_two_never_get_one_spot_and_placements_never_overlap(small, seed, spots, crowd, at):
    listed = ", ".join(f"s{i}: {{x_m: {x:.4f}, y_m: {y:.4f}}}" for i, (x, y) in enumerate(spots))
    scenario = small(
        f"spots: {{{listed}}}\ngroups: {{any_spot: [{', '.join(f's{i}' for i in range(len(spots)))}]}}\n"
        "zones: {area: {shape: rect, x_min_m: -0.6, x_max_m: 0.6, y_min_m: -0.7, y_max_m: 0.7}}",
        placing("[robots, ball]", at, ", facing: {random: true}, max_attempts: 20"),
    )
    roster = Roster.of(scenario)
    play = ScriptedMatch(scenario, roster, half_of(scenario, seed=seed))
    for robot, place in zip(("B1", "B2", "Y1"), crowd, strict=True):
        play.place(robot, *place)
    for _ in range(3):
        before = len(play.placements)
        put(play)
        placed = {placement.entity for _, placement in play.placements[before:]}
        bodies, poses = Bodies(scenario, roster), {roster.index[name]: play.pose(name) for name in roster.entities}
        for entity in placed:
            others = {index: pose for index, pose in poses.items() if index != entity}
            assert bodies.fits(entity, poses[entity], others, 0.0)


def test_the_same_seed_gives_the_same_places_another_seed_or_half_others(stage):
    rule = placing("ball", "{on_line: [[-0.4, 0.4], [0.4, 0.4]]}")
    one, again = (many(stage(rule, seed=3), times=5) for _ in range(2))
    assert one == again
    assert one != many(stage(rule, seed=4), times=5)
    assert one != many(stage(rule, seed=3, half=2), times=5)
