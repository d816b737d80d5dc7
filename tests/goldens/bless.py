"""Record the golden files: ``python -m tests.goldens.bless [SCENARIO...]``, all of them or those named.

Only for a change that is intended to change results; it needs a line under "Results change" in CHANGELOG.md. Where results
change on this kind of machine, those of other kinds are removed: they are no longer true.
"""

import json
import sys
import tempfile
from pathlib import Path

from tests.goldens.plays import PLAYS, STATES, TESTS, judged_tests, machine, played, read


def main() -> None:
    chosen = [play for play in PLAYS if play.scenario in sys.argv[1:]] if sys.argv[1:] else PLAYS
    for play in chosen:
        with tempfile.TemporaryDirectory() as folder:
            found = {length: played(play, length, Path(folder)) for length in play.lengths}
        print(play.scenario, found, flush=True)
        kinds = read(STATES)
        known = kinds.get(machine(), {}).get(play.scenario, {})
        if any(known[length] != found.get(length) for length in known):
            for results in kinds.values():
                results.pop(play.scenario, None)
        kinds.setdefault(machine(), {})[play.scenario] = found
        write(STATES, kinds)
    write(TESTS, read(TESTS) | {play.scenario: judged_tests(play.scenario) for play in chosen})


def write(path: Path, data: dict) -> None:
    path.write_text(json.dumps(data, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
