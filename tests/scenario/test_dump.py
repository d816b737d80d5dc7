import signal

import pytest

from rcj_challenges.scenario.dump import dumped
from rcj_challenges.scenario.load import load


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
