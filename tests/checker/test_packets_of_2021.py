"""Programs of the first demo of 2021 read packets without `waiting_for_kickoff`: a check says so, and what to set."""

from __future__ import annotations

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


@pytest.mark.parametrize(("layout", "tick"), [("dd", 2), ("ddd" * 6 + "dd", 400)])
def test_other_sizes_and_later_packets_say_nothing_about_the_flag(hint, layout, tick):
    told = hint(OF_2021, layout, 161, tick)
    assert (told.message, told.remedy[:33]) == ("", "the packet has another length tha")
