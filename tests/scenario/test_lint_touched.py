"""Lint of rules that ask at a touch whether the ball lies still: the touch itself has set it rolling."""

import pytest

from rcj_challenges.scenario.lint.table import lint
from rcj_challenges.scenario.load import load_text
from tests.scenario.writing import HEAD

TOUCH = "{trigger: touches, entity: %s, other: %s}"


def warned(condition, trigger=TOUCH % ("robots", "ball"), each="", kind="still_when_touched"):
    rule = f"{{{each}triggers: [{trigger}], conditions: [{{condition: {condition}}}], actions: [{{action: end}}]}}"
    found = [str(one) for one in lint(load_text(f"{HEAD}rules: {{r: {rule}}}\n", file="a.yaml"))]
    return [one for one in found if kind in one]


def test_a_touch_of_a_ball_that_lies_still_is_warned_of():
    (text,) = warned("speed, entity: ball, at_most: 0.01")
    assert text.endswith(
        "rules.r.conditions[0] (speed): in the tick in which it is touched 'ball' rolls already: this holds only after a "
        "touch that hardly moved it, though tests, which have no physics, pass; let a flag remember that it lay still, "
        "set by holds of its speed [still_when_touched]"
    )


@pytest.mark.parametrize(
    ("condition", "trigger", "each"),
    [
        ("speed, entity: ball, equals: 0", TOUCH % ("ball", "Y1"), ""),
        ("speed, entity: ball, at_least: 0.02, negate: true", TOUCH % ("robots", "ball"), ""),
        ("speed, entity: each, at_most: 0.01", TOUCH % ("each", "robots"), "for_each: balls, "),
        ("speed, entity: other, at_most: 0.01", TOUCH % ("each", "balls"), "for_each: robots, "),
        ("speed, entity: balls, at_most: 0.01, of: all", TOUCH % ("robots", "balls"), ""),
    ],
)
def test_in_whatever_words_it_is_asked(condition, trigger, each):
    assert len(warned(condition, trigger, each)) == 1


@pytest.mark.parametrize(
    ("condition", "trigger"),
    [
        ("speed, entity: ball, at_most: 0.3", TOUCH % ("robots", "ball")),
        ("speed, entity: ball, at_least: 0.02", TOUCH % ("robots", "ball")),
        ("speed, entity: ball, at_most: 0.01, negate: true", TOUCH % ("robots", "ball")),
        ("speed, entity: Y1, at_most: 0.01", TOUCH % ("Y1", "ball")),
        ("speed, entity: ball, at_most: 0.01", TOUCH % ("robots", "walls")),
        # While the touch goes on it may come to lie still.
        ("speed, entity: ball, at_most: 0.01", "{trigger: touches, entity: robots, other: ball, every_s: 1}"),
        ("speed, entity: ball, at_most: 0.01", "{trigger: time_reached, at_s: 5}"),
    ],
)
def test_other_questions_are_sound(condition, trigger):
    assert warned(condition, trigger) == []


def asks_in_vain(condition, trigger=TOUCH % ("yellow", "ball"), each=""):
    return warned(f"last_touch, {condition}", trigger, each, "last_touch_is_this_touch")


def test_who_touches_it_now_is_the_last_one():
    (text,) = asks_in_vain("by: blue")
    assert text.endswith(
        "rules.r.conditions[0] (last_touch): in the tick in which it is touched, who touches it is the one who touched it "
        "last: this holds only where both touch it in the same tick; let a flag remember who has touched it: a rule of that "
        "touch sets it, and this one asks it [last_touch_is_this_touch]"
    )


@pytest.mark.parametrize(
    ("condition", "trigger", "each", "count"),
    [
        ("by: blue", TOUCH % ("ball", "yellow"), "", 1),
        ("by: yellow, negate: true", TOUCH % ("yellow", "ball"), "", 1),
        ("by: each, negate: true", TOUCH % ("each", "ball"), "for_each: robots, ", 1),
        ("by: each", TOUCH % ("each", "ball"), "for_each: robots, ", 0),
        ("by: each, negate: true", TOUCH % ("robots", "ball"), "for_each: robots, ", 0),
        ("by: yellow", TOUCH % ("robots", "ball"), "", 0),
        ("by: Y1", TOUCH % ("yellow", "ball"), "", 0),
        ("by: blue", TOUCH % ("ball", "walls"), "", 0),
        ("by: blue", TOUCH % ("yellow", "walls"), "", 0),
        # What else touches it has not been the last robot.
        ("by: blue", TOUCH % ("ball", "[yellow, walls]"), "", 0),
        ("by: yellow, negate: true", TOUCH % ("ball", "[yellow, walls]"), "", 0),
        ("by: blue", TOUCH % ("yellow", "ball") + ", {trigger: half_ended}", "", 0),
    ],
)
def test_whoever_is_asked_for(condition, trigger, each, count):
    assert len(asks_in_vain(condition, trigger, each)) == count


GOAL = "goal: {triggers: [{trigger: enters, entity: ball, zone: blue_goal}], actions: [%s], says: A goal.}"
AWAY = "{action: place, entity: %s, at: {spot: centre}}, {action: emit, event: GOAL}"
HEARD = "{trigger: event, event: GOAL}"


def forgotten(rule, goal=AWAY % "ball", more=""):
    text = f"{HEAD}{more}rules:\n  {GOAL % goal}\n  r: {{{rule}, says: It is told.}}\n"
    return [str(one) for one in lint(load_text(text, file="a.yaml")) if one.kind == "last_touch_forgotten"]


ASKS = f"triggers: [{HEARD}], conditions: [{{condition: last_touch, by: Y1}}], actions: [{{action: score, entrant: yellow}}]"


def test_who_touched_last_is_forgotten_once_the_ball_is_put_elsewhere():
    (text,) = forgotten(ASKS)
    assert text.endswith(
        "rules.r.conditions[0] (last_touch): the rule 'goal', whose event is heard one tick later, has put 'ball' elsewhere "
        "by then: nobody has touched it since; ask in 'goal' itself, where it is known still, or let that rule set a flag or "
        "a counter [last_touch_forgotten]"
    )


@pytest.mark.parametrize(
    ("rule", "goal", "count"),
    [
        (f"triggers: [{HEARD}], actions: [{{action: score, entrant: {{last_touch: ball}}}}]", AWAY % "ball", 1),
        (
            f"triggers: [{HEARD}], actions: [{{action: emit, event: BY, payload: {{who: {{last_touch: ball}}}}}}]",
            AWAY % "ball",
            1,
        ),
        (ASKS, AWAY % "[balls, robots]", 1),
        (ASKS, "{action: place, layout: all}, {action: emit, event: GOAL}", 1),
        # The ball stays where it is, or something else sets the rule off as well, or it is another event.
        (ASKS, AWAY % "Y1", 0),
        (ASKS, "{action: emit, event: GOAL}", 0),
        (ASKS.replace(HEARD, HEARD + ", {trigger: half_ended}"), AWAY % "ball", 0),
        (ASKS.replace("event: GOAL", "event: OTHER"), AWAY % "ball", 0),
    ],
)
def test_whatever_asks_and_whatever_puts_it_there(rule, goal, count):
    assert len(forgotten(rule, goal, "placements: {all: [{entity: ball, at: start}]}\n")) == count


def test_in_the_rule_itself_it_is_known_still():
    asks = "{action: score, entrant: {last_touch: ball}}"
    assert forgotten(f"triggers: [{HEARD}], actions: [{{action: end}}]", f"{AWAY % 'ball'}, {asks}") == []


def test_each_of_one_rule_is_another_one_in_the_rule_that_hears_it():
    goal = "{trigger: enters, entity: each, zone: blue_goal}"
    rules = (
        f"rules:\n  goal: {{for_each: balls, triggers: [{goal}], actions: [{AWAY % 'each'}], says: A goal.}}\n"
        f"  r: {{for_each: balls, triggers: [{HEARD}], conditions: [{{condition: last_touch, entity: each, by: Y1}}],"
        " actions: [{action: score, entrant: yellow}], says: Told.}\n"
    )
    assert "last_touch_forgotten" not in [one.kind for one in lint(load_text(HEAD + rules, file="a.yaml"))]


# --- who is alone in a group touches nobody of it -----------------------------------------------------------------------

ALONE = "robots: {B1: null, B2: null, B3: null, Y2: null, Y3: null}\nentrants: {blue: null, yellow: {robots: {Y2: null, Y3: null}}}\n"


@pytest.mark.parametrize(
    ("touch", "robot"),
    [(TOUCH % ("each", "robots"), "Y1"), (TOUCH % ("robots", "yellow"), "Y1"), (TOUCH % ("balls", "ball"), "ball")],
)
def test_a_group_of_which_one_is_left_is_no_error_but_never_touches_itself(touch, robot):
    rules = f"rules: {{r: {{for_each: robots, triggers: [{touch}], actions: [{{action: end}}]}}}}\n"
    (text,) = (
        str(one) for one in lint(load_text(HEAD + ALONE + rules, file="a.yaml")) if one.kind == "rule_never_fires"
    )
    assert text.endswith(
        f"rules.r.triggers[0] (touches): '{robot}' alone is meant on both sides, and nothing touches itself; take the "
        "rule out, or name in other what else it touches [rule_never_fires]"
    )


@pytest.mark.parametrize(
    "touch", [TOUCH % ("each", "robots"), TOUCH % ("robots", "robots"), TOUCH % ("balls", "robots")]
)
def test_where_there_are_several_nothing_is_said(touch):
    rules = f"rules: {{r: {{for_each: robots, triggers: [{touch}], actions: [{{action: end}}]}}}}\n"
    assert "rule_never_fires" not in [one.kind for one in lint(load_text(HEAD + rules))]


def test_of_several_triggers_only_the_one_that_is_in_vain_is_to_go():
    touches = f"{TOUCH % ('each', 'robots')}, {TOUCH % ('ball', 'each')}"
    rules = f"rules: {{r: {{for_each: robots, triggers: [{touches}], actions: [{{action: end}}]}}}}\n"
    (found,) = (one for one in lint(load_text(HEAD + ALONE + rules)) if one.kind == "rule_never_fires")
    assert found.problem.path == "rules.r.triggers[0] (touches)"
    assert found.remedy == "take this trigger out, or name in other what else it touches"
