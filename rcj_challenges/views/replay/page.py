"""Putting the page together: facts, poses and viewer in one file that needs nothing else."""

from __future__ import annotations

import base64
import hashlib
import html
import json
from importlib.resources import files
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from rcj_challenges.facts.timing import TICK_S
from rcj_challenges.records.errors import RecordError
from rcj_challenges.records.folder import REPLAY, SCENARIO, replaced
from rcj_challenges.records.result import RunResult, read_result
from rcj_challenges.records.trajectory import HalfTrack, Trajectory
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.views.replay.packing import (
    HEIGHT_M,
    TILT_RAD,
    TURN_RAD,
    Frames,
    frames_of,
    length_unit,
    packed,
)
from rcj_challenges.views.replay.story import Story, tell
from rcj_challenges.views.replay.things import visible_things

SCRIPTS = (
    "element", "maths", "colours", "recording", "embedded", "mesh", "ground", "bodies", "painter", "scene", "flat",
    "camera", "hands", "labels", "board", "player", "deck", "eventlist", "robotlist", "panels", "app", "start",
)  # fmt: skip
"""The parts of the viewer in the order in which they are joined: what is used stands before what uses it."""

_LONGEST_DETAIL = 10_000


def write_replay(folder: Path) -> Path:
    """Write ``replay.html`` of a run: finished, still going on, or killed. Returns its path.

    Raises:
        RecordError: there is nothing in the folder that could be shown.
    """
    result = read_result(folder)
    scenario = _read_scenario(folder)
    halves = [half for half in Trajectory.open(folder).halves if half.ticks]
    if not halves:
        raise RecordError(f"{folder.name}: the run was stopped before its first tick: there is nothing to show")
    story = tell(folder, scenario, halves, result)
    unit_m = length_unit(*halves)
    frames = [frames_of(half, unit_m) for half in halves]
    facts = _facts(result, scenario, halves, frames, story, unit_m)
    blocks = {half.info.half: packed(moving) for half, moving in zip(halves, frames, strict=True)}
    path = folder / REPLAY
    with replaced(path) as file:
        file.write(_page(facts, blocks).encode())
    return path


def _read_scenario(folder: Path) -> Scenario:
    try:
        return Scenario.model_validate_json((folder / SCENARIO).read_bytes())
    except FileNotFoundError:
        raise RecordError(f"{folder.name}: {SCENARIO} is missing") from None
    except (OSError, ValidationError) as error:
        raise RecordError(f"{folder.name}: {SCENARIO} is damaged: it is not the scenario of a run") from error


def _facts(
    result: RunResult,
    scenario: Scenario,
    halves: list[HalfTrack],
    frames: list[Frames],
    story: Story,
    unit_m: float,
) -> dict[str, Any]:
    units = {"x": unit_m, "y": unit_m, "yaw": TURN_RAD, "z": HEIGHT_M, "tilt": TILT_RAD}
    return {
        "tick_s": TICK_S,
        **visible_things(scenario),
        "teams": [{"name": team, "title": entrant.name or team} for team, entrant in result.entrants.items()],
        "halves_planned": halves[0].info.halves,
        "channels": [{"name": name, "unit": units[name]} for name in frames[0].columns],
        "halves": [_half(half, moving, story) for half, moving in zip(halves, frames, strict=True)],
        "events": story.events,
        "about": _about(result),
        "problem": _problem(result, story),
    }


def _half(half: HalfTrack, frames: Frames, story: Story) -> dict[str, Any]:
    info = half.info
    faults = [fault for faults in half.faults.values() for fault in faults]
    return {
        "half": info.half,
        "ticks": half.ticks,
        "planned_ticks": info.ticks,
        "sides": info.teams,
        "scores": {info.teams[seat]: points for seat, points in info.scores.items()},
        "score_changes": story.score_changes[info.half],
        "phases": story.phases[info.half],
        "jumps": [list(ticks) for ticks in frames.jumps],
        "faults": [
            {"robot": fault.robot, "tick": fault.tick, "kind": fault.kind, "detail": fault.detail[:_LONGEST_DETAIL]}
            for fault in faults
        ],
    }


def _about(result: RunResult) -> list[tuple[str, str]]:
    """Return what is said of the run beside the field."""
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


def _problem(result: RunResult, story: Story) -> str:
    """Return the sentence of warning above the field, or nothing."""
    problems = []
    if not result.complete:
        why = f" ({result.stopped})" if result.stopped else ""
        problems.append(f"This run was not played to its end{why}: what was recorded is shown.")
    if story.unreadable:
        problems.append(f"{story.unreadable} lines of the referee's log are damaged and left out.")
    return " ".join(problems)


# --- the file ---------------------------------------------------------------------------------------------------------


def _page(facts: dict[str, Any], blocks: dict[int, str]) -> str:
    """Return the page. Every part is put in once, in one pass: no part can smuggle in another's mark."""
    viewer = files("rcj_challenges.views.replay") / "viewer"
    style = (viewer / "style.css").read_text("utf-8")
    script = _script({name: (viewer / f"{name}.js").read_text("utf-8") for name in SCRIPTS})
    parts = {
        "CSP": _policy(script, style),
        "TITLE": html.escape(_title(facts)),
        "STYLE": style,
        "FACTS": inert_json(facts),
        "HALVES": "\n".join(
            f'<script type="text/plain" id="half-{half}">{block}</script>' for half, block in blocks.items()
        ),
        "SCRIPT": script,
    }
    frame = (viewer / "page.html").read_text("utf-8")
    pieces = frame.split("@")
    return "".join(parts.get(piece, piece) if index % 2 else piece for index, piece in enumerate(pieces))


def _script(sources: dict[str, str]) -> str:
    joined = "\n".join(sources[name] for name in SCRIPTS)
    return f'"use strict";\n(() => {{\n{joined}\n}})();\n'


def _policy(script: str, style: str) -> str:
    """Return a policy under which only this script and this style run, and nothing is loaded from anywhere."""
    return (
        f"default-src 'none'; script-src 'sha256-{_hash(script)}'; style-src 'sha256-{_hash(style)}'; img-src data:; "
        "base-uri 'none'; form-action 'none'"
    )


def _hash(text: str) -> str:
    return base64.b64encode(hashlib.sha256(text.encode()).digest()).decode("ascii")


def _title(facts: dict[str, Any]) -> str:
    names = " - ".join(team["title"][:60] for team in facts["teams"])
    return f"{names}: {facts['about'][0][1]}"


def inert_json(value: Any) -> str:
    r"""Return JSON that is safe inside a page: no ``<``, ``>`` or ``&`` in it, whatever the names contain.

    Half of a surrogate pair stays the escape that `json` makes of it, so the page is always UTF-8.
    """
    text = json.dumps(value, ensure_ascii=True, allow_nan=False, separators=(",", ":"))
    return text.replace("<", "\\u003c").replace(">", "\\u003e").replace("&", "\\u0026")
