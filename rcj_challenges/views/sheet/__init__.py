"""The rule sheet for the teams, generated from the scenario: sheet and referee cannot disagree.

Belongs here: rules as sentences, tables of numbers, Markdown and HTML. Does not belong here: rules of any challenge.
"""

from __future__ import annotations

from rcj_challenges.views.sheet.page import sheet_html, sheet_markdown

__all__ = ["sheet_html", "sheet_markdown"]
