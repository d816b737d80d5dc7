"""Tests that a scenario inherits from what it extends, and that do not fit it any more.

A scenario that plays the match with two robots a side, or for three minutes, changes a line or two. The base's tests of
what it removed are not mistakes of its author: they are left out, and lint says which.
"""

from __future__ import annotations

import re
from collections.abc import Collection

from rcj_challenges.core.diagnostics import Diagnostic
from rcj_challenges.scenario.errors import ScenarioError, place_of
from rcj_challenges.scenario.tree import Entries, nodes_in

TESTS = "expect"
ALL_INHERITED = "inherited"
"""With ``null``, in place of a test's name: all tests of the base."""


def unfit_tests(error: ScenarioError, tree: Entries, bases: Collection[str]) -> dict[str, Diagnostic]:
    """Return the first mistake in each test that stands as a whole in what the scenario extends, by name of the test.

    The bases are the files that it extends, as marks name them.
    """
    tests = tree.entries.get(TESTS)
    found: dict[str, Diagnostic] = {}
    for problem in error.diagnostics:
        section, _, rest = place_of(problem).path.partition(".")
        name = re.split(r"[.\[]", rest, maxsplit=1)[0]
        if section == TESTS and isinstance(tests, Entries) and name in tests.entries:
            marks = [tests.key_marks[name], *(node.mark for node in nodes_in(tests.entries[name]))]
            if all(mark.file in bases for mark in marks):
                found.setdefault(name, problem)
    return found
