"""``other``, the one that is touched: where it may stand, and what lint makes of rules that name it."""

import pytest

from rcj_challenges.rules.refs import Ref, refs_of
from rcj_challenges.scenario.rule_effects import with_names
from tests.scenario.test_cross_references import WORLD
from tests.scenario.writing import loaded, problems_of
from tests.whole_scenarios.models import all_models

TOUCH = "{trigger: touches, entity: each, other: %s}"


def refers(action="{action: end}", condition="", touched="robots", trigger="", for_each="robots"):
    """Whether a rule of touches is in order; else what is said."""
    body = (
        f"rules:\n  r:\n    for_each: {for_each}\n    triggers: [{TOUCH % touched}{trigger}]\n"
        f"    conditions: [{condition}]\n    actions: [{action}]\n"
    )
    return [problem.code for problem in problems_of(loaded, WORLD + body)]


@pytest.mark.parametrize(
    "condition",
    [
        "entity: other, in: pitch", "entity: [each, other], in: pitch, of: all",
        "distance: [each, other], at_most: 1", "speed: other, at_least: 0.1",
        "entity: other, looks: each", "entity: each, looks: other",
        "counter: pushes, entity: other, at_least: 1", "timer: own, entity: other",
        "last_touch: ball, equals: other", "last_touch: other, equals: each",
    ],
)  # fmt: skip
def test_a_condition_can_ask_about_it(condition):
    assert refers(condition=f"{{{condition}}}") == []
    assert refers(condition=f"{{any_of: [{{{condition}}}]}}") == []


@pytest.mark.parametrize(
    "action",
    [
        "place, entity: other, at: {relative_to: each, offset_m: [0, 0.2]}, facing: {towards: each}",
        "place, entity: each, at: {nearest_free: all_spots, to: other}, facing: {towards: other}",
        "place, entity: ball, at: {relative_to: other}, kick: {towards: {relative_to: other}, speed_mps: 1}",
        "remove, entity: [other, each], for_s: 2",
        "count, counter: pushes, entity: other, by: {counter: pushes, entity: other}",
        "timer, timer: own, entity: other, do: start",
        "score, entrant: other, points: {sum: [1, {counter: pushes, entity: other}, {distance: [each, other]}]}",
        "score, entrant: {last_touch: other}",
        "emit, event: E, payload: {a: {word: other_name}, b: {position_of: other}, c: {last_touch: other}}",
    ],
)
def test_an_action_can_act_on_it(action):
    assert refers(f"{{action: {action}}}") == []


def test_it_may_be_a_ball_that_is_kicked_or_an_obstacle_that_moves():
    assert refers("{action: place, entity: other, at: start, kick: {towards: start, speed_mps: 1}}", "", "balls") == []
    assert refers("{action: set_flag, flag: seen, entity: other}", "", "movers", for_each="blue") == []


@pytest.mark.parametrize(
    ("action", "touched", "code"),
    [
        ("remove, entity: other", "post", "wrong-kind"),
        ("remove, entity: other", "[blue, walls]", "wrong-kind"),
        ("count, counter: blue_pushes, entity: other", "robots", "wrong-kind"),
        ("score, entrant: other", "[ball, blue]", "wrong-kind"),
        ("place, entity: other, at: start, kick: {towards: start, speed_mps: 1}", "yellow", "wrong-kind"),
        ("place, entity: ball, at: {spot: other}", "robots", "unbound-name"),
    ],
)
def test_what_may_be_touched_must_be_of_the_kind_that_is_needed(action, touched, code):
    assert refers(f"{{action: {action}}}", "", touched) == [code]


def test_other_is_never_the_entity_that_touches():
    """Of the robots Y1 is the only one that a rule for Y1 cannot find to be touched."""
    world = "groups: {rest: [B1, B2, B3, Y2, Y3]}\ncounters: {hits: {per: rest}}\nrules:\n  r:\n    %s\n"
    body = "triggers: [{trigger: touches, entity: %s, other: robots}], actions: [{action: count, counter: hits, entity: other}]"
    inside = body.replace(", actions", "\n    actions")
    assert problems_of(loaded, world % (inside % "Y1")) == []
    assert problems_of(loaded, world % ("for_each: Y1\n    " + inside % "each")) == []
    assert problems_of(loaded, world % (inside % "robots"))


def test_a_rule_with_another_trigger_does_not_know_it():
    for part in ({"action": "{action: remove, entity: other}"}, {"action": "{action: score, entrant: other}"},
                 {"condition": "{entity: other, in: pitch}"}):  # fmt: skip
        assert refers(**part) == []
        assert refers(trigger=", {trigger: half_started}", **part) == ["unbound-name"]


def test_other_is_unknown_outside_of_rules():
    broadcast = "broadcast: {fields: {at: {position_of: other}}}\n"
    assert [problem.code for problem in problems_of(loaded, broadcast)] == ["unbound-name"]
    layout = "placements: {all: [{entity: ball, at: {relative_to: other}}]}\n"
    assert [problem.code for problem in problems_of(loaded, layout)] == ["unbound-name"]


def test_an_entrant_may_be_called_other():
    body = "entrants: {other: {radio_channel: 5, robots: {Z1: robot.py}}}\nrobots: {Z1: {colour: red, number: 1, kit: v2, start: {x_m: 0, y_m: 0.2, yaw_rad: 0}}}\n"
    touch = "rules: {r: {triggers: [{trigger: touches, entity: ball, other: walls}], actions: [{action: score, entrant: other}]}}\n"
    assert problems_of(loaded, body + touch) == []


EACH_FIELDS = [
    (model, key) for model in all_models() for _, key, ref in refs_of(model) if isinstance(ref, Ref) and ref.each
]


@pytest.mark.parametrize(("model", "key"), EACH_FIELDS, ids=lambda part: getattr(part, "__name__", part))
def test_wherever_each_may_stand_other_is_replaced_too(model, key):
    name = next(name for name, info in model.model_fields.items() if (info.alias or name) == key)
    for written, expected in (
        ("other", "B1"),
        (("each", "other"), ("each", "B1")),
        ("each", "each"),
        ((0.5, 1.0), (0.5, 1.0)),
    ):
        part = model.model_construct(**{**dict.fromkeys(model.model_fields), name: written})
        assert getattr(with_names((part,), {"other": "B1"})[0], name) == expected


# --- lint -------------------------------------------------------------------------------------------------------------
