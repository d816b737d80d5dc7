"""Small pictures as SVG without any style of their own: the style sheet colours them, also in dark mode."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from html import escape
from itertools import cycle
from statistics import median

from markupsafe import Markup

from rcj_challenges.core.amounts import number_words
from rcj_challenges.tournament.site.render import fitted

_WIDTH = 360
_MAX_LABEL_CHARACTERS = 16
_MAX_TICKS_Y = 5


def score_plot(
    names: Sequence[str], halves: Sequence[tuple[float, Sequence[tuple[float, Sequence[float]]]]], period: str
) -> Markup:
    """Return a picture of the score of two sides over time.

    Each half has its length in s, and (time in s, scores of both sides) from each change on; the first at 0.
    """
    total_s = sum(length_s for length_s, _ in halves) or 1
    most = max((score for _, changes in halves for _, scores in changes for score in scores), default=0)
    least = min((score for _, changes in halves for _, scores in changes for score in scores), default=0)
    least, most = min(0.0, least), max(1.0, most)
    left, right, top, bottom = 26, _WIDTH - 8, 10, 110

    def x(at_s: float) -> float:
        return left + (right - left) * at_s / total_s

    def y(score: float) -> float:
        return bottom - (bottom - top) * (score - least) / (most - least)

    parts = []
    for tick in _ticks(least, most, 1.0):
        parts.append(f'<line class="grid" x1="{left}" x2="{right}" y1="{y(tick):.1f}" y2="{y(tick):.1f}"/>')
        parts.append(f'<text class="axis" x="{left - 5}" y="{y(tick) + 3.5:.1f}" text-anchor="end">{tick:g}</text>')
    begin_s = 0.0
    for number, (length_s, _) in enumerate(halves, 1):
        if number > 1:
            parts.append(
                f'<line class="cut" x1="{x(begin_s):.1f}" x2="{x(begin_s):.1f}" y1="{top - 4}" y2="{bottom}"/>'
            )
        middle = x(begin_s + length_s / 2)
        label = escape(f"{period} {number}")
        parts.append(f'<text class="axis" x="{middle:.1f}" y="{bottom + 15}" text-anchor="middle">{label}</text>')
        begin_s += length_s
    for side in range(len(names)):
        path, begin_s = "", 0.0
        for length_s, changes in halves:
            for at_s, scores in changes:
                step = f"H{x(begin_s + at_s):.1f}V{y(scores[side]):.1f}"
                path = path + step if path else f"M{x(begin_s + at_s):.1f} {y(scores[side]):.1f}"
            begin_s += length_s
        parts.append(f'<path class="line side-{side}" d="{path}H{right:.1f}"/>')
    about = "Score of " + " and ".join(names) + " over the match"
    return _picture("".join(parts), _WIDTH, bottom + 22, about)


def form_plot(results: Sequence[tuple[str, float]]) -> Markup:
    """Return goal differences by match (title, difference): bars up for won ones, down for lost ones."""
    most = max((abs(difference) for _, difference in results), default=1) or 1
    wide = min(18.0, (_WIDTH - 8) / max(1, len(results)))
    middle, reach = 44, 36
    parts = [f'<line class="grid" x1="0" x2="{_WIDTH}" y1="{middle}" y2="{middle}"/>']
    for at, (title, difference) in enumerate(results):
        tall = max(3.0, reach * abs(difference) / most)
        top = middle - tall if difference > 0 else middle if difference < 0 else middle - 1.5
        kind = "won" if difference > 0 else "lost" if difference < 0 else "drawn"
        parts.append(
            f'<rect class="{kind}" x="{4 + at * wide:.1f}" y="{top:.1f}" width="{wide * 0.8:.1f}" height="{tall:.1f}" '
            f'rx="2"><title>{escape(title)}: {difference:+g}</title></rect>'
        )
    return _picture("".join(parts), _WIDTH, 2 * middle, "Goal differences, oldest match first")


def distribution_plot(values: Mapping[str, Sequence[float]], unit: str) -> Markup:
    """Return the values of each team, in the order of the ranking, on one axis, with a mark at the median."""
    every = [value for several in values.values() for value in several]
    low, high = min(every, default=0.0), max(every, default=1.0)
    if low == high:
        low, high = low - 1, high + 1
    left, right, row, top = 122, _WIDTH - 12, 22, 8

    def x(value: float) -> float:
        return left + (right - left) * (value - low) / (high - low)

    bottom = top + row * len(values)
    parts = []
    for tick in _ticks(low, high):
        parts.append(f'<line class="grid" x1="{x(tick):.1f}" x2="{x(tick):.1f}" y1="{top}" y2="{bottom}"/>')
        parts.append(
            f'<text class="axis" x="{x(tick):.1f}" y="{bottom + 14}" text-anchor="middle">{number_words(tick)}</text>'
        )
    for at, (name, several) in enumerate(values.items()):
        y = top + row * (at + 0.5)
        parts.append(
            f'<text class="name" x="{left - 8}" y="{y + 4:.1f}" text-anchor="end">'
            f"{escape(fitted(name, _MAX_LABEL_CHARACTERS))}</text>"
        )
        parts += [
            f'<circle class="dot" cx="{x(value):.1f}" cy="{y:.1f}" r="4">'
            f"<title>{escape(name)}: {number_words(value, 3)}</title></circle>"
            for value in several
        ]
        if len(several) > 1:
            at_median = x(median(several))
            parts.append(
                f'<line class="median" x1="{at_median:.1f}" x2="{at_median:.1f}" y1="{y - 8:.1f}" y2="{y + 8:.1f}"/>'
            )
    parts.append(
        f'<text class="axis" x="{right}" y="{bottom + 28}" text-anchor="end">{escape(unit)}; line: median</text>'
    )
    return _picture("".join(parts), _WIDTH, bottom + 34, f"Distribution of {unit} by team")


def _picture(content: str, wide: float, tall: float, about: str) -> Markup:
    return Markup(  # noqa: S704 - every text in it was escaped above
        f'<svg class="plot" viewBox="0 0 {wide:g} {tall:g}" role="img" aria-label="{escape(about)}">{content}</svg>'
    )


def _ticks(low: float, high: float, least_step: float = 1e-6) -> list[float]:
    """Return up to `_MAX_TICKS_Y` round numbers of a range; ``least_step`` is a power of ten."""
    step, factors = least_step, cycle((2, 2.5, 2))
    while (high - low) / step > _MAX_TICKS_Y - 1:
        step *= next(factors)
    first = -(-low // step)
    ticks: list[float] = []
    while (first + len(ticks)) * step <= high + step * 1e-6:
        ticks.append(round((first + len(ticks)) * step, 9))
    return ticks
