"""A club that plays a ladder by itself: variations of the sample teams, uploads in between, and two kills.

    python -m benchmarks.club [--json] [--minutes 60] [--teams 20] [--half-s 150] [--keep FOLDER]

At a third of the time the dispatcher is killed, at two thirds the whole site, which is then started again. In the end
the table that follows from the published results is compared with the published one, and some matches are played again
and compared with their results.
"""

from __future__ import annotations

import io
import json
import os
import re
import signal
import subprocess
import sys
import tempfile
import time
import urllib.request
import zipfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

from benchmarks.rows import Row, as_users_have_it, parser, show
from rcj_challenges.scenario.resources import shipped_teams
from rcj_challenges.web.config import SiteConfig, load_site, make_site, set_up
from rcj_challenges.web.serving import migrate

SAMPLES = ("all_sensors", "roles_and_radio", "ball_chaser")
_COMMAND = [sys.executable, "-P", "-m", "rcj_challenges", "site"]
_SPEED = re.compile(r"^MAX_SPEED = 10\b", re.MULTILINE)
_UPLOADS = 6
_AGAIN = 5
_SETTLE_S = 900.0


def variation(number: int) -> bytes:
    """Return the ZIP of a sample team that drives at most so fast."""
    folder = shipped_teams()[SAMPLES[number % len(SAMPLES)]]
    made = io.BytesIO()
    with zipfile.ZipFile(made, "w", zipfile.ZIP_DEFLATED) as archive:
        for path in sorted(folder.rglob("*.py")):
            text = _SPEED.sub(f"MAX_SPEED = {10 - 0.2 * number:g}", path.read_text(encoding="utf-8"))
            archive.writestr(path.relative_to(folder).as_posix(), text)
    return made.getvalue()


class Site:
    """The site as a process.

    Args:
        config: its settings.
    """

    def __init__(self, config: SiteConfig) -> None:
        self._config = config
        self._port = 0
        self.start()

    def start(self) -> None:
        """Start it, and wait until it listens."""
        with (self._config.folder / "log").open("ab") as log:
            self.process = subprocess.Popen(
                [*_COMMAND, "serve", str(self._config.folder), "--port", str(self._port)],
                stdout=subprocess.PIPE, stderr=log, text=True, env=as_users_have_it(), start_new_session=True,
            )  # fmt: skip
        assert self.process.stdout is not None
        self.address = self.process.stdout.readline().rsplit(": ", 1)[1].strip()
        self._port = int(self.address.rsplit(":", 1)[1])

    def kill(self) -> None:
        """Kill the process of the pages, with which its dispatcher ends, and start again."""
        self.process.kill()
        self.end()
        self.start()

    def end(self, sign: int = signal.SIGINT) -> None:
        """End it."""
        if self.process.poll() is None:
            self.process.send_signal(sign)
        self.process.wait(60)
        assert self.process.stdout is not None
        self.process.stdout.close()

    def kill_dispatcher(self) -> None:
        """Kill the dispatcher; the site starts another one."""
        from rcj_challenges.web.models import Worker  # noqa: PLC0415 - once Django is set up

        newest = Worker.objects.order_by("-seen_at").first()
        assert newest is not None
        os.kill(int(newest.name.rsplit("-", 2)[1]), signal.SIGKILL)

    def hand_in(self, code: str, archive: bytes) -> None:
        """Hand an archive in."""
        headers = {"Authorization": f"Bearer {code}", "Content-Type": "application/zip"}
        request = urllib.request.Request(f"{self.address}/api/v1/submissions", archive, headers)  # noqa: S310 - ours
        with urllib.request.urlopen(request, timeout=60) as answer:  # noqa: S310
            assert answer.status == 201

    def results(self) -> bytes:
        """Return the published results."""
        with urllib.request.urlopen(f"{self.address}/api/v1/seasons/1/results", timeout=60) as answer:  # noqa: S310
            return bytes(answer.read())


def play(folder: Path, minutes: float, teams: int, half_s: float) -> list[Row]:
    """Let a club play; returns what was measured."""
    make_site(folder, "Club")
    with (folder / "site.yaml").open("a", encoding="utf-8") as file:
        file.write("uploads_per_hour: 100\n")
    config = load_site(folder)
    set_up(config)
    migrate(config)
    codes = begin(teams, half_s)
    site = Site(config)
    try:
        for number, code in enumerate(codes):
            site.hand_in(code, variation(number))
        began = time.monotonic()
        steps = [(minutes / 3, site.kill_dispatcher), (minutes * 2 / 3, site.kill)]
        steps += [
            (minutes * (1 + upload) / (_UPLOADS + 1), _upload(site, codes[upload % teams], teams + upload))
            for upload in range(_UPLOADS)
        ]
        for after, step in sorted(steps, key=lambda one: one[0]):
            time.sleep(max(0.0, began + 60 * after - time.monotonic()))
            step()
        time.sleep(max(0.0, began + 60 * minutes - time.monotonic()))
        _end()  # the secret is published, and no match of the ladder delays those that are played again
        results = json.loads(site.results())
        (folder / "results.json").write_text(json.dumps(results), encoding="utf-8")
        differing = _played_again(site)
    finally:
        site.end()
    command = [*_COMMAND, "rate", str(folder / "results.json"), "--check"]
    checked = subprocess.run(command, stdout=subprocess.DEVNULL, check=False)
    return _rows(results, minutes, checked.returncode, differing)


def begin(teams: int, half_s: float) -> list[str]:
    """Make a season that has begun, and teams of four groups; returns the codes of their cards."""
    from django.utils import timezone  # noqa: PLC0415 - once Django is set up

    from rcj_challenges.web import jobs, seasons  # noqa: PLC0415
    from rcj_challenges.web.accounts import give_card  # noqa: PLC0415
    from rcj_challenges.web.models import Group, Season, Team  # noqa: PLC0415

    with jobs.writing():
        season = Season.objects.create(title="Season", ladder_overrides=[f"match.half_s={half_s:g}"])
        groups = [Group.objects.create(label=f"School {number}") for number in range(4)]
        made = [Team.objects.create(group=groups[number % 4], name=f"Variation {number}") for number in range(teams)]
        codes = [give_card(team) for team in made]
    seasons.begin(season, timezone.now())
    return codes


def _end() -> None:
    from django.utils import timezone  # noqa: PLC0415 - once Django is set up

    from rcj_challenges.web import seasons  # noqa: PLC0415
    from rcj_challenges.web.models import Season  # noqa: PLC0415

    seasons.end(Season.objects.get(), timezone.now())


def _upload(site: Site, code: str, number: int) -> Callable[[], None]:
    return lambda: site.hand_in(code, variation(number))


def _played_again(site: Site) -> int:
    """Have some matches played again; returns how many ended differently or not at all."""
    from django.utils import timezone  # noqa: PLC0415 - once Django is set up

    from rcj_challenges.web import jobs  # noqa: PLC0415
    from rcj_challenges.web.models import Job, JobState, Match  # noqa: PLC0415

    matches = Match.objects.filter(played_at__isnull=False).order_by("number")
    step = max(1, matches.count() // _AGAIN)
    with jobs.writing():
        asked = [jobs.enqueue("again", match, timezone.now()).pk for match in matches[::step]][:_AGAIN]
    until = time.monotonic() + _SETTLE_S
    waiting = Job.objects.filter(pk__in=asked).exclude(state__in=(JobState.DONE, JobState.STUCK))
    while waiting.exists() and time.monotonic() < until and site.process.poll() is None:
        time.sleep(1.0)
    return Job.objects.filter(pk__in=asked).exclude(state=JobState.DONE).count()


def _rows(results: dict[str, Any], minutes: float, differs: int, differing: int) -> list[Row]:
    from rcj_challenges.web.models import Job, JobState, Match, Submission  # noqa: PLC0415 - once Django is set up

    played = Match.objects.filter(played_at__isnull=False)
    again = Job.objects.filter(attempt__gt=1).count()
    open_checks = Submission.objects.filter(state__in=("queued", "checking", "unchecked")).count()
    ranked = sum(row["rank"] is not None for row in results["table"])
    twice = len(results["matches"]) - len({match["number"] for match in results["matches"]})
    return [
        Row("matches played", played.count(), "", None, more_is_better=True),
        Row("matches in an hour", round(len(results["matches"]) * 60 / minutes), "1/h", None, more_is_better=True),
        Row("programs with a rank", ranked, "", None, more_is_better=True),
        Row("programs in the table", len(results["table"]), "", None),
        Row("jobs leased again", again, "", None),
        Row("matches that were doubtful", played.filter(is_doubtful=True).count(), "", None),
        Row("jobs stuck", Job.objects.filter(state=JobState.STUCK).count(), "", 0),
        Row("submissions without a verdict", open_checks, "", 0),
        Row("matches twice in the table", twice, "", 0),
        Row("matches that ended differently", differing, "", 0),
        Row("table differs from a recomputation", differs, "", 0),
    ]


def main() -> int:
    """Play; returns the exit code."""
    arguments = parser(__doc__ or "")
    arguments.add_argument("--minutes", type=float, default=60.0)
    arguments.add_argument("--teams", type=int, default=20)
    arguments.add_argument("--half-s", type=float, default=150.0)
    arguments.add_argument("--keep", type=Path)
    given = arguments.parse_args()
    with tempfile.TemporaryDirectory(prefix="rcj-club-") as temporary:
        folder = given.keep or Path(temporary) / "club"
        return show(play(folder, given.minutes, given.teams, given.half_s), as_json=given.json)


if __name__ == "__main__":
    sys.exit(main())
