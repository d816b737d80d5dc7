"""A program sends the referee a message by radio: it is judged in the next tick, recorded, and judged again alike."""

import pytest

from tests.judging_again import judged_again, reflog_of
from tests.match.programs import STAND

TREASURE = """schema_version: 2
id: treasure
title: Treasure
extends: soccersim_v2
match: {halves: 1, half_s: 2}
spots: {guess: {x_m: 0, y_m: 0}, treasure: {x_m: 0.3, y_m: 0.2}}
rules:
  guessed:
    for_each: yellow
    triggers: [{trigger: tells, entity: each, is_a: position}]
    actions:
      - {action: set_spot, spot: guess, to: {told: each}}
      - {action: emit, event: GUESS, payload: {told: {told: each}, off_m: {distance: [guess, treasure]}}}
    says: '{entity} tells where the treasure is.'
  over:
    triggers: [{trigger: tells, entity: Y2, text: DONE}]
    actions: [{action: emit, event: DONE}]
    says: Done.
"""
SENDS = """
from controller import Robot
robot = Robot()
emitter = robot.getDevice("team emitter")
mine = emitter.getChannel()
emitter.setChannel(1)
steps = 0
while robot.step(32) != -1:
    steps += 1
    if steps == 10:
        emitter.send([0.3, 0.1])
        emitter.send("0.3, 0.2")
print("sent on", emitter.getChannel(), "and not on", mine)
"""
SENDS_DONE = SENDS.replace("emitter.send([0.3, 0.1])", "pass").replace("0.3, 0.2", "DONE")


@pytest.fixture(scope="module")
def run(shared_place):
    return shared_place.play(scenario=TREASURE, yellow=shared_place.team_folder(SENDS, SENDS_DONE, STAND))


def test_it_is_received_in_the_next_tick_one_message_of_each_robot(run):
    lines = [(round(line["matchtime"] / 0.032), line["event"], line["payload"]) for line in run.reflog]
    assert lines == [
        (11, "GUESS", {"told": "0.3 0.1", "off_m": 0.1}),
        (11, "DONE", {}),
        (12, "GUESS", {"told": "0.3, 0.2", "off_m": 0}),
    ]


def test_the_program_may_use_the_referees_channel(run):
    assert run.log("Y1").endswith("sent on 1 and not on 3\n")


def test_the_record_keeps_the_messages(run):
    entities, (half,) = run.trajectory.entities, run.trajectory.halves
    received = {tick: [(entities[robot], text) for robot, text in texts] for tick, texts in half.messages.items()}
    assert received == {11: [("Y1", "0.3 0.1"), ("Y2", "DONE")], 12: [("Y1", "0.3, 0.2")]}


def test_the_referee_judges_the_record_alone_alike(run):
    assert judged_again(run.folder) == reflog_of(run.folder)
