"""``rcj-challenge validate``."""

import re
import subprocess
import sys

from rcj_challenges.cli.validate import validate_files
from rcj_challenges.scenario.resources import names_in, scenarios_folder


def write(folder, name, text):
    (folder / name).write_text(text, encoding="utf-8")
    return str(folder / name)


GOOD = "schema_version: 1\nid: a\ntitle: Ätsch\nextends: soccersim_v2\n"


def test_files_in_order_give_a_line_each_and_exit_0(capsys):
    names = names_in(scenarios_folder())
    assert validate_files(names, []) == 0
    out, err = capsys.readouterr()
    assert err == ""
    assert [line.split(":")[0] for line in out.splitlines()] == [f"ok  {name}" for name in names]
    summary = r"ok  match: RoboCupJunior SoccerSim match \(6 robots, 2 entrants, \d+ rules, \d+ tests?; 2 x 600 s\)"
    assert re.search(summary, out)


def test_problems_of_all_files_are_printed_and_exit_is_2(tmp_path, capsys):
    good = write(tmp_path, "good.yaml", GOOD)
    bad = write(tmp_path, "bad.yaml", GOOD + "match: {half_s: 0}\nzone: {}\n")
    assert validate_files([bad, good, "nowhere.yaml"], []) == 2
    out, err = capsys.readouterr()
    assert out.startswith(f"ok  {good}: Ätsch (6 robots, 2 entrants, 0 rules, 0 tests; 600 s)")
    lines = [line for line in err.splitlines() if not line.startswith(("warning[", "  --> ", "help: "))]
    assert lines[0].startswith(f"{bad}:5:17: match.half_s: ")
    assert lines[1].startswith(f"{bad}:6:1: unknown key 'zone'")
    assert lines[2].startswith("nowhere.yaml: no such file")
    assert "Traceback" not in err


def test_overrides_apply_to_every_file(tmp_path, capsys):
    assert validate_files([write(tmp_path, "a.yaml", GOOD)], ["match.half_s=7"]) == 0
    assert "7 s)" in capsys.readouterr().out
    assert validate_files([write(tmp_path, "a.yaml", GOOD)], ["match.half_s=0"]) == 2
    assert capsys.readouterr().err.startswith(
        "--set match.half_s=0: match.half_s: a duration must be at least one tick"
    )


def test_nothing_heavy_is_imported_and_it_is_quick():
    """0.5 s on an idle machine. Measured as the processor's time, since this one may be busy with other tests."""
    code = (
        "import sys\nfrom rcj_challenges.cli.validate import validate_files\nassert validate_files(['match'], []) == 0\n"
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
    code = f"from rcj_challenges.cli.validate import validate_files; raise SystemExit(validate_files([{bad!r}], []))"
    done = subprocess.run(
        [sys.executable, "-X", "utf8=0", "-c", code],
        capture_output=True, check=False, env={**__import__("os").environ, "PYTHONIOENCODING": "ascii"},
    )  # fmt: skip
    assert done.returncode == 2
    assert b"is no name" in done.stderr
    assert b"Traceback" not in done.stderr
