"""The static site of a tournament: pages, schedule, feed, premieres, and a private folder for each team.

Belongs here: what is published of a season, and how it looks. Does not belong here: what decides a season (the
engine), what was played (the store), the replay page itself (``views.replay``).

Two audiences, two folders. The site is for everyone: players are minors, so nothing of their code, their output or
their tracebacks is in it, and faults appear by kind only. ``for_teams/ID`` is for one team.
"""

from rcj_challenges.tournament.site.publishing import Published, publish
from rcj_challenges.tournament.site.source import RoundTime, SiteSource, hidden_fixtures, site_source

__all__ = ["Published", "RoundTime", "SiteSource", "hidden_fixtures", "publish", "site_source"]
