"""The page of a match whose clock a phase stops: it tells how long, or 0:03 of 0:02 would look like a fault."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from rcj_challenges.facts.play import Snapshot, Verdict
from rcj_challenges.records.testing import half_info, small_header, small_scenario
from rcj_challenges.records.writer import RecordWriter
from rcj_challenges.scenario.models.state import Phase
from rcj_challenges.views.replay import write_replay
from tests.views.browser_stage import NARROW, NO_WEBGL, settled

PLAYED, STOPPED_AT, STOPPED = 125, 50, 75  # ticks: 4 s of play, of which 2.4 s are no time of the half


@pytest.fixture(scope="module")
def run(tmp_path_factory: pytest.TempPathFactory) -> Path:
    scenario = small_scenario(1, 1, half_s=PLAYED * 0.032)
    pause = Phase.model_validate({"lasts_s": STOPPED * 0.032, "clock": "stops", "robots": "held"})
    scenario = scenario.model_copy(update={"phases": {**scenario.phases, "time_out": pause}})
    header = small_header(scenario)
    writer = RecordWriter(tmp_path_factory.mktemp("runs"), header)
    writer.begin_half(half_info(scenario, 1, PLAYED, header))
    phases = {STOPPED_AT: Verdict(phase="time_out"), STOPPED_AT + STOPPED: Verdict(phase="play")}
    verdict = Verdict()
    for tick in range(PLAYED + STOPPED + 1):
        poses = [(0.3, 0.3, 0.0), (-0.3, 0.001 * tick, 0.0), (0.0, 0.0, 0.0)]
        verdict = phases.get(tick, Verdict(phase=verdict.phase))
        writer.tick(Snapshot(tick, [poses] * 4, [0.0375, 0.0375, 0.021], [1.0] * 3, ((),) * 4), verdict, b"")
    writer.end_half(Verdict())
    folder = writer.finish({"wall_s": 1.0})
    write_replay(folder)
    return folder


@pytest.mark.parametrize(
    ("tick", "length", "phase"),
    [
        (STOPPED_AT - 1, "of 0:04", ""),
        (STOPPED_AT + 32, "of 0:04 + 0:01 stopped", "time out · robots held · clock stopped"),
        (PLAYED + STOPPED, "of 0:04 + 0:02 stopped", ""),
    ],
)
def test_the_time_for_which_the_clock_stood_is_told_beside_it(
    tick: int, length: str, phase: str, show: Callable[..., Any], run: Path
) -> None:
    page = show(run, f"#h1t{tick}", anew=True, script=NO_WEBGL)
    settled(page)
    assert page.inner_text("#half") == length
    assert (page.inner_text("#phase") if page.is_visible("#phase") else "") == phase


@pytest.mark.parametrize(("width", "height"), [(360, 740), (740, 360), (900, 700)])
def test_on_a_phone_it_is_told_in_whole_and_nothing_is_pushed_over_the_scores(
    width: int, height: int, show: Callable[..., Any], run: Path
) -> None:
    page = show(run, f"#h1t{PLAYED + STOPPED}", script=NO_WEBGL, viewport={"width": width, "height": height})
    settled(page)
    half, stopped, teams = map(page.locator, ("#half", "#half .stopped", ".teams"))
    assert half.inner_text().split() == ["of", "0:04", "+", "0:02", "stopped"]
    half.evaluate("half => { half.firstChild.textContent = 'half 1 of 2 · 10:00 '; }")
    stopped.evaluate("told => { told.textContent = '+ 10:00 stopped'; }")
    for name in page.locator(".team .name").all():
        name.evaluate("name => { name.textContent = 'The long name of a team and more'; }")
    assert half.evaluate("half => half.scrollWidth <= half.clientWidth")
    room_px = teams.evaluate("teams => teams.clientWidth")
    stopped.evaluate("told => told.remove()")
    assert teams.evaluate("teams => teams.clientWidth") == room_px
    for score in page.locator(".team .score").all():
        score.evaluate("score => { score.textContent = '-12.5'; }")
        assert score.evaluate("score => score.scrollWidth <= score.clientWidth")


def test_the_long_name_of_a_phase_is_cut_before_the_teams_names_are(show: Callable[..., Any], run: Path) -> None:
    viewport = {"width": 740, "height": 360}
    page = show(run, f"#h1t{STOPPED_AT + 32}", anew=True, script=NO_WEBGL, viewport=viewport)
    settled(page)
    names = page.locator(".team .name")
    for name in names.all():
        name.evaluate("name => { name.textContent = 'The long name of a team and more'; }")
    page.locator("#phase").evaluate(
        "phase => { phase.textContent = 'a very long time out · robots held · clock stopped'; }"
    )
    assert min(name.evaluate("name => name.clientWidth") for name in names.all()) > 80


def test_what_a_phase_does_is_told_whole_on_a_phone_too(show: Callable[..., Any], run: Path) -> None:
    page = show(run, f"#h1t{STOPPED_AT + 32}", anew=True, script=NO_WEBGL, viewport=NARROW)
    settled(page)
    shown, needed = page.evaluate(
        "() => { const { clientWidth, scrollWidth } = document.getElementById('phase'); return [clientWidth, scrollWidth]; }"
    )
    assert page.inner_text("#phase") == "time out · robots held · clock stopped"
    assert needed <= shown
