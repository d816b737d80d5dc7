"""A sensor recording holds what a program saw, bit for bit, survives a kill, and does not grow without bound."""

import math
import struct
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from rcj_challenges.core.traffic import DeviceSpec, MotorCommand, Observation, Packet, RobotSpec
from rcj_challenges.devices.camera import RECOGNITION
from rcj_challenges.records import sensors
from rcj_challenges.records.errors import RecordError
from rcj_challenges.records.sensors import SensedRobot, SensorWriter, read_sensors

DEVICES = (
    DeviceSpec("left wheel motor", "motor", 0, -1, 0),
    DeviceSpec("right wheel motor", "motor", 1, -1, 0),
    DeviceSpec("gps", "gps", 2, 0, 3),
    DeviceSpec("distancesensor left", "distance_sensor", 3, 3, 1, {"bearing_rad": 1.57, "max_value": 1000.0}),
    DeviceSpec("ball receiver", "receiver", 4, -1, 0),
    DeviceSpec("supervisor receiver", "receiver", 5, -1, 0),
)
INF = float("inf")


def robot(name: str = "B1", balls: int = 1) -> SensedRobot:
    return SensedRobot.of(RobotSpec(name, DEVICES, 4, "bytes"), ["ball receiver"], balls)


def saw(tick: int, values: list[float] | None = None, packets: list[Packet] | None = None) -> Observation:
    return Observation(tick, values or [float(tick), 0.1 * tick, 0.0, 1000.0 - tick], packets or [])


def bits(numbers: np.ndarray) -> list[bytes]:
    return [struct.pack("<d", number) for number in numbers.ravel().tolist()]


def write(folder: Path, ticks: int, half: int = 1) -> SensorWriter:
    writer = SensorWriter(folder, half, [robot()])
    writer.record_action(0, [MotorCommand(0, 3.0, INF)])
    for tick in range(1, ticks + 1):
        writer.record_observation(0, saw(tick))
        writer.record_action(0, [], f"line {tick}\n" if tick % 50 == 0 else "")
    return writer


_any_float = st.floats(allow_nan=True, allow_infinity=True)


@given(rows=st.lists(st.lists(_any_float, min_size=4, max_size=4), min_size=1, max_size=20))
def test_readings_are_read_back_bit_for_bit(rows: list, tmp_path_factory: pytest.TempPathFactory) -> None:
    folder = tmp_path_factory.mktemp("run")
    writer = SensorWriter(folder, 1, [robot()])
    for tick, values in enumerate(rows, 1):
        writer.record_observation(0, saw(tick, values))
        writer.record_action(0, [])
    writer.close()
    track = read_sensors(folder)[1].robots["B1"]
    assert bits(track.values) == bits(np.array(rows))
    assert track.ticks.tolist() == list(range(1, len(rows) + 1))
    assert bits(track.readings("gps")) == bits(np.array(rows)[:, :3])


def test_a_motor_keeps_what_it_was_set_to_until_it_is_set_again(tmp_path: Path) -> None:
    writer = SensorWriter(tmp_path, 1, [robot()])
    writer.record_action(0, [MotorCommand(1, 4.5, INF)])
    writer.record_observation(0, saw(1))
    writer.record_action(0, [])
    writer.record_observation(0, saw(2))
    writer.record_action(0, [MotorCommand(0, -2.0, INF), MotorCommand(1, 4.5, 1.0)])
    writer.close()
    motors = read_sensors(tmp_path)[1].robots["B1"].motors
    assert motors[:2, 1].tolist() == [4.5, 4.5]
    assert math.isnan(motors[1, 0])  # never set yet
    assert motors[2, 0] == -2.0
    assert math.isnan(motors[2, 1])  # it holds an angle now


def test_before_its_first_step_a_program_has_seen_nothing(tmp_path: Path) -> None:
    write(tmp_path, 1).close()
    track = read_sensors(tmp_path)[1].robots["B1"]
    assert track.ticks.tolist() == [0, 1]
    assert np.isnan(track.values[0]).all()
    assert track.motors[0, 0] == 3.0


def test_only_packets_of_balls_are_kept_the_newest_last(tmp_path: Path) -> None:
    writer = SensorWriter(tmp_path, 1, [robot(balls=2)])
    heard = [Packet(4, b"x", strength, (1.0, 0.0, -0.1)) for strength in (1.0, 2.0, 3.0)]
    writer.record_observation(0, saw(1, packets=[heard[0], Packet(5, b"\x01", 9.0, (0.0, 1.0, 0.0)), *heard[1:]]))
    writer.record_action(0, [])
    writer.record_observation(0, saw(2, packets=heard[:1]))
    writer.record_action(0, [])
    writer.record_observation(0, saw(3))
    writer.record_action(0, [])
    writer.close()
    packets = read_sensors(tmp_path)[1].robots["B1"].packets
    assert packets[0].tolist() == [[2.0, 1.0, 0.0, -0.1], [3.0, 1.0, 0.0, -0.1]]
    assert np.isnan(packets[1, 0]).all()
    assert packets[1, 1, 0] == 1.0
    assert np.isnan(packets[2]).all()


def test_printed_text_stands_at_the_tick_at_which_it_was_printed(tmp_path: Path) -> None:
    writer = SensorWriter(tmp_path, 1, [robot("B1"), robot("Y1")])
    writer.record_action(0, [], "hello\n")
    writer.record_observation(1, saw(7))
    writer.record_action(1, [], "<b>\u202e日本\n")
    writer.record_output(1, "goodbye\n")
    writer.close()
    half = read_sensors(tmp_path)[1]
    assert half.robots["B1"].output == ((0, "hello\n"),)
    assert half.robots["Y1"].output == ((7, "<b>\u202e日本\n"), (7, "goodbye\n"))


def test_endless_printing_is_cut_and_the_readings_go_on(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sensors, "MAX_PRINTED_BYTES", 1000)
    writer = SensorWriter(tmp_path, 1, [robot()])
    for tick in range(1, 21):
        writer.record_observation(0, saw(tick))
        writer.record_action(0, [], "x" * 99 + "\n")
    writer.close()
    track = read_sensors(tmp_path)[1].robots["B1"]
    text = "".join(text for _, text in track.output)
    assert len(text) < 1100
    assert len(track.ticks) == 20


def test_a_recording_stops_at_its_size_limit_and_notes_where(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sensors, "MAX_BYTES_A_HALF", 20_000)
    noise = np.random.default_rng(1)
    writer = SensorWriter(tmp_path, 1, [robot()])
    for tick in range(1, 3001):
        writer.record_observation(0, saw(tick, noise.random(4).tolist()))
        writer.record_action(0, [])
    writer.close()
    half = read_sensors(tmp_path)[1]
    path = next((tmp_path / "sensors").iterdir())
    assert path.stat().st_size < 20_200
    assert half.full_at is not None
    ticks = half.robots["B1"].ticks
    assert 0 <= half.full_at - ticks[-1] <= 2 * sensors.TICKS_PER_CHUNK
    assert not half.damaged


@pytest.mark.parametrize("lost", range(0, 1500, 61))
def test_a_recording_that_was_cut_off_anywhere_gives_its_whole_chunks(lost: int, tmp_path: Path) -> None:
    write(tmp_path, 400).close()
    path = next((tmp_path / "sensors").iterdir())
    data = path.read_bytes()
    head = data.index(b"\n") + 1
    path.write_bytes(data[: max(head, len(data) - lost)])
    half = read_sensors(tmp_path)[1]
    track = half.robots["B1"]
    whole = 401 if lost == 0 else len(track.ticks)
    assert len(track.ticks) == whole
    assert lost == 0 or whole in (0, 125, 250, 375)
    assert track.ticks.tolist() == list(range(whole))
    assert half.damaged or len(path.read_bytes()) == head or lost == 0


@given(place=st.integers(0, 10_000), byte=st.integers(0, 255))
def test_a_damaged_recording_is_read_as_far_as_it_goes_or_refused(
    place: int, byte: int, tmp_path_factory: pytest.TempPathFactory
) -> None:
    folder = tmp_path_factory.mktemp("run")
    write(folder, 300).close()
    path = next((folder / "sensors").iterdir())
    data = bytearray(path.read_bytes())
    data[place % len(data)] = byte
    path.write_bytes(bytes(data))
    try:
        halves = read_sensors(folder)
    except RecordError as error:
        assert "half-1.sensors" in str(error)  # noqa: PT017 - either is right
    else:
        assert all(len(track.ticks) <= 301 for half in halves.values() for track in half.robots.values())


def test_without_sensors_only_what_is_printed_is_recorded(tmp_path: Path) -> None:
    writer = SensorWriter(tmp_path, 1, [SensedRobot("B1")])
    writer.record_action(0, [MotorCommand(0, 3.0, INF)], "ready\n")
    for tick in range(1, 301):
        writer.record_observation(0, saw(tick))
        writer.record_action(0, [], f"line {tick}\n" if tick % 100 == 0 else "")
    writer.close()
    half = read_sensors(tmp_path)[1]
    assert not half.has_readings
    assert half.robots["B1"].output == ((0, "ready\n"), (100, "line 100\n"), (200, "line 200\n"), (300, "line 300\n"))
    assert len(half.robots["B1"].ticks) == 0


def test_packets_of_cameras_are_read_back_byte_for_byte(tmp_path: Path) -> None:
    eyes = tuple(DeviceSpec(name, "camera", index, -1, 0) for index, name in ((6, "front"), (7, "rear")))
    seeing = SensedRobot.of(RobotSpec("B1", (*DEVICES, *eyes), 4, "bytes"), [], 1)
    writer = SensorWriter(tmp_path, 1, [robot("Y1"), seeing])
    sent = []
    for tick in range(1, 301):
        packets = [Packet(number, bytes((tick % 256, number % 256)) * number, 0.0, (0.0, 0.0, 0.0))
                   for number in (6, 7) if tick % 3 == 0]  # fmt: skip
        packets += [Packet(6 + RECOGNITION, b"", 0.0, (0.0, 0.0, 0.0))] if tick % 50 == 0 else []
        sent += [(tick, packet.device, packet.data) for packet in packets]
        for number in range(2):
            writer.record_observation(number, saw(tick, packets=packets if number else None))
            writer.record_action(number, [])
    writer.close()
    tracks = read_sensors(tmp_path)[1].robots
    assert sorted(tracks["B1"].pictures) == sorted(sent)
    assert tracks["Y1"].pictures == ()
    assert len(tracks["B1"].ticks) == len(tracks["Y1"].ticks) == 300
