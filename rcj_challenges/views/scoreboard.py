"""The scoreboard in a terminal, and plain lines where there is none."""

from __future__ import annotations

from collections import deque
from collections.abc import Mapping, Sequence
from typing import Any

from rich.color import ANSI_COLOR_NAMES
from rich.console import Console, Group
from rich.live import Live
from rich.progress_bar import ProgressBar
from rich.table import Table
from rich.text import Text

from rcj_challenges.core.amounts import measure_words, measured_words, number_words
from rcj_challenges.core.play import Fault, HalfInfo, RefereeOutput, Snapshot
from rcj_challenges.core.sanitize import sanitize
from rcj_challenges.core.timing import TICK_S, s_from_ticks
from rcj_challenges.match.observers import Observer, Progress
from rcj_challenges.rules.ranked import Ranked
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.views.commentary import Commentator, Remark
from rcj_challenges.views.naming import score_so_far, team_names
from rcj_challenges.views.sentences import clock, fault_line

_EVENTS_SHOWN = 6
_BAR_COLUMNS = 30


def create_observer(console: Console, scenario: Scenario, *, quiet: bool, shared: bool) -> Observer:
    """Return the scoreboard in a terminal, plain lines elsewhere; if quiet, only what programs print.

    In a terminal that is shared with the programs, the scoreboard would be drawn over their lines.
    """
    if quiet:
        return PrintedLines(console)
    # In a dumb terminal (inside an editor, for instance) rich draws nothing at all, and the match would be silent.
    can_be_drawn_over = console.is_terminal and not console.is_dumb_terminal
    return Scoreboard(console, scenario) if can_be_drawn_over and not shared else PlainLines(console, scenario)


def _seats(half: HalfInfo) -> str:
    return ", ".join(f"{seat}: {sanitize(name, 32)}" for seat, name in half.team_names.items())


def decided_by_score_alone(rank: Sequence[Ranked]) -> bool:
    """Return whether the scores say all that decides."""
    return all(one.is_score for one in rank)


def criterion_words(ranked: Ranked, value: str = "") -> str:
    """Return ``score`` or ``best (s)``; with a value ``time 9.2 s (with touched posts)``."""
    first, *others = ranked.names
    added = f" (with {', '.join(map(measure_words, others))})" if others else ""
    return (measured_words(first, value) if value else measure_words(first)) + added


def criterion_name(ranked: Ranked) -> str:
    """Return the same for programs that read it: names as the scenario writes them, ``time_s (with touched_posts)``."""
    first, *others = ranked.names
    return f"{first} (with {', '.join(others)})" if others else first


def ranking_lines(rank: Sequence[Ranked], names: Mapping[str, str], ranking: Sequence[Mapping[str, Any]]) -> list[str]:
    """Return ``place 1: Hanse, score 4, time 9.248 s`` for each team, best first; nothing if the score decides."""
    return [f"{place}: {team}, {values}" for place, team, values in ranking_rows(rank, names, ranking)]


def ranking_rows(
    rank: Sequence[Ranked], names: Mapping[str, str], ranking: Sequence[Mapping[str, Any]]
) -> list[tuple[str, str, str]]:
    """Return ``place 1``, name and what was compared, ``score 4, time 9.248 s``, as of `ranking_lines`."""

    def words(values: Sequence[float | None]) -> str:
        return ", ".join(criterion_words(one, number_words(value)) for one, value in zip(rank, values, strict=True))

    rows = () if decided_by_score_alone(rank) else ranking
    return [(f"place {row['place']}", names[row["team"]], words(row["values"])) for row in rows]


def pace(progress: Progress) -> str:
    """Return the speed, and the time until the end."""
    return f"{progress.factor:.0f} x real time, done in about {progress.remaining_s:.0f} s"


class PrintedLines(Observer):
    """Shows what programs print whose output is shown, and nothing else.

    On a ``problem``, such as a full disk, nothing more is shown; the match goes on to its end.
    """

    def __init__(self, console: Console) -> None:
        self.problem: OSError | None = None
        self._console = console

    def printed(self, robot: str, text: str) -> None:
        for line in text.splitlines():
            self._print(f"{robot} | {sanitize(line.expandtabs(4), 2000)}")

    def _print(self, line: str) -> None:
        if self.problem is None:
            try:
                self._console.print(line, markup=False, highlight=False, soft_wrap=True)
            except OSError as error:
                self.problem = error


class _Commented(PrintedLines):
    """Also shows what happens, as remarks of a commentator."""

    def __init__(self, console: Console, scenario: Scenario) -> None:
        super().__init__(console)
        self._commentator = Commentator(scenario)
        self._period = scenario.match.period

    def half_started(self, half: HalfInfo) -> None:
        self._commentator.begin(half)

    def after_tick(self, snapshot: Snapshot, output: RefereeOutput) -> None:
        if output.events or output.firings or output.changes:
            for remark in self._commentator.remarks(output):
                self._show(remark)

    def after_last_tick(self, output: RefereeOutput, half: HalfInfo) -> None:
        for remark in self._commentator.remarks(output):
            self._show(remark)

    def _show(self, remark: Remark) -> None:
        self._print(remark.text)


class PlainLines(_Commented):
    """One line for each event and each simulated minute: for logs, pipes and editors."""

    progress_every_ticks = round(60 / TICK_S)

    def __init__(self, console: Console, scenario: Scenario) -> None:
        super().__init__(console, scenario)
        # Not through _print: if this fails, the match need not begin.
        console.print(scenario.title, markup=False, highlight=False, soft_wrap=True)

    def half_started(self, half: HalfInfo) -> None:
        super().half_started(half)
        self._print(f"{self._period} {half.half} of {half.halves}  {_seats(half)}")

    def progressed(self, progress: Progress) -> None:
        if progress.clock_ticks < progress.half.ticks:
            line = score_so_far(progress.half, progress.scores)
            self._print(f"{clock(s_from_ticks(progress.clock_ticks)):>7}  {line}  ({pace(progress)})")

    def fault(self, fault: Fault) -> None:
        self._print(fault_line(fault))


class Scoreboard(_Commented):
    """A live board: teams, score, clock, speed, last events. What changed the score stays above it."""

    progress_every_ticks = 125

    def __init__(self, console: Console, scenario: Scenario) -> None:
        super().__init__(console, scenario)
        self._title = scenario.title
        known = {seat: colour for seat, colour in self._commentator.colours.items() if colour in ANSI_COLOR_NAMES}
        self._styles = {seat: f"bold {colour}" for seat, colour in known.items()}
        self._events: deque[Text] = deque(maxlen=_EVENTS_SHOWN)
        self._live = Live(console=console, auto_refresh=False, transient=True)

    def half_started(self, half: HalfInfo) -> None:
        super().half_started(half)
        self._live.start()
        self._draw(Progress(half, 0, 0, dict(half.scores), "play", 0.0, 0.0))

    def progressed(self, progress: Progress) -> None:
        self._draw(progress)

    def fault(self, fault: Fault) -> None:
        self._events.append(Text(fault_line(fault), style="red", no_wrap=True, overflow="ellipsis"))

    def finished(self, result: dict[str, Any]) -> None:
        self._live.stop()

    def _show(self, remark: Remark) -> None:
        line = _one_line(remark.text, self._styles.get(remark.seat, ""))
        if remark.seat:
            self._console.print(line)
        else:
            self._events.append(line)

    def _draw(self, progress: Progress) -> None:
        half = progress.half
        score = _one_line(score_so_far(half, progress.scores), "bold")
        names = team_names(half)
        for seat, team in half.teams.items():
            score.highlight_words([sanitize(names[team], 32)], self._styles.get(seat, ""))
        time = f"{clock(s_from_ticks(progress.clock_ticks))} / {clock(s_from_ticks(half.ticks))}"
        status = Table.grid(padding=(0, 2))
        status.add_row(
            ProgressBar(total=half.ticks, completed=progress.clock_ticks, width=_BAR_COLUMNS),
            Text(time, no_wrap=True),
            Text(f"{self._period} {half.half} of {half.halves}", style="dim", no_wrap=True),
            _one_line(progress.phase.replace("_", " "), "dim"),
        )
        pace_line = _one_line(pace(progress) if progress.factor else "starting", "dim")
        title = _one_line(f"{self._title}   {_seats(half)}", "dim")
        self._live.update(Group(title, score, status, pace_line, *self._events), refresh=True)


def _one_line(text: str, style: str = "") -> Text:
    return Text(text, style=style, no_wrap=True, overflow="ellipsis")
