"""The pages of the codes of matches."""

from __future__ import annotations

PAGES: dict[str, str] = {
    "record-does-not-fit": (
        "A record can be judged only by a scenario with the same robots, balls, obstacles and entrants, in the same "
        "order.\n\nJudge it by the scenario that was played, or by a copy of it with other rules."
    ),
}
