"""``rcj-challenge test``: plays the ``expect`` blocks of scenarios, without physics and without programs."""

from __future__ import annotations

import sys
import time
from collections.abc import Sequence
from typing import Any

from rcj_challenges.cli.stdio import print_json, say, shown_path
from rcj_challenges.cli.validate import flat
from rcj_challenges.core.amounts import counted
from rcj_challenges.core.sanitize import sanitize
from rcj_challenges.core.timing import s_from_ticks
from rcj_challenges.expect.runner import run_test
from rcj_challenges.scenario.errors import ScenarioError
from rcj_challenges.scenario.load import Loaded, load
from rcj_challenges.scenario.reading.inherited_tests import TESTS
from rcj_challenges.scenario.tree import file_of

_WALL_DIGITS = 4


def run_tests(paths: Sequence[str], overrides: Sequence[str], *, as_json: bool = False) -> int:
    """Play all ``expect`` blocks of scenario files and say what came out differently.

    Args:
        paths: files, or names of shipped scenarios.
        overrides: ``PATH=VALUE`` each, applied to every file.
        as_json: print one JSON object and nothing else.

    Returns:
        2 if a file cannot be used (the others are played all the same); else 1 if something is not as expected; else 0.
    """
    code = 0
    reports: list[dict[str, Any]] = []
    for path in paths:
        try:
            loaded = load(path, overrides)
        except ScenarioError as error:
            reports.append(_unusable(path, error))
            code = ScenarioError.exit_code
            say("" if as_json else str(error), sys.stderr)
        else:
            reports.append(_report(path, loaded))
            code = max(code, 0 if reports[-1]["passed"] else 1)
            if not as_json:
                _show(reports[-1])
    if as_json:
        passed = all(report["passed"] for report in reports)
        print_json({"passed": passed, "files": reports})
    else:
        _show_sum(reports)
    return code


def _unusable(path: str, error: ScenarioError) -> dict[str, Any]:
    problems = [flat(problem) for problem in error.diagnostics]
    nothing: dict[str, Any] = {"tests": [], "left_out": {}, "untested_rules": []}
    return {"file": path, "title": None, "passed": False, "problems": problems, **nothing}


def _report(path: str, loaded: Loaded) -> dict[str, Any]:
    """Play all tests of a file; return what came out."""
    tests: list[dict[str, Any]] = []
    fired: set[str] = set()
    for name in loaded.scenario.expect:
        began = time.perf_counter()
        result = run_test(loaded, name)
        fired.update(result.fired)
        tests.append(
            {
                "name": name,
                "passed": not result.differences,
                "inherited_from": _inherited_from(loaded, name),
                "differences": list(result.differences),
                "simulated_s": s_from_ticks(result.ticks),
                "wall_s": round(time.perf_counter() - began, _WALL_DIGITS),
                "rules": list(result.fired),
            }
        )
    return {
        "file": path,
        "title": loaded.scenario.title,
        "passed": all(test["passed"] for test in tests),
        "problems": [],
        "tests": tests,
        "left_out": {name: f"{one.where}: {one.message}" for name, one in loaded.left_out.items()},
        "untested_rules": [name for name in loaded.scenario.rules if name not in fired],
    }


def _inherited_from(loaded: Loaded, name: str) -> str | None:
    """Return the file from which a test is inherited, None for one of the scenario's own."""
    written = loaded.written
    file = "" if written is None else file_of(written, TESTS, name)
    return None if written is None or file == written.mark.file else file


def _show(report: dict[str, Any]) -> None:
    say(f"{shown_path(report['file'])}: {sanitize(report['title'])}", sys.stdout)
    if not report["tests"]:
        say("  no tests: add expect: (docs/authoring.md says how)", sys.stdout)
    for test in report["tests"]:
        say(f"  {'ok  ' if test['passed'] else 'FAIL'}  {test['name']} ({test['simulated_s']:g} s)", sys.stdout)
        if test["inherited_from"] and not test["passed"]:
            origin = f"inherited from {test['inherited_from']}"
            say(f"          {origin}: replace it, or remove it by '{test['name']}: null' under expect", sys.stdout)
        for difference in test["differences"]:
            say(f"          {difference}", sys.stdout)
    for name, reason in report["left_out"].items():
        say(f"  left out: {name}, an inherited test that does not fit any more ({reason})", sys.stdout)
    if report["tests"] and report["untested_rules"]:
        say(f"  no test sets off: {', '.join(report['untested_rules'])}", sys.stdout)


def _show_sum(reports: list[dict[str, Any]]) -> None:
    tests = [test for report in reports for test in report["tests"]]
    failed = sum(not test["passed"] for test in tests)
    simulated = sum(test["simulated_s"] for test in tests)
    wall = sum(test["wall_s"] for test in tests)
    speed = f" in {wall:.2f} s ({simulated / wall:.0f} x real time)" if wall else ""
    verdict = f"{failed} of {len(tests)} failed" if failed else f"all {len(tests)} passed" if tests else "no tests"
    unusable = sum(bool(report["problems"]) for report in reports)
    if unusable < len(reports):
        say(f"{verdict}; {simulated:.0f} s played{speed}", sys.stdout)
    if unusable:
        say(f"{unusable} of {counted(len(reports), 'file')} cannot be used", sys.stdout)
