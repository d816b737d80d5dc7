"""Which end of the field a seat attacks, and where the goal lines are."""

from __future__ import annotations

from collections.abc import Mapping

from rcj_challenges.rules.effects import Entry, Scores
from rcj_challenges.scenario.models.field import FieldModel
from rcj_challenges.scenario.models.scenario import Rule, Scenario
from rcj_challenges.scenario.roster import Roster
from rcj_challenges.scenario.shapes import visible_outline

_AT_THE_END = 0.9
"""A zone is at an end of the field if its middle is beyond this share of the way from the centre to the end line."""
_EVERYWHERE = (-100.0, -100.0, 100.0, 100.0)


def attacked_ends(scenario: Scenario, roster: Roster) -> dict[str, frozenset[int]]:
    """Return by seat the ends that it attacks: 1 for +y, -1 for -y.

    A seat attacks an end if a rule gives it points for a ball that enters a zone there. Where no rule says so, and
    there are goals, two seats attack the end at which the other one starts, and a single one every end with a goal.
    """
    found: dict[str, set[int]] = {seat: set() for seat in scenario.entrants}
    for rule in scenario.rules.values():
        ends = _ends_entered(rule, scenario, roster)
        for score in (one for one in rule.effects(Scores) if one.may_gain):
            for seat in _receivers(score, rule, scenario, roster):
                found[seat].update(ends)
    if scenario.field.goals and not any(found.values()):
        found = _by_start(scenario)
    return {seat: frozenset(ends) for seat, ends in found.items()}


def _receivers(score: Scores, rule: Rule, scenario: Scenario, roster: Roster) -> list[str]:
    """Return the seats that may get the points; none if it depends on the last touch."""
    if score.entrant is None or score.entrant in scenario.entrants:
        return [] if score.entrant is None else [score.entrant]
    robots = set(roster.expand(rule.for_each or ()))
    return [seat for seat, entrant in scenario.entrants.items() if robots & set(entrant.robots)]


def own_end(ends: frozenset[int]) -> int | None:
    """Return the end that a seat defends; None if it attacks both or none."""
    return -next(iter(ends)) if len(ends) == 1 else None


def goal_widths(field: FieldModel) -> Mapping[int, float]:
    """Return by end the inner width in m of the goal there."""
    return {1 if goal.end == "positive_y" else -1: goal.width_m for goal in field.goals.values()}


def _ends_entered(rule: Rule, scenario: Scenario, roster: Roster) -> set[int]:
    balls, ends = set(scenario.balls), set()
    for entry in rule.moments(Entry):
        if balls & set(roster.may_be(entry.entity, rule)):
            for name in roster.may_be(entry.zone, rule):
                zone = scenario.zones.get(name)
                ys = [y for _, y in visible_outline(zone, scenario.field, _EVERYWHERE)] if zone is not None else []
                if ys and abs(sum(ys) / len(ys)) > _AT_THE_END * scenario.field.length_m / 2:
                    ends.add(1 if sum(ys) > 0 else -1)
    return ends


def _by_start(scenario: Scenario) -> dict[str, set[int]]:
    if len(scenario.entrants) != 2:
        return {seat: set(goal_widths(scenario.field)) for seat in scenario.entrants}
    starts = {}
    for seat, entrant in scenario.entrants.items():
        ys = [scenario.robots[robot].start.y_m for robot in entrant.robots]
        starts[seat] = sum(ys) / len(ys) if ys else 0.0
    (first, first_y), (second, second_y) = starts.items()
    if first_y * second_y >= 0:
        return {first: set(), second: set()}
    return {first: {-1 if first_y > 0 else 1}, second: {-1 if second_y > 0 else 1}}
