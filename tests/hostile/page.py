"""Writes ``docs/hostile-programs.md`` from the headers of the programs: ``python -m tests.hostile.page``."""

from __future__ import annotations

from pathlib import Path

from tests.hostile.harness import GROUPS, PLATFORMS, Entry, entries

PAGE = Path(__file__).parent.parent.parent / "docs" / "hostile-programs.md"

_TITLES = {
    "time": "Time: programs that make others wait",
    "endings": "Endings: programs that crash or exit",
    "output": "Output",
    "memory and files": "Memory, disk and the files of others",
    "processes and system": "Processes, network and the system",
    "protocol": "The protocol between a program and the match",
    "module": "The controller module and Python itself",
}
_PLATFORM_NAMES = {"linux": "Linux", "darwin": "macOS", "win32": "Windows"}
_ENDS = {
    "start_timeout": "stopped at the time limit of the start",
    "step_timeout": "stopped at the time limit of a step",
    "half_timeout": "stopped at the time limit of a half",
    "output_flood": "stopped for what it wrote",
    "memory": "ended for lack of memory",
    "crash": "crash",
    "exit": "exit",
    "protocol": "ended for its message",
}

_HEAD = """\
# Hostile and broken programs, and what stops them

A team's program may do anything. These {count} programs try; each is a small file in `tests/hostile/programs/`, and each is
played in a real match: in three robots of one team, against a normal team that uses all its sensors. Each time the test
asserts:

- the match ends in time, complete, and no other robot has a fault;
- all poses of all robots and of the ball are, bit for bit, those of the match in which that program sets speed 0 from the same
  tick on; so are all events but that of its own fault;
- the programs of the normal team have seen and printed exactly the same;
- no file, process, thread or open file is left, nothing outside the private folders has changed, and the match's own process has
  the same limits, priority, session and environment as before;
- the fault, with its tick and its cause, is in the reflog, in `result.json` and in that robot's log.

`python -m pytest tests/hostile/test_programs.py` plays them, as root or as any other user. Programs marked ☾ are variants of
others, and are played only in the nightly tests; `-m "nightly or not nightly"` plays all. Programs that need a layer of isolation
that this computer lacks are skipped with that reason. Programs marked ⚑ are also played with `--sandbox off`, to show that
their attempt succeeds there, and that it is the named layers that stop them.

**Layers**: — means that no layer of isolation is needed: each program has its own process, the match validates every message, never
waits longer than the limits, and uses only what it has checked. The other names are those in `result.json`.
"""

_TAIL = """\

## What is not prevented

- **Processor time.** Threads of a program may compute while other programs do: on a computer with few cores this makes a match
  slower, but does not change it. One hostile team costs at most 10 minutes per half, whatever it does
  ([isolation.md](isolation.md#time)).
- **The real clock** can be read with ctypes. Nothing in a match depends on it.
- **Talk between programs.** Two programs that want to exchange bits can do so, within a half and from one half to the next: by how
  much they compute, by the time that reading a shared file takes, by process and file numbers that the whole system shares.
  Rules and code review must forbid it.
- **Memory of the system**: buffers of pipes and socket pairs (about 60 MB for each program at the usual sizes) do not count as its memory, nor do
  its files if the temporary folder is in memory. [isolation.md](isolation.md#what-organizers-should-do) recommends a limit around the
  whole tournament.
- **Messages within a team**: a robot's radio messages reach its team-mates, which may do anything with them.
- Without the layers `filesystem` and `system_calls` (macOS, Windows, old kernels) a program can read and write what the user who
  runs the match can, start processes and use the network. Run untrusted programs there only as a user who owns nothing.

## Inputs

Untrusted files can be hostile before any program runs. Everything that is read is bounded by size and count; the largest input within all
bounds is checked in at most 5 s of processor time (`python -m benchmarks.inputs`), and a larger one is refused with a code.

| input | bound | code |
|---|---|---|
| archive or folder | 10 MB, 50 MB unpacked, 5000 files, 1000 folders, 12 levels deep | `archive.too_large`, `archive.bomb`, `archive.too_many`, `archive.too_many_folders`, `archive.too_deep` |
| Python that `check` reads | 64 kB per file, 192 kB in all, 5000 imported modules and names, usual encodings | `sources.large`, `sources.unread`, `sources.too_many_imports`, `sources.odd_encoding` |
| scenario | 1 MB, 10 000 values per file (20 000 with its bases), 256 entries of a mapping, 512 of a list | `scenario-too-large` |
| misspelt names | compared with 150 known ones, 32 letters of each | |
| file of a record | a pipe or a device in its place is refused | `record-not-a-file` |
| request to the live view | an address that cannot be read, a length of more than 12 digits | 400, 413 |

Control characters and direction marks in texts of scenarios are written as escapes in the terminal, the drawing and the sheet.
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
    then = "plays on" if entry.plays_on else " or ".join(_ENDS[kind] for kind in kinds)
    layers = ", ".join(f"`{layer}`" for layer in entry.layers) or "—"
    mark = (" ⚑" if entry.succeeds_without else "") + (" ☾" if entry.variant else "")
    cells = (f"`{entry.name}`{mark}", entry.tries, entry.holds, then, layers, platforms)
    return "| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |\n"


if __name__ == "__main__":
    PAGE.write_text(text(), encoding="utf-8", newline="\n")
