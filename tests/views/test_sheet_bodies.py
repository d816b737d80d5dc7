"""What a rule sheet says of bodies, surfaces and limits: what a team cannot measure before it plays."""

from __future__ import annotations

import pytest

from rcj_challenges.rules.phrasing import degrees, number
from tests.views.sheets import sheet

pytestmark = pytest.mark.usefixtures("without_drawing")

IDLE = """
kits:
  wide:
    chassis: {size_m: 0.2, mass_kg: 3, wheel_radius_m: 0.03, wheel_width_m: 0.02, wheel_track_m: 0.25, wheel_mass_kg: 0.5}
robots: {B3: {kit: wide, idle: true}}
entrants: {blue: {robots: {B3: null}}}
"""


def test_a_kit_tells_what_its_body_weighs_and_measures():
    text = sheet(
        "kits: {v2: {chassis: {mass_kg: 1.5, wheel_mass_kg: 0.02, wheel_track_m: 0.1, max_wheel_radps: 20}}}\n"
    )
    assert (
        "A cube of 7.5 cm on two wheels; its mass is 1.5 kg, and 0.02 kg that of each wheel. The wheels have a radius of 2 "
        "cm, are 1 cm wide and 10 cm apart, from centre to centre; top speed 0.4 m/s at 20 rad/s.\n"
    ) in text


def test_robots_that_stand_as_obstacles_have_a_body_but_no_devices():
    text = sheet(IDLE)
    kit = text[text.index("### Kit wide\n") :].split("\n## ")[0]
    assert "A cube of 0.2 m on two wheels; its mass is 3 kg" in kit
    assert "radius of 3 cm, are 2 cm wide and 25 cm apart" in kit
    assert "| device |" not in kit
    assert "Programs" not in kit


def test_a_kit_whose_pictures_show_its_front_at_the_other_end_says_so():
    assert "Pictures show its front at the other end" in sheet("kits: {v2: {looks_along: '-x'}}\n")
    assert "at the other end" not in sheet("")


def test_the_table_of_robots_tells_their_starts_and_how_far_chance_shifts_them():
    text = sheet(
        "robots: {B1: {start: {x_m: 0.1, y_m: 0, yaw_rad: 2, noise_m: [0.2, 0]}}, B2: {start: {noise_m: [0, 0]}}}\n"
    )
    assert (
        "| B1 | blue | program of blue | v2 | (0.1, 0), ± 0.2 m in x, facing 114.6° counter-clockwise from +x |" in text
    )
    assert "| B2 | blue | program of blue | v2 | (-0.3, 0.3), facing 90° clockwise from +x |" in text
    assert text.count("Where ± stands, chance shifts a start by up to that much to either side") == 1
    still = "".join(f"  {name}: {{start: {{noise_m: [0, 0]}}}}\n" for name in ("B1", "B2", "B3", "Y1", "Y2", "Y3"))
    assert "±" not in sheet(f"robots:\n{still}")


def test_the_field_tells_how_floor_and_walls_are():
    text = sheet("field: {friction: 0.3, restitution: 0.85}\n")
    floor = "The floor's coefficient of friction is 0.3."
    assert f"{floor} A ball springs back from a wall with 85 % of the speed at which it meets it." in text
    assert f"{floor}\n" in sheet("field: {friction: 0.3}\nballs: {ball: null}\n")
    assert f"{floor} A ball does not spring back from a wall." in sheet("field: {friction: 0.3, restitution: 0}\n")


def test_all_limits_are_told():
    usual = sheet("")
    assert (
        "1024 MB of memory, 32 MB of output, 64 MB of files in its own folder and 32 threads beside its first one. A program "
        "that exceeds one stops for the rest of the half.\n\nA radio packet of more than 1024 kB is not sent.\n"
    ) in usual
    assert "processor time" not in usual
    text = sheet("limits: {processor_s: 90, scratch_mb: 2.5, processes: 1, message_kb: 0.25}\n")
    assert "(its own CPU time and idle time), 90 s of processor time in a half, 1024 MB" in text
    assert "2.5 MB of files in its own folder and 1 thread beside its first one." in text
    assert "A radio packet of more than 0.25 kB is not sent." in text


def test_without_a_radio_nothing_is_said_of_its_packets():
    deaf = "".join(f"  {name}: {{without: [team emitter]}}\n" for name in ("B1", "B2", "B3", "Y1", "Y2", "Y3"))
    assert "radio packet" not in sheet(f"robots:\n{deaf}")


ANEW = "Where a rule begins the phase that is on already, that phase begins anew: with all of its time"


@pytest.mark.parametrize(
    ("phases", "count"), [("[play]", 0), ("[play, pause]", 1), ("any", 1), ("[pause]", 1), ("[other]", 0)]
)
def test_that_a_phase_can_begin_anew_is_said_where_a_rule_may_begin_the_one_that_is_on(phases, count):
    text = sheet(
        "phases: {pause: {lasts_s: 2}, other: {}}\n"
        f"rules: {{it: {{phases: {phases}, triggers: [{{trigger: enters, entity: ball, zone: blue_goal}}], "
        "actions: [{action: set_phase, phase: pause}]}}\n"
    )
    assert text.count(ANEW) == count


def test_a_time_is_over_on_the_first_tick_on_which_it_has_passed():
    assert "every tick of 32 ms; a time is over on the first tick on which it has passed." in sheet("")


@pytest.mark.parametrize(
    ("value", "told"),
    [
        (1_000_000, "1000000"),
        (1_234_567, "1234567"),
        (1234567.25, "1234567.25"),
        (1e15, "1000000000000000"),
        (0.1 + 0.2, "0.3"),
        (0.00001, "0.00001"),
        (-0.0, "0"),
        (-2.5, "-2.5"),
        (0, "0"),
        (1e-12, "1e-12"),
        (1e300, "1e+300"),
    ],
)
def test_a_number_has_all_its_digits(value, told):
    assert number(value) == told


def test_a_million_points_are_told_as_people_write_them():
    text = sheet(
        "rules: {it: {triggers: [{trigger: half_started}], actions: [{action: score, entrant: blue, points: 1234567}]}}\n"
    )
    assert "blue gets 1234567 points" in text


@pytest.mark.parametrize(
    ("angle_rad", "told"), [(2.0, "114.6°"), (3.14, "179.9°"), (1.57, "90°"), (0.3927, "22.5°"), (0.0123, "0.705°")]
)
def test_an_angle_is_told_to_a_tenth_of_a_degree(angle_rad, told):
    assert degrees(angle_rad) == told


def test_half_2_at_least_and_at_most_is_half_2():
    text = sheet(
        "match: {halves: 3}\nrules: {it: {triggers: [{trigger: enters, entity: ball, zone: blue_goal}], "
        "conditions: [{condition: half, at_least: 2, at_most: 2}], actions: [{action: end}]}}\n"
    )
    assert "provided that it is half 2: the half ends" in text


@pytest.mark.parametrize(
    ("device", "words"),
    [
        ("{device: lidar, points: 1}", "lidar, 1 point, 1 cm"),
        ("{device: lidar, points: 2}", "lidar, 2 points, 1 cm"),
        ("{device: team_emitter, baud: 250}", "250 baud (1 byte in a tick)"),
    ],
)
def test_one_is_told_in_the_singular(device, words):
    assert words in sheet(f"robots: {{Y1: {{devices: {{it: {device}}}}}}}\n")
