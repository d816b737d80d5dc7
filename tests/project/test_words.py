"""Every word of the scenario language has a sentence and an example that runs; the documents are fresh."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from rcj_challenges.expect.runner import run_test
from rcj_challenges.rules.fields import MAX_NAME_CHARACTERS
from rcj_challenges.scenario.json_schema import sentence_of
from rcj_challenges.scenario.lint.registry import lint
from rcj_challenges.scenario.load import Loaded, load, load_text
from rcj_challenges.views.drawing import draw_scenario
from rcj_challenges.views.sheet import sheet_html, sheet_markdown
from scripts import write_reference
from scripts.write_reference import CHAPTERS, Example, example_of, read_examples

ROOT = Path(__file__).resolve().parents[2]
EXAMPLES = read_examples()
WORDS = [(chapter, word) for chapter in CHAPTERS for word in chapter.words]
WITH_A_TEST = ("Triggers", "Conditions", "Actions", "Where things go")
RECIPES = sorted((ROOT / "docs" / "recipes").glob("*.yaml"))


def differences(loaded: Loaded) -> dict[str, tuple[str, ...]]:
    """Return what comes out differently in the tests of a scenario."""
    trials = {name: run_test(loaded, name).differences for name in loaded.scenario.expect}
    return {name: found for name, found in trials.items() if found}


def test_every_word_has_a_sentence_and_every_field_a_description():
    for chapter, word in WORDS:
        assert re.fullmatch(r"[A-Z].{9,}[.]", sentence_of(word.model)), word.name
        tagged = {chapter.tag, "start"}
        missing = [key for key, info in word.model.model_fields.items() if not info.description and key not in tagged]
        # Of single-valued aliases such as noise_m the description stands in the type.
        assert [key for key in missing if not _typed(word.model, key)] == [], word.name


def _typed(model, key: str) -> bool:
    return any(getattr(part, "description", None) for part in model.model_fields[key].metadata)


def test_every_word_has_an_example():
    # The others are parts of something else, and its example shows them.
    for chapter, word in ((chapter, word) for chapter, word in WORDS if word.own_example):
        example = example_of(word, chapter, EXAMPLES)
        assert example is not None, word.name
        assert word.name in example.text or word.name in example.words
        if chapter.title in WITH_A_TEST:
            assert word.name in example.text
            assert "expect:" in example.text, word.name


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda example: f"{example.file}-{example.words[0]}")
def test_every_example_is_a_scenario_with_its_declared_outcome(example: Example):
    assert differences(load_text(example.whole, file=f"{example.file}.yaml")) == {}


def test_no_example_shows_a_word_that_does_not_exist():
    known = {word.example or word.name for _, word in WORDS} | {"params", "groups", "literal"}
    assert {word for example in EXAMPLES for word in example.words} - known == set()


def test_the_reference_is_what_the_models_and_the_examples_say():
    page = write_reference.PAGE.read_text(encoding="utf-8")
    assert page == write_reference.page()
    assert f"at most {MAX_NAME_CHARACTERS} characters" in page


@pytest.mark.parametrize("recipe", RECIPES, ids=lambda path: path.stem)
def test_every_recipe_is_free_of_lint_and_has_its_declared_outcome(recipe):
    loaded = load(recipe)
    assert loaded.scenario.id == recipe.stem
    assert [str(finding) for finding in lint(loaded)] == []
    assert len(loaded.scenario.expect) >= 2
    assert differences(loaded) == {}


def test_every_recipe_has_its_section_on_the_page():
    page = (ROOT / "docs" / "recipes.md").read_text(encoding="utf-8")
    linked = re.findall(r"^\[(\w+\.yaml)\]\(recipes/\1\)$", page, re.MULTILINE)
    assert sorted(linked) == [path.name for path in RECIPES]
    assert len(linked) == page.count("\n## ") > 0


def test_lint_can_look_at_every_example():
    kinds = {finding.code for example in EXAMPLES for finding in lint(load_text(example.whole))}
    # What an example of one word leaves out on purpose, and nothing that would be a mistake in it.
    assert kinds <= {
        "missing-says",
        "no-way-to-score",
        "never-used",
        "never-read",
        "robot-without-program",
        "never-written",
    }


EXAMPLE_CHALLENGES = sorted((ROOT / "scenarios" / "examples").glob("*.yaml"))


@pytest.mark.parametrize("path", EXAMPLE_CHALLENGES, ids=lambda path: path.stem)
def test_the_example_challenges_pass_their_tests_and_every_rule_is_tested(path):
    loaded = load(path)
    trials = [run_test(loaded, name) for name in loaded.scenario.expect]
    assert [trial.differences for trial in trials if trial.differences] == []
    fired = {rule for trial in trials for rule in trial.fired}
    assert set(loaded.scenario.rules) - fired - {"finish"} == set()
    assert f"{path.name}]" in (ROOT / "docs" / "authoring.md").read_text(encoding="utf-8")


@pytest.mark.parametrize("path", EXAMPLE_CHALLENGES, ids=lambda path: path.stem)
def test_the_example_challenges_are_drawn_and_every_sentence_stands_in_their_sheets(path):
    loaded = load(path)
    scenario, roster = loaded.scenario, loaded.roster
    assert all(f">{name}: " in draw_scenario(scenario, roster) for name in (*scenario.robots, *scenario.balls))
    assert sheet_html(scenario, roster).startswith("<!")
    sheet = sheet_markdown(scenario, roster)
    missing = [rule.says for rule in scenario.rules.values() if rule.says.partition("}")[2].strip() not in sheet]
    assert missing == []
