"""Which moments a video shows."""

from dataclasses import replace

import pytest

from rcj_challenges.core.errors import RcjError
from rcj_challenges.core.timing import TICK_S
from rcj_challenges.views.timeline import Timeline
from rcj_challenges.views.video.clips import (
    Clip,
    clips_between,
    highlights,
    moment_at,
    moments,
    parse_seconds,
)
from rcj_challenges.views.video.footage import Footage
from tests.made_up_runs import GOAL_EVERY_TICKS, write_made_up_run

GOAL_S = GOAL_EVERY_TICKS * TICK_S


@pytest.fixture(scope="module")
def footage(tmp_path_factory):
    """Two halves of 32 s."""
    return Footage.open(write_made_up_run(tmp_path_factory.mktemp("runs"), ticks=1000))


@pytest.mark.parametrize(("text", "seconds"), [("113.9", 113.9), ("1:53.9", 113.9), ("0", 0), ("10:00", 600), ("7", 7)])
def test_times_are_seconds_or_minutes_and_seconds(text, seconds):
    assert parse_seconds(text) == pytest.approx(seconds)


@pytest.mark.parametrize("text", ["", "abc", "-1", "1:5", "1:99", "nan", "inf", "1e3", "1:2:3", "٣", "9" * 40])
def test_other_texts_are_not_times(text):
    with pytest.raises(RcjError) as error:
        parse_seconds(text)
    assert error.value.code == "bad-time"


def test_seconds_count_over_all_halves_or_within_one(footage):
    length_s = footage.halves[0].length_s
    over, within = moment_at(footage, length_s + 4.0, None), moment_at(footage, 4.0, 2)
    assert over.half.info.half == within.half.info.half == 2
    assert over.t_s == pytest.approx(within.t_s) == 4.0
    assert clips_between(footage, length_s - 1, length_s + 1, None) == [
        Clip(1, length_s - 1, length_s),
        Clip(2, 0.0, pytest.approx(1.0)),
    ]


@pytest.mark.parametrize(
    ("request_of", "code"),
    [
        (lambda f: moment_at(f, 1e6, None), "time-not-played"),
        (lambda f: moment_at(f, 40.0, 2), "time-not-played"),
        (lambda f: moment_at(f, 1.0, 3), "no-such-half"),
        (lambda f: clips_between(f, 5.0, 4.0, None), "empty-clip"),
        (lambda f: clips_between(f, 5.0, 5.0, None), "empty-clip"),
        (lambda f: clips_between(f, 0.0, 99.0, None), "time-not-played"),
        (lambda f: clips_between(f, 70.0, None, None), "time-not-played"),
        (lambda f: highlights(f, clips_between(f, 0.0, 3.0, None)), "no-highlights"),
    ],
)
def test_times_that_were_not_played_are_refused(footage, request_of, code):
    with pytest.raises(RcjError) as error:
        request_of(footage)
    assert error.value.code == code


@pytest.mark.parametrize(("speed", "pictures"), [(4.0, 19), (0.5, 150), (1.0, 75)])
def test_speed_changes_the_number_of_frames(footage, speed, pictures):
    clips = clips_between(footage, 2.0, 5.0, None)
    shown = moments(footage, clips, 25.0, speed)
    assert len(shown) == pictures
    assert shown[1].t_s - shown[0].t_s == pytest.approx(speed / 25)
    assert all(2.0 <= moment.t_s < 5.0 for moment in shown)


def test_highlights_are_six_seconds_before_each_goal_and_one_after(footage):
    found = highlights(footage, clips_between(footage, None, None, None))
    assert [clip.half for clip in found] == [1, 1, 2, 2]
    assert found[0].from_s == pytest.approx(GOAL_S - 6)
    assert found[0].to_s == pytest.approx(GOAL_S + 1)


def test_overlapping_highlights_are_joined(footage):
    scores = {"score_changes": [[300, {"blue": 1, "yellow": 0}], [400, {"blue": 1, "yellow": 1}]]}
    half = replace(footage.timeline.halves[1], changes=scores)
    close = replace(footage, halves=footage.halves[:1], timeline=Timeline({1: half}))
    (only,) = highlights(close, clips_between(close, None, None, None))
    assert (only.from_s, only.to_s) == (pytest.approx(300 * TICK_S - 6), pytest.approx(400 * TICK_S + 1))
