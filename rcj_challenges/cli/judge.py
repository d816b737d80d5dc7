"""``rcj-challenge judge``: the referee's verdict on a recorded match, by its own rules or by others."""

from __future__ import annotations

import sys
from collections.abc import Iterator, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from rcj_challenges.cli.app import ORGANIZE, app
from rcj_challenges.cli.options import Json, Overrides, Runs, RunsFolder, complete_scenarios
from rcj_challenges.cli.stdio import print_json, print_lines
from rcj_challenges.core.amounts import Noun, counted
from rcj_challenges.core.diagnostics import render_error
from rcj_challenges.core.errors import RcjError
from rcj_challenges.core.sanitize import sanitize
from rcj_challenges.core.timing import s_from_ticks

if TYPE_CHECKING:
    from rcj_challenges.match.rejudge import Difference, Judgement, Score
    from rcj_challenges.records.result import RunResult
    from rcj_challenges.scenario.models.scenario import Scenario

_MAX_SHOWN = 40
"""Lines about events that differ: a rule that changes the score changes the payloads of all later goals."""


@dataclass(frozen=True)
class _Judged:
    folder: Path
    result: RunResult
    score: dict[str, Score]
    scenario: Scenario
    judgement: Judgement
    alike: int
    differences: list[Difference]

    @property
    def is_as_recorded(self) -> bool:
        """Whether the same came out: events, and of a complete match also scores and ranking."""
        if self.differences or not (self.result.complete and self.judgement.complete):
            return not self.differences
        ranking = [one.model_dump() for one in self.result.ranking]
        return (self.score, ranking) == (self.judgement.scores, self.judgement.ranking)


@app.register(ORGANIZE, "rcj-challenge judge", "rcj-challenge judge --set ball_progress_s=15")
def judge(
    runs: Runs = None,
    scenario: Annotated[
        str | None,
        typer.Option(
            "--scenario",
            metavar="SCENARIO",
            autocompletion=complete_scenarios,
            help="Judge by the rules of this scenario; default: their own.",
        ),
    ] = None,
    set_: Overrides = None,
    out: RunsFolder = Path("runs"),
    json_: Json = False,
) -> int:
    """Judge recorded matches again, by their own rules or by changed ones, and report differences.

    The poses stay those of the record; no program runs. Exit status 0: judged; 1: a record's own rules give a different
    verdict than recorded; 2: a record or a scenario cannot be used.
    """
    from rcj_challenges.scenario.load import load
    from rcj_challenges.views.console import console_for
    from rcj_challenges.views.replay.browse import find_run

    overrides = set_ or []
    rules = None if scenario is None else load(scenario, overrides).scenario
    has_other_rules = scenario is not None or bool(overrides)
    console, code = console_for(), 0
    records: list[dict[str, Any]] = []
    for run in runs or (None,):
        name = None if run is None else run.name
        try:
            folder = find_run(run, out)
            name = folder.name
            judged = _judge_one(folder, rules, overrides)
        except RcjError as error:
            code = RcjError.exit_code
            records.append({"record": name, "problem": str(error), "code": error.code, "help": error.help})
            sys.stderr.write(f"{render_error(error)}\n")
            continue
        if not (judged.is_as_recorded or has_other_rules):
            code = max(code, 1)
        records.append(_as_json(judged))
        if not json_:
            print_lines(console, *_lines(judged, has_other_rules=has_other_rules))
    if json_:
        print_json({"other_rules": has_other_rules, "records": records})
    else:
        print_lines(console, *_closing(records, has_other_rules=has_other_rules))
    return code


def _closing(records: Sequence[dict[str, Any]], *, has_other_rules: bool) -> Iterator[str]:
    """Yield the last lines: how many scores differ, and that poses stay."""
    judged = [one for one in records if one["problem"] is None]
    if len(records) > 1:
        other = sum(one["recorded"]["score"] != one["judged"]["score"] for one in judged)
        left = f"; {len(records) - len(judged)} could not be judged" if len(judged) < len(records) else ""
        yield f"{counted(len(judged), 'record')} judged, {other} of them with another score{left}"
    if judged and has_other_rules:
        yield "Poses remain those of the record: things that these rules would move stay where they were."


def _judge_one(folder: Path, scenario: Scenario | None, overrides: Sequence[str]) -> _Judged:
    from rcj_challenges.match.rejudge import differences, recorded, rejudge
    from rcj_challenges.records.recorded_scenario import read_scenario, read_unresolved
    from rcj_challenges.records.referee_log import log_of_result, read_referee_log
    from rcj_challenges.records.result import read_result
    from rcj_challenges.records.trajectory import Trajectory
    from rcj_challenges.scenario.load import load_recorded

    result = read_result(folder)
    if scenario is None:
        scenario = read_scenario(folder)
        if overrides:
            scenario = load_recorded(scenario.dumped(), read_unresolved(folder), overrides).scenario
    trajectory = Trajectory.open(folder)
    judgement = rejudge(trajectory, scenario)
    log = read_referee_log(folder)
    score, events = recorded(trajectory, log if log.ticks else log_of_result(result), result.score)
    found = differences(events, judgement.events)
    alike = len(judgement.events) - sum(one.after is not None for one in found)
    return _Judged(folder, result, score, scenario, judgement, alike, found)


def _as_json(judged: _Judged) -> dict[str, Any]:
    result, judgement = judged.result, judged.judgement
    return {
        "record": judged.folder.name,
        "problem": None,
        "recorded": {
            "complete": result.complete,
            "score": judged.score,
            "ranking": [one.model_dump() for one in result.ranking],
        },
        "judged": {
            "scenario": judged.scenario.id,
            "complete": judgement.complete,
            "score": judgement.scores,
            "ranking": judgement.ranking,
            "halves": [asdict(half) for half in judgement.halves],
            "events": judgement.events,
        },
        "events_alike": judged.alike,
        "differences": [one.as_json() for one in judged.differences],
    }


def _lines(judged: _Judged, *, has_other_rules: bool) -> Iterator[str]:
    """Yield the lines about a judgement: scores, then each event that differs."""
    from rcj_challenges.views.naming import changes_sides, score_line, shown_names
    from rcj_challenges.views.scoreboard import ranking_lines

    result, judgement, scenario = judged.result, judged.judgement, judged.scenario
    names = {team: entrant.name for team, entrant in result.entrants.items()}
    names = shown_names(names, sides_change=changes_sides(scenario))
    yield sanitize(judged.folder.name)
    yield f"  recorded: {score_line(names, judged.score)}" + ("" if result.complete else "  (not complete)")
    yield f"  judged:   {score_line(names, judgement.scores)}" + (
        "" if judgement.complete else "  (the record ends before the match does)"
    )
    for line in ranking_lines(scenario.result.rank, names, judgement.ranking):
        yield f"            {line}"
    found = judged.differences
    yield from (_line(one, scenario.match.period) for one in found[:_MAX_SHOWN])
    if len(found) > _MAX_SHOWN:
        yield f"  … and {len(found) - _MAX_SHOWN} more: --json has them all"
    missing, new = (sum(getattr(one, side) is None for one in found) for side in ("after", "before"))
    changed = len(found) - missing - new
    otherwise = f", {missing} only in the record, {new} only now, {changed} changed" if found else ""
    yield f"  {'' if found else 'all '}{counted(judged.alike, 'event')} as recorded{otherwise}"
    if not (judged.is_as_recorded or has_other_rules):
        yield "  By its own rules the same should come out: were its files changed, or did another version play it?"


def _line(one: Difference, period: Noun) -> str:
    from rcj_challenges.views.sentences import clock

    when = f"  {period} {one.half} {clock(s_from_ticks(one.tick)):>7}  {sanitize(one.event, 60)}: "
    if one.before is None or one.after is None:
        which = "only now" if one.before is None else "only in the record"
        payload = ", ".join(f"{key} {sanitize(value)}" for key, value in (one.after or one.before or {}).items())
        return when + which + (f" ({payload})" if payload else "")
    keys = [key for key in one.before | one.after if one.before.get(key) != one.after.get(key)]
    return when + ", ".join(f"{key} {sanitize(one.before.get(key))} -> {sanitize(one.after.get(key))}" for key in keys)
