"""All checks, and the function that runs them."""

from __future__ import annotations

from rcj_challenges.core.diagnostics import Diagnostic
from rcj_challenges.scenario.checks.run import located
from rcj_challenges.scenario.errors import place_of
from rcj_challenges.scenario.lint import flow, placing, state, values  # noqa: F401 - they define the checks
from rcj_challenges.scenario.lint.base import LintContext, LintRule
from rcj_challenges.scenario.load import Loaded
from rcj_challenges.scenario.reading.repeating import merged

LINT_RULES = tuple(check() for check in LintRule.__subclasses__())


def lint(loaded: Loaded) -> list[Diagnostic]:
    """Return the warnings about a valid scenario, in the order of the file; none if it came from a record."""
    tree = loaded.written
    if tree is None:
        return []  # nothing has a position
    ctx = LintContext(loaded, tree)
    found: list[Diagnostic] = []
    for rule in LINT_RULES:
        found += (located(one, tree) for one in rule.check(ctx))
    # What holds for several rules that came from one repeated rule is reported once, of that one.
    return sorted(merged(found, loaded.repeated), key=lambda one: _order(one, tree.mark.file))


def _order(warning: Diagnostic, own_file: str) -> tuple[bool, str, int, int, str, str]:
    place = place_of(warning)
    return place.file != own_file, place.file, place.line or 0, place.column or 0, place.path, warning.code
