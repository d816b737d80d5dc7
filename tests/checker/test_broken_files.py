"""Files that Python cannot read and programs that are ready for that: only running them can tell whether they play."""

from __future__ import annotations

from pathlib import Path

import pytest

from rcj_challenges.checker.findings import Stage
from rcj_challenges.checker.sources import check_sources
from rcj_challenges.controllers.team import open_team
from rcj_challenges.scenario.load import load

ENTRANTS = tuple(load("match").scenario.entrants.values())


def checked(folder: Path, program: str) -> Stage:
    """Check a program that has a broken file, ``plan.py``, beside it."""
    (folder / "robot.py").write_text(program, encoding="utf-8")
    (folder / "plan.py").write_text("def f(:\n", encoding="utf-8")
    with open_team(folder, *ENTRANTS) as team:
        return check_sources(team)


@pytest.mark.parametrize(
    "program",
    [
        "try:\n    import plan\nexcept SyntaxError:\n    plan = None\n",
        "try:\n    import plan\nexcept (IndentationError, SyntaxError):\n    plan = None\n",
        "try:\n    import plan\nexcept ValueError:\n    pass\nexcept SyntaxError:\n    pass\n",
        "from contextlib import suppress\nwith suppress(SyntaxError):\n    import plan\n",
        "try:\n    import plan\nexcept Exception:\n    plan = None\n",
    ],
)
def test_of_a_broken_file_whose_error_is_caught_only_running_tells(tmp_path: Path, program: str) -> None:
    (found,) = checked(tmp_path, program).findings
    assert (found.code, found.level) == ("sources.syntax", "warning")
    assert "only running the programs can show" in found.message


@pytest.mark.parametrize(
    "program",
    [
        "import plan\n",
        "try:\n    import plan\nexcept KeyError:\n    plan = None\n",
        "try:\n    import plan\nexcept SyntaxError:\n    pass\nimport plan\n",
        "try:\n    pass\nexcept SyntaxError:\n    pass\nimport plan\n",
    ],
)
def test_a_broken_file_whose_error_nothing_catches_fails(tmp_path: Path, program: str) -> None:
    (found,) = checked(tmp_path, program).findings
    assert (found.code, found.level) == ("sources.syntax", "failure")
