"""Effects on bodies beyond MuJoCo's own step, one file each (ADR 2), and the drives of chassis."""

from __future__ import annotations

from collections.abc import Callable

from rcj_challenges.chassis.base import Chassis, Drive, Mount, Physics
from rcj_challenges.scenario.kits import chassis_of
from rcj_challenges.world.effects.base import Effect, Scene
from rcj_challenges.world.effects.bumpers import Bumpers
from rcj_challenges.world.effects.cylinder_contacts import CylinderContacts
from rcj_challenges.world.effects.dribbler import Dribblers
from rcj_challenges.world.effects.friction import GlidingFriction, RollingFriction
from rcj_challenges.world.effects.kicker import Kickers
from rcj_challenges.world.effects.restitution import Restitution
from rcj_challenges.world.effects.tunneling import Tunneling
from rcj_challenges.world.tables import one_by_one, turned_at


def make_effects(scene: Scene) -> list[Effect]:
    """Return all effects of a world in the order in which they act, after the drives."""
    kinds: tuple[Callable[[Scene], Effect], ...]
    kinds = RollingFriction, GlidingFriction, CylinderContacts, Tunneling, Restitution, Kickers, Dribblers, Bumpers
    return [effect for kind in kinds if (effect := kind(scene)).is_needed]


def make_drives(scene: Scene) -> list[Drive]:
    """Return the drive of each robot, which it shares with all that have the same kind of chassis."""
    model, data, names = scene.model, scene.data, scene.roster.entities[: scene.roster.robots]
    chassis = [chassis_of(scene.scenario, name) for name in names]
    friction = scene.scenario.field.friction
    limits_n, turned_rad = one_by_one(model.tendon_frictionloss), one_by_one(data.userdata)
    numbers = one_by_one(data.qpos), one_by_one(data.qvel), one_by_one(model.wrap_prm), limits_n, turned_rad
    mounts: dict[type[Chassis], list[Mount]] = {}
    for robot, (name, one, turned) in enumerate(zip(names, chassis, turned_at(chassis), strict=False)):
        grip = int(model.tendon(f"{name}/{one.grips(friction)[0].name}").id)
        mount = Mount(robot, one, scene.tables.qpos_at[robot], grip, int(model.tendon_adr[grip]), turned)
        mounts.setdefault(type(one), []).append(mount)
    drives = {kind: kind.make_drive(Physics(*numbers, friction), some) for kind, some in mounts.items()}
    return [drives[type(one)] for one in chassis]
