"""Events, times and reasons as short lines of text, for terminals and pages."""

from __future__ import annotations

import re

from rcj_challenges.core.amounts import HALF, Noun, distinct_decimals, number_words
from rcj_challenges.core.play import Fault, Firing
from rcj_challenges.core.sanitize import sanitize
from rcj_challenges.core.timing import s_from_ticks
from rcj_challenges.records.reflog import PROGRAM_FAULT
from rcj_challenges.rules.phrasing import quoted
from rcj_challenges.scenario.models.scenario import Scenario

_WHERE = re.compile(r'File "(?:[^"]*[/\\])?([^"/\\]+)", line (\d+)')


def clock(seconds: float) -> str:
    """Return a match time as ``m:ss.s``."""
    tenths = round(seconds * 10)
    return f"{tenths // 600}:{tenths // 10 % 60:02d}.{tenths % 10}"


def event_title(name: str, half: int, halves: int, period: Noun = HALF) -> str:
    """Return the name of an event for spectators: ``GOAL``, ``END OF HALF 1``."""
    if name == PROGRAM_FAULT:
        return "PROGRAM FAILED"
    if name == "MATCH_START" and half > 1:
        return f"START OF {period} {half}".upper()
    is_end = name == "MATCH_FINISH" and half < halves
    return f"END OF {period} {half}".upper() if is_end else name.replace("_", " ")


def fault_sentence(fault: Fault) -> str:
    """Return ``Y1 crashed at robot.py:7: ZeroDivisionError: division by zero``; the place once, where it is known."""
    where = [] if fault.detail.endswith(")") and ", line " in fault.detail else _WHERE.findall(fault.traceback)
    at = f" at {where[-1][0]}:{where[-1][1]}" if where else ""
    what = "crashed" if fault.kind == "crash" else f"failed ({fault.kind.replace('_', ' ')})"
    return f"{fault.robot} {what}{at}: {fault.detail}"


def fault_line(fault: Fault) -> str:
    """Return one line for a program's fault, with the time at which it failed."""
    return f"{clock(s_from_ticks(fault.tick)):>7}  {sanitize(fault_sentence(fault), 300)}"


# --- reasons of firings -----------------------------------------------------------------------------------------------


_DECIMALS = 3


class Reasons:
    """Formats why rules of a scenario fired."""

    def __init__(self, scenario: Scenario) -> None:
        self._rules = scenario.rules
        self._entities = {*scenario.robots, *scenario.balls, *scenario.obstacles}

    def about(self, cause: Firing | None) -> str:
        """Return the sentence of a rule; if it leaves open which of several triggers fired, the reason."""
        if cause is None:
            return ""
        rule = self._rules.get(cause.rule)
        return (self.reason(cause) if rule is not None and len(rule.triggers) > 1 else "") or cause.says

    def reason(self, cause: Firing | None) -> str:
        """Return the reason of a firing: ``Y1 made no progress: 0.497 m in 15 s, at least 0.5 m``; or nothing."""
        rule = self._rules.get(cause.rule) if cause is not None else None
        if cause is None or rule is None:
            return ""
        fired = [one for one in rule.triggers if one.name() == cause.trigger]
        if len(fired) != 1 or not fired[0].REASON or (cause.measured is None and fired[0].LIMIT):
            return ""
        fields = {key: quoted(value) if isinstance(value, str) else value for key, value in fired[0]}
        measures = {"measured": cause.measured, "limit": cause.limit}
        decimals = distinct_decimals(cause.measured, cause.limit, _DECIMALS)
        numbers = {key: number_words(value, decimals) for key, value in measures.items() if value is not None}
        reason: str = fired[0].REASON.format(**{**fields, **numbers})
        entity = cause.entity or getattr(fired[0], "entity", "")
        reason = f"{entity} {reason}" if entity in self._entities else reason
        return reason[0].upper() + reason[1:]
