"""Who looks at a record whose scenario somebody has changed by hand is told what is wrong with it."""

import json
import shutil
from pathlib import Path

import pytest

from rcj_challenges.records.errors import RecordError
from rcj_challenges.records.testing import write_made_up_run
from rcj_challenges.views.replay import write_replay
from rcj_challenges.views.stats.run import run_stats
from rcj_challenges.views.video.footage import Footage


@pytest.fixture(scope="module")
def good(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return write_made_up_run(tmp_path_factory.mktemp("runs"), ticks=10, halves=1)


def changed(good: Path, folder: Path, **robot: object) -> tuple[Path, str]:
    shutil.copytree(good, folder)
    scenario = json.loads((folder / "scenario.json").read_text("utf-8"))
    name = next(iter(scenario["robots"]))
    scenario["robots"][name] |= robot
    (folder / "scenario.json").write_text(json.dumps(scenario), "utf-8")
    return folder, name


@pytest.mark.parametrize("look", [write_replay, Footage.open])
def test_a_kit_that_the_scenario_has_not_is_named(good: Path, tmp_path: Path, look) -> None:
    record, name = changed(good, tmp_path / "record", kit="v3")
    with pytest.raises(RecordError, match=rf"scenario\.json is not as the run wrote it: robots\.{name}\.kit: unknown"):
        look(record)
    assert not (record / "replay.html").exists()


def test_what_needs_no_kit_counts_all_the_same(good: Path, tmp_path: Path) -> None:
    record, _ = changed(good, tmp_path / "record", kit="v3")
    assert run_stats(record).ticks == 10


def test_what_fails_in_a_record_that_nobody_changed_stays_our_fault(
    good: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def broken(*_: object) -> None:
        raise KeyError("ours")

    record, _ = changed(good, tmp_path / "record")
    monkeypatch.setattr("rcj_challenges.views.replay.page.visible_things", broken)
    with pytest.raises(KeyError, match="ours"):
        write_replay(record)
