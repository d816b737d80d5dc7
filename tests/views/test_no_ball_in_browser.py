"""The page of a challenge without a ball: it offers no camera that would follow one."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from rcj_challenges.facts.play import Snapshot, Verdict
from rcj_challenges.records.testing import half_info, small_header, small_scenario
from rcj_challenges.records.writer import RecordWriter
from rcj_challenges.views.replay import write_replay
from tests.views.browser_stage import NO_WEBGL, settled

TICKS = 30
CAMERA = "[replay.app.camera.mode, replay.app.camera.pose.distance, ...replay.app.camera.pose.target]"


@pytest.fixture(scope="module")
def run(tmp_path_factory: pytest.TempPathFactory) -> Path:
    scenario = small_scenario(1, 1).model_copy(update={"balls": {}})
    header = small_header(scenario)
    writer = RecordWriter(tmp_path_factory.mktemp("runs"), header)
    writer.begin_half(half_info(scenario, 1, TICKS, header))
    for tick in range(TICKS + 1):
        poses = [(0.3, 0.3, 0.0), (-0.3, 0.01 * tick, 0.0)]
        writer.tick(Snapshot(tick, [poses] * 4, [0.0375] * 2, [1.0] * 2, ((),) * 4), Verdict(), b"")
    writer.end_half(Verdict())
    folder = writer.finish({"wall_s": 1.0})
    write_replay(folder)
    return folder


def test_there_is_no_button_that_follows_a_ball_and_its_key_does_nothing(show: Callable[..., Any], run: Path) -> None:
    page = show(run, anew=True, script=NO_WEBGL)
    settled(page)
    assert not page.is_visible("[data-camera=ball]")
    assert page.is_visible("[data-camera=overview]")
    before = page.evaluate(CAMERA)
    page.keyboard.press("4")
    settled(page)
    assert page.evaluate(CAMERA) == before
    assert page.get_attribute("[data-camera=overview]", "aria-pressed") == "true"
