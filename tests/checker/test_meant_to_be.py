"""Which file of a submission was meant to be the program, where none is called as asked for: what the remedy says."""

from __future__ import annotations

import time
from pathlib import Path, PurePosixPath

import pytest

from rcj_challenges.checker.archives import inspect
from rcj_challenges.checker.findings import Finding
from rcj_challenges.checker.repair import repair
from rcj_challenges.scenario.load import load
from tests.hostile.archives.making import below, plain

MATCH, OF_2021 = load("match").scenario, load("match_2021").scenario
MAIN = b"from controller import Robot\nfrom robot1 import MyRobot1\nimport robot2\nMyRobot1(Robot()).run()\n"
BASE = b"class RCJSoccerRobot:\n    def __init__(self, robot):\n        self.robot = robot\n"
ROBOT = b"import utils\nfrom rcj_soccer_robot import RCJSoccerRobot, TIME_STEP\nclass MyRobot1(RCJSoccerRobot): pass\n"
SHARED = {"rcj_soccer_robot.py": BASE, "robot1.py": ROBOT, "robot2.py": ROBOT, "utils.py": b"x = 1\n"}
"""What lies beside the program in the style of 2022 and 2023."""
ALONE = b"from controller import Robot\nrobot = Robot()\nwhile robot.step(64) != -1:\n    pass\n"


def misplaced(tmp_path: Path, files: dict[str, bytes], scenario=MATCH) -> Finding:
    path = tmp_path / "team.zip"
    path.write_bytes(plain(files | {"team_name.txt": b"Cats"}))
    stage = inspect(path, scenario).stages[1]
    (found,) = [finding for finding in stage.findings if finding.level == "failure"]
    return found


def mended(tmp_path: Path, scenario=MATCH) -> set[str]:
    """The files of the submission after a repair that leaves nothing to do in its layout."""
    done = repair(tmp_path / "team.zip", tmp_path / "mended.zip", scenario)
    assert done.left == []
    inspection = inspect(tmp_path / "mended.zip", scenario)
    assert inspection.team is not None
    return {str(path) for path in inspection.team.files}


def test_the_only_program_that_no_other_imports_is_meant_whatever_it_is_called(tmp_path: Path) -> None:
    found = misplaced(tmp_path, below("tigers", {"tigers.py": MAIN} | SHARED))
    assert found.code == "layout.misnamed"
    assert found.remedy == (
        "rename the folder tigers to rcj_soccer_team_blue, "
        "rename the file rcj_soccer_team_blue/tigers.py to rcj_soccer_team_blue/rcj_soccer_team_blue.py"
    )
    assert "rcj_soccer_team_blue/rcj_soccer_robot.py" in mended(tmp_path)


def test_it_is_meant_too_where_only_its_folder_is_called_as_asked_for(tmp_path: Path) -> None:
    found = misplaced(tmp_path, below("rcj_soccer_team_blue", {"main.py": MAIN} | SHARED))
    assert found.remedy == (
        "rename the file rcj_soccer_team_blue/main.py to rcj_soccer_team_blue/rcj_soccer_team_blue.py"
    )
    assert "rcj_soccer_team_blue/rcj_soccer_robot.py" in mended(tmp_path)
    found = misplaced(tmp_path, below("score_goal", {"main.py": MAIN} | SHARED))
    assert found.code == "layout.missing"  # for another challenge, it seems
    assert "did you mean" not in found.message  # none of the files that it imports
    found = misplaced(tmp_path, below("rcj_soccer_team_blue", {"score_goal.py": MAIN} | SHARED))
    assert found.code == "layout.missing"  # so its own name says


def test_a_program_called_main_at_the_top_is_meant_and_no_file_that_it_imports(tmp_path: Path) -> None:
    found = misplaced(tmp_path, {"main.py": MAIN} | SHARED)
    assert found.remedy == "rename the file main.py to robot.py"
    assert mended(tmp_path) == {"robot.py", "team_name.txt", *SHARED}


def test_what_it_imports_may_be_a_package_or_have_other_letters_than_ascii(tmp_path: Path) -> None:
    main = b"from controller import Robot\nimport gr\xc3\xb6\xc3\x9fe, tactics\n"
    others = {"größe.py": b"from controller import Robot\n", "tactics/__init__.py": b"from controller import Robot\n"}
    found = misplaced(tmp_path, below("tigers", {"tigers.py": main} | others))
    assert "rename the file rcj_soccer_team_blue/tigers.py" in found.remedy


def test_of_several_such_programs_none_is_meant(tmp_path: Path) -> None:
    found = misplaced(tmp_path, below("cats", {"main.py": MAIN, "other.py": MAIN} | SHARED))
    assert found.code == "layout.missing"
    assert "rcj_soccer_robot" not in found.remedy


def test_a_test_of_a_program_is_none_itself(tmp_path: Path) -> None:
    found = misplaced(tmp_path, below("cats", {"main.py": MAIN, "test_it.py": b"import utils\nimport main\n"} | SHARED))
    assert "rename the file rcj_soccer_team_blue/main.py" in found.remedy


def test_a_file_that_never_meets_the_robot_is_no_program_of_one(tmp_path: Path) -> None:
    found = misplaced(tmp_path, {"cats/plot.py": b"import math\nprint(math.pi)\n"})
    assert found.code == "layout.missing"


def test_the_base_class_of_three_programs_at_the_top_is_not_meant(tmp_path: Path) -> None:
    files = {f"robot{n}.py": ROBOT + b"MyRobot1().run()\n" for n in (1, 2, 3)}
    found = misplaced(tmp_path, files | {"rcj_soccer_robot.py": BASE, "utils.py": b"x = 1\n"}, OF_2021)
    assert found.code == "layout.missing"
    assert "move the file robot1.py into a folder robot1" in found.remedy
    assert "rename the file rcj_soccer_robot.py" not in found.remedy


def test_of_the_same_programs_for_both_colours_those_of_blue_are_meant(tmp_path: Path) -> None:
    """So they lay in the controllers' folder of 2021; `match` knows one folder, called after blue, as well."""
    files = {
        f"rcj_soccer_player_{who}/rcj_soccer_player_{who}.py": b"# ROBOT %s\n" % who.upper().encode() + ALONE
        for who in ("b1", "b2", "b3", "y1", "y2", "y3")
    }
    found = misplaced(tmp_path, files, OF_2021)
    assert found.code == "layout.misnamed"
    assert "rename the folder rcj_soccer_player_b1 to robot1" in found.remedy
    assert "player_y" not in found.remedy
    assert "robot3/robot3.py" in mended(tmp_path, OF_2021)


def test_where_the_programs_of_the_colours_differ_the_team_has_to_say_which_are_its_own(tmp_path: Path) -> None:
    """Many wrote theirs for one colour only, and left the example as the opponent: which is which, no name tells."""
    files = {
        f"rcj_soccer_player_{who}/rcj_soccer_player_{who}.py": ALONE + b"# spare\nx = 1\n" * (who[0] == "y")
        for who in ("b1", "b2", "b3", "y1", "y2", "y3")
    }
    found = misplaced(tmp_path, below("controllers", files), OF_2021)
    assert (found.code, found.repair) == ("layout.missing", False)
    assert found.remedy.startswith(
        "move what is in controllers to the top, rename the folder rcj_soccer_player_b1 to robot1"
    )
    assert found.remedy.endswith(
        "; or do so with the programs of yellow, if these are yours: they differ, and the same ones play for both colours"
    )


def test_of_programs_for_yellow_alone_nothing_else_is_meant_instead(tmp_path: Path) -> None:
    files = {"rcj_soccer_player_y1.py": ALONE + b"import rcj_soccer_robot\n", "rcj_soccer_robot.py": BASE}
    found = misplaced(tmp_path, files, OF_2021)
    assert found.code == "layout.missing"
    assert "rename" not in found.remedy


@pytest.mark.parametrize("name", ["rcj_soccer_team_yellow", "rcj_soccer_team", "rcj_soccer_team_bleu"])
def test_what_lies_in_the_folder_of_yellow_may_be_given_alone(tmp_path: Path, name: str) -> None:
    """Who played as yellow at home gives that folder: in it lies the program, and not the folder."""
    found = misplaced(tmp_path, {f"{name}.py": MAIN} | SHARED)
    assert (found.code, found.remedy) == ("layout.misnamed", f"rename the file {name}.py to robot.py")
    assert mended(tmp_path) == {"robot.py", "team_name.txt", *SHARED}


def test_the_program_of_one_robot_is_none_for_all(tmp_path: Path) -> None:
    found = misplaced(tmp_path, {"robot1.py": ALONE, "utils.py": b"x = 1\n"})
    assert "robot.py" not in found.remedy.split(" or ")[0]


def test_programs_that_import_from_the_folder_of_another_one_are_meant_all_the_same(tmp_path: Path) -> None:
    """The template of 2021: what all share lies in the folder of B1; packed with all that its repository has."""
    up = b"import sys\nfrom pathlib import Path\nsys.path.append(str(Path('.').absolute().parent))\n"
    shared = up + b"from rcj_soccer_player_b1 import rcj_soccer_robot, utils\n" + ALONE
    own = b"import rcj_soccer_robot, utils\n" + ALONE
    players = {
        f"controllers/rcj_soccer_player_{who}/rcj_soccer_player_{who}.py": own if who == "b1" else shared
        for who in ("b1", "b2", "b3", "y1", "y2", "y3")
    }
    others = {
        "controllers/rcj_soccer_player_b1/rcj_soccer_robot.py": BASE,
        "controllers/rcj_soccer_player_b1/utils.py": b"x = 1\n",
        "controllers/rcj_soccer_player_b1/__init__.py": b"",
        "controllers/rcj_soccer_supervisor/rcj_soccer_supervisor.py": b"from controller import Supervisor\n",
        "worlds/soccer.wbt": b"#VRML_SIM\n",
        "README.md": b"#\n",
    }
    found = misplaced(tmp_path, below("rcj-soccer-sim-master", players | others), OF_2021)
    assert found.code == "layout.misnamed"
    assert "rename the folder rcj_soccer_player_b1 to robot1" in found.remedy
    assert "rename the folder rcj_soccer_player_b3 to robot3" in found.remedy
    assert found.remedy.endswith("the programs mention rcj_soccer_player_b1: change that as well")


@pytest.mark.parametrize(
    "name", ["rcj_soccer_team_blue_v2", "rcj_soccer_team_blue_final_2022", "My_rcj_soccer_team_blue3"]
)
def test_a_number_behind_the_name_that_is_asked_for_is_no_other_name(tmp_path: Path, name: str) -> None:
    found = misplaced(tmp_path, below(name, {f"{name}.py": MAIN} | SHARED))
    assert found.remedy == (
        f"rename the folder {name} to rcj_soccer_team_blue, "
        f"rename the file rcj_soccer_team_blue/{name}.py to rcj_soccer_team_blue/rcj_soccer_team_blue.py"
    )
    assert "rcj_soccer_team_blue/robot1.py" in mended(tmp_path)


FLAT = {f"robot{number}.py": ALONE for number in (1, 2, 3)}


def test_programs_that_lie_beside_their_folders_belong_into_them(tmp_path: Path) -> None:
    found = misplaced(tmp_path, FLAT)
    assert found.code == "layout.misnamed"
    assert found.remedy == (
        "move the file robot1.py into a folder robot1, move the file robot2.py into a folder robot2, "
        "move the file robot3.py into a folder robot3"
    )
    assert mended(tmp_path) == {"robot1/robot1.py", "robot2/robot2.py", "robot3/robot3.py", "team_name.txt"}


def test_so_do_those_that_mention_themselves(tmp_path: Path) -> None:
    found = misplaced(tmp_path, {file: b"# %s\n" % file.encode() + content for file, content in FLAT.items()})
    assert found.code == "layout.misnamed"
    assert found.repair
    assert "robot1/robot1.py" in mended(tmp_path)


def test_so_do_those_in_an_extra_folder(tmp_path: Path) -> None:
    found = misplaced(tmp_path, below("cats", FLAT))
    assert found.remedy.startswith("move what is in cats to the top, move the file robot1.py into a folder robot1, ")
    assert "robot3/robot3.py" in mended(tmp_path)


def test_programs_that_import_from_beside_them_take_it_with_them(tmp_path: Path) -> None:
    found = misplaced(tmp_path, FLAT | {"robot1.py": b"import utils\n" + ALONE, "utils.py": b"x = 1\n"})
    assert found.code == "layout.missing"  # nothing is repaired: no file is copied
    assert found.remedy.endswith(
        "move the file robot3.py into a folder robot3, each with a copy of what it imports or opens beside it"
    )


@pytest.mark.parametrize(
    ("program", "beside"),
    [
        (b"open('speeds.csv').read()\n", "speeds.csv"),
        (b"open('our speeds.csv').read()\n", "our speeds.csv"),
        (b"import fast\n", "fast.cp311-win_amd64.pyd"),
        (b"import lib.moves\n", "lib/moves.py"),
        (b"from robot1 import *\n", "robot1.py"),
        (b"exec(open('robot1.py').read())\n", "robot1.py"),
    ],
)
def test_programs_that_use_what_lies_beside_them_are_not_taken_from_it(tmp_path: Path, program, beside) -> None:
    """The archive of the repair would hold programs that do not find their files."""
    found = misplaced(tmp_path, {beside: b"x = 1\n"} | FLAT | {"robot2.py": program + ALONE})
    assert found.code == "layout.missing"
    assert "each with a copy of what it imports or opens beside it" in found.remedy
    assert "did you mean" not in found.message  # the remedy says it
    repair(tmp_path / "team.zip", tmp_path / "mended.zip", MATCH)
    assert PurePosixPath("robot2.py") in inspect(tmp_path / "mended.zip", MATCH).opening.contents.files


@pytest.mark.parametrize(("count", "ending"), [(250, ""), (250, "-b"), (1900, ""), (1900, "-b")])
@pytest.mark.nightly
def test_whether_long_programs_use_many_files_is_found_out_in_no_time(tmp_path: Path, count: int, ending: str) -> None:
    names = [f"f{number}{ending}" for number in range(count)]
    program = ALONE + "".join(f"# {name}\n" for name in names).encode() + b'"a b"\n' * 150_000
    files = {f"{name}.txt": b"x" for name in names} | {f"robot{number}.py": program for number in (1, 2, 3)}
    began_s = time.process_time()  # what else the machine does is not counted
    found = misplaced(tmp_path, files)
    assert "move the file robot1.py into a folder robot1" in found.remedy
    assert time.process_time() - began_s < 15


def test_what_lies_beside_programs_and_is_not_used_hinders_nothing(tmp_path: Path) -> None:
    found = misplaced(tmp_path, FLAT | {"plot.py": b"import math\nprint(math.pi)\n", "notes.md": b"Hello\n"})
    assert found.code == "layout.misnamed"
    assert found.remedy.startswith("move the file robot1.py into a folder robot1, ")


def test_one_program_that_lies_beside_its_folder_joins_those_that_lie_in_theirs(tmp_path: Path) -> None:
    there = {f"robot{number}/robot{number}.py": ALONE for number in (2, 3)}
    found = misplaced(tmp_path, {"robot1.py": ALONE + b"# defends\n"} | there)
    assert found.remedy == "move the file robot1.py into a folder robot1"
    assert "robot1/robot1.py" in mended(tmp_path)


def test_a_program_that_serves_is_not_meant_to_be_another_one(tmp_path: Path) -> None:
    found = misplaced(tmp_path, {f"robot{number}/robot{number}.py": ALONE for number in (2, 3)})
    assert found.code == "layout.missing"
    assert "did you mean" not in found.message


def test_a_copy_of_a_program_that_serves_may_be_meant_to_be_another_one(tmp_path: Path) -> None:
    found = misplaced(tmp_path, {"robot2/robot2.py": ALONE, "robot3/robot3.py": ALONE, "Robot1.py": ALONE})
    assert "did you mean Robot1.py to be robot1/robot1.py?" in found.message


def test_no_folder_is_made_where_a_file_of_its_name_lies(tmp_path: Path) -> None:
    found = misplaced(tmp_path, FLAT | {"robot1": b"x"})
    assert found.code == "layout.missing"
    repair(tmp_path / "team.zip", tmp_path / "mended.zip", MATCH)
    assert inspect(tmp_path / "mended.zip", MATCH).stages[0].level == "passed"


def test_two_programs_for_three_robots_are_not_taken_for_all(tmp_path: Path) -> None:
    found = misplaced(tmp_path, {"robot1.py": ALONE, "robot2.py": ALONE})
    assert found.code == "layout.missing"
    assert "into a folder" not in found.remedy


def test_an_ending_that_windows_hides_is_named(tmp_path: Path) -> None:
    found = misplaced(tmp_path, below("rcj_soccer_team_blue", {"rcj_soccer_team_blue.py.txt": MAIN} | SHARED))
    assert found.code == "layout.misnamed"
    assert found.remedy == (
        "rename the file rcj_soccer_team_blue/rcj_soccer_team_blue.py.txt to "
        "rcj_soccer_team_blue/rcj_soccer_team_blue.py"
    )
    assert "rcj_soccer_team_blue/rcj_soccer_team_blue.py" in mended(tmp_path)


@pytest.mark.nightly
def test_among_many_large_files_it_is_found_out_at_once(tmp_path: Path) -> None:
    """Every folder and every entry point is tried; what files import must not be looked up each time."""
    files = {
        f"d{number % 20}/e{number % 3}/f{number}.py": "".join(
            f"import f{(number * line) % 199}, x{number * line}\n" for line in range(400)
        ).encode()
        for number in range(199)
    }
    began_s = time.process_time()
    assert misplaced(tmp_path, files).code == "layout.missing"
    assert time.process_time() - began_s < 10


@pytest.mark.parametrize(
    "program",
    [
        b"def main():\n    robot = Robot()\nif __name__ == '__main__':\n    main()\n",
        b'if __name__ == "__main__": main()\n',
        b"print('in the main loop')  # main\n",
        b'"""The main program.\n\nmain is what is started.\n"""\nmain = 3\n',
    ],
)
def test_a_function_of_its_name_does_not_keep_a_program_from_being_renamed(tmp_path: Path, program: bytes) -> None:
    found = misplaced(tmp_path, {"main.py": ALONE + program})
    assert found.remedy == "rename the file main.py to robot.py"
    assert "robot.py" in mended(tmp_path)


@pytest.mark.parametrize(
    "program",
    [
        b"import tools, main\n",
        b"try: from main import step\nexcept ImportError: pass\n",
        b"from main.parts import (\n    one,\n)\n",
        b"from tools import (  # these\n    one,\n    main,\n)\n",
        b"import tools, \\\n    main\n",
        b"importlib.import_module('main')\n",
        b'__import__("main")\n',
        b"open('../my robots/main/plan.json')\n",
        b"exec(open(here + 'main.py').read())\n",
    ],
)
def test_who_changes_a_name_that_programs_import_or_open_is_told_of_them(tmp_path: Path, program: bytes) -> None:
    found = misplaced(tmp_path, {"main.py": ALONE + program, "tools.py": b"one = main = 1\nmain()\n"})
    assert found.remedy.endswith("the programs mention main: change that as well")


@pytest.mark.parametrize(
    ("beside", "remedy"),
    [
        ({"robot1/utils.py": b"x = 1\n"}, "add robot3/robot3.py: the programs that are there drive B1, B2, Y1, Y2"),
        ({"third.py": ALONE, "fourth.py": ALONE}, "call the program rcj_soccer_team_blue/rcj_soccer_team_blue.py or "),
    ],
    ids=["every program drives a robot", "one of two others is meant"],
)
def test_a_program_that_drives_another_robot_is_not_to_be_renamed(tmp_path: Path, beside: dict, remedy: str) -> None:
    programs = {"robot1/robot1.py": b"import utils\n" + ALONE, "robot2/robot2.py": ALONE}
    found = misplaced(tmp_path, programs | beside, OF_2021)
    assert found.code == "layout.missing"
    assert found.remedy.startswith(remedy)
