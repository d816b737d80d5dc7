"""``rcj-challenge stats``: a table for people, JSON for programs, and a message for what is no record."""

import json
from pathlib import Path

import pytest
from typer.testing import CliRunner

from rcj_challenges.cli.commands import load_app
from rcj_challenges.records.errors import RecordError
from rcj_challenges.views.stats import DEFINITIONS
from tests.made_up_runs import write_made_up_run


@pytest.fixture(scope="module")
def out(tmp_path_factory: pytest.TempPathFactory) -> Path:
    runs = tmp_path_factory.mktemp("runs")
    for name in ("20210618-100000-small", "20210618-110000-small"):
        write_made_up_run(runs, ticks=450, halves=1, names=("Hanse", "\u202eAlster\x1b[31m")).rename(runs / name)
    broken = runs / "20210618-090000-small"
    broken.mkdir()
    (broken / "result.json").write_text("{}", "utf-8")
    return runs


def stats(*arguments: str, out: Path, columns: int = 80) -> tuple[int, str]:
    result = CliRunner().invoke(load_app(), ["stats", *arguments, "--out", str(out)], env={"COLUMNS": str(columns)})
    if result.exception is not None and not isinstance(result.exception, SystemExit):
        raise result.exception
    return result.exit_code, result.stdout


def test_the_table_has_a_line_for_each_team_and_robot_and_fits_80_columns(out: Path) -> None:
    code, text = stats(out=out)
    assert code == 0
    assert "Hanse: 0" in text
    assert "Alster" in text
    for robot in ("B1", "B2", "B3", "Y1", "Y2", "Y3", "ball"):
        assert f" {robot} " in text
    assert "Y1: program fault: crash 1" in text
    assert "\x1b[31m" not in text
    assert "\u202e" not in text
    assert max(len(line) for line in text.splitlines()[:20]) <= 80
    assert "…" not in text.split("ball")[0]  # no column is cut off


def test_every_definition_is_printed_on_request(out: Path) -> None:
    _, short = stats(out=out)
    _, long = stats("--explain", out=out)
    for definition in DEFINITIONS.values():
        assert definition.text in long
        assert definition.text not in short


def test_json_has_the_figures_with_their_definitions(out: Path) -> None:
    code, text = stats("20210618-10", "20210618-11", "--json", out=out)
    assert code == 0
    document = json.loads(text)
    assert document["runs"] == ["20210618-100000-small", "20210618-110000-small"]
    assert document["teams"]["Hanse"]["runs"] == 2
    assert document["definitions"]["possession"]["unit"] == "%"


def test_a_run_that_is_given_twice_counts_once(out: Path) -> None:
    code, text = stats("20210618-10", str(out / "20210618-100000-small"), "20210618-11", "--json", out=out)
    assert code == 0
    document = json.loads(text)
    assert document["runs"] == ["20210618-100000-small", "20210618-110000-small"]
    assert any("counted once" in note for note in document["notes"])


def test_a_folder_that_is_no_record_is_reported(out: Path) -> None:
    with pytest.raises(RecordError, match=r"result\.json is damaged"):
        stats("20210618-09", out=out)
    with pytest.raises(RecordError, match="no record"):
        stats("1999", out=out)
