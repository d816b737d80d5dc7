"""Faults of programs as findings: what happened, to which robots, and what a pupil can do about it."""

from __future__ import annotations

from typing import Any

from rcj_challenges.checker.advice.hints import REMEDIES, hint_for, whereabouts_in
from rcj_challenges.checker.advice.table import Hint
from rcj_challenges.checker.findings import Finding, StageName
from rcj_challenges.checker.rehearsal import Rehearsal, Rehearsed
from rcj_challenges.core.sanitize import sanitize, sanitize_block
from rcj_challenges.core.timing import s_from_ticks

_OTHER_REMEDY = "see the report below, if there is one, and the program's output (--show-output)"


def fault_findings(stage: StageName, rehearsal: Rehearsal, match: Rehearsed, side: str = "") -> list[Finding]:
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
        why = hint_for(rehearsal.loaded.scenario, rehearsal.team, fault) if ended else None
        alike.setdefault((fault["kind"], fault["detail"], fault["traceback"], why), []).append(fault)
    return [_finding(stage, rehearsal, match, side, faults) for faults in alike.values()]


def _finding(
    stage: StageName, rehearsal: Rehearsal, match: Rehearsed, side: str, faults: list[dict[str, Any]]
) -> Finding:
    """Return the finding on equal faults."""
    first, robots = faults[0], [fault["robot"] for fault in faults]
    kind, detail, traceback = first["kind"], first["detail"], first["traceback"]
    # Robots that hang are stopped at different places: one is enough.
    places = (whereabouts_in(match.log(robot)) for robot in robots if not traceback)
    whereabouts = next(filter(None, places), "")
    hint = hint_for(rehearsal.loaded.scenario, rehearsal.team, first, match.log(first["robot"]), whereabouts)
    hint = hint or Hint(kind, REMEDIES.get(kind, _OTHER_REMEDY))
    when = f"{side}after {s_from_ticks(first['tick']):.1f} s: " if stage == "play" else ""
    report = traceback or whereabouts
    return Finding(
        code=f"{stage}.{kind}",
        level="failure",
        message=f"{when}{sanitize(detail, 300) or kind}{hint.message}",
        remedy=hint.remedy,
        where=", ".join(robots),
        details=sanitize_block(report) if report else "",
    )
