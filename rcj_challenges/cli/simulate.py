"""``rcj-challenge simulate``: plays a challenge many times and reports the spread of scores."""

from __future__ import annotations

import math
import os
import statistics
import time
from collections import Counter
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from rcj_challenges.cli import OK, OUR_FAULT, WRONG_INPUT, options
from rcj_challenges.cli.app import PLAY, app
from rcj_challenges.cli.codes import BAD_SEEDS
from rcj_challenges.cli.stdio import print_json, print_progress, require_layers
from rcj_challenges.cli.team_args import open_teams
from rcj_challenges.core.amounts import counted, number_words, times
from rcj_challenges.core.errors import RcjError
from rcj_challenges.core.grouping import grouped
from rcj_challenges.core.sanitize import sanitize

if TYPE_CHECKING:
    from rich.console import Console
    from rich.table import Table

    from rcj_challenges.match.batch import Job, Outcome
    from rcj_challenges.rules.ranked import Ranked
    from rcj_challenges.scenario.load import Loaded

_OF_RECORDS = ("folder", "inputs", "states", "digest")
_MAX_SEEDS = 100_000
_MAX_DIGITS = 100
"""Of a seed; Python refuses to parse some thousand."""


@app.register(PLAY, "rcj-challenge simulate match --seeds 1..20 --yellow my_team --blue ball_chaser")
def simulate(
    scenario: options.ScenarioName,
    seeds: options.Seeds = "1..10",
    team: options.Teams = None,
    blue: options.Blue = None,
    yellow: options.Yellow = None,
    duration: options.Duration = None,
    halves: options.Halves = None,
    set_: options.Overrides = None,
    out: options.OutFolder = Path("runs"),
    at_once: options.AtOnce = None,
    json_: options.Json = False,
    quiet: options.Quiet = False,
    sandbox: options.Sandbox = "auto",
) -> int:
    """Play a challenge with many seeds in parallel and report scores, events and faults."""
    teams, overrides = options.all_teams(team, blue, yellow), options.all_overrides(set_, duration, halves)
    from rcj_challenges.scenario.load import load

    try:
        loaded = load(scenario, overrides)
        jobs, known = prepared(loaded, scenario, seeds, teams, overrides, out, sandbox)
    except KeyboardInterrupt as error:
        raise KeyboardInterrupt("no match had begun, and nothing is recorded") from error
    from rcj_challenges.match.worker_pool import run_all
    from rcj_challenges.views.console import console_for

    rank = loaded.scenario.result.rank
    progress = Progress(console_for(to_stderr=True), len(jobs), list(known.values()), quiet=quiet or json_)
    todo = [job for job in jobs if job.seed not in known]
    try:
        played = run_all(todo, at_once or os.cpu_count() or 1, progress.done)
    except KeyboardInterrupt as error:
        if progress.outcomes or json_:
            _report(progress.outcomes, rank, as_json=json_)
        count = sum(outcome.result is not None for outcome in progress.outcomes)
        raise KeyboardInterrupt(f"{count} of {len(jobs)} matches were played to their end") from error
    order = {job.seed: number for number, job in enumerate(jobs)}
    outcomes = sorted([*known.values(), *played], key=lambda outcome: order[outcome.job.seed])
    failed = [outcome for outcome in outcomes if outcome.result is None]
    wrong = [outcome for outcome in failed if outcome.wrong_input]
    is_hopeless = bool(wrong) and len(failed) == len(outcomes)
    if json_ or not is_hopeless:
        _report(outcomes, rank, as_json=json_)
    if is_hopeless:
        raise RcjError(wrong[0].complaint)
    return (WRONG_INPUT if len(wrong) == len(failed) else OUR_FAULT) if failed else OK


def prepared(
    loaded: Loaded, scenario: str, seeds: str, teams: list[str], overrides: list[str], out: Path, sandbox: str
) -> tuple[list[Job], dict[int, Outcome]]:
    """What is to be played, and by seed the outcomes that have a record in ``out``.

    Raises:
        RcjError: wrong input.
    """
    from rcj_challenges.cli.output_paths import refuse_devices
    from rcj_challenges.match.batch import Job
    from rcj_challenges.records.folder import make_out_folder

    refuse_devices(out=out)
    played_seeds = dict.fromkeys(parse_seeds(seeds))
    # Errors of teams are reported once here, not for each seed.
    programs = {seat: opened.digest for seat, opened in open_teams(loaded, teams).items()}
    require_layers(sandbox)
    make_out_folder(out, "the records")
    arguments = [scenario, "--out", str(out), "--no-replay", "--quiet", "--sandbox", sandbox]
    arguments += [part for team in teams for part in ("--team", team)]
    arguments += [part for entry in overrides for part in ("--set", entry)]
    jobs = [Job(seed, tuple(arguments)) for seed in played_seeds]
    return jobs, _known(jobs, loaded, programs, out)


def _known(jobs: Sequence[Job], loaded: Loaded, programs: Mapping[str, str], out: Path) -> dict[int, Outcome]:
    """Outcomes of jobs that have a complete record, by seed.

    Matches that were played with other versions, or decided by a time limit, are played again.
    """
    from rcj_challenges.match.batch import Outcome
    from rcj_challenges.records.digest import inputs_digest
    from rcj_challenges.records.errors import RecordError
    from rcj_challenges.records.folder import RESULT, read_file
    from rcj_challenges.records.lines import parsed
    from rcj_challenges.records.result import has_time_fault, versions

    now = versions().model_dump()
    by_seed = {job.seed: job for job in jobs}
    found: dict[int, Outcome] = {}
    for path in sorted(out.glob(f"*/{RESULT}")):
        try:
            result = parsed(read_file(path))
            is_usable = result["complete"] and result["versions"] == now and not has_time_fault(result)
            job = by_seed.get(result["seed"]) if is_usable and not result["marks"] else None
            if job is not None and result["inputs"] == inputs_digest(loaded.scenario, job.seed, programs):
                found[job.seed] = Outcome(job, {**result, "folder": str(path.parent)})
        except (RecordError, ValueError, KeyError, TypeError):
            continue  # a record that is damaged, or of another version
    return found


def parse_seeds(text: str) -> list[int]:
    """Seeds of ``1..10``, ``3`` or ``1,4,7..9``.

    Raises:
        RcjError: it is none of these.
    """
    seeds: list[int] = []
    for part in text.split(","):
        first, dots, last = part.strip().partition("..")
        if not first.isdecimal() or (dots and not last.isdecimal()) or max(len(first), len(last)) > _MAX_DIGITS:
            raise RcjError(f"--seeds {sanitize(text)}: not seeds", "write 1..10, 3 or 1,4,7..9", code=BAD_SEEDS)
        begin, end = int(first), int(last if dots else first)
        if not 0 <= begin <= end < begin + _MAX_SEEDS:
            help_ = f"write {end}..{begin}" if end < begin else "play them in several parts"
            message = f"--seeds {sanitize(text)}: {sanitize(part)} is empty or more than {_MAX_SEEDS} seeds"
            raise RcjError(message, help_, code=BAD_SEEDS)
        seeds += range(begin, end + 1)
    return seeds


def summary(outcomes: Sequence[Outcome]) -> dict[str, Any]:
    """Scores and records by seed, the scores' spread by entrant, and counts of events and faults."""
    played = [(outcome.job.seed, outcome.result) for outcome in outcomes if outcome.result is not None]
    results = [result for _, result in played]
    entrants = list(results[0]["score"]) if results else []
    return {
        "played": len(results),
        "failed": [{"seed": o.job.seed, "message": o.complaint[-2000:]} for o in outcomes if o.result is None],
        "scores": [{"seed": seed, **result["score"]} for seed, result in played],
        "records": [{"seed": seed} | {key: result[key] for key in _OF_RECORDS} for seed, result in played],
        "spread": {entrant: _spread([result["score"][entrant] for result in results]) for entrant in entrants},
        "events": dict(Counter(event["event"] for result in results for event in result["events"]).most_common()),
        "faults": dict(
            Counter(
                f"{fault['robot']} {fault['kind']}" for result in results for fault in result["faults"]
            ).most_common()
        ),
    }


def rank_summary(rank: Sequence[Ranked], outcomes: Sequence[Outcome]) -> dict[str, Any]:
    """Ranking by seed, how often each entrant had which place, and the spread of what was compared.

    Where the shortest time is best, a match that no rule ended was not finished: its time is only the time played. In
    the spread such matches come last, as None, and ``unfinished`` counts them.

    Args:
        rank: the scenario's criteria; ``spread`` has a value for each, in their order, and so have the rankings.
        outcomes: of all matches; those that could not be played are left out.
    """
    from rcj_challenges.views.scoreboard import criterion_name

    results = [(outcome.job.seed, outcome.result) for outcome in outcomes if outcome.result is not None]
    entries = [
        (entry["team"], entry, all(half["ended"] for half in result["halves"]))
        for _, result in results
        for entry in result["ranking"]
    ]
    places = grouped((team, entry["place"]) for team, entry, _ in entries)
    found = grouped(
        (team, [value if ended or not one.is_time else None for one, value in zip(rank, entry["values"], strict=True)])
        for team, entry, ended in entries
    )
    return {
        "criteria": [criterion_name(criterion) for criterion in rank],
        "matches": [{"seed": seed, "ranking": result["ranking"]} for seed, result in results],
        "places": {
            team: {str(place): count for place, count in sorted(Counter(own).items())} for team, own in places.items()
        },
        "spread": {team: [_spread(values) for values in zip(*own, strict=True)] for team, own in found.items()},
    }


def _spread(values: Sequence[float | None]) -> dict[str, float | None]:
    """Spread of values; None is worse than all, and counted if there is one."""
    known = [value for value in values if value is not None]
    missing = len(values) - len(known)
    ordered = [*known, *[math.inf] * missing]
    mean = round(statistics.fmean(known), 3) if known else math.inf
    spread = {"least": min(ordered), "median": statistics.median(ordered), "mean": mean, "most": max(ordered)}
    found = {name: value if math.isfinite(value) else None for name, value in spread.items()}
    return found | ({"unfinished": missing} if missing else {})


class Progress:
    """Prints a line for each match that is over, and keeps the outcomes."""

    def __init__(self, console: Console, total: int, known: Sequence[Outcome], *, quiet: bool) -> None:
        self.outcomes = list(known)
        self._known = len(known)
        self._console = console
        self._total = total
        self._quiet = quiet
        self._began = time.perf_counter()
        if known and not quiet:
            line = f"{len(known)} of {counted(total, 'match', 'matches')} have been played before, and count"
            print_progress(console, line)

    def done(self, outcome: Outcome) -> None:
        """Count a match and print how it ended."""
        self.outcomes.append(outcome)
        if self._quiet:
            return
        count = len(self.outcomes)
        left_s = (time.perf_counter() - self._began) / (count - self._known) * (self._total - count)
        score = "could not be played" if outcome.result is None else str(list(outcome.result["score"].values()))
        line = f"{count}/{self._total}  seed {outcome.job.seed}  {score}  done in about {left_s:.0f} s"
        print_progress(self._console, line)


def _report(outcomes: Sequence[Outcome], rank: Sequence[Ranked], *, as_json: bool) -> None:
    from rcj_challenges.views.console import console_for
    from rcj_challenges.views.scoreboard import decided_by_score_alone

    report = summary(outcomes)
    if not decided_by_score_alone(rank):
        report["ranking"] = rank_summary(rank, outcomes)
    if as_json:
        print_json(report)
        return
    console = console_for()
    console.print(_score_table(report))
    if "ranking" in report:
        console.print(_rank_table(report["ranking"], rank))
    for head in ("events", "faults"):
        counts = ", ".join(f"{name} {count}" for name, count in report[head].items()) or "none"
        console.print(f"{head}: {counts}", markup=False, highlight=False)
    for failure in report["failed"]:
        console.print(f"seed {failure['seed']}: {failure['message']}", markup=False, highlight=False)


def _score_table(report: dict[str, Any]) -> Table:
    from rich.table import Table

    table = Table("entrant", "least", "median", "mean", "most", title=counted(report["played"], "match", "matches"))
    for entrant, spread in report["spread"].items():
        table.add_row(entrant, *map(number_words, spread.values()))
    return table


def _rank_table(ranking: dict[str, Any], rank: Sequence[Ranked]) -> Table:
    """A row for each entrant, a column for each place and for each criterion beside the score."""
    from rich.table import Column, Table

    from rcj_challenges.views.scoreboard import criterion_words

    places = sorted({place for own in ranking["places"].values() for place in own}, key=int)
    beside = [(index, criterion) for index, criterion in enumerate(rank) if not criterion.is_score]
    heads = [
        "entrant",
        *(f"place {place}" for place in places),
        *(criterion_words(criterion) for _, criterion in beside),
    ]
    table = Table(*(Column(head, overflow="fold") for head in heads), title="what decides")
    for entrant, own in ranking["places"].items():
        table.add_row(
            entrant,
            *(times(own.get(place, 0)) for place in places),
            *(_spread_words(ranking["spread"][entrant][index]) for index, _ in beside),
        )
    return table


def _spread_words(spread: dict[str, float | None]) -> str:
    values = (spread[name] for name in ("least", "median", "most"))
    least, median, most = ("unfinished" if value is None else number_words(value) for value in values)
    return least if least == most else f"{least} to {most}, median {median}"
