"""From where the field is looked at."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from difflib import get_close_matches

import numpy as np

from rcj_challenges.scenario.roster import Roster
from rcj_challenges.views.video.errors import VideoError
from rcj_challenges.views.video.footage import Footage, HalfFootage

KINDS = ("field", "top", "side", "follow-ball")
CALM_S = 0.8
"""A camera that follows something looks at where it is on average over this long: it glides, also over a jump."""


@dataclass(frozen=True)
class Camera:
    """A camera.

    Attributes:
        kind: ``field`` (all of it, from a raised seat; from above where nothing is solid), ``top``, ``side``,
            ``behind`` or ``follow-ball``.
        entity: index of the robot or ball that is followed, -1: none.
    """

    kind: str
    entity: int

    @classmethod
    def named(cls, name: str, roster: Roster) -> Camera:
        """Return the camera that a name means.

        Raises:
            VideoError: there is no such camera, robot or ball; the message lists what there is.
        """
        kind, colon, robot = name.partition(":")
        robots = roster.entities[: roster.robots]
        if kind == "behind" and colon:
            if robot not in robots:
                raise VideoError(
                    f"--camera {name[:60]}: there is no robot {robot[:40]!r}{_near(robot, robots)}; "
                    f"robots are {', '.join(robots)}"
                )
            return cls("behind", roster.entities.index(robot))
        if name not in KINDS:
            listed = ", ".join((*KINDS, f"behind:{robots[0]}" if robots else "behind:ROBOT"))
            raise VideoError(f"--camera {name[:60]!r} is unknown{_near(name, (*KINDS, 'behind:'))}; there are {listed}")
        if name == "follow-ball":
            if not roster.balls:
                raise VideoError("--camera follow-ball: this scenario has no ball")
            return cls(name, roster.robots)
        return cls(name, -1)

    def target(self, half: HalfFootage, t_s: float) -> tuple[float, float]:
        """Return the point of the field that it looks at: the middle, or near what it follows."""
        if self.entity < 0:
            return (0.0, 0.0)
        x_m, y_m = half.mean_place(self.entity, t_s, CALM_S)
        return (0.0, 0.0) if np.isnan(x_m) else (x_m, y_m)


def ends_of_field(footage: Footage) -> tuple[float, float]:
    """Return how far walls and goals reach from the middle along x and y, in m."""
    field: Mapping[str, float] = footage.things["field"]
    deepest = max((goal["depth_m"] for goal in footage.things["field"]["goals"]), default=0.0)
    return field["width_m"] / 2 + WALL_M, field["length_m"] / 2 + deepest + WALL_M


WALL_M = 0.012
"""How thick walls are drawn, outside of their inner faces."""


def _near(name: str, names: tuple[str, ...]) -> str:
    near = get_close_matches(name, names, 1)
    return f"; did you mean {near[0]!r}?" if near else ""
