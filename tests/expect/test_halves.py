"""Tests that play several halves in a row: seats, what is carried over, totals and ranking."""

import pytest

from tests.scenario.writing import complaints, findings

RULES = """
match: {halves: 3, half_s: 10, swap_sides: true, called: round}
zones: {goal: {shape: rect, y_min_m: 0.7}}
counters: {goals: {keep: match}, own: {per: robots}, ends: {}}
flags: {won: {keep: match}}
rules:
  goal:
    triggers: [{trigger: enters, entity: ball, zone: goal}]
    actions:
      - {action: score, entrant: yellow}
      - {action: count, counter: goals}
      - {action: emit, event: GOAL, payload: {team: {word: team_name, of: yellow}}}
  touched:
    for_each: robots
    triggers: [{trigger: touches, entity: each, other: ball}]
    actions: [{action: count, counter: own, entity: each}]
  over: {triggers: [{trigger: half_ended}], actions: [{action: count, counter: ends}]}
  decided:
    triggers: [{trigger: holds, conditions: [{counter: goals, at_least: 2}]}]
    conditions: [{flag: won}]
    actions: [{action: end, what: match}]
  win: {triggers: [{trigger: half_ended}], actions: [{action: set_flag, flag: won}]}
result: {rank: [{score: each, better: more}, {sum: {counter: own, entity: each}, better: less, says: O}]}
"""
GOAL = "keyframes: [{at_s: 0.32, place: {ball: [0, 0.75]}}]"
QUIET = "keyframes: [{at_s: 0}]"


@pytest.fixture
def run(differences):
    return lambda block, *sections: differences(block, RULES, *sections)


class TestHalvesInARow:
    def test_each_half_is_compared_by_its_seats_and_the_end_by_team(self, run):
        # In the first round the team yellow sits in yellow, in the second in blue.
        halves = (
            f"{{{GOAL}, lasts_s: 2, ended: half, counters: {{ends: 1}}, score: {{yellow: 1}}, events: [{{event: GOAL, payload: {{team: Yellow Sub}}}}]}}",
            f"{{{GOAL}, lasts_s: 1, score: {{yellow: 1, blue: 1}}, events: [{{event: GOAL, payload: {{team: Blue Moon}}}}]}}",
        )
        end = "score: {yellow: 1, blue: 1}, counters: {goals: 2, own: {B1: 0}}, ranking: [[blue, yellow]]"
        assert run(f"halves: [{', '.join(halves)}], {end}") == []

    def test_difference_names_the_half_and_the_totals_are_those_of_teams(self, run):
        second = f"{{{GOAL}, lasts_s: 1, score: {{yellow: 2}}, ended: match}}"
        assert run(f"halves: [{{{QUIET}, lasts_s: 1}}, {second}], score: {{blue: 3}}, counters: {{goals: 2}}") == [
            "round 2: score of yellow: expected 2, is 1",
            "round 2: ended: expected match, is none",
            "score of blue: expected 3, is 1",
            "counter goals: expected 2, is 1",
        ]

    def test_ranking_adds_up_what_the_robots_of_a_team_did_in_its_seats(self, run):
        touch = "keyframes: [{at_s: 0.32, touch: [[%s, ball]]}], lasts_s: 1"
        # B1 is driven by the team blue, then by the team yellow.
        halves = ", ".join(f"{{{touch % robot}}}" for robot in ("B1", "B1", "Y1"))
        assert run(f"halves: [{halves}], ranking: [blue, yellow]") == []
        assert run(f"halves: [{halves}], ranking: [yellow, blue]") == [
            "ranking: expected yellow, then blue; is blue (0, 1), then yellow (0, 2)"
        ]

    def test_half_after_the_end_of_the_match_is_not_played(self, run):
        halves = f"{{{GOAL}, lasts_s: 1}}, {{{GOAL}, lasts_s: 1, ended: match}}"
        assert run(f"halves: [{halves}]") == []
        assert run(f"halves: [{halves}, {{{QUIET}, lasts_s: 1}}], counters: {{goals: 2}}") == [
            "round 3: not played, as the match was over"
        ]

    def test_what_is_given_to_a_half_takes_the_place_of_what_was_carried_over(self, run):
        given = "given: {score: {blue: 5}, counters: {goals: 7}, flags: {won: false}}"
        assert (
            run(
                f"halves: [{{{GOAL}, lasts_s: 1}}, {{{given}, {GOAL}, lasts_s: 1, score: {{blue: 5, yellow: 1}}}}], "
                "score: {yellow: 5, blue: 1}, counters: {goals: 8}, ranking: [yellow, blue]"
            )
            == []
        )

    def test_failed_half_has_the_notes_of_a_failed_test(self, run):
        block = (
            f"halves: [{{{QUIET}, lasts_s: 1}}, {{{GOAL}, lasts_s: 1, events: [{{rule: decided}}], ignore: [GOAL]}}]"
        )
        assert run(
            block,
            "rules: {decided: {triggers: [{trigger: enters, entity: ball, zone: goal}], conditions: [{word: halftime, equals: 1}], actions: [{action: end}]}}",
        ) == [
            "round 2: missing: rule decided, event 1 of the test",
            "round 2: note: decided was triggered at 0.32 s, and {word: halftime, equals: 1} did not hold",
        ]


HALF = "{keyframes: [{at_s: 0}], lasts_s: 1%s}"
TEST = "match: {halves: 2, half_s: [60, 30]}\nexpect: {t: {%s}}\n"


@pytest.mark.parametrize(
    ("test", "expected"),
    [
        (f"halves: [{HALF % ''}], ended: match", "unknown-key expect.t -> seed"),
        ("halves: []", "wrong-value expect.t.halves"),
        (f"halves: [{HALF % ', half: 2'}]", "conflicting-keys expect.t.halves[0].half"),
        (f"halves: [{HALF % ', seed: 2'}]", "conflicting-keys expect.t.halves[0].seed"),
        (f"halves: [{HALF % ', ranking: [blue, yellow]'}]", "conflicting-keys expect.t.halves[0].ranking"),
        (f"halves: [{', '.join([HALF % ''] * 3)}]", "too-late expect.t.halves[2]"),
        (f"halves: [{HALF % ''}, {{keyframes: [{{at_s: 0}}], lasts_s: 31}}]", "too-late expect.t.halves[1].lasts_s"),
        (f"halves: [{HALF % ', events: [{event: A, at_s: 2}]'}]", "too-late expect.t.halves[0].events[0].at_s"),
        (f"halves: [{HALF % ', score: {red: 1}'}]", "unknown-name expect.t.halves[0].score.red"),
        (f"halves: [{HALF % ''}], score: {{red: 1}}", "unknown-name expect.t.score.red"),
        ("lasts_s: 1", "missing-key expect.t"),
    ],
)
def test_mistake_in_a_test_of_several_halves(test, expected):
    assert complaints(TEST % test) == [expected]


def test_event_that_is_never_emitted_is_found_in_each_half():
    waits = TEST % f"halves: [{HALF % ''}, {HALF % ', events: [{event: A}]'}]"
    assert any("event-never-emitted" in one and "halves[1].events[0]" in one for one in findings(waits))
