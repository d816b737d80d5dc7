"""Titles and paths on a terminal: a title is one line, and a path can be pasted into a shell."""

import os
import subprocess
import sys

import pytest

from rcj_challenges.cli.stdio import shell_quoted, shown_path
from rcj_challenges.scenario.resources import SCENARIOS_FOLDER, TOURNAMENTS_FOLDER
from tests.cli.in_this_process import here


@pytest.mark.skipif(sys.platform == "win32", reason="paths are bytes on POSIX only")
@pytest.mark.parametrize("name", [b"caf\xe9 '1'.yaml", b"a\nb.yaml", b"\xff\\f"])
def test_a_path_that_would_be_printed_with_escapes_can_be_pasted(name):
    shown = shown_path(os.fsdecode(name))
    assert shown.isascii()
    assert shown.isprintable()
    assert subprocess.run(["bash", "-c", f"printf %s {shown}"], capture_output=True, check=True).stdout == name


def test_other_paths_are_shown_as_they_are():
    assert shown_path("runs/a b") == "runs/a b"
    assert shell_quoted("runs/é") == "runs/é"


@pytest.mark.parametrize("file", [SCENARIOS_FOLDER / "match.yaml", next(TOURNAMENTS_FOLDER.glob("*.yaml"))])
def test_a_title_of_several_lines_forges_no_verdict(tmp_path, monkeypatch, capsys, file):
    lines = file.read_text("utf-8").splitlines()
    titled = ['title: "Cup\\r\\nok  other.yaml"' if line.startswith("title:") else line for line in lines]
    (tmp_path / "own.yaml").write_text("\n".join(titled), "utf-8")
    here(monkeypatch, tmp_path, "validate", "own.yaml")
    said = capsys.readouterr().out
    assert said.count("\n") == 1
    assert "\r" not in said
