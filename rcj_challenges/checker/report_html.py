"""The report as one HTML page: no network, no script, light and dark, everything from submissions escaped."""

from __future__ import annotations

import base64
import hashlib
import os
from importlib.resources import files
from pathlib import Path
from urllib.parse import quote

from jinja2 import Environment, StrictUndefined

from rcj_challenges.checker.report import (
    LEVEL_NAMES,
    ROBOT_NUMBERS,
    CheckReport,
    MatchReport,
    is_single,
    no_replay,
    summary,
    verdict,
)
from rcj_challenges.core.amounts import number_words


def html_page(report: CheckReport, folder: Path) -> str:
    """Return the page.

    Args:
        report: what to show.
        folder: where the page will lie; links to replays start from there.
    """
    package = files("rcj_challenges.checker")
    style = package.joinpath("report.css").read_text(encoding="utf-8")
    style_hash = _base64(hashlib.sha256(style.encode()).digest())
    environment = Environment(autoescape=True, trim_blocks=True, undefined=StrictUndefined)
    environment.filters["number"] = number_words
    template = environment.from_string(package.joinpath("report.html.j2").read_text(encoding="utf-8"))
    return template.render(
        report=report,
        single=is_single(report),
        style=style,
        policy=(
            f"default-src 'none'; style-src 'sha256-{style_hash}'; img-src data:; base-uri 'none'; form-action 'none'"
        ),
        words=LEVEL_NAMES,
        numbers=ROBOT_NUMBERS,
        base64=_base64,
        no_replay=no_replay,
        summary=summary,
        verdict=verdict,
        replay_link=lambda match: _replay_link(match, folder),
    )


def _replay_link(match: MatchReport, folder: Path) -> str:
    """Return a link to the replay page; empty if a page in that folder cannot lead there (another drive)."""
    if not match.replay:
        return ""
    try:
        way = Path(os.path.relpath(Path(match.replay).resolve(), folder.resolve())).as_posix()
    except ValueError:
        return ""
    return f"./{quote(way)}"


def _base64(content: bytes) -> str:
    return base64.b64encode(content).decode("ascii")
