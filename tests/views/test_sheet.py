"""The rule sheet says what the referee does."""

import re
from functools import cache
from html.parser import HTMLParser
from pathlib import Path

import pytest

from rcj_challenges.scenario.load import load, load_text
from rcj_challenges.views.sheet import sheet_html, sheet_markdown

ROOT = Path(__file__).resolve().parents[2]
SHIPPED = ("match", "fast_shooter", "pass_the_ball", "precision_lidar")
RECIPES = sorted((ROOT / "docs" / "recipes").glob("*.yaml"))
ALL = [
    *(pytest.param(path, id=path.stem) for path in sorted((ROOT / "scenarios").rglob("*.yaml"))),
    *(pytest.param(path, id=path.stem) for path in RECIPES),
]


@cache
def sheet(name: str, *overrides: str) -> str:
    loaded = load(name, overrides)
    return sheet_markdown(loaded.scenario, loaded.roster)


def test_the_sheet_of_a_challenge_of_2021_says_in_which_order_its_sensors_tell_numbers():
    text = sheet("precision_lidar").replace("\\", "")
    assert "position of the robot, told as [y, z, x] as in the worlds of 2021" in text
    assert "direction of north, told as [left, up, ahead] as in the worlds of 2021" in text
    assert "its points told as [left, up, ahead] as in the worlds of 2021" in text
    assert "2021" not in sheet("match").partition("# Robots")[2].partition("\n## ")[0]


@pytest.mark.parametrize("name", SHIPPED)
def test_every_rule_stands_on_the_sheet(name):
    text = sheet(name).replace("\\", "")
    for rule in load(name).scenario.rules:
        assert f"[{rule}]" in text


def test_a_changed_limit_changes_the_sheet():
    assert "over the last 15 s" in sheet("match")
    assert "over the last 7 s" in sheet("match", "robot_progress_s=7")


def test_points_stand_in_the_scoring_table():
    assert "| yellow | 5 |" in sheet("fast_shooter", "rules.goal.actions[0].points=5")


def test_blanks_of_sentences_are_filled():
    assert "{entity}" not in sheet("match")


class _Tags(HTMLParser):
    def __init__(self):
        super().__init__()
        self.open, self.seen = [], set()

    def handle_starttag(self, tag, attrs):
        self.seen.add(tag)
        if tag not in ("meta", "br"):
            self.open.append(tag)

    def handle_endtag(self, tag):
        assert self.open.pop() == tag


@pytest.mark.parametrize("name", SHIPPED)
def test_the_page_is_well_formed_and_needs_nothing_from_elsewhere(name):
    loaded = load(name, ["title='A <b>bold</b> title'"])
    page = sheet_html(loaded.scenario, loaded.roster)
    tags = _Tags()
    tags.feed(page)
    assert tags.open == []
    assert not tags.seen & {"script", "link", "img", "iframe", "b"}


SMALL = """
schema_version: 1
id: small
title: Small
extends: soccersim_v2
obstacles: {pin: {shape: cylinder, centre_m: [0.4, 0], radius_m: 0.02, movable: true}}
groups: {pins: [pin]}
rules:
  down:
    for_each: pins
    triggers: [{trigger: displaced, entity: each, distance_m: 0.02}]
    actions: [{action: emit, event: OUT}]
    says: "{entity} is down."
  gone:
    for_each: balls
    triggers: [{trigger: leaves, entity: each, zone: pitch}]
    actions: [{action: emit, event: OUT}]
    says: "{entity} is gone."
"""


def test_a_sentence_names_the_kind_of_thing_that_its_rule_goes_over():
    loaded = load_text(SMALL)
    text = sheet_markdown(loaded.scenario, loaded.roster)
    assert "The obstacle is down." in text
    assert "The ball is gone." in text


def test_an_event_of_several_rules_is_explained_by_all_of_them():
    loaded = load_text(SMALL)
    text = sheet_markdown(loaded.scenario, loaded.roster)
    assert "| OUT | The obstacle is down. Or: The ball is gone. |" in text


SEVERAL = re.compile(
    r"(?P<one>(?:[Oo]ne|[Ee]ach|any|none) of (?:the \w+ robots(?:,| and) )*)?the (?:\w+ )?(?:robots|balls|obstacles|spots|zones|circles|areas)(?: “[^”]*”)? "
    r"(?P<verb>is|has|was|leaves|enters|touches|crosses|moves|tilts|fails)\b"
)


@pytest.mark.parametrize("source", ALL)
def test_of_several_nothing_is_said_as_if_they_were_one(source):
    loaded = load(source) if isinstance(source, Path) else load_text(source)
    text = sheet_markdown(loaded.scenario, loaded.roster).replace("\\", "")
    assert [found[0] for found in SEVERAL.finditer(text) if found["one"] is None] == []
    for odd in (" of it ", "everything of", "not (", "-1 point", "1 times", "every 1 tick", " the the ", " a a "):
        assert odd not in text


GROUPS = """
schema_version: 1
id: groups
title: Groups
extends: soccersim_v2
balls: {red: {start_m: [0.4, 0]}}
obstacles: {vase: {shape: cylinder, centre_m: [0.4, 0.1], radius_m: 0.02, movable: true}}
groups: {wings: [B1, B2], lone: [Y1]}
counters: {laps: {per: robots}, goals: {}}
flags: {away: {}}
placements: {corner: [{entity: [blue, Y3], at: start}, {entity: balls, at: {spot: centre}}]}
rules:
  it: RULE
  other: {triggers: [{trigger: half_ended}], actions: [{action: count, counter: goals}, {action: set_flag, flag: away}]}
"""


def said(rule: str) -> str:
    """Return the sentence of a rule that is written in YAML on one line."""
    loaded = load_text(GROUPS.replace("RULE", f"{{{rule}}}"))
    text = sheet_markdown(loaded.scenario, loaded.roster).replace("\\", "")
    return next(line for line in text.splitlines() if line.startswith("1. [it]")).removeprefix("1. [it] ")


EDGES = {
    "trigger: touches, entity: robots, other: walls": "one of the robots touches a wall",
    "trigger: touches, entity: lone, other: obstacles": "Y1 touches the obstacle “vase”",
    "trigger: touches, entity: [Y1, blue], other: balls": "Y1 or one of the blue robots touches one of the balls",
    "trigger: touches, entity: blue, other: blue": "one of the blue robots touches another of them",
    "trigger: touches, entity: wings, other: robots": "one of the wings touches another of the robots",
    "trigger: touches, entity: Y1, other: robots": "Y1 touches another of the robots",
    "trigger: touches, entity: robots, other: blue": "one of the robots touches one of the blue robots",
    "trigger: leaves, entity: ball, zone: in_play": "the ball “ball” leaves the zones “in play”",
    "trigger: enters, entity: red, zone: penalty_areas": "the ball “red” enters one of the penalty areas",
    "trigger: stays_in, entity: wings, zone: pitch, limit_s: 3": (
        "one of the wings has been in the pitch for more than 3 s"
    ),
    "trigger: program_fault": "the program of one of the robots fails",
    "trigger: time_reached, at_s: 1": "the half has lasted 1 s",
    "trigger: time_reached, at_s: 1, every_s: 5": "the half has lasted 1 s, and again every 5 s until it ends",
}


@pytest.mark.usefixtures("without_drawing")
@pytest.mark.parametrize(("written", "words"), EDGES.items(), ids=list(EDGES.values()))
def test_a_trigger_of_a_group_speaks_of_one_of_them(written, words):
    assert said(f"triggers: [{{{written}}}], actions: [{{action: end}}]") == f"When {words}: the half ends."


LEVELS = {
    "condition: in_zone, entity: wings, of: all, zone: pitch": "all of the wings are in the pitch",
    "condition: in_zone, entity: wings, of: all, zone: pitch, negate: true": "not all of the wings are in the pitch",
    "condition: in_zone, entity: wings, zone: pitch, negate: true": "none of the wings is in the pitch",
    "condition: in_zone, entity: ball, zone: pitch, negate: true": "the ball “ball” is not in the pitch",
    "condition: in_zone, entity: robots, of: {at_least: 2}, zone: pitch": "at least 2 of the robots are in the pitch",
    "condition: in_zone, entity: robots, of: {at_least: 2}, zone: pitch, negate: true": (
        "fewer than 2 of the robots are in the pitch"
    ),
    "condition: speed, entity: ball, at_least: 0.1, negate: true": "the ball “ball” moves slower than 0.1 m/s",
    "condition: distance, entity: ball, to: robots, at_most: 0.1": (
        "the ball “ball” is at most 0.1 m from the nearest of the robots"
    ),
    "condition: flag, flag: away, negate: true": "the flag “away” is not set",
    "condition: counter, counter: blue, at_least: 2": "the score of blue is at least 2",
    "condition: last_touch, by: yellow, negate: true": "the last to touch the ball “ball” was not one of the yellow robots",
    "condition: spot_free, spot: neutral_spots, of: none": "none of the neutral spots is free",
}


@pytest.mark.usefixtures("without_drawing")
@pytest.mark.parametrize(("written", "words"), LEVELS.items(), ids=list(LEVELS.values()))
def test_a_condition_of_a_group_says_how_many_of_them(written, words):
    rule = f"triggers: [{{trigger: half_started}}], conditions: [{{{written}}}], actions: [{{action: end}}]"
    assert said(rule) == f"When a half starts, provided that {words}: the half ends."


DEEDS = {
    "action: place, entity: robots, at: start": "the robots are put at their starts",
    "action: place, entity: lone, at: start": "Y1 is put at its start",
    "action: place, entity: wings, at: {nearest_free: neutral_spots}": (
        "the wings are each put on that free one of the neutral spots which is nearest to where it is"
    ),
    "action: place, layout: corner": "things are put as in “corner”",
    "action: place, layout: corner, mirror: {axis: both, when: away}": (
        "things are put as in “corner”, mirrored (x becomes -x and y becomes -y) if the flag “away” is set"
    ),
    "action: remove, entity: [Y1, red]": "Y1 and the ball “red” are taken off the field",
    "action: remove, entity: blue, for_s: 5": (
        "the blue robots are taken off the field and after 5 s put at their starts"
    ),
    "action: count, counter: laps, to: 0": "the counter “laps” of each of the robots is set to 0",
    "action: count, counter: goals, by: -2": "the counter “goals” falls by 2",
    "action: score, entrant: blue, points: -1": "blue loses 1 point",
    "action: score, entrant: blue, points: 2.5": "blue gets 2.5 points",
}


@pytest.mark.usefixtures("without_drawing")
@pytest.mark.parametrize(("written", "words"), DEEDS.items(), ids=list(DEEDS.values()))
def test_an_action_on_a_group_speaks_of_all_of_them(written, words):
    assert said(f"triggers: [{{trigger: half_started}}], actions: [{{{written}}}]") == f"When a half starts: {words}."


def test_a_rule_for_each_of_a_group_says_it_and_its():
    rule = (
        "for_each: wings, triggers: [{trigger: leaves, entity: each, zone: pitch}, {trigger: program_fault, robot: each}], "
        "conditions: [{condition: counter, counter: laps, entity: each, at_least: 1}], "
        "actions: [{action: count, counter: laps, entity: each}, {action: place, entity: each, at: start}]"
    )
    assert said(rule) == (
        "For each of the wings, when it leaves the pitch, or when its program fails, provided that its counter “laps” is "
        "at least 1: its counter “laps” grows by 1, then it is put at its start."
    )


def test_a_layout_speaks_of_all_that_it_puts():
    place = "{action: place, layout: corner}"
    loaded = load_text(GROUPS.replace("RULE", f"{{triggers: [{{trigger: half_started}}], actions: [{place}]}}"))
    text = sheet_markdown(loaded.scenario, loaded.roster)
    assert "the blue robots and Y3 are put at their starts; the balls are each put on the spot “centre”." in text
    assert "“wings”: B1, B2" in text


def test_who_is_better_stands_on_the_sheet():
    assert "a shorter time, with 3 s added for each count of the counter “touched posts”" in sheet(
        str(ROOT / "scenarios" / "examples" / "slalom.yaml")
    )


def test_the_order_of_a_sequence_stands_on_the_sheet():
    assert (
        "quarter 1, then quarter 2, then quarter 3, then quarter 4 and back to the first; after the first step, "
        "entering one of these which is neither the last reached nor the next breaks it"
    ) in sheet("pass_the_ball")
