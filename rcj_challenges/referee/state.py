"""The referee's state within a half, filled from a scenario: poses, counters, flags, timers, draws, phase."""

from __future__ import annotations

import struct
from collections.abc import Callable, Mapping
from dataclasses import asdict
from functools import partial
from typing import Any

from rcj_challenges.core.amounts import plain, round_score
from rcj_challenges.core.play import HalfInfo
from rcj_challenges.core.timing import s_from_ticks, ticks_from_s
from rcj_challenges.rules.fields import Names, Scalar
from rcj_challenges.scenario.draw_order import Series, drawable
from rcj_challenges.scenario.halves import by_seat, by_team, half_length_s
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.models.state import Draw
from rcj_challenges.scenario.roster import ENTRANTS, Roster, as_tuple
from rcj_challenges.tracking.bound_rules import RuleHistory
from rcj_challenges.tracking.state import Clock, RefereeState

_FLOAT32 = struct.Struct("<f")


def float32(value: float) -> float:
    """Return the value as the world and the trajectory keep it, so that a placed pose is exactly the pose judged."""
    return float(_FLOAT32.unpack(_FLOAT32.pack(value))[0])


def _begin(values: dict[str, Any], name: str, initial: Any) -> None:
    """Let a value, or one of each of several, be what it is at first; in place, as words hold on to what they read."""
    if isinstance(initial, dict):
        values[name].update(initial)
    else:
        values[name] = initial


class State(RefereeState):
    """The referee's memory of one half, filled from a scenario.

    Attributes:
        members: by names, ``each`` and ``for_each``: what these stand for, as far as it has been found out.
    """

    def __init__(self, scenario: Scenario, roster: Roster, half: HalfInfo) -> None:
        super().__init__(half, scenario.first_phase, roster.entities, roster.robots)
        self.scenario = scenario
        self.roster = roster
        self.spots = {name: (spot.x_m, spot.y_m) for name, spot in scenario.spots.items()}
        self.scores = {name: half.scores.get(name, 0) for name in scenario.entrants}
        self._undrawn: dict[str, list[Scalar]] = {}
        self._decided: dict[str, list[Scalar]] = {}
        self.entrant_of = {robot: name for name, entrant in scenario.entrants.items() for robot in entrant.robots}
        self.began_with = {"half": dict(self.scores), "phase": dict(self.scores)}
        self._by_phase: list[tuple[str, Callable[[], None]]] = []
        roles = {name: role.draw(roster.roles[name]) for name, role in scenario.roles.items()}
        self.chosen: dict[str, Draw] = {**scenario.draws, **roles}
        self._histories: dict[str, dict[str, RuleHistory]] = {}
        self.members: dict[tuple[Names, str | None, str | None], tuple[str, ...]] = {}
        self._fill()
        # The scenario's own number (600, as in the original's log) unless the half is played at another length.
        nominal_s = half_length_s(scenario.match, half.half)
        self.half_length_s = plain(nominal_s if ticks_from_s(nominal_s) == half.ticks else s_from_ticks(half.ticks))

    def anew_in(self, keep: str | None, begin: Callable[[], None]) -> None:
        """Reset something with the phases for which it is kept."""
        if keep not in (None, "half", "match"):
            self._by_phase.append((keep, begin))

    def begin_phase(self, phase: str) -> bool:
        """Reset what is kept for this phase, or for each; return whether anything is."""
        self.began_with["phase"].update(self.scores)
        found = [begin for keep, begin in self._by_phase if keep in ("phase", phase)]
        for begin in found:
            begin()
        return bool(found)

    def history(self, keep: str, rule: str, each: str | None) -> RuleHistory:
        """Return the history of a rule, whose firings are counted for so long."""
        past = RuleHistory()
        self.anew_in(keep, partial(setattr, past, "executions", 0))
        if keep == "match":
            kept = self.half.kept.get("executions", {}).get(rule)
            group = self.scenario.rules[rule].for_each
            past.executions = 0 if kept is None else self._by_seat(kept, group).get(each or "", 0)
            self._histories.setdefault(rule, {})[each or ""] = past
        return past

    def _fill(self) -> None:
        sections: tuple[tuple[str, dict[str, Any]], ...] = (("counters", self.counters), ("flags", self.flags))
        for section, values in sections:
            kept = self.half.kept.get(section, {})
            for name, one in getattr(self.scenario, section).items():
                first = round_score(one.first) if section == "counters" and one.first is not None else one.first
                self.first.setdefault(section, {})[name] = first
                initial = first if one.per is None else dict.fromkeys(self.roster.keepers(one.per), first)
                values[name] = self._by_seat(kept[name], one.per) if name in kept else self._by_seat(initial, None)
                self.anew_in(one.keep, partial(_begin, values, name, initial))
        keeps = {"lowest": min, "highest": max}
        self.keeps = {name: keeps[one.keeps] for name, one in self.scenario.counters.items() if one.keeps is not None}
        kept = self.half.kept.get("timers", {})
        for name, timer in self.scenario.timers.items():
            members = (None,) if timer.per is None else self.roster.keepers(timer.per)
            # How long they are is known when everything is drawn; but for those that go on.
            first = {"length": 0, "since": 0 if timer.starts else None}
            own = self._by_seat(kept[name], timer.per) if name in kept else {}
            self.timers[name] = {member: Clock(**own.get(member or "", first)) for member in members}

    def _by_seat(self, kept: Any, per: str | None) -> Any:
        """Return what was kept from the half before: what entrants have changes seats with their teams."""
        if per == ENTRANTS:
            return by_seat(kept, self.half.teams)
        return dict(kept) if isinstance(kept, dict) else kept

    def _by_team(self, value: Any, per: str | None) -> Any:
        """Return what is to be kept for the next half: what entrants have by team."""
        if per == ENTRANTS:
            return by_team(value, self.half.teams)
        return dict(value) if isinstance(value, dict) else value

    def decide_draws(self, decided: Mapping[str, Series]) -> None:
        """Draw everything at the start of the half, but for what is decided beforehand or kept from the last half.

        If several values are decided for a draw, the later ones are used when it is drawn again.

        Raises:
            ValueError: a value is decided that the draw cannot have, or for a draw that does not exist.
        """
        for name, series in decided.items():
            self._decided[name] = list(as_tuple(series))
            known = self.chosen[name].values if name in self.chosen else ()
            wrong = [value for value in self._decided[name] if value not in known]
            if wrong:
                message = f"draws.{name}: {wrong[0]!r} is not one of its values"
                raise ValueError(message)
        kept, undrawn = self.half.kept.get("draws", {}), self.half.kept.get("undrawn", {})
        for name, draw in self.chosen.items():
            if draw.not_again is not None:
                self._undrawn[name] = list(undrawn.get(name, draw.values))
            role = self.scenario.roles.get(name)
            if name in decided and (role is None or role.initial is None):
                self.draw_again(name)
            elif name in kept:
                self.draws[name] = kept[name]
                if name not in undrawn:  # else it was taken out when it was drawn
                    self.set_draw(name, kept[name])
            elif role is not None:
                self.begin_role(name)
            else:
                self.draw_again(name)

    def begin_role(self, name: str) -> None:
        """Let a role stand for what it does at first."""
        role, members = self.scenario.roles[name], self.roster.roles[name]
        if role.order == "random" and role.initial is None:
            self.draw_again(name)
        else:
            self.set_draw(name, members[0] if role.initial is None else None)

    def assign_next(self, name: str) -> None:
        """Draw again, or give a role to the next: behind none the first one comes, behind the last one none or that."""
        role = self.scenario.roles.get(name)
        if role is None or role.order == "random":
            self.draw_again(name)
            return
        members, last = self.roster.roles[name], self.draws[name]
        following = 0 if last is None else members.index(str(last)) + 1
        is_over = following == len(members) and not role.cyclic
        self.set_draw(name, None if is_over else members[following % len(members)])

    def set_draw(self, name: str, value: Scalar | None) -> None:
        """Let a draw have a value, which has been drawn then."""
        self.draws[name] = value
        undrawn = self._undrawn.get(name, [])
        if value in undrawn:
            undrawn.remove(value)

    def draw_again(self, name: str) -> None:
        """Draw a value, equally likely each: with ``not_last`` never the one it has, with ``not_again`` one left.

        As long as a test has decided what comes next, that comes.
        """
        draw, last = self.chosen[name], (self.draws[name],) if name in self.draws else ()
        values, left = drawable(draw, self._undrawn.get(name, draw.values), last)
        if draw.not_again is not None:
            self._undrawn[name] = list(left)
        decided = self._decided.get(name)
        self.set_draw(name, decided.pop(0) if decided else self.stream(f"draw/{name}").choice(values))

    def undecided(self) -> dict[str, list[Scalar]]:
        """Return of the values that a test decided those that have not come."""
        return {name: list(left) for name, left in self._decided.items() if left}

    def undecided_spots(self) -> dict[str, int]:
        """Return the number of places decided by a test that have not come, by spot."""
        return {name: len(left) for name, left in self.decided_spots.items() if left}

    def kept(self) -> dict[str, dict[str, object]]:
        """Return what is kept for the next half's `HalfInfo.kept`."""
        scenario, by_team = self.scenario, self._by_team
        kept: dict[str, dict[str, object]] = {
            "draws": {name: self.draws[name] for name, draw in self.chosen.items()
                      if draw.keep == "match" and name in self.draws},
            "flags": {name: by_team(self.flags[name], one.per) for name, one in scenario.flags.items()
                      if one.keep == "match"},
            "undrawn": {name: list(left) for name, left in self._undrawn.items()
                        if self.chosen[name].not_again == "match"},
            "counters": {name: by_team(self.counters[name], one.per) for name, one in scenario.counters.items()
                         if one.keep == "match"},
            "timers": {name: by_team({owner or "": self._clock_kept(one) for owner, one in clocks.items()},
                                     scenario.timers[name].per)
                       for name, clocks in self.timers.items() if scenario.timers[name].keep == "match"},
            "executions": {rule: by_team({each: past.executions for each, past in pasts.items()},
                                         scenario.rules[rule].for_each)
                           for rule, pasts in self._histories.items()},
        }  # fmt: skip
        return {section: values for section, values in kept.items() if values or section in ("draws", "flags")}

    def _clock_kept(self, clock: Clock) -> dict[str, object]:
        return asdict(clock) | {"elapsed": clock.ticks(self.tick), "since": None if clock.since is None else 0}
