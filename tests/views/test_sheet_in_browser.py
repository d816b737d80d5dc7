"""The rule sheet in a real browser: on a phone, and on paper."""

import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from rcj_challenges.scenario.load import load
from rcj_challenges.scenario.resources import SCENARIOS_FOLDER, names_in
from rcj_challenges.views.sheet import sheet_html

PRINTED = (*names_in(SCENARIOS_FOLDER / "examples"), "match")
PHONE = {"width": 360, "height": 740}


@pytest.fixture
def sheet_of(watch: Callable[..., Any], tmp_path: Path) -> Callable[..., Any]:
    """Opens the rule sheet of a shipped scenario."""

    def open_sheet(name: str, viewport: dict[str, int]) -> Any:
        loaded = load(name)
        file = tmp_path / f"{name}.html"
        file.write_text(sheet_html(loaded.scenario, loaded.roster), encoding="utf-8")
        return watch(file.as_uri(), ready="table", viewport=viewport)

    return open_sheet


@pytest.mark.parametrize("name", ["match", "pass_the_ball"])
def test_on_a_phone_text_stays_on_the_screen_and_wide_tables_are_scrolled_alone(
    name: str, sheet_of: Callable[..., Any]
) -> None:
    page = sheet_of(name, PHONE)
    assert page.evaluate("document.documentElement.scrollWidth") <= PHONE["width"]
    # What is wider than the screen can be brought there: the end of the longest row.
    end = page.evaluate(
        """() => {
          const wide = [...document.querySelectorAll("table")].sort((a, b) => b.scrollWidth - a.scrollWidth)[0];
          if (wide.scrollWidth <= wide.clientWidth) return "no table is wide";
          wide.scrollLeft = wide.scrollWidth;
          const cell = [...wide.querySelectorAll("td:last-child")].at(-1).getBoundingClientRect();
          return cell.right;
        }"""
    )
    assert end == pytest.approx(PHONE["width"] - 16, abs=2)


def test_on_a_phone_the_field_fills_the_screen_and_its_legend_is_below(sheet_of: Callable[..., Any]) -> None:
    page = sheet_of("match", PHONE)
    field, legend = (
        page.evaluate(f"(() => {{ const box = document.querySelector('{one}').getBoundingClientRect(); "
                      "return [box.width, box.top, box.bottom]; })()")
        for one in ("figure > svg", ".legend")
    )  # fmt: skip
    assert field[0] > 0.9 * PHONE["width"]
    assert legend[1] >= field[2]
    assert page.evaluate("parseFloat(getComputedStyle(document.querySelector('.legend')).fontSize)") >= 12


@pytest.mark.parametrize("name", PRINTED)
def test_players_need_two_pages_of_paper_and_so_does_the_appendix(name: str, sheet_of: Callable[..., Any]) -> None:
    page = sheet_of(name, {"width": 700, "height": 1000})
    page.emulate_media(media="print")
    sizes = """[...document.querySelectorAll("body, body :not(svg, svg *, style)")]
               .map(one => parseFloat(getComputedStyle(one).fontSize))"""
    assert min(page.evaluate(sizes)) >= 10 * 96 / 72 - 0.01
    # The numbers in the drawing are at least 7 points high: 13 units of its width.
    assert (
        page.evaluate("document.querySelector('figure > svg').getBoundingClientRect().width") * 13 / 477 >= 7 * 96 / 72
    )
    both = _pages_a4(page)
    page.evaluate("document.querySelector('.appendix').remove()")
    assert _pages_a4(page) <= 2
    assert both - _pages_a4(page) <= 2


def _pages_a4(page: Any) -> int:
    """Return the number of pages that are printed, all in A4."""
    boxes = re.findall(rb"/MediaBox \[0 0 ([0-9.]+) ([0-9.]+)\]", page.pdf(prefer_css_page_size=True))
    assert {(round(float(width)), round(float(height))) for width, height in boxes} == {(595, 842)}
    return len(boxes)
