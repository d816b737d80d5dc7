"""A scenario as a picture: the field, what rules judge by, and where things start or are put."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from typing import NamedTuple

from rcj_challenges.core.grouping import grouped
from rcj_challenges.core.play import Pose2
from rcj_challenges.geometry.polygons import Point, box, turned
from rcj_challenges.rules.base import Word
from rcj_challenges.rules.phrasing import degrees
from rcj_challenges.scenario.halves import in_half
from rcj_challenges.scenario.kits import kit_of
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.outlines import extent, outline_of
from rcj_challenges.scenario.roster import Roster
from rcj_challenges.scenario.rule_effects import spots_set_at_start, spots_set_by_rules
from rcj_challenges.scenario.shapes import (
    FORWARD_M,
    at_start,
    corners_of,
    floor_of,
    floor_outline,
    forward_mark,
    goal_floor,
    middle,
    point_words,
    start_noise_m,
    start_pose,
    visible_outline,
    zone_outline,
    zone_words,
)
from rcj_challenges.scenario.walk import walk
from rcj_challenges.views.drawing.paper import MARKER_PX, Entry, Paper, Section
from rcj_challenges.views.drawing.placement_areas import Area, first_poses, flipped, placement_areas
from rcj_challenges.views.palette import PALETTE, hex_of, rgb, text_on

_BLACK = "#161c24"
# Dark enough for white numbers; none of these is near orange.
_ZONE_COLOURS = ("#7048e8", "#0b7285", "#c2255c", "#447007", "#9c36b5", "#4263eb", "#2b5f6b", "#a61e4d")
_PX_PER_M = 290.0  # of a field of the usual size
_MAX_PX = (480.0, 720.0)  # across and up: of a larger field the scale is smaller, and texts keep their size
_MARGIN_PX = 50.0
# Marks keep their size, whatever the scale: these are half of it on a field of the usual size.
_DOT_M = 0.01  # the square that marks a place without noise
_CROSS_M = 0.018  # a spot
_POST_M = 0.012  # the end of a gate
_TIP_M = 0.009  # the end of its mark that points forward
_NUMBER_PX = 8.5  # of a character of the name in a robot's body
_BESIDE_PX = 0.75 * MARKER_PX  # from a small thing to its marker
_PUT, _PUT_MARKER = "#f08c00", "#9a5a00"  # what rules put somewhere
_GATE = "#c92a2a"
_WITHIN = "within-the-walls"
_WITHIN_WALLS = f'clip-path="url(#{_WITHIN})"'
_NOISE_BOX = 'fill="none" stroke="#495057" stroke-dasharray="3 3"'
_PUT_AREA = f'fill="{_PUT}" fill-opacity="0.18" stroke="{_PUT}" stroke-width="1"'
_PLACED = "a rule puts it when {} starts"


class Picture(NamedTuple):
    """A drawing of the field and its legend, some of whose sections may be empty."""

    paper: Paper
    title: str
    sections: list[Section]

    def svg(self, *, legend: bool = True) -> str:
        """Return it as an SVG document; without its legend only the field."""
        return self.paper.svg(self.title, self.sections if legend else ())


def draw_scenario(scenario: Scenario, roster: Roster) -> str:
    """Return the drawing as an SVG document, with numbered markers and a legend that gives every number in m."""
    return picture_of(scenario, roster).svg()


def picture_of(scenario: Scenario, roster: Roster) -> Picture:
    """Return the drawing.

    Robots and balls are drawn where they are when a half has begun. Zones that are ``drawn`` have solid outlines, the
    others dashed ones. Dotted circles are distances that rules measure.
    """
    poses = first_poses(scenario, roster)
    x, y = _reach_m(scenario, poses)
    px_per_m = min(_PX_PER_M, _MAX_PX[0] / (2 * x), _MAX_PX[1] / (2 * y))
    x, y = x + _MARGIN_PX / px_per_m, y + _MARGIN_PX / px_per_m
    paper = Paper((-x, -y, x, y), px_per_m)
    _ground(paper, scenario)
    sections = [
        ("Zones (m; dashed: not drawn on the field)", [*_zones(paper, scenario)]),
        ("Put by rules (m)", [*_placement_areas(paper, scenario, roster, poses)]),
        ("Distances that rules measure (m)", [*_distances(paper, scenario, roster)]),
        ("Gates (m; the short mark points forward)", [*_gates(paper, scenario)]),
        ("Obstacles (m)", [*_obstacles(paper, scenario, poses)]),
        ("Spots (m; round: drawn on the field)", [*_spots(paper, scenario)]),
        ("Robots at the start (m)", [*_robots(paper, scenario, poses)]),
        ("Balls at the start (m)", [*_balls(paper, scenario, poses)]),
    ]
    return Picture(paper, scenario.title, sections)


def _reach_m(scenario: Scenario, poses: Mapping[str, Pose2 | None]) -> Point:
    """Return how far the drawing reaches along x and y: without walls to all that stands or is drawn on the floor."""
    field, floor = scenario.field, scenario.field.bounds
    x, y = field.reach_m
    if field.walls:
        return x, y
    most_x, most_y = floor.width_m / 2, floor.length_m / 2
    points = [(0.0, 0.0), *((spot.x_m, spot.y_m) for spot in scenario.spots.values())]
    fixed = [start_pose(scenario, name) for name in scenario.obstacles]
    points += [(pose[0], pose[1]) for pose in (*poses.values(), *fixed) if pose is not None]
    for zone in (at_start(one, scenario) for one in scenario.zones.values() if one.drawn and not one.inverted):
        points += visible_outline(zone, field, (-most_x, -most_y, most_x, most_y))
    far_x, far_y = (max(map(abs, along)) for along in zip(*points, strict=True))
    return max(x, min(far_x, most_x)), max(y, min(far_y, most_y))


def _mark_m(paper: Paper, usual_m: float) -> float:
    """Return the size of a mark in m of the paper's scale, by its size on a field of the usual size."""
    return usual_m * _PX_PER_M / paper.scale


def _ground(paper: Paper, scenario: Scenario) -> None:
    field = scenario.field
    w, h = field.width_m / 2, field.length_m / 2
    if field.walls:
        paper.clip(_WITHIN, [floor_of(field), *(goal_floor(goal, field) for goal in field.goals.values())])
        edge = 'fill="#e9f5ec" stroke="#343a40" stroke-width="3"'
        paper.polygon(floor_of(field), edge, "the field, inside its walls")
    else:
        floor = corners_of(*paper.bounds)
        paper.clip(_WITHIN, [floor])
        paper.polygon(floor, 'fill="#e9f5ec"', "the floor around the field")
        paper.polygon(floor_of(field), 'fill="none" stroke="#ffffff" stroke-width="3"', "the field")
    for name, goal in field.goals.items():
        corners = goal_floor(goal, field)
        paper.polygon(corners, f'fill="{hex_of(goal.colour)}" fill-opacity="0.35"', name)
        for start, end in zip(corners[1:], [*corners[2:], corners[0]], strict=True):
            paper.line(start, end, f'stroke="{hex_of(goal.colour)}" stroke-width="3"')
        paper.line(corners[0], corners[1], 'stroke="#ffffff" stroke-width="2"')
    # As on the replay page, the halfway line is one between two goals; without them it is only the axis.
    middle_words = "halfway line, y = 0" if field.goals else "y = 0"
    paper.line((-w, 0), (w, 0), 'stroke="#adb5bd" stroke-dasharray="2 6"', middle_words)
    paper.line((0, -h), (0, h), 'stroke="#adb5bd" stroke-dasharray="2 6"', "x = 0")
    for x in (-w, 0.0, w):
        paper.text_px(paper.px((x, 0))[0], paper.height_px - 5, f"x {x:g}", "axis")
    for y in (-h, 0.0, h):
        paper.text_px(_MARGIN_PX / 2, paper.px((0, y))[1] + 4, f"y {y:g}", "axis")


def _zones(paper: Paper, scenario: Scenario) -> Iterator[Entry]:
    for k, (name, written) in enumerate(scenario.zones.items()):
        zone = at_start(written, scenario)
        marker = _ZONE_COLOURS[k % len(_ZONE_COLOURS)]
        colour, marker = (hex_of(zone.colour), _BLACK) if zone.colour else (marker, marker)
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
            paper.mark(_corner_inside(paper, on_floor if _has_room(paper, on_floor) else area), number, name, marker)
        yield Entry(f"{name}: {zone_words(written)}", number, marker)


def _has_room(paper: Paper, area: list[Point]) -> bool:
    xs, ys = [x for x, _ in area], [y for _, y in area]
    return bool(area) and min(max(xs) - min(xs), max(ys) - min(ys)) * paper.scale > MARKER_PX


def _corner_inside(paper: Paper, area: list[Point]) -> Point:
    """Return a place for a marker inside an area, near its upper left corner."""
    x, y = min(area, key=lambda point: point[0] - point[1])
    to_x, to_y = middle(area)
    step_m = 0.8 * MARKER_PX / paper.scale
    return x + max(-step_m, min(step_m, to_x - x)), y + max(-step_m, min(step_m, to_y - y))


def _placement_areas(
    paper: Paper, scenario: Scenario, roster: Roster, poses: dict[str, Pose2 | None]
) -> Iterator[Entry]:
    """Draw where rules put things. Places of the same things have the same number."""
    areas_of = placement_areas(scenario, roster).items()
    places = grouped(((", ".join(things), area.is_aim), area) for area, things in areas_of)
    for (names, is_aim), areas in places.items():
        # What stands there when a half begins is drawn there anyway.
        pose = poses.get(names)
        shown = [area for area in areas if is_aim or any(area.noise_m) or pose is None or area.at != (pose[:2],)]
        number = paper.new_number() if shown else ""
        for area in shown:
            _draw_area(paper, scenario, area, f"{'roll' if is_aim else 'put'} {names}", number)
        yield Entry(f"{names}: {'; '.join(area.words() for area in areas)}", number, _PUT_MARKER)


def _draw_area(paper: Paper, scenario: Scenario, area: Area, title: str, number: str) -> None:
    offset_px = (0.0, 0.0)
    match area.at:
        case str() as zone:
            outline = [flipped(point, area.flip) for point in zone_outline(scenario.zones[zone], paper.bounds)]
            if not outline:
                return
            paper.polygon(outline, _PUT_AREA, f"{title} anywhere in here")
            place = _corner_inside(paper, outline)
        case (at,):
            dot_m = _mark_m(paper, _DOT_M)
            width_m, height_m = (2 * max(noise, dot_m) for noise in area.noise_m)
            paper.polygon(turned(box(width_m, height_m), (*at, 0.0)), _PUT_AREA, f"{title} at {point_words(at)}")
            place, offset_px = at, (0.0, _BESIDE_PX)
        case start, end, *_:
            line = f'stroke="{_PUT}" stroke-width="5" stroke-opacity="0.6"'
            paper.line(start, end, line, f"{title} anywhere on this line")
            place = ((start[0] + 3 * end[0]) / 4, (start[1] + 3 * end[1]) / 4)
        case _:
            return
    paper.mark(place, number, title, _PUT_MARKER, offset_px=offset_px)


def _distances(paper: Paper, scenario: Scenario, roster: Roster) -> Iterator[Entry]:
    """Draw the distances that rules measure, each once; spots that rules set are where they are when a half starts."""
    remembered, nowhere = spots_set_by_rules(scenario), spots_set_at_start(scenario)
    for radius_m, name, centre_m in dict.fromkeys(_measured(scenario, roster)):
        words = f"from {name or point_words(centre_m)}"
        if name not in nowhere:
            colour = _PUT if name in remembered else "#495057"
            style = f'fill="none" stroke="{colour}" stroke-dasharray="1 4" {_WITHIN_WALLS} class="distance"'
            paper.circle(centre_m, radius_m, style, f"{radius_m:g} m {words}")
        yield Entry(f"{radius_m:g} {words}")


def _measured(scenario: Scenario, roster: Roster) -> Iterator[tuple[float, str, Point]]:
    """Yield the distances that rules measure, in m: each with the spot's name (empty for a point) and its place."""
    for rule in scenario.rules.values():
        words = (word for word, _ in walk(rule) if isinstance(word, Word))
        for origin, radius_m in (pair for word in words for pair in word.distances_m()):
            if not isinstance(origin, str):
                yield radius_m, "", origin
                continue
            spots = (name for name in roster.may_be(origin, rule) if name in scenario.spots)
            yield from ((radius_m, name, (scenario.spots[name].x_m, scenario.spots[name].y_m)) for name in spots)


def _gates(paper: Paper, scenario: Scenario) -> Iterator[Entry]:
    for name, gate in scenario.gates.items():
        ends: tuple[Point, ...] = (gate.from_m, gate.to_m)
        if gate.anchor is not None:
            ends = turned(ends, start_pose(scenario, gate.anchor))
        number = paper.new_number()
        paper.line(ends[0], ends[1], f'stroke="{_GATE}" stroke-width="3" {_WITHIN_WALLS}', name)
        for post in ends:
            paper.circle(post, _mark_m(paper, _POST_M), f'fill="{_GATE}" {_WITHIN_WALLS}')
        centre, tip = forward_mark(ends[0], ends[1], _mark_m(paper, FORWARD_M))
        paper.line(centre, tip, f'stroke="{_GATE}" stroke-width="2"', "forward")
        paper.circle(tip, _mark_m(paper, _TIP_M), f'fill="{_GATE}"')
        (x, y), (tip_x, tip_y) = paper.px(centre), paper.px(tip)
        share = _BESIDE_PX / (math.dist((x, y), (tip_x, tip_y)) or 1.0)
        paper.mark(centre, number, name, _GATE, offset_px=(share * (x - tip_x), share * (y - tip_y)))
        moving = f", moving with {gate.anchor}" if gate.anchor else ""
        yield Entry(f"{name}: {point_words(gate.from_m)} to {point_words(gate.to_m)}{moving}", number, _GATE)


def _obstacles(paper: Paper, scenario: Scenario, poses: dict[str, Pose2 | None]) -> Iterator[Entry]:
    for name, obstacle in scenario.obstacles.items():
        pose = poses.get(name, start_pose(scenario, name))
        if pose is None:
            yield Entry(f"{name}: {_PLACED.format(scenario.match.period.a)}")
            continue
        style, parts = f'fill="{hex_of(obstacle.colour)}" stroke="#212529"', outline_of(scenario, name).at(pose)
        for part in parts:
            if len(part.points) == 1:
                paper.circle(part.points[0], part.radius_m, style, name)
            else:
                paper.polygon(part.points, style, name)
        west, east, south, north = extent(parts)
        at, reach_px = ((west + east) / 2, (south + north) / 2), max(east - west, north - south) / 2 * paper.scale
        number = paper.new_number()
        beside_px = reach_px + _BESIDE_PX if reach_px < MARKER_PX else 0.0  # it would hide a small one
        paper.mark(at, number, name, _BLACK, offset_px=(0.0, -beside_px))
        yield Entry(f"{name}: {point_words(at)}", number, _BLACK)


def _spots(paper: Paper, scenario: Scenario) -> Iterator[Entry]:
    """Draw the spots, except those that rules set when a half starts: they are never where the file has them."""
    remembered, nowhere, reach_m = spots_set_by_rules(scenario), spots_set_at_start(scenario), _mark_m(paper, _CROSS_M)
    for name, spot in scenario.spots.items():
        if name in nowhere:
            yield Entry(f"{name}: rules set it when {scenario.match.period.a} starts")
            continue
        at, is_set = (spot.x_m, spot.y_m), name in remembered
        stroke = f'stroke="{_PUT if is_set else "#212529"}" stroke-width="2"'
        if spot.drawn:
            paper.circle(at, reach_m, f'fill="{hex_of(spot.colour or "white")}" stroke="#212529"', name)
            paper.keep_free(at, reach_m)
        else:
            paper.line((at[0] - reach_m, at[1]), (at[0] + reach_m, at[1]), stroke, name)
            paper.line((at[0], at[1] - reach_m), (at[0], at[1] + reach_m), stroke, name)
        number, colour = paper.new_number(), _PUT_MARKER if is_set else _BLACK
        paper.mark(at, number, name, colour, offset_px=(_BESIDE_PX, -_BESIDE_PX))
        words = f" when {scenario.match.period.a} starts; rules set it" if is_set else ""
        yield Entry(f"{name}: {_numbers(at)}{words}", number, colour)


def _robots(paper: Paper, scenario: Scenario, poses: dict[str, Pose2 | None]) -> Iterator[Entry]:
    first_half, boxes = in_half(scenario, 1), False
    for name, robot in scenario.robots.items():
        pose, noise_m = poses[name], start_noise_m(scenario, name)
        if pose is None:
            yield Entry(f"{name}: {_PLACED.format(scenario.match.period.a)}")
            continue
        kit, at, ink = kit_of(first_half, name), pose[:2], text_on(rgb(robot.colour))
        size_m = kit.chassis.size_m
        shifts = any(noise_m) and pose == start_pose(scenario, name)
        if shifts:
            paper.polygon(turned(box(2 * noise_m[0], 2 * noise_m[1]), (*at, 0.0)), _NOISE_BOX, f"{name} starts in here")
        for wheel in kit.chassis.wheels():
            paper.polygon(turned(wheel.corners(), pose), 'fill="#212529"')
        for part, outline in reversed(kit.chassis.solids().items()):
            fill = hex_of(robot.colour) if part == "body" else "#212529"
            paper.polygon(turned(outline, pose), f'fill="{fill}" stroke="#212529"', name)
        reach, wide = (kit.chassis.front_m if kit.looks_along == "+x" else -size_m / 2), size_m * 0.16
        nose = [(reach * 0.95, 0.0), (reach * 0.55, wide), (reach * 0.55, -wide)]
        paper.polygon(turned(nose, pose), f'fill="rgb{ink}"', "its front")
        paper.keep_free(at, size_m * 0.7)
        number = ""
        if len(name) * _NUMBER_PX <= size_m * paper.scale:
            x, y = paper.px(at)
            paper.text_px(x, y + 5, name, "number" if ink == rgb(PALETTE["mark"]) else "number dark")
        else:
            number = paper.new_number()
            paper.mark(at, number, name, _BLACK, offset_px=(0.0, size_m * 0.7 * paper.scale + _BESIDE_PX))
        noise = f", ± {noise_m[0]:g}, {noise_m[1]:g}" if shifts else ""
        boxes = boxes or shifts
        yield Entry(f"{name}: {_numbers(at)}, turned by {degrees(pose[2])}{noise}", number, _BLACK)
    if boxes:
        yield Entry("chance shifts a start within its box (±)", sample=_NOISE_BOX)


def _balls(paper: Paper, scenario: Scenario, poses: dict[str, Pose2 | None]) -> Iterator[Entry]:
    for name, ball in scenario.balls.items():
        pose = poses[name]
        if pose is None:
            yield Entry(f"{name}: {_PLACED.format(scenario.match.period.a)}")
            continue
        at, number = pose[:2], paper.new_number()
        paper.circle(at, ball.radius_m, f'fill="{hex_of(ball.colour)}" stroke="#212529"', name)
        paper.keep_free(at, ball.radius_m)
        reach_px = ball.radius_m * paper.scale * 0.7 + _BESIDE_PX
        paper.mark(at, number, name, _BLACK, offset_px=(-reach_px, -reach_px))
        yield Entry(f"{name}: {_numbers(at)}", number, _BLACK)


def _numbers(at: Point) -> str:
    return point_words(at).strip("()")
