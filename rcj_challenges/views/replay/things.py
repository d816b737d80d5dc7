"""What of a scenario can be seen: field, robots, balls, obstacles, zones, gates and spots, for the page."""

from __future__ import annotations

from typing import Any

from pydantic import BaseModel

from rcj_challenges.scenario.halves import in_half
from rcj_challenges.scenario.kits import kit_of
from rcj_challenges.scenario.models.places import Zone
from rcj_challenges.scenario.models.robots import Kit
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.roster import Roster
from rcj_challenges.scenario.rule_effects import fixed_spots, spots_set_by_rules
from rcj_challenges.scenario.shapes import at_start
from rcj_challenges.scenario.walk import walk
from rcj_challenges.views.naming import seat_colours
from rcj_challenges.views.palette import css_colour
from rcj_challenges.views.standing import counted_names, shows_score


def visible_things(scenario: Scenario) -> dict[str, Any]:
    """Return field, entities (in the roster's order), fixed obstacles, zones, gates, spots and when robots are held."""
    roster = Roster.of(scenario)
    field = scenario.field
    used = _used_gates(scenario, roster)
    return {
        "period": scenario.match.period.one,
        "field": {
            "width_m": field.width_m,
            "length_m": field.length_m,
            "wall_height_m": field.wall_height_m,
            "corner_cut_m": field.cut_m,
            "floor_m": None if field.walls else [field.bounds.width_m / 2, field.bounds.length_m / 2],
            "goals": [_coloured(goal) for goal in field.goals.values()],
        },
        "entities": [_entity(in_half(scenario, 1), name) for name in roster.entities],
        "fixed": [_coloured(thing) for name, thing in scenario.obstacles.items() if name not in roster.entities],
        "zones": [
            _zone(scenario, roster, name, zone)
            for name, zone in scenario.zones.items()
            if getattr(zone, "anchor", None) not in {*spots_set_by_rules(scenario), *scenario.draws, *scenario.roles}
        ],
        # What moves has its posts, or its centre, in the frame of its anchor, whose place in the list `anchor` is.
        "gates": [
            gate.model_dump(mode="json")
            | {"name": name, "used": name in used, "anchor": roster.index.get(gate.anchor or "")}
            for name, gate in scenario.gates.items()
        ],
        # Spots that rules set, and circles around them or what is drawn, are left out: the record does not have them.
        "spots": [{"name": name, **_coloured(spot)} for name, spot in fixed_spots(scenario).items()],
        "seats": [
            {"name": name, "colour": _seat_colour(scenario, name), "letter": _initials(scenario).get(name, "")}
            for name in scenario.entrants
        ],
        "score_counts": shows_score(scenario),
        "counted": counted_names(scenario),
        "held_phases": [name for name, phase in scenario.phases.items() if phase.robots == "held"],
        "stopped_phases": [name for name, phase in scenario.phases.items() if phase.clock == "stops"],
    }


def _zone(scenario: Scenario, roster: Roster, name: str, zone: Zone) -> dict[str, Any]:
    anchor = roster.index.get(getattr(zone, "anchor", None) or "")
    shown = at_start(zone, scenario) if anchor is None else zone
    return {"name": name, **shown.model_dump(mode="json"), "colour": zone_colour(scenario, name), "anchor": anchor}


def zone_colour(scenario: Scenario, name: str) -> str | None:
    """Return the colour of a zone: its own, or that of its owner, whose name it begins with: ``blue_penalty_area``."""
    own = scenario.zones[name].colour
    seat = name.partition("_")[0]
    if own is None and seat in scenario.entrants:
        return _seat_colour(scenario, seat)
    return None if own is None else css_colour(own)


def _coloured(thing: BaseModel) -> dict[str, Any]:
    fields = thing.model_dump(mode="json")
    return {**fields, "colour": fields["colour"] and css_colour(fields["colour"])}


def _used_gates(scenario: Scenario, roster: Roster) -> set[str]:
    """Return the gates by which rules judge: a spectator must see them to understand what happens."""
    named = {
        name
        for model, _ in walk((scenario.rules, scenario.sequences))
        for field in type(model).model_fields
        for name in _texts(getattr(model, field))
        if name in scenario.gates or name in scenario.groups
    }
    return {member for name in named for member in roster.expand(name) if member in scenario.gates}


def _texts(value: Any) -> tuple[str, ...]:
    values = value if isinstance(value, tuple) else (value,)
    return tuple(one for one in values if isinstance(one, str))


def _entity(scenario: Scenario, name: str) -> dict[str, Any]:
    if name in scenario.robots:
        return _robot(scenario, name)
    if name in scenario.balls:
        ball = scenario.balls[name]
        return {"name": name, "kind": "ball", "radius_m": ball.radius_m, "colour": css_colour(ball.colour)}
    return {"name": name, "kind": "obstacle", **_coloured(scenario.obstacles[name])}


def _robot(scenario: Scenario, name: str) -> dict[str, Any]:
    robot = scenario.robots[name]
    seat = next((seat for seat, entrant in scenario.entrants.items() if name in entrant.robots), None)
    return {
        "name": name,
        "kind": "robot",
        "number": robot.number,
        "colour": css_colour(robot.colour),
        "seat": seat,
        "idle": robot.idle,
        **_body(kit_of(scenario, name)),
    }


def bodies_in(scenario: Scenario, half: int) -> dict[str, dict[str, Any]]:
    """Return the looks of robots in a half, by their numbers as text; empty if that is the same in all halves."""
    if not any(entrant.kits for entrant in scenario.entrants.values()):
        return {}
    here = in_half(scenario, half)
    robots = Roster.of(scenario).entities[: len(scenario.robots)]
    return {str(index): _body(kit_of(here, name)) for index, name in enumerate(robots)}


def _body(kit: Kit) -> dict[str, Any]:
    chassis, solids = kit.chassis, kit.chassis.solids()
    return {
        "front": 1 if kit.looks_along == "+x" else -1,
        "size_m": chassis.size_m,
        "height_m": chassis.height_m,
        "front_m": chassis.front_m,
        "body": solids.pop("body"),
        "jaws": list(solids.values()),
        "wheels": [wheel._asdict() for wheel in chassis.wheels()],
    }


def _seat_colour(scenario: Scenario, name: str) -> str:
    return css_colour(seat_colours(scenario).get(name, "grey"))


def _initials(scenario: Scenario) -> dict[str, str]:
    """Return by seat the initial of its robots' labels, if that distinguishes several seats; else nothing."""
    initials = {seat: {robot[0] for robot in entrant.robots} for seat, entrant in scenario.entrants.items()}
    different = len(set().union(*initials.values())) == len(initials)
    if len(initials) < 2 or not different or any(len(own) != 1 for own in initials.values()):
        return {}
    return {seat: own.pop() for seat, own in initials.items()}
