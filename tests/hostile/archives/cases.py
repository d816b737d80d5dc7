"""Archives that teams handed in, and those that somebody might: each with what a check must say of it.

The defects that were seen (reference, section 7) come first. Every entry holds on every platform: archives are judged
the same everywhere.
"""

from __future__ import annotations

import gzip
import io
import random
import tarfile
from collections.abc import Callable
from functools import cache

from tests.hostile.archives import pictures
from tests.hostile.archives.building import (
    DEVICE_MODE, ENCRYPTED, LINK_MODE, SIZES_FOLLOW, STORED, Member, deflated, folder, pack, with_folders,
)
from tests.hostile.archives.case import Case
from tests.hostile.archives.large import LARGE
from tests.hostile.archives.making import (
    ENTRY, PROGRAM, UTILS, NAME, SOUND, OF_2021, plain, sound_with, below, without, damaged_table, member_with, named,
    logo, importing, noise, tar, overlapping, quoted,
)


def leftover(path: str, says: str = "") -> Case:
    return Case(lambda: sound_with(**{path: b"\0"}), "archive.leftovers", "warning", says or path, repair=True)


SEEN: dict[str, Case] = {
    "extra_top_folder": Case(
        lambda: plain(below("My Team", SOUND)), "layout.top_folder", "warning", "extra folder: My Team", repair=True
    ),
    "two_extra_top_folders": Case(
        lambda: plain(below("Desktop/My Team", SOUND)), "layout.top_folder", "warning", "Desktop/My Team", repair=True
    ),
    "extra_top_folder_beside_others": Case(
        lambda: plain(below("My Team", SOUND) | {"docs/poster.txt": b"We"}),
        "layout.misnamed", says="looked for rcj_soccer_team_blue/rcj_soccer_team_blue.py", repair=True,
    ),
    "extra_top_folder_beside_others_and_another_name": Case(
        lambda: plain({"My Team/soccer/rcj_soccer_team_blue.py": PROGRAM, "docs/poster.txt": b"We"} | NAME),
        "layout.misnamed", says="found: My Team/soccer/rcj_soccer_team_blue.py", repair=True,
    ),
    "extra_top_folder_of_2021": Case(
        lambda: plain(below("team_7", OF_2021)), "layout.top_folder", "warning", "team_7", repair=True
    ),
    "folder_called_otherwise": Case(
        lambda: plain({name.replace("rcj_soccer_team_blue/", "our robots/"): data for name, data in SOUND.items()}),
        "layout.folder_name", "warning", "is called our robots", repair=True,
    ),
    "folder_and_program_called_otherwise": Case(
        lambda: plain(
            {name.replace("rcj_soccer_team_blue", "RCJ-Soccer-Team-Blue"): data for name, data in SOUND.items()}
        ),
        "layout.misnamed", says="RCJ-Soccer-Team-Blue", repair=True,
    ),
    "folder_called_after_the_other_colour": Case(
        lambda: plain({name.replace("_blue", "_yellow"): data for name, data in SOUND.items()}),
        "layout.misnamed", says="rcj_soccer_team_yellow.py", repair=True,
    ),
    "program_called_otherwise": Case(
        lambda: plain(without(SOUND, ENTRY) | {"rcj_soccer_team_blue/rcj_soccer_team_bleu.py": PROGRAM}),
        "layout.misnamed", says="found: rcj_soccer_team_blue/rcj_soccer_team_bleu.py", repair=True,
    ),
    "folders_of_2021_called_otherwise": Case(
        lambda: plain(
            {name.replace("robot1/", "Robot_1/").replace("robot3/", "ROBOT3/"): data for name, data in OF_2021.items()}
        ),
        "layout.misnamed", says="B3, Y3: looked for", repair=True,
    ),
    "one_program_of_2021_missing": Case(
        lambda: plain(without(OF_2021, "robot2/robot2.py")), "layout.missing", says="no program for B2, Y2"
    ),
    "a_mentioned_folder_called_otherwise": Case(
        lambda: plain(
            {name.replace("robot1/", "Robot_1/"): data for name, data in OF_2021.items()}
            | {"robot2/robot2.py": b"from Robot_1 import robot1\n"}
        ),
        "layout.misnamed",
    ),
    "challenge_folder_called_otherwise": Case(
        lambda: plain({"Score_Goal/Score_Goal.py": PROGRAM} | NAME),
        "layout.misnamed", says="Y3: looked for score_goal/score_goal.py", repair=True, scenario="fast_shooter",
    ),
    "challenge_folders_for_two_colours": Case(
        lambda: plain({"passball_yellow/passball_yellow.py": b"y = 1\n", "pass_ball_blue/pass_ball_blue.py": PROGRAM} | NAME),
        "layout.misnamed", says="no program for Y1, Y2", repair=True, scenario="pass_the_ball",
    ),
    "match_programs_for_a_challenge": Case(
        lambda: plain(SOUND), "layout.missing", says="score_goal/score_goal.py", scenario="fast_shooter"
    ),
    "the_programs_without_their_folder": Case(
        lambda: plain({name.removeprefix("rcj_soccer_team_blue/"): data for name, data in SOUND.items()}),
        "layout.no_folder", "warning", "not in a folder rcj_soccer_team_blue", repair=True,
    ),
    "empty_second_entry": Case(
        lambda: sound_with(**{"rcj_soccer_team_yellow/rcj_soccer_team_yellow.py": b"\n"}),
        "layout.empty_program", "warning", "is empty, and this scenario does not ask for it", repair=True,
    ),
    "second_entry_of_no_bytes": Case(
        lambda: sound_with(**{"rcj_soccer_team_yellow/rcj_soccer_team_yellow.py": b""}),
        "layout.empty_program", "warning", "is empty, and this scenario does not ask for it", repair=True,
    ),
    "a_program_for_the_other_colour": Case(
        lambda: sound_with(**{"rcj_soccer_team_yellow/rcj_soccer_team_yellow.py": b"x = 1\n"}),
        "layout.never_started", "warning", "is never started",
    ),
    "the_same_program_for_the_other_colour": Case(
        lambda: plain({ENTRY: b"x = 1\n", "rcj_soccer_team_yellow/rcj_soccer_team_yellow.py": b"x = 1\n"} | NAME),
        "layout.same_program", "passed", "the same as in rcj_soccer_team_blue",
    ),
    "empty_first_entry": Case(
        lambda: plain(OF_2021 | {ENTRY: b""}), "layout.empty_entry", says="B1, B2, B3", repair=True
    ),
    "nothing_but_an_empty_entry": Case(lambda: plain({ENTRY: b" \r\n"} | NAME), "layout.empty_entry", says="is empty"),
    "name_file_missing": Case(
        lambda: plain(without(SOUND, "team_name.txt")), "identity.name_missing", "warning", "there is no team_name.txt"
    ),
    "name_file_misnamed": Case(
        lambda: named(b"Robo Cats", "Team Name.TXT"), "identity.name_file", "warning", "Team Name.TXT", repair=True
    ),
    "name_file_with_a_typo": Case(
        lambda: named(b"Robo Cats", "team_nmae.txt"), "identity.name_file", "warning", "team_nmae.txt", repair=True
    ),
    "name_file_with_two_endings": Case(
        lambda: named(b"Robo Cats", "team_name.txt.txt"), "identity.name_file", "warning", "txt.txt", repair=True
    ),
    "name_file_in_a_folder": Case(
        lambda: named(b"Robo Cats", "rcj_soccer_team_blue/team_name.txt"),
        "identity.name_file", "warning", "is in a folder", repair=True,
    ),
    "name_file_is_a_document": Case(
        lambda: named(b"{\\rtf1 Robo Cats}", "team_name.rtf"), "identity.name_document", "warning", "not plain text"
    ),
    "name_file_of_no_bytes": Case(lambda: named(b""), "identity.name_empty", "warning", "is empty"),
    "name_empty": Case(lambda: named(b" \r\n"), "identity.name_empty", "warning", "is empty"),
    "name_too_long": Case(
        lambda: named(b"The Extraordinarily Invincible Robots"), "identity.name_long", "warning", "longer than 32 characters", repair=True
    ),
    "name_of_several_lines": Case(
        lambda: named(b"Robo Cats\nof Prague\n"), "identity.name_lines", "warning", "(Robo Cats)", repair=True
    ),
    "name_with_a_byte_order_mark": Case(
        lambda: named(b"\xef\xbb\xbfRobo Cats"), "identity.name_bom", "passed", "byte order mark", repair=True
    ),
    "name_with_windows_line_ends": Case(
        lambda: named(b"Robo Cats\r\n"), "identity.name_line_ends", "passed", "line ends of Windows", repair=True
    ),
    "name_in_quotes": Case(lambda: named(b'"Robo Cats"'), "identity.name_quotes", "passed", '"Robo Cats"'),
    "name_with_dots_and_signs": Case(lambda: named(b"../R.O.B.O! ;"), "identity.name_signs", "passed", "../R.O.B.O! ;"),
    "name_in_utf_16": Case(
        lambda: named("Robo Čats".encode("utf-16")), "identity.name_utf16", "passed", "UTF-16", repair=True
    ),
    "name_in_latin_1": Case(
        lambda: named("Équipe".encode("latin-1")), "identity.name_encoding", "warning", "is not in UTF-8"
    ),
    "left_by_macos": Case(
        lambda: sound_with(**{"__MACOSX/._team_name.txt": b"\0", ".DS_Store": b"\0", "Icon\r": b""}),
        "archive.leftovers", "warning", ".DS_Store", repair=True,
    ),
    "left_by_git_and_python": Case(
        lambda: sound_with(**{".git/HEAD": b"ref", "rcj_soccer_team_blue/__pycache__/utils.cpython-311.pyc": b"\0"}),
        "archive.leftovers", "warning", ".git/HEAD", repair=True,
    ),
    "left_over_shadow_of_macos": leftover("__MACOSX/rcj_soccer_team_blue/._picture.png"),
    "left_over_desktop_file_of_macos": leftover("rcj_soccer_team_blue/.DS_Store"),
    "left_over_icon_of_macos": leftover("rcj_soccer_team_blue/Icon\r", "Icon\\r"),
    "left_over_history_of_git": leftover(".git/objects/4b/825dc642cb6eb9a060e54bf8d69288fbee4904"),
    "left_over_byte_code": leftover("rcj_soccer_team_blue/__pycache__/utils.cpython-38.pyc"),
    "rar": Case(lambda: b"Rar!\x1a\x07\x01\x00" + noise(200), "archive.other_kind", says="a RAR archive"),
    "rar_of_old": Case(lambda: b"Rar!\x1a\x07\x00" + noise(200), "archive.other_kind", says="a RAR archive"),
    "logo_is_a_jpeg": Case(
        lambda: logo(pictures.jpeg_head()), "identity.logo_type", "warning", "is a JPEG", repair=True
    ),
    "logo_is_a_gif": Case(lambda: logo(pictures.gif()), "identity.logo_type", "warning", "is a GIF", repair=True),
    "logo_is_a_bmp": Case(lambda: logo(pictures.bmp()), "identity.logo_type", "warning", "is a BMP", repair=True),
    "logo_of_2500_pixels": Case(
        lambda: logo(pictures.png(2500, 2500)), "identity.logo_size", "warning", "2500 x 2500 pixels", repair=True
    ),
    "no_entries_for_folders": Case(
        lambda: pack([Member(name, content) for name, content in SOUND.items()]),
        "archive.no_folders", "passed", "no entries of their own", repair=True,
    ),
}  # fmt: skip
"""What was seen at the demo of 2021 and since."""

IMPORTS: dict[str, Case] = {
    "a_module_is_not_included": Case(
        lambda: plain(without(SOUND, "rcj_soccer_team_blue/utils.py")), "sources.missing_module", says='imports "utils"'
    ),
    "the_libraries_of_2021_are_not_included": Case(
        lambda: plain(without(OF_2021, "team_7_libraries/robot1.py")),
        "sources.missing_module", says='imports "team_7_libraries"',
    ),
    "a_part_of_the_libraries_of_2021_is_not_included": Case(
        lambda: plain(without(OF_2021, "team_7_libraries/robot1.py") | {"team_7_libraries/robot2.py": b"x = 1\n"}),
        "sources.missing_part", says="there is no robot1.py in the folder team_7_libraries",
    ),
    "a_module_that_is_on_the_teams_own_computer_only": Case(
        lambda: importing(b"import cv2"), "sources.missing_module", says='imports "cv2"'
    ),
    "an_import_in_the_middle_of_a_program": Case(
        lambda: importing(b"def later():\n    from strategy import attack"),
        "sources.missing_module", "warning", says='"strategy"',
    ),  # fmt: skip
    "an_import_of_an_import": Case(
        lambda: sound_with(**{"rcj_soccer_team_blue/utils.py": b"from maths import speed\n"}),
        "sources.missing_module", says='imports "maths"',
    ),
    "an_import_that_the_program_can_do_without": Case(
        lambda: importing(b"try:\n    import pandas\nexcept ImportError:\n    pass"),
        "sources.missing_module", "warning", "has a way out",
    ),
    "an_import_with_capital_letters": Case(
        lambda: importing(b"import Utils"), "sources.wrong_case", says='called "utils"'
    ),
    "a_module_in_another_folder": Case(
        lambda: importing(b"import strategy", **{"shared/strategy.py": b"x = 1\n"}),
        "sources.elsewhere", says="shared/strategy.py is not where Python looks",
    ),
}  # fmt: skip
"""Sound archives with a program that imports what is not there: seen as well, but told by the stage after these."""

HOSTILE: dict[str, Case] = {
    "no_bytes_at_all": Case(lambda: b"", "archive.empty", says="not a ZIP archive"),
    "no_files": Case(lambda: pack([]), "archive.empty", says="no files"),
    "only_folders": Case(lambda: pack([folder("a"), folder("b")]), "archive.empty", says="no files"),
    "only_leftovers": Case(lambda: plain({"__MACOSX/x": b"\0"}), "archive.empty", says="no files"),
    "seven_zip": Case(lambda: b"7z\xbc\xaf\x27\x1c" + noise(100), "archive.other_kind", says="a 7-Zip archive"),
    "tar": Case(tar, "archive.other_kind", says="a tar archive"),
    "tar_gz": Case(lambda: gzip.compress(tar(), mtime=0), "archive.other_kind", says="a gzip archive"),
    "web_page": Case(lambda: b"<!DOCTYPE html><p>Sign in", "archive.other_kind", says="a web page"),
    "a_program": Case(lambda: PROGRAM, "archive.not_zip", says="not a ZIP archive"),
    "random_bytes": Case(lambda: b"\xaa" + noise(5000), "archive.not_zip", says="not a ZIP archive"),
    "a_polyglot_picture": Case(
        lambda: sound_before(pictures.png()), "archive.prepended", "warning", "stand before the archive", repair=True
    ),
    "two_archives_in_one_file": Case(lambda: plain(OF_2021) + plain(SOUND), "archive.two", says="two archives"),
    "eleven_megabytes": Case(
        lambda: pack([*with_folders(SOUND), Member("w.bin", noise(11_000_000), method=STORED)]),
        "archive.too_large", says="11.0 MB is more than the 10 MB allowed",
    ),
    "bomb_of_zeros": Case(lambda: sound_with(zeros=bytes(60_000_000)), "archive.bomb", says="100 times its size"),
    "bomb_in_many_files": Case(
        lambda: sound_with(**{f"zeros{n}": bytes(1_000_000) for n in range(60)}), "archive.bomb", says="more than"
    ),
    "bomb_that_claims_to_be_small": Case(
        lambda: member_with(content=bytes(60_000_000), size=10), "archive.bomb", says="more than"
    ),
    "bomb_of_one_member_for_many_names": Case(overlapping, "archive.overlap", says="shares its bytes"),
    "bomb_of_quoted_headers": Case(quoted, "archive.overlap", says="shares its bytes"),
    "hundred_thousand_entries": Case(
        lambda: pack(Member(f"{n}", method=STORED) for n in range(100_000)),
        "archive.too_many", says="more than 10000 entries",
    ),
    "hundred_thousand_entries_denied": Case(
        lambda: pack((Member(f"{n}", method=STORED) for n in range(100_000)), count=3), "archive.too_many"
    ),
    "six_thousand_files": Case(
        lambda: pack(Member(f"{n}.txt", method=STORED) for n in range(6_000)), "archive.too_many", says="5000 files"
    ),
    "encrypted": Case(lambda: member_with(flags=ENCRYPTED), "archive.encrypted", says="is encrypted"),
    "encrypted_strongly": Case(lambda: member_with(method=99), "archive.encrypted", says="is encrypted"),
    "method_lzma": Case(lambda: member_with(method=14, packed=b"\x09\x04"), "archive.method", says="(LZMA)"),
    "method_bzip2": Case(lambda: member_with(method=12), "archive.method", says="(bzip2)"),
    "method_nobody_knows": Case(lambda: member_with(method=77), "archive.method", says="(method 77)"),
    "wrong_checksum": Case(lambda: member_with(crc=1), "archive.damaged", says="wrong checksum (CRC)"),
    "wrong_size": Case(lambda: member_with(size=99), "archive.damaged", says="where the archive promises 99"),
    "wrong_size_of_a_stored_member": Case(
        lambda: member_with(method=STORED, size=99), "archive.damaged", says="promises 99"
    ),
    "member_breaks_off": Case(lambda: member_with(packed=deflated(b"more " * 99)[:5]), "archive.damaged", says="damaged"),
    "member_is_garbage": Case(lambda: member_with(packed=b"\xff" * 40), "archive.damaged", says="cannot be unpacked"),
    "member_lies_beyond_the_end": Case(lambda: member_with(packed_size=9_999_999), "archive.damaged", says="outside"),
    "member_lies_elsewhere": Case(lambda: member_with(offset=3_000_000_000), "archive.damaged", says="outside"),
    "truncated": Case(lambda: plain(SOUND)[:-40], "archive.truncated", says="its end is missing"),
    "cut_in_half": Case(lambda: plain(SOUND)[:250], "archive.truncated", says="its end is missing"),
    "without_its_first_bytes": Case(lambda: plain(SOUND)[9:], "archive.not_zip"),
    "table_of_contents_elsewhere": Case(
        lambda: pack(with_folders(SOUND), directory_shift=5000), "archive.truncated", says="damaged"
    ),
    "table_of_contents_of_another_size": Case(
        lambda: pack(with_folders(SOUND), directory_size=4_000_000_000), "archive.truncated", says="damaged"
    ),
    "count_of_entries_is_wrong": Case(
        lambda: pack(with_folders(SOUND), count=2), "archive.headers", "warning", "says it has 2 entries", repair=True
    ),
    "size_in_local_header_is_wrong": Case(
        lambda: member_with(local_size=1), "archive.headers", "warning", "another size or checksum", repair=True
    ),
    "another_name_in_the_local_header": Case(
        lambda: member_with(local_name=b"evil.exe"), "archive.deceptive", says="another name or method"
    ),
    "another_method_in_the_local_header": Case(lambda: member_with(local_method=STORED), "archive.deceptive"),
    "bytes_after_the_archive": Case(
        lambda: plain(SOUND) + noise(300), "archive.trailing", "warning", "300 bytes follow", repair=True
    ),
    "one_byte_after": Case(lambda: plain(SOUND) + b"x", "archive.trailing", "warning", "1 byte follows", repair=True),
    "one_byte_before": Case(lambda: sound_before(b"x"), "archive.prepended", "warning", "1 byte stands", repair=True),
    "one_entry": Case(lambda: pack(with_folders(SOUND), count=1), "archive.headers", "warning", "1 entry,", repair=True),
    "table_of_contents_damaged": Case(damaged_table, "archive.damaged", says="is damaged after 1 entry"),
    "member_of_one_byte": Case(lambda: member_with(content=b"x", size=9), "archive.damaged", says="has 1 byte where"),
    "part_of_several": Case(lambda: pack(with_folders(SOUND), disk=2), "archive.split", says="several parts"),
    "member_on_another_disk": Case(lambda: member_with(disk=3), "archive.split", says="several parts"),
    "zip64_with_lies": Case(
        lambda: pack(with_folders(SOUND), zip64=True, directory_size=1 << 60), "archive.truncated", says="damaged"
    ),
    "zip64_with_endless_entries": Case(
        lambda: pack(with_folders(SOUND), zip64=True, count=1 << 60), "archive.too_many", says="more than 10000"
    ),
    "zip64_size_of_a_member": Case(
        lambda: member_with(size=0xFFFFFFFF, extra=b"\1\0\x08\0" + b"\xff" * 8), "archive.damaged", says="promises"
    ),
    "name_leads_up": Case(
        lambda: member_with(name="../../etc/passwd"), "archive.outside", says="leads out of the archive", repair=True
    ),
    "name_leads_up_in_the_middle": Case(lambda: member_with(name="a/../../b.txt"), "archive.outside", repair=True),
    "name_is_absolute": Case(lambda: member_with(name="/etc/cron.d/x"), "archive.outside", repair=True),
    "all_names_are_absolute": Case(
        lambda: pack([Member(f"/home/me/{name}", content) for name, content in SOUND.items()]),
        "archive.outside", says="/home/me/rcj_soccer", repair=True,
    ),
    "name_has_a_drive": Case(lambda: member_with(name="C:\\Windows\\evil.txt"), "archive.outside", repair=True),
    "name_is_a_share": Case(lambda: member_with(name="\\\\server\\share\\x.txt"), "archive.outside", repair=True),
    "name_leads_up_with_backslashes": Case(lambda: member_with(name="..\\..\\x.txt"), "archive.outside", repair=True),
    "name_is_empty": Case(lambda: member_with(name=b""), "archive.outside"),
    "name_is_a_dot": Case(lambda: member_with(name=b"."), "archive.outside"),
    "folder_leads_up": Case(
        lambda: pack([folder("../../up"), *with_folders(SOUND)]), "archive.outside_folder", says="../../up", repair=True
    ),
    "names_with_backslashes": Case(
        lambda: pack([Member(name.replace("/", "\\"), content) for name, content in SOUND.items()]),
        "archive.backslashes", "warning", "separated by backslashes", repair=True,
    ),
    "name_with_a_null": Case(lambda: member_with(name=b"a.txt\0.exe"), "archive.name_control", says="\\x00", repair=True),
    "name_with_an_escape": Case(
        lambda: member_with(name="\x1b[2J\x1b[31mred.txt"), "archive.name_control", says="\\x1b[2J", repair=True
    ),
    "name_with_a_line_break": Case(lambda: member_with(name="a\nb.txt"), "archive.name_control", says="a\\nb", repair=True),
    "name_written_from_right_to_left": Case(
        lambda: member_with(name="photo_\u202egpj.exe"), "archive.name_control", says="\\u202e", repair=True
    ),
    "program_name_with_an_escape": Case(lambda: member_with(name="a\x1b.py"), "archive.name_control", says="\\x1b"),
    "name_in_no_encoding": Case(
        lambda: member_with(name=b"caf\xe9.txt", flags=0x800), "archive.name_encoding", says="UTF-8", repair=True
    ),
    "name_in_an_encoding_that_is_not_told": Case(
        lambda: member_with(name="設定/ボール.txt".encode("cp932")), "archive.name_guessed", "warning", "does not say how"
    ),
    "name_reserved_on_windows": Case(
        lambda: member_with(name="notes/aux.txt"), "archive.name_reserved", says="device on Windows", repair=True
    ),
    "console_of_windows": Case(lambda: member_with(name="CONIN$"), "archive.name_reserved", repair=True),
    "console_of_windows_in_a_folder": Case(lambda: member_with(name="x/conout$.y"), "archive.name_reserved", repair=True),
    "program_name_reserved_on_windows": Case(lambda: member_with(name="con.py"), "archive.name_reserved"),
    "name_ends_in_a_dot": Case(lambda: member_with(name="notes."), "archive.name_ending", repair=True),
    "name_ends_in_a_space": Case(lambda: member_with(name="notes /a.txt"), "archive.name_ending", repair=True),
    "name_with_a_stream": Case(lambda: member_with(name="a.txt:evil"), "archive.name_forbidden", says="(:)", repair=True),
    "name_too_long": Case(lambda: member_with(name="n" * 300 + ".txt"), "archive.name_long", repair=True),
    "name_too_deep": Case(lambda: member_with(name="d/" * 200 + "a.txt"), "archive.name_long", repair=True),
    "name_of_64_kb": Case(lambda: member_with(name=b"x" * 65_535), "archive.name_long", repair=True),
    "names_differ_by_case": Case(
        lambda: sound_with(**{"Notes.txt": b"1", "notes.TXT": b"2"}), "archive.collision", says="one file on some computers"
    ),
    "folders_differ_by_case": Case(
        lambda: sound_with(**{"A/1.txt": b"1", "a/2.txt": b"2"}), "archive.collision", says="one file on some computers"
    ),
    "names_differ_by_composition": Case(
        lambda: sound_with(**{"caf\u00e9.txt": b"1", "cafe\u0301.txt": b"2"}), "archive.collision"
    ),
    "file_is_a_folder_too": Case(
        lambda: pack([*with_folders(SOUND), Member("a", b"1"), Member("a/b.txt", b"2")]),
        "archive.collision", says="a folder that is a file as well",
    ),
    "equal_names_and_contents": Case(
        lambda: pack([*with_folders(SOUND), Member("team_name.txt", NAME["team_name.txt"])]),
        "archive.duplicate", says="is in the archive twice", repair=True,
    ),
    "equal_names_other_contents": Case(
        lambda: pack([*with_folders(SOUND), Member(ENTRY, b"import evil\n")]),
        "archive.duplicate", says="with different contents",
    ),
    "link": Case(lambda: member_with(mode=LINK_MODE, content=b"/etc/passwd"), "archive.link", says="a link or a device"),
    "device": Case(lambda: member_with(mode=DEVICE_MODE), "archive.link", says="a link or a device"),
    "folder_that_is_a_link": Case(
        lambda: pack([*with_folders(SOUND), Member("out/", b"", method=STORED, mode=LINK_MODE)]), "archive.link"
    ),
    "archive_in_the_archive": Case(
        lambda: sound_with(**{"old/team.zip": plain(SOUND)}), "archive.nested", "warning", "a ZIP archive inside"
    ),
    "nothing_but_an_archive_in_the_archive": Case(
        lambda: plain({"team.zip": plain(SOUND)}), "layout.missing", says="found: team.zip"
    ),
    "tar_in_the_archive": Case(
        lambda: sound_with(**{"team.tar": tar()}), "archive.nested", "warning", "a tar archive inside"
    ),
    "name_of_the_team_moves_the_cursor": Case(
        lambda: named(b"\x1b[2J\x1b[H\x07Evil\xc2\x9b31m"), "identity.name_unsafe", "warning", "cannot be seen", repair=True
    ),
    "name_of_the_team_turns_the_line": Case(
        lambda: named("Evil \u202e\u2067maet".encode()), "identity.name_unsafe", "warning", "Evil maet", repair=True
    ),
    "name_of_the_team_cannot_be_seen": Case(
        lambda: named("\u200b\u2800\u3164\u200d".encode()), "identity.name_empty", "warning", "is empty"
    ),
    "name_of_the_team_is_html": Case(
        lambda: named(b"<script>alert(1)</script>"), "identity.name_signs", "passed", "<script>"
    ),
    "name_of_the_team_is_a_path": Case(lambda: named(b"../../../etc/passwd"), "identity.name_signs", "passed", "../.."),
    "name_of_the_team_is_a_megabyte": Case(
        lambda: named(b"A" * 1_000_000), "identity.name_long", "warning", "longer than 32", repair=True
    ),
    "logo_is_no_picture": Case(lambda: logo(PROGRAM), "identity.logo_no_picture", "warning", "no picture", repair=True),
    "logo_is_empty": Case(lambda: logo(b""), "identity.logo_no_picture", "warning", "no picture", repair=True),
    "logo_is_a_bomb": Case(
        lambda: logo(pictures.png(30_000, 30_000, pixels=bytes(5_000_000))),
        "identity.logo_size", "warning", "30000 x 30000", repair=True,
    ),
    "logo_lies_about_its_size": Case(
        lambda: logo(pictures.png(8, 8, pixels=bytes(9_000_000))), "identity.logo_damaged", "warning", "other pixels",
        repair=True,
    ),
    "logo_of_a_megabyte_and_more": Case(
        lambda: logo(pictures.png(extra=pictures.chunk(b"iTXt", noise(1_100_000)))),
        "identity.logo_bytes", "warning", "1.1 MB", repair=True,
    ),
    "logo_breaks_off": Case(
        lambda: logo(pictures.png()[:-9]), "identity.logo_damaged", "warning", "damaged", repair=True
    ),
    "logo_moves": Case(
        lambda: logo(pictures.animated_png()), "identity.logo_animated", "warning", "only its first picture", repair=True
    ),
    "logo_called_otherwise": Case(
        lambda: logo(pictures.png(), "Team-Logo.PNG"), "identity.logo_file", "warning", "Team-Logo.PNG", repair=True
    ),
    "logo_is_called_a_jpeg": Case(
        lambda: logo(pictures.jpeg_head(), "logo.jpg"), "identity.logo_file", "warning", "logo.jpg", repair=True
    ),
}  # fmt: skip
"""What nobody hands in by mistake, and what a bad connection or a bad program makes of an archive."""

FINE: dict[str, Callable[[], bytes]] = {
    "present_layout": lambda: plain(SOUND),
    "layout_of_2021": lambda: plain(OF_2021),
    "one_robot_file": lambda: plain({"robot.py": PROGRAM, "utils.py": UTILS} | NAME),
    "with_a_logo": lambda: logo(pictures.png(1024, 1024)),
    "with_a_comment": lambda: pack(with_folders(SOUND), comment=b"made by hand PK\5\6"),
    "with_zip64_records": lambda: pack(with_folders(SOUND), zip64=True),
    "with_a_zip64_size_behind_a_time": lambda: member_with(
        size=0xFFFFFFFF, local_size=280, extra=b"UT\x05\0\1time" + b"\1\0\x08\0" + (280).to_bytes(8, "little")
    ),
    "with_sizes_after_the_content": lambda: pack(
        [Member(m.name, m.content, flags=SIZES_FOLLOW) if m.content else m for m in with_folders(SOUND)]
    ),
    "with_an_entry_for_the_top": lambda: pack([folder("."), *with_folders(SOUND)]),
    "with_data_that_is_a_zip": lambda: sound_with(**{"rcj_soccer_team_blue/weights.npz": plain({"w.npy": b"1"})}),
    "with_names_in_any_script": lambda: plain(SOUND | {"заметки/ノート.txt": b"1", "team_name.txt": "Öko ⚽ Čats".encode()}),
    "ten_megabytes": lambda: pack([*with_folders(SOUND), Member("w.bin", noise(9_990_000), method=STORED)]),
}
"""Archives without a flaw."""

ALL = SEEN | HOSTILE | LARGE


@cache
def built(name: str) -> bytes:  # once: bombs take longer to pack than to look through
    return ALL[name].build()


def sound_before(data: bytes) -> bytes:
    return pack(with_folders(SOUND), before=data)
