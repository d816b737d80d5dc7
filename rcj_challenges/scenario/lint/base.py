"""The form of a check."""

from __future__ import annotations

from collections.abc import Iterator
from typing import ClassVar

from rcj_challenges.scenario.lint.context import LintContext
from rcj_challenges.scenario.tree import Path
from rcj_challenges.scenario.walk import Issue


class LintRule:
    """A check. Its docstring is the page of its code; ``message`` and ``help`` are filled in where it reports.

    Attributes:
        at_key: whether the key is reported, not its value.
    """

    code: ClassVar[str]
    message: ClassVar[str]
    help: ClassVar[str]
    at_key: ClassVar[bool] = False

    def check(self, ctx: LintContext) -> Iterator[Issue]:
        """Yield what is suspicious."""
        raise NotImplementedError

    def at(self, path: Path, *, help: str = "", **values: object) -> Issue:  # noqa: A002 - as it is printed
        """Return an issue at a path, with the templates filled in; ``help`` replaces the check's own."""
        return Issue(self.code, path, self.message.format(**values), (help or self.help).format(**values), self.at_key)
