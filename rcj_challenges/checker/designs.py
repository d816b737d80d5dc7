"""The stage *design* of a check: the robots that a team has designed, and what they cost."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from pathlib import PurePosixPath

from rcj_challenges.checker.codes import DESIGN_COST, DESIGN_UNUSED, DESIGN_UNUSED_DEVICE
from rcj_challenges.checker.findings import Stage
from rcj_challenges.core.diagnostics import Diagnostic, DiagnosticError, InFile
from rcj_challenges.core.sanitize import sanitize
from rcj_challenges.match.designs import brought_by, with_designs
from rcj_challenges.scenario.codes import DESIGN_OUT_OF_RANGE
from rcj_challenges.scenario.designs import ROBOT_FILE, Verdict, price_words
from rcj_challenges.scenario.load import Loaded
from rcj_challenges.submissions.team import Team

_MAX_SHOWN = 400
_UNUSED = "this scenario has no guidelines for robots, so robot.yaml is not used"


def check_designs(team: Team, loaded: Loaded) -> Stage:
    """Judge the designs of a team for every seat that has guidelines."""
    scenario, stage = loaded.scenario, Stage("design")
    guided = {
        seat: scenario.guidelines[entrant.design] for seat, entrant in scenario.entrants.items() if entrant.design
    }
    if PurePosixPath(ROBOT_FILE) not in team.files:
        return stage
    if not guided:
        stage.findings.append(Diagnostic(DESIGN_UNUSED, _UNUSED, "", ROBOT_FILE))
    found: dict[Diagnostic, None] = {}
    for seat, guideline in guided.items():
        brought = brought_by(team, seat, scenario)
        for verdict in brought.verdicts if brought is not None else ():
            found |= dict.fromkeys(map(_finding, [*verdict.problems, *verdict.warnings]))
            found |= dict.fromkeys(_unused(team, verdict))
            for design in verdict.designs:
                prices = verdict.prices(design)
                cost = sum(one.points for one in prices)  # integers
                if cost > guideline.budget:
                    continue
                message = f"{design} costs {cost} of {guideline.budget}: {price_words(prices) or 'nothing'}"
                found[Diagnostic(DESIGN_COST, sanitize(message, _MAX_SHOWN), "", ROBOT_FILE)] = None
    stage.findings += found
    if guided and not stage.failed:
        try:
            with_designs(loaded, {next(iter(guided)): team})
        except DiagnosticError as error:  # numbers that nothing here could build
            for one in error.diagnostics:
                stage.findings.append(_finding(replace(one, code=DESIGN_OUT_OF_RANGE, where=InFile(ROBOT_FILE))))
    return stage


def _unused(team: Team, verdict: Verdict) -> Iterator[Diagnostic]:
    """Yield the devices that cost points and whose name is in no program."""
    programs = [content for path, content in team.files.items() if path.suffix == ".py"]
    for design in verdict.designs:
        for device, points in verdict.costs(design).items():
            if points and not any(device.encode() in program for program in programs):
                message = f"{design}: no program asks for '{device}', which costs {points}"
                yield Diagnostic(DESIGN_UNUSED_DEVICE, sanitize(message, _MAX_SHOWN), "", ROBOT_FILE)


def _finding(problem: Diagnostic) -> Diagnostic:
    texts = problem.message, problem.help, problem.where or ""
    message, help_, where = (sanitize(text, _MAX_SHOWN) for text in texts)
    return Diagnostic(problem.code, message, help_, where)
