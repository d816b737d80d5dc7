"""The page of a match in which a robot is taken off the field for a time: everybody else stays exactly where they were."""

from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from rcj_challenges.facts.play import Placement, Snapshot, Verdict
from rcj_challenges.match.observers import ObserverGroup
from rcj_challenges.records.testing import half_info, made_up_play, small_header, small_scenario
from rcj_challenges.records.trajectory import Trajectory
from rcj_challenges.records.writer import RecordWriter
from rcj_challenges.views.live import MAX_SPEED, LiveShow
from rcj_challenges.views.replay import write_replay
from tests.views.browser_stage import NO_WEBGL, settled, until

TICKS, TAKEN_OFF, PUT_BACK = 500, 120, 380
PARKED = (1000.0, 0.0, 0.0)
DRAWN_AT = "replay.app.frame.poses[0]"


def _play(robots: int) -> Iterator[tuple[Snapshot, Verdict]]:
    """Yield a match in which the first robot is taken off and comes back."""
    for snapshot, verdict in made_up_play(robots, TICKS):
        parked = TAKEN_OFF < snapshot.tick <= PUT_BACK
        here = [[PARKED, *substep[1:]] for substep in snapshot.substeps] if parked else snapshot.substeps
        moved = {
            TAKEN_OFF: (Placement(0, 0.0, 0.0, 0.0, parked=True),),
            PUT_BACK: (Placement(0, 0.3, 0.3, 0.0),),
        }.get(snapshot.tick, ())
        yield snapshot._replace(substeps=here), replace(verdict, placements=(*verdict.placements, *moved))


@pytest.fixture(scope="module")
def run(tmp_path_factory: pytest.TempPathFactory) -> Path:
    scenario = small_scenario(halves=1, half_s=TICKS * 0.032)
    header = small_header(scenario)
    writer = RecordWriter(tmp_path_factory.mktemp("runs"), header)
    writer.begin_half(half_info(scenario, 1, TICKS, header))
    for snapshot, verdict in _play(len(scenario.robots)):
        writer.tick(snapshot, verdict, b"")
    writer.end_half(Verdict())
    folder = writer.finish({"wall_s": 1.0})
    write_replay(folder)
    return folder


def test_all_others_are_shown_where_they_were_judged(show: Callable[..., Any], run: Path) -> None:
    page = show(run)
    (half,) = Trajectory.open(run).halves
    shown = page.evaluate(
        f"""Array.from({{ length: {TICKS} }}, (_, row) => replay.recording.entities.map((_, index) => {{
          const pose = replay.recording.halves[0].pose(index, row + 1);
          return [pose.x, pose.y];
        }}))"""
    )
    off = np.array(shown)[:, 1:] - half.substeps[:, -1, 1:, :2]
    assert np.abs(off).max() < 1e-4


def test_its_card_says_that_it_is_off_the_field_and_no_place(show: Callable[..., Any], run: Path) -> None:
    page = show(run)
    page.click("#tab-robots")
    card = page.locator(".robot .numbers").first
    for tick, told in ((TAKEN_OFF, "x "), (TAKEN_OFF + 1, "off the field"), (PUT_BACK, "off"), (PUT_BACK + 1, "x ")):
        page.evaluate(f"replay.seek(1, {tick})")
        settled(page)
        assert card.inner_text().startswith(told), tick


def test_the_camera_behind_it_stays_with_the_field(show: Callable[..., Any], run: Path) -> None:
    page = show(run, f"#h1t{TAKEN_OFF - 10}", anew=True, script=NO_WEBGL)
    page.select_option("#behind", "0")
    settled(page)
    before = page.evaluate("replay.app.camera.pose.target")
    page.evaluate(f"replay.seek(1, {TAKEN_OFF + 50})")
    settled(page)
    assert page.evaluate("replay.app.camera.pose.target") == pytest.approx(before, abs=0.1)


def test_its_trail_and_its_heat_map_leave_out_the_time_off_the_field(show: Callable[..., Any], run: Path) -> None:
    page = show(run, f"#h1t{PUT_BACK - 10}", anew=True, script=NO_WEBGL)
    furthest = """Math.max(...replay.recording.trail(0, replay.place, 60).flat(2).map(Math.abs))"""
    assert page.evaluate(furthest) < 1
    page.click("#tab-show")
    page.select_option("#heat", "0")
    settled(page)
    told = page.inner_text("#heat-text")
    assert float(told.partition("5 cm: ")[2].partition(" %")[0]) < 25, told  # it was off for half of the time


def test_live_it_stands_nowhere_in_the_picture_either(tmp_path: Path, watch: Callable[..., Any]) -> None:
    scenario = small_scenario(halves=1, half_s=TICKS * 0.032)
    header = small_header(scenario)
    live = LiveShow(scenario, dict(header.team_names), 1, speed=MAX_SPEED)
    try:
        observer, half = ObserverGroup(live.observer), half_info(scenario, 1, TICKS, header)
        observer.half_started(half)
        for snapshot, verdict in _play(len(scenario.robots)):
            observer.ticked(snapshot, verdict)
        observer.closing(Verdict(), half)
        page = watch(live.address, script=NO_WEBGL)
        until(page, f"replay.recording.last >= {TICKS}")
        page.evaluate(f"replay.seek(1, {TAKEN_OFF + 50})")
        settled(page)
        assert page.evaluate(f"{DRAWN_AT}.off && {DRAWN_AT}.x") == 1000
    finally:
        live.close()
