"""A site as it runs: real processes, real archives."""

from __future__ import annotations

import shutil
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.web.conftest import Served, make_folder, make_team, use_site
from tests.web.handing_in import HOSTILE, check_all, small_team, wait_for


@pytest.fixture(scope="module")
def served(tmp_path_factory: pytest.TempPathFactory, migrated: Path) -> Iterator[Served]:
    """A site that checks."""
    config = make_folder(tmp_path_factory.mktemp("served") / "club")
    shutil.copy(migrated, config.folder / "site.sqlite3")
    made = Served(config)
    yield made
    made.stop()


def test_what_is_handed_in_is_checked_by_playing_and_then_plays(served: Served) -> None:
    with use_site(served.config):
        _, code = make_team()
    status, receipt = served.submit(code, small_team())
    assert status == 201
    state = wait_for(served, code, receipt["id"])
    assert (state["state"], state["is_active"]) == ("accepted", True), state
    assert served.submit(code, small_team())[1]["number"] == 2


def test_programs_that_attack_the_match_get_their_verdict(served: Served) -> None:
    by_name = {program.stem: program for program in HOSTILE}
    check_all([by_name["floods_its_output"], by_name["forges_the_lines_of_the_match"]], served)
