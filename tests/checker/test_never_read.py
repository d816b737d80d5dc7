"""Files of a team that are never read because Python has a module of that name in memory, and those that are."""

from __future__ import annotations

import sys
import tempfile

import pytest

from rcj_challenges.checker import preloaded
from rcj_challenges.checker.check import CheckOptions, check_file
from rcj_challenges.checker.preloaded import preloaded_modules
from rcj_challenges.checker.sources import check_sources
from rcj_challenges.controllers.private_folders import PREFIX
from rcj_challenges.controllers.team import open_team
from tests.checker.alone import alone

FOLDER = "rcj_soccer_team_blue"
ENTRY = f"{FOLDER}/{FOLDER}.py"
ALONE = alone()
LOOP = "from controller import Robot\nrobot = Robot()\nwhile robot.step(32) != -1:\n    pass\n"


@pytest.fixture
def submission(tmp_path):
    def written(program, **files):
        for name, text in {ENTRY: program, **files}.items():
            path = tmp_path / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
        return tmp_path

    return written


def sources(folder):
    with open_team(folder, *ALONE.scenario.entrants.values()) as team:
        return {(finding.code, finding.where): finding for finding in check_sources(team).findings}


@pytest.mark.parametrize("name", ["types", "sys", "builtins", "zipimport"])
def test_a_file_called_like_what_python_has_in_memory_is_told_as_never_read(submission, name):
    found = sources(submission(LOOP, **{f"{FOLDER}/{name}.py": "Speed = 5\n"}))
    told = found["sources.passed_over", f"{FOLDER}/{name}.py"]
    assert told.level == "warning"
    assert f'"import {name}" always gives' in told.message
    assert "never read" in told.message
    assert "hides" not in told.message
    assert "another name" in told.remedy
    assert ("sources.shadows", f"{FOLDER}/{name}.py") not in found


@pytest.mark.parametrize("path", ["types.py", f"{FOLDER}/types/__init__.py"])
def test_in_the_folder_above_or_as_a_folder_it_is_never_read_either(submission, path):
    assert ("sources.passed_over", path) in sources(submission(LOOP, **{path: ""}))


def test_a_file_where_no_program_would_look_for_it_under_that_name_is_none_of_ours(submission):
    found = sources(submission("import shared.types\n", **{f"{FOLDER}/shared/types.py": ""}))
    assert set(found) == {("sources.ok", "")}


def test_what_is_wrong_in_a_file_that_is_never_read_ends_no_program(submission):
    found = sources(submission("import types\n" + LOOP, **{f"{FOLDER}/types.py": "import cv2\n"}))
    assert set(found) == {("sources.passed_over", f"{FOLDER}/types.py")}


@pytest.mark.parametrize("name", ["random", "queue", "numpy"])
def test_a_file_called_like_what_is_loaded_later_hides_it(submission, name):
    found = sources(submission(LOOP, **{f"{FOLDER}/{name}.py": ""}))
    assert set(found) == {("sources.shadows", f"{FOLDER}/{name}.py")}


@pytest.mark.parametrize("name", ["types", "random", "ctypes", "resource", "runpy", "token"])
def test_what_the_sources_say_is_what_a_real_program_gets(submission, name):
    folder = submission(f"import {name}\nprint({name}.Speed)\n" + LOOP, **{f"{FOLDER}/{name}.py": "Speed = 5\n"})
    report = check_file(folder, ALONE, CheckOptions(play_s=0.5))
    (code,) = {finding.code for finding in report.stages[3].findings}
    crashed = {finding.code for finding in report.stages[4].findings} == {"start.crash"}
    assert (code == "sources.passed_over") == crashed


@pytest.mark.parametrize("name", ["types", "random"])
def test_a_crash_over_a_file_with_the_name_of_a_module_of_python_names_the_file(submission, name):
    program = f"import {name}\nprint({name}.Speed)\n" + LOOP
    report = check_file(submission(program, **{f"{FOLDER}/{name}.py": ""}), ALONE, CheckOptions())
    (found,) = report.stages[4].findings
    assert f"{FOLDER}/{name}.py" in found.remedy


def test_what_is_loaded_is_asked_of_a_program_as_it_is_started():
    assert {"sys", "types", "os"} <= preloaded_modules("auto") <= sys.stdlib_module_names
    assert not {"random", "json", "math_tools", "controller", "__main__"} & preloaded_modules("auto")


def test_where_no_program_can_be_started_only_what_is_part_of_the_interpreter_counts(monkeypatch):
    def no_room(*_):
        raise OSError("no space left")

    monkeypatch.setattr(preloaded.Crew, "launch", no_room)
    preloaded_modules.cache_clear()
    try:
        assert preloaded_modules("auto") == set(sys.builtin_module_names) & sys.stdlib_module_names
    finally:
        preloaded_modules.cache_clear()


def test_what_a_killed_check_leaves_of_it_is_where_the_next_one_finds_and_removes_it(tmp_path, monkeypatch):
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    seen = []

    def opened(path, *seats):
        seen.extend(tmp_path.iterdir())
        return open_team(path, *seats)

    monkeypatch.setattr(preloaded, "open_team", opened)
    assert "sys" in preloaded.preloaded_modules.__wrapped__("auto")
    assert seen
    assert all(folder.name.startswith(PREFIX) for folder in seen)
    assert not list(tmp_path.iterdir())
