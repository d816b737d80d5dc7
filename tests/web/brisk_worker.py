"""Dispatchers whose checks and matches take a moment only, for tests in which they die by the dozen.

Everything of them is as it is but the check and the match themselves, and the times. Run as a process with the folder of a site, it starts
one for each line of its standard input by a fork, and prints its process.
"""

from __future__ import annotations

import hashlib
import os
import random
import signal
import sys
import time
from datetime import timedelta
from pathlib import Path
from typing import Any

from rcj_challenges.web.config import load_site, set_up

LEASE_S = 2.0
CHECK_S = 0.04


def result_of(seed: int, blue: str, yellow: str) -> dict[str, Any]:
    """Return the made-up result of a match, which depends on its inputs as that of a played one does."""
    digest = hashlib.sha256(f"{seed}/{blue}/{yellow}".encode()).hexdigest()
    score = {"blue": int(digest[0], 16) % 4, "yellow": int(digest[1], 16) % 4}
    return {"score": score, "digest": digest, "faults": []}


def main(folder: str) -> None:
    config = load_site(Path(folder))
    set_up(config)
    from django.db import connections
    from django.utils import timezone

    from rcj_challenges.web import dispatcher, jobs, seasons
    from rcj_challenges.web.models import Audit, State

    jobs.LEASE, jobs.HEARTBEAT_S = timedelta(seconds=LEASE_S), 0.3
    jobs._RETRY_AFTER, dispatcher._POLL_S = timedelta(seconds=0.2), 0.05

    class Brisk(dispatcher.Dispatcher):
        def _do(self, job, claim):
            time.sleep(random.random() * CHECK_S)  # noqa: S311 - no secret
            if job.match is not None:
                return self._store_result(job.match)
            submission = job.submission
            verdict = jobs.Verdict(State.ACCEPTED, "passed", submission.sha256, {"level": "passed"})

            def store(_job):
                jobs.store_verdict(submission, verdict)
                Audit.objects.create(at=timezone.now(), actor=self.name, act="verdict", about=job.key)

            return store

        def _store_result(self, match):
            answer = {"result": result_of(match.seed, match.blue.digest, match.yellow.digest), "is_doubtful": False}

            def store(job):
                seasons.store_result(match, answer, timezone.now())
                Audit.objects.create(at=timezone.now(), actor=self.name, act="result", about=job.key)

            return store

    parent = os.getpid()
    signal.signal(signal.SIGCHLD, signal.SIG_IGN)
    connections.close_all()
    for _ in sys.stdin:
        pid = os.fork()
        if pid == 0:
            signal.signal(signal.SIGCHLD, signal.SIG_DFL)
            Brisk(config).run(parent)
            os._exit(0)
        print(pid, flush=True)


if __name__ == "__main__":
    main(sys.argv[1])
