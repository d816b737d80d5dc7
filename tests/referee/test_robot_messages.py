"""Messages from robots to the referee: the trigger, the condition, the value, the position."""

import math
import struct
import time

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rcj_challenges.core.messages import MAX_CHARACTERS, matches_text, message_text, number_in, position_in
from tests.referee.building import ASKING, TAKEN_OFF, emitting, paid, payload, scoring

AS_TEXT = str.maketrans("\t\r\n\ufffd", "   \0")
NUMBERS = st.floats(-10, 10)


def hearing(trigger="", each="robots", actions="[{action: score, entrant: each}]", more=""):
    """Return a rule that gives a point for each message."""
    return f"""
    rules:
      told: {{for_each: {each}, triggers: [{{trigger: tells, entity: each{trigger}}}], {more} actions: {actions}}}
    """


def reported(play, *messages, robot="Y1"):
    """Let a robot tell one message a tick; return the score of its team."""
    for message in messages:
        play.tell(robot, message)
        play.play()
    return play.referee.scores["yellow" if robot.startswith("Y") else "blue"]


class TestTriggerTells:
    def test_each_message_fires_the_rule_in_the_tick_of_its_reception(self, stage):
        play = stage(hearing())
        assert reported(play, "a", "b", "b") == 3
        play.play(10)
        assert play.referee.scores == {"yellow": 3, "blue": 0}

    TEXTS = ("FOUND", "found", "Found it", "2", "2.0", "red", "2 2", "True", "FOUND IT")
    NUMBERS = ("3", "-0.5", "1 2", "[0.1, -.2]", "(1;2)", "here", "1 2 3", "nan", "inf", "1e999")

    @pytest.mark.parametrize(
        ("wanted", "messages", "counted"),
        [
            ("text: FOUND", TEXTS, 1),
            ("text: Found it", TEXTS, 1),
            ("text: [FOUND, '2']", TEXTS, 3),
            ("text: 2", TEXTS, 2),
            ("text: 2.5", TEXTS, 0),
            ("text: {draw: number}", TEXTS, 2),
            ("text: {draw: colour}", TEXTS, 1),
            ("text: {draw: sure}", TEXTS, 1),
            ("is_a: number", NUMBERS, 2),
            ("is_a: position", NUMBERS, 3),
            ("text: ['1', far], is_a: number", ("1", "far", "2"), 1),  # both must fit
        ],
    )
    def test_it_may_ask_for_texts_numbers_or_what_is_drawn(self, stage, wanted, messages, counted):
        draws = "draws: {number: {values: [2, 2]}, colour: {values: [red, red]}, sure: {values: [true, true]}}"
        assert reported(stage(draws, hearing(f", {wanted}")), *messages) == counted

    def test_of_a_group_any_and_without_for_each_one_a_tick(self, stage):
        play = stage("rules: {r: {triggers: [{trigger: tells}], actions: [{action: score, entrant: blue}]}}")
        for robot in ("B1", "Y1"):
            play.tell(robot, "hello")
        play.play()
        play.tell("Y2", "hello")
        play.play()
        assert play.referee.scores["blue"] == 2

    def test_the_number_in_the_message_is_what_was_measured(self, stage):
        emit = "[{action: emit, event: TOLD, payload: {number: {word: measured}, who: {word: robot_name}}}]"
        play = stage(hearing(actions=emit, more="says: '{entity} tells {measured}.',"))
        reported(play, "0.25", "hello")
        assert [event.payload for event in play.events] == [
            {"number": 0.25, "who": "Y1"},
            {"number": None, "who": "Y1"},
        ]
        assert [firing.says for firing in play.firings] == ["Y1 tells 0.25.", "Y1 tells ."]

    def test_a_robot_off_the_field_is_not_received(self, stage):
        play = stage(TAKEN_OFF % "Y1", hearing())
        play.play_until(15)
        assert reported(play, "a") == 0
        assert reported(play, "a", robot="Y2") == 1

    def test_a_rule_that_does_not_live_in_the_phase_misses_it(self, stage):
        play = stage("phases: {pause: {}}", "first_phase: pause", hearing())
        assert reported(play, "a") == 0


class TestConditionTold:
    @pytest.mark.parametrize(
        ("condition", "holds"),
        [
            ("told: Y1", [False, True, True, True]),
            ("told: Y1, text: GO", [False, True, False, False]),
            ("told: Y1, text: GO, negate: true", [True, False, True, True]),
            ("told: Y1, is_a: number", [False, False, False, True]),
            ("told: [Y1, Y2], text: GO, of: all", [False] * 4),
            ("told: [Y1, Y2], text: GO, of: none", [True, False, True, True]),
            ("told: Y2", [False] * 4),
        ],
    )
    def test_the_last_message_counts(self, stage, ask, condition, holds):
        play = stage(ASKING % f"{{{condition}}}")
        found = [ask(play)]
        for message in ("GO", "STOP", "7"):
            play.tell("Y1", message)
            found.append(ask(play))
        assert found == holds


class TestValueTold:
    def test_it_is_the_text_as_it_was_sent_and_null_before(self, stage):
        play = stage(emitting("{said: {told: Y1}}"))
        assert payload(play) == {"said": None}
        play.tell("Y1", "0.50")
        assert payload(play) == {"said": "0.50"}

    @pytest.mark.parametrize(
        ("points", "given"),
        [("{told: Y1}", 7), ("{told: Y1, times: -2, plus: 1}", -13), ("{sum: [1, {told: Y2}]}", 1)],
    )
    def test_points_and_counts_take_its_number_and_pass_over_what_is_none(self, stage, points, given):
        play = stage(scoring(points))
        play.tell("Y1", "7")
        play.tell("Y2", "seven")
        assert paid(play) == given

    def test_a_spot_is_set_to_the_position_received_and_stays_where_it_is_otherwise(self, stage):
        guess = hearing(actions="[{action: set_spot, spot: guess, to: {told: each}}]")
        play = stage("spots: {guess: {x_m: 0, y_m: 0}}", guess)
        reported(play, "0.25 -0.5")
        assert play.referee.spots["guess"] == (0.25, -0.5)
        reported(play, "over there", "3")
        assert play.referee.spots["guess"] == (0.25, -0.5)

    @pytest.mark.parametrize("reported", ["0.64 0", "3 -3", "10 10", "-10 0", "12 0", "900 -900", "1000 0"])
    def test_no_program_can_have_anything_put_off_the_field(self, stage, reported):
        play = stage("""
        spots: {guess: {x_m: 0.2, y_m: 0.1}}
        rules:
          told: {triggers: [{trigger: tells}], actions: [{action: set_spot, spot: guess, to: {told: Y1}}, {action: emit, event: SET}]}
          put: {triggers: [{trigger: event, event: SET}], actions: [{action: place, entity: ball, at: {spot: guess}, on_failure: stay}]}
        """)
        play.tell("Y1", reported)
        play.play(10)
        x, y, _ = play.pose("ball")
        assert abs(x) < 0.65
        assert abs(y) < 0.75


class TestMessages:
    @pytest.mark.parametrize(
        ("data", "text"),
        [
            (b"FOUND", "FOUND"),
            (b"  two\twords\n", "two words"),
            ("ä".encode(), "ä"),
            (b"end\0", "end"),
            (b"done\0rest", "done"),
            (b"", ""),
            (struct.pack("<d", 0.5), "0.5"),
            (struct.pack("<d", 0.0), "0.0"),
            (struct.pack("<2d", 0.25, -0.5), "0.25 -0.5"),
            (struct.pack("<2d", math.nan, 1.0), ""),
            (struct.pack("<3d", 1.0, 2.0, 3.0), "1.0 2.0 3.0"),
            (struct.pack("<9d", *range(9)), ""),
            (b"\xff\xfe!", "\ufffd\ufffd!"),
            (b"a\x07b", "a b"),
            (b"x" * 500, "x" * MAX_CHARACTERS),
        ],
    )
    def test_bytes_are_read_as_text_or_as_one_or_two_doubles(self, data, text):
        assert message_text(data) == text

    @given(st.binary(max_size=600))
    def test_whatever_is_sent_is_one_printable_line(self, data):
        text = message_text(data)
        assert len(text) <= MAX_CHARACTERS
        assert text.isprintable()
        assert text == text.strip()

    @given(NUMBERS)
    def test_a_number_is_received_as_it_was_sent(self, number):
        assert number_in(message_text(repr(number).encode())) == number

    @given(NUMBERS.filter(lambda number: abs(number) > 1e-3), NUMBERS)
    def test_two_doubles_are_the_position_that_they_were(self, x, y):
        data = struct.pack("<2d", x, y)
        if not data.decode("utf-8", "replace").translate(AS_TEXT).isprintable():  # else it is text
            assert position_in(message_text(data)) == pytest.approx((x, y), abs=1e-6)

    @given(NUMBERS, NUMBERS, st.sampled_from(["{} {}", "[{}, {}]", "({},{})", "{};{}", " {} , {} "]))
    def test_a_position_is_read_as_people_write_it(self, x, y, form):
        assert position_in(message_text(form.format(x, y).encode())) == (x, y)

    @pytest.mark.parametrize(
        "text", ["", "1,", "1 2 3", "x 1", "1 nan", "0x10 1", "1_0 2", "1 1e999", "1e300 0", "0 10.1", "٣ ٤"]
    )
    def test_what_is_no_position_is_none(self, text):
        assert position_in(text) is None

    @pytest.mark.parametrize(("text", "number"), [("1e9", 1e9), ("-1e9", -1e9), ("1000000001", None), ("1e308", None)])
    def test_what_is_too_large_is_no_number(self, text, number):
        assert number_in(text) == number

    @pytest.mark.parametrize(
        ("text", "wanted", "same"),
        [("2", 2, True), ("2.0", 2, True), ("2", "2.0", True), ("two", 2, False), ("true", True, True), ("1", True, False),
         ("FALSE", False, True), ("a", "A", False)],
    )  # fmt: skip
    def test_numbers_are_compared_as_numbers_and_text_letter_by_letter(self, text, wanted, same):
        assert matches_text(text, wanted) is same

    @pytest.mark.parametrize("text", ["1" * 99 + " " + "1" * 99 + "x", "1" * 66 + "," + " " * 66 + "1" * 66 + "x"])
    def test_what_is_nearly_a_position_is_read_as_fast_as_one(self, text):
        # A hostile program sends it in each step; it cost two and a half steps of real time.
        started = time.process_time()
        assert [position_in(text) for _ in range(100)] == [None] * 100
        assert time.process_time() - started < 1
