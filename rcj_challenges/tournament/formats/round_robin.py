"""Round robin: all teams of a group meet each other once or twice."""

from collections import Counter
from collections.abc import Collection, Iterator, Mapping, Sequence
from itertools import chain
from typing import Annotated, Any, ClassVar, Literal

from pydantic import Field

from rcj_challenges.core.diagnostics import Diagnostic, issue
from rcj_challenges.rules.fields import Name, described
from rcj_challenges.scenario.errors import listing
from rcj_challenges.tournament.codes import LISTED_TEAMS, TOO_FEW_TEAMS
from rcj_challenges.tournament.drawing import Rounds, add_to_rounds, drawn_before, turn_pairs
from rcj_challenges.tournament.formats.context import Entrant, StageContext
from rcj_challenges.tournament.formats.groups import all_meet, group_names, groups_of, pairings
from rcj_challenges.tournament.formats.play_off import play_offs
from rcj_challenges.tournament.formats.stage import Intake, LeagueFormat, StageSize, listed_problems
from rcj_challenges.tournament.models import LostBy, TeamId
from rcj_challenges.tournament.season import Fixture, Ruled, StageState, Table, humanized
from rcj_challenges.tournament.standings import table


class RoundRobin(LeagueFormat):
    """All teams of a group meet each other."""

    stage: Literal["round_robin"]
    groups: Annotated[int, Field(ge=1, le=64)] | dict[Name, Annotated[tuple[TeamId, ...], Field(min_length=2)]] = (
        described(
            1,
            "number of groups, drawn evenly from each pot or, with 'from', from each place; or the teams by group: "
            "{A: [ada, bee], B: […]}",
        )
    )
    legs: int = described(1, "how often two teams meet; 2: home and away, with the sides changed", ge=1, le=2)

    FOLLOWS_PAIRS: ClassVar[bool] = True

    def size(self, intake: Intake) -> StageSize:
        """Return the size of the stage; groups that are drawn differ by one team at most."""
        if isinstance(self.groups, dict):
            tables = {name: sum(team in intake.present for team in own) for name, own in self.groups.items()}
        elif self.groups == 1:
            tables = {"": intake.teams}
        else:
            least, more = divmod(intake.teams, self.groups)
            tables = {name: least + (index < more) for index, name in enumerate(group_names(self.groups))}
        return StageSize(intake.teams, tables, *all_meet(tables, self.legs))

    def problems(self, intake: Intake, size: StageSize) -> Iterator[Diagnostic]:
        if not isinstance(self.groups, dict):
            if min(size.tables.values()) < 2:
                message = f"{size.teams} teams are too few for {self.groups} groups"
                yield issue(TOO_FEW_TEAMS, ("groups",), message, "two teams a group are the least")
            return
        if self.from_ is not None:
            message = "the teams of the groups are listed, and taken from another stage"
            yield issue(LISTED_TEAMS, ("groups",), message, "give the number of groups, or remove 'from'")
            return
        yield from listed_problems("groups", self.groups, intake.present)
        missing = [team for team in intake.present if all(team not in listed for listed in self.groups.values())]
        if missing:
            message = f"in no group: {listing(missing)}"
            yield issue(LISTED_TEAMS, ("groups",), message, "put each team into one group")

    def keep_seats(self, draw: Any, before: Collection[tuple[str, str]]) -> None:
        for _, rounds in draw.values() if self.legs == 1 else ():
            turn_pairs(rounds, before)

    def add_late(self, draw: Any, team: str, present: Collection[str]) -> bool:
        """Add a team to the group that lists it, else to the smallest one."""
        listed = self.groups if isinstance(self.groups, dict) else {}
        name = min(draw, key=lambda group: (team not in listed.get(group, ()), len(draw[group][0])))
        own, rounds = draw[name]
        add_to_rounds(rounds, [other for other in own if other in present], team, self.legs)
        own.append(team)
        return True

    def state(self, context: StageContext, entrants: Sequence[Entrant]) -> StageState:
        """Return the state of a round robin; teams whose matches are all annulled are not in its table."""
        teams = tuple(entrant.team for entrant in entrants)
        key = ("round_robin", context.name, teams)
        if key not in context.cache:
            pots = {entrant.team: entrant.pot for entrant in entrants}
            drawn = context.draw(self, teams, lambda: _drawn(context, self, pots))
            _check_unchanged(context.name, self, drawn)
            groups = {name: [team for team in own if team in pots] for name, (own, _) in drawn.items()}
            context.cache[key] = groups, {name: _fixtures(context, self, name, own) for name, (_, own) in drawn.items()}
        groups, by_group = context.cache[key]
        annulled = {team for fixtures in by_group.values() for team in _settle_withdrawn(context, fixtures)}
        tables: list[Table] = []
        play_off_fixtures: list[Fixture] = []
        for name, fixtures in by_group.items():
            is_complete = context.are_decided(fixtures)
            ranked = [team for team in groups[name] if team not in annulled]
            found = table(name, ranked, context.matches(fixtures), context.rules(name), complete=is_complete)
            if self.play_off and is_complete:
                found, more = play_offs(context, self, found, max((one.round for one in fixtures), default=0) + 1)
                play_off_fixtures += more
            tables.append(found)
        fixtures = tuple(sorted((one for own in by_group.values() for one in own), key=lambda one: one.round))
        is_finished = all(found.complete for found in tables)
        places = sorted((row for found in tables for row in found.rows), key=lambda row: row.place)
        return context.state(
            self,
            teams,
            is_finished=is_finished,
            fixtures=(*fixtures, *play_off_fixtures),
            expected_matches=len(fixtures) + len(play_off_fixtures),
            tables=tuple(tables),
            has_groups=True,
            has_matrices=True,
            places=tuple(places) if is_finished else (),
        )


def _drawn(context: StageContext, stage: RoundRobin, pots: Mapping[str, int]) -> dict[str, tuple[list[str], Rounds]]:
    groups = groups_of(stage.groups, pots, context.tournament.seed, f"{context.name}/groups")
    rounds = {own: pairings(len(own), stage.legs) for own in groups.values()}
    return {
        name: (list(own), [[[own[one], own[other]] for one, other in pairs] for pairs in rounds[own]])
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
    path, title = (f"{group}/round", f"Group {humanized(group)}, round") if group else ("round", "Round")
    return [
        context.match(f"{path}{number}", stage, (one, other), number, f"{title} {number}", group)
        for number, pairs in enumerate(rounds, 1)
        for one, other in pairs
    ]


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
