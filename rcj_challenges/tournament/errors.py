"""What is wrong with a tournament file: each mistake with a code, its place, and what to do about it."""

from __future__ import annotations

from collections.abc import Iterable

from rcj_challenges.core.diagnostics import Diagnostic, DiagnosticError, InFile
from rcj_challenges.scenario import errors


class TournamentFileError(DiagnosticError):
    """A tournament file cannot be used; its diagnostics stand in the order of the file."""

    def __init__(self, problems: Iterable[Diagnostic]) -> None:
        super().__init__(*sorted(dict.fromkeys(problems), key=_position))


def did_you_mean(word: str, known: Iterable[str], then: str = "") -> str:
    """Return ``did you mean 'x'?`` for the known word that is most like ``word``, if there is one, and then a text."""
    return f"{errors.did_you_mean(word, known)} {then}".strip()


def _position(problem: Diagnostic) -> tuple[str, int, int, str]:
    where = problem.where if isinstance(problem.where, InFile) else InFile("")
    return where.file, where.line or 0, where.column or 0, problem.code
