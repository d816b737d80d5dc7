"""The pages of the codes that scenarios bring: errors, and the warnings of lint."""

from __future__ import annotations

import inspect

from rcj_challenges.scenario.lint.base import LintRule
from rcj_challenges.scenario.lint.registry import LINT_RULES


def _page(rule: LintRule) -> str:
    texts = f"warning: {rule.message}\nhelp: {rule.help}".replace("{{", "{").replace("}}", "}")
    return f"{inspect.getdoc(type(rule))}\n\n{texts}"


PAGES: dict[str, str] = {
    "scenario-too-large": (
        "The scenario has more bytes, entries or values than any contest needs, with those of the files it extends.\n\n"
        "Leave out what the challenge does not need; repeat_for and groups say the same of several things at once."
    ),
    **{rule.code: _page(rule) for rule in LINT_RULES},
}
