import sys

from rcj_challenges.scenario.load import load


def test_a_scenario_is_dumped_without_calls_from_pydantic_which_would_swallow_ctrl_c():
    scenario, called = load("match").scenario, []
    sys.setprofile(lambda frame, event, _: called.append(frame.f_code.co_filename) if event == "call" else None)
    try:
        scenario.dumped()
    finally:
        sys.setprofile(None)
    assert [file for file in called if "rcj_challenges" in file] == [type(scenario).dumped.__code__.co_filename]
