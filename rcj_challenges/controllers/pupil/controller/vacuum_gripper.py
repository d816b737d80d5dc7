"""``controller.vacuum_gripper`` of R2023a."""

from ._absent import VacuumGripper

__all__ = ["VacuumGripper"]
