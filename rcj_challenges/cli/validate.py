"""``rcj-challenge validate``: says of each file that it is in order, or everything that is wrong with it."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from dataclasses import asdict
from typing import Any

from rcj_challenges.cli.says import say_json, say_no_more
from rcj_challenges.facts.amounts import counted
from rcj_challenges.facts.letters import READABLE
from rcj_challenges.scenario.errors import ScenarioError
from rcj_challenges.scenario.halves import half_lengths_s
from rcj_challenges.scenario.lint.registry import lint
from rcj_challenges.scenario.load import Loaded, load


def validate_files(
    paths: Sequence[str], overrides: Sequence[str], *, strict: bool = False, as_json: bool = False
) -> int:
    """Check scenario files; print a line for each that is in order, its lint, and each problem of the others.

    Args:
        paths: files, or names of shipped scenarios.
        overrides: ``PATH=VALUE`` each, applied to every file.
        strict: whether findings of lint are a negative verdict.
        as_json: print one JSON object instead, with a list of files.

    Returns:
        2 if one cannot be used; else 1 if ``strict`` and lint found something; else 0.
    """
    code = 0
    reports: list[dict[str, Any]] = []
    for path in paths:
        report: dict[str, Any] = {"file": path, "ok": True, "problems": [], "findings": []}
        try:
            loaded = load(path, overrides)
        except ScenarioError as error:
            report |= {"ok": False, "problems": [asdict(problem) for problem in error.problems]}
            code = ScenarioError.exit_code
            say("" if as_json else str(error), sys.stderr)
        else:
            findings = lint(loaded)
            report |= {"summary": _summary(loaded), "findings": [finding.to_json() for finding in findings]}
            code = max(code, 1 if strict and findings else 0)
            if not as_json:
                warned = f"; {counted(len(findings), 'warning')}" if findings else ""
                verdict = "no" if strict and findings else "ok"
                say(f"{verdict}  {path}: {_summary(loaded)}{warned}", sys.stdout)
                for finding in findings:
                    say(str(finding), sys.stderr)
        reports.append(report)
    if as_json:
        say_json({"files": reports})
    return code


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


def say(text: str, stream: object) -> None:
    """Print a line; of a text that is empty nothing. Who reads no more of it changes nothing about the exit code."""
    if not text:
        return
    # A terminal that cannot show a character must not hide the whole message.
    write = getattr(stream, "write")  # noqa: B009 - sys.stdout may be replaced by anything that writes
    encoding = getattr(stream, "encoding", None) or "utf-8"
    try:
        write(text.encode(encoding, READABLE).decode(encoding) + "\n")
    except BrokenPipeError:
        say_no_more(stream)
