"""Prizes: the podium of the overview, and certificates to print."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from rcj_challenges.core.files import slug
from rcj_challenges.tournament.season import Row, StageState, Status
from rcj_challenges.tournament.site.model import Season, group_title
from rcj_challenges.tournament.site.render import Renderer
from rcj_challenges.tournament.site.tree import Tree

_PODIUM_PLACES = 3


def podiums(season: Season) -> list[tuple[StageState, list[Row]]]:
    """Return the first three places of finished knock-outs, and at the end of all stages with one ranking."""
    found = []
    for stage in season.state.stages:
        is_shown = stage.status is Status.FINISHED and (season.source.is_over or stage.ties)
        if is_shown and not _has_groups(stage):
            found.append((stage, [row for row in stage.places if row.place <= _PODIUM_PLACES]))
    return found


def publish_certificates(tree: Tree, renderer: Renderer, season: Season, stage: StageState) -> None:
    """Write the certificates of a stage that has finished: one page for each team, the last place first."""
    path = f"certificates/{slug(stage.name)}.html"
    days = [match.played_at for match in season.of_stage(stage) if match.outcome and match.played_at.year > 1]
    certificates = sorted(_certificates(season, stage), key=lambda one: one["row"].place, reverse=True)
    at = max(days, default=None)
    renderer.write(tree, path, "certificates.html", stage=stage, at=at, certificates=certificates)


def _certificates(season: Season, stage: StageState) -> Iterator[dict[str, Any]]:
    """Yield the content of each certificate; of stages in groups, the place in the group."""
    for group, rows in stage.rankings if _has_groups(stage) else [("", stage.places)]:
        among = group_title(stage, group) if group else ""
        for row in rows:
            teams = tuple(row.team.split("+"))
            members = teams if len(teams) > 1 else ()
            shown = {"row": row, "place": ordinal(row.place), "among": among, "members": members, "of": len(rows)}
            yield from ({"team": team, **shown} for team in teams if not season.teams[team].withdrawn)


def _has_groups(stage: StageState) -> bool:
    return stage.has_groups and len(stage.tables) > 1


def ordinal(number: int) -> str:
    """Return ``1st``, ``2nd``, ``3rd``, ``4th``, ``11th``."""
    return f"{number}{'th' if number // 10 % 10 == 1 else {1: 'st', 2: 'nd', 3: 'rd'}.get(number % 10, 'th')}"
