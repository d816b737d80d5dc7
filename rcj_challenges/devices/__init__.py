"""Sensors, motors and radio: what a kit may have, one file each.

Belongs here: what a device is in a scenario, what it measures, its noise, and what programs, recordings and the rule
sheet are given of it. Does not belong here: the devices of all robots together (robots), how rays are cast (world).
Files here import neither scenario nor MuJoCo, and numpy only when a sensor is made.

Every device measures in the frames of the rule book: x forward, y left, z up of the robot; while a robot stands, its
frame is level and heights are nominal (ADR 5).
"""

from typing import Annotated

from rcj_challenges.devices.accelerometer import AccelerometerDevice
from rcj_challenges.devices.ball_receiver import BallReceiverDevice
from rcj_challenges.devices.ball_sensor import BallSensorDevice
from rcj_challenges.devices.base import DEVICES, Device
from rcj_challenges.devices.camera import CameraDevice
from rcj_challenges.devices.compass import CompassDevice
from rcj_challenges.devices.dribbler import DribblerDevice
from rcj_challenges.devices.floor_sensor import FloorSensorDevice
from rcj_challenges.devices.gps import GpsDevice
from rcj_challenges.devices.gyro import GyroDevice
from rcj_challenges.devices.inertial_unit import InertialUnitDevice
from rcj_challenges.devices.kicker import KickerDevice
from rcj_challenges.devices.led import LedDevice
from rcj_challenges.devices.lidar import LidarDevice
from rcj_challenges.devices.motor import MotorDevice
from rcj_challenges.devices.sonar import SonarDevice
from rcj_challenges.devices.supervisor_receiver import SupervisorReceiverDevice
from rcj_challenges.devices.team_emitter import TeamEmitterDevice
from rcj_challenges.devices.team_receiver import TeamReceiverDevice
from rcj_challenges.devices.touch_sensor import TouchSensorDevice
from rcj_challenges.devices.wheel_sensor import WheelSensorDevice

DEVICES.add(
    MotorDevice,
    WheelSensorDevice,
    GpsDevice,
    CompassDevice,
    SonarDevice,
    BallReceiverDevice,
    SupervisorReceiverDevice,
    TeamReceiverDevice,
    TeamEmitterDevice,
    LidarDevice,
    CameraDevice,
    KickerDevice,
    DribblerDevice,
    BallSensorDevice,
    FloorSensorDevice,
    TouchSensorDevice,
    GyroDevice,
    AccelerometerDevice,
    InertialUnitDevice,
    LedDevice,
)

AnyDevice = Annotated[Device, DEVICES]


def device_of_class(name: str) -> type[Device]:
    """Return the first kind of device that programs know as this class (`DeviceSpec.kind`), or else `Device`."""
    kinds = (kind for kind in DEVICES.words() if issubclass(kind, Device) and name == kind.CLASS)
    return next(kinds, Device)
