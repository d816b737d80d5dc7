"""``rcj-challenge test``: plays the ``expect`` blocks of scenarios, without physics and without programs."""

from __future__ import annotations

import time
from typing import TYPE_CHECKING, Annotated, Any

import typer

from rcj_challenges.cli.app import WRITE, app
from rcj_challenges.cli.options import Json, Overrides, complete_scenarios
from rcj_challenges.cli.stdio import print_json, print_safely, shown_path
from rcj_challenges.cli.validate import flat
from rcj_challenges.core.amounts import counted
from rcj_challenges.core.sanitize import sanitize
from rcj_challenges.core.timing import s_from_ticks

if TYPE_CHECKING:
    from rcj_challenges.scenario.load import Loaded

_WALL_DIGITS = 4


@app.register(WRITE, "rcj-challenge test relay_race.yaml", name="test")
def play_tests(
    files: Annotated[
        list[str],
        typer.Argument(
            metavar="FILE...", autocompletion=complete_scenarios, help="Scenario files, or names of shipped ones."
        ),
    ],
    set_: Overrides = None,
    json_: Json = False,
) -> int:
    """Play the tests written in scenario files (expect:), without physics and without programs.

    All files are played, even after one that cannot be used. Exit status 0: all as expected; 1: a test failed;
    2: a file cannot be used, whatever the result of the others.
    """
    from rcj_challenges.scenario.errors import ScenarioError
    from rcj_challenges.scenario.load import load

    code = 0
    reports: list[dict[str, Any]] = []
    for path in files:
        report: dict[str, Any] = {"file": path, "title": None, "passed": False, "problems": []}
        try:
            report |= _played(load(path, set_ or []))
        except ScenarioError as error:
            report["problems"] = [flat(problem) for problem in error.diagnostics]
            report |= {"tests": [], "left_out": {}, "untested_rules": []}
            print_safely("" if json_ else str(error), to_stderr=True)
        else:
            if not json_:
                _show(report)
        code = max(code, ScenarioError.exit_code if report["problems"] else int(not report["passed"]))
        reports.append(report)
    if json_:
        print_json({"passed": all(report["passed"] for report in reports), "files": reports})
    else:
        _show_sum(reports)
    return code


def _played(loaded: Loaded) -> dict[str, Any]:
    """Play all tests of a file; return its part of the report."""
    from rcj_challenges.expect.runner import run_test

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
        "title": loaded.scenario.title,
        "passed": all(test["passed"] for test in tests),
        "tests": tests,
        "left_out": {name: f"{one.where}: {one.message}" for name, one in loaded.left_out.items()},
        "untested_rules": [name for name in loaded.scenario.rules if name not in fired],
    }


def _inherited_from(loaded: Loaded, name: str) -> str | None:
    """The file from which a test is inherited; None for one of the scenario's own."""
    from rcj_challenges.scenario.reading.merge import TESTS
    from rcj_challenges.scenario.tree import mark_of

    written = loaded.written
    file = "" if written is None else mark_of(written, (TESTS, name), at_key=True).file
    return None if written is None or file == written.mark.file else file


def _show(report: dict[str, Any]) -> None:
    print_safely(f"{shown_path(report['file'])}: {sanitize(report['title'])}")
    if not report["tests"]:
        print_safely("  no tests: add expect: (docs/authoring.md says how)")
    for test in report["tests"]:
        print_safely(f"  {'ok  ' if test['passed'] else 'FAIL'}  {test['name']} ({test['simulated_s']:g} s)")
        if test["inherited_from"] and not test["passed"]:
            origin = f"inherited from {test['inherited_from']}"
            print_safely(f"          {origin}: replace it, or remove it by '{test['name']}: null' under expect")
        for difference in test["differences"]:
            print_safely(f"          {difference}")
    for name, reason in report["left_out"].items():
        print_safely(f"  left out: {name}, an inherited test that does not fit any more ({reason})")
    if report["tests"] and report["untested_rules"]:
        print_safely(f"  no test sets off: {', '.join(report['untested_rules'])}")


def _show_sum(reports: list[dict[str, Any]]) -> None:
    tests = [test for report in reports for test in report["tests"]]
    failed = sum(not test["passed"] for test in tests)
    simulated = sum(test["simulated_s"] for test in tests)
    wall = sum(test["wall_s"] for test in tests)
    speed = f" in {wall:.2f} s ({simulated / wall:.0f} x real time)" if wall else ""
    verdict = f"{failed} of {len(tests)} failed" if failed else f"all {len(tests)} passed" if tests else "no tests"
    unusable = sum(bool(report["problems"]) for report in reports)
    if unusable < len(reports):
        print_safely(f"{verdict}; {simulated:.0f} s played{speed}")
    if unusable:
        print_safely(f"{unusable} of {counted(len(reports), 'file')} cannot be used")
