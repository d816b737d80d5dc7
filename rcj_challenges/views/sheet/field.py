"""The field of a rule sheet: its walls, corners and goals, and what lies and stands on it."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from rcj_challenges.rules.phrasing import degrees, listed, metres, metres_alike, plain, quoted
from rcj_challenges.scenario.models import field as models
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.rule_effects import spots_set_by_rules
from rcj_challenges.scenario.shapes import point_words
from rcj_challenges.views.sheet.document import Block, Items, Table
from rcj_challenges.views.sheet.phrasebook import Phrasebook


def field_blocks(scenario: Scenario, phrases: Phrasebook) -> Iterator[Block]:
    """Yield the facts of the field."""
    field = scenario.field
    corners = (
        f"walls at 45° cut {metres(field.corner_cut_m)} off both sides of each corner" if field.corner_cut_m else ""
    )
    walls = (
        f"inside its walls, which are {metres(field.wall_height_m)} high; {corners or 'its corners are square'}"
        if field.walls
        else f"between its lines, without walls; {models.FLOOR_BEYOND_M:g} m behind them the floor ends"
    )
    yield (
        f"{field.width_m:g} m wide (x) and {field.length_m:g} m long (y) {walls}. The origin is the centre; x grows "
        f"to the right, y upwards in the drawing. The floor's coefficient of friction is {field.friction:g}."
    )
    bounces = f"A ball bounces off a wall with {100 * field.restitution:g} % of its speed towards it."
    if scenario.balls and (field.walls or scenario.obstacles):
        yield bounces
    if not scenario.balls:
        yield "There is no ball."
    yield from _goals(field)
    if scenario.gates:
        yield "A gate is crossed forward towards the side to which its short mark in the drawing points."
    if remembered := spots_set_by_rules(scenario):
        yield f"Rules move {listed([*map(phrases.thing, remembered)], 'and')} during {phrases.period.a}."
    if scenario.balls:
        balls = tuple(_ball_row(name, ball) for name, ball in scenario.balls.items())
        columns = ("ball", "start", "diameter", "mass", "colour", "sends infra-red", "rolling, it loses")
        yield Table(columns, balls, "Balls; x and y in m:")
    if scenario.obstacles:
        rows = tuple(_obstacle_row(name, obstacle) for name, obstacle in scenario.obstacles.items())
        head = ("obstacle", "place", "what it is", "height", "colour", "can be moved")
        yield Table(head, rows, f"Obstacles at the start of {phrases.period.a}; x and y of the centre in m:")
    if scenario.groups:
        groups = {group: phrases.roster.expand(group) for group in scenario.groups}
        words = (f"{quoted(group)}: {', '.join(map(plain, members))}" for group, members in groups.items())
        yield Items(tuple(words), "These names stand for several:")


def _goals(field: models.FieldModel) -> Iterator[str]:
    if not field.goals:
        yield "There are no goals."
    for name, goal in field.goals.items():
        wide, deep = metres_alike((goal.width_m, goal.depth_m))
        yield (
            f"The goal {quoted(name)} is at the {'+y' if goal.end == 'positive_y' else '-y'} end, {wide} wide and "
            f"{deep} deep; its walls are {metres(goal.wall_height_m)} high."
        )


def _ball_row(name: str, ball: models.Ball) -> tuple[str, ...]:
    size, mass = metres(2 * ball.radius_m), f"{ball.mass_kg:g} kg"
    slows = f"{ball.slows_mps2:g} m/s in each second" if ball.slows_mps2 else ""
    return plain(name), point_words(ball.start_m), size, mass, _colour(ball), "yes" if ball.emits else "no", slows


def _colour(thing: models.Ball | models.Obstacle) -> str:
    """Return a colour that the scenario chose; a default one distinguishes nothing."""
    return thing.colour if "colour" in thing.model_fields_set else ""


def _obstacle_row(name: str, obstacle: Any) -> tuple[str, ...]:
    movable = f"yes, its mass is {obstacle.mass_kg:g} kg" if getattr(obstacle, "movable", False) else "no"
    if isinstance(obstacle, models.Wall):
        place = f"from {point_words(obstacle.from_m)} to {point_words(obstacle.to_m)}"
        what = f"wall, {metres(obstacle.thickness_m)} thick"
    else:
        place, what = point_words(obstacle.centre_m), _shape(obstacle)
    return plain(name), place, what, metres(obstacle.height_m), _colour(obstacle), movable


def _shape(obstacle: models.Box | models.Cylinder) -> str:
    if isinstance(obstacle, models.Cylinder):
        return f"cylinder, radius {metres(obstacle.radius_m)}"
    x, y = metres_alike(obstacle.size_m)
    turned = f", turned by {degrees(obstacle.yaw_rad)}" if obstacle.yaw_rad else ""
    return f"box, {x} along its x and {y} along its y{turned}"
