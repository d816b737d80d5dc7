"""Writes ``docs/hostile-programs.md`` from the headers of the programs: ``python -m tests.hostile.page``."""

from __future__ import annotations

from pathlib import Path

from tests.hostile.harness import GROUPS, PLATFORMS, Entry, entries

PAGE = Path(__file__).parent.parent.parent / "docs" / "hostile-programs.md"

_TITLES = {
    "time": "Time: programs that make others wait",
    "endings": "Endings: programs that crash or exit",
    "output": "Output",
    "memory and files": "Memory, disk and files",
    "processes and system": "Processes, network and the system",
    "protocol": "The protocol between a program and the match",
    "module": "The controller module and Python itself",
}
_PLATFORM_NAMES = {"linux": "Linux", "darwin": "macOS", "win32": "Windows"}
_ENDS = {
    "start_timeout": "stopped at the time limit for the start",
    "step_timeout": "stopped at the time limit for a step",
    "half_timeout": "stopped at the time limit for a half",
    "output_flood": "stopped for writing too much",
    "memory": "stopped for using too much memory",
    "crash": "crash",
    "exit": "exit",
    "protocol": "stopped for an invalid message",
}

_HEAD = """\
# Hostile and broken programs, and what stops them

A team's program might try anything, and these {count} programs do. Each is a small file in `tests/hostile/programs/` and is run in
a real match, by robots of one team against a normal team that uses all its sensors. Each time, the test asserts that

- the match is completed in time, and no other robot has a fault;
- all poses of the robots and the ball, and all events except the program's own fault, are identical, bit for bit, to those of a
  match in which that program only sets its speed to 0 in the tick of the attempt;
- the normal team's programs have received and printed exactly the same as in that match;
- no file, process, thread or file descriptor is left behind, nothing outside the private folders has changed, and the match's own
  process has the same limits, priority, session and environment as before;
- the fault, with its tick and cause, is in the reflog, in `result.json` and in that robot's log.

`python -m pytest tests/hostile/test_programs.py` runs them, as root or as any other user. Programs marked ☾ are variants of others
and run only in the nightly tests; `-m "nightly or not nightly"` runs all. If the computer lacks an isolation layer that is needed
to stop a program, that program is skipped, and the reason is given. Programs marked ⚑ also run with `--sandbox off`, to show that
their attempts succeed there and that the named layers are what stops them.

**Layers**: a dash means that no isolation layer is needed: each program has its own process, and the match validates every message,
never waits longer than the limits allow, and uses only what it has checked. The names of layers are those in `result.json`.
"""

_TAIL = """\

## What is not prevented

- **Processor time.** A program's threads may compute at the same time as other programs: on a computer with few cores, this makes
  a match slower, but does not change it. One hostile team costs at most 10 minutes per half, whatever it does
  ([isolation.md](isolation.md#time)).
- **The real clock** can be read with `ctypes`. Nothing in a match depends on it.
- **Covert channels.** Two programs that want to exchange bits can do so, within a half and from one half to the next: through how
  much they compute, the time that reading a shared file takes, or process and file numbers that the whole system shares.
  The rules must forbid this, and a code review can find it.
- **System memory.** A program's memory does not include the buffers of its pipes and socket pairs (about 60 MB at the usual sizes),
  or its files if the temporary folder is in memory. [isolation.md](isolation.md#what-organizers-should-do) recommends a memory
  limit for the whole tournament.
- **Messages within a team.** A robot's radio messages reach its team-mates, which may do anything with them.
- **Missing layers.** Without `filesystem` and `system_calls` (macOS, Windows, old kernels), a program can read and write what the
  user who runs the match can, start processes and use the network. There, run untrusted programs only as a user who owns nothing.

## Inputs

Untrusted files can do harm before any program runs. Everything that is read is limited in size and number. The largest input within
all limits is checked in at most 5 s of processor time (`python -m benchmarks.inputs`); a larger one is refused with a code.

| input | limit | code |
|---|---|---|
| archive or folder | 10 MB, 50 MB unpacked, 5000 files, 1000 folders, 12 levels deep | `archive.too_large`, `archive.bomb`, `archive.too_many`, `archive.too_many_folders`, `archive.too_deep` |
| Python that `check` reads | 64 kB per file, 192 kB in all, 5000 imported modules and names, usual encodings | `sources.large`, `sources.unread`, `sources.too_many_imports`, `sources.odd_encoding` |
| scenario | 1 MB, 10 000 values per file (20 000 with its bases), 256 entries per mapping, 512 per list | `scenario-too-large` |
| misspelt names | compared with at most 150 known names, using 32 characters of each | |
| file in a record | regular files only; pipes and devices are refused | `record-not-a-file` |
| request to the live view | a valid address, a content length of at most 12 digits | 400, 413 |

Control characters and direction marks in scenario texts are shown as escapes in the terminal, the drawing and the rule sheet.
"""


def text() -> str:
    """Return the page."""
    parts = [_HEAD.format(count=len(entries()))]
    for group in GROUPS:
        parts += [
            f"\n## {_TITLES[group]}\n\n",
            "| program | attempt | what stops it | result | layers | platforms |\n|---|---|---|---|---|---|\n",
        ]
        parts += [_row(entry) for entry in entries() if entry.about == group]
    return "".join(parts) + _TAIL


def _row(entry: Entry) -> str:
    platforms = (
        "all" if set(entry.platforms) == set(PLATFORMS) else ", ".join(map(_PLATFORM_NAMES.get, entry.platforms))
    )
    kinds = "" if entry.plays_on else entry.ends.split(" at ")[0].split("|")
    then = "plays on" if entry.plays_on else " / ".join(_ENDS[kind] for kind in kinds)
    layers = ", ".join(f"`{layer}`" for layer in entry.layers) or "—"
    mark = (" ⚑" if entry.succeeds_without else "") + (" ☾" if entry.variant else "")
    cells = (f"`{entry.name}`{mark}", entry.tries, entry.holds, then, layers, platforms)
    return "| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |\n"


if __name__ == "__main__":
    PAGE.write_text(text(), encoding="utf-8", newline="\n")
