"""Every mistake an author would make is in a table with its errors: place, code, path, and what is suggested.

After a deliberate change: ``UPDATE_EXPECTED=1 pytest tests/scenario/test_bad_scenarios.py``, then read the difference.
"""

import os
import re
from pathlib import Path

import pytest
import yaml

from rcj_challenges.scenario.errors import ScenarioError, place_of
from rcj_challenges.scenario.load import load
from rcj_challenges.scenario.reading.yaml_strict import MAX_BYTES
from tests.scenario.writing import HEAD, in_short

TABLE = Path(__file__).with_name("bad_scenarios.yaml")
BASES, MISTAKES = yaml.load(TABLE.read_text(encoding="utf-8"), getattr(yaml, "CSafeLoader", yaml.SafeLoader)).values()  # noqa: S506


def refused(path, overrides=()):
    with pytest.raises(ScenarioError) as caught:
        load(path, overrides)
    return caught.value.diagnostics


def with_place(problem):
    """Return an error as the table has it: ``10:83 unknown-name rules.goal.triggers[0] (enters) -> blue_goal``."""
    place = place_of(problem)
    return f"{'' if place.file == 'it.yaml' else f'{place.file}:'}{place.line}:{place.column} {in_short(problem)}"


def portable(errors):
    """Leave out where syntax errors are: without libyaml PyYAML finds some of them elsewhere."""
    return errors if yaml.__with_libyaml__ else re.sub(r"\d+:\d+ invalid-yaml", "invalid-yaml", errors)


@pytest.fixture
def errors_of(tmp_path, monkeypatch):
    """Return the errors of a scenario that is written beside the bases."""
    (tmp_path / "bases").mkdir()
    for name, text in BASES.items():
        (tmp_path / "bases" / f"{name}.yaml").write_text(text, encoding="utf-8")
    monkeypatch.chdir(tmp_path)

    def errors(text: str | bytes) -> str:
        Path("it.yaml").write_bytes(text if isinstance(text, bytes) else text.encode("utf-8"))
        return "".join(f"{with_place(problem)}\n" for problem in refused("it.yaml"))

    return errors


def goal(mistake):
    """Return a rule for goals with the trigger, condition or action of a mistake."""
    trigger = mistake.get("trigger", "{trigger: enters, entity: ball, zone: blue_goal}")
    action = mistake.get("action", "{action: score, entrant: yellow}")
    conditions = f"    conditions:\n      - {mistake['condition']}\n" if "condition" in mistake else ""
    rule = f"rules:\n  goal:\n    triggers:\n      - {trigger}\n{conditions}    actions:\n      - {action}\n"
    return mistake.get("before", "") + rule


@pytest.mark.parametrize("name", MISTAKES)
def test_mistake_is_refused_with_the_error_beside_it(name, errors_of):
    mistake = MISTAKES[name]
    found = errors_of(mistake["scenario"] if "scenario" in mistake else HEAD + mistake.get("sections", goal(mistake)))
    if os.environ.get("UPDATE_EXPECTED"):
        update(name, found)
        return
    assert portable(found) == portable(MISTAKES[name]["errors"])


def update(name: str, found: str) -> None:
    """Replace the errors of one mistake in the table."""
    text = TABLE.read_text(encoding="utf-8")
    block = "    errors: |\n" + "".join(f"      {line}\n" for line in found.splitlines())
    entry = re.compile(rf"(^  {name}:\n.*?)^    errors: .*?(?=^  \w+:\n|\Z)", re.MULTILINE | re.DOTALL)
    TABLE.write_text(entry.sub(lambda match: match[1] + block, text, count=1), encoding="utf-8", newline="\n")


def test_file_in_another_encoding_is_refused_at_its_byte(errors_of):
    assert errors_of("id: a\ntitle: Schöner Schuß\n".encode("latin-1")) == "2:11 not-utf8\n"


def test_error_is_printed_with_code_place_and_help(tmp_path):
    path = tmp_path / "a.yaml"
    path.write_text("schema_version: 2\nid: a\ntitle: A\nextends: soccersim_v2\nmatch: {halvs: 2}\n", encoding="utf-8")
    with pytest.raises(ScenarioError) as caught:
        load(path)
    code, place, help_ = str(caught.value).splitlines()
    assert code == "error[unknown-key]: unknown key 'halvs'"
    assert place == f"  --> {path}:5:9  match"
    assert help_.startswith("help: did you mean 'halves'?")


def test_file_over_the_size_limit_is_refused_without_reading_it_all(tmp_path):
    huge = tmp_path / "huge.yaml"
    huge.write_bytes(b"# " + b"x" * (3 * MAX_BYTES))
    (problem,) = refused(huge)
    assert (problem.code, place_of(problem).file, place_of(problem).line) == ("scenario-too-large", str(huge), None)


def test_folder_is_not_a_scenario(tmp_path):
    assert [one.code for one in refused(tmp_path)] == ["unreadable-file"]


@pytest.mark.parametrize("source", ["scenarios/match.yaml", "Match", "match.yml", "scenarios\\match.yaml", "matsch"])
def test_unknown_file_is_refused_with_the_nearest_shipped_scenario(source, tmp_path, monkeypatch):
    # Documents write "scenarios/match.yaml"; an installed wheel has no such folder.
    monkeypatch.chdir(tmp_path)
    (problem,) = refused(source)
    assert (problem.code, place_of(problem).file) == ("no-such-file", source)
    assert "did you mean 'match'?" in problem.help


@pytest.mark.parametrize("source", ["a\0b", "x" * 5000, "", "no/such/folder/x.yaml", "."])
def test_impossible_path_is_refused(source):
    assert refused(source)
