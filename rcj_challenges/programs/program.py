"""One program: from its launch to its end, and whatever goes wrong in between."""

from __future__ import annotations

import contextlib
import errno
import math
import os
import re
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from rcj_challenges.core.errors import HostError, RcjError, format_error, is_of_the_host
from rcj_challenges.core.play import Fault
from rcj_challenges.core.streams import stream_seed
from rcj_challenges.core.temporary_folder import disk_full_error
from rcj_challenges.core.timing import s_from_ticks
from rcj_challenges.core.traffic import Note, Observation, Request, RobotSpec
from rcj_challenges.programs import debugging, isolation, processes, scratch
from rcj_challenges.programs.codes import CANNOT_START_PROGRAM
from rcj_challenges.programs.log import ProgramLog
from rcj_challenges.programs.pipes import ChannelClosedError, FrameTooLongError, open_channel
from rcj_challenges.programs.plan import PoolPlan
from rcj_challenges.programs.protocol import Codec, Ended, ProtocolError, hello_frame, max_frame_bytes, one_line
from rcj_challenges.programs.time_budget import MEASURED_AFTER_S, TimeBudget, TimeLimits
from rcj_challenges.programs.timed_channel import TimedChannel, WaitBudget, wait_together
from rcj_challenges.submissions.team import Team

CLEAN_UP_S = 1.0
"""How long a program may go on after its ``step`` returned -1 (reference, section 3)."""

BACKGROUND_S = 20.0
"""A program that has used more CPU time than this outside its intervals is suspended there from then on (POSIX):
otherwise the threads of one team could keep all processors from the match until ``processor_s`` ends them."""

_SLICE_S = 0.25  # how often a program is checked while the match waits for it
_CHECKS_PER_STEP_LIMIT = 8
_LOG_CHECK_EVERY = 16  # requests
_FOLDER_CHECK_EVERY = 256  # ticks; walking through a folder takes 100 µs and more
_MEMORY_CHECK_EVERY = 1024  # ticks; so does reading what a process has in its memory
_TOLERATED_BETWEEN = 2.0
"""A program's use is checked when it calls ``step``, at ticks that are the same in every run: there its limits count.
It is also checked by wall time, or it could fill a disk in between: there this many times the limits count."""
_OUTPUT_SLACK_BYTES = 65_536  # what the interpreter and the match itself add to a log
_FAREWELL_S = 1.0
_LAST_WORDS_S = 1.0  # a thread reads them where pipes cannot be polled
_NO_ROOM = re.compile(rf"\[Errno ({errno.ENOSPC}|{getattr(errno, 'EDQUOT', errno.ENOSPC)})\]|\[WinError 112\]")
"""Texts that an error of a full disk or a quota contains in every language."""

_TEAM = "controllers"
"""The folder of the team's files, by its name in Webots, where ``getProjectPath() + "/controllers/…"`` is a file."""


@dataclass(frozen=True)
class Sharing:
    """How the programs of a half share the temporary folder, and the time of the match.

    Attributes:
        place: in the temporary folder, where each has its private folder.
        share_bytes: when it is full, programs that have written more than this have filled it.
        wait_budget: of the match for all of them together.
    """

    place: Path
    share_bytes: float
    programs: tuple[Program, ...]
    wait_budget: WaitBudget


class Program:
    """A team's program in its own process. After its first `Fault` it is gone until the next half.

    Attributes:
        name: of the robot.
        requests: the number of its calls of ``step``.
    """

    def __init__(self, spec: RobotSpec, team: Team, entry: str, plan: PoolPlan) -> None:
        """Prepare the program that is the file ``entry`` of the team (`Team.entries`)."""
        self.name = spec.name
        self._spec, self._team, self._entry, self._plan = spec, team, entry, plan
        self._limits = plan.limits
        self._is_debugged = spec.name in plan.debug
        message_bytes = isolation.message_bytes(self._limits)
        self._codec = Codec(spec, message_bytes)
        self._frame_limit = max_frame_bytes(message_bytes)
        limits = TimeLimits(self._limits.start_s, self._limits.step_s, self._limits.half_s)
        self.budget = TimeBudget(
            TimeLimits(math.inf, math.inf, math.inf) if self._is_debugged else limits,
            lambda: None if self._process is None else self._process.times(),
            lambda thread: self._process is not None and self._process.is_runnable(thread),
        )
        self._output_limit = isolation.output_bytes(self._limits) + _OUTPUT_SLACK_BYTES
        self._scratch_limit = isolation.megabytes(self._limits.scratch_mb) + sum(map(len, team.files.values()))
        self._portable = processes.NEEDS_LIFELINE if plan.portable is None else plan.portable
        self._sharing = Sharing(Path(), math.inf, (), WaitBudget(math.inf))
        self._folder: Path | None = None
        self._log: ProgramLog | None = None
        self._check_at_s, self._check_at_tick = _SLICE_S, 0
        self._process: processes.Process | None = None
        self._channel: TimedChannel | None = None
        self._lifeline_fd: int | None = None
        self._tick = 0
        self.requests = 0
        self._is_over = self._is_suspended = False
        self.fault: Fault | None = None

    @property
    def notes(self) -> tuple[Note, ...]:
        """What the module ``controller`` refused or ignored of its calls."""
        return tuple(self._codec.notes)

    def launch(self, sharing: Sharing) -> None:
        """Start the process; it runs to its first ``step``, which `collect` waits for.

        Raises:
            RcjError: layers of strict isolation are missing here.
            OSError: the log cannot be written.
            HostError: this computer cannot start one more program.
        """
        plan = self._plan
        layers = isolation.active_layers("off" if self._is_debugged else plan.sandbox)
        self._sharing, place = sharing, sharing.place
        self._log = ProgramLog(plan.logs / f"{self.name}.log", self._output_limit, place)
        self._append_log(f"--- half {plan.half}: {self._entry} ---\n")
        try:
            self._start(layers, self._log.fd, place)
        except (OSError, ValueError, RcjError) as error:
            if isinstance(error, HostError):
                raise
            if is_of_the_host(error):
                message = f"the program of {self.name} cannot be started here: {format_error(error)}"
                raise HostError(message, code=CANNOT_START_PROGRAM) from error
            self._fail("start", f"the program could not be started: {one_line(format_error(error))}")

    def release(self, observation: Observation) -> None:
        """Let the program's ``step`` return with this. Does not wait."""
        self._tick = observation.tick
        if self._channel is not None:
            self._channel.release(self._codec.encode(observation))
            if self._is_suspended and self._process is not None:
                self._process.resume()

    def collect(self) -> Request | Fault:
        """Wait until the program calls ``step``, or until it reaches a limit of time or fails.

        Until the first time it may be charged ``start_s``, then ``step_s`` for each step and ``half_s`` for all of them
        (`TimeBudget`).

        Raises:
            HostError: it failed because the temporary folder is full, and no program has filled it; or this computer is
                too busy for the match.
        """
        channel = self._channel
        if channel is None:
            return self.fault or self._fail("start", "the program was not started")
        try:
            body = channel.receive_before_measuring() if self.requests else None
            if body is None:
                body = self._wait(channel)
            return self._too_slow() if body is None else self._accepted(self._codec.decode(body, self._tick))
        except (ChannelClosedError, FrameTooLongError, ProtocolError) as error:
            return self._broken(error)

    def collect_soon(self) -> Request | Fault | None:
        """Return the result of `collect` if it is here, or comes at once; None: `collect` has to wait for it."""
        channel = self._channel
        if channel is None or not self.requests:
            return None
        try:
            body = channel.receive_soon()
            return None if body is None else self._accepted(self._codec.decode(body, self._tick))
        except (ChannelClosedError, FrameTooLongError, ProtocolError) as error:
            return self._broken(error)

    def awaited_channel(self) -> TimedChannel | None:
        """Return its channel if it was released and has not answered."""
        return self._channel if self._channel is not None and self._channel.is_awaited else None

    def _accepted(self, answer: Request | Ended) -> Request | Fault:
        if self.budget.exceeded is not None:
            return self._too_slow()
        if not self.requests and self._process is not None:
            self._process.remember_program()
        self.requests += 1
        if isinstance(answer, Ended):
            return self._ended(answer.kind, answer.detail, answer.traceback)
        violation = None
        if self._tick >= self._check_at_tick:
            closely = self._check_at_tick % _MEMORY_CHECK_EVERY == 0
            self._check_at_tick = (self._tick // _FOLDER_CHECK_EVERY + 1) * _FOLDER_CHECK_EVERY
            violation = self._violation(closely=closely)
        elif self.requests % _LOG_CHECK_EVERY == 0:
            violation = self._prints_too_much()
            self.budget.settle()
        # Since its folder was looked through it may have had time to write much.
        if violation is None and self.budget.waited_s >= self._check_at_s:
            violation = self._violation(_TOLERATED_BETWEEN)
        if violation is not None:
            return self._fail(*violation)
        if self.budget.background_s > BACKGROUND_S:
            self._suspend()
        return answer

    def _suspend(self) -> None:
        if self._process is not None and not self._is_debugged:
            self._is_suspended = True
            self._process.suspend()

    def limit_fault(self, tick: int) -> Fault | None:
        """Check its limits while the match, at ``tick``, does not wait for it; end it if it exceeds one."""
        if self.fault is not None:  # found out when another one had no room
            return self.fault
        self.budget.settle()
        if self.budget.background_s > BACKGROUND_S:
            self._suspend()
        violation = self._violation()
        if violation is None:
            return None
        self._tick = tick
        return self._fail(*violation)

    def _broken(self, error: Exception) -> Fault:
        if isinstance(error, ChannelClosedError):
            return self._closed_fault()
        if isinstance(error, FrameTooLongError):
            return self._fail("protocol", f"the program sent a message of {error.args[0]} bytes")
        return self._fail("protocol", f"the program sent an invalid message: {error}")

    def finish(self, observation: Observation) -> None:
        """Let its ``step`` return -1, because the match is over; then it may clean up until `close`."""
        if self._channel is not None and not self._is_over:
            self._is_over = True
            self.budget.close()
            self.release(observation)

    def has_ended(self) -> bool:
        """Return whether its process is gone."""
        return self._process is None or self._process.has_ended()

    def wait_until(self, moment: float) -> None:
        """Wait until it has ended, at most until ``moment`` (of ``time.perf_counter``)."""
        if self._process is not None:
            self._process.exit_status(max(0.0, moment - time.perf_counter()))

    def kill(self) -> None:
        """End it, with all that it started. Can be called at any time, and again."""
        self.budget.close()
        process, self._process = self._process, None
        if process is not None:
            process.kill()
        channel, self._channel = self._channel, None
        if channel is not None:
            if self._is_over:
                self._take_last_notes(channel)
            channel.close()
        if self._lifeline_fd is not None:
            os.close(self._lifeline_fd)
            self._lifeline_fd = None

    def _take_last_notes(self, channel: TimedChannel) -> None:
        """Take the notes that follow the end of the half, when no request is sent any more."""
        with contextlib.suppress(ChannelClosedError, FrameTooLongError, ProtocolError):
            self._codec.decode(channel.channel.receive(0.0) or b"", self._tick)

    def close(self) -> None:
        """End it and remove its private folder. `new_output` still returns its last output."""
        self.kill()
        self._remove_folder()
        if self._log is not None:
            self._log.close()

    def _remove_folder(self) -> None:
        folder, self._folder = self._folder, None
        if folder is not None:
            scratch.remove(folder)

    def keep_output(self) -> int:
        """Put into its log what it has printed until now; return the size of all that the log has got."""
        if self._log is None:
            return 0
        self._log.take_over()
        return self._log.written_bytes

    def new_output(self) -> str:
        """Return the output since the last call."""
        return self._log.new_text() if self._log is not None else ""

    def _start(self, layers: tuple[str, ...], log_fd: int, place: Path) -> None:
        folder = self._folder = Path(tempfile.mkdtemp(prefix=f"rcj-{self.name}-", dir=place))
        root = folder / _TEAM
        root.mkdir()
        self._team.unpack(root)
        limited = "resource_limits" in layers
        self._process, read_fd, write_fd, self._lifeline_fd = processes.start(
            root,
            isolation.environment(folder),
            None if self._is_debugged else log_fd,
            isolation.memory_bytes(self._limits) if limited else None,
            lifeline=self._portable,
            prefix=isolation.prefix(layers, folder),
        )
        channel = open_channel(read_fd, write_fd, self._frame_limit, portable=self._plan.portable)
        channel.send(hello_frame(self._spec, self._setup(root, layers)))
        self._channel = TimedChannel(channel, self.budget)

    def _setup(self, root: Path, layers: tuple[str, ...]) -> dict[str, Any]:
        """Return the settings of the process beyond the robot."""
        plan = self._plan
        folder, entry = debugging.program_place(self._team, self._entry, root, is_debugged=self._is_debugged)
        return {
            "half": plan.half,
            "seed": stream_seed(plan.match_seed, f"program/{self.name}/half{plan.half}"),
            "program": {"root": str(folder), "entry": str(entry), "site": processes.site_folders()},
            "limits": isolation.limit_settings(self._limits, layers, root.parent, portable=self._portable),
            "layers": isolation.set_by_process(layers, portable=self._portable),
            "debug": self._is_debugged,
            "debugger": debugging.debugger_settings() if self._is_debugged else None,
        }

    def _wait(self, channel: TimedChannel) -> bytes | None:
        """Return the program's next message, None if it reached a limit. All other programs are charged meanwhile."""
        longest_s = min(_SLICE_S, self._limits.step_s / _CHECKS_PER_STEP_LIMIT)
        slice_s = min(MEASURED_AFTER_S, longest_s)
        channel.look(math.inf)  # since the last look the match did something else: no program is charged for that
        while (body := channel.receive(0.0)) is None:
            if self.budget.exceeded is not None:
                return None
            if self.budget.waited_s >= self._check_at_s and self._violation(_TOLERATED_BETWEEN) is not None:
                return None
            # Processes that it started may hold its pipes open after its end. Its last message may still be on its way.
            if self.has_ended():
                body = channel.receive(_LAST_WORDS_S)
                if body is None:
                    raise ChannelClosedError
                return body
            awaited = [other for program in self._sharing.programs if (other := program.awaited_channel()) is not None]
            wait_together(awaited, slice_s, self._sharing.wait_budget)
            slice_s = min(2 * slice_s, longest_s)
        return body

    def _too_slow(self) -> Fault:
        limits = self._limits
        if (violation := self._violation()) is not None:
            return self._fail(*violation)
        kind = self.budget.exceeded or "step_timeout"
        detail = {
            "start_timeout": f"the program used more than {limits.start_s:g} s until its first step",
            "step_timeout": f"the program used more than {limits.step_s:g} s for one step",
            "half_timeout": f"the program used more than {limits.half_s:g} s for all its steps",
        }[kind]
        if self._process is not None:
            self._process.dump_traceback(self._lifeline_fd)
        return self._fail(kind, detail, timed=True)

    def _closed_fault(self) -> Fault:
        status = None if self._process is None else self._process.exit_status(_FAREWELL_S)
        if status is None:
            return self._fail("protocol", "the program closed its connection to the match")
        if processes.is_crash(status):
            timed = processes.is_cpu_limit(status, self.budget.cpu_s, isolation.processor_s(self._limits))
            return self._ended("crash", f"the program was ended by {processes.describe_status(status)}", timed=timed)
        return self._ended("exit", f"the program ended itself (exit status {status})")

    def _ended(self, kind: str, detail: str, traceback: str = "", *, timed: bool = False) -> Fault:
        """Return the fault of a program that has ended: at the system's limit for files a flood ends in a crash.

        Its threads do not count: how many of them have ended by now is another thing in each run.
        """
        if (violation := self._prints_too_much() or self._writes_too_much()) is not None:
            return self._fail(*violation)
        if _NO_ROOM.search(detail + traceback):
            ended = self._end_all_over_share()
            if self.fault is not None:
                return self.fault
            detail += f"; the temporary folder was full of what {', '.join(ended)} had written" if ended else ""
        return self._fail(kind, detail, traceback, timed=timed)

    def _end_all_over_share(self) -> list[str]:
        """End the programs that have filled the temporary folder, if it is full; return their names.

        A program's message may be false: then there is room. This one is ended first, so that files which it only held
        open take none.

        Raises:
            HostError: it is full, and no program has written more than its share.
        """
        self.kill()
        try:
            scratch.ensure_room(self._sharing.place)
        except OSError as error:
            ended = [program.name for program in self._sharing.programs if program.end_if_over_share(self._tick)]
            if not ended:
                raise disk_full_error() from error
            return ended
        return []

    def end_if_over_share(self, tick: int) -> bool:
        """End it if it has written more than its share of the full temporary folder; return whether it has."""
        share_bytes = self._sharing.share_bytes
        if self.fault is not None or self._folder is None or not self._has_written_more_than(self._folder, share_bytes):
            return False
        self._tick = tick
        share = f"its share, {share_bytes / 1e6:.1f} MB"
        self._fail("output_flood", f"the program wrote more than {share}, until the temporary folder was full")
        return True

    def _violation(self, times: float = 1.0, *, closely: bool = True) -> tuple[str, str] | None:
        """Return kind and detail of the fault if it exceeds so many times one of its limits, else None."""
        return self._prints_too_much(times) or self._holds_too_much(times, closely=closely)

    def _prints_too_much(self, times: float = 1.0) -> tuple[str, str] | None:
        """Put into its log what it has printed, and return whether that is too much."""
        self.keep_output()
        if self._is_debugged or self._log is None or self._log.output_bytes() <= times * self._output_limit:
            return None
        return "output_flood", f"the program printed more than {self._limits.output_mb:g} MB"

    def _holds_too_much(self, times: float, *, closely: bool) -> tuple[str, str] | None:
        """Return whether its folder holds too much, it runs too many threads or has lost its main thread. Slow."""
        if self._is_debugged or self._process is None:
            return None
        self._check_at_s = self.budget.waited_s + _SLICE_S
        if self._process.has_lost_main_thread():
            return "exit", "the program's main thread ended while other threads kept running"
        if (written := self._writes_too_much(times, closely=closely)) is not None:
            return written
        # Besides those that it may start it has its main thread and the watching one.
        if self._process.threads() > times * self._limits.processes + 2:
            return "memory", f"the program runs more than {self._limits.processes} threads"
        return None

    def _writes_too_much(self, times: float = 1.0, *, closely: bool = True) -> tuple[str, str] | None:
        if self._is_debugged or self._folder is None:
            return None
        if not self._has_written_more_than(self._folder, times * self._scratch_limit, closely=closely):
            return None
        return "output_flood", f"the program wrote more than {self._limits.scratch_mb:g} MB into its folder"

    def _has_written_more_than(self, folder: Path, limit_bytes: float, *, closely: bool = True) -> bool:
        if self._process is not None:
            log_fd = -1 if self._log is None else self._log.fd
            limit_bytes -= self._process.nameless_bytes(log_fd, folder, in_memory=closely)
        return scratch.has_more_than(folder, limit_bytes)

    def _fail(self, kind: str, detail: str, traceback: str = "", *, timed: bool = False) -> Fault:
        self.kill()
        self.fault = Fault(self.name, kind, self._tick, self._plan.half, detail, traceback, timed)
        at = f"tick {self._tick} ({s_from_ticks(self._tick):.3f} s)"
        where = self._log.take_dump(self._folder / _TEAM) if self._log is not None and self._folder is not None else ""
        shown = f"It was here, the innermost call first:\n{where}" if where else traceback
        self._append_log(f"{shown}[{kind}] {self.name} at {at}: {detail}\n")
        self._remove_folder()  # others may need the room
        return self.fault

    def _append_log(self, text: str) -> None:
        if self._log is not None:
            self._log.append(text)
