"""Triggers about ways: crosses, sequences; and the path of no_progress."""

import random
from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rcj_challenges.expect.scripted_match import ScriptedMatch, half_of
from rcj_challenges.scenario.roster import Roster
from tests.referee.building import A_LOW, B_LOW, C_LOW, SEQUENCE, A, B, C, hears, place, rule, touch, walk


def crossing(direction: str, gate: str = "halfway") -> str:
    return hears(f"crosses, entity: ball, gate: {gate}, direction: {direction}")


class TestTriggerCrosses:
    MOUTH = "gates: {mouth: {from_m: [0.1, -0.05], to_m: [0.1, 0.05], anchor: B1}}"

    # `halfway` runs from +x to -x: its left is -y, so forward is towards -y.
    @pytest.mark.parametrize(("direction", "expected"), [("forward", 1), ("backward", 2), ("either", 3)])
    def test_direction_is_seen_from_the_gate(self, stage, direction, expected):
        play = stage(crossing(direction))
        place(play, "ball", 0.1, -0.2)
        before = len(play.events)
        walk(play, "ball", (0.1, 0.2), (0.1, -0.2), (0.1, 0.2))
        assert len(play.events) - before == expected

    def test_past_the_posts_is_not_through(self, stage):
        play = stage("gates: {narrow: {from_m: [0.1, 0], to_m: [-0.1, 0]}}", crossing("either", "narrow"))
        place(play, "ball", 0.3, 0.2)
        walk(play, "ball", (0.3, -0.2), (0.12, 0.2))
        assert play.names() == []
        walk(play, "ball", (0.05, -0.2))
        assert play.names() == ["TOLD"]

    def test_a_gate_can_move_and_turn_with_an_entity(self, stage):
        play = stage(self.MOUTH, crossing("either", "mouth"))
        play.place("B1", -0.4, 0.0, 0.0)
        place(play, "ball", 0.2, 0.0)
        walk(play, "B1", (0.05, 0.0))  # the gate, 0.1 ahead, stops short of the ball
        assert play.names() == []
        walk(play, "B1", (0.15, 0.0))
        assert play.names() == ["TOLD"]

    def test_a_gate_off_the_field_is_not_crossed(self, stage):
        gone = rule("trigger: half_started", "{action: remove, entity: B1}", name="gone")
        play = stage(self.MOUTH, crossing("either", "mouth"), gone)
        place(play, "ball", 3.2, 0.0)  # where the stage parks things
        walk(play, "ball", (3.0, 0.0))
        assert play.names() == []


ONCE, CYCLIC = SEQUENCE % "cyclic: false", SEQUENCE % "cyclic: true"
BREAKS = SEQUENCE % "cyclic: false, wrong_step: break"
CYCLIC_BREAKS = SEQUENCE % "cyclic: true, wrong_step: break"
BY_GATE = ONCE.replace("[a, b, c]", "[a, high, c]")
BY_ANY = ONCE.replace("[a, b, c]", "[a, {any_of: [b, high]}, c]")
IN_FIRST = ONCE.replace("start_m: [-0.4, -0.2]", "start_m: [-0.4, 0]")
ROUND, BACK = [A, B, C], [C_LOW, A_LOW, A]


class TestTriggersOfSequences:
    @pytest.mark.parametrize(
        ("sequence", "path", "names"),
        [
            (ONCE, [A, B], []),
            (ONCE, ROUND, ["DONE"]),
            (ONCE, [A, A_LOW, C_LOW, C, B], []),  # steps out of order
            # A cyclic one is complete on re-entering its first step, which is the first of the next round.
            (CYCLIC, ROUND, []),
            (CYCLIC, [*ROUND, *BACK], ["DONE"]),
            (CYCLIC, [*ROUND, *BACK, B, C, *BACK], ["DONE", "DONE"]),
            # One that is not cyclic begins again at its first step.
            (ONCE, [*ROUND, C_LOW, B_LOW, B, C], ["DONE"]),
            (ONCE, [*ROUND, *BACK, B, C], ["DONE", "DONE"]),
            (IN_FIRST, [B, C], ["DONE"]),
            # Any of several places makes a step; a gate only forward, which is upwards.
            (BY_ANY, [A, (-0.3, 0.2), (0.0, 0.2), (0.0, 0.4), (0.4, 0.4), C], ["DONE"]),
            (BY_GATE, [A, (-0.2, 0.4), (0.0, 0.4), (0.0, 0.2), (0.2, 0.2), C], []),
            # Another of its steps breaks it, and the steps made so far are lost; re-entering the current one does not.
            (CYCLIC_BREAKS, [A, A_LOW, C_LOW, C], ["WRONG"]),
            (CYCLIC_BREAKS, [A, B, B_LOW, B, B_LOW, B, C], []),
            (BREAKS, [A, B, A, A_LOW, C_LOW, C], ["WRONG", "WRONG"]),
        ],
    )
    def test_steps_on_a_path(self, stage, sequence, path, names):
        play = stage(sequence)
        walk(play, "ball", *path)
        assert play.names() == names

    def test_it_measures_the_time_since_the_first_step(self, stage):
        play = stage(ONCE)
        place(play, "ball", *A, ticks=10)
        place(play, "ball", *B, ticks=10)
        place(play, "ball", *C)
        assert play.events[0].payload == {"took": 0.64}

    def test_all_steps_within_one_tick_are_seen(self, stage):
        play = stage(ONCE)
        place(play, "ball", -0.55, 0.0)
        walk(play, "ball", (0.45, 0.0), ticks=2)
        assert play.names() == ["DONE"]


PUT_BACK = """
rules:
  back: {triggers: [{trigger: touches, entity: Y1, other: ball}],
         actions: [{action: place, entity: ball, at: {point: %s}}]}
  gone: {triggers: [{trigger: touches, entity: Y2, other: ball}], actions: [{action: remove, entity: ball}]}
"""


GOES_ON = SEQUENCE % "when_placed: goes_on"
PUT, GONE = "put", "gone"


class TestSequenceWhoseEntityIsPutElsewhere:
    @pytest.mark.parametrize(
        ("sequence", "to", "course", "names"),
        [
            (SEQUENCE % "when_placed: begins_anew", "[-0.2, 0.3]", [A, B, PUT, C], []),
            (GOES_ON, "[-0.2, 0.3]", [A, B, PUT, C], ["DONE"]),
            (GOES_ON, "[-0.2, 0.3]", [A, B, GONE, PUT, C], ["DONE"]),  # also after a time off the field
            # Being put into a step is no step.
            (GOES_ON, "[0, 0]", [A, PUT, C], []),
            (GOES_ON, "[0, 0]", [A, PUT, C, B, C], ["DONE"]),
            # Where no step is made none is to keep, and being put into the first one makes it.
            (GOES_ON, "[-0.4, 0]", [PUT, B, C], ["DONE"]),
            (GOES_ON, "[-0.4, 0]", [PUT, B, C, PUT, B, C], ["DONE", "DONE"]),
            # Being put into a wrong step breaks nothing.
            (SEQUENCE % "when_placed: goes_on, wrong_step: break", "[-0.4, 0]", [A, B, PUT, A_LOW, C_LOW, C], ["DONE"]),
        ],
    )
    def test_it_starts_again_or_goes_on(self, stage, sequence, to, course, names):
        play = stage(sequence, PUT_BACK % to)
        for step in course:
            if isinstance(step, str):
                touch(play, "Y1" if step == PUT else "Y2", "ball", ticks=2)
            else:
                walk(play, "ball", step)
        assert play.names() == names

    @pytest.mark.parametrize(("phases", "done"), [("", []), ("phases: any, ", ["DONE"])])
    def test_sequence_starts_again_after_a_phase_in_which_no_rule_follows_it(self, stage, phases, done):
        pause = rule("trigger: tips_over, entity: Y1", "{action: set_phase, phase: pause}", name="fell")
        play = stage(GOES_ON.replace("{triggers", "{" + phases + "triggers", 1), pause,
                     "phases: {play: {}, pause: {lasts_s: 1, next: play}}")  # fmt: skip
        walk(play, "ball", A, B)
        play.tip("Y1")
        play.play(40)
        walk(play, "ball", C)
        assert play.names() == done


PROGRESS = """
match: {half_s: 600}
rules:
  stuck:
    triggers: [{trigger: no_progress, entity: ball, distance_m: %s, within_s: %s}]
    actions: [{action: emit, event: STUCK, payload: {path: {word: measured}}}]
"""


class TestTriggerNoProgress:
    @pytest.mark.parametrize(("within_s", "first"), [(15, 470), (10, 314), (0.32, 11)])
    def test_a_window_that_is_not_full_cannot_fall_short(self, stage, within_s, first):
        play = stage(PROGRESS % (0.5, within_s))
        play.play(first - 1)
        assert play.names() == []
        play.play()
        assert [(event.tick, event.payload) for event in play.events] == [(first, {"path": 0})]

    def test_the_length_of_the_way_counts_not_the_distance(self, stage):
        play = stage(PROGRESS % (0.5, 3.2))
        for _ in range(30):  # to and fro, 0.1 m in 10 ticks: 1 m in the window
            walk(play, "ball", (0.1, 0.0), (0.0, 0.0), ticks=10)
        assert play.names() == []

    def test_it_fires_once_until_there_was_progress_again(self, stage):
        play = stage(PROGRESS % (0.5, 3.2))
        play.play(500)
        assert len(play.events) == 1
        walk(play, "ball", (0.5, 0.0), (-0.5, 0.0), ticks=20)
        play.play(300)
        assert len(play.events) == 2

    @pytest.mark.parametrize(("length", "calls"), [(0.3125, 0), (0.3126, 1)])
    def test_a_path_of_just_the_length_is_progress(self, stage, length, calls):
        play = stage(PROGRESS % (length, 0.32))  # 10 pieces of 1/32 m, exact in binary
        for step in range(40):
            place(play, "ball", step / 32, 0.0)
        assert len(play.events) == calls

    @given(
        st.lists(st.sampled_from([0.0, 0.001, 0.004, 0.01, 0.03]), min_size=1, max_size=12),
        st.integers(2, 40),
        st.sampled_from([0.05, 0.1, 0.3]),
        st.integers(0, 2**32),
    )
    def test_the_sliding_window_equals_the_naive_sum(self, small, speeds, pieces, length, seed):
        scenario = small(PROGRESS % (length, pieces * 0.032))
        play = ScriptedMatch(scenario, Roster.of(scenario), half_of(scenario))
        rng = random.Random(seed)  # noqa: S311 - a reproducible walk
        seen: list[tuple[float, float]] = []
        expected, was_short = [], False
        for tick in range(1, 241):
            if tick % 7 == 0:
                speed = rng.choice(speeds)
            elif tick == 1:
                speed = speeds[0]
            x, y, _ = play.pose("ball")
            place(play, "ball", x + speed * rng.choice([-1, 0, 1]), y + speed * rng.choice([-1, 0, 1]))
            seen.append(play.pose("ball")[:2])
            window = seen[-pieces - 1 :]
            path = sum(((a - c) ** 2 + (b - d) ** 2) ** 0.5 for (a, b), (c, d) in pairwise(window))
            short = len(window) == pieces + 1 and path < length
            if short and not was_short:
                expected.append((tick, pytest.approx(path, abs=1e-6)))
            was_short = short
        assert [(event.tick, event.payload["path"]) for event in play.events] == expected
