"""Reading a ZIP archive that may be damaged or made to deceive.

This module reads the table of contents at the archive's end itself: a forgiving reader could not report what is wrong,
nor notice that two programs would unpack one archive differently. Numbers: APPNOTE.TXT of PKWARE, 4.3 and 4.5.
"""

from __future__ import annotations

import stat
import struct
import zlib
from collections.abc import Iterator
from dataclasses import dataclass

from rcj_challenges.core.amounts import counted
from rcj_challenges.core.code import Code
from rcj_challenges.core.diagnostics import Diagnostic
from rcj_challenges.submissions import codes
from rcj_challenges.submissions.problems import Problems, safe_text

MAX_ENTRIES = 10_000
"""How many entries of an archive are read; no team needs tens of thousands of files."""

_END = struct.Struct("<4s4H2LH")
_END_64 = struct.Struct("<4sQ2H2L4Q")
_LOCATOR_64 = struct.Struct("<4sLQL")
_ENTRY = struct.Struct("<4s6H3L5H2L")
_LOCAL = struct.Struct("<4s5H3L2H")
_MAX_ENDS_TRIED = 32
_ALL_ONES_16, _ALL_ONES_32 = 0xFFFF, 0xFFFFFFFF
_ENCRYPTED = 0x1 | 0x40 | 0x2000  # by password, strongly, with hidden local headers
_SIZES_FOLLOW = 0x8
_UTF_8 = 0x800
_STORED, _DEFLATED, _AES = 0, 8, 99
_METHODS = {9: "Deflate64", 12: "bzip2", 14: "LZMA", 93: "Zstandard", 95: "XZ", 98: "PPMd"}

_PACK_AGAIN = "pack the folder again, as an ordinary ZIP archive"


@dataclass(frozen=True)
class Entry:
    """One entry of the table of contents, as it describes itself.

    Attributes:
        name: with slashes or backslashes between its parts.
        raw_name: its bytes.
        flags: what kind of entry it is.
        method: how it is packed.
        crc: checksum of its content.
        packed: size of its packed content in bytes.
        size: size of its content in bytes.
        mode: permissions and kind under Unix; 0 if it was packed elsewhere.
        offset: where its local header begins, counted from the file's first byte.
    """

    name: str
    raw_name: bytes
    flags: int
    method: int
    crc: int
    packed: int
    size: int
    mode: int
    offset: int

    @property
    def is_folder(self) -> bool:
        """Whether it stands for a folder."""
        return self.name.endswith(("/", "\\"))

    @property
    def guessed(self) -> bool:
        """Whether its name is read in code page 437, which the format prescribes and Windows rarely writes."""
        return not self.flags & _UTF_8 and not _is_utf_8(self.raw_name)

    @property
    def special(self) -> bool:
        """Whether it is neither a file nor a folder: a link, a device."""
        return stat.S_IFMT(self.mode) not in (0, stat.S_IFREG, stat.S_IFDIR)

    @property
    def encrypted(self) -> bool:
        """Whether it needs a password."""
        return bool(self.flags & _ENCRYPTED) or self.method == _AES

    @property
    def unknown_method(self) -> str:
        """How it is packed, if not in one of the two ways that every program can unpack."""
        return "" if self.method in (_STORED, _DEFLATED) else _METHODS.get(self.method, f"method {self.method}")


class UnreadableError(Exception):
    """An archive, or one entry of it, cannot be read."""

    def __init__(self, code: Code, message: str, help_: str = _PACK_AGAIN, where: str = "") -> None:
        super().__init__(message)
        self.problem = Diagnostic(code, message, help_, where)


class SizeLimitError(Exception):
    """More comes out of an entry than was allowed."""


@dataclass(frozen=True)
class _Bounds:
    """Where the table of contents lies: from ``start`` to ``end``; ``shift`` bytes stand before the archive."""

    start: int
    end: int
    shift: int
    count: int


def read_entries(data: bytes, problems: Problems) -> list[Entry]:
    """Return the entries of an archive, and add what is odd about it as a whole to ``problems``.

    Raises:
        UnreadableError: it is not a ZIP, or its table of contents is damaged.
    """
    bounds = _find_bounds(data, problems)
    entries = list(_entries(data, bounds))
    if len(entries) != bounds.count:
        message = f"the archive says it has {counted(bounds.count, 'entry', 'entries')}, and has {len(entries)}"
        problems.add(Diagnostic(codes.ARCHIVE_HEADERS, message, _PACK_AGAIN))
    _check_overlap(entries, bounds)
    return entries


def unpack(data: bytes, entry: Entry, most: int) -> tuple[bytes, str]:
    """Return an entry's content, and how its local header differs from the table of contents.

    Raises:
        UnreadableError: it is damaged.
        SizeLimitError: more than ``most`` bytes come out of it, whatever it says about its size.
    """
    start, lie = _content_start(data, entry)
    packed = memoryview(data)[start : start + entry.packed]
    if entry.method == _STORED:
        if len(packed) > most:
            raise SizeLimitError
        content = bytes(packed)
    else:
        unpacker = zlib.decompressobj(-zlib.MAX_WBITS)
        try:
            content = unpacker.decompress(packed, most + 1)
        except zlib.error:
            raise _damaged(entry, "cannot be unpacked") from None
        if len(content) > most:
            raise SizeLimitError
        if not unpacker.eof:
            raise _damaged(entry, "breaks off in the middle")
    if len(content) != entry.size:
        raise _damaged(entry, f"has {counted(len(content), 'byte')} where the archive promises {entry.size}")
    if zlib.crc32(content) != entry.crc:
        raise _damaged(entry, "has a wrong checksum (CRC)")
    return content, lie


def _damaged(entry: Entry, message: str) -> UnreadableError:
    shown = safe_text(entry.name)
    return UnreadableError(codes.ARCHIVE_DAMAGED, f"'{shown}' is damaged: it {message}", where=shown)


def _find_bounds(data: bytes, problems: Problems) -> _Bounds:
    """Find the archive's end, however much follows it."""
    at = len(data)
    for _ in range(_MAX_ENDS_TRIED):
        at = data.rfind(b"PK\x05\x06", 0, at)
        if at < 0:
            break
        if at + _END.size > len(data):
            continue
        bounds = _bounds_at(data, at, problems)
        if bounds is not None:
            return bounds
    if data.startswith((b"PK\x03\x04", b"PK\x05\x06")):
        raise UnreadableError(
            codes.ARCHIVE_TRUNCATED,
            "not a ZIP archive, or a damaged one: its end is missing or damaged",
            "copy or upload it once more, or pack the folder again",
        )
    raise UnreadableError(codes.ARCHIVE_NOT_ZIP, "this is not a ZIP archive", "pack the folder as a ZIP archive")


def _bounds_at(data: bytes, at: int, problems: Problems) -> _Bounds | None:
    """The bounds by an end of the archive at this place; None if there is none."""
    _, disk, first_disk, here, count, size, offset, comment = _END.unpack_from(data, at)
    end = at
    wide = _wide_end(data, at)
    if wide is not None:
        end, wide_disk, wide_count, wide_size, wide_offset = wide
        short = (
            (count, _ALL_ONES_16, wide_count),
            (size, _ALL_ONES_32, wide_size),
            (offset, _ALL_ONES_32, wide_offset),
        )
        if any(value not in (ones, full) for value, ones, full in short):
            return None
        count = here = wide_count
        size, offset, disk, first_disk = wide_size, wide_offset, wide_disk, wide_disk
    start = end - size
    if start < 0 or (size and data[start : start + 4] != b"PK\x01\x02"):
        return None
    if offset > start or at + _END.size + comment > len(data):
        return None
    if disk or first_disk or here != count:
        raise UnreadableError(codes.ARCHIVE_SPLIT, "this is one part of an archive in several parts", _PACK_AGAIN)
    if count > MAX_ENTRIES:
        raise _too_many()
    rest = len(data) - (at + _END.size + comment)
    if rest:
        message = _stray(rest, "follows", "follow")
        problems.add(Diagnostic(codes.ARCHIVE_TRAILING, message, _PACK_AGAIN))
    if offset < start and data.startswith(b"PK\x03\x04"):
        raise UnreadableError(codes.ARCHIVE_TWO, "these are two archives in one file", _PACK_AGAIN)
    if offset < start:
        message = _stray(start - offset, "stands before", "stand before")
        problems.add(Diagnostic(codes.ARCHIVE_PREPENDED, message, _PACK_AGAIN))
    return _Bounds(start, end, start - offset, count)


def _stray(count: int, stands: str, stand: str) -> str:
    if count == 1:
        return f"1 byte {stands} the archive that does not belong to it"
    return f"{count} bytes {stand} the archive that do not belong to it"


def _too_many() -> UnreadableError:
    return UnreadableError(
        codes.ARCHIVE_TOO_MANY,
        f"the archive has more than {MAX_ENTRIES} entries",
        "pack the folder of the robot programs only",
    )


def _wide_end(data: bytes, at: int) -> tuple[int, int, int, int, int] | None:
    """Return place, disk, count, size and offset from the record for large archives (ZIP64), if there is one."""
    place = at - _LOCATOR_64.size
    if place < 0 or data[place : place + 4] != b"PK\x06\x07":
        return None
    _, _, offset, _ = _LOCATOR_64.unpack_from(data, place)
    for record in (place - _END_64.size, offset):
        if 0 <= record <= place - _END_64.size and data[record : record + 4] == b"PK\x06\x06":
            fields = _END_64.unpack_from(data, record)
            return record, fields[4], fields[7], fields[8], fields[9]
    return None


def _entries(data: bytes, bounds: _Bounds) -> Iterator[Entry]:
    at = bounds.start
    for number in range(MAX_ENTRIES + 1):
        if at == bounds.end:
            return
        if at + _ENTRY.size > bounds.end or data[at : at + 4] != b"PK\x01\x02":
            message = f"the archive's table of contents is damaged after {counted(number, 'entry', 'entries')}"
            raise UnreadableError(codes.ARCHIVE_DAMAGED, message)
        fields = _ENTRY.unpack_from(data, at)
        (_, _, _, flags, method, _, _, crc, packed, size, name_size, extra_size, comment_size) = fields[:13]
        disk, _, outer, offset = fields[13:]
        name_at = at + _ENTRY.size
        extra_at = name_at + name_size
        at = extra_at + extra_size + comment_size
        if at > bounds.end:
            raise UnreadableError(codes.ARCHIVE_DAMAGED, "the archive's table of contents breaks off")
        raw_name = data[name_at:extra_at]
        packed, size, offset = _widened(data[extra_at : extra_at + extra_size], packed, size, offset)
        if disk not in (0, _ALL_ONES_16):
            raise UnreadableError(codes.ARCHIVE_SPLIT, "this is one part of an archive in several parts")
        name = _decoded(raw_name, flags)
        yield Entry(name, raw_name, flags, method, crc, packed, size, outer >> 16, offset + bounds.shift)
    raise _too_many()


def _decoded(raw_name: bytes, flags: int) -> str:
    """Return a name as text. Tools that write UTF-8 without saying so are more common than real code page 437."""
    if flags & _UTF_8 or _is_utf_8(raw_name):
        return raw_name.decode("utf-8", "surrogateescape")
    return raw_name.decode("cp437")


def _is_utf_8(raw_name: bytes) -> bool:
    try:
        raw_name.decode("utf-8")
    except UnicodeDecodeError:
        return False
    return True


def _widened(extra: bytes, packed: int, size: int, offset: int) -> tuple[int, int, int]:
    """Return sizes and offset with those of the extra field 1 (ZIP64) in place of all ones."""
    at = 0
    while at + 4 <= len(extra):
        kind, length = struct.unpack_from("<2H", extra, at)
        if kind == 1:
            wide = [value for (value,) in struct.iter_unpack("<Q", extra[at + 4 : at + 4 + length // 8 * 8][:24])]
            values = [size, packed, offset]
            for place, value in enumerate(values):
                if value == _ALL_ONES_32 and wide:
                    values[place] = wide.pop(0)
            return values[1], values[0], values[2]
        at += 4 + length
    return packed, size, offset


def _check_overlap(entries: list[Entry], bounds: _Bounds) -> None:
    """Refuse entries that share bytes: small archives become large that way, and programs read them differently."""
    end = 0
    for entry in sorted(entries, key=lambda entry: entry.offset):
        shown = safe_text(entry.name)
        if entry.offset < end:
            message = f"'{shown}' shares its bytes with another entry"
            raise UnreadableError(codes.ARCHIVE_OVERLAP, message, where=shown)
        end = entry.offset + _LOCAL.size + len(entry.raw_name) + entry.packed
        if end > bounds.start:
            message = f"'{shown}' is said to lie outside of the archive"
            raise UnreadableError(codes.ARCHIVE_DAMAGED, message, where=shown)


def _content_start(data: bytes, entry: Entry) -> tuple[int, str]:
    """Return where an entry's content begins, and what its own header says otherwise."""
    at = entry.offset
    if at + _LOCAL.size > len(data) or data[at : at + 4] != b"PK\x03\x04":
        raise _damaged(entry, "is not where the archive says")
    _, _, flags, method, _, _, crc, packed, size, name_size, extra_size = _LOCAL.unpack_from(data, at)
    start = at + _LOCAL.size + name_size + extra_size
    if start + entry.packed > len(data):
        raise _damaged(entry, "breaks off")
    shown = safe_text(entry.name)
    raw_name = data[at + _LOCAL.size : at + _LOCAL.size + name_size]
    if raw_name != entry.raw_name or method != entry.method or (flags ^ entry.flags) & _ENCRYPTED:
        message = f"'{shown}' has another name or method in the table of contents than in its own header"
        raise UnreadableError(codes.ARCHIVE_DECEPTIVE, message, where=shown)
    said = ((crc, entry.crc), (packed, entry.packed), (size, entry.size))
    if not flags & _SIZES_FOLLOW and any(here not in (there, _ALL_ONES_32) for here, there in said):
        return start, f"'{shown}' has another size or checksum in the table of contents than in its own header"
    return start, ""
