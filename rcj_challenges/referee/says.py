"""The sentence of a rule when it fires."""

from __future__ import annotations

from rcj_challenges.core.amounts import round_score
from rcj_challenges.referee.state import State
from rcj_challenges.rules.values.word import team_name_of
from rcj_challenges.scenario.placeholders import counted
from rcj_challenges.tracking.bound_rules import Firing


def fill_blanks(says: str, state: State, firing: Firing) -> str:
    """Return the sentence with {entity}, {each}, {other}, {team}, {measured}, {limit} and {points} filled in."""
    if "{" not in says:
        return says
    points = str(round_score(sum(firing.scored.values())))
    filled = {
        "{entity}": _named(firing.subject),
        "{each}": _named(firing.rule.each),
        "{other}": _named(firing.rule.other),
        "{team}": team_name_of(state, firing, None),
        "{measured}": _format_number(firing.measured),
        "{limit}": _format_number(firing.limit),
        "{points}": points,
        "{points} points": counted(points),
    }
    # One pass from left to right, so that a team called "{limit}" stays just that.
    parts, rest = [], says
    while rest:
        places = [(rest.find(key), -len(key), key) for key in filled if key in rest]
        if not places:
            break
        start, _, key = min(places)
        parts += [rest[:start], filled[key]]
        rest = rest[start + len(key) :]
    return "".join([*parts, rest])


def _named(name: str | None) -> str:
    """Return a name as people write it, as the rule sheet does: ``blue goal``."""
    return (name or "").replace("_", " ")


def _format_number(number: float | None) -> str:
    return "" if number is None else f"{round(number, 3):g}"
