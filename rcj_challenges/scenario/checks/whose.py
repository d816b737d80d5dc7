"""Whose counter, flag, timer or sequence a rule means, where there is one for each of a group."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, NamedTuple

from rcj_challenges.rules.actions.count import Count
from rcj_challenges.rules.actions.sequence import SequenceAction
from rcj_challenges.rules.actions.set_flag import SetFlag
from rcj_challenges.rules.actions.timer import TimerAction
from rcj_challenges.rules.actions.toggle_flag import ToggleFlag
from rcj_challenges.rules.conditions.counter import CounterIs
from rcj_challenges.rules.conditions.flag import FlagIs
from rcj_challenges.rules.conditions.sequence_at import SequenceAt
from rcj_challenges.rules.conditions.timer import TimerIs
from rcj_challenges.rules.triggers.sequence_broken import SequenceBroken
from rcj_challenges.rules.triggers.sequence_completed import SequenceCompleted
from rcj_challenges.rules.values.counter import CounterValue
from rcj_challenges.rules.values.flag import FlagValue
from rcj_challenges.rules.values.term import term_of
from rcj_challenges.rules.values.timer import NumberTimer, TimerValue
from rcj_challenges.scenario.catalogue import EACH, Catalogue, texts
from rcj_challenges.scenario.checks.bound import Bound
from rcj_challenges.scenario.tree import Entries, Items, Leaf, Mark, Node, Path, child, mark_of, node_at

_HEARS = (SequenceCompleted, SequenceBroken)
_READS = (CounterIs, FlagIs, TimerIs, SequenceAt, CounterValue,
          FlagValue, TimerValue, NumberTimer)  # fmt: skip
_WEIGHTED = (term_of(CounterValue), term_of(FlagValue), term_of(NumberTimer))
_WRITES = (Count, SetFlag, ToggleFlag, TimerAction, SequenceAction)
_SECTIONS = {"counter": "counters", "flag": "flags", "timer": "timers", "sequence": "sequences"}
_PLACES = ("zone", "gate")
_COMPARED = ("at_least", "at_most", "equals")

NAMING_ONE: tuple[Any, ...] = (*_HEARS, *_READS, *_WEIGHTED, *_WRITES)
"""The words that name something of which there may be one for each."""


class Wrong(NamedTuple):
    """A mistake in one of these words: where it is, and what."""

    path: Path
    mark: Mark
    message: str


def check_whose(model: Any, node: Entries, path: Path, bound: Bound, names: Catalogue) -> Iterator[Wrong]:
    """Yield what is wrong with whom ``entity`` names, or with its absence.

    Args:
        model: one of `NAMING_ONE`.
        node: the word as it is written.
        path: where it is.
        bound: what ``each`` and ``other`` stand for there.
        names: the names of the scenario.
    """
    key = next(key for key in _SECTIONS if key in model.model_fields)
    name, whose = node.entries.get(key), node.entries.get("entity")
    if not isinstance(name, Leaf) or not isinstance(name.value, str):
        return
    entry = node_at(names.root, (_SECTIONS[key], name.value))
    per = child(entry, "per")
    if isinstance(per, Leaf) and per.value is None:
        return  # empty, or an unknown param, which is reported where it is written
    if not isinstance(per, Leaf) or not isinstance(per.value, str):
        surplus = next((one for one in ("entity", "of") if one in node.entries), None)
        if surplus is not None and (entry is not None or name.value in names.names("entrants")):
            message = f"{key} '{name.value}' is not kept per entity; leave '{surplus}' out{_or_keep(key, entry)}"
            yield Wrong((*path, surplus), mark_of(names.root, (*path, surplus)), message)
        return
    if per.value not in names.groups and per.value not in names.kinds:
        return  # nobody knows of whom there is one, which is reported where it is written
    quantified = "of" in model.model_fields and "of" in node.entries
    owners = names.expand(per.value)
    if whose is None:
        asked = model in (*_HEARS, *_READS) and not quantified
        if asked and _is_for_one_of(owners, bound, names):
            such = _saying_whose(key, name.value, path)
            message = f"{key} '{name.value}' is kept per {per.value}: say whose with 'entity', such as {such}"
            yield Wrong(path, name.mark, message)
        return
    if "of" in model.model_fields and not quantified and _is_several(whose, names):
        what = "these are several" if isinstance(whose, Items) else f"'{texts(whose)[0]}' is a group"
        message = f"{what}; name one entity, or say with 'of' how many of them: any, all, none, {{at_least: n}}"
        yield Wrong((*path, "entity"), whose.mark, message)
        return
    stranger = next((one for one in bound.meant(whose, names) if one not in owners and one in names.kinds), None)
    if stranger is not None:
        message = f"{key} '{name.value}' is kept per {per.value}, and '{stranger}' is not among them"
        yield Wrong((*path, "entity"), whose.mark, message)


def _saying_whose(key: str, name: str, path: Path) -> str:
    """Return how to say whose it is: in whole where a comparison may have one of its own."""
    if path[-1] in _COMPARED:
        return f"{path[-1]}: {{{key}: {name}, entity: each}}"
    return "entity: each"


def _or_keep(key: str, entry: Node | None) -> str:
    """Return the other way out, where somebody's sequence was meant: one for each."""
    entity = child(entry, "entity")
    if key != "sequence" or not isinstance(entity, Leaf):
        return ""
    return f", or keep one for each: give it 'per', a group, in place of entity: {entity.value}"


def _is_for_one_of(owners: tuple[str, ...], bound: Bound, names: Catalogue) -> bool:
    """Return whether a rule is for one of those that have something each, or for an entity at all."""
    each = bound.each or ()
    return any(one in owners or names.kinds.get(one) not in _PLACES for one in each)


def _is_several(whose: Node, names: Catalogue) -> bool:
    return isinstance(whose, Items) or any(text in names.groups and text not in names.kinds for text in texts(whose))


def touching_itself(touch: Entries, names: Catalogue) -> str:
    """Return what is wrong with a touch of something with itself; empty: it is one of two.

    A group is none of it although only one may be left in it: of that lint tells.

    Args:
        touch: the trigger, as it is written.
        names: the names of the scenario.
    """
    written = {text for key in ("entity", "other") for text in texts(touch.entries.get(key))}
    both = all(key in touch.entries for key in ("entity", "other"))
    (alone, *others) = written or ("",)
    if not both or others or (alone != EACH and alone not in names.kinds):
        return ""
    return f"'{alone}' never touches itself; name in other what it touches, such as robots or walls"
