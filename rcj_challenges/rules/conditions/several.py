"""What conditions that are made of others share."""

from collections.abc import Sequence

from rcj_challenges.rules.base import Binder, Condition, Phrases
from rcj_challenges.rules.phrasing import listed


def watched_by(to: Binder, conditions: Sequence[Condition]) -> tuple[int, ...]:
    """Return the entities whose placement changes any of several conditions."""
    return tuple(dict.fromkeys(entity for condition in conditions for entity in condition.watched(to)))


def opposites(conditions: Sequence[Condition]) -> list[Condition]:
    """Return the opposite of each condition."""
    return [one.model_copy(update={"negate": not one.negate}) for one in conditions]


def all_hold(phrases: Phrases, parts: Sequence[Condition]) -> str:
    """Return that all of several conditions hold."""
    # Behind a comma it is clear that it does not belong to the alternatives before it.
    joint = ", and " if any(one.is_several() for one in parts) else " and "
    return joint.join(one.describe(phrases) for one in parts)


def one_holds(phrases: Phrases, parts: Sequence[Condition]) -> str:
    """Return that one of several conditions holds."""
    if len(parts) == 1:
        return parts[0].describe(phrases)
    inner = [_as_one(phrases, one) for one in parts]
    return "either " + (", or " if any(one.is_several() for one in parts) else " or ").join(inner)


def _as_one(phrases: Phrases, condition: Condition) -> str:
    """Return a condition as one of several; if all of others must hold in it, as ``both … and …``."""
    if not condition.is_several() or condition.name() != "all_of" or condition.negate:
        return condition.describe(phrases)
    inner = [one.describe(phrases) for one in getattr(condition, "conditions", ())]
    return f"both {inner[0]} and {inner[1]}" if len(inner) == 2 else f"{listed(inner, 'and')} at once"
