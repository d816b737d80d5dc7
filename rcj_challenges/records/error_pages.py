"""The pages of the codes of records."""

from __future__ import annotations

PAGES: dict[str, str] = {
    "record-too-old": (
        "The record was made by an earlier version, in a format that this version does not read.\n\n"
        "Its replay.html still opens in any browser. To judge or count the match, play it again: result.json names "
        "scenario and seed."
    ),
    "record-too-new": (
        "The record was made by a later version, in a format that this version does not know.\n\n"
        "Update rcj-challenges, or read the record where it was made."
    ),
    "record-damaged": (
        "A file of the record is not as the run wrote it: it was truncated, changed or replaced.\n\n"
        "Copy the whole record again. Pages and statistics show the ticks before the damage; judge needs all of them."
    ),
    "record-incomplete": (
        "A file that every record has is missing, or the folder is not a record.\n\n"
        "Copy the whole folder of the run: it contains result.json, scenario.json and trajectory.chunks."
    ),
    "record-unreadable": (
        "A file of the record exists but cannot be read.\n\n"
        "The message has the operating system's reason; often the file belongs to another user."
    ),
    "record-not-a-file": (
        "Something in the record is a named pipe or a device where a file should be.\n\n"
        "No run creates such a record: copy it again from where it was made."
    ),
    "record-too-large": (
        "A file of the record is larger than any file that a run writes.\n\nCopy the whole record again."
    ),
    "record-empty": (
        "The run ended, or was stopped, before its first tick, so there is nothing to show.\n\nPlay the match again."
    ),
    "no-record": (
        "There is no record with this name, or no run was recorded in the folder.\n\n"
        "Records are in runs/ unless --out named another folder; rcj-challenge view --list shows them."
    ),
    "ambiguous-record": (
        "Several records begin with what was given.\n\nGive more characters of the name, or the folder of the record."
    ),
    "cannot-write-record": (
        "The record of a match cannot be written on this computer.\n\n"
        "Free some space, or choose a folder with --out in which you can write."
    ),
}
