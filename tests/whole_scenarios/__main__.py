"""A long search: ``python -m tests.whole_scenarios --seeds 0..1000``; every broken promise is written to a folder."""

from __future__ import annotations

import argparse
import collections
import signal
import sys
import tempfile
import time
import traceback
from pathlib import Path

from tests.parsed_once import parse_once
from tests.whole_scenarios.changing import changed
from tests.whole_scenarios.promises import BrokenPromiseError, check_all
from tests.whole_scenarios.wholes import made_up

HANGS_S = 120


def main() -> int:
    """Search, and count what was found."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--seeds", default="0..200")
    parser.add_argument("--out", type=Path, default=Path("broken_promises"), help="where they are written")
    parser.add_argument("--changed", action="store_true", help="change what is shipped instead of making up")
    parser.add_argument("--play", type=int, default=4, help="play every so many of them")
    given = parser.parse_args()
    parse_once()
    first, last = map(int, given.seeds.split(".."))
    given.out.mkdir(parents=True, exist_ok=True)
    counts: collections.Counter[str] = collections.Counter()
    began = time.time()
    signal.signal(signal.SIGPROF, _too_long)
    for seed in range(first, last):
        signal.setitimer(signal.ITIMER_PROF, HANGS_S)  # of processor time
        try:
            counts[_one(seed, is_changed=given.changed, play=seed % given.play == 0)] += 1
        except BrokenPromiseError as error:
            what = error.what.splitlines()[0][:150]
            counts[what] += 1
            if counts[what] <= 3:
                print(f"seed {seed}: {what}", flush=True)
                trace = "".join(traceback.format_exception(error.__cause__)) if error.__cause__ else ""
                (given.out / f"{'changed' if given.changed else 'made'}-{seed}.txt").write_bytes(
                    f"{error}\n{trace}".encode("utf-8", "surrogatepass")
                )
        finally:
            signal.setitimer(signal.ITIMER_PROF, 0)
    print(f"{time.time() - began:.0f} s", *(f"{count:6} {what}" for what, count in counts.most_common()), sep="\n")
    return 0


class _TooLongError(Exception):
    """Something hangs."""


def _too_long(*_: object) -> None:
    raise _TooLongError


def _one(seed: int, *, is_changed: bool, play: bool) -> str:
    text = changed(seed) if is_changed else made_up(seed)
    with tempfile.TemporaryDirectory() as folder:
        taken = check_all(text, Path(folder), seed, mend=not is_changed, play=play)
    return "taken" if taken else "refused"


if __name__ == "__main__":
    sys.exit(main())
