"""The page of a match and the files beside it: replay, result and statistics, without anything private."""

from __future__ import annotations

import json
from collections.abc import Mapping
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from markupsafe import Markup

from rcj_challenges.core.amounts import number_words
from rcj_challenges.core.timing import s_from_ticks
from rcj_challenges.records.folder import REPLAY, TRAJECTORY
from rcj_challenges.tournament.jobs import STATS
from rcj_challenges.tournament.site.model import MatchView, Season
from rcj_challenges.tournament.site.plots import score_plot
from rcj_challenges.tournament.site.public import (
    ReplayData,
    fault_moment,
    fault_words,
    public_facts,
    public_result,
    public_stats,
    replay_of,
)
from rcj_challenges.tournament.site.render import Renderer
from rcj_challenges.tournament.site.tree import Tree, fingerprint
from rcj_challenges.views.replay.page import page_text
from rcj_challenges.views.sentences import clock
from rcj_challenges.views.stats import DEFINITIONS

_MAX_EVENTS = 400
_FIGURES = tuple(key for key in DEFINITIONS if key not in ("faults", "calls"))
_ROUTINE = ("MATCH_START", "MATCH_FINISH", "KICKOFF")
"""Events that a reader of a report does not miss; the replay has them."""


@dataclass(frozen=True, slots=True)
class Moment:
    """One event of the report.

    Attributes:
        about: a sentence.
        standing: the score after it, if it changed.
        side: that gained or lost points.
        kind: ``goal``, ``loss``, ``fault``, ``call``.
        link: to this moment of the replay.
    """

    half: int
    clock: str
    name: str
    about: str
    standing: str
    side: str
    kind: str
    link: str


def publish_match(tree: Tree, renderer: Renderer, season: Season, match: MatchView, templates: str) -> None:
    """Write the folder of a match with an outcome, unless it is as before, also the hash of the templates."""
    folder = f"matches/{match.slug}"
    tree.folder(folder, _made_from(season, match, templates), lambda: _write(tree, renderer, season, match, folder))


def _made_from(season: Season, match: MatchView, templates: str) -> str:
    played = match.played
    record = played.record if played else None
    files = [record / name for name in (REPLAY, STATS, TRAJECTORY)] if record else []
    return fingerprint(
        [
            templates, repr(match.fixture), match.stage.title, repr(match.outcome), str(match.at), match.lot_winner,
            [season.name(team) for team in match.teams], season.unnamed_seats(match),
            [match.played.result.get("digest"), match.played.doubtful, repr(match.played.rulings),
             dict(match.played.submissions), str(match.played.played_at)] if match.played else None,
            [(path.name, path.stat().st_mtime_ns) for path in files if path.is_file()],
            season.source.title, str(season.source.time_zone), [stage.title for stage in season.state.stages],
        ]
    )  # fmt: skip


def _write(tree: Tree, renderer: Renderer, season: Season, match: MatchView, folder: str) -> None:
    played = match.played
    result = played.result if played else {}
    record = played.record if played else None
    replay = replay_of(record)
    downloads = []
    if replay is not None:
        facts = public_facts(replay.facts, without_logos=season.unnamed_seats(match))
        tree.write(f"{folder}/replay.html", page_text(facts, replay.poses))
        replay = ReplayData(facts, replay.poses)
        downloads.append(("replay.html", "the replay, one file"))
    if result:
        tree.write(f"{folder}/result.json", _json(public_result(result)))
        downloads.append(("result.json", "result and events, JSON"))
    stats = _stats(record)
    if stats is not None:
        tree.write(f"{folder}/{STATS}", _json(stats))
        downloads.append((STATS, "statistics, JSON"))
    renderer.write(
        tree,
        f"{folder}/index.html",
        "match.html",
        match=match,
        moments=_moments(replay) if replay is not None else [],
        plot=_plot(season, match, replay),
        stats=_stats_rows(stats, match, list(result.get("entrants", ()))),
        definitions=DEFINITIONS,
        downloads=downloads,
        has_replay=replay is not None,
        halves=_halves(match, result),
        faults=_faults(season, match, result),
    )


def _json(value: Any) -> str:
    return json.dumps(value, ensure_ascii=True, separators=(",", ":")) + "\n"


def _stats(record: Path | None) -> dict[str, Any] | None:
    """Return the public statistics of a record; None if there are none."""
    with suppress(OSError, ValueError):
        return None if record is None else public_stats(json.loads((record / STATS).read_text("utf-8")))
    return None


# --- the page --------------------------------------------------------------------------------------------------------


def _moments(replay: ReplayData) -> list[Moment]:
    """Return the events of a match as sentences, with links into the replay."""
    titles = {team["name"]: team["title"] for team in replay.facts["teams"]}
    found = [
        Moment(
            half=event["half"],
            clock=clock(s_from_ticks(event["tick"])),
            name=event.get("title", event["name"]),
            about=" · ".join(filter(None, (event["about"], event["payload_text"]))),
            standing=event["standing"],
            side=titles.get(event["team"], ""),
            kind=event["kind"],
            link=f"replay.html#h{event['half']}t{event['tick']}",
        )
        for event in replay.facts["events"]
        if event["name"] not in _ROUTINE
    ]
    return found[:_MAX_EVENTS]


def _plot(season: Season, match: MatchView, replay: ReplayData | None) -> Markup | None:
    """Return a picture of the score of two sides over time; None without a replay."""
    if replay is None or len(match.fixture.sides) != 2:
        return None
    seats = [side.seat for side in match.fixture.sides]
    halves = []
    for half in replay.facts["halves"]:
        changes = [(0, half["scores"]), *half["score_changes"]]
        scores = [(s_from_ticks(tick), [own.get(seat, 0) for seat in seats]) for tick, own in changes]
        halves.append((s_from_ticks(half["ticks"]), scores))
    return score_plot([season.label(side.teams) for side in match.fixture.sides], halves, match.period)


def _halves(match: MatchView, result: Mapping[str, Any]) -> list[dict[str, Any]]:
    """Return the score after each half, in the order of the sides."""
    seats = [side.seat for side in match.fixture.sides]
    return [
        {
            "half": half["half"],
            "scores": [number_words(half["score"].get(seat, 0)) for seat in seats],
            "length": clock(s_from_ticks(half["ticks"])),
            "ended": half.get("ended") or "",
        }
        for half in result.get("halves", ())
    ]


def _faults(season: Season, match: MatchView, result: Mapping[str, Any]) -> list[dict[str, Any]]:
    """Return the faults of programs, by kind only."""
    sides = {side.seat: season.label(side.teams) for side in match.fixture.sides}
    period = match.period
    return [
        {
            "when": fault_moment(fault, period),
            "robot": fault["robot"],
            "side": sides.get(fault.get("team") or "", ""),
            "words": fault_words(fault["kind"]),
        }
        for fault in result.get("faults", ())
    ]


def _stats_rows(stats: Mapping[str, Any] | None, match: MatchView, seats: list[str]) -> list[dict[str, Any]]:
    """Return figures as rows with a cell for each side, in the order of the match's sides.

    The teams of ``stats`` are in the order of the scenario's ``seats``.
    """
    if stats is None or len(stats["teams"]) != len(seats):
        return []
    by_seat: Mapping[str, Mapping[str, Any]] = dict(zip(seats, stats["teams"].values(), strict=True))
    teams = [by_seat[side.seat] for side in match.fixture.sides if side.seat in by_seat]
    rows = []
    for key in (key for key in _FIGURES if all(key in team for team in teams)):
        definition = DEFINITIONS[key]
        cells = ["" if team[key] is None else number_words(team[key], 2) for team in teams]
        total = sum(team[key] or 0 for team in teams)
        share = round(100 * (teams[0][key] or 0) / total) if total and len(teams) == 2 else 50
        named = {"title": definition.title, "unit": definition.unit, "text": definition.text}
        rows.append(named | {"cells": cells, "share": share})
    return rows
