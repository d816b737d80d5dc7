"""What the rule sheet says of messages is how programs read them."""

import re
import struct

import pytest

from tests.devices.device_bench import Bench
from tests.views.sheets import section, sheet

pytestmark = pytest.mark.usefixtures("without_drawing")

RULE = "rules: {it: {triggers: [{trigger: half_started}], actions: [{action: end}]}}\n"
SECOND = "balls: {second: {start_m: [0.3, 0]}}\n"


def received(text: str, preset: str = "soccersim_v2") -> str:
    """Return the section of a sheet that has no other page with the rest: the sheet of a scenario without rules."""
    return section(sheet(text, preset), "What programs receive")


@pytest.mark.parametrize(
    ("text", "layout"),
    [
        ("", "18d2d?"),
        ("kits: {legacy_2021: {packet_lists: [Y3]}}\n", "3d2d?"),
        ("kits: {legacy_2021: {packet_lists: [Y2, B1], packet_has_flag: false}}\n", "6d2d"),
        ("balls: {ball: null}\nkits: {legacy_2021: {packet_lists: []}}\n", "?"),
        (SECOND, "18d4d?"),
    ],
)
def test_layout_of_a_packet_of_2021(text, layout):
    written = received(text, "soccersim_2021")
    assert f'the {struct.calcsize(layout)} bytes with struct.unpack("{layout}", packet)' in written
    assert ("True while a kick-off is awaited" in written) == layout.endswith("?")
    assert "a packet every 64 ms" in written


def test_packets_of_2021_are_unpacked_as_the_sheet_describes():
    written = re.search(r'struct\.unpack\("([^"]+)", packet\)', received(SECOND, "soccersim_2021"))
    bench = Bench("soccersim_2021", {"balls": {"second": {"start_m": [0.3, 0]}}})
    bench.place("B1", 0.1, 0.2, 0.5)
    bench.place("second", -0.3, 0.4)
    bench.enable("Y1", "receiver")
    bench.sense(ticks=3)
    numbers = struct.unpack(written[1], bench.heard("Y1", "receiver")[0].data)
    assert numbers[:3] == pytest.approx((0.2, 0.1, 0.5))
    assert numbers[20:22] == pytest.approx((0.4, -0.3))
    assert numbers[-1] is False


@pytest.mark.parametrize(
    ("preset", "every_ticks", "words"),
    [
        ("soccersim_v2", 1, "After the referee's packet, every 32 ms, one JSON object follows"),
        ("soccersim_2021", 4, "After the referee's packet, every 128 ms, one JSON object follows"),
        ("soccersim_2021", 1, "One JSON object is made every 32 ms; the newest follows the next packet"),
    ],
)
def test_broadcast_arrives_when_the_sheet_states(preset, every_ticks, words):
    assert words in received(f"broadcast: {{every_ticks: {every_ticks}, fields: {{now: {{word: time_s}}}}}}\n", preset)


@pytest.mark.parametrize(
    ("field", "words"),
    [
        ("{draw: side}", ': "west", 2 or true |'),
        ("{word: phase}", ': "play" or "pause" |'),
        ("{position_of: ball}", ": [x, y, yaw] in m and rad"),
        ("3", "| it | 3 |"),
    ],
)
def test_values_that_programs_compare_with_are_written_as_json(field, words):
    more = "phases: {pause: {}}\ndraws: {side: {values: [west, 2, true]}}\n"
    assert words in received(f"{more}broadcast: {{fields: {{it: {field}}}}}\n")


def test_robots_with_an_emitter_can_send_to_the_referee_if_a_rule_listens():
    rule = "rules: {it: {triggers: [{trigger: tells}], actions: [{action: end}], says: Told.}}\n"
    title = "What programs can send to the referee"
    written = section(sheet(rule + "robots: {Y1: {without: [team emitter]}}\n"), title)
    assert "what B1, B2, B3, Y2 and Y3 send with the team emitter on channel 1: text of up to 200 characters" in written
    assert section(sheet(RULE), title) == ""
