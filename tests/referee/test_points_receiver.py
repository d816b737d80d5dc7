"""Who gets points: a named entrant, the one that drives a robot, or the last toucher. And sequences that restart."""

import pytest

from tests.referee.building import SEQUENCE, A, B, C, fail, touch, walk

PAYS_EACH = """
rules:
  pays:
    for_each: robots
    triggers: [{trigger: touches, entity: each, other: ball}]
    actions: [{action: score, entrant: each, points: 2}]
"""

PAYS_LAST = """
rules:
  pays:
    triggers: [{trigger: enters, entity: ball, zone: middle}]
    actions: [{action: score, entrant: {last_touch: ball}, points: 3}]
"""


class TestWhoGetsPoints:
    @pytest.mark.parametrize(("robot", "scores"), [("Y2", {"blue": 0, "yellow": 2}), ("B1", {"blue": 2, "yellow": 0})])
    def test_each_is_the_entrant_of_the_current_robot(self, stage, robot, scores):
        play = stage(PAYS_EACH)
        touch(play, robot, "ball")
        assert play.referee.scores == scores
        assert play.firings[-1].scored == {name: points for name, points in scores.items() if points}

    def test_one_entrant_may_drive_robots_of_both_colours(self, stage):
        play = stage("entrants: {yellow: {robots: {Y1: a.py, B2: b.py}}, blue: {robots: {B1: a.py}}}", PAYS_EACH)
        touch(play, "B2", "ball")
        assert play.referee.scores == {"blue": 0, "yellow": 2}

    @pytest.mark.parametrize(
        ("touches", "sections", "scores"),
        [
            ([("Y1", 1)], [], {"blue": 0, "yellow": 3}),
            ([("Y1", 1), ("B2", 1)], [], {"blue": 3, "yellow": 0}),
            ([("Y1", 9), ("B2", 3)], [], {"blue": 0, "yellow": 3}),  # Y1 still touches it when B2 lets go
            ([], [], {"blue": 0, "yellow": 0}),
            ([("Y2", 1)], ["entrants: {yellow: {robots: {Y1: a.py}}}"], {"blue": 0, "yellow": 0}),  # without an entrant
        ],
    )
    def test_last_touch_is_the_last_toucher_and_none_if_nothing_touched_it(self, stage, touches, sections, scores):
        play = stage(PAYS_LAST, "balls: {ball: {start_m: [0.4, 0]}}", *sections)
        for robot, ticks in touches:
            play.touch(robot, "ball", ticks)
            play.play()
        play.glide("ball", (0.0, 0.0), 20)
        play.play(25)
        assert play.referee.scores == scores
        assert len(play.firings) == 1


class TestActionSequence:
    RESTARTS = (
        "  restarts: {triggers: [{trigger: program_fault, robot: B1}], actions: [{action: reset, sequence: way}]}\n"
    )

    def test_it_stands_at_its_first_step_if_the_entity_is_in_it(self, stage):
        play = stage(SEQUENCE % "cyclic: false" + self.RESTARTS)
        walk(play, "ball", A)
        fail(play, "B1")
        walk(play, "ball", B, C)
        assert play.names() == ["DONE"]
