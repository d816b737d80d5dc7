"""Any byte string as archive: a verdict in words, within bounds of time and memory, never a traceback."""

from __future__ import annotations

import random
import time
from collections.abc import Callable
from functools import cache
from pathlib import Path, PurePosixPath

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rcj_challenges.checker.archives import inspect
from rcj_challenges.checker.findings import STAGES
from rcj_challenges.checker.identity import find_logo
from rcj_challenges.checker.images import PictureError, as_png, identify
from rcj_challenges.checker.repair import repair
from rcj_challenges.scenario.load import load
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.submissions.paths import clean, name_problems
from rcj_challenges.submissions.problems import safe_text
from rcj_challenges.submissions.team import TeamError, open_team
from rcj_challenges.submissions.team_name import find_team_name
from tests.hostile.archives import pictures
from tests.hostile.archives.building import Member, pack, with_folders
from tests.hostile.archives.cases import ALL, FINE, built
from tests.hostile.archives.making import NAME, SOUND

MAX_CPU_S = 5
INTERESTING = (
    b"PK\1\2",
    b"PK\3\4",
    b"PK\5\6",
    b"PK\6\6",
    b"PK\6\7",
    b"PK\7\10",
    b"\0" * 4,
    b"\xff" * 4,
    b"\xff" * 8,
    b"../",
    b"\\",
)


@cache
def scenario() -> Scenario:
    return load("match").scenario


@cache
def seeds() -> list[bytes]:
    """Return archives to begin with: those that are small."""
    known = [built(name) for name in ALL if not name.startswith(("bomb", "hundred", "six_", "eleven"))]
    known += [build() for name, build in FINE.items() if name != "ten_megabytes"]
    return [data for data in known if len(data) < 20_000]


def check_holds(folder: Path, data: bytes, *, mend: bool) -> None:
    """Assert what is promised for any bytes."""
    path = folder / "any.zip"
    path.write_bytes(data)
    began = time.process_time()
    inspection = inspect(path, scenario())
    assert time.process_time() - began < MAX_CPU_S
    assert [stage.name for stage in inspection.stages] == list(STAGES)[:3]
    found = [finding for stage in inspection.stages for finding in stage.findings]
    for finding in found:
        for text in (finding.message, finding.help, finding.where):
            assert len(text) < 3000
            assert safe_text(text, 3000) == text
    assert safe_text(inspection.opening.name.text) == inspection.opening.name.text
    failed = any(stage.failed for stage in inspection.stages)
    assert failed or inspection.team is not None
    try:
        team = open_team(path, *scenario().entrants.values())
        assert inspection.team.digest == team.digest
    except TeamError:
        assert inspection.team is None
        assert failed
    if mend:
        check_mended(folder, path)


def check_mended(folder: Path, path: Path) -> None:
    """Assert that what a repair writes is sound, and that nothing was left for a second one."""
    out, again = folder / "out.zip", folder / "again.zip"
    out.unlink(missing_ok=True)
    again.unlink(missing_ok=True)
    if repair(path, out, scenario()).out is None:
        return
    assert not inspect(out, scenario()).stages[0].failed
    repair(out, again, scenario())
    assert out.read_bytes() == again.read_bytes()


def mutated(seed: int) -> bytes:
    """Return an archive that something happened to."""
    chance = random.Random(seed)  # noqa: S311 - nothing secret
    data = bytearray(chance.choice(seeds()))
    for _ in range(chance.choice((1, 1, 2, 3, 8))):
        chance.choice(MUTATIONS)(data, chance)
    return bytes(data)


def flip(data: bytearray, chance: random.Random) -> None:
    if data:
        data[chance.randrange(len(data))] = chance.randrange(256)


def flip_near_a_header(data: bytearray, chance: random.Random) -> None:
    """Change a byte of a header: that is where the lies are."""
    magic = chance.choice((b"PK\1\2", b"PK\3\4", b"PK\5\6"))
    places = [at for at in range(len(data)) if data.startswith(magic, at)]
    if places:
        at = chance.choice(places) + chance.randrange(4, 46)
        if at < len(data):
            data[at] = chance.choice((0, 1, 0x7F, 0x80, 0xFF, chance.randrange(256)))


def cut(data: bytearray, chance: random.Random) -> None:
    del data[chance.randrange(len(data) + 1) :]


def drop(data: bytearray, chance: random.Random) -> None:
    start = chance.randrange(len(data) + 1)
    del data[start : start + chance.choice((1, 2, 4, 30, 300))]


def insert(data: bytearray, chance: random.Random) -> None:
    at = chance.randrange(len(data) + 1)
    data[at:at] = chance.choice((*INTERESTING, chance.randbytes(chance.randrange(40))))


def overwrite(data: bytearray, chance: random.Random) -> None:
    at = chance.randrange(len(data) + 1)
    word = chance.choice(INTERESTING)
    data[at : at + len(word)] = word


def repeat(data: bytearray, chance: random.Random) -> None:
    start = chance.randrange(len(data) + 1)
    data[start:start] = data[start : start + chance.randrange(1, 400)]


def splice(data: bytearray, chance: random.Random) -> None:
    other = chance.choice(seeds())
    data[chance.randrange(len(data) + 1) :] = other[chance.randrange(len(other) + 1) :]


MUTATIONS: tuple[Callable[[bytearray, random.Random], None], ...] = (
    flip, flip, flip_near_a_header, flip_near_a_header, flip_near_a_header, cut, drop, insert, overwrite, repeat, splice
)  # fmt: skip


@given(st.integers(0, 2**64 - 1))
def test_a_mutated_archive_gives_a_verdict(tmp_path: Path, seed: int) -> None:
    check_holds(tmp_path, mutated(seed), mend=seed % 8 == 0)


@pytest.mark.nightly
@settings(max_examples=50_000)
@given(st.integers(0, 2**64 - 1))
def test_many_mutated_archives_give_a_verdict(tmp_path: Path, seed: int) -> None:
    check_holds(tmp_path, mutated(seed), mend=True)


@given(st.binary(max_size=400))
def test_any_bytes_give_a_verdict(tmp_path: Path, data: bytes) -> None:
    check_holds(tmp_path, data, mend=False)


@st.composite
def members(draw: st.DrawFn) -> Member:
    """Return an entry with any name, and lies about anything."""
    part = st.one_of(
        st.text(max_size=8), st.sampled_from(["..", ".", "", "aux", "C:", "robot1", "robot1.py", "logo.png"])
    )
    name = draw(st.one_of(st.lists(part, max_size=4).map("/".join), st.binary(max_size=12)))
    raw = name if isinstance(name, bytes) else name.encode("utf-8", "surrogatepass")
    maybe = st.one_of(st.none(), st.none(), st.none(), st.integers(0, 2**32 - 1))
    return Member(
        raw,
        draw(st.binary(max_size=40)),
        method=draw(st.sampled_from([0, 8, 8, 8, 12, 14, 99])),
        flags=draw(st.sampled_from([0, 0, 0, 1, 8, 0x800])),
        mode=draw(st.sampled_from([0, 0o100644, 0o100644, 0o120777, 0o040755])),
        crc=draw(maybe),
        size=draw(maybe),
        packed_size=draw(maybe),
        offset=draw(maybe),
        extra=draw(st.sampled_from([b"", b"", b"\1\0\x08\0" + b"\xff" * 8, b"\1\0\xff\xff", b"\1"])),
    )


@given(st.lists(members(), max_size=5), st.booleans())
def test_an_archive_that_lies_gives_a_verdict(tmp_path: Path, odd: list[Member], wide: bool) -> None:
    check_holds(tmp_path, pack([*with_folders(SOUND), *odd], zip64=wide), mend=True)


@given(st.text(max_size=60))
def test_a_cleaned_name_is_a_good_one(name: str) -> None:
    path = clean(name)
    if path is not None:
        assert list(name_problems(str(path))) == []
        assert clean(str(path)) == path
    if not list(name_problems(name)):
        assert path is not None


@given(st.binary(max_size=200))
def test_any_bytes_in_the_name_file_give_a_name_that_stays(content: bytes) -> None:
    path = next(iter(NAME))
    name = find_team_name({PurePosixPath(path): content}, "fallback")
    assert 0 < len(name.text) <= 32
    assert safe_text(name.text) == name.text
    again = find_team_name({PurePosixPath(path): name.text.encode()}, "fallback")
    assert again.text == name.text
    assert all(problem.level == "passed" for problem in again.problems)


PICTURES = [
    pictures.png(),
    pictures.animated_png(),
    pictures.gif(),
    pictures.bmp(),
    pictures.jpeg_head(),
    b"RIFF\0\0\0\0WEBPVP8X",
]


@given(st.sampled_from(PICTURES), st.binary(max_size=60), st.integers(0, 200), st.booleans())
def test_any_bytes_as_logo_are_a_picture_or_none(start: bytes, rest: bytes, at: int, convert: bool) -> None:
    data = start[:at] + rest + start[at + len(rest) :]
    identify(data)
    logo = find_logo({PurePosixPath("logo.png"): data})
    assert logo.shown is None or find_logo({PurePosixPath("logo.png"): logo.shown}).shown == logo.shown
    if convert:
        try:
            assert find_logo({PurePosixPath("logo.png"): as_png(data)}).shown is not None
        except PictureError as error:
            assert safe_text(error) == str(error)  # noqa: PT017 - the property is about every error
