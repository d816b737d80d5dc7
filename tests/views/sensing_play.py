"""What made-up programs see, set and print, for tests of pages: devices, readings, lines of any kind, logos."""

import math
import struct
import zlib
from typing import Any

from rcj_challenges.core.traffic import DeviceSpec, MotorCommand, Observation, Packet
from rcj_challenges.devices.camera import RECOGNITION, SEEN
from rcj_challenges.records.sensors import SensedRobot, SensorWriter
from tests.hostile.archives.pictures import PNG, chunk

HOSTILE = "</script><script>document.title='stolen'</script><img src=x onerror=\"document.title='stolen'\">\n"
TURNED = "\u202eevil\u2066 \u200f\n"
ENDLESS = "x" * 10_000 + "\n"
DEVICES = (
    DeviceSpec("left wheel motor", "motor", 0, -1, 0),
    DeviceSpec("right wheel motor", "motor", 1, -1, 0),
    DeviceSpec("left wheel sensor", "position_sensor", 2, 0, 1),
    DeviceSpec("gps", "gps", 3, 1, 3),
    DeviceSpec("distancesensor left", "distance_sensor", 4, 4, 1, {"bearing_rad": math.pi / 2, "max_value": 1000.0}),
    DeviceSpec("compass", "compass", 5, 5, 3),
    DeviceSpec("ball receiver", "receiver", 6, -1, 0),
    DeviceSpec(
        "lidar", "lidar", 7, 8, 360,
        {"first_bearing_rad": 0.0, "bearing_step_rad": -math.pi / 180, "max_range": 3.0},
    ),
    DeviceSpec("eye", "camera", 8, -1, 0, {"width": 8, "height": 6}),
    DeviceSpec("light", "led", 9, -1, 0, {"unit": "", "max_velocity": 2.0, "colours": ["red", "lime"]}),
)  # fmt: skip
SENSED = [SensedRobot(name, DEVICES, 368, ("ball receiver",), 1) for name in ("B1", "Y2")]


RANGES = [0.0 if cell < 90 else math.inf if cell < 180 else 0.5 + 0.001 * cell for cell in range(360)]
"""Lidar cells of all kinds."""


def values_at(tick: int) -> list[float]:
    """Return all numbers of the devices: a wheel that turns by 5 rad/s, a compass that is off, a lidar."""
    return [0.032 * 5 * tick, 0.1234, -0.0001 * tick, 0.0375, 250.0 + tick, *[math.nan] * 3, *RANGES]


def camera_packets(tick: int) -> list[Packet]:
    """Return a picture that is green, or blue from tick 60 on, and a ball that is recognized; every 3 ticks."""
    if tick % 3:
        return []
    picture = bytes((2, 0, 128, 0, 0, 0, 255)) + bytes(48 * [int(tick >= 60)])
    ball = SEEN.pack(7, 1, 255, 0, 0, 0.3, 0.0, -0.04, 0.0, 0.042, 0.042, 2, 3, 4, 2)
    return [Packet(number, data, 0.0, (0.0, 0.0, 0.0)) for number, data in ((8, picture), (8 + RECOGNITION, ball))]


def printed_at(tick: int) -> str:
    """Return what B1 prints on a tick."""
    return {10: HOSTILE, 20: TURNED, 30: ENDLESS}.get(tick, f"tick {tick}\n" if tick % 100 == 0 else "")


def sense(writer: SensorWriter, tick: int) -> None:
    """Record one tick of both robots; tick 0: what they set and print before their first step."""
    for robot in range(len(SENSED)):
        if tick == 0:
            writer.record_action(robot, [MotorCommand(0, 3.0, math.inf)], "ready\n")
            continue
        heard = [Packet(6, b"x", 4.0, (1.0, 0.0, -0.1))] if tick % 2 else []
        writer.record_observation(robot, Observation(tick, values_at(tick), heard + camera_packets(tick)))
        light = MotorCommand(9, float(tick // 100), math.inf)
        writer.record_action(
            robot, [MotorCommand(1, -float(tick % 8), math.inf), light], "" if robot else printed_at(tick)
        )


def logo(red: int) -> bytes:
    """Return a PNG of 8 x 8 pixels of one colour."""
    lines = (b"\0" + bytes((red, 0, 255)) * 8) * 8
    header = struct.pack(">IIBBBBB", 8, 8, 8, 2, 0, 0, 0)
    return PNG + b"".join(
        chunk(kind, body) for kind, body in ((b"IHDR", header), (b"IDAT", zlib.compress(lines)), (b"IEND", b""))
    )


READINGS_AT_125 = {
    "left wheel motor": "set to 3.00 rad/s",
    "right wheel motor": "set to -5.00 rad/s",
    "left wheel sensor": "20.00 rad, turned 5.00 rad/s",
    "gps": "0.123  -0.013  0.037",
    "distancesensor left": "375.0",
    "ball": "strength 4.0, direction 1.00  0.00  -0.10",
    "not enabled": "compass",
}
"""What the card of B1 says at tick 125."""


def reading(card: Any, name: str) -> str:
    """Return what a robot's card says of a device."""
    return str(card.locator(f"dt:text-is('{name}') + dd").inner_text())
