"""What observers of a match get while it is played, and its pace by the clock."""

import time

import pytest

from rcj_challenges.match.observers import Observer
from rcj_challenges.match.runner import MatchInterruptedError

SAYS = """from controller import Robot
robot = Robot()
while robot.step(32) != -1:
    print("at", round(robot.getTime(), 3))
"""


class Noting(Observer):
    progress_every_ticks = 8

    def __init__(self):
        self.ticks, self.progress, self.said, self.ends = [], [], [], []

    def after_tick(self, snapshot, verdict):
        self.ticks.append(snapshot.tick)

    def progressed(self, progress):
        self.progress.append(progress.tick)

    def half_started(self, half):
        self.ends.append(("half", half.half, len(self.ticks)))

    def half_ended(self, half, waits):
        self.ends.append(("is over", half.half, len(self.ticks)))

    def finished(self, result):
        self.ends.append(("match", result["complete"], len(self.ticks)))

    def printed(self, robot, text):
        self.said.append((len(self.ticks) - 1, robot, text))


@pytest.fixture(scope="module")
def reported(shared_place):
    observer = Noting()
    team = shared_place.team_folder(SAYS)
    shared_place.play("match.half_s=0.96", yellow=team, observer=observer, show_output=frozenset({"Y2"}))
    return observer


def test_each_tick_is_reported_and_progress_every_so_many(reported):
    assert reported.ticks == list(range(31))
    assert reported.progress == [8, 16, 24]


def test_a_half_begins_before_its_ticks_and_the_match_is_over_after_them(reported):
    assert reported.ends == [("half", 1, 0), ("is over", 1, 31), ("match", True, 31)]


def test_output_of_the_chosen_programs_is_shown_twice_a_second_and_at_the_end(reported):
    ticks = [tick for tick, _, _ in reported.said]
    assert set(ticks) <= {0, 16, 30}
    assert ticks[-1] == 30
    assert {robot for _, robot, _ in reported.said} == {"Y2"}
    head, *lines = "".join(text for _, _, text in reported.said).splitlines()
    assert head == "--- half 1: robot2/robot2.py ---"
    assert lines == [f"at {round(0.032 * tick, 3)}" for tick in range(1, 30)]


def test_by_the_clock_no_tick_is_judged_before_its_time(shared_place):
    began = []

    class Timing(Observer):
        def after_tick(self, snapshot, verdict):
            began.append(time.perf_counter())

    shared_place.play("match.half_s=0.96", observer=Timing(), real_time=True)
    assert all(at_s - began[0] >= 0.032 * (tick - 1) - 0.01 for tick, at_s in enumerate(began[1:], start=1))


def test_observers_of_a_broken_off_match_get_an_incomplete_result(shared_place):
    class Interrupting(Noting):
        def after_tick(self, snapshot, verdict):
            super().after_tick(snapshot, verdict)
            if snapshot.tick == 5:
                raise KeyboardInterrupt

    observer = Interrupting()
    with pytest.raises(MatchInterruptedError):
        shared_place.play("match.half_s=0.96", observer=observer)
    assert observer.ends == [("half", 1, 0), ("match", False, 6)]
