"""The tutorial's commands can be run as they stand; scripts/try_tutorial.py runs all of them from the wheel."""

import json
import shlex

import pytest
import typer.main

from rcj_challenges.cli.commands import load_app
from rcj_challenges.cli.new import new
from rcj_challenges.scenario.lint.registry import lint
from rcj_challenges.scenario.load import load_text
from scripts import try_site
from scripts.try_tutorial import PAGE, steps, write
from tests.cli.in_this_process import here
from tests.goldens.plays import STATES, machine, read

TEXT = PAGE.read_text(encoding="utf-8")
STEPS = list(steps(TEXT))
COMMANDS = [step.command for step in STEPS if step.command.startswith("rcj-challenge")]
COMPARE = next(line for line in TEXT.splitlines() if line.startswith("    rcj-challenge compare"))
GROUP = typer.main.get_command(load_app())


@pytest.mark.parametrize("command", [*COMMANDS, COMPARE])
def test_command_of_the_tutorial_has_options_that_exist(command):
    name, *arguments = shlex.split(command)[1:]
    GROUP.commands[name].make_context(name, arguments, resilient_parsing=False)


@pytest.fixture
def followed(tmp_path, monkeypatch):
    """Return the folder with the files that the tutorial makes, and the team as it was made first."""
    monkeypatch.chdir(tmp_path)
    new(["team", "starter"])
    for step in STEPS:
        if step.command == "rcj-challenge new team my_team":
            new(["team", "my_team"])
        elif step.file:
            write(step, tmp_path)
    return tmp_path


@pytest.fixture
def compare(followed, monkeypatch, capsys):
    """Return a function that compares the tutorial's two programs and returns the report."""
    if machine() not in read(STATES):
        pytest.skip(f"other matches than those that were measured: {machine()}")
    what = shlex.split(COMPARE.partition(" --seeds")[0])[1:]

    def compared(*options):
        capsys.readouterr()
        assert here(monkeypatch, followed, *what, *options, "--json") == 0
        return json.loads(capsys.readouterr().out)

    return compared


def test_changes_of_the_tutorial_fit_the_files_that_it_makes(followed):
    compile((followed / "my_team" / "robot.py").read_text(encoding="utf-8"), "robot.py", "exec")
    assert (followed / "my_rules.yaml").is_file()


@pytest.mark.timeout(600)  # two matches of four minutes, which a busy computer plays slowly
@pytest.mark.nightly
def test_the_new_program_does_better_than_the_first_in_the_match_that_is_shown(compare):
    first, new = (command for command in COMMANDS if "--yellow my_team" in command and "--debug" not in command)
    assert first == new
    options = shlex.split(new.removesuffix(" --open"))
    assert "--seed" not in options
    report = compare("--seeds=1", *options[options.index("--duration") :])
    assert report["better"] == 1


@pytest.mark.nightly
@pytest.mark.timeout(3600)
def test_the_new_program_does_better_with_most_seeds(compare):
    report = compare(*shlex.split(COMPARE)[-4:])
    assert len(report["seeds"]) == 20
    assert report["better"] >= 15


def test_rules_of_the_tutorial_give_no_warning():
    (rules,) = (step for step in STEPS if step.file == "my_rules.yaml")
    assert [str(finding) for finding in lint(load_text(rules.new, file=rules.file))] == []


@pytest.mark.parametrize("command", [command for command in try_site.commands() if command.startswith("rcj-challenge")])
def test_command_of_the_page_for_teachers_has_options_that_exist(command):
    name, *arguments = shlex.split(command)[1:]
    GROUP.commands[name].make_context(name, arguments, resilient_parsing=False)
