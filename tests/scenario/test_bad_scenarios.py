"""Every mistake an author would make has its message in a golden file beside it.

After a deliberate change of wording: ``UPDATE_EXPECTED=1 pytest tests/scenario/test_bad_scenarios.py``, then read the
difference.
"""

import os
import re
from pathlib import Path

import pytest
import yaml

from rcj_challenges.scenario.errors import ScenarioError
from rcj_challenges.scenario.load import load
from rcj_challenges.scenario.reading.yaml_strict import MAX_BYTES

FOLDER = Path(__file__).resolve().parent.parent / "bad_scenarios"
BAD = sorted(path.name for path in FOLDER.glob("*.yaml"))


def complaint(path, overrides=()):
    with pytest.raises(ScenarioError) as caught:
        load(path, overrides)
    return str(caught.value)


def portable(text):
    """The wording of syntax errors is the parser's own; without libyaml PyYAML words them otherwise."""
    return text if yaml.__with_libyaml__ else re.sub(r":\d+:\d+: not valid YAML.*", ": not valid YAML", text)


@pytest.mark.parametrize("name", BAD)
def test_a_wrong_scenario_is_refused_with_the_message_beside_it(name, monkeypatch):
    monkeypatch.chdir(FOLDER)
    golden = FOLDER / name.replace(".yaml", ".expected.txt")
    found = complaint(name) + "\n"
    if os.environ.get("UPDATE_EXPECTED"):
        golden.write_text(found, encoding="utf-8", newline="\n")
    assert portable(found) == portable(golden.read_text(encoding="utf-8"))


def test_there_are_at_least_sixty_different_mistakes():
    assert len(BAD) >= 60
    goldens = {path.read_text(encoding="utf-8").partition(": ")[2] for path in FOLDER.glob("*.expected.txt")}
    assert len(goldens) >= 0.9 * len(BAD)


def test_every_golden_file_has_its_scenario():
    assert {path.name.replace(".expected.txt", ".yaml") for path in FOLDER.glob("*.expected.txt")} == set(BAD)


@pytest.mark.parametrize("name", BAD)
def test_every_line_names_the_file_and_says_something(name):
    lines = (FOLDER / name.replace(".yaml", ".expected.txt")).read_text(encoding="utf-8").splitlines()
    assert lines
    for line in lines:
        assert re.match(r"[\w/]+\.yaml:\d+:\d+: \S", line), line


def test_a_file_over_the_size_limit_is_refused_without_reading_it_all(tmp_path):
    huge = tmp_path / "huge.yaml"
    huge.write_bytes(b"# " + b"x" * (3 * MAX_BYTES))
    assert (
        complaint(huge)
        == f"{huge}: {3 * MAX_BYTES + 2} bytes are too much for a scenario; at most {MAX_BYTES} are read"
    )


def test_a_folder_is_no_scenario(tmp_path):
    assert "this is no file" in complaint(tmp_path)


@pytest.mark.parametrize("source", ["scenarios/match.yaml", "Match", "match.yml", "scenarios\\match.yaml"])
def test_who_means_a_shipped_scenario_is_told_its_name_and_not_that_of_another(source, tmp_path, monkeypatch):
    # Documents write "scenarios/match.yaml": who has installed a wheel has no such folder.
    monkeypatch.chdir(tmp_path)
    with pytest.raises(ScenarioError, match=r"did you mean 'match'\?"):
        load(source)


def test_an_unknown_file_names_the_shipped_scenarios_and_the_nearest():
    text = complaint("matsch")
    assert text.startswith("matsch: no such file")
    assert "match" in text
    assert text.endswith("did you mean 'match'?")


@pytest.mark.parametrize("source", ["a\0b", "x" * 5000, "", "no/such/folder/x.yaml", "."])
def test_a_path_that_cannot_be_is_refused_in_words(source):
    assert complaint(source)
