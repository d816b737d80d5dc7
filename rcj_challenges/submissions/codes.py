"""Codes about submissions: archives, layout and names."""

from rcj_challenges.core.code import Code

# fmt: off
_PACK = "Pack the folder of your programs again, as an ordinary ZIP archive without a password."
_FIX = "`rcj-challenge check FILE --fix NEW.zip` repairs this."
_LESS = "Leave out what the programs do not need; docs/submission.md has the limits."
_RENAME = "Rename the file, also where programs import or open it."

NO_SUCH_TEAM = Code("no-such-team", page="""
There is no file or folder at the path that was given for a team.
Check the path.""")
UNUSABLE_TEAM = Code("unusable-team", page="""
A team's folder or archive cannot be used.
`rcj-challenge check FILE` says what to do.""")
ARCHIVE_BACKSLASHES = Code("archive.backslashes", level="warning", repair="yes", page=f"""
Names in the archive are separated by backslashes.
{_FIX}""")
ARCHIVE_BOMB = Code("archive.bomb", page=f"""
Unpacked, the archive is far too large.
{_LESS}""")
ARCHIVE_COLLISION = Code("archive.collision", page=f"""
Two names are the same on some computers (`Notes.txt`, `notes.TXT`), or a file and a folder have the same name.
{_RENAME}""")
ARCHIVE_DAMAGED = Code("archive.damaged", page=f"""
A checksum or size is wrong, or a file is cut off or lies outside the archive.
{_PACK}""")
ARCHIVE_DECEPTIVE = Code("archive.deceptive", page=f"""
The table of contents contradicts the files, so different programs would unpack different things.
{_PACK}""")
ARCHIVE_DUPLICATE = Code("archive.duplicate", repair="yes ²", page=f"""
A file is in the archive twice.
Keep one of them. If both are identical, {_FIX}""")
ARCHIVE_EMPTY = Code("archive.empty", page="""
There are no files in the submission, or only leftovers.
Give the folder or the ZIP with the robot programs.""")
ARCHIVE_ENCRYPTED = Code("archive.encrypted", page=f"""
A file in the archive is encrypted.
{_PACK}""")
ARCHIVE_HEADERS = Code("archive.headers", level="warning", repair="yes", page=f"""
Counts, sizes or checksums contradict each other; the content is sound.
{_FIX}""")
ARCHIVE_LEFTOVERS = Code("archive.leftovers", level="warning", repair="yes", page=f"""
There are `__MACOSX`, `.DS_Store`, `.git`, `__pycache__` and the like, or records of runs; they are ignored.
{_FIX}""")
ARCHIVE_LINK = Code("archive.link", page="""
There is a link or a device file; in a folder, a link that leads out of it.
Copy the file or folder itself.""")
ARCHIVE_LINK_INSIDE = Code("archive.link_inside", level="warning", page="""
A link to a folder is left out.
Copy the folder, if programs need it there.""")
ARCHIVE_METHOD = Code("archive.method", page=f"""
A file is packed with an unusual method (LZMA, bzip2, Deflate64 …).
{_PACK}""")
ARCHIVE_NAME_CONTROL = Code("archive.name_control", repair="yes ¹", page=f"""
A file name has control characters in it.
{_RENAME} {_FIX}""")
ARCHIVE_NAME_ENCODING = Code("archive.name_encoding", repair="yes ¹", page=f"""
A file name cannot be read.
{_RENAME} {_FIX}""")
ARCHIVE_NAME_ENDING = Code("archive.name_ending", repair="yes ¹", page=f"""
A file name ends with a dot or a space, which Windows removes.
{_RENAME} {_FIX}""")
ARCHIVE_NAME_FORBIDDEN = Code("archive.name_forbidden", repair="yes ¹", page=f"""
A file name has characters that some computers refuse.
{_RENAME} {_FIX}""")
ARCHIVE_NAME_GUESSED = Code("archive.name_guessed", level="warning", page="""
The archive does not say how its file names are encoded, so they may be read wrongly.
Use plain letters (a to z) in names of files and folders.""")
ARCHIVE_NAME_LONG = Code("archive.name_long", repair="yes ¹", page=f"""
A path is longer than some computers allow.
{_RENAME}""")
ARCHIVE_NAME_RESERVED = Code("archive.name_reserved", repair="yes ¹", page=f"""
A file has the name of a Windows device, such as CON or AUX.
{_RENAME} {_FIX}""")
ARCHIVE_NESTED = Code("archive.nested", level="warning", page="""
There is an archive inside the submission; it is not unpacked.
Pack what is in it instead.""")
ARCHIVE_NO_FOLDERS = Code("archive.no_folders", level="passed", repair="yes", page="""
The archive has no entries for its folders.
That does no harm.""")
ARCHIVE_NOT_ZIP = Code("archive.not_zip", page=f"""
The file is not a ZIP archive.
{_PACK}""")
ARCHIVE_OTHER_KIND = Code("archive.other_kind", page=f"""
The file is a RAR, 7-Zip or tar archive, a PDF, a web page or the like, whatever its name.
{_PACK}""")
ARCHIVE_OUTSIDE = Code("archive.outside", repair="yes", page=f"""
A name leads out of the archive: `/etc/x`, `../x`, `C:/x`.
{_PACK}""")
ARCHIVE_OUTSIDE_FOLDER = Code("archive.outside_folder", repair="yes", page=f"""
A folder leads out of the archive; it is left out.
{_FIX}""")
ARCHIVE_OVERLAP = Code("archive.overlap", page=f"""
Files in the archive overlap.
{_PACK}""")
ARCHIVE_PREPENDED = Code("archive.prepended", level="warning", repair="yes", page=f"""
There is other data before the archive.
{_FIX}""")
ARCHIVE_SPLIT = Code("archive.split", page=f"""
The file is one part of an archive in several parts.
{_PACK}""")
ARCHIVE_TOO_DEEP = Code("archive.too_deep", page=f"""
Folders are nested more than 12 deep.
{_LESS}""")
ARCHIVE_TOO_LARGE = Code("archive.too_large", page=f"""
The submission has more than 10 MB.
{_LESS}""")
ARCHIVE_TOO_MANY = Code("archive.too_many", page=f"""
The submission has too many files.
{_LESS}""")
ARCHIVE_TOO_MANY_FOLDERS = Code("archive.too_many_folders", page=f"""
The submission has more than 1000 folders.
{_LESS}""")
ARCHIVE_TRAILING = Code("archive.trailing", level="warning", repair="yes", page=f"""
There is other data after the archive.
{_FIX}""")
ARCHIVE_TRUNCATED = Code("archive.truncated", page=f"""
The end of the archive is missing.
Copy or upload it again. {_PACK}""")
ARCHIVE_TWO = Code("archive.two", page=f"""
Two archives are in one file.
{_PACK}""")
IDENTITY_NAME_MISSING = Code("identity.name_missing", level="warning", page="""
There is no team_name.txt.
Add it, with the team's name in one line.""")
IDENTITY_NAME_EMPTY = Code("identity.name_empty", level="warning", page="""
team_name.txt is empty.
Write the team's name into it.""")
IDENTITY_NAME_LINES = Code("identity.name_lines", level="warning", repair="yes", page=f"""
team_name.txt has more than one line; the first is used.
Leave one line. {_FIX}""")
IDENTITY_NAME_LONG = Code("identity.name_long", level="warning", repair="yes", page=f"""
The team's name has more than 32 characters; the rest is not shown.
Choose a shorter one. {_FIX}""")
IDENTITY_NAME_UNSAFE = Code("identity.name_unsafe", level="warning", repair="yes", page=f"""
The name has characters that cannot be printed.
Use printable characters. {_FIX}""")
IDENTITY_NAME_QUOTES = Code("identity.name_quotes", level="passed", page="""
Quotation marks in team_name.txt are part of the name.""")
IDENTITY_NAME_SIGNS = Code("identity.name_signs", level="passed", page="""
The name has characters that are not allowed in file names.
That does no harm.""")
IDENTITY_NAME_BOM = Code("identity.name_bom", level="passed", repair="yes", page="""
team_name.txt begins with a byte order mark.
That does no harm.""")
IDENTITY_NAME_LINE_ENDS = Code("identity.name_line_ends", level="passed", repair="yes", page="""
team_name.txt has the line ends of another system.
That does no harm.""")
IDENTITY_NAME_UTF16 = Code("identity.name_utf16", level="passed", repair="yes", page="""
team_name.txt is saved as UTF-16.
That does no harm; UTF-8 is more common.""")
IDENTITY_NAME_DOCUMENT = Code("identity.name_document", level="warning", page="""
team_name.txt is the document of a word processor.
Write the name with a text editor, as one line of text.""")
IDENTITY_NAME_ENCODING = Code("identity.name_encoding", level="warning", page=f"""
`team_name.txt` is not UTF-8; it is read as Windows-1252, and what cannot be read is shown as �.
Save it as UTF-8. {_FIX}""")
IDENTITY_NAME_FILE = Code("identity.name_file", level="warning", repair="yes", page=f"""
The team's name is in a file with another name or in another folder; it is used anyway.
{_FIX}""")
LAYOUT_MISSING = Code("layout.missing", page="""
A program is not where the scenario asks for it.
Rename or move it. For match it is rcj_soccer_team_blue/rcj_soccer_team_blue.py; docs/submission.md has a table.""")
