"""Text of strangers in HTML and SVG."""

from __future__ import annotations

import html

from rcj_challenges.facts.shown import shown_whole


def escaped(text: str) -> str:
    """Return text that can stand in an element or an attribute: visible characters without a meaning in markup."""
    return html.escape(shown_whole(text))
