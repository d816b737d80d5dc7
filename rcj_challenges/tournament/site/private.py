"""The folder of one team, for the organizer to hand out: its logs, its tracebacks, its check report, its replays.

Of a match only what is released is in it, and of the other side nothing that the site does not show.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Collection
from contextlib import suppress
from dataclasses import replace
from pathlib import Path
from typing import Any

from rcj_challenges.core.files import slug
from rcj_challenges.records.errors import RecordError
from rcj_challenges.records.folder import LOGS, RESULT, SCENARIO
from rcj_challenges.records.sensors import read_sensors
from rcj_challenges.tournament.jobs import sizes
from rcj_challenges.tournament.season import Side
from rcj_challenges.tournament.site.model import MatchView, Season, driver, team_faults
from rcj_challenges.tournament.site.public import public_facts, replay_of
from rcj_challenges.tournament.site.render import Renderer
from rcj_challenges.tournament.site.tree import Tree, fingerprint
from rcj_challenges.views.replay.page import page_text
from rcj_challenges.views.replay.sensor_blocks import output_block, picture_blocks, sensor_block, sensor_facts

_MAX_REPORT_FILES = 200


def publish_team(tree: Tree, renderer: Renderer, season: Season, team: str, made_with: str) -> None:
    """Write the folder of one team; what is as before, also the hash of the templates (``made_with``), stays."""
    home = slug(team)
    matches = [match for match in season.of_team(team) if match.outcome is not None and match.played is not None]
    for match in matches:
        folder = f"{home}/{match.slug}"
        digest, record = (match.played.result.get("digest"), match.played.record) if match.played else ("", None)
        made_from = fingerprint([made_with, digest, season.name(team), _recorded(record)])
        tree.folder(folder, made_from, lambda match=match, folder=folder: _write(tree, match, team, folder))  # type: ignore[misc]
    reports = _copy_reports(tree, season, team, home)
    rows = [
        {"match": match, "files": files, "faults": faults}
        for match in matches
        if (files := tree.listed(f"{home}/{match.slug}")) + (faults := team_faults(match, team))
    ]
    tree.write(f"{home}/style.css", renderer.style)
    renderer.write(tree, f"{home}/index.html", "for_team.html", team=team, rows=rows, reports=reports)


def _recorded(record: Path | None) -> dict[str, int]:
    """Return the size of each file of a record: ``rerun`` can add sensors to it."""
    try:
        return sizes(record) if record is not None else {}
    except OSError:
        return {}


def _write(tree: Tree, match: MatchView, team: str, folder: str) -> None:
    """Write logs and replay of one match."""
    record = match.played.record if match.played else None
    if record is None or match.played is None:
        return
    robots = _robots(record, match, team)
    halves = [half["half"] for half in match.played.result.get("halves", ())]
    for robot, text in own_logs(record, halves, robots).items():
        tree.write(f"{folder}/{robot}.log", text)
    if page := replay_of(record):
        facts = public_facts(page.facts, robots)
        if sensing := _sensing(facts, record, robots):  # else it would be the one of the site
            tree.write(f"{folder}/replay.html", page_text(facts, page.poses, sensing))


def _robots(record: Path, match: MatchView, team: str) -> frozenset[tuple[int, str]]:
    """Return (half, robot) for each robot that a team's programs drove."""
    sides: dict[str, Side] = {side.seat: side for side in match.fixture.sides}
    return driven(record, lambda seat, robot: seat in sides and team == driver(sides[seat], robot))


def driven(record: Path, is_own: Callable[[str, str], bool]) -> frozenset[tuple[int, str]]:
    """Return (half, robot) for each robot that is driven by the same programs.

    ``is_own`` decides this by the seat of the first half and the robot.
    """
    try:
        entrants = json.loads((record / SCENARIO).read_text("utf-8"))["entrants"]
        halves = json.loads((record / RESULT).read_text("utf-8"))["halves"]
    except (OSError, ValueError, KeyError, TypeError):
        return frozenset()
    return frozenset(
        (half["half"], robot)
        for half in halves
        for seat, first_seat in half["sides"].items()
        for robot in entrants.get(seat, {}).get("robots", {})
        if is_own(first_seat, robot)
    )


def own_logs(record: Path, halves: Collection[int], robots: Collection[tuple[int, str]]) -> dict[str, str]:
    """Return what the programs of some robots (half, robot) printed in a match with these halves, by robot."""
    found = {}
    for robot in sorted({robot for _, robot in robots}):
        with suppress(OSError):
            text = (record / LOGS / f"{robot}.log").read_text("utf-8", "replace")
            if mine := own_log(text, halves, [half for half in halves if (half, robot) in robots]):
                found[robot] = mine
    return found


def own_log(text: str, halves: Collection[int], own: Collection[int]) -> str:
    """Return the part of a robot's log that the team's own program printed: robots change teams with the sides.

    The second half is taken to begin at the last line that says so, wherever it stands in its line: so a program of
    the first half cannot get more than its own by printing such a line or by leaving its last line open, and one of
    the second half gives away its own at most. With more halves than two this does not work, so nothing is returned.
    In the halves ``own`` the robot was the team's.
    """
    if set(halves) <= set(own):
        return text
    if not own or set(halves) != {1, 2}:
        return ""
    begin = text.rfind("--- half 2: ")
    if begin < 0:
        return text if 1 in own else ""
    return text[:begin] if 1 in own else text[begin:]


def _sensing(facts: dict[str, Any], record: Path, robots: Collection[tuple[int, str]]) -> dict[str, str]:
    """Add the data and output of the team's own robots to the facts; return the blocks by id."""
    blocks: dict[str, str] = {}
    try:
        halves = read_sensors(record)
    except RecordError:
        return blocks
    for number, half in halves.items():
        own = replace(half, robots={name: track for name, track in half.robots.items() if (number, name) in robots})
        if own.robots:
            blocks[f"output-{number}"] = output_block(own)
            if own.has_readings:
                facts["sensors"][str(number)] = sensor_facts(own)
                blocks[f"sensors-{number}"] = sensor_block(own)
                blocks |= picture_blocks(own)
    return blocks


def _copy_reports(tree: Tree, season: Season, team: str, home: str) -> list[str]:
    """Copy the check's reports of a team's submissions; return their paths."""
    found = []
    for one in season.source.played.submissions:
        if one.team != team or one.report is None or not one.report.is_dir():
            continue
        for file in sorted(one.report.rglob("*"))[:_MAX_REPORT_FILES]:
            if file.is_file():
                path = f"check/{one.sha256[:12]}/{file.relative_to(one.report).as_posix()}"
                tree.copy(file, f"{home}/{path}")
                found.append(path)
    return found
