"""All checks of a scenario beyond its form: names, places, times, contradictions. One visible order."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from rcj_challenges.core.diagnostics import Diagnostic, InTree
from rcj_challenges.scenario.checks.consistency import check_consistency
from rcj_challenges.scenario.checks.ground import check_ground
from rcj_challenges.scenario.checks.magnitudes import check_magnitudes
from rcj_challenges.scenario.checks.naming import check_naming
from rcj_challenges.scenario.checks.references import check_references
from rcj_challenges.scenario.errors import MAX_FOUND
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.roster import Roster
from rcj_challenges.scenario.tree import (
    RESOLVED,
    Entries,
    Leaf,
    Mark,
    Path,
    format_path,
    mark_of,
    node_at,
    note_at,
)


def check(scenario: Scenario | None, tree: Entries, removed: Mapping[Path, Mark]) -> list[Diagnostic]:
    """Return the mistakes in a scenario whose parts may each be well formed; without models only names are checked."""
    roster = Roster.of_tree(tree)
    issues = [*check_naming(tree, roster, removed), *check_references(tree, roster, removed)][: 2 * MAX_FOUND]
    if scenario is not None:
        # What is out of all measure comes first and alone: it may be the cause of anything else.
        issues += tuple(check_magnitudes(scenario)) or (
            *check_ground(scenario),
            *check_consistency(
                scenario,
                is_half_set=_is_set(tree, "half_s") or _is_set(tree, "halves"),
                is_length_set=_is_set(tree, "half_s") and mark_of(tree, ("match", "half_s")).file != RESOLVED,
            ),
        )
    return [located(one, tree) for one in issues if not _may_follow_from_unknown(one, tree)]


def _is_set(tree: Entries, key: str) -> bool:
    """Return whether length or number of halves is set on the command line, also by a param, or read from a record.

    A half that was shortened in this way is no reason to rewrite the tests.
    """
    value = node_at(tree, ("match", key))
    param = value.param if isinstance(value, Leaf) else ""
    marks = mark_of(tree, ("match", key), at_key=True), *([mark_of(tree, ("params", param))] if param else [])
    return any(mark.file.startswith(("--set", RESOLVED)) for mark in marks)


def located(issue: Diagnostic, tree: Entries) -> Diagnostic:
    """Return an issue with its place in the file."""
    place = issue.where
    if not isinstance(place, InTree):
        return issue
    path, at_key = place.keys, place.at_key
    if place.other and mark_of(tree, path).file != tree.mark.file == mark_of(tree, place.other).file:
        path, at_key = place.other, False
    where = mark_of(tree, path, at_key=at_key).place(format_path(tree, path))
    return replace(issue, message=issue.message + note_at(tree, path), where=where)


def _may_follow_from_unknown(issue: Diagnostic, tree: Entries) -> bool:
    """Return whether a value in a mapping stands for a param that does not exist, which has been reported."""
    node = node_at(tree, issue.where.keys) if isinstance(issue.where, InTree) else None
    values = node.entries.values() if isinstance(node, Entries) else ()
    return any(isinstance(one, Leaf) and one.value is None and one.note == "unknown param" for one in values)
