"""``controller.inertial_unit`` of R2023a."""

from ._absent import InertialUnit

__all__ = ["InertialUnit"]
