"""Notes on things that a rule placed inside a zone in a test: that is no entry, so ``enters`` did not fire."""

from __future__ import annotations

from collections.abc import Collection, Container, Iterable, Iterator

from rcj_challenges.core.play import Placement
from rcj_challenges.core.timing import s_from_ticks
from rcj_challenges.referee.zones import region_of
from rcj_challenges.rules.effects import Emits, Entry
from rcj_challenges.scenario.models.scenario import Rule, Scenario
from rcj_challenges.scenario.roster import Roster


def placed_inside_notes(
    placements: Collection[tuple[int, Placement]],
    scenario: Scenario,
    roster: Roster,
    missing: Container[str],
    fired: Container[str],
) -> Iterable[str]:
    """Return notes on rules that emit a missing event and wait for an entry where a rule has put the thing.

    Placements are given with their ticks, and the rules that have fired are left out.
    """
    for name, rule in scenario.rules.items():
        names = (f"rule {name}", *(one.event for one in rule.effects(Emits)))
        if name in fired or not any(one in missing for one in names):
            continue
        found = next(_inside(placements, rule, scenario, roster), None)
        if found is not None:
            tick, entity, zone = found
            yield (
                f"note: a rule put {entity} into {zone} at {s_from_ticks(tick):g} s, which does not trigger "
                f"{name}: a placed thing has not entered the zone; use 'holds' with {{entity: {entity}, in: {zone}}} "
                "and for_s: 0.05"
            )


def _inside(
    placements: Collection[tuple[int, Placement]], rule: Rule, scenario: Scenario, roster: Roster
) -> Iterator[tuple[int, str, str]]:
    """Yield when what was put into a zone that a trigger of the rule waits for it to enter."""
    for entry in rule.moments(Entry):
        entities, zones = (roster.named(names, rule.for_each, None) for names in (entry.entity, entry.zone))
        for tick, put in placements:
            name = roster.entities[put.entity]
            if put.parked or name not in entities:
                continue
            # A zone that is drawn or moves is not looked at: it may be another one, or elsewhere, at that time.
            known = (one for one in zones if one in scenario.zones)
            inside = (one for one in known if not getattr(scenario.zones[one], "anchor", None))
            yield from (
                (tick, name, zone) for zone in inside if region_of(scenario.zones[zone]).contains(put.x_m, put.y_m)
            )
