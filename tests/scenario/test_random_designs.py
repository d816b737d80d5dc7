"""Whatever design the guidelines allow can be built, drives, and stays within its cylinder."""

import math

import yaml
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.scenario.test_designs import guideline, judged
from tests.world.physics_stage import Stage

CHASSIS = st.fixed_dictionaries(
    {
        "drive": st.just("omni"),
        "shape": st.sampled_from(["round", "flat_front"]),
        "size_m": st.floats(0.05, 0.1),
        "mass_kg": st.floats(0.02, 0.36),
        "wheels_at_rad": st.lists(st.floats(0, 6.28), min_size=3, max_size=4),
        "wheel_ring_m": st.floats(0.01, 0.045),
        "wheel_width_m": st.floats(0.004, 0.012),
    },
    optional={"jaws_m": st.tuples(st.floats(0.002, 0.008), st.floats(0.02, 0.06)).map(list)},
)


@settings(deadline=None)
@given(CHASSIS, st.lists(st.floats(-12.5, 12.5), min_size=4, max_size=4))
def test_allowed_designs_are_built_and_drive(chassis, speeds):
    devices = {f"m{wheel}": {"device": "motor", "wheel": wheel} for wheel in range(len(chassis["wheels_at_rad"]))}
    file = {"design_version": 1, "designs": {"it": {"chassis": chassis, "devices": devices}}}
    verdict = judged(yaml.safe_dump(file))
    if verdict.problems:
        return
    made = verdict.designs["it"].chassis
    corners = [corner for outline in made.footprint() for corner in outline]
    assert max(math.hypot(*corner) for corner in corners) <= guideline().max_diameter_m / 2 + 1e-6
    stage = Stage(kits={"v2": {"chassis": made}})
    stage.put("B1", 0, 0)
    stage.put("ball", 0.08, 0)
    for wheel, radps in zip(range(len(chassis["wheels_at_rad"])), speeds, strict=False):
        stage.world.set_wheel(stage.index("B1"), wheel, radps, math.inf)
    stage.play(1.5)
    assert all(map(math.isfinite, stage.pose("B1")))
    assert stage.speed("B1") < 2 * made.top_speed_mps + 0.05
