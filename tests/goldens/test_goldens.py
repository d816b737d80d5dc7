"""Results that must not change unawares: matches and challenges with frozen teams, tests, and a record judged again."""

import hashlib
import math
import random
import struct

import pytest

from rcj_challenges.match.rejudge import rejudge
from rcj_challenges.records.recorded_scenario import read_scenario
from rcj_challenges.records.result import read_result
from rcj_challenges.records.trajectory import Trajectory
from tests.goldens.plays import PLAYS, RECORD, STATES, TESTS, judged_tests, machine, played, read

CHANGED = "if that is intended: python -m tests.goldens.bless, and a line in CHANGELOG.md"


def compare(play, out, length):
    known = read(STATES).get(machine(), {}).get(play.scenario, {})
    if length not in known:
        pytest.skip(f"no golden {length} states for this kind of machine: {machine()}")
    assert played(play, length, out) == known[length], CHANGED


@pytest.mark.parametrize("play", PLAYS, ids=lambda play: play.scenario)
def test_the_first_seconds_are_played_as_ever(play, tmp_path):
    compare(play, tmp_path, "short")


@pytest.mark.nightly
@pytest.mark.parametrize("play", [play for play in PLAYS if "whole" in play.lengths], ids=lambda play: play.scenario)
def test_the_whole_of_it_is_played_as_ever(play, tmp_path):
    compare(play, tmp_path, "whole")


@pytest.mark.parametrize("play", PLAYS, ids=lambda play: play.scenario)
def test_the_tests_of_a_scenario_fire_the_same_rules_at_the_same_ticks(play):
    assert judged_tests(play.scenario) == read(TESTS)[play.scenario], CHANGED


def test_a_stored_record_is_judged_as_ever():
    result = read_result(RECORD)
    judgement = rejudge(Trajectory.open(RECORD), read_scenario(RECORD))
    assert judgement.complete
    assert judgement.events == [event.model_dump() for event in result.events]
    assert judgement.scores == result.score
    assert judgement.ranking == [place.model_dump() for place in result.ranking]


def test_lengths_of_vectors_are_the_same_to_the_last_bit_in_every_version_of_python():
    if machine() not in read(STATES):
        pytest.skip(f"no golden states for this kind of machine: {machine()}")
    rng, digest = random.Random(5), hashlib.sha256()  # noqa: S311 - fixed numbers
    for _ in range(100_000):
        x, y, z = (rng.uniform(-1, 1) * 10 ** rng.uniform(-6, 3) for _ in range(3))
        digest.update(struct.pack("<2d", math.hypot(x, y), math.hypot(x, y, z)))
    assert digest.hexdigest().startswith("d29229fc41d1ecff")
