"""What an action puts somewhere, entry by entry, for each layout that it may place."""

from __future__ import annotations

from rcj_challenges.rules.effects import Places, PlacesLayout
from rcj_challenges.rules.placement import places
from rcj_challenges.scenario.models.scenario import Scenario


def layouts_of(scenario: Scenario, effect: PlacesLayout) -> list[str]:
    """Return the layouts that may be placed: of a draw all among which it decides."""
    return [str(value) for value in scenario.draws[effect.layout].values] if effect.is_drawn else [effect.layout]


def alternatives(scenario: Scenario, effect: Places | PlacesLayout) -> list[list[Places]]:
    """Return the alternative placements: of a layout all its entries, of which a mirror of the whole is the last."""
    if isinstance(effect, Places):
        return [[effect]]
    layouts = (scenario.placements[name] for name in layouts_of(scenario, effect))
    return [[places(one, one.entity, one.at, effect.mirror) for one in layout] for layout in layouts]
