"""Spectators of the stage, other pages, and two lanes that play, all on one computer.

    python -m benchmarks.stage [--json] [--spectators 200] [--rounds 4] [--window-s 60] [--teams 12] [--half-s 30]

Rounds with and without spectators alternate. A delay is that of a step of the feed, from the moment at which it may be
sent to its arrival at a spectator; all spectators are in one process, which shares the processors with the site.
"""

from __future__ import annotations

import asyncio
import json
import os
import statistics
import sys
import tempfile
import time
from collections.abc import Sequence
from concurrent.futures import ProcessPoolExecutor
from datetime import timedelta
from itertools import pairwise
from multiprocessing import get_context
from pathlib import Path
from typing import Any, NamedTuple
from urllib.parse import urlsplit

from benchmarks.club import Site, begin, variation
from benchmarks.rows import Row, parser, show
from rcj_challenges.web.config import load_site, make_site, set_up
from rcj_challenges.web.serving import migrate

PAGES = ("/live", "/ladder", "/", "/help", "/teams/1")
PAGES_PER_S = 5
_LEAD_S = 5.0
_WAIT_S = 900.0
_MATCHES_FIRST = 4
_TICKS_PER_S = os.sysconf("SC_CLK_TCK")


class Window:
    """What was measured while spectators watched, or while there were none."""

    def __init__(self) -> None:
        self.delays_s: list[float] = []
        self.pages_s: list[float] = []
        self.lanes_s: list[float] = []
        self.cpu_s = 0.0
        self.length_s = 0.0
        self.lost = 0


class Crowd(NamedTuple):
    """So many spectators, in a process of their own: else their work would delay what loads the other pages."""

    pool: ProcessPoolExecutor
    count: int


async def _ask(address: str, path: str) -> tuple[asyncio.StreamReader, asyncio.StreamWriter]:
    parts = urlsplit(address)
    reader, writer = await asyncio.open_connection(parts.hostname, parts.port)
    writer.write(f"GET {path} HTTP/1.1\r\nHost: {parts.netloc}\r\nConnection: close\r\n\r\n".encode())
    head = await reader.readuntil(b"\r\n\r\n")
    if b" 200 " not in head.split(b"\r\n", 1)[0]:
        raise ConnectionError(head.decode("latin-1"))
    return reader, writer


async def _watch(address: str, release: dict[str, Any], path: str, window: Window) -> None:
    """Be a spectator: note when each step has come."""
    steps = [
        (end, release["begins_s"] + step * release["step_s"])
        for step, (before, end) in enumerate(pairwise([0, *release["ends"]]), 1)
        if end > before  # in a break nothing comes
    ]
    total = 0
    try:
        reader, writer = await _ask(address, path)
        try:
            while size := int((await reader.readuntil(b"\r\n")).strip(), 16):
                body = (await reader.readexactly(size + 2))[:-2]
                total += 0 if body == bytes(5) else size
                now_s = time.time()
                while steps and steps[0][0] <= total:
                    window.delays_s.append(now_s - steps.pop(0)[1])
        finally:
            writer.close()
    except (OSError, asyncio.IncompleteReadError):
        window.lost += 1


async def _load_page(address: str, path: str, window: Window) -> None:
    began = time.monotonic()
    reader, writer = await _ask(address, path)
    await reader.read()
    writer.close()
    window.pages_s.append(time.monotonic() - began)


async def _visit(address: str, until_s: float, window: Window) -> None:
    loads, number = [], 0
    while time.monotonic() < until_s:
        loads.append(asyncio.create_task(_load_page(address, PAGES[number % len(PAGES)], window)))
        number += 1
        await asyncio.sleep(1 / PAGES_PER_S)
    await asyncio.gather(*loads)


async def _crowd(address: str, release: dict[str, Any], path: str, count: int, until_s: float) -> Window:
    window = Window()
    spectators = [asyncio.create_task(_watch(address, release, path, window)) for _ in range(count)]
    await asyncio.sleep(until_s - time.time())
    for one in spectators:
        one.cancel()
    await asyncio.gather(*spectators, return_exceptions=True)
    return window


def _crowd_of(*arguments: Any) -> Window:
    return asyncio.run(_crowd(*arguments))


def _measure(
    site: Site, window: Window, length_s: float, feed: tuple[str, dict[str, Any]] | None, crowd: Crowd
) -> None:
    coming = None
    if feed is not None:
        begins_s = feed[1]["begins_s"]
        coming = crowd.pool.submit(_crowd_of, site.address, feed[1], feed[0], crowd.count, begins_s + length_s)
        time.sleep(max(0.0, begins_s - time.time()))
    began_cpu_s, began = _cpu_s(site.process.pid), time.monotonic()
    asyncio.run(_visit(site.address, began + length_s, window))
    window.cpu_s += _cpu_s(site.process.pid) - began_cpu_s
    window.length_s += time.monotonic() - began
    if coming is not None:
        seen = coming.result()
        window.delays_s += seen.delays_s
        window.lost += seen.lost


def _cpu_s(pid: int) -> float:
    fields = Path(f"/proc/{pid}/stat").read_text(encoding="utf-8").rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / _TICKS_PER_S


def _planned(folder: Path) -> tuple[str, dict[str, Any]]:
    """Put the last match on the stage; return the address of its feed, and its times."""
    from django.utils import timezone  # noqa: PLC0415 - once Django is set up

    from rcj_challenges.web import jobs, seasons, stage  # noqa: PLC0415
    from rcj_challenges.web.models import Show  # noqa: PLC0415

    stage.LEAD = timedelta(seconds=_LEAD_S)
    with jobs.writing():
        stage.take_off(Show.objects.all())
    match = stage.candidates(seasons.shown_basis(seasons.current()))[0]
    found = stage.schedule(match, timezone.now(), timezone.now(), is_chosen=True)
    assert found is not None
    release = json.loads((folder / "live" / str(found.pk) / "release.json").read_text(encoding="ascii"))
    return f"/live/{found.pk}/feed?from=0", release


def play(folder: Path, spectators: int, rounds: int, window_s: float, teams: int, half_s: float) -> list[Row]:
    """Measure; returns what was measured."""
    make_site(folder, "Club")
    settings = folder / "site.yaml"
    # One lane of several is kept for checks.
    settings.write_text(settings.read_text(encoding="utf-8").replace("lanes: 2", "lanes: 3"), encoding="utf-8")
    config = load_site(folder)
    set_up(config)
    migrate(config)
    from django.utils import timezone  # noqa: PLC0415 - once Django is set up

    from rcj_challenges.web.models import Job, JobState, Match, State, Submission  # noqa: PLC0415

    codes, loads = begin(teams, half_s), []
    site, on, off = Site(config), Window(), Window()
    crowd = Crowd(ProcessPoolExecutor(1, get_context("spawn")), spectators)
    crowd.pool.submit(os.getpid).result()
    try:
        for number, code in enumerate(codes):
            site.hand_in(code, variation(number))
        until = time.monotonic() + _WAIT_S
        checks = Submission.objects.filter(state__in=(State.QUEUED, State.CHECKING))
        while checks.exists() or Match.objects.filter(played_at__isnull=False).count() < _MATCHES_FIRST:
            if time.monotonic() > until:
                raise TimeoutError("no match was played")
            time.sleep(1.0)
        for number in range(2 * rounds):
            window, began_at = (on, off)[number % 2], timezone.now()
            _measure(site, window, window_s, None if number % 2 else _planned(folder), crowd)
            ended = Job.objects.filter(state=JobState.DONE, match__isnull=False, started_at__gt=began_at)
            window.lanes_s += ended.values_list("lane_s", flat=True)
            loads.append(os.getloadavg()[0])
    finally:
        crowd.pool.shutdown()
        site.end()
    return _rows(on, off, loads)


def _p99(numbers: Sequence[float]) -> float:
    return sorted(numbers)[int(0.99 * len(numbers))] if numbers else float("nan")


def _rows(on: Window, off: Window, loads: list[float]) -> list[Row]:
    ratio = (
        statistics.median(on.lanes_s) / statistics.median(off.lanes_s) if on.lanes_s and off.lanes_s else float("nan")
    )
    return [
        Row("delay of the feed, p99", round(_p99(on.delays_s), 3), "s", 1.0),
        Row("delay of the feed, median", round(statistics.median(on.delays_s), 4), "s", None),
        Row("steps that came before their time", sum(one < 0 for one in on.delays_s), "", 0),
        Row("steps that came", len(on.delays_s), "", None),
        Row("spectators that lost the feed", on.lost, "", 0),
        Row("page with spectators, p99", round(1000 * _p99(on.pages_s)), "ms", 500),
        Row("page with spectators, median", round(1000 * statistics.median(on.pages_s)), "ms", None),
        Row("page without, p99", round(1000 * _p99(off.pages_s)), "ms", None),
        Row("page without, median", round(1000 * statistics.median(off.pages_s)), "ms", None),
        Row("time of a match, with : without", round(ratio, 3), "", 1.05),
        Row("matches measured, with", len(on.lanes_s), "", None),
        Row("matches measured, without", len(off.lanes_s), "", None),
        Row("processor of the pages, with", round(on.cpu_s / on.length_s, 3), "", None),
        Row("processor of the pages, without", round(off.cpu_s / off.length_s, 3), "", None),
        Row("load average", round(statistics.median(loads), 1), "", None),
    ]


def main() -> int:
    """Measure; returns the exit code."""
    arguments = parser(__doc__ or "")
    arguments.add_argument("--spectators", type=int, default=200)
    arguments.add_argument("--rounds", type=int, default=4)
    arguments.add_argument("--window-s", type=float, default=60.0)
    arguments.add_argument("--teams", type=int, default=12)
    arguments.add_argument("--half-s", type=float, default=30.0)
    given = arguments.parse_args()
    with tempfile.TemporaryDirectory(prefix="rcj-stage-") as temporary:
        measured = play(
            Path(temporary) / "club", given.spectators, given.rounds, given.window_s, given.teams, given.half_s
        )
        return show(measured, as_json=given.json)


if __name__ == "__main__":
    sys.exit(main())
