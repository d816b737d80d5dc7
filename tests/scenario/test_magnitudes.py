"""Lengths, noises and masses have bounds: what is refused says them, and what is at them can be built and judged."""

from __future__ import annotations

import pytest

from rcj_challenges.expect.scripted_match import ScriptedMatch
from rcj_challenges.scenario.lint.registry import lint
from rcj_challenges.views.drawing.field import draw_scenario
from rcj_challenges.world.world import World
from tests.scenario.writing import errors, in_short, loaded, rule

PLACE = "{action: place, entity: ball, at: %s}"
CRATE = "obstacles: {crate: {shape: %s, centre_m: [0, 0.1], movable: true, %s}}\n"
DEVICE = "kits: {v2: {devices: {d: {%s}}}}\n"
KEYFRAME = "expect: {it: {keyframes: [{at_s: 0.1, %s}], lasts_s: 1}}\n"
CHASSIS = "kits: {v2: {chassis: {%s}}}\n"
ALONE = """
robots: {B1: null, B2: null, B3: null, Y1: null, Y2: null}
entrants: {blue: null, yellow: {robots: {Y1: null, Y2: null}}}
"""


@pytest.mark.parametrize(
    ("body", "path", "bound"),
    [
        ("robots: {Y1: {start: {noise_m: [75, 75]}}}\n", "robots.Y1.start.noise_m[0]", "5"),
        ("robots: {Y1: {start: {noise_m: [0, -0.1]}}}\n", "robots.Y1.start.noise_m[1]", "0"),
        (
            rule(action="{action: place, entity: ball, at: {point: [0, 0]}, noise_m: [0, 50]}"),
            "rules.r.actions[0] (place)",
            "5",
        ),
        ("placements: {all: [{entity: ball, at: start, noise_m: [-1, 0]}]}\n", "placements.all[0].noise_m[0]", "0"),
        (rule(action=PLACE % "{point: [1.0e+200, 0]}"), "rules.r.actions[0] (place)", "1000"),
        (rule(action=PLACE % "{on_line: [[0, 0], [0, -2000]]}"), "rules.r.actions[0] (place)", "-1000"),
        (rule(action=PLACE % "{choice: [centre, [0, 2000]]}"), "rules.r.actions[0] (place)", "1000"),
        ("spots: {far: {x_m: 1.0e+9, y_m: 0}}\n", "spots.far.x_m", "1000"),
        ("balls: {ball: {mass_kg: 1.0e-20}}\n", "balls.ball.mass_kg", "1e-06"),
        ("balls: {ball: {radius_m: 1.0e-9}}\n", "balls.ball.radius_m", "0.001"),
        (CHASSIS % "size_m: 1.0e-6", "kits.v2.chassis.size_m", "0.001"),
        (CHASSIS % "wheel_mass_kg: 1.0e-9", "kits.v2.chassis.wheel_mass_kg", "1e-06"),
        (CRATE % ("box", "size_m: [1.0e-6, 0.1]"), "obstacles.crate.size_m[0]", "0.001"),
        (CRATE % ("box", "size_m: [0.1, 11]"), "obstacles.crate.size_m[1]", "10"),
        ("field: {goals: {blue_goal: {depth_m: 1.0e+9}}}\n", "field.goals.blue_goal.depth_m", "10"),
        ("zones: {z: {shape: circle, centre_m: [0, 0], radius_m: 1.0e+5}}\n", "zones.z.radius_m", "1000"),
        ("robots: {Y1: {start: {yaw_rad: 1.0e+39}}}\n", "robots.Y1.start.yaw_rad", "1000"),
        (CRATE % ("box", "size_m: [0.1, 0.1], yaw_rad: -1.0e+308"), "obstacles.crate.yaw_rad", "-1000"),
        (rule(action=PLACE % "start, facing: 1.0e+308"), "rules.r.actions[0] (place)", "1000"),
        (DEVICE % "device: sonar, bearing_rad: 1.0e+308", "kits.v2.devices.d.bearing_rad", "1000"),
        (DEVICE % "device: compass, noise_rad: 1.0e+308", "kits.v2.devices.d.noise_rad", "1000"),
        (DEVICE % "device: sonar, bearing_rad: 0, noise: 1.0e+308", "kits.v2.devices.d.noise", "1000,"),
        (DEVICE % "device: ball_receiver, strength_noise: 1.0e+308", "kits.v2.devices.d.strength_noise", "1000,"),
        (KEYFRAME % "place: {Y1: [0, 0, 1.0e+308]}", "expect.it.keyframes[0].place.Y1[2]", "1000,"),
        (KEYFRAME % "move: {Y1: [-1.0e+308, 0]}", "expect.it.keyframes[0].move.Y1[0]", "-1000,"),
        (
            rule("{trigger: holds, conditions: [{entity: Y1, held: true}], for_s: 1.0e+308}"),
            "rules.r.triggers[0] (holds)",
            "86400",
        ),
        (
            rule("{trigger: stays_in, entity: ball, zone: pitch, limit_s: 1, grace_s: 1.0e+308}"),
            "rules.r.triggers[0] (stays_in)",
            "86400",
        ),
    ],
)
def test_number_out_of_all_measure_is_refused_with_its_bound(body, path, bound):
    (problem,) = errors(body)
    assert in_short(problem) == f"out-of-range {path}"
    assert f" {bound}" in problem.message


def test_a_counter_may_be_set_to_any_number():
    assert loaded("counters: {c: {}}\n" + rule(action="{action: count, counter: c, to: 5000}"))


SMALLEST = (
    "balls: {ball: {radius_m: 0.001, mass_kg: 1.0e-6}}\n",
    CRATE % ("box", "size_m: [0.001, 0.001], height_m: 0.001, mass_kg: 1.0e-6"),
    CHASSIS % "size_m: 0.001, mass_kg: 1.0e-6, wheel_radius_m: 0.001, wheel_width_m: 0.001, wheel_mass_kg: 1.0e-6",
)


@pytest.mark.parametrize("body", SMALLEST)
def test_the_smallest_bodies_stand_in_the_world(body):
    found = loaded(body + ("" if "robots:" in body else ALONE))
    World(found.scenario, found.roster)


LARGEST = (
    "zones: {z: {shape: circle, centre_m: [0, 0], radius_m: 1000}}\n",
    "zones: {z: {shape: polygon, points_m: [[-1000, -1000], [1000, -1000], [0, 1000]]}}\n",
    "gates: {g: {from_m: [-1000, -1000], to_m: [1000, 1000]}}\n",
    "spots: {s: {x_m: 1000, y_m: -1000}}\n",
    "robots: {Y3: {start: {noise_m: [5, 5]}}}\n",
    "field: {goals: {blue_goal: {depth_m: 10}}}\n",
    "balls: {ball: {radius_m: 0.001}}\n",
)


@pytest.mark.parametrize("body", LARGEST)
def test_the_largest_numbers_can_be_drawn_and_judged(body):
    found = loaded(body + ("" if "robots:" in body else ALONE))
    lint(found)
    ScriptedMatch(found.scenario, found.roster).play(2)
    assert "</svg>" in draw_scenario(found.scenario, found.roster)
