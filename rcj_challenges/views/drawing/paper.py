"""A sheet of SVG paper in field coordinates, with labels that keep out of each other's way."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape
from itertools import pairwise

from rcj_challenges.views.drawing.labels import (
    CHARACTER_PX,
    LABEL_PX,
    Box,
    Label,
    Placed,
    Point,
    Surroundings,
    place_labels,
)

_FRAME_PX = 2.0
_BASELINE_PX = 3.5
"""How far below the middle of a line of text its letters stand."""

_THIN_LINE = 0.8
"""What it costs a label to cover a pixel of a line, in pixels that it rather stands off."""


class Paper:
    """Collects SVG elements. Coordinates are the field's: metres, x to the right, y up.

    Args:
        bounds: smallest x, smallest y, largest x, largest y of what is shown, in m.
        px_per_m: scale.
    """

    def __init__(self, bounds: Box, px_per_m: float) -> None:
        self.bounds = bounds
        self.scale = px_per_m
        self.width_px = (bounds[2] - bounds[0]) * px_per_m
        self.height_px = (bounds[3] - bounds[1]) * px_per_m
        self._elements: list[str] = []
        self._leaders_at: int | None = None
        self._labels: list[Label] = []
        self._around = Surroundings(
            (_FRAME_PX, _FRAME_PX, self.width_px - _FRAME_PX, self.height_px - _FRAME_PX), [], []
        )

    def px(self, point: Point) -> Point:
        """Return the place of a point of the field on the paper, in pixels."""
        return (point[0] - self.bounds[0]) * self.scale, (self.bounds[3] - point[1]) * self.scale

    def polygon(self, points: Sequence[Point], style: str, title: str = "", *, in_the_way: float = _THIN_LINE) -> None:
        """Draw a closed polygon; ``in_the_way`` is what it costs a label to cover a pixel of its outline."""
        if points:
            self._add("path", f'd="{self.outline(points)}" {style}', title)
            self._keep_off([*points, points[0]], in_the_way)

    def path(self, description: str, style: str, title: str = "") -> None:
        """Draw a path whose description is already in pixels."""
        self._add("path", f'd="{description}" {style}', title)

    def clip(self, name: str, outlines: Sequence[Sequence[Point]]) -> None:
        """Name an area, so that what is drawn with ``clip-path="url(#name)"`` shows only in there."""
        area = " ".join(map(self.outline, outlines))
        self._elements.append(f'<clipPath id="{name}"><path d="{area}"/></clipPath>')

    def outline(self, points: Sequence[Point]) -> str:
        """Return the path description of a closed polygon."""
        return "M" + " L".join(f"{x:.1f} {y:.1f}" for x, y in map(self.px, points)) + " Z"

    def stretch(self, points: Sequence[Point]) -> str:
        """Return the path description of a line that is not closed."""
        return "M" + " L".join(f"{x:.1f} {y:.1f}" for x, y in map(self.px, points))

    def circle(self, centre: Point, radius_m: float, style: str, title: str = "") -> None:
        """Draw a circle."""
        x, y = self.px(centre)
        self._add("circle", f'cx="{x:.1f}" cy="{y:.1f}" r="{radius_m * self.scale:.1f}" {style}', title)

    def line(self, start: Point, end: Point, style: str, title: str = "", *, in_the_way: float = _THIN_LINE) -> None:
        """Draw a straight line; ``in_the_way`` is what it costs a label to cover a pixel of it."""
        (x1, y1), (x2, y2) = self.px(start), self.px(end)
        self._add("line", f'x1="{x1:.1f}" y1="{y1:.1f}" x2="{x2:.1f}" y2="{y2:.1f}" {style}', title)
        self._keep_off([start, end], in_the_way)

    def reserve(self, centre: Point, radius_m: float) -> None:
        """Keep labels off a place."""
        x, y = self.px(centre)
        r = radius_m * self.scale
        self._around.solids.append((x - r, y - r, x + r, y + r))

    def body(self, outline: Sequence[Point]) -> None:
        """Keep labels off a thing, but for one whose area it is."""
        self._around.bodies.append(tuple(map(self.px, outline)))

    def label(
        self, at: Point, text: str, *, reach_m: float = 0.0, area: Sequence[Point] = (), colour: str = ""
    ) -> None:
        """Ask for a label; where it goes is decided at the end.

        Args:
            at: what it names, in m.
            text: what is written.
            reach_m: how far what it names reaches around ``at``.
            area: the outline of what it names, if that is an area in which the label may stand.
            colour: of the text; left out: that of all texts.
        """
        reach = reach_m * self.scale
        self._labels.append(Label(text, self.px(at), (reach, reach), tuple(map(self.px, area)), colour))

    def leaders_here(self) -> None:
        """Draw the lines that lead to what labels name below all that is drawn from here on."""
        self._leaders_at = len(self._elements)

    def text_px(self, x: float, y: float, text: str, css: str) -> None:
        """Write text at a place in pixels."""
        self._elements.append(f'<text x="{x:.1f}" y="{y:.1f}" class="{css}">{escape(text)}</text>')

    def note_px(self, x: float, y: float, text: str, css: str) -> None:
        """Write text at a place in pixels of the drawing, and keep labels off it."""
        self.text_px(x, y, text, css)
        self._around.solids.append((x, y - LABEL_PX, x + len(text) * CHARACTER_PX, y + _BASELINE_PX))

    def svg(self, *, title: str, style: str, extra_width_px: float = 0.0, height_px: float = 0.0) -> str:
        """Return the whole picture."""
        self._settle_labels()
        width, height = self.width_px + extra_width_px, max(self.height_px, height_px)
        body = "\n".join(self._elements)
        return (
            f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width:.0f} {height:.0f}" width="{width:.0f}" '
            f'height="{height:.0f}" role="img" aria-label="{escape(title, quote=True)}">\n'
            f"<title>{escape(title)}</title>\n<style>{style}</style>\n"
            f'<rect width="100%" height="100%" fill="#ffffff"/>\n{body}\n</svg>\n'
        )

    def _add(self, tag: str, attributes: str, title: str) -> None:
        inside = f"<title>{escape(title)}</title>" if title else ""
        self._elements.append(f"<{tag} {attributes}>{inside}</{tag}>")

    def _keep_off(self, points: Sequence[Point], weight: float) -> None:
        corners = [self.px(point) for point in points]
        if weight:
            self._around.lines.extend((side, weight) for side in pairwise(corners))

    def _settle_labels(self) -> None:
        """Write each label where it is least in the way, and draw the lines that lead from labels to things."""
        placed = place_labels(self._labels, self._around)
        at = len(self._elements) if self._leaders_at is None else self._leaders_at
        self._elements[at:at] = [line for one in placed for line in _leader(one)]
        self._elements.extend(map(_text, placed))
        self._labels.clear()


def _leader(placed: Placed) -> list[str]:
    if placed.leader is None:
        return []
    (x1, y1), (x2, y2) = placed.leader
    line = f'<line class="leader" x1="{x1:.1f}" y1="{y1:.1f}" x2="{x2:.1f}" y2="{y2:.1f}"/>'
    return [line, f'<circle class="end" cx="{x2:.1f}" cy="{y2:.1f}" r="1.5"/>']


def _text(placed: Placed) -> str:
    label = placed.label
    colour = f' style="fill:{label.colour}"' if label.colour else ""
    return (
        f'<text x="{placed.x:.1f}" y="{placed.y + _BASELINE_PX:.1f}" text-anchor="middle" class="label"{colour}>'
        f"{escape(label.text)}</text>"
    )
