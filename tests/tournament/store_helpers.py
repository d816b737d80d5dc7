"""A small tournament in a folder, and an executor that plays nothing: its results are made of the job's address."""

import hashlib
import json
import shutil
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path

from sqlalchemy import update

from rcj_challenges.records.result import versions
from rcj_challenges.scenario.resources import TEAMS_FOLDER
from rcj_challenges.tournament.admission import take_submissions
from rcj_challenges.tournament.executor import JobOutcome
from rcj_challenges.tournament.fixtures import JobMaker
from rcj_challenges.tournament.load import load_tournament
from rcj_challenges.tournament.opened import OpenTournament
from rcj_challenges.tournament.reconcile import reconcile
from rcj_challenges.tournament.runner import Runner
from rcj_challenges.tournament.store.store import Store
from rcj_challenges.tournament.store.tables import JOB

LEAGUE = """
tournament_version: 1
title: Test league
seed: 7
set: {match.half_s: 2, match.halves: 1}
teams_folder: teams
tie_breaks: [points, goal_difference, goals, lot]
stages:
  league: {stage: round_robin}
  finals: {stage: knock_out, from: league, places: 1-2}
"""

SUPER_TEAMS = """
tournament_version: 1
title: Test super teams
seed: 7
set: {match.half_s: 2, match.halves: 1}
teams_folder: teams
stages: {super: {stage: super_team, super_teams: {red: [ada, bee, cid], white: [dee, eva, fay]}}}
"""


def code_of(error):
    """Return the code of an error that was raised."""
    return error.value.diagnostics[0].code


class Home:
    """A folder with a tournament file, its teams, and its data."""

    def __init__(self, folder, text=LEAGUE, teams=("ada", "bee", "cid")):
        self.folder = folder
        self.file = folder / "league.yaml"
        self.teams = folder / "teams"
        self.data = folder / "data"
        if not self.file.exists():
            folder.mkdir(exist_ok=True)
            self.file.write_text(text, encoding="utf-8")
            for team in teams:
                self.hand_in(team)

    def hand_in(self, team, word="", name=None):
        """Let a team hand in the sample team's programs, with a word of its own in them."""
        folder = self.teams / team
        shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(TEAMS_FOLDER / "ball_chaser", folder)
        (folder / "word.txt").write_text(f"{team} {word}", encoding="utf-8")
        (folder / "team_name.txt").write_text(name or f"Team {team}", encoding="utf-8")

    @contextmanager
    def opened(self, *, writing=True):
        with Store(self.data, writing=writing) as store:
            yield OpenTournament(load_tournament(self.file), store)

    def play(self, *, cascade=False, executor=None, observer=None):
        """Play what is not played yet with a `FakeExecutor`; returns the state, and the executor."""
        with self.opened() as tournament:
            handed = take_submissions(tournament.loaded.entries.values(), tournament.store)
            tournament.refresh()
            jobs = JobMaker(tournament, handed, "off")
            reconcile(tournament, jobs, cascade=cascade)
            executor = executor or FakeExecutor(tournament.store.place)
            executor.place = tournament.store.place
            return Runner(tournament, jobs, executor, observer or Silent()).run(), executor

    def state(self):
        with self.opened(writing=False) as tournament:
            return tournament.state()

    def tables(self):
        """Return all that can be seen of the results, to be compared."""
        state = self.state()
        return [(stage.tables, stage.ties, stage.places) for stage in state.stages], dict(state.outcomes)


def let_other_versions_have_played(home, **versions):
    """Change the versions that the store says of all jobs."""
    with Store(home.data, writing=True) as store:
        rows = store.jobs().values()
        with store.transaction() as connection:
            for row in rows:
                job = {**row.job, "versions": {**row.job["versions"], **versions}}
                connection.execute(update(JOB).where(JOB.c.id == row.id).values(job=job))


class Silent:
    """Sees a run, and keeps what it saw."""

    def __init__(self):
        self.seen = []

    def played(self, fixture, outcome, progress, *, is_doubtful):
        self.seen.append(("doubtful" if is_doubtful else "played", fixture.id))

    def not_played(self, fixture, complaint):
        self.seen.append(("not_played", fixture.id))

    def played_again(self, fixture):
        self.seen.append(("again", fixture.id))


def goals_of(job, salt=""):
    """Return the score by seat that a job gives: it depends on programs and seed, as that of a match does."""
    programs = [program.digest for programs in job.seats.values() for program in programs]
    drawn = hashlib.sha256(f"{programs} {job.seed} {salt}".encode()).digest()
    return {seat: drawn[number] % 5 for number, seat in enumerate(job.seats)}


@dataclass
class FakeExecutor:
    """Gives each job the next of its attempts' ends: ``ok``, ``timed``, ``other`` (score), ``died``, ``host``, ``stop``."""

    place: object
    ends: dict = field(default_factory=dict)
    """By number of the job, in the order of submission, from 0: how its attempts end."""
    lanes: int = 2
    jobs: list = field(default_factory=list)
    waiting: list = field(default_factory=list)
    most_waiting: int = 0

    def __enter__(self):
        return self

    def __exit__(self, *_):
        pass

    def submit(self, job):
        self.jobs.append(job)
        self.waiting.append(job)
        self.most_waiting = max(self.most_waiting, len(self.waiting))

    def poll(self):
        job = self.waiting.pop(0)
        return [self._outcome(job, self.ends.get(self.jobs.index(job), "ok"))]

    def _outcome(self, job, end):
        if not isinstance(end, str):
            end = end.pop(0)
        if end == "stop":
            raise KeyboardInterrupt
        if end in ("died", "host"):
            return JobOutcome(job, None, complaint=f"it {end}", is_host_error=end == "host")
        score = goals_of(job, "other" if end.startswith("other") else "")
        faults = (
            [{"robot": "B1", "team": "blue", "kind": "step_timeout", "detail": "", "half": 1}] if "timed" in end else []
        )
        result = {
            "score": score,
            "ranking": [{"team": seat, "place": 1, "values": [points]} for seat, points in score.items()],
            "digest": f"{job.seed} {score} {faults}",
            "wall_s": 1.0,
            "simulated_s": 2.0,
            "versions": versions().model_dump(),
            "faults": faults,
        }
        folder = Path(self.place.playing) / job.id
        folder.mkdir(parents=True)
        (folder / "result.json").write_text(json.dumps(result), encoding="utf-8")
        return JobOutcome(job, result, folder)
