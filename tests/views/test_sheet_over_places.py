"""The rule sheet tells rules over gates and zones, and who was drawn, as people say it."""

import pytest

from tests.views.sheets import sentence, sheet

pytestmark = pytest.mark.usefixtures("without_drawing")

GATES = """gates: {west: {from_m: [-0.5, 0], to_m: [-0.3, 0]}, east: {from_m: [0.3, 0], to_m: [0.5, 0]}}
groups: {doors: [west, east]}
flags: {passed: {per: doors}}
draws: {catcher: {values: [B1, B2, B3, Y1, Y2, Y3]}, next: {values: [west, east]}, poisoned: {values: [ball, nobody]}}
"""
CROSSES = "for_each: doors, triggers: [{trigger: crosses, entity: yellow, gate: each}]"
TOUCHES = "for_each: robots, triggers: [{trigger: touches, entity: each, other: robots}]"
END = "actions: [{action: end}]"


def test_a_rule_over_gates_speaks_of_the_gate():
    words = sentence(
        f"{CROSSES}, conditions: [{{condition: flag, flag: passed, entity: each, negate: true}}], "
        "actions: [{action: set_flag, flag: passed, entity: each}]",
        GATES,
    )
    assert words == (
        "For each of the doors, when one of the yellow robots crosses it, provided that its flag “passed” is not set: "
        "its flag “passed” is set."
    )


def test_what_it_says_is_about_who_crosses_and_names_the_gate():
    words = sentence(f'{CROSSES}, {END}, says: "{{entity}} of {{team}} has passed {{each}}."', GATES)
    assert words.startswith(
        "One of the yellow robots of yellow has passed one of the doors. For each of the doors, when"
    )


@pytest.mark.parametrize(
    ("says", "words"),
    [
        ("{each} is open; who crosses {each} closes it.", "One of the doors is open; who crosses the gate closes it."),
        ("{entity} has passed the gate {each}.", "One of the yellow robots has passed one of the doors."),
        # Where the rule fires a name stands there, “The west door is open.”; a group has its own article.
        (
            "The {each} is open; who crosses the {each} closes it.",
            "One of the doors is open; who crosses the gate closes it.",
        ),
        ("The {entity} has passed the {each}.", "One of the yellow robots has passed one of the doors."),
        ("Gate {each} is passed.", "One of the doors is passed."),
        ("The gate's name is {each}.", "The gate's name is one of the doors."),
        ("The colour of {each}'s posts counts.", "The colour of the gate's posts counts."),
        (
            "A {each} is open; who crosses a {each} closes it.",
            "One of the doors is open; who crosses the gate closes it.",
        ),
        ("A gate {each} is open.", "One of the doors is open."),
        ("This {each} is open.", "One of the doors is open."),
        # “The west gate”, “the west door” and “the door west” are what stands there when it fires.
        ("The {each} gate is open, and the {each} gate counts.", "One of the doors is open, and the gate counts."),
        ("The {each} door is open.", "One of the doors is open."),
        ("The door {each} is open.", "One of the doors is open."),
        ("The {each} gate's posts are red.", "The gate's posts are red."),
        ("An {entity} of {team} is through.", "One of the yellow robots of yellow is through."),
        (
            "{each} is passed. {each} counts! {entity} goes on.",
            "One of the doors is passed. The gate counts! One of the yellow robots goes on.",
        ),
        ("It is open: {each}.", "It is open: one of the doors."),
        # By another word for it: what is meant is told beside it, once.
        (
            "The field {each} is passed; who leaves the field {each} waits.",
            "The field (one of the doors) is passed; who leaves the field waits.",
        ),
        ("A runner {entity} is through.", "A runner (one of the yellow robots) is through."),
        ("The next {each} is open.", "The next one of the doors is open."),
        ("The robot that crosses {each} may go.", "The robot that crosses one of the doors may go."),
    ],
)
def test_it_is_said_of_which_group_the_gate_is(says, words):
    assert sentence(f'{CROSSES}, {END}, says: "{says}"', GATES).startswith(f"{words} For each of the doors, ")


@pytest.mark.parametrize(
    ("group", "says", "words"),
    [
        ("boxes", "The box {each} is passed.", "One of the boxes is passed."),
        ("entries", "It is an entry, the {each} entry.", "It is an entry, one of the entries."),
        ("east_doors", "The door {each} is passed.", "One of the east doors is passed."),
    ],
)
def test_what_a_group_is_of_is_not_said_twice(group, says, words):
    crosses = f"for_each: {group}, {CROSSES.partition(', ')[2]}"
    said = sentence(f'{crosses}, {END}, says: "{says}"', GATES.replace("doors", group))
    assert said.startswith(f"{words} For each of the ")


def test_the_other_one_by_another_word_is_told_beside_it():
    said = sentence(f'{TOUCHES}, {END}, says: "The loser {{other}} goes."', GATES)
    assert said.startswith("The loser (the other robot) goes. ")


@pytest.mark.parametrize("says", ["A {other} is touched.", "The robot {other} is touched.", "{other} is touched."])
def test_the_other_one_has_one_article(says):
    assert sentence(f'{TOUCHES}, {END}, says: "{says}"', GATES).startswith("The other robot is touched. ")


def test_a_team_that_is_not_known_is_named_once():
    touches = "for_each: robots, triggers: [{trigger: touches, entity: each, other: ball}]"
    words = sentence(f'{touches}, {END}, says: "Team {{team}} has it. {{team}} gets a point."', GATES)
    assert words.startswith("The team has it. The team gets a point. ")


def test_a_rule_over_robots_says_of_which_group_each_is_once():
    touches = "for_each: backs, triggers: [{trigger: touches, entity: each, other: ball}]"
    said = sentence(f'{touches}, {END}, says: "{{each}} has it, and {{entity}} may go."', "groups: {backs: [B1, B2]}\n")
    assert said.startswith("One of the backs has it, and the robot may go. ")


def test_a_rule_over_robots_says_each_as_entity():
    says = sentence(f'{TOUCHES}, {END}, says: "{{each}} or {{entity}}."', GATES).partition(". ")[0]
    assert says == "The robot or the robot"


def test_whose_timer_runs_out_is_the_one_concerned_only_if_it_is_on_the_field():
    said = 'triggers: [{trigger: timer_expired, timer: %s}], actions: [{action: end}], says: "{entity} may go."'
    timers = f"{GATES}timers: {{closed: {{lasts_s: 3, per: doors}}, tired: {{lasts_s: 3, per: yellow}}}}\n"
    assert sentence(said % "tired", timers).startswith("One of the yellow robots may go. ")
    assert sentence(said % "closed", timers).startswith("The one concerned may go. ")


def test_the_name_of_the_gate_is_told():
    told = sentence(f"{CROSSES}, actions: [{{action: emit, event: E, payload: {{gate: {{word: each_name}}}}}}]", GATES)
    assert told.endswith("E is announced (gate: the name of the one that the rule is for).")


def test_a_rule_over_zones_speaks_of_the_zone():
    rule = "for_each: penalty_areas, triggers: [{trigger: enters, entity: ball, zone: each}]"
    condition = "conditions: [{condition: in_zone, entity: Y1, zone: each}]"
    assert sentence(f"{rule}, {condition}, {END}") == (
        "For each of the penalty areas, when the ball enters it, provided that Y1 is in it: the half ends."
    )


def test_gates_of_which_each_has_a_flag_are_told_in_the_course():
    text = sheet(GATES.replace("{per: doors}", "{per: doors, initial: true}"))
    assert "- There is a flag “passed” for each of the doors; it is set when a half starts." in text.splitlines()


DRAWN = [
    ("drawn, draw: catcher, equals: each", "it was drawn as “catcher”"),
    ("drawn, draw: catcher, equals: other, negate: true", "the robot it touches was not drawn as “catcher”"),
    ("drawn, draw: catcher, equals: Y1", "“Y1” was drawn as “catcher”"),
    ("drawn, draw: poisoned, equals: nobody", "“nobody” was drawn as “poisoned”"),
]


@pytest.mark.parametrize(("condition", "words"), DRAWN)
def test_who_was_drawn(condition, words):
    said = sentence(f"{TOUCHES}, conditions: [{{condition: {condition}}}], {END}", GATES)
    assert said.endswith(f", provided that {words}: the half ends.")


MADE = [
    ("other", "the robot it touches becomes “catcher”"),
    ("each", "it becomes “catcher”"),
    ("Y2", "“catcher” becomes “Y2”"),
]


@pytest.mark.parametrize(("value", "words"), MADE)
def test_who_becomes_what_is_drawn(value, words):
    said = sentence(f"{TOUCHES}, actions: [{{action: draw, draw: catcher, as: {value}}}]", GATES)
    assert said.endswith(f": {words}.")


def test_a_value_called_other_is_told_as_a_value():
    more = "draws: {which: {values: [one, other]}}\n"
    rule = "triggers: [{trigger: half_started}], conditions: [{condition: drawn, draw: which, equals: other}]"
    assert sentence(f"{rule}, {END}", more) == (
        "When a half starts, provided that “other” was drawn as “which”: the half ends."
    )
