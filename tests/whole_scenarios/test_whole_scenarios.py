"""Generated scenarios: refused with a message, or read, drawn, judged and played; never an internal error.

A failure prints the scenario. ``python -m tests.whole_scenarios --seeds 0..1000`` searches on, for as long as you like.
"""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from tests.whole_scenarios.changing import changed, shipped
from tests.whole_scenarios.promises import FILE, check_all, look_at
from tests.whole_scenarios.wholes import made_up, without_what_is_refused

MADE_UP, CHANGED = 5, 24
MADE_UP_BY_NIGHT, CHANGED_BY_NIGHT, BY_COMMAND_BY_NIGHT = 1500, 3000, 20
AT_ONCE = 50


@pytest.mark.parametrize("seed", range(MADE_UP))
def test_a_made_up_scenario_is_refused_in_words_or_played(tmp_path: Path, seed: int) -> None:
    check_all(made_up(seed), tmp_path, seed, mend=True, play=seed % 4 == 0)


@pytest.mark.parametrize("first", range(0, CHANGED, 12))
def test_a_shipped_scenario_with_a_slip_is_refused_in_words_or_played(tmp_path: Path, first: int) -> None:
    for seed in range(first, first + 12):
        check_all(changed(seed), tmp_path, seed, play=seed % 12 == 0)


def test_most_made_up_scenarios_are_taken_with_most_of_what_is_in_them() -> None:
    """A generator of which everything is refused would promise nothing."""
    left = [without_what_is_refused(made_up(seed)) for seed in range(16)]
    taken = [loaded.scenario for _, loaded in filter(None, left)]
    assert len(taken) >= 10
    assert sum(len(scenario.rules) for scenario in taken) >= 2 * len(taken)
    assert sum(bool(scenario.expect) for scenario in taken) >= 2


def test_changes_are_not_all_refused() -> None:
    taken = sum(look_at(changed(seed)) is not None for seed in range(40))
    assert 5 <= taken <= 33
    assert len(shipped()) > 100


@pytest.mark.nightly
@pytest.mark.parametrize("first", range(1000, 1000 + MADE_UP_BY_NIGHT, AT_ONCE))
def test_many_made_up_scenarios(tmp_path: Path, first: int) -> None:
    for seed in range(first, first + AT_ONCE):
        check_all(made_up(seed), tmp_path, seed, mend=True, play=seed % 3 == 0)


@pytest.mark.nightly
@pytest.mark.parametrize("first", range(1000, 1000 + CHANGED_BY_NIGHT, AT_ONCE))
def test_many_slips(tmp_path: Path, first: int) -> None:
    for seed in range(first, first + AT_ONCE):
        check_all(changed(seed), tmp_path, seed, play=seed % 4 == 0)


@pytest.mark.nightly
@pytest.mark.parametrize("seed", range(5000, 5000 + BY_COMMAND_BY_NIGHT))
def test_the_commands_give_the_same_result(tmp_path: Path, seed: int) -> None:
    """A refused scenario exits with 2 and a position; an accepted one is drawn, described and tested. Never 3, nor a traceback."""
    text = made_up(seed) if seed % 2 else changed(seed)
    loaded = look_at(text)
    (tmp_path / FILE).write_text(text, encoding="utf-8", errors="surrogatepass", newline="")
    for command in (
        ["validate"],
        ["validate", "--strict"],
        ["draw"],
        ["sheet"],
        ["test"],
        ["run", "--quiet", "--set=match.half_s=1"],
    ):
        if command[0] == "run" and seed % 5:
            continue
        word, *options = command
        done = subprocess.run(
            [sys.executable, "-m", "rcj_challenges", word, FILE, *options],
            cwd=tmp_path,
            capture_output=True,
            timeout=300,
            check=False,
        )
        said = done.stderr.decode("utf-8", "replace")
        report = f"{' '.join(command)} exited with {done.returncode}: {said}\n--- {FILE}: ---\n{text}"
        assert "Traceback" not in said, report
        if loaded is None:
            assert done.returncode == 2, report
            assert said.startswith((f"{FILE}:", f"{word}: ", "soccersim", "match")) or FILE in said, report
        elif word == "run":
            assert done.returncode in (0, 2), report  # no team may have a program for its robots
        else:
            assert done.returncode in ((0, 1) if "--strict" in command or word == "test" else (0,)), report
