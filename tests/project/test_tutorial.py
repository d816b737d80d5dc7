"""The tutorial's commands can be run as they stand; scripts/try_tutorial.py runs all of them from the wheel."""

import shlex

import pytest
import typer.main

from rcj_challenges.cli.app import app
from rcj_challenges.cli.new_team import new_team
from rcj_challenges.scenario.lint.registry import lint
from rcj_challenges.scenario.load import load_text
from scripts.try_tutorial import PAGE, steps, write

STEPS = list(steps(PAGE.read_text(encoding="utf-8")))
COMMANDS = [step.command for step in STEPS if step.command.startswith("rcj-challenge")]
GROUP = typer.main.get_command(app)


@pytest.mark.parametrize("command", COMMANDS)
def test_command_of_the_tutorial_has_options_that_exist(command):
    name, *arguments = shlex.split(command)[1:]
    GROUP.commands[name].make_context(name, arguments, resilient_parsing=False)


def test_changes_of_the_tutorial_fit_the_files_that_it_makes(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    for step in STEPS:
        if step.command == "rcj-challenge new team my_team":
            new_team("my_team")
        elif step.file:
            write(step, tmp_path)
    compile((tmp_path / "my_team" / "robot.py").read_text(encoding="utf-8"), "robot.py", "exec")
    assert (tmp_path / "my_rules.yaml").is_file()


def test_rules_of_the_tutorial_give_no_warning():
    (rules,) = (step for step in STEPS if step.file == "my_rules.yaml")
    assert [str(finding) for finding in lint(load_text(rules.new, file=rules.file))] == []
