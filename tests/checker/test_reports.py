"""The report as JSON, as HTML and on a terminal: the same findings, and nothing of a stranger's that does harm."""

from __future__ import annotations

import base64
import hashlib
import io
import json
import re
from html.parser import HTMLParser
from pathlib import Path

import jsonschema
import pytest
from hypothesis import given
from hypothesis import strategies as st
from rich.console import Console

from rcj_challenges.checker.findings import STAGES, most_serious
from rcj_challenges.checker.report import (
    ROBOT_NUMBERS,
    CheckReport,
    FileReport,
    MatchReport,
    RobotReport,
    StageReport,
    check_report,
    first_cause,
    summary,
    verdict,
)
from rcj_challenges.checker.report_html import html_page
from rcj_challenges.checker.report_text import print_report
from rcj_challenges.core.code import Code
from rcj_challenges.core.diagnostics import Diagnostic
from rcj_challenges.core.sanitize import sanitize
from scripts.write_schemas import check_text

PNG = base64.b64decode(
    "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNk+M9QDwADhgGAWjR9awAAAABJRU5ErkJggg=="
)
EVIL = sanitize("<script>alert(1)</script>\x1b[2J\u202e\"'&</style>--><img src=x onerror=y>[/bold][red]:smile:")


def finding(level="error", message="it broke", help_="mend it", where="robot.py:3:1", *, repair=False, details=""):
    return Diagnostic(
        code=Code.named("sources.syntax"),
        level=level,
        message=message,
        help=help_,
        where=where,
        repair=repair,
        details=details,
    )


def file_report(name="team.zip", findings=(), *, team="Hanse", skipped="", logo=None, matches=(), repaired=()):
    levels = [found.level for found in findings]
    stages = [
        StageReport(
            name=stage,
            about=about,
            level=most_serious(levels) if stage == "sources" else "passed",
            skipped=skipped if stage == "play" else "",
            findings=list(findings) if stage == "sources" else [],
        )
        for stage, about in STAGES.items()
    ]
    return FileReport(
        file=name,
        level=most_serious(levels),
        cause=first_cause(stages, most_serious(levels)),
        team=team,
        digest="0" * 64,
        repaired=list(repaired),
        stages=stages,
        matches=list(matches),
        wall_s=1.0,
        logo=logo,
    )


def match_report(replay="", output="", opponent="All Sensors"):
    robot = RobotReport(
        robot="B1", path_m=1.0, turned_rad=2.0, ball_touches=3, steps=313, start_s=0.2, step_mean_ms=0.1,
        step_slowest_ms=4.0, fault="crash", output=output,
    )  # fmt: skip
    return MatchReport(
        seats=["blue"], opponents={"yellow": opponent}, score={"blue": 1, "yellow": 0}, simulated_s=10.016,
        wall_s=0.7, layers=["clean_environment"], replay=replay, robots=[robot],
    )  # fmt: skip


def report(*files):
    return check_report("match", "SoccerSim match", "auto", list(files))


def printed(made, width=80, *, terminal=False):
    stream = io.StringIO()
    print_report(Console(file=stream, width=width, force_terminal=terminal, color_system=None), made)
    return stream.getvalue()


@pytest.mark.parametrize("width", [40, 80])
def test_on_a_terminal_of_any_width_each_number_of_a_robot_can_be_read(width):
    made = report(file_report(matches=[match_report()]))
    lines = printed(made, width, terminal=True).splitlines()
    shown = " ".join(" ".join(lines).split())
    robot = made.files[0].matches[0].robots[0]
    assert "B1" in shown
    assert "…" not in shown
    assert [
        name for name, number_of in ROBOT_NUMBERS.items() if name not in shown or number_of(robot) not in shown
    ] == []
    assert "crash" in shown
    assert max(map(len, lines)) <= width


def test_the_committed_schema_is_fresh():
    committed = Path(__file__).parents[2] / "schemas" / "check.schema.json"
    assert committed.read_text("utf-8") == check_text()


def test_every_report_matches_the_schema_and_can_be_read_back():
    made = report(file_report(findings=[finding()], logo=PNG, matches=[match_report()]), file_report("other.zip"))
    data = json.loads(json.dumps(made.model_dump(mode="json")))
    jsonschema.validate(data, json.loads(check_text()))
    assert CheckReport.model_validate(data).summary == made.summary
    assert "logo" not in data["files"][0]


def test_the_exit_code_is_that_of_the_most_serious_verdict():
    good, warned, bad = (file_report(findings=[finding(level)]) for level in ("passed", "warning", "error"))
    assert [report(good).exit_code, report(good, warned).exit_code, report(bad, good).exit_code] == [0, 0, 1]
    counts = {"files": 4, "passed": 1, "warning": 1, "error": 2, "unchecked": 0}
    assert report(good, warned, bad, bad).summary.model_dump() == counts
    assert summary(report(good, bad)) == "2 submissions: 1 ok, 0 warnings, 1 error"


@pytest.mark.parametrize(
    ("findings", "skipped", "expected"),
    [
        ([], "", "It will play."),
        ([finding("warning")], "", "It will play, 1 warning."),
        ([finding("warning", repair=True)], "", "It will play, 1 warning; --fix OUT.zip repairs this."),
        ([], "not asked for", "In order as far as it was checked."),
        ([finding("warning"), finding()], "", "It cannot play like this: 1 error, 1 warning. First: mend it"),
        (
            [finding(repair=True), finding()],
            "",
            "It cannot play like this: 2 errors; --fix OUT.zip repairs part of this. First: mend it",
        ),
    ],
)
def test_the_verdict_states_whether_it_plays_and_what_a_repair_would_fix(findings, skipped, expected):
    assert verdict(file_report(findings=findings, skipped=skipped)) == expected


def test_a_terminal_shows_stages_findings_help_and_details():
    made = report(
        file_report(
            findings=[finding(details="Traceback\n  line 3")],
            matches=[match_report(output="hello\nworld", replay="r/a.html")],
            repaired=["took out the extra top folder"],
        )
    )
    lines = printed(made).splitlines()
    assert lines[0] == "team.zip  Hanse"
    assert "         repaired: took out the extra top folder" in lines
    assert "error    sources: the programs are valid Python and can run here" in lines
    assert "         robot.py:3:1: it broke" in lines
    assert "         → mend it" in lines
    assert "             line 3" in lines
    assert "         watch: r/a.html" in lines
    assert "B1 | world" in lines
    assert any(line.startswith("         B1: driven 1.00 m") and line.endswith(", crash") for line in lines)


def test_many_submissions_end_with_a_table_and_a_summary():
    made = printed(report(file_report("good.zip"), file_report("bad.zip", [finding()])))
    table = made[made.index("SoccerSim match") :]
    assert "It will play" not in made  # what is in order is only in the table
    assert re.search(r"good\.zip .* Hanse .* ok", table)
    assert re.search(r"bad\.zip .* error .* robot\.py:3:1: it broke", table)
    assert table.rstrip().endswith("2 submissions: 1 ok, 0 warnings, 1 error")


def test_names_of_strangers_do_no_harm_on_a_terminal():
    made = report(
        file_report(
            EVIL,
            [finding(message=EVIL, help_=EVIL, where=EVIL)],
            team=EVIL,
            matches=[match_report(output=EVIL, opponent=EVIL)],
        )
    )
    text = printed(made, 400)
    assert "\x1b" not in text
    assert "\u202e" not in text
    assert text.count("[/bold][red]:smile:") > 5  # rich takes no word in brackets for its markup


class _Tags(HTMLParser):
    def __init__(self):
        super().__init__(convert_charrefs=True)
        self.tags, self.open, self.text, self.attributes = [], [], [], []

    def handle_starttag(self, tag, attrs):
        self.tags.append(tag)
        self.attributes += [(tag, *pair) for pair in attrs]
        if tag not in ("meta", "img", "br"):
            self.open.append(tag)

    def handle_endtag(self, tag):
        assert self.open.pop() == tag

    def handle_data(self, data):
        self.text.append(data)


def parsed(page):
    tags = _Tags()
    tags.feed(page)
    assert tags.open == []
    return tags


TAGS = {
    "html", "head", "meta", "title", "style", "body", "h1", "h2", "p", "div", "table", "thead", "tbody", "tr", "th", "td",
    "a", "span", "bdi", "code", "article", "header", "ul", "ol", "li", "strong", "br", "pre", "caption", "details",
    "summary", "img",
}  # fmt: skip


def test_the_page_is_whole_and_loads_nothing(tmp_path):
    made = report(file_report(findings=[finding(details="x\ny")], logo=PNG, matches=[match_report(output="hi")]))
    page = html_page(made, tmp_path)
    tags = parsed(page)
    assert set(tags.tags) <= TAGS
    links = [value for _, key, value in tags.attributes if key in ("src", "href")]
    assert all(link.startswith(("data:image/png;base64,", "#")) for link in links)
    policy = next(value for tag, key, value in tags.attributes if tag == "meta" and key == "content")
    assert policy.startswith("default-src 'none'; style-src 'sha256-")
    assert "unsafe" not in policy
    style = page.partition("<style>")[2].partition("</style>")[0]
    assert base64.b64encode(hashlib.sha256(style.encode()).digest()).decode() in policy
    assert all(word in page for word in ("it broke", "mend it", "crash", "prefers-color-scheme: dark"))
    badges = {value for _, key, value in tags.attributes if key == "class" and value.startswith("badge ")}
    assert all(f".{name}" in style for badge in badges for name in badge.split()), "each has its colours"


def test_names_of_strangers_do_no_harm_in_the_page(tmp_path):
    made = report(
        file_report(
            EVIL,
            [finding(message=EVIL, help_=EVIL, where=EVIL, details=EVIL)],
            team=EVIL,
            matches=[match_report(output=EVIL, opponent=EVIL)],
            repaired=[EVIL],
        ),
        file_report(EVIL, team=EVIL),
    )
    tags = parsed(html_page(made, tmp_path))
    assert set(tags.tags) <= TAGS - {"img"}
    assert "".join(tags.text).count("<script>alert(1)</script>") > 8


@given(st.text(max_size=60))
def test_whatever_a_team_is_called_the_page_stays_whole(name):
    safe = sanitize(name)
    made = report(file_report(safe, [finding(message=safe, where=safe)], team=safe))
    tags = parsed(html_page(made, Path()))
    assert set(tags.tags) <= TAGS - {"img"}


@pytest.mark.parametrize("name", ["a b.html", "100%.html", "#1?x=2.html", "ü.html"])
def test_the_page_links_to_replays_wherever_they_lie(tmp_path, name):
    replay = tmp_path / "replays" / name
    made = report(file_report(matches=[match_report(replay=str(replay))]))
    tags = parsed(html_page(made, tmp_path / "pages"))
    (link,) = [value for _, key, value in tags.attributes if key == "href"]
    assert link.startswith("./../replays/")
    assert not set(link) & set(" #?\"'<>")
    from urllib.parse import unquote

    assert (tmp_path / "pages" / unquote(link)).resolve() == replay.resolve()
