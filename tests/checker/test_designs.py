"""The stage *design* of a check."""

import pytest

from rcj_challenges.checker.designs import check_designs
from rcj_challenges.scenario.load import load, load_text
from tests.match.playing import Place
from tests.match.test_designs import team
from tests.scenario.test_designs import GUIDELINES, design


def found(tmp_path, text, loaded=None):
    loaded = loaded or load_text(GUIDELINES)
    stage = check_designs(team(Place(tmp_path), text, loaded.scenario), loaded)
    return stage.level, [finding.code for finding in stage.findings]


def test_design_within_the_guidelines_passes_with_its_price(tmp_path):
    assert found(tmp_path, design()) == ("passed", ["design.cost"])


def test_device_that_costs_points_and_that_no_program_names_is_a_warning(tmp_path):
    devices = ", eye: {device: camera}, robot: {device: sonar, bearing_rad: 0}, m5: {device: motor, wheel: 0}"
    assert found(tmp_path, design(devices=devices)) == ("warning", ["design.unused_device", "design.cost"])


def test_team_without_designs_passes(tmp_path):
    assert found(tmp_path, None) == ("passed", [])


def test_file_that_is_not_used_is_one_warning(tmp_path):
    assert found(tmp_path, design(), load("match")) == ("warning", ["design.unused"])


@pytest.mark.parametrize(
    ("text", "codes"),
    [
        (design(", mass_kg: 3, shape: box"), ["design.not_allowed", "design.too_heavy", "design.cost"]),
        ("a: [", ["design.unreadable"]),
        (design(", wheel_ring_m: 1.0e-9"), ["design.cost", "design.out_of_range"]),
    ],
)
def test_all_that_is_wrong_fails_the_stage(tmp_path, text, codes):
    assert found(tmp_path, text) == ("error", codes)
