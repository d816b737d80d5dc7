"""Text of strangers in HTML and SVG."""

from __future__ import annotations

import html

from rcj_challenges.core.sanitize import sanitize_lines


def escaped(text: str) -> str:
    """Return text as it can stand in an element or an attribute: markup is escaped, control characters are visible."""
    return html.escape(sanitize_lines(text))
