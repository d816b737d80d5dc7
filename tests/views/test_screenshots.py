"""Pictures of the eight moments of a replay that matter, for people to look at: on a desk and a phone, light and dark.

``pytest -n 0 -m nightly tests/views/test_screenshots.py`` writes them into ``screenshots/`` (or ``$RCJ_SCREENSHOTS``).
"""

import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from tests.views.browser_stage import NARROW, WIDE, settled, until
from tests.views.replay_play import MOMENTS, write_storied_run

TABS = {"crash": "#tab-output", "paused_with_sensors": "#tab-robots", "robot_removed": "#tab-robots"}


@pytest.fixture(scope="module")
def run(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return write_storied_run(tmp_path_factory.mktemp("runs"))


@pytest.mark.nightly
@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("size", [WIDE, NARROW], ids=["desk", "phone"])
def test_screenshots_of_eight_moments(size: dict[str, int], scheme: str, run: Path, watch: Callable[..., Any]) -> None:
    out = Path(os.environ.get("RCJ_SCREENSHOTS", "screenshots"))
    out.mkdir(parents=True, exist_ok=True)
    page = watch(
        (run / "replay.html").as_uri(), viewport=size, color_scheme=scheme, device_scale_factor=1,
        is_mobile=size == NARROW, has_touch=size == NARROW,
    )  # fmt: skip
    for name, (half, tick) in MOMENTS.items():
        page.click(TABS.get(name, "#tab-events"))
        page.evaluate("([half, tick]) => replay.seek(half, tick)", [half, tick])
        until(page, "replay.app.sensors.half(1) && replay.app.output.of(1)")
        settled(page)
        path = out / f"{name}-{size['width']}x{size['height']}-{scheme}.png"
        page.screenshot(path=path)
        assert page.evaluate("document.documentElement.scrollWidth") <= size["width"], name
        assert path.stat().st_size > 20_000, name
