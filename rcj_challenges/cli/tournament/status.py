"""``rcj-challenge tournament status``: how far a tournament is."""

from __future__ import annotations

from contextlib import suppress
from typing import TYPE_CHECKING, Any

from rcj_challenges.cli.app import PLAY
from rcj_challenges.cli.options import Json
from rcj_challenges.cli.stdio import print_json, print_safely
from rcj_challenges.cli.tournament.group import Data, File, opened, tournament_app
from rcj_challenges.cli.tournament.tables import duration_words, score_words
from rcj_challenges.core.sanitize import sanitize

if TYPE_CHECKING:
    from rcj_challenges.tournament.jobs import Workplace

_NEWEST_SHOWN = 5


@tournament_app.register(PLAY, "rcj-challenge tournament status cup")
def status(file: File, data: Data = None, json_: Json = False) -> None:
    """Show the progress: matches by stage, doubtful ones, and those that could not be played."""
    from rcj_challenges.tournament.store.lock import is_locked

    with opened(file, data) as tournament:
        state, store = tournament.state(), tournament.store
        stages = [
            {
                "stage": stage.name,
                "title": stage.title,
                "status": stage.status.value,
                "done": sum(fixture.id in state.outcomes for fixture in stage.fixtures),
                "expected": stage.expected_matches,
            }
            for stage in state.stages
        ]
        is_running = is_locked(store.place.folder)
        progress = _progress(store.place) if is_running else {}
        newest = [one for one in store.latest_fixtures(_NEWEST_SHOWN) if one in state.outcomes]
        fixtures = {fixture.id: fixture for fixture in state.fixtures}
        found: dict[str, Any] = {
            "title": tournament.loaded.tournament.title,
            "is_running": is_running,
            "in_play": progress.get("in_play", []),
            "left_s": progress.get("left_s"),
            "latest": [{"match": one, "scores": state.outcomes[one].scores} for one in newest],
            "failed_submissions": store.failed_submissions(),
            "stages": stages,
            "doubtful": store.doubtful_fixtures(),
            "failed": store.complaints(),
            "withdrawn": sorted(team.id for team in state.teams.values() if team.withdrawn),
        }
    if json_:
        print_json(found)
        return
    doing = "is being written to at present" if found["is_running"] else "nothing is running"
    lines = [f"{sanitize(found['title'])}: {doing}"]
    lines += [f"in play: {fixture}" for fixture in found["in_play"]]
    lines += [f"about {duration_words(found['left_s'])} left"] if found["left_s"] else []
    lines += [f"{one['stage']}: {one['status']}, {one['done']} of {one['expected']} matches" for one in stages]
    lines += [f"played: {one}  {score_words(fixtures[one], state.outcomes[one], state.teams)}" for one in newest]
    lines += [f"fails the check: {team}: {sanitize(why)}" for team, why in found["failed_submissions"].items()]
    lines += [f"doubtful, a time limit decided something: {fixture}" for fixture in found["doubtful"]]
    lines += [f"withdrawn: {team}" for team in found["withdrawn"]]
    lines += [f"could not be played: {sanitize(complaint.strip())}" for complaint in found["failed"]]
    print_safely("\n".join(lines))


def _progress(place: Workplace) -> dict[str, Any]:
    """Progress that a run has written down; empty if there is none yet."""
    from rcj_challenges.records.lines import parsed

    with suppress(OSError, ValueError):
        return dict(parsed(place.progress.read_bytes()))
    return {}
