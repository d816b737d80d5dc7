"""Loading a scenario: what comes out, and that it can be read again."""

import copy
import errno
import json
import time
from pathlib import Path

import pytest

from rcj_challenges.core.diagnostics import Diagnostic, InFile
from rcj_challenges.scenario.codes import WRONG_VALUE
from rcj_challenges.scenario.errors import ScenarioError, nearest
from rcj_challenges.scenario.load import load, load_resolved, load_text
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.resources import SCENARIOS_FOLDER, names_in
from tests.scenario.writing import HEAD, problems_of

SHIPPED = names_in(SCENARIOS_FOLDER)


@pytest.mark.parametrize("name", SHIPPED)
def test_the_resolved_scenario_is_json_and_reads_as_the_same(name):
    first = load(name)
    text = json.dumps(first.resolved, allow_nan=False)
    again = load_resolved(json.loads(text), name)
    assert again.scenario == first.scenario
    assert again.roster == first.roster
    assert json.dumps(again.resolved) == text
    assert (again.name, again.path) == (name, None)


def test_what_a_record_holds_is_checked_too():
    resolved = copy.deepcopy(load("match").resolved)  # tests share it
    resolved["rules"]["goal_in_blue"]["triggers"][0]["zone"] = "gaol"
    with pytest.raises(
        ScenarioError, match=r"unknown-name(.|\n)*resolved scenario  rules\.goal_in_blue\.triggers\[0\]"
    ):
        load_resolved(resolved)


def test_the_smallest_scenario():
    fields = {"schema_version": 2, "id": "a", "title": "A", "robots": {}, "entrants": {}, "balls": {"ball": {}}}
    assert load_text(json.dumps(fields)).scenario == Scenario.model_validate(fields)


def test_a_text_extends_what_is_shipped_whatever_lies_in_the_current_folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    Path("slalom.yaml").write_text("id: own\n", encoding="utf-8")
    assert "finish" in load_text(HEAD.replace("soccersim_v2", "slalom")).scenario.gates


def problem_at(line, column, path=""):
    return Diagnostic(WRONG_VALUE, "m", where=InFile("f", line, column, path))


def test_problems_come_sorted_by_place_and_once_each():
    a, b, c = problem_at(2, 1, "p"), problem_at(1, 9, "p"), problem_at(1, 10)
    error = ScenarioError([a, b, a, c])
    assert error.diagnostics == (b, c, a)
    assert error.exit_code == 2


@pytest.mark.parametrize(
    ("word", "known", "hint"),
    [
        ("blue_gaol", ["blue_goal", "yellow_goal"], "blue_goal"),
        ("Blue_Goal", ["blue_goal"], "blue_goal"),
        ("distance", ["distance_m", "instance"], "distance_m"),
        ("at_min", ["at_most", "entity"], None),  # the opposite
        ("xyz", ["blue_goal"], None),
        ("x" * 100_000, ["y" * 64], None),
    ],
)
def test_the_nearest_match(word, known, hint):
    assert nearest(word, known) == hint


@pytest.mark.parametrize(
    ("asked", "suggested"),
    [
        ("quiet", "did you mean 'quiet.yaml'?"),  # 'quiet' is what was written
        ("quiet.yml", "did you mean 'quiet.yaml'?"),
        ("Quiet.yaml", "did you mean 'quiet.yaml'?"),
        ("arena", "did you mean 'arena.yml'?"),
        ("sub/slalon", "did you mean 'sub/slalons.yaml'?"),
        ("slalon", "did you mean 'slalom'?"),
        ("elsewhere/slalom.yaml", "did you mean 'slalom'?"),
        (f"sub/{'x' * 300}", "shipped are "),
    ],
)
def test_nearest_own_file_is_suggested_as_it_is_written(tmp_path, monkeypatch, asked, suggested):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "sub").mkdir()
    for name in ("quiet.yaml", "arena.yml", "sub/slalons.yaml"):
        (tmp_path / name).touch()
    with pytest.raises(ScenarioError) as error:
        load(asked)
    assert error.value.diagnostics[0].help.startswith(suggested)


@pytest.mark.parametrize(
    ("head", "line", "code"),
    [
        ("", "key_{0}: 1\n", "unknown-key"),
        ("rules:\n", "  r{0}: {{triggers: [{{trigger: enters, entity: bal{0}, zone: x}}], actions: []}}\n", "unknown-name"),
        ("robots:\n", "  R{0}: {{colour: c{0}, number: 1, kit: v2, start: {{x_m: 0, y_m: 0, yaw_rad: 0}}}}\n", "wrong-value"),
        ("spots:\n", "  s{0}:\n", "missing-value"),
    ],
)  # fmt: skip
def test_many_mistakes_are_answered_with_the_first_ones(head, line, code):
    body = head + "".join(line.format(number, number + 1) for number in range(230))
    found = problems_of(load_text, HEAD + body)
    assert found[0].code == code
    assert str(ScenarioError(found)).count("error[") <= 100


def test_groups_of_groups_of_groups_are_resolved_once_each():
    """Sixty layers in which every group names the one below twice: 2^60 ways down."""
    layers = "".join(f"  g{n}: [h{n}, g{n + 1}]\n  h{n}: [g{n + 1}]\n" for n in range(60))
    found = load_text(HEAD + "groups:\n" + layers + "  g60: [B1, ball]\n")
    assert found.roster.groups["g0"] == ("B1", "ball")


def test_a_scenario_in_an_unreadable_folder_is_not_reported_as_missing(tmp_path, monkeypatch):
    theirs, real = tmp_path / "theirs" / "cup.yaml", Path.stat

    def stat(path, **how):
        if path == theirs:
            raise PermissionError(errno.EACCES, "Permission denied", str(path))
        return real(path, **how)

    monkeypatch.setattr(Path, "stat", stat)
    with pytest.raises(ScenarioError) as refused:
        load(theirs)
    assert [one.code for one in refused.value.diagnostics] == ["unreadable-file"]


def test_the_scenario_of_a_record_is_loaded_as_a_file(tmp_path):
    """Its ``extends: null`` says that all of its base is in it."""
    played = load("slalom")
    recorded = tmp_path / "scenario.json"
    recorded.write_text(json.dumps(played.resolved), encoding="utf-8")
    assert load(recorded).resolved == played.resolved
    assert load(recorded, ["match.half_s=30"]).scenario.match.half_s == 30


@pytest.mark.parametrize("in_circles", [False, True])
def test_many_groups_within_groups_are_checked_quickly(in_circles):
    """Measured as the processor's time, since this one may be busy with other tests."""
    names = [f"g{number}" for number in range(60)]
    groups = {name: ["B1", *(names if in_circles else names[at + 1 :])] for at, name in enumerate(names)}
    began_s = time.process_time()
    problems = problems_of(load_text, f"{HEAD}groups: {json.dumps(groups)}\n")
    assert time.process_time() - began_s < 4
    assert {problem.code for problem in problems} == ({"group-in-itself"} if in_circles else set())
