"""What is told of a program that came to its end because it keeps quiet about its errors."""

from __future__ import annotations

from pathlib import PurePosixPath

import pytest

from rcj_challenges.checker.advice.early_ends import why_it_ended
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
    ],
)
def test_an_except_that_takes_every_error_and_tells_none_is_named(handler: str) -> None:
    assert why_it_ended({ENTRY: looped(handler)}, ENTRY, has_stepped=True) == SAYS


@pytest.mark.parametrize(
    "handler",
    [
        "except Exception as e:\n    print('something went wrong', e)",
        "except Exception as e: print(e)",
        "except:\n    import traceback\n    traceback.print_exc()",
        "except:\n    print(sys.exc_info())",
        "except:\n    logging.exception('oh')",
        "except:\n    raise",
        "except ValueError:\n    pass",
        "finally:\n    pass",
    ],
)
def test_nothing_is_said_of_one_that_tells_them_or_takes_some_only(handler: str) -> None:
    assert why_it_ended({ENTRY: looped(handler)}, ENTRY, has_stepped=True) == ""


def test_the_file_is_named_where_it_is_not_the_program() -> None:
    files = {ENTRY: b"import player\nplayer.play()\n", PurePosixPath("player.py"): looped("except:\n    pass")}
    assert why_it_ended(files, ENTRY, has_stepped=True) == SAYS.replace("line 6", "line 6 of player.py")


def test_a_check_says_so(tmp_path) -> None:
    path = tmp_path / "robot.py"
    path.write_bytes(looped("except:\n    pass"))
    report = check_file(path, alone(), CheckOptions(play_s=1.0))
    (found,) = [one for stage in report.stages for one in stage.findings if one.level == "failure"]
    assert "came to its end" in found.message
    assert found.remedy == SAYS
