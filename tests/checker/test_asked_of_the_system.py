"""Files that are not there, and what a match refuses: a crash over one is told with what to write instead."""

from __future__ import annotations

import pytest

from rcj_challenges.checker.advice.hints import hint_on
from rcj_challenges.controllers.team import open_team
from rcj_challenges.scenario.load import load

SCENARIO = load("match").scenario
FOLDER = "rcj_soccer_team_blue"
MISSING = "FileNotFoundError: [Errno 2] No such file or directory: "


@pytest.fixture
def remedy(tmp_path):
    def told(detail, *files, program="x = 1\n"):
        for name in (f"{FOLDER}/{FOLDER}.py", *files):
            path = tmp_path / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(program if path.suffix == ".py" else "{}", encoding="utf-8")
        fault = {"kind": "crash", "robot": "B1", "tick": 0, "detail": detail, "traceback": ""}
        with open_team(tmp_path, *SCENARIO.entrants.values()) as team:
            hint = hint_on(SCENARIO, team, fault, "")
        return hint.remedy if hint is not None else ""

    return told


def missing(path):
    return f"{MISSING}{path!r} ({FOLDER}/{FOLDER}.py, line 3)"


def test_a_file_that_is_named_as_on_windows_is_told_with_the_name_that_works_everywhere(remedy):
    # In a Python text some letters make another sign of the backslash before them: \t a tab.
    for written, name in (("data\\params.json", "params.json"), ("data\table.json", "table.json")):
        told = remedy(missing(written), f"{FOLDER}/data/{name}")
        assert f'write "data/{name}"' in told
        assert "Windows" in told


def test_a_place_on_the_computer_of_its_author_is_told_with_where_the_file_lies(remedy):
    for place in ("C:\\Users\\max\\params.json", "C:/Users/max/params.json", "/home/max/params.json"):
        told = remedy(missing(place), f"{FOLDER}/params.json")
        assert 'write "params.json"' in told, place
    told = remedy(missing("C:\\Users\\max\\model.pkl"))
    assert "your own computer" in told
    assert f"put model.pkl into {FOLDER}" in told
    assert 'open it as "model.pkl"' in told


def test_capital_letters_in_the_name_of_a_file_count(remedy):
    told = remedy(missing("Params.JSON"), f"{FOLDER}/params.json")
    assert 'write "params.json"' in told
    assert "capital" in told


def test_a_file_elsewhere_in_the_submission_is_told_with_the_way_from_the_current_folder(remedy):
    told = remedy(missing(f"{FOLDER}/params.json"), f"{FOLDER}/params.json")
    assert 'write "params.json"' in told
    assert f"the current folder is {FOLDER}" in told
    told = remedy(missing("table.csv"), f"{FOLDER}/data/table.csv")
    assert 'write "data/table.csv"' in told
    told = remedy(missing("shared.csv"), "shared.csv")
    assert 'write "../shared.csv"' in told


def test_a_file_that_was_not_handed_in_is_told_with_where_to_put_it(remedy):
    told = remedy(missing("model.pkl"))
    assert f"model.pkl was not handed in: put it into {FOLDER}" in told
    told = remedy(missing("models/it's.pkl"))
    assert f"models/it's.pkl was not handed in: put it into {FOLDER}/models" in told


def test_a_file_beside_the_program_that_is_named_by_its_file_is_no_other(remedy):
    """``os.path.join(os.path.dirname(__file__), "model.pkl")`` is shown from the top of the submission."""
    told = remedy(missing(f"{FOLDER}/model.pkl"))
    assert f"model.pkl was not handed in: put it into {FOLDER}," in told
    told = remedy(missing(f"{FOLDER}/Model.pkl"), f"{FOLDER}/model.pkl")
    assert "capital" in told


def test_a_folder_that_is_missing_for_a_new_file_is_not_called_a_file(remedy):
    told = remedy(missing("logs/run.txt"), program='log = open("logs/run.txt", "w")\n')
    assert "os.makedirs" in told


def test_who_writes_elsewhere_is_told_where_a_program_may_write(remedy):
    for detail in (
        "OSError: [Errno 30] Read-only file system: '/tmp/log.txt'",
        "PermissionError: [Errno 13] Permission denied: '/home/max/log.txt'",
    ):
        told = remedy(f"{detail} ({FOLDER}/{FOLDER}.py, line 3)")
        assert 'write "log.txt"' in told, detail
        assert "its own folder" in told


@pytest.mark.parametrize(
    ("program", "part"),
    [
        ("import subprocess\n", "other programs"),
        ("from multiprocessing import Pool\n", "threads"),
        ("import socket\n", "network"),
        ("import os\nos.fork()\n", "refuses"),
    ],
)
@pytest.mark.parametrize(
    "detail",
    [
        "PermissionError: [Errno 1] Operation not permitted",
        "OSError: [Errno 30] Read-only file system",
        "OSError: [Errno 30] Read-only file system: '/dev/shm/pym-2-5dtv7k49'",
    ],
)
def test_what_a_match_refuses_is_told_with_what_to_do_without(remedy, detail, program, part):
    told = remedy(f"{detail} ({FOLDER}/{FOLDER}.py, line 3)", program=program)
    assert part in told
    assert "without" in told


def test_other_errors_of_the_system_say_nothing_of_files(remedy):
    assert remedy("OSError: [Errno 22] Invalid argument") == ""
    assert remedy("ValueError: No such file or directory: 5") == ""
    assert remedy(f"{MISSING}'{'x' * 5000}' (a.py, line 1)") == ""


@pytest.mark.parametrize(
    "quoted",
    [r"'\x'", r"'C:\users'", r"'\N{no such letter}'", r"'data/\ud800.txt'", r"'\d'", r"'\'", r"'\\'"],
    ids=ascii,
)
@pytest.mark.parametrize("error", [MISSING, "PermissionError: [Errno 13] Permission denied: "])
@pytest.mark.filterwarnings("error")
def test_what_a_program_itself_wrote_in_the_words_of_python_costs_nothing_but_the_advice(remedy, error, quoted):
    program = "try:\n    open('data/x', 'w')\nexcept OSError:\n    pass\n"
    assert isinstance(remedy(f"{error}{quoted} ({FOLDER}/{FOLDER}.py, line 3)", program=program), str)
