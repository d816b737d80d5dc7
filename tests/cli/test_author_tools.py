"""What a committee does at the command line: new, validate, test, draw."""

from __future__ import annotations

import json
import os
import shlex
import subprocess
import sys
import time
from pathlib import Path

import pytest
from typer.testing import CliRunner

from rcj_challenges.cli.commands import load_app
from rcj_challenges.cli.draw import draw
from rcj_challenges.cli.sheet import sheet as write_sheet
from rcj_challenges.cli.stdio import shell_quoted
from rcj_challenges.core.errors import RcjError
from rcj_challenges.scenario.load import load

ROOT = Path(__file__).resolve().parents[2]
SHIPPED = ("match", "fast_shooter", "pass_the_ball", "precision_lidar")
PRESETS = ("soccersim_v2", "soccersim_2021", "empty_field")
GOAL = """schema_version: 2
id: goal
title: A goal
extends: soccersim_v2
match: {half_s: 60}
rules:
  goal:
    triggers: [{trigger: enters, entity: ball, zone: blue_goal}]
    actions: [{action: score, entrant: yellow}, {action: emit, event: GOAL, payload: {who: yellow}}]
    says: A goal.
expect:
  a_goal_gives_a_point: {keyframes: [{at_s: 1, place: {ball: [0, 0.8]}}], lasts_s: 2, score: {yellow: POINTS}}
  nothing_gives_nothing: {keyframes: [{at_s: 1}], lasts_s: 2, score: {yellow: 0}, events: []}
"""


def call(*arguments: str | Path):
    """Run the command line in this process."""
    return CliRunner().invoke(load_app(), [str(argument) for argument in arguments])


@pytest.fixture
def written(tmp_path):
    """Return what writes a scenario file: the goal, with replacements."""

    def write(*replacements: tuple[str, str], name: str = "it.yaml") -> Path:
        text = GOAL
        for old, new in (*replacements, ("POINTS", "1")):
            text = text.replace(old, new)
        path = tmp_path / name
        path.write_text(text, encoding="utf-8")
        return path

    return write


class TestValidate:
    def test_a_warning_is_shown_and_the_file_is_in_order_all_the_same(self, written):
        done = call("validate", written(("    says: A goal.\n", "")))
        assert done.exit_code == 0
        assert "; 1 warning" in done.stdout
        assert done.stderr.startswith("warning[missing-says]: ")
        assert "it.yaml:9:15  rules.goal.actions[0] (score)\n" in done.stderr

    def test_strict_makes_a_warning_a_failure(self, written):
        warned = call("validate", "--strict", written(("    says: A goal.\n", "")))
        assert (warned.exit_code, warned.stdout[:4]) == (1, "no  ")
        fine = call("validate", "--strict", written())
        assert (fine.exit_code, fine.stdout[:4]) == (0, "ok  ")

    def test_json_reports_problems_and_findings(self, written):
        silent = written(("    says: A goal.\n", ""))
        wrong = written(("blue_goal", "blue_gaol"), name="wrong.yaml")
        done = call("validate", "--json", silent, wrong)
        first, second = json.loads(done.stdout)["files"]
        assert (first["ok"], second["ok"]) == (True, False)
        assert first["findings"][0]["code"] == "missing-says"
        assert second["problems"][0]["line"] == 8

    def test_all_that_is_shipped_is_strictly_in_order(self):
        assert call("validate", "--strict", *sorted((ROOT / "scenarios").rglob("*.yaml"))).exit_code == 0


@pytest.fixture(scope="module")
def shipped():
    """Return what the tests of the shipped scenarios came to, and how long it took to play them."""
    began = time.process_time()
    done = call("test", "--json", *SHIPPED)
    return json.loads(done.stdout), time.process_time() - began  # what else the machine does is not counted


class TestTest:
    def test_what_comes_as_expected_passes(self, written):
        done = call("test", written())
        assert done.exit_code == 0
        assert "ok    a_goal_gives_a_point (2.016 s)" in done.stdout
        assert "all 2 passed" in done.stdout

    def test_a_difference_is_reported_in_words_and_the_verdict_is_negative(self, written):
        done = call("test", written(("POINTS", "2")))
        assert done.exit_code == 1
        assert "FAIL  a_goal_gives_a_point" in done.stdout
        assert "score of yellow: expected 2, is 1" in done.stdout
        assert "1 of 2 failed" in done.stdout

    def test_json_reports_the_same(self, written):
        done = call("test", "--json", written(("POINTS", "2")))
        report = json.loads(done.stdout)
        assert (done.exit_code, report["passed"]) == (1, False)
        (file,) = report["files"]
        assert [test["passed"] for test in file["tests"]] == [False, True]
        assert file["tests"][0]["differences"] == ["score of yellow: expected 2, is 1"]
        assert file["tests"][0]["rules"] == ["goal"]
        assert file["untested_rules"] == []

    def test_a_rule_that_no_test_sets_off_is_named(self, written):
        done = call("test", written(("place: {ball: [0, 0.8]}", "place: {ball: [0.5, 0]}"), ("POINTS", "0")))
        assert done.exit_code == 0
        assert "no test sets off: goal" in done.stdout

    def test_for_a_file_without_tests_the_message_shows_how_to_write_some(self, written):
        text = GOAL.partition("expect:")[0]
        path = written((GOAL, text))
        assert "no tests: add expect:" in call("test", path).stdout

    def test_a_file_that_cannot_be_used_is_reported_with_its_line_and_the_others_are_played(self, written, tmp_path):
        wrong = written(("blue_goal", "blue_gaol"), name="wrong.yaml")
        done = call("test", tmp_path / "missing.yaml", wrong, written(name="last.yaml"))
        assert done.exit_code == 2
        assert "missing.yaml" in done.stderr.splitlines()[1]
        assert "wrong.yaml:8:" in done.stderr
        assert "ok    a_goal_gives_a_point" in done.stdout
        assert "all 2 passed" in done.stdout
        assert done.stdout.strip().endswith("2 of 3 files cannot be used")

    def test_a_file_that_cannot_be_used_outweighs_a_failed_test(self, written):
        wrong = written(("blue_goal", "blue_gaol"), name="wrong.yaml")
        failing = written(("POINTS", "2"), name="failing.yaml")
        assert call("test", wrong, failing).exit_code == 2

    def test_json_reports_the_problems_of_a_file_that_cannot_be_used(self, written):
        wrong = written(("blue_goal", "blue_gaol"), name="wrong.yaml")
        done = call("test", "--json", wrong, written())
        report = json.loads(done.stdout)
        assert (done.exit_code, report["passed"]) == (2, False)
        first, second = report["files"]
        assert (first["passed"], first["tests"], first["problems"][0]["line"]) == (False, [], 8)
        assert (second["passed"], second["problems"]) == (True, [])

    def test_the_shipped_scenarios_play_over_200_times_faster_than_real_time(self, shipped):
        report, took_s = shipped
        assert report["passed"]
        assert sum(test["simulated_s"] for file in report["files"] for test in file["tests"]) / took_s > 200
        assert took_s < 5

    @pytest.mark.parametrize("number", range(len(SHIPPED)), ids=SHIPPED)
    def test_every_scoring_and_every_penalty_rule_of_the_shipped_scenarios_is_tested(self, shipped, number):
        report, _ = shipped
        file = report["files"][number]
        assert SHIPPED[number] in file["file"]
        assert set(file["untested_rules"]) <= {"match_finish"}


class TestNew:
    @pytest.mark.parametrize("preset", PRESETS)
    def test_a_starter_is_free_of_lint_and_its_tests_pass(self, tmp_path, preset):
        file = tmp_path / "my-first challenge.yaml"
        done = call("new", file, "--from", preset)
        assert done.exit_code == 0
        assert call("validate", "--strict", file).exit_code == 0
        report = json.loads(call("test", "--json", file).stdout)
        assert report["passed"]
        assert report["files"][0]["untested_rules"] == []
        loaded = load(file)
        assert (loaded.scenario.id, loaded.scenario.title) == ("my_first_challenge", "My first challenge")

    @pytest.mark.parametrize("preset", PRESETS)
    def test_its_program_is_python_and_where_the_scenario_looks_for_it(self, tmp_path, preset):
        call("new", tmp_path / "it", "--from", preset)
        program = tmp_path / "it_team" / load(tmp_path / "it.yaml").scenario.entrants["yellow"].robots["Y3"]
        compile(program.read_text(encoding="utf-8"), program.name, "exec")

    @pytest.mark.parametrize(
        "name", ["FILE_NAME", "TEAM_FOLDER", "SCHEMA_FILE", "it's", "x: y", "#1", 'the "best"', "a\\c"]
    )
    def test_whatever_a_file_is_called_the_starter_is_valid(self, tmp_path, name):
        if os.name == "nt" and not set(name).isdisjoint('":\\'):
            pytest.skip("no name of a file on Windows")
        call("new", tmp_path / name)
        assert load(tmp_path / f"{name}.yaml").scenario.title == name.replace("_", " ").capitalize()

    @pytest.mark.parametrize("name", ["a\nb", "a\x7fb", "a\x85b", "a\udcff", "a\u2028b", "a\ufeffb"])
    def test_a_name_that_no_yaml_can_hold_is_refused_and_nothing_is_written(self, tmp_path, name):
        error = call("new", tmp_path / name).exception
        assert isinstance(error, RcjError)
        assert error.code == "bad-name"
        assert list(tmp_path.iterdir()) == []

    @pytest.mark.parametrize("name", ["slalom", "of 2026/juniors/slalom.yaml"])
    def test_editors_find_the_schema_that_is_written_where_new_was_typed(self, tmp_path, monkeypatch, name):
        monkeypatch.chdir(tmp_path)
        call("new", name)
        call("schema")
        file = Path(name).with_suffix(".yaml")
        first = file.read_text(encoding="utf-8").splitlines()[0]
        assert first.startswith("# yaml-language-server: $schema=")
        named = first.partition("=")[2]
        assert " " not in named  # editors take the line to its first blank
        assert (file.parent / named).resolve() == (tmp_path / "schemas" / "scenario.schema.json").resolve()
        assert (file.parent / named).is_file()

    @pytest.mark.parametrize("existing", ["it.yaml", "it_team/robot.py"])
    def test_nothing_is_overwritten(self, tmp_path, existing):
        path = tmp_path / existing
        path.parent.mkdir(exist_ok=True)
        path.write_text("mine", encoding="utf-8")
        done = call("new", tmp_path / "it")
        assert isinstance(done.exception, RcjError)
        assert done.exception.code == "file-exists"
        assert path.read_text(encoding="utf-8") == "mine"
        assert sum(file.is_file() for file in tmp_path.rglob("*")) == 1

    def test_an_unknown_preset_is_named_with_the_known_ones(self, tmp_path):
        done = call("new", tmp_path / "it", "--from", "soccersim_v3")
        assert done.exception.code == "unknown-preset"
        assert "did you mean 'soccersim_v2'" in done.exception.help
        assert "soccersim_2021" in done.exception.help
        assert call("new", tmp_path / "ß").exception.code == "bad-name"

    @pytest.mark.parametrize("name", ["CON", "aux.yaml", "nul.yml", "Com1", "lpt9.old", "com¹", "CONIN$", "conout$.x"])
    def test_a_name_that_is_a_device_on_windows_is_refused_on_every_system(self, tmp_path, name):
        done = call("new", tmp_path / name)
        assert done.exception.code == "bad-name"
        assert list(tmp_path.iterdir()) == []

    @pytest.mark.parametrize("name", ["", ".yaml", ".yml", "challenges/", "challenges/.yaml"])
    def test_a_name_without_a_letter_before_the_ending_is_none(self, tmp_path, monkeypatch, name):
        monkeypatch.chdir(tmp_path)
        done = call("new", name)
        assert done.exception.code == "bad-name"
        assert list(tmp_path.iterdir()) == []

    def test_a_name_that_no_system_takes_is_reported(self, tmp_path):
        done = call("new", tmp_path / ("x" * 5000))
        assert isinstance(done.exception, RcjError)
        assert done.exception.code == "cannot-write"
        assert len(str(done.exception)) < 500


class TestNamesOfDevices:
    """A file that one makes on Linux must be one on the Windows of those who get it."""

    @pytest.mark.parametrize(
        "arguments",
        [
            ("draw", "match", "--out", "aux.svg"),
            ("draw", "match", "--out", "CON.png"),
            ("sheet", "match", "--out", "aux.html"),
            ("sheet", "match", "--out", "com1.md"),
            ("schema", "--out", "nul"),
            ("video", "--out", "aux.mp4"),
            ("snapshot", "--at", "1", "--out", "lpt1.png"),
            ("check", ".", "--html", "aux.html"),
            ("check", ".", "--fix", "aux.zip"),
            ("check", ".", "--replay", "con"),
            ("run", "match", "--out", "aux"),
            ("simulate", "match", "--out", "nul"),
        ],
        ids=" ".join,
    )
    def test_are_refused_on_every_system_before_anything_is_done(self, tmp_path, monkeypatch, arguments):
        monkeypatch.chdir(tmp_path)
        done = call(*arguments)
        assert isinstance(done.exception, RcjError), done.output
        assert done.exception.code == "device-name"
        assert list(tmp_path.iterdir()) == []


class TestDraw:
    def test_png_and_svg_are_distinguished_by_the_name(self, tmp_path):
        pytest.importorskip("resvg_py")
        assert call("draw", "match", "--out", tmp_path / "field.png").exit_code == 0
        assert call("draw", "match", "--out", tmp_path / "field.svg").exit_code == 0
        assert (tmp_path / "field.png").read_bytes().startswith(b"\x89PNG\r\n\x1a\n")
        assert (tmp_path / "field.svg").read_text(encoding="utf-8").startswith("<svg")

    def test_without_the_extra_the_message_names_what_to_install(self, tmp_path, monkeypatch):
        monkeypatch.setitem(sys.modules, "resvg_py", None)
        done = call("draw", "match", "--out", tmp_path / "field.png")
        assert 'pip install "rcj-challenges[png]"' in done.exception.help
        assert not (tmp_path / "field.png").exists()


class TestSheet:
    def test_the_drawing_lies_beside_the_markdown_that_shows_it(self, tmp_path):
        done = call("sheet", "match", "--out", tmp_path / "the match.md")
        assert done.exit_code == 0
        assert done.stdout.split("\n")[:2] == [str(tmp_path / "the match.svg"), str(tmp_path / "the match.md")]
        text = (tmp_path / "the match.md").read_text(encoding="utf-8")
        assert "![The field](the%20match.svg)" in text
        assert "<svg" not in text
        assert (tmp_path / "the match.svg").read_text(encoding="utf-8").startswith("<svg")
        assert call("sheet", "match", "--out", tmp_path / "the match.md").exit_code == 0

    def test_a_drawing_that_belongs_to_no_sheet_is_not_overwritten(self, tmp_path):
        (tmp_path / "field.svg").write_text("mine", encoding="utf-8")
        done = call("sheet", "match", "--out", tmp_path / "field.md")
        assert done.exception.code == "file-exists"
        assert (tmp_path / "field.svg").read_text(encoding="utf-8") == "mine"

    def test_a_drawing_of_somebody_else_stays_when_the_sheet_is_there_already(self, tmp_path):
        (tmp_path / "field.svg").write_text("mine", encoding="utf-8")
        (tmp_path / "field.md").write_text("# A text of mine\n", encoding="utf-8")
        assert call("sheet", "match", "--out", tmp_path / "field.md").exception.code == "file-exists"
        assert (tmp_path / "field.svg").read_text(encoding="utf-8") == "mine"

    @pytest.mark.parametrize(("write", "name"), [(write_sheet, "match.html"), (draw, "match.svg")])
    def test_on_a_terminal_a_document_without_a_name_becomes_a_file_that_replaces_no_other(
        self, tmp_path, monkeypatch, capsys, write, name
    ):
        monkeypatch.chdir(tmp_path)
        monkeypatch.setattr(sys.stdout, "isatty", lambda: True)
        write("match")
        assert capsys.readouterr().out == f"{name}\n"
        assert "<svg" in (tmp_path / name).read_text(encoding="utf-8")
        with pytest.raises(RcjError) as caught:
            write("match")
        assert (caught.value.code, caught.value.help) == ("file-exists", f"--out {name}")

    @pytest.mark.parametrize(
        ("path", "separator", "printed"),
        [
            ("match", "/", "match"),
            ("kurse/slalom.yaml", "/", "kurse/slalom.yaml"),
            ("Grün/slalom.yaml", "/", "Grün/slalom.yaml"),
            ("my slalom.yaml", "/", '"my slalom.yaml"'),
            ("you & me.yaml", "/", '"you & me.yaml"'),
            ("a$b.yaml", "/", "'a$b.yaml'"),
            (r"C:\kurse\slalom.yaml", "\\", r"C:\kurse\slalom.yaml"),
            (r"kurse\my slalom.yaml", "\\", r'"kurse\my slalom.yaml"'),
            (r"\\server\kurse\a$b.yaml", "\\", r'"\\server\kurse\a$b.yaml"'),
        ],
    )
    def test_paths_are_quoted_for_the_shell_of_this_system(self, monkeypatch, path, separator, printed):
        """The shells of Windows know no single quotes, and a backslash is nothing special there."""
        with monkeypatch.context() as system:
            system.setattr(os, "sep", separator)
            output = shell_quoted(path)
        assert output == printed
        if separator == "/":
            assert shlex.split(printed) == [path]


class TestEndings:
    """A file's ending says what is in it: an unknown one is refused, and nothing is written."""

    @pytest.mark.parametrize(
        ("command", "name"), [("draw", "x.pdf"), ("draw", "x"), ("sheet", "x.txt"), ("sheet", "x")]
    )
    def test_other_endings_are_refused(self, tmp_path, command, name):
        done = call(command, "match", "--out", tmp_path / name)
        assert (done.exception.code, done.exception.exit_code) == ("bad-out", 2)
        assert done.exception.help == f"rename it: --out {tmp_path / {'draw': 'x.svg', 'sheet': 'x.md'}[command]}"
        assert list(tmp_path.iterdir()) == []

    @pytest.mark.parametrize(
        ("command", "name", "begins"),
        [("draw", "x.SVG", "<svg"), ("sheet", "x.Md", "# "), ("sheet", "x.htm", "<!")],
    )
    def test_capitals_and_the_short_ending_of_html_are_understood(self, tmp_path, command, name, begins):
        assert call(command, "match", "--out", tmp_path / name).exit_code == 0
        assert (tmp_path / name).read_text(encoding="utf-8").startswith(begins)


def test_the_tools_of_authors_load_no_physics(tmp_path):
    program = """
import sys
from typer.testing import CliRunner
from rcj_challenges.cli.commands import load_app
for arguments in (["new", "it"], ["validate", "it.yaml"], ["test", "it.yaml"], ["draw", "it.yaml"], ["sheet", "it.yaml"]):
    done = CliRunner().invoke(load_app(), arguments)
    assert done.exit_code == 0, (arguments, done.exception)
    print(arguments[0], *sorted({"mujoco", "numpy", "scipy", "multiprocessing"} & set(sys.modules)))
"""
    done = subprocess.run(
        [sys.executable, "-c", program], cwd=tmp_path, capture_output=True, encoding="utf-8", check=True
    )
    assert done.stdout.split("\n")[:5] == ["new", "validate", "test", "draw", "sheet"]
