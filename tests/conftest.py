"""For all tests: what they start can be interrupted, and what was collected is no garbage."""

import gc
import signal
from collections.abc import Iterator
from functools import lru_cache

import pytest

from rcj_challenges.scenario import extend
from rcj_challenges.scenario.tree import Entries, Items, Leaf, Node

# A shell lets what it starts with `&` ignore Ctrl-C, `nohup` the end of a terminal; a process inherits what is ignored.
if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)
if hasattr(signal, "SIGHUP") and signal.getsignal(signal.SIGHUP) is signal.SIG_IGN:
    signal.signal(signal.SIGHUP, signal.SIG_DFL)


@pytest.hookimpl(wrapper=True)
def pytest_collection(session: pytest.Session) -> Iterator[None]:
    """Let nobody look for garbage among what stays to the end: some hundred thousand objects, again and again.

    Searching them took a quarter of the time of collecting, and a tenth of that of the tests.
    """
    gc.disable()
    try:
        return (yield)
    finally:
        gc.collect()
        gc.freeze()
        gc.enable()


def copied(node: Node) -> Node:
    """Return a copy of a tree that can be changed, with the same marks, which cannot."""
    if isinstance(node, Entries):
        return Entries({key: copied(value) for key, value in node.entries.items()}, node.mark, dict(node.key_marks))
    if isinstance(node, Items):
        return Items([copied(value) for value in node.items], node.mark)
    return Leaf(node.value, node.mark, node.empty, node.note)


@pytest.fixture(scope="session", autouse=True)
def _files_are_parsed_once() -> Iterator[None]:
    """Parse the same bytes once: thousands of tests read the match, or what it extends.

    To parse it takes eight times as long as to copy the tree.
    """
    parsed = lru_cache(maxsize=64)(extend.parse_bytes)
    with pytest.MonkeyPatch.context() as patched:
        patched.setattr(extend, "parse_bytes", lambda data, file: copied(parsed(data, file)))
        yield
