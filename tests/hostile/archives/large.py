"""Small archives that cost much to look through: one more than each bound allows."""

from __future__ import annotations

from rcj_challenges.checker.reading import MAX_ALL_BYTES, MAX_IMPORTS, MAX_BYTES
from rcj_challenges.submissions.limits import MAX_DEPTH, MAX_FOLDERS
from tests.hostile.archives.building import Member, pack, with_folders
from tests.hostile.archives.case import Case
from tests.hostile.archives.making import SOUND, importing, sound_with


def with_empty_folders(count: int) -> bytes:
    """Return a sound archive with so many folders, the top among them."""
    return pack([*with_folders(SOUND), *(Member(f"f{number}/", b"") for number in range(count - 2))])


LARGE: dict[str, Case] = {
    "folders_too_deep": Case(
        lambda: sound_with(**{"a/" * (MAX_DEPTH + 1) + "notes.txt": b"1"}), "archive.too_deep", says="lies too deep"
    ),
    "deep_folders_with_backslashes": Case(
        lambda: sound_with(**{"a\\" * (MAX_DEPTH + 1) + "notes.txt": b"1"}), "archive.too_deep"
    ),
    "empty_folder_too_deep": Case(
        lambda: pack([*with_folders(SOUND), Member("a/" * (MAX_DEPTH + 1), b"")]), "archive.too_deep"
    ),
    "too_many_folders": Case(
        lambda: with_empty_folders(MAX_FOLDERS + 1), "archive.too_many_folders", says="more than 1000 folders"
    ),
}


SOURCES: dict[str, Case] = {
    "a_program_in_punycode": Case(
        lambda: importing(b"# coding: punycode\n#" + b"a" * 30_000 + b"-" + b"z" * 30_000),
        "sources.odd_encoding", says="punycode",
    ),
    "a_long_program": Case(lambda: importing(b"#" * MAX_BYTES), "sources.large", "warning"),
    "long_programs": Case(
        lambda: sound_with(**{f"part{k}.py": b"%d\n" % k + b"#" * (MAX_ALL_BYTES // 5) for k in range(5)}),
        "sources.unread", "warning",
    ),
    "modules_that_import_each_other": Case(
        lambda: importing(
            b"import m0\n",
            **{f"m{k}.py": b"%d\nimport " % k + b", ".join(b"m%d" % n for n in range(80)) for k in range(80)},
        ),
        "sources.too_many_imports", "warning", says=f"more than {MAX_IMPORTS} modules",
    ),
    "many_names_of_one_module": Case(
        lambda: importing(b"from utils import " + b", ".join(b"a%d" % n for n in range(MAX_IMPORTS))),
        "sources.too_many_imports", "warning",
    ),
}  # fmt: skip
