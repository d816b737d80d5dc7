"""Tests in a scenario that expect a ranking."""

import pytest

from rcj_challenges.core.changes import CountersChange
from rcj_challenges.expect.runner import run_test
from rcj_challenges.scenario.load import load_text
from tests.scenario.writing import complaints

RACE = """schema_version: 2
id: race
title: Race
extends: soccersim_v2
match: {half_s: 60}
counters: {laps: {per: robots}, faults: {per: robots}}
result:
  rank:
    - {score: each, better: more}
    - {sum: {counter: laps, entity: each}, better: more, says: Laps.}
    - {word: time_s, plus: {sum: {counter: faults, entity: each}, times: 5}, better: less, says: Time.}
rules:
  lap:
    for_each: robots
    triggers: [{trigger: enters, entity: each, zone: blue_goal}]
    actions: [{action: count, counter: laps, entity: each}]
    says: A lap.
  fault:
    for_each: robots
    triggers: [{trigger: touches, entity: each, other: walls}]
    actions: [{action: count, counter: faults, entity: each}]
    says: A fault.
"""
TEST = "expect: {it: {keyframes: [{at_s: 1%s}], lasts_s: 2, ranking: %s}}\n"


def differences(ranking, happens="", given=""):
    test = TEST % (happens, ranking)
    return run_test(load_text(RACE + test.replace("it: {", f"it: {{{given}")), "it").differences


@pytest.mark.parametrize(
    ("given", "happens", "ranking"),
    [
        ("", "", "[[blue, yellow]]"),
        ("", "", "[[yellow, blue]]"),
        ("", ", place: {Y1: [0, 0.8]}", "[yellow, blue]"),
        ("", ", touch: [[Y1, walls]]", "[blue, yellow]"),
        ("", ", touch: [[Y1, walls]], place: {Y2: [0, 0.8]}", "[yellow, blue]"),
        ("given: {score: {blue: 1}, counters: {laps: {Y1: 3}}}, ", "", "[blue, yellow]"),
        ("given: {counters: {laps: {Y1: 3}}}, ", "", "[yellow, blue]"),
    ],
)
def test_entrants_are_ranked_by_result(given, happens, ranking):
    assert differences(ranking, happens, given) == ()


def test_another_ranking_is_shown_with_the_values_compared():
    assert differences("[yellow, blue]", ", touch: [[Y1, walls]]") == (
        "ranking: expected yellow, then blue; is blue (0, 0, 2.016), then yellow (0, 0, 7.016)",
    )
    assert differences("[yellow, blue]") == (
        "ranking: expected yellow, then blue; is blue (0, 0, 2.016) and yellow (0, 0, 2.016)",
    )


@pytest.mark.parametrize(
    ("ranking", "expected"),
    [
        ("[yellow, blu]", "unknown-name expect.it.ranking[1] -> blue"),
        ("[]", "wrong-value expect.it.ranking"),
        ("yellow", "wrong-value expect.it.ranking"),
    ],
)
def test_a_ranking_names_entrants(ranking, expected):
    assert complaints("rules: {}\n" + TEST % ("", ranking)) == [expected]


class TestChangesOfTheCountersThatRank:
    RACE = """
    counters: {laps: {per: robots}, faults: {}, other: {}}
    result:
      rank:
        - {sum: {counter: laps, entity: each}, better: more, says: Laps.}
        - {word: time_s, plus: {counter: faults, times: 5}, better: less, says: Time.}
    rules:
      other: {triggers: [{trigger: time_reached, at_s: 0.16}], actions: [{action: count, counter: other}]}
      fault: {triggers: [{trigger: time_reached, at_s: 0.32}], actions: [{action: count, counter: faults}]}
      none: {triggers: [{trigger: time_reached, at_s: 0.64}], actions: [{action: count, counter: faults, by: 0}]}
      last: {triggers: [{trigger: half_ended}], actions: [{action: count, counter: laps, entity: Y1}]}
    """
    NO_LAPS = dict.fromkeys(("B1", "B2", "Y1", "Y2"), 0)

    def test_they_are_reported_at_the_start_and_when_one_has_changed(self, stage):
        play = stage(self.RACE)
        reported = {}
        for tick in range(31):
            if tick:
                play.play(1)
            reported |= {one.tick: one.counters for one in play.output.changes if isinstance(one, CountersChange)}
        assert reported == {0: {"laps": self.NO_LAPS, "faults": 0}, 10: {"laps": self.NO_LAPS, "faults": 1}}
        assert play.finish().changes == (CountersChange(30, {"laps": self.NO_LAPS | {"Y1": 1}, "faults": 1}),)
        assert reported[0]["laps"]["Y1"] == 0  # what was reported stays as it was

    def test_without_a_counter_in_the_ranking_none_is_reported(self, stage):
        play = stage("counters: {laps: {}}", "rules: {it: {triggers: [{trigger: half_started}], "
                     "actions: [{action: count, counter: laps}]}}")  # fmt: skip
        assert not any(isinstance(one, CountersChange) for one in play.output.changes)
