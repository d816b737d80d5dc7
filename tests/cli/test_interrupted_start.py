"""Ctrl-C before anything is played: one line, exit code 130, no traceback and no folder, wherever it comes."""

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

pytestmark = pytest.mark.skipif(os.name != "posix", reason="signals are sent as POSIX has them")

INTERRUPTED = """
import os, signal, sys

class Finder:
    def find_spec(self, name, *_):
        if name == os.environ["INTERRUPTED_AT"]:
            os.kill(os.getpid(), signal.SIGINT)

sys.meta_path.insert(0, Finder())
from rcj_challenges.cli import main
main()
"""


def interrupted(folder: Path, module: str, *arguments: str) -> subprocess.CompletedProcess[str]:
    """Run a command that is interrupted at the moment at which it begins to import a module."""
    return subprocess.run(
        [sys.executable, "-c", INTERRUPTED, *arguments],
        cwd=folder, env={**os.environ, "INTERRUPTED_AT": module}, capture_output=True, text=True, timeout=120,
        check=False,
    )  # fmt: skip


@pytest.mark.parametrize(
    "module",
    [
        "rcj_challenges.cli.stdio",
        "rcj_challenges.cli.run",
    ],
)
def test_while_the_command_line_is_loaded(tmp_path: Path, module: str) -> None:
    done = interrupted(tmp_path, module, "run", "match")
    assert (done.returncode, done.stdout, done.stderr) == (130, "", "interrupted: nothing had begun\n")
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    ("module", "command"),
    [
        ("rcj_challenges.scenario.load", "run"),
        ("rcj_challenges.match.runner", "run"),
        ("rcj_challenges.match.batch", "simulate"),
    ],
)
def test_while_matches_are_prepared(tmp_path: Path, module: str, command: str) -> None:
    done = interrupted(tmp_path, module, command, "match")
    assert (done.returncode, done.stdout) == (130, "")
    assert re.fullmatch(r"interrupted: (no match had|the match had not) begun, and nothing is recorded\n", done.stderr)
    assert not list(tmp_path.iterdir())


def test_other_commands(tmp_path: Path) -> None:
    done = interrupted(tmp_path, "rcj_challenges.scenario.load", "validate", "match")
    assert (done.returncode, done.stdout, done.stderr) == (130, "", "interrupted\n")


def test_an_interruption_is_handled_before_anything_large_is_loaded(tmp_path: Path) -> None:
    """What Python itself does until then cannot be changed."""
    listed = (
        "import sys; before = set(sys.modules); import rcj_challenges.cli; print(*sorted(set(sys.modules) - before))"
    )
    done = subprocess.run([sys.executable, "-c", listed], capture_output=True, text=True, check=True, cwd=tmp_path)
    assert not {"typing", "json", "contextlib", "copy", "codecs", "pathlib"} & set(done.stdout.split()), done.stdout


SWALLOWED = INTERRUPTED.replace(
    "os.kill(os.getpid(), signal.SIGINT)",
    """\
swallowed = False
            try:
                os.kill(os.getpid(), signal.SIGINT)
                os.getpid()
            except KeyboardInterrupt:
                swallowed = True
            if swallowed:
                raise RuntimeError("SchemaError: Error building serializer: KeyboardInterrupt")""",
)


def test_an_interruption_that_a_library_makes_another_error_of_is_no_fault_of_ours(tmp_path: Path) -> None:
    """Pydantic's core does so while it builds a model: of the interruption nothing is left but the text."""
    done = subprocess.run(
        [sys.executable, "-c", SWALLOWED, "validate", "match"],
        cwd=tmp_path, env={**os.environ, "INTERRUPTED_AT": "rcj_challenges.scenario.load"}, capture_output=True,
        text=True, timeout=120, check=False,
    )  # fmt: skip
    assert (done.returncode, done.stdout, done.stderr) == (130, "", "interrupted\n")
    assert not list(tmp_path.iterdir())
