"""Uploads as they come over HTTP: a hundred at once, too large, damaged, malicious, and with a full disk."""

from __future__ import annotations

import asyncio
import contextlib
import http.client
import random
import statistics
import subprocess
import tempfile
import time
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from datetime import timedelta
from pathlib import Path
from typing import Any

import pytest
from django.db import close_old_connections
from django.utils import timezone

from rcj_challenges.web import blobs, jobs
from rcj_challenges.web.config import SiteConfig
from rcj_challenges.web.models import Job, Season, State, Submission
from rcj_challenges.web.receiving import RefusedError, receive
from tests.hostile.archives.cases import ALL, FINE, built
from tests.web.conftest import Postgres, Served, make_folder, make_team, postgres_programs, use_site
from tests.web.handing_in import hand_in

MANY = {"uploads_per_hour": 100_000, "uploads_per_day": 100_000, "upload_bytes_per_day": 10**12}
_MAX_WEB_BYTES = 200_000_000


def peak_bytes(pid: int) -> int:
    status = Path(f"/proc/{pid}/status").read_text(encoding="utf-8")
    return int(next(line for line in status.splitlines() if line.startswith("VmHWM")).split()[1]) * 1024


@pytest.fixture(params=["sqlite", pytest.param("postgresql", marks=pytest.mark.nightly)])
def any_folder(request: pytest.FixtureRequest, tmp_path: Path, folder: Callable[..., SiteConfig]) -> SiteConfig:
    """Return the folder of a site that is not used by this process yet, with each database."""
    if request.param == "sqlite":
        return folder(**MANY)
    return make_folder(tmp_path / "club", request.getfixturevalue("postgres").new_database(), **MANY)


@pytest.mark.parametrize(
    ("count", "size_bytes"),
    [(30, 100_000), *(pytest.param(100, size, marks=pytest.mark.nightly) for size in (100_000, 9_900_000))],
)
def test_uploads_of_many_just_before_the_deadline_are_all_in_time_and_what_begins_after_it_is_late(
    any_folder: SiteConfig, serve: Callable[..., Served], count: int, size_bytes: int
) -> None:
    with use_site(any_folder):
        codes = [make_team(f"Team {index}")[1] for index in range(count)]
    served = serve(any_folder, "--no-dispatch")
    noise = random.Random(1).randbytes(size_bytes)  # noqa: S311 - no secret
    began = time.monotonic()
    assert served.submit(codes[0], b"alone" + noise)[0] == 201
    alone_s = time.monotonic() - began
    took_s, pages_s = [], []

    def upload(index: int) -> dict[str, Any]:
        start = time.monotonic()
        status, receipt = served.submit(codes[index], f"{index} ".encode() + noise)
        took_s.append(time.monotonic() - start)
        assert status == 201, receipt
        return receipt

    with ThreadPoolExecutor(count) as pool:
        sent = [pool.submit(upload, index) for index in range(count)]
        while not all(one.done() for one in sent):
            start = time.monotonic()
            assert served.get("/help")[0] == 200
            pages_s.append(time.monotonic() - start)
            time.sleep(0.05)
        receipts = [one.result() for one in sent]
    last = max(receipt["begun_at"] for receipt in receipts)
    print(
        f"one upload {alone_s:.2f} s; {count} at once {max(took_s):.2f} s, median {statistics.median(took_s):.2f} s;"
        f" pages meanwhile {statistics.median(pages_s):.2f} s, slowest {max(pages_s):.2f} s;"
        f" memory {peak_bytes(served.process.pid) / 1e6:.0f} MB"
    )
    assert max(took_s) < count * alone_s + 5  # not slower than one after the other
    assert peak_bytes(served.process.pid) < _MAX_WEB_BYTES
    with use_site(any_folder):
        stored = {one.pk: one for one in Submission.objects.all()}
        assert all(stored[receipt["id"]].sha256 == receipt["sha256"] for receipt in receipts)
        Season.objects.update(closes_at=last)
        assert served.submit(codes[0], b"late")[1]["is_late"]
        assert not any(receipt["is_late"] for receipt in receipts)
        # All have used as much, so those that came first are checked first.
        claimed = [jobs.claim("one", timezone.now()) for _ in range(count)]
        order = [job.pk for job in claimed if job is not None]
        assert len(order) == count
        assert order == sorted(order)
        assert Job.objects.filter(state="queued").count() == 0


def damaged(seed: int) -> bytes:
    """Return an archive with some bytes that are others, are missing, or are there twice."""
    chance = random.Random(seed)  # noqa: S311 - no secret
    data = bytearray(built(chance.choice(SMALL)))
    for _ in range(chance.randrange(1, 8)):
        at, size = chance.randrange(max(1, len(data))), chance.randrange(1, 9)
        kind = chance.randrange(3)
        part = chance.randbytes(size) if kind == 0 else data[at : at + size] * 2 if kind == 1 else b""
        data[at : at + size] = part
    return bytes(data)


SMALL = sorted(name for name in ALL if not name.startswith(("bomb", "hundred", "six_", "eleven")))


@pytest.mark.parametrize("count", [20, pytest.param(10_000, marks=pytest.mark.nightly)])
def test_no_archive_is_an_error_of_the_server_or_takes_its_memory(
    folder: Callable[..., SiteConfig], serve: Callable[..., Served], count: int
) -> None:
    config = folder(**MANY)
    with use_site(config):
        _, code = make_team()
    served = serve(config, "--no-dispatch")
    known = SMALL[::8] if count == 20 else sorted(ALL)
    archives = [built(name) for name in known] + [build() for name, build in FINE.items() if name != "ten_megabytes"]
    statuses = {served.submit(code, data)[0] for data in archives}
    statuses |= {served.submit(code, damaged(seed))[0] for seed in range(count)}
    print(f"{len(archives) + count} archives; memory {peak_bytes(served.process.pid) / 1e6:.0f} MB")
    assert statuses <= {201, 413}
    assert peak_bytes(served.process.pid) < _MAX_WEB_BYTES
    assert "Traceback" not in served.log.read_text(encoding="utf-8")


def raw(served: Served, head: str, body: bytes = b"") -> int:
    """Send a request as it stands; return the status."""
    connection = http.client.HTTPConnection(served.address.removeprefix("http://"), timeout=30)
    connection.connect()
    assert connection.sock is not None
    connection.sock.sendall(head.replace("\n", "\r\n").encode() + b"\r\n" + body)
    answer = http.client.HTTPResponse(connection.sock)
    answer.begin()
    answer.read()
    connection.close()
    return answer.status


def test_too_much_is_refused_unread_and_counted_where_no_length_is_given(quiet: Served) -> None:
    with use_site(quiet.config):
        _, code = make_team()
    api = "POST /api/v1/submissions HTTP/1.1\nHost: localhost\nConnection: close\n"
    card = f"Authorization: Bearer {code}\n"
    chunk = b"%x\r\n" % 60_000 + bytes(60_000) + b"\r\n"
    end = b"0\r\n\r\n"
    chunked = "Transfer-Encoding: chunked\n"
    assert raw(quiet, api + card + "Content-Length: 100001\n", b"") == 413
    assert raw(quiet, api + card + chunked, chunk + chunk + end) == 413
    assert raw(quiet, api + card + chunked, chunk + end) == 201
    assert raw(quiet, api + chunked, chunk + end) == 401
    assert raw(quiet, "GET /help HTTP/1.1\nHost: localhost\nContent-Length: 70000\n", b"") == 413
    assert raw(quiet, "GET /help HTTP/1.1\nHost: localhost\n" + chunked, chunk + chunk + end) in {200, 413}
    form = "POST /my/upload HTTP/1.1\nHost: localhost\nContent-Type: multipart/form-data; boundary=x\n"
    assert raw(quiet, form + chunked, chunk + end) == 411
    assert raw(quiet, form + "Content-Length: 1000000\n") == 413
    assert list((quiet.config.folder / "incoming").iterdir()) == []


def test_an_upload_that_is_cut_off_leaves_nothing(quiet: Served) -> None:
    with use_site(quiet.config):
        team, code = make_team("Red Foxes")
    connection = http.client.HTTPConnection(quiet.address.removeprefix("http://"), timeout=30)
    connection.connect()
    assert connection.sock is not None
    head = f"POST /api/v1/submissions HTTP/1.1\r\nHost: localhost\r\nAuthorization: Bearer {code}\r\n"
    connection.sock.sendall(head.encode() + b"Content-Length: 90000\r\n\r\n" + bytes(70_000))
    incoming = quiet.config.folder / "incoming"
    until = time.monotonic() + 30
    while not any(path.stat().st_size for path in incoming.iterdir()):
        assert time.monotonic() < until
        time.sleep(0.01)
    connection.close()
    while list(incoming.iterdir()):
        assert time.monotonic() < until
        time.sleep(0.01)
    assert "Traceback" not in quiet.log.read_text(encoding="utf-8")
    with use_site(quiet.config):
        assert not Submission.objects.filter(team=team).exists()


@pytest.fixture
def small_disk(tmp_path: Path) -> Iterator[Path]:
    """Return the folder of a file system of 4 MB."""
    place = tmp_path / "disk"
    place.mkdir()
    mounted = subprocess.run(
        ["mount", "-t", "tmpfs", "-o", "size=4m", "tmpfs", place], capture_output=True, check=False
    )
    if mounted.returncode:
        pytest.skip("a small file system cannot be mounted without root")
    yield place
    subprocess.run(["umount", "-l", place], check=True)


def test_where_the_disk_is_nearly_full_nothing_is_taken_or_begun_and_nothing_is_lost(
    small_disk: Path, migrated: Path, serve: Callable[..., Served]
) -> None:
    config = make_folder(small_disk / "club")
    (config.folder / "site.sqlite3").write_bytes(migrated.read_bytes())
    with use_site(config):
        team, code = make_team()
        hand_in(config, team, b"x", timezone.now())
    served = serve(config)
    assert served.submit(code, b"y")[0] == 507
    time.sleep(2)
    with use_site(config):
        assert [one.state for one in Submission.objects.all()] == [State.QUEUED]


@pytest.mark.parametrize("way", ["kept", "received"])
def test_an_upload_for_which_the_disk_has_no_room_is_refused_and_nothing_is_broken(
    small_disk: Path, migrated: Path, monkeypatch: pytest.MonkeyPatch, way: str
) -> None:
    monkeypatch.setattr(blobs, "MIN_FREE_BYTES", 0)
    config = make_folder(small_disk / "club")
    (config.folder / "site.sqlite3").write_bytes(migrated.read_bytes())
    with use_site(config):
        team, code = make_team()
        hand_in(config, team, b"before", timezone.now())
        if way == "received":
            with ThreadPoolExecutor(1) as apart:  # a browser of other tests may run a loop in this thread
                assert apart.submit(lambda: asyncio.run(posted(config, code, bytes(6_000_000)))).result() == 507
        else:
            (config.folder / "incoming" / "next").write_bytes(b"")  # as if the rest of the disk went meanwhile
            fill(small_disk)
            now, season = timezone.now(), Season.objects.get()
            new = Submission(
                team=team, season=season, sha256="0" * 64, size_bytes=0, begun_at=now, received_at=now, via="api"
            )
            with pytest.raises(RefusedError) as refused:
                receive(config.folder / "incoming" / "next", new)
            assert refused.value.status == 507
        (small_disk / "filling").unlink(missing_ok=True)
        after = hand_in(config, team, b"after", timezone.now())
        job = jobs.claim("one", timezone.now() + timedelta(seconds=1))
        assert job is not None
        assert job.submission_id == after.pk
        for one in Submission.objects.all():
            assert blobs.Blobs(config.folder).path(one.sha256).exists()
        assert not list((config.folder / "incoming").glob("upload-*"))


@pytest.fixture
def postgres_on_a_small_disk(tmp_path: Path) -> Iterator[Postgres]:
    """Start a server of PostgreSQL whose file system has 150 MB."""
    programs = postgres_programs()
    place = Path(tempfile.mkdtemp(prefix="rcj-pg-"))
    mounted = programs and subprocess.run(
        ["mount", "-t", "tmpfs", "-o", "size=150m", "tmpfs", place], capture_output=True, check=False
    )
    if not mounted or mounted.returncode:
        pytest.skip("PostgreSQL's server is not installed, or a small file system cannot be mounted without root")
    try:
        server = Postgres(place, programs)
        yield server
        server.stop("immediate", wait=True)
    finally:
        subprocess.run(["umount", "-l", place], check=True)
        place.rmdir()


@pytest.mark.nightly
def test_uploads_while_the_disk_of_the_database_is_full_are_refused_and_nothing_is_lost(
    postgres_on_a_small_disk: Postgres, tmp_path: Path
) -> None:
    config = make_folder(tmp_path / "club", postgres_on_a_small_disk.new_database(), **MANY)
    with use_site(config):
        team, _ = make_team()
        taken = [hand_in(config, team, b"before", timezone.now())]
        fill(postgres_on_a_small_disk.folder)
        with pytest.raises(RefusedError) as refused:
            taken.extend(hand_in(config, team, f"full {number}".encode(), timezone.now()) for number in range(20_000))
        assert refused.value.status == 507
        (postgres_on_a_small_disk.folder / "filling").unlink()
        close_old_connections()
        with contextlib.suppress(AssertionError):  # it may have ended, as it does where its log finds no room
            postgres_on_a_small_disk.start()
        after = hand_in(config, team, b"after", timezone.now())
        assert set(Submission.objects.values_list("pk", flat=True)) >= {one.pk for one in (*taken, after)}
        for one in Submission.objects.all():
            assert blobs.Blobs(config.folder).path(one.sha256).exists()
        job = jobs.claim("one", timezone.now() + timedelta(seconds=1))
        assert job is not None
        assert job.submission_id == after.pk


def fill(disk: Path) -> None:
    with (disk / "filling").open("wb", buffering=0) as file, contextlib.suppress(OSError):
        while True:
            file.write(bytes(4096))


async def posted(config: SiteConfig, code: str, body: bytes) -> int:
    """Send an upload to the application as a server does; return the status."""
    from rcj_challenges.web.front import asgi_app

    parts = [body[start : start + 65536] for start in range(0, len(body), 65536)]
    statuses: list[int] = []

    async def read() -> dict[str, Any]:
        return {"type": "http.request", "body": parts.pop(0) if parts else b"", "more_body": bool(parts)}

    async def send(message: Any) -> None:
        if message["type"] == "http.response.start":
            statuses.append(message["status"])

    scope = {
        "type": "http", "method": "POST", "path": "/api/v1/submissions", "query_string": b"", "root_path": "",
        "headers": [(b"authorization", f"Bearer {code}".encode()), (b"content-length", str(len(body)).encode())],
        "server": ("localhost", 80), "client": ("127.0.0.1", 1), "scheme": "http", "http_version": "1.1",
    }  # fmt: skip
    await asgi_app(config)(scope, read, send)
    return statuses[0]
