"""``rcj-challenge tournament play-job``: plays one match for the pool of workers."""

from __future__ import annotations

import json
import os
from pathlib import Path

from rcj_challenges.cli.stdio import print_json
from rcj_challenges.cli.tournament.group import tournament_app


@tournament_app.command("play-job", hidden=True)
def play_job(job: str, data: Path) -> None:
    """Play one job in this process, for the pool of workers; print its result as JSON."""
    # MuJoCo would load a window system's library, 50 ms, and a match draws nothing.
    os.environ.setdefault("MUJOCO_GL", "disable")
    from rcj_challenges.tournament.jobs import MatchJob, Workplace
    from rcj_challenges.tournament.playing import play_job as play

    played = play(MatchJob.from_json(json.loads(job)), Workplace(data))
    print_json({**played.result, "folder": str(played.folder)})
