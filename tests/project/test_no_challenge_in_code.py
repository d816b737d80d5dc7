"""A challenge is a YAML file: no line of the package knows one by its name."""

from __future__ import annotations

import re
from pathlib import Path

import rcj_challenges
from rcj_challenges.scenario.resources import SCENARIOS_FOLDER, names_in

PACKAGE = Path(rcj_challenges.__file__).parent
ORDINARY_WORDS = {"match", "keeper", "market", "search"}
"""Names of scenarios that code may use as what they mean in English."""


def test_the_package_names_no_challenge() -> None:
    shipped = {*names_in(SCENARIOS_FOLDER), *names_in(SCENARIOS_FOLDER / "examples")}
    challenges = sorted(shipped - ORDINARY_WORDS)
    named = re.compile(rf"\b({'|'.join(challenges)})\b")
    sources = [path for ending in ("py", "js", "html", "css", "yaml") for path in PACKAGE.rglob(f"*.{ending}")]
    assert len(challenges) >= 6
    assert len(sources) > 300
    found = [
        f"{path.relative_to(PACKAGE)}: {line.strip()}"
        for path in sources
        if "data" not in path.relative_to(PACKAGE).parts  # what a wheel brings along
        for line in path.read_text(encoding="utf-8").splitlines()
        if named.search(line)
    ]
    assert found == []
