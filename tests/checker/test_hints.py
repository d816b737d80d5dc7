"""What a check says about a fault beyond the fault's own words, so that a pupil knows what to change."""

from __future__ import annotations

import time
import zipfile
from pathlib import Path, PurePosixPath

import pytest

from rcj_challenges.checker.advice.early_ends import why_it_ended
from rcj_challenges.checker.advice.hints import hint_on
from rcj_challenges.checker.advice.no_device import is_of_a_device
from rcj_challenges.checker.check import CheckOptions, check_file
from rcj_challenges.controllers.team import open_team
from rcj_challenges.scenario.load import load
from tests.checker.alone import ONE_EACH, alone

pytestmark = pytest.mark.usefixtures("sources_read_here")

ENTRY = "rcj_soccer_team_blue/rcj_soccer_team_blue.py"
LIMITS = ("limits.start_s=10", "limits.step_s=0.5")
V21, V22 = alone(*LIMITS), alone(*LIMITS, "kits.v2.messages=v2.2")
DUELS = [load("match", [*LIMITS, *ONE_EACH]), load("match", [*LIMITS, *ONE_EACH, "kits.v2.messages=v2.2"])]
STYLES = Path(__file__).resolve().parents[1] / "programs" / "styles"

BEGIN = """\
import json, struct
from controller import Robot
robot = Robot()
receiver = robot.getDevice("supervisor receiver")
receiver.enable(32)
for name in ("left wheel motor", "right wheel motor"):
    robot.getDevice(name).setPosition(float("inf"))
"""
LOOP = """\
while robot.step(32) != -1:
    while receiver.getQueueLength() > 0:
        waiting = READ
        receiver.nextPacket()
"""
READS_JSON = LOOP.replace("READ", "json.loads(receiver.getString())")
JSON_PROGRAM = BEGIN + READS_JSON
BYTE_PROGRAM = BEGIN + LOOP.replace("READ", 'struct.unpack("?", receiver.getData())[0]')


@pytest.fixture
def check(tmp_path):
    def checked(program, scenario=V21, play_s=1.0, **others):
        path = tmp_path / "team.zip"
        with zipfile.ZipFile(path, "w") as archive:
            archive.writestr(ENTRY, program)
            archive.writestr("team_name.txt", "Hanse")
            for name, text in others.items():
                archive.writestr(f"rcj_soccer_team_blue/{name}.py", text)
        return check_file(path, scenario, CheckOptions(play_s=play_s))

    return checked


@pytest.fixture(scope="module")
def fitting(tmp_path_factory):
    """Return the reports of programs that play with the messages that they were written for."""
    reports = {}
    for name, program, scenario, play_s in (
        ("v2.1", BYTE_PROGRAM, DUELS[0], 1.0),
        ("v2.2", JSON_PROGRAM, DUELS[1], 3.0),
    ):
        path = tmp_path_factory.mktemp("fitting") / "team.zip"
        with zipfile.ZipFile(path, "w") as archive:
            archive.writestr(ENTRY, program)
            archive.writestr("team_name.txt", "Hanse")
        reports[name] = check_file(path, scenario, CheckOptions(play_s=play_s))
    return reports


def failure(report):
    """Return the only failure."""
    (found,) = [finding for stage in report.stages for finding in stage.findings if finding.level == "failure"]
    return found


@pytest.mark.parametrize("read", ["json.loads(receiver.getString())", "json.loads(receiver.getData())"])
def test_a_program_that_reads_json_where_the_packet_is_a_byte_is_told_how_to_play_with_v2_2(check, read):
    found = failure(check(BEGIN + LOOP.replace("READ", read)))
    assert found.code == "start.crash"
    assert "JSONDecodeError" in found.message
    assert found.message.endswith("this program seems to be written for messages v2.2")
    assert "--set kits.v2.messages=v2.2" in found.remedy
    assert "one byte" in found.remedy


@pytest.mark.parametrize("side", ['robot.getName()[0] == "B"', "robot.getName()[0] in ('B', 'b')"])
def test_who_asks_for_the_letter_of_its_colour_reads_no_byte(check, side):
    own = f"is_blue = {side}\n{READS_JSON}    struct.unpack('<d', '') or receiver.getData()\n"
    assert "--set" not in failure(check(BEGIN + own, V22)).remedy


@pytest.mark.parametrize(
    ("usual", "written"),
    [
        ("import json, struct\n", 'import json, struct\nIS_BLUE = lambda robot: robot.getName()[0] == "B"\n'),
        ("import json, struct\n", "import json, struct\nSIDES = {'b': -1, 'y': 1}\n"),
        ('robot.getDevice("supervisor receiver")', "robot.getDevice(f\"{'supervisor'} receiver\")"),
    ],
    ids=["the letter of blue", "small letters", "a name made of parts"],
)
def test_a_program_for_v2_2_is_known_for_one_whatever_else_it_writes(check, usual, written):
    found = failure(check((BEGIN + LOOP).replace(usual, written).replace("READ", "json.loads(receiver.getString())")))
    assert found.message.endswith("this program seems to be written for messages v2.2")


@pytest.mark.parametrize("form", ["'ddd' * 6 + 'dd?'", "'ddd' * 6 + 'dd'"])
def test_a_program_that_reads_the_packets_of_2021_is_told_what_is_in_those_of_today(check, form):
    found = failure(check(BEGIN + LOOP.replace("READ", f"struct.unpack({form}, receiver.getData())")))
    assert found.message.endswith("this program reads the referee's packets of 2021")
    assert 'struct.unpack("?", receiver.getData())' in found.remedy
    assert "gps" in found.remedy


@pytest.mark.parametrize("form", ['"?"', "'<?'", '"B"', "'=b'", '"c"'])
@pytest.mark.parametrize("begins", ["struct.unpack(FORM, ", "struct.Struct(FORM).unpack("])
def test_a_program_that_knows_the_byte_is_not_told_of_it(check, begins, form):
    loop = LOOP.replace("READ", begins.replace("FORM", form) + "receiver.getData())[0]") + "    json.loads('')\n"
    assert "messages" not in failure(check(BEGIN + loop)).remedy


@pytest.mark.parametrize("read", ["getData()", "getBytes()"])
def test_a_program_that_reads_bytes_where_the_packet_is_json_is_told_how_to_play_with_v2_1(check, read):
    found = failure(check(BYTE_PROGRAM.replace("getData()", read), V22))
    assert found.message.endswith("this program seems to be written for messages v2.1")
    assert "--set kits.v2.messages=v2.1" in found.remedy
    assert "getBytes()" in found.remedy


def test_a_whole_program_of_2022_is_told_so_too():
    (blue,) = [
        finding
        for finding in check_file(STYLES / "style_2022", V22, CheckOptions(play_s=1.0)).stages[4].findings
        if finding.level == "failure"
    ]
    assert "--set kits.v2.messages=v2.1" in blue.remedy


@pytest.mark.parametrize("messages", ["v2.1", "v2.2"])
def test_a_program_plays_with_the_messages_that_it_was_written_for(fitting, messages):
    assert fitting[messages].level != "failure"


@pytest.mark.parametrize(
    "line",
    [
        'json.loads("")',  # in a program that knows the byte of v2.1
        'json.loads(open("empty.json", "w+").read())',
        "robot.getTime() / 0",
    ],
)
def test_other_crashes_in_the_first_step_say_nothing_about_messages(check, line):
    loop = LOOP.replace("READ", 'struct.unpack("?", receiver.getData())[0]') + f"    {line}\n"
    assert "messages" not in failure(check(BEGIN + loop)).remedy


def test_a_file_that_is_no_json_says_nothing_about_messages(check):
    loop = LOOP.replace("READ", "receiver.getBytes()") + '    json.loads(open("empty.json", "w+").read())\n'
    assert "messages" not in failure(check(BEGIN + loop)).remedy


def test_a_packet_of_later_steps_that_is_no_json_says_nothing_about_messages(check):
    loop = LOOP.replace("READ", "receiver.getString()") + "    robot.getTime() > 0.5 and json.loads('')\n"
    told = [finding for finding in check(BEGIN + loop).stages[5].findings if finding.level == "failure"]
    assert [finding.code for finding in told] == ["play.crash"]
    assert "messages" not in told[0].remedy


def test_text_of_the_teams_own_radio_says_nothing_about_messages(check):
    loop = LOOP.replace("READ", "receiver.getBytes()[0] == 1") + '    json.loads("")\n'
    assert "messages" not in failure(check(BEGIN + loop)).remedy


@pytest.mark.parametrize(
    ("error", "line"),
    [
        # What mates sent is read the wrong way; no mate plays here, so the line fails of something of its own.
        ("UnicodeDecodeError", "struct.pack('<d', -1.5).decode() or receiver.getString()"),
        ("UnicodeDecodeError", "struct.pack('<d', -1.5).decode() or receiver.getData()"),
        ("TypeError: a bytes-like object is required", "struct.unpack('<d', '') or receiver.getData()"),
    ],
)
def test_bytes_on_the_radio_of_a_program_for_v2_2_are_no_reason_to_play_with_v2_1(check, error, line):
    found = failure(
        check(BEGIN + LOOP.replace("READ", "json.loads(receiver.getString())") + f"    told = {line}\n", V22)
    )
    assert error in found.message
    assert "--set" not in found.remedy
    assert "getBytes()" in found.remedy


def test_a_place_that_nobody_could_look_up_is_no_reason_to_stumble(check):
    lines = "9" * 5000
    loop = (
        LOOP.replace("READ", "receiver.getData()") + f"    raise ValueError('a\\n  File \"robot.py\", line {lines}')\n"
    )
    assert failure(check(BEGIN + loop)).code == "start.crash"


def test_a_name_that_only_the_teams_own_controller_has_is_told_with_the_file_to_rename(check):
    found = failure(check("from controller import Robot, PIDController\n", controller="class PIDController: pass\n"))
    assert '"PIDController"' in found.remedy
    assert "rcj_soccer_team_blue/controller.py" in found.remedy


WAIT = """\
import asyncio
async def play():
    while robot.step(32) != -1:
        await asyncio.Event().wait()
asyncio.run(play())
"""


def test_a_wait_that_never_ends_is_told_as_a_wait_with_its_line(check):
    found = failure(check(BEGIN + WAIT))
    assert found.code == "start.step_timeout"
    assert "was waiting" in found.remedy
    assert f"line 12 of {ENTRY} (asyncio.run(play()))" in found.remedy
    assert "loop that never" not in found.remedy


def test_a_loop_without_step_is_told_with_its_line(check):
    found = failure(check(BEGIN + "robot.step(32)\nwhile robot.getTime() < 5:\n    x = ', '.join(['a'])\n"))
    assert "loop that never calls robot.step(32)" in found.remedy
    assert "was waiting" not in found.remedy
    assert f"line 9 of {ENTRY}" in found.remedy or f"line 10 of {ENTRY}" in found.remedy


def test_of_several_threads_no_line_is_blamed(check):
    threads = "import threading\nthreading.Thread(target=threading.Event().wait, daemon=True).start()\n"
    found = failure(check(BEGIN + threads + "robot.step(32)\nwhile True:\n    pass\n"))
    assert found.code == "start.step_timeout"
    assert "line" not in found.remedy


def test_who_imports_threading_and_starts_no_thread_is_told_the_line(check):
    found = failure(check("import threading\n" + BEGIN + "robot.step(32)\nwhile True:\n    threading.active_count()\n"))
    assert found.code == "start.step_timeout"
    assert "look for a loop that never calls robot.step(32): the program was in line" in found.remedy


def test_where_each_of_several_threads_was_is_told_apart(check):
    threads = "import threading\ndef wait():\n    threading.Event().wait()\nthreading.Thread(target=wait, daemon=True).start()\n"
    found = failure(check(BEGIN + threads + "robot.step(32)\nwhile True:\n    pass\n"))
    told = found.details.splitlines()
    beside = told.index("Beside it, another thread was here:")
    assert [line.rpartition(" in ")[2] for line in told[1:beside]] == ["<module>"]
    assert [line.rpartition(" in ")[2] for line in told[beside + 1 :]] == ["wait"]


def test_a_program_of_which_only_threads_go_on_is_told_that_it_came_to_its_end(check):
    threads = "import threading\nthreading.Thread(target=threading.Event().wait).start()\n"
    found = failure(check(BEGIN + threads + "robot.step(32)\n"))
    assert found.code == "start.step_timeout"
    assert found.remedy.startswith("the program itself came to its end, and only its threads go on")
    assert found.details.splitlines()[-1].startswith("  after its last line")


@pytest.mark.parametrize("attribute", ["enable", "value"])
def test_who_holds_a_device_is_found_out_in_no_time(tmp_path, attribute):
    program = f"x.{attribute}\n" + "x=" * 2_500_000 + "1\nx = robot.getDevice('lidar')\n"
    (tmp_path / "robot.py").write_text(program, encoding="utf-8")
    detail = f"AttributeError: 'NoneType' object has no attribute '{attribute}' (robot.py, line 1)"
    with open_team(tmp_path / "robot.py") as team:
        began_s = time.process_time()  # what else the machine does is not counted
        assert is_of_a_device(detail, team)
        assert time.process_time() - began_s < 5


def test_a_line_without_end_is_looked_at_in_no_time(tmp_path):
    (tmp_path / "robot.py").write_text("x.wait(timeout=" * 200_000, encoding="utf-8")
    fault = {"kind": "step_timeout", "robot": "B1", "tick": 1, "detail": "", "traceback": ""}
    with open_team(tmp_path, *V21.scenario.entrants.values()) as team:
        began_s = time.process_time()  # what else the machine does is not counted
        hint = hint_on(V21.scenario, team, fault, 'It was here:\n  File "robot.py", line 1 in <module>\n')
        assert time.process_time() - began_s < 5
    assert len(hint.remedy) < 400


FAILS_AS_OPPONENT = "import struct\nfrom controller import Robot\nrobot = Robot()\nrobot.step(32)\n1 / 0\n"


def test_an_opponent_whose_programs_fail_is_told_and_is_no_fault_of_the_team(check, monkeypatch, tmp_path):
    sample = tmp_path / "sample"
    sample.mkdir()
    (sample / "robot.py").write_text(FAILS_AS_OPPONENT, encoding="utf-8")
    monkeypatch.setattr("rcj_challenges.checker.rehearsal.sample_team", lambda *_: sample)
    play = check(BYTE_PROGRAM, DUELS[0]).stages[5]
    told = [finding for finding in play.findings if finding.code == "play.opponent_failed"]
    assert [finding.level for finding in told] == ["passed", "passed"]
    assert told[0].message.startswith("as blue, programs of the opponent failed (sample: Y1;")
    assert "ZeroDivisionError" in told[0].message
    assert "not your fault" in told[0].remedy
    assert play.level != "failure"


@pytest.mark.parametrize("messages", ["v2.1", "v2.2"])
def test_of_sample_teams_that_play_as_opponents_with_either_messages_nothing_is_said(fitting, messages):
    play = fitting[messages].stages[5]
    assert play.name == "play"
    assert not play.skipped
    assert "play.opponent_failed" not in {finding.code for finding in play.findings}


ENDS = "from controller import Robot\nrobot = Robot()\n"


@pytest.mark.parametrize(
    "test", ["robot.step(32)", "robot.step(32) == -1", "robot.step(32) != 0", "robot.step(32) > 0"]
)
def test_a_loop_that_ends_at_once_is_named(check, test):
    found = failure(check(ENDS + f"while {test}:\n    pass\n"))
    assert found.code == "start.exit"
    assert found.remedy.startswith(
        "step returns 0 while the match goes on and -1 at its end, so the loop in line 3 ends"
    )


@pytest.mark.parametrize("name", ["strategy", "größe", "strategy/__init__"])
def test_such_a_loop_is_named_in_another_file_as_well(check, name):
    module = name.partition("/")[0]
    found = failure(check(f"import {module}\n", **{name: ENDS + "while robot.step(32):\n    pass\n"}))
    assert f"the loop in line 3 of rcj_soccer_team_blue/{name}.py ends at once" in found.remedy


def test_a_loop_of_another_robots_program_is_not_why_this_one_ended(tmp_path):
    ends_at_once = ENDS + "while robot.step(32):\n    pass\n"
    path = tmp_path / "team.zip"
    with zipfile.ZipFile(path, "w") as archive:
        for number, program in enumerate((ends_at_once, ENDS, "\n" + ends_at_once), start=1):
            archive.writestr(f"robot{number}/robot{number}.py", program)
    report = check_file(path, load("match"), CheckOptions(play_s=1.0))
    told = {found.where: found.remedy for stage in report.stages for found in stage.findings if "start." in found.code}
    assert "the loop in line 3 ends at once" in told["B1, Y1"]
    assert told["B2, Y2"].startswith("call robot.step(32) in a loop until it returns -1")
    assert "the loop in line 4 ends at once" in told["B3, Y3"]


@pytest.mark.parametrize("last", ["", "if __name__ == 'main':\n    print('never')\n"])
def test_a_loop_that_nobody_comes_to_is_named(check, last):
    found = failure(check(ENDS + "def play():\n    while robot.step(32) != -1:\n        pass\n" + last))
    assert (
        found.remedy
        == "the loop with step is in play(), line 3, and nothing calls it: call play() at the end of the program"
    )


@pytest.mark.parametrize("name", ["main", "__main", "__name__", "rcj_soccer_team_blue"])
def test_a_name_that_the_started_program_does_not_have_is_told_with_its_line(check, name):
    play = "def play():\n    while robot.step(32) != -1:\n        pass\n"
    found = failure(check(ENDS + play + f"if __name__ == '{name}':\n    play()\n"))
    assert found.remedy == (
        'a program that is started has the name "__main__", so nothing comes to what is under line 6: '
        'write if __name__ == "__main__":'
    )


def test_who_asks_for_the_right_name_elsewhere_is_told_nothing_of_names():
    entry = PurePosixPath("a.py")
    program = b"def play():\n    pass\nif __name__ == '__main__':\n    play()\nif __name__ == 'test':\n    play()\n"
    assert why_it_ended({entry: program}, entry) == ""


@pytest.mark.parametrize("leave", ["exit()", "quit()", "sys.exit(1)", "raise SystemExit"])
def test_who_calls_exit_while_the_match_goes_on_is_told_of_that_call(check, leave):
    found = failure(check("import sys\n" + ENDS + f"while robot.step(32) != -1:\n    {leave}\n"))
    assert found.remedy == (
        "leave out exit(), quit() and sys.exit(), or call them only after step has returned -1: "
        "the robot of a program that ends stands for the rest of the half"
    )


METHOD = """
class Bot(Robot):
    def other(self):
        def inner():
            pass
    def run(self):
        while self.step(32) != -1:
            pass
"""
INIT = METHOD.replace("run", "__init__").replace("Bot", "Attacker")


@pytest.mark.parametrize(
    ("program", "remedy"),
    [
        (
            METHOD + "def main():\n    pass\nBot()\n",
            (
                "the loop with step is in the method run() of Bot, line 6, and nothing calls it: "
                "make a Bot at the end of the program and call its run()"
            ),
        ),
        (
            INIT,
            (
                "the loop with step is in __init__() of Attacker, line 6, and nothing makes an Attacker: "
                "make one at the end of the program"
            ),
        ),
        (INIT + "bot = Attacker()\n", ""),
        (METHOD + "Bot().run()\n", ""),
        (METHOD.replace("run", "__call__") + "Bot()()\n", ""),
        (
            "if True:\n  class A:\n    x = 1\n  def play():\n    while robot.step(32) != -1:\n      pass\n",
            "the loop with step is in play(), line 4, and nothing calls it: call play() at the end of the program",
        ),
    ],
)
def test_a_loop_in_a_method_that_nobody_comes_to_is_told_with_its_class(program, remedy):
    entry = PurePosixPath("a.py")
    assert why_it_ended({entry: program.encode()}, entry) == remedy


HELPER = "def wait():\n    while robot.step(32) != -1:\n        break\n"


@pytest.mark.parametrize(
    "played",
    [
        "while robot.step(32) != -1:\n    break\n",
        "while True:\n    if robot.step(32) == -1 or True:\n        break\n",
        "def play():\n    while robot.step(32) != -1:\n        break\nplay()\n",
    ],
)
def test_a_program_that_left_its_loop_is_not_told_to_call_a_helper_that_it_does_not_need(played):
    entry = PurePosixPath("a.py")
    assert why_it_ended({entry: (HELPER + played).encode()}, entry, has_stepped=True) == ""
    assert "call wait()" in why_it_ended({entry: HELPER.encode()}, entry)
    stepped_once = HELPER + "robot.step(32)\n"
    assert "call wait()" in why_it_ended({entry: stepped_once.encode()}, entry, has_stepped=True)
    loop_elsewhere = HELPER + "def play():\n    while robot.step(32) != -1:\n        pass\nplay\n"
    assert "call wait()" in why_it_ended({entry: loop_elsewhere.encode()}, entry)


def test_whether_it_left_its_loop_is_told_by_the_match(check):
    assert "wait()" not in failure(check(BEGIN + HELPER + "while robot.step(32) != -1:\n    break\n")).remedy
    assert "call wait()" in failure(check(BEGIN + HELPER)).remedy


@pytest.mark.parametrize("quotes", ['"""', "'''"])
def test_a_loop_that_stands_in_a_text_is_none(quotes):
    entry = PurePosixPath("a.py")
    loop = "while robot.step(32):\n    pass\n"
    text = f'"""One line."""\n# don{quotes}t\nx = {quotes}\n{loop}{quotes}\n'
    assert why_it_ended({entry: text.encode()}, entry) == ""
    assert "the loop in line 7 ends at once" in why_it_ended({entry: (text + loop).encode()}, entry)


def test_a_function_that_is_named_and_not_called_is_told_with_its_line():
    entry = PurePosixPath("a.py")
    program = "class Bot:\n    def run(self):\n        while robot.step(32) != -1:\n            pass\nbot = Bot()\n"
    remedy = "line 6 names bot.run and does not call it: a call needs brackets, bot.run()"
    assert why_it_ended({entry: (program + "bot.run\n").encode()}, entry) == remedy
    assert why_it_ended({entry: (program + "bot.run\nbot.run()\n").encode()}, entry) == ""
    assert why_it_ended({entry: (program + "bot.run\n").encode()}, entry, has_stepped=True) == ""


def test_among_very_many_functions_and_files_it_is_found_out_at_once():
    began_s = time.process_time()
    loops = "".join(f"def f{number}():\n    while 1: x.step(1)\nf{number}()\n" for number in range(20_000))
    entry, other = PurePosixPath("a.py"), b"import a\n" * 1_500
    files = {entry: loops.encode() + other, **{PurePosixPath(f"d{number}/a.py"): other for number in range(4_000)}}
    assert why_it_ended(files, entry) == ""
    assert time.process_time() - began_s < 10


@pytest.mark.parametrize(
    "program",
    [
        "robot.step(32)\n",
        "def play():\n    while robot.step(32) != -1:\n        break\nplay()\n",
        "while robot.step(32) >= 0:\n    break\n",
        "class Bot:\n    def run(self):\n        while robot.step(32) != -1:\n            break\nbot = Bot()\nbot.run()\n",
    ],
)
def test_where_the_lines_do_not_tell_it_is_said_what_every_program_has_to_do(check, program):
    found = failure(check(ENDS + program))
    assert found.remedy.startswith("call robot.step(32) in a loop until it returns -1")


def test_a_module_that_was_compiled_for_another_python_is_named(tmp_path):
    path = tmp_path / "team.zip"
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr(ENTRY, "import fast\n" + BEGIN)
        archive.writestr("rcj_soccer_team_blue/fast.cp38-win_amd64.pyd", b"MZ" + bytes(100))
    found = failure(check_file(path, V21, CheckOptions(play_s=1.0)))
    assert "No module named 'fast'" in found.message
    assert found.remedy == (
        "rcj_soccer_team_blue/fast.cp38-win_amd64.pyd was compiled for one version of Python on one system, and not for "
        "this one: hand in what it was made of (fast.py), or do without it"
    )
