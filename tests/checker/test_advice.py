"""What ``check`` and ``run`` advise about a program that failed: which hint, and the data in it."""

from __future__ import annotations

import struct
import time
import zipfile

import pytest

from rcj_challenges.checker.advice.hints import hint_for
from rcj_challenges.checker.advice.table import HELP_BY_ERROR
from rcj_challenges.checker.check import CheckOptions, check_file
from rcj_challenges.core.traffic import Note
from rcj_challenges.scenario.load import load
from rcj_challenges.submissions.team import open_team
from tests.checker.alone import alone

MATCH, MATCH_OF_2021 = load("match").scenario, load("match_2021").scenario
FAST_SHOOTER, LIDAR = load("fast_shooter").scenario, load("precision_lidar").scenario
FIRST_DEMO = load("match_2021", ["kits.legacy_2021.packet_has_flag=false"]).scenario
FOLDER = "rcj_soccer_team_blue"
ENTRY = f"{FOLDER}/{FOLDER}.py"
NO_FILE = "FileNotFoundError: [Errno 2] No such file or directory: "
BEGIN = "from controller import Robot\nrobot = Robot()\n"
LOOP = "while robot.step(32) != -1:\n    pass\n"


@pytest.fixture
def advise(tmp_path):
    """Return the hint for a fault of B1's program, or of the only robot of a challenge."""

    def advise(detail="", program="x = 1\n", files=(), scenario=MATCH, notes=(), whereabouts="", **fault):
        entry = next(iter(next(iter(scenario.entrants.values())).robots.values()))
        entry = entry if isinstance(entry, str) else entry[0]
        for name in (entry, *files):
            path = tmp_path / "team" / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(program if name == entry else "", encoding="utf-8")
        robot = next(iter(scenario.robots))
        fault = {"kind": "crash", "robot": robot, "tick": 2, "detail": detail, "traceback": "", **fault}
        team = open_team(tmp_path / "team", *scenario.entrants.values())
        return hint_for(scenario, team, fault, notes, whereabouts)

    return advise


WORDS = {
    "missing_module": "put the file or folder",
    "module_content": "It hides the module of that name",
    "syntax": "correct this line",
    "not_imported": "at the top of the file",
    "unknown_name": "defined further down",
    "local_variable": "has a variable of its own",
    "no_brackets": "a call needs brackets",
    "not_callable": "is not a function",
    "array_method": "numpy has removed this method",
    "none": "something in this line is None",
    "add_text": "text and numbers cannot be added",
    "vectors": "lists are not vectors",
    "whole_number": "a whole number is needed",
    "too_many_values": "positions have three numbers",
    "bytes_or_text": "bytes and text are different",
    "not_a_number": "this number is NaN",
    "refused": "only into its own folder",
    "no_file": "is not in the submission",
    "loop_ends": "ends at once",
    "hidden_error": "hides every error",
    "called_exit": "leave out exit()",
    "threads_alone": "only its threads go on",
}
"""Each hint by what it is about, with words that only it has."""


def about(hint):
    """Return what a hint is about; an unknown one as it is."""
    return next((name for name, words in WORDS.items() if words in hint), hint)


def python_error(program):
    """Return the last line of the traceback of a program, in the words of the Python that runs here."""
    with pytest.raises(BaseException) as caught:  # noqa: PT011 - whatever the program raises
        exec(compile(program, ENTRY, "exec"), {"__name__": "__main__"})  # noqa: S102
    kind = "struct.error" if caught.type is struct.error else caught.type.__name__
    return f"{kind}: {caught.value} ({ENTRY}, line {len(program.splitlines())})"


@pytest.mark.parametrize(
    ("program", "expected"),
    [
        ("import no_such_module", "missing_module"),
        ("import math\nmath.cube", "module_content"),
        ("from collections import Mapping", "module_content"),
        ("n = 0\ndef f():\n n += 1\nf()", "local_variable"),
        ("math.pi", "not_imported"),
        ("np.array([1])", "unknown_name"),
        ("'x'.upper > 0", "no_brackets"),
        ("'x'.split[0]", "no_brackets"),
        ("x, y, z = 'x'.split", "no_brackets"),
        ("max = 3\nmax(1, 2)", "not_callable"),
        ("ball = None\nball[0]", "none"),
        ("ball = None\nball.angle", "none"),
        ("x, y = None", "none"),
        ("'x: ' + 1.5", "add_text"),
        ("1.5 + ' m'", "add_text"),
        ("[1, 2] - [0, 0]", "vectors"),
        ("0.5 * [1, 2]", "vectors"),
        ("range(10 / 2)", "whole_number"),
        ("import numpy\nnumpy.zeros(2).tostring()", "array_method"),
        ("import numpy\nnumpy.zeros(2).ptp()", "array_method"),
        ("speeds = [1, 2, 3]\nspeeds[4 / 2]", "whole_number"),
        ("x, y = [1, 2, 3]", "too_many_values"),
        ("b'\\xfc'.decode()", "bytes_or_text"),
        ("b'1,2'.split(',')", "bytes_or_text"),
        ("'1,2'.decode()", "bytes_or_text"),
        ("import struct\nstruct.unpack('dd', b'xy')", "bytes_or_text"),
        ("int(float('nan'))", "not_a_number"),
        ("raise PermissionError(1, 'Operation not permitted')", "refused"),
        ("raise SyntaxError('invalid syntax')", "syntax"),
        ("open('/no/such/folder/x')", "no_file"),
        ("1 / 0", ""),
        ("raise RuntimeError('no ball')", ""),
    ],
)
def test_each_common_crash_gets_its_hint(advise, program, expected):
    assert about(advise(python_error(program), program)) == expected


def test_every_help_text_can_be_formatted(advise):
    assert all(help_.format(name="x") for help_ in HELP_BY_ERROR.values())


@pytest.mark.parametrize(
    ("asked", "there", "write"),
    [
        ("data\\params.json", f"{FOLDER}/data/params.json", '"data/params.json"'),
        ("C:\\Users\\max\\params.json", f"{FOLDER}/params.json", '"params.json"'),
        ("Params.JSON", f"{FOLDER}/params.json", '"params.json"'),
        ("shared.csv", "shared.csv", '"../shared.csv"'),
        ("model.pkl", f"{FOLDER}/other.pkl", f"put it into {FOLDER}"),
    ],
)
def test_a_file_that_was_not_found_is_named_with_what_to_write(advise, asked, there, write):
    hint = advise(f"{NO_FILE}{asked!r} ({ENTRY}, line 3)", files=[there])
    assert write in hint


@pytest.mark.parametrize("quoted", [r"'\x'", r"'\N{no such letter}'", r"'data/\ud800.txt'", r"'\'"], ids=ascii)
def test_an_error_that_a_program_made_up_itself_is_harmless(advise, quoted):
    advise(f"{NO_FILE}{quoted} ({ENTRY}, line 3)")
    advise(f"{NO_FILE}'{'x' * 5000}' (a.py, line {'9' * 5000})")


# -- devices ----------------------------------------------------------------------------------------------------------

NONE = f"AttributeError: 'NoneType' object has no attribute 'getValues' ({ENTRY}, line 1)"


def lacks(*names):
    return [Note("no-device", name, f'"{name}" device not found', "") for name in names]


@pytest.mark.parametrize(
    ("detail", "notes", "expected"),
    [
        (NONE, lacks("imu", "led"), 'getDevice("imu") or getDevice("led") returned None: these robots have'),
        (NONE, lacks("gpss"), 'getDevice("gpss") returned None: did you mean "gps"?'),
        (NONE, [Note("ignored-call", "getFromDef", "", "")], "getFromDef returned None: only a referee"),
    ],
)
def test_the_missing_device_behind_a_none_is_named(advise, detail, notes, expected):
    hint = advise(detail, notes=notes)
    assert hint.startswith(expected)


def test_a_none_that_is_no_device_is_not_blamed_on_a_missing_one(advise):
    assert about(advise(NONE.replace("getValues", "angle"), notes=lacks("led"))) == "none"
    assert about(advise(NONE)) == "none"


@pytest.mark.nightly
def test_programs_of_any_length_are_searched_quickly(advise):
    began_s = time.process_time()
    advise(NONE, "x.getValues()\n" + "x=" * 2_000_000 + "1\n", notes=lacks(*(f"led {n}" for n in range(100))))
    assert time.process_time() - began_s < 5


# -- packets of the referee -------------------------------------------------------------------------------------------

READS = "r = robot.getDevice('supervisor receiver')\n"
V22 = load("match", ["kits.v2.messages=v2.2"]).scenario
NO_JSON = f"json.decoder.JSONDecodeError: Expecting value: line 1 column 1 (char 0) ({ENTRY}, line 3)"
NO_BYTES = f"TypeError: a bytes-like object is required, not 'str' ({ENTRY}, line 2)"


@pytest.mark.parametrize(
    ("scenario", "detail", "setting"),
    [
        (MATCH, NO_JSON, "kits.v2.messages=v2.2"),
        (V22, NO_BYTES, "kits.v2.messages=v2.1"),
        (V22, "struct.error: unpack requires a buffer of 1 bytes", "kits.v2.messages=v2.1"),
    ],
)
def test_a_program_for_other_messages_gets_the_setting_that_it_needs(advise, scenario, detail, setting):
    hint = advise(detail, READS, scenario=scenario)
    assert setting in hint


@pytest.mark.parametrize(("program", "tick"), [(READS, 400), ("", 2)])
def test_a_late_crash_or_one_without_referee_packets_gives_no_advice_about_messages(advise, program, tick):
    assert about(advise(NO_BYTES, program, scenario=V22, tick=tick)) == "bytes_or_text"


@pytest.mark.parametrize(
    ("scenario", "size", "part"),
    [
        (MATCH_OF_2021, 160, "kits.legacy_2021.packet_has_flag=false"),
        (FIRST_DEMO, 161, "kits.legacy_2021.packet_has_flag=true"),
        (FAST_SHOOTER, 161, 'struct.unpack("ddd" * 1 + "dd?", packet)'),
        (LIDAR, 161, 'struct.unpack("dd?", packet)'),
    ],
)
def test_a_packet_of_another_size_is_described(advise, scenario, size, part):
    hint = advise(f"struct.error: unpack requires a buffer of {size} bytes", scenario=scenario)
    assert part in hint


# -- programs that end or hang ----------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("program", "tick", "expected"),
    [
        (BEGIN + "while robot.step(32):\n    pass\n", 1, "loop_ends"),
        (BEGIN + "while robot.step(32) == -1:\n    pass\n", 1, "loop_ends"),
        (BEGIN + "while robot.step(int(STEP)) > 0:\n    pass\n", 1, "loop_ends"),
        (BEGIN + "try:\n    1 / 0\nexcept:\n    pass\n", 1, "hidden_error"),
        (BEGIN + "try:\n    1 / 0\nexcept Exception: return\n", 1, "hidden_error"),
        (BEGIN + "try:\n    1 / 0\nexcept Exception:\n    raise\n", 1, ""),
        (BEGIN + "try:\n    1 / 0\nexcept ValueError:\n    pass\n", 1, ""),
        (BEGIN + "robot.step(32)\n", 1, ""),
    ],
)
def test_a_program_that_ends_early_gets_its_reason(advise, program, tick, expected):
    assert about(advise("the program came to its end", program, kind="exit", tick=tick)) == expected


def test_a_program_that_calls_exit_gets_that_call_as_the_reason(advise):
    assert about(advise("the program called sys.exit(0)", kind="exit")) == "called_exit"


def test_a_program_that_hangs_is_pointed_to_its_line(advise):
    program = BEGIN + "while True:\n    x = 1\n"
    hint = advise("", program, kind="step_timeout", whereabouts=f'It was here:\n  File "{ENTRY}", line 4 in <module>\n')
    assert f"line 4 of {ENTRY} (x = 1)" in hint


@pytest.mark.parametrize(
    ("whereabouts", "expected"),
    [
        ('  File "a.py", line 1\nBeside it, another thread was here:\n  File "a.py", line 2', ""),
        ("  after its last line: it waited there for its threads to end", "threads_alone"),
        ("", ""),
    ],
)
def test_with_several_threads_no_line_is_blamed(advise, whereabouts, expected):
    assert about(advise(kind="step_timeout", whereabouts=whereabouts)) == expected


# -- in a whole check -------------------------------------------------------------------------------------------------


@pytest.mark.usefixtures("sources_read_here")
@pytest.mark.parametrize(
    ("program", "finding", "part"),
    [
        (BEGIN + "while robot.step(32):\n    pass\n", "start.exit", "line 3"),
        (
            BEGIN + "import json\nr = robot.getDevice('supervisor receiver')\nr.enable(32)\n"
            "while robot.step(32) != -1:\n    if r.getQueueLength() > 0:\n        json.loads(r.getString())\n",
            "start.crash",
            "kits.v2.messages=v2.2",
        ),
    ],
)
def test_a_check_gives_the_hint_as_the_help_of_the_failure(tmp_path, program, finding, part):
    path = tmp_path / "team.zip"
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr(ENTRY, program)
        archive.writestr("team_name.txt", "Hanse")
    report = check_file(path, alone("limits.start_s=10", "limits.step_s=0.5"), CheckOptions(play_s=1.0))
    (failure,) = [one for stage in report.stages for one in stage.findings if one.level == "error"]
    assert failure.code == finding
    assert part in failure.help
