"""Round robin: all teams of a group meet each other once or twice."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from itertools import chain

from rcj_challenges.tournament.drawing import Rounds, drawn_before
from rcj_challenges.tournament.formats.circle import pairings
from rcj_challenges.tournament.formats.context import Entrant, StageContext
from rcj_challenges.tournament.formats.groups import groups_of
from rcj_challenges.tournament.formats.play_off import play_offs
from rcj_challenges.tournament.models import LostBy, RoundRobin
from rcj_challenges.tournament.season import Fixture, Ruled, StageState, Status, Table, humanized
from rcj_challenges.tournament.standings import table


def round_robin(context: StageContext, stage: RoundRobin, entrants: Sequence[Entrant]) -> StageState:
    """Return the state of a round robin; teams whose matches are all annulled are not in its table."""
    teams = tuple(entrant.team for entrant in entrants)
    key = ("round_robin", context.name, teams)
    if key not in context.cache:
        pots = {entrant.team: entrant.pot for entrant in entrants}
        drawn = context.drawn.draw(context.name, teams if stage.from_ else None, lambda: _drawn(context, stage, pots))
        _check_unchanged(context.name, stage, drawn)
        groups = {name: [team for team in own if team in pots] for name, (own, _) in drawn.items()}
        context.cache[key] = groups, {name: _fixtures(context, stage, name, own) for name, (_, own) in drawn.items()}
    groups, by_group = context.cache[key]
    annulled = {team for fixtures in by_group.values() for team in _settle_withdrawn(context, fixtures)}
    tables: list[Table] = []
    play_off_fixtures: list[Fixture] = []
    for name, fixtures in by_group.items():
        matches = [match for fixture in fixtures if (match := context.result(fixture)) is not None]
        is_complete = context.are_decided(fixtures)
        ranked = [team for team in groups[name] if team not in annulled]
        found = table(name, ranked, matches, context.rules(name), complete=is_complete)
        if stage.play_off and is_complete:
            found, more = play_offs(context, stage, found, max((one.round for one in fixtures), default=0) + 1)
            play_off_fixtures += more
        tables.append(found)
    fixtures = tuple(sorted((one for own in by_group.values() for one in own), key=lambda one: one.round))
    is_finished = all(found.complete for found in tables)
    return StageState(
        name=context.name,
        kind=stage.stage,
        title=context.title(stage),
        status=Status.FINISHED if is_finished else Status.RUNNING,
        teams=teams,
        fixtures=(*fixtures, *play_off_fixtures),
        expected_matches=len(fixtures) + len(play_off_fixtures),
        tables=tuple(tables),
        places=tuple(sorted((row for found in tables for row in found.rows), key=lambda row: row.place))
        if is_finished
        else (),
    )


def _drawn(context: StageContext, stage: RoundRobin, pots: Mapping[str, int]) -> dict[str, tuple[list[str], Rounds]]:
    groups = groups_of(stage, pots, context.tournament.seed, f"{context.name}/groups")
    return {
        name: (
            list(own),
            [[[own[one], own[other]] for one, other in pairs] for pairs in pairings(len(own), stage.legs)],
        )
        for name, own in groups.items()
    }


def _check_unchanged(name: str, stage: RoundRobin, drawn: Mapping[str, tuple[list[str], Rounds]]) -> None:
    met = Counter(frozenset(pair) for _, rounds in drawn.values() for pair in chain.from_iterable(rounds))
    if isinstance(stage.groups, dict):
        are_same = all(set(own) <= set(stage.groups.get(group, ())) for group, (own, _) in drawn.items())
    else:
        are_same = len(drawn) == stage.groups
    if not are_same or max(met.values(), default=stage.legs) != stage.legs:
        raise drawn_before([f"groups or legs of stage '{name}'"])


def _fixtures(context: StageContext, stage: RoundRobin, group: str, rounds: Rounds) -> list[Fixture]:
    found = []
    where = f"Group {humanized(group)}, " if group else ""
    for number, pairs in enumerate(rounds, 1):
        path = f"{group}/round{number}" if group else f"round{number}"
        title = f"{where}round {number}"
        for one, other in pairs:
            found.append(context.match(path, stage, (one, other), number, title[:1].upper() + title[1:], group))
    return found


def _settle_withdrawn(context: StageContext, fixtures: Sequence[Fixture]) -> list[str]:
    """Give the matches of teams that have left their outcome, and return the teams of which none counts.

    They leave one after another: what a team has played stands if it has played all that it could until then.
    """
    teams = {side.teams[0] for fixture in fixtures for side in fixture.sides}
    left = sorted((team for team in teams if context.has_left(team)), key=lambda team: context.teams[team].left_after)
    are_lost = isinstance(context.tournament.withdrawn, LostBy)
    unfinished = []
    for team in left:
        own = [one for one in fixtures if any(team in side.teams for side in one.sides)]
        if not any(context.is_unplayed(one) for one in own):
            continue
        unfinished.append(team)
        for fixture in own:
            outcome = context.outcomes.get(fixture.id)
            if are_lost and (outcome is None or outcome.ruled is not Ruled.WITHDRAWN):
                context.lose_if_left(fixture)
            else:  # the opponent that left before does not lose to one that leaves in the middle
                context.annul(fixture)
    return [] if are_lost else unfinished
