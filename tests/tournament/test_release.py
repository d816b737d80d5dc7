"""Times of release, and the schedule that they make."""

from datetime import UTC, datetime
from itertools import pairwise
from zoneinfo import ZoneInfo

from hypothesis import given
from hypothesis import strategies as st

from rcj_challenges.tournament.release import moments_of, release_times
from tests.tournament.seasons import by_strength, names, play, season


def times(stages, count, head="", outcome=by_strength):
    one = season(stages, names(count), head)
    tournament = one.loaded.tournament
    found = release_times(tournament, play(one, outcome))
    zone = ZoneInfo(tournament.time_zone)
    return {fixture: time.astimezone(zone).strftime("%d %H:%M %z") for fixture, time in found.items()}


def test_each_round_has_its_time_in_the_time_zone_of_the_tournament():
    stages = "  l: {stage: round_robin, legs: 2, release: [2021-06-22 18:00, 2021-12-22 18:00]}\n"
    found = times(stages, 2, "time_zone: Europe/Berlin\n")
    assert found == {"l/round1/t01-t02": "22 18:00 +0200", "l/round2/t02-t01": "22 18:00 +0100"}


def test_one_time_is_that_of_all_rounds():
    found = times("  l: {stage: round_robin, release: 2021-06-22 18:00}\n", 3)
    assert set(found.values()) == {"22 18:00 +0000"}


def test_a_stage_without_a_time_is_not_held_back():
    assert times("  l: {stage: round_robin}\n", 3) == {}


def test_matches_of_a_round_can_follow_each_other_and_those_of_a_tie_stay_together():
    stages = "  k: {stage: knock_out, legs: 2, release: 2021-06-22 18:00, minutes_between: 25}\n"
    found = times(stages, 4)
    by_tie = {tuple(fixture.split("/")[1:3]): time for fixture, time in found.items()}
    assert by_tie == {
        ("semi_finals", "1"): "22 18:00 +0000",
        ("semi_finals", "2"): "22 18:25 +0000",
        ("final", "1"): "22 18:50 +0000",
    }
    assert len(found) == 6


def test_minutes_between_are_elapsed_time_when_the_clock_is_put_back():
    stages = "  l: {stage: round_robin, groups: 3, release: 2021-10-31 02:30, minutes_between: 60}\n"
    one = season(stages, names(6), "time_zone: Europe/Berlin\n")
    found = sorted(time.astimezone(UTC) for time in release_times(one.loaded.tournament, play(one)).values())
    assert [(later - earlier).total_seconds() for earlier, later in pairwise(found)] == [3600, 3600]


@given(st.integers(0, 2_000_000_000), st.sampled_from(["Europe/Berlin", "Australia/Lord_Howe"]))
def test_a_time_stands_for_each_moment_at_which_the_clock_shows_it(time_s, name):
    zone = ZoneInfo(name)
    shown = datetime.fromtimestamp(time_s // 60 * 60, UTC)
    text = f"{shown.astimezone(zone):%Y-%m-%d %H:%M}"
    moments = moments_of(text, zone)
    assert shown in moments
    assert list(moments) == sorted(set(moments))
    assert all(f"{one.astimezone(zone):%Y-%m-%d %H:%M}" == text for one in moments)


def test_a_clock_that_is_put_forward_skips_times_and_one_that_is_put_back_shows_them_twice():
    zone = ZoneInfo("Europe/Berlin")
    assert moments_of("2026-03-29 02:30", zone) == ()
    assert [one.hour for one in moments_of("2026-10-25 02:45", zone)] == [0, 1]
