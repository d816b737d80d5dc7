"""The bars of tournaments: matches against those of `run`, ten thousand matches planned, the site, Swiss pairings.

    python -m benchmarks.tournament [--json] [--quick] [--only matches,large,site,swiss]

The ratio of the matches is of the same matches in the same run, in two lanes each; the check of the submissions, which
`run` does not make, has a row of its own. ``--quick`` plays fewer and shorter matches: a ratio of mostly start-up.
"""

from __future__ import annotations

import importlib.util
import random
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from dataclasses import replace
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

from rich.console import Console
from sqlalchemy import insert

from benchmarks.rows import Row, as_users_have_it, parser, show
from rcj_challenges.cli.tournament.run import prepare
from rcj_challenges.cli.tournament.run_lines import RunLines
from rcj_challenges.match.batch import Job
from rcj_challenges.match.worker_pool import run_all
from rcj_challenges.tournament.admission import take_submissions
from rcj_challenges.tournament.engine import Season
from rcj_challenges.tournament.executor import LocalExecutor
from rcj_challenges.tournament.fixtures import JobMaker, summary_of
from rcj_challenges.tournament.jobs import sizes
from rcj_challenges.tournament.load import load_tournament
from rcj_challenges.tournament.opened import OpenTournament
from rcj_challenges.tournament.runner import Runner
from rcj_challenges.tournament.season import Fixture, Outcome
from rcj_challenges.tournament.store.store import Store
from rcj_challenges.tournament.store.tables import JOB, PLAYED, JobRow, PlayedRow

LANES = 2
SAMPLES = ("all_sensors", "roles_and_radio", "ball_chaser")
PARTS = ("matches", "large", "site", "swiss")


def write_tournament(folder: Path, teams: int, stage: str, half_s: float) -> Path:
    """Write the file of a tournament of sample teams with one stage; returns its path."""
    entries = "".join(f"  t{number:03}: {{sample: {SAMPLES[number % 3]}}}\n" for number in range(teams))
    path = folder / "bench.yaml"
    path.write_text(
        f"tournament_version: 1\ntitle: Benchmark\nseed: 2021\nset: {{match.half_s: {half_s:g}}}\n"
        f"teams:\n{entries}tie_breaks: [points, goal_difference, goals, lot]\nstages:\n  stage: {{{stage}}}\n",
        "utf-8",
    )
    return path


def timed(action: Callable[[], object]) -> float:
    """Return how long an action takes, in s."""
    began = time.perf_counter()
    action()
    return time.perf_counter() - began


def command(*arguments: str | Path) -> None:
    """Run a command to its end."""
    subprocess.run(
        [sys.executable, "-m", "rcj_challenges", *map(str, arguments)],
        check=True, stdout=subprocess.DEVNULL, env=as_users_have_it(),
    )  # fmt: skip


def match_rows(folder: Path, *, is_quick: bool) -> list[Row]:
    """Play a group stage, and the same matches by `run`."""
    teams, groups, half_s = (4, 1, 20.0) if is_quick else (16, 4, 600.0)
    path = write_tournament(folder, teams, f"stage: round_robin, groups: {groups}, legs: 2", half_s)
    with Store(folder / "data", writing=True) as store:
        tournament = OpenTournament(load_tournament(path), store)
        lines = RunLines(Console(quiet=True), tournament, quiet=True)
        began = time.perf_counter()
        jobs = prepare(tournament, (), "auto", LANES, lines)
        check_s = time.perf_counter() - began
        fixtures = tournament.state().open_fixtures()
        runs = [_run_job(tournament, fixture, jobs, half_s, folder / "runs") for fixture in fixtures]
        run_s = timed(lambda: run_all(runs, LANES, lambda _: None))
        runner = Runner(tournament, jobs, LocalExecutor(store.place, LANES), lines)
        tournament_s = timed(runner.run)
        assert len(store.played()) == len(fixtures)
    must = None if is_quick else 1.03
    return [
        Row(f"{len(fixtures)} matches, over those by run", round(tournament_s / run_s, 3), "x", must),
        Row(f"{len(fixtures)} matches, tournament", round(tournament_s, 1), "s", None),
        Row(f"{len(fixtures)} matches, run in two lanes", round(run_s, 1), "s", None),
        Row(f"check of {teams} submissions", round(check_s, 1), "s", None),
    ]


def _run_job(tournament: OpenTournament, fixture: Fixture, jobs: JobMaker, half_s: float, out: Path) -> Job:
    """Return a fixture as a match by `run`."""
    paths = {side.seat: tournament.loaded.entries[side.teams[0]].source for side in fixture.sides}
    teams = [argument for seat, path in paths.items() for argument in (f"--{seat}", str(path))]
    seed = jobs.job_for(fixture).seed
    return Job(seed, ("match", "--set", f"match.half_s={half_s:g}", *teams, "--out", str(out)))


def large_rows(folder: Path) -> list[Row]:
    """Plan ten thousand matches, and ask for the status when all are played."""
    path = write_tournament(folder, 101, "stage: round_robin, legs: 2", 600.0)
    data = folder / "data"
    plan_s = timed(lambda: command("tournament", "plan", path, "--data", data))
    open_s = timed(lambda: command("tournament", "status", path, "--data", data))
    with Store(data, writing=True) as store:
        matches = fill(OpenTournament(load_tournament(path), store), {}, {})
    status_s = timed(lambda: command("tournament", "status", path, "--data", data))
    return [
        Row(f"plan of {matches} matches, with a trial", round(plan_s, 2), "s", 5.0),
        Row(f"status of {matches} matches, none played", round(open_s, 2), "s", 1.0),
        Row(f"status of {matches} matches, all played", round(status_s, 2), "s", 1.0),
    ]


def fill(tournament: OpenTournament, summary: dict[str, Any], files: dict[str, int]) -> int:
    """Let all matches that can be played have a made-up outcome; returns how many there are.

    Args:
        tournament: its store is open for writing.
        summary: of each job.
        files: sizes of the files in each record.
    """
    store = tournament.store
    handed = take_submissions(tournament.loaded.entries.values(), store)
    tournament.refresh()
    fixtures = tournament.state().open_fixtures()
    first = JobMaker(tournament, handed, "off").job_for(fixtures[0])
    at = datetime.now(UTC)
    draw = random.Random(1)  # noqa: S311 - the same figures each time
    made_jobs: list[dict[str, Any]] = []
    made: list[dict[str, Any]] = []
    for fixture in fixtures:
        job = replace(first, seed=fixture.seed)
        made_jobs.append(JobRow(job.id, "played", job.to_json(), summary, files, False, "", at)._asdict())
        sides = [side.teams[0] for side in fixture.sides]
        outcome = [[draw.randrange(5), draw.randrange(5)], []]
        archives = {team: handed[team, ""].archive for team in sides}
        made.append(PlayedRow(fixture.id, job.id, " ".join(sides), outcome, archives, at)._asdict())
    with store.transaction() as connection:
        connection.execute(insert(JOB), made_jobs)
        connection.execute(insert(PLAYED), made)
    return len(fixtures)


def site_rows(folder: Path, *, is_quick: bool) -> list[Row]:
    """Publish five hundred matches: the record of one, under the ids of all."""
    if importlib.util.find_spec("rcj_challenges.tournament.site") is None:
        print("note: this version cannot publish; no row for the site", file=sys.stderr)
        return []
    path = write_tournament(folder, 6 if is_quick else 23, "stage: round_robin, legs: 2", 20.0 if is_quick else 600.0)
    with Store(folder / "data", writing=True) as store:
        tournament = OpenTournament(load_tournament(path), store)
        handed = take_submissions(tournament.loaded.entries.values(), store)
        tournament.refresh()
        fixture = tournament.state().open_fixtures()[0]
        job = JobMaker(tournament, handed, "auto").job_for(fixture)
        with LocalExecutor(store.place, 1) as executor:
            executor.submit(job)
            while not (outcomes := executor.poll()):
                pass
        result, record = outcomes[0].result, outcomes[0].folder
        assert result is not None
        assert record is not None, outcomes[0].complaint
        matches = fill(tournament, summary_of(result), sizes(record))
        for played in store.played().values():
            shutil.copytree(record, store.place.record_of(played.job_id))
    publish_s = timed(lambda: command("tournament", "publish", path, "--data", folder / "data"))
    return [Row(f"site of {matches} matches", round(publish_s, 1), "s", None if is_quick else 60.0)]


def swiss_rows(folder: Path) -> list[Row]:
    """Pair 64 teams in nine rounds; the time is that of all states from the first round to the last table."""
    loaded = load_tournament(write_tournament(folder, 64, "stage: swiss, rounds: 9", 600.0))
    season = Season(loaded, loaded.teams())
    draw = random.Random(1)  # noqa: S311 - the same figures each time
    outcomes: dict[str, Outcome] = {}
    pair_s = 0.0
    while True:
        began = time.perf_counter()
        fixtures = season.state(outcomes).open_fixtures()
        pair_s += time.perf_counter() - began
        if not fixtures:
            break
        outcomes |= {one.id: Outcome((float(draw.randrange(4)), float(draw.randrange(4)))) for one in fixtures}
    assert len(outcomes) == 9 * 32
    return [Row("64 teams, 9 rounds of Swiss", round(pair_s, 2), "s", 2.0)]


def main() -> int:
    """Print the table; exit code 1 if a must is missed."""
    options = parser("the bars of tournaments, measured")
    options.add_argument("--quick", action="store_true", help="fewer and shorter matches")
    options.add_argument("--only", default=",".join(PARTS), help="parts, with commas between them")
    given = options.parse_args()
    parts: dict[str, Callable[[Path], list[Row]]] = {
        "matches": lambda folder: match_rows(folder, is_quick=given.quick),
        "large": large_rows,
        "site": lambda folder: site_rows(folder, is_quick=given.quick),
        "swiss": swiss_rows,
    }
    rows = []
    for part in given.only.split(","):
        with tempfile.TemporaryDirectory() as folder:
            rows += parts[part](Path(folder))
    return show(rows, as_json=given.json)


if __name__ == "__main__":
    sys.exit(main())
