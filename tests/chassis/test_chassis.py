"""Chassis: how they are chosen, what their motors may name, and the shapes of bodies."""

import pytest

from rcj_challenges.chassis import CHASSIS
from rcj_challenges.chassis.base import Chassis
from rcj_challenges.geometry.polygons import side
from rcj_challenges.scenario.errors import ScenarioError
from rcj_challenges.scenario.load import load_text

V2 = "schema_version: 2\nid: chassis\ntitle: Chassis\nextends: soccersim_v2\nmatch: {half_s: 60}\nkits: {v2: {%s}}\n"


def refused(body: str) -> list[tuple[str, str]]:
    with pytest.raises(ScenarioError) as caught:
        load_text(V2 % body)
    return [(one.code, one.where.path) for one in caught.value.diagnostics]


@pytest.mark.parametrize("wheel", ["2", "0"])
def test_wheels_of_a_differential_drive_are_left_and_right(wheel):
    wrong = refused(f"devices: {{left wheel motor: {{wheel: {wheel}}}}}")
    assert wrong == [("wrong-value", "kits.v2.devices.left wheel motor.wheel")]


def test_chassis_that_does_not_exist_is_an_unknown_word():
    assert refused("chassis: {drive: hover}") == [("unknown-word", "kits.v2.chassis")]


def test_kind_that_is_meant_without_its_key_keeps_what_a_base_says_when_it_is_named():
    text = V2 % "chassis: {wheel_track_m: 0.12}"
    merged = load_text(text, ["kits.v2.chassis={drive: differential}"])
    assert merged.scenario.kits["v2"].chassis.wheels()[0].y_m == 0.06


@pytest.mark.parametrize("kind", CHASSIS.words())
@pytest.mark.parametrize("shape", ["box", "round", "flat_front"])
def test_every_solid_of_a_body_is_convex_and_counter_clockwise_and_within_its_size(kind, shape):
    chassis = kind.model_validate({"drive": kind.name(), "shape": shape, "jaws_m": (0.006, 0.05)})
    for outline in chassis.solids().values():
        turns = zip(outline, outline[1:] + outline[:1], outline[2:] + outline[:2], strict=True)
        assert all(side(*corners) > 0 for corners in turns)
    assert all(abs(x) <= 0.0375 and abs(y) <= 0.0375 for x, y in chassis.body())
    assert max(x for outline in chassis.solids().values() for x, _ in outline) == chassis.front_m + 0.006


@pytest.mark.parametrize(("shape", "front_m"), [("box", 0.0375), ("round", 0.0368), ("flat_front", 0.03)])
def test_front_of_a_body(shape, front_m):
    assert Chassis.model_construct(shape=shape).front_m == pytest.approx(front_m, abs=1e-4)


def test_jaws_that_the_body_does_not_carry_are_refused():
    assert refused("chassis: {jaws_m: [0.005, 0.07]}") == [("wrong-value", "kits.v2.chassis.jaws_m")]
