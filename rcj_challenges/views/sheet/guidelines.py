"""What teams may design, for a rule sheet: limits, and a table of parts and prices."""

from __future__ import annotations

from collections.abc import Iterator

from rcj_challenges.rules.phrasing import counted, listed, metres, number, plain
from rcj_challenges.scenario.models.designs import Allowance, Guideline, Part
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.views.sheet.document import Block, Section, Table

_SHAPES = {"box": "a cube", "round": "round", "flat_front": "round with a flat front"}


def guideline_sections(scenario: Scenario) -> Iterator[Section]:
    """Yield a section for each guideline that a seat has."""
    for name, guideline in scenario.guidelines.items():
        seats = [plain(seat) for seat, entrant in scenario.entrants.items() if entrant.design == name]
        if seats:
            yield Section("Robots that teams design", tuple(_blocks(guideline, seats)))


def _blocks(guideline: Guideline, seats: list[str]) -> Iterator[Block]:
    yield (
        f"Robots of {listed(seats, 'and')} may be designed, with up to {counted(guideline.designs, 'design')} in the "
        f"file robot.yaml of a submission; without it, the robots are those of this sheet. A robot may cost up to "
        f"{guideline.budget} points."
    )
    jaws = (
        f"a ball may enter between its jaws by up to {metres(guideline.max_mouth_m)}"
        if guideline.max_mouth_m
        else "it may not have jaws"
    )
    yield (
        f"It fits in a cylinder around its centre with a diameter of {metres(guideline.max_diameter_m)} and a height "
        f"of {metres(guideline.max_height_m)}, and weighs up to {number(guideline.max_mass_kg)} kg with its wheels; "
        f"{jaws}. Its body is {listed([_SHAPES[shape] for shape in guideline.shapes], 'or')}."
    )
    if guideline.keeps:
        yield f"Every robot keeps {listed(list(guideline.keeps), 'and')}, which cost nothing."
    rows = [*_rows(guideline.drives, "drive "), *_rows(guideline.devices, "")]
    yield Table(("part", "points", "at most", "its fields"), tuple(rows))


def _rows(parts: dict[str, Part], before: str) -> Iterator[tuple[str, str, str, str]]:
    for name, part in parts.items():
        fields = "; ".join(f"{field} {_words(allowance)}" for field, allowance in part.limits.items())
        yield f"{before}{name}", str(part.price), "" if part.at_most is None else str(part.at_most), fields


def _words(allowance: Allowance) -> str:
    """Return what a field may be: ``from 0.1 up to 1``, ``up to 32: 0 points, up to 64: 100 points``."""
    words = [f"from {number(allowance.least)}"] if allowance.least is not None else []
    words += [
        f"up to {number(up_to)}" + (f": {counted(points, 'point')} more" if points else "")
        for up_to, points in allowance.prices
    ]
    words += [f"up to {number(allowance.most)}"] if allowance.most is not None else []
    return ", ".join(words)
