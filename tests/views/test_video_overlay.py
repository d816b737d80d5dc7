"""Scoreboard and captions."""

from dataclasses import replace

import numpy as np
import pytest
from PIL import Image

from rcj_challenges.core.timing import TICK_S
from rcj_challenges.views.video.clips import moment_at
from rcj_challenges.views.video.footage import Footage
from rcj_challenges.views.video.overlay import BAR, Overlay
from rcj_challenges.views.video.text import text_mask
from tests.made_up_runs import GOAL_EVERY_TICKS, write_made_up_run

GOAL_S = GOAL_EVERY_TICKS * TICK_S


@pytest.fixture(scope="module")
def footage(tmp_path_factory):
    return Footage.open(write_made_up_run(tmp_path_factory.mktemp("runs"), ticks=600))


def written(footage, t_s, size=(1280, 720)):
    """Return the pixels of an empty picture with everything written over it."""
    overlay, frame = Overlay(footage, size), Image.new("RGB", size)
    overlay.write(frame, moment_at(footage, t_s, None))
    return np.asarray(frame).astype(int), overlay.height


def test_goal_changes_the_score_and_has_a_caption_for_three_seconds(footage):
    def share_of_yellow(picture):
        r, g, b = (picture[600:, 300:980, channel] for channel in range(3))
        return ((r > 180) & (g > 140) & (b < 90)).mean()

    before, bar = written(footage, GOAL_S - 0.1)
    after, _ = written(footage, GOAL_S + 1)
    later, _ = written(footage, GOAL_S + 3.5)
    assert [share_of_yellow(picture) > 0.2 for picture in (before, after, later)] == [False, True, False]
    assert np.abs(after[:bar, 500:780] - before[:bar, 500:780]).max() > 60
    assert (later[:bar, 500:780] == after[:bar, 500:780]).all()


@pytest.mark.parametrize("names", [("Hanse",), ("Hanse", "Alster"), ("Hanse", "Alster", "Elbe")])
def test_teams_are_named_around_the_middle_of_the_scoreboard(footage, names):
    teams = [*footage.titles, "third"][: len(names)]
    picture, bar = written(replace(footage, titles=dict(zip(teams, names, strict=True))), 0.5)
    ink = np.abs(picture[:bar, 200:1080] - BAR).sum(axis=2) > 60  # without clock and half
    columns = np.flatnonzero(ink.any(axis=0)) + 200
    assert (columns[0] + columns[-1]) / 2 == pytest.approx(640, abs=25)
    assert bool(np.ptp(columns) > 250) is (len(names) > 1)


@pytest.mark.parametrize(
    "name", ["<script>", "x" * 10_000, "كرة القدم", "机器人足球", "\u202eevil", "A\nB", "\U0001f916", ""]
)
def test_any_name_fits_on_the_scoreboard(footage, name):
    picture, bar = written(replace(footage, titles={"blue": name, "yellow": "Alster"}), 0.5, (320, 180))
    assert (np.abs(picture[:bar, :90] - BAR).sum(axis=2) > 60).any()  # the clock is not written over


@pytest.mark.parametrize("text", ["Żółw", "x" * 300, "\N{PARAGRAPH SEPARATOR}", "two\N{LINE SEPARATOR}lines"])
@pytest.mark.parametrize("max_width_px", [1, 100])
def test_text_is_cut_to_the_width_it_has(text, max_width_px):
    assert text_mask(text, 20, max_width_px=max_width_px).width <= max_width_px + 1
