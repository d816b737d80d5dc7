"""All that takes part in a half. Imports physics and numerics, which `match` leaves until programs are starting."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from rcj_challenges.core.play import HalfInfo
from rcj_challenges.match.driver import Driver
from rcj_challenges.referee.engine import Referee
from rcj_challenges.robots.fitting import fit, fixed_rays
from rcj_challenges.robots.manager import DeviceManager
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.roster import Roster
from rcj_challenges.world.world import World


@dataclass
class HalfStage:
    """All that takes part in a half; drivers are by robot index, robots without one stand braked."""

    world: World
    referee: Referee
    devices: DeviceManager
    drivers: Mapping[int, Driver]


def build_stage(scenario: Scenario, roster: Roster, half: HalfInfo, drivers: Mapping[int, Driver]) -> HalfStage:
    """Compile the world of a checked scenario, and set up referee and devices for one half in it."""
    world = World(scenario, roster, fixed_rays(fit(scenario, roster)))
    return HalfStage(world, Referee(scenario, roster, half), DeviceManager(scenario, roster, world, half), drivers)
