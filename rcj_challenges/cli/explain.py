"""``rcj-challenge explain``: prints the page of a code, or the list of all codes."""

from __future__ import annotations

import inspect
import sys
from difflib import get_close_matches

from rcj_challenges.cli.validate import say
from rcj_challenges.facts.diagnostics import Diagnostic, DiagnosticError


def explain(code: str | None) -> int:
    """Print the page of a code, or all codes with their first sentence; returns 0.

    Raises:
        DiagnosticError: there is no such code.
    """
    pages = code_pages()
    if code is None:
        width = max(map(len, pages))
        for name, page in sorted(pages.items()):
            say(f"{name:{width}}  {page.splitlines()[0]}", sys.stdout)
        return 0
    if code not in pages:
        near = get_close_matches(code, pages, 1)
        hint = f"did you mean '{near[0]}'? " if near else ""
        raise DiagnosticError(
            Diagnostic("unknown-code", f"unknown code '{code}'", f"{hint}rcj-challenge explain lists all codes")
        )
    say(f"{code}\n\n{pages[code]}", sys.stdout)
    return 0


def code_pages() -> dict[str, str]:
    """Return the page of each code: what it means, its message and its help."""
    from rcj_challenges.scenario.lint.registry import LINT_RULES

    pages = {}
    for rule in LINT_RULES:
        texts = f"warning: {rule.message}\nhelp: {rule.help}".replace("{{", "{").replace("}}", "}")
        pages[rule.code] = f"{inspect.getdoc(type(rule))}\n\n{texts}"
    return pages
