"""What rule sheets say of conditions that must hold together, of measured values, and of points and params in sentences."""

import pytest

from rcj_challenges.scenario.load import load_text
from rcj_challenges.views.sheet import sheet_markdown
from tests.views.sheets import HEAD, sentence, sheet

A, B, C = (f"{{condition: in_zone, entity: {robot}, zone: blue_goal%s}}" for robot in ("Y1", "Y2", "Y3"))
IN, NOT = "is in the blue goal", "is not in the blue goal"


def several(word: str, *conditions: str, negate: bool = False) -> str:
    written = [one % "" if "%s" in one else one for one in conditions]
    return f"{{condition: {word}, negate: {str(negate).lower()}, conditions: [{', '.join(written)}]}}"


def said(condition: str) -> str:
    """Return how a rule says its condition."""
    text = sentence(f"triggers: [{{trigger: half_started}}], conditions: [{condition}], actions: [{{action: end}}]")
    return text.partition("provided that ")[2].partition(": ")[0]


@pytest.mark.parametrize(
    ("condition", "words"),
    [
        (several("all_of", A, B), f"Y1 {IN} and Y2 {IN}"),
        (several("all_of", A, B % ", negate: true", C), f"Y1 {IN} and Y2 {NOT} and Y3 {IN}"),
        (several("all_of", A), f"Y1 {IN}"),
        (several("all_of", A, negate=True), f"Y1 {NOT}"),
        (several("all_of", A, B, negate=True), f"either Y1 {NOT} or Y2 {NOT}"),
        (several("any_of", several("all_of", A, B), C), f"either both Y1 {IN} and Y2 {IN}, or Y3 {IN}"),
        (several("any_of", C, several("all_of", A, B, C)), f"either Y3 {IN}, or Y1 {IN}, Y2 {IN} and Y3 {IN} at once"),
        (several("any_of", several("all_of", A), C), f"either Y1 {IN} or Y3 {IN}"),
        (several("all_of", several("any_of", A, B), C), f"either Y1 {IN} or Y2 {IN}, and Y3 {IN}"),
        (several("all_of", several("any_of", A, B, negate=True), C), f"neither Y1 {IN} nor Y2 {IN}, and Y3 {IN}"),
        (several("any_of", several("all_of", A, B), C, negate=True), f"either Y1 {NOT} or Y2 {NOT}, and Y3 {NOT}"),
        (
            several("all_of", several("any_of", A, B), C, negate=True),
            f"either neither Y1 {IN} nor Y2 {IN}, or Y3 {NOT}",
        ),
    ],
)
def test_what_must_hold_together_is_said_so_that_it_can_be_told_from_alternatives(condition, words):
    assert said(condition) == words


def test_what_must_hold_together_for_a_time_says_so_before_it():
    trigger = f"{{trigger: holds, for_s: 2, condition: {several('all_of', A, B)}}}"
    assert sentence(f"triggers: [{trigger}], actions: [{{action: end}}]").startswith(
        f"When for 2 s Y1 {IN} and Y2 {IN}: "
    )


def test_a_sequence_that_a_condition_within_a_condition_asks_for_is_followed_where_its_rule_lives():
    asked = several("all_of", several("any_of", "{condition: sequence_at, sequence: way, step: blue_goal}"))
    text = sheet(
        "sequences: {way: {entity: ball, steps: [blue_goal, yellow_goal]}}\nphases: {pause: {lasts_s: 1}}\n"
        f"rules: {{r: {{triggers: [{{trigger: half_started}}], conditions: [{asked}], actions: [{{action: end}}]}}}}\n"
    )
    assert "It is followed in the phase “play” only" in text


TIMERS = "timers: {rest: {lasts_s: 9}, own: {lasts_s: 9, per: yellow}}\ncounters: {tries: {}}"


@pytest.mark.parametrize(
    ("points", "words"),
    [
        ("[5, {word: time_left_s, weight: 0.1}]", "5, plus 0.1 times the time left in full seconds"),
        ("[{counter: tries}, -2]", "the counter “tries”, minus 2"),
        ("[5, {distance: [Y3, ball], weight: -2}]", "5, minus 2 times the distance between Y3 and the ball in m"),
        ("{distance: [ball, [0, 0.5]]}", "the distance between the ball and (0, 0.5) in m"),
        ("{distance: [blue_goal, ball]}", "the distance between the blue goal and the ball in m (0 inside)"),
        ("{distance: [Y3, yellow]}", "the distance between Y3 and the nearest other one of the yellow robots in m"),
        ("{distance: [ball, yellow]}", "the distance between the ball and the nearest of the yellow robots in m"),
        ("{timer: rest}", "the time in full seconds that the timer “rest” has run"),
        ("[9, {timer: rest, weight: -1}]", "9, minus the time in full seconds that the timer “rest” has run"),
        (
            "{timer: own}",
            "the time in full seconds that the longest running timer “own” of the yellow robots has run",
        ),
        ("{timer: rest, fraction: true}", "the time in s that the timer “rest” has run (with its fraction)"),
        (
            "[9, {word: time_left_s, fraction: true, weight: -1}]",
            "9, minus the time left in s (with its fraction)",
        ),
        ("{timer: own, entity: Y1}", "the time in full seconds that the timer “own” of Y1 has run"),
    ],
)
def test_points_of_several_parts_are_one_sentence(points, words):
    rule = f"triggers: [{{trigger: half_started}}], actions: [{{action: score, entrant: blue, points: {points}}}]"
    assert f": blue gets points: {words}." in sentence(rule, TIMERS)


@pytest.mark.parametrize(
    ("action", "words"),
    [
        (
            "score, entrant: blue, points: [20, {timer: rest, weight: -1}], at_least: 5",
            "blue gets points: 20, minus the time in full seconds that the timer “rest” has run (at least 5)",
        ),
        (
            "score, entrant: blue, points: -5, keeps_at_least: 0",
            "blue loses 5 points (the score does not fall below 0 by it)",
        ),
        (
            "score, entrant: blue, points: {counter: tries}, at_least: 1, keeps_at_least: 0, keeps_at_most: 9",
            "blue gets points: the counter “tries” (at least 1; the score does not fall below 0 or rise above 9 by it)",
        ),
        (
            "count, counter: tries, by: [{counter: tries, weight: -1}, -2], keeps_at_least: 0",
            "the counter “tries” falls by the counter “tries”, plus 2 (the counter does not fall below 0 by it)",
        ),
        (
            "score, entrant: blue, points: [{counter: tries, weight: -2}]",
            "blue loses points: 2 times the counter “tries”",
        ),
        # What bounds the points bounds them as they are written: at most -1 is a loss of at least 1.
        (
            "score, entrant: blue, points: [{counter: tries, weight: -2}], at_most: -1",
            "blue gets points: -2 times the counter “tries” (at most -1)",
        ),
        (
            "count, counter: tries, by: [{counter: tries, weight: -1}, 2]",
            "the counter “tries” grows by -1 times the counter “tries”, plus 2",
        ),
        (
            "count, counter: tries, keeps_at_most: 3",
            "the counter “tries” grows by 1 (the counter does not rise above 3 by it)",
        ),
        (
            "count, counter: tries, to: {word: time_s}, at_most: 9",
            "the counter “tries” is set to the time in full seconds (at most 9)",
        ),
    ],
)
def test_floors_and_ceilings_are_said_behind_what_they_bound(action, words):
    said = sentence(f"triggers: [{{trigger: half_started}}], actions: [{{action: {action}}}]", TIMERS)
    assert said.endswith(f": {words}.")


def test_the_table_of_points_tells_bounds_too():
    action = "{action: score, entrant: blue, points: -5, keeps_at_least: 0}"
    text = sheet(f"rules: {{r: {{triggers: [{{trigger: half_started}}], actions: [{action}], says: Foul.}}}}\n")
    assert "| Foul. | blue | -5 (the score does not fall below 0 by it) |" in text


MEASURED = {
    "trigger: displaced, entity: ball, distance_m: 0.1": "the distance in m by which it was displaced",
    "trigger: no_progress, entity: ball, distance_m: 0.1, within_s: 2": "the length in m of its path",
    "trigger: stays_in, entity: ball, zone: pitch, limit_s: 2": "the time in s of the stay",
    "trigger: tips_over, entity: Y1": "its tilt in rad",
    "trigger: holds, condition: {condition: speed, entity: ball, at_most: 0.1}": "the time in s for which that has held",
    "trigger: time_reached, at_s: 2": "the time in s",
    "trigger: timer_expired, timer: rest": "the length in s of the timer",
    "trigger: sequence_completed, sequence: way": "the time in s since the first step of the sequence",
    "trigger: half_started": "what was measured",
}


@pytest.mark.parametrize(("trigger", "words"), MEASURED.items(), ids=list(MEASURED.values()))
def test_it_is_said_what_a_rule_counts_that_was_measured(trigger, words):
    count = "actions: [{action: count, counter: tries, to: {word: measured}}]"
    sequence = f"{TIMERS}\nsequences: {{way: {{entity: ball, steps: [blue_goal, yellow_goal]}}}}"
    assert sentence(f"triggers: [{{{trigger}}}], {count}", sequence).endswith(f"“tries” is set to {words}.")


def test_what_different_triggers_measure_is_only_said_to_be_measured():
    both = "triggers: [{trigger: time_reached, at_s: 2}, {trigger: tips_over, entity: Y1}]"
    said = sentence(f"{both}, actions: [{{action: count, counter: tries, to: {{word: measured}}}}]", TIMERS)
    assert said.endswith("is set to what was measured.")


def test_what_is_told_is_said_with_its_unit():
    fields = "{far: {distance: [Y3, ball]}, run: {timer: rest}, who: {last_touch: ball}}"
    text = sheet(f"{TIMERS}\nbroadcast: {{fields: {fields}}}\n")
    assert "| far | the distance between Y3 and the ball in m |" in text
    assert "| run | the time in s that the timer “rest” has run |" in text
    assert "| who | the name of the last to touch the ball |" in text
    assert "The last to touch something is the robot that touched it last since a rule put it where it is" in text


SAYS = "triggers: [{trigger: half_started}], actions: [{action: score, entrant: blue, points: %s}], says: '%s'"


def test_a_sentence_says_the_points_and_the_params():
    assert sentence(SAYS % ("3", "A goal; {points} points.")).startswith("A goal; 3 points. ")
    assert sentence(SAYS % ("{counter: tries}", "{points} points."), TIMERS).startswith("… points. ")
    assert sentence(SAYS % ("-1", "A foul: {points} points.")).startswith("A foul: -1 point. ")
    params = "params: {reach_m: 0.5, side: left}\n"
    assert sentence(SAYS % ("1", "Within {reach_m} m, {side}."), params).startswith("Within 0.5 m, left. ")
    params = "params: {tiny_m: 0.00001, far_m: 2.5}\n"
    assert sentence(SAYS % ("1", "From {tiny_m} to {far_m} m."), params).startswith("From 0.00001 to 2.5 m. ")


def test_it_follows_what_is_set_on_the_command_line():
    text = HEAD + "params: {goal_points: 3}\nrules:\n  it: {%s}\n" % (
        SAYS % ("{param: goal_points}", "{goal_points}, {points}")
    )
    loaded = load_text(text, ["goal_points=5"])
    assert "[it\\] 5, 5. When" in sheet_markdown(loaded.scenario, loaded.roster)


@pytest.mark.parametrize(
    ("condition", "words"),
    [
        ("entity: ball, to: line, at_most: 0.1", "the ball is at most 0.1 m from the gate “line”"),
        (
            "entity: robots, to: blue_goal, at_least: 0.5, of: all",
            "all of the robots are at least 0.5 m from the blue goal",
        ),
        (
            "entity: ball, to: goals, at_most: 0.2, negate: true",
            "the ball is more than 0.2 m from the nearest of the goals",
        ),
        # Nothing is measured to itself.
        ("entity: Y1, to: yellow, at_most: 0.2", "Y1 is at most 0.2 m from the nearest other one of the yellow robots"),
        ("entity: B1, to: yellow, at_most: 0.2", "B1 is at most 0.2 m from the nearest of the yellow robots"),
        (
            "entity: yellow, to: robots, at_least: 0.2, of: all",
            "all of the yellow robots are at least 0.2 m from the nearest other one of the robots",
        ),
    ],
)
def test_a_distance_to_a_gate_a_zone_or_the_nearest_of_several(condition, words):
    rule = f"triggers: [{{trigger: half_started}}], conditions: [{{condition: distance, {condition}}}], actions: [{{action: end}}]"
    more = "gates: {line: {from_m: [0, 0], to_m: [0.1, 0]}}\ngroups: {goals: [blue_goal, yellow_goal]}\n"
    assert sentence(rule, more).partition("provided that ")[2].partition(": ")[0] == words
