"""What can be imported from ``controller``, and which constants are there."""

from __future__ import annotations

from dataclasses import replace

import pytest
from fake_match import INDEX, FakeMatch, Played, packet, robot_spec

CLASSES = (
    *("Accelerometer", "Altimeter", "AnsiCodes", "Brake", "Camera", "CameraRecognitionObject", "Compass", "Connector"),
    *("ContactPoint", "Device", "Display", "DistanceSensor", "Emitter", "Field", "GPS", "Gyro", "ImageRef"),
    *("InertialUnit", "Joystick", "Keyboard", "LED", "Lidar", "LidarPoint", "LightSensor", "Motion", "Motor", "Mouse"),
    *("MouseState", "Node", "Pen", "PositionSensor", "Radar", "RadarTarget", "RangeFinder", "Receiver", "Robot"),
    *("Sensor", "Skin", "Speaker", "Supervisor", "TouchSensor", "VacuumGripper"),
)

MODULES = {
    "accelerometer": "Accelerometer",
    "altimeter": "Altimeter",
    "ansi_codes": "AnsiCodes",
    "brake": "Brake",
    "camera": "Camera, CameraRecognitionObject",
    "compass": "Compass",
    "connector": "Connector",
    "device": "Device",
    "display": "Display, ImageRef",
    "distance_sensor": "DistanceSensor",
    "emitter": "Emitter",
    "field": "Field",
    "gps": "GPS",
    "gyro": "Gyro",
    "inertial_unit": "InertialUnit",
    "joystick": "Joystick",
    "keyboard": "Keyboard",
    "led": "LED",
    "lidar": "Lidar",
    "lidar_point": "LidarPoint",
    "light_sensor": "LightSensor",
    "motion": "Motion",
    "motor": "Motor",
    "mouse": "Mouse, MouseState",
    "node": "Node, ContactPoint",
    "pen": "Pen",
    "position_sensor": "PositionSensor",
    "radar": "Radar",
    "radar_target": "RadarTarget",
    "range_finder": "RangeFinder",
    "receiver": "Receiver",
    "robot": "Robot",
    "sensor": "Sensor",
    "skin": "Skin",
    "speaker": "Speaker",
    "supervisor": "Supervisor",
    "touch_sensor": "TouchSensor",
    "vacuum_gripper": "VacuumGripper",
}


def _play(match: FakeMatch, program: str) -> Played:
    played = match.play(program + "\nrobot.step(32)\nrobot.step(32)\n", 1)
    assert played.fault is None, played.log
    return played


@pytest.mark.parametrize(
    "imports", ["from controller import *", "from controller import " + ", ".join(CLASSES), "import controller"]
)
def test_every_class_of_webots_can_be_named(match: FakeMatch, imports: str) -> None:
    where = "controller." if imports == "import controller" else ""
    program = f"{imports}\nrobot = {where}Robot()\n" + "".join(f"assert {where}{name}\n" for name in CLASSES)
    if imports.endswith("*"):
        program += "print(os.getcwd() in sys.path)\n"  # up to R2022b the star gave these two as well
    assert _play(match, program).said == ["True"] * imports.endswith("*")


def test_making_a_device_that_no_robot_has_is_refused_also_as_a_class_of_the_teams_own(match: FakeMatch) -> None:
    played = _play(
        match,
        "from controller import Robot, Camera, Node\n"
        "class Eye(Camera): pass\n"
        "robot = Robot()\n"
        "for kind in (Camera, Eye, Node):\n"
        "    try:\n        kind('x')\n"
        "    except NotImplementedError as error:\n        print(error)\n",
    )
    assert played.said == [
        "there is no Camera on these robots",
        "there is no Camera on these robots",
        "there is no Node on these robots",
    ]


def test_each_class_has_a_module_of_its_own_as_in_r2023a(match: FakeMatch) -> None:
    program = "import controller\nfrom controller.robot import Robot\nrobot = Robot()\n"
    for module, names in MODULES.items():
        program += f"from controller.{module} import {names}\n"
        program += "".join(f"assert {name} is controller.{name}\n" for name in names.split(", "))
    _play(match, program)


def test_what_a_program_does_not_import_is_not_read(match: FakeMatch) -> None:
    played = _play(
        match,
        "import sys\nfrom controller import Robot, Motor, GPS, Receiver\nrobot = Robot()\n"
        "print(sorted(name for name in sys.modules if name.startswith('controller.') and '._' not in name))\n",
    )
    read = ["device", "lidar", "motor", "radio", "robot", "sensors"]
    assert played.said == [str([f"controller.{name}" for name in read])]


def test_a_robot_without_a_lidar_does_not_read_what_is_known_of_lidars(match: FakeMatch) -> None:
    spec = robot_spec()
    others = (one if one.kind != "lidar" else replace(one, kind="gps") for one in spec.devices)
    spec = replace(spec, devices=tuple(others))
    program = """
import sys
from controller import Robot, Motor
robot = Robot()
print("controller.lidar" in sys.modules)
from controller import Lidar, LidarPoint
print(Lidar.__name__, robot.getLidar("gps"))
robot.step(32)
robot.step(32)
"""
    said = match.play(program, 1, spec=spec).said
    assert [said[0], said[-1]] == ["False", "Lidar None"]


def test_a_name_that_webots_does_not_have_is_an_import_error(match: FakeMatch) -> None:
    played = _play(
        match,
        "import controller\nfrom controller import Robot\nrobot = Robot()\n"
        "try:\n    from controller import Ball\nexcept ImportError as error:\n    print(error.name)\n"
        "try:\n    controller.Moter\nexcept AttributeError as error:\n    print(error, error.name, error.obj is controller)\n"
        "print({'AnsiCodes', 'Motor'} <= set(dir(controller)))\n",
    )
    assert played.said == ["controller", "module 'controller' has no attribute 'Moter' Moter True", "True"]


def test_ansi_codes_are_texts_and_the_log_keeps_them(match: FakeMatch) -> None:
    played = _play(
        match,
        "from controller import Robot, AnsiCodes\nrobot = Robot()\n"
        "print(AnsiCodes.RED_FOREGROUND + AnsiCodes.BOLD + 'goal' + AnsiCodes.RESET)\n"
        "colours = ('BLACK', 'RED', 'GREEN', 'YELLOW', 'BLUE', 'MAGENTA', 'CYAN', 'WHITE')\n"
        "for place, first in (('FOREGROUND', 30), ('BACKGROUND', 40)):\n"
        "    for number, colour in enumerate(colours, first):\n"
        "        assert getattr(AnsiCodes, f'{colour}_{place}') == f'\\x1b[{number}m'\n"
        "print(repr(AnsiCodes.UNDERLINE + AnsiCodes.CLEAR_SCREEN))\n",
    )
    assert played.said == ["\x1b[31m\x1b[1mgoal\x1b[0m", r"'\x1b[4m\x1b[2J'"]


def test_each_device_tells_its_kind_as_the_constants_of_node_do(match: FakeMatch) -> None:
    played = _play(
        match,
        "from controller import Robot, Node\nrobot = Robot()\n"
        "kinds = {number: kind for kind, number in vars(Node).items() if type(number) is int and kind[0] != '_'}\n"
        "assert len(kinds) == sum(type(number) is int and kind[0] != '_' for kind, number in vars(Node).items())\n"
        "for number in range(robot.getNumberOfDevices()):\n"
        "    device = robot.getDeviceByIndex(number)\n"
        "    assert device.node_type == device.getNodeType()\n"
        "    print(device.getName(), kinds[device.getNodeType()])\n",
    )
    kinds = ("ROTATIONAL_MOTOR", "POSITION_SENSOR", "GPS", "COMPASS", "DISTANCE_SENSOR", "RECEIVER", "EMITTER", "LIDAR")
    kind_of = dict(line.rsplit(" ", 1) for line in played.said)
    assert kind_of.keys() == INDEX.keys()
    assert kind_of["left wheel motor"] == "ROTATIONAL_MOTOR"
    assert kind_of["ball receiver"] == "RECEIVER"
    assert set(kind_of.values()) == set(kinds)


def test_a_supervisor_is_a_robot_whose_further_calls_do_nothing_and_say_so_once(match: FakeMatch) -> None:
    program = """
from controller import Supervisor
robot = Supervisor()
ball = robot.getFromDef("BALL")
print(ball, robot.getRoot(), robot.getSelf(), robot.getFromDef("Y1"), robot.simulationReset(), robot.setLabel(0, "x", size=1))
print(robot.getSupervisor(), robot.getName(), robot.getDevice("gps").getName(), Supervisor.SIMULATION_MODE_PAUSE)
try:
    robot.fly()
except AttributeError as error:
    print(error, error.name, error.obj is robot)
robot.getDevice("left wheel motor").setVelocity(3)
"""
    played = _play(match, program)
    ignored = [line.split()[1] for line in played.said if line.startswith("Warning: ")]
    assert ignored == ["getFromDef", "getRoot", "getSelf", "simulationReset", "setLabel"]
    assert [line for line in played.said if not line.startswith("Warning: ")] == [
        "None None None None None None",
        "False Y1 gps 0",
        "'Supervisor' object has no attribute 'fly' fly True",
    ]
    assert [speed for _, speed, _ in played.motors()] == [3.0]


def test_a_class_of_the_teams_own_may_be_a_supervisor_and_a_second_robot_is_the_same_one(match: FakeMatch) -> None:
    program = """
from controller import Robot, Supervisor
class Coach(Supervisor):
    def __init__(self):
        super().__init__()
        self.ball = self.getFromDef("BALL")
robot = Coach()
for kind in (Supervisor, Robot):
    second = kind()
    print(second.getName(), second.getDevice("gps") is robot.getDevice("gps"), Robot.created is robot, second.getTime())
    second.step(32)
print(robot.ball, robot.getTime())
"""
    assert match.play(program, 5).said[1:6] == [
        "Error: only one Robot can be made: this second Supervisor is the same robot.",
        "Y1 True True 0.0",
        "Error: only one Robot can be made: this second Robot is the same robot.",
        "Y1 True True 0.032",
        "None 0.064",
    ]


ASKS = """
import inspect
from controller import Robot
robot = Robot()
receiver = robot.getDevice("team receiver")
receiver.enable(32)
for name in ("data", "bytes", "string", "floats", "ints", "bools", "emitter_direction"):
    assert getattr(receiver, name, None) is None, name
    try:
        getattr(receiver, name)
    except RuntimeError as error:
        assert "empty queue" in str(error)
        assert error.name is None, "or Python proposes the getter"
    else:
        print(name, "is there")
assert hasattr(receiver, "getBytes") and hasattr(receiver, "queue_length") and hasattr(type(receiver), "data")
assert "getData" in dict(inspect.getmembers(receiver))
robot.step(32)
print(receiver.data, hasattr(receiver, "bytes"))
while robot.step(32) != -1:
    pass
"""


def test_a_program_may_ask_whether_there_is_a_property_while_no_packet_is(match: FakeMatch) -> None:
    """`hasattr` and `getattr` with a default are made for `AttributeError`; else the question would end the program."""
    played = match.play(ASKS, 3, lambda _: [packet("team receiver", b"x")])
    assert played.fault is None
    assert [line for line in played.said if not line.startswith("Error:")] == ["b'x' True"]
