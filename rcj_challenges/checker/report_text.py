"""The report on a terminal."""

from __future__ import annotations

from rich.console import Console, RenderableType
from rich.table import Table
from rich.text import Text

from rcj_challenges.checker.report import (
    LEVEL_NAMES,
    ROBOT_NUMBERS,
    CheckReport,
    FileReport,
    MatchReport,
    StageReport,
    format_finding,
    is_single,
    no_replay,
    summary,
    verdict,
)
from rcj_challenges.core.code import Level
from rcj_challenges.core.sanitize import sanitize

_STYLES: dict[Level, str] = {"passed": "green", "warning": "yellow", "error": "bold red", "unchecked": "bold"}
_SKIPPED = "skipped"
_WIDTH = max(map(len, ("warning", "error", _SKIPPED)))  # the longest word is rare
_MAX_LEFT_OUT = 30
_INDENT = _WIDTH + 2
_LEAST_WIDTH = 30
_WIDE = 160


def print_report(console: Console, report: CheckReport) -> None:
    """Print one submission in full; of several a table, and in full only those with findings."""
    if not console.is_terminal:
        console.width = max(console.width, _WIDE)  # a file or a pipe has no width
    single = is_single(report)
    for file in report.files:
        if single or file.level != "passed":
            print_file(console, file)
    if report.files and not single:
        print_table(console, report)
    _print_left_out(console, report)
    if not single:
        _print(console, Text(summary(report), style="bold"))


def print_file(console: Console, file: FileReport) -> None:
    """Print the stages of one submission, what was found in each, how its robots did, and the verdict."""
    head = Text(file.file, style="bold")
    if file.team:
        head.append(f"  {file.team}", style="not bold")
    _print(console, head)
    for line in file.repaired:
        _indented(console, Text(f"repaired: {line}"))
    for stage in file.stages:
        _print_stage(console, stage)
    for match in file.matches:
        against = "".join(f" against {name}" for name in match.opponents.values())
        _indented(console, Text(f"as {', '.join(match.seats)}{against}:", style="dim"))
        _print_robots(console, match)
        if match.replay:
            _indented(console, Text(f"watch: {sanitize(match.replay, 400)}"))
        if match.no_replay:
            _indented(console, Text(no_replay(match)))
    for robot, output in file.started.items():
        _print_output(console, robot, "at its start", output)
    for match in file.matches:
        for one in match.robots:
            _print_output(console, one.robot, f"as {', '.join(match.seats)}", one.output)
    _print(console, Text(verdict(file), style=_STYLES[file.level]))
    _print(console, Text(""))


def print_table(console: Console, report: CheckReport) -> None:
    """Print one line for each submission."""
    table = Table(
        "file", "team", "verdict", "first thing to do", title=Text(sanitize(report.title)), title_justify="left"
    )
    for column in table.columns:
        column.overflow = "fold"
    for file in report.files:
        table.add_row(
            Text(file.file),
            Text(file.team),
            Text(LEVEL_NAMES[file.level], style=_STYLES[file.level]),
            Text(file.blocked_by or file.cause),
        )
    _print(console, table)


def _print_left_out(console: Console, report: CheckReport) -> None:
    """Print what was not looked at, and why."""
    if not report.left_out:
        return
    _print(console, Text("not looked at:"))
    for other in report.left_out[:_MAX_LEFT_OUT]:
        _indented(console, Text(f"{other.file}: {other.reason}"))
    if len(report.left_out) > _MAX_LEFT_OUT:
        _indented(console, Text(f"and {len(report.left_out) - _MAX_LEFT_OUT} more (all of them: --json or --html)"))


def _print_stage(console: Console, stage: StageReport) -> None:
    if stage.skipped:
        _indented(console, Text(f"{stage.name}: {stage.skipped}", style="dim"), Text(_SKIPPED, style="dim"))
        return
    word = Text(LEVEL_NAMES[stage.level], style=_STYLES[stage.level])
    _indented(console, Text(f"{stage.name}: {stage.about}"), word)
    for finding in stage.findings:
        _indented(
            console, Text(format_finding(finding), style="dim" if finding.level == "passed" else _STYLES[finding.level])
        )
        if finding.help:
            _indented(console, Text(f"→ {finding.help}"))
        for line in finding.details.splitlines():
            _indented(console, Text(f"  {line}", style="dim"))


def _indented(console: Console, text: Text, word: Text | None = None) -> None:
    """Print text beside a word, or below the text beside the last one; on a terminal it keeps to its column."""
    head = word or Text()
    width = max(_LEAST_WIDTH, console.width - _INDENT)
    lines = text.wrap(console, width) if console.is_terminal else [text]
    for number, line in enumerate(lines):
        line.rstrip()
        lead = head.copy() if number == 0 else Text()
        lead.pad_right(max(2 * bool(head) * (number == 0), _INDENT - lead.cell_len))
        console.print(lead + line, markup=False, highlight=False, soft_wrap=True)


def _print_robots(console: Console, match: MatchReport) -> None:
    for robot in match.robots:
        numbers = ", ".join(f"{name} {number_of(robot)}" for name, number_of in ROBOT_NUMBERS.items())
        line = Text(f"{robot.robot}: {numbers}")
        if robot.fault:
            line.append(f", {robot.fault}", style=_STYLES["error"])
        _indented(console, line)


def _print_output(console: Console, robot: str, when: str, output: str) -> None:
    if output:
        _print(console, Text(f"{robot} {when} printed:", style="dim"))
        for line in output.split("\n"):
            console.print(Text(f"{robot} | {line}"), soft_wrap=True)


def _print(console: Console, content: RenderableType) -> None:
    console.print(content, markup=False, highlight=False)


def progress_line(done: int, total: int, file: FileReport) -> str:
    """Return a line for a submission that is done, while others are not."""
    return f"{done}/{total}  {LEVEL_NAMES[file.level]:<{_WIDTH}}  {file.file}"
