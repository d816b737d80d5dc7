"""Tables of real leagues come out as in reality; the results are facts from public data."""

import csv
from collections import defaultdict
from pathlib import Path

import pytest

from rcj_challenges.tournament.standings import Match, TableRules, table

FOLDER = Path(__file__).parent / "tables"
BY_MEETINGS = ("points", "head_to_head", "goal_difference", "goals")
BY_GOALS = ("points", "goal_difference", "goals", "head_to_head")


def lines(name):
    with (FOLDER / f"{name}.csv").open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def rows(results, tie_breaks):
    matches = [
        Match((one["first"], one["second"]), (float(one["goals_first"]), float(one["goals_second"]))) for one in results
    ]
    teams = list(dict.fromkeys(team for one in matches for team in one.teams))
    return table("", teams, matches, TableRules(3, 1, 0, tie_breaks, str), complete=True).rows


@pytest.mark.parametrize(
    ("league", "tie_breaks", "places"),
    [
        ("la_liga_2013", BY_MEETINGS, {2: "barcelona", 3: "real_madrid"}),
        ("la_liga_2022", BY_MEETINGS, {14: "cadiz", 15: "getafe", 16: "valencia"}),
        ("serie_a_2018", BY_MEETINGS, {17: "genoa", 18: "empoli"}),
        ("serie_a_2020", BY_MEETINGS, {3: "atalanta", 4: "juventus"}),
        ("premier_league_2022", BY_GOALS, {1: "manchester_city", 7: "aston_villa"}),
    ],
)
def test_places_of_a_league_are_those_of_reality(league, tie_breaks, places):
    found = {row.place: row for row in rows(lines(league), tie_breaks)}
    assert {place: team in found[place].team and not found[place].shared for place, team in places.items()} == (
        dict.fromkeys(places, True)
    )


def test_places_of_the_world_cup_are_those_of_reality():
    groups, expected = defaultdict(list), defaultdict(dict)
    for one in lines("world_cup_2014_groups"):
        groups[one["group"]].append(one)
    for one in lines("world_cup_2014_places"):
        expected[one["group"]][int(one["place"])] = one["team"]
    for group, results in groups.items():
        assert {row.place: row.team for row in rows(results, BY_GOALS)} == expected[group]
