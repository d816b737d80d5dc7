"""A word is one file and one entry of a list: validated, judged, explained, and shown in schema and reference."""

import json
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture(scope="module")
def toy() -> dict:
    """Return what a process finds that has registered the toy trigger."""
    command = [sys.executable, "-m", "tests.rules.toy_trigger"]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True)
    return json.loads(done.stdout)


def test_rule_with_registered_trigger_is_judged(toy):
    assert toy["differences"] == []


def test_unknown_name_in_registered_trigger_is_refused_at_its_place(toy):
    assert toy["refused"] == ["rules.strayed.triggers[0] (strays)"]


def test_registered_trigger_is_explained_on_the_sheet(toy):
    assert "the ball strays by more than 0.5 m" in toy["sheet"]


def test_registered_trigger_is_in_the_schema(toy):
    assert toy["schema"] == ["trigger", "entity", "distance_m"]


def test_registered_trigger_is_in_the_reference_with_its_example(toy):
    assert "| `distance_m` | number, over 0 |" in toy["reference"]
    assert "trigger: strays, entity: ball" in toy["reference"]
