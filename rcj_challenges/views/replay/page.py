"""Builds the replay page: facts, poses and viewer in one file."""

from __future__ import annotations

import base64
import hashlib
import json
from collections.abc import Callable, Collection, Iterator, Mapping
from dataclasses import dataclass
from functools import partial
from importlib.resources import files
from itertools import chain
from pathlib import Path
from typing import Any

from rcj_challenges.core.play import Fault
from rcj_challenges.core.timing import TICK_S
from rcj_challenges.records.chunks import DAMAGE
from rcj_challenges.records.errors import RecordError
from rcj_challenges.records.folder import REPLAY, replaced
from rcj_challenges.records.logos import MAX_LOGO_BYTES, LogoError, checked_png, logo_path
from rcj_challenges.records.result import RunResult
from rcj_challenges.records.run_record import RunRecord, read_run
from rcj_challenges.records.sensors import read_sensors
from rcj_challenges.records.trajectory import HalfTrack
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.views.markup import escaped
from rcj_challenges.views.naming import titles
from rcj_challenges.views.palette import PALETTE
from rcj_challenges.views.replay.events import EventFacts, half_facts
from rcj_challenges.views.replay.packing import Frames, frames_of, length_unit, packed, units
from rcj_challenges.views.replay.sensor_blocks import output_block, picture_blocks, sensor_block, sensor_facts
from rcj_challenges.views.replay.things import visible_things
from rcj_challenges.views.scoreboard import ranking_rows
from rcj_challenges.views.timeline import timeline_of

SCRIPTS = (
    "element", "maths", "colourMaths", "recording", "embedded", "mesh", "ground", "bodies", "overlays",
    "painter", "scene", "canvas2d", "camera", "pointerInput", "labels", "board", "player", "transport",
    "eventlist", "robotlist", "pictures", "sensors", "output", "heat", "logos", "panels", "app", "start",
)  # fmt: skip
"""The parts of the viewer in the order in which they are joined: what is used stands before what uses it."""

_FED_SCRIPTS = (*SCRIPTS[:-1], "live", "livesensors", "liveClient")
"""What pages have that a feed fills, besides their own parts."""

_LONGEST_NAME = 200


@dataclass(frozen=True, slots=True)
class PageKind:
    """What kind of page the viewer is on.

    Attributes:
        scripts, styles: its parts, in the order in which they are joined.
        scripts_from: addresses from which it may load further scripts, as a content security policy has them.
        connects_to: addresses that it may ask, in the same form; empty: none.
    """

    scripts: tuple[str, ...]
    styles: tuple[str, ...] = ("style.css",)
    scripts_from: str = ""
    connects_to: str = ""


REPLAY_PAGE = PageKind(SCRIPTS)
LIVE_PAGE = PageKind((*_FED_SCRIPTS, "matchControls", "startlive"), ("style.css", "live.css"), connects_to="'self'")
"""Watches a match while it is played."""
PREMIERE_PAGE = PageKind(
    (*_FED_SCRIPTS, "premiere", "startpremiere"), ("style.css", "live.css", "premiere.css"), "'self'", "'self'"
)
"""Shows a recorded match at a time that was set: the feed is the recording and the clock."""
STAGE_PAGE = PageKind((*_FED_SCRIPTS, "startstage"), ("style.css", "live.css", "stage.css"), connects_to="'self'")
"""Watches a recorded match which a server releases by its clock."""


def write_replay(folder: Path, run: RunRecord | None = None) -> Path:
    """Write ``replay.html`` of a run: finished, still going on, or killed. Returns its path.

    Raises:
        RecordError: there is nothing in the folder that could be shown.
    """
    run = run or read_run(folder)
    unit_m = length_unit(*run.halves)
    frames = [frames_of(half, unit_m) for half in run.halves]
    facts = _facts(run, frames, unit_m)
    blocks = {half.info.half: packed(moving) for half, moving in zip(run.halves, frames, strict=True)}
    more = _sensor_blocks(facts, folder)
    add_logos(facts, partial(_recorded_logo, folder, run.scenario.entrants))
    path = folder / REPLAY
    with replaced(path) as file:
        file.write(page_text(facts, blocks, more).encode())
    return path


def _sensor_blocks(facts: dict[str, Any], folder: Path) -> dict[str, str]:
    """Add the facts of sensor recordings; return their blocks by id."""
    facts["sensors"] = {}
    blocks = {}
    try:
        for number, half in read_sensors(folder).items():
            blocks[f"output-{number}"] = output_block(half)
            if half.has_readings:
                facts["sensors"][str(number)] = sensor_facts(half)
                blocks[f"sensors-{number}"] = sensor_block(half)
                blocks |= picture_blocks(half)
            if half.damaged:
                which = f"{facts['period']} {number}"
                facts["problem"] += f" The sensor recording of {which} is damaged: its beginning is shown."
    except RecordError as error:
        facts["problem"] += f" {error.message}"
    except DAMAGE as error:
        facts["problem"] += f" The sensor recording is damaged and not shown: {type(error).__name__}: {error}"
        facts["sensors"], blocks = {}, {}
    facts["problem"] = facts["problem"].strip()
    return blocks


def add_logos(facts: dict[str, Any], logo_of: Callable[[str], bytes | None]) -> list[tuple[str, str]]:
    """Add the teams' logos to the facts: checked and encoded again, as addresses. Returns why others are not shown."""
    missing = []
    for team in facts["teams"]:
        try:
            if (logo := logo_of(team["name"])) is not None:
                team["logo"] = "data:image/png;base64," + base64.b64encode(checked_png(logo)).decode("ascii")
        except (LogoError, OSError) as error:
            missing.append(("logo", f"that of {team['title']} is not shown: {error}"))
    facts["about"] += missing
    return missing


def _recorded_logo(folder: Path, seats: Collection[str], team: str) -> bytes | None:
    path = logo_path(folder, team) if team in seats else None  # a damaged record may have other names
    return path.read_bytes() if path is not None and path.is_file() and path.stat().st_size <= MAX_LOGO_BYTES else None


def page_facts(scenario: Scenario, names: Mapping[str, str], unit_m: float, **more: Any) -> dict[str, Any]:
    """Return the facts of a page before the first half.

    ``names`` are the teams', by their seats of the first half; ``unit_m``: of x and y; ``more`` facts of this page.
    """
    return {
        "tick_s": TICK_S,
        **visible_things(scenario),
        # Browsers lay out very long names slowly.
        "teams": [{"name": team, "title": name[:_LONGEST_NAME]} for team, name in names.items()],
        "channels": [{"name": name, "unit": unit} for name, unit in units(unit_m).items()],
        "halves": [],
        "events": [],
        "places": [],
        "problem": "",
        **more,
    }


def _facts(run: RunRecord, frames: list[Frames], unit_m: float) -> dict[str, Any]:
    scenario, result, halves, names = run.scenario, run.result, run.halves, titles(run.scenario, run.result)
    timeline = timeline_of(scenario, halves, run.shown_log)
    return page_facts(
        scenario,
        names,
        unit_m,
        halves_planned=halves[0].info.halves,
        halves=[
            half_facts(scenario, timeline.halves[half.info.half], half.ticks, moving.jumps, _faults(half))
            for half, moving in zip(halves, frames, strict=True)
        ],
        events=EventFacts(scenario, names).of_timeline(timeline),
        places=places(scenario, result),
        complete=result.complete,
        about=about_run(result),
        problem=" ".join(run.problems),
    )


def _faults(half: HalfTrack) -> Iterator[Fault]:
    return chain.from_iterable(half.faults.values())


def places(scenario: Scenario, result: RunResult) -> list[dict[str, str]]:
    """Return the ranking with what decided it, best first; empty if the score decides alone."""
    rows = ranking_rows(scenario.result.rank, titles(scenario, result), [one.model_dump() for one in result.ranking])
    return [{"place": place, "team": team, "values": values} for place, team, values in rows]


def about_run(result: RunResult) -> list[tuple[str, str]]:
    """Return the facts of the run that stand beside the field."""
    versions = result.versions
    lines = [
        ("scenario", f"{result.title} ({result.scenario})"),
        ("played", f"{result.started[:16].replace('T', ' ')} UTC"),
        ("seed", str(result.seed)),
        ("simulated", f"{result.simulated_s:g} s"),
        ("speed", f"{result.real_time_factor:g} times real time" if result.real_time_factor else ""),
        ("marks", ", ".join(result.marks)),
        ("digest", result.digest),
        ("made with", f"rcj-challenges {versions.rcj_challenges}, MuJoCo {versions.mujoco}, {versions.python}"),
    ]
    return [(name, text) for name, text in lines if text]


# --- the file ---------------------------------------------------------------------------------------------------------


def page_text(
    facts: dict[str, Any], blocks: dict[int, str], more: Mapping[str, str] | None = None, kind: PageKind = REPLAY_PAGE
) -> str:
    """Return the page. Every part is inserted in one pass, so that no part can contain the mark of another.

    ``facts`` are JSON-able; ``blocks`` are packed poses by half, ``more`` other packed blocks by id.
    """
    viewer = files("rcj_challenges.views.replay") / "viewer"
    style = "".join((viewer / name).read_text("utf-8") for name in kind.styles)
    sources = "\n".join((viewer / f"{name}.js").read_text("utf-8") for name in kind.scripts)
    script = f'"use strict";\n(() => {{\nconst PALETTE_CSS = {inert_json(PALETTE)};\n{sources}\n}})();\n'
    parts = {
        "CSP": _policy(script, style, kind),
        "TITLE": escaped(f"{' - '.join(team['title'][:60] for team in facts['teams'])}: {facts['about'][0][1]}"),
        "STYLE": style,
        "FACTS": inert_json(facts),
        "HALVES": "\n".join(
            f'<script type="text/plain" id="{name}">{block}</script>'
            for name, block in ({f"half-{half}": block for half, block in blocks.items()} | dict(more or {})).items()
        ),
        "SCRIPT": script,
    }
    pieces = (viewer / "page.html").read_text("utf-8").split("@")
    return "".join(parts.get(piece, piece) if index % 2 else piece for index, piece in enumerate(pieces))


def _policy(script: str, style: str, kind: PageKind) -> str:
    scripts = f"'sha256-{_hash(script)}' {kind.scripts_from}".strip()
    policy = (
        f"default-src 'none'; script-src {scripts}; style-src 'sha256-{_hash(style)}'; img-src data:; "
        "base-uri 'none'; form-action 'none'"
    )
    return policy + (f"; connect-src {kind.connects_to}" if kind.connects_to else "")


def _hash(text: str) -> str:
    return base64.b64encode(hashlib.sha256(text.encode()).digest()).decode("ascii")


def inert_json(value: Any) -> str:
    r"""Return JSON that is safe inside a page: no ``<``, ``>`` or ``&`` in it, whatever the names contain.

    Half of a surrogate pair stays the escape that `json` makes of it, so the page is always UTF-8.
    """
    text = json.dumps(value, ensure_ascii=True, allow_nan=False, separators=(",", ":"))
    return text.replace("<", "\\u003c").replace(">", "\\u003e").replace("&", "\\u0026")
