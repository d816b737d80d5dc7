"""What programs printed, where a check is asked to show it: also of those that fail before anything is played."""

from __future__ import annotations

import io

import pytest
from rich.console import Console

from rcj_challenges.checker.check import CheckOptions, check_file
from rcj_challenges.checker.report import check_report
from rcj_challenges.checker.report_html import html_page
from rcj_challenges.checker.report_text import print_file
from tests.checker.alone import alone
from tests.checker.small_team import PLAYER, write_team

pytestmark = pytest.mark.usefixtures("sources_read_here")

ENDS = "print('no <ball>')\n" + PLAYER.replace("    pass", "    break")


def check(tmp_path, program, *, show_output):
    options = CheckOptions(play_s=1.0, show_output=show_output)
    return check_file(write_team(tmp_path / "team.zip", program), alone(), options)


def printed(report):
    console = Console(file=io.StringIO(), width=200)
    print_file(console, report)
    return console.file.getvalue()


def test_what_a_program_printed_that_failed_at_its_start_is_shown_on_request(tmp_path):
    """Where a program prints the error that has ended it, there is nothing else to go by."""
    report = check(tmp_path, ENDS, show_output=True)
    assert report.matches == []
    assert "no <ball>\n" in report.started["B1"]
    assert "B1 at its start printed:\n" in printed(report)
    assert "B1 | no <ball>\n" in printed(report)
    page = html_page(check_report("alone", "Alone", "auto", [report]), tmp_path)
    assert "What B1 printed at its start" in page
    assert "no &lt;ball&gt;" in page


def test_what_was_played_is_shown_instead_of_how_it_started(tmp_path):
    report = check(tmp_path, "print('hello')\n" + PLAYER, show_output=True)
    assert report.started == {}
    assert "hello" in report.matches[0].robots[0].output


def test_nothing_is_shown_that_was_not_asked_for(tmp_path):
    assert check(tmp_path, ENDS, show_output=False).started == {}
