"""Which devices robots have, and which of their properties programs get before the start."""

from __future__ import annotations

import json
from dataclasses import asdict

import pytest

from tests.devices.device_bench import Bench, scenario_of

KIT_V2 = [
    ("left wheel motor", "motor"),
    ("right wheel motor", "motor"),
    ("left wheel sensor", "position_sensor"),
    ("right wheel sensor", "position_sensor"),
    ("gps", "gps"),
    ("compass", "compass"),
    ("distancesensor left", "distance_sensor"),
    ("distancesensor right", "distance_sensor"),
    ("distancesensor front", "distance_sensor"),
    ("distancesensor back", "distance_sensor"),
    ("ball receiver", "receiver"),
    ("supervisor receiver", "receiver"),
    ("team receiver", "receiver"),
    ("team emitter", "emitter"),
]


def test_kit_v2_has_the_devices_of_the_rule_book() -> None:
    specs = Bench().devices.specs
    assert [spec.name for spec in specs.values()] == ["B1", "B2", "B3", "Y1", "Y2", "Y3"]
    for spec in specs.values():
        assert [(device.name, device.kind) for device in spec.devices] == KIT_V2
        assert spec.values == 12
        assert (spec.getdata_returns, spec.basic_step_ms, spec.max_velocity_radps) == ("bytes", 32, 10)


def test_kit_2021_has_motors_wheel_sensors_and_one_receiver_on_channel_0() -> None:
    spec = Bench("soccersim_2021").devices.specs[0]
    assert [device.name for device in spec.devices] == [
        "left wheel motor", "right wheel motor", "left wheel sensor", "right wheel sensor", "receiver",
    ]  # fmt: skip
    assert spec.devices[4].facts["channel"] == 0
    assert spec.getdata_returns == "bytes"


def test_the_2021_preset_differs_from_v2_in_kit_walls_and_entry_points_only() -> None:
    old, new = (scenario_of(name).model_dump() for name in ("soccersim_2021", "soccersim_v2"))
    for section in ("zones", "spots", "groups", "balls", "match"):
        assert old[section] == new[section]
    assert old["field"] == {**new["field"], "wall_height_m": 0.05}
    assert old["entrants"]["blue"]["robots"]["B2"] == "robot2/robot2.py"
    assert [robot["kit"] for robot in old["robots"].values()] == ["legacy_2021"] * 6


def test_slots_do_not_overlap_and_fill_the_values() -> None:
    bench = Bench(
        "soccersim_2021", {"robots": {"Y3": {"devices": {"lidar": {"device": "lidar"}, "gps": {"device": "gps"}}}}}
    )
    for spec in bench.devices.specs.values():
        taken = [slot for device in spec.devices for slot in range(device.slot, device.slot + device.width)]
        assert taken == list(range(spec.values))
        assert all((device.slot == -1) == (device.width == 0) for device in spec.devices)
        assert [device.index for device in spec.devices] == list(range(len(spec.devices)))


def test_a_robot_can_have_a_device_more_another_one_and_one_fewer() -> None:
    change = {
        "robots": {
            "Y3": {
                "without": ["team emitter", "gps"],
                "devices": {"ball receiver": {"device": "ball_receiver", "range_m": 1.0}, "eye": {"device": "lidar"}},
            }
        }
    }
    spec = Bench(change=change).devices.specs[5]
    names = [device.name for device in spec.devices]
    assert names == [name for name, _ in KIT_V2 if name not in ("gps", "team emitter")] + ["eye"]
    assert spec.devices[names.index("ball receiver")].facts["range"] == 1.0


def test_idle_robots_and_robots_without_entrant_have_no_program() -> None:
    change = {"robots": {"B1": {"idle": True}}, "entrants": {"blue": {"robots": {"B2": None}}}}
    bench = Bench(change=change)
    assert [spec.name for spec in bench.devices.specs.values()] == ["B3", "Y1", "Y2", "Y3"]
    assert sorted(bench.devices.specs) == [2, 3, 4, 5]
    bench.sense(ticks=2)


def test_specs_of_robots_can_be_sent_as_json() -> None:
    change = {"robots": {"Y3": {"devices": {"lidar": {"device": "lidar"}}}}}
    for spec in Bench(change=change).devices.specs.values():
        assert json.loads(json.dumps(asdict(spec), allow_nan=False))["name"] == spec.name


@pytest.mark.parametrize(
    ("device", "fact", "value"),
    [
        ("left wheel motor", "max_velocity", 10),
        ("distancesensor left", "min_value", 0),
        ("distancesensor left", "max_value", 1000),
        ("ball receiver", "channel", 4),
        ("supervisor receiver", "channel", 1),
        ("team receiver", "channel", 3),
        ("team receiver", "refused_channels", [2]),
        ("team emitter", "channel", 3),
        ("team emitter", "range", 10),
        ("team emitter", "refused_channels", [-1, 1, 2]),
    ],
)
def test_what_a_program_can_ask_without_stepping(device: str, fact: str, value: object) -> None:
    spec = Bench().devices.specs[3]
    assert next(one for one in spec.devices if one.name == device).facts[fact] == value
