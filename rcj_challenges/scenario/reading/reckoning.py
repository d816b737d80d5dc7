"""Params in use: ``{param: gap_m, times: -1, plus: 0.02}`` stands for the param times a number plus a number."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass
from decimal import Context
from math import isfinite

from rcj_challenges.facts.amounts import plain, round_score
from rcj_challenges.facts.measures import number_words
from rcj_challenges.scenario.errors import nearest
from rcj_challenges.scenario.messages.wording import expected, found_text
from rcj_challenges.scenario.reading.yaml_strict import INT_LIMIT
from rcj_challenges.scenario.tree import Entries, Leaf, Mark, Node

TIMES, PLUS = "times", "plus"
KEYS = ("param", TIMES, PLUS)
_ON_PAPER = Context(prec=60)
"""More digits than a product of two numbers of a file has, so that only the result is rounded, to a float."""
_DECIMALS = 9  # to so many what is written on paper is exact
_EXACT = 2**53
"""Up to here each whole number is a float."""
_INSTEAD = {"weight": TIMES, "factor": TIMES, "add": PLUS, "offset": PLUS}
"""What others call the two."""

_NAME, _AMOUNT = r"(?P<name>[A-Za-z_]\w*)", r"(?P<number>\d+(?:\.\d*)?|\.\d+)"
_WRITTEN_OUT = tuple(
    (re.compile(form, re.ASCII), meaning)
    for form, meaning in (
        (rf"-\s*{_NAME}", "times: -1"),
        (rf"{_NAME}\s*\*\s*{_AMOUNT}", "times: {number}"),
        (rf"{_AMOUNT}\s*\*\s*{_NAME}", "times: {number}"),
        (rf"{_NAME}\s*\+\s*{_AMOUNT}", "plus: {number}"),
        (rf"{_NAME}\s*-\s*{_AMOUNT}", "plus: -{number}"),
    )
)
"""How somebody may write it as a formula, and how it is written here."""


@dataclass(frozen=True)
class Refusal:
    """Why a use of a param cannot stand.

    Attributes:
        mark: where.
        key: the key of the use that is wrong; empty if the whole is.
        message: what is wrong.
    """

    mark: Mark
    key: str
    message: str


def reckoned(use: Entries, name: str, value: Leaf) -> tuple[Leaf, list[Refusal]]:
    """Return the value for which a param stands, and what is wrong; then the value is None.

    Args:
        use: the mapping ``{param: NAME, times: …, plus: …}``.
        name: of the param.
        value: of the param.
    """
    mark = use.entries["param"].mark
    refused = [*_strangers(use), *_no_numbers(use)]
    factors = {key: use.entries[key] for key in (TIMES, PLUS) if key in use.entries}
    number = value.value
    if factors and (isinstance(number, (str, bool)) or number is None):
        message = f"param '{name}' is {found_text(value)}; times and plus are for numbers"
        refused.append(Refusal(mark, "", message))
    # A number that was left empty, or is null, has been reported already.
    if refused or any(isinstance(one, Leaf) and one.value is None for one in factors.values()):
        return Leaf(None, mark, note="unknown param", param=name), refused
    said = "".join(f" {key} {found_text(one)}" for key, one in factors.items())
    if isinstance(number, (int, float)) and factors:
        number = _result(number, _number(factors.get(TIMES), 1), _number(factors.get(PLUS), 0))
        if not (-INT_LIMIT <= number < INT_LIMIT if isinstance(number, int) else isfinite(number)):
            message = f"param '{name}'{said} is no number that can be written: it is too large"
            return Leaf(None, mark, note="unknown param", param=name), [Refusal(mark, "", message)]
    return Leaf(number, mark, note=f"param '{name}'{said}", param=name), []


def written_out(name: str, params: Iterable[str]) -> str:
    """Return how to write what somebody has written as a formula, as a hint; empty if it is none."""
    for form, meaning in _WRITTEN_OUT:
        found = form.fullmatch(name.strip())
        if found is not None and found["name"] in params:
            said = meaning.format_map({"number": "", **found.groupdict()})
            return f"; write {{param: {found['name']}, {said}}}"
    return ""


def _strangers(use: Entries) -> Iterable[Refusal]:
    for key in use.entries:
        if key not in KEYS:
            meant = f"; did you mean '{_INSTEAD[key]}'?" if key in _INSTEAD else nearest(key, (TIMES, PLUS))
            meant = _other_way_round(key, use.entries[key]) or meant
            message = f"unknown key '{key[:64]}'; beside param may stand times and plus{meant}"
            yield Refusal(use.key_marks[key], "", message)


def _other_way_round(key: str, node: Node) -> str:
    """Return what takes off or divides as plus and times; empty: the key is for something else."""
    number = node.value if isinstance(node, Leaf) and not isinstance(node.value, bool | str) else None
    if key in ("minus", "subtract"):
        amount = "" if number is None else f": plus: {number_words(round_score(-number), _DECIMALS)}"
        return f"; what is taken off is a plus below 0{amount}"
    if key in ("divide", "divided_by", "over") and number:
        return f"; it is divided by times: {round_score(1 / number):g}"
    return ""


def _no_numbers(use: Entries) -> Iterable[Refusal]:
    for key in (TIMES, PLUS):
        node = use.entries.get(key)
        value = node.value if isinstance(node, Leaf) else ""
        if node is not None and value is not None and (isinstance(value, (str, bool))):
            other = "; it is a number, no other param" if isinstance(node, Entries) and "param" in node.entries else ""
            yield Refusal(node.mark, key, expected(float, node) + other)


def _number(node: Node | None, default: int) -> int | float:
    value = node.value if isinstance(node, Leaf) else default
    return value if isinstance(value, (int, float)) else default


def _result(value: float, times: float, plus: float) -> int | float:
    """Return a number times a number plus a number, as it would be on paper: three times 0.1 is 0.3."""
    if isinstance(value, int) and isinstance(times, int) and isinstance(plus, int):
        return value * times + plus
    first, second, third = (_ON_PAPER.create_decimal(repr(one)) for one in (value, times, plus))
    number = float(_ON_PAPER.add(_ON_PAPER.multiply(first, second), third))
    return plain(number) if abs(number) < _EXACT else number
