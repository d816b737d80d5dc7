"""What finds no room is said once, in the referee's own log and beside a test that fails; the reflog stays as it is."""

import pytest

from rcj_challenges.expect.runner import run_test
from rcj_challenges.referee.bodies import Bodies
from rcj_challenges.referee.engine import Referee
from rcj_challenges.referee.placement import ATTEMPTS_WAITING
from rcj_challenges.scenario.load import load_text
from tests.referee.building import at_tick_10, place


def put(where: str, more: str = "", entity: str = "Y1") -> str:
    """Return rules that put something somewhere at 0.32 s and say so."""
    return f"""
rules:
  put:
    triggers: [{{trigger: time_reached, at_s: 0.32}}]
    actions: [{{action: place, entity: {entity}, at: {{{where}}}{more}}}, {{action: emit, event: PUT}}]
    says: It is put there.
"""


def notes(play) -> list[str]:
    """Return what the log says of things without room."""
    return [firing.says for firing in play.firings if firing.suppressed == "no_room"]


def test_what_waits_for_room_is_in_the_log_once_with_what_is_in_the_way(stage):
    play = stage(put("point: [0, 0]"))
    play.play(100)
    (line,) = [firing for firing in play.firings if firing.suppressed is not None]
    assert (line.tick, line.rule, line.entity, line.trigger, line.suppressed) == (10, "put", "Y1", "place", "no_room")
    assert line.says == "Y1 waits for room: ball is there"
    assert line.scored == {}
    assert play.names() == ["PUT"]


NARROW = "zones: {strip: {shape: rect, x_min_m: -0.05, x_max_m: 0.05, y_min_m: -0.01, y_max_m: 0.01}}"
HOLE = "zones: {hole: {shape: circle, centre_m: [0, 0], radius_m: 0.01}}"
HERE = "spots: {here: {x_m: 0, y_m: 0.2}}"


@pytest.mark.parametrize(
    ("sections", "poses", "note"),
    [
        ([put("point: [0, 0]", ", on_failure: stay")], {}, "Y1 stays where it is for want of room: ball is there"),
        ([put("point: [0.64, 0]")], {}, "Y1 waits for room: a wall or a fixed obstacle is there"),
        (
            [put("point: [0, 0]", ", min_clearance_m: 0.02")],
            {"B1": (0, 0.09)},
            "Y1 waits for room: B1 and ball are nearer than 0.02 m",
        ),
        ([HERE, put("nearest_free: [here]")], {"ball": (0, 0.2)}, "Y1 waits for room: no spot is free"),
        ([HOLE, put("uniform_in: hole")], {}, "Y1 waits for room: chance found none in 100 attempts"),
        ([put("point: [0.3, 0]", entity="[Y1, Y2]")], {}, "Y2 waits for room: Y1 is there"),
        (
            [HERE, put("point: [0.2, 0]", ", kick: {towards: {nearest_free: [here]}, speed_mps: 1}", entity="ball")],
            {"Y1": (0, 0.2)},
            "ball waits for room: its kick finds nothing to aim at",
        ),
    ],
)
def test_the_log_states_why_there_is_no_room(stage, sections, poses, note):
    play = stage(*sections)
    for entity, (x_m, y_m) in poses.items():
        play.place(entity, x_m, y_m)
    play.play(20)
    assert notes(play) == [note]


@pytest.mark.parametrize(
    "where",
    [
        "point: [30, 20]", "spot: away", "choice: [[0, 25], [0, -25]]", "on_line: [[12, 0], [40, 0]]",
        "uniform_in: wide", "relative_to: B1, offset_m: [0, 30]", "nearest_free: [away]",
    ],
)  # fmt: skip
def test_a_place_far_outside_the_field_is_no_room(stage, where):
    far = "zones: {wide: {shape: circle, centre_m: [400, 0], radius_m: 100}}\nspots: {away: {x_m: 30, y_m: 0}}"
    play = stage(far, put(where, ", max_attempts: 3"))
    before = play.pose("Y1")
    play.play(12)
    assert play.pose("Y1") == before
    assert [firing.suppressed for firing in play.firings] == [None, "no_room"]


def test_a_late_placement_is_reported_with_the_earlier_lack_of_room(stage):
    # B1 takes the first spot, and so Y1 stays where it is; that is too near to the first spot for B1, which moves on.
    play = stage(
        "spots: {first: {x_m: 0.3, y_m: 0}, second: {x_m: 0.5, y_m: 0}}",
        """
rules:
  put:
    triggers: [{trigger: time_reached, at_s: 0.32}]
    actions:
      - {action: place, entity: B1, at: {nearest_free: [first, second], to: ball, clearance_m: 0.15}}
      - {action: place, entity: Y1, at: {point: [0.3, 0]}, on_failure: stay}
""",
    )
    place(play, "Y1", 0.2, 0, ticks=20)
    assert play.pose("B1")[:2] == pytest.approx((0.5, 0))
    assert play.pose("Y1")[:2] == pytest.approx((0.2, 0))
    assert notes(play) == ["Y1 stays where it is for want of room: there was none when it was put"]


def test_a_return_without_room_is_reported_too(stage):
    play = stage(at_tick_10("{action: remove, entity: Y1, for_s: 0.32, back_at: {point: [0, 0]}}"))
    play.play(15)
    assert notes(play) == []
    play.play(20)
    assert notes(play) == ["Y1 waits for room: ball is there"]


def test_to_look_for_the_reason_takes_nothing_from_chance(stage, monkeypatch):
    def placed(play):
        play.play(20)
        assert play.placements == []
        place(play, "ball", 0.5, 0.5, ticks=2)
        return play.pose("Y1")

    one = placed(stage(NARROW, put("uniform_in: strip", ", facing: {random: true}")))
    monkeypatch.setattr(Referee, "_log_no_room", lambda _referee, _job: None)
    assert one == placed(stage(NARROW, put("uniform_in: strip", ", facing: {random: true}")))


FILE = """schema_version: 2
id: it
title: It
extends: soccersim_v2
match: {half_s: 5}
rules:
  put:
    triggers: [{trigger: time_reached, at_s: 1}]
    actions: [{action: place, entity: Y1, at: {point: [0, 0]}}, {action: emit, event: PUT}]
    says: Y1 is put on the centre.
expect:
  it: {keyframes: [{at_s: 0.5}], lasts_s: 2, events: [{event: PUT}]%s}
"""


def test_a_failing_test_names_what_waits_for_room():
    differences = list(run_test(load_text(FILE % ", poses: {Y1: [0, 0]}"), "it").differences)
    assert len(differences) == 2
    assert differences[0].startswith("Y1: expected at (0, 0)")
    assert differences[1] == "note: from 1.024 s on Y1 waits for room: ball is there (rule put)"


def drawn_by_tick(play, monkeypatch, ticks: int) -> list[int]:
    """Return how often chance looked for a place in each tick."""
    looked = []
    fits = Bodies.fits

    def counted(*arguments):
        looked[-1] += 1
        return fits(*arguments)

    monkeypatch.setattr(Bodies, "fits", counted)
    for _ in range(ticks):
        looked.append(0)
        play.play(1)
    return looked


@pytest.mark.parametrize(("attempts", "waiting"), [(1000, ATTEMPTS_WAITING), (2, 2)])
def test_what_waits_looks_a_few_times_a_tick_for_room(stage, monkeypatch, attempts, waiting):
    play = stage(NARROW, put("uniform_in: strip", f", max_attempts: {attempts}"))
    play.play(9)
    looked = drawn_by_tick(play, monkeypatch, 4)
    assert looked == [attempts, waiting, waiting, waiting]
    assert notes(play) == [f"Y1 waits for room: chance found none in {attempts} attempts"]


def test_what_is_placed_again_makes_all_its_attempts_again(stage, monkeypatch):
    twice = put("uniform_in: strip", ", max_attempts: 30").replace(
        "0.32}", "0.32}, {trigger: time_reached, at_s: 0.384}"
    )
    play = stage(NARROW, twice)
    play.play(9)
    assert drawn_by_tick(play, monkeypatch, 4) == [30, ATTEMPTS_WAITING, 30, ATTEMPTS_WAITING]


def test_a_place_that_takes_many_attempts_is_found_at_first(stage):
    corner = NARROW.replace("x_max_m: 0.05", "x_max_m: 0.075")
    play = stage(corner, put("uniform_in: strip", ", max_attempts: 2000"))
    play.play(10)
    assert [tick for tick, _ in play.placements] == [10]
    assert play.pose("Y1")[0] > 0.07  # a thirtieth of the strip: beside the ball
