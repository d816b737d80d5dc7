"""Chassis: what carries a robot and drives it, one file each.

Belongs here: a chassis in a scenario, its body and wheels, its grip on the floor, and how commands turn its wheels.
Does not belong here: how bodies become MuJoCo's (world), and what drives the wheels (devices). Files here import
neither scenario nor MuJoCo: they describe bodies as data, and act on MuJoCo's numbers through memory views.
"""

from typing import Annotated

from rcj_challenges.chassis.base import CHASSIS, Chassis
from rcj_challenges.chassis.differential import DifferentialChassis
from rcj_challenges.chassis.omni import OmniChassis

CHASSIS.add(DifferentialChassis, OmniChassis)

AnyChassis = Annotated[Chassis, CHASSIS]
USUAL_CHASSIS: Chassis = DifferentialChassis.model_construct()
