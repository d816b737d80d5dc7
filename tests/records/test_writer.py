"""A run's folder: made for one run alone, readable at any moment, complete at the end, without anything private."""

import errno
import json
import os
import signal
import subprocess
import sys
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from datetime import UTC, datetime
from pathlib import Path
from pkgutil import resolve_name

import jsonschema
import pytest

from rcj_challenges.core.changes import ScoreChange
from rcj_challenges.core.play import RefereeOutput
from rcj_challenges.records.errors import RecordError
from rcj_challenges.records.folder import TRAJECTORY, make_run_folder
from rcj_challenges.records.result import read_result
from rcj_challenges.records.trajectory import Trajectory
from rcj_challenges.records.writer import RecordWriter
from rcj_challenges.scenario.models.scenario import Scenario
from scripts.write_schemas import result_text
from tests.made_up_runs import (
    half_info,
    made_up_snapshot,
    small_header,
    small_scenario,
    write_made_up_run,
)

_NOON = datetime(2021, 6, 18, 12, 0, 0, tzinfo=UTC)


@pytest.fixture(scope="module")
def run(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return write_made_up_run(tmp_path_factory.mktemp("runs"), ticks=900, halves=2)


def test_runs_of_the_same_second_never_share_a_folder(tmp_path: Path) -> None:
    with ThreadPoolExecutor(8) as pool:
        folders = list(pool.map(lambda _: make_run_folder(tmp_path / "runs", "20210618-120000-match"), range(40)))
    assert len(set(folders)) == 40
    assert {"20210618-120000-match", "20210618-120000-match-2"} <= {folder.name for folder in folders}


def test_a_folder_that_cannot_be_created_is_reported(tmp_path: Path) -> None:
    (tmp_path / "runs").write_text("a file", encoding="utf-8")
    with pytest.raises(RecordError) as refused:
        RecordWriter(tmp_path / "runs", small_header(small_scenario()))
    assert refused.value.diagnostics[0].code == "cannot-write-record"


def test_a_kill_while_the_folder_is_made_leaves_a_result_in_it(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    makes = Path.mkdir

    def killed(folder: Path, *arguments: object, **named: object) -> None:
        if folder.parent.parent == tmp_path:
            raise KeyboardInterrupt
        makes(folder, *arguments, **named)

    monkeypatch.setattr(Path, "mkdir", killed)
    with pytest.raises(KeyboardInterrupt):
        RecordWriter(tmp_path, small_header(small_scenario()))
    (folder,) = tmp_path.iterdir()
    assert not read_result(folder).complete


def test_where_there_is_no_room_for_a_result_no_folder_is_left(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def full(path: Path, _: bytes) -> None:
        path.touch()
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr(Path, "write_bytes", full)
    with pytest.raises(OSError, match="No space left") as raised:
        RecordWriter(tmp_path, small_header(small_scenario()))
    assert str(raised.value.filename).endswith("result.json")
    assert list(tmp_path.iterdir()) == []


def test_from_the_first_moment_there_is_a_result_that_is_not_complete(tmp_path: Path) -> None:
    writer = RecordWriter(tmp_path, small_header(small_scenario()))
    result = read_result(writer.folder)
    assert not result.complete
    assert result.score == {"blue": 0, "yellow": 0}
    assert len(result.inputs) == 64
    assert (result.states, result.digest) == ("", "")
    assert Trajectory.open(writer.folder).halves == ()
    writer.finish({"complete": False})


def test_result_of_a_finished_run_has_teams_sides_events_and_versions(run: Path) -> None:
    result = read_result(run)
    assert result.complete
    assert {team: entrant.name for team, entrant in result.entrants.items()} == {"blue": "Hanse", "yellow": "Alster"}
    assert [half.sides for half in result.halves] == [
        {"blue": "blue", "yellow": "yellow"},
        {"blue": "yellow", "yellow": "blue"},
    ]
    assert result.simulated_s == 57.6
    assert result.real_time_factor == 57.6
    assert result.versions.mujoco != "unknown"
    assert {event.event for event in result.events} == {
        "KICKOFF", "MATCH_START", "GOAL", "PROGRAM_FAULT", "MATCH_FINISH",
    }  # fmt: skip


def test_points_follow_the_team_when_sides_are_changed(run: Path) -> None:
    # Twice a half the seat `yellow` scores: Alster sits there in the first half, Hanse in the second.
    result = read_result(run)
    assert [half.score for half in result.halves] == [{"blue": 0, "yellow": 2}, {"blue": 2, "yellow": 2}]
    assert result.score == {"blue": 2, "yellow": 2}


def test_a_fault_names_robot_team_kind_and_tick(run: Path) -> None:
    fault = read_result(run).faults[0]
    assert (fault.robot, fault.team, fault.kind, fault.tick, fault.half) == ("Y1", "yellow", "crash", 300, 1)
    assert fault.detail == "ZeroDivisionError: division by zero"


def test_the_score_is_that_of_the_changes_also_after_the_last_tick(tmp_path: Path) -> None:
    scenario = small_scenario(1, 2)
    header = small_header(scenario)
    with RecordWriter(tmp_path, header) as writer:
        writer.begin_half(half_info(scenario, 2, 2, header))
        writer.tick(made_up_snapshot(0, 2), RefereeOutput(changes=(ScoreChange(0, {"blue": 1, "yellow": 0}),)), b"")
        writer.end_half(RefereeOutput(changes=(ScoreChange(0, {"blue": 5, "yellow": 3}),)), ended="mercy")
        writer.finish()
    half = read_result(writer.folder).halves[0]
    assert half.score == {"blue": 3, "yellow": 5}
    assert half.ended == "mercy"


def test_a_run_stopped_by_an_error_is_closed_and_marked(tmp_path: Path) -> None:
    scenario = small_scenario(1, 1)
    header = small_header(scenario)
    with pytest.raises(KeyboardInterrupt), RecordWriter(tmp_path, header) as writer:  # noqa: PT012
        writer.begin_half(half_info(scenario, 1, 50, header))
        for tick in range(10):
            writer.tick(made_up_snapshot(tick, 2), RefereeOutput(), b"")
        raise KeyboardInterrupt
    result = read_result(writer.folder)
    assert (result.complete, result.stopped) == (False, "KeyboardInterrupt")
    assert (len(result.inputs), result.states, result.digest) == (64, "", "")
    assert Trajectory.open(writer.folder).halves[0].ticks == 9
    (half,) = result.halves
    assert (half.half, half.ticks, half.ended, half.complete) == (1, 9, None, False)
    assert result.simulated_s == 0.288


@pytest.mark.skipif(sys.platform == "win32", reason="the limit for the size of files is POSIX's")
@pytest.mark.parametrize("cut", [1, 500, 3_001])
def test_a_disk_that_is_full_for_a_moment_puts_nothing_twice_into_the_record(tmp_path: Path, cut: int) -> None:
    scenario = small_scenario(3, 1)
    header = small_header(scenario)
    writer = RecordWriter(tmp_path, header)
    writer.begin_half(half_info(scenario, 1, 50, header))
    for tick in range(50):
        writer.tick(made_up_snapshot(tick, 6), RefereeOutput(), b"")
    with _no_file_beyond((writer.folder / TRAJECTORY).stat().st_size + cut), pytest.raises(OSError, match="too large"):
        writer.tick(made_up_snapshot(50, 6), RefereeOutput(), b"")
    writer.break_off(OSError)  # the programs have left, and so there is room again
    (half,) = Trajectory.open(writer.folder).halves
    assert [one.substeps for one in half.snapshots()] == [made_up_snapshot(tick, 6).substeps for tick in range(1, 51)]


@contextmanager
def _no_file_beyond(size_bytes: int) -> Iterator[None]:
    """Let files grow to a size only: a write beyond it is cut there, and the next one is refused, as on a full disk."""
    import resource

    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (size_bytes, before[1]))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)


_PLACES = {
    "while the trajectory ends": "rcj_challenges.records.trajectory.TrajectoryWriter.close",
    "while its file is closed": "rcj_challenges.records.chunks.ChunkWriter.close",
}


@pytest.mark.parametrize("place", _PLACES.values(), ids=_PLACES)
@pytest.mark.parametrize("after", [False, True], ids=["before it", "after it"])
def test_an_interruption_of_the_end_counts_no_half_twice_and_loses_none(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, place: str, *, after: bool
) -> None:
    scenario = small_scenario(1, 1)
    header = small_header(scenario)
    owner, _, name = place.rpartition(".")
    original, hit = resolve_name(place), []

    def interrupted(*arguments: object, **named: object) -> object:
        result = original(*arguments, **named) if after or hit else None
        if not hit:
            hit.append(True)
            raise KeyboardInterrupt
        return result

    writer = RecordWriter(tmp_path, header)
    writer.begin_half(half_info(scenario, 1, 9, header))
    for tick in range(10):
        writer.tick(made_up_snapshot(tick, 2), RefereeOutput(), b"")
    monkeypatch.setattr(resolve_name(owner), name, interrupted)
    with pytest.raises(KeyboardInterrupt):  # noqa: PT012 - wherever it comes
        writer.end_half(RefereeOutput())
        writer.finish()
    writer.break_off(KeyboardInterrupt)
    result = read_result(writer.folder)
    assert (result.complete, result.stopped) == (False, "KeyboardInterrupt")
    assert [(half.half, half.ticks) for half in result.halves] == [(1, 9)]
    assert result.simulated_s == 0.288
    assert Trajectory.open(writer.folder).halves[0].ticks == 9
    assert Trajectory.open(writer.folder).finished


def test_the_scenario_of_the_record_reads_back_equal(run: Path) -> None:
    assert Scenario.model_validate_json((run / "scenario.json").read_bytes()) == small_scenario(half_s=28.8)


def test_nothing_but_the_records_files_is_left(run: Path) -> None:
    assert sorted(path.name for path in run.iterdir()) == [
        "logs", "referee.jsonl", "reflog.jsonl", "result.json", "scenario.json", "trajectory.chunks",
    ]  # fmt: skip


def test_no_path_user_or_host_stands_in_any_record(run: Path) -> None:
    private = [
        str(run.parent),
        str(Path.home()),
        os.uname().nodename if hasattr(os, "uname") else os.environ["COMPUTERNAME"],
    ]
    for path in run.rglob("*"):
        if path.is_file():
            data = path.read_bytes()
            assert not [word for word in private if len(word) > 3 and word.encode() in data], path.name


def test_the_result_fits_its_published_schema(run: Path) -> None:
    schema = json.loads(result_text())
    jsonschema.Draft202012Validator.check_schema(schema)
    jsonschema.validate(json.loads((run / "result.json").read_text("utf-8")), schema)


def test_the_committed_schema_is_fresh() -> None:
    committed = Path(__file__).parents[2] / "schemas" / "result.schema.json"
    assert committed.read_text("utf-8") == result_text()


@pytest.mark.parametrize(
    ("data", "code"),
    [
        (b"", "record-unreadable"),
        (b"\xff\xfe", "record-unreadable"),
        (b"[]", "record-damaged"),
        (b'{"record": 2}', "record-damaged"),
        (b'{"record": 7}', "record-too-new"),
    ],
)
def test_a_damaged_result_is_refused(data: bytes, code: str, tmp_path: Path) -> None:
    (tmp_path / "result.json").write_bytes(data)
    with pytest.raises(RecordError) as refused:
        read_result(tmp_path)
    assert refused.value.diagnostics[0].code == code


# --- killed -------------------------------------------------------------------------------------------------------------

_ENDLESS = """
import sys
from pathlib import Path
from tests.made_up_runs import half_info, made_up_play, small_header, small_scenario
from rcj_challenges.records.writer import RecordWriter

scenario = small_scenario()
header = small_header(scenario)
writer = RecordWriter(Path(sys.argv[1]), header)
writer.begin_half(half_info(scenario, 1, 10**9, header))
for snapshot, output in made_up_play(6, 10**9):
    writer.tick(snapshot, output, b"12345678")
    if snapshot.tick == int(sys.argv[2]):
        print(snapshot.tick, flush=True)
"""


@pytest.fixture
def endless(tmp_path: Path, at_tick: int) -> Iterator[subprocess.Popen[str]]:
    process = subprocess.Popen(
        [sys.executable, "-c", _ENDLESS, str(tmp_path), str(at_tick)],
        stdout=subprocess.PIPE,
        text=True,
        encoding="utf-8",
    )
    with process:
        yield process
        process.kill()


@pytest.mark.skipif(not hasattr(signal, "SIGKILL"), reason="SIGKILL is a thing of POSIX")
@pytest.mark.parametrize("at_tick", [0, 1013])
def test_a_kill_at_any_moment_leaves_readable_files(
    at_tick: int, endless: subprocess.Popen[str], tmp_path: Path
) -> None:
    assert endless.stdout is not None
    reached = int(endless.stdout.readline())
    endless.send_signal(signal.SIGKILL)
    endless.wait()
    (folder,) = tmp_path.iterdir()
    half = Trajectory.open(folder).halves[0]
    assert half.ticks >= reached - 25
    assert [snapshot.tick for snapshot in half.snapshots()] == list(range(1, half.ticks + 1))
    assert not read_result(folder).complete
    lines = [json.loads(line) for line in (folder / "reflog.jsonl").read_text("utf-8").splitlines()]
    assert len([line for line in lines if line["event"] == "GOAL"]) >= reached // 400


def test_the_writer_holds_only_what_is_rare_in_memory(tmp_path: Path) -> None:
    import tracemalloc

    scenario = small_scenario(3, 1)
    header = small_header(scenario)
    snapshots = [made_up_snapshot(tick, 6) for tick in range(1, 101)]
    output = RefereeOutput()
    with RecordWriter(tmp_path, header) as writer:
        writer.begin_half(half_info(scenario, 1, 100, header))
        tracemalloc.start()
        for snapshot in snapshots:
            writer.tick(snapshot, output, bytes(920))
        held, _ = tracemalloc.get_traced_memory()
        tracemalloc.stop()
        writer.finish()
    assert held < 150_000  # 100 ticks are 40 kB of poses and 90 kB of state; a second of them may wait
