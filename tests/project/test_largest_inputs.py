"""The largest input inside every bound is looked at in time; one more than the bound has a code."""

import pytest

from benchmarks.inputs import MAX_S, archives, checked, processor_s, scenarios, validated
from rcj_challenges.cli.validate import validate
from rcj_challenges.scenario.errors import ScenarioError
from rcj_challenges.scenario.load import load_resolved, load_text
from rcj_challenges.scenario.reading.yaml_strict import MAX_BYTES
from rcj_challenges.scenario.tree import MAX_ITEMS, MAX_KEYS, MAX_VALUES

HEAD = "schema_version: 2\nid: large\ntitle: Large\nextends: soccersim_v2\n"
BOUNDS = {"archive.too_many", "archive.too_deep", "archive.too_many_folders", "sources.large", "sources.unread"}


@pytest.mark.nightly
@pytest.mark.parametrize("name", archives())
def test_archive_inside_every_bound_is_checked_in_time(name: str) -> None:
    archive, codes = archives()[name](), []
    checked(archive)  # what is loaded once for all
    assert processor_s(lambda: codes.extend(checked(archive))) <= MAX_S
    assert BOUNDS.isdisjoint(codes)


@pytest.mark.nightly
@pytest.mark.parametrize("name", scenarios())
def test_scenario_inside_every_bound_is_validated_in_time(name: str) -> None:
    text, found = scenarios()[name](), []
    assert processor_s(lambda: found.extend(validated(text))) <= MAX_S
    assert not any("scenario-too-large" in one for one in found)


def counters(count: int) -> str:
    return "counters:\n" + "".join(f"  c{number}: {{}}\n" for number in range(count))


def params(count: int) -> str:
    return "params: {p: 1, " + ", ".join(f"p{number}: 1" for number in range(count)) + "}\n"


@pytest.mark.parametrize(
    "text",
    [
        counters(MAX_KEYS + 1),
        params(90_000),
        "".join(f"k{number}: 1\n" for number in range(90_000)),
        f"groups: {{g: [{', '.join(['Y1'] * (MAX_ITEMS + 1))}]}}\n",
        "zones:\n" + "".join(f"  z{k}: [" + "0, " * 99 + "0]\n" for k in range(MAX_VALUES // 100)),
        "#" * MAX_BYTES,
    ],
    ids=["counters", "params", "unknown keys", "a list", "values", "bytes"],
)
def test_one_more_than_a_bound_of_scenarios_has_a_code(text: str) -> None:
    with pytest.raises(ScenarioError) as raised:
        load_text(HEAD + text)
    (problem,) = raised.value.diagnostics
    assert problem.code == "scenario-too-large"
    assert problem.help


def test_bounds_hold_for_a_scenario_with_its_bases_together(tmp_path, capsys) -> None:
    (tmp_path / "base.yaml").write_text(HEAD + counters(MAX_KEYS), encoding="utf-8")
    more = "schema_version: 2\nid: more\ntitle: More\nextends: base.yaml\ncounters: {one_more: {}}\n"
    (tmp_path / "more.yaml").write_text(more, encoding="utf-8")
    assert validate([str(tmp_path / "base.yaml")]) == 0
    assert validate([str(tmp_path / "more.yaml")]) == 2
    assert "error[scenario-too-large]" in capsys.readouterr().err


def test_bounds_hold_for_repeated_rules_and_for_scenarios_of_records() -> None:
    rows = ", ".join(f"n{number}: {{}}" for number in range(50))
    tables = f"tables: {{t: {{{rows}}}}}\n"
    rule = "{repeat_for: t, triggers: [{trigger: half_started}], actions: [{action: end}]}"
    with pytest.raises(ScenarioError, match="scenario-too-large"):
        load_text(HEAD + tables + "rules:\n" + "".join(f"  r{number}: {rule}\n" for number in range(6)))
    resolved = load_text(HEAD).resolved
    with pytest.raises(ScenarioError, match="scenario-too-large"):
        load_resolved(resolved | {"counters": {f"c{number}": {} for number in range(MAX_KEYS + 1)}})


def test_scenario_at_the_bound_is_read() -> None:
    assert len(load_text(HEAD + counters(MAX_KEYS)).scenario.counters) == MAX_KEYS
    scenario = load_text(HEAD + f"groups: {{g: [{', '.join(['Y1'] * MAX_ITEMS)}]}}\n").scenario
    assert len(scenario.groups["g"]) == MAX_ITEMS
