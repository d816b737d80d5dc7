"""Premieres: a page that counts down and then shows a recorded match to everybody at the same time.

The page is published at once and knows no more than the schedule does. The recording is a file of its own, outside of
the site, which the organizer uploads beside the page when the premiere begins: ``premieres/NAME.js`` to
``site/premiere/NAME.js``.
"""

from __future__ import annotations

from dataclasses import dataclass
from datetime import datetime
from pathlib import Path

from rcj_challenges.tournament.site.model import MatchView, Season
from rcj_challenges.tournament.site.public import public_facts, replay_of
from rcj_challenges.tournament.site.render import Renderer, day
from rcj_challenges.tournament.site.schedule import what_of
from rcj_challenges.tournament.site.source import HALF_TIME_S
from rcj_challenges.tournament.site.tree import Tree
from rcj_challenges.views.replay.page import PREMIERE_PAGE, inert_json, page_text


@dataclass(frozen=True, slots=True)
class Recording:
    """The recording of a premiere, to be uploaded when that begins."""

    file: Path
    at: datetime


def publish_premieres(tree: Tree, data: Tree, season: Season, renderer: Renderer) -> list[Recording]:
    """Write the page of each match that has a premiere, and the recordings of those that were played; return these.

    Recordings go into the folder of ``data``; one whose time has come is also put beside its page.
    """
    recordings = []
    for match in season.matches.values():
        if match.stage.name not in season.source.premieres or match.at is None:
            continue
        if match.outcome is not None:  # links to it are still around
            renderer.write(tree, f"premiere/{match.slug}.html", "premiere_over.html", match=match)
            continue
        tree.write(f"premiere/{match.slug}.html", _page(season, match))
        played = season.played(match.fixture)
        if recording := _recording(season, match, played.record if played else None):
            data.write(f"{match.slug}.js", recording)
            recordings.append(Recording(data.target / f"{match.slug}.js", match.at))
            if match.at <= season.source.now:
                tree.write(f"premiere/{match.slug}.js", recording)
    return recordings


def _page(season: Season, match: MatchView) -> str:
    zone = season.source.time_zone
    at = (match.at or season.source.now).astimezone(zone)
    return page_text(
        {
            "id": match.slug,
            "start": round(at.timestamp() * 1000),
            "half_time_s": HALF_TIME_S,
            "when": f"{day(at, zone)}, {at:%H:%M} {at:%Z}",
            "what": what_of(match),
            "teams": [{"title": season.label(side.teams)} for side in match.fixture.sides],
            "data": f"{match.slug}.js",
            "home": "../index.html",
            "about": [("what", season.source.title)],
        },
        {},
        kind=PREMIERE_PAGE,
    )


def _recording(season: Season, match: MatchView, record: Path | None) -> str:
    """Return the recording as a script that gives itself to the page; empty if there is none."""
    replay = replay_of(record)
    if replay is None:
        return ""
    facts = public_facts(replay.facts, without_logos=season.unnamed_seats(match))
    data = {"id": match.slug, "facts": facts, "poses": replay.poses}
    return f"window.premiere({inert_json(data)});\n"
