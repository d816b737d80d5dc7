"""The trigger ``tips_over``."""

from collections.abc import Callable
from math import acos, cos, pi
from typing import Annotated, Literal

from rcj_challenges.rules.base import Binder, Phrases, Trigger
from rcj_challenges.rules.fields import Names, described
from rcj_challenges.rules.phrasing import degrees
from rcj_challenges.rules.refs import Ref
from rcj_challenges.rules.values import Angle, compile_limit, limit_words
from rcj_challenges.tracking.state import RefereeState
from rcj_challenges.tracking.trackers import TickTracker


class TipsOver(Trigger):
    """Fires when a robot tilts beyond a given angle."""

    trigger: Literal["tips_over"]
    entity: Annotated[
        Names,
        Ref(
            "robot",
            frozenset({"robot"}),
            groups=True,
            each=True,
            instead="an obstacle does not tip over: of a movable one 'displaced' tells that it was pushed away",
        ),
    ] = described(..., "a robot, a group of robots (any member), or each")
    angle_rad: Angle = described(0.7854, "tilt of its vertical axis in rad, read when it is placed")

    MEASURED = "its tilt in rad"
    LIMIT = "angle_rad"
    REASON = "tilted by {measured} rad, at most {limit} rad"
    EXAMPLE = """
rules:
  fell:
    triggers: [{trigger: tips_over, entity: robots, angle_rad: 0.8}]
    actions: [{action: emit, event: FELL, payload: {robot_name: {word: entity_name}}}]
expect:
  it_is_named:
    keyframes: [{at_s: 1, tips: [B3]}]
    lasts_s: 2
    events: [{event: FELL, payload: {robot_name: B3}}]
"""

    def bind(self, to: Binder) -> None:
        limit_rad = compile_limit(self.angle_rad, to, most=pi, none=pi)
        for robot in to.entities(self.entity):
            key = (robot, self.angle_rad)
            to.track(TiltTracker, key, robot, limit_rad).bindings.append(to.binding(robot))

    def describe(self, phrases: Phrases) -> str:
        return (
            f"{phrases.any_of(self.entity)} tilts by more than {limit_words(phrases, self.angle_rad, degrees, 'rad')}"
        )


class TiltTracker(TickTracker):
    """Reports the tick in which a robot exceeds a tilt."""

    def __init__(self, state: RefereeState, robot: int, limit_rad: Callable[[], float]) -> None:
        super().__init__(state, robot)
        self._robot = robot
        self._read_limit_rad = limit_rad
        self._limit_rad, self._min_cos = pi, -1.0
        self._tilted = False

    def reset(self) -> None:
        """Take the present tilt for the one before."""
        self._limit_rad = self._read_limit_rad()
        self._min_cos = cos(self._limit_rad)
        self._tilted = self._state.uprights[self._robot] < self._min_cos

    def update(self) -> None:
        if not self._state.present[self._robot]:
            return
        upright = self._state.uprights[self._robot]
        was, self._tilted = self._tilted, upright < self._min_cos
        if self._tilted and not was:
            self._hits.report(self.bindings, acos(max(-1.0, min(1.0, upright))), self._limit_rad)
