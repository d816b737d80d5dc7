"""Fixed obstacles: what never moves can be touched, keep something of its own, and have a rule each."""

from math import pi
from textwrap import dedent

import pytest

from tests.referee.building import emitting, payload, payloads, place, touch

POLES = """
obstacles:
  crate: {shape: box, centre_m: [0.5, 0], size_m: [0.05, 0.05], movable: true}
  p1: {shape: cylinder, centre_m: [0.2, 0], radius_m: 0.02}
  p2: {shape: box, centre_m: [-0.2, 0], size_m: [0.04, 0.04], yaw_rad: 0.5}
  fence: {shape: wall, from_m: [-0.3, 0.3], to_m: [0.3, 0.3]}
groups: {poles: [p1, p2], marks: [crate, p1]}
"""
ONCE = (
    POLES
    + """
flags: {touched: {per: poles}}
rules:
  hit:
    triggers: [{trigger: touches, entity: robots, other: poles}]
    conditions: [{flag: touched, entity: other, negate: true}]
    actions: [{action: set_flag, flag: touched, entity: other}, {action: score, entrant: yellow, points: -1}]
"""
)
EACH = (
    POLES
    + """
counters: {hits: {per: poles}}
timers: {rest: {lasts_s: 0.5, per: poles}}
rules:
  hit:
    for_each: poles
    max_executions: 1
    triggers: [{trigger: touches, entity: %s, other: %s}]
    actions:
      - {action: count, counter: hits, entity: each}
      - {action: timer, timer: rest, entity: each, do: restart}
      - {action: emit, event: HIT, payload: {pole: {word: each_name}, who: {word: robot_name}, team: {word: entrant}}}
    says: '{entity} was touched.'
  heard:
    for_each: poles
    triggers: [{trigger: event, event: HIT, entity: each}]
    actions: [{action: emit, event: HEARD, payload: {pole: {word: each_name}}}]
  rested:
    triggers: [{trigger: timer_expired, timer: rest}]
    actions: [{action: emit, event: RESTED, payload: {pole: {word: entity_name}}}]
"""
)


class TestWhatTheyKeep:
    def test_each_touched_pole_counts_once(self, stage):
        play = stage(ONCE)
        play.play()
        for robot, pole in (("Y1", "p2"), ("Y1", "p2"), ("B1", "p2"), ("Y1", "p1")):
            touch(play, robot, pole, ticks=2)
        assert play.referee.scores["yellow"] == -2
        assert play.referee.flags["touched"] == {"p1": True, "p2": True}


@pytest.mark.parametrize(("entity", "other"), [("robots", "each"), ("each", "robots")])
def test_a_rule_for_each_counts_fires_emits_and_starts_the_timer_of_the_one_touched(stage, entity, other):
    play = stage(EACH % (entity, other))
    play.play()
    for pole in ("p1", "p1", "p2"):
        touch(play, "Y2", pole, ticks=2)
    play.play(20)
    assert play.referee.counters["hits"] == {"p1": 1, "p2": 1}
    hits = [firing for firing in play.firings if firing.rule == "hit" and firing.suppressed is None]
    assert [(firing.entity, firing.place, firing.says) for firing in hits] == [
        ("p1", None, "p1 was touched."),
        ("p2", None, "p2 was touched."),
    ]
    for event in ("HIT", "HEARD", "RESTED"):
        assert [payload["pole"] for payload in payloads(play, event)] == ["p1", "p2"]


class TestWhoTouches:
    def test_a_robot_is_named_if_it_is_written_first(self, stage):
        play = stage(EACH % ("robots", "each"))
        play.play()
        touch(play, "Y2", "p1")
        (hit,) = play.events_named("HIT")
        assert (hit.payload["who"], hit.payload["team"]) == ("Y2", "yellow")

    def test_the_last_to_touch_it_is_known_and_asked_for(self, stage):
        play = stage(
            POLES
            + """
rules:
  taken:
    triggers: [{trigger: touches, entity: robots, other: p1}]
    actions: [{action: score, entrant: {last_touch: p1}}, {action: emit, event: WHO, payload: {a: {last_touch: p1}}}]
  kept:
    triggers: [{trigger: holds, for_s: 0.5, conditions: [{last_touch: p1, equals: yellow}]}]
    actions: [{action: emit, event: KEPT}]
"""
        )
        play.play()
        for robot in ("B1", "Y1"):
            touch(play, robot, "p1", ticks=2)
        assert [payload["a"] for payload in payloads(play, "WHO")] == ["B1", "Y1"]
        assert play.referee.scores == {"blue": 1, "yellow": 1}
        play.place("Y1", 0.0, -0.6)  # a placed robot has touched it all the same
        play.play(20)
        assert len(play.events_named("KEPT")) == 1


class TestWhereTheyAre:
    def reported(self, stage, value):
        return payload(stage(POLES + dedent(emitting(f"{{a: {value}}}"))))["a"]

    @pytest.mark.parametrize(
        ("named", "expected"),
        [
            ("p1", [0.2, 0.0, 0.0]), ("p2", [-0.2, 0.0, 0.5]), ("fence", [0.0, 0.3, 0.0]), ("crate", [0.5, 0.0, 0.0]),
        ],
    )  # fmt: skip
    def test_a_position_is_that_of_the_file(self, stage, named, expected):
        assert self.reported(stage, f"{{position_of: {named}}}") == pytest.approx(expected, abs=1e-6)

    @pytest.mark.parametrize(
        ("ends", "expected"),
        [
            ("[p1, p2]", 0.4), ("[[0.2, 0.5], p1]", 0.5), ("[p1, crate]", 0.3), ("[[0, 0], poles]", 0.2),
            ("[[0.1, 0.1], fence]", 0.2), ("[fence, [0.4, 0.3]]", 0.1), ("[fence, p1]", 0.3), ("[fence, crate]", 0.361),
        ],
    )  # fmt: skip
    def test_distances_are_measured_to_the_centre_of_a_wall_to_its_middle_line(self, stage, ends, expected):
        assert self.reported(stage, f"{{distance: {ends}}}") == pytest.approx(expected, abs=1e-3)

    def test_nearness_and_looks_can_be_asked_for_each(self, stage):
        near = "{distance: [Y1, each], at_most: 0.1}"
        look = "{entity: Y1, looks: each, within_rad: 0.1}"
        play = stage(
            POLES
            + f"""
spots: {{seen: {{x_m: 0, y_m: 0}}}}
rules:
  near:
    for_each: poles
    triggers: [{{trigger: holds, conditions: [{near}]}}]
    conditions: [{look}]
    actions: [{{action: set_spot, spot: seen, to: each}}, {{action: emit, event: NEAR, payload: {{a: {{word: each_name}}}}}}]
"""
        )
        play.play()
        place(play, "Y1", -0.2, 0.2, -pi / 2, ticks=2)
        place(play, "Y1", -0.2, 0.09, -pi / 2)
        play.place("Y1", 0.2, 0.09, 0.0)  # near the other one, but it does not look there
        play.play()
        assert [event.payload["a"] for event in play.events_named("NEAR")] == ["p2"]
