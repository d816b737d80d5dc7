"""What a program must not do, tried by real programs under one layer at a time: each layer holds by itself."""

from __future__ import annotations

import os
import socket
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

import pytest
from attempts import only, outcomes
from fake_match import FakeMatch, robot_spec, values_at

from rcj_challenges.programs import isolation
from rcj_challenges.programs.program_side.controller import _landlock, _seccomp
from rcj_challenges.core.traffic import Observation, Request

needs_landlock = pytest.mark.skipif(not _landlock.is_available(), reason="this kernel has no Landlock")
needs_seccomp = pytest.mark.skipif(not _seccomp.is_available(), reason="this kernel has no seccomp, or another machine")
needs_linux = pytest.mark.skipif(sys.platform != "linux", reason="layers of Linux")
LANDLOCK = _landlock.version() if _landlock.is_available() else 0

READS = {
    "who has an account": "open('/etc/passwd').read()",
    "a file of the record": "open(secret).read()",
    "the folder of the record": "os.listdir(elsewhere)",
    "another program's folder": "os.listdir(sibling)",
    "another program's code": "open(sibling + '/robot.py').read()",
    "who else has a private folder": "os.listdir(os.path.dirname(sibling))",
    "the match's command line, with the seed": "open(f'/proc/{parent}/cmdline').read()",
    "the match's environment": "open(f'/proc/{parent}/environ').read()",
    "the match's memory": "open(f'/proc/{parent}/mem', 'rb')",
    "the match's pipes": "os.listdir(f'/proc/{parent}/fd')",
    "where the match runs": "os.readlink(f'/proc/{parent}/cwd')",
    "all processes": "os.listdir('/proc')",
    "a file by the root of its own process": "open(os.path.join('/proc/self/root', 'etc/passwd')).read()",
    "the match by a way round": "open(f'/proc/self/../{parent}/environ').read()",
    "a file by a link of its own": "(os.symlink(secret, 'link'), open('link').read())",
}
WRITES = {
    "a new file elsewhere": "open(elsewhere + '/new', 'w')",
    "the end of a foreign file": "open(secret, 'a')",
    "the place of a foreign file": "os.unlink(secret)",
    "a folder elsewhere": "os.mkdir(elsewhere + '/folder')",
    "a link elsewhere": "os.symlink('x', elsewhere + '/link')",
    "a second name for a foreign file": "os.link(secret, 'mine')",
    "a foreign file's folder": "os.rename(secret, 'mine')",
    "its own file's folder": "(open('own', 'w').close(), os.rename('own', elsewhere + '/own'))",
    "Python's library": "open(os.__file__, 'a')",
    "the controller module": "open(sys.modules['controller'].__file__, 'a')",
    "memory that all share": "open('/dev/shm/rcj-test', 'w')",
    "a pipe with a name": "os.mkfifo('pipe')",
    "a device": "os.mknod('device', 0o20666, os.makedev(1, 3))",
}
OWN = {
    "write a file": "open('mine', 'w').write('text')",
    "read it": "open('mine').read()",
    "shorten it": "os.truncate('mine', 1)",
    "make folders": "os.makedirs('one/two')",
    "move it": "os.rename('mine', 'one/two/mine')",
    "list": "os.listdir('one/two')",
    "remove": "(os.unlink('one/two/mine'), os.removedirs('one/two'))[0]",
    "link": "os.symlink('x', 'to')",
    "use a temporary file": "__import__('tempfile').TemporaryFile().write(b'12')",
    "throw away": "open('/dev/null', 'w').write('123')",
    "look at its own process": "len(open('/proc/self/status').read()) > 100",
}
NETWORK = {  # by the version of Landlock that refuses it
    "connect by TCP": (4, "socket.create_connection(('127.0.0.1', port))", "EACCES"),
    "offer TCP": (4, "socket.socket().bind(('127.0.0.1', 0))", "EACCES"),
    "reach an abstract socket": (6, "socket.socket(socket.AF_UNIX).connect(abstract)", "EPERM"),
    "send the match a signal": (6, "os.kill(parent, 0)", "EPERM"),
}


@pytest.fixture(scope="module")
def surroundings() -> Iterator[str]:
    """Other people's things, as lines that name them."""
    with (
        tempfile.TemporaryDirectory() as elsewhere,
        tempfile.TemporaryDirectory(prefix="rcj-Y2-") as sibling,
        socket.socket() as tcp,
        socket.socket(socket.AF_UNIX if sys.platform == "linux" else socket.AF_INET) as abstract,
    ):
        secret = Path(elsewhere, "reflog.jsonl")
        secret.write_text("0 : 0", encoding="utf-8")
        permissions = secret.stat().st_mode
        Path(sibling, "robot.py").write_text("attack = True", encoding="utf-8")
        name = f"\0rcj-test-{os.getpid()}"
        if sys.platform == "linux":
            abstract.bind(name)
            abstract.listen()
        tcp.bind(("127.0.0.1", 0))
        tcp.listen()
        yield (
            f"secret, elsewhere, sibling = {str(secret)!r}, {elsewhere!r}, {sibling!r}\n"
            f"parent, port, abstract = os.getppid(), {tcp.getsockname()[1]}, {name!r}\n"
        )
        assert secret.stat().st_mode == permissions
        assert secret.read_text(encoding="utf-8") == "0 : 0"
        assert [entry.name for entry in Path(elsewhere).iterdir()] == [secret.name]
        assert [entry.name for entry in Path(sibling).iterdir()] == ["robot.py"]


@pytest.fixture(scope="module")
def by_filesystem(tmp_path_factory: pytest.TempPathFactory, surroundings: str) -> dict[str, str]:
    network = {name: action for name, (version, action, _) in NETWORK.items() if version <= LANDLOCK}
    with only("filesystem"):
        return outcomes(tmp_path_factory.mktemp("fs"), {**READS, **WRITES, **OWN, **network}, surroundings)


@needs_landlock
@pytest.mark.parametrize("thing", READS)
def test_a_program_cannot_read(by_filesystem: dict[str, str], thing: str) -> None:
    assert by_filesystem[thing] == "EACCES"


@needs_landlock
@pytest.mark.parametrize("thing", WRITES)
def test_a_program_cannot_change(by_filesystem: dict[str, str], thing: str) -> None:
    assert by_filesystem[thing] in ("EACCES", "EPERM", "EXDEV")


@needs_landlock
def test_a_program_does_what_it_likes_in_its_own_folder(by_filesystem: dict[str, str]) -> None:
    assert {name: by_filesystem[name] for name in OWN} == {
        **dict.fromkeys(OWN, "done"),
        "write a file": "4",
        "read it": "text",
        "list": "['mine']",
        "use a temporary file": "2",
        "throw away": "3",
        "look at its own process": "True",
    }


@needs_landlock
@pytest.mark.parametrize("what", NETWORK)
def test_landlock_alone_refuses_to(by_filesystem: dict[str, str], what: str) -> None:
    version, _, error = NETWORK[what]
    if version > LANDLOCK:
        pytest.skip(f"Landlock of version {version} refuses it; here it is {LANDLOCK}")
    assert by_filesystem[what] == error


@needs_linux
def test_without_isolation_the_same_attempts_to_read_succeed(tmp_path: Path, surroundings: str) -> None:
    with only():
        network = {name: action for name, (_, action, _) in NETWORK.items()}
        reported = outcomes(tmp_path, {**READS, **network}, surroundings)
    refused = {name for name, outcome in reported.items() if outcome.startswith("E") and outcome.isupper()}
    # A kernel with Yama lets no process look into its parent's memory.
    assert refused <= {"the match's memory"}


CALLS = {
    "open a socket": "socket.socket()",
    "open a local socket": "socket.socket(socket.AF_UNIX)",
    "ask the kernel by a socket": "socket.socket(16, socket.SOCK_RAW, 0)",
    "open two ends that send anywhere": "socket.socketpair(socket.AF_UNIX, socket.SOCK_DGRAM)",
    "start a program": "subprocess.run(['true'])",
    "start a program at once": "os.posix_spawn('/bin/true', ['true'], {})",
    "become another program": "os.execv('/bin/true', ['true'])",
    "fork": "os.fork()",
    "fork by number": "syscall(56, 220, signal.SIGCHLD, 0, 0, 0, 0)",
    "start a Python process": "__import__('multiprocessing').Process(target=print).start()",
    "make a name space": "syscall(272, 97, 0x10000000)",
    "enter a name space": "syscall(308, 268, 0, 0)",
    "mount": "syscall(165, 40, b'none', b'.', b'tmpfs', 0, None)",
    "change the root": "os.chroot('.')",
    "trace the match": "syscall(101, 117, 16, parent, 0, 0)",
    "read the match's memory": "syscall(310, 270, parent, b'', 0, b'', 0, 0)",
    "write the match's memory": "syscall(311, 271, parent, b'', 0, b'', 0, 0)",
    "take hold of the match": "os.pidfd_open(parent)",
    "compare processes": "syscall(312, 272, parent, parent, 0, 0, 0)",
    "send the match a signal": "os.kill(parent, 0)",
    "send everybody a signal": "os.kill(-1, 0)",
    "send its group a signal": "os.kill(0, 0)",
    "send a thread of the match a signal": "syscall(234, 131, parent, parent, 0)",
    "send any thread a signal": "syscall(200, 130, parent, 0)",
    "let the kernel send a signal": "fcntl.fcntl(0, fcntl.F_SETOWN, parent)",
    "lease a file": "fcntl.fcntl(os.open('mine', os.O_RDWR | os.O_CREAT), 1024, fcntl.F_WRLCK)",
    "outlive the match": "syscall(157, 167, 1, 0, 0, 0, 0)",
    "limit the match": "resource.prlimit(parent, resource.RLIMIT_NOFILE)",
    "slow the match down": "os.setpriority(os.PRIO_PROCESS, parent, 5)",
    "bind the match to a processor": "os.sched_setaffinity(parent, {0})",
    "take the match's turn": "os.sched_setscheduler(parent, os.SCHED_BATCH, os.sched_param(0))",
    "give a file away": "os.chown(secret, os.getuid(), os.getgid())",
    "change a file's time": "os.utime(secret)",
    "mark a file": "os.setxattr(secret, 'user.mark', b'')",
    "empty a file": "os.truncate(secret, 0)",
    "empty a file that it reads": "os.open(secret, os.O_RDONLY | os.O_TRUNC)",
    "empty a file that it neither reads nor writes": "os.open(secret, 3 | os.O_TRUNC)",
    "open a file by its number": "syscall(304, 265, -100, b'', 0)",
    "keep memory in a file without name": "os.memfd_create('x')",
    "keep memory that all share": "syscall(29, 194, 0, 4096, 0o1600)",
    "keep messages that all share": "syscall(68, 186, 0, 0o1600)",
    "keep keys": "syscall(250, 219, 0, -3, 0, 0, 0)",
    "put code into the kernel": "syscall(321, 280, 0, None, 0)",
    "count the processor's events": "syscall(298, 241, None, 0, -1, -1, 0)",
    "queue calls": "syscall(425, 425, 1, None)",
    "handle page faults": "syscall(323, 282, 0)",
    "watch files": "syscall(294, 26, 0)",
    "wait for everybody's files": "syscall(162, 81)",
    "read the match's CPU clock": "syscall(228, 113, ~parent << 3 | 2, bytes(16))",
    "wait for the match's CPU clock": "syscall(230, 115, ~parent << 3 | 2, 0, bytes(16), None)",
    "set a timer by the match's CPU clock": "syscall(222, 107, ~parent << 3 | 2, None, bytes(8))",
    "look for a process by its clock": "time.clock_getres(~parent << 3 | 2)",
    "see the match's session": "os.getsid(parent)",
    "see the match's group": "os.getpgid(parent)",
    "see the match's priority": "os.getpriority(os.PRIO_PROCESS, parent)",
    "see the priority of its user's processes": "os.getpriority(os.PRIO_USER, 0)",
    "see the match's privileges": "syscall(125, 90, struct.pack('=Ii', 0x20080522, parent), bytes(24))",
    "set the clock": "syscall(227, 112, 99, None)",
    "type into a terminal": "fcntl.ioctl(0, 0x5412, b'x')",
    "change attributes of a file": "fcntl.ioctl(os.open('.', os.O_RDONLY), 0x40086602, bytes(8))",
}
PASSED_OVER = {
    "take away permissions": "os.chmod(secret, 0)",
    "take away permissions of what is open": "os.fchmod(os.open('.', os.O_RDONLY), 0)",
}
UNKNOWN = {
    "see the processors of the match": "syscall(204, 123, parent, 128, bytes(128))",
    "see how the match is scheduled": "os.sched_getscheduler(parent)",
    "see the match's scheduling parameters": "os.sched_getparam(parent)",
    "see the match's turn": "os.sched_rr_get_interval(parent)",
    "a call in a form that cannot be judged": "syscall(435, 435, bytes(64), 64)",
    "a call that no kernel has": "syscall(4000, 4000)",
}
HARMLESS = ("open a socket", "take hold of the match", "send the match a signal", "keep memory in a file without name")


@pytest.fixture(scope="module")
def by_system_calls(tmp_path_factory: pytest.TempPathFactory, surroundings: str) -> dict[str, str]:
    with only("system_calls"):
        return outcomes(
            tmp_path_factory.mktemp("calls"),
            {**CALLS, **PASSED_OVER, **UNKNOWN},
            surroundings + "import fcntl, struct, time\n",
        )


@needs_seccomp
@pytest.mark.parametrize("what", CALLS)
def test_a_program_is_refused_to(by_system_calls: dict[str, str], what: str) -> None:
    assert by_system_calls[what] == "EPERM"


@needs_seccomp
@pytest.mark.parametrize("what", PASSED_OVER)
def test_nothing_happens_when_a_program_tries_to(by_system_calls: dict[str, str], what: str) -> None:
    """That the files keep their permissions is looked at when all attempts are over."""
    assert by_system_calls[what] == "done"


@needs_seccomp
@pytest.mark.parametrize("what", UNKNOWN)
def test_the_kernel_does_not_know(by_system_calls: dict[str, str], what: str) -> None:
    assert by_system_calls[what] == "ENOSYS"


@needs_linux
def test_without_isolation_the_same_calls_succeed(tmp_path: Path, surroundings: str) -> None:
    with only():
        reported = outcomes(tmp_path, {name: CALLS[name] for name in HARMLESS}, surroundings)
    assert not [name for name, outcome in reported.items() if outcome.startswith("E")]


HONEST = """
import asyncio, concurrent.futures, ctypes, fcntl, http.server, json, logging, mmap, multiprocessing, os, queue
import select, shutil, signal, socket, sqlite3, ssl, subprocess, tempfile, threading, time, urllib.request, zipfile, zoneinfo
import numpy, scipy.fft, scipy.linalg, scipy.optimize, scipy.spatial
from controller import Robot, Lidar, Supervisor

robot = Robot()
assert numpy.linalg.inv(numpy.eye(3) * 2)[0, 0] == 0.5
assert scipy.optimize.minimize(lambda x: (x[0] - 1) ** 2, [0.0]).success
assert abs(numpy.random.default_rng().random()) < 1

seen = []
threads = [threading.Thread(target=seen.append, args=(n,)) for n in range(20)]
[t.start() for t in threads]
[t.join() for t in threads]
assert sorted(seen) == list(range(20))
with concurrent.futures.ThreadPoolExecutor(4) as pool:
    assert list(pool.map(len, ["a", "bc"])) == [1, 2]
handed = queue.Queue(1)
taker = threading.Thread(target=lambda: [seen.append(handed.get()) for _ in range(100)])
taker.start()
[handed.put(n) for n in range(100)]
taker.join()
assert seen[-100:] == list(range(100))
for clock in (time.pthread_getcpuclockid(threading.get_ident()), ~os.getpid() << 3 | 2, -2):
    assert time.clock_getres(clock) > 0
assert os.getsid(0) > 0 < os.getpgid(os.getpid())
assert os.sched_getscheduler(0) == os.sched_getscheduler(os.getpid())
assert os.getpriority(os.PRIO_PROCESS, 0) == os.getpriority(os.PRIO_PROCESS, os.getpid())
points = numpy.arange(30_000.0).reshape(10_000, 3)
assert (scipy.spatial.cKDTree(points).query(points, workers=4)[1] == numpy.arange(10_000)).all()
assert scipy.fft.fft(points.T, workers=3).shape == (3, 10_000)
entry, thread = ctypes.CFUNCTYPE(ctypes.c_long, ctypes.c_void_p)(lambda _: seen.append("thread") or 0), ctypes.c_ulong()
assert ctypes.CDLL(None).pthread_create(ctypes.byref(thread), None, entry, None) == 0
assert ctypes.CDLL(None).pthread_join(thread, None) == 0
assert seen.pop() == "thread"

async def wake():
    await asyncio.to_thread(len, "x")
    return 7

assert asyncio.run(wake()) == 7
signal.signal(signal.SIGUSR1, lambda *_: seen.append("signal"))
os.kill(os.getpid(), signal.SIGUSR1)
signal.raise_signal(signal.SIGUSR1)
assert seen[-2:] == ["signal", "signal"]
with open("data", "wb+") as file:
    file.write(bytes(4096))
    file.flush()
    file.truncate(2048)
    fcntl.lockf(file, fcntl.LOCK_EX)
    fcntl.flock(file, fcntl.LOCK_EX)
    os.posix_fadvise(file.fileno(), 0, 0, os.POSIX_FADV_SEQUENTIAL)
    assert os.preadv(file.fileno(), [bytearray(4)], 0) == 4
    mmap.mmap(file.fileno(), 2048)[0:4] = b"abcd"
shutil.copy("data", "copy")
assert open("copy", "rb").read() == open("data", "rb").read()
os.chmod("copy", 0o600)
with zipfile.ZipFile("z.zip", "w") as archive:
    archive.write("copy")
zipfile.ZipFile("z.zip").extractall("unpacked")
with tempfile.TemporaryDirectory() as folder:
    open(folder + "/x", "w").close()
with sqlite3.connect("a.db") as database:
    database.execute("create table plays (name)")
assert sqlite3.connect("a.db").execute("select count(*) from plays").fetchone() == (0,)
read, write = os.pipe()
os.write(write, b"x")
assert select.select([read], [], [], 0)[0] == [read]
assert zoneinfo.ZoneInfo("Europe/Berlin")
assert ctypes.CDLL(None).getpid() == os.getpid()
print("all is well", multiprocessing.cpu_count() > 0, os.getloadavg is not None)
while robot.step(32) != -1:
    pass
"""


@needs_linux
def test_an_honest_program_notices_nothing(either_match: FakeMatch) -> None:
    played = either_match.play(HONEST, 3)
    assert played.said == ["all is well True True"]
    assert played.fault is None


@pytest.mark.parametrize("program", ["patterns/keeps_state_at_module_level", "patterns/throws_dice"])
def test_a_program_plays_the_same_with_isolation_and_without(tmp_path: Path, program: str) -> None:
    played = [FakeMatch(tmp_path).play(program, 5, sandbox=sandbox) for sandbox in ("off", "auto")]
    assert played[0].requests == played[1].requests
    assert played[0].said == played[1].said
    assert played[0].fault == played[1].fault


@needs_linux
def test_layers_bind_the_thread_that_watches_the_parent_too(tmp_path: Path) -> None:
    """With ``portable`` a thread watches the parent; it starts after the layers are in place."""
    program = """
import os
from controller import Robot
robot = Robot()
for task in os.listdir("/proc/self/task"):
    status = dict(line.split(":", 1) for line in open(f"/proc/self/task/{task}/status"))
    print(status["NoNewPrivs"].strip(), status["Seccomp"].strip())
robot.step(32)
"""
    said = FakeMatch(tmp_path, portable=True).play(program, 1).said
    assert len(said) >= 2
    assert set(said[:2]) == {"1 2" if _seccomp.is_available() else "1 0"}


@needs_landlock
def test_a_layer_that_fails_keeps_the_program_from_starting(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    reported = isolation.limit_settings
    monkeypatch.setattr(
        isolation, "limit_settings", lambda *args, **kind: {**reported(*args, **kind), "readable": ["\0"]}
    )
    with only("filesystem"):
        played = FakeMatch(tmp_path).play("print('I am free')\n\n", 1)
    assert played.fault is not None
    assert played.fault.kind == "start"
    assert "could not be isolated: filesystem" in played.fault.detail
    assert "I am free" not in played.log


@needs_landlock
def test_two_robots_of_a_team_cannot_meet_in_each_others_folder(tmp_path: Path) -> None:
    program = """
import glob, os, tempfile
from controller import Robot
robot = Robot()
private = tempfile.gettempdir()
open("note", "w").close()
robot.step(32)
print(os.listdir(private), glob.glob(os.path.dirname(private) + "/rcj-*/controllers/note"))
while robot.step(32) != -1:
    pass
"""
    match = FakeMatch(tmp_path)
    with match.pool() as pool:
        team = match.team(program)
        drivers = [pool.add(robot_spec(name), team, "robot.py") for name in ("Y1", "Y2")]
        pool.launch()
        assert all(isinstance(driver.collect(), Request) for driver in drivers)
        for driver in drivers:
            driver.release(Observation(1, values_at(1), []))
            assert isinstance(driver.collect(), Request)
            assert driver.new_output().splitlines()[-1] == "['controllers'] []"
