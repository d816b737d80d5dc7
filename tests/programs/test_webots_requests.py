"""What devices ask of the match, and what they show of it, when programs use them as in Webots."""

from __future__ import annotations

import math
import struct
import sys
import time
from dataclasses import replace
from pathlib import Path

import fake_match
import pytest
from fake_match import INDEX, FakeMatch, Played, packet, robot_spec, values_at

LEFT = INDEX["left wheel motor"]
INFINITE = math.inf

_HEAD = """
from controller import *
robot = Robot()
motor, gps, emitter, receiver = map(robot.getDevice, ("left wheel motor", "gps", "team emitter", "team receiver"))
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


def _speeds(played: Played) -> list[tuple[int, float]]:
    """At which tick the left motor was commanded which velocity."""
    reported = [
        (tick, m.velocity_radps) for tick, request in played.requests for m in request.motors if m.device == LEFT
    ]
    return [(tick, round(speed, 9)) for tick, speed in reported]


def _sampled(played: Played) -> list[tuple[int, int]]:
    return [setting for _, request in played.requests for setting in request.sampling]


@pytest.mark.parametrize(
    ("lines", "speeds"),
    {
        "reached step by step without further calls": (
            "motor.setVelocity(0); motor.setAcceleration(100); robot.step(32); motor.setVelocity(10)",
            # 100 rad/s² are 3.2 rad/s in a tick of 32 ms.
            [(0, 0.0), (1, 3.2), (2, 6.4), (3, 9.6), (4, 10.0)],
        ),
        "braking and reversing": (
            "motor.setVelocity(5); robot.step(32); motor.setAcceleration(100); motor.setVelocity(-2)",
            [(0, 5.0), (1, 1.8), (2, -1.4), (3, -2.0)],
        ),
        "-1 lets it be reached at once": (
            "motor.setAcceleration(100); robot.step(32); motor.setAcceleration(-1); robot.step(32); motor.setVelocity(-10)",
            [(0, 3.2), (1, 10.0), (2, -10.0)],
        ),
        "NaN is refused": ("motor.setVelocity(4); motor.setAcceleration(float('nan'))", [(0, 4.0)]),
    }.values(),
)
def test_an_acceleration_limits_the_change_of_speed(
    match: FakeMatch, lines: str, speeds: list[tuple[int, float]]
) -> None:
    played = _play(match, f"motor.setPosition(float('inf')); {lines}\nprint(motor.getVelocity())", 7)
    assert _speeds(played) == speeds
    assert float(played.said[-1]) == speeds[-1][1], "getVelocity returns what was set"


def test_a_motor_that_held_an_angle_speeds_up_from_rest(match: FakeMatch) -> None:
    played = _play(
        match,
        "motor.setAcceleration(100); motor.setPosition(float('inf')); motor.setVelocity(9); robot.step(32)\n"
        "motor.setPosition(1.5); robot.step(32)\n"
        "motor.setPosition(float('inf'))\n",
        6,
    )
    assert [(round(speed, 9), place) for _, speed, place in played.motors()] == [
        (3.2, INFINITE), (9.0, 1.5), (3.2, INFINITE), (6.4, INFINITE), (9.0, INFINITE),
    ]  # fmt: skip


def test_a_speed_beyond_the_maximum_is_clamped_with_one_warning_and_nan_refused(match: FakeMatch) -> None:
    played = _play(
        match,
        "motor.setPosition(float('inf'))\n"
        "for velocity in (4.0, -10.000000000000002, 10.0000001, -15, float('nan')): motor.setVelocity(velocity); robot.step(32)\n"
        "motor.setPosition(float('nan')); print(motor.getVelocity(), motor.getMaxVelocity(), motor.getTargetPosition())\n",
        6,
    )
    assert [speed for _, speed, _ in played.motors()] == [4.0, -10.0, 10.0, -10.0]
    assert played.said == [
        # Not for what rounding leads beyond it, of which the text could not be understood.
        "Warning: 'left wheel motor': the velocity 10.0000001 is beyond the maximum of 10 rad/s, which is taken instead.",
        "Error: 'left wheel motor': setVelocity(NaN) is refused.",
        "Error: 'left wheel motor': setPosition(NaN) is refused.",
        "-10.0 10.0 inf",
    ]


def test_lists_arrays_and_views_of_bytes_are_sent_and_cut_to_a_size(match: FakeMatch) -> None:
    program = """
import array
import numpy as np
for message in ([0.5, 2], (1,), np.array([1.5, 2.5]), array.array("d", [3]), memoryview(b"view"), "Gruß", range(2)):
    emitter.send(message)
emitter.send(b"abcdef", 3)
"""
    packed = [struct.pack(f"{len(some)}d", *some) for some in ([0.5, 2], [1], [1.5, 2.5], [3])]
    assert _play(match, program).sent() == [*packed, b"view", "Gruß".encode(), struct.pack("2d", 0, 1), b"abc"]


def test_where_only_small_packets_are_allowed_a_step_may_still_send_many(tmp_path: Path) -> None:
    match = FakeMatch(tmp_path, message_kb=0.008)
    played = _play(match, "print({emitter.send(bytes([1] * 8)) for _ in range(100)}, emitter.send(bytes(9)))\n")
    assert played.said[1:] == ["{1} 0"]
    assert played.sent() == [bytes([1] * 8)] * 100


def test_each_packet_is_sent_on_the_channel_that_was_set_before_it(match: FakeMatch) -> None:
    played = _play(
        match,
        "for channel in (12, 13, 3): emitter.setChannel(channel); emitter.send(str(channel))\n"
        "emitter.channel = 14; robot.step(32); emitter.send('14')\n"
        "robot.stepBegin(32); emitter.setChannel(15); emitter.send('15'); robot.stepEnd()\n",
        6,
    )
    sent = [(channel, int(data)) for _, request in played.requests for _, channel, data in request.emissions]
    assert sent == [(channel, channel) for channel in (12, 13, 3, 14, 15)]


def test_a_robot_without_a_lidar_does_not_read_what_is_known_of_lidars(match: FakeMatch) -> None:
    spec = robot_spec()
    others = (one if one.kind != "lidar" else replace(one, kind="gps") for one in spec.devices)
    program = """
import sys
from controller import Robot, Motor
robot = Robot()
print(sorted(name for name in sys.modules if name.startswith("controller.") and "._" not in name))
from controller import Lidar, LidarPoint
print(Lidar.__name__)
robot.step(32)
robot.step(32)
"""
    said = match.play(program, 1, spec=replace(spec, devices=tuple(others))).said
    read = ["device", "motor", "radio", "robot", "sensors"]
    assert said == [str([f"controller.{name}" for name in read]), "Lidar"]


def test_an_enabled_sensor_is_sampled_in_the_period_asked_for(match: FakeMatch) -> None:
    played = _play(
        match,
        "DistanceSensor('distancesensor left', 32); Compass('compass', sampling_period=64); Receiver('team receiver', 32)\n"
        "gps.enable(samplingPeriod=1e12); robot.getDevice('left wheel sensor').sampling_period = 96\n",
    )
    assert _sampled(played) == [
        (INDEX["distancesensor left"], 1),
        (INDEX["compass"], 2),
        (INDEX["team receiver"], 1),
        (INDEX["gps"], 2**31 - 1),
        (INDEX["left wheel sensor"], 3),
    ]


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
print(ears.getString(), receiver.getQueueLength(), motor.velocity)
print(wheel.getPositionSensor() is robot.getDevice("left wheel sensor"))
"""
    played = _play(match, program, air=lambda _: [packet("team receiver", b"hi")])
    assert played.said == ["left 2 4.0 mine mine left wheel motor Wheel", "*hi 1 4.0", "True"]
    assert played.motors()[-1][:2] == (LEFT, 4.0)


def test_devices_are_made_after_the_robot(match: FakeMatch) -> None:
    played = match.play(
        "from controller import Robot, Motor\ntry:\n    Motor('left wheel motor')\n"
        "except RuntimeError as error:\n    print(error)\nrobot = Robot()\nrobot.step(32)\nrobot.step(32)\n",
        1,
    )
    assert played.said == ["Motor('left wheel motor'): make the robot first: robot = Robot()"]


def test_packets_of_numbers_are_read_as_floats_ints_and_bools_and_stay_when_a_receiver_is_disabled(
    match: FakeMatch,
) -> None:
    played = _play(
        match,
        "receiver.enable(32); robot.step(32); receiver.disable()\n"
        "print(receiver.getFloats(), receiver.floats, receiver.getInts(), receiver.ints, receiver.bools == receiver.getBools())\n"
        "receiver.nextPacket(); print(receiver.getBools(), receiver.getData())\n"
        "caught(receiver.getFloats); caught(receiver.getInts)\n",
        air=lambda tick: [packet("team receiver", bytes(8)), packet("team receiver", b"\0\1\0")] if tick == 1 else [],
    )
    head, tail = "error: 'team receiver': ", "this packet has 3 bytes. struct.unpack reads others."
    assert played.said == [
        "[0.0] [0.0] [0, 0] [0, 0] True",
        r"[False, True, False] b'\x00\x01\x00'",
        f"{head}getFloats reads packets of doubles, 8 bytes each; {tail}",
        f"{head}getInts reads packets of ints, 4 bytes each; {tail}",
    ]


def test_cells_of_a_lidar_are_0_until_they_are_measured_also_before_the_first_step(match: FakeMatch) -> None:
    lines = (
        'lidar = robot.getDevice("lidar"); lidar.enable(32); lidar.setFrequency(20)\nprint(set(lidar.getRangeImage()))'
    )
    played = _play(match, lines)
    assert played.said == ["{0.0}"]
    assert played.requests[0][1].frequencies == ((INDEX["lidar"], 20.0),)


def test_what_is_set_between_the_begin_and_the_end_of_a_step_acts_in_the_next_one(match: FakeMatch) -> None:
    played = _play(
        match,
        "motor.setPosition(float('inf'))\n"
        "for speed in (1, 2, 3):\n"
        "    motor.setVelocity(speed); robot.stepBegin(32)\n"
        "    if speed == 2: motor.setVelocity(5); emitter.send('late')\n"
        "    print(robot.stepEnd(), robot.getTime())\n"
        "    if speed == 2: robot.step(64)\n",
        10,
    )
    assert played.said == ["0 0.032", "0 0.064", "0 0.16"]
    reported = [
        (tick, [m.velocity_radps for m in r.motors], [d for _, _, d in r.emissions]) for tick, r in played.requests
    ]
    assert reported[:4] == [(0, [1.0], []), (1, [2.0], []), (2, [5.0], [b"late"]), (4, [3.0], [])]


def test_what_passes_between_the_begin_and_the_end_of_a_step_is_missed(match: FakeMatch) -> None:
    played = _play(match, "import time\nrobot.stepBegin(32)\ntime.sleep(0.1)\nrobot.stepEnd()\n", 7)
    assert [r.missed_ticks for _, r in played.requests][:2] == [3, 0]


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
        "print(signal.signal(signal.SIGALRM, alarm) is signal.SIG_DFL, signal.getsignal(signal.SIGALRM) is alarm)\n"
        "broken = 0\n"
        "for _ in range(20):\n"
        "    try:\n"
        "        signal.setitimer(signal.ITIMER_REAL, 0.001)\n"
        "        robot.step(32)\n"
        "        signal.setitimer(signal.ITIMER_REAL, 0)\n"
        f"    except {error}: broken += 1\n"
        "print(broken > 0)\n"
    )
    played = _play(match, lines, 25, air=lambda _: time.sleep(0.003) or [])
    assert played.said == ["True True", "True"]
    assert [tick for tick, _ in played.requests] == list(range(25))  # no step is lost


class TestTheSpeedOfAGps:
    """It is that between two samples. The robot drives 1 m in a tick."""

    @pytest.fixture
    def shows(self, monkeypatch: pytest.MonkeyPatch):
        """Sets the tick of the sample that is shown at each tick; None: none."""
        nothing = [math.nan] * len(values_at(0))

        def set_to(sample_at) -> None:
            shown = lambda tick: nothing if (at := sample_at(tick)) is None else values_at(at)  # noqa: E731
            monkeypatch.setattr(fake_match, "values_at", shown)

        return set_to

    @pytest.mark.parametrize(("period", "step"), [(1, 1), (1, 3), (2, 1), (2, 3), (3, 1), (3, 5), (4, 2), (4, 4)])
    def test_is_right_however_long_period_and_step_are(self, match: FakeMatch, shows, period: int, step: int) -> None:
        """It begins to measure at tick 3, after the program has slept for 2."""
        shows(lambda tick: 3 + (tick - 3) // period * period if tick >= 3 + period else None)
        lines = f"import time\nrobot.step(32)\ngps.enable({32 * period - 0.5}); time.sleep(0.07)\n"
        lines += f"for _ in range(12): robot.step({32 * step}); print(round(gps.getSpeed() * 0.032, 9))\n"
        said = _play(match, lines, 70).said
        assert set(said) <= {"nan", "1.0"}
        assert said[8:] == ["1.0"] * 4

    def test_stays_right_when_the_period_changes(self, match: FakeMatch, shows) -> None:
        """Three ticks, then one, then five, then none, then two."""
        sampled = {**{tick: tick // 3 * 3 for tick in range(20)}, 20: 18, **{tick: tick for tick in range(21, 31)}}
        sampled |= {tick: 30 + (tick - 30) // 5 * 5 for tick in range(31, 43)}
        shows((sampled | {tick: 44 + (tick - 44) // 2 * 2 for tick in range(46, 60)}).get)
        lines = """
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

    def test_is_right_when_a_program_sleeps_within_a_step(self, match: FakeMatch, shows) -> None:
        """The step takes up the new period after two missed ticks."""
        shows(lambda tick: 2 + (tick - 2) // 3 * 3)
        lines = "import time\ngps.enable(96)\nrobot.stepBegin(32)\ntime.sleep(0.07)\nrobot.stepEnd()\n"
        lines += "for _ in range(16): robot.step(32); print(round(gps.getSpeed() * 0.032, 9))\n"
        assert _play(match, lines, 22).said[6:] == ["1.0"] * 10
