"""Errors with a code, as text and as data."""

import json

import pytest

from rcj_challenges import cli
from rcj_challenges.cli.codes import BAD_NAME
from rcj_challenges.core.code import Code
from rcj_challenges.core.diagnostics import Diagnostic, DiagnosticError, InFile, InMatch

UNKNOWN_ZONE = Diagnostic(
    Code("unknown-zone", "A zone does not exist."),
    "unknown zone 'blue_gaol'",
    "did you mean 'blue_goal'?",
    InFile("fast_shooter.yaml", 41, 18, "rules.goal_in_blue.triggers[0].zone"),
)
NO_BALL = Diagnostic(Code("no-ball", "There is no ball."), "there is no ball")


def test_a_diagnostic_is_printed_with_code_place_and_help():
    assert str(UNKNOWN_ZONE) == (
        "error[unknown-zone]: unknown zone 'blue_gaol'\n"
        "  --> fast_shooter.yaml:41:18  rules.goal_in_blue.triggers[0].zone\n"
        "help: did you mean 'blue_goal'?"
    )


def test_a_diagnostic_without_place_and_help_is_one_line():
    assert str(NO_BALL) == "error[no-ball]: there is no ball"


@pytest.mark.parametrize(
    ("where", "printed"),
    [
        (InFile("a.yaml"), "a.yaml"),
        (InFile("a.yaml", 3), "a.yaml:3"),
        (InFile("--set a=1", path="a"), "--set a=1  a"),
        (InMatch("Y1", 120), "robot Y1, tick 120"),
        (InMatch("Y1", 120, 2), "robot Y1, half 2, tick 120"),
        (InMatch(half=1), "half 1"),
    ],
)
def test_a_place_is_printed_as_far_as_it_is_known(where, printed):
    assert str(where) == printed


def test_control_characters_of_strangers_are_printed_as_escapes_and_stay_in_the_data():
    hostile = Diagnostic(BAD_NAME, "name \x1b[2J", where=InFile("a\nb.yaml"))
    assert str(hostile) == "error[bad-name]: name \\x1b[2J\n  --> a\\nb.yaml"
    assert hostile.to_json()["message"] == "name \x1b[2J"


def test_a_diagnostic_is_data_with_the_same_fields():
    data = json.loads(json.dumps(UNKNOWN_ZONE.to_json()))
    assert data == {
        "level": "error",
        "code": "unknown-zone",
        "message": "unknown zone 'blue_gaol'",
        "help": "did you mean 'blue_goal'?",
        "where": {
            "file": "fast_shooter.yaml",
            "line": 41,
            "column": 18,
            "path": "rules.goal_in_blue.triggers[0].zone",
        },
        "repair": False,
        "details": "",
    }
    assert NO_BALL.to_json()["where"] == ""


@pytest.mark.parametrize("code", ["", "Unknown-zone", "unknown_zone", "unknown--zone", "-x", "1x"])
def test_a_code_of_another_form_is_refused(code):
    with pytest.raises(ValueError, match="not a code"):
        Code(code, "A page.")


def test_many_diagnostics_are_cut_in_the_text_only():
    error = DiagnosticError(*[NO_BALL] * 103)
    assert len(error.diagnostics) == 103
    assert str(error).count("error[no-ball]") == 100
    assert str(error).endswith("… and 3 more")


def test_the_command_line_prints_all_diagnostics_and_exits_with_2(capsys):
    assert cli._report_error(DiagnosticError(UNKNOWN_ZONE, NO_BALL), None, begun=True) == 2
    assert capsys.readouterr().err == f"{UNKNOWN_ZONE}\n\n{NO_BALL}\n"
