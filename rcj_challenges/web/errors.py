"""Errors of the site's commands."""

from __future__ import annotations

from rcj_challenges.core.errors import RcjError


class SiteError(RcjError):
    """The folder or the settings of a site cannot be used."""
