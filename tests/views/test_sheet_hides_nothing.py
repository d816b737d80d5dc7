"""What a sheet leaves unsaid would mislead: room that is waited for, times that are added up, units, other teams' names."""

import pytest

from rcj_challenges.views.drawing.shapes import point_words
from rcj_challenges.views.sheet.phrases import metres_alike
from tests.views.sheets import sentence, sheet

pytestmark = pytest.mark.usefixtures("without_drawing")

WAITS = "What a rule puts somewhere waits until there is room"
START = "triggers: [{trigger: half_started}]"


@pytest.mark.parametrize(
    ("actions", "waits"),
    [
        ("{action: place, entity: Y1, at: start}", True),
        ("{action: place, layout: all}", True),
        ("{action: remove, entity: Y1, for_s: 5}", True),
        ("{action: remove, entity: Y1}", False),
        ("{action: place, entity: Y1, at: start, on_failure: stay}", False),
        ("{action: end}", False),
    ],
)
def test_that_a_placement_waits_for_room_is_said_where_rules_place_things(actions: str, waits: bool) -> None:
    layout = "placements: {all: [{entity: ball, at: start}]}\n" if "layout" in actions else ""
    assert (WAITS in sheet(f"{layout}rules: {{it: {{{START}, actions: [{actions}]}}}}\n")) == waits


@pytest.mark.parametrize(
    ("halves", "words"),
    [
        (1, ("a shorter time; if that is equal, a larger value of the counter “laps”; if that is equal, a smaller value of "
            "the counter “best (s)”.")),
        (2, ("a shorter time (of all halves together); if that is equal, a larger value of the counter “laps” (all halves "
            "added up); if that is equal, a smaller value of the counter “best (s)”.")),
    ],
)  # fmt: skip
def test_what_several_halves_add_up_is_said(halves: int, words: str) -> None:
    rank = "{time: ascending}, {counter: laps, order: descending}, {counter: best_s, order: ascending}"
    text = (
        f"match: {{halves: {halves}}}\ncounters: {{laps: {{}}, best_s: {{keep: match}}}}\nresult: {{rank: [{rank}]}}\n"
    )
    assert f"The better one has {words}" in sheet(text)


def test_a_folder_that_is_named_after_a_colour_is_everybodys() -> None:
    said = sheet("")
    assert (
        "Where several places are named for a program, it lies in one of them: the first that exists is taken." in said
    )
    assert "The folder rcj_soccer_team_blue has this name for every team, whichever colour it plays." in said
    own = sheet(
        "entrants: {blue: null, yellow: {robots: {Y1: robot.py, Y2: null, Y3: null}}}\nrobots: {B1: null, B2: null, B3: null, Y2: null, Y3: null}\n"
    )
    assert "whichever colour" not in own
    assert "Where several places" not in own


@pytest.mark.parametrize(
    ("lengths_m", "words"),
    [
        ((0.1, 0.07), ["10 cm", "7 cm"]),
        ((0.05, 0.07), ["5 cm", "7 cm"]),
        ((0.4, 0.1), ["0.4 m", "0.1 m"]),
        ((1.2, 0.05), ["1.2 m", "0.05 m"]),
        ((0.3, 0.0), ["0.3 m", "0 m"]),
    ],
)
def test_lengths_side_by_side_are_in_one_unit(lengths_m: tuple[float, float], words: list[str]) -> None:
    assert metres_alike(lengths_m) == words


def test_zero_has_no_sign() -> None:
    assert point_words((-0.0, 0.42)) == "(0, 0.42)"
    said = sentence(f"{START}, actions: [{{action: place, entity: Y1, at: {{point: [-0.0, 0.2]}}}}]")
    assert said == "When a half starts: Y1 is put at (0, 0.2)."


@pytest.mark.parametrize(
    ("name", "words"), [("best_s", "best (s)"), ("speed_mps", "speed (m/s)"), ("laps", "laps"), ("way_m", "way (m)")]
)
def test_units_in_names_of_counters_are_told_as_units(name: str, words: str) -> None:
    said = sentence(f"{START}, actions: [{{action: count, counter: {name}}}]", f"counters: {{{name}: {{}}}}")
    assert said == f"When a half starts: the counter “{words}” grows by 1."


@pytest.mark.parametrize(
    ("holds", "words"),
    [
        ("condition: {condition: half, at_least: 1}, for_s: 5, every_s: 5", "When 5 s have passed, and again every 5 s: "),
        ("condition: {condition: half, at_least: 1}, every_s: 3", "When a half starts, and again every 3 s: "),
        ("condition: {condition: half, at_least: 2}, for_s: 5, every_s: 5",
         "When it is half 2 or a later one for 5 s, and again every 5 s while that lasts: "),
    ],
)  # fmt: skip
def test_what_is_always_so_counts_time(holds: str, words: str) -> None:
    assert sentence(
        f"triggers: [{{trigger: holds, {holds}}}], actions: [{{action: end}}]", "match: {halves: 2}"
    ).startswith(words)
