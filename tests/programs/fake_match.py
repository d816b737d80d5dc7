"""A match without physics: enough of one to play a real program in a real process, tick by tick."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from pathlib import Path

from rcj_challenges.programs.program import Program
from rcj_challenges.programs.pool import PoolPlan, ProgramPool
from rcj_challenges.submissions.team import Team, open_team
from rcj_challenges.core.play import Fault
from rcj_challenges.core.traffic import DeviceSpec, Note, Observation, Packet, Request, RobotSpec
from rcj_challenges.scenario.models.limits import Limits

PROGRAMS = Path(__file__).parent.parent / "programs"

KIT = (
    ("left wheel motor", "motor", 0, {"max_velocity": 10.0}),
    ("right wheel motor", "motor", 0, {"max_velocity": 10.0}),
    ("left wheel sensor", "position_sensor", 1, {}),
    ("right wheel sensor", "position_sensor", 1, {}),
    ("gps", "gps", 3, {}),
    ("compass", "compass", 3, {}),
    ("distancesensor left", "distance_sensor", 1, {"min_value": 0.0, "max_value": 1000.0}),
    ("distancesensor front", "distance_sensor", 1, {"min_value": 0.0, "max_value": 1000.0}),
    ("ball receiver", "receiver", 0, {"channel": 4, "refused_channels": []}),
    ("supervisor receiver", "receiver", 0, {"channel": 1, "refused_channels": [2]}),
    ("team receiver", "receiver", 0, {"channel": 3, "refused_channels": [2]}),
    ("team emitter", "emitter", 0, {"channel": 3, "range": 10.0, "refused_channels": [1, 2]}),
    ("lidar", "lidar", 8, {"fov": 6.283185307179586, "min_range": 0.01, "max_range": 3.0, "frequency": 10.0}),
)
INDEX = {name: index for index, (name, *_) in enumerate(KIT)}


def robot_spec(name: str = "Y1", getdata_returns: str = "bytes") -> RobotSpec:
    devices, slot = [], 0
    for index, (device, kind, width, facts) in enumerate(KIT):
        devices.append(DeviceSpec(device, kind, index, slot if width else -1, width, facts))
        slot += width
    return RobotSpec(name, tuple(devices), slot, getdata_returns)


SPEC = robot_spec()


def values_at(tick: int) -> list[float]:
    """Numbers by which a test recognizes what a program has read: GPS x is the tick."""
    wheels, gps, compass, sonars = (
        [0.1 * tick, -0.1 * tick],
        [float(tick), 0.5, 0.0375],
        [0.0, 1.0, 0.0],
        [1000.0, 500.0],
    )
    return [*wheels, *gps, *compass, *sonars, *(0.5 + 0.1 * cell for cell in range(8))]


def packet(
    device: str, data: bytes, strength: float = 1.0, direction: tuple[float, float, float] = (1, 0, 0)
) -> Packet:
    return Packet(INDEX[device], data, strength, direction)


Air = Callable[[int], Iterable[Packet]]


def supervisor_every_tick(tick: int) -> list[Packet]:
    return [packet("supervisor receiver", b"\x00")]


@dataclass
class Played:
    """What came of it."""

    requests: list[tuple[int, Request]] = field(default_factory=list)
    fault: Fault | None = None
    log: str = ""
    notes: tuple[Note, ...] = ()

    @property
    def said(self) -> list[str]:
        """The program's own lines."""
        return [line for line in self.log.splitlines() if not line.startswith("--- half")]

    def sent(self) -> list[bytes]:
        return [data for _, request in self.requests for _, _, data in request.emissions]

    def motors(self) -> list[tuple[int, float, float]]:
        return [(m.device, m.velocity_radps, m.position_rad) for _, r in self.requests for m in r.motors]


class FakeMatch:
    """Plays one program alone. Programs are those of ``tests/programs``, or given as text."""

    def __init__(self, folder: Path, *, portable: bool | None = None, **limits: float) -> None:
        self.folder = folder
        self.portable = portable
        # Long enough that only a hang meets them on a busy machine.
        self.limits = Limits(**{"start_s": 20.0, "step_s": 20.0, **limits})  # type: ignore[arg-type]

    def team(self, program: str) -> Team:
        """A team of one program: a path below ``tests/programs`` without ``.py``, or source text."""
        if "\n" not in program:
            return open_team(PROGRAMS / f"{program}.py")
        path = self.folder / "robot.py"
        path.write_text(program, encoding="utf-8")
        return open_team(path)

    def pool(self, **plan: object) -> ProgramPool:
        given = {
            "limits": self.limits,
            "half": 1,
            "match_seed": 1,
            "logs": self.folder / "logs",
            "portable": self.portable,
        }
        return ProgramPool(PoolPlan(**{**given, **plan}))  # type: ignore[arg-type]

    def play(
        self,
        program: str | Team,
        ticks: int = 10,
        air: Air = lambda _: (),
        *,
        entry: str = "robot.py",
        spec: RobotSpec = SPEC,
        finish: bool = True,
        **plan: object,
    ) -> Played:
        team = self.team(program) if isinstance(program, str) else program
        played = Played()
        with self.pool(**plan) as pool:
            driver = pool.add(spec, team, team.single or entry)
            pool.launch()
            last = play_on(driver, played, ticks, air)
            if finish and played.fault is None:
                pool.finish({spec.name: Observation(last, values_at(last), [], over=True)})
            pool.close()
            played.log, played.notes = driver.new_output(), driver.notes
        return played


def play_on(driver: Program, played: Played, ticks: int, air: Air = lambda _: ()) -> int:
    """Play from tick 0 to ``ticks``, or until a fault. Returns the last tick."""
    waiting: list[Packet] = []
    due = 0
    for tick in range(ticks + 1):
        if tick:
            waiting += air(tick)
        if tick < due:
            continue
        if tick == ticks and tick:
            break
        if tick:
            driver.release(Observation(tick, values_at(tick), waiting))
            waiting = []
        answer = driver.collect()
        if isinstance(answer, Fault):
            played.fault = answer
            return tick
        played.requests.append((tick, answer))
        due = tick + answer.missed_ticks + answer.advance_ticks
    return ticks


_EACH = """
from controller import Robot
robot = Robot()
for name, lines in {snippets!r}.items():
    print("---", name, flush=True)
    exec(compile(lines, name, "exec"), {{"robot": robot, "__name__": "__main__"}})
while robot.step(32) != -1:
    pass
"""


def said_by_each(
    folder: Path, snippets: Mapping[str, str], ticks: int = 20, air: Air = lambda _: ()
) -> dict[str, list[str]]:
    """Run snippets one after the other in one program, each with names of its own and the ``robot``.

    Returns:
        What each has printed, by its name.
    """
    played = FakeMatch(folder).play(_EACH.format(snippets=dict(snippets)), ticks, air)
    assert played.fault is None, played.log
    said: dict[str, list[str]] = {}
    for line in played.said:
        if line.startswith("--- "):
            said[line[4:]] = lines = []
        else:
            lines.append(line)
    return said


def fault_of(match: FakeMatch, program: str, ticks: int = 30) -> Fault:
    """The fault of a program that has to fail."""
    played = match.play(program, ticks)
    assert played.fault is not None
    assert f"[{played.fault.kind}] Y1 at tick {played.fault.tick} " in played.log
    return played.fault
