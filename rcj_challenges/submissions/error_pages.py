"""The pages of the codes about submissions: archives, layout and names."""

from __future__ import annotations

_PACK = "Pack the folder of your programs again, as an ordinary ZIP archive without a password."
_FIX = "`rcj-challenge check FILE --fix NEW.zip` repairs this."
_LESS = "Leave out what the programs do not need; docs/submission.md has the limits."
_RENAME = "Rename the file, also where programs import or open it."

PAGES: dict[str, str] = {
    "no-such-team": "There is no file or folder at the path that was given for a team.\n\nCheck the path.",
    "unusable-team": "A team's folder or archive cannot be used.\n\n`rcj-challenge check FILE` says what to do.",
    "archive.backslashes": f"Names in the archive are separated by backslashes.\n\n{_FIX}",
    "archive.bomb": f"Unpacked, the archive is far too large.\n\n{_LESS}",
    "archive.collision": f"Two files would be one and the same on computers that ignore upper and lower case.\n\n{_RENAME}",
    "archive.damaged": f"The archive is damaged.\n\n{_PACK}",
    "archive.deceptive": f"The sizes in the archive are not those of its files.\n\n{_PACK}",
    "archive.duplicate": f"A file is in the archive twice.\n\nKeep one of them. If both are identical, {_FIX}",
    "archive.empty": "There are no files in the submission.\n\nGive the folder or the ZIP with the robot programs.",
    "archive.encrypted": f"A file in the archive is encrypted.\n\n{_PACK}",
    "archive.headers": f"Sizes or checksums in the archive are wrong.\n\n{_FIX}",
    "archive.leftovers": f"The archive has files that operating systems and editors leave behind.\n\n{_FIX}",
    "archive.link": "The submission has a link or a device in it.\n\nCopy the file or folder itself.",
    "archive.link_inside": "A link to a folder is left out.\n\nCopy the folder, if programs need it there.",
    "archive.method": f"A file is packed with a method that not every program supports.\n\n{_PACK}",
    "archive.name_control": f"A file name has control characters in it.\n\n{_RENAME} {_FIX}",
    "archive.name_encoding": f"A file name cannot be read.\n\n{_RENAME} {_FIX}",
    "archive.name_ending": f"A file name ends with a dot or a space, which Windows removes.\n\n{_RENAME} {_FIX}",
    "archive.name_forbidden": f"A file name has characters that some computers refuse.\n\n{_RENAME} {_FIX}",
    "archive.name_guessed": (
        "The archive does not say how its file names are encoded, so they may be read wrongly.\n\n"
        "Use plain letters (a to z) in names of files and folders."
    ),
    "archive.name_long": f"A path is longer than some computers allow.\n\n{_RENAME}",
    "archive.name_reserved": f"A file has the name of a Windows device, such as CON or AUX.\n\n{_RENAME} {_FIX}",
    "archive.nested": "There is an archive inside the submission; it is not unpacked.\n\nPack what is in it instead.",
    "archive.no_folders": "The archive has no entries for its folders.\n\nThat does no harm.",
    "archive.not_zip": f"The file is not a ZIP archive.\n\n{_PACK}",
    "archive.other_kind": f"The file is an archive of another kind, or no archive.\n\n{_PACK}",
    "archive.outside": f"A path leads out of the archive.\n\n{_PACK}",
    "archive.outside_folder": f"A folder leads out of the archive; it is left out.\n\n{_FIX}",
    "archive.overlap": f"Files in the archive overlap.\n\n{_PACK}",
    "archive.prepended": f"There is other data before the archive.\n\n{_FIX}",
    "archive.split": f"The file is one part of an archive in several parts.\n\n{_PACK}",
    "archive.too_deep": f"Folders are nested too deeply.\n\n{_LESS}",
    "archive.too_large": f"The submission is too large.\n\n{_LESS}",
    "archive.too_many": f"The submission has too many files.\n\n{_LESS}",
    "archive.too_many_folders": f"The submission has too many folders.\n\n{_LESS}",
    "archive.trailing": f"There is other data after the archive.\n\n{_FIX}",
    "archive.truncated": f"The end of the archive is missing.\n\nCopy or upload it again. {_PACK}",
    "archive.two": f"Two archives are in one file.\n\n{_PACK}",
    "identity.name_missing": "There is no team_name.txt.\n\nAdd it, with the team's name in one line.",
    "identity.name_empty": "team_name.txt is empty.\n\nWrite the team's name into it.",
    "identity.name_lines": f"team_name.txt has more than one line; the first is used.\n\nLeave one line. {_FIX}",
    "identity.name_long": f"The name is longer than 32 letters; the rest is not shown.\n\nChoose a shorter one. {_FIX}",
    "identity.name_unsafe": f"The name has letters that cannot be printed.\n\nUse printable letters. {_FIX}",
    "identity.name_quotes": "Quotation marks in team_name.txt are part of the name.",
    "identity.name_signs": "The name has characters that are not allowed in file names.\n\nThat does no harm.",
    "identity.name_bom": "team_name.txt begins with a byte order mark.\n\nThat does no harm.",
    "identity.name_line_ends": "team_name.txt has the line ends of another system.\n\nThat does no harm.",
    "identity.name_utf16": "team_name.txt is saved as UTF-16.\n\nThat does no harm; UTF-8 is more common.",
    "identity.name_document": (
        "team_name.txt is the document of a word processor.\n\nWrite the name with a text editor, as one line of text."
    ),
    "identity.name_encoding": f"The letters of team_name.txt cannot be read.\n\nSave it as UTF-8. {_FIX}",
    "identity.name_file": f"The team's name is in a file with another name or in another folder.\n\n{_FIX}",
    "layout.missing": (
        "A program is not where the scenario asks for it.\n\n"
        "Rename or move it. For match it is rcj_soccer_team_blue/rcj_soccer_team_blue.py; docs/submission.md has a table."
    ),
}
