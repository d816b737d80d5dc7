"""What cameras recognize, compared with their pictures."""

import math
import random
from dataclasses import replace

import numpy as np
import pytest

from rcj_challenges.devices.base import Eye, Seen
from rcj_challenges.world.camera_renderer import CameraRenderer
from rcj_challenges.world.standing import colour_digits
from tests.world.physics_stage import Stage
from tests.world.test_camera_renderer import LENSES, LOOK, OBSTACLES, ROUND, scatter

COLOURS = dict(
    zip(("B1", "B2", "B3", "Y1", "Y2", "Y3"), ("red", "lime", "cyan", "magenta", "orange", "navy"), strict=True)
)
BALLS = {"ball": {"colour": "plum"}, "second": {"colour": "salmon", "radius_m": 0.035}}


@pytest.fixture(scope="module")
def stage() -> Stage:
    """A field on which everything has a colour of its own."""
    tints = ("pink", "gold", "tan", "teal", "violet")
    return Stage(
        obstacles={name: {**one, "colour": tint} for (name, one), tint in zip(OBSTACLES.items(), tints, strict=True)},
        balls=BALLS, kits={"round": ROUND},
        robots={name: {"colour": colour, **({"kit": "round"} if name[1] == "2" else {})} for name, colour in COLOURS.items()},
    )  # fmt: skip


def boxes_in(picture: bytes, sight: CameraRenderer, eye: Eye) -> dict[tuple[int, int, int], tuple[int, int, int, int]]:
    """Return the box of the pixels of each colour."""
    numbers = np.frombuffer(picture, np.uint8).reshape(eye.height, eye.width)
    boxes = {}
    for number, rgb in enumerate(sight.palette):
        rows, columns = np.nonzero(numbers == number)
        if len(rows):
            left, top = int(columns.min()), int(rows.min())
            boxes[rgb] = (left, top, int(columns.max()) + 1 - left, int(rows.max()) + 1 - top)
    return boxes


def most_pixels_off(one: tuple[int, int, int, int], other: tuple[int, int, int, int]) -> int:
    ends = [(left, top, left + width, top + height) for left, top, width, height in (one, other)]
    return max(abs(mine - theirs) for mine, theirs in zip(*ends, strict=True))


@pytest.mark.parametrize("lens", LENSES)
def test_what_is_recognized_is_what_the_picture_shows(stage: Stage, lens: str) -> None:
    # Without the seam of a panorama: what lies across it has pixels at both ends.
    eye = replace(LENSES[lens], fov_rad=min(LENSES[lens].fov_rad, 4.0))
    rng, sight = random.Random(lens), CameraRenderer(stage.scenario, stage.roster, stage.world)  # noqa: S311
    shown, differ = 0, []
    for _ in range(20):
        scatter(stage, rng)
        eyes = [(stage.index(name), eye) for name in COLOURS]
        for picture, things in zip(sight.take(eyes), sight.recognize(eyes), strict=True):
            boxes, found = boxes_in(picture, sight, eye), {one.rgb: one.box for one in things}
            assert len(found) == len(things)
            tints = {one.rgb for one in things} | (boxes.keys() & set(map(rgb_of, all_colours(stage))))
            shown += len(tints)
            differ += [t for t in tints if t not in boxes or t not in found or most_pixels_off(boxes[t], found[t]) > 1]
    assert shown > 200
    assert len(differ) <= shown / 150, differ


def all_colours(stage: Stage) -> list[str]:
    scenario = stage.scenario
    return [one.colour for things in (scenario.robots, scenario.balls, scenario.obstacles) for one in things.values()]


def rgb_of(colour: str) -> tuple[int, int, int]:
    red, green, blue = bytes.fromhex(colour_digits(colour)[1:])
    return red, green, blue


def seen_from(stage: Stage, name: str, eye: Eye = LOOK) -> list[Seen]:
    (things,) = CameraRenderer(stage.scenario, stage.roster, stage.world).recognize([(stage.index(name), eye)])
    return things


def test_a_ball_in_a_goal_is_hidden_by_the_corner_of_the_end_wall() -> None:
    stage = Stage()
    goal_y = stage.scenario.field.length_m / 2
    stage.put("ball", -0.16, goal_y + 0.04)
    stage.put("Y1", -0.1, goal_y - 0.3, math.pi / 2)
    assert [one.model for one in seen_from(stage, "Y1")] == ["ball"]
    stage.put("Y1", -0.5, goal_y - 0.08, 0.3)
    assert seen_from(stage, "Y1") == []


def test_all_numbers_stay_if_robot_and_things_are_moved_and_turned_together() -> None:
    """So none of them is of the field's frame."""
    stage = Stage(obstacles={"cart": OBSTACLES["cart"]})
    things = {"Y1": (0.0, 0.0, 0.0), "ball": (0.2, 0.03, 0.0), "B1": (0.3, -0.1, 1.0), "cart": (0.35, 0.1, -0.5)}

    def seen(x: float, y: float, turn: float) -> list[Seen]:
        for name, (ahead, aside, yaw) in things.items():
            stage.put(name, x + ahead * math.cos(turn) - aside * math.sin(turn),
                      y + ahead * math.sin(turn) + aside * math.cos(turn), yaw + turn)  # fmt: skip
        return seen_from(stage, "Y1")

    here, there = seen(-0.3, 0.1, 0.0), seen(0.2, -0.3, 2.0)
    assert [one.model for one in here] == ["ball", "robot", "obstacle"]
    for one, other in zip(here, there, strict=True):
        assert (one.number, one.model, one.rgb, one.box) == (other.number, other.model, other.rgb, other.box)
        numbers = [(*thing.position, math.cos(thing.yaw_rad), math.sin(thing.yaw_rad), thing.width_m, thing.height_m)
                   for thing in (one, other)]  # fmt: skip
        assert numbers[0] == pytest.approx(numbers[1], abs=1e-9)


def test_a_wall_beside_a_panorama_is_as_high_as_it_is_where_it_is_nearest() -> None:
    """Its corners are farther away than its middle."""
    stage = Stage(
        obstacles={"screen": {"shape": "wall", "from_m": [0.12, -0.2], "to_m": [0.12, 0.2], "height_m": 0.15}}
    )
    stage.put("Y1", 0.0, 0.0)
    eye = LENSES["panorama"]
    sight = CameraRenderer(stage.scenario, stage.roster, stage.world)
    (screen,) = seen_from(stage, "Y1", eye)
    (picture,) = sight.take([(stage.index("Y1"), eye)])
    assert most_pixels_off(screen.box, boxes_in(picture, sight, eye)[screen.rgb]) == 0


def test_a_ball_whose_middle_is_below_the_picture_is_as_wide_as_what_is_visible_of_it() -> None:
    stage, eye = Stage(), replace(LOOK, down=0.45)
    stage.put("Y1", 0.0, 0.0)
    sight = CameraRenderer(stage.scenario, stage.roster, stage.world)
    for ahead_m in (0.09, 0.1, 0.11, 0.12):
        stage.put("ball", ahead_m, 0.01)
        (ball,) = seen_from(stage, "Y1", eye)
        (picture,) = sight.take([(stage.index("Y1"), eye)])
        assert most_pixels_off(ball.box, boxes_in(picture, sight, eye)[ball.rgb]) <= 1


def test_from_within_a_goal_its_walls_hide_what_is_on_the_field() -> None:
    stage, eye = Stage(), replace(LENSES["panorama"], ahead_m=0.03, fov_rad=4.0)
    goal_y = stage.scenario.field.length_m / 2
    stage.put("Y1", 0.0, goal_y, math.pi / 2)
    stage.put("ball", 0.5, goal_y - 0.03)
    assert seen_from(stage, "Y1", eye) == []
    stage.put("ball", 0.5, goal_y - 0.1)
    assert [one.model for one in seen_from(stage, "Y1", eye)] == ["ball"]
