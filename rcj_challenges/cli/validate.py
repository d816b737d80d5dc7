"""``rcj-challenge validate``: prints of each file that it is in order, or everything that is wrong with it."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from typing import Any

from rcj_challenges.cli.stdio import print_json, say, shown_path
from rcj_challenges.core.amounts import counted
from rcj_challenges.core.diagnostics import Diagnostic, DiagnosticError, InFile
from rcj_challenges.core.sanitize import sanitize
from rcj_challenges.scenario.errors import ScenarioError
from rcj_challenges.scenario.halves import half_lengths_s
from rcj_challenges.scenario.lint.registry import lint
from rcj_challenges.scenario.load import Loaded, load
from rcj_challenges.tournament.recognize import is_tournament


def validate_files(
    paths: Sequence[str], overrides: Sequence[str], *, strict: bool = False, as_json: bool = False
) -> int:
    """Check scenario and tournament files; print a line for each that is in order, its lint, and all other problems.

    Args:
        paths: files, or names of shipped scenarios and tournaments.
        overrides: ``PATH=VALUE`` each, applied to every scenario.
        strict: whether findings of lint are a negative verdict.
        as_json: print one JSON object instead, with a list of files.

    Returns:
        2 if one cannot be used; else 1 if ``strict`` and lint found something; else 0.
    """
    code = 0
    reports: list[dict[str, Any]] = []
    for path in paths:
        report: dict[str, Any] = {"file": path, "ok": True, "problems": [], "findings": []}
        if is_tournament(path):
            found, one = _of_tournament(path, overrides, strict=strict, as_json=as_json)
        else:
            found, one = _of_scenario(path, overrides, strict=strict, as_json=as_json)
        code = max(code, one)
        reports.append(report | found)
    if as_json:
        print_json({"files": reports})
    return code


def _of_scenario(path: str, overrides: Sequence[str], *, strict: bool, as_json: bool) -> tuple[dict[str, Any], int]:
    """Print the verdict on a scenario file; return its part of the report and the exit code."""
    try:
        loaded = load(path, overrides)
    except ScenarioError as error:
        say("" if as_json else str(error), sys.stderr)
        return {"ok": False, "problems": [flat(problem) for problem in error.diagnostics]}, error.exit_code
    return _verdict(path, _summary(loaded), lint(loaded), strict=strict, as_json=as_json)


def _verdict(
    path: str, summary: str, findings: Sequence[Diagnostic], *, strict: bool, as_json: bool
) -> tuple[dict[str, Any], int]:
    """Print the verdict on a file that can be used; return its part of the report and the exit code."""
    if not as_json:
        warned = f"; {counted(len(findings), 'warning')}" if findings else ""
        verdict = "no" if strict and findings else "ok"
        say(f"{verdict}  {shown_path(path)}: {sanitize(summary, 500)}{warned}", sys.stdout)
        for finding in findings:
            say(str(finding), sys.stderr)
    report = {"summary": summary, "findings": [finding.to_json() for finding in findings]}
    return report, 1 if strict and findings else 0


def _of_tournament(path: str, overrides: Sequence[str], *, strict: bool, as_json: bool) -> tuple[dict[str, Any], int]:
    """Print the verdict on a tournament file; return its part of the report and the exit code."""
    from rcj_challenges.tournament.engine import Season
    from rcj_challenges.tournament.load import load_tournament

    try:
        if overrides:
            message = "--set changes scenarios, and this is a tournament"
            raise DiagnosticError(
                Diagnostic("set-on-tournament", message, "write it under 'set' in the file", InFile(path))
            )
        loaded = load_tournament(path)
    except DiagnosticError as error:
        say("" if as_json else str(error), sys.stderr)
        return {"ok": False, "problems": [flat(one) for one in error.diagnostics]}, error.exit_code
    stages = Season(loaded).state({}).stages
    counts = (
        counted(len(loaded.entries), "team"),
        counted(len(stages), "stage"),
        counted(sum(stage.expected_matches for stage in stages), "match", "matches"),
    )
    summary = f"{loaded.tournament.title} ({', '.join(counts)})"
    return _verdict(path, summary, loaded.warnings, strict=strict, as_json=as_json)


def flat(diagnostic: Diagnostic) -> dict[str, Any]:
    """Return a problem as data, with its place."""
    where = diagnostic.where if isinstance(diagnostic.where, InFile) else InFile("")
    place = {"file": where.file, "line": where.line or 0, "column": where.column or 0, "path": where.path}
    return {**place, "message": diagnostic.message, "code": diagnostic.code, "help": diagnostic.help}


def _summary(loaded: Loaded) -> str:
    """Return what stands in a scenario: title, how much of what, how long."""
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
    return f"{scenario.title} ({counts}; {halves}{lengths} s)"
