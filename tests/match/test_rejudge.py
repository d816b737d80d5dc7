"""A recorded match is judged again: by its own rules the same comes out, by others what these say of the same poses."""

import json
from types import SimpleNamespace
from unittest.mock import ANY

import pytest

from rcj_challenges.core.changes import ScoreChange
from rcj_challenges.core.errors import RcjError
from rcj_challenges.core.play import Event
from rcj_challenges.match.rejudge import differences, recorded, rejudge
from rcj_challenges.records.referee_log import LoggedTick, RefereeLog
from rcj_challenges.records.reflog import event_line
from rcj_challenges.scenario.errors import ScenarioError
from rcj_challenges.scenario.load import load, load_resolved

GOAL_AFTER_A_SECOND = """\
schema_version: 2
id: gift
title: A gift
extends: match
match: {halves: 2, half_s: 4}
placements:
  before_the_goal: [{entity: ball, at: {point: [0, 0.5]}, kick: {towards: {point: [0, 0.8]}, speed_mps: 1}}]
rules:
  gift:
    triggers: [{trigger: time_reached, at_s: 1}]
    actions: [{action: place, layout: before_the_goal}]
    says: The ball rolls into the goal.
"""


@pytest.fixture(scope="module")
def gift(shared_place):
    """A match of two halves in each of which the ball rolls into the goal of the blue seat; teams change sides."""
    file = shared_place.folder / "gift.yaml"
    file.write_text(GOAL_AFTER_A_SECOND, "utf-8")
    return shared_place.play("match.halves=2", "match.half_s=4", scenario=str(file))


@pytest.fixture
def by(gift):
    """Judge that match by its own rules with changes."""

    def judged(*overrides):
        resolved = json.loads((gift.folder / "scenario.json").read_text("utf-8"))
        return rejudge(gift.trajectory, load_resolved(resolved, overrides=overrides).scenario)

    return judged


def test_rejudging_with_the_same_rules_gives_the_same_result(gift, by):
    again = by()
    assert again.events == gift.result["events"]
    assert gift.result["score"] == {"blue": 1, "yellow": 1}
    assert (again.scores, again.ranking) == (gift.result["score"], gift.result["ranking"])
    assert [(half.ticks, half.complete) for half in again.halves] == [(125, True), (125, True)]
    assert again.complete


def test_changed_rules_judge_the_same_poses_and_the_score_passes_on_to_the_second_half(gift, by):
    again = by("rules.goal_in_blue.actions[0].points=3")
    assert again.scores == {"blue": 3, "yellow": 3}
    changed = [(one.half, one.before, one.after) for one in differences(gift.result["events"], again.events)]
    goals = [(half, before, after) for half, before, after in changed if "team_name" in before]
    assert [(half, before["score_yellow"], after["score_yellow"]) for half, before, after in goals] == [
        (1, 1, 3),
        (2, 1, 3),
    ]
    assert [(half, after["score_blue"]) for half, _, after in goals] == [(1, 0), (2, 3)]


@pytest.mark.parametrize(
    ("override", "halves", "complete"),
    [
        ("match.half_s=0.96", [(1, 30, None, True), (2, 30, None, True)], True),
        # Where the rules go on longer than the record the verdict is not complete.
        ("match.half_s=60", [(1, 125, None, False), (2, 125, None, False)], False),
        ("match.halves=1", [(1, 125, None, True)], True),
        (
            "rules.goal_in_blue.actions=[{action: end, what: match, reason: golden goal}]",
            [(1, ANY, "golden goal", True)],
            True,
        ),
    ],
)
def test_halves_end_where_the_changed_rules_or_the_record_end_them(by, override, halves, complete):
    again = by(override)
    assert [(half.half, half.ticks, half.ended, half.complete) for half in again.halves] == halves
    assert again.complete is complete
    assert ("MATCH_FINISH" in {event["event"] for event in again.events}) is complete


def test_what_came_after_a_shorter_half_is_no_event_any_more(by):
    assert {event["event"] for event in by("match.half_s=0.96").events} == {"MATCH_START", "KICKOFF", "MATCH_FINISH"}
    assert by("match.halves=1").scores == {"blue": 0, "yellow": 1}


def test_a_scenario_with_others_on_the_field_cannot_judge_it(gift):
    with pytest.raises(RcjError, match=r"the match had B1, .*, the scenario has Y3, ball, walls"):
        rejudge(gift.trajectory, load("fast_shooter").scenario)
    with pytest.raises(RcjError, match=r"the scenario has B1, B2, B3, Y1, Y2, Y3, ball, coin, walls"):
        rejudge(gift.trajectory, load("match", ["balls.coin={start_m: [0.4, 0]}"]).scenario)


def test_a_param_of_a_record_is_refused_for_its_value_stands_where_it_is_used(gift):
    resolved = json.loads((gift.folder / "scenario.json").read_text("utf-8"))
    name = next(iter(resolved["params"]))
    resolved["params"]["match"] = 5  # a section of its name can be set all the same, by parts
    for override in (f"{name}=1", f"params.{name}=1", f"params={{{name}: 1}}", "match=3"):
        with pytest.raises(ScenarioError, match="wrong-override"):
            load_resolved(resolved, overrides=[override])
    assert load_resolved(resolved, overrides=["match.half_s=3"]).scenario.match.half_s == 3


def test_a_value_that_no_rule_takes_is_refused(by):
    with pytest.raises(ScenarioError, match="half_s"):
        by("match.half_s=-1")


def event(tick, half=1, **payload):
    return {"half": half, "tick": tick, "matchtime": 0, "event": "GOAL", "payload": payload}


@pytest.mark.parametrize(
    ("before", "after", "found"),
    [
        ([event(5, by="Y1")], [], [(1, 5, {"by": "Y1"}, None)]),
        ([], [event(5, by="Y1")], [(1, 5, None, {"by": "Y1"})]),
        ([event(5, score=1)], [event(5, score=2)], [(1, 5, {"score": 1}, {"score": 2})]),
        # Equal events of one tick are distinguished from the others of it.
        ([event(5, robot="Y1"), event(5, robot="Y2")], [event(5, robot="Y2"), event(5, robot="Y1")], []),
        (
            [event(5, robot="Y1"), event(5, robot="Y2")],
            [event(5, robot="Y2"), event(5, robot="B1")],
            [(1, 5, {"robot": "Y1"}, {"robot": "B1"})],
        ),
        ([event(5), event(5)], [event(5)], [(1, 5, {}, None)]),
        ([], [event(9), event(2, half=2), event(3)], [(1, 3, None, {}), (1, 9, None, {}), (2, 2, None, {})]),
    ],
)
def test_differences_come_in_the_order_of_time(before, after, found):
    assert [(one.half, one.tick, one.before, one.after) for one in differences(before, after)] == found


def test_of_a_match_that_is_not_over_points_are_those_of_the_log_up_to_the_last_pose_by_team():
    swapped = {"blue": "yellow", "yellow": "blue"}
    halves = [
        SimpleNamespace(info=SimpleNamespace(half=half, teams=teams), ticks=ticks)
        for half, teams, ticks in ((1, {one: one for one in swapped}, 50), (2, swapped, 30))
    ]

    def scored(half, tick, blue):
        return LoggedTick(half, tick, changes=(ScoreChange(tick, {"blue": blue, "yellow": 0}),))

    goal = Event(30, "GOAL")
    log = RefereeLog(
        (
            scored(1, 50, 1),
            LoggedTick(2, 30, (goal,), changes=(ScoreChange(30, {"blue": 0.3, "yellow": 1}),)),
            scored(2, 31, 5),
            LoggedTick(3, 0, (Event(0, "GOAL"),), changes=(ScoreChange(0, {"blue": 5, "yellow": 1}),)),
        )
    )
    cut_off = SimpleNamespace(finished=False, halves=halves)
    scores, events = recorded(cut_off, log, {"blue": 0, "yellow": 0})
    assert scores == {"blue": 1, "yellow": 0.3}
    assert events == [event_line(2, goal)]
    scores, events = recorded(SimpleNamespace(finished=True, halves=halves), log, {"blue": 7, "yellow": 0})
    assert scores == {"blue": 7, "yellow": 0}
    assert len(events) == 2
