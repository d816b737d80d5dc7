"""A knock-out as a picture: rounds from left to right, SVG for screens and for A4 paper."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from html import escape
from itertools import pairwise

from markupsafe import Markup

from rcj_challenges.core.amounts import number_words
from rcj_challenges.core.grouping import grouped
from rcj_challenges.tournament.season import Tie
from rcj_challenges.tournament.site.render import fitted

_BOX_WIDTH, _BOX_HEIGHT, _GAP_X, _GAP_Y, _HEAD = 196, 46, 36, 18, 34
_CHARACTERS, _CHARACTERS_WITHOUT_SCORE = 22, 25
_THIRD_PLACE = "third_place"

PRINT_STYLE = """
.bracket text{font:13px system-ui,"Noto Sans","Noto Sans CJK SC",sans-serif;fill:#16202b}
.bracket .head{font-weight:700;fill:#5b6876}
.bracket .box{fill:#fff;stroke:#9aa7b4}
.bracket .rule{stroke:#d5dce3}
.bracket .join{fill:none;stroke:#9aa7b4;stroke-width:1.5}
.bracket .winner{font-weight:700}
.bracket .open{fill:#5b6876;font-style:italic}
.bracket .note{font-size:10px;fill:#5b6876}
"""
"""For a bracket that stands alone: dark on white."""


@dataclass(frozen=True, slots=True)
class _Placed:
    tie: Tie
    x: float
    y: float


def bracket_svg(
    ties: tuple[Tie, ...], name: Callable[[str], str], title: str, links: Mapping[str, str], *, alone: bool = False
) -> Markup:
    """Return the bracket; a picture that stands ``alone`` is a file of its own, with its style in it."""
    trees = grouped((tie.tree, tie) for tie in ties if tie.round != _THIRD_PLACE)
    placed: list[_Placed] = []
    parts: list[str] = []
    bottom = 0.0
    for tree in trees.values():
        own = _placed(tree, bottom + _HEAD)
        for x, head in {one.x: escape(one.tie.round_title) for one in own}.items():
            parts.append(f'<text class="head" x="{x:g}" y="{bottom + 18:g}">{head}</text>')
        parts += _joins(own)
        bottom = max(one.y + _BOX_HEIGHT for one in own) + _GAP_Y
        placed += own
    bottom = max(bottom - _GAP_Y, _HEAD)
    right = max((one.x + _BOX_WIDTH for one in placed), default=_BOX_WIDTH)
    for third in (tie for tie in ties if tie.round == _THIRD_PLACE):
        last_x = right - _BOX_WIDTH
        final_bottom = max((one.y + _BOX_HEIGHT for one in placed if one.x == last_x), default=_HEAD)
        at = _Placed(third, last_x, final_bottom + _HEAD + _GAP_Y)
        placed.append(at)
        bottom = max(bottom, at.y + _BOX_HEIGHT)
        parts.append(f'<text class="head" x="{at.x:g}" y="{at.y - 10:g}">Third place</text>')
    parts += [_box(one, name, links) for one in placed]
    wide, tall = right + 2, bottom + 16
    style = f"<style>{PRINT_STYLE}</style>" if alone else ""
    name_space = ' xmlns="http://www.w3.org/2000/svg"' if alone else ""
    return Markup(  # noqa: S704 - every text in it was escaped
        f'<svg class="bracket"{name_space} viewBox="0 0 {wide:g} {tall:g}" width="{wide:g}" height="{tall:g}" '
        f'role="img" aria-label="Bracket: {escape(title)}">{style}{"".join(parts)}</svg>'
    )


def _placed(ties: list[Tie], top: float) -> list[_Placed]:
    """Place the ties of each round evenly: each in the middle of those that lead to it."""
    rounds = grouped((tie.round, tie) for tie in ties)
    height = max(map(len, rounds.values())) * (_BOX_HEIGHT + _GAP_Y)
    return [
        _Placed(
            tie,
            1 + at * (_BOX_WIDTH + _GAP_X),
            max(top, top + (tie.number - 0.5) * height / len(column) - _BOX_HEIGHT / 2),
        )
        for at, column in enumerate(rounds.values())
        for tie in column
    ]


def _joins(placed: list[_Placed]) -> list[str]:
    columns = sorted({one.x for one in placed})
    parts = []
    for x, following in pairwise(columns):
        later = {one.tie.number: one for one in placed if one.x == following}
        own = [one for one in placed if one.x == x]
        for one in own:
            target = later.get((one.tie.number - 1) * len(later) // len(own) + 1)
            if target is not None:
                begin, end = one.y + _BOX_HEIGHT / 2, target.y + _BOX_HEIGHT / 2
                middle = following - _GAP_X / 2
                parts.append(f'<path class="join" d="M{x + _BOX_WIDTH:g} {begin:g}H{middle:g}V{end:g}H{following:g}"/>')
    return parts


def _box(one: _Placed, name: Callable[[str], str], links: Mapping[str, str]) -> str:
    tie, x, y = one.tie, one.x, one.y
    middle = y + _BOX_HEIGHT / 2
    parts = [
        f'<rect class="box" x="{x:g}" y="{y:g}" width="{_BOX_WIDTH}" height="{_BOX_HEIGHT}" rx="6"/>',
        f'<line class="rule" x1="{x:g}" x2="{x + _BOX_WIDTH:g}" y1="{middle:g}" y2="{middle:g}"/>',
    ]
    for side, team in enumerate(tie.teams):
        base = y + 16 + side * _BOX_HEIGHT / 2
        kind = "winner" if team and team == tie.winner else "team" if team else "open"
        text = name(team) if team else tie.sources[side]
        shown = fitted(text, _CHARACTERS_WITHOUT_SCORE if tie.scores is None else _CHARACTERS)
        parts.append(
            f'<text class="{kind}" x="{x + 9:g}" y="{base:g}">{escape(shown)}<title>{escape(text)}</title></text>'
        )
        if tie.scores is not None:
            score = number_words(tie.scores[side])
            parts.append(
                f'<text class="{kind}" x="{x + _BOX_WIDTH - 9:g}" y="{base:g}" text-anchor="end">{score}</text>'
            )
    if tie.decided_by not in ("", "match", "bye"):
        how = escape(tie.decided_by.replace("_", " "))
        parts.append(f'<text class="note" x="{x + 9:g}" y="{y + _BOX_HEIGHT + 12:g}">by {how}</text>')
    link = next((links[fixture] for fixture in reversed(tie.fixtures) if fixture in links), "")
    content = "".join(parts)
    return f'<a href="{escape(link)}">{content}</a>' if link else content
