"""The referee reports each change of phase, score, counters and held robots once, with its tick."""

from rcj_challenges.core.changes import ChangeTracker, CountersChange, HeldChange, PhaseChange, ScoreChange

FIRST = {"phase": ("play", False), "scores": {"blue": 1, "yellow": 0}, "counters": {"laps": 0}, "held": ()}


def test_first_tick_reports_phase_and_counters_and_a_quiet_tick_nothing():
    tracker = ChangeTracker({"blue": 1, "yellow": 0})
    assert tracker.update(0, **FIRST) == (
        PhaseChange(0, "play", waiting_for_kickoff=False),
        CountersChange(0, {"laps": 0}),
    )
    assert tracker.update(1, **FIRST) == ()


def test_each_change_is_reported_once():
    tracker = ChangeTracker({"blue": 1, "yellow": 0})
    tracker.update(0, **FIRST)
    later = {"phase": ("play", True), "scores": {"blue": 1, "yellow": 2}, "counters": {"laps": 1}, "held": ("B1",)}
    assert tracker.update(7, **later) == (
        PhaseChange(7, "play", waiting_for_kickoff=True),
        ScoreChange(7, {"blue": 1, "yellow": 2}),
        CountersChange(7, {"laps": 1}),
        HeldChange(7, ("B1",)),
    )
    assert tracker.update(8, **later) == ()


def test_scores_that_change_in_place_are_noticed():
    scores = {"blue": 0}
    tracker = ChangeTracker(scores)
    tracker.update(0, phase=("play", False), scores=scores, counters={}, held=())
    scores["blue"] = 1
    (change,) = tracker.update(1, phase=("play", False), scores=scores, counters={}, held=())
    scores["blue"] = 2
    assert change == ScoreChange(1, {"blue": 1})
