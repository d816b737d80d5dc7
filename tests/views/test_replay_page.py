"""The replay page: one small file that carries the match as it was recorded, whatever the names in it."""

import base64
import json
import re
import shutil
import tracemalloc
import zlib
from hashlib import sha256
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from rcj_challenges.core.play import HalfInfo, Placement
from rcj_challenges.records.errors import RecordError
from rcj_challenges.records.trajectory import HalfTrack, Trajectory
from rcj_challenges.records.writer import RecordWriter
from rcj_challenges.views.replay import find_run, list_runs, write_replay
from rcj_challenges.views.replay.packing import Frames, frames_of, length_unit, packed
from tests.made_up_runs import (
    GOAL_EVERY_TICKS,
    begun_run,
    half_info,
    made_up_play,
    small_header,
    small_scenario,
    write_made_up_run,
)

HOSTILE = "</script><script>alert(1)</script><!-- <img src=x onerror=alert(2)> & \u2028"


@pytest.fixture(scope="module")
def run(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return write_made_up_run(tmp_path_factory.mktemp("runs"), ticks=900, halves=2, names=(HOSTILE, "\u202eفريق"))


@pytest.fixture(scope="module")
def page(run: Path) -> str:
    return write_replay(run).read_text("utf-8")


def _part(page: str, opening: str, closing: str = "</script>") -> str:
    return page.split(opening, 1)[1].split(closing, 1)[0]


def _facts(page: str) -> dict:
    return json.loads(_part(page, '<script type="application/json" id="facts">'))


def _unpacked(text: str, columns: int, frames: int) -> np.ndarray:
    """What the page makes of a block: int16 ``[columns, frames]``."""
    planes = np.frombuffer(zlib.decompress(base64.b64decode(text)), np.uint8).reshape(columns, 2, frames)
    steps = planes[:, 0].astype(np.int64) | (planes[:, 1].astype(np.int64) << 8)
    return np.cumsum(np.cumsum(steps, axis=1), axis=1).astype(np.int16)


# --- one file, nothing from outside ------------------------------------------------------------------------------------


def test_the_page_names_no_other_file_and_no_address(page: str) -> None:
    assert not re.findall(
        r"""(?:src|href|action)\s*=\s*["'](?!data:|#)""", re.sub(r"<script.*?</script>", "", page, flags=re.DOTALL)
    )
    assert not re.findall(r"https?://|@import|url\(", page)


def test_only_the_pages_own_script_and_style_may_run(page: str) -> None:
    policy = _part(page, 'http-equiv="Content-Security-Policy" content="', '"')
    script = _part(page, "</script>\n<script>")
    style = _part(page, "<style>", "</style>")
    for text, kind in ((script, "script"), (style, "style")):
        digest = base64.b64encode(sha256(text.encode()).digest()).decode()
        assert f"{kind}-src 'sha256-{digest}'" in policy
    assert policy.startswith("default-src 'none'")
    assert "unsafe" not in policy


def test_names_cannot_leave_the_text_they_stand_in(page: str) -> None:
    assert "<img src=x" not in page
    assert page.count("<script") == 4  # facts, two halves, the viewer
    assert _facts(page)["teams"][0]["title"] == HOSTILE


# --- poses -------------------------------------------------------------------------------------------------------------


def test_poses_in_the_page_equal_the_trajectory_within_a_tenth_of_a_millimetre(run: Path, page: str) -> None:
    facts = _facts(page)
    halves = Trajectory.open(run).halves
    assert len(halves) == 2
    for half in halves:
        names = [channel["name"] for channel in facts["channels"]]
        units = {channel["name"]: channel["unit"] for channel in facts["channels"]}
        block = _part(page, f'id="half-{half.info.half}">')
        numbers = _unpacked(block, len(names) * len(facts["entities"]), half.ticks + 1)
        numbers = numbers.reshape(len(names), len(facts["entities"]), half.ticks + 1)
        shown = {name: numbers[index].T[1:] * units[name] for index, name in enumerate(names)}
        judged = half.substeps[:, -1].astype(float)
        assert np.abs(shown["x"] - judged[:, :, 0]).max() < 1e-4
        assert np.abs(shown["y"] - judged[:, :, 1]).max() < 1e-4
        assert np.abs(shown["z"] - half.heights).max() <= 1.01e-4
        turn = np.remainder(shown["yaw"] - judged[:, :, 2] + np.pi, 2 * np.pi) - np.pi
        assert np.degrees(np.abs(turn)).max() < 0.01


@given(st.lists(st.lists(st.integers(-32768, 32767), min_size=2, max_size=2), min_size=1, max_size=30))
def test_any_motion_is_unpacked_as_it_was_packed(rows: list[list[int]]) -> None:
    numbers = np.array(rows, np.int16)
    text = packed(Frames({"x": numbers}, ((), ())))
    assert (_unpacked(text, 2, len(rows)) == numbers.T).all()


def _track(poses: np.ndarray, placements: dict | None = None) -> HalfTrack:
    ticks, entities, _ = poses.shape
    info = HalfInfo(1, 1, ticks, 1, 0, {}, {}, {})
    return HalfTrack(
        info,
        None,
        np.repeat(poses[:, None].astype(np.float32), 4, axis=1),
        np.zeros((ticks, entities), np.float32),
        np.ones((ticks, entities), np.float32),
        np.zeros((ticks, 4), np.uint16),
        np.zeros((0, 2), np.uint16),
        placements or {},
        {},
    )


@pytest.mark.parametrize("furthest", [0.5, 3.2, 3.3, 6.0, 13.0])
def test_far_away_things_are_shown_within_two_tenths_of_a_millimetre(furthest: float) -> None:
    track = _track(np.array([[[furthest, -furthest, 0.0]], [[0.12345, 0.0, 0.0]]]))
    unit_m = length_unit(track)
    frames = frames_of(track, unit_m)
    assert np.abs(frames.columns["x"][1:, 0] * unit_m - [np.float32(furthest), np.float32(0.12345)]).max() <= 2e-4


def test_who_is_on_the_largest_field_is_never_taken_for_off_it() -> None:
    track = _track(np.array([[[13.0, -13.0, 0.0]]]))
    assert frames_of(track, length_unit(track)).columns["x"][1, 0] < 32_767


def test_what_a_rule_takes_off_at_the_start_is_off_in_the_first_picture() -> None:
    taken_off = {0: (Placement(0, 0.0, 0.0, 0.0, parked=True),)}
    assert frames_of(_track(np.zeros((1, 1, 3)), taken_off), 1e-4).columns["x"][0, 0] == 32_767


def test_what_was_put_elsewhere_does_not_glide_there() -> None:
    poses = np.zeros((5, 2, 3))
    frames = frames_of(_track(poses, {3: (Placement(1, 0.3, 0.3, 0.0),), 0: (Placement(0, 0.1, 0.2, 0.3),)}), 1e-4)
    assert frames.jumps == ((), (3,))
    assert frames.columns["x"][0].tolist() == [1000, 0]  # the first frame shows the layout of the start


def test_numbers_that_are_none_do_not_stop_the_page() -> None:
    frames = frames_of(_track(np.array([[[np.nan, np.inf, -np.inf]]])), 1e-4)
    assert frames.columns["x"][1, 0] == 0


# --- size --------------------------------------------------------------------------------------------------------------


@pytest.mark.nightly
def test_a_half_of_ten_minutes_is_a_small_page_made_with_little_memory(tmp_path: Path) -> None:
    scenario = small_scenario(halves=1)
    header = small_header(scenario)
    noise = np.random.default_rng(1).normal(0, 2e-4, 18_750)
    with RecordWriter(tmp_path, header) as writer:
        writer.begin_half(half_info(scenario, 1, 18_750, header))
        for snapshot, verdict in made_up_play(6, 3_000):
            # Robots that shake on their wheels are harder to pack than the smooth circles of made-up play.
            for entity, (x, y, yaw) in enumerate(snapshot.substeps[-1]):
                jitter = float(noise[(7 * snapshot.tick + entity) % 18_750])
                snapshot.substeps[-1][entity] = (x + jitter, y - jitter, yaw + jitter)
            writer.tick(snapshot, verdict, b"")
        writer.end_half(verdict)
        writer.finish()
    tracemalloc.start()
    page = write_replay(writer.folder)
    _, most = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    viewer = 130_000
    assert (page.stat().st_size - viewer) * 18_750 / 3_000 + viewer < 2_000_000
    assert most * 18_750 / 3_000 < 100_000_000


# --- what happened -----------------------------------------------------------------------------------------------------


def test_an_event_shows_measured_values_and_the_score(page: str) -> None:
    goals = [event for event in _facts(page)["events"] if event["name"] == "GOAL"]
    first = goals[0]
    assert (first["half"], first["tick"], first["kind"]) == (1, 400, "goal")
    assert (first["measured"], first["limit"], first["rule"], first["trigger"]) == (0.76, 0.745, "goal", "enters")
    assert first["says"] == "The ball is in the goal."
    assert [event["standing"] for event in goals] == ["0 : 1", "0 : 2", "1 : 2", "2 : 2"]


def test_the_end_of_a_half_is_not_the_end_of_the_match(page: str) -> None:
    titles = [event["title"] for event in _facts(page)["events"] if event["name"] == "MATCH_FINISH"]
    assert titles == ["END OF HALF 1", "MATCH FINISH"]


def test_phases_and_score_are_listed_by_half(page: str) -> None:
    first, second = _facts(page)["halves"]
    assert first["phases"][:3] == [[0, "play", False], [400, "goal_pause", True], [494, "play", False]]
    assert first["held"] == [[200, ["B1"]], [260, []]]
    assert first["sides"] == {"blue": "blue", "yellow": "yellow"}
    assert second["sides"] == {"blue": "yellow", "yellow": "blue"}
    assert first["score_changes"][0] == [400, {"blue": 0, "yellow": 1}]
    assert second["scores"] == {"blue": 0, "yellow": 2}


def test_zones_spots_and_what_stands_on_the_field_are_in_the_page(page: str) -> None:
    facts = _facts(page)
    assert [zone["name"] for zone in facts["zones"]] == ["blue_goal", "penalty_area", "middle"]
    assert [(spot["name"], spot["x_m"], spot["y_m"]) for spot in facts["spots"]] == [("centre", 0.0, 0.0)]
    assert facts["gates"][0]["name"] == "half_way"
    assert facts["fixed"][0]["shape"] == "cylinder"
    assert facts["held_phases"] == ["goal_pause"]
    assert [entity["name"] for entity in facts["entities"]] == ["B1", "B2", "B3", "Y1", "Y2", "Y3", "ball"]


# --- bad input ---------------------------------------------------------------------------------------------------------


def test_a_killed_run_shows_its_recorded_part_and_a_notice(tmp_path: Path) -> None:
    writer = begun_run(tmp_path, 100)
    facts = _facts(write_replay(writer.folder).read_text("utf-8"))
    assert facts["halves"][0]["ticks"] == 100
    assert facts["halves"][0]["planned_ticks"] == 1000
    assert "not played to its end" in facts["problem"]
    assert facts["complete"] is False
    writer.finish({"complete": False})


def test_a_run_that_was_killed_before_its_first_tick_has_no_page(tmp_path: Path) -> None:
    writer = RecordWriter(tmp_path, small_header(small_scenario()))
    with pytest.raises(RecordError, match="nothing to show"):
        write_replay(writer.folder)
    writer.finish({"complete": False})


def test_without_the_referees_log_the_events_of_the_result_are_shown(run: Path, tmp_path: Path) -> None:
    folder = tmp_path / "run"
    shutil.copytree(run, folder)
    (folder / "referee.jsonl").unlink()
    facts = _facts(write_replay(folder).read_text("utf-8"))
    assert [event["tick"] for event in facts["events"] if event["name"] == "GOAL"] == [400, 800, 400, 800]


# --- finding records ---------------------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def runs(tmp_path_factory: pytest.TempPathFactory) -> Path:
    out = tmp_path_factory.mktemp("runs")
    for name in ("20210618-100000-match", "20210618-110000-match", "20210619-100000-match"):
        write_made_up_run(out, ticks=30, halves=1).rename(out / name)
    (out / "20210620-100000-match").mkdir()
    (out / "20210620-100000-match" / "result.json").write_text("{}", "utf-8")
    (out / "notes").mkdir()
    return out


def test_records_are_listed_newest_first_with_what_is_wrong(runs: Path) -> None:
    rows = list_runs(runs)
    assert [row.folder.name[:11] for row in rows] == ["20210620-10", "20210619-10", "20210618-11", "20210618-10"]
    assert "damaged" in rows[0].problem
    assert rows[0].result is None
    assert rows[1].result is not None


def test_a_run_that_was_killed_is_listed_with_the_points_of_its_log(tmp_path: Path) -> None:
    writer = begun_run(tmp_path, GOAL_EVERY_TICKS + 50)  # its result tells of whole halves only
    killed = Path(shutil.copytree(writer.folder, tmp_path / "killed" / writer.folder.name))
    writer.finish({"complete": False})
    assert [row.score for row in list_runs(killed.parent)] == [{"blue": 0, "yellow": 1}]
    (killed / "scenario.json").write_text("{}", "utf-8")
    assert [row.score for row in list_runs(killed.parent)] == [{"blue": 0, "yellow": 0}]


def test_a_record_is_found_by_folder_file_name_or_the_beginning_of_its_name(runs: Path) -> None:
    wanted = runs / "20210619-100000-match"
    for given_ in (wanted, wanted / "result.json", Path(wanted.name), Path("20210619")):
        assert find_run(given_, runs) == wanted
    assert find_run(None, runs).name == "20210620-100000-match"


def test_a_record_has_its_name_when_it_is_the_current_folder(runs: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    wanted = runs / "20210619-100000-match"
    monkeypatch.chdir(wanted)
    for given_ in (Path(), Path("result.json")):
        assert find_run(given_, runs).name == wanted.name
    other = "20210620-100000-match"  # and is not taken for another one
    assert find_run(Path(other), runs).name == other
    with pytest.raises(RecordError, match="no record '1999'"):
        find_run(Path("1999"), runs)
    (wanted / "logs").mkdir(exist_ok=True)
    monkeypatch.chdir(wanted / "logs")
    assert find_run(Path(".."), runs).name == wanted.name


@pytest.mark.parametrize(
    ("name", "says"),
    [
        ("20210618", "fits several"),
        ("1999", "no record '1999'"),
        (r"old\runs", r"no record 'old\\runs'"),  # each backslash of Windows once
        ("x" * 5000, "no record 'xxx.*…xxx.*'"),
    ],
    ids=["several", "none", "backslash", "long"],
)
def test_a_missing_record_is_reported(name: str, says: str, runs: Path) -> None:
    with pytest.raises(RecordError, match=says):
        find_run(Path(name), runs)
