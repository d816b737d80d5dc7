"""The robots that teams have designed, as cards with picture and price: those of a team's latest released match."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from rcj_challenges.core.files import slug
from rcj_challenges.records.errors import RecordError
from rcj_challenges.records.folder import SCENARIO, read_file
from rcj_challenges.records.recorded_scenario import read_scenario
from rcj_challenges.scenario.designs import Verdict
from rcj_challenges.scenario.models.designs import Design
from rcj_challenges.tournament.site.model import MatchView, Season
from rcj_challenges.tournament.site.tree import Tree
from rcj_challenges.views.drawing.designs import design_card, points_words
from rcj_challenges.views.drawing.paper import Entry


@dataclass(frozen=True, slots=True)
class RobotCard:
    """A robot by its number, the name of its design and what it costs.

    Attributes:
        picture: the file with its picture, beside the team's page.
        lines: what is in it.
    """

    number: int
    design: str
    cost: str
    picture: str
    lines: list[Entry]


def publish_cards(tree: Tree, season: Season, team: str) -> list[RobotCard]:
    """Write the pictures of a team's robots, and return their cards; none if it plays with those of the challenge."""
    found = next((one for match in season.latest if (one := _seat_and_record(match, team))), None)
    if found is None:
        return []
    seat, record = found
    try:
        if f"design_{seat}_".encode() not in read_file(record / SCENARIO):  # to read all of it takes longer
            return []
        scenario = read_scenario(record)
    except RecordError:
        return []  # the page of the match is without its replay then
    entrant = scenario.entrants[seat]
    guideline = scenario.guidelines.get(entrant.design or "")
    if guideline is None:
        return []
    names = {kit: kit.removeprefix(f"design_{seat}_").partition("_")[2] or kit for kit in entrant.kits}
    designs: dict[str, Design] = {}
    for kit, name in names.items():
        devices = {own: device for own, device in scenario.kits[kit].devices.items() if own not in guideline.keeps}
        designs[name] = Design.model_construct(chassis=scenario.kits[kit].chassis, devices=devices)
    verdict = Verdict(guideline, designs, tuple(names[kit] for kit in entrant.kits))
    drawn = {name: design_card(verdict, name) for name in designs}
    files = {name: f"{slug(team)}.{number}.svg" for number, name in enumerate(drawn, 1)}
    for name, (picture, _) in drawn.items():
        tree.write(f"teams/{files[name]}", picture)
    return [
        RobotCard(number, name, points_words(verdict, name), files[name], drawn[name][1])
        for number, name in enumerate(verdict.robots, 1)
    ]


def _seat_and_record(match: MatchView, team: str) -> tuple[str, Path] | None:
    """Return where a team played by itself, and the record; None if it did not, or there is none."""
    record = match.played.record if match.played else None
    seats = [side.seat for side in match.fixture.sides if side.teams == (team,)]
    return (seats[0], record) if seats and record is not None else None
