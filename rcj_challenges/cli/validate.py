"""``rcj-challenge validate``: prints of each file that it is in order, or everything that is wrong with it."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Annotated, Any

import typer

from rcj_challenges.cli.app import WRITE, app
from rcj_challenges.cli.codes import SET_ON_TOURNAMENT
from rcj_challenges.cli.options import Json, Overrides, complete_scenarios
from rcj_challenges.cli.stdio import print_json, print_safely, shown_path
from rcj_challenges.core.amounts import counted
from rcj_challenges.core.diagnostics import Diagnostic, DiagnosticError, InFile
from rcj_challenges.core.sanitize import sanitize


@app.register(WRITE, "rcj-challenge validate relay_race.yaml")
def validate(
    files: Annotated[
        list[str],
        typer.Argument(
            metavar="FILE...",
            autocompletion=complete_scenarios,
            help="Scenario and tournament files, or names of shipped ones.",
        ),
    ],
    set_: Overrides = None,
    strict: Annotated[bool, typer.Option("--strict", help="Exit with 1 if there is a warning; for CI.")] = False,
    json_: Json = False,
) -> int:
    """Check scenario and tournament files; report mistakes and warnings with file, line and column."""
    from rcj_challenges.tournament.recognize import is_tournament

    code = 0
    reports: list[dict[str, Any]] = []
    for path in files:
        report: dict[str, Any] = {"file": path, "ok": True, "problems": [], "findings": []}
        reports.append(report)
        try:
            summary, findings = (_tournament if is_tournament(path) else _scenario)(path, set_ or [])
        except DiagnosticError as error:
            print_safely("" if json_ else str(error), to_stderr=True)
            report |= {"ok": False, "problems": [flat(problem) for problem in error.diagnostics]}
            code = max(code, error.exit_code)
            continue
        report |= {"summary": summary, "findings": [finding.to_json() for finding in findings]}
        is_refused = strict and bool(findings)
        code = max(code, int(is_refused))
        if not json_:
            warned = f"; {counted(len(findings), 'warning')}" if findings else ""
            verdict = "no" if is_refused else "ok"
            print_safely(f"{verdict}  {shown_path(path)}: {sanitize(summary, 500)}{warned}")
            for finding in findings:
                print_safely(str(finding), to_stderr=True)
    if json_:
        print_json({"files": reports})
    return code


def flat(diagnostic: Diagnostic) -> dict[str, Any]:
    """A problem as data, with its place."""
    where = diagnostic.where if isinstance(diagnostic.where, InFile) else InFile("")
    place = {"file": where.file, "line": where.line or 0, "column": where.column or 0, "path": where.path}
    return {**place, "message": diagnostic.message, "code": diagnostic.code, "help": diagnostic.help}


def _scenario(path: str, overrides: Sequence[str]) -> tuple[str, Sequence[Diagnostic]]:
    """Summary of a scenario file (title, how much of what, how long) and its warnings.

    Raises:
        ScenarioError: it cannot be used.
    """
    from rcj_challenges.scenario.halves import half_lengths_s
    from rcj_challenges.scenario.lint.registry import lint
    from rcj_challenges.scenario.load import load

    loaded = load(path, overrides)
    scenario = loaded.scenario
    lengths_s = half_lengths_s(scenario.match)
    alike = len(set(lengths_s)) == 1
    halves = f"{len(lengths_s)} x " if alike and len(lengths_s) > 1 else ""
    lengths = " + ".join(f"{one:g}" for one in (lengths_s[:1] if alike else lengths_s))
    counts = ", ".join(
        (
            counted(len(scenario.robots), "robot"),
            counted(len(scenario.entrants), "entrant"),
            counted(len(scenario.rules), "rule"),
            counted(len(scenario.expect), "test"),
        )
    )
    return f"{scenario.title} ({counts}; {halves}{lengths} s)", lint(loaded)


def _tournament(path: str, overrides: Sequence[str]) -> tuple[str, Sequence[Diagnostic]]:
    """Summary of a tournament file and its warnings.

    Raises:
        DiagnosticError: it cannot be used, or there are overrides.
    """
    from rcj_challenges.tournament.engine import Season
    from rcj_challenges.tournament.load import load_tournament

    if overrides:
        message = "--set changes scenarios, and this is a tournament"
        raise DiagnosticError(Diagnostic(SET_ON_TOURNAMENT, message, "write it under 'set' in the file", InFile(path)))
    loaded = load_tournament(path)
    stages = Season(loaded).state({}).stages
    counts = (
        counted(len(loaded.entries), "team"),
        counted(len(stages), "stage"),
        counted(sum(stage.expected_matches for stage in stages), "match", "matches"),
    )
    return f"{loaded.tournament.title} ({', '.join(counts)})", loaded.warnings
