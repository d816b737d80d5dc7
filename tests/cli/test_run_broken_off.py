"""A match that is broken off by its user says how far it came and where that is, whenever it happens."""

import json

import pytest

from rcj_challenges.records.result import read_result
from tests.cli.conftest import STAND
from tests.cli.in_this_process import here
from tests.cli.test_run import DUEL, short


@pytest.fixture
def team(tmp_path):
    file = tmp_path / "team.py"
    file.write_text(STAND, encoding="utf-8")
    return str(file)


def test_an_interruption_that_an_import_makes_an_error_of_is_one(tmp_path, monkeypatch, capsys, team):
    """Numpy says of a Ctrl-C in its midst that it cannot be imported."""

    def numpy(*_):
        try:
            raise KeyboardInterrupt
        except KeyboardInterrupt as error:
            raise ImportError("numpy cannot be imported") from error

    monkeypatch.setattr("rcj_challenges.match.stage.build_stage", numpy)
    assert here(monkeypatch, tmp_path, *short(team, *DUEL)) == 130
    result_printed = capsys.readouterr().out
    (folder,) = (tmp_path / "runs").iterdir()
    assert "interrupted before the first half" in result_printed
    assert f"record: {folder.relative_to(tmp_path)}" in result_printed
    assert read_result(folder).stopped == "KeyboardInterrupt"


@pytest.mark.parametrize(
    "moment",
    [
        "rcj_challenges.match.stage.build_stage",
        "rcj_challenges.match.observers.Observer.finished",
        "rcj_challenges.cli.advice.advice_on",
        "rcj_challenges.views.replay.write_replay",
    ],
)
def test_result_of_an_interrupted_match_is_printed_once(tmp_path, monkeypatch, capsys, team, moment):
    def interrupt(*_, **__):
        raise KeyboardInterrupt

    monkeypatch.setattr(moment, interrupt)
    assert here(monkeypatch, tmp_path, *short(team, "--json", *DUEL)) == 130
    printed, lines = capsys.readouterr()
    result_printed = json.loads(printed)
    (folder,) = (tmp_path / "runs").iterdir()
    is_played = moment != "rcj_challenges.match.stage.build_stage"
    assert ("interrupted after half 1 of 1: " in lines) is is_played
    assert f"record: {folder.relative_to(tmp_path)}\n" in lines
    result = json.loads((folder / "result.json").read_text("utf-8"))
    assert result_printed == {**result, "hints": [], "folder": str(folder.relative_to(tmp_path))}
    assert result["complete"] is is_played
