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
    problems = alike((problem for problem, *_ in found), loaded.repeated)
    unique = dict.fromkeys((problem, *rest) for problem, (_, *rest) in zip(problems, found, strict=True))
    own = tree.mark.file
    in_order = sorted(unique, key=lambda one: (one[0].file != own, one[0].file, one[0].line, one[0].column, one[1]))
    return [
        Diagnostic(code, problem.message, help_, InFile(problem.file, problem.line or None, problem.column or None, problem.path), "warning")
        for problem, code, help_ in in_order
    ]
