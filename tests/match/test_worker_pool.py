"""The pool of worker processes: jobs can be added while it runs, and an interruption ends everything."""

import errno
import os
import subprocess
import sys
import tempfile
import threading
import time

import pytest

from rcj_challenges.match.worker_pool import Attempt, WorkerPool, run_all
from rcj_challenges.programs.private_folders import PrivateFolders

LASTS_S = 30


class Script:
    """A job: a Python script, whose exit status is the outcome."""

    def __init__(self, code, *, retries=False):
        self.code = code
        self.retries = retries
        self.processes = []

    def start(self):
        self.processes.append(subprocess.Popen([sys.executable, "-c", self.code]))
        return self.processes[-1]

    def interrupt(self, process):
        process.terminate()

    def read_outcome(self, process):
        return Attempt(process.wait(), is_final=not self.retries)

    def start_failed(self, error):
        return error.errno


def exits(status, **options):
    return Script(f"raise SystemExit({status})", **options)


def sleeps():
    return Script(f"import time; time.sleep({LASTS_S})")


def test_outcomes_come_in_the_order_of_the_jobs():
    seen = []
    jobs = [Script("import time; time.sleep(1); raise SystemExit(1)"), exits(2), exits(3)]
    assert run_all(jobs, 3, seen.append) == [1, 2, 3]
    assert sorted(seen) == [1, 2, 3]
    assert seen[-1] == 1


def test_jobs_can_be_submitted_as_results_come_and_results_are_read_in_the_calling_thread():
    played = []
    with WorkerPool(2) as pool:
        pool.submit(exits(1))
        for job, status in pool.results():
            assert threading.current_thread() is threading.main_thread()
            played.append((job.code[-2], status))
            if status < 3:
                pool.submit(exits(status + 1))
    assert played == [("1", 1), ("2", 2), ("3", 3)]


def test_poll_returns_without_a_result_when_its_time_is_up():
    with WorkerPool(1) as pool:
        pool.submit(sleeps())
        assert pool.poll(0.05) == []
        pool.end_all()


def test_no_more_processes_run_at_a_time_than_allowed():
    class Counting(Script):
        running = most = 0

        def start(self):
            Counting.running += 1
            Counting.most = max(Counting.most, Counting.running)
            return super().start()

        def read_outcome(self, process):
            attempt = super().read_outcome(process)
            Counting.running -= 1
            return attempt

    run_all([Counting("pass") for _ in range(4)], 1, lambda _: None)
    assert Counting.most == 1


def test_a_job_whose_attempt_is_not_final_is_tried_once_more():
    final, dying = exits(1), exits(2, retries=True)
    assert run_all([final, dying], 1, lambda _: None) == [1, 2]
    assert (len(final.processes), len(dying.processes)) == (1, 2)


def test_a_job_whose_process_cannot_be_started_gets_an_outcome_and_harms_no_other():
    job = exits(1)
    job.start = lambda: (_ for _ in ()).throw(OSError(errno.EAGAIN, os.strerror(errno.EAGAIN)))
    assert run_all([job, exits(2)], 1, lambda _: None) == [errno.EAGAIN, 2]


def test_an_interruption_while_jobs_are_still_submitted_ends_what_has_begun():
    first, second = sleeps(), sleeps()

    def jobs():
        yield first
        yield second
        while not first.processes:
            time.sleep(0.01)
        raise KeyboardInterrupt

    began = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        run_all(jobs(), 1, print)
    assert time.monotonic() - began < LASTS_S / 2
    assert first.processes[0].poll() is not None
    assert second.processes == []


def test_what_a_process_that_had_to_be_killed_leaves_in_the_temporary_folder_is_removed(tmp_path, monkeypatch):
    """It takes too long to clean up; its lock is gone with it, that of another process is not."""
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    busy, other = PrivateFolders(), PrivateFolders()
    killed = threading.Event()

    class Busy:
        def wait(self, timeout_s=None):
            if timeout_s is not None:
                raise subprocess.TimeoutExpired("match", timeout_s)

        def kill(self):
            os.close(busy._lock_fd)
            killed.set()

    class Job(Script):
        def start(self):
            self.processes.append(Busy())
            return self.processes[-1]

        def interrupt(self, process):
            pass

        def read_outcome(self, process):
            killed.wait()
            return Attempt(0)

    job = Job("")
    with WorkerPool(1) as pool:
        pool.submit(job)
        while not job.processes:
            time.sleep(0.01)
        pool.end_all()
    assert list(tmp_path.iterdir()) == [other.place]
    other.close()
