"""``explain``: each code has a page."""

import re

import pytest
import typer
from typer.testing import CliRunner

from rcj_challenges.cli.commands import load_app
from rcj_challenges.cli.explain import all_codes, explain
from rcj_challenges.core.errors import RcjError


def call(*arguments: str):
    return CliRunner().invoke(load_app(), arguments)


def test_page_of_a_code_has_its_meaning_and_its_help():
    done = call("explain", "event-loop")
    assert done.exit_code == 0
    assert done.stdout.startswith("event-loop\n\nRules that trigger each other")
    assert "help: add a condition" in done.stdout


def test_all_codes_are_listed():
    done = call("explain")
    assert "each-never-named " in done.stdout


def test_unknown_code_names_the_nearest():
    with pytest.raises(RcjError) as caught:
        explain("event-lop")
    assert caught.value.code == "unknown-code"
    assert "'event-loop'" in caught.value.help


def test_pages_name_only_commands_that_exist():
    commands = typer.main.get_command(load_app()).commands
    tournament = commands["tournament"].commands
    pages = [code.page for code in all_codes().values()]
    named = {found for page in pages for found in re.findall(r"rcj-challenge ([a-z]\S*) ?(\S*)", page)}
    assert {
        (command, word)
        for command, word in named
        if command.strip("`.,") not in commands or (command == "tournament" and word.strip("`.,") not in tournament)
    } == set()
