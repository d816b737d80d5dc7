"""The JSON schema: complete, fresh, and of one mind with the loader."""

import copy
import json

import jsonschema
import pytest

from rcj_challenges.cli.schema import schema
from rcj_challenges.core.errors import RcjError
from rcj_challenges.scenario.json_schema import FILE, scenario_schema, schema_text
from rcj_challenges.scenario.reading.yaml_strict import parse_bytes, parse_text
from rcj_challenges.scenario.resources import PRESETS_FOLDER, SCENARIOS_FOLDER, SCHEMAS_FOLDER
from rcj_challenges.scenario.tree import plain
from tests.scenario.writing import HEAD as FIRST
from tests.scenario.writing import rule

HEAD = FIRST.replace("schema_version: 2", "schema_version: 2")

SCHEMA = scenario_schema()
VALIDATOR = jsonschema.Draft202012Validator(SCHEMA)
FILES = sorted([*SCENARIOS_FOLDER.rglob("*.yaml"), *PRESETS_FOLDER.glob("*.yaml")])
WHOLE = {"schema_version": 2, "id": "a", "title": "A", "robots": {}, "entrants": {}}


def accepts(data):
    return VALIDATOR.is_valid(data)


def test_the_committed_schema_is_fresh():
    assert schema(check=True) == 0


def test_it_is_a_valid_schema_and_the_same_every_time():
    jsonschema.Draft202012Validator.check_schema(SCHEMA)
    assert schema_text() == schema_text()
    assert json.loads(schema_text()) == SCHEMA


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_shipped_files_are_valid_as_they_are_written(path):
    data = plain(parse_bytes(path.read_bytes(), path.name))
    assert [f"{'/'.join(map(str, e.absolute_path))}: {e.message[:200]}" for e in VALIDATOR.iter_errors(data)] == []


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_every_shipped_file_names_the_schema_for_editors(path):
    first = path.read_text(encoding="utf-8").splitlines()[0]
    assert first.startswith("# yaml-language-server: $schema=")
    named = (path.parent / first.partition("=")[2]).resolve()
    assert named == (SCHEMAS_FOLDER / FILE).resolve()


def properties(schema, where=""):
    if isinstance(schema, dict):
        for name, inner in schema.get("properties", {}).items():
            yield f"{where}.{name}", inner
        for key, inner in schema.items():
            if key not in ("if", "then", "else"):
                yield from properties(inner, f"{where}.{key}" if key != "properties" else where)
    elif isinstance(schema, list):
        for inner in schema:
            yield from properties(inner, where)


def test_every_field_is_described():
    found = list(properties(SCHEMA))
    assert len(found) > 300
    assert [where for where, schema in found if not schema.get("description")] == []


def test_every_number_with_a_unit_in_its_name_describes_the_unit():
    units = {
        "_s": (" s", "seconds", "duration"),
        "_m": (" m", "[x, y]"),
        "_rad": ("rad",),
        "_kg": ("kg",),
        "_hz": ("second",),
        "_mb": ("MB",),
    }
    missing = [
        where
        for where, schema in properties(SCHEMA)
        for unit, words in units.items()
        if where.rpartition(".")[2].endswith(unit) and not any(word in schema["description"] for word in words)
    ]
    assert missing == []


@pytest.mark.parametrize(
    "body",
    [
        "match: {half_s: {param: x}, halves: {param: x}, swap_sides: {param: x}}\n",
        "title: {param: x}\n",
        rule("{trigger: enters, entity: {param: x}, zone: [{param: x}, pitch]}"),
        rule("{trigger: displaced, entity: ball, distance_m: {param: x}, axis: {param: x}, from: [{param: x}, 0]}"),
        rule(action="{action: score, entrant: {param: x}, points: {param: x}}"),
        rule(action="{action: emit, event: {param: x}, payload: {a: {param: x}}}"),
        "zones: {pitch: {x_min_m: {param: x}, inverted: {param: x}}}\n",
        "zones: {pitch: {x_min_m: {param: x, times: -1}, x_max_m: {param: x, plus: 0.5}}}\n",
        rule(action="{action: score, entrant: yellow, points: {sum: [{param: x, times: 2, plus: -1}]}}"),
        rule(rest="    phases: {param: x}\n"),
        rule("{trigger: displaced, entity: ball, distance_m: 1, from: {param: x}}"),
        rule(action="{action: remove, entity: ball, back_at: {param: x}}"),
        rule(action="{action: timer, timer: clock, do: {param: x}}"),
        "id: {param: x}\n",
        "schema_version: {param: x}\n",
        # Also for a word by which the schema knows what else may stand there.
        rule("{trigger: {param: x}, entity: ball, zone: pitch}"),
        rule("{trigger: holds, conditions: [{speed: {param: x}, at_most: {param: x}}]}"),
        rule(rest="    conditions: [{word: {param: x}, equals: 1}]\n"),
        rule(action="{action: {param: x}, entity: ball, at: start}"),
        rule(action="{action: place, entity: Y1, at: {start: {param: x}}, facing: {random: {param: x}}}"),
        "zones: {z: {shape: {param: x}, centre_m: [0, 0], radius_m: 0.1}}\n",
        "obstacles: {o: {shape: {param: x}, centre_m: [0, 0], radius_m: 0.1}}\n",
        "robots: {Y1: {devices: {eye: {device: {param: x}}}}}\n",
    ],
)
def test_a_param_may_stand_for_any_single_value(body):
    assert accepts({**plain(parse_text(HEAD, "f")), **plain(parse_text(body, "f"))})


@pytest.mark.parametrize(
    "body", ["match: {param: x}\n", "params: {a: {param: b}}\n", "extends: {param: x}\n",
             "match: {half_s: {param: x, times: a}}\n", "match: {half_s: {param: x, time: 2}}\n", "match: {half_s: {times: 2}}\n"]
)  # fmt: skip
def test_a_param_may_not_stand_for_more(body):
    assert not accepts({**plain(parse_text(HEAD, "f")), **plain(parse_text(body, "f"))})


@pytest.mark.parametrize(
    "body",
    [
        "robots: {B1: null}\n",
        "robots: {B1: {number: 7}}\n",
        "rules: {r: {priority: 3}}\n",
        "zones: {pitch: {x_min_m: 0}}\n",
        "kits: {v2: {devices: {gps: null, ball receiver: {range_m: 1}}}}\n",
        "field: {goals: {blue_goal: {width_m: 0.3}}}\n",
    ],
)
def test_what_extends_may_leave_out_what_its_base_brings(body):
    data = plain(parse_text(body, "f"))
    assert accepts({"extends": "soccersim_v2", **data})


@pytest.mark.parametrize(
    "body",
    [
        rule("{trigger: enters, entity: ball}"),
        rule("{trigger: enterz}"),
        rule("{trigger: half_started, x: 1}"),
        rule(action="{action: place, entity: ball, at: nowhere}"),
        "match: {half_s: -1}\n",
        "match: {half_s: 0.03}\n",
        "match: {halvs: 1}\n",
        "rules: {a-b: {}}\n",
        "rules: {r: {triggers: []}}\n",
        "groups: {g: []}\n",
        "zones: {z: {shape: oval}}\n",
        "draws: {d: {values: [[1]]}}\n",
        "robots: {B1: {start: {x_m: a}}}\n",
        "balls: {ball: {start_m: [0, 0, 0]}}\n",
        "match: null\n",
    ],
)
def test_what_the_loader_refuses_in_form_the_schema_refuses_too(body):
    assert not accepts(plain(parse_text(HEAD + body, "f")))


def test_every_value_of_the_match_that_is_spoilt_is_noticed():
    """Replacing any mapping by a number, and any number by a mapping, must not pass."""
    data = plain(parse_bytes((SCENARIOS_FOLDER / "match.yaml").read_bytes(), "match.yaml"))
    count = 0

    def spoil(node, path):
        nonlocal count
        items = node.items() if isinstance(node, dict) else enumerate(node) if isinstance(node, list) else ()
        for key, value in list(items):
            if (
                path[:1] != ("params",)
                and "payload" not in path
                and count < 60
                and isinstance(value, (dict, int, float))
            ):
                spoilt = copy.deepcopy(data)
                holder = spoilt
                for step in path:
                    holder = holder[step]
                holder[key] = {"x": 1} if not isinstance(value, dict) else [[]]
                assert not accepts(spoilt), (path, key)
                count += 1
            spoil(value, (*path, key))

    spoil({key: data[key] for key in ("match", "flags", "counters", "phases", "placements", "rules")}, ())
    assert count == 60


def test_the_schema_is_written_where_asked(tmp_path, monkeypatch, capsys):
    assert schema(tmp_path / "deep" / "x.json") == 0
    assert (tmp_path / "deep" / "x.json").read_bytes() == schema_text().encode()
    monkeypatch.chdir(tmp_path)
    assert schema(None) == 0
    assert (tmp_path / "schemas" / FILE).is_file()
    assert capsys.readouterr().out.splitlines()[1].replace("\\", "/") == f"schemas/{FILE}"
    with pytest.raises(RcjError, match="cannot be written"):
        schema(tmp_path / "deep")


REPEATED = {"triggers": [{"trigger": "half_started"}], "actions": [{"action": "end"}]}


@pytest.mark.parametrize(
    ("repeated", "fits"),
    [
        ({"yellow": {"zone": "blue_goal"}, "blue": {"zone": "yellow_goal"}}, True),
        ({"yellow": {"others": ["blue", "red"], "worth": {"param": "n"}, "fast": True, "home": [0, 0.5]}}, True),
        ({"yellow": {}}, True),
        ([], False),
        ("yellow", False),
        ({"yellow": "blue_goal"}, False),
        ({"yellow": {"zone": {"of": "blue"}}}, False),
        ({"left-hand": {}}, False),
    ],
)
def test_a_table_has_rows_with_values(repeated, fits):
    assert accepts(WHOLE | {"tables": {"t": repeated}}) is fits


@pytest.mark.parametrize(("tables", "fits"), [("t", True), (["t", "u"], True), ([], False), ({"yellow": {}}, False)])
def test_entries_of_sections_are_repeated_for_tables(tables, fits):
    assert accepts(WHOLE | {"rules": {"r": {"repeat_for": tables, **REPEATED}}}) is fits
    assert (
        accepts(WHOLE | {"spots": {"s": {"repeat_for": tables, "x_m": 0, "y_m": {"param": "y", "of": "other"}}}})
        is fits
    )
    assert accepts(WHOLE | {"broadcast": {"fields": {"b": {"repeat_for": tables, "word": "phase"}}}}) is fits
    assert accepts(WHOLE | {"placements": {"l": [{"repeat_for": tables, "entity": "ball", "at": "start"}]}}) is fits
