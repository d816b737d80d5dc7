"""A whole match: halves one after the other, each with a fresh world and fresh processes, all of it recorded."""

from __future__ import annotations

import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from rcj_challenges.core.errors import format_error, interruption_behind
from rcj_challenges.core.play import HalfInfo
from rcj_challenges.core.timing import ticks_from_s
from rcj_challenges.core.traffic import Note, RobotSpec
from rcj_challenges.match.loading import load_stage
from rcj_challenges.match.loop import LoopResult, TickLoop
from rcj_challenges.match.observers import Observer, ProgramTimes
from rcj_challenges.match.pacing import TickEffects
from rcj_challenges.match.sensor_recording import SensorRecording
from rcj_challenges.programs.isolation import active_layers, dropped_layers
from rcj_challenges.programs.pool import PoolPlan, ProgramPool
from rcj_challenges.programs.program import Program
from rcj_challenges.records.errors import UnwritableError
from rcj_challenges.records.logos import logo_of
from rcj_challenges.records.result import MemberResult
from rcj_challenges.records.writer import RecordWriter, RunHeader
from rcj_challenges.referee.carry_over import CarryOver
from rcj_challenges.robots.fitting import fit, robot_specs
from rcj_challenges.scenario.halves import by_seat, half_length_s, half_lengths_s, in_half, teams_by_seat
from rcj_challenges.scenario.load import Loaded
from rcj_challenges.submissions.team import SuperTeam, Team


@dataclass(frozen=True)
class MatchPlan:
    """Everything that decides a match, and where its record goes.

    Attributes:
        teams: by seat of the first half; a SuperTeam has a team for each robot of the seat.
        team_names: as shown and logged, by seat of the first half; overrides what the teams call themselves.
        match_id: as printed in MATCH_START.
        out: the folder in which the record's folder is made.
        record_name: name of the record's folder; left out: time and scenario.
        sandbox: ``auto``, ``strict`` or ``off``.
        real_time: True delays the loop to the pace of the clock; it changes nothing else.
        show_output: robots whose output is shown while they play.
        debug: robots whose program has the terminal, without limits.
        record_sensors: True records what programs see and set; what they print is recorded in any case.
    """

    loaded: Loaded
    teams: Mapping[str, Team | SuperTeam]
    team_names: Mapping[str, str]
    seed: int = 1
    match_id: int = 0
    out: Path = Path("runs")
    record_name: str | None = None
    sandbox: str = "auto"
    real_time: bool = False
    show_output: frozenset[str] = frozenset()
    debug: frozenset[str] = frozenset()
    record_sensors: bool = False

    def name_of(self, team: str) -> str:
        """Return the name of a team."""
        return self.team_names.get(team) or self.teams[team].name

    @property
    def logos(self) -> dict[str, bytes]:
        """The teams' own ``logo.png`` as they gave it, by seat of the first half; it is not checked yet."""
        return {team: logo for team, opened in self.teams.items() if (logo := logo_of(opened.files))}


@dataclass(frozen=True)
class PlayedMatch:
    """A match that is over, or was interrupted.

    ``notes``: by robot, what the module ``controller`` refused or ignored of its program's calls.
    """

    folder: Path
    result: dict[str, Any]
    notes: Mapping[str, Sequence[Note]] = field(default_factory=dict)


class MatchInterruptedError(KeyboardInterrupt):
    """Ctrl-C during a match, or while its end was shown. Its record is closed and contains everything that was played.

    ``problem``: why the record could not be closed properly; empty if it was.
    """

    def __init__(self, played: PlayedMatch, problem: str) -> None:
        super().__init__(f"the record so far is in {played.folder}")
        self.played = played
        self.problem = problem


def play_match(plan: MatchPlan, observer: Observer | None = None) -> PlayedMatch:
    """Play all halves of a match and record them.

    Raises:
        RcjError: the record cannot be written, a sandbox layer is missing, the physics became unstable.
        MatchInterruptedError: it was interrupted; the record is closed, marked as not complete.
    """
    try:
        return _MatchRunner(plan, observer or Observer()).play()
    except OSError as error:
        unwritable = UnwritableError.of(error, plan.out)
        if unwritable is None:
            raise
        raise unwritable from error


class _MatchRunner:
    def __init__(self, plan: MatchPlan, observer: Observer) -> None:
        self._plan = plan
        self._observer = observer
        self._scenario = plan.loaded.scenario
        self._roster = plan.loaded.roster
        self._carry_over = CarryOver(self._scenario)
        self._notes: dict[str, list[Note]] = {}
        self._held_up_s = 0.0
        self._began = 0.0
        self._start_up_s: float | None = None

    def play(self) -> PlayedMatch:
        plan = self._plan
        self._began = time.perf_counter()
        header = RunHeader(
            scenario=self._scenario,
            seed=plan.seed,
            team_names={team: plan.name_of(team) for team in plan.teams},
            programs={team: opened.digest for team, opened in plan.teams.items()},
            match_id=plan.match_id,
            sandbox={
                "mode": plan.sandbox,
                "layers": list(active_layers(plan.sandbox)),
                "dropped": dropped_layers(plan.sandbox),
            },
            marks=("debug",) if plan.debug else (),
            unresolved=plan.loaded.unresolved,
            logos=plan.logos,
            members={team: members for team, opened in plan.teams.items() if (members := _members(opened))},
        )
        with RecordWriter(plan.out, header, name=plan.record_name) as record:
            try:
                for number in range(1, self._scenario.match.halves + 1):
                    if self._play_half(number, record).ends_match:
                        break
                record.finish({"ranking": self._carry_over.ranking()} | self._times())
            except BaseException as error:
                stopped_by = interruption_behind(error) or error
                problem = self._break_off(record, stopped_by)
                self._observer.finished(record.result)
                if isinstance(stopped_by, KeyboardInterrupt):
                    raise MatchInterruptedError(PlayedMatch(record.folder, record.result), problem) from error
                raise
        played = PlayedMatch(record.folder, record.result, self._notes)
        try:
            self._observer.finished(record.result)
        except KeyboardInterrupt as error:
            raise MatchInterruptedError(played, "") from error
        return played

    def _break_off(self, record: RecordWriter, error: BaseException) -> str:
        """Close the record of an unfinished match; return why that failed, or an empty text."""
        try:
            if not record.result["complete"]:
                record.break_off(type(error), self._times())
        except OSError as failure:
            return format_error(failure)
        return ""

    def _times(self) -> dict[str, float]:
        wall_s = time.perf_counter() - self._began - self._held_up_s
        return {"wall_s": round(wall_s, 3), "start_up_s": round(self._start_up_s or 0.0, 3)}

    def _play_half(self, number: int, record: RecordWriter) -> LoopResult:
        """Play one half with a fresh world and fresh processes; programs start while the world is compiled."""
        plan, scenario, roster = self._plan, in_half(self._scenario, number), self._roster
        half = self._half_info(number)
        specs = robot_specs(scenario, roster, fit(scenario, roster))
        pool_plan = PoolPlan(scenario.limits, half.half, plan.seed, record.logs, sandbox=plan.sandbox, debug=plan.debug)
        recording = SensorRecording(scenario, record, number, specs, sensors=plan.record_sensors)
        with recording, ProgramPool(pool_plan) as pool:
            drivers = self._launch(pool, specs, half)
            # Not before programs start: loading the physics takes as long as they do.
            stage = load_stage()(scenario, roster, half, recording.wrap(drivers))
            referee, devices = stage.referee, stage.devices
            later_ticks = sum(ticks_from_s(half_s) for half_s in half_lengths_s(scenario.match)[number:])  # integers
            effects = TickEffects(
                half, later_ticks, referee, record, self._observer, pool, plan.show_output, real_time=plan.real_time
            )
            record.begin_half(half)
            self._observer.half_started(half)
            recording.attach(self._observer, half)
            outcome = TickLoop(stage, half, effects.after_tick, self._observer.fault, self._before_tick).play()
            record.end_half(outcome.closing, outcome.ended)
            pool.finish(
                {
                    roster.entities[robot]: devices.observe(robot, outcome.ticks, over=True)
                    for robot, driver in drivers.items()
                    if driver.fault is None
                }
            )
            effects.closed(outcome.closing)
        for driver in drivers.values():
            self._notes.setdefault(driver.name, []).extend(driver.notes)
        self._observer.half_ended(half, tuple(_waits(driver) for driver in drivers.values()))
        self._carry_over.add(half, referee)
        return outcome

    def _before_tick(self, tick: int) -> None:
        """Wait for the observer; this does not count as time of the match."""
        if self._start_up_s is None:
            self._start_up_s = time.perf_counter() - self._began
        self._held_up_s += self._observer.before_tick(tick)

    def _launch(self, pool: ProgramPool, specs: Mapping[int, RobotSpec], half: HalfInfo) -> dict[int, Program]:
        """Start the programs of all seats; returns them by robot index."""
        drivers: dict[int, Program] = {}
        for seat, entrant in self._scenario.entrants.items():
            team = self._plan.teams[half.teams[seat]]
            for number, name in enumerate(entrant.robots):
                robot = self._roster.index[name]
                if robot in specs:
                    driving = team.driving(number)
                    drivers[robot] = pool.add(specs[robot], driving, driving.entries[name])
        pool.launch()
        return {robot: drivers[robot] for robot in sorted(drivers)}

    def _half_info(self, number: int) -> HalfInfo:
        teams = teams_by_seat(self._scenario, number)
        return HalfInfo(
            half=number,
            halves=self._scenario.match.halves,
            ticks=ticks_from_s(half_length_s(self._scenario.match, number)),
            match_seed=self._plan.seed,
            match_id=self._plan.match_id,
            team_names={seat: self._plan.name_of(team) for seat, team in teams.items()},
            teams=teams,
            scores=by_seat(self._carry_over.scores, teams),
            kept=dict(self._carry_over.kept),
        )


def _members(team: Team | SuperTeam) -> tuple[MemberResult, ...]:
    members = team.members if isinstance(team, SuperTeam) else ()
    return tuple(MemberResult(name=member.name, programs=member.digest) for member in members)


def _waits(program: Program) -> ProgramTimes:
    budget = program.budget
    return ProgramTimes(program.name, program.requests, budget.started_s, budget.charged_s, budget.slowest_s)
