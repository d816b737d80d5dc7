"""What rule sheets say of messages to the referee."""

import pytest

from tests.views.sheets import sentence, sheet

END = "actions: [{action: end}]"
OPEN = "What programs can tell the referee"


@pytest.mark.parametrize(
    ("trigger", "words"),
    [
        ("entity: Y1", "When the referee hears a message from Y1"),
        ("text: FOUND", "When the referee hears “FOUND” from one of the robots"),
        ("text: [2, two]", "When the referee hears 2 or “two” from one of the robots"),
        ("text: [blue_door]", "When the referee hears “blue_door” from one of the robots"),
        ("text: {draw: colour}", "When the referee hears what was drawn as “colour” from one of the robots"),
        ("entity: yellow, is_a: number", "When the referee hears a number from one of the yellow robots"),
        ("entity: Y1, is_a: position", "When the referee hears a position (two numbers, x and y in m) from Y1"),
    ],
)
def test_what_is_heard_is_said(trigger, words):
    more = "draws: {colour: {values: [red, green]}}\n"
    assert sentence(f"triggers: [{{trigger: tells, {trigger}}}], {END}", more).startswith(f"{words}:")


@pytest.mark.parametrize(
    ("condition", "words"),
    [
        ("entity: Y1", "Y1 was heard by the referee before"),
        ("entity: Y1, negate: true", "Y1 was not heard by the referee before"),
        ("entity: yellow, of: all", "all of the yellow robots were heard by the referee before"),
        ("entity: yellow, of: none", "none of the yellow robots was heard by the referee before"),
        ("entity: yellow, text: GO, of: all", "all of the yellow robots have “GO” as the last message told"),
        ("entity: Y1, is_a: number, negate: true", "Y1 does not have a number as the last message told"),
    ],
)
def test_what_was_heard_last_is_said(condition, words):
    text = sentence(f"triggers: [{{trigger: half_started}}], conditions: [{{condition: told, {condition}}}], {END}")
    assert f"provided that {words}:" in text


def test_what_is_done_with_it_is_said():
    actions = "actions: [{action: set_spot, spot: guess, to: {told: Y1}}, {action: score, entrant: yellow, points: {told: Y1}}]"
    text = sentence(f"triggers: [{{trigger: tells, entity: Y1}}], {actions}", "spots: {guess: {x_m: 0, y_m: 0}}\n")
    assert "the position that Y1 has told the referee is remembered as the spot “guess”" in text
    assert "yellow gets points: the number that Y1 has told the referee last" in text


def test_programs_learn_on_which_channel_they_are_heard_and_who_has_no_emitter():
    rule = f"rules: {{it: {{triggers: [{{trigger: tells}}], {END}, says: Told.}}}}\n"
    told = sheet(
        rule + "robots: {Y1: {without: [team emitter]}}\nentrants: {yellow: {robots: {Y2: null}}}\n"
    ).partition(OPEN)[2]
    assert "The referee hears what B1, B2, B3 and Y3 send with the team emitter on channel 1: text of up to 200" in told
    assert "emitter.setChannel(1)" in told
    assert OPEN not in sheet("")
    assert OPEN not in sheet(rule + "entrants: {blue: null, yellow: null}\n")  # nobody tells anything


def test_who_has_a_receiver_of_its_own_in_place_of_the_kits_hears_the_referee():
    own = "robots: {Y1: {without: [supervisor receiver]%s}}\n"
    assert "but for Y1, which has no receiver for it" in sheet(own % "")
    receiver = ", devices: {supervisor receiver: {device: supervisor_receiver}}"
    assert "no receiver for it" not in sheet(own % receiver)
