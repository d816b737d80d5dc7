"""The page "How do I say …": each of its sentences holds, and holds because of each rule and condition in its lines."""

import re
from copy import deepcopy
from pathlib import Path

import pytest
import yaml

from rcj_challenges.expect.runner import run_test
from rcj_challenges.scenario.lint.registry import lint
from rcj_challenges.scenario.load import Loaded, load

PAGE = (Path(__file__).parents[2] / "docs" / "how-do-i-say.md").read_text("utf-8")
TESTS = yaml.safe_load(Path(__file__).with_suffix(".yaml").read_text("utf-8"))
BASE, *_ = re.findall(r"```yaml\n(.*?)```", PAGE, re.DOTALL)
SENTENCES = dict(re.findall(r"\n\*\*(.+?)[.]\*\* .+?\n\n```yaml\n(.*?)```", PAGE, re.DOTALL))


def whole(need: str, lines: dict, folder: Path) -> Loaded:
    """Return the scenario that has these lines and the tests of a sentence, over the base."""
    (folder / "base.yaml").write_text(BASE, "utf-8")
    head = {"schema_version": 2, "id": "said", "title": "Said", "extends": "base.yaml"}
    path = folder / "said.yaml"
    path.write_text(yaml.safe_dump(head | lines | {"expect": TESTS[need]}, sort_keys=False), "utf-8")
    return load(path)


def differences(loaded: Loaded) -> list[str]:
    return [line for name in loaded.scenario.expect for line in run_test(loaded, name).differences]


def poorer(lines: dict) -> dict[str, dict]:
    """Return the lines without one of their rules (which never runs), a condition, or what makes the ranking."""
    made = {"without ranking": {key: of for key, of in lines.items() if key != "result"}} if "result" in lines else {}
    for name, rule in lines.get("rules", {}).items():
        lame = made[f"without {name}"] = deepcopy(lines)
        lame.setdefault("phases", {})["never"] = {}
        lame["rules"][name]["phases"] = ["never"]
        for number in range(len(rule.get("conditions", ()))):
            lax = made[f"{name} without condition {number}"] = deepcopy(lines)
            del lax["rules"][name]["conditions"][number]
    return made


def test_every_sentence_has_its_tests():
    assert list(SENTENCES) == list(TESTS)
    assert len(SENTENCES) >= 30


@pytest.mark.parametrize("need", SENTENCES)
def test_the_sentence_holds_and_only_because_of_its_lines(need, tmp_path):
    lines = yaml.safe_load(SENTENCES[need])
    loaded = whole(need, lines, tmp_path)
    assert differences(loaded) == []
    assert [str(finding) for finding in lint(loaded) if finding.code != "missing-says"] == []
    idle = [change for change, others in poorer(lines).items() if not differences(whole(need, others, tmp_path))]
    assert idle == []
