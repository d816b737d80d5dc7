"""The pages of the codes about running programs."""

from __future__ import annotations

PAGES: dict[str, str] = {
    "unknown-sandbox": "The value of --sandbox is unknown.\n\nWrite auto, strict or off.",
    "isolation-missing": (
        "--sandbox strict was given, and this computer lacks some layers of isolation.\n\n"
        "Play with --sandbox auto, or on another computer. docs/isolation.md lists the layers."
    ),
    "host-too-busy": (
        "The match waited a very long time for programs, but none of them used up its own time.\n\n"
        "This computer is too busy: close other programs, and play the match again."
    ),
    "cannot-start-program": "This computer cannot start one more program.\n\nClose other programs and run it again.",
    "temporary-folder": (
        "The folder for temporary files cannot be used, perhaps because its disk is full.\n\n"
        "Free some space there, or set TMPDIR (TEMP on Windows) to another folder."
    ),
}
