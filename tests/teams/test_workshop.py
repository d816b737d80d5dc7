"""The example designs of the workshop: each within its budget, by a program that a pupil can read, and better than chance."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
import yaml
from typer.testing import CliRunner

from rcj_challenges.checker.designs import check_designs
from rcj_challenges.cli.commands import load_app
from rcj_challenges.scenario.designs import judge_designs
from rcj_challenges.scenario.kits import kit_of
from rcj_challenges.scenario.load import load
from rcj_challenges.submissions.team import open_team

ROOT = Path(__file__).resolve().parents[2]
TEAMS = ROOT / "examples" / "teams"
WORKSHOP = ("workshop_classic", "workshop_keeper", "workshop_striker")
PROGRAM = "rcj_soccer_team_blue/rcj_soccer_team_blue.py"
AT_RANDOM = """import random
from controller import Robot
robot = Robot()
motors = [robot.getDevice(f"{side} wheel motor") for side in ("left", "right")]
for motor in motors:
    motor.setPosition(float("inf"))
while robot.step(320) != -1:
    for motor in motors:
        motor.setVelocity(random.uniform(-10, 10))
"""


@pytest.mark.parametrize("name", WORKSHOP)
def test_a_design_is_within_the_budget_and_every_device_is_used(name):
    loaded = load("workshop")
    stage = check_designs(open_team(TEAMS / name, *loaded.scenario.entrants.values()), loaded)
    assert {finding.code for finding in stage.findings} == {"design.cost"}


GUIDED = [path for path in sorted(ROOT.glob("scenarios/**/*.yaml")) if load(path).scenario.guidelines]


@pytest.mark.parametrize("path", GUIDED, ids=lambda path: path.stem)
def test_the_usual_robots_are_within_the_guidelines(path):
    """A team that writes down the kit that it has anyway hands in a valid design."""
    scenario = load(path).scenario
    assert scenario.guidelines
    for seat, entrant in scenario.entrants.items():
        guideline = scenario.guidelines[entrant.design or ""]
        kits = [kit_of(scenario, robot) for robot in entrant.robots]
        for kit in {id(kit): kit for kit in kits}.values():
            data = kit.model_dump(mode="json", exclude_defaults=True)
            devices = {name: device for name, device in data["devices"].items() if name not in guideline.keeps}
            file = {"design_version": 1, "designs": {"usual": {"chassis": data.get("chassis", {}), "devices": devices}}}
            verdict = judge_designs(yaml.safe_dump(file).encode(), guideline, len(entrant.robots), 0.021, {})
            assert [str(one) for one in verdict.problems + verdict.warnings] == [], seat
            assert sum(one.points for one in verdict.prices("usual")) <= guideline.budget


@pytest.mark.parametrize("name", WORKSHOP)
def test_a_program_has_at_most_80_lines(name):
    assert len((TEAMS / name / PROGRAM).read_text(encoding="utf-8").splitlines()) <= 80


@pytest.mark.nightly
@pytest.mark.parametrize("name", WORKSHOP)
def test_a_team_beats_robots_that_drive_at_random(tmp_path, name):
    (tmp_path / "chance.py").write_text(AT_RANDOM, encoding="utf-8")
    teams = ("--blue", str(TEAMS / name), "--yellow", str(tmp_path / "chance.py"))
    record = ("--out", str(tmp_path / "runs"), "--json", "--no-replay")
    done = CliRunner().invoke(load_app(), ["run", "workshop", *teams, *record, "--seed", "1", "--duration", "90"])
    result = json.loads(done.stdout)
    assert result["faults"] == []
    assert result["score"]["blue"] > result["score"]["yellow"]
