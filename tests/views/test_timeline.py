"""A match that is played and the record of it give the same timeline."""

import pytest

from rcj_challenges.core.changes import HeldChange, PhaseChange, ScoreChange
from rcj_challenges.core.play import Event, Fault, Firing
from rcj_challenges.records.referee_log import read_referee_log
from rcj_challenges.records.reflog import events_of
from rcj_challenges.records.run_record import read_run
from rcj_challenges.views.timeline import POINTS, TimelineBuilder, timeline_of
from tests.made_up_runs import (
    GOAL_EVERY_TICKS,
    half_info,
    made_up_play,
    small_header,
    small_scenario,
    write_made_up_run,
)

TICKS = 2 * GOAL_EVERY_TICKS + 50
SCENARIO = small_scenario(halves=2, half_s=TICKS * 0.032)
HEADER = small_header(SCENARIO)


@pytest.fixture
def builder():
    found = TimelineBuilder(SCENARIO, max_unannounced=2)
    found.begin_half(half_info(SCENARIO, 2, TICKS, HEADER, {"blue": 1, "yellow": 3}))
    return found


def test_played_and_recorded_match_have_the_same_timeline(tmp_path):
    played = TimelineBuilder(SCENARIO)
    score = {}
    for half in (1, 2):
        info = half_info(SCENARIO, half, TICKS, HEADER, score)
        played.begin_half(info)
        for snapshot, output in made_up_play(6, TICKS, info.scores):
            played.add(events_of(snapshot, output), output.firings, output.changes, snapshot.faults)
        played.add((Event(TICKS, "MATCH_FINISH", {"total_match_time": TICKS * 0.032}),), (), ())
        score = played.timeline.halves[half].changes["score_changes"][-1][1]
    folder = write_made_up_run(tmp_path, ticks=TICKS)
    run = read_run(folder)
    assert timeline_of(run.scenario, run.halves, read_referee_log(folder)) == played.timeline
    assert score == {"blue": 2, "yellow": 2}


def test_scores_of_seats_are_mapped_to_teams_after_sides_were_changed(builder):
    _, changes = builder.add((), (), (ScoreChange(5, {"blue": 4, "yellow": 1}),))
    assert changes == {"score_changes": [[5, {"yellow": 4, "blue": 1}]]}


def test_event_has_the_firing_that_emitted_it_and_the_score_after_the_tick(builder):
    goal = Firing(5, "goal", None, "enters", scored={"yellow": 1})
    other = Firing(5, "goal", None, "enters", suppressed="cooldown")
    (event,), _ = builder.add((Event(5, "GOAL"),), (other, goal), (ScoreChange(5, {"blue": 3, "yellow": 2}),))
    assert event.cause == goal
    assert event.score == {"yellow": 3, "blue": 2}


def test_points_without_an_event_stand_in_it_a_few_times(builder):
    paid = [builder.add((), (Firing(tick, "pays", None, "holds", scored={"blue": 1}),), ()) for tick in range(5)]
    assert [[event.name for event in events] for events, _ in paid] == [[POINTS], [POINTS], [], [], []]


def test_program_fault_stands_at_the_tick_in_which_the_program_failed(builder):
    fault = Fault("Y1", "crash", 7, 2, "ZeroDivisionError")
    (event,), _ = builder.add((Event(8, "PROGRAM_FAULT", {"robot_name": "Y1"}),), (), (), (fault,))
    assert (event.tick, event.fault) == (7, fault)


def test_phases_and_held_robots_are_listed_with_their_ticks(builder):
    builder.add((), (), (PhaseChange(3, "goal_pause", waiting_for_kickoff=True),))
    builder.add((), (), (HeldChange(4, ("B1",)),))
    changes = builder.timeline.halves[2].changes
    assert (changes["phases"], changes["held"]) == ([[3, "goal_pause", True]], [[4, ["B1"]]])
