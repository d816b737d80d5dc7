"""A made-up match with all that a replay page must show, and its named moments, for tests and for screenshots."""

import math
from collections.abc import Iterator, Mapping
from dataclasses import replace
from pathlib import Path

from rcj_challenges.core.play import Event, Fault, Firing, Placement, RefereeOutput, Snapshot
from rcj_challenges.core.timing import TICK_S
from rcj_challenges.records.logos import logo_path
from rcj_challenges.records.sensors import SensorWriter
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.views.replay import write_replay
from tests.made_up_runs import finish_event, made_up_play, small_scenario, write_run
from tests.scenario.writing import in_tuples
from tests.views.sensing_play import SENSED, logo, sense

TICKS = 1000
GOALS = (400, 800)  # of `made_up_play`: ticks of each half, by the seat yellow
HELD, CRASH, CRASH_HEARD = 200, 299, 300
STUCK, REMOVED, BACK = 600, 640, 760
TRACEBACK = (
    'Traceback (most recent call last):\n  File "robot.py", line 7, in <module>\n    strike(ball)\n'
    '  File "lib/strike.py", line 31, in strike\n    return 1 / distance\nZeroDivisionError: division by zero\n'
)

MOMENTS = {
    "before_kick_off": (1, 0),
    "goal": (1, GOALS[0] + 15),
    "just_after_half_time": (2, 3),
    "robot_removed": (1, REMOVED + 20),
    "crash": (1, CRASH + 10),
    "lack_of_progress": (1, STUCK + 10),
    "end": (2, TICKS),
    "paused_with_sensors": (1, 125),
}
"""Half and tick of the moments that people look at."""


def scenario() -> Scenario:
    """Return the scenario: sides change at half-time, and a rule that may fire for two reasons."""
    fields = small_scenario(halves=2, half_s=TICKS * TICK_S).model_dump(mode="json", by_alias=True)
    for seat, ends in (("blue", {"y_min_m": 0.59}), ("yellow", {"y_max_m": -0.59})):
        area = {"shape": "rect", "x_min_m": -0.35, "x_max_m": 0.35, **ends, "drawn": True}
        fields["zones"][f"{seat}_penalty_area"] = area
    del fields["zones"]["penalty_area"]
    fields["rules"]["stuck"] = {
        "for_each": "robots",
        "triggers": [
            {"trigger": "no_progress", "entity": "each", "distance_m": 0.5, "within_s": 15},
            {"trigger": "leaves", "entity": "each", "zone": "middle"},
        ],
        "actions": [{"action": "emit", "event": "LACK_OF_PROGRESS"}],
        "says": "{entity} made no progress or left the field; it is put on a neutral spot.",
    }
    return Scenario.model_validate(in_tuples(fields))


def play(robots: int, half: int, scores: Mapping[str, float]) -> Iterator[tuple[Snapshot, RefereeOutput]]:
    """Yield a half; in the first one a program crashes, a robot is stuck, and one is taken off for a time."""
    for snapshot, judged in made_up_play(robots, TICKS, scores):
        tick, output = snapshot.tick, judged
        fault = Fault("Y1", "crash", CRASH, 1, "ZeroDivisionError: division by zero", TRACEBACK)
        shown = snapshot._replace(faults=(fault,) if half == 1 and tick == CRASH_HEARD else ())
        if half == 1 and tick == STUCK:
            says = "B2 made no progress or left the field; it is put on a neutral spot."
            firing = Firing(tick, "stuck", "B2", "no_progress", 0.49712, 0.5, {}, None, says)
            event = Event(tick, "LACK_OF_PROGRESS", {"type": "robot", "robot_name": "B2"})
            output = replace(output, events=(event,), firings=(firing,), placements=(Placement(1, 0.0, 0.2, 0.0),))
        if half == 1 and REMOVED < tick <= BACK:
            gone = (1000.0, 0.0, 0.0)
            shown = shown._replace(substeps=[[*poses[:2], gone, *poses[3:]] for poses in shown.substeps])
        if half == 1 and tick in (REMOVED, BACK):
            placement = Placement(2, 0.0, 0.0, math.pi / 2, parked=tick == REMOVED)
            output = replace(output, placements=(*output.placements, placement))
        yield shown, output


def write_storied_run(out: Path, names: tuple[str, str] = ("Hanse", "Alster"), *, with_sensors: bool = True) -> Path:
    """Write the record of the match and its page; sensors of B1 and Y2 and a logo are in the first half."""
    played = scenario()
    folder = write_run(
        out,
        played,
        lambda half: play(len(played.robots), half.half, half.scores),
        ticks=TICKS,
        halves=2,
        names=names,
        closing=finish_event,
    )
    if with_sensors:
        sensors = SensorWriter(folder, 1, SENSED)
        for tick in range(TICKS + 1):
            sense(sensors, tick)
        sensors.close()
        logo_path(folder, "blue").write_bytes(logo(200))
    write_replay(folder)
    return folder
