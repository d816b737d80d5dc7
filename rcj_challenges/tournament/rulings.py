"""Decisions of a human referee: kept and shown for ever."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from difflib import get_close_matches

from rcj_challenges.core.code import Code
from rcj_challenges.core.diagnostics import Diagnostic, DiagnosticError
from rcj_challenges.records.folder import utc_now
from rcj_challenges.tournament import codes
from rcj_challenges.tournament.models import LostBy
from rcj_challenges.tournament.opened import OpenTournament, last_ruling, later_stages, sides_of
from rcj_challenges.tournament.played import RulingKind
from rcj_challenges.tournament.reconcile import stage_closed
from rcj_challenges.tournament.season import Fixture, Ruled, SeasonState
from rcj_challenges.tournament.store.tables import RulingRow

_LOST_BY = (0.0, 3.0)
_MAX_REASON_CHARS = 500


def decide(
    tournament: OpenTournament,
    fixture_id: str,
    kind: RulingKind,
    reason: str,
    *,
    losers: Sequence[str] = (),
    scores: Sequence[float] = (),
    cascade: bool = False,
) -> list[str]:
    """Note a ruling on a match; returns the fixtures of later rounds and stages that have to be played again.

    Args:
        tournament: its store is open for writing.
        fixture_id: of the match.
        kind: of the decision.
        reason: in the referee's words; it is published.
        losers: of a forfeit: a team of each side that forfeits.
        scores: of a corrected score, by side.
        cascade: whether matches of later rounds and stages that were played may change.

    Raises:
        DiagnosticError: there is no such match or team, the ruling does not fit it, or changes a match played later.
    """
    before = tournament.state()
    fixtures = {one.id: one for one in before.fixtures}
    if fixture_id not in fixtures:
        raise _wrong(codes.UNKNOWN_MATCH, f"there is no match '{fixture_id}' (yet)", _near(fixture_id, fixtures))
    fixture, reason = fixtures[fixture_id], _checked(reason)
    outcome = before.outcomes.get(fixture_id)
    is_settled = outcome is not None and outcome.ruled in (Ruled.ANNULLED, Ruled.WITHDRAWN)
    if is_settled and kind is not RulingKind.UNDONE:
        message = f"'{fixture_id}' cannot be ruled on: a team of it has left the tournament"
        raise _wrong(codes.RULING_ANNULLED, message, "first take the withdrawal back: --withdraw TEAM --undo")
    undone = last_ruling(tournament.held, fixture_id) if kind is RulingKind.UNDONE else None
    if kind is RulingKind.UNDONE and undone is None:
        raise _nothing_to_undo(fixture_id)
    if kind is RulingKind.FORFEIT:
        kind, scores = _forfeited(tournament, fixture, losers)
    elif kind is RulingKind.CORRECTED and len(scores) != len(fixture.sides):
        raise _wrong(
            codes.RULING_SCORE, f"'{fixture_id}' has {len(fixture.sides)} scores, not {len(scores)}", _SCORE_HELP
        )
    elif kind is RulingKind.REPLAY and outcome is None:
        raise _wrong(codes.NOT_PLAYED, f"'{fixture_id}' has not been played yet", "there is nothing to be replayed")
    row = RulingRow(kind.value, reason, utc_now(), fixture_id, "+".join(losers), sides_of(fixture), list(scores))
    # Without a replay the first result counts again; the next run finds it among the jobs.
    replayed = [fixture_id] if RulingKind.REPLAY in (kind, undone.kind if undone else "") else []
    return _note(tournament, before, row, fixture, replayed, cascade=cascade)


def withdraw(
    tournament: OpenTournament, team: str, reason: str, *, undo: bool = False, cascade: bool = False
) -> list[str]:
    """Note that a team leaves the tournament, or has not left it; returns the fixtures that have to be played again.

    The reason is published. With ``cascade`` later stages that have begun may change.

    Raises:
        DiagnosticError: there is no such team, it has left already (or has not), or a later stage has begun.
    """
    before = tournament.state()
    if team not in before.teams:
        raise _wrong(codes.UNKNOWN_TEAM, f"there is no team '{team}'", _near(team, before.teams))
    if undo and not before.teams[team].withdrawn:
        raise _nothing_to_undo(team)
    if before.teams[team].withdrawn and not undo:
        raise _wrong(codes.WITHDRAWN_TWICE, f"'{team}' has withdrawn already", "nothing is left to decide")
    kind = RulingKind.UNDONE if undo else RulingKind.WITHDRAWN
    last_rounds = {} if undo else before.last_rounds(team)
    row = RulingRow(kind.value, _checked(reason), utc_now(), team=team, last_rounds=last_rounds)
    return _note(tournament, before, row, None, [], cascade=cascade)


def scores_of(text: str) -> list[float]:
    """Return the numbers of ``2:1``; none of an empty text.

    Raises:
        DiagnosticError: it is not a score.
    """
    try:
        scores = [float(part) for part in text.split(":")] if text else []
    except ValueError:
        scores = [-1.0]
    if any(not 0 <= score < float("inf") for score in scores):
        raise _wrong(codes.RULING_SCORE, f"not a score: '{text}'", "write it as 2:1")
    return scores


_SCORE_HELP = "give a score for each side, such as --score 2:1, or one number for what a team plays alone"


def _note(
    tournament: OpenTournament,
    before: SeasonState,
    row: RulingRow,
    ruled: Fixture | None,
    replayed: Sequence[str],
    *,
    cascade: bool,
) -> list[str]:
    """Write a ruling on a match (None: a team leaves), unless it changes the teams of a later one that was played.

    Without it the state is ``before``; what was played of the fixtures ``replayed`` does not count any more.
    """
    store = tournament.store
    played, counted = store.played(), tournament.state_and_outcomes()[1]
    for fixture in replayed:
        played.pop(fixture, None)
    after = tournament.state_with(row, played)
    stages = tournament.loaded.tournament.stages if ruled is None else later_stages(tournament.loaded, ruled.stage)
    same_stage, round_ = (ruled.stage, ruled.round) if ruled is not None else ("", 0)
    gone = [one for one in before.fixtures if one.id in counted and one.id not in after.outcomes]
    lost = [one.id for one in gone if one.stage in stages or (one.stage == same_stage and one.round > round_)]
    if lost and not cascade:
        raise stage_closed(f"the ruling may change the teams of '{lost[0]}', which has been played already")
    tournament.keep_drawn()
    store.add_ruling(row, forget=[*replayed, *lost])
    tournament.refresh()
    return lost


def _forfeited(tournament: OpenTournament, fixture: Fixture, losers: Sequence[str]) -> tuple[RulingKind, list[float]]:
    teams = [team for one in fixture.sides for team in one.teams]
    for loser in set(losers) - set(teams):
        raise _wrong(
            codes.UNKNOWN_TEAM, f"'{loser}' does not play in '{fixture.id}'", f"it is one of {', '.join(teams)}"
        )
    rule = tournament.loaded.tournament.withdrawn
    lost, won = rule.lost if isinstance(rule, LostBy) else _LOST_BY
    are_lost = [not set(losers).isdisjoint(side.teams) for side in fixture.sides]
    kind = RulingKind.DOUBLE_FORFEIT if len(are_lost) > 1 and all(are_lost) else RulingKind.FORFEIT
    return kind, [float(lost if is_lost else won) for is_lost in are_lost]


def _checked(reason: str) -> str:
    reason = " ".join(reason.split())
    if not reason or len(reason) > _MAX_REASON_CHARS:
        raise _wrong(
            codes.RULING_REASON, f"a ruling has a reason of 1 to {_MAX_REASON_CHARS} characters", "--reason TEXT"
        )
    return reason


def _nothing_to_undo(subject: str) -> DiagnosticError:
    help_ = "'tournament results FILE --json' lists all decisions"
    return _wrong(codes.NOTHING_TO_UNDO, f"no decision about '{subject}' holds", help_)


def _near(name: str, names: Iterable[str]) -> str:
    near = get_close_matches(name, list(names), 3, 0.3)
    return f"did you mean {' or '.join(near)}?" if near else "'tournament plan FILE' lists all matches and teams"


def _wrong(code: Code, message: str, help_: str) -> DiagnosticError:
    return DiagnosticError(Diagnostic(code, message, help_))
