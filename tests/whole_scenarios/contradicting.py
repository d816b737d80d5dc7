"""What lint says can never be, against what came to be."""

from __future__ import annotations

import re
from collections.abc import Iterator

from rcj_challenges.facts.amounts import on_paper
from rcj_challenges.referee.script import ScriptedPlay
from rcj_challenges.scenario.lint.table import Finding
from rcj_challenges.scenario.models.scenario import Scenario

_NEVER_FIRES = frozenset({"rule_never_fires", "each_of_nobody"})


def contradictions(findings: list[Finding], scenario: Scenario, play: ScriptedPlay) -> Iterator[str]:
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
        section, _, rest = finding.problem.path.partition(".")
        name = re.split(r"[.\[ ]", rest)[0]
        wrong = False
        match finding.kind:
            case kind if kind in _NEVER_FIRES:
                wrong = section == "rules" and name in fired and len(scenario.rules[name].triggers) == 1
            case "phase_never_entered":
                wrong = section == "phases" and name in phases
            case "phase_never_left":
                wrong = section == "phases" and name in {phase for _, phase in play.phases[:-1]}
            case "event_never_emitted":
                told = re.search(r"'([A-Z][A-Z0-9_]*)'", finding.problem.message)
                wrong = told is not None and told[1] in events
            case "counter_never_counted" if abs(scenario.counters[name].initial) <= 1e15:
                wrong = section == "counters" and _all(referee.counters[name]) != {
                    on_paper(scenario.counters[name].initial)
                }
            case "flag_never_set":
                wrong = section == "flags" and _all(referee.flags[name]) != {scenario.flags[name].initial}
            case "no_way_to_score":
                wrong = any(referee.scores.values())
            case _:
                pass
        if wrong:
            yield f"{finding} - and so it was, in tick {play.tick}"


def _all(value: object) -> set[object]:
    return set(value.values()) if isinstance(value, dict) else {value}
