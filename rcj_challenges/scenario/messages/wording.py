"""What was expected and what was found, in the words that error messages use."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any, Literal, get_args, get_origin

from rcj_challenges.core.amounts import counted
from rcj_challenges.core.colours import CSS_COLOURS
from rcj_challenges.core.timing import TICK_S
from rcj_challenges.rules.fields import NAME_RULE, Colour, EventName, Name, Names, Point
from rcj_challenges.rules.message import SaidText
from rcj_challenges.rules.phrasing import listed, spelled
from rcj_challenges.scenario.errors import cut, did_you_mean, listing
from rcj_challenges.scenario.models.robots import EntryPoint
from rcj_challenges.scenario.shape import Shape, bare, is_list, is_model, is_named, is_union, members, without_none
from rcj_challenges.scenario.tree import Entries, Items, Leaf, Node

_YES, _NO = frozenset({"yes", "on", "y", "true"}), frozenset({"no", "off", "n", "false"})
_NUMBER = re.compile(r"[-+]?[0-9]*\.?[0-9]+([eE][-+]?[0-9]+)?")
_TYPES = {str: "a text", int: "a whole number", float: "a number", bool: "true/false"}
_SPECIAL: tuple[tuple[Any, str, str], ...] = (
    (Names, "a name or a list of names", ""),
    (Name, "a name", f"write {NAME_RULE}"),
    (EventName, "an event's name in capitals", "capitals, digits and _, such as GOAL"),
    (EntryPoint, "a path to a .py file", "write a relative path with / to a .py file"),
    (Colour, "a colour", "write a CSS colour name or '#rrggbb'"),
    (SaidText, "a text that can be said", "single blanks between words, and none at the ends"),
    (Point, "two numbers [x, y]", ""),
)
"""Shapes with what they are called, and the form that they have."""


def format_node(node: Node | None) -> str:
    """Return a value as authors write it, for ``found …``."""
    if isinstance(node, Entries):
        return f"a mapping with {listing(map(cut, node.entries), 6)}" if node.entries else "an empty mapping"
    if isinstance(node, Items):
        return f"a list of {len(node.items)}" if node.items else "an empty list"
    if node is None or node.value is None:
        return "nothing"
    return quoted(node.value) if isinstance(node.value, str) else node.written or spelled(node.value)


def quoted(text: str) -> str:
    """Return a text in quotes on one line, cut if it is long."""
    flat = " ".join(text.split()) if "\n" in text else text
    return f"'{flat}'" if len(flat) <= 64 else f"'{flat[:60]}…'"


def expected(shape: Shape, node: Node | None) -> str:
    """Return the message about a value of the wrong form."""
    return f"expected {expectation(shape)}, found {format_node(node)}"


def expectation(shape: Shape) -> str:
    """Return in words what may stand at a place."""
    shape = without_none(shape)
    if special := next((text for known, text, _ in _SPECIAL if shape == known), None):
        return special
    kind, discriminator = bare(shape)
    if is_union(kind):
        parts = list(dict.fromkeys(expectation(member) for member in members(shape)))
        if "a number" in parts and "a whole number" in parts:
            parts.remove("a whole number")
        return f"a mapping with '{discriminator}'" if isinstance(discriminator, str) else listed(parts, "or")
    if is_model(kind):
        required = [info.alias or key for key, info in kind.model_fields.items() if info.is_required()]
        return f"{{{required[0]}: …}}" if len(required) == 1 else "a mapping"
    if get_origin(kind) is Literal:
        return listed([spelled(word) for word in get_args(kind)], "or")
    if get_origin(kind) is tuple:
        inner = get_args(kind)
        return f"a list of {len(inner)}" if is_fixed(shape) else "a list of names" if inner[0] == Name else "a list"
    return "a mapping by name" if is_named(kind) else _TYPES.get(kind, "a value")


# --- what pydantic refuses --------------------------------------------------------------------------------------------

_BOUNDS = {
    "greater_than": "must be greater than {gt:g}",
    "greater_than_equal": "must be at least {ge:g}",
    "less_than": "must be less than {lt:g}",
    "less_than_equal": "must be at most {le:g}",
}


def refusal(kind: str, details: Mapping[str, Any], shape: Shape, node: Node | None) -> tuple[str, str]:
    """Return message and help for a value that pydantic refuses.

    Args:
        kind: pydantic's type of the error, ``greater_than``.
        details: pydantic's description of it.
        shape: what is expected.
        node: what stands there.
    """
    context, found = details.get("ctx", {}), format_node(node)
    if kind in _BOUNDS:
        is_duration = context.get("ge") == TICK_S
        bound = f"a duration must be at least one tick ({TICK_S} s)" if is_duration else _BOUNDS[kind].format(**context)
        return f"{bound}, found {found}", ""
    if kind in ("string_pattern_mismatch", "unknown_colour"):
        known = (one for one in _SPECIAL if one[0] == without_none(shape))
        _, what, form = next(known, (None, f"of the form that is needed: {expectation(shape)}", ""))
        colour = str(node.value) if kind == "unknown_colour" and isinstance(node, Leaf) else ""
        hint = did_you_mean(colour, CSS_COLOURS) if colour.isalpha() else ""
        return f"{found} is not {what}", hint or form
    if kind.endswith(("too_short", "too_long")) and not is_fixed(shape):
        bound, key = ("at least", "min_length") if kind.endswith("short") else ("at most", "max_length")
        unit = ("character", "characters") if kind.startswith("string") else ("entry", "entries")
        return f"must have {bound} {counted(context[key], *unit)}, found {found}", ""
    if kind.endswith(("_type", "_error", "_parsing", "_from_float", "too_long", "too_short")):
        return expected(shape, node), as_it_is_written(shape, node)
    return f"{details['msg']}, found {found}", ""


def is_fixed(shape: Shape) -> bool:
    """Return whether a shape is a list of a fixed length, such as ``[x, y]``."""
    kind = bare(shape).kind
    return get_origin(kind) is tuple and Ellipsis not in get_args(kind)


def as_it_is_written(shape: Shape, node: Node | None) -> str:
    """Return help for the usual slips in writing a value; empty: it is none of them."""
    kinds = [bare(inner).kind for member in members(shape) for inner in members(member)]
    lists = [kind for kind in kinds if is_list(kind)]
    literals = [word for kind in kinds if get_origin(kind) is Literal for word in get_args(kind)]
    if not isinstance(node, Leaf):
        inner = [bare(one).kind for kind in lists for one in members(get_args(kind)[0])]
        is_one = isinstance(node, Entries) and any(is_model(kind) or is_named(kind) for kind in inner)
        return "a list stands in brackets, also of one: [{…}]" if is_one else ""
    text, help_ = str(node.value), ""
    if not isinstance(node.value, str):
        help_ = f"write it in quotes: '{node.written or text}'" if text in literals or kinds == [str] else ""
    elif any(str(word).casefold() == text.casefold() for word in literals if not isinstance(word, str)):
        help_ = "leave the quotes out"
    elif bool in kinds and text.casefold() in _YES | _NO:
        help_ = f"did you mean {spelled(text.casefold() in _YES)}?"
    elif {int, float} & set(kinds) and _NUMBER.fullmatch(text):
        help_ = "leave the quotes out"
    elif {int, float} & set(kinds) and _NUMBER.fullmatch(text.replace(",", ".")):
        help_ = f"a decimal number is written with a point: {text.replace(',', '.')}"
    elif {int, float} & set(kinds) and text[:1].isdigit():
        help_ = "write one number alone; its unit is in the name of the key"
    elif lists and text.isidentifier():
        help_ = did_you_mean(text, map(str, literals)) or f"a list of one is written [{text}]"
    return help_ or did_you_mean(text, map(str, literals))
