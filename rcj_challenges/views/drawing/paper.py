"""A sheet of SVG paper in field coordinates, with labels that keep out of each other's way."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape

Point = tuple[float, float]
Box = tuple[float, float, float, float]

_LABEL_PX = 11.0
_CHARACTER_PX = 6.1  # mean width of a character of the label font at its size
_STEP_PX = 13.0


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
        self._labels: list[tuple[str, float, float, str, str]] = []
        self._taken: list[Box] = []

    def px(self, point: Point) -> Point:
        """Return the place of a point of the field on the paper, in pixels."""
        return (point[0] - self.bounds[0]) * self.scale, (self.bounds[3] - point[1]) * self.scale

    def polygon(self, points: Sequence[Point], style: str, title: str = "") -> None:
        """Draw a closed polygon."""
        if points:
            self._add("path", f'd="{self.outline(points)}" {style}', title)

    def path(self, description: str, style: str, title: str = "") -> None:
        """Draw a path whose description is already in pixels."""
        self._add("path", f'd="{description}" {style}', title)

    def outline(self, points: Sequence[Point]) -> str:
        """Return the path description of a closed polygon."""
        return "M" + " L".join(f"{x:.1f} {y:.1f}" for x, y in map(self.px, points)) + " Z"

    def circle(self, centre: Point, radius_m: float, style: str, title: str = "") -> None:
        """Draw a circle."""
        x, y = self.px(centre)
        self._add("circle", f'cx="{x:.1f}" cy="{y:.1f}" r="{radius_m * self.scale:.1f}" {style}', title)

    def line(self, start: Point, end: Point, style: str, title: str = "") -> None:
        """Draw a straight line."""
        (x1, y1), (x2, y2) = self.px(start), self.px(end)
        self._add("line", f'x1="{x1:.1f}" y1="{y1:.1f}" x2="{x2:.1f}" y2="{y2:.1f}" {style}', title)

    def reserve(self, centre: Point, radius_m: float) -> None:
        """Keep labels off a place."""
        x, y = self.px(centre)
        r = radius_m * self.scale
        self._taken.append((x - r, y - r, x + r, y + r))

    def label(self, at: Point, text: str, *, anchor: str = "middle", css: str = "label") -> None:
        """Ask for a label near a point; where it goes is decided at the end."""
        x, y = self.px(at)
        self._labels.append((text, x, y, anchor, css))

    def text_px(self, x: float, y: float, text: str, css: str) -> None:
        """Write text at a place in pixels."""
        self._elements.append(f'<text x="{x:.1f}" y="{y:.1f}" class="{css}">{escape(text)}</text>')

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

    def _settle_labels(self) -> None:
        """Write each label at the free place nearest to where it was asked for."""
        for text, x, y, anchor, css in self._labels:
            half = len(text) * _CHARACTER_PX / 2
            shift = {"start": half, "middle": 0.0, "end": -half}[anchor]
            centre = min(max(x + shift, half + 2), self.width_px - half - 2)
            offsets = sorted((step * _STEP_PX for step in range(-12, 13)), key=lambda off: (abs(off), off))
            chosen = next((off for off in offsets if self._is_free(centre, y + off, half)), 0.0)
            self._taken.append(self._label_box(centre, y + chosen, half))
            self._elements.append(
                f'<text x="{centre:.1f}" y="{y + chosen + 3.5:.1f}" text-anchor="middle" class="{css}">'
                f"{escape(text)}</text>"
            )
        self._labels.clear()

    def _label_box(self, x: float, y: float, half: float) -> Box:
        return x - half, y - _LABEL_PX / 2, x + half, y + _LABEL_PX / 2

    def _is_free(self, x: float, y: float, half: float) -> bool:
        left, top, right, bottom = self._label_box(x, y, half)
        if top < 0 or bottom > self.height_px:
            return False
        return not any(b[0] < right and left < b[2] and b[1] < bottom and top < b[3] for b in self._taken)
