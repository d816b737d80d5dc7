"""Nothing is put outside the field, however far out a placement, its noise or its zone leads."""

from __future__ import annotations

import pytest

from rcj_challenges.referee.bodies import Bodies
from rcj_challenges.scenario.roster import Roster
from tests.referee.conftest import small_scenario

FAR = """
zones: {{wide: {{shape: circle, centre_m: [400, 0], radius_m: 100}}}}
spots: {{away: {{x_m: 30, y_m: 0}}}}
rules:
  put:
    triggers: [{{trigger: time_reached, at_s: 0.32}}]
    actions: [{{action: place, entity: Y1, at: {at}, max_attempts: 3}}]
    says: It is put there.
"""


@pytest.mark.parametrize(
    "at",
    [
        "{point: [30, 20]}",
        "{spot: away}",
        "{choice: [[0, 25], [0, -25]]}",
        "{on_line: [[12, 0], [40, 0]]}",
        "{uniform_in: wide}",
        "{relative_to: B1, offset_m: [0, 30]}",
        "{nearest_free: [away]}",
    ],
)
def test_a_place_far_outside_is_no_room(stage, at):
    play = stage(FAR.format(at=at))
    before = play.pose("Y1")
    play.play(12)
    assert play.pose("Y1") == before
    assert [firing.suppressed for firing in play.firings] == [None, "no_room"]


@pytest.mark.parametrize("direction", [(1, 0), (-1, 0), (0, 1), (0, -1), (1, 1)])
def test_no_distance_from_the_field_is_free_again(direction):
    scenario = small_scenario()
    roster = Roster.of(scenario)
    bodies = Bodies(scenario, roster)
    for distance_m in (0.9, 2.0, 9.0, 10.5, 11.0, 100.0, 1e6):
        pose = (direction[0] * distance_m, direction[1] * distance_m, 0.0)
        for name in ("Y1", "ball"):
            assert not bodies.fits(roster.index[name], pose, {}, 0.0)


def test_in_a_goal_there_is_still_room():
    scenario = small_scenario()
    roster = Roster.of(scenario)
    y_m = scenario.field.length_m / 2 + 0.05
    assert Bodies(scenario, roster).fits(roster.index["ball"], (0.0, y_m, 0.0), {}, 0.0)
