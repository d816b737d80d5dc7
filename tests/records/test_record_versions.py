"""Records of every version that was ever written are read; newer ones and ones that never were are refused."""

import json
import shutil
from pathlib import Path

import numpy as np
import pytest

from rcj_challenges.records import folder as names
from rcj_challenges.records.errors import RecordError
from rcj_challenges.records.folder import RECORD_VERSION
from rcj_challenges.records.recorded_scenario import read_scenario
from rcj_challenges.records.result import read_result
from rcj_challenges.records.salvage import read_run
from rcj_challenges.records.sensors import read_sensors
from rcj_challenges.records.trajectory import Trajectory
from rcj_challenges.views.replay import write_replay
from rcj_challenges.views.stats import run_stats

KEPT = Path(__file__).parent
OLD = KEPT / "version-1"
"""A match of two halves of 3 s as version 1 wrote it. Never to be made anew: it stands for all records out there."""


@pytest.fixture
def old(tmp_path: Path) -> Path:
    return Path(shutil.copytree(OLD, tmp_path / "20261121-143130-match"))


def test_a_record_of_each_version_is_kept() -> None:
    assert sorted(path.name for path in KEPT.glob("version-*")) == [
        f"version-{version}" for version in range(1, RECORD_VERSION + 1)
    ]


def test_a_record_of_version_1_is_read_whole(old: Path) -> None:
    run = read_run(old)
    assert run.problems == ()
    assert [half.ticks for half in run.halves] == [94, 94]
    assert run.result.entrants["blue"].name == "Roles and Radio"
    assert run.scenario.id == "match"
    first = run.halves[0]
    assert first.info.team_names == {"blue": "Roles and Radio", "yellow": "All Sensors"}
    assert first.substeps.shape == (94, 4, 7, 3)
    assert first.substeps[-1, -1, 0].tolist() == pytest.approx([-0.06024, 0.559821, -0.432028], abs=1e-6)
    assert {event.event for event in run.result.events} == {"KICKOFF", "MATCH_START", "MATCH_FINISH"}
    assert read_sensors(old)[2].robots["Y1"].values.shape == (94, 12)


def test_a_colour_that_was_once_taken_is_read(old: Path) -> None:
    path = old / names.SCENARIO
    scenario = json.loads(path.read_text("utf-8"))
    scenario["field"]["goals"]["blue_goal"]["colour"] = "transparent"
    path.write_text(json.dumps(scenario), encoding="utf-8")
    assert read_scenario(old).field.goals["blue_goal"].colour == "transparent"


def test_a_record_of_version_1_has_a_page_and_figures(old: Path) -> None:
    page = write_replay(old).read_text("utf-8")
    facts = json.loads(page.split('<script type="application/json" id="facts">')[1].split("</script>")[0])
    assert facts["problem"] == ""
    assert facts["teams"][0]["logo"].startswith("data:image/png;base64,")
    stats = run_stats(old)
    assert set(stats.teams) == {"Roles and Radio", "All Sensors"}
    assert stats.teams["All Sensors"].total.distance_m > 1
    assert stats.notes == []


def with_version(folder: Path, version: int) -> None:
    """Make a record say that it is of another version."""
    result = json.loads((folder / "result.json").read_text("utf-8"))
    (folder / "result.json").write_text(json.dumps(result | {"record": version}), "utf-8")
    with np.load(folder / "trajectory.npz") as arrays:
        found = {name: arrays[name] for name in arrays.files}
    header = json.loads(found["header"].tobytes()) | {"record": version}
    found["header"] = np.frombuffer(json.dumps(header).encode(), np.uint8)
    np.savez(folder / "trajectory.npz", **found)


def test_a_newer_record_is_refused_naming_what_is_needed(old: Path) -> None:
    with_version(old, RECORD_VERSION + 1)
    for read in (read_result, Trajectory.open, read_run, run_stats, write_replay):
        with pytest.raises(RecordError, match="needs a newer rcj-challenges"):
            read(old)


def test_a_version_that_never_was_is_refused(old: Path) -> None:
    with_version(old, 0)
    with pytest.raises(RecordError, match="version 0, which no rcj-challenges has written"):
        read_result(old)
