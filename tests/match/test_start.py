"""How a match starts: programs first, and the physics while they do."""

import subprocess
import sys


def test_the_physics_is_not_loaded_before_programs_are_started():
    asked = "import sys, rcj_challenges.match.runner; print('mujoco' in sys.modules)"
    output = subprocess.run([sys.executable, "-c", asked], check=True, capture_output=True, text=True).stdout
    assert output.strip() == "False"


def test_the_result_has_the_start_up_time(play):
    run = play("match.half_s=1")
    assert 0 < run.result["start_up_s"] < run.result["wall_s"]
