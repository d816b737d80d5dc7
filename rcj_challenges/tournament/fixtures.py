"""From a fixture to the job that plays it, and from the job's result to the fixture's outcome."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from rcj_challenges.core.diagnostics import Diagnostic, DiagnosticError
from rcj_challenges.records.result import has_time_fault, versions
from rcj_challenges.scenario.load import Loaded, load
from rcj_challenges.submissions.team import TeamError, open_team
from rcj_challenges.tournament.admission import CheckTask, Submissions, purpose_of
from rcj_challenges.tournament.codes import SUBMISSION_UNUSABLE
from rcj_challenges.tournament.jobs import MatchJob, Program, Workplace, entrants_of
from rcj_challenges.tournament.opened import OpenTournament
from rcj_challenges.tournament.scenarios import ScenarioUse
from rcj_challenges.tournament.season import Fixture, Outcome
from rcj_challenges.tournament.store.tables import SubmissionRow


@dataclass
class JobMaker:
    """Makes the jobs of a tournament's fixtures from the submissions of all teams that play or have played."""

    tournament: OpenTournament
    handed: Submissions
    sandbox: str

    def __post_init__(self) -> None:
        self._versions = versions().model_dump()
        self._scenarios: dict[tuple[str, tuple[str, ...]], tuple[str, Loaded]] = {}
        self._digests: dict[tuple[str, str], str] = {}

    def job_for(self, fixture: Fixture) -> MatchJob:
        """Return the job of a fixture.

        Raises:
            RcjError: the scenario cannot be loaded or kept, or a submission cannot be opened for it.
        """
        scenario, loaded = self.scenario(fixture.scenario, fixture.overrides)
        teams = self.tournament.season.teams
        return MatchJob(
            scenario=scenario,
            seats={
                side.seat: tuple(self._program(fixture, team, side.seat, loaded) for team in side.teams)
                for side in fixture.sides
            },
            names={side.seat: " + ".join(teams[team].name for team in side.teams) for side in fixture.sides},
            seed=self.tournament.seed_of(fixture),
            versions=self._versions,
            records=self.tournament.loaded.records(fixture.stage),
            sandbox=self.sandbox,
        )

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

    def check_tasks(self, handed: Submissions) -> list[CheckTask]:
        """Return the checks: each submission once for each scenario that it will play.

        Settings such as the length of a half make no other check: the first ones of each scenario are taken.
        """
        loaded = self.tournament.loaded
        tasks: dict[tuple[str, str], CheckTask] = {}
        alone: set[ScenarioUse] = set()
        for (name, key), one in loaded.tournament.challenges.items():
            use = loaded.names.use(one.scenario, one.set)
            alone.add(use)
            part = [
                handed[entry.id, purpose_of(entry, name, key)]
                for entry in loaded.entries.values()
                if entry.submission(name, key) is not None and (entry.id, "") in handed
            ]
            self._add_task(tasks, use, f"{name}/{key}", part)
        of_matches = [one for (_, purpose), one in handed.items() if not purpose]
        for use in loaded.scenarios:
            if use not in alone:
                self._add_task(tasks, use, "", of_matches)
        return list(tasks.values())

    def _add_task(
        self, tasks: dict[tuple[str, str], CheckTask], use: ScenarioUse, purpose: str, handed: Sequence[SubmissionRow]
    ) -> None:
        if handed and (use.source, purpose) not in tasks:
            tasks[use.source, purpose] = CheckTask(*self.scenario(use.source, use.overrides), tuple(handed))

    @property
    def _place(self) -> Workplace:
        return self.tournament.store.place

    def _program(self, fixture: Fixture, team: str, seat: str, loaded: Loaded) -> Program:
        entry = self.tournament.loaded.entries[team]
        one = self.handed.get((team, purpose_of(entry, fixture.stage, fixture.group)))
        if one is None:  # it has left, and a SuperTeam still counts on its program
            message = f"{team} has never handed in a submission that can be read, and is to play in '{fixture.id}'"
            help_ = f"decide that match: 'tournament decide FILE {fixture.id} --forfeit {team} --reason TEXT'"
            raise DiagnosticError(Diagnostic(SUBMISSION_UNUSABLE, message, help_))
        entrants = entrants_of(seat, loaded.scenario)
        key = (one.archive, repr([entrant.robots for entrant in entrants]))
        if key not in self._digests:
            try:
                self._digests[key] = open_team(self._place.submissions / one.file, *entrants).digest
            except TeamError as error:
                message = f"the submission of {team} cannot be opened for '{loaded.scenario.title}': {error}"
                help_ = "let the team replace it, or decide its matches with 'tournament decide'"
                raise DiagnosticError(Diagnostic(SUBMISSION_UNUSABLE, message, help_)) from error
        return Program(one.archive, self._digests[key], self.tournament.season.teams[team].name)


def outcome_of(fixture: Fixture, result: Mapping[str, Any]) -> Outcome:
    """Return the outcome of a fixture from ``score`` and ``ranking`` of ``result.json``."""
    scores = tuple(result["score"][side.seat] for side in fixture.sides)
    if len(fixture.sides) > 1:
        return Outcome(scores)
    values = next((tuple(one["values"]) for one in result["ranking"] if one["team"] == fixture.sides[0].seat), ())
    return Outcome(scores, values=values)


def summary_of(result: Mapping[str, Any]) -> dict[str, Any]:
    """Return the part of a result that the store keeps; all of it is in the record."""
    summary = {key: result[key] for key in ("score", "ranking", "digest", "wall_s", "simulated_s", "versions")}
    summary["faults"] = [{key: fault[key] for key in ("robot", "team", "kind")} for fault in result["faults"]]
    summary["is_timed"] = has_time_fault(result)
    return summary
