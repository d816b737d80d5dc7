"""A chassis is one file and one entry of a list."""

import json
import subprocess
import sys
from pathlib import Path

import pytest

from rcj_challenges.scenario.errors import ScenarioError
from rcj_challenges.scenario.load import load_text

ROOT = Path(__file__).resolve().parents[2]
V2 = "schema_version: 1\nid: chassis\ntitle: Chassis\nextends: soccersim_v2\nmatch: {half_s: 60}\nkits: {v2: {%s}}\n"


@pytest.fixture(scope="module")
def toy(tmp_path_factory) -> dict:
    """Return what a process finds that has registered the toy chassis and played a match with it."""
    command = [sys.executable, "-m", "tests.chassis.toy_chassis", str(tmp_path_factory.mktemp("toy"))]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True)
    return json.loads(done.stdout)


@pytest.mark.parametrize("wheels", ["3", "4"])
@pytest.mark.parametrize("way", ["ahead", "sideways", "spin", "ahead and spin"])
def test_robot_with_omni_wheels_moves_as_its_wheels_are_commanded(toy, wheels, way):
    assert toy["speeds"][wheels][way]["is"] == pytest.approx(toy["speeds"][wheels][way]["ordered"], abs=0.003)


def test_programs_drive_registered_chassis_and_sense_its_wheels(toy):
    (x, y, yaw), (to_x, to_y, to_yaw) = toy["poses"]
    assert (to_x, to_y, to_yaw) == pytest.approx((x, y - 0.1 / 0.75**0.5 * 2, yaw), abs=0.01)
    assert toy["turned"][-1] == pytest.approx(-10, abs=0.2)


def test_all_its_wheels_cost_one_degree_of_freedom(toy):
    assert toy["dofs"] == 6 * 4 + 6


def test_wheel_that_registered_chassis_lacks_and_its_wrong_values_are_refused_at_their_place(toy):
    assert toy["refused"] == ["kits.v2.devices.rear wheel motor.wheel", "kits.v2.chassis.wheels_at_rad[0]"]


def test_registered_chassis_is_read_back_from_a_record(toy):
    assert toy["recorded"] == "OmniChassis"


def test_registered_chassis_is_drawn_on_page_picture_and_video(toy):
    assert toy["page"] == [3] * 6
    assert toy["drawn"] == 3 * 6
    assert toy["filmed"] == 3 * 6


def test_registered_chassis_is_described_on_sheet_and_reference(toy):
    assert "a round body on 3 omni wheels" in toy["sheet"]
    assert "| `wheels_at_rad` | list of numbers | required |" in toy["reference"]


@pytest.mark.parametrize("wheel", ["2", "0"])
def test_wheels_of_a_differential_drive_are_left_and_right(wheel):
    with pytest.raises(ScenarioError) as caught:
        load_text(V2 % f"devices: {{left wheel motor: {{wheel: {wheel}}}}}")
    assert [one.where.path for one in caught.value.diagnostics] == ["kits.v2.devices.left wheel motor.wheel"]


def test_chassis_that_does_not_exist_is_an_unknown_word():
    with pytest.raises(ScenarioError) as caught:
        load_text(V2 % "chassis: {drive: hover}")
    assert [(one.code, one.where.path) for one in caught.value.diagnostics] == [("unknown-word", "kits.v2.chassis")]


def test_kind_that_is_meant_without_its_key_keeps_what_a_base_says_when_it_is_named():
    text = V2 % "chassis: {wheel_track_m: 0.12}"
    merged = load_text(text, ["kits.v2.chassis={drive: differential}"])
    assert merged.scenario.kits["v2"].chassis.wheels()[0].y_m == 0.06
