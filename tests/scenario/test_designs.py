"""Designs of teams, judged by guidelines."""

import time
from functools import cache
from pathlib import Path

import pytest

from rcj_challenges.devices.team_emitter import TeamEmitterDevice
from rcj_challenges.scenario.designs import MAX_BYTES, Verdict, judge_designs
from rcj_challenges.scenario.errors import ScenarioError
from rcj_challenges.scenario.load import load_text

DOCS = Path(__file__).resolve().parents[2] / "docs"
GUIDELINES = """
schema_version: 2
id: workshop
title: Workshop
extends: soccersim_v2
match: {halves: 2, half_s: 2, swap_sides: true}
guidelines:
  workshop:
    budget: 3000
    designs: 2
    max_diameter_m: 0.12
    max_height_m: 0.1
    max_mass_kg: 0.4
    max_mouth_m: 0.008
    shapes: [round, flat_front]
    drives:
      omni: {price: 100, limits: {wheels_at_rad: {prices: [[3, 800], [4, 1100]]}}}
    devices:
      motor: {}
      sonar: {price: 50, at_most: 8, limits: {range_m: {least: 0.1, most: 1}}}
      camera: {price: 500, at_most: 2, limits: {width: {prices: [[32, 0], [64, 100]]}, recognition: {prices: [[0, 0], [1, 300]]}}}
      kicker: {price: 400}
    keeps: [team emitter]
entrants:
  blue: {design: workshop}
  yellow: {design: workshop}
"""
MOTORS = "m0: {device: motor, wheel: 0}, m1: {device: motor, wheel: 1}, m2: {device: motor, wheel: 2}"
TWO_WHEELS = """
design_version: 1
designs:
  striker:
    chassis: {drive: differential, shape: round}
    devices: {left: {device: motor, wheel: left}, right: {device: motor, wheel: right}}
"""
FOURTH = "m3: {device: motor, wheel: 3}"


@cache
def guideline():
    return load_text(GUIDELINES).scenario.guidelines["workshop"]


def judged(text: str | bytes, robots: int = 3) -> Verdict:
    data = text.encode() if isinstance(text, str) else text
    kept = {"team emitter": TeamEmitterDevice(device="team_emitter")}
    return judge_designs(data, guideline(), robots, 0.021, kept)


def design(chassis: str = "", devices: str = "", more: str = "") -> str:
    return (
        f"design_version: 1\ndesigns:\n  striker:\n    chassis: {{drive: omni{chassis}}}\n"
        f"    devices: {{{MOTORS}, {FOURTH}{devices}}}\n{more}"
    )


def codes(verdict: Verdict) -> list[tuple[str, str]]:
    return [(one.code, one.where.path.removeprefix("designs.striker").lstrip(".")) for one in verdict.problems]


def test_design_within_the_guidelines_has_a_price_table():
    devices = ", front: {device: sonar, bearing_rad: 0}, left: {device: sonar, bearing_rad: 1.5}"
    devices += ", eye: {device: camera, recognition: true}"
    verdict = judged(design(devices=devices))
    assert verdict.problems == verdict.warnings == []
    assert {(one.what, one.count, one.points) for one in verdict.prices("striker")} == {
        ("omni", 1, 1200), ("motor", 4, 0), ("sonar", 2, 100), ("camera", 1, 900),
    }  # fmt: skip
    assert verdict.robots == ("striker",) * 3


@pytest.mark.parametrize(
    ("text", "code", "path"),
    [
        (design(devices=", a: {device: camera}, b: {device: camera}, k: {device: kicker}, l: {device: kicker}"),
         "over_budget", ""),
        (design(", wheel_ring_m: 0.06"), "too_wide", "chassis"),
        (design(", size_m: 0.11"), "too_high", "chassis"),
        (design(", mass_kg: 0.39"), "too_heavy", "chassis"),
        (design(", jaws_m: [0.009, 0.05]"), "mouth", "chassis.jaws_m"),
        (design(", shape: box"), "not_allowed", "chassis.shape"),
        (
            TWO_WHEELS, "not_allowed", "chassis",
        ),
        (design(devices=", gps: {device: gps}"), "not_allowed", "devices.gps"),
        (design(devices="".join(f", s{n}: {{device: sonar, bearing_rad: 0}}" for n in range(9))), "too_many", "devices"),
        (design(devices=", s: {device: sonar, bearing_rad: 0, range_m: 2}"), "out_of_range", "devices.s.range_m"),
        (design(devices=", s: {device: sonar, bearing_rad: 0, range_m: 0.05}"), "out_of_range", "devices.s.range_m"),
        (design(devices=", s: {device: sonar, bearing_rad: 0, noise: 0}"), "out_of_range", "devices.s.noise"),
        (design(devices=", c: {device: camera, width: 96}"), "out_of_range", "devices.c.width"),
        (design(", grip: 1"), "out_of_range", "chassis.grip"),
        (design(", wheels_at_rad: [0, 3.1416, 0, 0]"), "cannot_drive", "chassis.wheels_at_rad"),
        (design(", jaws_m: [0.005, 0.07]"), "contradiction", "chassis.jaws_m"),
        (design(devices=", m: {device: motor, wheel: 7}"), "contradiction", "devices.m.wheel"),
        (design(devices=", c: {device: camera, ahead_m: 0.05}"), "outside", "devices.c"),
        (design(devices=", c: {device: camera, height_m: 0.2}"), "outside", "devices.c"),
        (design(devices=", team emitter: {device: motor, wheel: 0}"), "name_taken", "devices.team emitter"),
        (design(more="robots: [striker, striker]\n"), "robots", "robots"),
        (design(more="robots: [striker, striker, goalie]\n"), "unknown_design", "robots[2]"),
    ],
)  # fmt: skip
def test_what_is_wrong_has_a_code_and_a_place(text, code, path):
    assert codes(judged(text)) == [(f"design.{code}", path)]


def test_all_that_is_wrong_is_found_at_once():
    found = codes(judged(design(", mass_kg: 1, shape: box, size_m: 0.2", ", gps: {device: gps}")))
    assert {code for code, _ in found} == {
        f"design.{one}" for one in ("too_heavy", "not_allowed", "too_wide", "too_high")
    }


def test_too_many_designs():
    text = (
        design()
        + design().split("designs:\n")[1].replace("striker", "a")
        + design().split("designs:\n")[1].replace("striker", "b")
    )
    assert [code for code, _ in codes(judged(text + "robots: [striker, a, b]\n"))] == ["design.too_many"]


def test_wheel_without_a_motor_is_a_warning():
    verdict = judged(design().replace(f", {FOURTH}", ""))
    assert verdict.problems == []
    assert [one.code for one in verdict.warnings] == ["design.no_motor"]


HOSTILE = {
    "1 MB": b"a" * 1_000_000,
    "deep": b"[" * 60_000,
    "many devices": ("design_version: 1\ndesigns: {a: {devices: {" + ", ".join(f"d{n}: {{device: gps}}" for n in range(2500)) + "}}}").encode(),
    "many keys": ("designs: {" + ", ".join(f"k{n}: 1" for n in range(5000)) + "}").encode(),
    "aliases": b"a: &a [1, 1]\nb: &b [*a, *a]\nc: [*b, *b]\n",
    "nan": design(", size_m: .nan").encode(),
    "infinite": design(", size_m: .inf").encode(),
    "huge number": design(", size_m: 1" + "0" * 5000).encode(),
    "control characters": design(devices=', "a\\x1b[31mb": {device: gps}').encode(),
    "raw control characters": b"a: \x1b[31m",
    "not UTF-8": b"\xff\xfe\x00",
    "empty": b"",
    "a list": b"- 1",
    "another version": design().replace("design_version: 1", "design_version: 2").encode(),
    "true as a number": design(", size_m: true").encode(),
    "unknown key": design(", turbo: 9").encode(),
    "unknown device": design(devices=", x: {device: laser}").encode(),
    "a tag": b"!!python/object/apply:os.system ['echo']",
    "extends": b"extends: match\n",
}  # fmt: skip


@pytest.mark.parametrize("data", HOSTILE.values(), ids=HOSTILE)
def test_hostile_file_is_refused_within_a_second(data):
    began = time.process_time()
    verdict = judged(data)
    assert time.process_time() - began < 1
    assert {one.code for one in verdict.problems} == {"design.unreadable"}
    assert all(len(str(one)) < 3000 and "\x1b" not in str(one) for one in verdict.problems)


def test_file_as_large_as_allowed_is_judged_within_a_second():
    text = design()
    began = time.process_time()
    judged(text + "#" * (MAX_BYTES - len(text)))
    assert time.process_time() - began < 1


@pytest.mark.parametrize(
    ("wrong", "code", "path"),
    [
        ("drives: {hover: {}}", "unknown-word", "guidelines.workshop.drives.hover"),
        ("devices: {laser: {}}", "unknown-word", "guidelines.workshop.devices.laser"),
        ("devices: {sonar: {limits: {colour: {most: 1}}}}", "unknown-name", "guidelines.workshop.devices.sonar.limits.colour"),
        (
            "devices: {sonar: {limits: {range_m: {prices: [[1, 0], [0.5, 10]]}}}}", "wrong-value",
            "guidelines.workshop.devices.sonar.limits.range_m.prices",
        ),
    ],
)  # fmt: skip
def test_guidelines_with_mistakes_are_refused(wrong, code, path):
    with pytest.raises(ScenarioError) as caught:
        load_text(GUIDELINES, [f"guidelines.workshop.{wrong.replace(': ', '=', 1)}"])
    assert (code, path) in [(one.code, one.where.path) for one in caught.value.diagnostics]


def test_seat_with_a_guideline_that_does_not_exist_is_refused():
    with pytest.raises(ScenarioError) as caught:
        load_text(GUIDELINES.replace("blue: {design: workshop}", "blue: {design: workshed}"))
    assert [(one.code, one.where.path) for one in caught.value.diagnostics] == [
        ("unknown-name", "entrants.blue.design")
    ]


def documented_guideline():
    words = (DOCS / "words" / "devices.yaml").read_text("utf-8").split("--- # ")
    example = next(part for part in words if part.startswith("guidelines"))
    return load_text(GUIDELINES.partition("guidelines:")[0] + example.partition("\n")[2]).scenario.guidelines[
        "workshop"
    ]


def test_design_in_the_documentation_is_within_the_guidelines_in_the_reference():
    page = (DOCS / "design-a-robot.md").read_text("utf-8")
    text = page.partition("```yaml\n")[2].partition("```")[0]
    verdict = judge_designs(text.encode(), documented_guideline(), 3, 0.021, {})
    assert [str(one) for one in verdict.problems + verdict.warnings] == []
    cost = sum(one.points for one in verdict.prices("striker"))
    assert f"striker costs {cost} of 3000: 1 omni 1200, 1 kicker 400, 1 compass 150 and 1 sonar 50" in page
