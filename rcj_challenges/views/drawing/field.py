"""A scenario as a picture: the field, what rules judge by, and where things start or are put."""

from __future__ import annotations

import math

from rcj_challenges.facts.colours import hex_colour
from rcj_challenges.rules.places.on_line import OnLine
from rcj_challenges.scenario.models.field import Box as BoxObstacle
from rcj_challenges.scenario.models.field import Cylinder, Wall
from rcj_challenges.scenario.models.places import Gate, Zone
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.remembered import remembered_spots, set_at_once
from rcj_challenges.scenario.roster import Roster
from rcj_challenges.views.drawing.areas import Area, Beside, flipped, placement_areas
from rcj_challenges.views.drawing.distances import measured_distances
from rcj_challenges.views.drawing.paper import MARKER_PX, Entry, Paper
from rcj_challenges.views.drawing.shapes import (
    FORWARD_M,
    Point,
    box,
    floor_of,
    forward_mark,
    goal_floor,
    home,
    home_yaw_rad,
    inverted_outlines,
    middle,
    point_words,
    shifted,
    shown_outline,
    turned,
    zone_outline,
    zone_words,
)

_PX_PER_M = 460.0  # of a field of the usual size
_MAX_PX = (968.0, 1408.0)  # across and up: of a larger field the scale is smaller, and texts keep their size
_MARGIN_PX = 46.0
# Marks keep their size, whatever the scale: these are half of it on a field of the usual size.
_DOT_M = 0.006  # the square that marks a place without noise
_CROSS_M = 0.012  # a spot
_POST_M = 0.008  # the end of a gate
_TIP_M = 0.006  # the end of its mark that points forward
_NUMBER_PX = 8.5  # of a character of the name in a robot's body
_BESIDE_PX = 0.75 * MARKER_PX  # from a small thing to its marker
_PUT = "#f08c00"  # what rules put somewhere
_GATE = "#c92a2a"
# Of zones; none of these is near orange.
_ZONE_COLOURS = ("#7048e8", "#1098ad", "#d6336c", "#5c940d", "#9c36b5", "#4263eb", "#0b7285", "#a61e4d")
_READABLE = 1.05 / 4.5 - 0.05  # the luminance whose contrast to white is the least for small text in WCAG 2
_WITHIN = "within-the-walls"
_WHITE, _BLACK = "#ffffff", "#161c24"
_SET = " when a half starts; rules set it"  # of a spot

Section = tuple[str, list[Entry]]


def draw_scenario(scenario: Scenario, roster: Roster) -> str:
    """Return the drawing as an SVG document, with numbered markers and a legend that gives every number in m.

    Robots are drawn where they start. Zones that are ``drawn`` have solid outlines, the others dashed ones. Dotted
    circles and grey bands are distances that rules measure.
    """
    field = scenario.field
    depth = max((goal.depth_m for goal in field.goals.values()), default=0.0)
    x, y = field.width_m / 2, field.length_m / 2 + depth
    px_per_m = min(_PX_PER_M, _MAX_PX[0] / (2 * x), _MAX_PX[1] / (2 * y))
    x, y = x + _MARGIN_PX / px_per_m, y + _MARGIN_PX / px_per_m
    paper = Paper((-x, -y, x, y), px_per_m)
    _ground(paper, scenario)
    sections = [
        _zones(paper, scenario),
        _placement_areas(paper, scenario, roster),
        _distances(paper, scenario, roster),
        _gates(paper, scenario),
        _obstacles(paper, scenario),
        _spots(paper, scenario),
        _robots(paper, scenario),
        _balls(paper, scenario, roster),
    ]
    return paper.svg(scenario.title, sections)


def _mark_m(paper: Paper, usual_m: float) -> float:
    """Return how large a mark is, in m of the paper's scale, that has a size on a field of the usual size."""
    return usual_m * _PX_PER_M / paper.scale


def _ground(paper: Paper, scenario: Scenario) -> None:
    field = scenario.field
    w, h = field.width_m / 2, field.length_m / 2
    paper.polygon(floor_of(field), 'fill="#e9f5ec" stroke="#343a40" stroke-width="4"', "the field, inside its walls")
    for name, goal in field.goals.items():
        corners = goal_floor(goal, field)
        paper.polygon(corners, f'fill="{_colour(goal.colour)}" fill-opacity="0.35"', name)
        for start, end in zip(corners[1:], [*corners[2:], corners[0]], strict=True):
            paper.line(start, end, f'stroke="{_colour(goal.colour)}" stroke-width="4"')
        paper.line(corners[0], corners[1], 'stroke="#ffffff" stroke-width="3"')
    # As on the replay page, the halfway line is one between two goals; without them it is only the axis.
    middle_words = "halfway line, y = 0" if field.goals else "y = 0"
    paper.line((-w, 0), (w, 0), 'stroke="#adb5bd" stroke-dasharray="2 6"', middle_words)
    paper.line((0, -h), (0, h), 'stroke="#adb5bd" stroke-dasharray="2 6"', "x = 0")
    for x in (-w, 0.0, w):
        paper.text_px(paper.px((x, 0))[0] - 10, paper.height_px - 5, f"x {x:g}", "axis")
    for y in (-h, 0.0, h):
        paper.text_px(2, paper.px((0, y))[1] + 4, f"y {y:g}", "axis")


def _zones(paper: Paper, scenario: Scenario) -> Section:
    entries: list[Entry] = []
    for k, (name, zone) in enumerate(scenario.zones.items()):
        colour = _colour(zone.colour) if zone.colour else _ZONE_COLOURS[k % len(_ZONE_COLOURS)]
        dash = "" if zone.drawn else ' stroke-dasharray="6 4"'
        style = f'fill="{colour}" fill-opacity="0.06" stroke="{colour}" stroke-width="1.5"{dash}'
        area = shown_outline(zone, scenario.field, paper.bounds)
        if zone.inverted:
            whole, hole = inverted_outlines(zone, scenario.field, paper.bounds)
            area = hole or whole
            both = " ".join(paper.outline(outline) for outline in (whole, hole) if outline)
            paper.path(both, f'{style} fill-rule="evenodd"', f"all but {name}")
        else:
            paper.polygon(area, style, name)
        number = paper.new_number() if area else ""  # what lies beside the paper is only in the legend
        if area:
            paper.mark(_corner(paper, area), number, name, _dark(colour))
        entries.append(Entry(f"{name}: {zone_words(zone)}", number, _dark(colour)))
    return "Zones (m)", entries


def _corner(paper: Paper, area: list[Point]) -> Point:
    """Return a place for a marker inside an area, near its upper left corner."""
    x, y = min(area, key=lambda point: point[0] - point[1])
    to_x, to_y = middle(area, paper.bounds)
    step_m = 0.8 * MARKER_PX / paper.scale
    return x + max(-step_m, min(step_m, to_x - x)), y + max(-step_m, min(step_m, to_y - y))


def _placement_areas(paper: Paper, scenario: Scenario, roster: Roster) -> Section:
    """Draw where rules put things. Places of the same things have the same number."""
    places: dict[tuple[str, bool], list[Area]] = {}
    for area, things in placement_areas(scenario, roster).items():
        places.setdefault((", ".join(things), area.aim), []).append(area)
    entries: list[Entry] = []
    for (names, aim), areas in places.items():
        # What is put at its start is drawn there anyway; beside something that moves there is no place to draw.
        shown = [
            (area, area.at)
            for area in areas
            if not isinstance(area.at, Beside) and not _is_start(scenario, names, area)
        ]
        number = paper.new_number() if shown else ""
        for area, at in shown:
            _draw_area(paper, scenario, area, at, f"{'roll' if aim else 'put'} {names}", number)
        entries.append(Entry(f"{names}: {'; '.join(area.words() for area in areas)}", number, _dark(_PUT)))
    return "Put by rules (m)", entries


def _is_start(scenario: Scenario, names: str, area: Area) -> bool:
    bodies = {**scenario.robots, **scenario.balls}
    return not area.aim and not any(area.noise_m) and names in bodies and area.at == home(scenario, names)


def _draw_area(paper: Paper, scenario: Scenario, area: Area, at: str | OnLine | Point, title: str, number: str) -> None:
    style = f'fill="{_PUT}" fill-opacity="0.18" stroke="{_PUT}" stroke-width="1"'
    dot_m = _mark_m(paper, _DOT_M)
    offset_px = (0.0, 0.0)
    if isinstance(at, str):
        outline = [flipped(point, area.flip) for point in zone_outline(scenario.zones[at], paper.bounds)]
        if not outline:
            return
        paper.polygon(outline, style, f"{title} anywhere in here")
        place = _corner(paper, outline)
    elif isinstance(at, OnLine):
        (x1, y1), (x2, y2) = at.on_line
        line = f'stroke="{_PUT}" stroke-width="5" stroke-opacity="0.6"'
        paper.line((x1, y1), (x2, y2), line, f"{title} anywhere on this line")
        place = ((x1 + 3 * x2) / 4, (y1 + 3 * y2) / 4)
    else:
        width_m, height_m = (2 * max(noise, dot_m) for noise in area.noise_m)
        outline = [shifted(at, corner) for corner in box(width_m, height_m)]
        paper.polygon(outline, style, f"{title} at {point_words(at)}")
        place, offset_px = at, (0.0, _BESIDE_PX)
    paper.mark(place, number, title, _dark(_PUT), offset_px=offset_px)


def _distances(paper: Paper, scenario: Scenario, roster: Roster) -> Section:
    """Draw distances within the walls: circles, or bands around zones, gates and walls."""
    field, remembered, nowhere = scenario.field, remembered_spots(scenario), set_at_once(scenario)
    found = measured_distances(scenario, roster)
    paper.clip(_WITHIN, [floor_of(field), *(goal_floor(goal, field) for goal in field.goals.values())])
    for distance in found:
        if distance.name in nowhere:
            continue
        is_set = distance.name in remembered
        colour, words = (_PUT if is_set else "#495057"), f"{distance.words(' m')}{_SET if is_set else ''}"
        clip = f'clip-path="url(#{_WITHIN})" class="distance"'
        if distance.centre_m is not None:
            style = f'fill="none" stroke="{colour}" stroke-dasharray="1 4" {clip}'
            paper.circle(distance.centre_m, distance.radius_m, style, words)
            continue
        # All points that are at most so far away: a line around it, twice as wide, with round corners.
        width_px = 2 * distance.radius_m * paper.scale
        style = (
            f'fill="{colour}" fill-rule="evenodd" stroke="{colour}" stroke-width="{width_px:.1f}" '
            f'stroke-linejoin="round" stroke-linecap="round" opacity="0.12" {clip}'
        )
        paper.path(_description(paper, scenario, distance.name, distance.radius_m), style, words)
    return "Distances that rules measure (m)", [Entry(distance.words()) for distance in found]


def _description(paper: Paper, scenario: Scenario, name: str, margin_m: float) -> str:
    """Return the path of a zone, a gate or a wall; what is open ends so far outside that a band ends there too."""
    wall = scenario.obstacles.get(name)
    place: Zone | Gate | Wall = wall if isinstance(wall, Wall) else scenario.zones.get(name) or scenario.gates[name]
    if isinstance(place, Gate | Wall):
        return paper.outline([place.from_m, place.to_m])
    left, bottom, right, top = paper.bounds
    bounds = (left - margin_m, bottom - margin_m, right + margin_m, top + margin_m)
    around = [(bounds[0], bounds[1]), (bounds[0], bounds[3]), (bounds[2], bounds[3]), (bounds[2], bounds[1])]
    outlines = [zone_outline(place, bounds), around if place.inverted else []]
    return " ".join(paper.outline(outline) for outline in outlines if outline)


def _gates(paper: Paper, scenario: Scenario) -> Section:
    entries: list[Entry] = []
    colour = _dark(_GATE)
    for name, gate in scenario.gates.items():
        start, end = gate.from_m, gate.to_m
        if gate.anchor is not None:
            start, end = turned([start, end], home(scenario, gate.anchor), home_yaw_rad(scenario, gate.anchor))
        paper.line(start, end, f'stroke="{_GATE}" stroke-width="3"', name)
        for post in (start, end):
            paper.circle(post, _mark_m(paper, _POST_M), f'fill="{_GATE}"')
        centre, tip = forward_mark(start, end, _mark_m(paper, FORWARD_M))
        paper.line(centre, tip, f'stroke="{_GATE}" stroke-width="2"', "forward")
        paper.circle(tip, _mark_m(paper, _TIP_M), f'fill="{_GATE}"')
        number = paper.new_number()
        (x, y), (tip_x, tip_y) = paper.px(centre), paper.px(tip)
        share = _BESIDE_PX / (math.dist((x, y), (tip_x, tip_y)) or 1.0)
        paper.mark(centre, number, name, colour, offset_px=(share * (x - tip_x), share * (y - tip_y)))
        moving = f", moving with {gate.anchor}{_axes_words(scenario, gate.anchor)}" if gate.anchor else ""
        entries.append(Entry(f"{name}: {point_words(gate.from_m)} to {point_words(gate.to_m)}{moving}", number, colour))
    return "Gates (m; the short mark points forward)", entries


def _obstacles(paper: Paper, scenario: Scenario) -> Section:
    paper.leaders_here()
    entries: list[Entry] = []
    for name, obstacle in scenario.obstacles.items():
        style = f'fill="{_colour(obstacle.colour)}" stroke="#212529"'
        if isinstance(obstacle, Cylinder):
            at, reach_m = obstacle.centre_m, obstacle.radius_m
            paper.circle(at, reach_m, style, name)
        elif isinstance(obstacle, BoxObstacle):
            at, reach_m = obstacle.centre_m, max(obstacle.size_m) / 2
            paper.polygon(turned(box(*obstacle.size_m), at, obstacle.yaw_rad), style, name)
        else:
            (x1, y1), (x2, y2) = obstacle.from_m, obstacle.to_m
            at, reach_m = ((x1 + x2) / 2, (y1 + y2) / 2), math.dist((x1, y1), (x2, y2)) / 2
            shape = box(2 * reach_m, obstacle.thickness_m)
            paper.polygon(turned(shape, at, math.atan2(y2 - y1, x2 - x1)), style, name)
        number, reach_px = paper.new_number(), reach_m * paper.scale
        beside_px = reach_px + _BESIDE_PX if reach_px < MARKER_PX else 0.0  # it would hide a small one
        paper.mark(at, number, name, _BLACK, offset_px=(0.0, -beside_px))
        entries.append(Entry(f"{name}: {point_words(at)}", number, _BLACK))
    return "Obstacles (m)", entries


def _spots(paper: Paper, scenario: Scenario) -> Section:
    """Draw the spots, except those that rules set when a half starts: they are never where the file has them."""
    remembered, nowhere, reach_m = remembered_spots(scenario), set_at_once(scenario), _mark_m(paper, _CROSS_M)
    entries: list[Entry] = []
    for name, spot in scenario.spots.items():
        if name in nowhere:
            entries.append(Entry(f"{name}: rules set it when a half starts"))
            continue
        (x, y), words = (spot.x_m, spot.y_m), _SET if name in remembered else ""
        stroke = _PUT if name in remembered else "#212529"
        for dx, dy in ((reach_m, 0.0), (0.0, reach_m)):
            paper.line((x - dx, y - dy), (x + dx, y + dy), f'stroke="{stroke}" stroke-width="2"', f"{name}{words}")
        number, colour = paper.new_number(), _dark(stroke)
        paper.mark((x, y), number, name, colour, offset_px=(_BESIDE_PX, -_BESIDE_PX))
        entries.append(Entry(f"{name}: {x + 0.0:g}, {y + 0.0:g}{words}", number, colour))
    return "Spots (m)", entries


def _robots(paper: Paper, scenario: Scenario) -> Section:
    entries: list[Entry] = []
    for name, robot in scenario.robots.items():
        kit = scenario.kits[robot.kit]
        start, chassis, body = robot.start, kit.chassis, _team_colour(robot.colour)
        at, size_m = (start.x_m, start.y_m), kit.chassis.size_m
        if any(start.noise_m):
            area = [shifted(at, corner) for corner in box(2 * start.noise_m[0], 2 * start.noise_m[1])]
            paper.polygon(area, 'fill="none" stroke="#868e96" stroke-dasharray="3 3"', f"{name} starts in here")
        wheel = box(2 * chassis.wheel_radius_m, chassis.wheel_width_m)
        for side in (0.5, -0.5):
            corners = [(x, y + side * chassis.wheel_track_m) for x, y in wheel]
            paper.polygon(turned(corners, at, start.yaw_rad), 'fill="#212529"')
        cube = turned(box(size_m, size_m), at, start.yaw_rad)
        paper.polygon(cube, f'fill="{body}" stroke="#212529"', f"{name} at its start")
        reach, wide = (size_m / 2 if kit.looks_along == "+x" else -size_m / 2), size_m * 0.16
        nose = [(reach * 0.95, 0.0), (reach * 0.55, wide), (reach * 0.55, -wide)]
        paper.polygon(turned(nose, at, start.yaw_rad), f'fill="{_ink_on(body)}"', "its front")
        paper.keep_free(at, size_m * 0.7)
        number = ""
        if len(name) * _NUMBER_PX <= size_m * paper.scale:
            x, y = paper.px(at)
            paper.text_px(x, y + 5, name, "number" if _ink_on(body) == _WHITE else "number dark")
        else:
            number = paper.new_number()
            paper.mark(at, number, name, _BLACK, offset_px=(0.0, size_m * 0.7 * paper.scale + _BESIDE_PX))
        noise = f", ± {start.noise_m[0]:g}, {start.noise_m[1]:g}" if any(start.noise_m) else ""
        pose = f"{at[0] + 0.0:g}, {at[1] + 0.0:g}, yaw {start.yaw_rad + 0.0:g}"
        entries.append(Entry(f"{name}: {pose}{noise}", number, _BLACK))
    return "Robots' starts (m, rad; ±: the dashed box)", entries


def _balls(paper: Paper, scenario: Scenario, roster: Roster) -> Section:
    entries: list[Entry] = []
    for name in roster.groups["balls"]:
        ball = scenario.balls[name]
        style = f'fill="{_colour(ball.colour)}" stroke="#212529"'
        paper.circle(ball.start_m, ball.radius_m, style, f"{name} at its start")
        paper.keep_free(ball.start_m, ball.radius_m)
        number, reach_px = paper.new_number(), ball.radius_m * paper.scale * 0.7 + _BESIDE_PX
        paper.mark(ball.start_m, number, name, _BLACK, offset_px=(-reach_px, -reach_px))
        entries.append(Entry(f"{name}: {ball.start_m[0] + 0.0:g}, {ball.start_m[1] + 0.0:g}", number, _BLACK))
    return "Balls (m)", entries


def _dark(colour: str) -> str:
    """Return a colour #rrggbb so much darker that text of it is readable on white."""
    rgb = [int(colour[k : k + 2], 16) / 255 for k in (1, 3, 5)]
    share = 0.65
    while _brightness([share * part for part in rgb]) > _READABLE:
        share -= 0.05
    return "#" + "".join(f"{round(share * part * 255):02x}" for part in rgb)


def _brightness(rgb: list[float]) -> float:
    """Return the relative luminance of a colour in sRGB, 0 to 1 (WCAG 2)."""
    linear = (part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4 for part in rgb)
    return sum(weight * part for weight, part in zip((0.2126, 0.7152, 0.0722), linear, strict=True))


def _axes_words(scenario: Scenario, anchor: str) -> str:
    """Return how the axes of something that turns lie on it; nothing of what has no front."""
    robot = scenario.robots.get(anchor)
    if robot is None:
        return ""
    ahead = scenario.kits[robot.kit].looks_along == "+x"
    return f" ({'x forward, y left' if ahead else 'x backward, y right'})"


def _team_colour(colour: str) -> str:
    """Return a team's colour; blue and yellow are those on which white letters can be read."""
    return {"blue": "#2563eb", "yellow": "#ca8a04"}.get(colour) or _colour(colour)


def _ink_on(colour: str) -> str:
    """Return black or white, whichever can be read on a colour #rrggbb (luma of ITU-R BT.601)."""
    red, green, blue = (int(colour[k : k + 2], 16) for k in (1, 3, 5))
    return _BLACK if 0.299 * red + 0.587 * green + 0.114 * blue > 150 else _WHITE


def _colour(colour: str) -> str:
    """Return a colour as a number: programs that render SVG do not know all of CSS's names."""
    return hex_colour(colour) or "#868e96"
