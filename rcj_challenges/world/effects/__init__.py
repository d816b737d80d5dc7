"""Effects on bodies beyond MuJoCo's own step, one file each (ADR 2)."""

from __future__ import annotations

from rcj_challenges.world.effects.base import Effect, Scene
from rcj_challenges.world.effects.cylinder_contacts import CylinderContacts
from rcj_challenges.world.effects.friction import GlidingFriction, RollingFriction
from rcj_challenges.world.effects.restitution import Restitution
from rcj_challenges.world.effects.tunneling import Tunneling
from rcj_challenges.world.effects.wheel_grip import WheelGrip


def make_effects(scene: Scene) -> tuple[WheelGrip, list[Effect]]:
    """Return the grip of wheels, which is commanded, and all effects of a world in the order in which they act."""
    wheel_grip = WheelGrip(scene)
    effects = [
        wheel_grip,
        RollingFriction(scene),
        GlidingFriction(scene),
        CylinderContacts(scene),
        Tunneling(scene),
        Restitution(scene),
    ]
    return wheel_grip, [effect for effect in effects if effect.is_needed]
