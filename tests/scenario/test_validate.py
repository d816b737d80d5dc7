"""``rcj-challenge validate``."""

import json
import re
import subprocess
import sys

from rcj_challenges.cli.validate import validate
from rcj_challenges.scenario.resources import SCENARIOS_FOLDER, names_in


def write(folder, name, text):
    (folder / name).write_text(text, encoding="utf-8")
    return str(folder / name)


GOOD = "schema_version: 2\nid: a\ntitle: Ätsch\nextends: soccersim_v2\n"


def test_files_in_order_give_a_line_each_and_exit_0(capsys):
    names = names_in(SCENARIOS_FOLDER)
    assert validate(names) == 0
    out, err = capsys.readouterr()
    assert err == ""
    assert [line.split(":")[0] for line in out.splitlines()] == [f"ok  {name}" for name in names]
    summary = r"ok  match: RoboCupJunior SoccerSim match \(6 robots, 2 entrants, \d+ rules, \d+ tests?; 2 x 600 s\)"
    assert re.search(summary, out)


def test_problems_of_all_files_are_printed_and_exit_is_2(tmp_path, capsys):
    good = write(tmp_path, "good.yaml", GOOD)
    bad = write(tmp_path, "bad.yaml", GOOD + "match: {half_s: 0}\nzone: {}\n")
    assert validate([bad, good, "nowhere.yaml"]) == 2
    out, err = capsys.readouterr()
    assert out.startswith(f"ok  {good}: Ätsch (6 robots, 2 entrants, 0 rules, 0 tests; 600 s)")
    places = [line.strip() for line in err.splitlines() if line.startswith("  -->")]
    assert places[:2] == [f"--> {bad}:5:17  match.half_s", f"--> {bad}:6:1"]
    assert places[-1] == "--> nowhere.yaml"
    assert [line.partition("]")[0] for line in err.splitlines() if line.startswith("error")] == [
        "error[wrong-value", "error[unknown-key", "error[no-such-file",
    ]  # fmt: skip
    assert "Traceback" not in err


def test_json_has_code_message_help_and_place_of_each_problem(tmp_path, capsys):
    bad = write(tmp_path, "bad.yaml", GOOD + "zone: {}\n")
    assert validate([bad], json_=True) == 2
    ((problem,),) = (one["problems"] for one in json.loads(capsys.readouterr().out)["files"])
    assert problem.pop("message")
    assert problem.pop("help").startswith("did you mean 'zones'?")
    assert problem == {"code": "unknown-key", "file": bad, "line": 5, "column": 1, "path": ""}


def test_overrides_apply_to_every_file(tmp_path, capsys):
    assert validate([write(tmp_path, "a.yaml", GOOD)], ["match.half_s=7"]) == 0
    assert "7 s)" in capsys.readouterr().out
    assert validate([write(tmp_path, "a.yaml", GOOD)], ["match.half_s=0"]) == 2
    assert "--> --set match.half_s=0  match.half_s\n" in capsys.readouterr().err


def test_nothing_heavy_is_imported_and_it_is_quick():
    """0.5 s on an idle machine. Measured as the processor's time, since this one may be busy with other tests."""
    code = (
        "import sys\nfrom rcj_challenges.cli.validate import validate\nassert validate(['match']) == 0\n"
        "import time\nprint(time.process_time())\nheavy = {'mujoco', 'numpy', 'scipy', 'jsonschema', 'rich', 'asyncio'} & set(sys.modules)\nassert not heavy, heavy\n"
    )
    times = []
    for _ in range(3):
        done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr
        times.append(float(done.stdout.splitlines()[-1]))
        if times[-1] < 1.5:
            break  # it can be as quick as that: once is enough
    assert min(times) < 1.5


def test_a_terminal_without_unicode_still_gets_the_message(tmp_path):
    bad = write(tmp_path, "bad.yaml", GOOD + "zones: {'größe': {shape: rect}}\n")
    code = f"from rcj_challenges.cli.validate import validate; raise SystemExit(validate([{bad!r}]))"
    done = subprocess.run(
        [sys.executable, "-X", "utf8=0", "-c", code],
        capture_output=True, check=False, env={**__import__("os").environ, "PYTHONIOENCODING": "ascii"},
    )  # fmt: skip
    assert done.returncode == 2
    assert b"error[wrong-name]" in done.stderr
    assert b"Traceback" not in done.stderr


TOURNAMENT = "tournament_version: 1\ntitle: Cup\nseed: 1\nteams: {a: {sample: ball_chaser}, b: {sample: ball_chaser}}\n"


def test_tournament_files_are_recognized_among_scenarios(tmp_path, capsys):
    good = write(tmp_path, "cup.yaml", TOURNAMENT + "stages: {final: {stage: knock_out}}\n")
    assert validate([good, "cup", "match"]) == 0
    out, err = capsys.readouterr()
    assert err == ""
    lines = out.splitlines()
    assert lines[0] == f"ok  {good}: Cup (2 teams, 1 stage, 1 match)"
    assert [line.split(":")[0] for line in lines[1:]] == ["ok  cup", "ok  match"]


def test_mistakes_of_tournament_files_have_a_code_a_place_and_help(tmp_path, capsys):
    bad = write(tmp_path, "bad.yaml", TOURNAMENT + "stages: {final: {stage: knockout}}\n")
    assert validate([bad]) == 2
    out, err = capsys.readouterr()
    assert out == ""
    code, place, hint = err.splitlines()
    assert code.startswith("error[unknown-word]: ")
    assert place.strip() == f"--> {bad}:5:25  stages.final"
    assert hint.startswith("help: did you mean 'knock_out'?")


def test_settings_from_the_command_line_are_refused_for_tournaments(capsys):
    assert validate(["cup"], ["match.half_s=5"]) == 2
    assert "error[set-on-tournament]" in capsys.readouterr().err


def test_validating_a_tournament_loads_neither_physics_nor_store(tmp_path):
    code = (
        "import sys; from rcj_challenges.cli.validate import validate; validate(['cup']); "
        "sys.exit(any(name in sys.modules for name in ('mujoco', 'numpy', 'sqlalchemy', 'jinja2')))"
    )
    assert subprocess.run([sys.executable, "-c", code], capture_output=True, check=False).returncode == 0
