"""Lint of kicks, and of sequences that are only begun anew."""

import pytest

from tests.scenario.writing import findings, rule

PLACE = "{action: place, entity: ball, at: %s, kick: {towards: %s, speed_mps: 0.6}%s}"


def kicks(at, towards, more=""):
    return [text for text in findings(rule(action=PLACE % (at, towards, more))) if "kick" in text]


@pytest.mark.parametrize("place", ["{point: [0, 0.1]}", "{spot: centre}", "start", "{relative_to: Y1}"])
def test_a_ball_that_is_aimed_at_its_own_place_has_no_way_to_go(place):
    (text,) = kicks(place, place)
    assert text.endswith(
        "rules.r.actions[0] (place): the ball is aimed at the place where it is put: it has no way to go and lies still; "
        "aim it elsewhere, or leave kick out [kick_without_a_way]"
    )


@pytest.mark.parametrize(
    ("at", "towards", "more"),
    [
        ("{point: [0, 0.1]}", "{point: [0, 0.2]}", ""),
        ("{point: [0, 0.1]}", "{point: [0, 0.1]}", ", noise_m: [0.1, 0]"),
        ("{on_line: [[-0.1, 0], [0.1, 0]]}", "{on_line: [[-0.1, 0], [0.1, 0]]}", ""),
        ("{spot: centre}", "{relative_to: centre, offset_m: [0, 0.1]}", ""),
    ],
)
def test_any_other_aim_is_fine(at, towards, more):
    assert kicks(at, towards, more) == []


def test_a_zone_that_a_kick_is_aimed_at_is_used():
    zone = "zones: {corner: {shape: circle, centre_m: [0.4, 0.4], radius_m: 0.1}}\n"
    assert "zone_never_used" in " ".join(findings(zone + rule()))
    used = findings(zone + rule(action=PLACE % ("start", "{uniform_in: corner}", "")))
    assert "zone_never_used" not in " ".join(used)


def test_a_sequence_that_is_only_begun_anew_is_never_used():
    way = "sequences: {way: {entity: ball, steps: [blue_goal, yellow_goal]}}\n"
    assert "sequence_never_used" in " ".join(findings(way + rule(action="{action: sequence, sequence: way}")))
