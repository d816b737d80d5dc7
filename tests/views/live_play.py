"""A live match without physics, for tests of what spectators see."""

import struct
import threading
from collections.abc import Mapping
from contextlib import ExitStack, closing
from pathlib import Path

from rcj_challenges.core.play import Event, RefereeOutput
from rcj_challenges.core.timing import TICK_S
from rcj_challenges.match.observers import ObserverGroup
from rcj_challenges.records.sensors import SensorWriter
from rcj_challenges.records.writer import RecordWriter
from rcj_challenges.views.live import MAX_SPEED, LiveShow
from rcj_challenges.views.replay import write_replay
from tests.made_up_runs import half_info, made_up_play, small_header, small_scenario
from tests.views.sensing_play import SENSED, sense

TICKS = 1000
HOSTILE = "</script><script>document.title='stolen'</script>\u202eمريخ"


class MadeUpMatch:
    """A match without physics that is played, recorded and shown as any other, in a thread of its own."""

    def __init__(
        self,
        out: Path,
        *,
        ticks: int = TICKS,
        speed: float = MAX_SPEED,
        halves: int = 2,
        names: tuple[str, str] = ("Hanse", HOSTILE),
        logos: Mapping[str, bytes] | None = None,
        sensors: bool = False,
    ) -> None:
        self._scenario = small_scenario(halves=halves, half_s=ticks * TICK_S)
        self._header = small_header(self._scenario, names)
        self._out = out
        self._ticks = ticks
        self._halves = halves
        self._sensors = sensors
        self.show = LiveShow(self._scenario, dict(self._header.team_names), 1, logos=logos, speed=speed)
        self.folder: Path | None = None
        self._stopped = threading.Event()
        self._thread = threading.Thread(target=self._play, daemon=True)

    def start(self) -> "MadeUpMatch":
        self._thread.start()
        return self

    def end(self) -> None:
        """Let it run to its end at once, and wait for that."""
        self.show.pace.release()
        self._thread.join(30)
        assert not self._thread.is_alive()

    def close(self) -> None:
        """Stop it where it is: no viewer is left."""
        self._stopped.set()
        self.show.close()
        self._thread.join(30)
        assert not self._thread.is_alive()

    def _play(self) -> None:
        writer = RecordWriter(self._out, self._header)
        for number in range(1, self._halves + 1):
            if not self._play_half(writer, number):
                writer.finish({"complete": False})
                return
        self.folder = writer.finish({"wall_s": 1.0})
        write_replay(self.folder)
        self.show.match_over(self.folder)

    def _play_half(self, writer: RecordWriter, number: int) -> bool:
        """Play a half; returns whether it came to its end."""
        observer, ticks = ObserverGroup(self.show.observer), self._ticks
        half = half_info(self._scenario, number, ticks, self._header, writer.result["score"])
        writer.begin_half(half)
        observer.half_started(half)
        with ExitStack() as recording:
            senses = None
            if self._sensors:
                senses = recording.enter_context(closing(SensorWriter(writer.folder, number, SENSED)))
                senses.set_listeners(observer.sensing(half, SENSED))
            for snapshot, output in made_up_play(len(self._scenario.robots), ticks, half.scores):
                if self._stopped.is_set():
                    return False
                if snapshot.tick:
                    observer.before_tick(snapshot.tick)
                writer.tick(snapshot, output, struct.pack("<d", snapshot.substeps[-1][0][0]))
                observer.after_tick(snapshot, output)
                if senses is not None:
                    sense(senses, snapshot.tick)
        last = RefereeOutput(events=(Event(ticks, "MATCH_FINISH", {"total_match_time": ticks * TICK_S}),))
        writer.end_half(last)
        observer.after_last_tick(last, half)
        return True
