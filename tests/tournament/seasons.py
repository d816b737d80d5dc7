"""Small tournaments for the tests of this folder, played without a match."""

import random
from pathlib import Path

from rcj_challenges.rules.ranked import BY_SCORE
from rcj_challenges.scenario.models.scenario import Result
from rcj_challenges.scenario.reading.yaml_strict import parse_text
from rcj_challenges.scenario.tree import plain
from rcj_challenges.tournament.engine import Season
from rcj_challenges.tournament.entries import TeamEntry
from rcj_challenges.tournament.load import LoadedTournament
from rcj_challenges.tournament.scenarios import ScenarioInfo, ScenarioNames
from rcj_challenges.tournament.season import FixtureKind, Outcome, Team
from rcj_challenges.tournament.tournament_file import Tournament

FOLDER = Path("here")
RACE = Result.model_validate({"rank": ({"score": "each", "better": "more"}, {"word": "time_s", "better": "less"})}).rank
SOLO = ("shooter", "slalom")
"""Names of scenarios with one seat; all others have two."""


def names(count):
    return [f"t{number:02}" for number in range(1, count + 1)]


def loaded(stages, teams, head=""):
    """Return a tournament of which only the stages, and more keys if given, matter.

    Args:
        stages: what stands below ``stages:``, indented.
        teams: ids, or ids with their pots.
        head: more keys of the file.
    """
    text = f"tournament_version: 1\ntitle: T\nseed: 1\n{head}stages:\n{stages}"
    tournament = Tournament.model_validate(plain(parse_text(text, "t.yaml"), tuple))
    pots = teams if isinstance(teams, dict) else dict.fromkeys(teams, 0)
    entries = {team: TeamEntry(team, FOLDER / team, None, pot) for team, pot in pots.items()}
    infos = {use: info(Path(use.source).name) for use in tournament.uses(ScenarioNames(tournament, FOLDER))}
    return LoadedTournament(tournament, "t", FOLDER / "t.yaml", entries, infos)


def info(name):
    if name == "shooter":
        return ScenarioInfo(name, name, {"yellow": 1}, (BY_SCORE,), 60)
    if name == "slalom":
        return ScenarioInfo(name, name, {"yellow": 1}, RACE, 60)
    return ScenarioInfo(name, name, {"blue": 3, "yellow": 3}, (BY_SCORE,), 1200)


def season(stages, teams, head="", withdrawn=None):
    """Return a season; ``withdrawn`` are the last rounds of teams that have left, by id, in the order in which they left."""
    one = loaded(stages, teams, head)
    left = {
        team: Team(team, team, 0, withdrawn=True, last_rounds=rounds, left_after=number)
        for number, (team, rounds) in enumerate((withdrawn or {}).items())
    }
    return Season(one, one.teams() | left)


def teams_of(fixture):
    return tuple("+".join(side.teams) for side in fixture.sides)


def by_strength(fixture):
    """Return an outcome in which the team whose id comes first wins 2:1; alone a team gets a point for its number."""
    first, *others = teams_of(fixture)
    if not others:
        return alone(int("".join(letter for letter in first if letter.isdigit()) or 0))
    return Outcome((2.0, 1.0) if first < others[0] else (1.0, 2.0))


def alone(*values):
    return Outcome((values[0],), values=tuple(map(float, values)))


def by_chance(seed, most=3):
    """Return a function that gives outcomes by chance, the same for the same fixture whenever it is played."""

    def outcome(fixture):
        drawn = random.Random(f"{seed}/{fixture.id}")  # noqa: S311 - a test draws the same each time
        if fixture.kind is FixtureKind.CHALLENGE or len(fixture.sides) == 1:
            return alone(drawn.randint(0, most), drawn.randint(10, 20))
        return Outcome((float(drawn.randint(0, most)), float(drawn.randint(0, most))))

    return outcome


def play(one, outcome=by_strength, outcomes=None):
    """Play a season to its end; return its last state."""
    outcomes = {} if outcomes is None else outcomes
    for _ in range(1000):
        state = one.state(outcomes)
        open_fixtures = state.open_fixtures()
        if not open_fixtures:
            return state
        outcomes |= {fixture.id: outcome(fixture) for fixture in open_fixtures}
    raise AssertionError("the tournament does not end")


def stage(state, name):
    return next(one for one in state.stages if one.name == name)


def order(rows):
    return [row.team for row in rows]
