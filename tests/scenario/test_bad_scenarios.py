"""Every mistake an author would make is in a table with its error.

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

TABLE = Path(__file__).with_name("bad_scenarios.yaml")
BASES, MISTAKES = yaml.safe_load(TABLE.read_text(encoding="utf-8")).values()


def complaint(path, overrides=()):
    with pytest.raises(ScenarioError) as caught:
        load(path, overrides)
    return str(caught.value)


def portable(text):
    """The wording of syntax errors is the parser's own; without libyaml PyYAML words them otherwise."""
    return text if yaml.__with_libyaml__ else re.sub(r"(^|:)\d+:\d+: not valid YAML.*", ": not valid YAML", text)


@pytest.fixture
def error_of(tmp_path, monkeypatch):
    """Return the error of a scenario that is written beside the bases, without its own file's name."""
    (tmp_path / "bases").mkdir()
    for name, text in BASES.items():
        (tmp_path / "bases" / f"{name}.yaml").write_text(text, encoding="utf-8")
    monkeypatch.chdir(tmp_path)

    def error(text: str | bytes) -> str:
        Path("it.yaml").write_bytes(text if isinstance(text, bytes) else text.encode("utf-8"))
        return re.sub(r"^it\.yaml:", "", complaint("it.yaml"), flags=re.MULTILINE) + "\n"

    return error


@pytest.mark.parametrize("name", MISTAKES)
def test_mistake_is_refused_with_the_error_beside_it(name, error_of):
    found = error_of(MISTAKES[name]["scenario"])
    if os.environ.get("UPDATE_EXPECTED"):
        update(name, found)
        return
    assert portable(found) == portable(MISTAKES[name]["errors"])


def update(name: str, found: str) -> None:
    """Replace the errors of one mistake in the table."""
    text = TABLE.read_text(encoding="utf-8")
    block = "    errors: |\n" + "".join(f"      {line}\n" for line in found.splitlines())
    entry = re.compile(rf"(^  {name}:\n    scenario: .*?)^    errors: .*?(?=^  \w+:\n|\Z)", re.MULTILINE | re.DOTALL)
    TABLE.write_text(entry.sub(lambda match: match[1] + block, text, count=1), encoding="utf-8", newline="\n")


def test_file_in_another_encoding_is_refused_at_its_byte(error_of):
    assert error_of("id: a\ntitle: Schöner Schuß\n".encode("latin-1")) == (
        "2:11: not UTF-8: byte 0xf6; save the file as UTF-8\n"
    )


def test_mistakes_have_different_errors():
    assert len({one["errors"].partition(": ")[2] for one in MISTAKES.values()}) >= 0.9 * len(MISTAKES)


@pytest.mark.parametrize("name", MISTAKES)
def test_every_line_of_an_error_has_a_position(name):
    for line in MISTAKES[name]["errors"].splitlines():
        assert re.match(r"([\w/]+\.yaml:)?\d+:\d+: \S", line), line


def test_a_file_over_the_size_limit_is_refused_without_reading_it_all(tmp_path):
    huge = tmp_path / "huge.yaml"
    huge.write_bytes(b"# " + b"x" * (3 * MAX_BYTES))
    first, place, _ = complaint(huge).splitlines()
    assert first.startswith(f"error[scenario-too-large]: the scenario has {3 * MAX_BYTES + 2} bytes")
    assert place == f"  --> {huge}"


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
