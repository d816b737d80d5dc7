"""What can be wrong with a record."""

from __future__ import annotations

from rcj_challenges.facts.errors import RcjError


class RecordError(RcjError):
    """A record that is missing, damaged, foreign or newer than this package."""
