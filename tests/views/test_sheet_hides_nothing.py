"""What a sheet leaves unsaid would mislead: room that is waited for, times that are added up, units, other teams' names."""

import pytest

from rcj_challenges.rules.phrasing import metres_alike
from rcj_challenges.scenario.load import load
from rcj_challenges.views.drawing.shapes import point_words
from rcj_challenges.views.sheet import sheet_markdown
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
        ("condition: {condition: half, at_least: 1}, every_s: 3", "When 3 s have passed, and again every 3 s: "),
        ("condition: {condition: half, at_least: 2}, for_s: 5, every_s: 5",
         "When it is half 2 or a later one for 5 s, and again every 5 s while that lasts: "),
    ],
)  # fmt: skip
def test_what_is_always_so_counts_time(holds: str, words: str) -> None:
    assert sentence(
        f"triggers: [{{trigger: holds, {holds}}}], actions: [{{action: end}}]", "match: {halves: 2}"
    ).startswith(words)


# --- who was taken off, and is put back by another rule ------------------------------------------------------------------

TAKES_OFF = "foul: {for_each: robots, triggers: [{trigger: touches, entity: each, other: robots}], actions: [%s]}"
KICK_OFF = "kick_off: {triggers: [%s], actions: [{action: place, %s}]}"
STAYS = (
    "stuck: {for_each: robots, triggers: [{trigger: holds, for_s: 2, condition: %s}], conditions: [%s], "
    "actions: [{action: place, entity: each, at: start}]}"
)
IN_GOAL = "{condition: in_zone, entity: each, zone: blue_goal}"
NOT_IN_GOAL = "{condition: in_zone, entity: each, zone: blue_goal, negate: true}"
OUT = (
    "out: {for_each: robots, triggers: [{trigger: leaves, entity: each, zone: pitch}], "
    "actions: [{action: place, entity: each, at: start}]}"
)
GOAL = "{trigger: enters, entity: ball, zone: blue_goal}"


def said_of_the_gone(takes_off: str, puts: str) -> list[str]:
    layout = "placements: {all: [{entity: [ball, robots], at: start}]}\n"
    text = sheet(f"{layout}rules: {{{TAKES_OFF % takes_off}, {puts}}}\n")
    return [line for line in text.splitlines() if "is back as soon as" in line]


def test_who_is_taken_off_is_back_when_another_rule_puts_it_somewhere() -> None:
    assert said_of_the_gone("{action: remove, entity: each, for_s: 60}", KICK_OFF % (GOAL, "layout: all")) == [
        "A robot that was taken off the field is back as soon as [kick_off] puts it somewhere, also before its time is over."
    ]
    assert said_of_the_gone("{action: remove, entity: each}", KICK_OFF % (GOAL, "entity: Y1, at: start")) == [
        "A robot that was taken off the field is back as soon as [kick_off] puts it somewhere."
    ]


@pytest.mark.parametrize(
    "puts",
    [
        KICK_OFF % (GOAL, "entity: ball, at: start"),
        # Nobody is off the field when a half starts.
        KICK_OFF % ("{trigger: half_started}", "layout: all"),
        # Who is off the field leaves no zone, so that it is not meant.
        OUT,
        # Nor is it in a zone.
        STAYS % (IN_GOAL, ""),
        STAYS % (f"{{condition: all_of, conditions: [{IN_GOAL}, {NOT_IN_GOAL}]}}", ""),
        STAYS % (NOT_IN_GOAL, "{condition: in_zone, entity: each, zone: pitch}"),
    ],
)
def test_who_is_put_nowhere_while_it_is_off_is_not_told(puts: str) -> None:
    assert said_of_the_gone("{action: remove, entity: each}", puts) == []


def test_who_is_nowhere_is_not_in_the_goal_and_so_is_meant() -> None:
    (said,) = said_of_the_gone("{action: remove, entity: each}", STAYS % (NOT_IN_GOAL, ""))
    assert "as soon as [stuck] puts it somewhere" in said


IN_A_GOAL = "{trigger: enters, entity: robots, zone: blue_goal}"
ANY_IN_GOAL = "{condition: in_zone, entity: robots, zone: blue_goal}"


@pytest.mark.parametrize("rule", [f"triggers: [{IN_A_GOAL}]", f"triggers: [{GOAL}], conditions: [{ANY_IN_GOAL}]"])
def test_one_robot_in_the_goal_brings_all_of_them_back(rule: str) -> None:
    puts = f"again: {{{rule}, actions: [{{action: place, entity: robots, at: start}}]}}"
    (said,) = said_of_the_gone("{action: remove, entity: each}", puts)
    assert "as soon as [again] puts it somewhere" in said


def test_a_rule_for_each_that_waits_for_a_time_brings_all_back() -> None:
    puts = (
        "again: {for_each: robots, triggers: [{trigger: time_reached, at_s: 30}], "
        "actions: [{action: place, entity: each, at: start}]}"
    )
    assert "as soon as [again] puts it somewhere" in said_of_the_gone("{action: remove, entity: each}", puts)[0]


def test_one_trigger_that_brings_it_back_suffices() -> None:
    leaves = "{trigger: leaves, entity: each, zone: pitch}"
    for other in ("{trigger: time_reached, at_s: 30}", "{trigger: half_started}, {trigger: time_reached, at_s: 30}"):
        puts = OUT.replace(leaves, f"{leaves}, {other}")
        assert "as soon as [out] puts it somewhere" in said_of_the_gone("{action: remove, entity: each}", puts)[0]


def test_who_is_asked_for_in_no_zone_may_be_off_the_field() -> None:
    puts = STAYS % (IN_GOAL.replace("}", ", of: none}"), "")
    assert "as soon as [stuck] puts it somewhere" in said_of_the_gone("{action: remove, entity: each}", puts)[0]


def test_the_time_is_over_sooner_only_for_whom_a_rule_brings_back() -> None:
    for_a_time = "{action: remove, entity: B1, for_s: 60}, {action: remove, entity: Y1}"
    assert said_of_the_gone(for_a_time, KICK_OFF % (GOAL, "entity: Y1, at: start")) == [
        "A robot that was taken off the field is back as soon as [kick_off] puts it somewhere."
    ]


def test_the_match_tells_that_a_kick_off_brings_damaged_robots_back() -> None:
    loaded = load("match")
    said = " ".join(sheet_markdown(loaded.scenario, loaded.roster).replace("\\", "").split())
    told = "is back as soon as [kickoff_blue] or [kickoff_yellow] puts it somewhere, also before its time is over."
    assert f"A robot that was taken off the field {told}" in said
