"""What moves, seen from above: drawn once, large, then turned and shrunk into every frame."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from PIL import Image, ImageDraw

from rcj_challenges.views.video.colours import EDGE, WHEEL, WHITE, Rgb, mixed, rgb, text_on
from rcj_challenges.views.video.ground import Point
from rcj_challenges.views.video.lettering import Lettering

_FINER = 2
"""A sprite has this many pixels for one of the picture: bilinear sampling then takes the mean of all it covers."""
_DRAWN_FINER = 4
"""It is drawn this many times larger still and reduced: smooth edges."""


@dataclass(frozen=True)
class Sprite:
    """A picture of one thing.

    Attributes:
        image: RGBa (colours times alpha, so that nothing shines at its edges); the thing's centre is in its middle,
            its front to the right.
        reach_px: half the edge of the square that it covers in a frame, whatever its turn.
        turns: whether it turns with the thing.
    """

    image: Image.Image
    reach_px: int
    turns: bool = True

    def put(self, frame: Image.Image, at: Point, turn_rad: float) -> None:
        """Draw it into a frame, to a fraction of a pixel.

        Args:
            frame: RGB.
            at: where its centre is to be, in continuous pixel coordinates.
            turn_rad: direction of its front, counter-clockwise from the right.
        """
        reach = self.reach_px
        left, top = math.floor(at[0]) - reach, math.floor(at[1]) - reach
        edge = 2 * reach + 1
        if left + edge < 0 or top + edge < 0 or left > frame.width or top > frame.height:
            return
        angle = turn_rad if self.turns else 0.0
        c, s = _FINER * math.cos(angle), _FINER * math.sin(angle)
        dx, dy = left - at[0], top - at[1]
        middle = self.image.width / 2
        # Of a pixel of the patch: where it lies in the sprite.
        matrix = (c, -s, middle + c * dx - s * dy, s, c, middle + s * dx + c * dy)
        patch = self.image.transform((edge, edge), Image.Transform.AFFINE, matrix, Image.Resampling.BILINEAR)
        frame.paste(patch, (left, top), patch)


def sprites_of(entity: Mapping[str, Any], px_per_m: float, lettering: Lettering) -> tuple[Sprite, ...]:
    """Return the sprites of an entity as `visible_things` describes it, from the lowest to the highest."""
    if entity["kind"] == "robot":
        return _robot(entity, px_per_m, lettering)
    if entity["kind"] == "ball":
        return (_ball(entity, px_per_m),)
    return (_obstacle(entity, px_per_m),)


class _Easel:
    """A sprite while it is drawn: coordinates in m, x forward to the right, y left upwards."""

    def __init__(self, reach_m: float, px_per_m: float) -> None:
        self.reach_px = math.ceil(reach_m * px_per_m) + 2
        self.edge = (2 * self.reach_px + 1) * _FINER * _DRAWN_FINER
        self.scale = px_per_m * _FINER * _DRAWN_FINER
        self.image = Image.new("RGBA", (self.edge, self.edge))
        self.pen = ImageDraw.Draw(self.image)

    def px(self, x_m: float, y_m: float) -> Point:
        return self.edge / 2 + x_m * self.scale, self.edge / 2 - y_m * self.scale

    def box(self, x_m: float, y_m: float, centre: Point, colour: Rgb, round_m: float = 0.0) -> None:
        left, top = self.px(centre[0] - x_m / 2, centre[1] + y_m / 2)
        right, bottom = self.px(centre[0] + x_m / 2, centre[1] - y_m / 2)
        self.pen.rounded_rectangle((left, top, right, bottom), radius=round_m * self.scale, fill=(*colour, 255))

    def disc(self, radius_m: float, colour: Rgb, centre: Point = (0.0, 0.0)) -> None:
        self.pen.circle(self.px(*centre), radius_m * self.scale, fill=(*colour, 255))

    def sprite(self, *, turns: bool = True) -> Sprite:
        return Sprite(self.image.convert("RGBa").reduce(_DRAWN_FINER), self.reach_px, turns)


def _robot(entity: Mapping[str, Any], px_per_m: float, lettering: Lettering) -> tuple[Sprite, ...]:
    size, track = float(entity["size_m"]), float(entity["wheel_track_m"])
    radius, width = float(entity["wheel_radius_m"]), float(entity["wheel_width_m"])
    colour, front = rgb(str(entity["colour"])), int(entity["front"])
    easel = _Easel(math.hypot(size, track + width) / 2, px_per_m)
    for side in (-1, 1):
        easel.box(2 * radius, width, (0.0, side * track / 2), WHEEL)
    easel.box(size, size, (0.0, 0.0), EDGE, size * 0.1)
    easel.box(size * 0.93, size * 0.93, (0.0, 0.0), colour, size * 0.08)
    tip, base = front * size * 0.45, front * size * 0.26
    easel.pen.polygon([easel.px(tip, 0), easel.px(base, size * 0.2), easel.px(base, -size * 0.2)], fill=(*WHITE, 255))
    return easel.sprite(), _number(entity, size, px_per_m, lettering)


def _number(entity: Mapping[str, Any], size_m: float, px_per_m: float, lettering: Lettering) -> Sprite:
    """Return the number on the lid, which always stands upright."""
    easel = _Easel(size_m / 2, px_per_m)
    colour = text_on(rgb(str(entity["colour"])))
    height = max(6, round(size_m * 0.5 * easel.scale / _DRAWN_FINER))
    mask = lettering.mask(str(entity["number"]), height, bold=True)
    image = easel.image.reduce(_DRAWN_FINER)
    # Digits stand on the line, about 0.72 of the size tall; they are centred by eye on that.
    image.paste((*colour, 255), ((image.width - mask.width) // 2, round(image.height / 2 - height * 0.64)), mask)
    return Sprite(image.convert("RGBa"), easel.reach_px, turns=False)


def _ball(entity: Mapping[str, Any], px_per_m: float) -> Sprite:
    radius, colour = float(entity["radius_m"]), rgb(str(entity["colour"]))
    easel = _Easel(radius, px_per_m)
    easel.disc(radius, mixed(colour, EDGE, 0.5))
    easel.disc(radius * 0.86, colour)
    easel.disc(radius * 0.3, mixed(colour, WHITE, 0.55), (-radius * 0.3, radius * 0.35))
    return easel.sprite(turns=False)


def _obstacle(entity: Mapping[str, Any], px_per_m: float) -> Sprite:
    colour = rgb(str(entity["colour"]))
    if entity["shape"] == "cylinder":
        radius = float(entity["radius_m"])
        easel = _Easel(radius, px_per_m)
        easel.disc(radius, EDGE)
        easel.disc(radius * 0.93, colour)
        return easel.sprite()
    x_m, y_m = (float(length) for length in entity["size_m"])
    easel = _Easel(math.hypot(x_m, y_m) / 2, px_per_m)
    rim = min(x_m, y_m) * 0.07
    easel.box(x_m, y_m, (0.0, 0.0), EDGE)
    easel.box(x_m - rim, y_m - rim, (0.0, 0.0), colour)
    return easel.sprite()
