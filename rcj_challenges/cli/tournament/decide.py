"""``rcj-challenge tournament decide``: a referee's ruling, or that a team leaves."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

import typer

from rcj_challenges.cli.app import ORGANIZE
from rcj_challenges.cli.stdio import print_lines
from rcj_challenges.cli.tournament.group import Cascade, Data, File, opened, tournament_app
from rcj_challenges.cli.tournament.tables import score_words, team_words
from rcj_challenges.core.diagnostics import Diagnostic, DiagnosticError
from rcj_challenges.tournament.codes import WHICH_DECISION

if TYPE_CHECKING:
    from rcj_challenges.tournament.season import SeasonState, Tie


@tournament_app.register(ORGANIZE, 'rcj-challenge tournament decide cup MATCH --replay --reason "a robot broke"')
def decide(
    file: File,
    match: Annotated[
        str | None, typer.Argument(metavar="[MATCH]", help="Which match, as plan prints it; none with --withdraw.")
    ] = None,
    reason: Annotated[str, typer.Option("--reason", metavar="TEXT", help="Why; it is published.")] = "",
    forfeit: Annotated[
        list[str] | None,
        typer.Option("--forfeit", metavar="TEAM", help="This team loses the match; given for both, both lose."),
    ] = None,
    replay: Annotated[bool, typer.Option("--replay", help="The match is played again with a different seed.")] = False,
    score: Annotated[
        str | None, typer.Option("--score", metavar="A:B", help="The score is corrected: sides as plan prints them.")
    ] = None,
    withdraw: Annotated[
        str | None, typer.Option("--withdraw", metavar="TEAM", help="This team leaves the tournament.")
    ] = None,
    undo: Annotated[
        bool, typer.Option("--undo", help="Take the last ruling on the match back, or with --withdraw a withdrawal.")
    ] = False,
    cascade: Cascade = False,
    data: Data = None,
) -> None:
    """Record a referee's ruling on a match, or the withdrawal of a team; it is always shown as a ruling."""
    from rcj_challenges.tournament import rulings
    from rcj_challenges.tournament.played import RulingKind
    from rcj_challenges.views.console import console_for

    kinds = {
        RulingKind.FORFEIT: bool(forfeit),
        RulingKind.REPLAY: replay,
        RulingKind.CORRECTED: score is not None,
        RulingKind.UNDONE: undo,
    }
    given = [kind for kind, is_given in kinds.items() if is_given]
    fits = given in ([], [RulingKind.UNDONE]) if match is None and withdraw is not None else len(given) == 1
    if not fits or (match is None) != (withdraw is not None):
        message = "a decision is about a match: --forfeit TEAM, --replay, --score A:B or --undo; or --withdraw TEAM"
        raise DiagnosticError(Diagnostic(WHICH_DECISION, message, "give one of them; MATCH only for the first four"))
    with opened(file, data, writing=True) as tournament:
        before = tournament.state()
        if withdraw is not None:
            lost = rulings.withdraw(tournament, withdraw, reason, undo=undo, cascade=cascade)
        else:
            scores = rulings.scores_of(score or "")
            lost = rulings.decide(
                tournament, match or "", given[0], reason, losers=forfeit or (), scores=scores, cascade=cascade
            )
        after = tournament.state()
    lines = [f"{fixture} is played again by the next run" for fixture in lost]
    print_lines(console_for(), *([*_changes(before, after), *lines] or ["recorded: no result changes"]))


def _changes(before: SeasonState, after: SeasonState) -> list[str]:
    """Differences, a line each: scores, winners of ties, and tables."""
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
