"""Plays a scenario for ``rcj-challenge run``: from options to the last lines on the terminal."""

from __future__ import annotations

import os
from dataclasses import dataclass
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Any

from rcj_challenges.cli.stdio import print_json, shell_quoted
from rcj_challenges.cli.team_args import UsageError, assignments, known, open_teams
from rcj_challenges.core.timing import TICK_S

if TYPE_CHECKING:
    from collections.abc import Sequence

    from rich.console import Console

    from rcj_challenges.cli.live import LiveOptions
    from rcj_challenges.match.observers import Observer
    from rcj_challenges.match.runner import MatchInterruptedError, MatchPlan, PlayedMatch
    from rcj_challenges.scenario.load import Loaded
    from rcj_challenges.scenario.models.scenario import Scenario

_CONTRADICT, _ONE = "options-contradict", "give one of them"


@dataclass(frozen=True)
class RunOptions:
    """The options of ``run``, as given."""

    scenario: str
    teams: list[str]
    team_names: list[str]
    seed: int
    match_id: int
    overrides: list[str]
    out: Path
    json: bool
    quiet: bool
    real_time: bool
    show_output: frozenset[str]
    debug: frozenset[str]
    sandbox: str
    replay: bool
    record_sensors: bool = False
    open: bool = False
    live: LiveOptions | None = None


def run_scenario(options: RunOptions) -> int:
    """Play it; returns the exit code.

    Raises:
        RcjError: wrong input: the message says where and what is allowed.
    """
    _refuse_contradictions(options)
    # MuJoCo would load a window system's library, 50 ms, and a match draws nothing.
    os.environ.setdefault("MUJOCO_GL", "disable")
    try:
        plan, console, observer = _prepared(options)
    except KeyboardInterrupt as error:
        raise KeyboardInterrupt("the match had not begun, and nothing is recorded") from error
    from rcj_challenges.cli import INTERRUPTED
    from rcj_challenges.cli.live import on_air, stay_on_air
    from rcj_challenges.core.errors import interruption_behind
    from rcj_challenges.match.motionless import MotionlessObserver
    from rcj_challenges.match.observers import ObserverGroup
    from rcj_challenges.match.runner import MatchInterruptedError, play_match

    scenario = plan.loaded.scenario
    titles = {team: plan.name_of(team) for team in plan.teams}
    try:
        with on_air(options.live, scenario, titles, plan.logos, plan.seed, console) as show:
            standing = MotionlessObserver(scenario)
            outcome = play_match(plan, ObserverGroup(observer, standing, *(() if show is None else (show.observer,))))
            try:
                played = _Played(plan, outcome, standing.robots())
                _report(options, console, played, getattr(observer, "trouble", None))
            except BaseException as error:
                if interruption_behind(error) is None:
                    raise
                raise MatchInterruptedError(outcome, "") from error
            if options.open and options.live is None and _has_ticks(outcome):
                _open_page(outcome.folder, console)
            if show is not None and options.live is not None:
                show.match_over(outcome.folder)
                stay_on_air(show, options.live, console)
    except MatchInterruptedError as error:
        _report_interruption(options, console, scenario, error)
        return INTERRUPTED
    finally:
        for team in plan.teams.values():
            team.close()
    return 0


def _refuse_contradictions(options: RunOptions) -> None:
    """Refuse options that contradict each other.

    Raises:
        UsageError: says which, and why they do not go together.
    """
    if options.open and options.live is None and not options.replay:
        raise UsageError("--open opens the page of the match, and --no-replay leaves it out", _ONE, code=_CONTRADICT)
    if options.debug and options.json:
        raise UsageError(
            "--debug gives a program the terminal, and --json prints the result there and nothing else",
            f"{_ONE}; result.json in the record has the same",
            code=_CONTRADICT,
        )
    if len(options.debug) > 1:
        robots = ", ".join(sorted(options.debug))
        raise UsageError("--debug is given more than once", f"give it for one of {robots}", code="option-given-twice")


def _prepared(options: RunOptions) -> tuple[MatchPlan, Console, Observer]:
    """Return the match to be played with its teams opened, the console, and the observer."""
    from rcj_challenges.cli.output_paths import refuse_devices
    from rcj_challenges.scenario.load import load

    refuse_devices(out=options.out)
    loaded = load(options.scenario, options.overrides)
    robots = frozenset(robot for entrant in loaded.scenario.entrants.values() for robot in entrant.robots)
    for robot in (*options.show_output, *options.debug):
        known(robot, robots, "robot")

    # The physics is imported here, before the match begins: opening teams is quick, compiling is not.
    from rcj_challenges.match.runner import MatchPlan
    from rcj_challenges.views.console import console_for
    from rcj_challenges.views.scoreboard import create_observer

    console = console_for(to_stderr=options.json)
    plan = MatchPlan(
        loaded=loaded,
        teams=open_teams(loaded, options.teams),
        team_names=_team_names(loaded, options),
        seed=options.seed,
        match_id=options.match_id,
        out=options.out,
        sandbox=options.sandbox,
        real_time=options.real_time,
        show_output=frozenset() if options.json else options.show_output,
        debug=options.debug,
        record_sensors=options.record_sensors,
    )
    quiet = options.quiet or options.json
    observer = create_observer(console, loaded.scenario, quiet=quiet, shared=bool(options.debug))
    if options.debug and find_spec("debugpy") is None:
        _print_debug_help(console)
    return plan, console, observer


def _print_debug_help(console: Console) -> None:
    """Say what stops where without the extra that waits for an editor."""
    line = "debug: breakpoint() stops in this terminal; to stop in VS Code too: pip install 'rcj-challenges[debug]'"
    console.print(line, markup=False, highlight=False, soft_wrap=True)


@dataclass(frozen=True)
class _Played:
    """What is printed: the plan, the outcome, and the robots that never moved."""

    plan: MatchPlan
    outcome: PlayedMatch
    standing: Sequence[str]


def _report(options: RunOptions, console: Console, played: _Played, trouble: OSError | None) -> None:
    """Write the replay page, and say how it ended: also if there is no room for the page.

    Args:
        options: as given.
        console: where to say it.
        played: what was played.
        trouble: why the match could not be shown while it was played; None: it could.

    Raises:
        HostError: something cannot be written; the match counts all the same.
    """
    from rcj_challenges.cli.stdio import is_output_error, output_error
    from rcj_challenges.core.errors import HostError, format_error, is_no_room, is_of_the_host, room_help
    from rcj_challenges.core.sanitize import sanitize

    try:
        _report_all(options, console, played)
        if trouble is not None:
            raise output_error(trouble)
    except (OSError, HostError) as error:
        if isinstance(error, BrokenPipeError) or not (isinstance(error, HostError) or is_of_the_host(error)):
            raise
        file = error.filename if isinstance(error, OSError) else None
        message = f"{sanitize(file)}: {format_error(error)}" if file else format_error(error)
        found = HostError(message, room_help(error), code="disk-full" if is_no_room(error) else "")
        if isinstance(error, OSError) and not file and (trouble is not None or is_output_error(error)):
            found = output_error(error)
        elif isinstance(error, HostError):
            found = error
        whole = f"the match was played to its end, and its record is whole: {sanitize(played.outcome.folder)}"
        raise HostError(str(found), "; ".join(filter(None, (found.help, whole))), code=found.code) from error


def _report_all(options: RunOptions, console: Console, played: _Played) -> None:
    from rcj_challenges.cli.advice import advice_on
    from rcj_challenges.core.errors import interruption_behind
    from rcj_challenges.records.folder import LOGS

    plan, outcome = played.plan, played.outcome
    scenario = plan.loaded.scenario
    hints: list[dict[str, Any]] = []

    def say(*, replay: bool) -> None:
        if options.json:
            _print_result(outcome, hints)
        else:
            _summary(console, scenario, outcome, hints, replay=replay)

    wanted = options.replay and _has_ticks(outcome)
    try:  # whatever happens to hints and page, the result is printed
        # A robot that was debugged needs no hint about its debugger.
        faults = [fault for fault in outcome.result["faults"] if fault["robot"] not in options.debug]
        failed = {fault["robot"] for fault in outcome.result["faults"]}
        standing = [robot for robot in played.standing if robot not in failed]
        hints = advice_on(scenario, plan.teams, faults, standing, outcome.folder / LOGS)
        if wanted:
            from rcj_challenges.views.replay import write_replay

            write_replay(outcome.folder)
    except BaseException as error:
        if interruption_behind(error) is None:  # what is said of an interruption says it all
            say(replay=False)
        raise
    say(replay=wanted)


def _print_result(outcome: PlayedMatch, hints: Sequence[dict[str, Any]]) -> None:
    print_json({**outcome.result, "hints": hints, "folder": str(outcome.folder)})


def _has_ticks(outcome: PlayedMatch) -> bool:
    """Return whether there is anything to show: a rule may end a match as it begins."""
    return any(half["ticks"] for half in outcome.result["halves"])


def _open_page(folder: Path, console: Console) -> None:
    """Open the replay page in the browser; if there is none, say so."""
    from rcj_challenges.views.replay.browse import open_replay

    page, opened = open_replay(folder)
    if not opened:
        line = f"no browser could be started here: open {page} in one"
        console.print(line, markup=False, highlight=False, soft_wrap=True)


def _report_interruption(
    options: RunOptions, console: Console, scenario: Scenario, error: MatchInterruptedError
) -> None:  # fmt: skip
    """Say how far the match came, and where that is."""
    from rcj_challenges.views.naming import changes_sides
    from rcj_challenges.views.scoreboard import score_line
    from rcj_challenges.views.sentences import clock

    if options.json:
        _print_result(error.played, [])
    result, folder = error.played.result, error.played.folder
    names = {seat: entrant["name"] for seat, entrant in result["entrants"].items()}
    where = "before the first half"
    if result["halves"]:
        half = result["halves"][-1]
        number = f"half {half['half']} of {scenario.match.halves}"
        where = f"after {number}" if half["complete"] else f"in {number} at {clock(half['ticks'] * TICK_S)}"
        where += f": {score_line(names, result['score'], sides_change=changes_sides(scenario))}"
    lines = [f"interrupted {where}", f"record: {folder}"]
    if result["halves"]:
        lines.append(f"watch:  rcj-challenge view {shell_quoted(folder)}")
    if error.trouble:
        lines.append(f"the record could not be closed: {error.trouble}")
    for line in lines:
        console.print(line, markup=False, highlight=False, soft_wrap=True)


def _team_names(loaded: Loaded, options: RunOptions) -> dict[str, str]:
    """Return the names that override the teams' own, made safe to show as those are."""
    from rcj_challenges.controllers.team import safe_name

    given = assignments(options.team_names, loaded.scenario.entrants, "--team-name")
    names = {seat: safe_name(name) for seat, name in given.items()}
    for seat, name in names.items():
        if not name:
            raise UsageError(f"--team-name {seat}=…: nothing of this name can be shown", code="bad-team-name")
    return names


def _summary(
    console: Console, scenario: Scenario, outcome: PlayedMatch, hints: Sequence[dict[str, Any]], *, replay: bool
) -> None:
    """Say how it ended, by what, and where the record is."""
    from rcj_challenges.views.naming import changes_sides
    from rcj_challenges.views.scoreboard import ranking_lines, score_line

    result, folder = outcome.result, outcome.folder
    names = {seat: entrant["name"] for seat, entrant in result["entrants"].items()}
    swap = changes_sides(scenario)
    lines = [score_line(names, result["score"], sides_change=swap)]
    lines += ranking_lines(scenario.result.rank, names, result["ranking"], sides_change=swap)
    lines += _fault_lines(result["faults"])
    lines += [f"hint for {', '.join(hint['robots'])}: {hint['remedy']}" for hint in hints]
    lines.append(
        f"{result['simulated_s']:.0f} s played in {result['wall_s']:.1f} s "
        f"({result['real_time_factor']:.0f} x real time)"
    )
    lines.append(f"record: {folder}")
    if replay:
        lines.append(f"watch:  {folder / 'replay.html'}")
    elif not _has_ticks(outcome):
        lines.append("watch:  there is nothing to show, the match was over before its first tick")
    for line in lines:
        console.print(line, markup=False, highlight=False, soft_wrap=True)


def _fault_lines(faults: Sequence[dict[str, Any]]) -> list[str]:
    """Return one line for robots that failed alike at the same tick, whichever half it was: mostly all six do."""
    from rcj_challenges.core.sanitize import sanitize

    alike: dict[tuple[str, int, str], dict[str, None]] = {}
    for fault in faults:
        alike.setdefault((fault["kind"], fault["tick"], fault["detail"]), {})[fault["robot"]] = None
    return [
        f"program fault: {', '.join(robots)} {kind} at tick {tick}: {sanitize(detail)} (logs/{next(iter(robots))}.log)"
        for (kind, tick, detail), robots in alike.items()
    ]
