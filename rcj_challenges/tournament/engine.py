"""The engine: from tournament, teams and outcomes to the state of all stages."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from typing import Any

from rcj_challenges.tournament.drawing import Drawn
from rcj_challenges.tournament.formats.context import Entrant, StageContext
from rcj_challenges.tournament.load import LoadedTournament
from rcj_challenges.tournament.models import FromModel
from rcj_challenges.tournament.season import Outcome, SeasonState, StageState, Status, Team
from rcj_challenges.tournament.seeds import lot


class Season:
    """A tournament with its teams; pure: the same outcomes give the same state, in whichever order they came.

    The names of ``teams`` are shown, those of the file by default. New draws are added to ``drawn``.
    """

    def __init__(
        self, loaded: LoadedTournament, teams: Mapping[str, Team] | None = None, drawn: Drawn | None = None
    ) -> None:
        self.loaded = loaded
        self.teams = dict(loaded.teams() if teams is None else teams)
        self.drawn = Drawn.of(loaded.tournament.seed, self.teams) if drawn is None else drawn
        self._tournament = loaded.tournament
        self._sizes = loaded.tournament.sizes(self.teams, loaded.scenarios, loaded.names)
        self._cuts = {name: loaded.tournament.cuts(name, self._sizes) for name in loaded.tournament.stages}
        self._cache: dict[Any, Any] = {}

    def state(self, outcomes: Mapping[str, Outcome], hidden: Collection[str] = ()) -> SeasonState:
        """Return the state after these outcomes by fixture; those of fixtures that do not exist are left out.

        The outcomes of ``hidden`` fixtures were left out by the caller, although they were played.
        """
        counted = dict(outcomes)
        states: dict[str, StageState] = {}
        for name, stage in self._tournament.stages.items():
            entrants = self._entrants(name, stage, states)
            context = StageContext(
                name=name,
                kind=stage.stage,
                tournament=self._tournament,
                names=self.loaded.names,
                scenarios=self.loaded.scenarios,
                teams=self.teams,
                entries=self.loaded.entries,
                drawn=self.drawn,
                outcomes=counted,
                hidden=hidden,
                cuts=self._cuts[name],
                cache=self._cache,
            )
            if entrants is None:
                states[name] = stage.waiting(context, self._unknown_entrants(stage), self._sizes[name].matches)
            else:
                states[name] = stage.state(context, entrants)
        known = (fixture.id for state in states.values() for fixture in state.fixtures)
        kept = {fixture: counted[fixture] for fixture in known if fixture in counted}
        return SeasonState(tuple(states.values()), self.teams, kept)

    def _entrants(self, name: str, stage: FromModel, states: Mapping[str, StageState]) -> list[Entrant] | None:
        """Return the teams of a stage; None if they are not decided yet."""
        here = {team: one for team, one in self.teams.items() if not one.withdrawn or name in one.last_rounds}
        if stage.from_ is None:
            late = self.drawn.left_out.get(name, ())
            return [Entrant(team, pot) for team, pot in self.drawn.pots.items() if team in here and team not in late]
        source = states[stage.from_]
        if source.status is not Status.FINISHED:
            return None
        found = []
        for group, rows in source.rankings:
            # A team that has left in between makes room for the next one.
            staying = [row for row in rows if row.team in here]
            ranked = sorted(staying, key=lambda row: (row.place, lot(self._tournament.seed, f"{name}/order", row.team)))
            found += [
                Entrant(ranked[place - 1].team, place, place, group, _origin(stage.from_, group, place))
                for place in stage.taken(len(ranked))
            ]
        return sorted(found, key=lambda one: one.place)

    def _unknown_entrants(self, stage: FromModel) -> list[Entrant]:
        """Return the sources of the teams of a waiting stage."""
        name = stage.from_ or ""
        found = [
            Entrant("", place, place, group, _origin(name, group, place))
            for group, size in self._sizes[name].tables.items()
            for place in stage.taken(size)
        ]
        return sorted(found, key=lambda one: one.place)


def _origin(source: str, group: str, place: int) -> str:
    return f"{group}{place}" if group else f"place {place} of {source}"
