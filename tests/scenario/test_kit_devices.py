"""One robot's device is that of its kit, but for what is written."""

import jsonschema
import pytest
import yaml

from rcj_challenges.scenario.errors import ScenarioError
from rcj_challenges.scenario.json_schema import scenario_schema
from rcj_challenges.scenario.load import load_text

HEAD = "schema_version: 2\nid: mine\ntitle: Mine\nextends: soccersim_v2\n"
NAME = "distancesensor front"


def test_what_a_robots_device_leaves_out_is_as_in_its_kit():
    text = HEAD + f"robots: {{Y1: {{devices: {{{NAME}: {{range_m: 0.4}}}}}}}}\n"
    scenario = load_text(text).scenario
    kit = scenario.kits["v2"].devices[NAME]
    assert scenario.robots["Y1"].devices[NAME] == kit.model_copy(update={"range_m": 0.4})
    assert kit.range_m != 0.4
    assert not scenario.robots["Y2"].devices
    jsonschema.validate(yaml.safe_load(text), scenario_schema())


def test_the_kit_may_be_changed_beside_it_and_be_the_robots_own():
    kits = f"kits: {{v2: {{devices: {{{NAME}: {{noise: 0.2}}}}}}}}\nparams: {{far_m: 0.5}}\n"
    robots = f"robots: {{Y1: {{devices: {{{NAME}: {{range_m: {{param: far_m}}}}}}}}}}\n"
    device = load_text(HEAD + kits + robots).scenario.robots["Y1"].devices[NAME]
    assert (device.range_m, device.noise) == (0.5, 0.2)
    shorter = load_text(HEAD + kits + robots, ["far_m=0.3"]).scenario.robots["Y1"].devices[NAME]
    assert shorter.range_m == 0.3


@pytest.mark.parametrize(
    ("robots", "says"),
    [
        ("Y1: {devices: {sonar front: {range_m: 0.4}}}", "'device' is missing"),
        (f"Y1: {{devices: {{{NAME}: {{rnge_m: 0.4}}}}}}", "rnge_m"),
        (f"Y1: {{devices: {{{NAME}: null}}}}", f"is taken away by 'without: \\[{NAME}\\]'"),
        (f"Y1: {{kit: nowhere, devices: {{{NAME}: {{range_m: 0.4}}}}}}", "nowhere"),
    ],
)
def test_what_the_kit_does_not_have_is_a_mistake(robots, says):
    with pytest.raises(ScenarioError, match=says):
        load_text(HEAD + f"robots: {{{robots}}}\n")
