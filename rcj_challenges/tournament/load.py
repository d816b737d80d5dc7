"""From a file to a checked tournament: the strict reader of scenarios, models, the scenarios it names, cross-checks."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path

from pydantic import ValidationError

from rcj_challenges.core.diagnostics import Diagnostic
from rcj_challenges.core.errors import format_error
from rcj_challenges.core.files import open_regular
from rcj_challenges.scenario.codes import NO_SUCH_FILE, UNREADABLE_FILE, WRONG_VALUE
from rcj_challenges.scenario.errors import ScenarioError, did_you_mean, listing
from rcj_challenges.scenario.halves import half_lengths_s
from rcj_challenges.scenario.load import Loaded, load
from rcj_challenges.scenario.messages.explain import explain
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.reading.yaml_strict import MAX_BYTES, parse_bytes
from rcj_challenges.scenario.resources import TOURNAMENTS_FOLDER, names_in, shipped_scenarios
from rcj_challenges.scenario.tree import Entries, Mark, Node, in_names, mark_of, plain
from rcj_challenges.tournament.checks import Checks
from rcj_challenges.tournament.codes import UNKNOWN_SCENARIO, WRONG_SCENARIO
from rcj_challenges.tournament.entries import TeamEntry, TeamLists
from rcj_challenges.tournament.models import Records
from rcj_challenges.tournament.scenarios import ScenarioInfo, ScenarioNames, ScenarioUse
from rcj_challenges.tournament.season import Team
from rcj_challenges.tournament.tournament_file import Tournament


@dataclass(frozen=True)
class LoadedTournament:
    """A tournament that can be played.

    Attributes:
        name: the file's stem.
        entries: the teams by id, in the order of the file, then of the folder.
    """

    tournament: Tournament
    name: str
    path: Path
    entries: Mapping[str, TeamEntry]
    scenarios: Mapping[ScenarioUse, ScenarioInfo] = field(repr=False)
    warnings: tuple[Diagnostic, ...] = ()

    def teams(self) -> dict[str, Team]:
        """Return the teams with the names of the file; a submission's own name is not known here."""
        return {team: entry.team for team, entry in self.entries.items()}

    @cached_property
    def names(self) -> ScenarioNames:
        """The names of scenarios."""
        return ScenarioNames(self.tournament, self.path.parent)

    def records(self, stage: str) -> Records:
        """Return the kind of records of a stage: ``full``, ``replay`` or ``result``."""
        return self.tournament.stages[stage].records or self.tournament.records


def load_tournament(source: str | Path) -> LoadedTournament:
    """Load a tournament from a file, or by the bare name of a shipped one (``cup``).

    Raises:
        ScenarioError: all its mistakes.
    """
    path = find_tournament(source)
    return load_tree(read_tree(path, str(source) if path == Path(source) else path.name), path)


def load_tree(tree: Node, path: Path) -> LoadedTournament:
    """Load a tournament from the tree of its file.

    Raises:
        ScenarioError: all its mistakes.
    """
    tournament, tree = _validated(tree)
    names = ScenarioNames(tournament, path.parent)
    lists = TeamLists(tournament, path.parent, tree)
    scenarios: dict[ScenarioUse, Loaded] = {}
    problems: list[Diagnostic] = []
    for use, where in tournament.uses(names).items():
        try:
            scenarios[use] = load(use.source, use.overrides)
        except ScenarioError as error:
            mark = mark_of(tree, where)
            problems += [_of_scenario(mark, in_names(tree, where), one) for one in error.diagnostics]
    entries = lists.entries()
    has_samples = any(entry.is_sample for entry in entries.values())
    samples = _samples(tournament, names, scenarios) if has_samples else {}
    entries = lists.with_challenges(entries, tournament.challenges, samples)
    teams = {team: entry.team for team, entry in entries.items()}
    infos = {use: _info(loaded.scenario) for use, loaded in scenarios.items()}
    problems += lists.problems
    problems += Checks(tournament, teams, infos, tree, names, are_teams_known=not lists.problems).problems()
    if any(one.level == "error" for one in problems):
        raise ScenarioError(problems)
    return LoadedTournament(tournament, path.stem, path, entries, infos, tuple(problems))


def find_tournament(source: str | Path) -> Path:
    """Return the file of a tournament by its path, or by the bare name of a shipped one.

    Raises:
        ScenarioError: there is no such file.
    """
    path = Path(source)
    try:
        if path.is_file():
            return path
    except (OSError, ValueError):  # a name too long, or with a zero byte
        pass
    shipped = names_in(TOURNAMENTS_FOLDER)
    if str(source) in shipped:
        return TOURNAMENTS_FOLDER / f"{source}.yaml"
    help_ = did_you_mean(str(source), shipped, f"Shipped are {listing(shipped)}")
    message = "no such file, and no shipped tournament of that name"
    raise ScenarioError([Mark(str(source)[:200]).error(NO_SUCH_FILE, message, help_)])


def read_tree(path: Path, shown: str) -> Node:
    """Return a file's tree.

    Raises:
        ScenarioError: it cannot be read, or is not strict YAML.
    """
    try:
        with open_regular(path) as file:
            return parse_bytes(file.read(MAX_BYTES + 1), shown)
    except OSError as error:
        help_ = "give a file that you may read"
        raise ScenarioError([Mark(shown).error(UNREADABLE_FILE, format_error(error), help_)]) from None
    except ScenarioError as error:
        help_ = "the file is read as strict YAML: correct this line"
        raise ScenarioError(replace(one, help=one.help or help_) for one in error.diagnostics) from None


def _validated(tree: Node) -> tuple[Tournament, Entries]:
    if not isinstance(tree, Entries):
        help_ = "write keys and their values: 'tournament_version', 'title', 'seed', 'stages', …"
        raise ScenarioError([tree.mark.error(WRONG_VALUE, "a tournament file is a mapping", help_)])
    try:
        return Tournament.model_validate(plain(tree, tuple)), tree
    except ValidationError as error:
        raise ScenarioError(explain(error, tree, Tournament, are_empty_reported=False)) from None


def _samples(
    tournament: Tournament, names: ScenarioNames, scenarios: Mapping[ScenarioUse, Loaded]
) -> dict[tuple[str, str], Path | None]:
    """Return the sample team for each challenge."""
    found: dict[tuple[str, str], Path | None] = {}
    for key, one in tournament.challenges.items():
        if (loaded := scenarios.get(names.use(one.scenario, one.set))) is not None:
            from rcj_challenges.match.samples import sample_team  # noqa: PLC0415 - few tournaments need it

            bases = [load(base).scenario for base in loaded.bases]
            found[key] = sample_team(loaded.scenario, next(iter(loaded.scenario.entrants)), bases)
    return found


def _of_scenario(mark: Mark, path: str, problem: Diagnostic) -> Diagnostic:
    if problem.code == "no-such-file":
        message = "no such file, and no shipped scenario of that name"
        return mark.error(UNKNOWN_SCENARIO, message, f"Shipped are {listing(shipped_scenarios(), 20)}", path)
    help_ = "'rcj-challenge validate SCENARIO' shows all that is wrong with it"
    message = f"the scenario cannot be used: {problem.where}: {problem.message}"
    return mark.error(WRONG_SCENARIO, message, help_, path)


def _info(scenario: Scenario) -> ScenarioInfo:
    seats = {seat: len(entrant.robots) for seat, entrant in scenario.entrants.items()}
    return ScenarioInfo(scenario.id, scenario.title, seats, scenario.result.rank, sum(half_lengths_s(scenario.match)))
