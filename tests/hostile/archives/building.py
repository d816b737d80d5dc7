"""Making ZIP archives byte by byte, so that each field can lie. Numbers: APPNOTE.TXT of PKWARE, 4.3."""

from __future__ import annotations

import stat
import struct
import zlib
from collections.abc import Iterable, Mapping
from dataclasses import dataclass

STORED, DEFLATED = 0, 8
FILE_MODE, FOLDER_MODE, LINK_MODE, DEVICE_MODE = 0o100644, 0o040755, stat.S_IFLNK | 0o777, stat.S_IFCHR | 0o666
ENCRYPTED, SIZES_FOLLOW, UTF_8 = 0x1, 0x8, 0x800


@dataclass
class Member:
    """One entry; what is None is told truly.

    Attributes:
        name: as the table of contents has it; bytes are taken as they are.
        content: unpacked.
        method: how it is packed.
        flags: general purpose flags.
        mode: kind and permissions.
        crc: checksum that the table of contents claims.
        size: unpacked size that the table of contents claims.
        packed_size: packed size that the table of contents claims.
        packed: packed bytes, if not those of the content.
        local_name: name in the local header.
        local_size: unpacked size in the local header.
        local_method: how it is packed, in the local header.
        offset: where the table of contents says that the local header is.
        extra: extra field in the table of contents.
        disk: number of the disk that it is said to be on.
    """

    name: str | bytes
    content: bytes = b""
    method: int = DEFLATED
    flags: int = 0
    mode: int = FILE_MODE
    crc: int | None = None
    size: int | None = None
    packed_size: int | None = None
    packed: bytes | None = None
    local_name: bytes | None = None
    local_size: int | None = None
    local_method: int | None = None
    offset: int | None = None
    extra: bytes = b""
    disk: int = 0

    def raw_name(self) -> bytes:
        return self.name if isinstance(self.name, bytes) else self.name.encode()

    def raw_flags(self) -> int:
        return self.flags if isinstance(self.name, bytes) else self.flags | UTF_8

    def raw(self) -> bytes:
        if self.packed is not None:
            return self.packed
        return deflated(self.content) if self.method == DEFLATED else self.content


def deflated(content: bytes) -> bytes:
    packer = zlib.compressobj(9, zlib.DEFLATED, -zlib.MAX_WBITS)
    return packer.compress(content) + packer.flush()


def folder(name: str) -> Member:
    return Member(f"{name.rstrip('/')}/", method=STORED, mode=FOLDER_MODE)


def with_folders(files: Mapping[str, bytes]) -> list[Member]:
    """Return members for files and for the folders that they are in."""
    folders: dict[str, None] = {}
    for name in files:
        parts = name.split("/")[:-1]
        folders |= {"/".join(parts[: depth + 1]): None for depth in range(len(parts))}
    return [*map(folder, sorted(folders)), *(Member(name, content) for name, content in files.items())]


def pack(
    members: Iterable[Member],
    *,
    before: bytes = b"",
    after: bytes = b"",
    comment: bytes = b"",
    count: int | None = None,
    disk: int = 0,
    zip64: bool = False,
    directory_size: int | None = None,
    directory_shift: int = 0,
) -> bytes:
    """Return an archive.

    Args:
        members: its entries.
        before: bytes before it that no offset counts.
        after: bytes after it.
        comment: the archive's comment.
        count: number of entries it claims.
        disk: number of this disk it claims.
        zip64: whether count, size and place stand in the records for large archives only.
        directory_size: size of the table of contents it claims.
        directory_shift: added to the place of the table of contents it claims.
    """
    body, directory = bytearray(), bytearray()
    number = 0
    for member in members:
        number += 1
        raw, name, flags = member.raw(), member.raw_name(), member.raw_flags()
        crc = zlib.crc32(member.content) if member.crc is None else member.crc
        size = len(member.content) if member.size is None else member.size
        packed_size = len(raw) if member.packed_size is None else member.packed_size
        offset = len(body) if member.offset is None else member.offset
        local_name = name if member.local_name is None else member.local_name
        local_size = size if member.local_size is None else member.local_size
        local_method = member.method if member.local_method is None else member.local_method
        told = (crc, packed_size, local_size) if not flags & SIZES_FOLLOW else (0, 0, 0)
        body += struct.pack("<4s5H3L2H", b"PK\3\4", 20, flags, local_method, 0, 33, *told, len(local_name), 0)
        body += local_name + raw
        if flags & SIZES_FOLLOW:
            body += struct.pack("<4s3L", b"PK\7\10", crc, packed_size, size)
        directory += struct.pack(
            "<4s6H3L5H2L", b"PK\1\2", 0x314, 20, flags, member.method, 0, 33, crc, packed_size, size,
            len(name), len(member.extra), 0, member.disk, 0, member.mode << 16, offset,
        )  # fmt: skip
        directory += name + member.extra
    start = len(body) + directory_shift
    long = len(directory) if directory_size is None else directory_size
    count = number if count is None else count
    wide = b""
    if zip64:
        record = len(before) + len(body) + len(directory)
        wide = struct.pack("<4sQ2H2L4Q", b"PK\6\6", 44, 45, 45, disk, disk, count, count, long, start)
        wide += struct.pack("<4sLQL", b"PK\6\7", 0, record, 1)
        count, long, start = 0xFFFF, 0xFFFFFFFF, 0xFFFFFFFF
    end = struct.pack("<4s4H2LH", b"PK\5\6", disk, disk, count & 0xFFFF, count & 0xFFFF, long, start, len(comment))
    return before + bytes(body + directory) + wide + end + comment + after
