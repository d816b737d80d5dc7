"""The display names of teams: safe to show, and unique."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping

from rcj_challenges.submissions.team_name import safe_name
from rcj_challenges.tournament.entries import TeamEntry
from rcj_challenges.tournament.store.tables import SubmissionRow


def display_names(
    entries: Mapping[str, TeamEntry], submissions: Mapping[tuple[str, str], SubmissionRow]
) -> dict[str, str]:
    """Return what each team is called: as the file says, else as its submission, else its id.

    Names that are equal without regard to case are followed by the team's id.
    """
    names = {}
    for team, entry in entries.items():
        row = submissions.get((team, ""))
        names[team] = safe_name(entry.name or (row.name if row is not None else "")) or team
    counts = Counter(name.casefold() for name in names.values())
    return {team: name if counts[name.casefold()] == 1 else f"{name} ({team})" for team, name in names.items()}
