"""The zones of a scenario in its drawing."""

from __future__ import annotations

from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.shapes import Point, corners_of, floor_outline, middle, visible_outline, zone_words
from rcj_challenges.views.drawing.paper import MARKER_PX, Entry, Paper, Section
from rcj_challenges.views.palette import hex_of

BLACK = "#161c24"
# Dark enough for white numbers; none of these is near orange.
_ZONE_COLOURS = ("#7048e8", "#0b7285", "#c2255c", "#447007", "#9c36b5", "#4263eb", "#2b5f6b", "#a61e4d")


def draw_zones(paper: Paper, scenario: Scenario) -> Section:
    """Draw the zones; returns their part of the legend."""
    entries: list[Entry] = []
    for k, (name, zone) in enumerate(scenario.zones.items()):
        marker = _ZONE_COLOURS[k % len(_ZONE_COLOURS)]
        colour, marker = (hex_of(zone.colour), BLACK) if zone.colour else (marker, marker)
        dash = "" if zone.drawn else ' stroke-dasharray="6 4"'
        style = f'fill="{colour}" fill-opacity="0.06" stroke="{colour}" stroke-width="1.5"{dash}'
        area = visible_outline(zone, scenario.field, paper.bounds)
        if zone.inverted:
            whole = corners_of(*paper.bounds)
            both = " ".join(paper.outline(outline) for outline in (whole, area) if outline)
            paper.path(both, f'{style} fill-rule="evenodd"', f"all but {name}")
            area = area or whole
        else:
            paper.polygon(area, style, name)
        number = paper.new_number() if area else ""  # what lies beside the paper is only in the legend
        if area:
            on_floor = floor_outline(zone, scenario.field)
            paper.mark(corner_inside(paper, on_floor if _has_room(paper, on_floor) else area), number, name, marker)
        entries.append(Entry(f"{name}: {zone_words(zone)}", number, marker))
    return "Zones (m; dashed: not drawn on the field)", entries


def _has_room(paper: Paper, area: list[Point]) -> bool:
    xs, ys = [x for x, _ in area], [y for _, y in area]
    return bool(area) and min(max(xs) - min(xs), max(ys) - min(ys)) * paper.scale > MARKER_PX


def corner_inside(paper: Paper, area: list[Point]) -> Point:
    """Return a place for a marker inside an area, near its upper left corner."""
    x, y = min(area, key=lambda point: point[0] - point[1])
    to_x, to_y = middle(area)
    step_m = 0.8 * MARKER_PX / paper.scale
    return x + max(-step_m, min(step_m, to_x - x)), y + max(-step_m, min(step_m, to_y - y))
