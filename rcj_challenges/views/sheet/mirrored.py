"""What the mirror of a layout does, as part of a sentence."""

from __future__ import annotations

from typing import TYPE_CHECKING

from rcj_challenges.rules.actions.place import Place
from rcj_challenges.rules.places import place_of
from rcj_challenges.rules.values.draw import DrawValue

if TYPE_CHECKING:
    from rcj_challenges.views.sheet.nouns import Nouns


def mirrored_layout_words(nouns: Nouns, action: Place) -> str:
    """Return how all places of a layout are mirrored, and what its kicks are aimed at."""
    if action.mirror is None:
        return ""
    scenario, layout = nouns.scenario, action.layout
    names = map(str, scenario.draws[layout.draw].values) if isinstance(layout, DrawValue) else (layout or "",)
    kicks = [placing.kick for name in names for placing in scenario.placements[name] if placing.kick is not None]
    aims = any(place_of(kick.towards).mirrored(nouns) is not None for kick in kicks)
    return f", {'places and aims ' if aims else ''}mirrored {action.mirror.describe(nouns)}"
