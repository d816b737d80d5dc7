"""A scenario as a picture: what stands where, what is judged where, and what is put where."""

from __future__ import annotations

import math
from collections.abc import Iterator

from rcj_challenges.scenario.models.actions import Place, Remove
from rcj_challenges.scenario.models.field import Box as BoxObstacle
from rcj_challenges.scenario.models.field import Cylinder, Wall
from rcj_challenges.scenario.models.places import At, AtPoint, Choice, OnLine, UniformIn
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.roster import Roster
from rcj_challenges.views.drawing.paper import Paper, Point
from rcj_challenges.views.drawing.shapes import box, middle, point_words, turned, zone_outline, zone_words

_PX_PER_M = 460.0
_MARGIN_M = 0.08
_LEGEND_PX = 380.0
_LINE_PX = 15.0
_WALL_M = 0.01
_ZONE_COLOURS = ("#7048e8", "#1098ad", "#d6336c", "#5c940d", "#e67700", "#4263eb", "#0b7285", "#a61e4d")
_STYLE = (
    "text{font-family:system-ui,-apple-system,'Segoe UI',sans-serif;fill:#1f2937}"
    ".label{font-size:11px;paint-order:stroke;stroke:#ffffff;stroke-width:3px;stroke-linejoin:round}"
    ".number{font-size:13px;font-weight:700;fill:#ffffff;text-anchor:middle}"
    ".axis{font-size:10px;fill:#6b7280}.title{font-size:16px;font-weight:700}.head{font-size:12px;font-weight:700}"
    ".entry{font-size:11px}"
)


def draw_scenario(scenario: Scenario, roster: Roster) -> str:
    """Return the drawing as an SVG document, with a legend that gives every number in m.

    Robots are drawn where they start; dashed boxes show the noise of start poses, hatching shows where things may be
    put by chance. Zones that are ``drawn`` have solid outlines, the others dashed ones.
    """
    field = scenario.field
    depth = max((goal.depth_m for goal in field.goals.values()), default=0.0)
    half_x, half_y = field.width_m / 2 + _MARGIN_M, field.length_m / 2 + depth + _MARGIN_M
    paper = Paper((-half_x, -half_y, half_x, half_y), _PX_PER_M)
    _ground(paper, scenario)
    _zones(paper, scenario)
    _placement_areas(paper, scenario)
    _gates(paper, scenario)
    _spots(paper, scenario)
    _obstacles(paper, scenario)
    _bodies(paper, scenario, roster)
    height = _legend(paper, scenario)
    return paper.svg(title=f"{scenario.title}: field", style=_STYLE, extra_width_px=_LEGEND_PX, height_px=height)


def _ground(paper: Paper, scenario: Scenario) -> None:
    field = scenario.field
    w, h, cut = field.width_m / 2, field.length_m / 2, field.corner_cut_m
    octagon = [(w - cut, h), (w, h - cut), (w, -h + cut), (w - cut, -h),
               (-w + cut, -h), (-w, -h + cut), (-w, h - cut), (-w + cut, h)]  # fmt: skip
    paper.polygon(octagon, 'fill="#e9f5ec" stroke="#343a40" stroke-width="4"', "the field, inside its walls")
    for name, goal in field.goals.items():
        sign = 1 if goal.end == "positive_y" else -1
        near, far, g = sign * h, sign * (h + goal.depth_m), goal.width_m / 2
        corners = [(-g, near), (g, near), (g, far), (-g, far)]
        paper.polygon(corners, f'fill="{_colour(goal.colour)}" fill-opacity="0.35"', name)
        for start, end in zip(corners[1:], [*corners[2:], corners[0]], strict=True):
            paper.line(start, end, f'stroke="{_colour(goal.colour)}" stroke-width="4"')
        paper.line((-g, near), (g, near), 'stroke="#ffffff" stroke-width="3"')
    paper.line((-w, 0), (w, 0), 'stroke="#adb5bd" stroke-dasharray="2 6"', "halfway line, y = 0")
    paper.line((0, -h), (0, h), 'stroke="#adb5bd" stroke-dasharray="2 6"', "x = 0")
    for x in (-w, 0.0, w):
        at = paper.px((x, -h - 0.03))
        paper.text_px(at[0] - 10, at[1] + 6, f"x {x:g}", "axis")
    for y in (-h, h):
        at = paper.px((-w - _MARGIN_M, y))
        paper.text_px(at[0] + 2, at[1] + (12 if y > 0 else -4), f"y {y:g}", "axis")


def _zones(paper: Paper, scenario: Scenario) -> None:
    for k, (name, zone) in enumerate(scenario.zones.items()):
        colour = _ZONE_COLOURS[k % len(_ZONE_COLOURS)]
        outline = zone_outline(zone, paper.bounds)
        dash = "" if zone.drawn else ' stroke-dasharray="6 4"'
        style = f'fill="{colour}" fill-opacity="0.06" stroke="{colour}" stroke-width="1.5"{dash}'
        if zone.inverted:
            left, bottom, right, top = paper.bounds
            everything = paper.outline([(left, bottom), (right, bottom), (right, top), (left, top)])
            paper.path(f"{everything} {paper.outline(outline)}", f'{style} fill-rule="evenodd"', f"all but {name}")
        else:
            paper.polygon(outline, style, name)
        paper.label(middle(outline, paper.bounds), f"not {name}" if zone.inverted else name)


def _placement_areas(paper: Paper, scenario: Scenario) -> None:
    """Hatch where chance may put something; each area once, however many rules put something there."""
    for at, noise in dict.fromkeys(_places(scenario)):
        style = 'fill="#f08c00" fill-opacity="0.18" stroke="#f08c00" stroke-width="1"'
        if isinstance(at, UniformIn) and at.uniform_in in scenario.zones:
            paper.polygon(zone_outline(scenario.zones[at.uniform_in], paper.bounds), style, "put anywhere in here")
        elif isinstance(at, OnLine):
            paper.line(
                *at.on_line,
                'stroke="#f08c00" stroke-width="5" stroke-opacity="0.6"',
                "put anywhere on this line",
            )
        elif isinstance(at, AtPoint):
            _area(paper, at.point, noise, style)
        elif isinstance(at, Choice):
            for place in at.choice:
                if not isinstance(place, str):
                    _area(paper, place, noise, style)


def _area(paper: Paper, at: Point, noise: Point, style: str) -> None:
    size = [(at[0] + x, at[1] + y) for x, y in box(2 * max(noise[0], 0.006), 2 * max(noise[1], 0.006))]
    paper.polygon(size, style, f"put here: {at[0]:g}, {at[1]:g}")


def _places(scenario: Scenario) -> Iterator[tuple[At | None, Point]]:
    for layout in scenario.placements.values():
        for placing in layout:
            yield placing.at, placing.noise_m
    for rule in scenario.rules.values():
        for action in rule.actions:
            if isinstance(action, Place):
                yield action.at, action.noise_m
            elif isinstance(action, Remove):
                yield action.back_at, (0.0, 0.0)


def _gates(paper: Paper, scenario: Scenario) -> None:
    for name, gate in scenario.gates.items():
        start, end = gate.from_m, gate.to_m
        if gate.anchor is not None:
            start, end = (_shifted(point, _home(scenario, gate.anchor)) for point in (start, end))
        paper.line(start, end, 'stroke="#c92a2a" stroke-width="3"', name)
        for post in (start, end):
            paper.circle(post, 0.008, 'fill="#c92a2a"')
        centre = ((start[0] + end[0]) / 2, (start[1] + end[1]) / 2)
        length = math.dist(start, end) or 1.0
        ahead = (-(end[1] - start[1]) / length * 0.05, (end[0] - start[0]) / length * 0.05)
        tip = _shifted(centre, ahead)
        paper.line(centre, tip, 'stroke="#c92a2a" stroke-width="2"', "forward")
        paper.circle(tip, 0.006, 'fill="#c92a2a"')
        paper.label(_shifted(tip, ahead), name)


def _spots(paper: Paper, scenario: Scenario) -> None:
    for name, spot in scenario.spots.items():
        at = (spot.x_m, spot.y_m)
        for dx, dy in ((0.012, 0.0), (0.0, 0.012)):
            paper.line((at[0] - dx, at[1] - dy), (at[0] + dx, at[1] + dy), 'stroke="#212529" stroke-width="2"', name)
        paper.reserve(at, 0.012)
        paper.label((at[0], at[1] - 0.03), name)


def _obstacles(paper: Paper, scenario: Scenario) -> None:
    for name, obstacle in scenario.obstacles.items():
        style = f'fill="{_colour(obstacle.colour)}" stroke="#212529"'
        if isinstance(obstacle, Cylinder):
            at = obstacle.centre_m
            paper.circle(at, obstacle.radius_m, style, name)
        elif isinstance(obstacle, BoxObstacle):
            at = obstacle.centre_m
            paper.polygon(turned(box(*obstacle.size_m), at, obstacle.yaw_rad), style, name)
        else:
            at = _wall(paper, obstacle, style, name)
        paper.label(at, name)


def _wall(paper: Paper, wall: Wall, style: str, name: str) -> Point:
    (x1, y1), (x2, y2) = wall.from_m, wall.to_m
    at = ((x1 + x2) / 2, (y1 + y2) / 2)
    shape = box(math.dist(wall.from_m, wall.to_m), wall.thickness_m)
    paper.polygon(turned(shape, at, math.atan2(y2 - y1, x2 - x1)), style, name)
    return at


def _bodies(paper: Paper, scenario: Scenario, roster: Roster) -> None:
    for name, robot in scenario.robots.items():
        kit = scenario.kits[robot.kit]
        start, chassis = robot.start, kit.chassis
        at = (start.x_m, start.y_m)
        if any(start.noise_m):
            area = [_shifted(at, corner) for corner in box(2 * start.noise_m[0], 2 * start.noise_m[1])]
            paper.polygon(area, 'fill="none" stroke="#868e96" stroke-dasharray="3 3"', f"{name} starts in here")
        for side in (1, -1):
            wheel = [
                (x, y + side * chassis.wheel_track_m / 2)
                for x, y in box(2 * chassis.wheel_radius_m, chassis.wheel_width_m)
            ]
            paper.polygon(turned(wheel, at, start.yaw_rad), 'fill="#212529"')
        paper.polygon(
            turned(box(chassis.size_m, chassis.size_m), at, start.yaw_rad),
            f'fill="{_team_colour(robot.colour)}" stroke="#212529"',
            f"{name} at its start",
        )
        front = 1 if kit.looks_along == "+x" else -1
        reach = front * chassis.size_m / 2
        nose = [
            (reach * 0.95, 0.0),
            (reach * 0.55, chassis.size_m * 0.16),
            (reach * 0.55, -chassis.size_m * 0.16),
        ]
        paper.polygon(turned(nose, at, start.yaw_rad), 'fill="#ffffff"', "its front")
        x, y = paper.px(at)
        paper.text_px(x, y + 5, name, "number")
        paper.reserve(at, chassis.size_m * 0.7)
    for name in roster.groups["balls"]:
        ball = scenario.balls[name]
        paper.circle(
            ball.start_m,
            ball.radius_m,
            f'fill="{_colour(ball.colour)}" stroke="#212529"',
            f"{name} at its start",
        )
        paper.reserve(ball.start_m, ball.radius_m)
        paper.label((ball.start_m[0], ball.start_m[1] + ball.radius_m + 0.02), name)


def _legend(paper: Paper, scenario: Scenario) -> float:
    """Write the numbers of zones, gates and spots beside the drawing; returns the height used in pixels."""
    x, y = paper.width_px + 8, 26.0
    paper.text_px(x, y, scenario.title, "title")
    for head, entries in _legend_entries(scenario):
        if not entries:
            continue
        y += _LINE_PX * 1.6
        paper.text_px(x, y, head, "head")
        for entry in entries:
            y += _LINE_PX
            paper.text_px(x, y, entry, "entry")
    return y + 2 * _LINE_PX


def _legend_entries(scenario: Scenario) -> list[tuple[str, list[str]]]:
    zones = [f"{name}: {zone_words(zone)}" for name, zone in scenario.zones.items()]
    gates = [
        f"{name}: {point_words(gate.from_m)} to {point_words(gate.to_m)}"
        + (f", with {gate.anchor}" if gate.anchor else "")
        for name, gate in scenario.gates.items()
    ]
    spots = [f"{name}: {spot.x_m:g}, {spot.y_m:g}" for name, spot in scenario.spots.items()]
    starts = [
        f"{name}: {r.start.x_m:g}, {r.start.y_m:g}, yaw {r.start.yaw_rad:g}"
        + (f", ± {r.start.noise_m[0]:g}, {r.start.noise_m[1]:g}" if any(r.start.noise_m) else "")
        for name, r in scenario.robots.items()
    ]
    return [
        ("Zones (m)", zones), ("Gates (m)", gates), ("Spots (m)", spots), ("Robots' starts (m, rad)", starts),
    ]  # fmt: skip


def _shifted(point: Point, by: Point) -> Point:
    return point[0] + by[0], point[1] + by[1]


def _home(scenario: Scenario, entity: str) -> Point:
    if entity in scenario.robots:
        start = scenario.robots[entity].start
        return start.x_m, start.y_m
    if entity in scenario.balls:
        return scenario.balls[entity].start_m
    obstacle = scenario.obstacles[entity]
    return obstacle.from_m if isinstance(obstacle, Wall) else obstacle.centre_m


def _team_colour(colour: str) -> str:
    return {"blue": "#2563eb", "yellow": "#ca8a04"}.get(colour, "#495057")


def _colour(colour: str) -> str:
    """Return a colour that cannot break out of its attribute."""
    return "".join(c for c in colour if c.isalnum() or c == "#") or "#868e96"
