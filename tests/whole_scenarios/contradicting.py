"""What lint says can never be, against what came to be."""

from __future__ import annotations

import re
from collections.abc import Iterator

from rcj_challenges.core.amounts import round_score
from rcj_challenges.core.diagnostics import Diagnostic
from rcj_challenges.expect.scripted_match import ScriptedMatch
from rcj_challenges.scenario.models.scenario import Scenario

_NEVER_FIRES = frozenset({"rule-never-fires", "each-of-none"})


def contradictions(findings: list[Diagnostic], scenario: Scenario, play: ScriptedMatch) -> Iterator[str]:
    """Yield the findings that a play has proved wrong.

    Args:
        findings: of a scenario without repeated rules, of which lint speaks by another name.
        scenario: the models.
        play: any play of it, also one that no physics would allow.
    """
    fired = {firing.rule for firing in play.firings if firing.suppressed is None}
    phases, events = {phase for _, phase in play.phases}, {event.name for event in play.events}
    referee = play.referee
    for finding in findings:
        section, _, rest = finding.where.path.partition(".")
        name = re.split(r"[.\[ ]", rest)[0]
        wrong = False
        match finding.code:
            case kind if kind in _NEVER_FIRES:
                wrong = section == "rules" and name in fired and len(scenario.rules[name].triggers) == 1
            case "phase-never-entered":
                wrong = section == "phases" and name in phases
            case "event-never-emitted":
                reported = re.search(r"'([A-Z][A-Z0-9_]*)'", finding.message)
                wrong = reported is not None and reported[1] in events
            case "never-written" if section == "counters" and abs(scenario.counters[name].first or 0) <= 1e15:
                first = scenario.counters[name].first
                wrong = _all(referee.counters[name]) != {None if first is None else round_score(first)}
            case "never-written" if section == "flags":
                wrong = _all(referee.flags[name]) != {scenario.flags[name].initial}
            case "no-way-to-score":
                wrong = any(referee.scores.values())
            case _:
                pass
        if wrong:
            yield f"{finding} - and so it was, in tick {play.tick}"


def _all(value: object) -> set[object]:
    return set(value.values()) if isinstance(value, dict) else {value}
