"""Equal runs have equal digests; whatever decides a result changes it, and nothing else does."""

from pathlib import Path

import pytest

from rcj_challenges.facts.play import Event
from rcj_challenges.records.digest import Digest
from rcj_challenges.records.result import read_result
from rcj_challenges.records.testing import write_made_up_run

_INPUTS = ({"id": "match", "rules": {"a": 1, "b": 2}}, 7, {"blue": "00", "yellow": "11"})
_GOAL = Event(5, "GOAL", {"team_name": "Hanse"})


def _digest(scenario: dict, seed: int, programs: dict, states: list[bytes], events: list[Event]) -> str:
    digest = Digest(scenario, seed, programs)
    digest.half(1)
    for state in states:
        digest.state(state)
    for event in events:
        digest.event(event)
    return digest.hexdigest()


def test_the_same_run_has_the_same_digest_whenever_it_is_played(tmp_path: Path) -> None:
    digests = {read_result(write_made_up_run(tmp_path, ticks=60)).digest for _ in range(2)}
    assert len(digests) == 1
    assert len(digests.pop()) == 64


def test_the_digest_of_a_fixed_input_never_changes_without_a_new_version() -> None:
    found = _digest(*_INPUTS, [b"12345678", b"abcdefgh"], [_GOAL])
    assert found == "d8c769a0a8edb90aedfb64231e4200875535055187b27c8124b8ce12e04b9973"


@pytest.mark.parametrize(
    ("change", "what"),
    [
        ({"scenario": {"id": "match", "rules": {"b": 2, "a": 1}}}, "the order of rules"),
        ({"seed": 8}, "the seed"),
        ({"programs": {"blue": "11", "yellow": "00"}}, "who plays where"),
        ({"states": [b"12345678abcdefgh"]}, "how states are cut into ticks"),
        ({"states": [b"12345678", b"abcdefgi"]}, "one bit of a state"),
        ({"events": []}, "a missing event"),
        ({"events": [Event(6, "GOAL", {"team_name": "Hanse"})]}, "the tick of an event"),
        ({"events": [Event(5, "GOAL", {"team_name": "Alster"})]}, "the payload of an event"),
    ],
)
def test_what_decides_a_result_changes_the_digest(change: dict, what: str) -> None:
    scenario, seed, programs = _INPUTS
    inputs = {
        "scenario": scenario,
        "seed": seed,
        "programs": programs,
        "states": [b"12345678", b"abcdefgh"],
        "events": [_GOAL],
    }
    assert _digest(**inputs) != _digest(**(inputs | change)), what


def test_a_programs_own_words_are_no_part_of_the_digest() -> None:
    def with_detail(detail: str) -> str:
        fault = Event(5, "PROGRAM_FAULT", {"robot_name": "Y1", "kind": "crash", "detail": detail})
        return _digest(*_INPUTS, [], [fault])

    assert with_detail("at 0x7f00") == with_detail("at 0x7fff")


def test_a_long_run_is_hashed_as_it_goes_and_state_may_change_its_length() -> None:
    once, twice = Digest(*_INPUTS), Digest(*_INPUTS)
    for number in range(5000):
        once.state(bytes([number % 256]) * (8 + number % 2))
    for number in range(5000):
        twice.state(bytes([number % 256]) * (8 + number % 2))
        if number % 1000 == 0:
            twice.hexdigest()
    assert once.hexdigest() == twice.hexdigest()
