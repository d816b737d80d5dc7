"""``{param: NAME}`` and ``--set PATH=VALUE``."""

import json

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from rcj_challenges.core.diagnostics import InFile
from rcj_challenges.scenario.errors import ScenarioError, place_of
from rcj_challenges.scenario.load import load, load_recorded
from rcj_challenges.scenario.resources import shipped_scenarios
from tests.scenario.writing import complaints, errors, problems_of, rule, scenario

PAUSE = "params: {pause_s: 3, side: left}\nphases: {pause: {lasts_s: {param: pause_s}}}\n"


def test_a_param_stands_for_a_value_anywhere():
    found = scenario(
        "params: {far_m: 0.5, who: ball, colour: '#00ff00', yes_: true, n: 2}\n"
        "zones: {z: {shape: circle, centre_m: [0, {param: far_m}], radius_m: {param: far_m}, drawn: {param: yes_}}}\n"
        "balls: {ball: {colour: {param: colour}}}\n"
        + rule("{trigger: enters, entity: {param: who}, zone: z}", rest="    max_executions: {param: n}\n")
    )
    assert found.zones["z"].centre_m == (0, 0.5)
    assert found.zones["z"].drawn is True
    assert found.balls["ball"].colour == "#00ff00"
    assert found.rules["r"].triggers[0].entity == "ball"
    assert found.rules["r"].max_executions == 2


def test_a_wrong_value_is_reported_where_the_param_is_used():
    (problem,) = errors(PAUSE, ["pause_s=-1"])
    assert problem.where == InFile("a.yaml", 6, 35, "phases.pause.lasts_s")
    assert problem.message.endswith("found -1 (param 'pause_s')")


def test_a_resolved_param_cannot_bring_another_param_or_a_formula():
    assert complaints("params: {a: {param: b}, b: 1}\nmatch: {half_s: {param: a}}\n") == ["wrong-value params.a"]
    assert complaints("params: {a: 1}\nmatch: {half_s: {param: a + 1}}\n") == ["unknown-param match.half_s"]


def test_of_a_sequence_of_one_set_makes_one_of_each_and_back():
    one = "sequences: {way: {entity: ball, steps: [pitch, blue_goal]}}\n"
    each = scenario(one, ["sequences.way.per=robots"]).sequences["way"]
    assert (each.entity, each.per) == (None, "robots")
    again = scenario(one.replace("entity: ball", "per: robots"), ["sequences.way.entity=ball"]).sequences["way"]
    assert (again.entity, again.per) == ("ball", None)
    with_param = "params: {who: yellow}\n" + one.replace("entity: ball", "per: {param: who}")
    assert scenario(with_param, ["who=blue"]).sequences["way"].per == "blue"


# --- --set ------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("override", "read"),
    [
        ("pause_s=4.5", lambda s: s.phases["pause"].lasts_s == 4.5),
        ("params.pause_s=4.5", lambda s: s.phases["pause"].lasts_s == 4.5),
        ("match.half_s=1e1", lambda s: s.match.half_s == 10),
        ("match.swap_sides=true", lambda s: s.match.swap_sides is True),
        ("title=no", lambda s: s.title == "no"),
        ("rules.r.triggers[0].zone=[yellow_goal, pitch]", lambda s: s.rules["r"].triggers[0].zone == ("yellow_goal", "pitch")),
        ("rules.r.triggers.0.zone=yellow_goal", lambda s: s.rules["r"].triggers[0].zone == "yellow_goal"),
        ("rules.r.priority=-3", lambda s: s.rules["r"].priority == -3),
        ("rules.r.actions=[{action: end, what: match}]", lambda s: s.rules["r"].actions[0].what == "match"),
        ("zones.pitch={shape: circle, centre_m: [0, 0], radius_m: 1}", lambda s: s.zones["pitch"].radius_m == 1),
        ("counters.extra={initial: 4}", lambda s: s.counters["extra"].initial == 4),
        ("limits.memory_mb=128", lambda s: s.limits.memory_mb == 128),
        ("kits.v2.devices.ball receiver.range_m=0.9", lambda s: s.kits["v2"].devices["ball receiver"].range_m == 0.9),
        ("kits.v2.devices.gps={device: compass}", lambda s: s.kits["v2"].devices["gps"].device == "compass"),
        ("rules.r=null", lambda s: not s.rules),
        ("phases.pause.lasts_s={param: pause_s}", lambda s: s.phases["pause"].lasts_s == 3),
        (" match.half_s = 20 ", lambda s: s.match.half_s == 20),
        ("description='a = b'", lambda s: s.description == "a = b"),
        ("balls.ball.colour=#00ff00", lambda s: s.balls["ball"].colour == "#00ff00"),
        ("title=#1 Köln 😀 \"A\" \\ 'B'", lambda s: s.title == "#1 Köln 😀 \"A\" \\ 'B'"),
        ("balls.ball.colour= '#00ff00'", lambda s: s.balls["ball"].colour == "#00ff00"),
    ],
)  # fmt: skip
def test_an_override_changes_a_param_or_any_value(override, read):
    body = PAUSE + rule("{trigger: enters, entity: ball, zone: blue_goal}")
    assert read(scenario(body, [override]))


def test_an_override_of_a_removed_thing_is_found_by_the_cross_references():
    with pytest.raises(ScenarioError) as caught:
        load("match", ["phases.goal_pause=null"])
    assert "was removed in --set phases.goal_pause=null" in str(caught.value)


@pytest.mark.parametrize(
    ("override", "expected"),
    [
        ("half_s=3", "wrong-override -> match.half_s"),
        ("pause=3", "wrong-override -> pause_s"),
        ("xyz=3", "wrong-override"),
        ("params.pause=3", "wrong-override -> pause_s"),
        ("match.half=3", "wrong-override -> half_s"),
        ("rules.q.priority=3", "wrong-override"),
        ("rules.r.triggers[1].zone=x", "wrong-override"),
        ("rules.r.triggers.x=3", "wrong-override"),
        ("rules[0]=3", "wrong-override"),
        ("title.x=3", "wrong-override"),
        ("match.half_s", "wrong-override"),
        ("=3", "wrong-override"),
        ("match.half_s=", "wrong-override"),
        ("match..half_s=1", "wrong-override"),
        ("match.half_s=&a 3", "invalid-yaml"),
        ("match.half_s=null", "wrong-null match.half_s"),
        ("match.half_s=abc", "wrong-value match.half_s"),
        ("rules.r.actions=[]", "wrong-value rules.r.actions"),
        ("extends=match", "wrong-override"),
        ("extends[0]=match", "wrong-override"),
        ("zones.pitch.shape=oval", "unknown-word zones.pitch"),
    ],
)
def test_an_override_that_leads_nowhere_is_refused_with_the_nearest(override, expected):
    assert complaints(PAUSE + rule(), [override]) == [expected]


def test_a_problem_of_an_override_points_to_the_option():
    with pytest.raises(ScenarioError) as caught:
        load("match", ["match.half_s=abc", "rules.goal_in_blue.triggers[0].zone=gaol"])
    assert [(one.code, place_of(one)) for one in caught.value.diagnostics] == [
        ("wrong-value", InFile("--set match.half_s=abc", path="match.half_s")),
        (
            "unknown-name",
            InFile("--set rules.goal_in_blue.triggers[0].zone=gaol", path="rules.goal_in_blue.triggers[0] (enters)"),
        ),
    ]


LONG_TEST = "expect: {t: {keyframes: [{at_s: 1}], lasts_s: 120}}\n"


@pytest.mark.parametrize(
    ("half_s", "override"),
    [("120", "match.half_s=10"), ("{param: play_s}", "play_s=10"), ("{param: play_s}", "params.play_s=10")],
)
def test_a_half_that_is_shortened_on_the_command_line_contradicts_neither_rules_nor_tests(half_s, override):
    body = (
        f"params: {{play_s: 120}}\nmatch: {{half_s: {half_s}}}\n"
        + rule("{trigger: time_reached, at_s: 90}")
        + LONG_TEST
    )
    assert scenario(body, [override]).match.half_s == 10


def test_a_half_that_the_file_makes_too_short_for_its_test_is_refused():
    assert complaints("params: {play_s: 60}\nmatch: {half_s: {param: play_s}}\n" + LONG_TEST) == [
        "too-late expect.t.lasts_s"
    ]


PATHS = st.text(alphabet="abrules.mtch[]01=_ -", max_size=20) | st.sampled_from(
    [
        "rules.r",
        "match",
        "params.pause_s",
        "kits.v2.devices.gps",
        "rules.r.actions[0]",
        "robots",
        "phases.pause.lasts_s",
    ]
)
VALUES = st.text(max_size=15) | st.sampled_from(["null", "[]", "{}", "1", "{param: pause_s}", "[[1], {a: b}]", "*a"])


@given(PATHS, VALUES)
@example("match", "{param: pause_s}")
@example("rules.r.actions[0]", "null")
def test_any_override_is_either_taken_or_refused_in_words(path, value):
    assert all(str(problem) for problem in problems_of(scenario, PAUSE + rule(), [f"{path}={value}"]))


WITH_PARAMS = [name for name in shipped_scenarios() if load(name).scenario.params]


@pytest.mark.parametrize("name", WITH_PARAMS)
def test_a_recorded_scenario_with_another_value_of_a_param_is_what_its_file_gives_with_it(name):
    loaded = load(name)
    param, value = next(iter(loaded.scenario.params.items()))
    override = f"{param}={value + 1}"
    kept = json.loads(json.dumps(loaded.unresolved))
    assert "expect" not in kept
    again, wanted = load_recorded(loaded.resolved, kept, [override]).scenario, load(name, [override]).scenario
    assert again != loaded.scenario
    assert again == wanted.model_copy(update={"expect": {}, "tables": {}})
    assert list(again.rules) == list(wanted.rules)


def test_tests_in_a_record_do_not_hinder_another_value_of_a_param():
    """Inherited tests that did not fit were written into records too."""
    loaded = load("match")
    kept = {**loaded.unresolved, "expect": {"unfit": {"given": {}, "play_s": 1, "then": [{"rule": "gone"}]}}}
    assert load_recorded(loaded.resolved, kept, ["goal_pause_s=5"]).scenario.params["goal_pause_s"] == 5
