"""Lint of events that come from one of a group, and that the rule of each hears."""

import pytest

from rcj_challenges.scenario.lint.table import lint
from rcj_challenges.scenario.load import load_text

HIT = "rules: {hit: {%s triggers: [{trigger: touches, entity: %s, other: walls}], actions: [{action: emit, event: HIT}], says: H.}"


@pytest.mark.parametrize(
    ("hit", "hears", "warned"),
    [
        (("for_each: robots,", "each"), "for_each: robots, triggers: [{trigger: event, event: HIT}]", True),
        (("for_each: yellow,", "each"), "for_each: robots, triggers: [{trigger: event, event: HIT}]", True),
        (
            ("for_each: robots,", "each"),
            "for_each: robots, triggers: [{trigger: event, event: HIT, entity: each}]",
            False,
        ),
        (("for_each: robots,", "each"), "triggers: [{trigger: event, event: HIT}]", False),
        (("for_each: yellow,", "each"), "for_each: blue, triggers: [{trigger: event, event: HIT}]", False),
        (("", "Y1"), "for_each: robots, triggers: [{trigger: event, event: HIT}]", False),
        (
            ("for_each: robots,", "each"),
            "for_each: robots, conditions: [{condition: held, entity: each}], triggers: [{trigger: event, event: HIT}]",
            False,
        ),
        (
            ("for_each: penalty_areas,", "robots"),
            "for_each: penalty_areas, triggers: [{trigger: event, event: HIT}]",
            True,
        ),
        # It is about one of those whom the trigger may find.
        (("for_each: penalty_areas,", "robots"), "for_each: robots, triggers: [{trigger: event, event: HIT}]", True),
        (("", "robots"), "for_each: robots, triggers: [{trigger: event, event: HIT}]", True),
        (("", "yellow"), "for_each: robots, triggers: [{trigger: event, event: HIT}]", True),
        (("", "yellow"), "for_each: blue, triggers: [{trigger: event, event: HIT}]", False),
        # Of a rule for each of the yellow ones it is about that one, and not whom the trigger finds.
        (("for_each: yellow,", "blue"), "for_each: blue, triggers: [{trigger: event, event: HIT}]", False),
        (("", "yellow"), "for_each: robots, triggers: [{trigger: event, event: HIT, entity: each}]", False),
        (
            ("for_each: penalty_areas,", "robots"),
            "for_each: penalty_areas, triggers: [{trigger: event, event: HIT, entity: each}]",
            False,
        ),
    ],
)
def test_an_event_of_one_that_each_hears(hit, hears, warned):
    rules = f"{HIT % hit}, all: {{{hears}, actions: [{{action: emit, event: E}}, {{action: hold, entity: robots, for_s: 1}}], says: A.}}}}\n"
    loaded = load_text("schema_version: 1\nid: it\ntitle: It\nextends: soccersim_v2\nmatch: {half_s: 60}\n" + rules)
    assert ("event_heard_by_each" in {one.kind for one in lint(loaded)}) is warned


@pytest.mark.parametrize(
    ("hit", "hears", "about"),
    [
        (("", "Y1"), "entity: blue_penalty_area", "Y1"),
        (
            ("for_each: penalty_areas,", "yellow"),
            "entity: blue_goal",
            "Y1, Y2, Y3, blue_penalty_area, yellow_penalty_area",
        ),
        (("for_each: penalty_areas,", "yellow"), "entity: B1", "Y1, Y2, Y3, blue_penalty_area, yellow_penalty_area"),
        (("for_each: yellow,", "each"), "entity: [blue, ball]", "Y1, Y2, Y3"),
        # Whom the trigger finds is another one than the one that the rule is for.
        (("for_each: yellow,", "[blue, each]"), "entity: blue", "Y1, Y2, Y3"),
        (("for_each: penalty_areas,", "yellow"), "entity: blue_penalty_area", ""),
        (("for_each: penalty_areas,", "yellow"), "entity: Y2", ""),
        (("for_each: yellow,", "each"), "entity: [B1, Y3]", ""),
        (("for_each: yellow,", "each"), "entity: robots", ""),
    ],
)
def test_an_event_that_is_never_about_whom_a_rule_hears_it_of(hit, hears, about):
    rules = f"{HIT % hit}, all: {{triggers: [{{trigger: event, event: HIT, {hears}}}], actions: [{{action: end}}], says: A.}}}}\n"
    loaded = load_text("schema_version: 1\nid: it\ntitle: It\nextends: soccersim_v2\nmatch: {half_s: 60}\n" + rules)
    assert [one.problem.message for one in lint(loaded) if one.kind == "rule_never_fires"] == (
        [f"'HIT' is about {about} only, as the rules that emit it are"] if about else []
    )


def test_who_hears_of_a_door_passes_on_whom_it_found_and_not_the_door():
    rules = HIT % ("for_each: penalty_areas,", "yellow")
    rules += ", on: {triggers: [{trigger: event, event: HIT, entity: penalty_areas}], actions: [{action: emit, event: ON}], says: O.}"
    rules += (
        ", all: {triggers: [{trigger: event, event: ON, entity: penalty_areas}], actions: [{action: end}], says: A.}}\n"
    )
    loaded = load_text("schema_version: 1\nid: it\ntitle: It\nextends: soccersim_v2\nmatch: {half_s: 60}\n" + rules)
    assert [one.problem.message for one in lint(loaded) if one.kind == "rule_never_fires"] == [
        "'ON' is about nobody in particular, as the rules that emit it are"
    ]


def test_of_an_event_that_nobody_emits_that_is_told_and_not_whom_it_is_about():
    rules = "rules: {all: {triggers: [{trigger: event, event: HIT, entity: Y1}], actions: [{action: end}], says: A.}}\n"
    loaded = load_text("schema_version: 1\nid: it\ntitle: It\nextends: soccersim_v2\nmatch: {half_s: 60}\n" + rules)
    kinds = {one.kind for one in lint(loaded)}
    assert "event_never_emitted" in kinds
    assert "rule_never_fires" not in kinds


@pytest.mark.parametrize(
    ("waits", "key"),
    [
        ("{trigger: event, event: HIT}", "entity"),
        ("{trigger: enters, entity: ball, zone: blue_goal}", "zone"),
        ("{trigger: event, event: HIT}, {trigger: enters, entity: ball, zone: blue_goal}", "zone"),
    ],
)
def test_a_rule_over_zones_that_hears_events_names_each_by_the_key_that_events_have(waits, key):
    rules = HIT % ("for_each: penalty_areas,", "yellow")
    rules += f", all: {{for_each: penalty_areas, triggers: [{waits}], actions: [{{action: end}}], says: A.}}}}\n"
    loaded = load_text("schema_version: 1\nid: it\ntitle: It\nextends: soccersim_v2\nmatch: {half_s: 60}\n" + rules)
    told = {one.problem.path: one.remedy for one in lint(loaded) if one.kind == "each_never_named"}
    assert told["rules.all.for_each"] == f"write {key}: each where it looks or acts, or leave for_each out"


def test_an_event_that_is_about_nobody():
    rules = "rules: {hit: {triggers: [{trigger: half_started}], actions: [{action: emit, event: HIT}], says: H.}, "
    rules += "all: {triggers: [{trigger: event, event: HIT, entity: Y1}], actions: [{action: end}], says: A.}}\n"
    loaded = load_text("schema_version: 1\nid: it\ntitle: It\nextends: soccersim_v2\nmatch: {half_s: 60}\n" + rules)
    (one,) = (one for one in lint(loaded) if one.kind == "rule_never_fires")
    assert str(one).endswith(
        "rules.all.triggers[0] (event): 'HIT' is about nobody in particular, as the rules that emit it are; give the rule that "
        "emits it a for_each over those that are meant, or leave entity out here [rule_never_fires]"
    )


@pytest.mark.parametrize(
    ("rule", "key"),
    [
        ("for_each: robots, triggers: [{trigger: enters, entity: robots, zone: blue_goal}]", "entity"),
        ("for_each: yellow, triggers: [{trigger: touches, entity: yellow, other: ball}]", "entity"),
        ("for_each: robots, triggers: [{trigger: program_fault}]", "robot"),
        ("for_each: penalty_areas, triggers: [{trigger: enters, entity: ball, zone: penalty_areas}]", "zone"),
        ("for_each: robots, triggers: [{trigger: enters, entity: [robots], zone: blue_goal}]", "entity"),
        ("for_each: yellow, triggers: [{trigger: enters, entity: [Y3, Y1, Y2], zone: blue_goal}]", "entity"),
        ("for_each: robots, triggers: [{trigger: touches, entity: ball, other: robots}]", "other"),
        # Who does something about the other one has thought of both.
        (
            (
                "for_each: robots, conditions: [{condition: held, entity: other}], "
                "triggers: [{trigger: touches, entity: ball, other: robots}]"
            ),
            "",
        ),
        ("for_each: robots, triggers: [{trigger: event, event: HIT, entity: robots}]", "entity"),
        (
            "for_each: robots, triggers: [{trigger: holds, condition: {condition: in_zone, entity: robots, zone: blue_goal}}]",
            "entity",
        ),
        # That it is true of all of them, or of none, is not about one of them.
        (
            "for_each: robots, triggers: [{trigger: holds, condition: {condition: in_zone, entity: robots, of: all, zone: blue_goal}}]",
            "",
        ),
        (
            "for_each: robots, triggers: [{trigger: holds, condition: {condition: in_zone, entity: robots, negate: true, zone: blue_goal}}]",
            "",
        ),
        ("for_each: robots, triggers: [{trigger: event, event: HIT, entity: yellow}]", ""),
        ("for_each: robots, triggers: [{trigger: enters, entity: each, zone: blue_goal}]", ""),
        ("for_each: yellow, triggers: [{trigger: enters, entity: robots, zone: blue_goal}]", ""),
        ("for_each: robots, triggers: [{trigger: touches, entity: robots, other: each}]", ""),
        ("for_each: Y1, triggers: [{trigger: enters, entity: Y1, zone: blue_goal}]", ""),
        ("triggers: [{trigger: enters, entity: robots, zone: blue_goal}]", ""),
        # Whoever asks something of each has thought of all of them.
        (
            (
                "for_each: robots, triggers: [{trigger: enters, entity: robots, zone: blue_goal}], "
                "conditions: [{condition: in_zone, entity: each, zone: blue_goal, negate: true}]"
            ),
            "",
        ),
    ],
)
def test_a_rule_of_each_that_waits_for_any(rule, key):
    tells = "{action: emit, event: E, payload: {which: {word: each_name}}}"
    hit = HIT % ("for_each: robots,", "each")
    text = f"{hit}, it: {{{rule}, actions: [{tells}, {{action: score, entrant: blue}}], says: A.}}}}\n"
    loaded = load_text("schema_version: 1\nid: it\ntitle: It\nextends: soccersim_v2\nmatch: {half_s: 60}\n" + text)
    found = [one.remedy for one in lint(loaded) if one.kind == "any_heard_by_each"]
    remedy = f"write {key}: each, so that it fires for that one only, or leave for_each out and name them all"
    assert found == ([remedy] if key else [])
