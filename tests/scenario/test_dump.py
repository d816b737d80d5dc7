import signal

import pytest

from rcj_challenges.scenario.dump import dumped
from rcj_challenges.scenario.load import load, load_text


def test_a_scenario_survives_being_written_and_read():
    scenario = load("match").scenario
    assert type(scenario).model_validate(dumped(scenario)) == scenario


def test_a_draw_that_repeats_is_written_as_before_there_were_others():
    draws = "draws: {plain: {values: [1, 2]}, once: {values: [1, 2], not_again: half}}"
    scenario = load_text(f"schema_version: 1\nid: it\ntitle: It\nextends: soccersim_v2\n{draws}\n").scenario
    written = dumped(scenario)["draws"]
    assert written["plain"] == {"values": [1, 2], "not_last": False, "keep": "half"}
    assert written["once"]["not_again"] == "half"
    assert type(scenario).model_validate(dumped(scenario)) == scenario


def test_a_counter_that_is_not_kept_is_written_as_before_any_was():
    counters = "counters: {plain: {}, kept: {per: robots, keep: match}}"
    scenario = load_text(f"schema_version: 1\nid: it\ntitle: It\nextends: soccersim_v2\n{counters}\n").scenario
    written = dumped(scenario)["counters"]
    assert written["plain"] == {"initial": 0.0, "per": None}
    assert written["kept"]["keep"] == "match"
    assert type(scenario).model_validate(dumped(scenario)) == scenario


def test_a_zone_without_a_colour_is_written_as_before_there_were_any():
    zones = "zones: {plain: {shape: rect, x_min_m: 0}, base: {shape: rect, x_max_m: 0, colour: red}}"
    scenario = load_text(f"schema_version: 1\nid: it\ntitle: It\nextends: soccersim_v2\n{zones}\n").scenario
    written = dumped(scenario)["zones"]
    assert {name for name, zone in written.items() if "colour" in zone} == {"base"}
    assert type(scenario).model_validate(dumped(scenario)) == scenario


def test_a_test_that_does_not_ask_who_is_held_is_written_as_before():
    block = "{keyframes: [{at_s: 0}], lasts_s: 1%s}"
    expect = f"expect: {{plain: {block % ''}, asking: {block % ', held: {Y1: false}'}}}"
    scenario = load_text(f"schema_version: 1\nid: it\ntitle: It\nextends: soccersim_v2\n{expect}\n").scenario
    written = dumped(scenario)["expect"]
    assert "held" not in written["plain"]
    assert written["asking"]["held"] == {"Y1": False}
    assert type(scenario).model_validate(dumped(scenario)) == scenario


def test_a_sequence_of_one_is_written_as_before_each_could_have_one():
    text = (
        "sequences: {one: {entity: ball, steps: [pitch, blue_goal]}, each: {per: robots, steps: [pitch, blue_goal]}}\n"
        "rules: {it: {triggers: [{trigger: sequence_completed, sequence: one}, {trigger: sequence_broken, sequence: one}], "
        "conditions: [{condition: sequence_at, sequence: one, step: pitch}], actions: [{action: sequence, sequence: one}]}}"
    )
    scenario = load_text(f"schema_version: 1\nid: it\ntitle: It\nextends: soccersim_v2\n{text}\n").scenario
    written = dumped(scenario)
    steps = {"steps": ["pitch", "blue_goal"], "cyclic": False, "wrong_step": "ignore"}
    assert written["sequences"] == {"one": {"entity": "ball", **steps}, "each": {"per": "robots", **steps}}
    rule = written["rules"]["it"]
    assert [set(trigger) for trigger in rule["triggers"]] == [{"trigger", "sequence"}] * 2
    assert set(rule["conditions"][0]) == {"condition", "negate", "sequence", "step"}
    assert set(rule["actions"][0]) == {"action", "sequence", "do"}
    assert type(scenario).model_validate(written) == scenario


# The command line lets SIGTERM, the end of a service, mean the same.
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM], ids=lambda number: number.name)
def test_ctrl_c_while_a_scenario_is_written_waits_until_that_is_done_and_is_not_lost(monkeypatch, number):
    before = signal.signal(number, signal.default_int_handler)
    scenario = load("match").scenario
    kind, done = type(scenario), []
    write = kind.model_dump

    def interrupted(self, **options):
        signal.raise_signal(number)
        written = write(self, **options)
        done.append(written)
        return written

    monkeypatch.setattr(kind, "model_dump", interrupted)
    try:
        with pytest.raises(KeyboardInterrupt):
            dumped(scenario)
        assert done
        assert signal.getsignal(number) is signal.default_int_handler
    finally:
        signal.signal(number, before)
