"""Checks across the whole file: stages that cannot be played, places that stay undecided."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from zoneinfo import ZoneInfo

from rcj_challenges.core.code import Code, Level
from rcj_challenges.core.diagnostics import Diagnostic, InTree
from rcj_challenges.scenario.codes import MISSING_KEY
from rcj_challenges.scenario.errors import did_you_mean, listing
from rcj_challenges.scenario.tree import Entries, Step, in_names, mark_of
from rcj_challenges.tournament import codes
from rcj_challenges.tournament.formats import Stage
from rcj_challenges.tournament.formats.stage import Intake, StageSize
from rcj_challenges.tournament.models import FromModel
from rcj_challenges.tournament.release import moments_of
from rcj_challenges.tournament.scenarios import ScenarioInfo, ScenarioNames, ScenarioUse
from rcj_challenges.tournament.season import Team
from rcj_challenges.tournament.tournament_file import Tournament


@dataclass
class Checks:
    """The checks of a tournament; if not all teams could be read, their number is not checked."""

    tournament: Tournament
    teams: Mapping[str, Team]
    scenarios: Mapping[ScenarioUse, ScenarioInfo]
    tree: Entries
    names: ScenarioNames
    are_teams_known: bool

    def problems(self) -> Iterator[Diagnostic]:
        """Yield errors and warnings."""
        yield from self._tie_breaks()
        yield from self._same_names()
        yield from self._times()
        yield from self._seats()
        before = [*self._teams(), *self._sources()]
        yield from before
        if before or not self.are_teams_known:  # the numbers of teams mean nothing
            return
        sizes = self.tournament.sizes(self.teams, self.scenarios, self.names)
        for name, stage in self.tournament.stages.items():
            yield from self._stage(name, stage, sizes)

    def _at(
        self, path: tuple[Step, ...], code: Code, message: str, help_: str, level: Level | None = None
    ) -> Diagnostic:
        where = mark_of(self.tree, path).place(in_names(self.tree, path))
        return Diagnostic(code, message, help_, where, level or code.level)

    # --- the whole file -----------------------------------------------------------------------------------------------

    def _teams(self) -> Iterator[Diagnostic]:
        if not self.tournament.teams and self.tournament.teams_folder is None:
            yield self._at((), MISSING_KEY, "no teams", "give 'teams' or 'teams_folder'")
        elif self.are_teams_known and len(self.teams) < 2:
            where = ("teams",) if self.tournament.teams else ("teams_folder",)
            message = f"{len(self.teams)} team(s); a tournament has at least two"
            yield self._at(where, codes.TOO_FEW_TEAMS, message, "add teams")

    def _tie_breaks(self) -> Iterator[Diagnostic]:
        words = self.tournament.tie_breaks
        for index, word in enumerate(words):
            where = ("tie_breaks", index)
            if word in words[:index]:
                yield self._at(where, codes.USELESS_TIE_BREAK, f"'{word}' is listed twice", "keep the first")
            elif word == "lot" and index < len(words) - 1:
                yield self._at(where, codes.USELESS_TIE_BREAK, "after 'lot' nothing is level", "put 'lot' last")

    def _same_names(self) -> Iterator[Diagnostic]:
        """Refuse names of pages that are one file on Windows and macOS."""
        stages = self.tournament.stages
        challenges = {("stages", name, "scenarios"): stage.challenges for name, stage in stages.items()}
        for path, names in ({("stages",): stages} | challenges).items():
            first: dict[str, str] = {}
            for name in names:
                if (twin := first.setdefault(name.casefold(), name)) != name:
                    message = f"the names '{twin}' and '{name}' differ by case only"
                    yield self._at((*path, name), codes.SAME_NAME, message, "give one of them another name")

    def _times(self) -> Iterator[Diagnostic]:
        name = self.tournament.time_zone
        try:
            zone = ZoneInfo(name)
        except (KeyError, ValueError, OSError):
            help_ = "write it as Europe/Berlin or UTC"
            yield self._at(("time_zone",), codes.UNKNOWN_TIME_ZONE, f"unknown time zone '{name}'", help_)
            return
        help_ = f"write it as 2021-06-22 18:00, a time in {name} (time_zone)"
        for stage_name, stage in self.tournament.stages.items():
            single = isinstance(stage.release, str)
            times = ((stage.release,) if isinstance(stage.release, str) else stage.release) or ()
            before = None
            for index, text in enumerate(times):
                path = ("stages", stage_name, "release", *(() if single else (index,)))
                try:
                    moments = moments_of(text, zone)
                except (ValueError, OverflowError):
                    yield self._at(path, codes.WRONG_TIME, f"there is no time '{text}'", help_)
                    continue
                if not moments:
                    message = f"there is no '{text}' in {name}: the clock is put forward over it"
                    yield self._at(path, codes.WRONG_TIME, message, "choose a time before or after that")
                    continue
                if len(moments) > 1:
                    both = " and ".join(f"{one.astimezone(zone):%H:%M %Z} ({one:%H:%M} UTC)" for one in moments)
                    message = f"'{text}' comes twice in {name}, because the clock is put back: {both}"
                    advice = "the first is used; take a time outside of that hour, or write all in UTC: time_zone: UTC"
                    yield self._at(path, codes.AMBIGUOUS_TIME, message, advice)
                if before is not None and moments[0] < before:
                    yield self._at(path, codes.WRONG_TIME, f"'{text}' is before the round before it", "order the times")
                before = moments[0]

    def _seats(self) -> Iterator[Diagnostic]:
        path: tuple[Step, ...]
        for name, stage in self.tournament.stages.items():
            for use, keys in stage.uses(self.names):
                path = ("stages", name, *keys)
                yield from self._seat_count(path, use, {stage.SEATS})
                info = self.scenarios.get(use)
                for message, help_ in stage.scenario_problems(info) if info is not None else ():
                    yield self._at(path, codes.WRONG_SEATS, message, help_)
        if (tie := self.tournament.drawn.tie_scenario) is not None:
            path = ("drawn", "tie_scenario", "scenario")
            yield from self._seat_count(path, self.names.use(tie.scenario, tie.set), {1, 2})

    def _seat_count(self, path: tuple[Step, ...], use: ScenarioUse, wanted: set[int]) -> Iterator[Diagnostic]:
        info = self.scenarios.get(use)
        if info is not None and len(info.seats) not in wanted:
            need = " or ".join(map(str, sorted(wanted)))
            message = f"scenario '{info.id}' has {len(info.seats)} seat(s) ({listing(info.seats)}); {need} needed here"
            yield self._at(path, codes.WRONG_SEATS, message, "matches are played by two, challenges by one")

    # --- where teams come from ----------------------------------------------------------------------------------------

    def _sources(self) -> Iterator[Diagnostic]:
        for at, (name, stage) in enumerate(self.tournament.stages.items()):
            yield from self._source(name, stage, list(self.tournament.stages)[:at])

    def _source(self, name: str, stage: FromModel, before: list[str]) -> Iterator[Diagnostic]:
        path = ("stages", name)
        if stage.from_ is None:
            if stage.places is not None:
                message = "'places' says nothing without 'from'"
                yield self._at((*path, "places"), codes.NO_SOURCE, message, "add 'from', or remove 'places'")
            return
        if stage.from_ not in before:
            is_later = stage.from_ in self.tournament.stages
            message = f"'{stage.from_}' is not played before '{name}'" if is_later else f"no stage '{stage.from_}'"
            help_ = did_you_mean(stage.from_, before, f"Earlier stages: {listing(before) or 'none'}")
            yield self._at((*path, "from"), codes.UNREACHABLE_STAGE, message, help_)
            return
        if not self.tournament.stages[stage.from_].RANKS_TEAMS:
            message = f"'{stage.from_}' ranks super teams, not teams"
            yield self._at((*path, "from"), codes.UNREACHABLE_STAGE, message, "take the teams from another stage")
        if isinstance(stage.places, str) and (numbers := stage.place_range(0))[0] > numbers[1]:
            message = f"places {stage.places} begin after their end"
            yield self._at((*path, "places"), codes.WRONG_PLACES, message, f"write {numbers[1]}-{numbers[0]}")

    # --- one stage ----------------------------------------------------------------------------------------------------

    def _stage(self, name: str, stage: Stage, sizes: Mapping[str, StageSize]) -> Iterator[Diagnostic]:
        path = ("stages", name)
        size = sizes[name]
        if stage.from_ is not None and stage.places is not None:
            yield from self._places(path, stage, sizes[stage.from_])
        if size.teams < stage.MIN_TEAMS:
            message = f"{size.teams} team(s) come into this stage, at least {stage.MIN_TEAMS} needed"
            yield self._at(path, codes.TOO_FEW_TEAMS, message, "take more places, or remove the stage")
            return
        for one in stage.problems(Intake(size.teams, self.teams, self.names, self.scenarios), size):
            keys = one.where.keys if isinstance(one.where, InTree) else ()
            yield self._at((*path, *keys), one.code, one.message, one.help, one.level)
        if isinstance(stage.release, tuple) and len(stage.release) not in (1, size.rounds):
            message = f"{len(stage.release)} times of release for {size.rounds} rounds"
            yield self._at((*path, "release"), codes.WRONG_RELEASE, message, "give one time, or one for each round")
        yield from self._undecided(name, stage, sizes)

    def _places(self, path: tuple[Step, ...], stage: FromModel, source: StageSize) -> Iterator[Diagnostic]:
        for group, count in source.tables.items():
            if stage.place_range(count)[1] > count:
                where = f"group {group} of '{stage.from_}'" if group else f"'{stage.from_}'"
                message = f"places {stage.places} of '{stage.from_}': {where} has {count} teams only"
                yield self._at((*path, "places"), codes.TOO_FEW_TEAMS, message, "take fewer places, or add teams")
                return

    def _undecided(self, name: str, stage: Stage, sizes: Mapping[str, StageSize]) -> Iterator[Diagnostic]:
        """Refuse places that can be shared if only some of the teams advance."""
        open_cuts = stage.shared_cuts(self.tournament.cuts(name, sizes), sizes[name].teams)
        if not open_cuts or "lot" in self.tournament.tie_breaks:
            return
        after = ", ".join(map(str, sorted(open_cuts)))
        taker = next(one for one, other in self.tournament.stages.items() if other.from_ == name and other.places)
        help_ = "add lot at the end of tie_breaks"
        if stage.CAN_PLAY_OFF:
            help_ = f"set play_off: true in {name!r}, or {help_}"
        message = f"places after place {after} of '{name}' may be shared, and only some of these teams advance"
        yield self._at(("stages", taker, "places"), codes.UNDECIDED_PLACES, message, help_)
