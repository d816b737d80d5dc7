"""The site of a tournament in a real browser: on a desk, on a phone, on paper, and a premiere by the clock."""

import re
from collections.abc import Callable
from dataclasses import replace
from datetime import timedelta
from pathlib import Path
from typing import Any

import pytest

from rcj_challenges.tournament.site import publish
from tests.tournament.site_play import NOW, MadeUpSeason, make_season
from tests.views.browser_stage import NARROW, NO_WEBGL, WIDE, Stage, until

TICKS, HALF_TIME_S, TICK_S = 1000, 30, 0.032
START_MS = round(NOW.timestamp() * 1000)


@pytest.fixture(scope="module")
def season(tmp_path_factory: pytest.TempPathFactory) -> MadeUpSeason:
    return make_season(tmp_path_factory.mktemp("season"), ticks=TICKS)


@pytest.fixture(scope="module")
def data(season: MadeUpSeason, tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("site")
    source = season.source(season.outcomes({"groups": 1, "skills": 1}))
    match = source.state.stages[0].fixtures[0].id
    outcomes = {one: outcome for one, outcome in source.state.outcomes.items() if one != match}
    now = NOW - timedelta(minutes=5)
    state = season.engine.state(outcomes)
    publish(replace(source, state=state, now=now, releases={match: NOW}, premieres=frozenset({"groups"})), folder)
    return folder


@pytest.fixture
def visit(watch: Callable[..., Any], data: Path) -> Callable[..., Any]:
    def open_page(path: str, **options: Any) -> Any:
        return watch((data / path).as_uri(), ready="main", own=data.as_uri(), **options)

    return open_page


@pytest.mark.parametrize(
    ("scheme", "viewport"),
    [
        pytest.param("light", WIDE, id="on a desk", marks=pytest.mark.nightly),
        pytest.param("dark", NARROW, id="on a phone"),
    ],
)
def test_pages_fit_the_screen_and_their_policy_lets_the_style_in(
    scheme: str, viewport: dict[str, int], visit: Callable[..., Any], data: Path
) -> None:
    match = next((data / "site" / "matches").glob("groups.*/replay.html")).parent
    paths = ["index", "stages/groups", "stages/skills", "head_to_head", "teams/ibex", f"matches/{match.name}/index"]
    page = visit("site/schedule.html", viewport=viewport, color_scheme=scheme)
    for path in paths:
        page.goto((data / "site" / f"{path}.html").as_uri())
        assert page.evaluate("document.documentElement.scrollWidth <= innerWidth"), path
        dark = page.evaluate("getComputedStyle(document.body).backgroundColor") == "rgb(14, 18, 22)"
        assert dark == (scheme == "dark"), path


def test_an_event_of_the_report_leads_to_its_moment_of_the_replay(visit: Callable[..., Any], data: Path) -> None:
    match = next((data / "site" / "matches").glob("groups.*/replay.html")).parent
    page = visit(f"site/matches/{match.name}/index.html", script=NO_WEBGL)
    page.click(".moments .goal a >> nth=1")
    page.wait_for_selector("body.ready")
    assert page.evaluate("[replay.half, replay.tick]") == [1, 800]


def test_goals_stand_first_and_more_of_a_bracket_is_indicated(visit: Callable[..., Any], data: Path) -> None:
    match = next((data / "site" / "matches").glob("groups.*/replay.html")).parent
    page = visit(f"site/matches/{match.name}/index.html", viewport=NARROW)
    assert page.locator("article section").first.locator(".standing").all_inner_texts() == [
        "0 : 1", "0 : 2", "1 : 2", "2 : 2",
    ]  # fmt: skip
    page.goto((data / "site/stages/finals.html").as_uri())
    box = page.locator(".scroll:has(.bracket)")
    assert box.evaluate("(one) => one.scrollWidth > one.clientWidth && getComputedStyle(one).backgroundAttachment") == (
        "local, local, scroll, scroll"
    )


def test_a_bracket_prints_on_one_sheet_across(visit: Callable[..., Any]) -> None:
    page = visit("site/brackets/finals.html")
    page.emulate_media(media="print")
    pdf = page.pdf(prefer_css_page_size=True)
    sheets = re.findall(rb"/MediaBox \[0 0 ([0-9.]+) ([0-9.]+)\]", pdf)
    assert [(round(float(wide)), round(float(tall))) for wide, tall in sheets] == [(842, 595)]  # A4 in points


# --- premiere --------------------------------------------------------------------------------------------------------

FAKE_CLOCK = """
  const began = Date.now(), clock = Date.now.bind(Date);
  Date.now = () => {start} + clock() - began;
"""


@pytest.fixture
def premiere(watch: Callable[..., Any], data: Path) -> Callable[..., Any]:
    """Opens the page of the premiere at a time, in s from its beginning; the recording is uploaded, if it is to be."""
    page = next((data / "site" / "premiere").glob("*.html"))
    recording = next((data / "premieres").glob("*.js"))

    def open_premiere(at_s: float, *, uploaded: bool = True, ready: str = "body.ready") -> Any:
        target = page.with_name(recording.name)
        target.unlink(missing_ok=True)
        if uploaded:
            target.write_bytes(recording.read_bytes())
        clock = FAKE_CLOCK.replace("{start}", str(START_MS + 1000 * at_s))
        return watch(page.as_uri(), ready=ready, script=NO_WEBGL + clock, own=data.as_uri())

    return open_premiere


def test_a_premiere_counts_down_and_has_no_replay_before_its_start(premiere: Callable[..., Any]) -> None:
    page = premiere(-90061, ready="#countdown")
    assert page.inner_text("#countdown").startswith("1 d 01:01:0")
    assert page.evaluate("window.replay === undefined")


def test_a_premiere_begins_by_itself(premiere: Callable[..., Any]) -> None:
    page = premiere(-0.5)
    assert page.evaluate("replay.half") == 1
    assert page.evaluate("replay.recording.last") * TICK_S < 10


def test_who_comes_late_to_a_premiere_joins_at_the_moment_and_sees_no_later_score(premiere: Callable[..., Any]) -> None:
    page = premiere(20)  # there are goals at 12.8 s and at 25.6 s
    seen = page.evaluate("({ last: replay.recording.last * 0.032, span: replay.recording.span * 0.032 })")
    assert 20 <= seen["last"] <= 25
    assert seen["span"] == pytest.approx(2 * TICKS * TICK_S, abs=0.1)
    assert page.locator(".score").all_inner_texts() == ["0", "1"]
    assert page.locator("#events .goal").count() == 1
    page.keyboard.press("End")
    assert page.evaluate("replay.place <= replay.recording.last")


@pytest.mark.nightly
def test_two_spectators_see_the_same_moment(premiere: Callable[..., Any]) -> None:
    until_now = "replay.place - (Date.now() - replay.started) / 32"
    pages = [premiere(at_s) for at_s in (10, 10)]
    for page in pages:
        page.evaluate(f"replay.started = {START_MS}")
        until(page, "replay.recording.last - replay.place < 40")
    early, late = [page.evaluate(until_now) for page in pages]
    assert abs(early - late) * TICK_S < 1


@pytest.mark.nightly
def test_a_premiere_pauses_between_the_halves(premiere: Callable[..., Any]) -> None:
    page = premiere(TICKS * TICK_S + HALF_TIME_S - 10)
    assert page.evaluate("replay.half") == 1
    assert page.is_visible("#problem")
    until(page, "replay.recording.halves.length === 2")
    assert not page.is_visible("#problem")


def test_after_a_premiere_all_of_it_can_be_seen(premiere: Callable[..., Any]) -> None:
    page = premiere(1000)
    until(page, "replay.recording.over")
    assert page.evaluate("replay.recording.last") == 2 * TICKS + 1
    page.evaluate("replay.seek(1, 0)")
    until(page, "[...document.querySelectorAll('.score')].map((score) => score.innerText).join() === '0,0'")


@pytest.mark.nightly
def test_a_premiere_waits_for_its_recording(browser_stage: Stage, premiere: Callable[..., Any]) -> None:
    page = premiere(5, uploaded=False, ready="#countdown")
    until(page, "document.querySelector('.news').textContent !== ''")
    browser_stage.complaints.clear()  # that the file is not there
    assert page.inner_text("#countdown") == "00:00"
