"""Codes about records."""

from rcj_challenges.core.code import Code

# fmt: off
RECORD_TOO_OLD = Code("record-too-old", page="""
The record was made by an earlier version, in a format that this version does not read.
Its replay.html still opens in any browser. To judge or count the match, play it again: result.json names scenario
and seed.""")
RECORD_TOO_NEW = Code("record-too-new", page="""
The record was made by a later version, in a format that this version does not know.
Update rcj-challenges, or read the record where it was made.""")
RECORD_DAMAGED = Code("record-damaged", page="""
A file of the record is not as the run wrote it: it was truncated, changed or replaced.
Copy the whole record again. Pages and statistics show the ticks before the damage; judge needs all of them.""")
RECORD_INCOMPLETE = Code("record-incomplete", page="""
A file that every record has is missing, or the folder is not a record.
Copy the whole folder of the run: it contains result.json, scenario.json and trajectory.chunks.""")
RECORD_UNREADABLE = Code("record-unreadable", page="""
A file of the record exists but cannot be read.
The message has the operating system's reason; often the file belongs to another user.""")
RECORD_NOT_A_FILE = Code("record-not-a-file", page="""
Something in the record is a named pipe or a device where a file should be.
No run creates such a record: copy it again from where it was made.""")
RECORD_TOO_LARGE = Code("record-too-large", page="""
A file of the record is larger than any file that a run writes.
Copy the whole record again.""")
RECORD_EMPTY = Code("record-empty", page="""
The run ended, or was stopped, before its first tick, so there is nothing to show.
Play the match again.""")
NO_RECORD = Code("no-record", page="""
There is no record with this name, or no run was recorded in the folder.
Records are in runs/ unless --out named another folder; rcj-challenge view --list shows them.""")
AMBIGUOUS_RECORD = Code("ambiguous-record", page="""
Several records begin with what was given.
Give more characters of the name, or the folder of the record.""")
CANNOT_WRITE_RECORD = Code("cannot-write-record", page="""
The record of a match cannot be written on this computer.
Free some space, or choose a folder with --out in which you can write.""")
