"""``rcj-challenge replay``: writes the page of a record again."""

from __future__ import annotations

import sys
from pathlib import Path

from rcj_challenges.cli.app import WATCH, app
from rcj_challenges.cli.options import Run, RunsFolder
from rcj_challenges.cli.stdio import shown_path
from rcj_challenges.core.sanitize import sanitize


@app.register(WATCH, "rcj-challenge replay")
def replay(run: Run = None, out: RunsFolder = Path("runs")) -> None:
    """Write the replay page of a record again."""
    from rcj_challenges.records.run_record import read_run
    from rcj_challenges.views.replay import write_replay
    from rcj_challenges.views.replay.browse import find_run

    folder = find_run(run, out)
    sys.stdout.write(f"{shown_path(write_replay(folder))}\n")
    for problem in read_run(folder).problems:
        sys.stderr.write(f"{sanitize(problem, 500)}\n")
