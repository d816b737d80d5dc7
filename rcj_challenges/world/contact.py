"""Contact, grip and collision parameters, each with its source: the reference (section 2) or a measurement (ADR 2).

MuJoCo solves contacts on accelerations. For a contact of depth r that closes at the speed v, the target is the
acceleration ``-b v - k r`` (`solref` = [-k, -b]), of which the share `solimp` is enforced. With b = (1 + e) / sub-step,
one sub-step turns the speed v into -e v: that is restitution e at every speed, wherever within a sub-step the bodies
meet.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from rcj_challenges.chassis.base import Chassis
from rcj_challenges.core.timing import SUBSTEP_S
from rcj_challenges.scenario.models.field import Ball

# --- collision bits ---------------------------------------------------------------------------------------------------
# MuJoCo lets two geoms collide if `contype` of one shares a bit with `conaffinity` of the other.
ON_FLOOR = 1
AMONG_SOLIDS = 2
FIXED = 4
"""Of walls and fixed obstacles: everything that moves collides with them."""

# --- geom groups: what a ray can select -------------------------------------------------------------------------------
GROUP_FLOOR = 0
GROUP_FIXTURES = 1
"""Walls, goals and obstacles, fixed or movable."""
GROUP_CHASSIS = 2
GROUP_WHEELS = 3
GROUP_BALLS = 4
GROUP_BORDER = 5
"""What ends the floor of a field without walls."""

# --- whose parameters count in a contact: those of the geom of the higher priority ------------------------------------
PRIORITY_SOLID = 0
PRIORITY_WHEEL = 1
PRIORITY_BALL = 2
PRIORITY_FLOOR = 3


@dataclass(frozen=True)
class Softness:
    """How a contact answers.

    Attributes:
        restitution: share of the closing speed that is given back.
        stiffness_ps2: how hard it pushes overlapping bodies apart, in 1/s² (acceleration per depth).
        rigidity: share of the wanted acceleration that is enforced; the rest yields to standing forces.
    """

    restitution: float
    stiffness_ps2: float
    rigidity: float

    @property
    def solref(self) -> list[float]:
        """MuJoCo's reference parameters in their direct form: minus stiffness, minus damping."""
        return [-self.stiffness_ps2, -(1 + self.restitution) / SUBSTEP_S]

    @property
    def solimp(self) -> list[float]:
        """MuJoCo's impedance parameters: the same rigidity at any depth."""
        return [self.rigidity, self.rigidity, 0.001, 0.5, 2.0]


SOLIDS = Softness(restitution=0.5, stiffness_ps2=500.0, rigidity=0.99)
"""Robots and obstacles against each other and against walls, and robots against balls. Restitution 0.5: reference,
section 2. A robot at full speed then sends a resting ball off at 0.253 to 0.261 m/s (ADR 13)."""

BALL_ON_MOVING_FRICTION = 0.1
"""Highest friction between a ball and a robot or another ball. Not 1 as elsewhere: with 1 at the floor and 1 at the
face that pushes it, a ball jams instead of rolling, and a hit ends in the floor (ADR 2)."""

BALL_ON_SOLID_FRICTION = 1.0
"""Highest friction between a ball and walls or obstacles. A ball that rolls at a wall sticks to it from 0.2 on, so more
would change nothing; but with 1.5 to 2 at wall and floor the ball jammed between them, and lay still (ADR 2)."""

_FLOOR_YIELDS = 1 / 12
"""How much the floor yields to a ball: chosen for the 0.1 mm of `ball_on_floor`."""

_LEAST_FRICTION_MADE_UP_FOR = 0.5
"""On a smoother floor the ball sinks in by less: as soft a floor as 0.1 mm would need does not carry it."""

_USUAL_SHARE = Ball().mass_kg / Chassis().mass_kg
"""Ratio of the masses of the usual ball and the usual robot."""

OBSTACLE_GLIDES = 0.1
"""Highest friction between a movable obstacle and the floor: no robot could push the default 0.5 kg at 1 (ADR 2)."""

WHEEL_GLIDES = 0.1
"""Highest friction between a wheel's outline and walls, obstacles and robots. What touches there is the rim, which
moves up or down with up to 0.2 m/s while the wheel turns: Coulomb's friction acts against that, and leaves next to
nothing along a wall (ADR 2)."""

GRIP_RIGIDITY = 0.999
"""Of the wheels' grip: a braked robot creeps by less than 0.1 mm/s under any push that its grip can hold."""


def ball_on_floor(friction: float) -> tuple[Softness, float]:
    """Return the ball's contact with a floor of the given friction, and the friction to set in MuJoCo.

    No bounce. MuJoCo's pyramid bounds the sum of the forces along x and y: with 1, a ball that slides at 45° to both is
    held by 0.71 of its weight, and a hit in that direction sent it off 4 % slower. With √2, the pyramid contains the
    whole of Coulomb's cone; it is then the original's bound, on each of both forces separately, turned by 45° (ADR 2).

    A pyramid of friction m yields to its load in proportion to m² (1 + m²). Rigidity makes up for that: the ball
    sinks in by 0.1 mm, so that its centre rests 0.0209 above the floor (reference, section 2).
    """
    mujoco_friction = friction * math.sqrt(2)
    load = max(mujoco_friction, _LEAST_FRICTION_MADE_UP_FOR) ** 2
    rigidity = 1 / (1 + _FLOOR_YIELDS / (load * (1 + load)))
    return Softness(restitution=0.0, stiffness_ps2=1 / (2 * SUBSTEP_S) ** 2, rigidity=rigidity), mujoco_friction


def ball_on_solid(restitution: float, rigidity: float = SOLIDS.rigidity) -> Softness:
    """Return the ball's contact with walls, obstacles and (but for the friction) other balls."""
    return Softness(restitution=restitution, stiffness_ps2=500.0, rigidity=rigidity)


def ball_rigidity(ball_kg: float, robot_kg: float) -> float:
    """Return the rigidity of a ball's contacts, by its mass and that of the heaviest robot that may pin it to a wall.

    A contact yields to a constant push in proportion to the push, more for light bodies. With the same rigidity for
    all, a ball of 5 g that a robot of 1.5 kg pins sank into the wall by 19 mm (ADR 2). So the lighter the ball is
    beside the robot, the less its contacts yield.
    """
    share = ball_kg / robot_kg / _USUAL_SHARE
    return SOLIDS.rigidity if share >= 1.0 else 1 / (1 + (1 / SOLIDS.rigidity - 1) * share)
