"""Texts of strangers that would steer a terminal, or turn the direction of what stands beside them."""

import unicodedata
from collections.abc import Callable
from pathlib import Path

import pytest
from rich.table import Table
from rich.text import Text

from rcj_challenges.cli.validate import validate
from rcj_challenges.scenario.load import Loaded, load_text
from rcj_challenges.views.console import console_for
from rcj_challenges.views.drawing import draw_scenario
from rcj_challenges.views.sheet import sheet_html, sheet_markdown

STRANGE = r"\e[2J \e]0;title\a \u009b31m \u202Eturned \u2066x \u200F"
SCENARIO = f"""
schema_version: 2
id: strange
title: "Title {STRANGE}"
description: "Description {STRANGE}\\nsecond line"
extends: soccersim_v2
rules:
  goal:
    says: "says {STRANGE}"
    triggers: [{{trigger: enters, entity: ball, zone: blue_goal}}]
    actions: [{{action: emit, event: GOAL, payload: {{words: "{STRANGE}"}}}}]
"""


def hidden_in(text: str) -> set[str]:
    return {letter for letter in text if unicodedata.category(letter) in ("Cc", "Cf") and letter != "\n"}


@pytest.mark.parametrize(
    "write",
    [
        lambda loaded: draw_scenario(loaded.scenario, loaded.roster),
        lambda loaded: sheet_html(loaded.scenario, loaded.roster),
        lambda loaded: sheet_markdown(loaded.scenario, loaded.roster).replace("\\", ""),
    ],
    ids=["drawing", "sheet in HTML", "sheet in Markdown"],
)
def test_what_is_drawn_has_no_hidden_characters(write: Callable[[Loaded], str]) -> None:
    text = write(load_text(SCENARIO))
    assert hidden_in(text) == set()
    assert "Title" in text
    assert "u202e" in text


def test_validate_prints_no_hidden_characters(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    good, bad = tmp_path / "good.yaml", tmp_path / "bad.yaml"
    good.write_text(SCENARIO, encoding="utf-8")
    bad.write_text(SCENARIO + f'"{STRANGE}": 1\n', encoding="utf-8")
    validate([str(good), str(bad)])
    out, err = capsys.readouterr()
    assert hidden_in(out + err) == set()
    assert "\\u202eturned" in out
    assert "\\u202eturned" in err


def test_the_console_prints_no_hidden_characters(capsys: pytest.CaptureFixture[str]) -> None:
    console = console_for()
    table = Table("col\x1bumn")
    table.add_row("\u202ecell")
    for content in ("\x1b]0;title\x07\u2066", Text("styled\x9b31m", style="bold"), table):
        console.print(content, markup=False, highlight=False)
    out = capsys.readouterr().out
    assert hidden_in(out) == set()
    assert all(letters in out for letters in ("\\x1b]0;title", "\\u2066", "styled\\x9b31m", "\\u202e"))
