"""The rule sheet tells balls apart, lists them, says what the packets hold, and repeats no setting in words."""

import re
import struct
from pathlib import Path

import pytest

from rcj_challenges.scenario.load import load, load_text
from rcj_challenges.views.sheet import sheet_markdown
from tests.devices.device_bench import Bench

pytestmark = pytest.mark.usefixtures("without_drawing")

ROOT = Path(__file__).resolve().parents[2]
SHIPPED = [pytest.param(path, id=path.stem) for path in sorted((ROOT / "scenarios").rglob("*.yaml"))]
END = "actions: [{action: end}]"
RULE = f"rules: {{it: {{triggers: [{{trigger: half_started}}], {END}}}}}\n"


def sheet(text: str, preset: str = "soccersim_v2") -> str:
    """Return the sheet of a scenario, without the marks that keep Markdown from reading names as something else."""
    loaded = load_text(f"schema_version: 1\nid: told\ntitle: Told\nextends: {preset}\n{text}")
    return sheet_markdown(loaded.scenario, loaded.roster).replace("\\", "")


def rule_of(text: str, rule: str) -> str:
    """Return the sentence of the rule ``it`` beside ``text``."""
    lines = sheet(f"{text}rules:\n  it: {{{rule}}}\n").splitlines()
    return next(line for line in lines if line.startswith("1. [it] ")).removeprefix("1. [it] ")


# --- names ----------------------------------------------------------------------------------------------------------

SECOND = "balls: {second: {start_m: [0.3, 0]}}\n"
BACK = (
    "for_each: balls, triggers: [{trigger: leaves, entity: each, zone: pitch}], says: '{entity} is out.', "
    "actions: [{action: place, entity: each, at: {relative_to: ball, offset_m: [0.1, 0]}}]"
)


def test_of_several_balls_the_one_named_ball_is_told_from_the_one_concerned():
    assert rule_of(SECOND, BACK) == (
        "The ball is out. For each of the balls, when it leaves the pitch: "
        "it is put 0.1 m towards +x of the ball “ball”."
    )


def test_a_single_ball_is_the_ball():
    rule = f"triggers: [{{trigger: leaves, entity: ball, zone: pitch}}], {END}"
    assert rule_of("", rule) == "When the ball leaves the pitch: the half ends."


LIKE_OTHERS = {
    "gate": (
        "gates: {gate: {from_m: [0, 0], to_m: [0, 0.2]}, another: {from_m: [0.2, 0], to_m: [0.2, 0.2]}}\n",
        "trigger: crosses, entity: Y1, gate: gate",
        "Y1 crosses the gate “gate”",
    ),
    "obstacle": (
        (
            "obstacles: {obstacle: {shape: wall, from_m: [0.3, 0], to_m: [0.5, 0]}, "
            "another: {shape: wall, from_m: [-0.5, 0], to_m: [-0.3, 0]}}\n"
        ),
        "trigger: touches, entity: Y1, other: obstacle",
        "Y1 touches the obstacle “obstacle”",
    ),
    "zone": (
        "zones: {zone: {shape: circle, centre_m: [0, 0], radius_m: 0.2}}\n",
        "trigger: enters, entity: Y1, zone: zone",
        "Y1 enters the zone “zone”",
    ),
    "spot": (
        "spots: {the_spot: {x_m: 0.1, y_m: 0.1}}\n",
        "trigger: holds, condition: {condition: distance, entity: Y1, to: the_spot, at_most: 0.5}",
        "Y1 is at most 0.5 m from the spot “the spot”",
    ),
}


@pytest.mark.parametrize("kind", LIKE_OTHERS)
def test_what_is_called_like_all_of_its_kind_stands_in_quotes(kind):
    text, trigger, words = LIKE_OTHERS[kind]
    assert rule_of(text, f"triggers: [{{{trigger}}}], {END}") == f"When {words}: the half ends."


# --- the balls ------------------------------------------------------------------------------------------------------


def test_a_single_ball_is_described_in_a_line():
    said = "The ball measures 4.2 cm across, its mass is 0.05 kg. It sends infra-red. Its start is (0, 0)."
    assert said in sheet(RULE)


def test_the_line_tells_what_is_set():
    balls = "balls: {ball: null, red: {start_m: [0.1, 0], radius_m: 0.1, mass_kg: 0.2, colour: red, emits: false}}\n"
    assert (
        "The ball “red” measures 0.2 m across, its mass is 0.2 kg, its colour is red. It sends no infra-red. "
        "Its start is (0.1, 0)." in sheet(balls + RULE)
    )


def test_several_balls_stand_in_a_table():
    text = sheet("balls: {big: {start_m: [0.3, 0], radius_m: 0.03, colour: green, emits: false}}\n" + RULE)
    assert "| ball | start | diameter | mass | colour | sends infra-red |" in text
    assert "| ball | (0, 0) | 4.2 cm | 0.05 kg | #e8590c | yes |" in text
    assert "| big | (0.3, 0) | 6 cm | 0.05 kg | green | no |" in text


def test_colours_that_nobody_gave_are_no_column():
    assert "| ball | start | diameter | mass | sends infra-red |" in sheet(SECOND + RULE)


def test_the_sheet_says_of_a_ball_that_slows_down_by_how_much():
    told = "it loses 0.05 m/s in each second."
    assert f"While it rolls, {told}" in sheet("balls: {ball: {slows_mps2: 0.05}}\n" + RULE)
    assert "loses" not in sheet(SECOND + RULE)
    assert f"While second rolls, {told}" in sheet("balls: {second: {start_m: [0.3, 0], slows_mps2: 0.05}}\n" + RULE)


def test_balls_that_slow_down_alike_share_a_sentence():
    slow = "balls: {ball: null, red: {start_m: [0.3, 0], slows_mps2: %s}, green: {slows_mps2: 0.05}}\n"
    assert "\nWhile one of the balls rolls, it loses 0.05 m/s in each second.\n" in sheet(slow % 0.05 + RULE)
    text = sheet(slow % 0.1 + RULE)
    assert "While red rolls, it loses 0.1 m/s in each second." in text
    assert "While green rolls, it loses 0.05 m/s in each second." in text
    third = slow.replace("}}\n", "}, white: {start_m: [-0.3, 0]}}\n")
    assert "While red or green rolls, it loses 0.05 m/s in each second." in sheet(third % 0.05 + RULE)


def test_without_balls_the_sheet_says_so():
    assert "There is no ball." in sheet("balls: {ball: null}\n" + RULE)


HEARD = {
    "": "infra-red receiver of the ball, up to 0.6 m",
    SECOND: "infra-red receiver of all balls, up to 0.6 m",
    "balls: {red: {start_m: [0.3, 0]}, dumb: {start_m: [-0.3, 0], emits: false}}\n": (
        "infra-red receiver of the ball “ball” and the ball “red” only, up to 0.6 m"
    ),
    "balls: {ball: {emits: false}}\n": "infra-red receiver; it hears nothing, for no ball sends infra-red",
}


@pytest.mark.parametrize(("balls", "words"), HEARD.items(), ids=list(HEARD.values()))
def test_an_infra_red_receiver_says_which_balls_it_hears(balls, words):
    assert f"| ball receiver | {words} |" in sheet(balls + RULE)


def test_the_sheet_warns_that_packets_of_several_balls_look_alike():
    warning = "A packet of infra-red does not tell which of the balls sent it."
    assert warning in sheet(SECOND + RULE)
    assert warning not in sheet(RULE)
    assert warning not in sheet(SECOND + RULE, "soccersim_2021")


# --- a sonar that does not reach 1 m --------------------------------------------------------------------------------


def test_a_sonar_of_less_than_1_m_tells_the_noise_at_its_own_range():
    sonar = "{device: sonar, bearing_rad: 0, range_m: 0.4, noise: 0.05}"
    assert (
        "up to 0.4 m (noise: standard deviation 2 % of the value at 0.4 m, less when nearer: at half the distance half "
        "that share), " in sheet(f"robots: {{Y1: {{devices: {{it: {sonar}}}}}}}\n" + RULE)
    )


def test_a_short_sonar_without_noise_tells_none():
    sonar = "{device: sonar, bearing_rad: 0, range_m: 0.4, noise: 0}"
    assert "bearing 0°, up to 0.4 m, 3.85 cm off" in sheet(f"robots: {{Y1: {{devices: {{it: {sonar}}}}}}}\n" + RULE)


# --- packets --------------------------------------------------------------------------------------------------------

PACKETS_2021 = {
    "": ("B1, B2, B3, Y1, Y2 and Y3, one after the other: X, Z, orientation", "18d2d?"),
    "kits: {legacy_2021: {packet_lists: [Y3]}}\n": ("of Y3: X, Z, orientation", "3d2d?"),
    "kits: {legacy_2021: {packet_lists: [Y2, B1], packet_has_flag: false}}\n": ("each of Y2 and B1, one after", "6d2d"),
    "kits: {legacy_2021: {packet_lists: []}}\n": ("1. of the ball: X, Z", "2d?"),
    SECOND: ("each of the ball “ball” and the ball “second”, one after the other: X, Z", "18d4d?"),
    "balls: {ball: null}\n": ("X is the y of this sheet, Z is its x", "18d?"),
}


@pytest.mark.parametrize(("text", "told"), PACKETS_2021.items(), ids=[layout for _, layout in PACKETS_2021.values()])
def test_the_sheet_says_what_a_packet_of_2021_holds(text, told):
    words, layout = told
    written = sheet(text + RULE, "soccersim_2021")
    assert "The referee sends robots of the kit legacy_2021 a packet every 2 ticks (0.064 s)." in written
    assert words in written
    assert f'the {struct.calcsize(layout)} bytes with struct.unpack("{layout}", packet)' in written
    assert ("True while a kick-off is awaited" in written) == layout.endswith("?")
    assert ("does not tell whether a kick-off is awaited" in written) != layout.endswith("?")


def test_of_a_packet_of_one_byte_the_byte_is_unpacked():
    nothing = "balls: {ball: null}\nkits: {legacy_2021: {packet_lists: []}}\n"
    written = sheet(nothing + RULE, "soccersim_2021")
    assert 'Python unpacks its one byte with struct.unpack("?", packet).' in written
    assert "bytes" not in written.partition("What programs are told")[2].partition("##")[0]


def test_packets_of_2021_are_unpacked_as_the_sheet_says():
    written = re.search(r'struct\.unpack\("([^"]+)", packet\)', sheet(SECOND + RULE, "soccersim_2021"))
    bench = Bench("soccersim_2021", {"balls": {"second": {"start_m": [0.3, 0]}}})
    bench.place("B1", 0.1, 0.2, 0.5)
    bench.place("second", -0.3, 0.4)
    bench.enable("Y1", "receiver")
    bench.sense(ticks=3)
    numbers = struct.unpack(written[1], bench.heard("Y1", "receiver")[0].data)
    assert numbers[:3] == pytest.approx((0.2, 0.1, 0.5))
    assert numbers[20:22] == pytest.approx((0.4, -0.3))
    assert numbers[-1] is False


def test_packets_of_later_kits_hold_the_flag_only():
    assert 'a packet every tick (0.032 s). It is one byte, whether a kick-off is awaited; Python unpacks it with struct.unpack("?", packet).' in sheet(RULE)  # fmt: skip
    assert '{"waiting_for_kickoff": true}' in sheet("kits: {v2: {messages: v2.2}}\n" + RULE)


def test_each_kit_in_use_has_its_packet_told():
    kits = (
        "kits: {old: {messages: '2021', packet_lists: [Y1], devices: {receiver: {device: supervisor_receiver}}}, "
        "deaf: {}}\nrobots: {Y1: {kit: old}, Y2: {kit: deaf}}\n"
    )
    written = sheet(kits + RULE)
    assert "robots of the kit old a packet" in written
    assert "robots of the kit v2 a packet" in written
    assert "robots of the kit deaf" not in written


def test_robots_that_cannot_hear_the_referee_are_told_nothing():
    deaf = ", ".join(f"{name}: {{without: [supervisor receiver]}}" for name in ("B1", "B2", "B3", "Y1", "Y2", "Y3"))
    written = sheet(f"robots: {{{deaf}}}\nbroadcast: {{fields: {{now: {{word: time_s}}}}}}\n" + RULE)
    assert "No robot has a receiver of the referee's packets." in written
    assert "JSON" not in written


@pytest.mark.parametrize(
    ("deaf", "words"),
    [
        (("Y2",), ", but for Y2, which has no receiver for it,"),
        (("Y2", "Y3"), ", but for Y2 and Y3, which have no receiver for it,"),
        ((), ""),
    ],
)
def test_of_robots_of_one_kit_that_do_not_all_hear_the_referee_it_is_said_who_does_not(deaf, words):
    robots = ", ".join(f"{name}: {{without: [supervisor receiver]}}" for name in deaf)
    written = sheet(f"robots: {{{robots}}}\n" + RULE)
    assert f"The referee sends robots of the kit v2{words} a packet every tick (0.032 s). It is one byte" in written


BROADCASTS = {
    ("soccersim_v2", 1): "After it, every tick (0.032 s), one JSON object follows",
    ("soccersim_2021", 4): "After it, every 4 ticks (0.128 s), one JSON object follows",
    ("soccersim_2021", 1): "One JSON object is made every tick (0.032 s); the newest follows the next packet",
}


@pytest.mark.parametrize(("preset", "every_ticks"), BROADCASTS)
def test_a_broadcast_is_told_to_come_when_it_comes(preset, every_ticks):
    broadcast = f"broadcast: {{every_ticks: {every_ticks}, fields: {{now: {{word: time_s}}}}}}\n"
    assert BROADCASTS[preset, every_ticks] in sheet(broadcast + RULE, preset)


@pytest.mark.parametrize(
    ("preset", "messages", "said"),
    [
        ("soccersim_v2", "v2.1", True),
        ("soccersim_2021", "2021", True),
        # Then the official packet is JSON text as well, and its key tells it.
        ("soccersim_v2", "v2.2", False),
    ],
)
def test_how_programs_tell_the_broadcast_from_the_packet_is_told(preset, messages, said):
    kit = "legacy_2021" if preset == "soccersim_2021" else "v2"
    fields = "broadcast: {fields: {now: {word: time_s}}}\n"
    written = sheet(f"kits: {{{kit}: {{messages: '{messages}'}}}}\n{fields}{RULE}", preset)
    by_its_end = 'A packet for which packet.endswith(b"}") is true is that object, any other the official one'
    by_its_key = "That with the key “waiting_for_kickoff” is the official packet, the other one is that object"
    assert (by_its_end in written, by_its_key in written) == (said, not said)


def test_no_packet_of_2021_ends_like_json_whatever_it_begins_with():
    # 0.1 + this many steps of the smallest size begins with the byte of "{".
    x = next(x for x in (0.1 + step * 2**-56 for step in range(1000)) if struct.pack("d", x).startswith(b"{"))
    for waiting in (False, True):
        packet = struct.pack("ddd?", x, 0, 0, waiting)
        assert packet.startswith(b"{")
        assert not packet.endswith(b"}")


# --- nothing is said twice ------------------------------------------------------------------------------------------

SETTING = re.compile(
    r"\b(?:\d+|n|one|two|three|four|five|six|ten) (?:more )?(?:minutes?|seconds?|half|halves|points?|robots?|balls|gates|circles)\b"
    r"|\ba point\b|change sides|half-time",
    re.IGNORECASE,
)


@pytest.mark.parametrize("path", SHIPPED)
def test_no_text_of_a_shipped_scenario_repeats_what_a_setting_says(path):
    scenario = load(path).scenario
    texts = [scenario.description, *(rule.says for rule in scenario.rules.values())]
    assert [found[0] for text in texts for found in SETTING.finditer(text)] == []


def test_a_shorter_match_has_no_other_length_on_its_sheet():
    loaded = load_text("schema_version: 1\nid: short\ntitle: Short\nextends: match\nmatch: {half_s: 180, halves: 1}\n")
    written = sheet_markdown(loaded.scenario, loaded.roster)
    assert "One half of 3 min." in written
    assert "ten minutes" not in written
    assert "change sides" not in written
