"""The list of checks, and the function that runs them."""

from __future__ import annotations

from rcj_challenges.facts.diagnostics import Diagnostic, InFile
from rcj_challenges.scenario.checks.crossrefs import shown_path
from rcj_challenges.scenario.errors import Problem
from rcj_challenges.scenario.lint import flow, placing, state, values
from rcj_challenges.scenario.lint.base import LintRule
from rcj_challenges.scenario.lint.context import LintContext
from rcj_challenges.scenario.load import Loaded
from rcj_challenges.scenario.reading.repeating import alike
from rcj_challenges.scenario.tree import Leaf, mark_of, node_at

LINT_RULES: tuple[LintRule, ...] = (
    flow.PhaseNeverEntered(),
    flow.RuleNeverFires(),
    flow.EventNeverEmitted(),
    flow.EventLoop(),
    flow.MissingSays(),
    flow.EachOfNone(),
    flow.EachNeverNamed(),
    flow.EachNotInTrigger(),
    flow.SequenceNeverBreaks(),
    flow.NoWayToScore(),
    flow.CriterionAlwaysEqual(),
    flow.HalfNeverPlayed(),
    state.NeverRead(),
    state.NeverWritten(),
    state.NeverUsed(),
    state.HeldForever(),
    state.InheritedTestLeftOut(),
    values.LimitTooLong(),
    values.AngleInDegrees(),
    values.NeverReached(),
    values.ExactMeasurement(),
    values.UnknownPlaceholder(),
    values.PlaceholderNeverFilled(),
    placing.OffTheField(),
    placing.RobotWithoutProgram(),
    placing.NeverOnTheField(),
    placing.TwoRulesMoveOneThing(),
    placing.NoRoom(),
)


def lint(loaded: Loaded) -> list[Diagnostic]:
    """Return the warnings about a valid scenario, in the order of the file.

    Args:
        loaded: a scenario that came from a file or a text.

    Raises:
        ValueError: it came from a record, so that nothing has a position.
    """
    ctx = LintContext.of(loaded)
    tree = ctx.tree
    found: list[tuple[Problem, str, str]] = []
    for rule in LINT_RULES:
        for suspicion in rule.check(ctx):
            mark = mark_of(tree, suspicion.path, at_key=suspicion.at_key)
            leaf = node_at(tree, suspicion.path)
            note = f" ({leaf.note})" if isinstance(leaf, Leaf) and leaf.note else ""
            problem = mark.problem(shown_path(tree, suspicion.path), suspicion.message + note)
            found.append((problem, suspicion.code, suspicion.help))
    # What holds for several rules that came of one repeated rule is reported once, of that one.
    problems = alike((problem for problem, _, _ in found), loaded.repeated)
    unique = {(problem, code, help_) for problem, (_, code, help_) in zip(problems, found, strict=True)}
    own = tree.mark.file
    return [
        Diagnostic(code, problem.message, help_, _place(problem), "warning")
        for problem, code, help_ in sorted(unique, key=lambda one: _order(one[0], own) + one[1:])
    ]


def _order(problem: Problem, own_file: str) -> tuple[bool, str, int, int, str]:
    return problem.file != own_file, problem.file, problem.line, problem.column, problem.path


def _place(problem: Problem) -> InFile:
    return InFile(problem.file, problem.line or None, problem.column or None, problem.path)
