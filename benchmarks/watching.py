"""The bars of watching: the replay page, the live view, films.

    python -m benchmarks.watching [--json] [--rounds 10] [--chromium /usr/bin/chromium]

Pages are measured in headless Chromium without a GPU, once as it starts by itself (WebGL by SwiftShader, pages put
together by the processor) and once with everything by SwiftShader; beside each stands the floor of the same minutes:
a page that only clears a canvas of the same size. Costs of the live view are ratios of alternating matches.
"""

from __future__ import annotations

import contextlib
import os
import re
import shutil
import socket
import statistics
import subprocess
import sys
import tempfile
import threading
import time
import tracemalloc
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from benchmarks.rows import Row, as_users_have_it, parser, show
from rcj_challenges.match.observers import Observer, ObserverGroup
from rcj_challenges.match.runner import MatchPlan, play_match
from rcj_challenges.scenario.load import load
from rcj_challenges.submissions.team import open_team
from rcj_challenges.views.live import MAX_SPEED, LiveShow
from rcj_challenges.views.replay.page import write_replay

PROGRAM = Path(__file__).parent / "programs" / "trivial" / "robot.py"
HALF_S = 600.0
LIVE_S = 120.0
SPECTATORS = 2
WATCHED_S = 4.0
SETTLING_MS = 500
BROWSERS = {
    "as it starts": ["--no-sandbox"],
    "all by SwiftShader": [
        "--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
        "--ignore-gpu-blocklist",
    ],
}  # fmt: skip
FLOOR = """<body style="margin:0"><canvas id=c width=1006 height=622></canvas><script>
window.frames_drawn = 0;
const gl = c.getContext("webgl2", {alpha: false, antialias: false});
(function draw() {
  gl.clearColor((window.frames_drawn++ % 60) / 60, 0, 0, 1); gl.clear(gl.COLOR_BUFFER_BIT); requestAnimationFrame(draw);
})();</script>"""
READER = """
import socket, sys
line = socket.create_connection(("127.0.0.1", int(sys.argv[1])))
line.sendall(sys.argv[2].encode())
while line.recv(65536):
    pass
"""


def match_of(seconds: float, out: Path, show: LiveShow | None = None) -> tuple[Path, float]:
    """Play a half with six trivial programs; returns the folder of its record, and its wall time in s."""
    loaded = load("match", ["match.halves=1", f"match.half_s={seconds:g}"])
    seats = tuple(loaded.scenario.entrants.values())
    teams = {seat: open_team(PROGRAM, *seats) for seat in loaded.scenario.entrants}
    plan = MatchPlan(loaded, teams, {}, seed=3, out=out)
    observer = Observer() if show is None else ObserverGroup(Observer(), show.observer)
    played = play_match(plan, observer)
    return played.folder, float(played.result["wall_s"])


@contextlib.contextmanager
def spectators(port: int, match: str) -> Iterator[None]:
    """Let some read the feed of a live match, each in a process of its own."""
    request = f"GET /feed?match={match}&from=0 HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\n\r\n"
    readers = [
        subprocess.Popen([sys.executable, "-S", "-c", READER, str(port), request]) for _ in range(SPECTATORS)
    ]  # fmt: skip
    try:
        yield
    finally:
        for reader in readers:
            reader.kill()
            reader.wait()


def live_cost(rounds: int, out: Path) -> float:
    """Return by how many percent a live view with spectators slows a match: medians of alternating matches."""
    plain, live = [], []
    loaded = load("match", ["match.halves=1", f"match.half_s={LIVE_S:g}"])
    match_of(LIVE_S, out)
    for _ in range(rounds):
        plain.append(match_of(LIVE_S, out)[1])
        with LiveShow(loaded.scenario, {}, 3, speed=MAX_SPEED) as show:
            page = _get(show.port)
            match = re.search(r'"match":\s*"([\w-]+)"', page)
            assert match is not None, "the page does not name its match"
            with spectators(show.port, match[1]):
                live.append(match_of(LIVE_S, out, show)[1])
    return round((statistics.median(live) / statistics.median(plain) - 1) * 100, 1)


def _get(port: int) -> str:
    with socket.create_connection(("127.0.0.1", port)) as line:
        line.sendall(f"GET / HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\nConnection: close\r\n\r\n".encode())
        return b"".join(iter(lambda: line.recv(65536), b"")).decode("utf-8", "replace")


def replay_rows(record: Path) -> list[Row]:
    """Measure the writing of the page of a half, and its size."""
    times = []
    for _ in range(3):
        began = time.perf_counter()
        page = write_replay(record)
        times.append(time.perf_counter() - began)
    tracemalloc.start()
    write_replay(record)
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    return [
        Row("replay of a half, written", round(statistics.median(times), 2), "s", 0.6),
        Row("replay of a half, memory", round(peak / 1e6), "MB", 100.0),
        Row("replay of a half, size", round(page.stat().st_size / 1e6, 2), "MB", 2.0),
    ]


def page_rows(page: Path, chromium: str) -> list[Row]:
    """Measure frames a second of a playing page, and until it can be used."""
    from playwright.sync_api import ViewportSize, sync_playwright  # noqa: PLC0415 - the other rows do without

    wide = ViewportSize(width=1366, height=768)
    made = []
    with sync_playwright() as driver:
        for name, arguments in BROWSERS.items():
            browser = driver.chromium.launch(executable_path=chromium, args=arguments)
            floor = browser.new_page(viewport=wide)
            floor.set_content(FLOOR)
            made.append(Row(f"a page that only clears, {name}", _frames(floor, "frames_drawn"), "frames/s", None))
            floor.close()
            tab = browser.new_page(viewport=wide)
            began = time.perf_counter()
            tab.goto(page.as_uri())
            tab.wait_for_selector("body.ready")
            ready_s = time.perf_counter() - began
            tab.evaluate("replay.app.player.start(1, 1), replay.app.changed()")
            made.append(Row(f"replay page, {name}", _frames(tab, "replay.app.drawn"), "frames/s", 60.0, None, True))
            made.append(Row(f"replay page usable, {name}", round(ready_s, 2), "s", 1.0))
            browser.close()
    return made


def _frames(tab: Any, counter: str) -> float:
    """Return how many frames a second a page draws: the most of three stretches, for others use this machine too."""
    best = 0.0
    for _ in range(3):
        tab.wait_for_timeout(SETTLING_MS)
        first, began = tab.evaluate(counter), time.perf_counter()
        tab.wait_for_timeout(WATCHED_S * 1000)
        last = tab.evaluate(counter)
        best = max(best, (last - first) / (time.perf_counter() - began))
    # A screen of 60 Hz shows 60 frames at most, and the clocks differ a little.
    return float(round(best))


def film_rows(record: Path, out: Path) -> list[Row]:
    """Measure pictures a second of a video at 720p."""
    done = subprocess.run(
        [sys.executable, "-m", "rcj_challenges", "video", str(record), "--from", "5", "--to", "25", "--camera", "top",
         "--out", str(out / "video.mp4")],
        check=True, capture_output=True, text=True, env=as_users_have_it(),
    )  # fmt: skip
    rate = re.search(r"(\d+) a second", done.stderr + done.stdout)
    assert rate is not None, done.stderr
    return [Row("film at 720p", float(rate[1]), "frames/s", 25.0, None, True)]


def main() -> int:
    """Print the table; exit code 1 if a must is missed."""
    options = parser("the bars of watching, measured")
    options.add_argument("--rounds", type=int, default=10)
    options.add_argument("--chromium", default=shutil.which("chromium") or "")
    given = options.parse_args()
    os.environ.pop("PYTHONDONTWRITEBYTECODE", None)
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder)
        record, _ = match_of(HALF_S, out)
        rows = replay_rows(record)
        if given.chromium:
            # Its driver must not share a thread with anything that waits.
            pages: list[Row] = []
            thread = threading.Thread(target=lambda: pages.extend(page_rows(record / "replay.html", given.chromium)))
            thread.start()
            thread.join()
            rows += pages
        rows.append(Row(f"live, {SPECTATORS} spectators, cost", live_cost(given.rounds, out), "%", 5.0))
        rows += film_rows(record, out)
    return show(rows, as_json=given.json)


if __name__ == "__main__":
    sys.exit(main())
