"""What is told of a program that came to its end because it keeps quiet about its errors."""

from __future__ import annotations

from pathlib import PurePosixPath

import pytest

from rcj_challenges.checker.advice.early_ends import why_it_ended, why_it_stands
from rcj_challenges.checker.check import CheckOptions, check_file
from tests.checker.alone import alone

ENTRY = PurePosixPath("robot.py")
BEGIN = "from controller import Robot\nrobot = Robot()\n"
SAYS = (
    'the "except" in line 6 takes every error: if one ended the program, it kept quiet about it. Write '
    "traceback.print_exc() there, and import traceback at the top"
)


def looped(handler: str) -> bytes:
    return f"{BEGIN}try:\n    while robot.step(32) != -1:\n        1 / 0\n{handler}\n".encode()


@pytest.mark.parametrize(
    "handler",
    [
        "except:\n    pass",
        "except Exception:\n    print('something went wrong')",
        "except BaseException :  # whatever\n    robot = None",
        "except Exception as e: pass",
        "except (Exception):\n    # print(error)\n    pass",
        "except Exception as e:\n    robot = None",
    ],
)
def test_an_except_that_takes_every_error_and_tells_none_is_named(handler: str) -> None:
    assert why_it_ended({ENTRY: looped(handler)}, ENTRY, has_stepped=True) == SAYS


TOLD = (
    'the "except" in line 6 takes every error: if one ended the program, what was printed of it stands in the program\'s '
    "output (--show-output). Without try and except Python tells its line as well"
)


@pytest.mark.parametrize(
    "handler",
    [
        "except Exception as e:\n    print('something went wrong', e)",
        "except Exception as e: print(e)",
        "except:\n    import traceback\n    traceback.print_exc()",
        "except:\n    print(sys.exc_info())",
        "except:\n    logging.exception('oh')",
    ],
)
def test_of_one_that_tells_them_it_is_said_where(handler: str) -> None:
    """The loop is there: who is told to write one looks in the wrong place."""
    assert why_it_ended({ENTRY: looped(handler)}, ENTRY, has_stepped=True) == TOLD


def test_one_that_keeps_quiet_is_named_before_one_that_tells() -> None:
    program = looped("except Exception as e:\n    print(e)") + b"try:\n    robot.step(1 / 0)\nexcept:\n    pass\n"
    program = program.replace(b"robot.step(1", b"while robot.step(32) != -1: (1")
    assert "line 10 takes every error: if one ended the program, it kept quiet" in why_it_ended({ENTRY: program}, ENTRY)


@pytest.mark.parametrize(
    "handler",
    [
        "except:\n    raise",
        "except Exception as e:\n    print(e)\n    raise",
        "except ValueError:\n    pass",
        "except ValueError as e:\n    print(e)",
        "finally:\n    pass",
    ],
)
def test_nothing_is_said_of_one_that_lets_errors_pass_or_takes_some_only(handler: str) -> None:
    assert why_it_ended({ENTRY: looped(handler)}, ENTRY, has_stepped=True) == ""


LOOP = "while robot.step(32) != -1 and n < 9:\n    n += 1\n"


@pytest.mark.parametrize(
    "program",
    [
        "try:\n    import cv2\nexcept:\n    cv2 = None\n" + LOOP,
        "try:\n    robot.getDevice('kicker').enable(32)\nexcept:\n    pass\n" + LOOP,
        LOOP + "    try:\n        x = float(word)\n    except:\n        x = 0\n",
        "def read():\n    try:\n        return float(word)\n    except:\n        return 0\n" + LOOP + "    read()\n",
        "for tick in range(9):\n    try:\n        robot.step(32)\n        1 / 0\n    except:\n        pass\n",
        # What is called from the loop does not lead to it.
        (
            "def read():\n    try:\n        look()\n    except:\n        pass\ndef look():\n    return float(word)\n"
            "def play():\n    while robot.step(32) != -1 and n < 9:\n        read()\nplay()\n"
        ),
        "def read():\n    while True:\n        try:\n            return float(word)\n        except:\n            break\n"
        + LOOP,
    ],
    ids=[
        "of an import",
        "of a device",
        "in the loop",
        "in a function",
        "around step in a loop that goes on",
        "called in it",
        "in another loop",
    ],
)
def test_one_after_which_the_loop_goes_on_is_not_what_ended_the_program(program: str) -> None:
    for written in (program, program.replace("except:\n", "except Exception as e:\n        print(e)\n")):
        assert why_it_ended({ENTRY: (BEGIN + written).encode()}, ENTRY, has_stepped=True) == ""


@pytest.mark.parametrize(
    "program",
    [
        "while robot.step(32) != -1:\n    try:\n        1 / 0\n    except Exception as e:\n        break\n",
        "goes_on = True\nwhile robot.step(32) != -1 and goes_on:\n    try:\n        1 / 0\n    except:\n        goes_on = False\n",
        "def play():\n    while robot.step(32) != -1:\n        1 / 0\ntry:\n    play()\nexcept:\n    pass\n",
        "def play():\n    while robot.step(32) != -1:\n        1 / 0\ndef main():\n    play()\ntry:\n    main()\nexcept:\n    pass\n",
        (
            "class Player:\n    def run(self):\n        while robot.step(32) != -1:\n            1 / 0\n"
            "    def begin(self):\n        self.run()\nplayer = Player()\ntry:\n    player.begin()\nexcept:\n    pass\n"
        ),
        (
            "class Player:\n    def __init__(self):\n        self.run()\n    def run(self):\n"
            "        while robot.step(32) != -1:\n            1 / 0\ndef main():\n    Player()\ntry:\n    main()\nexcept:\n    pass\n"
        ),
        "def step():\n    try:\n        return robot.step(look())\n    except:\n        return -1\nwhile step() != -1:\n    pass\n",
        "for tick in range(9999):\n    robot.step(32)\n    try:\n        1 / 0\n    except:\n        break\n",
        "def play():\n    while robot.step(32) != -1:\n        1 / 0\ntry: play()\nexcept: pass\n",
    ],
    ids=[
        "break",
        "a flag",
        "around the call",
        "a call of a call",
        "a method of a method",
        "made",
        "around step",
        "for",
        "a try in one line",
    ],
)
def test_one_that_leaves_the_loop_is_named(program: str) -> None:
    assert "takes every error" in why_it_ended({ENTRY: (BEGIN + program).encode()}, ENTRY, has_stepped=True)


def test_the_file_is_named_where_it_is_not_the_program() -> None:
    files = {ENTRY: b"import player\nplayer.play()\n", PurePosixPath("player.py"): looped("except:\n    pass")}
    assert why_it_ended(files, ENTRY, has_stepped=True) == SAYS.replace("line 6", "line 6 of player.py")


STANDS = "while robot.step(32) != -1:\n    try:\n        left.setVelocity(speed)\n    except:\n        pass\n"


@pytest.mark.parametrize(
    "program",
    [
        STANDS,
        STANDS.replace("pass", "print('oh no')"),
        STANDS.replace("left.setVelocity(speed)", "left.velocity = speed"),
        (
            "def drive():\n    left.setVelocity(speed)\ndef play():\n    drive()\n"
            "while robot.step(32) != -1:\n    try:\n        play()\n    except Exception:\n        continue\n"
        ),
        "try:\n    left.setPosition(float('int'))\nexcept:\n    pass\n" + LOOP,
        "while robot.step(32) != -1:\n    try: left.setVelocity(speed)\n    except: pass\n",
    ],
    ids=["in the loop", "it says something", "a property", "a call of a call", "before the loop", "in one line"],
)
def test_of_a_robot_that_stands_an_except_that_may_keep_it_from_driving_is_named(program: str) -> None:
    content = (BEGIN + program).encode()
    number = 1 + next(number for number, line in enumerate(content.splitlines()) if b"except" in line)
    assert why_it_stands({ENTRY: content}, ENTRY) == (
        f'the "except" in line {number} takes every error and keeps quiet about it: write traceback.print_exc() there, '
        "and import traceback at the top"
    )


@pytest.mark.parametrize(
    "program",
    [
        STANDS.replace("except:", "except ValueError:"),
        STANDS.replace("except:", "except Exception as e:").replace("pass", "print(e)"),
        STANDS.replace("pass", "raise"),
        STANDS.replace("left.setVelocity(speed)", "x = ball.getEmitterDirection()"),
        "left.setVelocity(5)\ntry:\n    import cv2\nexcept:\n    cv2 = None\n" + LOOP,
    ],
    ids=["it takes some only", "it tells them", "it lets them pass", "nothing drives there", "of an import"],
)
def test_of_others_nothing_is_said(program: str) -> None:
    assert why_it_stands({ENTRY: (BEGIN + program).encode()}, ENTRY) == ""


def test_a_check_says_so_of_robots_that_stand(tmp_path) -> None:
    path = tmp_path / "robot.py"
    path.write_text(BEGIN + STANDS, encoding="utf-8")
    (found,) = [
        one
        for stage in check_file(path, alone(), CheckOptions(play_s=1.0)).stages
        for one in stage.findings
        if one.code == "play.stands"
    ]
    hidden = why_it_stands({ENTRY: path.read_bytes()}, ENTRY)
    assert hidden
    assert found.remedy.endswith(f"setVelocity on both motors; or an error is hidden: {hidden}")


def test_a_check_says_so(tmp_path) -> None:
    path = tmp_path / "robot.py"
    path.write_bytes(looped("except:\n    pass"))
    report = check_file(path, alone(), CheckOptions(play_s=1.0))
    (found,) = [one for stage in report.stages for one in stage.findings if one.level == "failure"]
    assert "came to its end" in found.message
    assert found.remedy == SAYS
