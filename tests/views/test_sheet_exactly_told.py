"""What a rule sheet tells exactly: the values that programs compare with, and whom a sentence is about."""

from __future__ import annotations

import pytest

from tests.views.sheets import sheet

TOLD = """
draws: {%s}
phases: {show_first: {lasts_s: 2}}
balls: {ball: {}}
broadcast: {fields: {%s}}
rules: {it: {triggers: [{trigger: half_started}], actions: [{action: score, entrant: blue}], says: So.}}
"""


@pytest.mark.parametrize(
    ("draw", "field", "words"),
    [
        (
            "place: {values: [corner_blue_left, centre]}",
            "{draw: place}",
            'what was drawn as “place”: "corner_blue_left" or "centre"',
        ),
        ("tile: {values: [1, 2.5, true]}", "{draw: tile}", "what was drawn as “tile”: 1, 2.5 or true"),
        ("tile: {values: [1]}", "{word: phase}", 'the phase: "play" or "show_first"'),
        (
            "tile: {values: [1]}",
            "{position_of: ball}",
            "the position of the ball: [x, y, yaw] in m and rad, null while it is off the field",
        ),
        (
            "hidden: {values: [centre, middle_blue]}",
            "{position_of: hidden}",
            "the position of the spot drawn as “hidden”: [x, y] in m",
        ),
        (
            "target: {values: [ball, centre]}",
            "{position_of: target}",
            "the position of what was drawn as “target”: [x, y, yaw] in m and rad, of a spot [x, y], null while it is off the field",
        ),
        ("tile: {values: [1]}", "{position_of: centre}", "the position of the spot “centre”: [x, y] in m"),
    ],
)
def test_what_programs_compare_with_is_told_as_they_get_it(draw, field, words):
    assert f"| it | {words} |" in sheet(TOLD % (draw, f"it: {field}"))


ONLY = """
broadcast: {fields: {%s}, only: {Y1: {way: left}, blue: {way: right, more: 1}}}
rules: {it: {triggers: [{trigger: half_started}], actions: [{action: score, entrant: blue}], says: So.}}
"""


def test_who_is_told_what_others_are_not():
    text = sheet(ONLY % "score: {word: score, of: blue}")
    told = text[text.index("After it, every tick") :].split("\n## ")[0]
    assert "one JSON object follows on the same channel:\n\n| key | value |" in told
    assert "\nOnly Y1 is told in it as well:\n\n| key | value |\n| --- | --- |\n| way |" in told
    assert "\nOnly the blue robots are told in it as well:\n" in told
    assert "| more | 1 |" in told


_LATER = "Where a robot is told two values under one key, the one further down counts."


@pytest.mark.parametrize(
    ("broadcast", "count"),
    [
        ("{fields: {a: 1}, only: {Y1: {b: 2}}}", 0),
        ("{fields: {a: 1}, only: {Y1: {a: 2}}}", 1),
        ("{fields: {}, only: {Y1: {a: 1}, Y2: {a: 2}, blue: {a: 3}}}", 0),
        ("{fields: {}, only: {Y1: {a: 1}, yellow: {a: 2}}}", 1),
    ],
)
def test_which_of_two_values_under_one_key_counts_is_told(broadcast, count):
    assert sheet(f"broadcast: {broadcast}\n").count(_LATER) == count


def test_texts_are_told_with_the_quotes_that_tell_them_from_numbers():
    text = sheet("broadcast: {fields: {game: tag, version: '2', level: 2, open: true}}\n")
    for row in ('| game | "tag" |', '| version | "2" |', "| level | 2 |", "| open | true |"):
        assert row in text


def test_who_is_told_nothing_more_has_no_table():
    text = sheet("broadcast: {fields: {}, only: {Y1: {}, Y2: {a: 1}}}\n")
    assert "Only Y1" not in text
    assert "Only Y2 is told:" in text


def test_where_some_alone_are_told_something():
    text = sheet(ONLY % "")
    assert "one JSON object follows on the same channel for some robots:\n\nOnly Y1 is told:\n" in text
    assert "\nOnly the blue robots are told:\n" in text


HIDDEN = """
spots: {treasure: {x_m: 0, y_m: 0}}
rules:
  hide: {triggers: [{trigger: half_started}], actions: [{action: set_spot, spot: treasure, to: %s}]}
  it: {triggers: [{trigger: touches, entity: Y1, other: ball}], conditions: [{condition: distance, entity: Y1, to: treasure, at_most: 0.1}], actions: [{action: score, entrant: yellow}], says: So.}
"""


@pytest.mark.parametrize(
    ("to", "where"),
    [
        ("{uniform_in: pitch}", "a random point of the pitch"),
        ("{on_line: [[-0.3, 0], [0.3, 0]]}", "a random point of the line from (-0.3, 0) to (0.3, 0)"),
    ],
)
def test_where_chance_hides_something(to, where):
    assert f"{where} is remembered as the spot “treasure”".casefold() in sheet(HIDDEN % to).casefold()


FRUITS = """
balls: {ball: null, green_1: {start_m: [0.3, 0]}, green_2: {start_m: [-0.3, 0]}, red_1: {}, red_2: {start_m: [0, 0.2]}}
groups: {green_fruits: [green_1, green_2], red_fruits: [red_1, red_2]}
rules:
  green: {for_each: green_fruits, triggers: [{trigger: enters, entity: each, zone: blue_goal}], actions: [{action: score, entrant: blue}], says: "%s"}
  red: {for_each: red_fruits, triggers: [{trigger: enters, entity: each, zone: blue_goal}], actions: [{action: score, entrant: blue, points: 3}], says: "{entity} for blue."}
"""


def test_a_sentence_about_each_of_a_group_names_the_group():
    text = sheet(FRUITS % "{entity} for blue.")
    assert "| One of the green fruits for blue. | blue | 1 |" in text
    assert "| One of the red fruits for blue. | blue | 3 |" in text


def test_it_names_the_group_once_and_not_where_something_belongs_to_the_one():
    text = sheet(FRUITS % "{entity} is in; {entity} is gone.")
    assert "One of the green fruits is in; the ball is gone." in text
    assert "The ball's way is over; the ball is gone." in sheet(FRUITS % "{entity}'s way is over; {entity} is gone.")


def test_of_a_group_that_always_exists_it_says_the_kind():
    text = sheet("rules: {it: {for_each: robots, triggers: [{trigger: tips_over, entity: each}], "
                 "actions: [{action: remove, entity: each}], says: '{entity} fell.'}}\n")  # fmt: skip
    assert "[it] The robot fell." in text


PUT = "{action: place, entity: ball, at: {nearest_free: neutral_spots%s}}"
FREE = "rules: {it: {triggers: [{trigger: half_started}], conditions: [%s], actions: [%s]}}\n"
ASKED = "{condition: spot_free, spot: centre%s}"
ITSELF = "; what is to be put there counts as well where it is now, and must have room"


@pytest.mark.parametrize(
    ("condition", "action", "sentence", "words"),
    [
        (ASKED % "", "{action: end}", "8 cm.", "the spot “centre” is free:"),
        ("", PUT % "", f"8 cm{ITSELF}.", "on that free one of the neutral spots which is nearest to where it is"),
        (ASKED % ", clearance_m: 0.08", PUT % "", f"8 cm{ITSELF}.", "the spot “centre” is free:"),
        # A number of its own stands where it counts.
        (
            ASKED % ", clearance_m: 0.12",
            "{action: end}",
            "the distance that is said.",
            "the spot “centre” is free within 0.12 m:",
        ),
        (
            ASKED % "",
            PUT % ", clearance_m: 0.05, choose_among: 2",
            f"8 cm, or the distance that is said{ITSELF}.",
            "on a random one of those 2 free ones (within 5 cm) of the neutral spots which are nearest to where it is",
        ),
        (
            ASKED % ", clearance_m: 0.12, negate: true",
            "{action: end}",
            "the distance that is said.",
            "the spot “centre” is not free within 0.12 m:",
        ),
    ],
)
def test_it_says_when_a_spot_is_free(condition, action, sentence, words):
    text = sheet(FREE % (condition, action))
    assert f"A spot is free when the centre of no robot and of no ball is nearer to it than {sentence}" in text
    assert words in text


def test_where_nobody_asks_for_a_free_spot_it_says_nothing_of_them():
    assert "A spot is free" not in sheet(FREE % ("", "{action: end}"))


def test_it_says_so_of_layouts_and_of_who_comes_back_as_well():
    back = "{action: remove, entity: Y1, for_s: 1, back_at: {furthest_free: neutral_spots, from: ball}}"
    assert "A spot is free when" in sheet(FREE % ("", back))
    layout = "placements: {l: [{entity: ball, at: {nearest_free: neutral_spots}}]}\n"
    assert "A spot is free when" in sheet(layout + FREE % ("", "{action: place, layout: l}"))
