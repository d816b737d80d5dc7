"""The field of a rule sheet: its walls, corners and goals, what lies and stands on it, and a drawing."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from rcj_challenges.rules.phrasing import degrees, listed, metres, metres_alike, plain, quoted
from rcj_challenges.scenario.models import field as models
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.remembered import remembered_spots, set_at_once
from rcj_challenges.views.drawing import draw_scenario
from rcj_challenges.views.drawing.shapes import point_words
from rcj_challenges.views.sheet.blocks import Block, Heading, Items, Paragraph, Picture, Table
from rcj_challenges.views.sheet.nouns import Nouns


def field_blocks(scenario: Scenario, nouns: Nouns) -> Iterator[Block]:
    """Return the section about the field."""
    field = scenario.field
    yield Heading(2, "Field")
    yield Paragraph(
        f"{field.width_m:g} m wide (x) and {field.length_m:g} m long (y) inside its walls, which are "
        f"{metres(field.wall_height_m)} high. The origin is the centre; x grows to the right, y upwards in the drawing."
        f" {_corners(field)} {_goals(nouns, field)}"
    )
    yield Paragraph(_surfaces(scenario))
    yield Picture(draw_scenario(scenario, nouns.roster))
    if scenario.gates:
        yield Paragraph("A gate is crossed forward towards the side to which its short mark in the drawing points.")
    yield from _remembered(nouns)
    yield from _balls(nouns)
    if scenario.obstacles:
        movable = any(getattr(obstacle, "movable", False) for obstacle in scenario.obstacles.values())
        unless = ", if no rule puts it elsewhere" if movable else ""
        yield Paragraph(
            f"Obstacles; the place is where the centre stands at the start of a half{unless}, x and y in m:"
        )
        colours = any(map(_colour_given, scenario.obstacles.values()))
        rows = tuple(_obstacle_row(name, obstacle, colours=colours) for name, obstacle in scenario.obstacles.items())
        yield Table(
            ("obstacle", "place", "what it is", "height", *(("colour",) if colours else ()), "can be moved"), rows
        )
    groups = [f"{quoted(group)}: {nouns.members(group)}" for group in scenario.groups]
    if groups:
        yield Paragraph("These names stand for several:")
        yield Items(tuple(groups))


def _corners(field: models.FieldModel) -> str:
    if not field.corner_cut_m:
        return "Its corners are square."
    return f"Walls at 45° cut {metres(field.corner_cut_m)} off both sides of each corner."


def _surfaces(scenario: Scenario) -> str:
    """Return how the floor holds what drives on it, and how a ball springs back."""
    field = scenario.field
    floor = f"The floor's coefficient of friction is {field.friction:g}."
    if not scenario.balls:
        return floor
    if not field.restitution:
        return f"{floor} A ball does not spring back from a wall."
    return (
        f"{floor} A ball springs back from a wall with {100 * field.restitution:g} % of the speed at which it meets it."
    )


def _goals(nouns: Nouns, field: models.FieldModel) -> str:
    if not field.goals:
        return "There are no goals."
    ends = {"positive_y": "+y", "negative_y": "-y"}
    goals = "; ".join(
        f"{nouns.thing(name) if name in nouns.scenario.zones else f'the goal {quoted(name)}'} stands at the "
        f"{ends[goal.end]} end, {wide} wide and {deep} deep, its walls are {metres(goal.wall_height_m)} high"
        for name, goal in field.goals.items()
        for wide, deep in [metres_alike((goal.width_m, goal.depth_m))]
    )
    return f"{goals[:1].upper()}{goals[1:]}."


def _remembered(nouns: Nouns) -> Iterator[Block]:
    """Return that some spots do not stay where the drawing shows them, or are never there."""
    at_once = set_at_once(nouns.scenario)
    later = [name for name in remembered_spots(nouns.scenario) if name not in at_once]
    if at_once:
        yield Paragraph(f"Rules set {listed([*map(nouns.thing, at_once)], 'and')} as soon as a half starts.")
    if later:
        those = listed([*map(nouns.thing, later)], "and")
        are, them = ("they are", "them") if len(later) > 1 else ("it is", "it")
        yield Paragraph(f"Rules set {those} anew in a half; until then {are} where the drawing shows {them}.")


def _balls(nouns: Nouns) -> Iterator[Block]:
    """Return what is known of the balls: of one a sentence, of several a table."""
    balls = nouns.scenario.balls
    if not balls:
        yield Paragraph("There is no ball.")
    elif len(balls) == 1:
        ((name, ball),) = balls.items()
        yield Paragraph(_ball_words(nouns.thing(name), ball))
    else:
        # A colour that nobody chose is that of every ball, and tells none of them from the others.
        colours = any(_colour_given(ball) for ball in balls.values())
        yield Paragraph("Balls; the start is where the centre lies if no rule puts the ball elsewhere, x and y in m:")
        head = ("ball", "start", "diameter", "mass", *(("colour",) if colours else ()), "sends infra-red")
        yield Table(head, tuple(_ball_row(name, ball, colours=colours) for name, ball in balls.items()))
        for slows_mps2 in dict.fromkeys(ball.slows_mps2 for ball in balls.values() if ball.slows_mps2):
            alike = [plain(name) for name, ball in balls.items() if ball.slows_mps2 == slows_mps2]
            who = "one of the balls" if len(alike) == len(balls) else listed(alike, "or")
            yield Paragraph(f"While {who} rolls, it loses {slows_mps2:g} m/s in each second.")


def _ball_words(who: str, ball: models.Ball) -> str:
    colour = f", its colour is {ball.colour}" if _colour_given(ball) else ""
    sends = "infra-red" if ball.emits else "no infra-red"
    said = f"{who} measures {metres(2 * ball.radius_m)} across, its mass is {ball.mass_kg:g} kg{colour}."
    slows = f" While it rolls, it loses {ball.slows_mps2:g} m/s in each second." if ball.slows_mps2 else ""
    return f"{said[:1].upper()}{said[1:]} It sends {sends}. Its start is {point_words(ball.start_m)}.{slows}"


def _ball_row(name: str, ball: models.Ball, *, colours: bool) -> tuple[str, ...]:
    size, mass = metres(2 * ball.radius_m), f"{ball.mass_kg:g} kg"
    colour = (ball.colour,) if colours else ()
    return plain(name), point_words(ball.start_m), size, mass, *colour, "yes" if ball.emits else "no"


def _colour_given(thing: models.Ball | models.Obstacle) -> bool:
    return "colour" in thing.model_fields_set


def _obstacle_row(name: str, obstacle: Any, *, colours: bool) -> tuple[str, ...]:
    colour = (obstacle.colour,) if colours else ()
    movable = f"yes, its mass is {obstacle.mass_kg:g} kg" if getattr(obstacle, "movable", False) else "no"
    if isinstance(obstacle, models.Wall):
        place = f"from {point_words(obstacle.from_m)} to {point_words(obstacle.to_m)}"
        what = f"wall, {metres(obstacle.thickness_m)} thick"
    else:
        place, what = point_words(obstacle.centre_m), _shape(obstacle)
    return plain(name), place, what, metres(obstacle.height_m), *colour, movable


def _shape(obstacle: models.Box | models.Cylinder) -> str:
    if isinstance(obstacle, models.Cylinder):
        return f"cylinder, radius {metres(obstacle.radius_m)}"
    x, y = metres_alike(obstacle.size_m)
    turned = f", turned by {degrees(obstacle.yaw_rad)}" if obstacle.yaw_rad else ""
    return f"box, {x} along its x and {y} along its y{turned}"
