"""The process of an event: it plays what is to be played of its tournament, and publishes what may be shown."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from datetime import timedelta
from pathlib import Path
from typing import Any

from rcj_challenges.records.folder import utc_now
from rcj_challenges.tournament.admission import take_submissions
from rcj_challenges.tournament.executor import LocalExecutor
from rcj_challenges.tournament.fixtures import JobMaker
from rcj_challenges.tournament.opened import OpenTournament, open_tournament
from rcj_challenges.tournament.reconcile import reconcile
from rcj_challenges.tournament.release import release_times
from rcj_challenges.tournament.runner import Progress, Runner, RunObserver
from rcj_challenges.tournament.season import Fixture, Outcome
from rcj_challenges.tournament.site import publish, site_source
from rcj_challenges.web.codes import EVENT_CHANGED
from rcj_challenges.web.errors import SiteError

_PUBLISHED_EVERY_S = 60.0
_PREMIERE = timedelta(seconds=30)
"""How often it is looked whether a premiere is over."""


def play_event(request: Mapping[str, Any], write: Callable[[dict[str, Any]], None]) -> dict[str, Any]:
    """Play and publish an event in this process.

    Returns:
        Why matches could not be played, whether all is played, and when there is something new to be shown.

    Raises:
        RcjError: the tournament cannot be played on this computer, or its archives are not those that were frozen.
    """
    with open_tournament(request["file"], Path(request["data"]), writing=request["plays"]) as tournament:
        watch = _Watch(tournament, request, write)
        if request["plays"]:
            watch.play()
        return {"failed": watch.failed, **watch.publish()}


@dataclass
class _Watch(RunObserver):
    """Publishes the tournament while it is played, and reports its progress."""

    tournament: OpenTournament
    request: Mapping[str, Any]
    write: Callable[[dict[str, Any]], None]
    failed: list[str] = field(default_factory=list)
    published_at_s: float = 0.0

    def play(self) -> None:
        """Play all that is not played yet."""
        tournament, store = self.tournament, self.tournament.store
        staying = [one for one in tournament.loaded.entries.values() if not tournament.season.teams[one.id].withdrawn]
        handed = take_submissions(staying, store)
        if other := [one.team for one in handed.values() if one.archive != self.request["hashes"][one.team]]:
            message = f"the archive of {', '.join(other)} is not the one that was frozen"
            raise SiteError(message, "copy it from a backup into the folder of the event", code=EVENT_CHANGED)
        tournament.refresh()
        jobs = JobMaker(tournament, store.current_submissions() | handed, self.request["sandbox"])
        reconcile(tournament, jobs, cascade=False)
        Runner(tournament, jobs, LocalExecutor(store.place, self.request["lanes"]), self).run()

    def publish(self) -> dict[str, Any]:
        """Write the site; return whether all is played, and when there will be something new to be shown."""
        tournament, now = OpenTournament(self.tournament.loaded, self.tournament.store), utc_now()
        file = tournament.loaded.tournament
        premieres = [name for name, stage in file.stages.items() if stage.release is not None]
        source = site_source(tournament, now, premieres, self.request["url"])
        publish(replace(source, **self.request["site"]), tournament.store.place.folder, may_shrink=True)
        state, times = tournament.state(), release_times(file, tournament.state())
        hidden = [at for one, at in times.items() if one in state.outcomes and one not in source.state.outcomes]
        self.published_at_s = time.monotonic()
        return {
            "is_over": all(stage.status == "finished" for stage in state.stages),
            "publish_at": max(min(hidden), now + _PREMIERE).isoformat() if hidden else None,
        }

    def played(self, fixture: Fixture, outcome: Outcome, progress: Progress, *, is_doubtful: bool) -> None:
        """Report how many matches are played."""
        self.write({"stage": f"{progress.done}/{progress.done + progress.left}"})
        if time.monotonic() > self.published_at_s + _PUBLISHED_EVERY_S:
            self.publish()

    def not_played(self, fixture: Fixture, complaint: str) -> None:
        """Note that a match could not be played."""
        self.failed.append(f"{fixture.id}: {complaint}")
