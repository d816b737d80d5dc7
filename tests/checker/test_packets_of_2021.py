"""Programs of the first demo of 2021 read packets without `waiting_for_kickoff`: a check says so, and what to set."""

from __future__ import annotations

import re
import struct

import pytest

from rcj_challenges.checker.advice.hints import hint_on
from rcj_challenges.controllers.team import open_team
from rcj_challenges.scenario.load import load

NO_FLAG = "kits.legacy_2021.packet_has_flag=false"
OF_2021, OF_THE_FIRST_DEMO = load("match_2021").scenario, load("match_2021", [NO_FLAG]).scenario
ALONE = load("fast_shooter").scenario


@pytest.fixture
def hint(tmp_path):
    def on(scenario, layout, packet_bytes, tick=2):
        (tmp_path / "robot.py").write_text("packet = receiver.getData()\n", encoding="utf-8")
        robot = next(iter(scenario.robots))
        with pytest.raises(struct.error) as error:
            struct.unpack(layout, bytes(packet_bytes))
        detail = f"struct.error: {error.value}"
        fault = {"kind": "crash", "robot": robot, "tick": tick, "detail": detail, "traceback": ""}
        with open_team(tmp_path / "robot.py") as team:
            return hint_on(scenario, team, fault, "")

    return on


def test_a_program_of_the_first_demo_is_told_how_to_play_without_the_flag(hint):
    told = hint(OF_2021, "ddd" * 6 + "dd", 161)
    assert told.message == ": this program seems to be written for packets without waiting_for_kickoff"
    assert f'"--set {NO_FLAG}" (check and run)' in told.remedy
    assert (
        "160 bytes without waiting_for_kickoff at its end (as in the first demo of 2021), and 161 with it"
        in told.remedy
    )
    assert 'else add the "?"' in told.remedy


def test_a_program_that_waits_for_the_flag_is_told_how_to_play_with_it(hint):
    told = hint(OF_THE_FIRST_DEMO, "ddd" * 6 + "dd?", 160)
    assert "--set kits.legacy_2021.packet_has_flag=true" in told.remedy
    assert "161 bytes with waiting_for_kickoff at its end, and 160 without it, as here" in told.remedy
    assert 'else leave out the "?"' in told.remedy


def test_the_size_is_that_of_the_scenarios_own_packet(hint):
    assert NO_FLAG in hint(ALONE, "ddddd", 41).remedy
    assert "flag" not in hint(ALONE, "ddd" * 6 + "dd", 41).remedy


LIDAR, PASSERS = load("precision_lidar").scenario, load("pass_the_ball").scenario


@pytest.mark.parametrize(
    ("scenario", "packet_bytes", "told"),
    [
        (OF_2021, 161, 'unpack("ddd" * 6 + "dd?", packet) gives x, y and orientation of B1, B2, B3, Y1, Y2, Y3; x and y of the'),
        (ALONE, 41, 'has 41 bytes: struct.unpack("ddd" * 1 + "dd?", packet) gives x, y and orientation of Y3; x and y of the ball'),
        (PASSERS, 113, 'unpack("ddd" * 4 + "dd?", packet) gives x, y and orientation of B1, B2, Y1, Y2; x and y of the ball'),
        (LIDAR, 17, 'has 17 bytes: struct.unpack("dd?", packet) gives x and y of the ball; waiting_for_kickoff'),
        (OF_THE_FIRST_DEMO, 160, 'unpack("ddd" * 6 + "dd", packet) gives x, y and orientation of B1, B2, B3, Y1, Y2, Y3; x and y of the ball'),
    ],
)  # fmt: skip
def test_a_program_that_reads_packets_of_another_size_is_told_what_is_in_those_of_the_scenario(
    hint, scenario, packet_bytes, told
):
    """A program of the match that is taken for a challenge, mostly: each of these lists other robots."""
    found = hint(scenario, "ddd" * 5 + "dd?", packet_bytes)
    assert told in found.remedy
    assert found.message == ": this program reads other packets than the referee sends here"


@pytest.mark.parametrize(
    ("scenario", "layout", "packet_bytes", "meant"),
    [(LIDAR, "ddddd?", 17, "fast_shooter"), (ALONE, "dd?", 41, "precision_lidar"), (LIDAR, "d" * 20, 17, "")],
)
def test_two_challenges_that_call_their_program_alike_are_told_apart_by_their_packets(
    tmp_path, scenario, layout, packet_bytes, meant
):
    (tmp_path / "score_goal").mkdir()
    (tmp_path / "score_goal" / "score_goal.py").write_text("packet = receiver.getData()\n", encoding="utf-8")
    with pytest.raises(struct.error) as error:
        struct.unpack(layout, bytes(packet_bytes))
    detail = f"struct.error: {error.value}"
    fault = {"kind": "crash", "robot": "Y3", "tick": 2, "detail": detail, "traceback": ""}
    with open_team(tmp_path, *scenario.entrants.values()) as team:
        told = hint_on(scenario, team, fault, "")
    assert told.remedy.startswith(f"it looks like one for {meant}: " if meant else "here that packet has 17 bytes")
    assert "here that packet has" in told.remedy


def test_what_is_told_to_be_unpacked_is_what_the_packet_holds(hint):
    form = re.search(r"struct\.unpack\((.+), packet\)", hint(PASSERS, "d", 113).remedy)[1]
    assert struct.calcsize(eval(form)) == 113  # noqa: S307 - a form that the advice has made


def test_later_packets_say_nothing_about_what_the_referees_hold(hint):
    told = hint(OF_2021, "ddd" * 6 + "dd", 161, 400)
    assert (told.message, told.remedy[:33]) == ("", "the packet has another length tha")


def test_of_a_packet_that_is_read_as_the_referees_but_is_another_one_nothing_is_said(hint):
    """What a challenge tells comes in packets of its own."""
    told = hint(ALONE, "ddddd?", 30)
    assert (told.message, told.remedy[:33]) == ("", "the packet has another length tha")
