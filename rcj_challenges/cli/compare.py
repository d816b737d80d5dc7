"""``rcj-challenge compare``: did a change of a team help?"""

from __future__ import annotations

import os
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from rcj_challenges.cli import OK, OUR_FAULT, options
from rcj_challenges.cli.app import PLAY, app
from rcj_challenges.cli.codes import OPTION_DOES_NOT_FIT
from rcj_challenges.cli.simulate import Progress, prepared
from rcj_challenges.cli.stdio import print_json, print_lines
from rcj_challenges.core.amounts import counted, number_words
from rcj_challenges.core.errors import RcjError

if TYPE_CHECKING:
    from rcj_challenges.match.batch import Job, Outcome
    from rcj_challenges.scenario.models.scenario import Scenario

_VERSIONS = ("new", "old")
_REPLAYS = 3


@app.register(PLAY, "rcj-challenge compare my_team old_team --against ball_chaser")
def compare(
    new: Annotated[str, typer.Argument(metavar="NEW", help="The changed team.", autocompletion=options.complete_teams)],
    old: Annotated[str, typer.Argument(metavar="OLD", help="The team before.", autocompletion=options.complete_teams)],
    against: Annotated[
        str | None,
        typer.Option("--against", metavar="TEAM", help="The opponent.", autocompletion=options.complete_teams),
    ] = None,
    scenario: Annotated[
        str,
        typer.Option(
            "--scenario", metavar="SCENARIO", help="What is played.", autocompletion=options.complete_scenarios
        ),
    ] = "match",
    seeds: options.Seeds = "1..20",
    duration: options.Duration = None,
    halves: options.Halves = None,
    set_: options.Overrides = None,
    out: options.OutFolder = Path("runs"),
    at_once: options.AtOnce = None,
    json_: options.Json = False,
    quiet: options.Quiet = False,
    sandbox: options.Sandbox = "auto",
) -> int:
    """Compare two versions of a team: same seeds, opponent and seat. Is the difference more than chance?"""
    from rcj_challenges.scenario.load import load

    overrides = options.all_overrides(set_, duration, halves)
    loaded = load(scenario, overrides)
    *others, team = loaded.scenario.entrants
    if bool(others) != (against is not None):
        help_ = "give --against TEAM" if others else "leave out --against"
        message = f"{loaded.scenario.id} has {counted(len(others), 'opponent')}"
        raise RcjError(message, help_, code=OPTION_DOES_NOT_FIT)
    # Both have the seat of the scenario's last entrant.
    (new_jobs, new_known), (old_jobs, old_known) = (
        prepared(
            loaded, scenario, seeds, [f"{team}={version}", *(f"{other}={against}" for other in others)], overrides, out,
            sandbox
        )
        for version in (new, old)
    )  # fmt: skip
    known = [*new_known.values(), *old_known.values()]
    outcomes = _played([*new_jobs, *old_jobs], known, at_once or os.cpu_count() or 1, quiet=quiet or json_)
    failed = [outcome for outcome in outcomes.values() if outcome.result is None]
    played = [
        {"seed": one.seed, "new": outcomes[one].result, "old": outcomes[other].result}
        for one, other in zip(new_jobs, old_jobs, strict=True)
        if outcomes[one].result is not None and outcomes[other].result is not None
    ]
    if not played:
        raise RcjError(failed[0].complaint)
    report = _report(played, team, loaded.scenario)
    report["failed"] = [{"seed": outcome.job.seed, "message": outcome.complaint[-2000:]} for outcome in failed]
    print_json(report) if json_ else _print(report, {"new": new, "old": old})
    return OUR_FAULT if failed else OK


def _played(jobs: Iterable[Job], known: Sequence[Outcome], at_once: int, *, quiet: bool) -> dict[Job, Outcome]:
    """Play what is not known; then, one at a time, what a busy computer may have spoilt."""
    from rcj_challenges.match.worker_pool import run_all
    from rcj_challenges.records.result import has_time_fault
    from rcj_challenges.views.console import console_for

    outcomes = {outcome.job: outcome for outcome in known}
    todo = [job for job in dict.fromkeys(jobs) if job not in outcomes]
    total = len(outcomes) + len(todo)
    progress = Progress(console_for(to_stderr=True), total, known, quiet=quiet)
    played = run_all(todo, at_once, progress.done)
    again = [outcome.job for outcome in played if outcome.result is None or has_time_fault(outcome.result)]
    played += run_all(again, 1, lambda _: None)
    return outcomes | {outcome.job: outcome for outcome in played}


def _report(played: Sequence[dict[str, Any]], team: str, scenario: Scenario) -> dict[str, Any]:
    """Write the replays of the seeds that differ most; return what is printed as JSON."""
    from rcj_challenges.cli.run_report import score_lines
    from rcj_challenges.match.comparison import gains, sign_test, tally
    from rcj_challenges.views.replay import write_replay

    rank = scenario.result.rank
    seeds = []
    for one in played:
        seeds.append({"seed": one["seed"], "gains": gains(one["new"], one["old"], team, rank)})
        for version in _VERSIONS:
            result = {"words": "; ".join(score_lines(scenario, one[version]))}
            seeds[-1][version] = result | {key: one[version][key] for key in ("score", "folder")}
    differing = [seed for seed in seeds if any(seed["gains"])]
    for seed in sorted(differing, key=lambda seed: [-abs(gain) for gain in seed["gains"]])[:_REPLAYS]:
        for version in _VERSIONS:
            seed[version]["replay"] = str(write_replay(Path(seed[version]["folder"])))
    better = sum(seed["gains"] > (0,) * len(rank) for seed in differing)
    return {
        **sign_test(better, len(differing) - better, len(seeds) - len(differing)),
        **{version: tally([one[version] for one in played], team) for version in _VERSIONS},
        "seeds": seeds,
    }


def _print(report: dict[str, Any], paths: dict[str, str]) -> None:
    from rich.table import Table

    from rcj_challenges.views.console import console_for

    console = console_for()
    table = Table("", *report["new"])
    for version, path in paths.items():
        table.add_row(f"{version}: {path}", *map(number_words, report[version].values()))
    console.print(table, markup=False)
    for failure in report["failed"]:
        print_lines(console, f"seed {failure['seed']}: {failure['message']}")
    for seed in report["seeds"]:
        for name in paths if "replay" in seed["new"] else ():
            print_lines(console, f"seed {seed['seed']}, {name}: {seed[name]['words']}", f"  {seed[name]['replay']}")
    low, high = report["interval"]
    print_lines(console, f"better with {low:.0%} to {high:.0%} of the seeds that differ (95 % confidence)")
    print_lines(console, report["sentence"])
