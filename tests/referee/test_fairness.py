"""Neither the order of rules in the file nor the order of teams decides what a tick brings."""

from collections.abc import Set as AbstractSet
from typing import NamedTuple

import pytest
from hypothesis import given
from hypothesis import strategies as st

SECTIONS = """
phases: {pause: {lasts_s: 0.16, next: play}}
counters: {touches: {}, by: {per: robots}, ticks: {}, rests: {}, far_m: {per: robots, keeps: highest}, stays: {}}
flags: {booked: {per: entrants}}
timers: {rest: {lasts_s: 0.16}, held: {per: entrants, while: [{entity: each, touching: ball}]}}
sequences: {way: {entity: ball, steps: [left, right]}}
"""
RULES = (
    "touched: {triggers: [{trigger: touches, entity: robots, other: ball, apart_s: 0}], actions: [{action: count, counter: touches}]}",
    (
        "by_each: {for_each: robots, phases: any, triggers: [{trigger: touches, entity: each, other: ball, apart_s: 0}], "
        "actions: [{action: count, counter: by, entity: each}]}"
    ),
    "stops: {triggers: [{trigger: touches, entity: Y1, other: ball, apart_s: 0}], actions: [{action: set_phase, phase: pause}]}",
    "goal: {triggers: [{trigger: enters, entity: ball, zone: middle}], actions: [{action: score, entrant: yellow}]}",
    "beat: {triggers: [{trigger: time_reached, at_s: 0.096, every_s: 0.096}], actions: [{action: count, counter: ticks}]}",
    "again: {triggers: [{trigger: enters, entity: ball, zone: right}], actions: [{action: timer, timer: rest}]}",
    "rested: {phases: any, triggers: [{trigger: timer_expired, timer: rest}], actions: [{action: count, counter: rests}]}",
    "back: {phases: any, triggers: [{trigger: phase_entered, phase: play, from: pause}], actions: [{action: emit, event: BACK}]}",
    (
        "far: {for_each: robots, triggers: [{trigger: displaced, entity: each, distance_m: 0.1, angle_rad: 0.5}], "
        "actions: [{action: count, counter: far_m, to: {distance: [each, ball]}}]}"
    ),
    "stay: {triggers: [{trigger: stays_in, entity: ball, zone: left, limit_s: 0.064}], actions: [{action: count, counter: stays}]}",
    "way: {triggers: [{trigger: sequence_completed, sequence: way}], actions: [{action: remove, entity: Y2, for_s: 0.096}]}",
    (
        "books: {for_each: entrants, triggers: [{trigger: holds, conditions: [{timer: held, at_least: 0.064}]}], "
        "actions: [{action: set_flag, flag: booked}]}"
    ),
)
ROBOTS = ("B1", "B2", "Y1", "Y2")
PLACES = ((0.0, 0.0), (0.3, 0.0), (-0.3, 0.0))
POINTS = ((0.4, 0.5), (0.05, 0.0), (-0.2, 0.3))


class Step(NamedTuple):
    """What happens in a tick: which robots touch the ball, where it is put, which two touch, and how one is moved."""

    touching: AbstractSet[str] = frozenset()
    ball: tuple[float, float] | None = None
    clash: tuple[str, str] | None = None
    moved: tuple[str, tuple[float, float], float] | None = None

    def exchanged(self) -> "Step":
        """Return the same of the other team, turned by half a turn around the centre."""
        ball = None if self.ball is None else _turned(self.ball)
        clash = None if self.clash is None else (EXCHANGED[self.clash[0]], EXCHANGED[self.clash[1]])
        moved = None if self.moved is None else (EXCHANGED[self.moved[0]], _turned(self.moved[1]), self.moved[2])
        return Step({EXCHANGED[robot] for robot in self.touching}, ball, clash, moved)


def _turned(point):
    return -point[0], -point[1]


EXCHANGED = {"B1": "Y1", "B2": "Y2", "Y1": "B1", "Y2": "B2", "blue": "yellow", "yellow": "blue"}
SCRIPT = st.lists(
    st.builds(
        Step,
        st.sets(st.sampled_from(ROBOTS), max_size=2),
        st.none() | st.sampled_from(PLACES),
        st.none() | st.sampled_from([(one, other) for one in ROBOTS for other in ROBOTS if one < other]),
        st.none() | st.tuples(st.sampled_from(ROBOTS), st.sampled_from(POINTS), st.sampled_from((0.0, 0.3, -1.0))),
    ),
    max_size=25,
)


def played(stage, script, *sections):
    play = stage(*sections)
    starts = {robot: play.pose(robot)[2] for robot in ROBOTS}
    for step in script:
        for robot in sorted(step.touching):
            play.touch(robot, "ball")
        if step.ball is not None:
            play.place("ball", *step.ball)
        if step.clash is not None:
            play.touch(*step.clash)
        if step.moved is not None:
            robot, place, turn_rad = step.moved
            play.place(robot, *place, starts[robot] + turn_rad)
        play.play()
    play.finish()
    return play


@given(script=SCRIPT, order=st.permutations(RULES))
def test_rules_that_share_no_written_state_may_stand_in_any_order(stage, script, order):
    def log(rules):
        play = played(stage, script, SECTIONS, f"rules: {{{', '.join(rules)}}}")
        return sorted((one.tick, one.rule, one.entity or "", one.suppressed or "") for one in play.firings)

    assert log(order) == log(RULES)


DUEL = """
phases: {pause: {lasts_s: 0.16, next: play}}
rules:
  blue_touches:
    triggers: [{trigger: touches, entity: blue, other: ball, apart_s: 0}]
    actions: [{action: score, entrant: blue}, {action: set_phase, phase: pause}]
  yellow_touches:
    triggers: [{trigger: touches, entity: yellow, other: ball, apart_s: 0}]
    actions: [{action: score, entrant: yellow}, {action: set_phase, phase: pause}]
  wins_the_middle:
    triggers: [{trigger: enters, entity: ball, zone: middle}]
    actions: [{action: score, entrant: blue, points: 2}, {action: score, entrant: yellow, points: 2}]
"""
TEAMS = """
zones: {home_blue: {shape: rect, y_min_m: 0.25}, home_yellow: {shape: rect, y_max_m: -0.25}}
groups: {homes: [home_blue, home_yellow]}
phases: {pause: {lasts_s: 0.096, next: play}}
counters: {hits: {per: robots}, sets: {per: entrants}, far_m: {per: robots, keeps: highest}, in_home: {per: homes}}
flags: {booked: {per: robots}}
timers: {near: {per: entrants, while: [{distance: [each, ball], below: 0.3}]}, rest: {per: robots, lasts_s: 0.096}}
sequences: {way: {per: robots, steps: [home_blue, home_yellow], order: any}}
rules:
  hit:
    for_each: robots
    triggers: [{trigger: touches, entity: each, other: ball, apart_s: 0}]
    actions: [{action: count, counter: hits}, {action: timer, timer: rest}]
  set:
    for_each: entrants
    triggers: [{trigger: holds, conditions: [{sum: {counter: hits, entity: each}, at_least: 3}]}]
    actions:
      - {action: count, counter: sets}
      - {action: count, counter: hits, entity: each, to: 0}
      - {action: set_phase, phase: pause}
  ahead:
    for_each: entrants
    priority: 1
    triggers: [{trigger: phase_entered, phase: play}, {trigger: time_reached, at_s: 0.16, every_s: 0.16}]
    conditions: [{counter: sets, above: {counter: sets, entity: others}}]
    actions: [{action: score, entrant: each}]
  foul:
    for_each: robots
    cooldown_s: 0.064
    triggers: [{trigger: touches, entity: each, other: others}]
    conditions: [{entity: each, in: middle}]
    actions: [{action: score, entrant: other}, {action: set_flag, flag: booked}]
  sent_off:
    for_each: robots
    triggers: [{trigger: timer_expired, timer: rest}]
    conditions: [{flag: booked}]
    actions: [{action: remove, entity: each, for_s: 0.16}, {action: set_flag, flag: booked, to: false}]
  far:
    for_each: robots
    triggers: [{trigger: displaced, entity: each, distance_m: 0.1, angle_rad: 0.5}]
    actions: [{action: count, counter: far_m, to: {distance: [each, ball]}}]
  home: {for_each: homes, triggers: [{trigger: enters, entity: ball, zone: each}], actions: [{action: count, counter: in_home}]}
  way:
    for_each: robots
    triggers: [{trigger: sequence_completed, sequence: way}]
    actions: [{action: score, entrant: each, points: 3}]
  near:
    for_each: entrants
    triggers: [{trigger: half_ended}]
    actions: [{action: score, entrant: each, points: {timer: near}}]
"""
EXCHANGED |= {
    "home_blue": "home_yellow",
    "home_yellow": "home_blue",
    "blue_touches": "yellow_touches",
    "yellow_touches": "blue_touches",
}


def result_of(play, names):
    """Return the log up to order, the scores and what is kept, by names as given."""

    def named(one):
        return names.get(one, one)

    log = sorted(
        (
            one.tick,
            named(one.rule),
            *(named(name) or "" for name in (one.entity, one.other, one.place)),
            one.suppressed or "",
        )
        for one in play.firings
    )
    kept = {
        name: {named(owner): value for owner, value in values.items()} if isinstance(values, dict) else values
        for name, values in (play.referee._state.counters | play.referee._state.flags).items()
    }
    return log, {named(seat): points for seat, points in play.referee.scores.items()}, kept


@given(script=SCRIPT)
@pytest.mark.parametrize("sections", [DUEL, TEAMS], ids=["duel", "teams"])
def test_exchanging_the_teams_and_mirroring_what_happens_exchanges_the_result(stage, script, sections):
    mirrored = [step.exchanged() for step in script]
    assert result_of(played(stage, mirrored, sections), {}) == result_of(played(stage, script, sections), EXCHANGED)
