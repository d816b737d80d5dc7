"""Devices as programs get, make and read them."""

from __future__ import annotations

import math
import sys
import time

import fake_match
import pytest
from fake_match import INDEX, FakeMatch, Played, fault_of, packet, values_at

LEFT = INDEX["left wheel motor"]

_HEAD = """
from controller import *
robot = Robot()
def caught(what):
    try:
        return what()
    except Exception as error:
        print(type(error).__name__ + ":", error)
"""


def _play(match: FakeMatch, lines: str, ticks: int = 2, **given: object) -> Played:
    played = match.play(_HEAD + lines + "\nwhile robot.step(32) != -1: pass\n", ticks, **given)  # type: ignore[arg-type]
    assert played.fault is None, played.log
    return played


def _sampled(played: Played) -> list[tuple[int, int]]:
    return [setting for _, request in played.requests for setting in request.sampling]


def test_a_device_made_by_its_class_is_the_robots_device_of_that_name(match: FakeMatch) -> None:
    played = _play(
        match,
        "motor, gps = Motor('left wheel motor'), GPS('gps')\n"
        "motor.setPosition(float('inf')); motor.setVelocity(3)\n"
        "gps.enable(32); robot.step(32)\n"
        "there = robot.getDevice('left wheel motor')\n"
        "print(motor.getName(), there.getVelocity(), gps.getValues(), robot.getDevice('gps').getSamplingPeriod())\n"
        "there.setVelocity(4); print(motor.getVelocity(), isinstance(motor, Motor))\n",
    )
    assert played.said == ["left wheel motor 3.0 [1.0, 0.5, 0.0375] 32", "4.0 True"]
    assert [(device, speed) for device, speed, _ in played.motors()] == [(LEFT, 3.0), (LEFT, 4.0)]


def test_a_second_argument_enables_a_sensor(match: FakeMatch) -> None:
    played = _play(
        match,
        "sonar = DistanceSensor('distancesensor left', 32)\n"
        "compass = Compass('compass', sampling_period=64)\n"
        "receiver = Receiver('team receiver', 32)\n"
        "lidar = Lidar('lidar')\n"
        "print(sonar.getSamplingPeriod(), compass.sampling_period, lidar.getSamplingPeriod())\n"
        "robot.step(32); print(sonar.getValue(), receiver.getQueueLength())\n",
        air=lambda _: [packet("team receiver", b"x")],
    )
    assert played.said == ["32 64 0", "1000.0 1"]
    assert _sampled(played) == [(INDEX["distancesensor left"], 1), (INDEX["compass"], 2), (INDEX["team receiver"], 1)]


def test_a_class_of_the_teams_own_may_be_a_device_with_attributes_and_methods_of_its_own(match: FakeMatch) -> None:
    program = """
class Wheel(Motor):
    def __init__(self, side):
        self.side = side
        super().__init__(side + " wheel motor")
        self.setPosition(float("inf"))
        self._velocity = self._position = self._connection = self._index = self.speed = "mine"
    def setVelocity(self, velocity):
        self.asked = velocity
        super().setVelocity(2 * velocity)
    def _command(self):
        return "mine"
class Ears(Receiver):
    def __init__(self):
        super().__init__("team receiver", 32)
    def getString(self):
        return "*" + self.getData().decode()
wheel, ears = Wheel("left"), Ears()
wheel.setVelocity(2)
robot.step(32)
print(wheel.side, wheel.asked, wheel.getVelocity(), wheel._velocity, wheel._command(), wheel.getName(), type(wheel).__name__)
print(ears.getString(), robot.getDevice("team receiver").getQueueLength(), robot.getDevice("left wheel motor").velocity)
print(wheel.getPositionSensor() is robot.getDevice("left wheel sensor"))
"""
    played = _play(match, program, air=lambda _: [packet("team receiver", b"hi")])
    assert played.said == ["left 2 4.0 mine mine left wheel motor Wheel", "*hi 1 4.0", "True"]
    assert played.motors()[-1][:2] == (LEFT, 4.0)


def test_a_name_that_the_robot_lacks_is_told_as_by_get_device_and_using_it_is_an_error(match: FakeMatch) -> None:
    played = _play(
        match,
        "motor, gps = Motor('kicker'), GPS('left wheel motor')\n"
        "print(isinstance(motor, Motor))\n"
        "caught(lambda: motor.setVelocity(3)); caught(lambda: gps.getValues()); caught(lambda: gps.getName())\n"
        "caught(lambda: GPS('gsp', 32))\n",
    )
    assert played.said[0].startswith('Warning: "kicker" device not found. This robot has: left wheel motor, ')
    assert played.said[1:3] == ['Warning: "left wheel motor" is a Motor, not a GPS.', "True"]
    raised = "AttributeError: this {} is no device of the robot, as the warning above says"
    assert played.said[3:6] == [raised.format("Motor"), *[raised.format("GPS")] * 2]
    assert played.said[6].startswith('Warning: "gsp" device not found.')
    assert played.said[7] == raised.format("GPS")


def test_devices_are_made_after_the_robot(match: FakeMatch) -> None:
    played = match.play(
        "from controller import Robot, Motor\ntry:\n    Motor('left wheel motor')\n"
        "except RuntimeError as error:\n    print(error)\nrobot = Robot()\nrobot.step(32)\nrobot.step(32)\n",
        1,
    )
    assert played.said == ["Motor('left wheel motor'): make the robot first: robot = Robot()"]


def test_all_devices_stand_in_one_dict_by_name(match: FakeMatch) -> None:
    played = _play(
        match,
        "print(list(robot.devices)[:2], robot.devices['gps'] is robot.getDevice('gps'))\n"
        "robot.devices.clear(); print(len(robot.devices))\n"
        "robot.devices = 'mine'; print(robot.devices)\n",
    )
    assert played.said == ["['left wheel motor', 'right wheel motor'] True", str(len(INDEX)), "mine"]


def test_a_receiver_that_was_never_enabled_says_so_once_when_it_is_read(match: FakeMatch) -> None:
    played = _play(
        match,
        "receiver, other = robot.getDevice('team receiver'), robot.getDevice('ball receiver')\n"
        "for tick in range(3):\n"
        "    print(receiver.getQueueLength(), receiver.getSignalStrength(), receiver.getDataSize())\n"
        "    receiver.nextPacket(); robot.step(32)\n"
        "other.nextPacket()\n",
        5,
    )
    told = "Warning: {!r} is read but not enabled: call enable(32) before the first step."
    assert played.said == [told.format("team receiver"), *["0 nan -1"] * 3, told.format("ball receiver")]


def test_reading_a_packet_of_a_receiver_that_was_never_enabled_tells_that_enable_is_missing(match: FakeMatch) -> None:
    played = _play(
        match,
        "receiver = robot.getDevice('team receiver')\n"
        "caught(receiver.getData); caught(receiver.getEmitterDirection)\n"
        "receiver.enable(32)\n"
        "caught(receiver.getData)\n"
        "receiver.disable()\n"
        "caught(receiver.getData)\n",
    )
    raised = [line for line in played.said if line.startswith("RuntimeError")]
    missing = "but the receiver is not enabled: call enable(32) before the first step."
    empty = "RuntimeError: 'team receiver': getData was called with an empty queue; ask getQueueLength() first."
    assert raised == [
        f"RuntimeError: 'team receiver': getData was called {missing}",
        f"RuntimeError: 'team receiver': getEmitterDirection was called {missing}",
        empty,
        empty,
    ]


def test_packets_stay_when_a_receiver_is_disabled(match: FakeMatch) -> None:
    played = _play(
        match,
        "receiver = robot.getDevice('team receiver'); receiver.enable(32)\n"
        "robot.step(32); receiver.disable(); print(receiver.getQueueLength(), receiver.getData())\n",
        air=lambda tick: [packet("team receiver", b"x")] if tick == 1 else [],
    )
    assert played.said == ["1 b'x'"]


def test_packets_of_numbers_are_read_as_floats_ints_and_bools(match: FakeMatch) -> None:
    played = _play(
        match,
        "import struct\nreceiver = robot.getDevice('team receiver'); receiver.enable(32); robot.step(32)\n"
        "print(receiver.getFloats(), receiver.floats, receiver.getInts(), receiver.ints, receiver.bools == receiver.getBools())\n"
        "receiver.nextPacket()\nprint(receiver.getBools())\n",
        air=lambda tick: [packet("team receiver", bytes(8)), packet("team receiver", b"\0\1\0")] if tick == 1 else [],
    )
    assert played.said == ["[0.0] [0.0] [0, 0] [0, 0] True", "[False, True, False]"]


def test_a_packet_of_another_length_is_told_with_what_was_found_and_what_is_wanted(match: FakeMatch) -> None:
    played = _play(
        match,
        "receiver = robot.getDevice('team receiver'); receiver.enable(32); robot.step(32)\n"
        "caught(receiver.getFloats); caught(receiver.getInts)\n",
        air=lambda tick: [packet("team receiver", bytes(9))] if tick == 1 else [],
    )
    head, tail = "error: 'team receiver': ", "this packet has 9 bytes. struct.unpack reads others."
    assert played.said == [
        f"{head}getFloats reads packets of doubles, 8 bytes each; {tail}",
        f"{head}getInts reads packets of ints, 4 bytes each; {tail}",
    ]


def test_periods_and_steps_are_given_by_the_names_of_all_years(match: FakeMatch) -> None:
    played = _play(
        match,
        "gps, sonar = robot.getDevice('gps'), robot.getDevice('distancesensor left')\n"
        "gps.enable(sampling_period=32); sonar.enable(samplingPeriod=64); robot.getDevice('compass').sampling_period = 96\n"
        "keyboard = Keyboard(); keyboard.enable(sampling_period=64); print(keyboard.getSamplingPeriod())\n"
        "robot.step(time_step=32); print(robot.getTime())\n"
        "robot.step(timeStep=64); print(robot.getTime())\n"
        "robot.step(duration=32); print(robot.getTime())\n"
        "robot.step(); print(robot.getTime())\n",
        8,
    )
    assert played.said == ["64", "0.032", "0.096", "0.128", "0.16"]
    assert _sampled(played) == [(INDEX["gps"], 1), (INDEX["distancesensor left"], 2), (INDEX["compass"], 3)]


def test_what_is_set_between_the_begin_and_the_end_of_a_step_acts_in_the_next_one(match: FakeMatch) -> None:
    played = _play(
        match,
        "motor, emitter = robot.getDevice('left wheel motor'), robot.getDevice('team emitter')\n"
        "motor.setPosition(float('inf'))\n"
        "for speed in (1, 2, 3):\n"
        "    motor.setVelocity(speed)\n"
        "    robot.stepBegin(32)\n"
        "    if speed == 2: motor.setVelocity(5); emitter.send('late')\n"
        "    print(robot.stepEnd(), robot.getTime())\n"
        "    if speed == 2: robot.step(64)\n"
        "caught(robot.stepEnd)\n"
        "robot.stepBegin(); caught(lambda: robot.stepBegin(32)); robot.stepEnd()\n",
        10,
    )
    assert played.said == [
        "0 0.032",
        "0 0.064",
        "0 0.16",
        "RuntimeError: stepEnd was called without stepBegin before it",
        "RuntimeError: stepBegin was called again before stepEnd",
    ]
    told = [(tick, [m.velocity_radps for m in r.motors], [d for _, _, d in r.emissions]) for tick, r in played.requests]
    assert told[:4] == [(0, [1.0], []), (1, [2.0], []), (2, [5.0], [b"late"]), (4, [3.0], [])]


def test_what_passes_between_the_beginning_and_the_end_of_a_step_is_missed(match: FakeMatch) -> None:
    played = _play(match, "import time\nrobot.stepBegin(32)\ntime.sleep(0.1)\nrobot.stepEnd()\n", 7)
    assert [r.missed_ticks for _, r in played.requests][:2] == [3, 0]


def test_a_step_within_a_step_is_refused(match: FakeMatch) -> None:
    lines = "robot.stepBegin(32)\ncaught(lambda: robot.step(96))\nrobot.stepEnd()\n"
    assert _play(match, lines, 4).said == ["RuntimeError: step was called between stepBegin and stepEnd"]


def test_a_first_step_of_no_time_and_a_period_without_end_are_taken_as_a_tick_and_for_ever(match: FakeMatch) -> None:
    played = _play(match, 'robot.getDevice("gps").enable(float("inf"))\nrobot.step(-1)\n', 4)
    assert [r.advance_ticks for _, r in played.requests] == [1] * len(played.requests)


@pytest.mark.parametrize(
    "use",
    [
        "motor.getName()",
        "motor.setVelocity(3)",
        "motor.setPosition(float('inf'))",
        "print(motor)",
        "motor.velocity = 3",
    ],
)
def test_a_device_that_is_none_suggests_nothing(match: FakeMatch, use: str) -> None:
    fault = fault_of(match, _HEAD + f"motor = Motor('nope')\n{use}\n")
    assert fault.detail.startswith("AttributeError: this Motor is no device of the robot, as the warning above says (")


def test_a_copy_of_a_device_or_robot_is_the_thing_itself(match: FakeMatch) -> None:
    lines = (
        "import copy, dataclasses\n"
        "@dataclasses.dataclass\nclass Wheels:\n    left: object\n"
        'motor = robot.getDevice("left wheel motor")\n'
        "kept = dataclasses.asdict(Wheels(motor))\n"
        "print(copy.copy(motor) is motor, kept['left'] is motor, copy.deepcopy([robot])[0] is robot)\n"
    )
    assert _play(match, lines).said == ["True True True"]


@pytest.mark.skipif(sys.platform == "win32", reason="signals as POSIX has them")
def test_a_program_finds_its_own_handlers_of_signals(match: FakeMatch) -> None:
    lines = (
        "import signal\ndef alarm(*_): pass\n"
        "print(signal.signal(signal.SIGALRM, alarm) is signal.SIG_DFL, signal.getsignal(signal.SIGALRM) is alarm)\n"
        "print(signal.signal(signal.SIGALRM, signal.SIG_IGN) is alarm, signal.getsignal(signal.SIGALRM) is signal.SIG_IGN)\n"
    )
    assert _play(match, lines).said == ["True True", "True True"]


@pytest.mark.skipif(sys.platform == "win32", reason="signals as POSIX has them")
@pytest.mark.parametrize(
    ("handler", "error"),
    [("raise TimeoutError", "TimeoutError"), ("os.kill(os.getpid(), signal.SIGINT)", "KeyboardInterrupt")],
)
def test_a_step_that_a_signal_of_the_programs_own_breaks_off_is_taken_all_the_same(
    match: FakeMatch, handler: str, error: str
) -> None:
    lines = (
        f"import os, signal\ndef alarm(*_): {handler}\n"
        "signal.signal(signal.SIGALRM, alarm)\nbroken = 0\n"
        "for _ in range(20):\n"
        "    try:\n"
        "        signal.setitimer(signal.ITIMER_REAL, 0.001)\n"
        "        robot.step(32)\n"
        "        signal.setitimer(signal.ITIMER_REAL, 0)\n"
        f"    except {error}: broken += 1\n"
        "print(broken > 0)\n"
    )
    played = _play(match, lines, 25, air=lambda _: time.sleep(0.003) or [])
    assert played.said == ["True"]
    assert [tick for tick, _ in played.requests] == list(range(25))  # nobody has lost a step


@pytest.mark.parametrize("step", [1, 2, 3, 4, 5])
@pytest.mark.parametrize("period", [1, 2, 3, 4])
def test_the_speed_is_that_between_two_samples_however_long_period_and_step_are(
    match: FakeMatch, monkeypatch: pytest.MonkeyPatch, period: int, step: int
) -> None:
    """A robot that drives 1 m in a tick; it begins to measure at tick 3, after it has slept for 2."""
    nothing = [math.nan] * len(values_at(0))
    monkeypatch.setattr(
        fake_match,
        "values_at",
        lambda tick: values_at(3 + (tick - 3) // period * period) if tick >= 3 + period else nothing,
    )
    played = _play(
        match,
        "import time\ngps = robot.getDevice('gps')\nrobot.step(32)\n"
        f"gps.enable({32 * period}); time.sleep(0.07)\n"
        f"for _ in range(12): robot.step({32 * step}); print(round(gps.getSpeed() * 0.032, 9))\n",
        70,
    )
    assert set(played.said) <= {"nan", "1.0"}
    assert played.said[8:] == ["1.0"] * 4


def test_the_speed_is_right_for_a_period_that_is_no_whole_number_of_ms(
    match: FakeMatch, monkeypatch: pytest.MonkeyPatch
) -> None:
    """32.5 ms are two ticks."""
    monkeypatch.setattr(fake_match, "values_at", lambda tick: values_at(tick // 2 * 2))
    lines = "gps = robot.getDevice('gps')\ngps.enable(32.5)\n"
    lines += "for _ in range(8): robot.step(32); print(round(gps.getSpeed() * 0.032, 9))\n"
    assert _play(match, lines, 10).said[4:] == ["1.0"] * 4


def test_the_speed_stays_right_when_the_period_changes(match: FakeMatch, monkeypatch: pytest.MonkeyPatch) -> None:
    """Three ticks, then one, then five, then none, then two."""
    sampled = {**{tick: tick // 3 * 3 for tick in range(20)}, 20: 18, **{tick: tick for tick in range(21, 31)}}
    sampled |= {tick: 30 + (tick - 30) // 5 * 5 for tick in range(31, 43)}
    sampled |= {tick: 44 + (tick - 44) // 2 * 2 for tick in range(46, 60)}
    nothing = [math.nan] * len(values_at(0))
    monkeypatch.setattr(fake_match, "values_at", lambda tick: values_at(sampled[tick]) if tick in sampled else nothing)
    lines = """
gps = robot.getDevice("gps")
gps.enable(96)
tick = 0
while tick < 55:
    robot.step(32)
    tick += 1
    if tick in (20, 30, 42, 44):
        gps.enable({20: 32, 30: 160, 42: 0, 44: 64}[tick])
    if 6 <= tick < 42 or tick >= 48:
        print(round(gps.getSpeed() * 0.032, 9))
"""
    assert set(_play(match, lines, 57).said) == {"1.0"}


def test_the_speed_is_right_when_a_program_sleeps_within_a_step(
    match: FakeMatch, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The step takes up the new period after two missed ticks."""
    monkeypatch.setattr(fake_match, "values_at", lambda tick: values_at(2 + (tick - 2) // 3 * 3))
    lines = "import time\ngps = robot.getDevice('gps')\ngps.enable(96)\n"
    lines += "robot.stepBegin(32)\ntime.sleep(0.07)\nrobot.stepEnd()\n"
    lines += "for _ in range(16): robot.step(32); print(round(gps.getSpeed() * 0.032, 9))\n"
    assert _play(match, lines, 22).said[6:] == ["1.0"] * 10
