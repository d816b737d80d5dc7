"""Who writes a word of another game or language learns what it is called here."""

from __future__ import annotations

import re

import pytest

from rcj_challenges.rules.actions import AnyAction
from rcj_challenges.rules.conditions import AnyCondition
from rcj_challenges.rules.triggers import AnyTrigger
from rcj_challenges.scenario.messages.other_names import table
from rcj_challenges.scenario.shape import tags
from tests.scenario.writing import complaints, rule, scenario

WORDS = {"trigger": tags(AnyTrigger), "action": tags(AnyAction), "condition": tags(AnyCondition)}
KNOWN = """\
zones: {area: {shape: circle, centre_m: [0, 0], radius_m: 0.2}}
counters: {laps: {}}
timers: {clock: {lasts_s: 5}}
phases: {play: {}}
"""


@pytest.mark.parametrize(
    ("kind", "word", "way_out"),
    [
        ("action", "set_counter", "a counter changes by {action: count"),
        ("action", "teleport", "write place: "),
        ("action", "attach", "nothing is carried along: "),
        ("action", "pick_up", "nothing is carried along: "),
        ("action", "Penalty", "points are given by {action: score"),
        ("action", "goto_phase", "write set_phase"),
        ("action", "pause", "a pause is a phase"),
        ("trigger", "collision", "write touches"),
        ("trigger", "timeout", "write timer_expired"),
        ("trigger", "goal", "a goal is {trigger: enters, entity: ball"),
        ("condition", "inside", "write in_zone"),
        ("condition", "outside", "write in_zone, with negate: true"),
        ("condition", "and", "write all_of"),
        ("condition", "random", "what chance decides is a draw"),
    ],
)
def test_a_word_of_elsewhere_is_told_what_it_is_called_here(kind, word, way_out):
    written = f"{{{kind}: {word}}}"
    texts = {
        "trigger": lambda: rule(written),
        "action": lambda: rule(action=written),
        "condition": lambda: rule(rest=f"    conditions: [{written}]\n"),
    }
    (text,) = complaints(KNOWN + texts[kind]())
    assert f"unknown {kind} '{word}'" in text
    assert f"; {way_out}" in text


@pytest.mark.parametrize(
    ("section", "word", "meant"),
    [
        ("zones", "rectangle", "rect"),
        ("zones", "box", "rect"),
        ("zones", "disc", "circle"),
        ("zones", "triangle", "polygon"),
        ("obstacles", "rectangle", "box"),
        ("obstacles", "cube", "box"),
        ("obstacles", "circle", "cylinder"),
        ("obstacles", "pole", "cylinder"),
        ("obstacles", "line", "wall"),
    ],
)
def test_a_shape_of_another_name_is_told_the_one_that_stands_there(section, word, meant):
    (text,) = complaints(f"{section}: {{thing: {{shape: {word}}}}}\n")
    assert text.startswith(f"{section}.thing: unknown shape '{word}'")
    assert text.endswith(f"; write {meant}")


def test_a_shape_that_nobody_knows_gets_no_advice():
    (text,) = complaints("zones: {thing: {shape: banana}}\n")
    assert text.endswith("there are rect, circle, polygon, half_plane")


def test_no_word_of_the_language_is_taken_for_one_of_elsewhere():
    assert not [(kind, word) for kind, word in table() if word in WORDS[kind]]


@pytest.mark.parametrize("kind", WORDS)
def test_what_is_to_be_written_instead_is_a_word(kind):
    meant = {
        one
        for (of, _), hint in table().items()
        if of == kind
        for one in re.findall(r"^write ([a-z_]+)(?=[,:]|$)", hint)
    }
    assert len(meant) > 5
    assert meant <= {*WORDS[kind], "phases"}


@pytest.mark.parametrize(
    "action", sorted({part for hint in table().values() for part in re.findall(r"\{action: .*?\}", hint)})
)
def test_what_stands_in_braces_can_be_written_like_that(action):
    named = {"counter: NAME": "counter: laps", "entrant: NAME": "entrant: yellow", "timer: NAME": "timer: clock"}
    named["event: NAME"] = "event: SEEN"
    for placeholder, name in named.items():
        action = action.replace(placeholder, name)
    assert scenario(KNOWN + rule(action=action)).rules["r"].actions


KEYS = {
    (kind, *found.groups())
    for (kind, _), hint in table().items()
    if (found := re.fullmatch(r"(?:.*; )?write (\w+), with (\w+)(?: or .*|: .*)?", hint))
}


@pytest.mark.parametrize(("kind", "word", "key"), sorted(KEYS))
def test_a_key_that_is_told_is_one_of_that_word(kind, word, key):
    written = f"{{{kind}: {word}, {key}: {{}}}}"  # of the wrong kind, at best
    texts = {
        "trigger": lambda: rule(written),
        "action": lambda: rule(action=written),
        "condition": lambda: rule(rest=f"    conditions: [{written}]\n"),
    }
    assert not [text for text in complaints(KNOWN + texts[kind]()) if "unknown" in text]


def test_keys_are_told_of_several_words():
    assert {
        ("condition", "distance", "at_most"),
        ("trigger", "time_reached", "at_s"),
        ("action", "remove", "for_s"),
    } <= KEYS
