"""Version 1 of the language: in a file an error with the new text, in a record read as what it meant."""

import json
from pathlib import Path

import pytest
import yaml

from rcj_challenges.scenario.errors import ScenarioError
from rcj_challenges.scenario.load import load, load_resolved, load_text

HEAD = "schema_version: %d\nid: it\ntitle: It\nextends: soccersim_v2\n"
KEPT = "counters: {n: {}, laps: {per: robots}}\nflags: {seen: {per: robots}}\ntimers: {clock: {lasts_s: 9, starts: true}}\n"
BOTH = "{condition: flag, flag: f}, {condition: half, equals: 1}"
RULE = "rules: {r: {%striggers: [{trigger: half_started}], conditions: [%s], actions: [%s]}}\n"


def scenario(version: int, action: str, condition: str = "", more: str = ""):
    return in_version(version, KEPT + RULE % (more, condition, action))


def in_version(version: int, sections: str):
    """Return the scenario of a text; of one of version 1 what it is when all is written as the errors say."""
    text = HEAD % version + sections
    return load_text(rewritten(text) if version == 1 else text).scenario


def old_forms(text: str):
    with pytest.raises(ScenarioError) as caught:
        load_text(text)
    assert {one.code for one in caught.value.diagnostics} == {"old-language"}
    return caught.value.diagnostics


def spans(node: yaml.Node, key: yaml.Node | None = None):
    """Yield line and column of each value, and the indices between which it stands with its key."""
    start = node.start_mark
    yield (start.line + 1, start.column + 1), (key or node).start_mark.index, node.end_mark.index
    for one in node.value if isinstance(node, yaml.CollectionNode) else ():
        yield from spans(one[1], one[0]) if isinstance(one, tuple) else spans(one)


def rewritten(text: str) -> str:
    """Return a text in which the new texts stand in the places of all errors about its language."""
    found, sections = {place: span for place, *span in spans(yaml.compose(text))}, ""
    for problem in reversed(old_forms(text)):
        start, end = found[problem.where.line, problem.where.column]
        new, *added = problem.help.removeprefix("write ").removesuffix(", after all other changes").split(", and ")
        text, sections = text[:start] + new + text[end:], "\n".join([sections, *added])
    return f"{text}{sections}\n"


def points(written: str) -> str:
    return f"{{action: score, entrant: blue, points: {written}}}"


@pytest.mark.parametrize(
    ("first", "second"),
    [
        ("3", "3"),
        ("{counter: n}", "{counter: n}"),
        ("[2, {counter: n, weight: -2}]", "{sum: [2, {counter: n, times: -2}]}"),
        ("[{counter: n, weight: 1}, 5]", "{sum: [{counter: n}, 5]}"),
        ("{timer: clock}", "{timer: clock, round: down}"),
        ("{timer: clock, fraction: true}", "{timer: clock}"),
        ("[20, {word: time_s, weight: -3}]", "{sum: [20, {sum: [{word: time_s, round: down}], times: -3}]}"),
        ("{distance: [ball, centre]}", "{distance: [ball, centre], otherwise: 0}"),
        ("[{word: measured, weight: 10}]", "{sum: [{word: measured, otherwise: 0, times: 10}]}"),
        ("{counter: n}, at_least: 2, at_most: 9", "{lowest: [{highest: [{counter: n}, 2]}, 9]}"),
    ],
)
def test_points(first, second):
    assert scenario(1, points(first)) == scenario(2, points(second))


def test_what_is_counted():
    first, second = (f"{{action: count, counter: n, {change}}}" for change in ("at_most: 4", "by: {lowest: [1, 4]}"))
    assert scenario(1, first) == scenario(2, second)


def test_in_a_sum_of_a_rule_for_each_what_is_kept_for_several_was_that_of_all():
    first, second = (
        points("[{counter: laps}, {flag: seen, weight: 2}]"),
        points("{sum: [{sum: {counter: laps}}, {highest: {flag: seen}, times: 2}]}"),
    )
    assert scenario(1, first, more="for_each: robots, ") == scenario(2, second, more="for_each: robots, ")


@pytest.mark.parametrize(
    ("group", "entity"), [("for_each: robots, ", ", entity: others"), ("for_each: yellow, ", ""), ("", "")]
)
def test_the_lowest_of_others(group, entity):
    first = scenario(1, points("1"), "{condition: counter, counter: n, at_most: {lowest: laps}}", group)
    compared = f"{{counter: n, at_most: {{lowest: {{counter: laps{entity}}}}}}}"
    assert first == scenario(2, points("1"), compared, group)


def test_a_record_is_read_like_a_file():
    resolved = load_text(HEAD % 2 + KEPT + RULE % ("", "", points("{timer: clock}"))).resolved
    assert load_resolved({**resolved, "schema_version": 1}).scenario.rules["r"].actions[0].points.round_ == "down"
    assert load_resolved(resolved).scenario.rules["r"].actions[0].points.round_ is None


def test_a_file_of_version_2_is_not_changed():
    with pytest.raises(ScenarioError) as caught:
        scenario(2, points("[2, {counter: n, weight: -2}]"))
    assert [one.code for one in caught.value.diagnostics] == ["wrong-value"]


@pytest.mark.parametrize(
    ("first", "second"),
    [
        ("{condition: in_zone, entity: ball, zone: blue_goal}", "{entity: ball, in: blue_goal}"),
        ("{condition: held, entity: blue, of: all}", "{entity: blue, held: true, of: all}"),
        ("{condition: looks, entity: B1, towards: ball}", "{entity: B1, looks: ball}"),
        ("{condition: looks, entity: B1, heading_rad: 1.5}", "{entity: B1, looks: 1.5}"),
        ("{condition: distance, entity: blue, to: [0, 0], at_most: 1}", "{distance: [blue, [0, 0]], at_most: 1}"),
        ("{condition: speed, entity: ball, at_most: 1}", "{speed: ball, at_most: 1}"),
        ("{condition: way, entity: ball, at_least: 1}", "{way: ball, at_least: 1}"),
        ("{condition: counter, counter: n, equals: 1}", "{counter: n, equals: 1}"),
        ("{condition: counter, counter: blue, equals: {counter: yellow}}", "{score: blue, equals: {score: yellow}}"),
        ("{condition: flag, flag: seen, entity: B1}", "{flag: seen, entity: B1}"),
        ("{condition: timer, timer: clock, negate: true}", "{timer: clock, negate: true}"),
        ("{condition: half, at_least: 2}", "{word: halftime, at_least: 2}"),
        ("{condition: drawn, draw: d, equals: a}", "{draw: d, equals: a}"),
        ("{condition: last_touch, by: blue}", "{last_touch: ball, equals: blue}"),
        ("{condition: told, entity: B1, text: HI}", "{told: B1, text: HI}"),
        ("{condition: sequence_at, sequence: s, step: blue_goal}", "{sequence: s, equals: blue_goal}"),
        ("{condition: spot_free, spot: centre}", "{spot_free: centre}"),
        (
            f"{{condition: any_of, conditions: [{{condition: held, entity: B1}}, {{condition: all_of, conditions: [{BOTH}]}}]}}",
            "{any_of: [{entity: B1, held: true}, [{flag: f}, {word: halftime, equals: 1}]]}",
        ),
        (
            f"{{condition: all_of, conditions: [{BOTH}], negate: true}}",
            "{any_of: [[{flag: f}, {word: halftime, equals: 1}]], negate: true}",
        ),
        (
            f"{{condition: all_of, conditions: [{BOTH}]}}",
            "{flag: f}, {word: halftime, equals: 1}",
        ),
    ],
)
def test_conditions(first, second):
    more = "draws: {d: {values: [a, b]}}\nsequences: {s: {entity: ball, steps: [blue_goal, yellow_goal]}}\n"
    kept = KEPT.replace("flags: {", "flags: {f: {}, ") + more

    def rules(version: int, condition: str, waited_for: str):
        rule = (
            f"{{triggers: [{{trigger: holds, {waited_for}}}], conditions: [{condition}], actions: [{{action: end}}]}}"
        )
        return in_version(version, f"{kept}rules: {{r: {rule}}}\n")

    assert rules(1, first, f"condition: {first}") == rules(2, second, f"conditions: [{second}]")


def test_that_a_robot_is_held_was_a_value_of_its_own():
    emit = "{action: emit, event: E, payload: {a: %s, b: %s}}"
    first = scenario(1, emit % ("{held: B1}", "{word: score, of: blue}"))
    assert first == scenario(2, emit % ("{entity: B1, held: true}", "{score: blue}"))


@pytest.mark.parametrize(
    ("first", "second"),
    [
        ("{action: count, counter: laps}", "{action: count, counter: laps, entity: robots}"),
        ("{action: toggle_flag, flag: seen}", "{action: set_flag, flag: seen, to: opposite, entity: robots}"),
        ("{action: sequence, sequence: s, do: reset}", "{action: reset, sequence: s, entity: yellow}"),
        ("{action: sequence, sequence: s, entity: each}", "{action: reset, sequence: s, entity: each}"),
    ],
)
def test_flags_were_turned_over_and_sequences_reset_by_actions_of_their_own(first, second):
    more = "sequences: {s: {per: yellow, steps: [blue_goal, yellow_goal]}}\n"
    rules = (
        in_version(version, KEPT + more + RULE % ("for_each: yellow, ", "", action)).rules
        for version, action in enumerate((first, second), 1)
    )
    assert next(rules) == next(rules)


RANK = "counters: {n: {}, laps: {per: robots}}\nresult: {rank: [%s]}\nrules: {}\n"
PHASE = "phases: {pause: {lasts_s: 3, clock: stops}}\n"


def recorded(rank: list[dict[str, object]], more: str = ""):
    """Return the scenario of a record that ranks as version 1 did."""
    resolved = load_text(HEAD % 2 + more + RANK % "{score: each, better: more}").resolved
    return load_resolved({**resolved, "result": {"rank": rank}}).scenario


@pytest.mark.parametrize(
    ("first", "second"),
    [
        ({"score": "ascending"}, "{score: each, better: less}"),
        ({"counter": "n"}, "{counter: n, better: more, says: 'N: more is better.'}"),
        (
            {"counter": "laps", "order": "ascending"},
            "{sum: {counter: laps, entity: each}, better: less, says: 'Laps: less is better.'}",
        ),
        (
            {"time": "ascending", "plus": [{"counter": "n", "weight": 5}]},
            "{word: time_s, plus: {counter: n, times: 5}, better: less, says: 'Time with n: less is better.'}",
        ),
        (
            {"time": "descending", "plus": [{"counter": "n", "weight": 5}, {"counter": "laps", "weight": -1}]},
            "{word: time_s, plus: {sum: [{counter: n, times: 5}, {sum: {counter: laps, entity: each}, times: -1}]}, better: more, says: 'Time with n with laps: more is better.'}",
        ),
    ],
)
def test_ranking_of_a_record_is_converted_and_that_of_a_file_is_an_error_with_the_new_line(first, second):
    ranked = in_version(2, RANK % second).result.rank
    assert recorded([first]).result.rank == ranked
    for version in (1, 2):
        assert load_text(rewritten(HEAD % version + RANK % first)).scenario.result.rank == ranked


@pytest.mark.parametrize("plus", ["{}", "{weight: 5}", "{counter: [n], weight: 5}", "n", "5"])
def test_what_was_never_a_ranking_has_no_new_text(plus):
    with pytest.raises(ScenarioError) as caught:
        load_text(HEAD % 2 + RANK % f"{{time: ascending, plus: [{plus}]}}")
    assert "old-language" not in {one.code for one in caught.value.diagnostics}


def test_time_of_a_record_went_on_while_the_clock_stood_still():
    scenario = recorded([{"time": "ascending"}], PHASE + "timers: {played: {lasts_s: 5}}\n")
    assert scenario.result.rank[0].timer == "played_s"
    assert scenario.timers["played_s"].starts
    assert scenario.timers["played_s"].lasts_s is None


def test_the_new_text_for_a_time_that_went_on_comes_with_its_timer():
    text = HEAD % 2 + PHASE + RANK % {"time": "ascending"}
    assert load_text(rewritten(text)).scenario.timers["played"].starts
    (problem,) = old_forms(text.replace("rules:", "timers: {played: {lasts_s: 5}}\nrules:"))
    assert problem.help.endswith(", and timers: {played_s: {starts: true}}")
    assert problem.where.path == "result.rank[0]"


BLOCK = """\
rules:
  goal:
    repeat_for: [yellow, blue]
    for_each: robots
    triggers:
      - trigger: holds
        for_s: 1
        condition:
          condition: half
          equals: 1
    conditions:
      - {counter: n, at_most: {lowest: laps}}
      - condition: counter
        counter: n
        at_least: {param: this}
    actions:
      - action: score
        entrant: blue
        points:
          - 2
          - {counter: n, weight: 3}
"""


def test_each_place_is_an_error_and_nothing_else_is_said_of_it():
    found = [(one.where.line, one.where.column, one.where.path, one.help) for one in old_forms(HEAD % 1 + KEPT + BLOCK)]
    assert found == [
        (1, 17, "schema_version", "write schema_version: 2, after all other changes"),
        (
            10,
            17,
            "rules.goal.repeat_for",
            "write repeat_for: goal, and tables: {goal: {yellow: {}, blue: {}}}",
        ),
        (
            13,
            9,
            "rules.goal.triggers[0] (holds)",
            "write {trigger: holds, for_s: 1, conditions: [{word: halftime, equals: 1}]}",
        ),
        (
            19,
            40,
            "rules.goal.conditions[0] (counter).at_most.lowest",
            "write lowest: {counter: laps, entity: others}",
        ),
        (
            20,
            9,
            "rules.goal.conditions[1] (counter)",
            "write {counter: n, at_least: {param: this}}",
        ),
        (
            27,
            11,
            "rules.goal.actions[0] (score).points",
            "write points: {sum: [2, {counter: n, times: 3}]}",
        ),
    ]


def test_old_forms_of_a_base_are_errors_in_the_base(tmp_path):
    for name, base in (("base", "soccersim_v2"), ("variant", "base.yaml")):
        body = f"rules: {{{name}: {{triggers: [{{trigger: half_started}}], conditions: [{{condition: half}}], actions: []}}}}\n"
        (tmp_path / f"{name}.yaml").write_text(f"id: {name}\ntitle: It\nextends: {base}\n{body}", encoding="utf-8")
    with pytest.raises(ScenarioError) as caught:
        load(tmp_path / "variant.yaml")
    problems = caught.value.diagnostics
    assert [Path(one.where.file).name for one in problems] == ["variant.yaml", "base.yaml"]
    assert all("schema_version" in one.message for one in problems)


def test_a_scenario_of_a_record_is_no_file_of_an_author(tmp_path):
    resolved = load_text(HEAD % 2 + KEPT + RULE % ("", "", points("{timer: clock}"))).resolved
    (tmp_path / "scenario.json").write_text(json.dumps({**resolved, "schema_version": 1}), encoding="utf-8")
    assert load(tmp_path / "scenario.json").scenario.rules["r"].actions[0].points.round_ == "down"
