"""The schedule: for the page, for calendars (ICS), for spreadsheets (CSV); and the news as a feed."""

from __future__ import annotations

import json
from collections.abc import Iterable
from dataclasses import dataclass
from datetime import UTC, datetime, timedelta, tzinfo
from typing import NamedTuple

from rcj_challenges.core.files import slug
from rcj_challenges.tournament.csv_text import csv_text
from rcj_challenges.tournament.season import humanized
from rcj_challenges.tournament.site.model import MatchView, Season

FEED_VERSION = "https://jsonfeed.org/version/1.1"
_FOLD_BYTES = 73
_MAX_NEWS = 100


@dataclass(frozen=True, slots=True)
class Appointment:
    """Something that happens at a known time.

    Attributes:
        id: stable, for calendars.
        what: the stage, and the round.
        title: of the match, or empty.
        path: of its page in the site, or empty.
    """

    id: str
    at: datetime
    what: str
    title: str
    path: str
    match: MatchView | None = None


class Heading(NamedTuple):
    """What a calendar is of; the address is empty or ends in ``/``."""

    id: str
    title: str
    time_zone: tzinfo
    now: datetime
    url: str


def appointments(season: Season) -> tuple[Appointment, ...]:
    """Return all that has a time, in order: matches, and challenges and rounds as a whole."""
    found: list[Appointment] = []
    timed = [match for match in season.matches.values() if match.at is not None]
    for match in timed:
        if match.is_challenge:  # one run of many
            continue
        title = " - ".join(season.label(side.teams) for side in match.fixture.sides)
        when = match.at or season.source.now
        found.append(Appointment(match.slug, when, what_of(match), title, page_of(match), match))
    runs = {(match.stage.name, match.fixture.group, match.at): match for match in timed if match.is_challenge}
    for (stage, group, at), match in runs.items():
        what = f"{match.stage.title}: {humanized(group)}"
        found.append(Appointment(f"{stage}.{group}", at or season.source.now, what, "", f"stages/{slug(stage)}.html"))
    known = {(match.stage.name, match.fixture.round) for match in timed}
    titles = {stage.name: stage.title for stage in season.state.stages}
    for time in season.source.rounds:
        if any(stage == time.stage and time.round in (0, number) for stage, number in known):
            continue
        what = titles.get(time.stage, time.stage) + (f", round {time.round}" if time.round else "")
        path = f"stages/{slug(time.stage)}.html"
        found.append(Appointment(f"{time.stage}.{time.round}", time.at, what, "", path))
    return tuple(sorted(found, key=lambda appointment: (appointment.at, appointment.id)))


def page_of(match: MatchView) -> str:
    """Return the path of the page about a match, or of its premiere; empty if there is none yet."""
    if match.outcome is not None:
        return f"matches/{match.slug}/index.html"
    return f"premiere/{match.slug}.html" if match.premiere else ""


def what_of(match: MatchView) -> str:
    """Return the stage and title of a match: ``Finals: Semi-final 1``."""
    return f"{match.stage.title}: {match.short_title}" if match.short_title else match.stage.title


def as_csv(season: Season, rows: Iterable[Appointment]) -> str:
    """Return the schedule as a table; no name in it is taken for a formula."""
    zone = season.source.time_zone
    lines = [["date", "time", "time_zone", "utc", "what", "first", "second", "result"]]
    for row in rows:
        local = row.at.astimezone(zone)
        sides = [season.label(side.teams) for side in row.match.fixture.sides] if row.match else []
        sides += [""] * (2 - len(sides))
        result = " : ".join(row.match.scores) if row.match else ""
        fixed = [f"{local:%Y-%m-%d}", f"{local:%H:%M}", str(zone), f"{row.at.astimezone(UTC):%Y-%m-%dT%H:%M:%SZ}"]
        lines.append([*fixed, row.what, *sides[:2], result])
    return csv_text(lines, "\r\n")


def as_ics(heading: Heading, rows: Iterable[Appointment]) -> str:
    """Return a calendar (RFC 5545): times in UTC, lines folded within 75 bytes."""
    lines = [
        "BEGIN:VCALENDAR", "VERSION:2.0", "PRODID:-//rcj-challenges//tournament//EN", "CALSCALE:GREGORIAN",
        f"X-WR-CALNAME:{_ics_text(heading.title)}", f"X-WR-TIMEZONE:{heading.time_zone}",
    ]  # fmt: skip
    for row in rows:
        summary = f"{row.title} ({row.what})" if row.title else row.what
        lines += [
            "BEGIN:VEVENT",
            f"UID:{row.id}@{heading.id}.rcj-challenges",
            f"DTSTAMP:{_utc(heading.now)}",
            f"DTSTART:{_utc(row.at)}",
            f"DTEND:{_utc(row.at + _length(row))}",
            f"SUMMARY:{_ics_text(summary)}",
        ]
        if heading.url and row.path:
            lines.append(f"URL:{heading.url}{row.path}")
        lines.append("END:VEVENT")
    lines.append("END:VCALENDAR")
    return "".join(f"{folded}\r\n" for line in lines for folded in _folded(line))


def as_feed(season: Season) -> str:
    """Return the latest results as a JSON Feed 1.1."""
    source = season.source
    feed: dict[str, object] = {"version": FEED_VERSION, "title": source.title}
    if source.description:
        feed["description"] = source.description
    if source.url:
        feed |= {"home_page_url": f"{source.url}index.html", "feed_url": f"{source.url}feed.json"}
    feed["items"] = [_item(season, match) for match in season.latest[:_MAX_NEWS]]
    return json.dumps(feed, ensure_ascii=False, indent=1) + "\n"


def _item(season: Season, match: MatchView) -> dict[str, object]:
    sides = [season.label(side.teams) for side in match.fixture.sides]
    if match.is_challenge:
        title = f"{sides[0]}: {', '.join(match.values)}"
    else:
        title = f"{sides[0]} {' : '.join(match.scores)} {sides[-1]}"
    parts = [what_of(match), match.ruled and f"{match.ruled}: {match.outcome.reason if match.outcome else ''}"]
    item: dict[str, object] = {
        "id": f"{season.source.url}{page_of(match)}",
        "title": title,
        "content_text": ". ".join(filter(None, parts)),
    }
    if season.source.url:
        item["url"] = item["id"]
    if match.played_at.year > 1:
        item["date_published"] = match.played_at.astimezone(UTC).isoformat(timespec="seconds")
    return item


def _length(row: Appointment) -> timedelta:
    played = row.match.played if row.match else None
    return timedelta(seconds=float(played.result.get("simulated_s", 0))) if played else timedelta(minutes=30)


def _utc(at: datetime) -> str:
    return f"{at.astimezone(UTC):%Y%m%dT%H%M%SZ}"


def _ics_text(text: str) -> str:
    escaped = text.replace("\\", "\\\\").replace(";", "\\;").replace(",", "\\,")
    return escaped.replace("\r\n", "\\n").replace("\n", "\\n").replace("\r", "\\n")


def _folded(line: str) -> list[str]:
    """Return a line in pieces that are short enough, without cutting a character in two."""
    pieces, piece, size = [], "", 0
    for character in line:
        bytes_of = len(character.encode("utf-8", "replace"))
        if size + bytes_of > _FOLD_BYTES:
            pieces.append(piece)
            piece, size = " ", 1
        piece += character
        size += bytes_of
    return [*pieces, piece]
