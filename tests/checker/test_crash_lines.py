"""The line of a team's program that a crash names, whatever system and editor its file comes from."""

from pathlib import PurePosixPath

import pytest

from rcj_challenges.checker.advice.crash_lines import CrashLine, crash_line, text_of

ROBOT = PurePosixPath("team/robot.py")


def named(place: str, content: bytes) -> CrashLine | None:
    return crash_line(f"NameError: name 'x' is not defined ({place})", {ROBOT: content})


@pytest.mark.parametrize("ends", [b"\n", b"\r\n", b"\r"])
@pytest.mark.parametrize(("number", "code"), [(1, "one()"), (2, "two()"), (3, "three()")])
def test_each_line_is_found_from_the_first_to_the_last(number: int, code: str, ends: bytes) -> None:
    assert named(f"team/robot.py, line {number}", ends.join([b"one()", b"two()", b"three()"])) == (
        CrashLine(ROBOT, number, code)
    )


def test_a_place_as_windows_writes_it_is_the_same() -> None:
    assert named("team\\robot.py, line 1", b"one()") == CrashLine(ROBOT, 1, "one()")


@pytest.mark.parametrize(
    "place", ["team/robot.py, line 0", "team/robot.py, line 2", "robot.py, line 1", "team/robot.py"]
)
def test_what_is_no_line_of_the_team_is_none(place: str) -> None:
    assert named(place, b"one()\n") is None


def test_of_a_line_without_end_the_beginning_is_looked_at_and_of_what_is_no_text_what_is() -> None:
    line = named("team/robot.py, line 1", b"x" * 1_000_000)
    assert line is not None
    assert len(line.code) == 500
    assert named("team/robot.py, line 1", b"x = '\xff'") == CrashLine(ROBOT, 1, "x = '\N{REPLACEMENT CHARACTER}'")


def test_a_program_is_read_with_the_line_ends_of_unix() -> None:
    assert text_of(b"a\r\nb\rc\n") == "a\nb\nc\n"
