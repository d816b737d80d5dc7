"""What a mirror does to where things are put and to where balls roll from there, as parts of sentences."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from rcj_challenges.rules.phrasing import listed
from rcj_challenges.rules.places import RelativeTo
from rcj_challenges.rules.values import DrawValue

if TYPE_CHECKING:
    from rcj_challenges.views.sheet.nouns import Nouns


def mirrored_words(nouns: Nouns, mirror: Any, at: Any) -> str:
    """Return how a place is mirrored; nothing where it is not, or where that changes nothing.

    Args:
        nouns: what the names stand for.
        mirror: the mirror; None: there is none.
        at: the place.
    """
    seen = None if mirror is None else _seen(nouns, at)
    return "" if seen is None else f", mirrored{seen} {_turned(nouns, mirror)}"


def mirrored_aim_words(nouns: Nouns, placing: Any) -> str:
    """Return how what a kick is aimed at is mirrored: as its place is, if that has been told."""
    seen = None if placing.mirror is None else _seen(nouns, placing.kick.towards)
    if seen is None:
        return ""
    if _seen(nouns, placing.at) is None:
        return mirrored_words(nouns, placing.mirror, placing.kick.towards)
    return f", mirrored in the same way{seen}"


def mirrored_layout_words(nouns: Nouns, action: Any) -> str:
    """Return how all places of a layout are mirrored, and what its kicks are aimed at."""
    if action.mirror is None:
        return ""
    scenario, layout = nouns.scenario, action.layout
    names = map(str, scenario.draws[layout.draw].values) if isinstance(layout, DrawValue) else (layout,)
    kicks = [placing.kick for name in names for placing in scenario.placements[name] if placing.kick is not None]
    what = "places and aims " if any(_seen(nouns, kick.towards) is not None for kick in kicks) else ""
    return f", {what}mirrored {_turned(nouns, action.mirror)}"


def _turned(nouns: Nouns, mirror: Any) -> str:
    turned = listed([f"{axis} becomes -{axis}" for axis in ("x", "y") if mirror.axis in (axis, "both")], "and")
    return f"({turned})" + (f" if {nouns.kept('flag', mirror.when, None)} is set" if mirror.when else "")


def _seen(nouns: Nouns, at: Any) -> str | None:
    """Return what of a place is mirrored: an empty text for all, `` as seen from Y1`` for the way from there.

    None: nothing is. An entity stays where it is, and what turns with it is told in its own frame.
    """
    if not isinstance(at, RelativeTo) or not _is_entity(nouns, at.relative_to):
        return ""
    return None if at.turns or not any(at.offset_m) else f" as seen from {nouns.thing(at.relative_to)}"


def _is_entity(nouns: Nouns, name: str) -> bool:
    scenario = nouns.scenario
    return not any(member in scenario.spots or member in scenario.draws for member in nouns.roster.expand(name))
