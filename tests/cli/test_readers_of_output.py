"""Whoever reads what the command prints may go away: the match is played to its end all the same."""

import errno
import io
import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

from rcj_challenges.cli import output_paths, stdio
from tests.cli.conftest import STAND


def test_match_continues_when_its_output_is_no_longer_read(tmp_path: Path) -> None:
    Path(tmp_path, "team.py").write_text(STAND, encoding="utf-8")
    teams = ["--blue", "team.py", "--yellow", "team.py"]
    command = [sys.executable, "-m", "rcj_challenges", "run", "match", *teams, "--halves", "1", "--duration", "2"]
    with subprocess.Popen(command, cwd=tmp_path, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as playing:
        assert playing.stdout is not None
        assert playing.stderr is not None
        assert playing.stdout.readline()
        playing.stdout.close()
        printed = playing.stderr.read()
    assert (playing.returncode, printed) == (0, "")
    (result,) = Path(tmp_path, "runs").glob("*/result.json")
    assert json.loads(result.read_text(encoding="utf-8"))["complete"]


def printing(monkeypatch: pytest.MonkeyPatch, errors: str, encoding: str = "cp1252") -> io.BytesIO:
    """Let standard output be as on Windows where it goes into a file; return what gets there."""
    file = io.BytesIO()
    monkeypatch.setattr(sys, "stdout", io.TextIOWrapper(file, encoding=encoding, errors=errors, newline="\r\n"))
    return file


@pytest.mark.parametrize("errors", ["strict", "surrogateescape"])  # the second is Python's choice on Windows
def test_letters_that_the_output_cannot_encode_are_replaced(monkeypatch, errors: str) -> None:
    file = printing(monkeypatch, errors)
    stdio.replace_unencodable()
    print("Grün → Łódź.mp4", flush=True)
    assert file.getvalue() == "Grün -> ?ód?.mp4\r\n".encode("cp1252")


@pytest.mark.parametrize("encoding", ["ascii", "utf-8"])
def test_the_bytes_of_names_stay_what_they_are(monkeypatch: pytest.MonkeyPatch, encoding: str) -> None:
    file = printing(monkeypatch, "surrogateescape", encoding)
    stdio.replace_unencodable()
    print("\udcc5.mp4", flush=True)
    assert file.getvalue() == b"\xc5.mp4\r\n"


def test_a_document_is_utf_8_wherever_it_goes(monkeypatch: pytest.MonkeyPatch) -> None:
    """A redirected sheet or drawing is a file as ``--out`` writes it, whatever code page the system has."""
    file = printing(monkeypatch, "strict")
    output_paths.deliver("π = 180°\n<svg/>\n", None)
    sys.stdout.flush()
    assert file.getvalue() == "π = 180°\n<svg/>\n".encode()


@pytest.mark.parametrize(
    ("printed", "raised"), [(errno.EINVAL, BrokenPipeError), (errno.EPIPE, BrokenPipeError), (errno.ENOSPC, OSError)]
)
def test_closed_pipe_is_detected_however_the_system_reports_it(monkeypatch, printed: int, raised: type) -> None:
    """Windows says of such a pipe that the argument is invalid."""
    read_fd, write_fd = os.pipe()
    try:
        with os.fdopen(write_fd, "w", encoding="cp850", errors="backslashreplace", closefd=False) as usual:
            monkeypatch.setattr(sys, "stdout", usual)
            monkeypatch.setattr(sys, "stderr", usual)
            stdio.detect_closed_pipes()
            stream = sys.stdout
            assert stream is not usual
            assert stream.fileno() == write_fd
            print("grün \N{PENCIL}")
            stream.flush()
            assert os.read(read_fd, 100).splitlines() == ["grün \\u270f".encode("cp850")]

            def refuse(*_: object) -> int:
                raise OSError(printed, os.strerror(printed))

            with monkeypatch.context() as gone:
                gone.setattr(os, "write", refuse)
                print("nobody")
                with pytest.raises(OSError, match=r"\[Errno") as caught:
                    stream.flush()
            assert type(caught.value) is raised
            stdio.discard_output(stream)
            stream.flush()
    finally:
        os.close(read_fd)
        os.close(write_fd)
