"""Play-offs: teams that share a place from which only some of them advance play each other for it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from rcj_challenges.tournament.formats.context import StageContext
from rcj_challenges.tournament.formats.groups import pairings
from rcj_challenges.tournament.formats.tie import TieGame
from rcj_challenges.tournament.models import MatchesModel
from rcj_challenges.tournament.season import Fixture, Row, Table, humanized
from rcj_challenges.tournament.standings import table


def play_offs(context: StageContext, stage: MatchesModel, found: Table, round_: int) -> tuple[Table, list[Fixture]]:
    """Return a complete table with the play-offs that it needs, and their fixtures.

    Two teams play one tie; more play each other once, and what is level after that is decided by lot. The play-offs
    begin in ``round_``.
    """
    rows = list(found.rows)
    fixtures: list[Fixture] = []
    is_complete = True
    start = 0
    while start < len(rows):
        level = [row for row in rows if row.place == rows[start].place]
        end = start + len(level)
        if len(level) > 1 and any(start < cut < end for cut in context.cuts):
            ranked, more = _play(context, stage, found.name, level, round_)
            fixtures += more
            is_complete = is_complete and ranked is not None
            rows[start:end] = ranked or level
        start = end
    return replace(found, rows=tuple(rows), complete=is_complete), fixtures


def _play(
    context: StageContext, stage: MatchesModel, group: str, level: Sequence[Row], round_: int
) -> tuple[list[Row] | None, list[Fixture]]:
    """Return the rows of level teams in their new order, None if they still play, and the fixtures."""
    teams, place = [row.team for row in level], level[0].place
    path = f"{group}/play_off{place}" if group else f"play_off{place}"
    title = f"{f'Group {humanized(group)}, play-off' if group else 'Play-off'} for place {place}"
    if len(teams) == 2:
        tie = TieGame(context, stage, path, (teams[0], teams[1]), round_, title, group).result()
        if tie.decided_by and not tie.winner:
            return list(level), tie.fixtures
        order = {team: 0 if team == tie.winner else 1 for team in teams} if tie.winner else {}
        by_lot = set(teams) if tie.decided_by == "lot" else set()
        fixtures = tie.fixtures
    else:
        fixtures = []
        for number, pairs in enumerate(pairings(len(teams))):
            for one, other in pairs:
                pair = (teams[one], teams[other])
                fixture = context.match(f"{path}/round{number + 1}", stage, pair, round_ + number, title, group)
                context.lose_if_left(fixture)
                fixtures.append(fixture)
        order, by_lot = {}, set()
        if context.are_decided(fixtures):
            rules = context.rules(path, with_lot=True)
            ranked = table(group, teams, context.matches(fixtures), rules, complete=True).rows
            order = {row.team: row.place - 1 for row in ranked}
            by_lot = {row.team for row in ranked if row.by_lot}
    if not order:
        return None, fixtures
    rows = [
        replace(row, place=place + order[row.team], shared=False, by_lot=row.team in by_lot)
        for row in sorted(level, key=lambda row: order[row.team])
    ]
    return rows, fixtures
