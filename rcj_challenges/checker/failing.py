"""Faults of programs as findings: what happened, to which robots, and what a pupil can do about it."""

from __future__ import annotations

from typing import Any

from rcj_challenges.checker.advice.hints import WHEREABOUTS, hint_for
from rcj_challenges.checker.advice.table import Hint
from rcj_challenges.checker.findings import Finding, StageName
from rcj_challenges.checker.rehearsal import Rehearsal, Rehearsed
from rcj_challenges.controllers.log import AFTER_ITS_END, ANOTHER_THREAD
from rcj_challenges.facts.sanitize import sanitize, sanitize_block
from rcj_challenges.facts.timing import s_from_ticks

_BETWEEN = (ANOTHER_THREAD.strip(), AFTER_ITS_END)
"""What stands between the places that a log names."""
_REMEDIES = {
    "crash": "the last line of the report below says what is wrong, the lines above it where",
    "exit": "call robot.step(32) in a loop until it returns -1; a program that ends leaves its robot standing",
    "start_timeout": "call robot.step(32) sooner: is there a loop before it, or something that takes long to load?",
    "step_timeout": "look for a loop that never calls robot.step(32), at the place below if one is named",
    "half_timeout": "do less in each step: the program may only compute and wait for that long in a whole half",
    "memory": "keep less, start fewer threads: is there a list that grows in every step?",
    "output_flood": "print less, and write fewer files",
    "protocol": "leave the channel to the match alone: let the controller module do the talking",
    "start": "if the files are in order, this computer may be the reason: ask the organizers",
}
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
        # All that come to their end do so in the same words, each program perhaps for a reason of its own.
        ended = fault["kind"] == "exit"
        why = hint_for(rehearsal.loaded.scenario, rehearsal.team, fault) if ended else None
        alike.setdefault((fault["kind"], fault["detail"], fault["traceback"], why), []).append(fault)
    return [_finding(stage, rehearsal, match, side, faults) for faults in alike.values()]


def _finding(
    stage: StageName, rehearsal: Rehearsal, match: Rehearsed, side: str, faults: list[dict[str, Any]]
) -> Finding:
    """Return the finding on faults that are alike."""
    first, robots = faults[0], [fault["robot"] for fault in faults]
    kind, detail, traceback = first["kind"], first["detail"], first["traceback"]
    # Of robots that hang, each was somewhere else when its patience ended: one place is enough.
    whereabouts = next(filter(None, (_whereabouts(match.log(robot)) for robot in robots)), "") if not traceback else ""
    hint = hint_for(rehearsal.loaded.scenario, rehearsal.team, first, match.log(first["robot"]), whereabouts)
    hint = hint or Hint(kind, _REMEDIES.get(kind, _OTHER_REMEDY))
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


def _whereabouts(log: str) -> str:
    """Return what stands in a log about where a program was when it was ended."""
    _, found, rest = log.rpartition(WHEREABOUTS)
    lines = rest.splitlines() if found else []
    inside = [line for line in lines if line.startswith("  File ") or line in _BETWEEN]
    return "\n".join([WHEREABOUTS.strip(), *inside]) if inside else ""
