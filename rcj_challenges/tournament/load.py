"""From a file to a checked tournament: the strict reader of scenarios, models, the scenarios it names, cross-checks."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

from pydantic import ValidationError

from rcj_challenges.facts.errors import told_of
from rcj_challenges.scenario.errors import ScenarioError, listing, nearest
from rcj_challenges.scenario.halves import half_lengths_s
from rcj_challenges.scenario.load import load
from rcj_challenges.scenario.models.scenario import RankByCounter, RankByScore, RankByTime, Scenario
from rcj_challenges.scenario.reading.yaml_strict import parse_bytes
from rcj_challenges.scenario.resources import names_in, shipped_scenarios, tournaments_folder
from rcj_challenges.scenario.tree import Entries, Mark, mark_of, plain
from rcj_challenges.tournament.checks import check
from rcj_challenges.tournament.entries import TeamEntry, list_teams
from rcj_challenges.tournament.errors import Problem, TournamentFileError, problem_at
from rcj_challenges.tournament.explain import explain
from rcj_challenges.tournament.models import Tournament
from rcj_challenges.tournament.scenarios import Criterion, ScenarioInfo, ScenarioUse, scenario_uses
from rcj_challenges.tournament.season import Team


@dataclass(frozen=True)
class LoadedTournament:
    """A tournament that can be played.

    Attributes:
        tournament: the file's content.
        name: the file's stem.
        path: the file.
        entries: the teams by id, in the order of the file, then of the folder.
        scenarios: what is to be known of each scenario with its settings.
    """

    tournament: Tournament
    name: str
    path: Path
    entries: Mapping[str, TeamEntry]
    scenarios: Mapping[ScenarioUse, ScenarioInfo] = field(repr=False)

    def teams(self) -> dict[str, Team]:
        """Return the teams as the file names them; a submission's own name is not known here."""
        return {entry.id: Team(entry.id, entry.name or entry.id, entry.pot) for entry in self.entries.values()}


def load_tournament(source: str | Path) -> LoadedTournament:
    """Load a tournament.

    Args:
        source: a file, or the bare name of a shipped tournament (``cup``).

    Raises:
        TournamentFileError: everything that is wrong with it.
    """
    path = find_tournament(source)
    shown = str(source) if path == Path(source) else path.name
    tree = read_tree(path, shown)
    tournament = _validated(tree)
    entries, problems = list_teams(tournament, path.parent, tree)
    scenarios: dict[ScenarioUse, ScenarioInfo] = {}
    for use, where in scenario_uses(tournament, path.parent).items():
        try:
            scenarios[use] = _info(load(use.source, use.overrides).scenario)
        except ScenarioError as error:
            mark = mark_of(tree, where)
            problems += [_of_scenario(mark, ".".join(map(str, where)), str(one)) for one in error.problems]
    problems += check(tournament, entries, scenarios, tree, path.parent)
    if problems:
        raise TournamentFileError(problems)
    return LoadedTournament(tournament, path.stem, path, entries, scenarios)


def find_tournament(source: str | Path) -> Path:
    """Return the file that ``source`` stands for: a path, or the bare name of a shipped tournament.

    Raises:
        TournamentFileError: there is no such file.
    """
    path = Path(source)
    try:
        if path.is_file():
            return path
    except (OSError, ValueError):  # a name too long, or with a zero byte
        pass
    shipped = names_in(tournaments_folder())
    if str(source) in shipped:
        return tournaments_folder() / f"{source}.yaml"
    hint = nearest(str(source), shipped).removeprefix("; ")
    help_ = f"{hint} " if hint else ""
    raise TournamentFileError(
        [
            Problem(
                "no-such-file",
                "no such file, and no shipped tournament of that name",
                f"{help_}shipped are {listing(shipped)}",
                str(source)[:200],
            )
        ]
    )


def read_tree(path: Path, shown: str) -> Entries:
    """Return a file's tree.

    Raises:
        TournamentFileError: it cannot be read, or is not strict YAML.
    """
    try:
        data = path.read_bytes()
    except OSError as error:
        raise TournamentFileError([Problem("unreadable-file", told_of(error), "", shown)]) from None
    try:
        tree = parse_bytes(data, shown)
    except ScenarioError as error:
        problems = [Problem("invalid-yaml", one.message, "", one.file, one.line, one.column) for one in error.problems]
        raise TournamentFileError(problems) from None
    if not isinstance(tree, Entries):
        message = "a tournament file is a mapping with 'tournament_version', 'title', 'seed', 'stages', …"
        raise TournamentFileError([problem_at(tree.mark, "wrong-value", message)])
    return tree


def is_tournament(tree: object) -> bool:
    """Return whether a file's tree is a tournament, and not a scenario."""
    return isinstance(tree, Entries) and "tournament_version" in tree.entries


def _validated(tree: Entries) -> Tournament:
    try:
        return Tournament.model_validate(plain(tree))
    except ValidationError as error:
        raise TournamentFileError(explain(error, tree, Tournament)) from None


def _of_scenario(mark: Mark, path: str, said: str) -> Problem:
    help_ = f"shipped scenarios: {listing(shipped_scenarios(), 20)}" if "no such file" in said else ""
    return problem_at(mark, "scenario", said.partition("; shipped are ")[0], help_, path)


def _info(scenario: Scenario) -> ScenarioInfo:
    """Return what a tournament needs to know of a scenario."""
    seats = {seat: len(entrant.robots) for seat, entrant in scenario.entrants.items()}
    criteria = tuple(map(_criterion, scenario.result.rank))
    return ScenarioInfo(scenario.id, scenario.title, seats, criteria, sum(half_lengths_s(scenario.match)))


def _criterion(rank: RankByScore | RankByTime | RankByCounter) -> Criterion:
    if isinstance(rank, RankByScore):
        return Criterion("score", is_more_better=rank.score == "descending")
    if isinstance(rank, RankByTime):
        return Criterion("time", is_more_better=rank.time == "descending")
    return Criterion(rank.counter, is_more_better=rank.order == "descending")
