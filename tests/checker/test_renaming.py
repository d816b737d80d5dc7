"""Which renaming is proposed for programs that are not where the scenario asks for them, and whether --fix does it."""

from __future__ import annotations

import time
from pathlib import PurePosixPath

import pytest

from rcj_challenges.checker.archives import inspect
from rcj_challenges.checker.renaming import plan_moves
from rcj_challenges.scenario.load import load
from tests.hostile.archives.making import below, plain

SEATS = tuple(load("match").scenario.entrants.values())
MAIN = b"from controller import Robot\nfrom helper import run\nrun(Robot())\n"
PROGRAM = b"from controller import Robot\nrobot = Robot()\nwhile robot.step(64) != -1:\n    pass\n"
LIBRARIES = {"helper.py": b"import rcj_soccer_robot\n", "rcj_soccer_robot.py": b"class Base: pass\n"}
TEAM = "rcj_soccer_team_blue"
FLAT = {f"robot{number}.py": PROGRAM for number in (1, 2, 3)}
NUMBERED = {f"rcj_soccer_player_b{n}/rcj_soccer_player_b{n}.py": PROGRAM for n in (1, 2, 3)}


def plan(files):
    found = plan_moves({PurePosixPath(path): content for path, content in files.items()}, SEATS)
    if found is None:
        return None
    return [(str(move.old), str(move.new)) for move in found.moves], bool(found.caution)


@pytest.mark.parametrize("left", [b"SPEED = 9\n", b"import math\ndef angle(x, y):\n    return math.atan2(y, x)\n"])
def test_what_is_left_without_the_main_program_is_not_made_one(left):
    assert plan(below(TEAM, {"helper.py": left})) is None


@pytest.mark.parametrize(
    ("files", "moves"),
    [
        (
            below("tigers", {"tigers.py": MAIN} | LIBRARIES),
            [("tigers", TEAM), (f"{TEAM}/tigers.py", f"{TEAM}/{TEAM}.py")],
        ),
        (below(TEAM, {"main.py": MAIN} | LIBRARIES), [(f"{TEAM}/main.py", f"{TEAM}/{TEAM}.py")]),
        (below(TEAM, {f"{TEAM}.py.txt": MAIN}), [(f"{TEAM}/{TEAM}.py.txt", f"{TEAM}/{TEAM}.py")]),
        (
            below(f"{TEAM}_v2", {f"{TEAM}_v2.py": MAIN} | LIBRARIES),
            [(f"{TEAM}_v2", TEAM), (f"{TEAM}/{TEAM}_v2.py", f"{TEAM}/{TEAM}.py")],
        ),
        ({"main.py": MAIN} | LIBRARIES, [("main.py", "robot.py")]),
        ({"rcj_soccer_team_yellow.py": MAIN} | LIBRARIES, [("rcj_soccer_team_yellow.py", "robot.py")]),
        (NUMBERED, [(f"rcj_soccer_player_b{n}", f"robot{n}") for n in (1, 2, 3)]
         + [(f"robot{n}/rcj_soccer_player_b{n}.py", f"robot{n}/robot{n}.py") for n in (1, 2, 3)]),
        (below("controllers", {"robot1/robot1.py": MAIN, "robot2/robot2.py": MAIN, "Robot3/robot3.py": MAIN}),
         [("controllers", "."), ("Robot3", "robot3")]),
    ],
)  # fmt: skip
def test_a_clear_renaming_is_planned(files, moves):
    assert plan(files) == (moves, False)


def test_programs_for_both_colours_that_are_the_same_count_once():
    both = NUMBERED | {path.replace("player_b", "player_y"): content for path, content in NUMBERED.items()}
    assert plan(both) == plan(NUMBERED)
    assert plan(both | {"rcj_soccer_player_y1/rcj_soccer_player_y1.py": PROGRAM + b"x = 1\n"}) is None


@pytest.mark.parametrize(
    ("line", "is_mentioned"),
    [
        (b"import tools, main\n", True),
        (b"importlib.import_module('main')\n", True),
        (b"exec(open(here + 'main.py').read())\n", True),
        (b"def main():\n    pass\nif __name__ == '__main__':\n    main()\n", False),
        (b"print('in the main loop')  # main\n", False),
    ],
)
def test_a_name_that_programs_use_is_not_changed_without_the_team(line, is_mentioned):
    assert plan({"main.py": PROGRAM + line}) == ([("main.py", "robot.py")], is_mentioned)


@pytest.mark.parametrize(
    "files",
    [
        {"robot1.py": PROGRAM, "utils.py": b"x = 1\n"},
        {"robot1.py": PROGRAM, "robot2.py": PROGRAM},
        {"cats/plot.py": b"import math\n"},
        {f"robot{number}/robot{number}.py": PROGRAM for number in (2, 3)},
        FLAT,
    ],
)
def test_without_a_clear_renaming_none_is_planned(files):
    assert plan(files) is None


@pytest.mark.parametrize(
    ("files", "code", "repair"),
    [({"main.py": MAIN} | LIBRARIES, "layout.misnamed", True), (FLAT, "layout.missing", False)],
)
def test_the_finding_states_whether_the_renaming_is_possible(tmp_path, files, code, repair):
    path = tmp_path / "team.zip"
    path.write_bytes(plain(files | {"team_name.txt": b"Cats"}))
    stage = inspect(path, load("match").scenario).stages[1]
    assert [(one.code, one.repair) for one in stage.findings if one.level == "error"] == [(code, repair)]


@pytest.mark.nightly
def test_many_large_files_are_planned_quickly():
    imports = "".join(f"import f{line % 199}, x{line}\n" for line in range(4000)).encode()
    files = {f"d{number % 20}/e{number % 3}/f{number}.py": imports for number in range(199)}
    began_s = time.process_time()
    assert plan(files) is None
    assert time.process_time() - began_s < 10
