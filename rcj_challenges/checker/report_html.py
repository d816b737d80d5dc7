"""The report as one HTML page: no network, no script, light and dark, everything of strangers escaped."""

from __future__ import annotations

import base64
import hashlib
import html
import os
from importlib.resources import files
from pathlib import Path
from urllib.parse import quote

from rcj_challenges.checker.findings import Level
from rcj_challenges.checker.report import (
    ROBOT_NUMBERS,
    CheckReport,
    FileReport,
    FindingReport,
    MatchReport,
    StageReport,
)
from rcj_challenges.checker.report_text import WORDS, first_finding, is_single, no_replay, summary, verdict
from rcj_challenges.controllers.disk_names import from_disk, on_disk
from rcj_challenges.facts.measures import number_words


def html_page(report: CheckReport, folder: Path) -> str:
    """Return the page.

    Args:
        report: what is told.
        folder: where the page will lie; links to replays start from there.
    """
    style = files("rcj_challenges.checker").joinpath("report.css").read_text(encoding="utf-8")
    policy = (
        f"default-src 'none'; style-src 'sha256-{_hash(style)}'; img-src data:; base-uri 'none'; form-action 'none'"
    )
    single = is_single(report)
    title = f"Check for {report.title}" if not single else f"{report.files[0].file}: check for {report.title}"
    parts = [
        "<!doctype html>",
        '<html lang="en">',
        "<head>",
        '<meta charset="utf-8">',
        f'<meta http-equiv="Content-Security-Policy" content="{html.escape(policy)}">',
        '<meta name="viewport" content="width=device-width, initial-scale=1">',
        '<meta name="referrer" content="no-referrer">',
        f"<title>{_text(title)}</title>",
        f"<style>{style}</style>",
        "</head>",
        "<body>",
        f"<h1>Check for {_shown(report.title)}</h1>",
        "" if single else f'<p class="quiet">{_text(summary(report))}</p>{_table(report)}',
        _left_out(report),
        *(_file(file, number, folder) for number, file in enumerate(report.files, 1)),
        f'<p class="quiet">Isolation: {_text(report.sandbox)}. Times are those of the computer that checked.</p>',
        "</body>",
        "</html>",
    ]
    return "\n".join(part for part in parts if part) + "\n"


def _table(report: CheckReport) -> str:
    rows = []
    for number, file in enumerate(report.files, 1):
        first = first_finding(file)
        told = _shown(file.hindrance) if first is None else _where(first) + _shown(first.message)
        rows.append(
            f'<tr><td><a href="#file-{number}">{_shown(file.file)}</a></td><td>{_shown(file.team)}</td>'
            f"<td>{_badge(file.level)}</td><td>{told}</td></tr>"
        )
    head = "<tr><th>file</th><th>team</th><th>verdict</th><th>first thing to do</th></tr>"
    return f'<div class="scroll"><table><thead>{head}</thead><tbody>{"".join(rows)}</tbody></table></div>'


def _left_out(report: CheckReport) -> str:
    """Return what was not looked at, and why."""
    if not report.left_out:
        return ""
    listed = "".join(
        f"<li><code><bdi>{_text(other.file)}</bdi></code>: {_shown(other.reason)}</li>" for other in report.left_out
    )
    return f"<p>Not looked at:</p><ul>{listed}</ul>"


def _file(file: FileReport, number: int, folder: Path) -> str:
    logo = "" if file.logo is None else f'<img alt="" src="data:image/png;base64,{_base64(file.logo)}">'
    team = f'<p class="quiet">{_shown(file.team)}</p>' if file.team else ""
    repaired = "".join(f"<li>{_shown(line)}</li>" for line in file.repaired)
    return "\n".join(
        part
        for part in (
            f'<article id="file-{number}">',
            f"<header>{logo}<div><h2>{_shown(file.file)}</h2>{team}</div>{_badge(file.level)}</header>",
            f"<p>{_text(verdict(file))}</p>",
            f"<p>Repaired:</p><ul>{repaired}</ul>" if repaired else "",
            f'<ol class="stages">{"".join(map(_stage, file.stages))}</ol>',
            *(_output(robot, " at its start", output) for robot, output in file.started.items()),
            *(_match(match, folder) for match in file.matches),
            f'<p class="quiet">Files: <code>{_text(file.digest[:16])}</code></p>' if file.digest else "",
            "</article>",
        )
        if part
    )


def _stage(stage: StageReport) -> str:
    if stage.skipped:
        badge = '<span class="badge skipped">skipped</span>'
        told = f'<div class="quiet">{_text(stage.name)}: {_text(stage.skipped)}</div>'
        return f'<li><div class="stage"><div>{badge}</div>{told}</div></li>'
    findings = "".join(map(_finding, stage.findings))
    head = f"{_badge(stage.level)}</div><div><strong>{_text(stage.name)}</strong>: {_text(stage.about)}"
    listed = f'<ul class="findings">{findings}</ul>' if findings else ""
    return f'<li><div class="stage"><div>{head}</div></div>{listed}</li>'


def _finding(finding: FindingReport) -> str:
    remedy = f"<br><strong>→ {_shown(finding.remedy)}</strong>" if finding.remedy else ""
    repair = (
        '<br><span class="quiet">--fix puts this right</span>' if finding.repair and finding.level != "passed" else ""
    )
    details = f"<pre>{_text(finding.details)}</pre>" if finding.details else ""
    told = f"{_where(finding)}{_shown(finding.message)}"
    return f'<li class="is-{_text(finding.level)}">{told}{remedy}{repair}{details}</li>'


def _match(match: MatchReport, folder: Path) -> str:
    against = "".join(f" against {_shown(name)}" for name in match.opponents.values())
    score = " : ".join(map(number_words, match.score.values()))
    seats = _text(", ".join(match.seats))
    caption = f"as {seats}{against}, {match.simulated_s:.0f} s, score {_text(score)}"
    head = "".join(f'<th class="number">{column}</th>' for column in ROBOT_NUMBERS)
    rows = []
    for robot in match.robots:
        fault = f'<span class="badge failure">{_text(robot.fault)}</span>' if robot.fault else ""
        numbers = "".join(f'<td class="number">{number_of(robot)}</td>' for number_of in ROBOT_NUMBERS.values())
        rows.append(f"<tr><td>{_text(robot.robot)}</td>{numbers}<td>{fault}</td></tr>")
    outputs = "".join(_output(robot.robot, "", robot.output) for robot in match.robots)
    return (
        f'<div class="scroll"><table><caption>{caption}</caption><thead><tr><th>robot</th>{head}<th></th></tr></thead>'
        f"<tbody>{''.join(rows)}</tbody></table></div>{_replay(match, folder)}{outputs}"
    )


def _output(robot: str, when: str, output: str) -> str:
    if not output:
        return ""
    return f"<details><summary>What {_text(robot)} printed{when}</summary><pre>{_text(output)}</pre></details>"


def _replay(match: MatchReport, folder: Path) -> str:
    """Return a link to the replay page; nothing if a page in that folder cannot lead there (another drive)."""
    if match.no_replay:
        return f'<p class="quiet">{_shown(no_replay(match))}</p>'
    if not match.replay:
        return ""
    try:
        way = Path(os.path.relpath(Path(on_disk(match.replay)).resolve(), folder.resolve())).as_posix()
    except ValueError:
        return ""
    return f'<p><a href="./{_text(quote(from_disk(way)))}">Watch this match</a></p>'


def _where(finding: FindingReport) -> str:
    needless = not finding.where or finding.where in finding.message
    return "" if needless else f"<code><bdi>{_text(finding.where)}</bdi></code>: "


def _badge(level: Level) -> str:
    return f'<span class="badge {level}">{WORDS[level]}</span>'


def _shown(text: str) -> str:
    """Return text of strangers: its direction stays its own."""
    return f"<bdi>{_text(text)}</bdi>"


def _text(text: str) -> str:
    return html.escape(text)


def _hash(text: str) -> str:
    return base64.b64encode(hashlib.sha256(text.encode()).digest()).decode("ascii")


def _base64(content: bytes) -> str:
    return base64.b64encode(content).decode("ascii")
