"""The match from above, by Pillow alone: no graphics library, no display."""

from __future__ import annotations

import math

import numpy as np
from PIL import Image, ImageDraw

from rcj_challenges.views.video.camera import Camera, ends_of_field
from rcj_challenges.views.video.colours import GATE
from rcj_challenges.views.video.footage import Footage, Poses
from rcj_challenges.views.video.ground import (
    LINE_M,
    Point,
    Projection,
    moving_gate_lines,
    paint_ground,
    whole_field,
)
from rcj_challenges.views.video.lettering import Lettering
from rcj_challenges.views.video.sprites import sprites_of
from rcj_challenges.views.video.timeline import Moment

_FINER = 3
"""Lines that move are drawn this many times larger each way and then reduced: smooth edges."""
_CLOSE_VIEW_M = 0.9
"""What a camera that follows something shows of the field along the shorter side of the picture."""


class TopDown:
    """Draws moments from above. The field is drawn once, what moves is put onto a copy of it.

    Args:
        footage: what is shown.
        size: of the whole picture, in pixels.
        top: how much of it is left free for the board.
        camera: ``field`` and ``top`` show all of the field; others follow.
        lettering: for the robots' numbers.
    """

    name = "from above"

    def __init__(self, footage: Footage, size: tuple[int, int], top: int, camera: Camera, lettering: Lettering) -> None:
        self._size, self._top, self._camera = size, top, camera
        whole = whole_field(footage, size, top)
        if camera.entity >= 0:
            self._ground, self._view = self._larger_ground(footage, whole)
        else:
            self._ground, self._view = paint_ground(footage, size, whole), whole
        # One for all: fresh memory for each frame costs more than the drawing.
        self._frame = Image.new("RGB", size)
        self._gates = moving_gate_lines(footage)
        self._sprites = [sprites_of(entity, self._view.px_per_m, lettering) for entity in footage.things["entities"]]
        # Robots hide what lies on the floor, and the ball is small: it is drawn last.
        kinds = [entity["kind"] for entity in footage.things["entities"]]
        self._order = sorted(range(len(kinds)), key=lambda k: ("obstacle", "robot", "ball").index(kinds[k]))

    def projection(self, moment: Moment) -> Projection:
        """Return where the points of the field are in the picture of a moment."""
        if self._camera.entity < 0:
            return self._view
        left, top = self._corner(moment)
        x, y = self._view.centre
        return Projection(self._view.px_per_m, self._view.lying, self._view.at, (x - left, y - top + self._top))

    def picture(self, moment: Moment) -> Image.Image:
        """Return the picture of a moment, without the board; it is drawn over by the next."""
        view = self.projection(moment)
        frame = self._frame
        self._put_ground(moment)
        poses = moment.half.poses(moment.t_s)
        self._draw_gates(view, poses)
        for entity in self._order:
            x_m, y_m, yaw_rad, _ = poses[entity].tolist()
            if not np.isnan(x_m):
                at, turn_rad = view.px(x_m, y_m), view.turn_rad(yaw_rad)
                for sprite in self._sprites[entity]:
                    sprite.put(frame, at, turn_rad)
        return frame

    def close(self) -> None:
        """Nothing to give back."""

    def _draw_gates(self, view: Projection, poses: Poses) -> None:
        """Draw the gates that move with something on the field: lines on the floor, under all that stands on it."""
        for entity, lines in self._gates.items():
            x_m, y_m, yaw_rad, _ = poses[entity].tolist()
            if math.isnan(x_m):
                continue
            c, s = math.cos(yaw_rad), math.sin(yaw_rad)
            for line in lines:
                start, end = (view.px(x_m + c * x - s * y, y_m + s * x + c * y) for x, y in line)
                self._draw_line(start, end, LINE_M * view.px_per_m)

    def _draw_line(self, start: Point, end: Point, width_px: float) -> None:
        """Draw one with smooth edges: finer than the frame, on the part of it that the line covers."""
        reach = math.ceil(width_px) + 1
        left, top = (max(math.floor(min(pair)) - reach, 0) for pair in zip(start, end, strict=True))
        right, bottom = (
            min(math.ceil(max(pair)) + reach, edge)
            for pair, edge in zip(zip(start, end, strict=True), self._size, strict=True)
        )
        if left >= right or top >= bottom:
            return
        mask = Image.new("L", ((right - left) * _FINER, (bottom - top) * _FINER))
        finer = [((x - left) * _FINER, (y - top) * _FINER) for x, y in (start, end)]
        ImageDraw.Draw(mask).line(finer, fill=255, width=max(_FINER, round(width_px * _FINER)))
        self._frame.paste(GATE, (left, top), mask.reduce(_FINER))

    def _put_ground(self, moment: Moment) -> None:
        if self._camera.entity < 0:
            self._frame.paste(self._ground)
            return
        left, top = self._corner(moment)
        width, height = self._size
        self._frame.paste(self._ground.crop((left, top, left + width, top + height - self._top)), (0, self._top))

    def _corner(self, moment: Moment) -> tuple[int, int]:
        """Return the corner, in whole pixels of the larger ground, of what a camera that follows shows of it."""
        x, y = self._view.px(*self._camera.target(moment.half, moment.t_s))
        width, height = self._size[0], self._size[1] - self._top
        return (
            _within(round(x - width / 2), self._ground.width - width),
            _within(round(y - height / 2), self._ground.height - height),
        )

    def _larger_ground(self, footage: Footage, whole: Projection) -> tuple[Image.Image, Projection]:
        """Return the ground that a camera moves over: at least as large as the picture."""
        width, height = self._size[0], self._size[1] - self._top
        across, along = ends_of_field(footage)
        scale = max(min(width, height) / _CLOSE_VIEW_M, whole.px_per_m)
        right, up = (along, across) if whole.lying else (across, along)
        size = (max(width, round(2.1 * right * scale)), max(height, round(2.1 * up * scale)))
        view = Projection(scale, whole.lying, (0.0, 0.0), (size[0] / 2, size[1] / 2))
        return paint_ground(footage, size, view), view


def _within(value: int, largest: int) -> int:
    return min(max(value, 0), max(largest, 0))
