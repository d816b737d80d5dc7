"""``{param: NAME}`` and ``--set PATH=VALUE``."""

import json

import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from rcj_challenges.scenario.errors import ScenarioError
from rcj_challenges.scenario.load import load, load_recorded, load_text
from rcj_challenges.scenario.resources import shipped_scenarios
from tests.scenario.writing import HEAD, complaints, problems_of, rule, scenario

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


def test_params_are_resolved_after_merging_so_that_a_variant_changes_one_line(tmp_path):
    (tmp_path / "base.yaml").write_text(HEAD + PAUSE, encoding="utf-8")
    (tmp_path / "mine.yaml").write_text("extends: base.yaml\nparams: {pause_s: 7}\n", encoding="utf-8")
    assert load(tmp_path / "mine.yaml").scenario.phases["pause"].lasts_s == 7


def test_a_wrong_value_is_reported_where_the_param_is_used():
    with pytest.raises(ScenarioError) as caught:
        load_text(HEAD + PAUSE, ["pause_s=-1"], file="a.yaml")
    assert str(caught.value) == (
        "a.yaml:6:35: phases.pause.lasts_s: a duration must be at least one tick (0.032 s), found -1 (param 'pause_s')"
    )


def test_a_payload_may_have_a_key_called_param():
    found = scenario(rule(action="{action: emit, event: E, payload: {param: x}}"))
    assert found.rules["r"].actions[0].payload == {"param": "x"}


def test_a_resolved_param_cannot_bring_another_param_or_a_formula():
    assert complaints("params: {a: {param: b}, b: 1}\nmatch: {half_s: {param: a}}\n") == [
        "params.a: expected a text, a number or true/false, found a mapping with param"
    ]
    assert complaints("params: {a: 1}\nmatch: {half_s: {param: a + 1}}\n") == [
        "match.half_s: unknown param 'a + 1'; write {param: a, plus: 1}"
    ]


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


def test_later_overrides_win():
    assert scenario(PAUSE, ["pause_s=4", "pause_s=5"]).phases["pause"].lasts_s == 5


def test_an_override_of_a_removed_thing_is_found_by_the_cross_references():
    with pytest.raises(ScenarioError) as caught:
        load("match", ["phases.goal_pause=null"])
    assert "unknown phase 'goal_pause': it was removed in --set phases.goal_pause=null" in str(caught.value)


@pytest.mark.parametrize(
    ("override", "message"),
    [
        ("half_s=3", "unknown param or section 'half_s'; did you mean 'match.half_s'?"),
        ("pause=3", "unknown param or section 'pause'; did you mean 'pause_s'?"),
        ("xyz=3", "unknown param or section 'xyz'"),
        ("params.pause=3", "params has no 'pause'; there are pause_s, side; did you mean 'pause_s'?"),
        ("match.half=3", "match has no 'half'; it has halves, half_s, swap_sides; did you mean 'half_s'?"),
        ("rules.q.priority=3", "rules has no 'q'; there are r"),
        ("rules.r.triggers[1].zone=x", "rules.r.triggers is a list: its entries are [0] to [0], not '1'"),
        ("rules.r.triggers.x=3", "rules.r.triggers is a list: its entries are [0] to [0], not 'x'"),
        ("rules[0]=3", "rules is no list; there are r"),
        ("title.x=3", "title is a single value, nothing is inside it"),
        ("match.half_s.x=3", "match.half_s is a single value, nothing is inside it"),
        ("match.half_s", "expected PATH=VALUE: a param's name, or a path such as match.half_s=60"),
        ("=3", "expected PATH=VALUE: a param's name, or a path such as match.half_s=60"),
        ("match.half_s=", "expected PATH=VALUE: a param's name, or a path such as match.half_s=60"),
        ("match..half_s=1", "'match..half_s' is no path; write names with dots and list entries with [0]: rules.goal.actions[0]"),
        ("match.half_s=&a 3", "anchor '&a': anchors are not allowed; write the value out"),
        ("match.half_s=null", "match.half_s: null removes named entries of the base only; leave the line out"),
        ("match.half_s=abc", "match.half_s: expected a number or a list, found 'abc'"),
        ("rules.r.actions=[]", "rules.r.actions: must have at least 1 entry, found an empty list"),
        ("extends=match", "what a scenario extends is read before anything is set; write extends: in a file, with what you change"),
        ("extends[0]=match", "what a scenario extends is read before anything is set; write extends: in a file, with what you change"),
        ("zones.pitch.shape=oval", "zones.pitch: unknown shape 'oval'; there are rect, circle, polygon, half_plane"),
    ],
)  # fmt: skip
def test_an_override_that_leads_nowhere_is_refused_with_the_nearest(override, message):
    assert complaints(PAUSE + rule(), [override]) == [message]


def test_a_problem_of_an_override_points_to_the_option():
    with pytest.raises(ScenarioError) as caught:
        load("match", ["match.half_s=abc", "rules.goal_in_blue.triggers[0].zone=gaol"])
    assert str(caught.value).splitlines() == [
        "--set match.half_s=abc: match.half_s: expected a number or a list, found 'abc'",
        (
            "--set rules.goal_in_blue.triggers[0].zone=gaol: rules.goal_in_blue.triggers[0] (enters): unknown zone 'gaol'; "
            "there are pitch, blue_goal, yellow_goal, blue_penalty_area, yellow_penalty_area, in_play, penalty_areas"
        ),
    ]


def test_a_shortened_half_is_no_contradiction():
    body = "match: {half_s: 120}\n" + rule("{trigger: time_reached, at_s: 90}")
    assert scenario(body, ["match.half_s=10"]).match.half_s == 10


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


@settings(max_examples=60, deadline=None)
@given(PATHS, VALUES)
@example("match", "{param: pause_s}")
@example("rules.r.actions[0]", "null")
def test_any_override_is_either_taken_or_refused_in_words(path, value):
    assert all(str(problem) for problem in problems_of(scenario, PAUSE + rule(), [f"{path}={value}"]))


@pytest.mark.parametrize("name", shipped_scenarios())
def test_a_recorded_scenario_with_a_param_set_is_what_its_file_gives_with_it(name):
    loaded = load(name)
    param, value = next(iter(loaded.scenario.params.items()), ("match.halves", loaded.scenario.match.halves))
    override = f"{param}={json.dumps(value)}"
    kept = json.loads(json.dumps(loaded.unresolved))
    again = load_recorded(loaded.resolved, kept, [override]).scenario
    assert again.model_copy(update={"tests": {}}) == loaded.scenario.model_copy(update={"tests": {}})
    assert list(again.rules) == list(loaded.scenario.rules)
