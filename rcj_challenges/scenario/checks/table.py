"""All checks of a scenario beyond its form: names, places, times, contradictions. One visible order."""

from __future__ import annotations

from collections.abc import Mapping

from rcj_challenges.scenario.catalogue import Catalogue
from rcj_challenges.scenario.checks.crossrefs import check_references, shown_path
from rcj_challenges.scenario.checks.ground import check_ground
from rcj_challenges.scenario.checks.magnitudes import check_magnitudes
from rcj_challenges.scenario.checks.naming import check_names
from rcj_challenges.scenario.checks.sense import check_sense
from rcj_challenges.scenario.errors import MAX_FOUND, Problem
from rcj_challenges.scenario.measured import check_measured
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.tree import RESOLVED, Entries, Leaf, Mark, Node, Path, mark_of, node_at


def check(scenario: Scenario | None, tree: Entries, removed: Mapping[Path, Mark]) -> list[Problem]:
    """Return what is wrong with a scenario whose parts may each be well formed.

    Args:
        scenario: the models; None if the tree has not the form of a scenario: then only names are checked.
        tree: the finished tree.
        removed: where entries of a base were removed.
    """
    catalogue = Catalogue(tree)
    problems = [*check_names(catalogue, removed), *check_references(catalogue, removed)]
    if scenario is None:
        return problems[: 2 * MAX_FOUND]
    # Whoever shortens a half on the command line does not mean to rewrite the tests; a record holds such a half.
    written_in = {key: mark_of(tree, ("match", key), at_key=True).file for key in ("half_s", "halves")}
    half_is_set = any(file.startswith(("--set", RESOLVED)) for file in written_in.values())
    lengths_are_set = written_in["half_s"].startswith("--set")
    # What is out of all measure comes first and alone: nothing else can be told of it.
    found = tuple(check_magnitudes(scenario)) or (
        *check_ground(scenario), *check_measured(scenario),
        *check_sense(scenario, half_is_set=half_is_set, lengths_are_set=lengths_are_set),
    )  # fmt: skip
    for path, message, at_key, other in found:
        if other and mark_of(tree, path).file != tree.mark.file == mark_of(tree, other).file:
            path, at_key = other, False  # noqa: PLW2901 - the other place takes over
        leaf = node_at(tree, path)
        if isinstance(leaf, Entries) and any(_is_unknown(entry) for entry in leaf.entries.values()):
            continue  # what is said of it may follow from the value that is not known
        note = f" ({leaf.note})" if isinstance(leaf, Leaf) and leaf.note else ""
        mark = mark_of(tree, path, at_key=at_key)
        problems.append(mark.problem(shown_path(tree, path), message + note))
    return problems


def _is_unknown(node: Node) -> bool:
    """Return whether a value stands for a param that does not exist, as has been said of it."""
    return isinstance(node, Leaf) and node.value is None and node.note == "unknown param"
