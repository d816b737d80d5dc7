"""What the process of a match reports decides whether this computer can play others."""

import pytest

from rcj_challenges.match import batch
from rcj_challenges.tournament.executor import LocalExecutor
from rcj_challenges.tournament.jobs import MatchJob, Workplace


@pytest.mark.parametrize(("code", "is_host_error"), [("host-too-busy", False), ("disk-full", True)])
@pytest.mark.parametrize("complaint", ["error[host-too-busy]: it waited", "error[disk-full]: no room"])
def test_a_match_for_which_the_computer_was_too_busy_says_nothing_about_the_next(
    tmp_path, monkeypatch, code, is_host_error, complaint
):
    fails = f'import sys; print(\'{{"code": "{code}"}}\'); sys.stderr.write({complaint!r}); sys.exit(2)'
    monkeypatch.setattr(batch, "_START", fails)
    with LocalExecutor(Workplace(tmp_path), 1) as executor:
        executor.submit(MatchJob("0" * 64, {}, {}, 1, {}))
        while not (outcomes := executor.poll()):
            pass
    assert [outcome.is_host_error for outcome in outcomes] == [is_host_error]
