"""Challenges: each team plays scenarios alone, over the same seeds as all others."""

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import groupby
from typing import Any, ClassVar, Literal

from rcj_challenges.core.amounts import round_score
from rcj_challenges.rules.fields import Name, described
from rcj_challenges.rules.ranked import Ranked
from rcj_challenges.scenario.tree import Step
from rcj_challenges.tournament.formats.context import Entrant, StageContext
from rcj_challenges.tournament.formats.stage import Format, Intake, StageSize
from rcj_challenges.tournament.models import ChallengeScenario
from rcj_challenges.tournament.scenarios import ScenarioInfo, ScenarioNames, ScenarioUse
from rcj_challenges.tournament.season import Fixture, FixtureKind, Outcome, Row, Ruled, StageState, Table, humanized
from rcj_challenges.tournament.standings import placed

_Values = tuple[float | None, ...]
TOTAL = "total"
"""Name of the table that combines several challenges."""


class Challenge(Format):
    """Each team plays scenarios alone, with the same seeds as all others."""

    stage: Literal["challenge"]
    scenarios: dict[Name, ChallengeScenario] = described(..., "the challenges by name", min_length=1, max_length=64)
    seeds: int = described(1, "how often each team plays each of them, each time with a different seed", ge=1, le=1000)
    rank_by: Literal["sum", "median", "best"] = described(
        "sum", "which result of a team counts: the sum or the median of each criterion over its runs, or its best run"
    )
    combine: Literal["places", "share"] = described(
        "places",
        "how several challenges are combined into one table. places: points by place; share: 100 points for "
        "the best value, and for others their share of it, but never more than for a better place",
    )
    place_points: tuple[float, ...] = described(
        (),
        "points for the first place, the second, …; if omitted: the number of teams for the first place, 1 for"
        " the last",
    )

    MIN_TEAMS: ClassVar[int] = 1
    SEATS: ClassVar[int] = 1

    @property
    def challenges(self) -> Mapping[str, ChallengeScenario]:
        return self.scenarios

    def uses(self, names: ScenarioNames) -> Iterator[tuple[ScenarioUse, tuple[Step, ...]]]:
        for key, one in self.scenarios.items():
            yield names.use(one.scenario, one.set), ("scenarios", key, "scenario")

    def size(self, intake: Intake) -> StageSize:
        count = len(self.scenarios)
        return StageSize(intake.teams, {"": intake.teams}, intake.teams * count * self.seeds, count)

    def add_late(self, draw: Any, team: str, present: Collection[str]) -> bool:
        return True

    def state(self, context: StageContext, entrants: Sequence[Entrant]) -> StageState:
        teams = tuple(entrant.team for entrant in entrants)
        key = ("challenge", context.name, teams)
        if key not in context.cache:
            context.cache[key] = {
                name: _fixtures(context, self, name, teams, number) for number, name in enumerate(self.scenarios, 1)
            }
        by_name: dict[str, list[Fixture]] = context.cache[key]
        fixtures = tuple(fixture for own in by_name.values() for fixture in own)
        gone = _settle_withdrawn(context, fixtures)
        counted = [team for team in teams if team not in gone]
        tables = [_table(context, self, name, counted, own) for name, own in by_name.items()]
        if len(tables) > 1:
            tables.append(_total(context, self, counted, tables))
        is_finished = context.are_decided(fixtures)
        return context.state(
            self,
            teams,
            is_finished=is_finished,
            fixtures=fixtures,
            expected_matches=len(fixtures),
            tables=tuple(tables),
            is_solo=True,
            places=tables[-1].rows if is_finished else (),
        )


def _fixtures(context: StageContext, stage: Challenge, name: str, teams: Sequence[str], number: int) -> list[Fixture]:
    one = stage.scenarios[name]
    use = context.names.use(one.scenario, one.set)
    return [
        context.fixture(
            f"{name}/seed{turn}/{team}",
            use,
            ((team,),),
            number,
            f"{humanized(name)}, run {turn}" if stage.seeds > 1 else humanized(name),
            kind=FixtureKind.CHALLENGE,
            group=name,
            leg=turn,
            seed_path=f"{name}/seed{turn}",  # the same for all teams
        )
        for turn in range(1, stage.seeds + 1)
        for team in teams
        if context.entries[team].submission(context.name, name) is not None  # else it takes no part
    ]


def _settle_withdrawn(context: StageContext, fixtures: Sequence[Fixture]) -> set[str]:
    """Annul the open runs of teams that have left, and return those teams; a team that has played all of them stays."""
    gone = set()
    for fixture in fixtures:
        team = fixture.sides[0].teams[0]
        if context.is_unplayed(fixture) and context.has_left(team):
            context.annul(fixture)
            gone.add(team)
    return gone


def _table(context: StageContext, stage: Challenge, name: str, teams: Sequence[str], fixtures: list[Fixture]) -> Table:
    info = _info(context, stage, name)
    runs: dict[str, list[_Values]] = {team: [] for team in teams}
    forfeits = dict.fromkeys(teams, 0)
    for fixture in fixtures:
        team, outcome = fixture.sides[0].teams[0], context.outcomes.get(fixture.id)
        if team not in runs or outcome is None or outcome.ruled is Ruled.ANNULLED:
            continue
        if outcome.ruled is Ruled.FORFEIT:
            forfeits[team] += 1
        else:
            runs[team].append(outcome.values or outcome.scores)
    worst = _worst(info, [run for own in runs.values() for run in own])
    values = {team: _counted(stage, info, [(*run, *worst[len(run) :]) for run in own]) for team, own in runs.items()}
    # Without its forfeited runs a team could have a better sum or median than with them.
    keys = {team: (not runs[team], forfeits[team], info.sort_key(Outcome((), values=values[team]))) for team in teams}
    columns = tuple(one.names[0] for one in info.rank)
    # A lot decides the ranking of the stage; in one of several challenges it would decide points.
    may_draw = context.are_decided(fixtures) and len(stage.scenarios) == 1
    rows = _rows(context, name, keys, may_draw=may_draw)
    counted = (replace(row, played=len(runs[row.team]), values=values[row.team]) for row in rows)
    return Table(name, tuple(counted), columns, context.are_decided(fixtures))


def _info(context: StageContext, stage: Challenge, name: str) -> ScenarioInfo:
    one = stage.scenarios[name]
    return context.scenarios[context.names.use(one.scenario, one.set)]


def _worst(info: ScenarioInfo, runs: Sequence[_Values]) -> _Values:
    """Return the worst value of each criterion: a run with a corrected score has these in the other criteria."""
    return tuple(
        max((run[at] for run in runs if at < len(run)), key=rank.number, default=0.0)
        for at, rank in enumerate(info.rank)
    )


def _counted(stage: Challenge, info: ScenarioInfo, runs: Sequence[_Values]) -> _Values:
    """Return the value of each criterion that counts for a team."""
    if not runs:
        return ()
    if stage.rank_by == "best":
        return min(runs, key=lambda run: info.sort_key(Outcome((), values=run)))
    from statistics import median  # noqa: PLC0415 - it imports much

    together = median if stage.rank_by == "median" else sum
    columns = zip(info.rank, zip(*runs, strict=True), strict=False)
    return tuple(rank.value_of(together(map(rank.number, column))) for rank, column in columns)


def _total(context: StageContext, stage: Challenge, teams: Sequence[str], tables: Sequence[Table]) -> Table:
    columns = tuple(found.name for found in tables)
    points: dict[str, list[float]] = {team: [] for team in teams}
    for found in tables:
        info = _info(context, stage, found.name)
        given = _place_points(stage, found) if stage.combine == "places" else _shares(info.rank[0], found)
        for team in teams:
            points[team].append(given[team])
    totals = {team: round_score(sum(own)) for team, own in points.items()}
    is_complete = all(found.complete for found in tables)
    rows = _rows(context, TOTAL, {team: -total for team, total in totals.items()}, may_draw=is_complete)
    counted = (replace(row, points=totals[row.team], values=tuple(points[row.team])) for row in rows)
    return Table(TOTAL, tuple(counted), columns, is_complete)


def _place_points(stage: Challenge, found: Table) -> dict[str, float]:
    """Return points by place; teams that share a place get those of that place, teams without a run none."""
    listed = stage.place_points or tuple(range(len(found.rows), 0, -1))
    return {
        row.team: float(listed[row.place - 1]) if row.played and row.place <= len(listed) else 0.0 for row in found.rows
    }


def _shares(rank: Ranked, found: Table) -> dict[str, float]:
    """Return 100 for the best value of the first criterion, and to others their share of it; nothing below 0.

    No team gets more than one with a better place: a team with a forfeited run can have the best value and the last
    place.
    """
    shares: dict[str, float] = {}
    best: float | None = 0.0
    least = 100.0
    for row in found.rows:
        if not shares and row.values:
            best = row.values[0]
        least = min(least, _share(rank, row.values[0], best) if row.values else 0.0)
        shares[row.team] = least
    return shares


def _share(rank: Ranked, value: float | None, best: float | None) -> float:
    if value is None or best is None:
        return 0.0
    if value == best and best >= 0 and not (rank.better == "more" and best == 0):
        return 100.0
    part, whole = (value, best) if rank.better == "more" else (best, value)
    return round_score(round(100 * max(0.0, part / whole), 6)) if whole > 0 else 0.0


def _rows(context: StageContext, use: str, keys: Mapping[str, Any], *, may_draw: bool) -> Iterator[Row]:
    """Return teams with their places by key, the smallest first; those with equal keys share a place, or draw lots."""
    rules = context.rules(use)
    levels = [list(part) for _, part in groupby(sorted(keys, key=keys.__getitem__), key=keys.__getitem__)]
    return placed(levels, rules.lot if may_draw and "lot" in rules.tie_breaks else None)
