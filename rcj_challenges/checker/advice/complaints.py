"""What the controller module writes into a program's log about its calls, and what to do about it."""

from __future__ import annotations

import re

from rcj_challenges.core.sanitize import sanitize

MAX_COMPLAINTS = 5

# Errors, and those warnings behind which there may be a mistake.
_COMPLAINTS = tuple(
    (re.compile(words), help_)
    for words, help_ in (
        (r"Error: (only one Robot can be made: .+)", "make it once, and hand it to what needs it: def run(robot): …"),
        (r"Error: ('[^']+': .+?)\.?", "correct this call"),  # each of them begins with the device
        (r"Warning: (.+ is read but not enabled): call enable.+", "call enable(32) before the first step"),
        (r"Warning: ('[^']+': the velocity .+ is beyond the maximum of .+), which is taken instead\.", "ask for less"),
        (r"Warning: (step was called .+); write a while loop\.", "write a loop: while robot.step(32) != -1:"),
        (r"Warning: (.+ is ignored and gives None: .+)", "do without this call"),
        (r"Warning: (.+: the packet is dropped: it is empty.*)", "send nothing where there is nothing to say"),
        (r"Warning: (.+: the packet is dropped: .+)", "send less in one packet and in one step"),
    )
)


def complaints_in(log: str) -> list[tuple[str, str]]:
    """Return what was refused or ignored, safe to show, and what to do about it, each once in the order of the log."""
    found = (
        next(((hit[1], help_) for words, help_ in _COMPLAINTS if (hit := words.fullmatch(line))), None)
        for line in dict.fromkeys(log.splitlines())
    )
    return [(sanitize(what), help_) for what, help_ in filter(None, found)]
