"""What is told of an attribute that is used before it is set: a check says where it is, and what is missing."""

from __future__ import annotations

from pathlib import PurePosixPath

import pytest

from rcj_challenges.checker.advice.slips import on_slip

PLAYER = PurePosixPath("player.py")
UNSET = "AttributeError: '{}' object has no attribute 'best' (player.py, line 9)"
LATE = b"""class Player:
    def __init__(self):
        self.n = 0

    def play(self):
        # self.best = 3.0
        if self.n == 10: self.best: float = 3.0
        self.n += 1
        return self.best
"""


def test_the_line_that_sets_it_is_named() -> None:
    assert on_slip(UNSET.format("Player"), {PLAYER: LATE}) == (
        'line 7 of player.py sets "best", and the program had not come there yet: give it a first value at the '
        "beginning of __init__ of Player"
    )


SOON = LATE.replace(b"self.n = 0", b"self.n = 0; self.best = 3.0")
KEEPER = (
    b"from player import Player\nclass Keeper(Player):\n    def __init__(self, robot):\n        self.robot = robot\n"
)
HEIR = b"from player import Player\nclass Keeper(Player):\n    def look(self):\n        return self.best\n"


@pytest.mark.parametrize(
    ("player", "keeper", "told"),
    [
        (
            SOON,
            KEEPER,
            'line 3 of player.py, in Player, sets "best": call super().__init__() at the beginning of __init__ of Keeper',
        ),
        (LATE, KEEPER, "first value at the beginning of __init__ of Keeper"),
        (LATE, HEIR, "first value at the beginning of __init__ of Player"),
        (SOON, HEIR, "first value at the beginning of __init__ of Player"),
    ],
    ids=[
        "init of the base was not called",
        "init would not set it",
        "no init of its own",
        "its base calls it too early",
    ],
)
def test_of_a_class_whose_base_sets_it_the_init_is_named_that_can_help(player: bytes, keeper: bytes, told: str) -> None:
    found = on_slip(UNSET.format("Keeper"), {PLAYER: player, PurePosixPath("keeper.py"): keeper})
    assert told in found
    assert ("super()" in found) == ("super()" in told)


def test_nothing_is_said_where_nothing_sets_it_or_something_else_does() -> None:
    assert on_slip(UNSET.format("Player"), {PLAYER: LATE.replace(b"self.best: float =", b"best =")}) == ""
    assert on_slip(UNSET.format("Player"), {PLAYER: LATE.replace(b"self.best: float =", b"self.best ==")}) == ""
    assert on_slip(UNSET.format("Motor"), {PLAYER: LATE}) == ""
    beside = LATE.replace(b"self.best: float =", b"best =") + b"def prepare(self):\n    self.best = 3.0\n"
    assert on_slip(UNSET.format("Player"), {PLAYER: beside}) == ""
    guessed = "AttributeError: 'Player' object has no attribute 'best'. Did you mean: 'rest'? (player.py, line 9)"
    assert on_slip(guessed, {PLAYER: LATE}) == ""


def test_a_member_that_an_enum_has_not_is_told_as_such_where_there_are_enums() -> None:
    detail = "AttributeError: ATTACK (player.py, line 9)"  # all that Python says up to 3.11
    for line in (b"from enum import Enum\n", b"import enum\n", b"from enum import IntEnum, Enum, auto\n"):
        assert on_slip(detail, {PLAYER: line}).startswith("the Enum has no such name")
    assert on_slip(detail, {PLAYER: LATE}) == ""
