"""Drawing again and taking in late teams, after matches have counted."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict

from rcj_challenges.core.diagnostics import Diagnostic, DiagnosticError
from rcj_challenges.scenario.errors import listing
from rcj_challenges.tournament.codes import ADDED_TOO_LATE, UNKNOWN_TEAM
from rcj_challenges.tournament.drawing import Drawn
from rcj_challenges.tournament.engine import Season
from rcj_challenges.tournament.opened import OpenTournament, sides_of
from rcj_challenges.tournament.season import SeasonState, StageState, Status


def redraw(tournament: OpenTournament) -> list[str]:
    """Draw again with the teams and the seed of now; return lines about the results that count no more.

    Results of a round robin follow their pair to its new group and round, and seats and seed stay.
    """
    before, store, teams = tournament.drawn, tournament.store, tournament.teams
    stages = tournament.loaded.tournament.stages
    left = [team for team, one in teams.items() if one.withdrawn]
    drawn = Drawn.of(tournament.loaded.tournament.seed, teams)
    drawn.match_seed = before.match_seed
    drawn.left_out = {name: list(left) for name in stages if left}
    played = {fixture: one.sides for fixture, one in store.played().items()}
    ruled = {row.fixture: tuple(map(tuple, row.sides)) for row in tournament.held if row.fixture}
    known = {
        (fixture.partition("/")[0], sides): fixture
        for fixture, sides in (ruled | played).items()
        if "/play_off" not in fixture
    }
    Season(tournament.loaded, teams, drawn).state({})
    for name, stage in stages.items():
        if stage.FOLLOWS_PAIRS and stage.from_ is None:
            stage.keep_seats(drawn.draws[name], {(sides[0][0], sides[1][0]) for one, sides in known if one == name})
    moved = {}
    for fixture in Season(tournament.loaded, teams, drawn).state({}).fixtures:
        old = known.get((fixture.stage, sides_of(fixture)), fixture.id)
        first = before.moved.get(old, old)
        if stages[fixture.stage].FOLLOWS_PAIRS and first != fixture.id:
            moved[fixture.id], drawn.moved[fixture.id] = old, first
    store.keep_drawn(asdict(drawn), moved)
    tournament.refresh()
    state = tournament.state()
    count = sum(moved.get(fixture.id, fixture.id) in played for fixture in state.fixtures)
    lost = set(ruled).difference(moved.values(), before.moved.values(), (fixture.id for fixture in state.fixtures))
    lines = [f"the ruling on '{fixture}' counts no more" for fixture in sorted(lost)]
    return [f"drawn again: {count} of {len(played)} matches played so far still count", *lines]


def add_teams(tournament: OpenTournament, late: Sequence[str]) -> list[str]:
    """Take late teams in; return lines about the stages in which they play. Those that take part already are ignored.

    Raises:
        DiagnosticError: there is no such team, or it is too late for all stages.
    """
    if not late:
        return []
    drawn, teams, state = tournament.drawn, tournament.teams, tournament.state_as_drawn()
    lines = []
    for team in dict.fromkeys(late):
        if team not in teams:
            message = f"there is no team '{team}'"
            raise DiagnosticError(Diagnostic(UNKNOWN_TEAM, message, f"teams: {listing(teams, 30)}"))
        if team in drawn.pots:
            continue
        drawn.pots[team] = teams[team].pot
        open_to_all = [one for one in state.stages if tournament.loaded.tournament.stages[one.name].from_ is None]
        entered = [one.name for one in open_to_all if _enter(tournament, state, one, team)]
        too_late = [one.name for one in open_to_all if one.name not in entered]
        if not entered:
            message = f"it is too late for '{team}': {listing(too_late)} has been drawn or is finished"
            raise DiagnosticError(Diagnostic(ADDED_TOO_LATE, message, "remove it; or draw again with --redraw"))
        why = f"; too late for {listing(too_late)}" if too_late else ""
        lines.append(f"{team} plays from stage {entered[0]} on{why}")
    drawn.check(tournament.loaded.tournament.seed, teams)
    tournament.store.keep_drawn(asdict(drawn))
    tournament.refresh()
    return lines


def _enter(tournament: OpenTournament, state: SeasonState, one: StageState, team: str) -> bool:
    """Add a team to a stage; return whether it is not too late for that."""
    drawn, stage = tournament.drawn, tournament.loaded.tournament.stages[one.name]
    if not any(fixture.id in state.outcomes for fixture in one.fixtures):
        drawn.draws.pop(one.name, None)
        return True
    present = [other for other in drawn.pots if not tournament.teams[other].withdrawn]
    if one.status is Status.FINISHED or not stage.add_late(drawn.draws.get(one.name), team, present):
        drawn.left_out.setdefault(one.name, []).append(team)
        return False
    return True
