"""``rcj-challenge tournament decide``: a referee's ruling, or that a team leaves."""

from __future__ import annotations

from rcj_challenges.cli import OK
from rcj_challenges.core.diagnostics import Diagnostic, DiagnosticError
from rcj_challenges.tournament.opened import OpenTournament
from rcj_challenges.tournament.played import RulingKind
from rcj_challenges.tournament.rulings import decide, withdraw
from rcj_challenges.views.console import console_for


def record_decision(
    tournament: OpenTournament,
    match: str | None,
    reason: str,
    *,
    forfeit: str | None,
    replay: bool,
    score: str | None,
    withdrawn: str | None,
    cascade: bool,
) -> int:
    """Record a decision, from the options as given; returns the exit code.

    Raises:
        DiagnosticError: options that do not fit together, or a decision that cannot be made.
    """
    kinds = {
        RulingKind.FORFEIT: forfeit is not None,
        RulingKind.REPLAY: replay,
        RulingKind.CORRECTED: score is not None,
    }
    given = [kind for kind, is_given in kinds.items() if is_given]
    if len(given) + (withdrawn is not None) != 1 or (match is None) != (withdrawn is not None):
        message = "a decision is either about a match: --forfeit TEAM, --replay or --score A:B, or --withdraw TEAM"
        raise DiagnosticError(Diagnostic("which-decision", message, "give one of them; MATCH only for the first three"))
    if withdrawn is not None:
        lost = withdraw(tournament, withdrawn, reason, cascade=cascade)
    else:
        scores = _scores(score)
        lost = decide(tournament, match or "", given[0], reason, loser=forfeit or "", scores=scores, cascade=cascade)
    console = console_for()
    lines = [f"{fixture} will be played again" for fixture in lost]
    for line in ("recorded", *lines):
        console.print(line, markup=False, highlight=False, soft_wrap=True)
    return OK


def _scores(text: str | None) -> list[float]:
    """Return the numbers of ``2:1``.

    Raises:
        DiagnosticError: it is not a score.
    """
    try:
        scores = [] if text is None else [float(part) for part in text.split(":")]
    except ValueError:
        scores = [-1.0]
    if any(not 0 <= score < float("inf") for score in scores):
        raise DiagnosticError(Diagnostic("ruling-score", f"not a score: '{text}'", "write it as 2:1"))
    return scores
