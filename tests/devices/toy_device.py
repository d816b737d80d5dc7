"""A device that the package does not have, in one file; run as a program it prints what the package makes of it."""

import json
import shutil
import sys
from pathlib import Path
from typing import Any, Literal

from rcj_challenges.devices.base import DEVICES, Device, Fitted, RobotSetup, Sensor, SensorContext
from rcj_challenges.devices.noise import Noise
from rcj_challenges.devices.poses import RobotPose
from rcj_challenges.devices.wording import noise_words
from rcj_challenges.rules.fields import NotNegative, described
from rcj_challenges.rules.phrasing import metres


class MidlineDevice(Device):
    """How far the robot is from the midline in m."""

    device: Literal["midline"]
    noise_m: NotNegative = described(0.0, "standard deviation of the distance in m")

    CLASS = "midline_sensor"
    ACCEPTS = frozenset({"sampling"})
    WIDTH = 1
    EXAMPLE = """
robots:
  B1: {devices: {midline: {device: midline, noise_m: 0.001}}}
"""

    def facts(self, _setup: RobotSetup) -> dict[str, Any]:
        """Return what a program can ask without stepping."""
        return {"is_noisy": self.noise_m > 0}

    def make_sensor(self, fitted: Fitted, context: SensorContext) -> Sensor:
        """Return the sensor of this device."""
        return MidlineSensor(self, fitted, context)

    def describe(self) -> str:
        """Return what it is."""
        return f"distance to the midline{noise_words(metres(self.noise_m) if self.noise_m else '')}"


class MidlineSensor(Sensor):
    """The distance, with noise."""

    def __init__(self, device: MidlineDevice, fitted: Fitted, context: SensorContext) -> None:
        super().__init__(fitted.spec)
        self._noise_m = device.noise_m
        self._noise = Noise.of(fitted, context.half)

    def read(self, tick: int, pose: RobotPose, values: list[float]) -> None:
        """Write the sample of a tick into the robot's numbers."""
        values[self.slot] = abs(pose.y) + self._noise_m * self._noise.numbers(tick)[0]


PROGRAM = """
from controller import Robot
robot = Robot()
midline = robot.getDevice("midline"); midline.enable(32)
gps = robot.getDevice("gps"); gps.enable(32)
while robot.step(32) != -1:
    print(midline.getValue().hex(), gps.getValues()[1])
"""


def report(folder: Path) -> dict[str, object]:
    """Return what validation, a match, its recording, sheet, schema and reference make of the device."""
    from rcj_challenges.records.sensors import read_sensors
    from rcj_challenges.scenario.errors import ScenarioError
    from rcj_challenges.scenario.json_schema import scenario_schema
    from rcj_challenges.scenario.load import load_text
    from rcj_challenges.views.replay.sensor_blocks import robot_facts
    from rcj_challenges.views.sheet import sheet_markdown
    from scripts.write_reference import Example, page
    from tests.match.playing import Place

    text = Example("devices", ("midline",), MidlineDevice.EXAMPLE).whole
    loaded = load_text(text)
    try:
        load_text(text.replace("noise_m: 0.001", "noise_m: -1"))
        refused = []
    except ScenarioError as error:
        refused = [one.where.path for one in error.diagnostics]
    use_controller_with(folder / "program_side")
    place = Place(folder)
    robot = "robots.B1.devices={midline: {device: midline, noise_m: 0.001}}"
    run = place.play(robot, "match.half_s=1", blue=place.team_folder(PROGRAM), record_sensors=True)
    track = read_sensors(run.folder)[1].robots["B1"]
    return {
        "refused": refused,
        "printed": [line.split() for line in run.log("B1").splitlines() if line.startswith("0x")],
        "recorded": [value.hex() for value in track.readings("midline")[1:, 0].tolist()],
        "on_page": [one["kind"] for one in robot_facts(track.robot)["devices"] if one["name"] == "midline"],
        "sheet": sheet_markdown(loaded.scenario, loaded.roster),
        "schema": list(scenario_schema()["$defs"]["MidlineDevice"]["properties"]),
        "reference": page().partition("### midline\n")[2].partition("\n### ")[0],
    }


def use_controller_with(folder: Path) -> None:
    """Let programs run with a copy of `controller` that has the device's class."""
    from rcj_challenges.programs import processes, visible_files

    shutil.copytree(processes.PROGRAM_SIDE, folder)
    shutil.copy(Path(__file__).with_name("toy_controller.py"), folder / "controller" / "midline_sensor.py")
    processes.PROGRAM_SIDE = visible_files.PROGRAM_SIDE = folder


if __name__ == "__main__":
    DEVICES.add(MidlineDevice)
    print(json.dumps(report(Path(sys.argv[1]))))
