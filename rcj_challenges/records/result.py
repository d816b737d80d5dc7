"""``result.json``: the inputs of a run, its outcome, and the kind of machine."""

from __future__ import annotations

import platform
from collections.abc import Mapping
from functools import cache
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import Annotated, Any

from pydantic import BaseModel, ConfigDict, Field, ValidationError

from rcj_challenges.core.amounts import Score
from rcj_challenges.records.codes import RECORD_UNREADABLE
from rcj_challenges.records.errors import COPY_AGAIN, RecordError
from rcj_challenges.records.folder import RESULT, check_version, read_file
from rcj_challenges.records.lines import parsed

_PACKAGES = {"rcj_challenges": "rcj-challenges", "mujoco": "mujoco", "numpy": "numpy"}


class Part(BaseModel):
    """A part of a file of results or of a report."""

    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False)


def described(text: str, **bounds: Any) -> Any:
    """Return a field with its description."""
    return Field(description=text, **bounds)


Half = Annotated[int, described("half of the match, from 1", ge=1)]
Tick = Annotated[int, described("tick of the half: 0.032 s each", ge=0)]


class MemberResult(Part):
    """One of the teams of a SuperTeam."""

    name: str = described("name of the team")
    programs: str = described("SHA-256 of the files of its programs, hexadecimal")


class EntrantResult(Part):
    """A team, by the name of its seat in the first half."""

    name: str = described("name of the team")
    programs: str = described(
        "SHA-256 of the files of its programs, hexadecimal; for a SuperTeam, over those of its members"
    )
    members: list[MemberResult] = described(
        "for a SuperTeam: the team of each robot, in the order of the entrant's robots; otherwise empty", default=[]
    )


class HalfResult(Part):
    """One half."""

    half: Half
    sides: dict[str, str] = described("by seat: the team that played there")
    score: dict[str, Score] = described("by team: points of the match when this half was over")
    ticks: int = described("number of ticks that were judged", ge=0)
    ended: str | None = described(
        "the reason of the rule that ended it, or the match with it; null: its time was up, or it is not complete"
    )
    complete: bool = described("whether it was played to its end", default=True)


class RankResult(Part):
    """A team's place by the criteria of the scenario."""

    place: int = described("1 for the best; teams that are equal by all criteria share a place", ge=1)
    team: str = described("the team")
    values: list[Score | None] = described("what was compared, in the order of the scenario's result.rank; null: none")


class EventResult(Part):
    """One event, as in the reflog, with its half and tick."""

    half: Half
    tick: Tick
    matchtime: float = described("simulated time in this half in s", ge=0)
    event: str = described("its name")
    payload: dict[str, Any] = described("its payload")


class FaultResult(Part):
    """A program that failed; its robot stood still until the end of the half."""

    robot: str = described("name of the robot")
    team: str | None = described("the team whose program it was")
    half: Half
    tick: Tick
    kind: str = described("crash, exit, start, start_timeout, step_timeout, half_timeout, memory, protocol, …")
    detail: str = described("one line for the team")
    traceback: str = described("the program's own traceback, if there is one")
    timed: bool = described("whether it reached a limit of time, which may differ from run to run", default=False)


class HintResult(Part):
    """Advice on programs that failed or made mistakes, and on robots that did not move."""

    robots: list[str] = described("names of the robots whose programs it is about")
    help: str = described("what to do, in the words of `check`")


class Versions(Part):
    """Versions that affect the bits of a result: digests are comparable if all but Python's number are equal."""

    rcj_challenges: str = described("version of this package")
    python: str = described("implementation and version of Python")
    mujoco: str = described("version of MuJoCo")
    numpy: str = described("version of numpy")
    system: str = described("operating system")
    machine: str = described("architecture of the processor")


class RunResult(Part):
    """The whole file. It exists from the first tick on, with ``complete: false``."""

    record: int = described("version of the record's format", ge=1)
    complete: bool = described("whether the run was played to its end and its record closed")
    stopped: str | None = described("why a run stopped before its end; null: it did not, or the reason is unknown")
    scenario: str = described("id of the scenario, which is in scenario.json")
    title: str = described("title of the scenario")
    started: str = described("wall clock time at the start of the run, in UTC")
    seed: int = described("seed of all random choices")
    match_id: int = described("number of the match, as in MATCH_START")
    entrants: dict[str, EntrantResult] = described("the teams, by their seat of the first half")
    score: dict[str, Score] = described("points by team")
    ranking: list[RankResult] = described("the teams, best first; empty while it is not complete", default=[])
    halves: list[HalfResult] = described("the halves that are over, and one that was interrupted")
    events: list[EventResult] = described("all events, in order")
    faults: list[FaultResult] = described("programs that failed, in order")
    inputs: str = described("SHA-256 of what was played: scenario without defaults, seed, programs")
    states: str = described(
        "SHA-256 of what happened: states of all ticks, and events; empty while the run is not complete"
    )
    digest: str = described("SHA-256 over `inputs` and `states`; empty while the run is not complete")
    simulated_s: float = described("simulated time of all halves in s", ge=0)
    wall_s: float = described(
        "wall time of the match in s, without waits before ticks for the steering of a live view (pauses, "
        "single steps, a slower speed)",
        ge=0,
    )
    start_up_s: float = Field(
        default=0.0,
        ge=0,
        description="part of `wall_s` until all programs of the first half had called `step` for the first time: "
        "loading the physics, compiling the world, starting the processes; 0 if unknown",
    )
    real_time_factor: float = described("simulated_s divided by wall_s", ge=0)
    versions: Versions
    sandbox: dict[str, Any] = described("how programs were isolated: request, active layers, dropped ones and why")
    marks: list[str] = described("what makes this run special, such as debug: it does not count as a fair match")
    hints: list[HintResult] = Field(
        default=[],
        exclude=True,  # advice is not part of the result, and later versions may improve it
        description="what to do about programs that crashed, ended or made mistakes, if their output and source show "
        "it (for example another form of the referee's packets); only in the output of `run --json`, and as a line at "
        "the end of each such robot's log",
    )
    folder: str = Field(
        default="",
        exclude=True,  # no file holds a path
        description="the record's folder, relative to `--out`; only in the output of `run --json`, because "
        "`result.json` is in it",
    )


def versions() -> Versions:
    """Return the platform of this run, without host, user and paths."""
    return Versions(
        **{key: _package_version(package) for key, package in _PACKAGES.items()},
        python=f"{platform.python_implementation()} {platform.python_version()}",
        system=platform.system(),
        machine=platform.machine(),
    )


def deciding(versions: Mapping[str, str]) -> dict[str, str]:
    """Return the versions that decide the bits of a result: of Python only the implementation."""
    return {**versions, "python": versions["python"].partition(" ")[0]} if "python" in versions else dict(versions)


@cache
def _package_version(package: str) -> str:
    """Return the installed versions, cached for this process because reading them takes 3 ms."""
    try:
        return version(package)
    except PackageNotFoundError:
        return "unknown"


def read_result(folder: Path) -> RunResult:
    """Read the result of a run, finished or not.

    Raises:
        RecordError: there is none, it is damaged, or it was written by a newer version.
    """
    try:
        data = parsed(read_file(folder / RESULT))
    except ValueError as error:
        raise RecordError(RECORD_UNREADABLE, f"{folder.name}: {RESULT} cannot be read: {error}", COPY_AGAIN) from error
    record = data.get("record") if isinstance(data, dict) else None
    if type(record) is int:
        check_version(record, folder.name)
    try:
        return RunResult.model_validate(data)
    except ValidationError as error:
        first = error.errors()[0]
        where = ".".join(map(str, first["loc"])) or "the file"
        raise RecordError.damaged(f"{folder.name}: {RESULT} is damaged: {where}: {first['msg']}") from error


_TIME_FAULTS = frozenset({"start_timeout", "step_timeout", "half_timeout"})


def has_time_fault(result: Mapping[str, Any]) -> bool:
    """Return whether a time limit decided something in a run, so that another computer may have gone on."""
    return any(fault.get("timed") or fault["kind"] in _TIME_FAULTS for fault in result["faults"])
