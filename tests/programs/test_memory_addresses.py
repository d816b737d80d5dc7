"""A program's memory lies at the same addresses in every run: what depends on them repeats (Linux)."""

from __future__ import annotations

import threading
from pathlib import Path

import pytest
from fake_match import FakeMatch

from rcj_challenges.programs import memory_addresses


def _can_be_fixed() -> bool:
    with memory_addresses.fixed():
        present = memory_addresses._personality(memory_addresses._ASK)
    return present >= 0 and present & memory_addresses._NOT_AT_RANDOM != 0


pytestmark = pytest.mark.skipif(not _can_be_fixed(), reason="this system gives addresses at random only")

_PROGRAM = """
from controller import Robot
robot = Robot()
class Place:
    def __init__(self, number):
        self.number = number
places = [Place(number) for number in range(3000)]
print([place.number for place in set(places)][:20], hash(None), hash(print), id(places))
robot.step(32)
robot.step(32)
"""


def _said(folder: Path, times: int) -> list[str]:
    return ["".join(FakeMatch(folder / str(run)).play(_PROGRAM, 1).said) for run in range(times)]


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    for run in range(4):
        (tmp_path / str(run)).mkdir()
    return tmp_path


def test_a_set_of_a_programs_own_objects_is_gone_through_in_the_same_order_in_every_run(folder: Path) -> None:
    assert len(set(_said(folder, 4))) == 1


def test_the_match_itself_keeps_its_random_addresses() -> None:
    def present() -> int:
        return memory_addresses._personality(memory_addresses._ASK)

    before, seen = present(), []
    with memory_addresses.fixed():
        other = threading.Thread(target=lambda: seen.append(present()))
        seen.append(present())
    other.start()
    other.join()
    assert present() == before
    assert seen == [before | memory_addresses._NOT_AT_RANDOM, before]


def test_where_it_is_refused_programs_start_all_the_same(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(memory_addresses, "_personality", lambda _: -1)
    (said,) = _said(folder, 1)
    assert said.startswith("[")
    assert not _can_be_fixed()
