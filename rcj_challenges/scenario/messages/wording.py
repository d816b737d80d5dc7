"""What was expected and what was found, in the words that error messages use."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from typing import Any, Literal, get_args, get_origin

from rcj_challenges.core.amounts import counted
from rcj_challenges.core.colours import CSS_COLOURS
from rcj_challenges.core.timing import TICK_S
from rcj_challenges.rules.fields import Colour, EventName, Name, Names, Point
from rcj_challenges.rules.message import SaidText
from rcj_challenges.scenario.errors import cut, did_you_mean, listing
from rcj_challenges.scenario.models.robots import EntryPoint
from rcj_challenges.scenario.shape import Shape, bare, is_model, is_named, is_union, members, without_none
from rcj_challenges.scenario.tree import Entries, Items, Leaf, Node

NAME_RULE = "letters a to z, digits and _, not beginning with a digit, at most 64"

_YES, _NO = frozenset({"yes", "on", "y", "true"}), frozenset({"no", "off", "n", "false"})
_NUMBER = re.compile(r"[-+]?[0-9]*\.?[0-9]+([eE][-+]?[0-9]+)?")
_DECIMAL_COMMA = re.compile(r"[-+]?[0-9]+,[0-9]+")
_TYPES = {str: "a text", int: "a whole number", float: "a number", bool: "true/false"}
_SPECIAL: tuple[tuple[Any, str], ...] = (
    (Names, "a name or a list of names"),
    (Name, "a name"),
    (EventName, "an event's name in capitals"),
    (EntryPoint, "a path to a .py file"),
    (Colour, "a colour"),
    (Point, "two numbers [x, y]"),
)


def format_node(node: Node | None) -> str:
    """Return a value as authors write it, for ``found …``."""
    if isinstance(node, Entries):
        return f"a mapping with {listing(map(cut, node.entries), 6)}" if node.entries else "an empty mapping"
    if isinstance(node, Items):
        return f"a list of {len(node.items)}" if node.items else "an empty list"
    value = node.value if node is not None else None
    if isinstance(value, str):
        return quoted(value)
    return "nothing" if value is None else spelled(value)


def spelled(value: object) -> str:
    """Return a single value as it stands in a file, without quotes."""
    return str(value).lower() if isinstance(value, bool) else str(value)


def quoted(text: str) -> str:
    """Return a text in quotes on one line, cut if it is long."""
    flat = " ".join(text.split()) if "\n" in text else text
    return f"'{flat}'" if len(flat) <= 64 else f"'{flat[:60]}…'"


def expected(shape: Shape, node: Node | None) -> str:
    """Return the message about a value of the wrong form."""
    return f"expected {expectation(shape)}, found {format_node(node)}"


def expectation(shape: Shape) -> str:  # noqa: PLR0911 - one for each kind of shape
    """Return in words what may stand at a place."""
    shape = without_none(shape)
    special = next((text for known, text in _SPECIAL if shape == known), None)
    if special is not None:
        return special
    kind, discriminator = bare(shape)
    if is_union(kind):
        if isinstance(discriminator, str):
            return f"a mapping with '{discriminator}'"
        parts = list(dict.fromkeys(expectation(member) for member in members(shape)))
        if "a number" in parts and "a whole number" in parts:
            parts.remove("a whole number")
        return _any_of(parts)
    if is_named(kind):
        return "a mapping by name"
    if is_model(kind):
        required = [info.alias or key for key, info in kind.model_fields.items() if info.is_required()]
        return f"{{{required[0]}: …}}" if len(required) == 1 else "a mapping"
    if get_origin(kind) is tuple:
        return _expectation_of_list(get_args(kind))
    if get_origin(kind) is Literal:
        return _any_of([spelled(word) for word in get_args(kind)])
    return _TYPES.get(kind, "a value")


def _expectation_of_list(arguments: tuple[Any, ...]) -> str:
    if len(arguments) == 2 and arguments[1] is Ellipsis:
        return "a list of names" if arguments[0] == Name else "a list"
    if all(argument == Point for argument in arguments):
        return f"{len(arguments)} points, each [x, y]"
    return f"a list of {len(arguments)}"


def _any_of(parts: list[str]) -> str:
    return " or ".join([", ".join(parts[:-1]), parts[-1]] if len(parts) > 1 else parts)


# --- what pydantic refuses --------------------------------------------------------------------------------------------

_BOUNDS: dict[str, Callable[[Mapping[str, Any]], str]] = {
    "greater_than": lambda context: f"must be greater than {context['gt']:g}",
    "greater_than_equal": lambda context: f"must be at least {context['ge']:g}",
    "less_than": lambda context: f"must be less than {context['lt']:g}",
    "less_than_equal": lambda context: f"must be at most {context['le']:g}",
}
_LENGTHS = {
    "string_too_short": ("at least", "min_length", ("character", "characters")),
    "string_too_long": ("at most", "max_length", ("character", "characters")),
    "too_short": ("at least", "min_length", ("entry", "entries")),
    "too_long": ("at most", "max_length", ("entry", "entries")),
}


def refusal(kind: str, details: Mapping[str, Any], shape: Shape, node: Node | None) -> tuple[str, str]:
    """Return message and help for a value that pydantic refuses.

    Args:
        kind: pydantic's type of the error, ``greater_than``.
        details: pydantic's description of it.
        shape: what is expected.
        node: what stands there.
    """
    context = details.get("ctx", {})
    if kind in _BOUNDS:
        bound = _BOUNDS[kind](context)
        if context.get("ge") == TICK_S:
            bound = f"a duration must be at least one tick ({TICK_S} s)"
        return f"{bound}, found {format_node(node)}", ""
    if kind in ("string_pattern_mismatch", "unknown_colour"):
        return _wrong_form(shape, node)
    if kind in _LENGTHS and not is_fixed(shape):
        bound, key, unit = _LENGTHS[kind]
        return f"must have {bound} {counted(context[key], *unit)}, found {format_node(node)}", ""
    if kind.endswith(("_type", "_error", "_parsing", "_from_float", "too_long", "too_short")):
        return expected(shape, node), as_it_is_written(shape, node)
    message = str(details["msg"])
    return f"{message[:1].lower()}{message[1:]}, found {format_node(node)}", ""


def is_fixed(shape: Shape) -> bool:
    """Return whether a shape is a list of a fixed length, such as ``[x, y]``."""
    kind = bare(shape).kind
    return get_origin(kind) is tuple and Ellipsis not in get_args(kind)


def as_it_is_written(shape: Shape, node: Node | None) -> str:  # noqa: PLR0911 - one for each slip
    """Return help for the usual slips in writing a value; empty: it is none of them."""
    literals = [word for member in members(shape) for word in _literals(member)]
    words = [str(word) for word in literals]
    kinds = [bare(inner).kind for member in members(shape) for inner in members(member)]
    if isinstance(node, Entries) and len(node.entries) == 1 and any(one in (Name, Names) for one in members(shape)):
        ((key, name),) = node.entries.items()
        is_name = isinstance(name, Leaf) and isinstance(name.value, str) and key not in words
        return f"the name stands alone: {name.value}" if is_name and isinstance(name, Leaf) else ""
    if not isinstance(node, Leaf):
        is_listed = (
            isinstance(node, Entries) and any(get_origin(kind) is tuple for kind in kinds) and not is_fixed(shape)
        )
        return "a list stands in brackets, also of one: [{…}]" if is_listed else ""
    text = str(node.value)
    if not isinstance(node.value, str):
        return f"write it in quotes: '{text}'" if text in words or kinds == [str] else ""
    if any(str(word).casefold() == text.casefold() for word in literals if not isinstance(word, str)):
        return "leave the quotes out"
    if bool in kinds and text.casefold() in _YES | _NO:
        return f"did you mean {spelled(text.casefold() in _YES)}?"
    if {int, float} & set(kinds):
        return _as_number(text)
    entries = (get_args(kind)[0] for kind in kinds if get_origin(kind) is tuple and Ellipsis in get_args(kind))
    if text.isidentifier() and any(bare(entry).kind is str for entry in entries):
        return did_you_mean(text, words) or f"a list of one is written [{text}]"
    return did_you_mean(text, words)


def _as_number(text: str) -> str:
    if _NUMBER.fullmatch(text):
        return "leave the quotes out"
    if _DECIMAL_COMMA.fullmatch(text):
        return f"a decimal number is written with a point: {text.replace(',', '.')}"
    return "write one number alone; its unit is in the name of the key" if text[:1].isdigit() else ""


def _literals(shape: Shape) -> tuple[Any, ...]:
    kind = bare(shape).kind
    return get_args(kind) if get_origin(kind) is Literal else ()


def _wrong_form(shape: Shape, node: Node | None) -> tuple[str, str]:
    shape, shown = without_none(shape), format_node(node)
    if shape == EventName:
        return f"{shown} is not an event's name", "capitals, digits and _, such as GOAL"
    if shape == Colour:
        text = str(node.value) if isinstance(node, Leaf) else ""
        hint = did_you_mean(text, CSS_COLOURS) if text.isalpha() else ""
        return f"{shown} is not a colour", hint or "write a CSS colour name or '#rrggbb'"
    if shape == EntryPoint:
        return f"{shown} is not an entry point", "write a relative path with / to a .py file"
    if shape == SaidText:
        return f"{shown} cannot be said", "single blanks between words, and none at the ends"
    if shape == Name:
        return f"{shown} is not a name", f"write {NAME_RULE}"
    return f"{shown} does not have the form that is needed: {expectation(shape)}", ""
