"""Plays a scenario for ``rcj-challenge run``: from options to the last lines on the terminal."""

from __future__ import annotations

import os
from dataclasses import dataclass
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Any

from rcj_challenges.cli.sandbox import require_layers
from rcj_challenges.cli.stdio import as_host_error, output_error, print_json, print_lines, shell_quoted, shown_path
from rcj_challenges.cli.team_args import UsageError, assignments, known, open_teams
from rcj_challenges.core.errors import HostError, interruption_behind
from rcj_challenges.core.sanitize import sanitize
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
                _report(options, console, plan, outcome, standing.robots(), getattr(observer, "trouble", None))
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
        message = "--debug gives a program the terminal, and --json prints the result there and nothing else"
        raise UsageError(message, f"{_ONE}; result.json in the record has the same", code=_CONTRADICT)
    if len(options.debug) > 1:
        robots = ", ".join(sorted(options.debug))
        raise UsageError("--debug is given more than once", f"give it for one of {robots}", code="option-given-twice")


def _prepared(options: RunOptions) -> tuple[MatchPlan, Console, Observer]:
    """Return the match to be played with its teams opened, the console, and the observer."""
    from rcj_challenges.cli.output_paths import refuse_devices
    from rcj_challenges.scenario.load import load

    refuse_devices(out=options.out)
    loaded = load(options.scenario, options.overrides)
    if not options.quiet:
        require_layers(options.sandbox)
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
        help_ = 'to stop in VS Code too: pip install "rcj-challenges[debug]"'
        print_lines(console, f"debug: breakpoint() stops in this terminal; {help_}")
    return plan, console, observer


def _team_names(loaded: Loaded, options: RunOptions) -> dict[str, str]:
    """Return the names that override the teams' own, made safe to show as those are."""
    from rcj_challenges.submissions.team import safe_name

    given = assignments(options.team_names, loaded.scenario.entrants, "--team-name")
    names = {seat: safe_name(name) for seat, name in given.items()}
    for seat, name in names.items():
        if not name:
            raise UsageError(f"--team-name {seat}=…: nothing of this name can be shown", code="bad-team-name")
    return names


def _report(
    options: RunOptions,
    console: Console,
    plan: MatchPlan,
    outcome: PlayedMatch,
    standing: Sequence[str],
    trouble: OSError | None,
) -> None:
    """Write hints and the replay page, and print how the match ended: whatever happens to hints and page.

    ``trouble`` is why the match could not be shown while it was played.

    Raises:
        HostError: something cannot be written; the match counts all the same.
    """
    from rcj_challenges.cli.advice import advice_on
    from rcj_challenges.records.folder import LOGS

    hints: list[dict[str, Any]] = []
    replay = False
    try:
        try:
            # A robot that was debugged needs no hint about its debugger.
            faults = [fault for fault in outcome.result["faults"] if fault["robot"] not in options.debug]
            failed = {fault["robot"] for fault in outcome.result["faults"]}
            standing = [robot for robot in standing if robot not in failed]
            hints = advice_on(plan.loaded.scenario, plan.teams, faults, standing, outcome.folder / LOGS)
            if options.replay and _has_ticks(outcome):
                from rcj_challenges.views.replay import write_replay

                write_replay(outcome.folder)
                replay = True
        except BaseException as error:
            if interruption_behind(error) is None:  # else `_report_interruption` prints it
                _print_outcome(options, console, plan.loaded.scenario, outcome, hints, replay=False)
            raise
        _print_outcome(options, console, plan.loaded.scenario, outcome, hints, replay=replay)
        if trouble is not None:
            raise output_error(trouble)
    except (OSError, HostError) as error:
        if trouble is not None and isinstance(error, OSError) and error.filename is None:
            found: HostError | None = output_error(error)
        else:
            found = as_host_error(error)
        if found is None or isinstance(error, BrokenPipeError):
            raise
        whole = f"the match was played to its end, and its record is whole: {sanitize(outcome.folder)}"
        raise HostError(str(found), "; ".join(filter(None, (found.help, whole))), code=found.code) from error


def _has_ticks(outcome: PlayedMatch) -> bool:
    """Return whether there is anything to show: a rule may end a match as it begins."""
    return any(half["ticks"] for half in outcome.result["halves"])


def _open_page(folder: Path, console: Console) -> None:
    from rcj_challenges.views.replay.browse import open_replay

    page, opened = open_replay(folder)
    if not opened:
        print_lines(console, f"no browser could be started here: open {shown_path(page)} in one")


def _report_interruption(
    options: RunOptions, console: Console, scenario: Scenario, error: MatchInterruptedError
) -> None:  # fmt: skip
    """Print how far the match came, and where its record is."""
    from rcj_challenges.views.sentences import clock

    result, folder = error.played.result, error.played.folder
    if options.json:
        print_json({**result, "hints": [], "folder": str(folder)})
    where = "before the first half"
    if result["halves"]:
        half = result["halves"][-1]
        number = f"half {half['half']} of {scenario.match.halves}"
        where = f"after {number}" if half["complete"] else f"in {number} at {clock(half['ticks'] * TICK_S)}"
        where += f": {score_lines(scenario, result)[0]}"
    print_lines(console, f"interrupted {where}", f"record: {shown_path(folder)}")
    if result["halves"]:
        print_lines(console, f"watch:  rcj-challenge view {shell_quoted(folder)}")
    if error.trouble:
        print_lines(console, f"the record could not be closed: {error.trouble}")


def _print_outcome(
    options: RunOptions,
    console: Console,
    scenario: Scenario,
    outcome: PlayedMatch,
    hints: Sequence[dict[str, Any]],
    *,
    replay: bool,
) -> None:
    """Print how it ended, by what, and where the record is."""
    result, folder = outcome.result, outcome.folder
    if options.json:
        print_json({**result, "hints": hints, "folder": str(folder)})
        return
    lines = score_lines(scenario, result) + _fault_lines(result["faults"])
    lines += [f"hint for {', '.join(hint['robots'])}: {hint['help']}" for hint in hints]
    pace = f"{result['real_time_factor']:.0f} x real time"
    lines.append(f"{result['simulated_s']:.0f} s played in {result['wall_s']:.1f} s ({pace})")
    lines.append(f"record: {shown_path(folder)}")
    if replay:
        lines.append(f"watch:  {shown_path(folder / 'replay.html')}")
    elif not _has_ticks(outcome):
        lines.append("watch:  there is nothing to show, the match was over before its first tick")
    print_lines(console, *lines)


def score_lines(scenario: Scenario, result: dict[str, Any]) -> list[str]:
    """Return the score, and a line for each place of the ranking."""
    from rcj_challenges.views.naming import changes_sides
    from rcj_challenges.views.score_lines import score_line
    from rcj_challenges.views.scoreboard import ranking_lines

    names = {seat: entrant["name"] for seat, entrant in result["entrants"].items()}
    swap = changes_sides(scenario)
    score = score_line(names, result["score"], sides_change=swap)
    return [score, *ranking_lines(scenario.result.rank, names, result["ranking"], sides_change=swap)]


def _fault_lines(faults: Sequence[dict[str, Any]]) -> list[str]:
    """Return one line for robots that failed alike at the same tick, whichever half it was: mostly all six do."""
    alike: dict[tuple[str, int, str], dict[str, None]] = {}
    for fault in faults:
        alike.setdefault((fault["kind"], fault["tick"], fault["detail"]), {})[fault["robot"]] = None
    return [
        f"program fault: {', '.join(robots)} {kind} at tick {tick}: {sanitize(detail)} (logs/{next(iter(robots))}.log)"
        for (kind, tick, detail), robots in alike.items()
    ]
