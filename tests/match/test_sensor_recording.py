"""A sensor recording tells what programs saw, set and printed, and changes nothing."""

import struct

import numpy as np
import pytest
from typer.testing import CliRunner

from rcj_challenges.cli.commands import load_app
from rcj_challenges.match.sensor_recording import LogTail
from rcj_challenges.records.sensors import read_sensors
from tests.match.playing import alone
from tests.match.programs import AHEAD, STAND

PRINTS_ITS_READINGS = """
from controller import Robot
robot = Robot()
gps = robot.getDevice("gps"); gps.enable(32)
sonar = robot.getDevice("distancesensor front"); sonar.enable(64)
wheel = robot.getDevice("left wheel sensor"); wheel.enable(32)
ball = robot.getDevice("ball receiver"); ball.enable(32)
left, right = (robot.getDevice(side + " wheel motor") for side in ("left", "right"))
for motor in (left, right):
    motor.setPosition(float("inf"))
print("ready")
tick = 0
while robot.step(32) != -1:
    tick += 1
    heard = "none"
    while ball.getQueueLength():
        heard = ball.getSignalStrength().hex()
        ball.nextPacket()
    readings = [*gps.getValues(), sonar.getValue(), wheel.getValue()]
    left.setVelocity(tick % 10)
    print(tick, heard, *(value.hex() for value in readings))
"""


@pytest.fixture(scope="module")
def recorded(shared_place):
    blue = shared_place.team_folder(PRINTS_ITS_READINGS, AHEAD, STAND)
    return shared_place.play(blue=blue, record_sensors=True)


def test_recorded_readings_are_what_the_program_printed_bit_for_bit(recorded) -> None:
    track = read_sensors(recorded.folder)[1].robots["B1"]
    printed = [line.split() for _, text in track.output for line in text.splitlines() if line[0].isdigit()]
    assert len(printed) == 156
    for line in printed:
        row = int(line[0])
        assert track.ticks[row] == row
        readings = [*track.readings("gps")[row], *track.readings("distancesensor front")[row]]
        readings += [*track.readings("left wheel sensor")[row]]
        reported = [float.fromhex(number) for number in line[2:]]
        assert struct.pack("<5d", *readings) == struct.pack("<5d", *reported)
        heard = track.packets[row, -1, 0]
        assert np.isnan(heard) if line[1] == "none" else heard == float.fromhex(line[1])


def test_printed_lines_stand_at_the_tick_at_which_they_were_printed(recorded) -> None:
    track = read_sensors(recorded.folder)[1].robots["B1"]
    lines = [(tick, line) for tick, text in track.output for line in text.splitlines()]
    assert lines[0] == (0, "ready")
    assert all(tick == int(line.split()[0]) for tick, line in lines[1:])


def test_wheel_speeds_are_those_that_were_set_on_the_reading(recorded) -> None:
    track = read_sensors(recorded.folder)[1].robots["B1"]
    assert track.motors[1:, 0].tolist() == [tick % 10 for tick in range(1, 157)]


def test_a_recording_changes_neither_the_digest_nor_what_else_is_recorded(play, team_folder) -> None:
    teams = {"blue": team_folder(PRINTS_ITS_READINGS), "yellow": team_folder(AHEAD)}
    two = alone("blue", "yellow")
    with_sensors, without = play(*two, **teams, record_sensors=True), play(*two, **teams)
    assert with_sensors.result["digest"] == without.result["digest"]
    assert not read_sensors(without.folder)[1].has_readings
    robots = read_sensors(without.folder)[1].robots
    assert robots["B1"].output == read_sensors(with_sensors.folder)[1].robots["B1"].output
    assert with_sensors.log("B1") == without.log("B1")


def test_a_program_that_fails_is_recorded_until_then_with_its_last_words(play, team_folder) -> None:
    crashing = PRINTS_ITS_READINGS.replace(
        "    tick += 1", '    tick += 1\n    if tick == 50: raise ValueError("lost")'
    )
    run = play(blue=team_folder(crashing), record_sensors=True)
    track = read_sensors(run.folder)[1].robots["B1"]
    assert track.ticks[-1] == 49
    assert "ValueError: lost" in "".join(text for tick, text in track.output if tick == 50)


def test_each_half_has_a_recording_with_its_own_output(play, team_folder) -> None:
    halves = ("match.halves=2", "match.half_s=2", *alone("blue", "yellow"))
    run = play(*halves, yellow=team_folder(PRINTS_ITS_READINGS), record_sensors=True)
    halves = read_sensors(run.folder)
    assert halves[1].robots["Y1"].output[0] == (0, "ready\n")
    assert not halves[1].robots["B1"].output
    assert halves[2].robots["B1"].output[0] == (0, "ready\n")
    assert not halves[2].robots["Y1"].output


def test_the_command_line_records_sensors_on_request(tmp_path) -> None:
    arguments = ["run", "match", "--halves", "1", "--duration", "1", "--quiet", "--out", str(tmp_path)]
    assert CliRunner().invoke(load_app(), [*arguments, "--record", "sensors"]).exit_code == 0
    (folder,) = tmp_path.iterdir()
    assert len(read_sensors(folder)[1].robots) == 6
    page = (folder / "replay.html").read_text("utf-8")
    assert 'id="sensors-1"' in page
    assert CliRunner().invoke(load_app(), [*arguments, "--record", "everything"]).exit_code == 2


@pytest.mark.parametrize("letters", [1, 65_535, 65_536, 65_537, 3 * 65_536, 200_001])
def test_however_much_is_printed_at_once_all_of_it_is_taken_over_without_the_heading(tmp_path, letters):
    log = tmp_path / "Y1.log"
    tail = LogTail(log)
    said = ("é123456\n" * letters)[:letters]
    log.write_bytes(b"--- half 1 ---\n" + said.encode())
    assert tail.new_text() == said
    with log.open("ab") as file:
        file.write(said.encode())
    assert tail.new_text() == said
    assert tail.new_text() == ""
    tail.close()
