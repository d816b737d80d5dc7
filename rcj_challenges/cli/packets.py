"""What ``run`` says of programs that read packets of another form than they have in this match, or that lack files."""

from __future__ import annotations

import contextlib
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence
    from pathlib import Path

    from rcj_challenges.controllers.team import Team
    from rcj_challenges.scenario.models.scenario import Scenario


def packet_hints(
    scenario: Scenario, teams: Mapping[str, Team], faults: Sequence[Mapping[str, Any]], logs: Path
) -> list[dict[str, Any]]:
    """Return each such mistake as in `HintResult`, in the words of ``check``, and write it into the robots' logs.

    Args:
        scenario: what was played.
        teams: who played, by seat of the first half.
        faults: as in the result.
        logs: folder with the robots' logs.
    """
    crashes = [fault for fault in faults if fault["kind"] == "crash" and fault["team"] in teams]
    if not crashes:
        return []
    from rcj_challenges.checker.hints import on_files, on_messages

    robots: dict[str, dict[str, None]] = {}
    for fault in crashes:
        team = teams[fault["team"]]
        hint = on_messages(scenario, team, fault) or on_files(team, fault)
        if hint is not None:
            robots.setdefault(hint.remedy, {})[fault["robot"]] = None
    for remedy, alike in robots.items():
        for robot in alike:
            # A full disk is no reason to keep back the result of a match.
            with contextlib.suppress(OSError), (logs / f"{robot}.log").open("a", encoding="utf-8") as log:
                log.write(f"hint: {remedy}\n")
    return [{"robots": list(alike), "remedy": remedy} for remedy, alike in robots.items()]
