"""The check that no file is longer than a reader can hold."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

SCRIPT = Path(__file__).resolve().parents[2] / "scripts" / "check_file_lengths.py"


def check(root: Path) -> tuple[int, str]:
    done = subprocess.run([sys.executable, str(SCRIPT), str(root)], capture_output=True, encoding="utf-8", check=False)
    return done.returncode, done.stdout


def write(path: Path, lines: int) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text("x = 1\n" * lines, encoding="utf-8")


def test_files_may_have_500_lines_and_tests_no_more(tmp_path):
    files = (tmp_path / "package" / "module.py", tmp_path / "viewer.js", tmp_path / "tests" / "test_much.py")
    for file in files:
        write(file, 500)
    assert check(tmp_path)[0] == 0
    for file in files:
        write(file, 501)
    status, output = check(tmp_path)
    assert status == 1
    assert all(f"{file.relative_to(tmp_path).as_posix()}: 501 lines" in output for file in files)


def test_goldens_and_hidden_folders_are_exempt(tmp_path):
    write(tmp_path / "tests" / "goldens" / "page.js", 5000)
    write(tmp_path / ".venv" / "module.py", 5000)
    assert check(tmp_path)[0] == 0
