"""Plays hostile programs in real matches, and compares everything with matches in which they do nothing.

Each file in ``programs`` begins with what it is, as TOML behind ``#:``::

    #: about = "processes and system"
    #: tries = "to start processes without end"
    #: holds = "starting a process is refused"
    #: layers = ["system_calls"]
    #: platforms = ["linux"]
    #: tick = 10
    #: ends = "plays on"
    #: said = ["refused: fork"]

See `Entry` for the keys. Up to three of them play in one match, each in a robot and a process of its own, against a
sane team; so a match with three of them shows as well that they do not disturb each other.
"""

from __future__ import annotations

import functools
import json
import os
import re
import shutil
import stat
import sys
import tempfile
import threading
import time
import tomllib
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass, fields
from pathlib import Path
from typing import Any

import numpy as np

from rcj_challenges.programs.isolation import LAYERS, active_layers
from rcj_challenges.submissions.team import Team, open_team
from rcj_challenges.match.runner import MatchPlan, play_match
from rcj_challenges.records.trajectory import Trajectory
from rcj_challenges.scenario.load import Loaded, load

HERE = Path(__file__).parent
PROGRAMS = HERE / "programs"
MARK = "rcj-hostile"
"""In the name of every file that a program tries to leave behind."""

PLAN_OF_THE_OTHERS = "the sane team attacks on the left at 1947"
"""Stands in a file of the sane team, and nowhere in a hostile program."""

PLATFORMS = ("linux", "darwin", "win32")
GROUPS = ("time", "endings", "output", "memory and files", "processes and system", "protocol", "module")
PLAYS_ON = "plays on"
_END = re.compile(r"(?P<kinds>[a-z_|]+)( at (?P<tick>\d+))?$")
_HEADER = "#: "
_ROBOTS = ("Y1", "Y2", "Y3")
_SANE = ("B1", "B2")  # two that talk to each other; a third one would only start one more process a match
_HALF_S = 2.1
_LIMITS = {"start_s": 30.0, "step_s": 10.0, "half_s": 60.0}
_SHORT_STEP_S = 0.5  # where a program is to exceed it: on a busy machine others do so by mere bad luck
_MAX_S = 60.0
_PATIENCE_S = 5.0
_MAX_OF_THE_MATCH = 150_000  # letters in a log beside what a program may print
_MAX_TOLD, _MAX_TRACED = 1_000, 20_000  # letters of a fault's detail and traceback


@dataclass(frozen=True)
class Entry:
    """One hostile or broken program.

    Attributes:
        name: of its file.
        about: the group that it is shown in, one of `GROUPS`.
        tries: what it attempts, as the end of "a program that tries …".
        holds: what keeps it from succeeding, one sentence.
        tick: from which its wheels stand; it sets speed 0 there, or dies.
        ends: ``plays on``, or the fault and its tick: ``step_timeout at 10``; without a tick where that depends on
            real time, with several kinds (``exit|crash``) where the program cannot know.
        layers: of isolation, without one of which it is not held.
        platforms: on which it can be tried.
        said: regular expressions, each of which is found in its log.
        cause: a regular expression for the fault's detail.
        limits: of the scenario, where it needs other ones than the rest.
        succeeds_without: True: with ``--sandbox off`` it does get through, and doing so harms nobody.
        variant: True: it does what another one does in another way; played every night.
    """

    name: str
    about: str
    tries: str
    holds: str
    tick: int
    ends: str
    layers: tuple[str, ...] = ()
    platforms: tuple[str, ...] = PLATFORMS
    said: tuple[str, ...] = ()
    cause: str = ""
    limits: tuple[tuple[str, float], ...] = ()
    succeeds_without: bool = False
    variant: bool = False

    @property
    def plays_on(self) -> bool:
        """Whether it stays to the end."""
        return self.ends == PLAYS_ON

    def is_its_end(self, fault: Mapping[str, Any] | None) -> bool:
        """Return whether a fault, or none, is the end that the header tells."""
        if fault is None or self.plays_on:
            return fault is None and self.plays_on
        found = _END.match(self.ends)
        assert found is not None, self.ends
        return fault["kind"] in found["kinds"].split("|") and found["tick"] in (None, str(fault["tick"]))

    @property
    def source(self) -> Path:
        """Its file."""
        return PROGRAMS / f"{self.name}.py"

    def not_here(self) -> str | None:
        """Return why it cannot be held, or tried, here; None if it can."""
        if sys.platform not in self.platforms:
            return f"not on {sys.platform}: {', '.join(self.platforms)} only"
        missing = [layer for layer in self.layers if layer not in active_layers("auto")]
        return f"needs layers that cannot be had here: {', '.join(missing)}" if missing else None


def read_entry(path: Path) -> Entry:
    """Read the header of a program.

    Raises:
        ValueError: it is not as `Entry` describes.
    """
    lines = path.read_text(encoding="utf-8").splitlines()
    header = "\n".join(line.removeprefix(_HEADER) for line in lines if line.startswith(_HEADER))
    try:
        told = tomllib.loads(header)
    except tomllib.TOMLDecodeError as error:
        raise ValueError(f"{path.name}: {error}") from error
    unknown = set(told) - {field.name for field in fields(Entry)} | ({"name"} & set(told))
    if unknown:
        raise ValueError(f"{path.name}: unknown: {', '.join(sorted(unknown))}")
    for key in ("layers", "platforms", "said"):
        if key in told:
            told[key] = tuple(told[key])
    short = {"step_s": _SHORT_STEP_S} if "step_timeout" in told.get("ends", "") else {}
    told["limits"] = tuple(sorted({**short, **told.get("limits", {})}.items()))
    entry = Entry(name=path.stem, **told)
    if entry.plays_on and not entry.said:
        raise ValueError(f"{path.name}: a program that plays on has to say that it tried")
    if not entry.plays_on and not _END.match(entry.ends):
        raise ValueError(f"{path.name}: ends: expected '{PLAYS_ON}' or 'kind at tick', found {entry.ends!r}")
    if set(entry.layers) - set(LAYERS) or set(entry.platforms) - set(PLATFORMS) or entry.about not in GROUPS:
        raise ValueError(f"{path.name}: unknown layer, platform or group")
    return entry


@functools.cache
def entries() -> tuple[Entry, ...]:
    """Return the whole corpus, by name."""
    return tuple(read_entry(path) for path in sorted(PROGRAMS.glob("*.py")))


def batches(chosen: Iterable[Entry]) -> list[tuple[Entry, ...]]:
    """Return groups of up to three that can play in one match: same tick, same limits."""
    alike: dict[tuple[Any, ...], list[Entry]] = {}
    for entry in chosen:
        alike.setdefault((entry.tick, entry.limits), []).append(entry)
    return [tuple(group[at : at + 3]) for group in alike.values() for at in range(0, len(group), 3)]


@dataclass(frozen=True)
class Played:
    """A match that is over, as far as it is compared.

    Attributes:
        poses: of all entities, in all sub-steps of all ticks.
        result: as in ``result.json``.
        events: of the reflog, without the moment at which they were written.
        logs: text by robot.
        files: names in the record's folder.
        wall_s: how long it took.
    """

    poses: np.ndarray
    result: dict[str, Any]
    events: list[dict[str, Any]]
    logs: dict[str, str]
    files: set[str]
    wall_s: float

    def events_but_faults(self) -> list[dict[str, Any]]:
        """Return what the reflog holds apart from programs that failed."""
        return [event for event in self.events if event["event"] != "PROGRAM_FAULT"]


def play(
    programs: Sequence[Path], tick: int, folder: Path, limits: Sequence[tuple[str, float]] = (), sandbox: str = "auto"
) -> Played:
    """Play a short match of these programs (yellow) against the sane team (blue).

    Args:
        programs: up to three.
        tick: robots without a program of their own set speed 0 at this tick and stay.
        folder: new; the record and the teams are in it.
        limits: differing from those of all these matches.
        sandbox: of the match.
    """
    loaded = _scenario(tuple(limits))
    seats = tuple(loaded.scenario.entrants.values())
    folder.mkdir()
    stays = folder / "stays.py"
    stays.write_text(f"import arena\n\narena.drive({tick})\narena.play_on()\n", encoding="utf-8")
    teams = {
        "blue": _opened(folder / "sane", [HERE / "sane.py"] * 3, seats),
        "yellow": _opened(folder / "hostile", [*programs, *[stays] * 3][:3], seats),
    }
    began = time.perf_counter()
    outcome = play_match(MatchPlan(loaded, teams, {}, seed=1, out=folder / "runs", sandbox=sandbox))
    wall_s = time.perf_counter() - began
    record = outcome.folder
    logs = record / "logs"
    lines = (record / "reflog.jsonl").read_text("utf-8").splitlines()
    return Played(
        poses=np.array([snapshot.substeps for snapshot in Trajectory.open(record).halves[0].snapshots()]),
        result=outcome.result,
        events=[{k: v for k, v in json.loads(line).items() if k != "datetime"} for line in lines],
        logs={path.stem: path.read_text("utf-8", "replace") for path in sorted(logs.iterdir())},
        files={path.relative_to(record).as_posix() for path in record.rglob("*")},
        wall_s=wall_s,
    )


@functools.cache
def _scenario(limits: tuple[tuple[str, float], ...]) -> Loaded:
    """Return the shipped match, shortened, with other limits."""
    settings = {**_LIMITS, **dict(limits)}
    told = [f"limits.{name}={value}" for name, value in settings.items()]
    two = ["match.swap_sides=false", "entrants.blue.robots.B3=null"]
    return load("match", ["match.halves=1", f"match.half_s={_HALF_S}", *two, *told])


def _opened(folder: Path, programs: Sequence[Path], seats: Sequence[Any]) -> Team:
    """Write a team whose robots run these programs, and open it."""
    for number, program in enumerate(programs, 1):
        entry = folder / f"robot{number}" / f"robot{number}.py"
        entry.parent.mkdir(parents=True)
        shutil.copyfile(program, entry)
    shutil.copyfile(HERE / "arena.py", folder / "arena.py")
    (folder / "team_name.txt").write_text(folder.name, encoding="utf-8")
    if folder.name == "sane":
        (folder / "plan.txt").write_text(PLAN_OF_THE_OTHERS, encoding="utf-8")
    return open_team(folder, *seats)


@functools.cache
def reference(tick: int) -> Played:
    """Return the match in which all three programs set speed 0 at ``tick`` and stay; played once."""
    with tempfile.TemporaryDirectory() as folder:
        return play([], tick, Path(folder) / "match")


@contextmanager
def nothing_is_left_behind(places: Path) -> Iterator[None]:
    """Assert that what runs inside leaves no file, process, thread or open file, and does not change this process.

    Args:
        places: a new folder; the temporary files of the match are there.
    """
    temporary = places / "temporary"
    temporary.mkdir()
    treasure = places / "treasure" / "folder"
    treasure.mkdir(parents=True)
    (treasure.parent / "keep.txt").write_text("kept", encoding="utf-8")
    treasure.chmod(0o755)
    kept, tempfile.tempdir = tempfile.tempdir, str(temporary)
    before = _state_of_this_process()
    try:
        yield
    finally:
        tempfile.tempdir = kept
    assert _state_of_this_process() == before
    assert [path.name for path in temporary.iterdir()] == [], "private folders are left"
    assert sorted(path.name for path in treasure.parent.iterdir()) == ["folder", "keep.txt"], "what was linked is gone"
    assert (treasure.parent / "keep.txt").read_text("utf-8") == "kept"
    assert sys.platform == "win32" or stat.S_IMODE(treasure.stat().st_mode) == 0o755
    assert lasting_marks(places) == set(), "files are left"
    assert processes_of(temporary) == [], "processes are left"


def _state_of_this_process() -> dict[str, Any]:
    """Return what a program could change in the process of the match."""
    state: dict[str, Any] = {
        "threads": sorted(thread.name for thread in threading.enumerate()),
        "folder": Path.cwd(),
        "environment": dict(os.environ),
    }
    if sys.platform == "linux":
        state["open files"] = dict(_open_files())
    if sys.platform != "win32":
        import resource

        limits = (resource.RLIMIT_CPU, resource.RLIMIT_AS, resource.RLIMIT_NOFILE, resource.RLIMIT_FSIZE)
        state["limits"] = [resource.getrlimit(kind) for kind in limits]
        state["niceness"] = os.getpriority(os.PRIO_PROCESS, 0)
        state["session"] = os.getsid(0), os.getpgid(0)
        state["host"] = os.uname().nodename
    if sys.platform == "linux":
        state["scheduler"] = os.sched_getscheduler(0), os.sched_getaffinity(0)
    return state


def _open_files() -> Iterator[tuple[int, str]]:
    """Yield the open files of this process by number (Linux), without that of the listing itself."""
    for descriptor in Path("/proc/self/fd").iterdir():
        with suppress(FileNotFoundError):
            yield int(descriptor.name), str(descriptor.readlink())


def lasting_marks(*more: Path) -> set[str]:
    """Return files with the mark that stay.

    Another match beside this one may be trying something without isolation, and removes it at once: on a busy machine
    that is some hundredths of a second later.
    """
    left, give_up = marked_files(*more), time.perf_counter() + _PATIENCE_S
    while left and time.perf_counter() < give_up:
        left &= marked_files(*more)
    return left


def marked_files(*more: Path) -> set[str]:
    """Return files with the mark in their name, in all places where a program could leave one."""
    found = []
    places = {
        *more,
        *(
            Path(place)
            for place in ("/", "/tmp", "/var/tmp", "/dev/shm", "/run", "/etc", "/var/lock", "/usr/lib", "/opt")
        ),
        Path.cwd(),
        Path.home(),
        HERE,
        PROGRAMS,
        Path(tempfile.gettempdir()),
        Path(sys.executable).parent,
        Path(os.__file__).parent,
        *(Path(entry) for entry in sys.path if entry),
    }
    for place in places:
        if place.is_dir():
            found += [entry.path for entry in os.scandir(place) if MARK in entry.name]
    for place in more:
        found += [str(path) for path in place.rglob(f"*{MARK}*")]
    return set(found)


def processes_of(temporary: Path) -> list[str]:
    """Return processes whose home is below a folder: programs, and all that they started (Linux)."""
    found = []
    if sys.platform != "linux":
        return found
    mark = f"HOME={temporary}".encode()
    for entry in Path("/proc").iterdir():
        if entry.name.isdigit():
            try:
                environment = (entry / "environ").read_bytes()
                state = (entry / "stat").read_text("utf-8").rpartition(")")[2].split()[0]
            except OSError:
                continue
            if mark in environment and state != "Z":
                found.append(f"{entry.name} {(entry / 'cmdline').read_bytes()!r}")
    return found


def assert_held(batch: Sequence[Entry], folder: Path) -> None:
    """Play a batch, and assert all that must hold for each of its programs and for everybody else."""
    sane = reference(batch[0].tick)
    with nothing_is_left_behind(folder):
        match = play([entry.source for entry in batch], batch[0].tick, folder / "match", batch[0].limits)
    assert match.wall_s < _MAX_S, f"the match took {match.wall_s:.1f} s"
    faults = {fault["robot"]: fault for fault in match.result["faults"]}
    for robot, entry in zip(_ROBOTS, batch, strict=False):
        _assert_its_end(entry, faults.pop(robot, None), match.logs[robot])
    assert faults == {}, "a program that did nothing wrong failed"
    assert match.result["complete"]
    np.testing.assert_array_equal(match.poses, sane.poses)
    assert match.events_but_faults() == sane.events_but_faults()
    for robot in _SANE:
        assert match.logs[robot] == sane.logs[robot], f"{robot} of the sane team saw something else"
    assert match.files == sane.files
    told = {event["payload"]["robot_name"] for event in match.events if event["event"] == "PROGRAM_FAULT"}
    assert told == {robot for robot, entry in zip(_ROBOTS, batch, strict=False) if not entry.plays_on}


def assert_gets_through(batch: Sequence[Entry], folder: Path) -> None:
    """Play a batch without isolation, and assert that what is tried does succeed there, and harms nobody."""
    with nothing_is_left_behind(folder):
        match = play([entry.source for entry in batch], batch[0].tick, folder / "match", batch[0].limits, "off")
    assert match.result["complete"]
    for robot, entry in zip(_ROBOTS, batch, strict=False):
        assert "BROKEN" in match.logs[robot], f"{entry.name}: {match.logs[robot][-3000:]}"


def _output_bytes(entry: Entry) -> float:
    return _scenario(entry.limits).scenario.limits.output_mb * 1e6


def _assert_its_end(entry: Entry, fault: dict[str, Any] | None, log: str) -> None:
    """Assert that a program ended, or played on, as its header says, and that the cause can be read."""
    told = f"{entry.name}: {fault}\n{log[-3000:]}"
    assert "BROKEN" not in log, told
    assert PLAN_OF_THE_OTHERS not in log, told
    assert len(log) <= _output_bytes(entry) + _MAX_OF_THE_MATCH, f"{entry.name}: a log of {len(log)} letters"
    assert entry.is_its_end(fault), told
    for pattern in entry.said:
        assert re.search(pattern, log), f"not said: {pattern}: {told}"
    if fault is not None:
        assert re.search(entry.cause, fault["detail"]), told
        assert len(fault["detail"]) <= _MAX_TOLD, told
        assert len(fault["traceback"]) <= _MAX_TRACED, told
        assert f"[{fault['kind']}] {fault['robot']} at tick {fault['tick']} " in log, told
