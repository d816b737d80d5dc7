"""The robots that teams have designed, on the site of a tournament."""

from __future__ import annotations

import xml.etree.ElementTree as ET
from dataclasses import replace
from pathlib import Path

import pytest

from rcj_challenges.match.designs import with_designs
from rcj_challenges.records.folder import SCENARIO
from rcj_challenges.records.lines import json_line
from rcj_challenges.scenario.load import load, load_text
from rcj_challenges.submissions.team import open_team
from rcj_challenges.tournament.site import SiteSource, publish
from rcj_challenges.tournament.site.model import MatchView, Season
from tests.tournament.site_play import make_season

HEAD = "schema_version: 2\nid: given\ntitle: Given\nextends: soccersim_v2\n"
TEAMS = Path(__file__).resolve().parents[2] / "examples" / "teams"


@pytest.fixture(scope="module")
def played(tmp_path_factory: pytest.TempPathFactory) -> tuple[SiteSource, Path]:
    """Return a season in whose records blue has designed robots, and its site."""
    folder = tmp_path_factory.mktemp("season")
    season = make_season(folder, ticks=60)
    loaded = load("workshop")
    team = open_team(TEAMS / "workshop_keeper", *loaded.scenario.entrants.values())
    resolved = with_designs(loaded, {"blue": team}).resolved
    (season.record / SCENARIO).write_bytes(json_line(resolved))
    source = season.source(season.outcomes({"groups": 2}))
    return source, publish(source, folder / "data").site


def latest_recorded(source: SiteSource, seat: str) -> str:
    """Return a team whose latest match with a record was in a seat."""
    season = Season(source)

    def seat_of(team: str) -> str | None:
        found: MatchView | None = next(
            (match for match in season.latest if team in match.teams and match.played and match.played.record), None
        )
        return next((side.seat for side in found.fixture.sides if team in side.teams), None) if found else None

    return next(team for team in source.state.teams if seat_of(team) == seat)


def test_team_that_designed_its_robots_has_a_card_for_each_with_picture_and_price(
    played: tuple[SiteSource, Path],
) -> None:
    source, site = played
    team = latest_recorded(source, "blue")
    page = (site / "teams" / f"{team}.html").read_text("utf-8")
    plain = page.replace("<bdi>", "").replace("</bdi>", "")
    assert "Robot 1: keeper, 2350 of 3000 points" in plain
    assert plain.count("runner, 2800 of 3000 points") == 2
    assert "eye: camera, 600" in plain
    pictures = sorted(site.glob(f"teams/{team}.*.svg"))
    assert {f'src="{picture.name}"' in page for picture in pictures} == {True}
    titles = [{element.text for element in ET.parse(picture).iter()} for picture in pictures]
    assert [{"what rear eye looks at", "the cylinder of 0.12 m"} <= some for some in titles] == [True, False]


def test_team_with_the_robots_of_the_challenge_has_no_cards(played: tuple[SiteSource, Path]) -> None:
    source, site = played
    assert "of 3000 points" not in (site / "teams" / f"{latest_recorded(source, 'yellow')}.html").read_text("utf-8")


def test_design_of_a_match_that_is_not_released_is_not_shown(played: tuple[SiteSource, Path], tmp_path: Path) -> None:
    source, _ = played
    hidden = replace(source.state, outcomes={})
    site = publish(replace(source, state=hidden), tmp_path).site
    assert list(site.glob("teams/*.svg")) == []


def test_kits_that_the_challenge_gives_a_team_are_no_designs(tmp_path: Path) -> None:
    season = make_season(tmp_path, ticks=60)
    kits = "kits: {design_blue_a: {chassis: {size_m: 0.07}}}\nentrants: {blue: {kits: [design_blue_a, v2, v2]}}\n"
    (season.record / SCENARIO).write_bytes(json_line(load_text(HEAD + kits).resolved))
    site = publish(season.source(season.outcomes({"groups": 1})), tmp_path / "data").site
    assert list(site.glob("teams/*.svg")) == []
