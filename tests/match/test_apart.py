"""Work in processes of our own: whoever interrupts it does not wait for it, whenever that is."""

import subprocess
import sys
import time

import pytest

from rcj_challenges.match.apart import Running, do_all

LASTS_S = 30


def test_an_interruption_while_the_work_is_still_handed_out_ends_what_has_begun():
    begun = []
    running = Running(lambda process: process.terminate())

    def work(_job):
        process = running.begin(lambda: subprocess.Popen([sys.executable, "-c", f"import time; time.sleep({LASTS_S})"]))
        if process is not None:
            begun.append(process)
            process.wait()
            running.forget(process)

    class Jobs(list):
        """Jobs of which the second is asked for at the moment of Ctrl-C."""

        def __iter__(self):
            yield self[0]
            while not begun:
                time.sleep(0.01)
            raise KeyboardInterrupt

    began = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        do_all(Jobs(["first", "second"]), work, running, 2, print)
    assert time.monotonic() - began < LASTS_S / 2
    assert [process.poll() is None for process in begun] == [False]
    assert running.stopped
