"""Names that are meant and not written: a default that is gone, whose counter another is compared with."""

import pytest

from rcj_challenges.scenario.load import load
from tests.scenario.writing import HEAD, complaints, rule


def test_a_default_that_the_base_has_taken_away_is_asked_for():
    head = "schema_version: 1\nid: a\ntitle: A\nextends: empty_field\n"
    body = rule(rest="    conditions: [{condition: last_touch, by: B1}]\n")
    assert complaints(body, head=head) == [
        "rules.r.conditions[0] (last_touch): 'entity' is left out and then means 'ball', which is not here any more; write 'entity'"
    ]


@pytest.mark.parametrize(
    "section",
    [
        "flags: {play: %s}",
        "counters: {play: %s}",
        "timers: {play: {lasts_s: 3}}",
        "spots: {play: %s}",
        "phases: {play: {clock: stops}}",  # that phase is always there
    ],
)
def test_something_else_of_the_name_of_a_default_may_be_taken_away(tmp_path, section):
    own = "{x_m: 0.2, y_m: 0}" if section.startswith("spots") else "{}"
    body = section % own if "%" in section else section
    (tmp_path / "base.yaml").write_text(f"{HEAD}{body}\n", encoding="utf-8")
    kind = section.partition(":")[0]
    head = "schema_version: 1\nid: a\ntitle: A\nextends: base.yaml\n"
    (tmp_path / "a.yaml").write_text(f"{head}{kind}: {{play: null}}\n{rule()}", encoding="utf-8")
    assert load(tmp_path / "a.yaml").scenario.first_phase == "play"


def test_what_a_base_has_taken_away_and_this_file_names_is_told_with_what_there_is():
    head = "schema_version: 1\nid: a\ntitle: A\nextends: empty_field\n"
    balls = "balls: {puck: {start_m: [0, 0]}}\n"
    (text,) = complaints(balls + rule(action="{action: place, entity: ball, at: start}"), head=head)
    assert "unknown entity 'ball': it was removed in empty_field.yaml:" in text
    assert text.endswith("; did you mean 'balls'?")


def test_what_the_command_line_takes_away_is_not_told_as_if_it_had_never_been_there():
    goal = rule("{trigger: enters, entity: ball, zone: blue_goal}")
    (text,) = (one for one in complaints(goal, ["zones.blue_goal=null"]) if one.startswith("rules.r."))
    assert text.endswith("it was removed in --set zones.blue_goal=null; write rules.r anew without it")


@pytest.mark.parametrize("key", ["at_least", "at_most", "equals"])
def test_with_whose_counter_another_is_compared_is_told_in_whole(key):
    counters = "counters: {best_s: {per: robots}, this_s: {per: robots}}\n"
    compared = f"{{condition: counter, counter: best_s, entity: each, {key}: {{counter: this_s}}}}"
    said = "counter 'this_s' is kept per robots: say whose with 'entity'"
    assert complaints(counters + rule(rest=f"    for_each: robots\n    conditions: [{compared}]\n")) == [
        f"rules.r.conditions[0] (counter): {said}, such as {key}: {{counter: this_s, entity: each}}"
    ]


@pytest.mark.parametrize("group", ["robot", "gates"])
def test_whose_it_is_is_not_asked_while_nobody_knows_of_whom_there_is_one(group):
    flags = f"flags: {{seen: {{per: {group}}}}}\n"
    (text,) = complaints(flags + rule(action="{action: set_flag, flag: seen, entity: Y1}"))
    assert text.startswith(f"flags.seen.per: unknown entity, obstacle, zone or gate '{group}'; ")


def test_whose_it_is_is_not_denied_while_a_param_that_is_not_there_says_of_whom_there_is_one():
    counters = "params: {who: robots}\ncounters: {c: {per: {param: how}}}\n"
    (text,) = complaints(counters + rule(action="{action: count, counter: c, entity: Y1}"))
    assert text.startswith("counters.c.per: unknown param 'how'")


def test_who_is_drawn_is_not_doubted_while_nobody_knows_for_whom_a_rule_is():
    draws = "draws: {chosen: {values: [Y1, Y2]}}\n"
    drawn = "    for_each: robotz\n    conditions: [{condition: drawn, draw: chosen, equals: each}]\n"
    (text,) = complaints(draws + rule(rest=drawn))
    assert text.startswith("rules.r.for_each: unknown entity")


@pytest.mark.parametrize("bound", ["at_most: {param: fare_m}", "at_most: {param: far_m, times: 2, plus: {}}"])
def test_a_bound_that_is_wrong_is_there_all_the_same(bound):
    holds = f"{{trigger: holds, condition: {{condition: speed, entity: ball, {bound}}}}}"
    body = rule().replace("{trigger: half_started}", holds)
    texts = complaints("params: {far_m: 1}\n" + body)
    assert texts
    assert not [text for text in texts if "nothing to compare with" in text]


COUNTED = "counters: {tries: {}}\ndraws: {fuse_s: {values: [8, 12]}}\n"


@pytest.mark.parametrize(
    ("body", "remedy"),
    [
        (rule(action="{action: score, entrant: yellow, points: tries}"), "its value is written {counter: tries}"),
        (rule(action="{action: count, counter: tries, to: measured}"), "its value is written {word: measured}"),
        ("timers: {fuse: {lasts_s: fuse_s}}\n", "its value is written {draw: fuse_s}"),
        (
            rule(action="{action: place, entity: Y1, at: start, facing: ball}"),
            "to look at it is written {towards: ball}",
        ),
        (rule(action="{action: score, entrant: yellow, points: trys}"), "found 'trys'"),
        (rule(action="{action: place, entity: Y1, at: start, facing: away}"), "found 'away'"),
        # A bound has no draw: nothing is advised that would be refused.
        (rule(rest="    conditions: [{condition: counter, counter: tries, at_least: fuse_s}]\n"), "found 'fuse_s'"),
    ],
)
def test_a_name_that_stands_for_its_value_is_told_how_that_is_written(body, remedy):
    assert any(text.endswith(remedy) for text in complaints(COUNTED + body)), complaints(COUNTED + body)


@pytest.mark.parametrize(("movable", "advised"), [("", False), (", movable: true", True)])
def test_to_look_at_an_obstacle_is_advised_only_where_that_is_not_refused(movable, advised):
    crate = f"obstacles: {{crate: {{shape: box, centre_m: [0.5, 0], size_m: [0.08, 0.08]{movable}}}}}\n"
    (text,) = complaints(crate + rule(action="{action: place, entity: Y1, at: start, facing: crate}"))
    assert text.endswith("; to look at it is written {towards: crate}") is advised
