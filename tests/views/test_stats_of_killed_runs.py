"""Figures of a run that was killed: its result tells of whole halves only, and its log goes on beyond its poses."""

import json
import shutil
from pathlib import Path

from rcj_challenges.views.stats import run_stats
from tests.made_up_runs import GOAL_EVERY_TICKS, begun_run


def test_points_of_a_run_that_was_killed_are_those_of_its_log(tmp_path: Path) -> None:
    writer = begun_run(tmp_path, 2 * GOAL_EVERY_TICKS + 50)  # its result tells of whole halves only
    killed = Path(shutil.copytree(writer.folder, tmp_path / "killed"))
    writer.finish({"complete": False})
    teams = run_stats(killed).teams
    assert (teams["Alster"].points, teams["Hanse"].points) == (2, 0)
    # The log goes on for longer than the poses: like judge and the page, the figures end with these.
    log = killed / "referee.jsonl"
    (goal, *_) = (line for line in log.read_text("utf-8").splitlines() if '"kind": "score"' in line)
    with log.open("a", encoding="utf-8") as stream:
        stream.write(json.dumps(json.loads(goal) | {"tick": 2 * GOAL_EVERY_TICKS + 60}) + "\n")
        late = {"kind": "event", "half": 1, "tick": 2 * GOAL_EVERY_TICKS + 60, "event": "LATE", "payload": {}}
        stream.write(json.dumps(late) + "\n")
    stats = run_stats(killed)
    assert stats.teams["Alster"].points == 2
    assert "LATE" not in stats.calls
    (killed / "referee.jsonl").unlink()
    assert run_stats(killed).teams["Alster"].points == 0
