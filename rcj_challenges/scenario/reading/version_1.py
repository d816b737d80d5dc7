"""Reads version 1 of the language: a tree of it becomes one of version 2.

This is the only module that knows how version 1 was written. Where nothing changed, the tree stays as it is.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from rcj_challenges.scenario.tree import Entries, Items, Leaf, Mark, Node

_ACTIONS = {"score": ("points",), "count": ("by", "to")}
"""Actions with an amount, and where it stands."""
_OF_ALL = {"counter": "sum", "flag": "highest", "timer": "highest"}
"""What was read of something that is kept for several, without ``entity``."""


def to_version_2(tree: Entries) -> None:
    """Bring a file of version 1, or one that names no version, to version 2."""
    version = tree.entries.get("schema_version")
    if version is not None and not (isinstance(version, Leaf) and version.value == 1 and version.value is not True):
        return
    if version is not None:
        tree.put("schema_version", Leaf(2, version.mark), tree.key_marks["schema_version"])
    for rule in _entries(tree.entries.get("rules")).values():
        _Rule(rule, tree).convert()


class _Rule:
    """Converts a rule."""

    def __init__(self, rule: Node, tree: Entries) -> None:
        self._rule = rule
        self._tree = tree
        self._group = _text(rule, "for_each")

    def convert(self) -> None:
        """Convert amounts, and limits of comparisons."""
        for node in _mappings(self._rule):
            keys = _ACTIONS.get(_text(node, "action"), ())
            for key in keys:
                self._amount(node, key)
            for key in ("at_least", "at_most", "equals"):
                self._bound(node, key)
            if keys:
                _limit_amount(node, keys)

    def _amount(self, action: Entries, key: str) -> None:
        amount = action.entries.get(key)
        if isinstance(amount, Items):
            parts = [self._part(one, in_list=True) for one in amount.items]
            action.put(key, _mapping(amount.mark, sum=Items(parts, amount.mark)), action.key_marks[key])
        elif isinstance(amount, Entries) and "weight" not in amount.entries:
            action.put(key, self._part(amount), action.key_marks[key])

    def _part(self, node: Node, *, in_list: bool = False) -> Node:
        """Return a number: times were counted in whole seconds, what there was not was 0, weights are factors.

        In a list, what is kept for several was that of all of them.
        """
        if not isinstance(node, Entries) or "param" in node.entries:
            return node
        part = Entries(dict(node.entries), node.mark, dict(node.key_marks))
        weight, fraction = (part.entries.pop(key, None) for key in ("weight", "fraction"))
        word, is_timer = _text(part, "word"), "timer" in part.entries
        kind = next((one for one in _OF_ALL if one in part.entries), "")
        if in_list and self._group and "entity" not in part.entries and self._is_kept_per(kind, _text(part, kind)):
            part = _mapping(node.mark, **{_OF_ALL[kind]: part})
        if (is_timer or word.endswith("_s")) and not (isinstance(fraction, Leaf) and fraction.value is True):
            part.put("round", Leaf("down", node.mark), node.mark)
        if "distance" in part.entries or "told" in part.entries or word in ("measured", "limit"):
            part.put("otherwise", Leaf(0, node.mark), node.mark)
        if weight is None or (isinstance(weight, Leaf) and weight.value == 1):
            return part
        if "round" in part.entries:  # before the weight
            part = _mapping(node.mark, sum=Items([part], node.mark))
        part.put("times", weight, node.key_marks["weight"])
        return part

    def _is_kept_per(self, kind: str, name: str) -> bool:
        entry = _entries(self._tree.entries.get(f"{kind}s")).get(name)
        return bool(_text(entry, "per"))

    def _bound(self, node: Entries, key: str) -> None:
        """``{lowest: COUNTER}`` is among all others in a rule for each that keeps the counter, else among all."""
        bound = node.entries.get(key)
        for word in ("lowest", "highest") if isinstance(bound, Entries) else ():
            counter = _text(bound, word)
            if not counter or not isinstance(bound, Entries):
                continue
            entries: dict[str, Node] = {"counter": bound.entries[word]}
            per = _text(_entries(self._tree.entries.get("counters")).get(counter), "per")
            if self._group and per in ("", self._group):
                entries["entity"] = Leaf("others", bound.mark)
            node.put(key, _mapping(bound.mark, **{word: _mapping(bound.mark, **entries)}), node.key_marks[key])


def _limit_amount(action: Entries, keys: tuple[str, ...]) -> None:
    """Limits of an amount are the higher or the lower of two numbers."""
    for bound, word in (("at_least", "highest"), ("at_most", "lowest")):
        limit = action.entries.get(bound)
        if limit is None:
            continue
        mark = action.key_marks[bound]
        action.drop(bound)
        key = next((one for one in keys if one in action.entries), keys[0])
        amount = action.entries.get(key) or Leaf(1, mark)
        pair = Items([amount, limit], amount.mark)
        action.put(key, _mapping(amount.mark, **{word: pair}), action.key_marks.get(key, mark))


def _mapping(mark: Mark, **entries: Node) -> Entries:
    return Entries(dict(entries), mark, dict.fromkeys(entries, mark))


def _entries(node: Node | None) -> Mapping[str, Node]:
    return node.entries if isinstance(node, Entries) else {}


def _text(node: Node | None, key: str) -> str:
    found = _entries(node).get(key)
    return found.value if isinstance(found, Leaf) and isinstance(found.value, str) else ""


def _mappings(node: Node) -> Iterator[Entries]:
    """Yield all mappings in a value, itself included; what changes meanwhile is not looked at again."""
    if isinstance(node, Entries):
        for inner in list(node.entries.values()):
            yield from _mappings(inner)
        yield node
    elif isinstance(node, Items):
        for inner in node.items:
            yield from _mappings(inner)
