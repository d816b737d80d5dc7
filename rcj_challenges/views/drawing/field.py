"""A scenario as a picture: what stands where, what is judged where, and what is put where."""

from __future__ import annotations

import math
from textwrap import wrap

from rcj_challenges.facts.colours import hex_colour
from rcj_challenges.scenario.models.field import Box as BoxObstacle
from rcj_challenges.scenario.models.field import Cylinder, Wall
from rcj_challenges.scenario.models.places import Gate, OnLine, Zone
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.remembered import remembered_spots, set_at_once
from rcj_challenges.scenario.roster import Roster
from rcj_challenges.views.drawing.areas import placement_areas
from rcj_challenges.views.drawing.around import lines_around
from rcj_challenges.views.drawing.flips import flipped
from rcj_challenges.views.drawing.labels import Point
from rcj_challenges.views.drawing.paper import Paper
from rcj_challenges.views.drawing.reaches import reaches
from rcj_challenges.views.drawing.shapes import (
    FORWARD_M,
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
_MOST_PX = (968.0, 1408.0)  # across and up: of a larger field the scale is smaller, and texts keep their size
_MARGIN_PX = 46.0
_LEGEND_PX = 380.0
_LINE_PX = 15.0
_CHARACTERS = 60  # of a line of the legend: 380 px hold them in wide fonts too
_TITLE_CHARACTERS = 38
_THICK = 3.0  # what it costs a label to cover a pixel of a wall, of an obstacle or of a gate, which are thick
# Marks keep their size, whatever the scale: these are half of it on a field of the usual size.
_DOT_M = 0.006  # the square that marks a place without noise
_CROSS_M = 0.012  # a spot
_POST_M = 0.008  # the end of a gate
_TIP_M = 0.006  # the end of its mark that points forward
_NUMBER_PX = 8.5  # of a character of the name in a robot's body
_PUT = "#f08c00"  # what rules put somewhere
# Of zones; none of these is near orange.
_ZONE_COLOURS = ("#7048e8", "#1098ad", "#d6336c", "#5c940d", "#9c36b5", "#4263eb", "#0b7285", "#a61e4d")
_READABLE = 1.05 / 4.5 - 0.05  # the luminance whose contrast to white is the least for small text in WCAG 2
_WITHIN = "within-the-walls"
_WHITE, _BLACK = "#ffffff", "#161c24"
_SET = " when a half starts; rules set it"  # of a spot
_STYLE = (
    "text{font-family:system-ui,-apple-system,'Segoe UI',sans-serif;fill:#1f2937}"
    ".label{font-size:11px;paint-order:stroke;stroke:#ffffff;stroke-width:3px;stroke-linejoin:round}"
    f".number{{font-size:13px;font-weight:700;fill:{_WHITE};text-anchor:middle}}.dark{{fill:{_BLACK}}}"
    ".leader{stroke:#495057;stroke-width:1;stroke-opacity:.8}.end{fill:#495057}"
    ".axis{font-size:10px;fill:#6b7280}.title{font-size:16px;font-weight:700}.head{font-size:12px;font-weight:700}"
    ".entry{font-size:11px}"
)


def draw_scenario(scenario: Scenario, roster: Roster) -> str:
    """Return the drawing as an SVG document, with a legend that gives every number in m.

    Robots are drawn where they start; dashed boxes show the noise of start poses, hatching shows where things may be
    put by chance. Zones that are ``drawn`` have solid outlines, the others dashed ones. Dotted circles are distances
    that rules measure from a spot or a point, other dotted lines such from a zone or a gate.
    """
    field = scenario.field
    depth = max((goal.depth_m for goal in field.goals.values()), default=0.0)
    x, y = field.width_m / 2, field.length_m / 2 + depth
    px_per_m = min(_PX_PER_M, _MOST_PX[0] / (2 * x), _MOST_PX[1] / (2 * y))
    x, y = x + _MARGIN_PX / px_per_m, y + _MARGIN_PX / px_per_m
    paper = Paper((-x, -y, x, y), px_per_m)
    _ground(paper, scenario)
    _zones(paper, scenario)
    _placement_areas(paper, scenario, roster)
    _reaches(paper, scenario, roster)
    _gates(paper, scenario)
    paper.leaders_here()
    _obstacles(paper, scenario)
    _spots(paper, scenario)
    _bodies(paper, scenario, roster)
    height = _legend(paper, scenario, roster)
    return paper.svg(title=f"{scenario.title}: field", style=_STYLE, extra_width_px=_LEGEND_PX, height_px=height)


def _mark_m(paper: Paper, usual_m: float) -> float:
    """Return how large a mark is, in m of the paper's scale, that has a size on a field of the usual size."""
    return usual_m * _PX_PER_M / paper.scale


def _ground(paper: Paper, scenario: Scenario) -> None:
    field = scenario.field
    w, h = field.width_m / 2, field.length_m / 2
    walls = 'fill="#e9f5ec" stroke="#343a40" stroke-width="4"'
    paper.polygon(floor_of(field), walls, "the field, inside its walls", in_the_way=_THICK)
    for name, goal in field.goals.items():
        corners = goal_floor(goal, field)
        paper.polygon(corners, f'fill="{_colour(goal.colour)}" fill-opacity="0.35"', name)
        for start, end in zip(corners[1:], [*corners[2:], corners[0]], strict=True):
            paper.line(start, end, f'stroke="{_colour(goal.colour)}" stroke-width="4"')
        paper.line(corners[0], corners[1], 'stroke="#ffffff" stroke-width="3"')
    # As on the replay page, the halfway line is one between two goals; without them it is but the axis.
    middle_words = "halfway line, y = 0" if field.goals else "y = 0"
    paper.line((-w, 0), (w, 0), 'stroke="#adb5bd" stroke-dasharray="2 6"', middle_words, in_the_way=0)
    paper.line((0, -h), (0, h), 'stroke="#adb5bd" stroke-dasharray="2 6"', "x = 0", in_the_way=0)
    for x in (-w, 0.0, w):
        paper.note_px(paper.px((x, 0))[0] - 10, paper.height_px - 5, f"x {x:g}", "axis")
    for y in (-h, 0.0, h):
        paper.note_px(2, paper.px((0, y))[1] + 4, f"y {y:g}", "axis")


def _zones(paper: Paper, scenario: Scenario) -> None:
    for k, (name, zone) in enumerate(scenario.zones.items()):
        colour = _colour(zone.colour) if zone.colour else _ZONE_COLOURS[k % len(_ZONE_COLOURS)]
        dash = "" if zone.drawn else ' stroke-dasharray="6 4"'
        style = f'fill="{colour}" fill-opacity="0.06" stroke="{colour}" stroke-width="1.5"{dash}'
        text, area = name, shown_outline(zone, scenario.field, paper.bounds)
        if zone.inverted:
            whole, hole = inverted_outlines(zone, scenario.field, paper.bounds)
            text, area = (f"not {name}", hole) if hole else (name, whole)
            both = " ".join(paper.outline(outline) for outline in (whole, hole) if outline)
            paper.path(both, f'{style} fill-rule="evenodd"', f"all but {name}")
        elif area:
            paper.polygon(area, style, name)
        if area:  # what lies beside the paper has its numbers in the legend
            paper.label(middle(area, paper.bounds), text, area=area, colour=_dark(colour))


def _placement_areas(paper: Paper, scenario: Scenario, roster: Roster) -> None:
    """Draw where rules put things: each place once, however many rules put something there, with what is put."""
    style = f'fill="{_PUT}" fill-opacity="0.18" stroke="{_PUT}" stroke-width="1"'
    for area, who in placement_areas(scenario, roster).items():
        at, colour = area.at, _dark(_PUT)
        # What is put at its start is drawn there anyway.
        moved = [name for name in who if area.aim or any(area.noise_m) or at != _start(scenario, name)]
        if not moved:
            continue
        names = f"{'roll' if area.aim else 'put'} {', '.join(moved)}"
        if isinstance(at, str):
            zone = zone_outline(scenario.zones[at], paper.bounds)
            outline = [flipped(point, area.flip) for point in zone]
            if not outline:
                continue
            paper.polygon(outline, style, f"{names} anywhere in here")
            paper.label(middle(outline, paper.bounds), names, area=outline, colour=colour)
        elif isinstance(at, OnLine):
            line = f'stroke="{_PUT}" stroke-width="5" stroke-opacity="0.6"'
            start, end = at.on_line
            paper.line(start, end, line, f"{names} anywhere on this line", in_the_way=_THICK)
            paper.label(((start[0] + 3 * end[0]) / 4, (start[1] + 3 * end[1]) / 4), names, colour=colour)
        else:
            dot_m = _mark_m(paper, _DOT_M)
            x, y = (2 * max(noise, dot_m) for noise in area.noise_m)
            paper.polygon([shifted(at, corner) for corner in box(x, y)], style, f"{names} at {point_words(at)}")
            # A dot may lie under a robot: the line that leads there tells where it is.
            paper.label(at, names, reach_m=max(area.noise_m[1], dot_m), colour=colour)


def _start(scenario: Scenario, name: str) -> Point | None:
    return home(scenario, name) if name in scenario.robots or name in scenario.balls else None


def _reaches(paper: Paper, scenario: Scenario, roster: Roster) -> None:
    """Draw the distances that rules measure, within the walls: nothing is ever behind them."""
    remembered, nowhere = remembered_spots(scenario), set_at_once(scenario)
    measured = [reach for reach in reaches(scenario, roster) if reach.name not in nowhere]
    if measured:
        field = scenario.field
        paper.clip(_WITHIN, [floor_of(field), *(goal_floor(goal, field) for goal in field.goals.values())])
    for reach in measured:
        is_set = reach.name in remembered
        line = f'stroke="{_PUT if is_set else "#495057"}" stroke-dasharray="1 4"'
        style = f'fill="none" {line} clip-path="url(#{_WITHIN})" class="reach"'
        words = f"{reach.words(' m')}{_SET if is_set else ''}"
        if reach.centre_m is not None:
            paper.circle(reach.centre_m, reach.radius_m, style, words)
            continue
        lines = map(paper.stretch, lines_around(_wide(scenario, reach.name), reach.radius_m, paper.bounds))
        paper.path(" ".join(lines), style, words)


def _wide(scenario: Scenario, name: str) -> Zone | Gate | Wall:
    wall = scenario.obstacles.get(name)
    return wall if isinstance(wall, Wall) else scenario.zones.get(name) or scenario.gates[name]


def _gates(paper: Paper, scenario: Scenario) -> None:
    for name, gate in scenario.gates.items():
        start, end = gate.from_m, gate.to_m
        if gate.anchor is not None:
            start, end = turned([start, end], home(scenario, gate.anchor), home_yaw_rad(scenario, gate.anchor))
        paper.line(start, end, 'stroke="#c92a2a" stroke-width="3"', name, in_the_way=_THICK)
        for post in (start, end):
            paper.circle(post, _mark_m(paper, _POST_M), 'fill="#c92a2a"')
            paper.reserve(post, _mark_m(paper, _POST_M))
        centre, tip = forward_mark(start, end, _mark_m(paper, FORWARD_M))
        paper.line(centre, tip, 'stroke="#c92a2a" stroke-width="2"', "forward", in_the_way=_THICK)
        paper.circle(tip, _mark_m(paper, _TIP_M), 'fill="#c92a2a"')
        paper.reserve(tip, _mark_m(paper, _TIP_M))
        paper.label(centre, name, colour=_dark("#c92a2a"))


def _spots(paper: Paper, scenario: Scenario) -> None:
    """Draw the spots, but for those that are set as soon as a half starts: they are never where the file says."""
    remembered, reach_m = remembered_spots(scenario), _mark_m(paper, _CROSS_M)
    nowhere = set_at_once(scenario)
    for name, spot in scenario.spots.items():
        if name in nowhere:
            continue
        at, is_set = (spot.x_m, spot.y_m), name in remembered
        style = f'stroke="{_PUT if is_set else "#212529"}" stroke-width="2"'
        for dx, dy in ((reach_m, 0.0), (0.0, reach_m)):
            words = f"{name}{_SET if is_set else ''}"
            paper.line((at[0] - dx, at[1] - dy), (at[0] + dx, at[1] + dy), style, words)
        paper.reserve(at, reach_m)
        paper.label(at, name, reach_m=reach_m, colour=_dark(_PUT) if is_set else "")


def _obstacles(paper: Paper, scenario: Scenario) -> None:
    for name, obstacle in scenario.obstacles.items():
        style = f'fill="{_colour(obstacle.colour)}" stroke="#212529"'
        if isinstance(obstacle, Cylinder):
            paper.circle(obstacle.centre_m, obstacle.radius_m, style, name)
            paper.reserve(obstacle.centre_m, obstacle.radius_m)
            paper.label(obstacle.centre_m, name, reach_m=obstacle.radius_m)
            continue
        if isinstance(obstacle, BoxObstacle):
            at, outline = obstacle.centre_m, turned(box(*obstacle.size_m), obstacle.centre_m, obstacle.yaw_rad)
        else:
            at, outline = _wall(obstacle)
        paper.polygon(outline, style, name, in_the_way=_THICK)
        paper.body(outline)
        paper.label(at, name, area=outline)


def _wall(wall: Wall) -> tuple[Point, list[Point]]:
    """Return the middle of a wall and its outline."""
    (x1, y1), (x2, y2) = wall.from_m, wall.to_m
    at = ((x1 + x2) / 2, (y1 + y2) / 2)
    shape = box(math.dist(wall.from_m, wall.to_m), wall.thickness_m)
    return at, turned(shape, at, math.atan2(y2 - y1, x2 - x1))


def _bodies(paper: Paper, scenario: Scenario, roster: Roster) -> None:
    for name, robot in scenario.robots.items():
        kit = scenario.kits[robot.kit]
        start, chassis, body = robot.start, kit.chassis, _team_colour(robot.colour)
        at = (start.x_m, start.y_m)
        if any(start.noise_m):
            area = [shifted(at, corner) for corner in box(2 * start.noise_m[0], 2 * start.noise_m[1])]
            paper.polygon(area, 'fill="none" stroke="#868e96" stroke-dasharray="3 3"', f"{name} starts in here")
        for side in (1, -1):
            wheel = [
                (x, y + side * chassis.wheel_track_m / 2)
                for x, y in box(2 * chassis.wheel_radius_m, chassis.wheel_width_m)
            ]
            paper.polygon(turned(wheel, at, start.yaw_rad), 'fill="#212529"')
        paper.polygon(
            turned(box(chassis.size_m, chassis.size_m), at, start.yaw_rad),
            f'fill="{body}" stroke="#212529"',
            f"{name} at its start",
        )
        front = 1 if kit.looks_along == "+x" else -1
        reach = front * chassis.size_m / 2
        nose = [
            (reach * 0.95, 0.0),
            (reach * 0.55, chassis.size_m * 0.16),
            (reach * 0.55, -chassis.size_m * 0.16),
        ]
        paper.polygon(turned(nose, at, start.yaw_rad), f'fill="{_ink_on(body)}"', "its front")
        paper.reserve(at, chassis.size_m * 0.7)
        if len(name) * _NUMBER_PX <= chassis.size_m * paper.scale:
            x, y = paper.px(at)
            paper.text_px(x, y + 5, name, "number" if _ink_on(body) == _WHITE else "number dark")
        else:
            paper.label(at, name, reach_m=chassis.size_m * 0.7)
    for name in roster.groups["balls"]:
        ball = scenario.balls[name]
        paper.circle(
            ball.start_m,
            ball.radius_m,
            f'fill="{_colour(ball.colour)}" stroke="#212529"',
            f"{name} at its start",
        )
        paper.reserve(ball.start_m, ball.radius_m)
        paper.label(ball.start_m, name, reach_m=ball.radius_m)


def _legend(paper: Paper, scenario: Scenario, roster: Roster) -> float:
    """Write the numbers of zones, gates and spots beside the drawing; returns the height used in pixels."""
    x, y = paper.width_px + 8, 10.0
    for line in wrap(scenario.title, _TITLE_CHARACTERS):
        y += 1.3 * _LINE_PX
        paper.text_px(x, y, line, "title")
    for head, entries in _legend_entries(scenario, roster):
        if not entries:
            continue
        y += _LINE_PX * 1.6
        paper.text_px(x, y, head, "head")
        for line in (line for entry in entries for line in wrap(entry, _CHARACTERS, subsequent_indent="    ")):
            y += _LINE_PX
            paper.text_px(x, y, line, "entry")
    return y + 2 * _LINE_PX


def _legend_entries(scenario: Scenario, roster: Roster) -> list[tuple[str, list[str]]]:
    zones = [f"{name}: {zone_words(zone)}" for name, zone in scenario.zones.items()]
    gates = [
        f"{name}: {point_words(gate.from_m)} to {point_words(gate.to_m)}"
        + (f", moving with {gate.anchor}{_axes_words(scenario, gate.anchor)}" if gate.anchor else "")
        for name, gate in scenario.gates.items()
    ]
    remembered = remembered_spots(scenario)
    nowhere = set_at_once(scenario)
    spots = [
        f"{name}: rules set it when a half starts"
        if name in nowhere
        else f"{name}: {spot.x_m + 0.0:g}, {spot.y_m + 0.0:g}{_SET if name in remembered else ''}"
        for name, spot in scenario.spots.items()
    ]
    starts = [
        f"{name}: {r.start.x_m + 0.0:g}, {r.start.y_m + 0.0:g}, yaw {r.start.yaw_rad + 0.0:g}"
        + (f", ± {r.start.noise_m[0]:g}, {r.start.noise_m[1]:g}" if any(r.start.noise_m) else "")
        for name, r in scenario.robots.items()
    ]
    put = [f"{', '.join(who)}: {area.words()}" for area, who in placement_areas(scenario, roster).items()]
    remote = [reach.words() for reach in reaches(scenario, roster)]
    return [
        ("Zones (m)", zones),
        ("Gates (m; the short mark points forward)", gates),
        ("Spots (m)", spots),
        ("Distances that rules measure (m)", remote),
        ("Robots' starts (m, rad)", starts),
        ("Put by rules (m)", put),
    ]


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
