"""The value of a param in use: ``{param: gap_m, times: -1, plus: 0.02}`` is the param times a number plus a number."""

from __future__ import annotations

from collections.abc import Iterator
from decimal import Context
from math import isfinite
from typing import NamedTuple

from rcj_challenges.core.amounts import plain
from rcj_challenges.scenario.errors import choice_of
from rcj_challenges.scenario.messages.wording import expected, format_node
from rcj_challenges.scenario.reading.yaml_strict import INT_LIMIT
from rcj_challenges.scenario.tree import Entries, Leaf, Mark, Node

TIMES, PLUS = "times", "plus"
KEYS = ("param", TIMES, PLUS)
_EXACT = Context(prec=60)
"""More digits than a product of two numbers of a file has, so that only the result is rounded, to a float."""
_MAX_EXACT = 2**53
"""Up to here each whole number is a float."""


class Refusal(NamedTuple):
    """Why a param cannot be used so.

    Attributes:
        mark: where.
        key: the key that is wrong; empty if the whole is.
        message, help: as of `Diagnostic`.
    """

    mark: Mark
    key: str
    message: str
    help: str = ""


def param_value(use: Entries, name: str, value: Leaf) -> tuple[Leaf, list[Refusal]]:
    """Return the value for which a param stands, and what is wrong; then the value is None.

    Args:
        use: the mapping ``{param: NAME, times: …, plus: …}``.
        name: of the param.
        value: of the param.
    """
    mark = use.entries["param"].mark
    unknown = Leaf(None, mark, note="unknown param", param=name)
    refused = list(_refusals(use))
    factors = {key: use.entries[key] for key in (TIMES, PLUS) if key in use.entries}
    number = value.value
    if factors and (isinstance(number, (str, bool)) or number is None):
        message = f"param '{name}' is {format_node(value)}"
        refused.append(Refusal(mark, "", message, "times and plus are for numbers"))
    # A number that was left empty, or is null, has been reported already.
    if refused or any(isinstance(one, Leaf) and one.value is None for one in factors.values()):
        return unknown, refused
    formula = "".join(f" {key} {format_node(one)}" for key, one in factors.items())
    if isinstance(number, (int, float)) and factors:
        number = _result(number, _number(factors.get(TIMES), 1), _number(factors.get(PLUS), 0))
        if not (-INT_LIMIT <= number < INT_LIMIT if isinstance(number, int) else isfinite(number)):
            return unknown, [Refusal(mark, "", f"param '{name}'{formula} is too large a number")]
    return Leaf(number, mark, note=f"param '{name}'{formula}", param=name), []


def _refusals(use: Entries) -> Iterator[Refusal]:
    for key in use.entries:
        if key not in KEYS:
            yield Refusal(use.key_marks[key], "", f"unknown key '{key[:64]}'", choice_of(key, (TIMES, PLUS)))
    for key in (TIMES, PLUS):
        node = use.entries.get(key)
        value = node.value if isinstance(node, Leaf) else ""
        if node is not None and isinstance(value, (str, bool)):
            yield Refusal(node.mark, key, expected(float, node), "not another param: write a number")


def _number(node: Node | None, default: int) -> int | float:
    value = node.value if isinstance(node, Leaf) else default
    return value if isinstance(value, (int, float)) else default


def _result(value: float, times: float, plus: float) -> int | float:
    """Return a number times a number plus a number, exact before it is rounded: three times 0.1 is 0.3."""
    if isinstance(value, int) and isinstance(times, int) and isinstance(plus, int):
        return value * times + plus
    first, second, third = (_EXACT.create_decimal(repr(one)) for one in (value, times, plus))
    number = float(_EXACT.add(_EXACT.multiply(first, second), third))
    return plain(number) if abs(number) < _MAX_EXACT else number
