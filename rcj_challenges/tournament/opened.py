"""A tournament with its store: the names of teams now, rulings applied, and the state that follows."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import asdict, dataclass
from functools import cached_property
from pathlib import Path

from rcj_challenges.submissions.team_name import safe_name
from rcj_challenges.tournament.drawing import Drawn
from rcj_challenges.tournament.engine import Season
from rcj_challenges.tournament.entries import TeamEntry
from rcj_challenges.tournament.load import LoadedTournament, load_tournament
from rcj_challenges.tournament.played import RulingKind
from rcj_challenges.tournament.season import Fixture, Outcome, Ruled, SeasonState, StageState, Team
from rcj_challenges.tournament.seeds import derived_seed
from rcj_challenges.tournament.store.store import PlayedFixture, Store
from rcj_challenges.tournament.store.tables import RulingRow, SubmissionRow

_RULED = {
    RulingKind.FORFEIT: Ruled.FORFEIT,
    RulingKind.DOUBLE_FORFEIT: Ruled.DOUBLE_FORFEIT,
    RulingKind.CORRECTED: Ruled.CORRECTED,
}


def data_folder(loaded: LoadedTournament, given: Path | None) -> Path:
    """Return the folder of a tournament's data: the one that was given, else ``NAME_data`` in the current folder."""
    return given if given is not None else Path(f"{loaded.name}_data")


@contextmanager
def open_tournament(file: Path | str, data: Path | None, *, writing: bool) -> Iterator[OpenTournament]:
    """Open a tournament with its store.

    Raises:
        RcjError: the file or the store cannot be used.
    """
    loaded = load_tournament(file)
    with Store(data_folder(loaded, data), writing=writing) as store:
        yield OpenTournament(loaded, store)


def sides_of(fixture: Fixture) -> tuple[tuple[str, ...], ...]:
    """Return the team ids of each side."""
    return tuple([side.teams for side in fixture.sides])


@dataclass(frozen=True, slots=True)
class StageLeft:
    """The matches of a stage without an outcome, and the mean of their simulated time.

    There may be ``more``: extra time, tie scenarios, the last matches of a best-of.
    """

    stage: str
    matches: int
    more: int
    mean_s: float


@dataclass
class OpenTournament:
    """A tournament with its store of what was played, submitted and decided."""

    loaded: LoadedTournament
    store: Store
    _kept_draws: int = -1

    @cached_property
    def rulings(self) -> list[RulingRow]:
        """All decisions, oldest first, also those that were taken back."""
        return self.store.rulings()

    @cached_property
    def held(self) -> list[RulingRow]:
        """The decisions that hold, oldest first."""
        return _held(self.rulings)

    @cached_property
    def season(self) -> Season:
        """The engine, with the names of teams and whether they are still there."""
        return self._season(self.held)

    def _season(self, rulings: Sequence[RulingRow]) -> Season:
        teams = self._teams(rulings)
        self.drawn.check(self.loaded.tournament.seed, teams)
        return Season(self.loaded, teams, self.drawn)

    @property
    def teams(self) -> dict[str, Team]:
        """The teams of the file, with their names and whether they are still there."""
        return self._teams(self.held)

    def _teams(self, rulings: Sequence[RulingRow]) -> dict[str, Team]:
        names = display_names(self.loaded.entries, self.store.current_submissions())
        withdrawn = [row for row in rulings if row.kind == RulingKind.WITHDRAWN]
        left = {row.team: (True, dict(row.last_rounds), number) for number, row in enumerate(withdrawn)}
        return {
            team: Team(team, names[team], entry.pot, *left.get(team, ())) for team, entry in self.loaded.entries.items()
        }

    @cached_property
    def drawn(self) -> Drawn:
        """The draws so far; new ones are added."""
        kept = self.store.drawn() if self.store.has_begun() else None
        if kept is None:
            return Drawn.of(self.loaded.tournament.seed, self.loaded.teams())
        kept.pop("by_exchanges", None)  # how Swiss rounds were paired when there were two ways
        return Drawn(**kept)

    def keep_drawn(self) -> None:
        """Keep the draws since the last time."""
        if len(self.drawn.draws) != self._kept_draws:
            self.store.keep_drawn(asdict(self.drawn))
            self._kept_draws = len(self.drawn.draws)

    def refresh(self) -> None:
        """Read teams, rulings and draws again."""
        self._kept_draws = -1
        for name in ("rulings", "held", "season", "drawn"):
            self.__dict__.pop(name, None)

    def state(self, played: Mapping[str, PlayedFixture] | None = None) -> SeasonState:
        """Return the state after what was played (left out: as in the store) and decided."""
        return _state(self.season, self.store.played() if played is None else played, self.held)[0]

    def state_and_outcomes(self) -> tuple[SeasonState, dict[str, Outcome]]:
        """Return the state, and what was played and decided before withdrawals are applied, by fixture."""
        return _state(self.season, self.store.played(), self.held)

    def state_as_drawn(self) -> SeasonState:
        """Return the state with the teams that were drawn, also when the file has others now."""
        return _state(Season(self.loaded, self.teams, self.drawn), self.store.played(), self.held)[0]

    def state_with(self, ruling: RulingRow, played: Mapping[str, PlayedFixture]) -> SeasonState:
        """Return the state with one more ruling, after what was played by fixture."""
        rulings = _held([*self.rulings, ruling])
        return _state(self._season(rulings), played, rulings)[0]

    def seed_of(self, fixture: Fixture) -> int:
        """Return the seed of a fixture: another one each time a referee orders a replay."""
        replays = sum(
            row.kind == RulingKind.REPLAY and tuple(map(tuple, row.sides)) == sides_of(fixture)
            for row in self.held
            if row.fixture == fixture.id
        )
        return derived_seed(fixture.seed, f"replay/{replays}") if replays else fixture.seed

    def work_left(self, state: SeasonState) -> list[StageLeft]:
        """Return the rest of each stage."""
        durations_s = {(use.source, use.overrides): info.duration_s for use, info in self.loaded.scenarios.items()}
        found = []
        for stage in state.stages:
            known = [durations_s[one.scenario, one.overrides] for one in stage.fixtures] or list(durations_s.values())
            left = max(0, stage.expected_matches - sum(one.id in state.outcomes for one in stage.fixtures))
            found.append(StageLeft(stage.name, left, self._more(stage), sum(known) / len(known)))
        return found

    def _more(self, stage: StageState) -> int:
        drawn = self.loaded.tournament.drawn
        least, most = self.loaded.tournament.stages[stage.name].matches_of_tie
        most += drawn.extra_time is not None
        if drawn.tie_scenario is not None:
            use = self.loaded.names.use(drawn.tie_scenario.scenario, drawn.tie_scenario.set)
            most += 2 if len(self.loaded.scenarios[use].seats) == 1 else 1  # each team by itself, or both together
        ties = [tie for tie in stage.ties if not tie.winner and "bye" not in tie.sources]
        return sum(max(0, most - max(least, len(tie.fixtures))) for tie in ties)


def last_ruling(rulings: Sequence[RulingRow], fixture: str, team: str = "") -> RulingRow | None:
    """Return the last decision about a match, or with no match the last one about a team; None if there is none."""
    return next((row for row in reversed(rulings) if row.fixture == fixture and (fixture or row.team == team)), None)


def _held(rulings: Sequence[RulingRow]) -> list[RulingRow]:
    held: list[RulingRow] = []
    for row in rulings:
        if row.kind != RulingKind.UNDONE:
            held.append(row)
        elif undone := last_ruling(held, row.fixture, row.team):
            held.remove(undone)
    return held


def _state(
    season: Season, played: Mapping[str, PlayedFixture], rulings: Sequence[RulingRow]
) -> tuple[SeasonState, dict[str, Outcome]]:
    outcomes = {fixture: one.outcome for fixture, one in played.items()}
    sides = {fixture: one.sides for fixture, one in played.items()}
    for fixture, row in {row.fixture: row for row in rulings if row.fixture}.items():  # the last of each holds
        if row.kind != RulingKind.REPLAY:
            outcomes[fixture] = Outcome(tuple(row.scores), _RULED[RulingKind(row.kind)], row.reason)
            sides[fixture] = tuple(map(tuple, row.sides))
    while True:
        state = season.state(outcomes)
        known = (fixture for fixture in state.fixtures if fixture.id in outcomes)
        others = [one.id for one in known if sides[one.id] != sides_of(one)]
        if not others:
            return state, outcomes
        for fixture in others:  # it was played, or ruled on, with other teams than those of now
            own = played.get(fixture)
            if own is not None and own.sides != sides[fixture]:
                outcomes[fixture], sides[fixture] = own.outcome, own.sides
            else:
                del outcomes[fixture]


def later_stages(loaded: LoadedTournament, stage: str) -> list[str]:
    """Return the stages that take their teams from a stage, directly or not."""
    found = [stage]
    for name, one in loaded.tournament.stages.items():
        if one.from_ in found:
            found.append(name)
    return found[1:]


def display_names(
    entries: Mapping[str, TeamEntry], submissions: Mapping[tuple[str, str], SubmissionRow]
) -> dict[str, str]:
    """Return the name of each team: of the file, else of its submission, else its id.

    Names that are equal without regard to case are followed by the team's id.
    """
    names = {}
    for team, entry in entries.items():
        row = submissions.get((team, ""))
        names[team] = safe_name(entry.name or (row.name if row is not None else "")) or team
    counts = Counter(name.casefold() for name in names.values())
    return {team: name if counts[name.casefold()] == 1 else f"{name} ({team})" for team, name in names.items()}
