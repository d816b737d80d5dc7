"""Breakpoints: an editor's in a program that is debugged, and ``breakpoint()`` in one that is not."""

import itertools
import json
import os
import signal
import socket
import subprocess
import sys
from pathlib import Path

import pytest

from rcj_challenges.programs import debugging
from tests.programs.fake_match import FakeMatch

ROOT = Path(__file__).parents[2]
PROGRAM = """\
import os
from controller import Robot
robot = Robot()
steps = 0
while robot.step(32) != -1:
    steps += 1
    place = os.getcwd()
"""
SHARED = "from controller import Robot\nrobot = Robot()\nwhile robot.step(32) != -1:\n    breakpoint()\n    print('went on')\n"
MATCH = """
import sys
sys.path.insert(0, {here!r})
from pathlib import Path
from fake_match import FakeMatch
from rcj_challenges.submissions.team import open_team
played = FakeMatch(Path({folder!r})).play(open_team({team!r}), 10, debug=frozenset({{"Y1"}}))
print("fault:", played.fault)
"""


class Editor:
    """As much of an editor as the Debug Adapter Protocol asks."""

    def __init__(self, port):
        self._socket = socket.create_connection(("127.0.0.1", port), timeout=60)
        self._stream = self._socket.makefile("rwb")
        self._numbers = itertools.count(1)
        self._events = []

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self._stream.close()
        self._socket.close()

    def send(self, name, **arguments):
        """Send a request; returns its number."""
        number = next(self._numbers)
        body = json.dumps({"seq": number, "type": "request", "command": name, "arguments": arguments}).encode()
        self._stream.write(b"Content-Length: %d\r\n\r\n%b" % (len(body), body))
        self._stream.flush()
        return number

    def ask(self, name, **arguments):
        """Send a request and return the body of the answer."""
        number = self.send(name, **arguments)
        while True:
            message = self._receive()
            if message["type"] == "response" and message["request_seq"] == number:
                assert message["success"], message
                return message.get("body", {})
            self._events.append(message)

    def wait_for(self, event):
        """Return the body of the next such event."""
        while True:
            message = self._events.pop(0) if self._events else self._receive()
            if message.get("event") == event:
                return message.get("body", {})

    def _receive(self):
        length = 0
        while (line := self._stream.readline().strip()) or not length:
            assert line, "the debugger is gone"
            length = int(line.partition(b":")[2]) if line.lower().startswith(b"content-length") else length
        return json.loads(self._stream.read(length))


@pytest.fixture
def debugged(tmp_path):
    """Start a short match in which the program of Y1 waits for an editor; yields the process, the port, the program."""
    pytest.importorskip("debugpy")
    team = tmp_path / "my_team"
    team.mkdir()
    (team / "robot.py").write_text(PROGRAM, encoding="utf-8")
    match = MATCH.format(here=str(Path(__file__).parent), folder=str(tmp_path), team=str(team))
    command = [sys.executable, "-c", match]
    with subprocess.Popen(command, cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
        try:
            for line in process.stderr:
                if "waits for VS Code" in line:
                    yield process, int(line.rsplit(maxsplit=1)[1]), team / "robot.py"
                    break
            else:
                pytest.fail("it did not wait for an editor")
        finally:
            process.kill()


@pytest.mark.skipif(sys.platform == "win32", reason="POSIX quoting of paths in the protocol")
def test_an_editor_stops_at_a_breakpoint_in_the_teams_own_file_reads_a_variable_and_goes_on(debugged):
    process, port, program = debugged
    with Editor(port) as editor:
        editor.ask("initialize", adapterID="test", pathFormat="path", linesStartAt1=True)
        attached = editor.send("attach", justMyCode=True)
        editor.wait_for("initialized")
        answer = editor.ask(
            "setBreakpoints", source={"path": str(program)}, breakpoints=[{"line": 7, "condition": "steps == 3"}]
        )
        assert [one["verified"] for one in answer["breakpoints"]] == [True]
        editor.ask("configurationDone")
        assert attached
        stopped = editor.wait_for("stopped")
        assert stopped["reason"] == "breakpoint"
        frame = editor.ask("stackTrace", threadId=stopped["threadId"])["stackFrames"][0]
        assert (frame["source"]["path"], frame["line"]) == (str(program), 7)
        assert editor.ask("evaluate", expression="steps", frameId=frame["id"])["result"] == "3"
        editor.ask("next", threadId=stopped["threadId"])
        editor.wait_for("stopped")
        place = editor.ask(
            "evaluate",
            expression="place",
            frameId=editor.ask("stackTrace", threadId=stopped["threadId"])["stackFrames"][0]["id"],
        )
        assert place["result"] == repr(str(program.parent))
        editor.ask("setBreakpoints", source={"path": str(program)}, breakpoints=[])
        editor.ask("continue", threadId=stopped["threadId"])
        editor.wait_for("terminated")
    said, complaint = process.communicate(timeout=60)
    assert process.returncode == 0, complaint
    assert said == "fault: None\n"


def start_debugged(tmp_path, program, setting="", **options):
    (tmp_path / "my_team").mkdir()
    (tmp_path / "my_team" / "robot.py").write_text(program, encoding="utf-8")
    match = MATCH.format(here=str(Path(__file__).parent), folder=str(tmp_path), team=str(tmp_path / "my_team"))
    command = [sys.executable, "-c", f"from rcj_challenges.programs import debugging\n{setting}\n{match}"]
    pipes = dict.fromkeys(("stdin", "stdout", "stderr"), subprocess.PIPE)
    return subprocess.Popen(command, cwd=ROOT, text=True, **pipes, **options)


def test_leaving_the_debugger_ends_the_program_and_is_no_crash(tmp_path):
    with start_debugged(tmp_path, SHARED, env={**os.environ, "PYTHONBREAKPOINT": "pdb.set_trace"}) as process:
        said, complaint = process.communicate("q\n", timeout=60)
    assert "kind='exit'" in said.partition("fault:")[2]
    assert "Traceback" not in said + complaint


@pytest.mark.skipif(sys.platform == "win32", reason="Ctrl-C is sent as a signal to a group of processes")
def test_a_taken_port_is_named_with_what_to_attach_to_and_the_wait_can_be_interrupted(tmp_path):
    pytest.importorskip("debugpy")
    with socket.create_server(("127.0.0.1", 0)) as taken:
        port = taken.getsockname()[1]
        with start_debugged(tmp_path, PROGRAM, f"debugging.PORT = {port}", start_new_session=True) as process:
            notice, waits = (next(line for line in process.stderr if "port" in line) for _ in range(2))
            os.killpg(process.pid, signal.SIGINT)
            _, complaint = process.communicate(timeout=60)
    assert f"port {port} is taken" in notice
    assert waits.split()[-1] in notice
    assert "wait_for_editor" not in complaint


def test_breakpoint_in_a_program_that_is_not_debugged_only_prints_one_notice(tmp_path):
    played = FakeMatch(tmp_path).play(SHARED, 3)
    assert played.fault is None
    assert played.said.count("went on") >= 2
    assert sum("--debug Y1" in line for line in played.said) == 1


@pytest.mark.parametrize(("installed", "variable"), [(False, ""), (True, "pdb.set_trace")])
def test_without_debugpy_or_if_the_user_wants_it_breakpoint_has_the_terminal(monkeypatch, installed, variable):
    monkeypatch.setenv("PYTHONBREAKPOINT", variable)
    if not installed:
        monkeypatch.setattr(debugging, "find_spec", lambda _: None)
    assert debugging.debugger_settings() is None
