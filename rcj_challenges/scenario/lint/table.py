"""Lint: what is legal in a scenario and hardly meant. One visible table of checks.

An error says that a scenario cannot be used; a finding says that it can, and that its author should look again. Only
what can be decided from the file is reported: no finding rests on how a match might go.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Any

from rcj_challenges.scenario.checks.crossrefs import shown_path
from rcj_challenges.scenario.errors import Problem
from rcj_challenges.scenario.lint.about import check_heard_about
from rcj_challenges.scenario.lint.angles import check_angles
from rcj_challenges.scenario.lint.beside import check_beside
from rcj_challenges.scenario.lint.bounds import check_bounds
from rcj_challenges.scenario.lint.denied import check_contradictions
from rcj_challenges.scenario.lint.distances import check_distances
from rcj_challenges.scenario.lint.echoes import check_echoes
from rcj_challenges.scenario.lint.edges import check_edges, check_exclusive_groups
from rcj_challenges.scenario.lint.exactly import check_exactly
from rcj_challenges.scenario.lint.flow import (
    check_any_for_each,
    check_events,
    check_events_of_one,
    check_phases,
    check_rules,
    check_scoring,
)
from rcj_challenges.scenario.lint.gone import check_gone
from rcj_challenges.scenario.lint.ground import check_entities, check_layouts, check_obstacles, check_places
from rcj_challenges.scenario.lint.heard import check_heard
from rcj_challenges.scenario.lint.held import check_held, check_holds
from rcj_challenges.scenario.lint.ignored import check_ignored
from rcj_challenges.scenario.lint.judged import check_judged_twice
from rcj_challenges.scenario.lint.kicks import check_kicks
from rcj_challenges.scenario.lint.literals import check_literals, check_told_names
from rcj_challenges.scenario.lint.locked import check_locked
from rcj_challenges.scenario.lint.moments import check_moments
from rcj_challenges.scenario.lint.numbers import check_numbers, check_written_out
from rcj_challenges.scenario.lint.others import check_others
from rcj_challenges.scenario.lint.put_back import check_put_back
from rcj_challenges.scenario.lint.repeated import check_groups_of_groups, check_repeated
from rcj_challenges.scenario.lint.result import check_ranking
from rcj_challenges.scenario.lint.says import check_broadcast, check_description, check_sentences
from rcj_challenges.scenario.lint.sides import check_sides
from rcj_challenges.scenario.lint.speeds import check_speeds
from rcj_challenges.scenario.lint.state import (
    check_drawn_names,
    check_draws,
    check_inherited_tests,
    check_params,
    check_spots,
    check_state,
    check_unused,
)
from rcj_challenges.scenario.lint.steps import check_kept_steps
from rcj_challenges.scenario.lint.sums import check_numbers_alone, check_sums
from rcj_challenges.scenario.lint.suspect import Subject, Suspect
from rcj_challenges.scenario.lint.times import (
    check_ends,
    check_halves,
    check_last_tick,
    check_phase_limits,
    check_reached,
    check_rests,
    check_times,
)
from rcj_challenges.scenario.lint.touched import (
    check_forgotten_touches,
    check_last_touches,
    check_touched,
    check_touching_itself,
)
from rcj_challenges.scenario.lint.unheard import check_unheard
from rcj_challenges.scenario.lint.units import check_units
from rcj_challenges.scenario.lint.variants import (
    check_field_size,
    check_goals,
    check_idle_robots,
    check_inherited_sentences,
    check_inherited_texts,
    check_kits,
)
from rcj_challenges.scenario.lint.walled import check_walled_zones
from rcj_challenges.scenario.load import Loaded
from rcj_challenges.scenario.reading.merge import Repeated
from rcj_challenges.scenario.reading.repeating import alike
from rcj_challenges.scenario.tree import Leaf, mark_of, node_at

CHECKS: tuple[Callable[[Subject], Iterator[Suspect]], ...] = (
    check_phases,
    check_events,
    check_events_of_one,
    check_any_for_each,
    check_heard_about,
    check_echoes,
    check_rules,
    check_repeated,
    check_groups_of_groups,
    check_contradictions,
    check_touched,
    check_touching_itself,
    check_last_touches,
    check_forgotten_touches,
    check_judged_twice,
    check_moments,
    check_unheard,
    check_sentences,
    check_description,
    check_units,
    check_broadcast,
    check_literals,
    check_told_names,
    check_scoring,
    check_bounds,
    check_ranking,
    check_edges,
    check_exclusive_groups,
    check_state,
    check_locked,
    check_others,
    check_numbers_alone,
    check_sums,
    check_draws,
    check_drawn_names,
    check_spots,
    check_params,
    check_unused,
    check_times,
    check_phase_limits,
    check_halves,
    check_ends,
    check_reached,
    check_last_tick,
    check_rests,
    check_kept_steps,
    check_sides,
    check_places,
    check_distances,
    check_speeds,
    check_exactly,
    check_obstacles,
    check_entities,
    check_layouts,
    check_beside,
    check_put_back,
    check_gone,
    check_kicks,
    check_ignored,
    check_field_size,
    check_goals,
    check_walled_zones,
    check_inherited_sentences,
    check_numbers,
    check_written_out,
    check_angles,
    check_inherited_texts,
    check_kits,
    check_idle_robots,
    check_held,
    check_heard,
    check_holds,
    check_inherited_tests,
)


@dataclass(frozen=True)
class Finding:
    """Something to look at again.

    Attributes:
        kind: which check found it: ``event_never_emitted``.
        problem: where it is, and the reason.
        remedy: what to do about it.
    """

    kind: str
    problem: Problem
    remedy: str

    def __str__(self) -> str:
        problem = self.problem
        where = f"{problem.file}:{problem.line}:{problem.column}" if problem.line else problem.file
        reason = ": ".join(part for part in (problem.path, problem.message) if part)
        # A reason may end in "did you mean 'GOAL'?"; what follows a question needs no other mark.
        mark = "" if reason.endswith("?") else ";"
        return f"{where}: warning: {reason}{mark} {self.remedy} [{self.kind}]"

    def as_json(self) -> dict[str, Any]:
        """Return it as JSON-able data."""
        problem = self.problem
        return {
            "kind": self.kind,
            "file": problem.file,
            "line": problem.line,
            "column": problem.column,
            "path": problem.path,
            "reason": problem.message,
            "remedy": self.remedy,
        }


def lint(loaded: Loaded) -> list[Finding]:
    """Return what the author of a checked scenario should look at again, in the order of the file.

    Args:
        loaded: a scenario that came from a file or a text.

    Raises:
        ValueError: the scenario was not loaded from a file or a text, so that nothing has a place.
    """
    tree = loaded.written
    if tree is None:
        message = "lint needs a scenario that was loaded from a file or a text"
        raise ValueError(message)
    changes = loaded.removed, loaded.replaced, loaded.repeated, loaded.overridden
    subject = Subject(loaded.scenario, loaded.roster, tree, loaded.left_out, *changes)
    findings = []
    for check in CHECKS:
        for suspect in check(subject):
            mark = mark_of(tree, suspect.path, at_key=suspect.at_key)
            leaf = node_at(tree, suspect.path)
            note = f" ({leaf.note})" if isinstance(leaf, Leaf) and leaf.note else ""
            problem = mark.problem(shown_path(tree, suspect.path), suspect.reason + note)
            findings.append(Finding(suspect.kind, problem, suspect.remedy))
    findings = _told_once(findings, loaded.repeated)
    own = tree.mark.file
    return sorted(
        dict.fromkeys(findings),
        key=lambda f: (f.problem.file != own, f.problem.file, f.problem.line, f.problem.column, f.kind),
    )


def _told_once(findings: list[Finding], repeated: Mapping[str, Repeated]) -> list[Finding]:
    """Return findings in which what holds for several rules that came of one is said of that one, once."""
    same = alike((finding.problem for finding in findings), repeated)
    return [replace(finding, problem=problem) for finding, problem in zip(findings, same, strict=True)]
