"""The rule sheet in a real browser: on a phone, and on paper."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from rcj_challenges.scenario.load import load
from rcj_challenges.views.sheet import sheet_html

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


def test_players_need_two_pages_of_paper(sheet_of: Callable[..., Any]) -> None:
    width, height = 680, 1009  # of A4 inside its margins, in CSS pixels
    page = sheet_of("match", {"width": width, "height": height})
    page.emulate_media(media="print")
    assert page.evaluate("document.querySelector('.appendix').getBoundingClientRect().top") < 2 * height
    assert page.evaluate("getComputedStyle(document.querySelector('.appendix')).breakBefore") == "page"
    # The numbers in the drawing are at least 7 points high: 13 units of its width.
    assert (
        page.evaluate("document.querySelector('figure > svg').getBoundingClientRect().width") * 13 / 477 >= 7 * 96 / 72
    )
