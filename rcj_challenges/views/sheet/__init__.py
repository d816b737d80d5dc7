"""The rule sheet for the teams, generated from the scenario: sheet and referee cannot disagree.

Belongs here: rules as sentences, tables of numbers, Markdown and HTML. Does not belong here: rules of any challenge.
"""

from __future__ import annotations

from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.roster import Roster
from rcj_challenges.views.sheet.document import to_html, to_markdown
from rcj_challenges.views.sheet.page import sheet_of

__all__ = ["sheet_html", "sheet_markdown"]


def sheet_markdown(scenario: Scenario, roster: Roster, picture: str | None = None) -> str:
    """Return the rule sheet as Markdown; ``picture`` is what stands for the drawing, None: itself, as inline SVG."""
    return to_markdown(sheet_of(scenario, roster), picture)


def sheet_html(scenario: Scenario, roster: Roster) -> str:
    """Return the rule sheet as one self-contained HTML page."""
    return to_html(sheet_of(scenario, roster))
