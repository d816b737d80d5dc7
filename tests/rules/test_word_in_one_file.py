"""A word is one file and one line of a list: validated, judged, explained, and shown in schema and reference."""

import json
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
KINDS = ("trigger", "condition", "action", "place", "value")


@pytest.fixture(scope="module")
def toys() -> dict:
    """Return by kind what a process reports that has registered a toy word of each kind."""
    command = [sys.executable, "-m", "tests.rules.toys"]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True)
    return json.loads(done.stdout)


@pytest.mark.parametrize("kind", KINDS)
def test_registered_word_is_judged_as_its_example_expects(toys, kind):
    assert toys[kind]["differences"] == []


@pytest.mark.parametrize(
    ("kind", "path"),
    [
        ("trigger", "rules.strayed.triggers[0] (strays)"),
        ("condition", "rules.goal_from_the_right.conditions[0] (right_of)"),
        ("action", "rules.goal.actions[0] (double)"),
        ("place", "rules.drop.actions[0] (place)"),
        ("value", "rules.late.actions[1] (emit)"),
    ],
)
def test_unknown_name_in_registered_word_is_refused_at_its_place(toys, kind, path):
    assert toys[kind]["refused"] == [["unknown-name", path]]


@pytest.mark.parametrize(
    ("kind", "sentence"),
    [
        ("trigger", "the ball strays by more than 0.5 m"),
        ("condition", "provided that the ball is more than 5 cm to the right"),
        ("action", "the counter “stake” is doubled"),
        ("place", "the ball is put anywhere 0.1 m from the spot “middle yellow”"),
        ("value", "yellow gets points: 1, plus 10 times the y of the ball in m"),
    ],
)
def test_registered_word_is_explained_on_the_sheet(toys, kind, sentence):
    assert sentence in toys[kind]["sheet"]


@pytest.mark.parametrize(
    ("kind", "fields"),
    [
        ("trigger", ["trigger", "entity", "distance_m"]),
        ("condition", ["right_of", "beside"]),
        ("action", ["action", "counter"]),
        ("place", ["on_circle", "radius_m"]),
        ("value", ["y_of"]),
    ],
)
def test_registered_word_is_in_the_schema(toys, kind, fields):
    assert set(fields) <= set(toys[kind]["schema"])


@pytest.mark.parametrize(
    ("kind", "row", "example"),
    [
        ("trigger", "| `distance_m` | number, above 0 |", "trigger: strays"),
        ("condition", "| `right_of` | number |", "right_of: 0.05"),
        ("action", "| `counter` | name |", "action: double"),
        ("place", "| `radius_m` | number, above 0 |", "on_circle: middle_yellow"),
        ("value", "| `y_of` | name |", "y_of: ball"),
    ],
)
def test_registered_word_is_in_the_reference_with_its_example(toys, kind, row, example):
    assert row in toys[kind]["reference"]
    assert example in toys[kind]["reference"]
