"""What programs that were written for Webots R2021b to R2023a ask of the module ``controller``."""

from __future__ import annotations

import math
import struct

import pytest
from fake_match import INDEX, FakeMatch, Played, packet

LEFT = INDEX["left wheel motor"]
INFINITE = math.inf

_HEAD = """
from controller import Robot
robot = Robot()
motor = robot.getDevice("left wheel motor")
"""


def _play(match: FakeMatch, lines: str, ticks: int = 1) -> Played:
    played = match.play(_HEAD + lines, ticks)
    assert played.fault is None, played.log
    return played


def _speeds(played: Played) -> list[tuple[int, float]]:
    """At which tick the left motor was commanded which velocity."""
    told = [(tick, m.velocity_radps) for tick, request in played.requests for m in request.motors if m.device == LEFT]
    return [(tick, round(speed, 9)) for tick, speed in told]


def test_a_motor_with_an_acceleration_reaches_its_speed_step_by_step_without_further_calls(match: FakeMatch) -> None:
    played = _play(
        match,
        "motor.setPosition(float('inf')); motor.setVelocity(0); motor.setAcceleration(100)\n"
        "robot.step(32)\n"
        "motor.setVelocity(10)\n"
        "while robot.step(32) != -1:\n"
        "    print(motor.getVelocity(), motor.getAcceleration())\n",
        7,
    )
    # 100 rad/s² are 3.2 rad/s in a tick of 32 ms; getVelocity goes on giving what was set.
    assert _speeds(played) == [(0, 0.0), (1, 3.2), (2, 6.4), (3, 9.6), (4, 10.0)]
    assert set(played.said) == {"10.0 100.0"}


def test_braking_and_reversing_are_limited_by_the_acceleration_too(match: FakeMatch) -> None:
    played = _play(
        match,
        "motor.setPosition(float('inf')); motor.setVelocity(5)\n"
        "robot.step(32)\n"
        "motor.setAcceleration(100); motor.setVelocity(-2)\n"
        "while robot.step(32) != -1: pass\n",
        6,
    )
    assert _speeds(played) == [(0, 5.0), (1, 1.8), (2, -1.4), (3, -2.0)]


def test_an_acceleration_of_minus_1_lets_the_speed_be_reached_at_once(match: FakeMatch) -> None:
    played = _play(
        match,
        "motor.setPosition(float('inf')); motor.setAcceleration(100)\n"
        "robot.step(32)\n"
        "motor.setAcceleration(-1); print(motor.getAcceleration())\n"
        "robot.step(32)\n"
        "motor.setVelocity(-10)\n"
        "while robot.step(32) != -1: pass\n",
        5,
    )
    assert _speeds(played) == [(0, 3.2), (1, 10.0), (2, -10.0)]
    assert played.said == ["-1.0"]


def test_a_motor_that_held_an_angle_speeds_up_from_rest(match: FakeMatch) -> None:
    played = _play(
        match,
        "motor.setAcceleration(100); motor.setPosition(float('inf')); motor.setVelocity(9)\n"
        "robot.step(32)\n"
        "motor.setPosition(1.5)\n"
        "robot.step(32)\n"
        "motor.setPosition(float('inf'))\n"
        "while robot.step(32) != -1: pass\n",
        6,
    )
    assert played.motors() == [
        (LEFT, pytest.approx(3.2), INFINITE),
        (LEFT, 9.0, 1.5),
        (LEFT, pytest.approx(3.2), INFINITE),
        (LEFT, pytest.approx(6.4), INFINITE),
        (LEFT, 9.0, INFINITE),
    ]


def test_an_acceleration_that_is_no_number_is_refused(match: FakeMatch) -> None:
    played = _play(match, "motor.setAcceleration(float('nan')); print(motor.acceleration)\nrobot.step(32)\n")
    assert played.said == ["Error: 'left wheel motor': setAcceleration(NaN) is refused.", "-1.0"]


def test_a_class_of_the_teams_own_may_use_names_that_are_attributes_of_a_robot(match: FakeMatch) -> None:
    program = """
from controller import Robot
class Striker(Robot):
    def __init__(self):
        super().__init__()
        self.name = self.getName()
        for name in ("time", "mode", "model", "supervisor", "synchronization", "custom_data", "basic_time_step",
                     "number_of_devices", "keyboard", "_connection", "_devices", "_by_index", "_told_of"):
            setattr(self, name, "mine")
            assert getattr(self, name) == "mine"
    def getMode(self):
        return "attack"
    def getBasicTimeStep(self):
        return "no number"
striker = Striker()
striker.step()
print(striker.name, striker.getTime(), striker.getModel(), striker.getDevice("gps").getName(), striker.getLidar("lidar"))
striker.step(32)
"""
    played = match.play(program, 2)
    assert played.fault is None, played.log
    assert played.said[-1] == "Y1 0.032  gps <Lidar 'lidar'>"


def test_devices_take_attributes_of_the_teams_own(match: FakeMatch) -> None:
    played = _play(
        match,
        "motor.name = 'left'; motor.type = 'wheel'; motor.side = 1\n"
        "receiver = robot.getDevice('ball receiver'); receiver.data = 'old'; receiver.bytes = 5\n"
        "print(motor.name, motor.type, motor.side, receiver.data, receiver.bytes, motor.getName(), motor.getType())\n"
        "robot.step(32)\n",
    )
    assert played.said == ["left wheel 1 old 5 left wheel motor 0"]


@pytest.mark.parametrize(
    "imports", ["from controller import Robot, Keyboard, Mouse, Joystick", "from controller import *"]
)
def test_keyboard_mouse_and_joystick_are_there_and_nobody_uses_them(match: FakeMatch, imports: str) -> None:
    program = (
        imports
        + """
robot = Robot()
keyboard, mouse, joystick = Keyboard(), Mouse(), Joystick()
for device in (keyboard, mouse, joystick, robot.getKeyboard(), robot.getMouse(), robot.getJoystick()):
    device.enable(64)
print(keyboard.getSamplingPeriod(), robot.getKeyboard().getSamplingPeriod(), robot.keyboard is robot.getKeyboard())
robot.step(32)
print(keyboard.getKey(), robot.getKeyboard().getKey(), keyboard.key == ord("W"), mouse.getState().left)
print(joystick.isConnected(), joystick.getPressedButton(), joystick.getNumberOfAxes())
print([getattr(Keyboard, key) for key in ("END", "HOME", "LEFT", "UP", "RIGHT", "DOWN", "PAGEUP", "PAGEDOWN")])
print([getattr(Keyboard, "NUMPAD_" + key) for key in ("HOME", "LEFT", "UP", "RIGHT", "DOWN", "END")])
print([getattr(Keyboard, key) for key in ("KEY", "SHIFT", "CONTROL", "ALT")])
keyboard.disable()
print(keyboard.getSamplingPeriod())
robot.step(32)
"""
    )
    played = match.play(program, 2)
    assert played.fault is None, played.log
    assert played.said == [
        "64 64 True",
        "-1 -1 False False",
        "False -1 0",
        "[312, 313, 314, 315, 316, 317, 366, 367]",
        "[375, 376, 377, 378, 379, 382]",
        "[65535, 65536, 131072, 262144]",
        "0",
    ]


def test_a_motor_and_its_wheels_sensor_know_each_other(match: FakeMatch) -> None:
    played = _play(
        match,
        "sensor = robot.getDevice('left wheel sensor')\n"
        "print(motor.getPositionSensor() is sensor, sensor.getMotor() is motor, motor.getBrake(), sensor.getBrake())\n"
        "robot.step(32)\n",
    )
    assert played.said == ["True True None None"]


def test_what_webots_has_and_this_world_has_not_is_accepted(match: FakeMatch) -> None:
    played = _play(
        match,
        "motor.setControlPID(10, 0, 0); motor.setAvailableForce(3); motor.setAvailableTorque(2)\n"
        "print(motor.getMaxForce(), motor.getAvailableForce(), motor.getAvailableTorque())\n"
        "print(robot.getDevice('distancesensor left').getLookupTable())\n"
        "robot.setCustomData('goalie'); robot.setMode(0, ''); robot.wwiSendText('hi')\n"
        "print(robot.getCustomData(), robot.custom_data, robot.getMode(), [robot.wwiReceiveText(), robot.getWorldPath()])\n"
        "import os; print(os.path.samefile(robot.getProjectPath() + '/controllers/robot.py', 'robot.py'), [robot.getUrdf()])\n"
        "from controller import GPS; gps = robot.getDevice('gps')\n"
        "print(GPS.convertToDegreesMinutesSeconds(12.51), gps.convertToDegreesMinutesSeconds(-0.5))\n"
        "robot.batterySensorEnable(32)\n"
        "print(robot.batterySensorGetSamplingPeriod(), robot.batterySensorGetValue())\n"
        "robot.batterySensorDisable(); print(robot.batterySensorGetSamplingPeriod())\n"
        "robot.step(32)\n",
    )
    assert played.said == [
        "10.0 2.0 2.0",
        "[0.0, 0.0, 0.0, 1.0, 1000.0, 0.0]",
        "goalie goalie 0 ['', '']",
        "True ['']",
        "12° 30' 36\" 0° 30' 0\"",
        "32 nan",
        "0",
    ]
    assert played.motors() == []


def test_a_robot_tells_its_kind_and_each_device_its_tag(match: FakeMatch) -> None:
    played = _play(
        match,
        "from controller import Node\n"
        "other = robot.getDevice('right wheel motor')\n"
        "print(robot.getType() == Node.ROBOT, robot.getDeviceByIndex(2).getTag(), motor.getTag() != other.getTag())\n"
        "print(robot.getAltimeter('gps'), robot.getSkin('skin'), robot.getVacuumGripper('gripper'))\n"
        "robot.step(32)\n",
    )
    assert played.said[0] == "True 3 True"  # 0 is the robot's own
    assert played.said[-1] == "None None None"


def test_the_period_of_the_torque_feedback_is_kept_and_the_torque_is_always_0(match: FakeMatch) -> None:
    played = _play(
        match,
        "motor.enableTorqueFeedback(32)\n"
        "robot.step(32)\n"
        "print(motor.getTorqueFeedbackSamplingPeriod(), motor.getTorqueFeedback())\n"
        "motor.disableTorqueFeedback(); print(motor.getTorqueFeedbackSamplingPeriod())\n"
        "motor.enableTorqueFeedback(0.032); print(motor.getTorqueFeedbackSamplingPeriod())\n"
        "motor.enableTorqueFeedback(float('inf')); print(motor.getTorqueFeedbackSamplingPeriod())\n"
        "robot.step(32)\n",
        2,
    )
    assert played.said == ["32 0.0", "0", "1", "2147483647"]


def test_cells_of_a_lidar_are_0_until_they_are_measured_also_before_the_first_step(match: FakeMatch) -> None:
    played = _play(
        match,
        'lidar = robot.getDevice("lidar"); lidar.enable(32); lidar.enablePointCloud()\n'
        "print(lidar.getRangeImage(), lidar.getPointCloud()[0].x)\nwhile robot.step(32) != -1: pass\n",
    )
    assert played.said == [f"{[0.0] * 8} 0.0"]


def test_the_lidar_gives_buffers_of_float32_on_request(match: FakeMatch) -> None:
    played = _play(
        match,
        "lidar = robot.getDevice('lidar'); lidar.enable(32)\n"
        "print(lidar.getPointCloud(data_type='buffer'))\n"
        "lidar.enablePointCloud(); robot.step(32)\n"
        "ranges, points = lidar.getRangeImage(data_type='buffer'), lidar.getPointCloud(data_type='buffer')\n"
        "print(type(ranges), type(points), points == lidar.getLayerPointCloud(0, 'buffer'))\n"
        "print(ranges.hex(), points.hex())\n"
        "robot.step(32)\n",
        2,
    )
    assert played.said[:2] == ["bytearray(b'')", "<class 'bytearray'> <class 'bytearray'> True"]
    ranges, points = map(bytes.fromhex, played.said[2].split())
    assert struct.unpack("<8f", ranges) == pytest.approx([0.5, 0.6, 0.7, 0.8, 0.9, 1.0, 1.1, 1.2])
    cloud = list(struct.iter_unpack("<fffif", points))  # x, y, z, layer_id, time
    assert len(cloud) == 8
    assert cloud[2] == pytest.approx((0.0, -0.7, 0.0, 0, 0.032))


def test_sending_what_cannot_be_sent_names_the_emitter_and_what_was_given(match: FakeMatch) -> None:
    played = _play(
        match,
        "emitter = robot.getDevice('team emitter')\n"
        "for message in ({'x': 1}, {1.0: 2}, 5, None, [1, 'a'], {1, 2}):\n"
        "    try:\n        emitter.send(message)\n"
        "    except TypeError as error:\n        print(error)\n"
        "robot.step(32)\n",
    )
    head = "'team emitter': send takes bytes, a str or a list of numbers; "
    tail = " json.dumps makes a str of other data, struct.pack bytes."
    assert played.said == [
        head + found + tail
        for found in (
            "dict was given.",
            "dict was given.",
            "int was given.",
            "NoneType was given.",
            "list was given, and not all in it are numbers.",
            "set was given.",
        )
    ]
    assert played.sent() == []


def test_lists_tuples_arrays_and_views_of_bytes_are_sent_as_ever(match: FakeMatch) -> None:
    program = """
import array
import numpy as np
from controller import Robot
robot = Robot()
emitter = robot.getDevice("team emitter")
for message in ([0.5, 2], (1,), np.array([1.5, 2.5]), array.array("d", [3]), memoryview(b"view"), "Gruß", range(2)):
    emitter.send(message)
robot.step(32)
"""
    played = match.play(program, 1)
    assert played.fault is None or played.fault.kind == "exit", played.log
    numbers = ([0.5, 2], [1], [1.5, 2.5], [3])
    packed = [struct.pack(f"{len(some)}d", *some) for some in numbers]
    assert played.sent() == [*packed, b"view", "Gruß".encode(), struct.pack("2d", 0, 1)]


def test_a_packet_cut_to_a_size_is_sent_so(match: FakeMatch) -> None:
    played = match.play(
        "from controller import Robot\nrobot = Robot()\nrobot.getDevice('team emitter').send(b'abcdef', 3)\n"
        "while robot.step(32) != -1: pass\n",
        2,
        lambda _: [packet("team receiver", b"x")],
    )
    assert played.sent() == [b"abc"]
