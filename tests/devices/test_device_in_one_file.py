"""A device is one file and one entry of a list, and the file of its `controller` class."""

import json
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture(scope="module")
def toy(tmp_path_factory) -> dict:
    """Return what a process finds that has registered the toy device and played a match with it."""
    command = [sys.executable, "-m", "tests.devices.toy_device", str(tmp_path_factory.mktemp("toy"))]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True)
    return json.loads(done.stdout)


def test_program_reads_registered_device_through_its_own_class(toy):
    assert len(toy["printed"]) >= 30
    for reading, y_m in toy["printed"]:
        assert float.fromhex(reading) == pytest.approx(abs(float(y_m)), abs=0.01)


def test_readings_of_registered_device_are_recorded_bit_for_bit(toy):
    assert toy["recorded"] == [reading for reading, _ in toy["printed"]]
    assert toy["on_page"] == ["midline_sensor"]


def test_wrong_value_in_registered_device_is_refused_at_its_place(toy):
    assert toy["refused"] == ["robots.B1.devices.midline.noise_m"]


def test_registered_device_is_described_on_the_sheet(toy):
    assert "distance to the midline (noise: standard deviation" in toy["sheet"]


def test_registered_device_is_in_the_schema(toy):
    assert toy["schema"] == ["device", "noise_m"]


def test_registered_device_is_in_the_reference_with_its_example(toy):
    assert "| `noise_m` | number, at least 0 |" in toy["reference"]
    assert "device: midline, noise_m: 0.001" in toy["reference"]
