"""A recorded match is judged again: by its own rules the same comes out, by others what these say of the same poses."""

import json
from types import SimpleNamespace

import pytest

from rcj_challenges.core.changes import ScoreChange
from rcj_challenges.core.play import Event
from rcj_challenges.match.rejudge import MisfitError, differences, recorded, rejudge
from rcj_challenges.records.referee_log import LoggedTick, RefereeLog
from rcj_challenges.records.reflog import event_line
from rcj_challenges.scenario.errors import ScenarioError
from rcj_challenges.scenario.load import load, load_resolved

GOAL_AFTER_A_SECOND = """\
schema_version: 1
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


def test_its_own_rules_say_the_same_again(gift, by):
    again = by()
    assert again.events == gift.result["events"]
    assert gift.result["score"] == {"blue": 1, "yellow": 1}
    assert (again.scores, again.ranking) == (gift.result["score"], gift.result["ranking"])
    assert [(half.ticks, half.complete) for half in again.halves] == [(125, True), (125, True)]
    assert again.complete


def test_changed_rules_judge_the_same_poses_and_the_score_passes_on_to_the_second_half(gift, by):
    again = by("rules.goal_in_blue.actions[0].points=3")
    assert again.scores == {"blue": 3, "yellow": 3}
    told = [(one.half, one.before, one.after) for one in differences(gift.result["events"], again.events)]
    goals = [(half, before, after) for half, before, after in told if "team_name" in before]
    assert [(half, before["score_yellow"], after["score_yellow"]) for half, before, after in goals] == [
        (1, 1, 3),
        (2, 1, 3),
    ]
    assert [(half, after["score_blue"]) for half, _, after in goals] == [(1, 0), (2, 3)]


def test_a_shorter_half_ends_sooner_and_what_came_later_is_no_event_any_more(by):
    again = by("match.half_s=0.96")
    assert [half.ticks for half in again.halves] == [30, 30]
    assert again.complete
    assert {event["event"] for event in again.events} == {"MATCH_START", "KICKOFF", "MATCH_FINISH"}


def test_where_the_rules_go_on_longer_than_the_record_the_verdict_is_not_complete(by):
    again = by("match.half_s=60")
    assert [(half.ticks, half.complete) for half in again.halves] == [(125, False), (125, False)]
    assert not again.complete
    assert "MATCH_FINISH" not in {event["event"] for event in again.events}


def test_one_half_of_two_can_be_asked_for(by):
    again = by("match.halves=1")
    assert [half.half for half in again.halves] == [1]
    assert again.scores == {"blue": 0, "yellow": 1}


def test_a_rule_that_ends_the_match_ends_it_in_the_first_half(by):
    again = by("rules.goal_in_blue.actions=[{action: end, what: match, reason: golden goal}]")
    assert [(half.half, half.ended) for half in again.halves] == [(1, "golden goal")]
    assert again.complete


def test_a_scenario_with_others_on_the_field_cannot_judge_it(gift):
    with pytest.raises(MisfitError, match=r"the match had B1, .*, the scenario has Y3, ball, walls"):
        rejudge(gift.trajectory, load("fast_shooter").scenario)
    with pytest.raises(MisfitError, match=r"the scenario has B1, B2, B3, Y1, Y2, Y3, ball, coin, walls"):
        rejudge(gift.trajectory, load("match", ["balls.coin={start_m: [0.4, 0]}"]).scenario)


def test_a_param_of_a_record_is_refused_for_its_value_stands_where_it_is_used(gift):
    resolved = json.loads((gift.folder / "scenario.json").read_text("utf-8"))
    name = next(iter(resolved["params"]))
    for override in (f"{name}=1", f"params.{name}=1"):
        with pytest.raises(ScenarioError, match="wrong-override"):
            load_resolved(resolved, overrides=[override])
    with pytest.raises(ScenarioError, match="wrong-override"):
        load_resolved(resolved, overrides=[f"params={{{name}: 1}}"])


def test_what_is_in_a_section_of_a_params_name_can_be_set(gift):
    resolved = json.loads((gift.folder / "scenario.json").read_text("utf-8"))
    resolved["params"]["match"] = 5
    assert load_resolved(resolved, overrides=["match.half_s=3"]).scenario.match.half_s == 3
    with pytest.raises(ScenarioError, match="wrong-override"):
        load_resolved(resolved, overrides=["match=3"])


def test_a_value_that_no_rule_takes_is_refused(by):
    with pytest.raises(ScenarioError, match="half_s"):
        by("match.half_s=-1")


class TestDifferences:
    @staticmethod
    def event(tick, name="GOAL", half=1, **payload):
        return {"half": half, "tick": tick, "matchtime": 0, "event": name, "payload": payload}

    def test_what_stands_in_one_list_alone_has_no_payload_in_the_other(self):
        (gone,) = differences([self.event(5, by="Y1")], [])
        assert (gone.half, gone.tick, gone.event, gone.before, gone.after) == (1, 5, "GOAL", {"by": "Y1"}, None)
        (new,) = differences([], [self.event(5, by="Y1")])
        assert (new.before, new.after) == (None, {"by": "Y1"})

    def test_the_same_event_at_the_same_moment_with_another_payload_has_changed(self):
        (one,) = differences([self.event(5, score=1)], [self.event(5, score=2)])
        assert (one.before, one.after) == ({"score": 1}, {"score": 2})

    def test_equal_events_of_one_tick_are_distinguished_from_the_others_of_it(self):
        before = [self.event(5, robot="Y1"), self.event(5, robot="Y2")]
        assert differences(before, before[::-1]) == []
        (one,) = differences(before, [self.event(5, robot="Y2"), self.event(5, robot="B1")])
        assert (one.before, one.after) == ({"robot": "Y1"}, {"robot": "B1"})
        (twice,) = differences([self.event(5), self.event(5)], [self.event(5)])
        assert (twice.before, twice.after) == ({}, None)

    def test_they_come_in_the_order_of_time(self):
        after = [self.event(9), self.event(2, half=2), self.event(3)]
        assert [(one.half, one.tick) for one in differences([], after)] == [(1, 3), (1, 9), (2, 2)]


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
    found = recorded(cut_off, log, {"blue": 0, "yellow": 0})
    assert found.scores == {"blue": 1, "yellow": 0.3}
    assert found.events == [event_line(2, goal)]
    over = recorded(SimpleNamespace(finished=True, halves=halves), log, {"blue": 7, "yellow": 0})
    assert over.scores == {"blue": 7, "yellow": 0}
    assert len(over.events) == 2
