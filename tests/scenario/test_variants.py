"""The variants of the technical challenges: the same rules for the robots of later years, in a few lines."""

from __future__ import annotations

import pytest

from rcj_challenges.expect.runner import run_test
from rcj_challenges.scenario.load import load
from rcj_challenges.scenario.resources import SCENARIOS_FOLDER

VARIANTS = sorted((SCENARIOS_FOLDER / "variants").glob("*.yaml"))


def test_each_technical_challenge_has_one():
    assert [path.stem for path in VARIANTS] == ["fast_shooter_v2", "pass_the_ball_v2", "precision_lidar_v2"]


@pytest.mark.parametrize("path", VARIANTS, ids=lambda path: path.stem)
def test_a_variant_replaces_the_kit_in_at_most_twelve_lines(path):
    assert len(path.read_text(encoding="utf-8").splitlines()) <= 12
    variant = load(path).scenario
    original = load(path.stem.removesuffix("_v2")).scenario
    assert {robot.kit for robot in original.robots.values()} == {"legacy_2021"}
    assert {robot.kit for robot in variant.robots.values()} == {"v2"}
    assert variant.rules == original.rules
    assert variant.placements == original.placements


@pytest.mark.parametrize("path", VARIANTS, ids=lambda path: path.stem)
def test_the_tests_of_the_challenge_pass_in_its_variant(path):
    loaded = load(path)
    differences = {name: list(run_test(loaded, name).differences) for name in loaded.scenario.expect}
    assert not any(differences.values()), differences


def test_the_lidar_of_the_variant_stands_beside_the_sonars():
    variant = load(SCENARIOS_FOLDER / "variants" / "precision_lidar_v2.yaml").scenario
    assert set(variant.robots["Y3"].devices) == {"lidar"}
    assert "distancesensor front" in variant.kits["v2"].devices
