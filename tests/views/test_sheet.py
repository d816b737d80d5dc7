"""The rule sheet says what the referee does."""

from html.parser import HTMLParser

import pytest

from rcj_challenges.scenario.load import load, load_text
from rcj_challenges.scenario.models.actions import Action
from rcj_challenges.scenario.models.conditions import Condition
from rcj_challenges.scenario.models.places import At
from rcj_challenges.scenario.models.triggers import Trigger
from rcj_challenges.views.sheet import sheet_html, sheet_markdown
from rcj_challenges.views.sheet.deeds import ACTIONS, PLACES
from rcj_challenges.views.sheet.edges import CONDITIONS, TRIGGERS

SHIPPED = ("match", "fast_shooter", "pass_the_ball", "precision_lidar")


def sheet(name: str, *overrides: str) -> str:
    loaded = load(name, overrides)
    return sheet_markdown(loaded.scenario, loaded.roster)


def words_of(union, key: str) -> set[str]:
    return {member.model_fields[key].annotation.__args__[0] for member in union.__args__[0].__args__}


def test_every_word_of_the_vocabulary_can_be_said():
    assert words_of(Trigger, "trigger") == set(TRIGGERS)
    assert words_of(Condition, "condition") == set(CONDITIONS)
    assert words_of(Action, "action") == set(ACTIONS)
    assert len(At.__args__[0].__args__) == len(PLACES)


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
