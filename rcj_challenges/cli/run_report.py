"""What ``rcj-challenge run`` prints after a match: hints, the score, and where record and page are."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from rcj_challenges.cli.stdio import as_host_error, output_error, print_json, print_lines, shell_quoted, shown_path
from rcj_challenges.core.errors import HostError, interruption_behind
from rcj_challenges.core.grouping import grouped
from rcj_challenges.core.sanitize import sanitize
from rcj_challenges.core.timing import TICK_S

if TYPE_CHECKING:
    from collections.abc import Sequence

    from rich.console import Console

    from rcj_challenges.match.runner import MatchInterruptedError, MatchPlan, PlayedMatch
    from rcj_challenges.scenario.models.scenario import Scenario


class MatchReport:
    """Prints how a match ended, and writes its page.

    Args:
        plan: of the match.
        console: for what people read.
        as_json: whether the result is printed as JSON and nothing else.
        with_page: whether to write the replay page.
    """

    def __init__(self, plan: MatchPlan, console: Console, *, as_json: bool, with_page: bool) -> None:
        self._plan = plan
        self._scenario = plan.loaded.scenario
        self._console = console
        self._as_json = as_json
        self._with_page = with_page

    def played(self, outcome: PlayedMatch, motionless: Sequence[str], display_error: OSError | None) -> None:
        """Write hints and the replay page, and print how the match ended: whatever happens to hints and page.

        ``display_error`` is why the match could not be shown while it was played.

        Raises:
            HostError: something cannot be written; the match counts all the same.
        """
        from rcj_challenges.cli.advice import advice_on
        from rcj_challenges.records.folder import LOGS
        from rcj_challenges.scenario.halves import in_half

        hints: list[dict[str, Any]] = []
        replay = False
        try:
            try:
                # A robot that was debugged needs no hint about its debugger.
                faults = [fault for fault in outcome.result["faults"] if fault["robot"] not in self._plan.debug]
                failed = {fault["robot"] for fault in outcome.result["faults"]}
                motionless = [robot for robot in motionless if robot not in failed]
                logs = outcome.folder / LOGS
                hints = advice_on(in_half(self._scenario, 1), self._plan.teams, faults, motionless, outcome.notes, logs)
                if self._with_page and has_ticks(outcome):
                    from rcj_challenges.views.replay import write_replay

                    write_replay(outcome.folder)
                    replay = True
            except BaseException as error:
                if interruption_behind(error) is None:  # else `interrupted` prints it
                    self._print(outcome, hints, replay=False)
                raise
            self._print(outcome, hints, replay=replay)
            if display_error is not None:
                raise output_error(display_error)
        except (OSError, HostError) as error:
            if display_error is not None and isinstance(error, OSError) and error.filename is None:
                found: HostError | None = output_error(error)
            else:
                found = as_host_error(error)
            if found is None or isinstance(error, BrokenPipeError):
                raise
            whole = f"the match was played to its end, and its record is whole: {sanitize(outcome.folder)}"
            raise HostError(str(found), "; ".join(filter(None, (found.help, whole))), code=found.code) from error

    def interrupted(self, error: MatchInterruptedError) -> None:
        """Print how far the match came, and where its record is."""
        from rcj_challenges.views.sentences import clock

        result, folder = error.played.result, error.played.folder
        if self._as_json:
            print_json({**result, "hints": [], "folder": str(folder)})
        period = self._scenario.match.period
        where = f"before the first {period}"
        if result["halves"]:
            half = result["halves"][-1]
            number = f"{period} {half['half']} of {self._scenario.match.halves}"
            where = f"after {number}" if half["complete"] else f"in {number} at {clock(half['ticks'] * TICK_S)}"
            where += f": {score_lines(self._scenario, result)[0]}"
        print_lines(self._console, f"interrupted {where}", f"record: {shown_path(folder)}")
        if result["halves"]:
            print_lines(self._console, f"watch:  rcj-challenge view {shell_quoted(folder)}")
        if error.problem:
            print_lines(self._console, f"the record could not be closed: {error.problem}")

    def _print(self, outcome: PlayedMatch, hints: Sequence[dict[str, Any]], *, replay: bool) -> None:
        """Print how it ended, by what, and where the record is."""
        result, folder = outcome.result, outcome.folder
        if self._as_json:
            print_json({**result, "hints": hints, "folder": str(folder)})
            return
        lines = score_lines(self._scenario, result) + _fault_lines(result["faults"])
        lines += [f"hint for {', '.join(hint['robots'])}: {hint['help']}" for hint in hints]
        pace = f"{result['real_time_factor']:.0f} x real time"
        lines.append(f"{result['simulated_s']:.0f} s played in {result['wall_s']:.1f} s ({pace})")
        lines.append(f"record: {shown_path(folder)}")
        if replay:
            lines.append(f"watch:  {shown_path(folder / 'replay.html')}")
        elif not has_ticks(outcome):
            lines.append("watch:  there is nothing to show, the match was over before its first tick")
        print_lines(self._console, *lines)


def has_ticks(outcome: PlayedMatch) -> bool:
    """Whether there is anything to show: a rule may end a match as it begins."""
    return any(half["ticks"] for half in outcome.result["halves"])


def score_lines(scenario: Scenario, result: dict[str, Any]) -> list[str]:
    """The score, and a line for each place of the ranking."""
    from rcj_challenges.views.naming import changes_sides, score_line, shown_names
    from rcj_challenges.views.scoreboard import ranking_lines

    names = {seat: entrant["name"] for seat, entrant in result["entrants"].items()}
    names = shown_names(names, sides_change=changes_sides(scenario))
    return [score_line(names, result["score"]), *ranking_lines(scenario.result.rank, names, result["ranking"])]


def _fault_lines(faults: Sequence[dict[str, Any]]) -> list[str]:
    """One line for robots that failed alike at the same tick, whichever half it was: mostly all six do."""
    alike = grouped(((fault["kind"], fault["tick"], fault["detail"]), fault["robot"]) for fault in faults)
    return [
        f"program fault: {', '.join(dict.fromkeys(robots))} {kind} at tick {tick}: {sanitize(detail)} "
        f"(logs/{robots[0]}.log)"
        for (kind, tick, detail), robots in alike.items()
    ]
