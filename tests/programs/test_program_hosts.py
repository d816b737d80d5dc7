"""What this computer lacks while programs run: no fault of theirs, unless one of them has taken it all."""

from __future__ import annotations

import errno
import os
import tempfile
from pathlib import Path

import pytest
from fake_match import FakeMatch, fault_of, robot_spec, values_at

from rcj_challenges.programs import processes, scratch
from rcj_challenges.core.errors import HostError
from rcj_challenges.core.traffic import Observation, Request


def test_a_temporary_folder_that_cannot_be_used_is_no_programs_fault(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    match = FakeMatch(tmp_path)
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path / "gone"))
    with pytest.raises(HostError) as raised:
        match.play("pass\n")
    assert str(raised.value).startswith(f"the temporary folder {tmp_path / 'gone'} cannot be used: ")


def test_a_process_that_cannot_be_started_is_a_fault_of_that_program_only(
    match: FakeMatch, monkeypatch: pytest.MonkeyPatch
) -> None:
    def refuse(*_: object, **__: object) -> None:
        raise OSError(7, "Argument list too long", "/home/somebody/python")

    monkeypatch.setattr(processes, "start", refuse)
    fault = fault_of(match, "faults/never_steps")
    assert (fault.kind, fault.tick) == ("start", 0)
    assert fault.detail == "the program could not be started: Argument list too long"  # and no path


@pytest.mark.parametrize("number", [errno.ENOMEM, errno.ENOSPC, errno.EMFILE])
def test_what_this_computer_lacks_is_no_fault_of_a_program(
    match: FakeMatch, monkeypatch: pytest.MonkeyPatch, number: int
) -> None:
    def refuse(*_: object, **__: object) -> None:
        raise OSError(number, "it is lacking")

    monkeypatch.setattr(processes, "start", refuse)
    with pytest.raises(HostError, match="the program of Y1 cannot be started here: it is lacking"):
        fault_of(match, "faults/never_steps")


@pytest.mark.parametrize("code", [14, 39, 1450, 1455])
def test_windows_reports_what_this_computer_lacks_in_numbers_of_its_own(
    match: FakeMatch, monkeypatch: pytest.MonkeyPatch, code: int
) -> None:
    """Such as 1455, "the paging file is too small": their ``errno`` is only EINVAL."""
    error = OSError(errno.EINVAL, "it is lacking")
    error.winerror = code  # type: ignore[attr-defined, unused-ignore]

    def refuse(*_: object, **__: object) -> None:
        raise error

    monkeypatch.setattr(processes, "start", refuse)
    with pytest.raises(HostError, match="the program of Y1 cannot be started here: it is lacking"):
        fault_of(match, "faults/never_steps")


FINDS_NO_ROOM = """
from controller import Robot
Robot().step(32)
try:
    raise OSError(28, "No space left on device")  # as of a write
except OSError as error:
    raise ValueError("my notes") from error
"""


@pytest.fixture
def _full(monkeypatch: pytest.MonkeyPatch) -> None:
    """The temporary folder is full, and one has filled it that has written more than 100 kB."""

    def full(_: Path) -> None:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr(scratch, "ensure_room", full)
    monkeypatch.setattr(scratch, "share_bytes", lambda *_: 100_000)


@pytest.mark.usefixtures("_full")
def test_a_temporary_folder_without_room_is_no_fault_of_a_program(match: FakeMatch) -> None:
    with pytest.raises(HostError) as raised:
        match.play(FINDS_NO_ROOM, 3)
    assert raised.value.code == "disk-full"
    assert tempfile.gettempdir() in str(raised.value)
    assert "Y1" not in str(raised.value), "no team is to blame"


WRITES_MUCH = """
from controller import Robot
with open("much", "wb") as file:
    file.write(bytes(200_000))
robot = Robot()
while robot.step(32) != -1:
    pass
"""


@pytest.mark.usefixtures("_full")
def test_the_program_that_filled_the_temporary_folder_is_ended_and_the_match_goes_on(match: FakeMatch) -> None:
    with match.pool() as pool:
        programs = {}
        for name, program in (("Y1", WRITES_MUCH), ("B1", FINDS_NO_ROOM)):
            team = match.team(program)
            programs[name] = pool.add(robot_spec(name), team, team.single)
        pool.launch()
        greedy, poor = programs.values()
        assert isinstance(greedy.collect(), Request)
        poor.collect()
        poor.release(Observation(1, values_at(1), []))
        fault = poor.collect()
        assert (fault.robot, fault.kind) == ("B1", "crash")
        assert fault.detail.endswith("; the temporary folder was full of what Y1 had written")
        # Its fault is reported when its turn comes, or when its absence is noticed.
        greedy.release(Observation(1, values_at(1), []))
        assert greedy.collect() is greedy.limit_fault(1)
        assert (greedy.fault.kind, greedy.fault.detail) == (
            "output_flood",
            "the program wrote more than its share, 0.1 MB, until the temporary folder was full",
        )
        assert not any(path.is_dir() for path in pool._folders.place.iterdir()), "the room is there again"


def test_a_program_that_only_claims_that_there_is_no_room_has_crashed(match: FakeMatch) -> None:
    assert fault_of(match, FINDS_NO_ROOM).kind == "crash"
