"""The small field of the referee's tests, for tests of `expect` blocks."""

from collections.abc import Callable

import pytest

from rcj_challenges.expect.runner import run_test
from rcj_challenges.scenario.load import Loaded
from rcj_challenges.scenario.roster import Roster
from tests.referee.conftest import match, match_play, small, small_scenario, stage

__all__ = ["match", "match_play", "small", "stage"]


@pytest.fixture(scope="session")
def differences() -> Callable[..., list[str]]:
    """Return what plays one ``expect`` block on the small field and returns its differences, then its notes."""

    def play(block: str, *sections: str) -> list[str]:
        scenario = small_scenario(*sections, f"expect: {{it: {{{block}}}}}")
        return list(run_test(Loaded(scenario, Roster.of(scenario), "test", None, {}), "it").differences)

    return play
