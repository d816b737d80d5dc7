"""From a fixture to the job that plays it, and from the job's result to the fixture's outcome."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from rcj_challenges.controllers.team import TeamError, open_team
from rcj_challenges.facts.diagnostics import Diagnostic, DiagnosticError
from rcj_challenges.records.result import versions
from rcj_challenges.scenario.load import Loaded, load
from rcj_challenges.tournament.jobs import MatchJob, Program, Workplace, entrants_of
from rcj_challenges.tournament.models import Records
from rcj_challenges.tournament.opened import OpenTournament
from rcj_challenges.tournament.season import Fixture, Outcome
from rcj_challenges.tournament.submissions import Handed


class JobMaker:
    """Makes the jobs of a tournament's fixtures."""

    def __init__(self, tournament: OpenTournament, handed: Mapping[str, Handed], sandbox: str) -> None:
        """Prepare it.

        Args:
            tournament: the tournament.
            handed: the submission of each team that plays.
            sandbox: how programs are isolated.
        """
        self._tournament = tournament
        self._handed = handed
        self._sandbox = sandbox
        self._versions = versions().model_dump()
        self._scenarios: dict[tuple[str, tuple[str, ...]], tuple[str, Loaded]] = {}
        self._digests: dict[tuple[str, str], str] = {}

    def job_for(self, fixture: Fixture) -> MatchJob:
        """Return the job of a fixture.

        Raises:
            RcjError: the scenario cannot be loaded or kept, or a submission cannot be opened for it.
        """
        scenario, loaded = self.scenario(fixture.scenario, fixture.overrides)
        teams = self._tournament.season.teams
        return MatchJob(
            scenario=scenario,
            seats={
                side.seat: tuple(self._program(team, side.seat, loaded) for team in side.teams)
                for side in fixture.sides
            },
            names={side.seat: " + ".join(teams[team].name for team in side.teams) for side in fixture.sides},
            seed=self._tournament.seed_of(fixture),
            versions=self._versions,
            records=self.records_of(fixture.stage),
            sandbox=self._sandbox,
        )

    def records_of(self, stage: str) -> Records:
        """Return what is kept of the records of a stage."""
        tournament = self._tournament.loaded.tournament
        return tournament.stages[stage].records or tournament.records

    def scenario(self, source: str, overrides: Sequence[str]) -> tuple[str, Loaded]:
        """Return a scenario and its hash; jobs find it by that.

        Raises:
            RcjError: it cannot be loaded, or not be written into the tournament's data.
        """
        key = (source, tuple(overrides))
        if key not in self._scenarios:
            loaded = load(source, overrides)
            self._scenarios[key] = (self._place.keep_scenario(loaded), loaded)
        return self._scenarios[key]

    @property
    def _place(self) -> Workplace:
        return self._tournament.store.place

    def _program(self, team: str, seat: str, loaded: Loaded) -> Program:
        one = self._handed[team]
        entrants = entrants_of(seat, loaded.scenario)
        key = (one.archive, repr([entrant.robots for entrant in entrants]))
        if key not in self._digests:
            try:
                with open_team(self._place.submissions / one.file, *entrants) as opened:
                    self._digests[key] = opened.digest
            except TeamError as error:
                message = f"the submission of {team} cannot be opened for '{loaded.scenario.title}': {error}"
                help_ = "let the team replace it, or decide its matches with 'tournament decide'"
                raise DiagnosticError(Diagnostic("submission-unusable", message, help_)) from error
        return Program(one.archive, self._digests[key], self._tournament.season.teams[team].name)


def outcome_of(fixture: Fixture, result: Mapping[str, Any]) -> Outcome:
    """Return the outcome of a fixture.

    Args:
        fixture: what was played.
        result: ``score`` and ``ranking`` as in ``result.json``.
    """
    scores = tuple(result["score"][side.seat] for side in fixture.sides)
    if len(fixture.sides) > 1:
        return Outcome(scores)
    values = next((tuple(one["values"]) for one in result["ranking"] if one["team"] == fixture.sides[0].seat), ())
    return Outcome(scores, values=values)


def summary_of(result: Mapping[str, Any]) -> dict[str, Any]:
    """Return what the store keeps of a result; all of it is in the record."""
    summary = {key: result[key] for key in ("score", "ranking", "digest", "wall_s", "simulated_s", "versions")}
    summary["faults"] = [{key: fault[key] for key in ("robot", "team", "kind")} for fault in result["faults"]]
    summary["is_timed"] = is_timed(result)
    return summary


_TIME_FAULTS = frozenset({"start_timeout", "step_timeout", "half_timeout"})


def is_timed(result: Mapping[str, Any]) -> bool:
    """Return whether a time limit decided something in a match: another computer may have played on."""
    return any(fault.get("timed") or fault["kind"] in _TIME_FAULTS for fault in result["faults"])
