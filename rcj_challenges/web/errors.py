"""Errors of the site's commands."""

from rcj_challenges.core.errors import RcjError


class SiteError(RcjError):
    """The folder or the settings of a site cannot be used."""
