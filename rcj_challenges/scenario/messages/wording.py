"""What was expected and what was found, in the words that error messages use."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Callable, Mapping
from typing import Any, Literal, get_args, get_origin

from rcj_challenges.facts.colours import CSS_COLOURS
from rcj_challenges.facts.timing import TICK_S
from rcj_challenges.rules.fields import Colour, EventName, Name, Names, Point
from rcj_challenges.rules.message import SaidText
from rcj_challenges.rules.places import At
from rcj_challenges.scenario.catalogue import BOUND
from rcj_challenges.scenario.errors import cut, listing, nearest
from rcj_challenges.scenario.models.robots import EntryPoint
from rcj_challenges.scenario.shape import Shape, bare, is_list, is_model, is_named, is_union, members, without_none
from rcj_challenges.scenario.tree import Entries, Items, Leaf, Node

NAME_RULE = "letters, digits and _, not beginning with a digit, at most 64"
_SPELT = str.maketrans(
    {"ä": "ae", "ö": "oe", "ü": "ue", "Ä": "Ae", "Ö": "Oe", "Ü": "Ue", "ß": "ss", "ø": "o", "Ø": "O", "ł": "l"}
)
"""Letters of which more is left than the letter below an accent, or that are none with one."""

_MINUS = str.maketrans("\u2212\u2013\u2014", "---")
"""Signs that a text processor writes for a minus."""
_QUOTES = "\u201c\u201d\u201e\u201f\u2018\u2019\u201a\u201b\u00ab\u00bb\u2039\u203a"
"""All that a text processor writes for quotes."""

_YES, _NO = frozenset({"yes", "on", "y"}), frozenset({"no", "off", "n"})
_ALL = frozenset({"all", "every", "always", "each"})
_HOW_MANY = {
    **dict.fromkeys(("one", "some", "either", "anybody", "anyone"), "any"),
    **dict.fromkeys(("both", "each", "every", "everybody", "everyone"), "all"),
    **dict.fromkeys(("neither", "nobody", "nothing", "0"), "none"),
}
"""What others write for how many of a group: a word of it can be more like one that means the opposite."""
_LIST_OF_NAMES = "a list of names"
_NAMED = frozenset(
    ("draw", "entity", "robot", "ball", "obstacle", "group", "spot", "zone", "gate", "relative_to", "position_of")
) | {"entrant", "team", "counter", "flag", "timer", "sequence", "phase", "layout", "name", "point"}
"""Behind which the name of something is written where its name alone is expected."""
_NUMBER = re.compile(r"[-+]?[0-9]*\.?[0-9]+([eE][-+]?[0-9]+)?")
_DECIMAL_COMMA = re.compile(r"[-+]?[0-9]+,[0-9]+")
_FEW = 4
"""So many keys are listed where a mapping is expected."""
_FORMULA = re.compile(r"[-+*/] ")
_BEGINS_WITH_NUMBER = re.compile(r"[-+]?[0-9]")
_TYPES = {str: "a text", int: "a whole number", float: "a number", bool: "true/false"}
_SPECIAL: tuple[tuple[Any, str], ...] = (
    (Names, "a name or a list of names"),
    (Name, "a name"),
    (EventName, "an event's name in capitals"),
    (EntryPoint, "a path to a .py file"),
    (Colour, "a colour"),
    (Point, "two numbers [x, y]"),
)


def expected(shape: Shape, node: Node | None) -> str:
    """Return the sentence for a value of the wrong type or an unknown word."""
    hint = _how_many(shape, node) or _instead(shape, node)
    return f"expected {expectation(shape)}, found {found_text(node)}{hint}"


def _instead(shape: Shape, node: Node | None) -> str:
    """Return how what was most likely meant is written; empty: nobody knows."""
    if isinstance(node, Leaf) and isinstance(node.value, str):
        known = (str(word).casefold() for word in _literals(shape) if not isinstance(word, str))
        if node.value.casefold() in known:
            return "; leave the quotes out"
        return nearest(node.value, _words(shape)) or _hint(shape, node.value)
    if isinstance(node, Leaf) and str(node.value) in _words(shape):
        return f"; write it in quotes: '{node.value}'"
    if isinstance(node, Items) and without_none(shape) == At:
        return _point(node)
    if isinstance(node, Entries) and any(member in (Name, Names) for member in (without_none(shape), *members(shape))):
        return _name_alone(node, looked_at=Point in members(shape))
    return "" if node is None else _hint_at_list(shape, node)


def _how_many(shape: Shape, node: Node | None) -> str:
    """Return how it is written how many of a group are meant; empty: nothing of the kind stands there."""
    if not isinstance(node, Leaf) or not {"any", "all", "none"} <= set(_words(shape)):
        return ""
    if isinstance(node.value, int) and not isinstance(node.value, bool) and node.value > 0:
        return f"; so many or more are written {{at_least: {node.value}}}"
    meant = _HOW_MANY.get(str(node.value).casefold())
    return f"; did you mean {meant!r}?" if meant else ""


def _hint(shape: Shape, text: str) -> str:
    """Return a hint for the usual ways to write a value that YAML takes for a text."""
    kinds = [bare(inner).kind for member in members(shape) for inner in members(member)]
    if without_none(shape) == At:
        return _named_place(text) if text.isidentifier() else ""
    if bool in kinds and text.lower() in _YES | _NO:
        return f"; did you mean {'true' if text.lower() in _YES else 'false'}?"
    if int in kinds or float in kinds:
        return _hint_at_number(text)
    if "any" in _words(shape) and text.lower() in _ALL:
        return "; did you mean any?"
    of_names = _LIST_OF_NAMES in map(expectation, members(shape)) and text.isidentifier()
    inner = get_args(bare(shape).kind)
    of_texts = inner[1:] == (Ellipsis,) and bare(inner[0]).kind is str
    return f"; a list of one is written [{text}]" if of_names or of_texts else ""


def _hint_at_number(text: str) -> str:
    plain = text.translate(_MINUS)
    if plain != text and _NUMBER.fullmatch(plain):
        return f"; its minus is another sign: write {plain}"
    if _NUMBER.fullmatch(text):
        return "; leave the quotes out"
    if _DECIMAL_COMMA.fullmatch(text):
        return f"; a decimal number is written with a point: {text.replace(',', '.')}"
    if _FORMULA.search(text):
        return (
            "; no formula is read: {param: NAME, times: 2, plus: 1} reckons with a param, a list of parts is added up"
        )
    if _BEGINS_WITH_NUMBER.match(text):
        return "; write one number and nothing else: its unit is the one that the key's name ends with"
    return ""


def _is_of_mappings(shape: Shape) -> bool:
    entry = bare(get_args(bare(shape).kind)[0]).kind
    return is_model(entry) or (is_union(entry) and any(is_model(bare(one).kind) for one in get_args(entry)))


def _hint_at_list(shape: Shape, node: Node) -> str:
    """Return how a list is written: of one entry, or of decimals; or a mapping in whose place a list stands."""
    shape = without_none(shape)
    if isinstance(node, Items) and is_named(bare(shape).kind):
        return "; each entry begins with its name and ':', not with '-'"
    if isinstance(node, Entries) and is_list(shape) and _is_of_mappings(shape):
        return "; a list stands in brackets, also of one: [{…}]"
    if not isinstance(node, Items) or shape != Point or len(node.items) not in (3, 4):
        return ""
    numbers = [item.value if isinstance(item, Leaf) else None for item in node.items]
    if not all(isinstance(one, int) and not isinstance(one, bool) for one in numbers):
        return ""
    if len(numbers) == 3:  # which of the commas is meant, nobody knows
        return "; if decimal numbers are meant, they are written with a point, as in [0.3, -0.2]"
    return f"; a decimal number is written with a point: [{numbers[0]}.{numbers[1]}, {numbers[2]}.{numbers[3]}]"


def _named_place(text: str) -> str:
    """Return how the place of a name is written: of a spot, in a zone, beside a thing that moves."""
    beside = f"beside a robot or a ball {{relative_to: {text}}}"
    if text in BOUND:
        return f"; {beside}"
    return f"; a spot is written {{spot: {text}}}, a random point of a zone {{uniform_in: {text}}}, {beside}"


def _point(node: Items) -> str:
    """Return how a point is written where a list of its two numbers stands alone."""
    found = [item.value if isinstance(item, Leaf) else None for item in node.items]
    if len(found) != 2 or not all(isinstance(one, int | float) and not isinstance(one, bool) for one in found):
        return ""
    return f"; a point is written {{point: [{found[0]}, {found[1]}]}}"


def _name_alone(node: Entries, *, looked_at: bool) -> str:
    """Return that the name of something stands alone where it was written with what it is, `{spot: centre}`."""
    (kind,) = node.entries if len(node.entries) == 1 else ("",)
    name = node.entries.get(kind)
    if kind not in _NAMED or not isinstance(name, Leaf) or not isinstance(name.value, str):
        return ""
    if looked_at and kind == "zone":  # it is no place to look at
        return ""
    return f"; {'where a draw may decide, ' * (kind == 'draw')}its name stands alone: {name.value}"


def _words(shape: Shape) -> list[str]:
    return [str(word) for word in _literals(shape)]


def _literals(shape: Shape) -> list[Any]:
    kinds = [bare(member).kind for member in members(shape)]
    return [word for kind in kinds if get_origin(kind) is Literal for word in get_args(kind)]


def found_text(node: Node | None) -> str:
    """Return a value as authors write it, for ``found …``."""
    if isinstance(node, Entries):
        return f"a mapping with {listing(map(cut, node.entries), 6)}" if node.entries else "an empty mapping"
    if isinstance(node, Items):
        count = len(node.items)
        return "an empty list" if not count else f"a list of {count}"
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


def expectation(shape: Shape) -> str:
    """Return in words what may stand at a place."""
    shape = without_none(shape)
    special = next((text for known, text in _SPECIAL if shape == known), None)
    if special is not None:
        return special
    kind, discriminator = bare(shape)
    if is_union(kind):
        return _expectation_of_union(shape, discriminator)
    if is_named(kind) or is_model(kind):
        return _expectation_of_mapping(kind)
    if get_origin(kind) is tuple:
        return _expectation_of_list(get_args(kind))
    if get_origin(kind) is Literal:
        words = ["true" if word is True else str(word) for word in get_args(kind)]
        return " or ".join([", ".join(words[:-1]), words[-1]] if len(words) > 1 else words)
    return _TYPES.get(kind, "a value")


def _expectation_of_mapping(kind: Any) -> str:
    if is_named(kind):
        return "a mapping by name"
    keys = [info.alias or key for key, info in kind.model_fields.items() if info.is_required()]
    if len(keys) == 1:
        return f"{{{keys[0]}: …}}"
    known = [info.alias or key for key, info in kind.model_fields.items()]
    return "a mapping" if keys or len(known) > _FEW else f"a mapping that may have {listing(known)}, such as {{}}"


def _expectation_of_list(arguments: tuple[Any, ...]) -> str:
    if len(arguments) == 2 and arguments[1] is Ellipsis:
        return _LIST_OF_NAMES if arguments[0] == Name else "a list"
    if all(argument == Point for argument in arguments):
        return f"{len(arguments)} points, each [x, y]"
    return f"a list of {len(arguments)}"


def _expectation_of_union(shape: Shape, discriminator: object) -> str:
    if isinstance(discriminator, str):
        return f"a mapping with '{discriminator}'"
    parts = list(dict.fromkeys(expectation(member) for member in members(shape)))
    if "a number" in parts and "a whole number" in parts:
        parts.remove("a whole number")
    return " or ".join([", ".join(parts[:-1]), parts[-1]] if len(parts) > 1 else parts)


# --- bounds and forms -------------------------------------------------------------------------------------------------


def _number(value: object) -> str:
    return f"{value:g}" if isinstance(value, float) else str(value)


_BOUNDS: dict[str, Callable[[Mapping[str, Any]], str]] = {
    "greater_than": lambda context: f"must be greater than {_number(context['gt'])}",
    "greater_than_equal": lambda context: f"must be at least {_number(context['ge'])}",
    "less_than": lambda context: f"must be less than {_number(context['lt'])}",
    "less_than_equal": lambda context: f"must be at most {_number(context['le'])}",
}
_LENGTHS = {
    "string_too_short": ("at least", "min_length", "character"),
    "string_too_long": ("at most", "max_length", "character"),
    "too_short": ("at least", "min_length", "entry"),
    "too_long": ("at most", "max_length", "entry"),
}
_PLURALS = {"character": "characters", "entry": "entries"}


def refusal(kind: str, details: Mapping[str, Any], shape: Shape, node: Node | None) -> str:
    """Return the sentence for a value that pydantic refuses.

    Args:
        kind: pydantic's type of the error, ``greater_than``.
        details: pydantic's description of it.
        shape: what is expected.
        node: what stands there.
    """
    context = details.get("ctx", {})
    shown = found_text(node)
    if kind in _BOUNDS:
        if context.get("ge") == TICK_S:
            return f"a duration must be at least one tick ({TICK_S} s), found {shown}"
        return f"{_BOUNDS[kind](context)}, found {shown}"
    if kind in ("string_pattern_mismatch", "unknown_colour"):
        return _wrong_form(shape, node)
    if kind in _LENGTHS and not is_fixed(shape):
        bound, key, unit = _LENGTHS[kind]
        count = context[key]
        return f"must have {bound} {count} {unit if count == 1 else _PLURALS[unit]}, found {shown}"
    if kind.endswith(("_type", "_error", "_parsing", "_from_float", "too_long", "too_short")):
        return expected(shape, node)
    message = str(details["msg"])
    return f"{message[:1].lower()}{message[1:]}, found {shown}"


def is_fixed(shape: Shape) -> bool:
    """Return whether a shape is a list of a fixed length, such as ``[x, y]``."""
    kind = bare(shape).kind
    return get_origin(kind) is tuple and Ellipsis not in get_args(kind)


def no_name(text: str) -> str:
    """Return why a text is no name, and what is one."""
    return f"{quoted(text)} is no name: {NAME_RULE}{_from_a_to_z(text) or _without_blanks(text)}"


def _without_blanks(text: str) -> str:
    """Return how names are written where blanks or commas stand in a text; empty: it has none, or is something else."""
    parts = text.replace(",", " ").split()
    are_names = len(parts) > 1 and all(part.isidentifier() for part in parts)
    if "," in text:
        return f"; several names are a list: [{', '.join(parts)}]" if are_names else ""
    joined = "_".join(parts)
    several = f"; several names have commas between them: {', '.join(parts)}" if are_names else ""
    return f"; in a name no blank stands: {joined}{several}" if len(parts) > 1 and joined.isidentifier() else ""


def _from_a_to_z(text: str) -> str:
    """Return how a name is written without the letters that only some languages have; empty: it has none."""
    if text.isascii():
        return ""
    if text.strip(_QUOTES) != text:
        return f"; quotes of a text processor are part of it: write {text.strip(_QUOTES)}"
    plain = unicodedata.normalize("NFKD", unicodedata.normalize("NFC", text).translate(_SPELT))
    plain = "".join(letter for letter in plain if not unicodedata.combining(letter))
    if text.isupper():
        plain = plain.upper()
    such = f": {plain}" if plain.isascii() and plain.isidentifier() else ""
    return f"; letters are those from {'A to Z' if text.isupper() else 'a to z'}{such}"


def _wrong_form(shape: Shape, node: Node | None) -> str:
    shape, shown = without_none(shape), found_text(node)
    if shape == EventName:
        text = node.value if isinstance(node, Leaf) and isinstance(node.value, str) else ""
        return f"{shown} is no event's name: capitals, digits and _, such as GOAL{_from_a_to_z(text)}"
    if shape == Colour:
        word = str(node.value) if isinstance(node, Leaf) else ""
        hint = nearest(word, CSS_COLOURS) if word.isalpha() else ""
        return f"{shown} is no colour: a CSS colour name or #rrggbb{hint}"
    if shape == EntryPoint:
        return f"{shown} is no entry point: a relative path with / to a .py file"
    if shape == SaidText:
        return f"{shown} is heard otherwise: with single blanks between its words, and none at its ends"
    if shape == Name:
        return no_name(str(node.value)) if isinstance(node, Leaf) else f"{shown} is no name: {NAME_RULE}"
    return f"{shown} does not have the form that is needed: {expectation(shape)}"
