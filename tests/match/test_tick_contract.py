"""The sentences of ADR 1 that the match loop keeps. Numbers in the names are those of the ADR."""

import json

import numpy as np
import pytest

from rcj_challenges.match.observers import Observer
from rcj_challenges.world.errors import PhysicsFault
from rcj_challenges.world.world import World
from tests.match.programs import AHEAD, DRIVE, STAND

HEAD = DRIVE.format(speed=0).split("while")[0]
GO = "for motor in motors:\n    motor.setVelocity(10)\n"
LOOP = "while robot.step(32) != -1:\n    pass\n"


def path_y(run, robot):
    """Return [tick][sub-step] -> y in the first half; row 0 is tick 1."""
    entity = run.trajectory.entities.index(robot)
    return np.array([[poses[entity][1] for poses in s.substeps] for s in run.trajectory.halves[0].snapshots()])


def first_move(run, robot):
    steps = np.abs(np.diff(path_y(run, robot)[:, -1]))
    return int(np.argmax(steps > 1e-4)) + 2  # the tick in which it moved


def test_0_1_each_half_is_a_fresh_world_and_fresh_processes(play, team_folder):
    counts = HEAD + "print('time', robot.getTime(), 'seen', globals().get('seen'))\nseen = 1\n" + LOOP
    run = play("match.halves=2", "match.half_s=1", yellow=team_folder(counts))
    assert run.log("Y1").count("time 0.0 seen None") == 1
    assert run.log("B1").count("time 0.0 seen None") == 1  # the same team in the other seat
    first, second = (run.trajectory.halves[k].start for k in (0, 1))
    assert first.substeps == second.substeps  # both halves begin at the nominal start poses


def test_0_5_programs_run_to_their_first_step_before_tick_1(play, team_folder):
    run = play("match.half_s=1", yellow=team_folder(AHEAD))
    assert first_move(run, "Y1") <= 3  # its first commands act in tick 1 already


def test_1_1_commands_hold_for_the_four_substeps_of_the_tick_that_follows(play, team_folder):
    late = HEAD + "for _ in range(10):\n    robot.step(32)\n" + GO + LOOP
    path = path_y(play("match.half_s=1", yellow=team_folder(late)), "Y1")
    assert np.ptp(path[:10]) < 1e-5
    assert path[10, 3] - path[9, 3] > 1e-4


def test_1_3_a_program_that_is_not_due_keeps_its_commands_and_its_packets_queue(play, team_folder):
    slow = HEAD + GO + (
        "referee = robot.getDevice('supervisor receiver')\nreferee.enable(32)\n"
        "robot.step(32)\nwhile referee.getQueueLength():\n    referee.nextPacket()\n"
        "robot.step(320)\nprint('packets', referee.getQueueLength())\n" + LOOP
    )  # fmt: skip
    run = play("match.half_s=1", yellow=team_folder(slow))
    assert "packets 10" in run.log("Y1")
    assert path_y(run, "Y1")[10, 3] - path_y(run, "Y1")[0, 0] > 0.02


def test_2_5_unstable_physics_ends_the_match_as_a_fault_with_a_clear_message(play, monkeypatch, tmp_path):
    step = World.step

    def explode(world, tick, faults=()):
        if tick == 10:
            world.data.qpos[:] = np.nan
        return step(world, tick, faults)

    monkeypatch.setattr(World, "step", explode)
    with pytest.raises(PhysicsFault, match="unstable in tick 10"):
        play("match.half_s=1")
    (folder,) = (tmp_path / "runs").iterdir()
    result = json.loads((folder / "result.json").read_text("utf-8"))
    assert not result["complete"]
    assert result["stopped"] == "PhysicsFault"


def test_9_1_observation_k_shows_the_placed_world(play, team_folder):
    watches = HEAD + (
        "gps = robot.getDevice('gps')\ngps.enable(32)\nlast = None\n"
        "while robot.step(32) != -1:\n"
        "    here = [round(v, 4) for v in gps.getValues()[:2]]\n"
        "    if last is not None and abs(here[0] - last[0]) + abs(here[1] - last[1]) > 0.05:\n"
        "        print('jump at', round(robot.getTime() / 0.032), here)\n"
        "    last = here\n"
    )
    run = play("robot_progress_s=2", "match.half_s=3", yellow=team_folder(watches))
    call = next(line for line in run.events("LACK_OF_PROGRESS") if line["payload"]["robot_name"] == "Y1")
    tick = round(call["matchtime"] / 0.032)
    assert f"jump at {tick}" in run.log("Y1")


def test_a_stopped_clock_lengthens_the_half(play):
    run = play("match.half_s=1", "phases.goal_pause.clock=stops", "phases.goal_pause.next=play",
               "first_phase=goal_pause", "goal_pause_s=2", yellow=None)  # fmt: skip
    assert run.result["halves"][0]["ticks"] == 32 + 63


def test_a_clock_that_never_goes_on_ends_the_half_with_a_reason(play):
    run = play("match.half_s=0.1", "phases.goal_pause.clock=stops", "first_phase=goal_pause", "goal_pause_s=600")
    assert "stood still" in run.result["halves"][0]["ended"]
    assert run.result["halves"][0]["ticks"] == 40


def test_programs_get_the_end_as_minus_one(play, team_folder):
    says = STAND + "print('the end at', robot.getTime())\n"
    assert "the end at 1.024" in play("match.half_s=1", yellow=team_folder(says)).log("Y1")


def test_observers_are_asked_before_each_tick_in_order_and_once(play):
    class Asked(Observer):
        def __init__(self):
            self.ticks = []

        def before_tick(self, tick):
            self.ticks.append(tick)
            return 0.0

    observer = Asked()
    play("match.half_s=0.32", observer=observer)
    assert observer.ticks == list(range(1, 11))
