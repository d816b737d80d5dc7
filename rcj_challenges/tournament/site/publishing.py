"""Publishing: builds the site and the teams' folders beside the old ones, reusing unchanged files, and swaps them."""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from importlib.resources import files
from pathlib import Path

from rcj_challenges import __version__
from rcj_challenges.core.diagnostics import Diagnostic, DiagnosticError
from rcj_challenges.tournament.codes import FEWER_MATCHES
from rcj_challenges.tournament.played import Submission
from rcj_challenges.tournament.site.matches import publish_match
from rcj_challenges.tournament.site.model import Season
from rcj_challenges.tournament.site.pages import publish_overview, publish_stage, publish_teams
from rcj_challenges.tournament.site.premiere import Recording, publish_premieres
from rcj_challenges.tournament.site.private import publish_team
from rcj_challenges.tournament.site.render import Renderer
from rcj_challenges.tournament.site.similarity import LEAST_SHARE, LENGTH, similar_pairs
from rcj_challenges.tournament.site.source import SiteSource
from rcj_challenges.tournament.site.tree import Tree

SITE, FOR_TEAMS, ORGANIZER, PREMIERES = "site", "for_teams", "organizer", "premieres"
"""Folders in the tournament's data folder."""


@dataclass(frozen=True, slots=True)
class Published:
    """The folders that were written, and the organizer's page.

    Attributes:
        matches: number of those with a page.
        reused: number of those that are as they were the last time.
        recordings: of premieres that are still to come.
    """

    site: Path
    matches: int
    reused: int
    for_teams: Path
    organizer: Path
    recordings: tuple[Recording, ...]


def publish(
    source: SiteSource,
    data: Path,
    progress: Callable[[int, int], None] = lambda _done, _total: None,
    *,
    may_shrink: bool = False,
) -> Published:
    """Write the site, the folders of the teams, the premieres' data, and the page for the organizer.

    ``progress`` is called with the number of matches that are done, and of all. With ``may_shrink`` a site with more
    matches may be replaced.

    Raises:
        DiagnosticError: a foreign folder is in the way, or the site of before has more matches.
        OSError: a file cannot be written; the site of before is still there.
    """
    season = Season(source)
    renderer = Renderer(season)
    made_with = _templates()
    total = len(season.released)
    with Tree(data / SITE) as tree, Tree(data / PREMIERES) as premieres:
        if total < tree.folders_before and not may_shrink:
            message = f"the site shows {tree.folders_before} matches, and the new one would show {total}"
            help_ = "'status' shows what counts now; give --fewer to replace the site"
            raise DiagnosticError(Diagnostic(FEWER_MATCHES, message, help_))
        tree.write("style.css", renderer.style)
        for done, match in enumerate(season.released):
            progress(done, total)
            publish_match(tree, renderer, season, match, made_with)
        progress(total, total)
        publish_overview(tree, renderer, season)
        for stage in season.state.stages:
            publish_stage(tree, renderer, season, stage)
        publish_teams(tree, renderer, season)
        recordings = publish_premieres(tree, premieres, season, renderer)
    with Tree(data / FOR_TEAMS) as own:
        for team in season.teams:
            publish_team(own, renderer, season, team, made_with)
    with Tree(data / ORGANIZER) as page:
        publish_similarity(page, renderer, source.played.submissions)
    coming = tuple(one for one in recordings if one.at > source.now)
    return Published(data / SITE, total, tree.reused, data / FOR_TEAMS, data / ORGANIZER / "similarity.html", coming)


def publish_similarity(tree: Tree, renderer: Renderer, submissions: Iterable[Submission]) -> None:
    """Write the page about similar submissions, for the organizer."""
    current: dict[str, dict[str, Path]] = {}
    for one in submissions:  # the last one of each team for each purpose
        current.setdefault(one.team, {})[one.purpose] = one.path
    pairs, unread = similar_pairs(current)
    tree.write("style.css", renderer.style)
    renderer.write(tree, "similarity.html", pairs=pairs, unread=unread, least=LEAST_SHARE, length=LENGTH)


def _templates() -> str:
    """Return a hash of all files that a match's page and its replay are made with."""
    digest = hashlib.sha256(__version__.encode())
    for package, folder in (("rcj_challenges.tournament.site", "templates"), ("rcj_challenges.views.replay", "viewer")):
        for file in sorted((files(package) / folder).iterdir(), key=lambda file: file.name):
            digest.update(file.read_bytes())
    return digest.hexdigest()
