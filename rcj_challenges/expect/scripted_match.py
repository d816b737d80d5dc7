"""A scripted match: poses, touches, tilts and faults are fed to a referee, without physics or programs."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from rcj_challenges.core.play import Event, Fault, Firing, HalfInfo, Placement, Pose2, RefereeOutput, Snapshot
from rcj_challenges.core.timing import SUBSTEPS_PER_TICK, ticks_from_s
from rcj_challenges.referee.engine import Referee
from rcj_challenges.referee.state import float32
from rcj_challenges.scenario.draw_order import Series
from rcj_challenges.scenario.halves import half_length_s, teams_by_seat
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.roster import Roster
from rcj_challenges.scenario.shapes import start_pose

# Where the stage shows what is off the field; the referee must not look there.
_PARKED_X_M, _PARKED_STEP_M = 3.0, 0.2
_STANDING_HEIGHT_M = 0.0375


def half_of(scenario: Scenario, half: int = 1, seed: int = 1) -> HalfInfo:
    """Return the facts of a half for tests: no points yet, teams named by their seats' titles."""
    return HalfInfo(
        half=half,
        halves=max(half, scenario.match.halves),
        ticks=ticks_from_s(half_length_s(scenario.match, half)),
        match_seed=seed,
        match_id=1,
        team_names={seat: entrant.title or seat for seat, entrant in scenario.entrants.items()},
        teams=teams_by_seat(scenario, half),
        scores=dict.fromkeys(scenario.entrants, 0),
    )


class ScriptedMatch:
    """A match in which things move only when the script or the referee moves them.

    Args:
        half: facts of the half; left out: the first half with seed 1.
        spots: where chance sets spots, decided beforehand, in m.

    Attributes:
        events, firings: all so far, in order.
        placements: all so far, each with its tick.
        received: by robot, the last broadcast that it received.
        is_over: whether the half has ended.
        phases: all phases so far, each with the tick in which it was entered.
    """

    def __init__(
        self,
        scenario: Scenario,
        roster: Roster,
        half: HalfInfo | None = None,
        draws: Mapping[str, Series] | None = None,
        spots: Mapping[str, Sequence[tuple[float, float]]] | None = None,
    ) -> None:
        self.roster = roster
        self.referee = Referee(scenario, roster, half or half_of(scenario), draws, spots)
        self.referee.rounds.denied = {}
        self.tick = 0
        self.events: list[Event] = []
        self.firings: list[Firing] = []
        self.placements: list[tuple[int, Placement]] = []
        entities = len(roster.entities)
        self._poses = [_float32(*start_pose(scenario, name)) for name in roster.entities]
        self._uprights = [1.0] * entities
        self._heights = [_STANDING_HEIGHT_M] * entities
        self._glides: dict[int, tuple[tuple[float, ...], int]] = {}  # where to, and the sub-steps that are left
        self._touching: dict[tuple[int, int], int] = {}
        self._faults: list[Fault] = []
        self._messages: dict[int, list[str]] = {}
        self._parked: set[int] = set()
        self._by_hand: set[int] = set()
        self.phases: list[tuple[int, str]] = [(0, scenario.first_phase)]
        self.received: dict[str, dict[str, Any]] = {}
        self.is_over = False
        self.output = self._take(self.referee.start(self._snapshot()))
        self._store_broadcast()

    # --- what the script does ---------------------------------------------------------------------------------------

    def place(self, entity: str, x_m: float, y_m: float, yaw_rad: float | None = None) -> None:
        """Put an entity somewhere by hand, upright; the next snapshot shows it there.

        What is off the field comes back, as if a rule had placed it.
        """
        index = self.roster.index[entity]
        self._by_hand.add(index)
        self._glides.pop(index, None)
        self._uprights[index] = 1.0
        self._stand(index, x_m, y_m, self._poses[index][2] if yaw_rad is None else yaw_rad)
        if index in self._parked:
            self._parked.discard(index)
            self.referee.bring_back(index, self._poses[index])

    def is_off(self, name: str) -> bool:
        """Return whether an entity is off the field."""
        return self.roster.index.get(name) in self._parked

    def glide(self, entity: str, to: tuple[float, ...], ticks: int) -> None:
        """Let an entity glide to [x, y] or [x, y, yaw] in a straight line, to arrive after so many ticks."""
        self._glides[self.roster.index[entity]] = to, ticks * SUBSTEPS_PER_TICK

    def touch(self, first: str, second: str, ticks: int = 1) -> None:
        """Let two things touch from the next tick on for so many ticks, in all their sub-steps."""
        a, b = self.roster.index[first], self.roster.index[second]
        pair = (min(a, b), max(a, b))
        self._touching[pair] = max(ticks, self._touching.get(pair, 0))

    def tip(self, robot: str) -> None:
        """Let a robot lie on its side from the next tick on."""
        self._uprights[self.roster.index[robot]] = 0.0

    def fail(self, robot: str) -> None:
        """Let the program of a robot fail in the next tick."""
        self._faults.append(Fault(robot, "crash", self.tick + 1, 1, "scripted"))

    def tell(self, robot: str, text: str) -> None:
        """Let a robot send the referee a message; it arrives in the next tick, after earlier ones."""
        self._messages.setdefault(self.roster.index[robot], []).append(text)

    def play(self, ticks: int = 1) -> RefereeOutput:
        """Judge so many ticks and return the last output."""
        for _ in range(ticks):
            self.tick += 1
            by_hand, self._by_hand = frozenset(self._by_hand), set()
            self.output = self._take(self.referee.judge(self._snapshot(), by_hand))
            self._store_broadcast()
        return self.output

    def play_until(self, tick: int) -> RefereeOutput:
        """Judge up to a tick, or to the end of the half, and return the last output."""
        while self.tick < tick and self.output.ended is None and not self.referee.time_is_up:
            self.play()
        return self.output

    def finish(self) -> RefereeOutput:
        """End the half."""
        self.is_over = True
        self.output = self._take(self.referee.finish())
        return self.output

    # --- what came of it --------------------------------------------------------------------------------------------

    def pose(self, entity: str) -> Pose2:
        """Return the pose of an entity: x and y in m, yaw in rad."""
        return self._poses[self.roster.index[entity]]

    def names(self) -> list[str]:
        """Return the names of all events so far."""
        return [event.name for event in self.events]

    def events_named(self, name: str) -> list[Event]:
        """Return the events of one name so far."""
        return [event for event in self.events if event.name == name]

    # --- the stage --------------------------------------------------------------------------------------------------

    def _stand(self, index: int, x_m: float, y_m: float, yaw_rad: float) -> None:
        self._poses = [*self._poses]
        self._poses[index] = _float32(x_m, y_m, yaw_rad)

    def _snapshot(self) -> Snapshot:
        substeps = [self._glided() if self._glides else self._poses for _ in range(SUBSTEPS_PER_TICK)]
        touches = (tuple(sorted(self._touching)),) * SUBSTEPS_PER_TICK
        self._touching = {pair: left - 1 for pair, left in self._touching.items() if left > 1}
        faults, self._faults = tuple(self._faults), []
        messages = tuple((robot, texts.pop(0)) for robot, texts in sorted(self._messages.items()) if texts)
        return Snapshot(self.tick, substeps, self._heights, [*self._uprights], touches, faults, messages)

    def _glided(self) -> list[Pose2]:
        """Move what glides by one sub-step; each step is the rest of the way over the sub-steps that are left."""
        poses = list(self._poses)
        for index, (to, left) in [*self._glides.items()]:
            here = poses[index]
            goal = (*to, *here[len(to) :])
            poses[index] = _float32(*(a + (b - a) / left for a, b in zip(here, goal, strict=True)))
            self._glides[index] = to, left - 1
            if left == 1:
                del self._glides[index]
        self._poses = poses
        return poses

    def _take(self, output: RefereeOutput) -> RefereeOutput:
        """Note an output and carry out its placements."""
        self.events += output.events
        self.firings += output.firings
        if self.referee.phase != self.phases[-1][1]:
            self.phases.append((self.tick, self.referee.phase))
        for placement in output.placements:
            self.placements.append((self.tick, placement))
            index = placement.entity
            self._glides.pop(index, None)  # it stays put until the script moves it again
            self._touching = {pair: left for pair, left in self._touching.items() if index not in pair}
            if placement.parked:
                self._parked.add(index)
                self._stand(index, _PARKED_X_M + index * _PARKED_STEP_M, 0.0, 0.0)
                continue
            self._parked.discard(index)
            self._stand(index, placement.x_m, placement.y_m, placement.yaw_rad)
            self._uprights[index] = 1.0
        return output

    def _store_broadcast(self) -> None:
        """Store what each robot's program receives beyond the official packet."""
        to_all, to_some = self.output.broadcast, self.output.private_broadcasts or {}
        if to_all is None:
            return
        for robot, name in enumerate(self.roster.entities[: self.roster.robots]):
            self.received[name] = {**to_all, **to_some.get(robot, {})}


def _float32(x_m: float, y_m: float, yaw_rad: float) -> Pose2:
    return float32(x_m), float32(y_m), float32(yaw_rad)
