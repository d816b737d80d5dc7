"""``rcj-challenge tournament decide``: a referee's ruling, or that a team leaves."""

from __future__ import annotations

from rcj_challenges.cli import OK
from rcj_challenges.cli.tournament_tables import score_words, team_words
from rcj_challenges.core.diagnostics import Diagnostic, DiagnosticError
from rcj_challenges.tournament.opened import OpenTournament
from rcj_challenges.tournament.played import RulingKind
from rcj_challenges.tournament.rulings import decide, withdraw
from rcj_challenges.tournament.season import SeasonState, Tie
from rcj_challenges.views.console import console_for


def record_decision(
    tournament: OpenTournament,
    match: str | None,
    reason: str,
    *,
    forfeit: list[str] | None,
    replay: bool,
    score: str | None,
    withdrawn: str | None,
    undo: bool,
    cascade: bool,
) -> int:
    """Record a decision, from the options as given; returns the exit code.

    Raises:
        DiagnosticError: options that do not fit together, or a decision that cannot be made.
    """
    kinds = {
        RulingKind.FORFEIT: bool(forfeit),
        RulingKind.REPLAY: replay,
        RulingKind.CORRECTED: score is not None,
        RulingKind.UNDONE: undo,
    }
    given = [kind for kind, is_given in kinds.items() if is_given]
    fits = given in ([], [RulingKind.UNDONE]) if match is None and withdrawn is not None else len(given) == 1
    if not fits or (match is None) != (withdrawn is not None):
        message = "a decision is about a match: --forfeit TEAM, --replay, --score A:B or --undo; or --withdraw TEAM"
        raise DiagnosticError(Diagnostic("which-decision", message, "give one of them; MATCH only for the first four"))
    before = tournament.state()
    if withdrawn is not None:
        lost = withdraw(tournament, withdrawn, reason, undo=undo, cascade=cascade)
    else:
        scores = _scores(score)
        lost = decide(tournament, match or "", given[0], reason, losers=forfeit or (), scores=scores, cascade=cascade)
    console = console_for()
    lines = [f"{fixture} is played again by the next run" for fixture in lost]
    for line in [*changes(before, tournament.state()), *lines] or ["recorded: no result changes"]:
        console.print(line, markup=False, highlight=False, soft_wrap=True)
    return OK


def changes(before: SeasonState, after: SeasonState) -> list[str]:
    """Return what is different, a line each: scores, winners of ties, and tables."""
    lines = []
    for fixture in after.fixtures:
        was, now = before.outcomes.get(fixture.id), after.outcomes.get(fixture.id)
        if was != now:
            shown = ["open" if one is None else score_words(fixture, one, after.teams) for one in (now, was)]
            lines.append(f"{fixture.id}: {' instead of '.join(shown)}")
    for old, new in zip(before.stages, after.stages, strict=True):
        winners = {tie.id: _winner(tie, before) for tie in old.ties}
        for tie in new.ties:
            was_winner, winner = winners.get(tie.id, ""), _winner(tie, after)
            if winner != was_winner:
                instead = f" instead of {was_winner}" if winner and was_winner else ""
                verb = "wins" if tie.round in ("final", "third_place") else "advances"
                lines.append(f"{tie.title}: {f'{winner} {verb}{instead}' if winner else 'open again'}")
        for was_table, table in zip(old.tables, new.tables, strict=False):
            places = [(row.team, row.place) for row in table.rows]
            if places != [(row.team, row.place) for row in was_table.rows]:
                ranked = ", ".join(f"{place} {team_words(after.teams, team)}" for team, place in places)
                lines.append(f"{new.title} {table.name}".strip() + f": {ranked}")
    return lines


def _winner(tie: Tie, state: SeasonState) -> str:
    return team_words(state.teams, tie.winner) if tie.winner else "neither team" if tie.decided_by else ""


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
