"""``--help``, completion in the shell, and what may be typed in the place of a path or a number."""

import os
import subprocess
import sys
from pathlib import Path

import pytest
from typer.main import get_command

from rcj_challenges.cli.app import ORGANIZE, PLAY, SUBMIT, WATCH, WRITE
from rcj_challenges.cli.commands import load_app
from rcj_challenges.cli.options import parse_duration
from rcj_challenges.cli.team_args import locate_team, path_or_sample_team
from rcj_challenges.core.diagnostics import DiagnosticError
from rcj_challenges.core.errors import RcjError
from rcj_challenges.scenario.resources import shipped_teams


def commands(group=None, words=()):
    """Yield each command that is listed with the words by which it is called."""
    group = get_command(load_app()) if group is None else group
    for name, command in group.commands.items():
        if hasattr(command, "commands"):
            yield from commands(command, (*words, name))
        elif not command.hidden:
            yield " ".join((*words, name)), command


COMMANDS = dict(commands())


def help_of(command):
    return command.get_help(command.make_context("rcj-challenge", ["x"], resilient_parsing=True))


def test_commands_of_a_tournament_are_listed_in_groups_with_examples():
    group = get_command(load_app()).commands["tournament"]
    text = help_of(group)
    assert [heading for heading in (PLAY, WATCH, ORGANIZE, "Examples") if f"\n{heading}:\n" not in text] == []
    assert "\nCommands:\n" not in text


@pytest.mark.parametrize("name", COMMANDS)
def test_an_option_of_one_value_is_refused_when_given_twice(name):
    for option in COMMANDS[name].params:
        if option.param_type_name == "option" and not (option.multiple or option.is_flag):
            with pytest.raises(DiagnosticError) as error:
                COMMANDS[name].make_context(name, [option.opts[0], "1", option.opts[-1], "1"])
            assert error.value.diagnostics[0].code == "option-given-twice"


@pytest.mark.parametrize("name", COMMANDS)
def test_help_of_a_command_has_an_example_and_no_type_names(name):
    text = help_of(COMMANDS[name])
    assert f"  rcj-challenge {name}" in text.partition("\nExample")[2]
    assert [word for word in ("<bool>", "<str>", "<int>", "<path>", "<list") if word in text] == []


def test_commands_are_listed_in_groups():
    root = get_command(load_app())
    text = help_of(root)
    headings = [line.rstrip(":") for line in text.splitlines() if line.endswith(":") and not line.startswith(" ")]
    assert headings == ["Options", PLAY, WATCH, WRITE, SUBMIT, ORGANIZE, "Examples"]
    assert text.index("  judge ") > text.index(ORGANIZE)


def test_help_loads_no_library_that_draws_frames():
    program = (
        "import sys; sys.argv = ['rcj-challenge', '--help']\n"
        "from rcj_challenges.cli import main\n"
        "try: main()\n"
        "finally: print('loaded:', *[m for m in ('rich', 'pygments', 'numpy', 'pydantic', 'yaml') if m in sys.modules])"
    )
    printed = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True).stdout
    assert printed.splitlines()[-1].strip() == "loaded:"


@pytest.mark.parametrize(
    ("typed", "offered"),
    [
        ("rcj-challenge simu", "simulate"),
        ("rcj-challenge run fast", "fast_shooter"),
        ("rcj-challenge run match --blue ball", "ball_chaser"),
        ("rcj-challenge run match --team blue=ball", "blue=ball_chaser"),
        ("rcj-challenge run match --durat", "--duration"),
    ],
)
def test_the_shell_completes_commands_options_scenarios_and_teams(typed, offered):
    words = typed.split(" ")
    completing = {
        "_RCJ_CHALLENGE_COMPLETE": "complete_bash",
        "COMP_WORDS": typed,
        "COMP_CWORD": str(len(words) - 1),
    }
    program = "import sys; sys.argv = ['rcj-challenge']; from rcj_challenges.cli import main; main()"
    command = [sys.executable, "-c", program]
    done = subprocess.run(command, capture_output=True, text=True, env=os.environ | completing, check=True)
    assert offered in done.stdout.split()


@pytest.mark.parametrize(
    ("text", "seconds"), [("90", 90), ("90s", 90), ("1:30", 90), ("0.5", 0.5), ("1:02.5", 62.5), ("0:05", 5)]
)
def test_a_duration_is_seconds_or_minutes_and_seconds(text, seconds):
    assert parse_duration(text) == seconds


@pytest.mark.parametrize("text", ["", "1:90", "90m", "-5", "nan", "1:2:3", "x"])
def test_what_is_no_duration_is_refused_with_the_forms_that_there_are(text):
    with pytest.raises(DiagnosticError, match=r"error\[bad-duration\]"):
        parse_duration(text)


def test_a_sample_team_is_found_by_its_name_and_an_existing_path_wins(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert locate_team("ball_chaser") == shipped_teams()["ball_chaser"]
    assert path_or_sample_team(Path("ball_chaser")) == shipped_teams()["ball_chaser"]
    (tmp_path / "ball_chaser").mkdir()
    assert locate_team("ball_chaser") == path_or_sample_team(Path("ball_chaser")) == Path("ball_chaser")


def test_a_misspelt_team_is_met_with_the_nearest_name(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    with pytest.raises(RcjError) as refused:
        locate_team("bal_chaser")
    assert refused.value.code == "unknown-team"
    assert "'ball_chaser'" in refused.value.help


def test_the_list_of_teams_names_each_with_a_sentence(capsys, monkeypatch):
    monkeypatch.setenv("COLUMNS", "80")
    load_app()(["teams"], standalone_mode=False)
    lines = capsys.readouterr().out.splitlines()
    assert max(map(len, lines)) <= 80
    listed = dict(line.split(maxsplit=1) for line in lines if not line.startswith(" "))
    assert sorted(listed) == sorted(shipped_teams())
    assert all(listed.values())
