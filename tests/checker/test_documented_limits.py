"""The figures that teams read are those of a match."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from rcj_challenges.scenario.load import load

PAGE = (Path(__file__).parents[2] / "docs" / "programs.md").read_text(encoding="utf-8")
UNITS = {"s": 1, "MB": 1, "GB": 1024, "": 1}


@pytest.mark.parametrize(
    ("what", "limit", "scale"),
    [
        ("from the start of the program to its first `step`", "start_s", 1),
        ("from the end of one `step` to the next", "step_s", 1),
        ("all steps of a half together", "half_s", 1),
        ("memory", "memory_mb", 1),
        ("output", "output_mb", 1),
        ("files written into the program's own folder", "scratch_mb", 1),
        ("threads", "processes", 1),
        ("one radio packet", "message_kb", 1024),
    ],
)
def test_limits_match_the_page_for_programs(what, limit, scale):
    amount, unit = re.search(rf"^\| {re.escape(what)} \| (\d+) ?(s|MB|GB|)\b", PAGE, re.MULTILINE).groups()
    assert int(amount) * UNITS[unit] * scale == getattr(load("match").scenario.limits, limit)


def test_the_page_for_programs_describes_text_messages():
    (override,) = set(re.findall(r"--set (kits\.v2\.messages=v2\.2)", PAGE))
    assert load("match", [override]).scenario.kits["v2"].messages == "v2.2"
    assert "kits: {v2: {messages: v2.2}}" in PAGE
