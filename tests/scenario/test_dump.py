from rcj_challenges.scenario.dump import dumped
from rcj_challenges.scenario.load import load


def test_a_scenario_survives_being_written_and_read():
    scenario = load("match").scenario
    assert type(scenario).model_validate(dumped(scenario)) == scenario
