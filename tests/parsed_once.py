"""Parses the same bytes once, and loads what is shipped once: thousands of tests read the match, or what it extends."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import Any

from rcj_challenges.scenario import load
from rcj_challenges.scenario.reading import extend
from rcj_challenges.scenario.tree import Entries, Items, Leaf, Node

_SHIPPED_WITH = Path(__file__).resolve().parents[1]


@dataclass
class Root(Entries):
    """The tree of a file that can be compared with another by what it was parsed from."""

    parsed_from: tuple[bytes, str] = (b"", "")


def copied(node: Node) -> Node:
    """Return a copy of a tree that can be changed, with the same marks, which cannot."""
    if isinstance(node, Entries):
        return Entries({key: copied(value) for key, value in node.entries.items()}, node.mark, dict(node.key_marks))
    if isinstance(node, Items):
        return Items([copied(value) for value in node.items], node.mark)
    return Leaf(node.value, node.mark, node.empty, node.note)


def parse_once() -> None:
    """Let scenarios be read so until the tests are over. To parse one takes eight times as long as to copy its tree."""
    parsed = lru_cache(maxsize=64)(extend.parse_bytes)

    def parse(data: bytes, file: str) -> Node:
        tree = copied(parsed(data, file))
        return Root(tree.entries, tree.mark, tree.key_marks, (data, file)) if isinstance(tree, Entries) else tree

    extend.parse_bytes = parse


def load_once() -> None:
    """Let shipped scenarios be loaded so until the tests are over: loading them again took a quarter of some rooms."""
    loaded: dict[Any, load.Loaded] = {}
    load_uncached = load._load

    def load_first(source: extend.Source, overrides: Sequence[str], name: str, path: Path | None) -> load.Loaded:
        if path is None or not path.is_relative_to(_SHIPPED_WITH):
            return load_uncached(source, overrides, name, path)
        files = tuple(
            (one.tree.parsed_from, one.path) for one in extend.read_chain(source) if isinstance(one.tree, Root)
        )
        key = files, tuple(overrides), name, path
        if key not in loaded:
            loaded[key] = load_uncached(source, overrides, name, path)
        return loaded[key]

    load._load = load_first
