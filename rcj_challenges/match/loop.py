"""One half: the loop, in the order of the tick contract (ADR 1)."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from rcj_challenges.core.play import Fault, HalfInfo, RefereeOutput, Snapshot
from rcj_challenges.core.traffic import Request
from rcj_challenges.scenario.halves import MAX_LENGTHS

if TYPE_CHECKING:
    from rcj_challenges.match.stage import HalfStage
    from rcj_challenges.referee.engine import Referee


@dataclass(frozen=True)
class LoopResult:
    """How a half ended.

    Attributes:
        ended: None if the time was up, else the reason of the rule that ended it, or the match when it was over.
        ends_match: whether that rule ended the whole match.
        closing: the output of the rules of ``half_ended`` after the last tick.
    """

    ticks: int
    ended: str | None
    ends_match: bool
    closing: RefereeOutput


_LIMITS_EVERY = 64
"""Ticks between checks of programs in longer steps."""

OnTick = Callable[[Snapshot, RefereeOutput, bytes, bytes], None]
"""Takes a snapshot, the referee's output, and from the world `state_bytes` and `poses_bytes`."""


def should_continue(referee: Referee, output: RefereeOutput, tick: int, half: HalfInfo) -> bool:
    """Return whether another tick follows this one: the clock of the half decides, which a phase may stop."""
    if output.ended is not None or referee.time_is_up:
        return False
    return tick < MAX_LENGTHS * half.ticks


@dataclass
class TickLoop:
    """Plays one half, tick by tick.

    Programs of all robots that are due are released first and collected afterwards, so that they overlap with each
    other and with the writing of the record. A program that fails has its wheels at 0 from the tick of its failure
    on; the referee learns of it with the next snapshot.

    Attributes:
        on_tick: called with every judged tick, while the programs compute the next.
        before_tick: called before each simulated tick, when all programs that were due have answered. It may wait:
            that does not count towards limits, and no program computes meanwhile.
        tick: the last one that was judged.
    """

    stage: HalfStage
    half: HalfInfo
    on_tick: OnTick
    on_fault: Callable[[Fault], None]
    before_tick: Callable[[int], None]
    tick: int = 0

    def __post_init__(self) -> None:
        self._alive = dict(self.stage.drivers)
        self._due = dict.fromkeys(self.stage.drivers, 0)
        self._later: list[tuple[int, int, Request]] = []
        self._faults: list[Fault] = []
        self._all_held = False
        self._held: frozenset[int] = frozenset()

    def play(self) -> LoopResult:
        """Play to the end. Programs still wait in their last ``step`` then: the caller ends them.

        Raises:
            PhysicsFault: the simulation became unstable.
        """
        output = self._begin()
        while should_continue(self.stage.referee, output, self.tick, self.half):
            self.before_tick(self.tick + 1)
            output = self._one_tick(self.tick + 1)
        closing = self.stage.referee.finish()
        # A half that is over cannot be ended once more, the match can.
        ended = closing.ended if closing.ends_match else output.ended
        if ended is None and not self.stage.referee.time_is_up:
            ended = f"the clock of the half stood still for too long: {self.tick} ticks were played"
        return LoopResult(self.tick, ended, closing.ends_match, closing)

    def _begin(self) -> RefereeOutput:
        """Tick 0: draws, layouts, arming; no physics. Programs run to their first ``step``."""
        stage = self.stage
        stage.world.reset()
        snapshot = stage.world.judged()
        output = stage.referee.start(snapshot)
        stage.world.place(output.placements)
        if output.robots_held or output.held:
            self._hold(output)
        stage.devices.begin(output)
        self.on_tick(snapshot, output, stage.world.state_bytes(), stage.world.poses_bytes())
        for robot in list(self._alive):
            self._take(robot, self._alive[robot].collect())
        return output

    def _one_tick(self, tick: int) -> RefereeOutput:
        stage = self.stage
        if self._later:
            self._apply_late_requests(tick)
        faults, self._faults = tuple(self._faults), []
        snapshot = stage.world.step(tick, faults)
        if messages := stage.devices.messages_to_referee(tick):
            snapshot = snapshot._replace(messages=messages)
        state = stage.world.state_bytes()
        output = stage.referee.judge(snapshot)
        if output.placements:
            stage.world.place(output.placements)
        if output.held is not self._held or output.robots_held is not self._all_held:
            self._hold(output)
        stage.devices.begin_sensing(tick, output)
        self.tick = tick

        due = self._sense_and_release(tick, plays_on=should_continue(stage.referee, output, tick, self.half))
        self.on_tick(snapshot, output, state, stage.world.poses_bytes())
        self._collect(due)
        if tick % _LIMITS_EVERY == 0:
            self._check_long_steps(tick)
        return output

    def _hold(self, output: RefereeOutput) -> None:
        """Hold robots from the next tick on, all or some, and let the others go."""
        self._all_held, self._held = output.robots_held, output.held
        world = self.stage.world
        world.hold_robots(range(world.tables.robots) if output.robots_held else output.held)

    def _check_long_steps(self, tick: int) -> None:
        for robot, due in list(self._due.items()):
            fault = self._alive[robot].limit_fault(tick) if due > tick + _LIMITS_EVERY else None
            if fault is not None:
                self._take(robot, fault)

    def _sense_and_release(self, tick: int, *, plays_on: bool) -> list[int]:
        """Update each robot's sensors, and release its program if it is due; return those released."""
        devices, alive = self.stage.devices, self._alive
        due = [robot for robot in devices.specs if self._due.get(robot) == tick] if plays_on else []
        for robot in devices.specs:
            devices.finish_sensing(robot)
            if robot in due:
                alive[robot].release(devices.observe(robot, tick))
        return due

    def _collect(self, due: list[int]) -> None:
        """Carry out the requests of the programs that were released, in their order."""
        alive, taken = self._alive, 0
        # The requests of the first are carried out while the last still compute.
        for robot in due:
            answer = alive[robot].collect_soon()
            if answer is None:
                break
            self._take(robot, answer)
            taken += 1
        waiting = due[taken:]
        # After a sleep until the last answer, the others are mostly ready: one sleep instead of six.
        answers = [alive[robot].collect() for robot in reversed(waiting)]
        for robot in waiting:
            self._take(robot, answers.pop())

    def _take(self, robot: int, answer: Request | Fault) -> None:
        """Carry out a request, now or after the ticks that its program slept through; or remove a failed program."""
        if isinstance(answer, Fault):
            del self._alive[robot], self._due[robot]
            self.stage.devices.silence(robot)
            self._faults.append(answer)
            self.on_fault(answer)
            return
        begins = self.tick + answer.missed_ticks
        self._due[robot] = begins + answer.advance_ticks
        if answer.missed_ticks:
            self._later.append((begins, robot, answer))
        else:
            self.stage.devices.apply(robot, answer)

    def _apply_late_requests(self, tick: int) -> None:
        """Requests of programs that slept take effect at the tick at which they woke up."""
        for begins, robot, request in self._later:
            if begins < tick:
                self.stage.devices.apply(robot, request)
        self._later = [entry for entry in self._later if entry[0] >= tick]
