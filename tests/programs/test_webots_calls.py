"""What the module ``controller`` answers to programs that were written for Webots R2021b to R2023a."""

from __future__ import annotations

import re

import pytest
from fake_match import INDEX, said_by_each

CLASSES = (
    *("Accelerometer", "Altimeter", "AnsiCodes", "Brake", "Camera", "CameraRecognitionObject", "Compass", "Connector"),
    *("ContactPoint", "Device", "Display", "DistanceSensor", "Emitter", "Field", "GPS", "Gyro", "ImageRef"),
    *("InertialUnit", "Joystick", "Keyboard", "LED", "Lidar", "LidarPoint", "LightSensor", "Motion", "Motor", "Mouse"),
    *("MouseState", "Node", "Pen", "PositionSensor", "Radar", "RadarTarget", "RangeFinder", "Receiver", "Robot"),
    *("Sensor", "Skin", "Speaker", "Supervisor", "TouchSensor", "VacuumGripper"),
)
SECOND_CLASSES = {
    "CameraRecognitionObject": "camera",
    "ImageRef": "display",
    "MouseState": "mouse",
    "ContactPoint": "node",
}


def module_of(name: str) -> str:
    """Return ``distance_sensor`` for ``DistanceSensor``, as R2023a calls the module of a class."""
    return SECOND_CLASSES.get(name) or re.sub("(?<=[a-z])(?=[A-Z])", "_", name).lower()


HEAD = """
from controller import *
motor, other, gps, emitter, receiver, lidar = map(robot.getDevice, (
    "left wheel motor", "right wheel motor", "gps", "team emitter", "team receiver", "lidar"))
def caught(what):
    try:
        what()
    except Exception as error:
        print(type(error).__name__ + ":", error)
    else:
        print("accepted")
"""

TAKES_A_NUMBER = {
    "robot.step({})": "step takes a number of ms, such as 32",
    "gps.enable({})": "'gps': enable takes a number of ms, such as 32",
    "motor.setVelocity({})": "'left wheel motor': setVelocity takes a number of rad/s, such as 5.0",
    "motor.setPosition({})": "'left wheel motor': setPosition takes a number of rad, such as float('inf')",
    "motor.setAcceleration({})": "'left wheel motor': setAcceleration takes a number of rad/s²",
    "emitter.setChannel({})": "'team emitter': setChannel takes the number of a channel, such as 1",
    "receiver.setChannel({})": "'team receiver': setChannel takes the number of a channel, such as 1",
}
NUMBERS = "3", "3.5", "np.float64(3)", "np.float32(3)", "np.int64(3)", "np.array([3.0])[0]", "Fraction(7, 2)"
NO_NUMBERS = {"'32'": "str", "'fast'": "str", "[1, 2]": "list", "{}": "dict"}
NOT_MADE = "Striker.__init__ has to call super().__init__() first: until then it is no robot"
SECOND = "Error: only one Robot can be made: this second {} is the same robot."
SEND = "TypeError: 'team emitter': send takes bytes, a str or a list of numbers; {}. json.dumps makes a str of other data, struct.pack bytes."
DROPPED = "Warning: 'team emitter': the packet is dropped: {}"
NO_DEVICE = "AttributeError: this {} is not a device of the robot (see the warning above)"
NOT_ENABLED = "RuntimeError: 'ball receiver': {} was called but the receiver is not enabled: call enable(32) before the first step."
EMPTY = "RuntimeError: 'ball receiver': getData was called with an empty queue; ask getQueueLength() first."
NAN = "Error: 'right wheel motor': setVelocity(NaN) is refused."

CALLS: dict[str, tuple[str, list[str]]] = {
    **{
        f"{call} takes numbers and refuses everything else": (
            "import numpy as np\nfrom fractions import Fraction\n"
            + "".join(f"caught(lambda: {call.format(one)})\n" for one in (*NUMBERS, *NO_NUMBERS)),
            ["accepted"] * len(NUMBERS)
            + [f"TypeError: {wanted}; {one} ({kind}) was given" for one, kind in NO_NUMBERS.items()],
        )
        for call, wanted in TAKES_A_NUMBER.items()
    },
    "enable without a period": (
        "caught(gps.enable)",
        ["TypeError: 'gps': enable takes a number of ms, such as 32; None (NoneType) was given"],
    ),
    "a velocity that is refused changes nothing": (
        "motor.setVelocity(3); caught(lambda: motor.setVelocity('9' * 1000)); print(motor.getVelocity())",
        [f"TypeError: {TAKES_A_NUMBER['motor.setVelocity({})']}; '{'9' * 59} (str) was given", "3.0"],
    ),
    "every class of Webots can be named": (
        f"import controller\nfrom controller import {', '.join(CLASSES)}\n"
        + "".join(f"assert {name} is controller.{name}\n" for name in CLASSES)
        + "print(os.getcwd() in sys.path)\n",  # up to R2022b the star gave these two as well
        ["True"],
    ),
    "each class has a module of its own as in R2023a": (
        "import controller\n"
        + "".join(
            f"from controller.{module_of(name)} import {name}\nassert {name} is controller.{name}\n" for name in CLASSES
        ),
        [],
    ),
    "a name that Webots does not have": (
        """
import controller
try:
    from controller import Ball
except ImportError as error:
    print(error.name)
try:
    controller.Moter
except AttributeError as error:
    print(error, error.name, error.obj is controller)
print({"AnsiCodes", "Motor"} <= set(dir(controller)))
""",
        ["controller", "module 'controller' has no attribute 'Moter' Moter True", "True"],
    ),
    "devices that no robot has cannot be made": (
        "class Eye(Radar): pass\nfor kind in (Radar, Eye, Node): caught(lambda: kind('x'))",
        [f"NotImplementedError: there is no {kind} on these robots" for kind in ("Radar", "Radar", "Node")],
    ),
    "ANSI codes are texts": (
        """
print(AnsiCodes.RED_FOREGROUND + AnsiCodes.BOLD + "goal" + AnsiCodes.RESET)
print(repr(AnsiCodes.UNDERLINE + AnsiCodes.CLEAR_SCREEN + AnsiCodes.WHITE_BACKGROUND))
""",
        ["\x1b[31m\x1b[1mgoal\x1b[0m", r"'\x1b[4m\x1b[2J\x1b[47m'"],
    ),
    "constants of Node tell the kind of a device": (
        """
kinds = {number: kind for kind, number in vars(Node).items() if type(number) is int and kind[0] != "_"}
assert len(kinds) == sum(type(number) is int and kind[0] != "_" for kind, number in vars(Node).items())
print(*dict.fromkeys(kinds[device.node_type] for device in map(robot.getDeviceByIndex, range(robot.getNumberOfDevices()))))
print(robot.getType() == Node.ROBOT, robot.getDeviceByIndex(2).getTag(), motor.getTag() != other.getTag())
""",
        ["ROTATIONAL_MOTOR POSITION_SENSOR GPS COMPASS DISTANCE_SENSOR RECEIVER EMITTER LIDAR", "True 3 True"],
    ),
    "a supervisor is the same robot, and its further calls do nothing": (
        """
class Coach(Supervisor):
    def __init__(self):
        super().__init__()
        self.ball = self.getFromDef("BALL")
coach = Coach()
print(coach.ball, coach.getFromDef("Y1"), coach.simulationReset(), coach.setLabel(0, "x", size=1))
print(coach.getSupervisor(), coach.getName(), coach.getDevice("gps") is gps, Supervisor.SIMULATION_MODE_PAUSE)
try:
    coach.fly()
except AttributeError as error:
    print(error, error.name, error.obj is coach)
print(Robot.created is robot, Robot().getName())
""",
        [
            SECOND.format("Coach"),
            *(
                f"Warning: {call} is ignored and gives None: it is the referee's, this is a player's robot."
                for call in ("getFromDef", "simulationReset", "setLabel")
            ),
            "None None None None",
            "False Y1 True 0",
            "'Coach' object has no attribute 'fly' fly True",
            SECOND.format("Robot"),
            "True Y1",
        ],
    ),
    "a team's own class may use names that are attributes of a robot": (
        """
class Striker(Robot):
    def __init__(self, side, speed=3):
        super().__init__()
        self.name, self.side, self.speed = self.getName(), side, speed
        for name in ("time", "mode", "model", "supervisor", "synchronization", "custom_data", "basic_time_step",
                     "number_of_devices", "keyboard", "_connection", "_devices", "_by_index", "_told_of"):
            setattr(self, name, "mine")
            assert getattr(self, name) == "mine"
    def getMode(self):
        return "attack"
    def getBasicTimeStep(self):
        return "no number"
striker = Striker("left", speed=4)
began = striker.getTime()
striker.step()
print(striker.name, striker.side, striker.speed, round(striker.getTime() - began, 3), [striker.getModel()])
print(striker.getDevice("gps").getName(), striker.getLidar("lidar"))
""",
        [
            SECOND.format("Striker"),
            "Y1 left 4 0.032 ['']",
            "DEPRECATION: Robot.getLidar is deprecated, please use Robot.getDevice instead.",
            "gps <Lidar 'lidar'>",
        ],
    ),
    "a team's own class that forgets to make its robot": (
        """
class Striker(Robot):
    def __init__(self):
        for call in (self.step, self.getName, self.getTime, self.getNumberOfDevices, self.getBasicTimeStep,
                     lambda: self.getDevice("gps"), lambda: self.name, lambda: self.devices):
            caught(call)
Striker()
""",
        [f"RuntimeError: {NOT_MADE}"] * 8,
    ),
    "an attribute that a robot lacks": (
        "try:\n    robot.getdevice\nexcept AttributeError as error:\n    print(error, error.name, error.obj is robot)",
        ["'Robot' object has no attribute 'getdevice' getdevice True"],
    ),
    "devices take attributes of the team's own": (
        """
other.name = "left"; other.type = "wheel"; other.side = 1; receiver.data = "old"; receiver.bytes = 5
print(other.name, other.type, other.side, receiver.data, receiver.bytes, other.getName(), other.getType())
del other.name, receiver.data, receiver.bytes
""",
        ["left wheel 1 old 5 right wheel motor 0"],
    ),
    "keyboard, mouse and joystick are there and not used": (
        """
keyboard, mouse, joystick = Keyboard(), Mouse(), Joystick()
for device in (keyboard, mouse, joystick, robot.getKeyboard(), robot.getMouse(), robot.getJoystick()):
    device.enable(sampling_period=64)
print(keyboard.getSamplingPeriod(), robot.getKeyboard().getSamplingPeriod(), robot.keyboard is robot.getKeyboard())
print(keyboard.getKey(), robot.getKeyboard().getKey(), keyboard.key == ord("W"), mouse.getState().left)
print(joystick.isConnected(), joystick.getPressedButton(), joystick.getNumberOfAxes())
print([getattr(Keyboard, key) for key in ("END", "HOME", "LEFT", "UP", "RIGHT", "DOWN", "PAGEUP", "PAGEDOWN")])
print([getattr(Keyboard, key) for key in ("NUMPAD_HOME", "NUMPAD_DOWN", "NUMPAD_END", "KEY", "SHIFT", "CONTROL", "ALT")])
keyboard.disable(); print(keyboard.getSamplingPeriod())
""",
        [
            "64 64 True",
            "-1 -1 False False",
            "False -1 0",
            "[312, 313, 314, 315, 316, 317, 366, 367]",
            "[375, 379, 382, 65535, 65536, 131072, 262144]",
            "0",
        ],
    ),
    "a motor and the sensor of its wheel know each other": (
        (
            "sensor = robot.getDevice('left wheel sensor')\n"
            "print(motor.getPositionSensor() is sensor, sensor.getMotor() is motor, motor.getBrake(), sensor.getBrake())"
        ),
        ["True True None None"],
    ),
    "calls of Webots without effect here are accepted": (
        """
motor.setControlPID(10, 0, 0); motor.setAvailableForce(3); motor.setAvailableTorque(2)
print(motor.getMaxForce(), motor.getAvailableForce(), motor.getAvailableTorque())
robot.setCustomData("goalie"); robot.setMode(0, ""); robot.wwiSendText("hi")
print(robot.getCustomData(), robot.custom_data, robot.getMode(), [robot.wwiReceiveText(), robot.getWorldPath(), robot.getUrdf()])
print(os.path.samefile(robot.getProjectPath() + "/controllers/robot.py", "robot.py"))
print(GPS.convertToDegreesMinutesSeconds(12.51), gps.convertToDegreesMinutesSeconds(-0.5))
robot.batterySensorEnable(32); print(robot.batterySensorGetSamplingPeriod(), robot.batterySensorGetValue())
robot.batterySensorDisable(); print(robot.batterySensorGetSamplingPeriod())
print(robot.getDevice("distancesensor left").getLookupTable())
for period in (32, 0.032, float("inf")):
    motor.enableTorqueFeedback(period); print(motor.getTorqueFeedbackSamplingPeriod(), motor.getTorqueFeedback())
motor.disableTorqueFeedback(); print(motor.getTorqueFeedbackSamplingPeriod())
""",
        [
            "10.0 2.0 2.0",
            "goalie goalie 0 ['', '', '']",
            "True",
            "12° 30' 36\" 0° 30' 0\"",
            "32 nan",
            "0",
            "[0.0, 0.0, 0.0, 1.0, 1000.0, 0.0]",
            *("32 0.0", "1 0.0", "2147483647 0.0", "0"),
        ],
    ),
    "the lidar is read by all its methods": (
        """
import struct
caught(lambda: print(lidar.getPointCloud(data_type="buffer")))
lidar.enable(32); lidar.enablePointCloud(); lidar.setFrequency(20); robot.step(32)
print([round(reading, 2) for reading in lidar.getRangeImage()], len(lidar.getRangeImageArray()), lidar.getLayerRangeImage(0) == lidar.getRangeImage())
point = lidar.getPointCloud()[2]
print(round(point.x, 3), round(point.y, 3), point.z, point.layer_id, point.time == robot.getTime(), lidar.getNumberOfPoints(), lidar.getHorizontalResolution())
print(lidar.getFov() > 6.28, lidar.getMinRange(), lidar.getMaxRange(), lidar.getNumberOfLayers(), lidar.getFrequency())
ranges, points = lidar.getRangeImage(data_type="buffer"), lidar.getPointCloud(data_type="buffer")
print(type(ranges), type(points), points == lidar.getLayerPointCloud(0, "buffer"))
print([round(one, 2) for one in struct.unpack("<8f", ranges)], len(list(struct.iter_unpack("<fffif", points))))
""",
        [
            "bytearray(b'')",
            "accepted",
            "[0.5, 0.6, 0.7, 0.8, 0.9, 1.0, 1.1, 1.2] 8 True",
            "0.0 -0.7 0.0 0 True 8 8",  # index 2 of 8 looks to the right
            "True 0.01 3.0 1 20.0",
            "<class 'bytearray'> <class 'bytearray'> True",
            "[0.5, 0.6, 0.7, 0.8, 0.9, 1.0, 1.1, 1.2] 8",
        ],
    ),
    "what cannot be sent": (
        (
            "for message in ({'x': 1}, 5, None, [1, 'a'], {1, 2}): caught(lambda: emitter.send(message))\n"
            "caught(lambda: emitter.send('a', 'b'))"
        ),
        [
            *(
                SEND.format(found)
                for found in (
                    "dict was given",
                    "int was given",
                    "NoneType was given",
                    "list was given, and not all in it are numbers",
                    "set was given",
                )
            ),
            (
                "TypeError: 'team emitter': send takes one message, and then how many of its bytes to send; 'b' (str) was given "
                "as this number."
            ),
        ],
    ),
    "empty packets, too large ones and too many are dropped, each reason with one warning": (
        """
print([emitter.send(message) for message in (b"", "", [], "a", bytes(1_024_001), bytes(1_024_000))])
robot.step(32)
print([emitter.send(bytes(1_024_000)) for _ in range(3)], emitter.send("a"))
robot.step(32)
print(sum(emitter.send("a") for _ in range(1002)))
robot.step(32)
""",
        [
            DROPPED.format("it is empty."),
            DROPPED.format("it has 1024001 bytes, and at most 1024000 are allowed."),
            "[0, 0, 0, 1, 0, 1]",
            DROPPED.format("too much is sent in one step."),
            "[1, 1, 0] 0",
            "1000",
        ],
    ),
    "channels of other teams, and channels that do not exist, are refused": (
        """
for device in (emitter, receiver):
    for channel in (-2, 2, 7):
        device.setChannel(channel); print(device.channel)
""",
        [
            line
            for device in ("team emitter", "team receiver")
            for line in (
                f"Error: '{device}': channel -2 does not exist (the lowest is -1); it stays on 3.",
                "3",
                f"Error: '{device}': channel 2 is not for this team; it stays on 3.",
                "3",
                "7",
            )
        ],
    ),
    "what goes wrong again and again is printed ten times and then now and then, each thing for itself": (
        (
            "for _ in range(100): other.setVelocity(float('nan'))\n"
            "for n in range(22): robot.getDevice(n % 2)\n"
        ),
        [
            *[NAN] * 10,
            "(printed 10 times; from now on only the 100th time, the 1000th and so on)",
            *(NAN, "(this is the 100th time)"),
            *[f'Warning: "{n % 2}" device not found. This robot has: {", ".join(INDEX)}.' for n in range(20)][
                :19
            ],
            "(printed 10 times; from now on only the 100th time, the 1000th and so on)",
            f'Warning: "1" device not found. This robot has: {", ".join(INDEX)}.',
            "(printed 10 times; from now on only the 100th time, the 1000th and so on)",
        ],
    ),
    "a device made by its class is the robot's device of that name": (
        """
mine = Motor("left wheel motor")
mine.setVelocity(4)
sonar, compass = DistanceSensor("distancesensor left", 32), Compass("compass", sampling_period=64)
print(mine.getName(), motor.getVelocity(), isinstance(mine, Motor), sonar.getSamplingPeriod(), compass.sampling_period)
""",
        ["left wheel motor 4.0 True 32 64"],
    ),
    "a device of a name or class that the robot lacks": (
        """
kicker, wrong = Motor("kicker"), GPS("left wheel motor")
print(isinstance(kicker, Motor))
for use in (lambda: kicker.setVelocity(3), lambda: kicker.setPosition(1), lambda: print(kicker), lambda: wrong.getValues(),
            lambda: wrong.getName(), lambda: GPS("gsp", 32)):
    caught(use)
try:
    kicker.getName()
except AttributeError as error:
    print(error.name)  # else Python suggests another
""",
        [
            f'Warning: "kicker" device not found. This robot has: {", ".join(INDEX)}.',
            'Warning: "left wheel motor" is a Motor, not a GPS.',
            "True",
            *[NO_DEVICE.format("Motor")] * 3,
            *[NO_DEVICE.format("GPS")] * 2,
            f'Warning: "gsp" device not found. This robot has: {", ".join(INDEX)}.',
            NO_DEVICE.format("GPS"),
            "None",
        ],
    ),
    "all devices are in one dict by name": (
        """
print(list(robot.devices)[:2], robot.devices["gps"] is gps)
robot.devices.clear(); print(len(robot.devices))
robot.devices = "mine"; print(robot.devices); del robot.devices
""",
        ["['left wheel motor', 'right wheel motor'] True", str(len(INDEX)), "mine"],
    ),
    "getters of earlier years work after a line of deprecation": (
        """
print(robot.getMotor("left wheel motor") is motor, robot.getMotor("right wheel motor") is other)
print(robot.getReceiver("team receiver") is receiver, robot.getAltimeter("gps"), robot.getServo("left wheel motor") is motor)
""",
        [
            "DEPRECATION: Robot.getMotor is deprecated, please use Robot.getDevice instead.",
            "True True",
            *(
                f"DEPRECATION: Robot.get{kind} is deprecated, please use Robot.getDevice instead."
                for kind in ("Receiver", "Altimeter")
            ),
            'Warning: "gps" is a GPS, not a Altimeter.',
            "DEPRECATION: Robot.getServo is deprecated, please use Robot.getDevice instead.",
            "True None True",
        ],
    ),
    "a receiver that was never enabled says so once when it is read, and by errors": (
        """
ball = robot.getDevice("ball receiver")
for _ in range(3):
    print(ball.getQueueLength(), ball.getSignalStrength(), ball.getDataSize())
    ball.nextPacket(); robot.step(32)
for call in (ball.getData, ball.getEmitterDirection):
    try:
        call()
    except RuntimeError as error:
        print("RuntimeError:", error)
""",
        [
            "Warning: 'ball receiver' is read but not enabled: call enable(32) before the first step.",
            *["0 nan -1"] * 3,
            *(
                line
                for call in ("getData", "getEmitterDirection")
                for line in (NOT_ENABLED.format(call).replace("RuntimeError", "Error"), NOT_ENABLED.format(call))
            ),
        ],
    ),
    "an empty queue is an error, and a property of no packet is not there": (
        """
import contextlib, inspect, io
ball = robot.getDevice("ball receiver")
names = "data", "bytes", "string", "floats", "ints", "bools", "emitter_direction"
with contextlib.redirect_stderr(io.StringIO()):
    ball.enable(32); caught(ball.getData)
    ball.disable(); caught(ball.getData)
    for name in names:
        try:
            getattr(ball, name)
        except RuntimeError as error:
            assert error.name is None, "or Python proposes the getter"
    print([getattr(ball, name, None) for name in names], hasattr(ball, "queue_length"), hasattr(type(ball), "data"))
    print("getData" in dict(inspect.getmembers(ball)))
""",
        [EMPTY, EMPTY, f"{[None] * 7} True True", "True"],
    ),
    "a copy of a device or robot is the thing itself": (
        """
import copy, dataclasses
@dataclasses.dataclass
class Wheels:
    left: object
kept = dataclasses.asdict(Wheels(motor))
print(copy.copy(motor) is motor, kept["left"] is motor, copy.deepcopy([robot])[0] is robot)
""",
        ["True True True"],
    ),
    "steps are given by the names of all years": (
        """
began = robot.getTime()
for step in (lambda: robot.step(time_step=32), lambda: robot.step(timeStep=64), lambda: robot.step(duration=32), robot.step):
    step(); print(round(robot.getTime() - began, 3))
""",
        ["0.032", "0.096", "0.128", "0.16"],
    ),
    "a step in two parts": (
        """
robot.stepBegin(32)
caught(lambda: robot.step(96)); caught(lambda: robot.stepBegin(32))
print(robot.stepEnd()); caught(robot.stepEnd)
""",
        [
            "RuntimeError: step was called between stepBegin and stepEnd",
            "RuntimeError: stepBegin was called again before stepEnd",
            "0",
            "RuntimeError: stepEnd was called without stepBegin before it",
        ],
    ),
}


@pytest.fixture(scope="module")
def said(tmp_path_factory: pytest.TempPathFactory) -> dict[str, list[str]]:
    calls = {name: HEAD + program for name, (program, _) in CALLS.items()}
    return said_by_each(tmp_path_factory.mktemp("calls"), calls, 100)


@pytest.mark.parametrize("call", CALLS)
def test_calls_of_webots_are_answered(said: dict[str, list[str]], call: str) -> None:
    assert said[call] == CALLS[call][1]
