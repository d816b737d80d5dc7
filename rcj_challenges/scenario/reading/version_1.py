"""Reads version 1 of the language: a tree of it becomes one of version 2.

This is the only module that knows how version 1 was written. Where nothing changed, the tree stays as it is.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

from rcj_challenges.scenario.reading.yaml_strict import on_one_line
from rcj_challenges.scenario.tree import (
    Entries,
    Items,
    Leaf,
    Mark,
    Node,
    Path,
    child,
    entries_of,
    items_of,
    node_at,
    nodes_in,
    plain,
    value_of,
)

_ACTIONS = {"score": ("points",), "count": ("by", "to")}
"""Actions with an amount, and where it stands."""
_OF_ALL = {"counter": "sum", "flag": "highest", "timer": "highest"}
"""What was read of something that is kept for several, without ``entity``."""


def new_texts(tree: Entries, bases: Sequence[Entries] = ()) -> dict[Mark, tuple[Path, str]]:
    """Bring a file to version 2; return, by place, the path of what was changed there and its new text."""
    before = plain(tree)
    to_version_2(tree, bases)
    found: dict[Mark, tuple[Path, str]] = {}
    for path, now in sorted(_changes(before, tree), key=lambda change: _is_of_section(change[0])):
        text = _written(path, now)
        if now.mark in found:
            first, earlier = found[now.mark]
            found[now.mark] = first, f"{earlier}, and {text}"
        else:
            found[now.mark] = path, text
    return found


def _is_of_section(path: Path) -> bool:
    """Return whether a path leads to an entry of a section: such are added for what is changed elsewhere."""
    return len(path) == 2


def _written(path: Path, node: Node) -> str:
    key, value = path[-1], plain(node)
    if isinstance(key, int):
        return on_one_line(value)
    text = on_one_line({path[0]: {key: value}} if _is_of_section(path) else {key: value})[1:-1]
    # A file that says version 2 is no longer searched for old forms.
    return f"{text}, after all other changes" if key == "schema_version" else text


def _changes(before: Any, now: Node, path: Path = ()) -> Iterator[tuple[Path, Node]]:
    """Yield the smallest parts that are not as they were before: values of keys, entries of lists or sections."""
    if isinstance(before, dict) and isinstance(now, Entries) and (len(path) < 2 or before.keys() == now.entries.keys()):
        for key, node in now.entries.items():
            # Of a section that was not there each entry is new.
            yield from _changes(before.get(key, None if path else {}), node, (*path, key))
    elif isinstance(before, list) and isinstance(now, Items) and len(before) == len(now.items):
        for index, node in enumerate(now.items):
            yield from _changes(before[index], node, (*path, index))
    elif before != plain(now):
        yield path, now


def to_version_2(tree: Entries, bases: Sequence[Entries] = ()) -> None:
    """Bring a tree to version 2; ``bases``: what it extends.

    What entrants are ranked by is converted in any, the rest in one of version 1, or one that names no version.
    """
    ranked = items_of(node_at(tree, ("result", "rank")))
    for at, one in enumerate(ranked):
        if isinstance(one, Entries) and "better" not in one.entries:
            ranked[at] = _ranked(one, tree, bases) or one
    version = tree.entries.get("schema_version")
    if version is not None and (value_of(version) != 1 or value_of(version) is True):
        return
    if version is not None:
        tree.put("schema_version", Leaf(2, version.mark), tree.key_marks["schema_version"])
    trees = (tree, *bases)
    _make_tables(tree)
    for rule in entries_of(tree.entries.get("rules")).values():
        _Rule(rule, trees).convert()
    for node in _mappings(tree):
        _convert_value(node, trees)


def _ranked(one: Entries, tree: Entries, bases: Sequence[Entries]) -> Entries | None:
    """Return a value that ranks: a score, a time with penalties, or a counter, which was that of a team's robots."""
    mark, trees = one.mark, (tree, *bases)
    key = next((key for key in ("score", "time", "counter") if key in one.entries), "")
    order = _text(one, "order" if key == "counter" else key) or "descending" * (key == "counter")
    better, parts = {"descending": "more", "ascending": "less"}.get(order), items_of(one.entries.get("plus"))
    if better is None or not all(_text(part, "counter") for part in parts):
        return None
    if key == "score":
        return _mapping(mark, score=Leaf("each", mark), better=Leaf(better, mark))
    terms: list[Node] = [
        _mapping(part.mark, **_counter(part, trees), times=child(part, "weight") or Leaf(1, mark)) for part in parts
    ]
    plus = {"plus": terms[0] if len(terms) == 1 else _mapping(mark, sum=Items(terms, mark))} if terms else {}
    value = _counter(one, trees) if key == "counter" else _time(tree, trees, mark) | plus
    what = [_text(one, key) if key == "counter" else key, *(_text(part, "counter") for part in parts)]
    says = f"{' with '.join(what).replace('_', ' ')}: {better} is better."
    return _mapping(mark, **value, better=Leaf(better, mark), says=Leaf(says[:1].upper() + says[1:], mark))


def _counter(node: Node, trees: Sequence[Entries]) -> dict[str, Node]:
    counter = entries_of(node)["counter"]
    if not _per(trees, "counters", _text(node, "counter")):
        return {"counter": counter}
    return {"sum": _mapping(node.mark, counter=counter, entity=Leaf("each", node.mark))}


def _time(tree: Entries, trees: Sequence[Entries], mark: Mark) -> dict[str, Node]:
    """The time of the ranking went on while the clock stood still, as a timer does."""
    phases = [phase for one in trees for phase in entries_of(one.entries.get("phases")).values()]
    if not any(_text(phase, "clock") == "stops" for phase in phases):
        return {"word": Leaf("time_s", mark)}
    name, timers = "played", tree.entries.get("timers") or Entries({}, mark)
    while _defines(trees, "timers", name):
        name += "_s"
    if isinstance(timers, Entries):
        timers.put(name, _mapping(mark, starts=Leaf(value=True, mark=mark)), mark)
        tree.put("timers", timers, mark)
    return {"timer": Leaf(name, mark)}


def _make_tables(tree: Entries) -> None:
    """A rule had the rows for which it was repeated in it: a list of names, or their values by name."""
    for name, rule in entries_of(tree.entries.get("rules")).items():
        rows = child(rule, "repeat_for")
        marks = {one.value: one.mark for one in items_of(rows) if isinstance(one, Leaf) and isinstance(one.value, str)}
        if isinstance(rows, Items) and len(marks) == len(rows.items):
            rows = Entries({one: Entries({}, mark) for one, mark in marks.items()}, rows.mark, marks)
        if isinstance(rows, Entries) and "param" not in rows.entries and isinstance(rule, Entries):
            tables, mark = tree.entries.get("tables") or Entries({}, rows.mark), rule.key_marks["repeat_for"]
            if isinstance(tables, Entries):
                tables.put(name, rows, mark)
                tree.put("tables", tables, mark)
                rule.put("repeat_for", Leaf(name, rows.mark), mark)


def _convert_value(node: Entries, trees: Sequence[Entries]) -> None:
    """A score was read like a counter, or as a word; that a robot is held had a key of its own."""
    name = "" if "action" in node.entries else _text(node, "counter")
    if name and not _defines(trees, "counters", name) and _defines(trees, "entrants", name):
        _rename(node, counter="score")
    elif _text(node, "word") == "score" and "of" in node.entries:
        node.drop("word")
        _rename(node, of="score")
    elif set(node.entries) == {"held"} and _text(node, "held"):
        _rename(node, held="entity")
        node.put("held", Leaf(value=True, mark=node.mark), node.mark)


def _per(trees: Sequence[Entries], section: str, name: str) -> str:
    entries = (entries_of(tree.entries.get(section)).get(name) for tree in trees)
    return next((_text(entry, "per") for entry in entries if entry is not None), "")


def _defines(trees: Sequence[Entries], section: str, name: str) -> bool:
    return any(name in entries_of(tree.entries.get(section)) for tree in trees)


def _rename(node: Entries, **keys: str) -> None:
    """Give keys their new names, in their places."""
    renamed = {keys.get(key, key): (inner, node.key_marks[key]) for key, inner in node.entries.items()}
    for key in list(node.entries):
        node.drop(key)
    for key, (inner, mark) in renamed.items():
        node.put(key, inner, mark)


class _Rule:
    """Converts a rule."""

    def __init__(self, rule: Node, trees: Sequence[Entries]) -> None:
        self._rule = rule
        self._trees = trees
        self._group = _text(rule, "for_each")

    def convert(self) -> None:
        """Convert amounts, conditions and what they compare with."""
        for node in _mappings(self._rule):
            keys = _ACTIONS.get(_text(node, "action"), ())
            for key in keys:
                self._amount(node, key)
            for key in ("at_least", "at_most", "equals"):
                self._bound(node, key)
            if keys:
                _limit_amount(node, keys)
            self._action(node)
            if "condition" in node.entries and _text(node, "trigger") != "holds":
                _convert_condition(node)
        for node in _mappings(self._rule):
            _flatten(node)

    def _action(self, action: Entries) -> None:
        """A flag was turned over, and a sequence reset, by an action of its own; without ``entity``, of all."""
        word, mark = _text(action, "action"), action.mark
        kept = ((f"{key}s", _text(action, key)) for key in ("counter", "flag", "timer", "sequence"))
        per = next((per for section, name in kept if (per := _per(self._trees, section, name))), "")
        if word not in ("", "reset") and self._group and per and "entity" not in action.entries:
            action.put("entity", Leaf(per, mark), mark)
        if word == "toggle_flag":
            action.put("action", Leaf("set_flag", mark), mark)
            action.put("to", Leaf("opposite", mark), mark)
        elif word == "sequence":
            action.entries["action"] = Leaf("reset", action.entries["action"].mark)
            action.entries.pop("do", None)

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
        if (
            in_list
            and self._group
            and "entity" not in part.entries
            and _per(self._trees, f"{kind}s", _text(part, kind))
        ):
            part = _mapping(node.mark, **{_OF_ALL[kind]: part})
        if (is_timer or word.endswith("_s")) and value_of(fraction) is not True:
            part.put("round", Leaf("down", node.mark), node.mark)
        if "distance" in part.entries or "told" in part.entries or word in ("measured", "limit"):
            part.put("otherwise", Leaf(0, node.mark), node.mark)
        if weight is None or value_of(weight) == 1:
            return part
        if "round" in part.entries:  # before the weight
            part = _mapping(node.mark, sum=Items([part], node.mark))
        part.put("times", weight, node.key_marks["weight"])
        return part

    def _bound(self, node: Entries, key: str) -> None:
        """``{lowest: COUNTER}`` is among all others in a rule for each that keeps the counter, else among all."""
        bound = node.entries.get(key)
        for word in ("lowest", "highest"):
            counter = _text(bound, word)
            if not counter or not isinstance(bound, Entries):
                continue
            entries: dict[str, Node] = {"counter": bound.entries[word]}
            if self._group and _per(self._trees, "counters", counter) in ("", self._group):
                entries["entity"] = Leaf("others", bound.mark)
            bound.entries[word] = _mapping(bound.entries[word].mark, **entries)


_KEYS = {
    "in_zone": {"zone": "in"}, "looks": {"towards": "looks", "heading_rad": "looks"}, "speed": {"entity": "speed"},
    "way": {"entity": "way"}, "drawn": {}, "last_touch": {"entity": "last_touch", "by": "equals"},
    "told": {"entity": "told"}, "sequence_at": {"step": "equals"}, "spot_free": {"spot": "spot_free"},
    "any_of": {"conditions": "any_of"}, "all_of": {"conditions": "any_of"}, "distance": {"entity": "distance"},
    "half": {"condition": "word"}, "held": {}, "counter": {}, "flag": {}, "timer": {},
}  # fmt: skip
"""By condition of version 1: keys that have other names now."""


def _convert_condition(node: Entries) -> None:
    word, mark = _text(node, "condition"), node.mark
    if word not in _KEYS:
        return
    if word == "half":
        node.put("condition", Leaf("halftime", mark), mark)
    else:
        node.drop("condition")
    if word == "last_touch" and "entity" not in node.entries:
        node.put("entity", Leaf("ball", mark), mark)
    _rename(node, **_KEYS[word])
    if word == "held":
        node.put("held", Leaf(value=True, mark=mark), mark)
    elif word == "distance" and {"distance", "to"} <= node.entries.keys():
        node.put("distance", Items([node.entries["distance"], node.entries["to"]], mark), mark)
        node.drop("to")
    elif word == "all_of" and isinstance(several := node.entries.get("any_of"), Items):
        node.put("any_of", Items([several], several.mark), mark)


def _flatten(node: Entries) -> None:
    """Conditions that must all hold stand in a list; ``holds`` has a list of them."""
    waited_for = node.entries.get("condition")
    if isinstance(waited_for, Entries):
        _rename(node, condition="conditions")
        node.put("conditions", Items(_all_of(waited_for) or [waited_for], waited_for.mark), waited_for.mark)
    for key in ("conditions", "any_of"):
        listed = items_of(node.entries.get(key))
        for at, one in reversed(list(enumerate(listed))):
            if inner := _all_of(one):
                listed[at : at + 1] = inner if key == "conditions" else [Items(inner, one.mark)]


def _all_of(node: Node) -> list[Node]:
    """Return the conditions of which all must hold; none if it is something else."""
    several = items_of(child(node, "any_of"))
    return items_of(several[0]) if len(several) == 1 and set(entries_of(node)) == {"any_of"} else []


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


def _text(node: Node | None, key: str) -> str:
    found = value_of(child(node, key))
    return found if isinstance(found, str) else ""


def _mappings(node: Node) -> list[Entries]:
    """Return all mappings in a value, itself included, inner ones first; later ones are not among them."""
    return [one for one in reversed([*nodes_in(node)]) if isinstance(one, Entries)]
