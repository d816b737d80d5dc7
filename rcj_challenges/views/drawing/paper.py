"""An SVG picture in field coordinates, with numbered markers and a legend."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Sequence
from textwrap import wrap
from typing import NamedTuple

from rcj_challenges.geometry.polygons import Point
from rcj_challenges.scenario.shapes import Box
from rcj_challenges.views.markup import escaped

MARKER_PX = 18.0
"""Height of a marker."""
LEGEND_PX = 385.0
"""Width of the legend beside the field."""
_DIGIT_PX = 7.0
_LEADER_FROM_PX = 20.0
"""A marker that stands further than this from its place gets a line that leads there."""
_RINGS_PX = (20.0, 32.0, 46.0, 62.0, 80.0)
_DIRECTIONS = 12
_LINE_PX = 18.0
_CHARACTERS = 48
"""Of a line of the legend: it holds them in wide fonts too."""
_TITLE_CHARACTERS = 36
_POINT = re.compile(r"\([-\d.]+, [-\d.]+\)")
_NO_BREAK = "\N{NO-BREAK SPACE}"
# Printed on A4, the smallest text is 7 pt high.
_STYLE = (
    "text{font-family:system-ui,-apple-system,'Segoe UI',sans-serif;fill:#1f2937}"
    ".number{font-size:13px;font-weight:700;fill:#ffffff;text-anchor:middle}.number.dark{fill:#161c24}"
    ".marker rect{stroke:#ffffff}.leader{stroke:#495057}"
    ".axis{font-size:12px;fill:#4b5563;text-anchor:middle}.title{font-size:17px;font-weight:700}"
    ".head{font-size:14px;font-weight:700}.entry{font-size:13px}"
)


class Entry(NamedTuple):
    """A line of the legend; it explains a marker by its number and colour, or a small box with SVG attributes."""

    text: str
    number: str = ""
    colour: str = ""
    sample: str = ""


Section = tuple[str, list[Entry]]
"""A heading of the legend with its lines."""


class _Marker(NamedTuple):
    at_px: Point
    offset_px: Point
    number: str
    name: str
    colour: str


class Paper:
    """Collects SVG elements. Coordinates are the field's: metres, x to the right, y up."""

    def __init__(self, bounds: Box, px_per_m: float) -> None:
        self.bounds = bounds
        self.scale = px_per_m
        self.width_px = (bounds[2] - bounds[0]) * px_per_m
        self.height_px = (bounds[3] - bounds[1]) * px_per_m
        self._elements: list[str] = []
        self._markers: list[_Marker] = []
        self._bodies: list[tuple[Point, float]] = []
        self._numbers = 0

    def px(self, point: Point) -> Point:
        """Return the place of a point of the field on the paper, in pixels."""
        return (point[0] - self.bounds[0]) * self.scale, (self.bounds[3] - point[1]) * self.scale

    def outline(self, points: Sequence[Point]) -> str:
        """Return the path description of a closed polygon."""
        return "M" + " L".join(f"{x:.1f} {y:.1f}" for x, y in map(self.px, points)) + " Z"

    def polygon(self, points: Sequence[Point], style: str, title: str = "") -> None:
        """Draw a closed polygon."""
        if points:
            self.path(self.outline(points), style, title)

    def path(self, description: str, style: str, title: str = "") -> None:
        """Draw a path whose description is already in pixels."""
        self._add("path", f'd="{description}" {style}', title)

    def circle(self, centre: Point, radius_m: float, style: str, title: str = "") -> None:
        """Draw a circle."""
        x, y = self.px(centre)
        self._add("circle", f'cx="{x:.1f}" cy="{y:.1f}" r="{radius_m * self.scale:.1f}" {style}', title)

    def line(self, start: Point, end: Point, style: str, title: str = "") -> None:
        """Draw a straight line."""
        (x1, y1), (x2, y2) = self.px(start), self.px(end)
        self._add("line", f'x1="{x1:.1f}" y1="{y1:.1f}" x2="{x2:.1f}" y2="{y2:.1f}" {style}', title)

    def clip(self, name: str, outlines: Sequence[Sequence[Point]]) -> None:
        """Name an area, so that elements with ``clip-path="url(#name)"`` show only in there."""
        area = " ".join(map(self.outline, outlines))
        self._elements.append(f'<clipPath id="{name}"><path d="{area}"/></clipPath>')

    def text_px(self, x: float, y: float, text: str, css: str) -> None:
        """Write text at a place in pixels."""
        self._elements.append(_text(x, y, text, css))

    def keep_free(self, centre: Point, radius_m: float) -> None:
        """Let no marker cover a robot or a ball."""
        self._bodies.append((self.px(centre), radius_m * self.scale))

    def new_number(self) -> str:
        """Return the next number of a marker."""
        self._numbers += 1
        return str(self._numbers)

    def mark(self, at: Point, number: str, name: str, colour: str, *, offset_px: Point = (0.0, 0.0)) -> None:
        """Add a marker; its place is chosen by `svg`."""
        self._markers.append(_Marker(self.px(at), offset_px, number, name, colour))

    def svg(self, title: str, sections: Sequence[Section] = (), *, shown: str = "field") -> str:
        """Return the picture with a legend on its right, without sections that have no lines; or only the picture."""
        elements, width, height = self._with_markers(), self.width_px, self.height_px
        if sections:
            lines, below = _legend(title, sections, self.width_px + 8)
            elements, width, height = elements + lines, width + LEGEND_PX, max(height, below)
        label, body = escaped(f"{title}: {shown}"), "\n".join(elements)
        return (
            f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width:.0f} {height:.0f}" width="{width:.0f}" '
            f'height="{height:.0f}" role="img" aria-label="{label}">\n'
            f"<title>{label}</title>\n<style>{_STYLE}</style>\n"
            f'<rect width="100%" height="100%" fill="#ffffff"/>\n{body}\n</svg>\n'
        )

    def _add(self, tag: str, attributes: str, title: str) -> None:
        inside = f"<title>{escaped(title)}</title>" if title else ""
        self._elements.append(f"<{tag} {attributes}>{inside}</{tag}>")

    def _with_markers(self) -> list[str]:
        """Return all elements, with each marker at its place or at the nearest one around it that is free."""
        placed: list[tuple[Point, float]] = []
        leaders, markers = list[str](), list[str]()
        for marker in self._markers:
            half_px = _half_width_px(marker.number)
            candidates = [self._inside(place) for place in _places(marker)]
            x, y = next((at for at in candidates if self._is_free(at, half_px, placed)), candidates[0])
            placed.append(((x, y), half_px))
            markers.append(_marker(x, y, marker.number, marker.colour, marker.name))
            x2, y2 = self._inside(marker.at_px)
            if math.dist((x, y), (x2, y2)) > _LEADER_FROM_PX:
                leaders.append(f'<line class="leader" x1="{x:.1f}" y1="{y:.1f}" x2="{x2:.1f}" y2="{y2:.1f}"/>')
        return self._elements + leaders + markers

    def _is_free(self, at: Point, half_px: float, placed: Sequence[tuple[Point, float]]) -> bool:
        x, y = at
        return all(
            abs(x - px) > half_px + other_px or abs(y - py) > MARKER_PX for (px, py), other_px in placed
        ) and all(math.dist(at, centre) > radius_px + MARKER_PX / 2 for centre, radius_px in self._bodies)

    def _inside(self, place: Point) -> Point:
        x, y = place
        return min(max(x, MARKER_PX), self.width_px - MARKER_PX), min(max(y, MARKER_PX), self.height_px - MARKER_PX)


def _text(x: float, y: float, text: str, css: str) -> str:
    return f'<text x="{x:.1f}" y="{y:.1f}" class="{css}">{escaped(text)}</text>'


def _marker(x: float, y: float, number: str, colour: str, name: str) -> str:
    half_px = _half_width_px(number)
    return (
        f'<g class="marker"><title>{escaped(name)}</title><rect x="{x - half_px:.1f}" y="{y - MARKER_PX / 2:.1f}" '
        f'width="{2 * half_px:.1f}" height="{MARKER_PX:.0f}" rx="{MARKER_PX / 2:.0f}" fill="{colour}"/>'
        f"{_text(x, y + 4.5, number, 'number')}</g>"
    )


def _legend(title: str, sections: Sequence[Section], x: float) -> tuple[list[str], float]:
    y, elements = 10.0, list[str]()
    for line in wrap(title, _TITLE_CHARACTERS):
        y += 1.3 * _LINE_PX
        elements.append(_text(x, y, line, "title"))
    for head, entries in sections:
        if entries:
            y += 1.6 * _LINE_PX
            elements.append(_text(x, y, head, "head"))
        for entry in entries:
            if entry.number:
                elements.append(_marker(x + 14, y + _LINE_PX - 4.5, entry.number, entry.colour, ""))
            if entry.sample:
                elements.append(f'<rect x="{x + 4:.1f}" y="{y + 7:.1f}" width="20" height="11" {entry.sample}/>')
            text = _POINT.sub(lambda point: point[0].replace(" ", _NO_BREAK), entry.text)
            for line in wrap(text, _CHARACTERS):
                y += _LINE_PX
                elements.append(_text(x + 32, y, line.replace(_NO_BREAK, " "), "entry"))
    return elements, y + 2 * _LINE_PX


def _half_width_px(number: str) -> float:
    return max(MARKER_PX, 6 + _DIGIT_PX * len(number) + 4) / 2


def _places(marker: _Marker) -> Iterator[Point]:
    """Yield the possible places of a marker, the best first."""
    (x, y), (dx, dy) = marker.at_px, marker.offset_px
    yield x + dx, y + dy
    for ring_px in _RINGS_PX:
        for step in range(_DIRECTIONS):
            turn = math.tau * step / _DIRECTIONS
            yield x + ring_px * math.cos(turn), y + ring_px * math.sin(turn)
