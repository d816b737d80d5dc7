"""``python -m rcj_challenges`` is the command ``rcj-challenge``."""

import os
import sys


def _forget_current_folder() -> None:
    """Look for no module in the current folder, as the command does not: what lies there may be a team's."""
    try:
        here = os.getcwd()  # noqa: PTH109 - pathlib would be looked for there as well
    except OSError:  # it is gone, and Python has not put it first
        return
    if sys.path[:1] in ([""], [here]):
        del sys.path[0]


if __name__ == "__main__":
    _forget_current_folder()
    from rcj_challenges.cli import main

    main()
