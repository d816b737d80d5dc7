"""What a program is told that calls the module ``controller`` in a way that cannot work."""

from __future__ import annotations

from pathlib import Path

import pytest
from fake_match import FakeMatch, Played

_HEAD = """
from controller import Robot
robot = Robot()
motor, gps, emitter = map(robot.getDevice, ("left wheel motor", "gps", "team emitter"))
receiver = robot.getDevice("team receiver")
def caught(what):
    try:
        what()
    except Exception as error:
        print(type(error).__name__ + ":", error)
    else:
        print("accepted")
"""


def _play(match: FakeMatch, lines: str) -> Played:
    played = match.play(_HEAD + lines + "\nwhile robot.step(32) != -1: pass\n", 20)
    assert played.fault is None, played.log
    return played


@pytest.mark.parametrize(
    ("call", "wanted"),
    [
        ("robot.step({})", "step takes a number of ms, such as 32"),
        ("gps.enable({})", "'gps': enable takes a number of ms, such as 32"),
        ("motor.setVelocity({})", "'left wheel motor': setVelocity takes a number of rad/s, such as 5.0"),
        ("motor.setPosition({})", "'left wheel motor': setPosition takes a number of rad, such as float('inf')"),
        ("motor.setAcceleration({})", "'left wheel motor': setAcceleration takes a number of rad/s²"),
        ("emitter.setChannel({})", "'team emitter': setChannel takes the number of a channel, such as 1"),
        ("receiver.setChannel({})", "'team receiver': setChannel takes the number of a channel, such as 1"),
    ],
)
def test_what_is_no_number_is_named_with_the_call_and_what_it_takes(match: FakeMatch, call: str, wanted: str) -> None:
    given = ("'32'", "'fast'", "[1, 2]", "{}")
    played = _play(match, "".join(f"caught(lambda: {call.format(one)})\n" for one in given))
    kinds = ("str", "str", "list", "dict")
    assert played.said == [
        f"TypeError: {wanted}; {one} ({kind}) was given" for one, kind in zip(given, kinds, strict=True)
    ]


@pytest.mark.parametrize("call", ["robot.step({})", "gps.enable({})", "motor.setVelocity({})", "motor.setPosition({})"])
def test_numbers_of_every_kind_are_taken(match: FakeMatch, call: str) -> None:
    given = (
        "3",
        "3.5",
        "True",
        "np.float64(3)",
        "np.float32(3)",
        "np.int64(3)",
        "np.array([3.0])[0]",
        "Fraction(7, 2)",
    )
    lines = "import numpy as np\nfrom fractions import Fraction\n"
    played = _play(match, lines + "".join(f"caught(lambda: {call.format(one)})\n" for one in given))
    assert played.said == ["accepted"] * len(given)


def test_enable_without_a_period_says_what_it_takes(match: FakeMatch) -> None:
    played = _play(match, "caught(gps.enable)\n")
    assert played.said == ["TypeError: 'gps': enable takes a number of ms, such as 32; None (NoneType) was given"]


def test_a_long_thing_is_not_shown_as_a_whole(match: FakeMatch) -> None:
    played = _play(match, "caught(lambda: motor.setVelocity('x' * 1000))\n")
    assert len(played.said[0]) < 200


def test_a_velocity_that_was_refused_changes_nothing(match: FakeMatch) -> None:
    played = _play(match, "motor.setVelocity(3); caught(lambda: motor.setVelocity('9')); print(motor.getVelocity())\n")
    assert played.said[-1] == "3.0"
    assert [speed for _, speed, _ in played.motors()] == [3.0]


def test_a_class_of_the_teams_own_that_forgets_to_make_its_robot_is_told_so(match: FakeMatch) -> None:
    program = """
from controller import Robot
class Striker(Robot):
    def __init__(self):
        for call in (self.step, self.getName, self.getTime, self.getNumberOfDevices, self.getBasicTimeStep,
                     lambda: self.getDevice("gps"), lambda: self.getMotor("x"), lambda: self.name, lambda: self.devices):
            try:
                call()
            except RuntimeError as error:
                print(error)
        super().__init__()
        print(self.getName())
striker = Striker()
striker.step(32)
striker.step(32)
"""
    said = match.play(program, 1).said
    told = "Striker.__init__ has to call super().__init__() first: until then it is no robot"
    assert [line for line in said if not line.startswith("DEPRECATION")] == [told] * 9 + ["Y1"]


def test_a_robot_of_a_class_with_arguments_is_made(match: FakeMatch) -> None:
    program = """
from controller import Robot
class Striker(Robot):
    def __init__(self, side, speed=3):
        super().__init__()
        self.side, self.speed = side, speed
striker = Striker("left", speed=4)
print(striker.side, striker.speed, striker.getName())
striker.step(32)
striker.step(32)
"""
    assert match.play(program, 1).said == ["left 4 Y1"]


def test_an_attribute_that_a_robot_lacks_is_named_so_that_python_can_propose_another(match: FakeMatch) -> None:
    played = _play(
        match,
        "try:\n    robot.getdevice\nexcept AttributeError as error:\n    print(error, error.name, error.obj is robot)\n",
    )
    assert played.said == ["'Robot' object has no attribute 'getdevice' getdevice True"]


def test_a_second_argument_of_send_that_is_no_size_is_told(match: FakeMatch) -> None:
    played = _play(match, "caught(lambda: emitter.send('a', 'b'))\n")
    told = "'team emitter': send takes one message, and then how many of its bytes to send"
    assert played.said == [f"TypeError: {told}; 'b' (str) was given as this number."]
    assert played.sent() == []


def test_each_packet_is_sent_on_the_channel_that_was_set_before_it(match: FakeMatch) -> None:
    played = _play(
        match,
        "for channel in (12, 13, 3):\n    emitter.setChannel(channel)\n    emitter.send(str(channel))\n"
        "emitter.channel = 14\nrobot.step(32)\nemitter.send('later'); print(emitter.getChannel())\n",
    )
    sent = [(channel, data) for _, request in played.requests for _, channel, data in request.emissions]
    assert sent == [(12, b"12"), (13, b"13"), (3, b"3"), (14, b"later")]
    assert played.said == ["14"]


def test_a_packet_that_is_sent_after_a_step_has_begun_keeps_its_channel(match: FakeMatch) -> None:
    played = _play(
        match,
        "robot.stepBegin(32); emitter.setChannel(12); emitter.send('12'); robot.stepEnd()\n"
        "emitter.setChannel(13); emitter.send('13')\n",
    )
    sent = [(channel, data) for _, request in played.requests for _, channel, data in request.emissions]
    assert sent == [(12, b"12"), (13, b"13")]


@pytest.mark.parametrize("device", ["emitter", "receiver"])
def test_a_channel_below_minus_1_is_refused(match: FakeMatch, device: str) -> None:
    played = _play(match, f"{device}.setChannel(-2); print({device}.getChannel())\n")
    told = f"Error: 'team {device}': channel -2 is none: it is -1 or more; it stays on 3."
    assert played.said == [told, "3"]


@pytest.mark.parametrize("message", ["b''", "''", "[]"])
def test_an_empty_packet_is_not_sent_and_the_program_is_told(match: FakeMatch, message: str) -> None:
    played = _play(match, f"print(emitter.send({message}), emitter.send({message}), emitter.send('a'))\n")
    assert played.said == ["Warning: 'team emitter': the packet is dropped: it is empty.", "0 0 1"]
    assert played.sent() == [b"a"]


def test_a_packet_that_is_too_large_is_told_with_its_size_and_the_limit(match: FakeMatch) -> None:
    played = _play(match, "print(emitter.send(bytes(1_024_001)), emitter.send(bytes(1_024_000)))\n")
    told = "Warning: 'team emitter': the packet is dropped: it has 1024001 bytes, and at most 1024000 are allowed."
    assert played.said == [told, "0 1"]


def test_too_many_packets_in_a_step_are_told_too_after_one_that_was_too_large(match: FakeMatch) -> None:
    played = _play(match, "emitter.send(bytes(1_024_001))\nfor _ in range(1002): emitter.send('a')\n")
    assert played.said[1:] == ["Warning: 'team emitter': the packet is dropped: too much is sent in one step."]
    assert len(played.sent()) == 1000


def test_where_only_small_packets_are_allowed_a_step_may_still_send_many(tmp_path: Path) -> None:
    match = FakeMatch(tmp_path, message_kb=0.008)
    played = _play(match, "print({emitter.send(bytes([1] * 8)) for _ in range(100)}, emitter.send(bytes(9)))\n")
    told = "Warning: 'team emitter': the packet is dropped: it has 9 bytes, and at most 8 are allowed."
    assert played.said == [told, "{1} 0"]
    assert played.sent() == [bytes([1] * 8)] * 100


def test_a_step_may_send_two_packets_of_the_largest_size_and_no_more(match: FakeMatch) -> None:
    played = _play(match, "print([emitter.send(bytes(1_024_000)) for _ in range(3)], emitter.send('a'))\n")
    told = "Warning: 'team emitter': the packet is dropped: too much is sent in one step."
    assert played.said == [told, "[1, 1, 0] 0"]


def test_what_goes_wrong_in_every_step_is_told_ten_times_and_then_now_and_then(match: FakeMatch) -> None:
    refused = "Error: 'left wheel motor': setVelocity(NaN) is refused."
    played = match.play(_HEAD + "while robot.step(32) != -1: motor.setVelocity(float('nan'))\nprint('end')\n", 250)
    often = "(told 10 times; from now on only the 100th time, the 1000th and so on)"
    assert played.said == [*[refused] * 10, often, refused, "(this is the 100th time)", "end"]


def test_each_thing_that_goes_wrong_is_counted_for_itself(match: FakeMatch) -> None:
    lines = "for n in range(20): robot.getDevice(f'camera {n % 2}')\n"
    played = _play(match, lines)
    assert sum("device not found" in line for line in played.said) == 20
    assert [line for line in played.said if line.startswith("(")] == [played.said[-1]] * 2
