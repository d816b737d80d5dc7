"""Findings on programs that failed or requested missing devices: what happened, to which robots, and what helps."""

from __future__ import annotations

from typing import Any

from rcj_challenges.checker.advice.devices import device_help, missing_devices, missing_sentence
from rcj_challenges.checker.advice.hints import HELP_BY_FAULT, hint_for, whereabouts_in
from rcj_challenges.checker.findings import StageName
from rcj_challenges.checker.rehearsal import Rehearsal, Rehearsed
from rcj_challenges.core.code import Code
from rcj_challenges.core.diagnostics import Diagnostic
from rcj_challenges.core.grouping import grouped
from rcj_challenges.core.sanitize import sanitize, sanitize_block
from rcj_challenges.core.timing import s_from_ticks

MissingDevices = dict[str, list[str]]
"""Robots by the name of the device that they lack."""

_MAX_DEVICES = 10


def fault_findings(stage: StageName, rehearsal: Rehearsal, match: Rehearsed, side: str = "") -> list[Diagnostic]:
    """Return one finding for each kind of failure; robots that failed alike share one.

    Args:
        stage: in which it was found.
        rehearsal: what was to be played.
        match: what was played.
        side: where the team played, as the message begins.
    """
    alike: dict[tuple[Any, ...], list[dict[str, Any]]] = {}
    for fault in match.faults:
        # All that end have the same message, but each program may have its own reason.
        ended = fault["kind"] == "exit"
        why = hint_for(rehearsal.scenario, rehearsal.team, fault) if ended else ""
        alike.setdefault((fault["kind"], fault["detail"], fault["traceback"], why), []).append(fault)
    return [_fault_finding(stage, rehearsal, match, side, faults) for faults in alike.values()]


def _fault_finding(
    stage: StageName, rehearsal: Rehearsal, match: Rehearsed, side: str, faults: list[dict[str, Any]]
) -> Diagnostic:
    first, robots = faults[0], [fault["robot"] for fault in faults]
    kind, detail, traceback = first["kind"], first["detail"], first["traceback"]
    # Robots that hang are stopped at different places: one is enough.
    places = (whereabouts_in(match.log(robot)) for robot in robots if not traceback)
    whereabouts = next(filter(None, places), "")
    help_ = hint_for(rehearsal.scenario, rehearsal.team, first, match.notes[first["robot"]], whereabouts)
    when = f"{side}after {s_from_ticks(first['tick']):.1f} s: " if stage == "play" else ""
    report = traceback or whereabouts
    return Diagnostic(
        Code.named(f"{stage}.{kind}"),
        f"{when}{sanitize(detail, 300) or kind}",
        help_ or HELP_BY_FAULT[kind],
        ", ".join(robots),
        details=sanitize_block(report) if report else "",
        level="error",
    )


def missing_by_device(match: Rehearsed) -> MissingDevices:
    """Return the devices that robots of the team lacked in a match."""
    return grouped((found, robot) for robot in match.robots for found in missing_devices(match.notes[robot]))


def device_findings(
    stage: StageName, missing: MissingDevices, rehearsal: Rehearsal, side: str = ""
) -> list[Diagnostic]:
    """Return a warning for each missing device that a program requested.

    Args:
        stage: in which it was found.
        missing: the devices.
        rehearsal: what was to be played.
        side: where the team played, as the message begins.
    """
    findings = []
    for name, robots in list(missing.items())[:_MAX_DEVICES]:
        message = f"{side}{missing_sentence(name)}"
        help_ = device_help(rehearsal.scenario, rehearsal.team, robots[0], name, missing)
        findings.append(Diagnostic(Code.named(f"{stage}.no_device"), message, help_, ", ".join(robots)))
    return findings
