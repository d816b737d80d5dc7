"""Placeholders of ``says`` and of the description: what is known before the match is filled in here."""

from __future__ import annotations

import re
from collections.abc import Mapping

from rcj_challenges.core.amounts import number_words, round_score
from rcj_challenges.rules.effects import Scores
from rcj_challenges.rules.fields import Scalar
from rcj_challenges.rules.phrasing import listed
from rcj_challenges.scenario.models.scenario import Rule

PLACEHOLDERS = ("entity", "each", "other", "others", "team", "measured", "limit", "points")
"""Placeholders that are filled in when a rule fires; they take precedence over params of the same name."""

OPEN = "…"
"""Stands on the sheet for a number that is known only when a rule fires."""

_ARTICLES = ("the ", "a ", "an ", "one of ", "its ")
_KIND = "robot|ball|obstacle|gate|spot|zone|team"
# What makes sense beside a name only: “the gate {each}”, “the {each} gate”.
_BESIDE_A_NAME = re.compile(
    rf"((?:\b(?:the|an?|this|that) )?(?:\b(?:{_KIND}) )?)\{{(\w+)\}}((?: (?:{_KIND})\b)?)", re.IGNORECASE
)
_IN_BRACES = re.compile(r"\{([^{}]*)\}")
_OF_POINTS = re.compile(r"\{([^{}]*)\}( points\b)?")
_ONE = ("1", "-1")
_DECIMALS = 9  # to so many numbers are exact


def placeholders_in(says: str) -> tuple[str, ...]:
    """Return the placeholders of a sentence, each once."""
    return tuple(dict.fromkeys(_IN_BRACES.findall(says)))


def named_in(rule: Rule) -> dict[str, str]:
    """Return the placeholders of a rule's sentences, each with the key of the first one that has it."""
    sheet = rule.sheet if isinstance(rule.sheet, str) else ""
    return dict.fromkeys(placeholders_in(sheet), "sheet") | dict.fromkeys(placeholders_in(rule.says), "says")


def fill_params(rule: Rule, params: Mapping[str, Scalar], text: str) -> str:
    """Return a sentence of a rule with its params filled in, and its points if it gives one plain number."""
    known = {name: value for name, value in params.items() if name not in PLACEHOLDERS}
    points = {one.points for one in rule.effects(Scores)}
    if len(points) == 1 and (number := points.pop()) is not None:
        known["points"] = number
    return filled(text, known)


def counted(number: str) -> str:
    """Return a number of points as people say it: ``1 point``, ``2 points``."""
    return f"{number} point" if number in _ONE else f"{number} points"


def filled(text: str, values: Mapping[str, Scalar | list[Scalar]]) -> str:
    """Return a text with values filled in by their names; what is not known stays as it is.

    ``{points} points`` is one point if it is one.
    """

    def fill(placeholder: re.Match[str]) -> str:
        if placeholder[1] not in values:
            return placeholder[0]
        value = values[placeholder[1]]
        words = [_as_text(one) for one in value] if isinstance(value, list) else [_as_text(value)]
        text = listed(words, "and")
        return counted(text) if placeholder[2] else text

    return _OF_POINTS.sub(fill, text)


def fill_generally(text: str, words: Mapping[str, tuple[str, str]]) -> str:
    """Fill in general words for names: the first ones where a thing is named first, “a robot”, later the others."""
    named: set[tuple[str, str]] = set()

    def fill(found: re.Match[str]) -> str:
        before, name, after = found.groups()
        if name not in words:
            return found[0]
        is_possessive = text[found.end() :].startswith(("'", "\N{RIGHT SINGLE QUOTATION MARK}"))
        known = words[name][words[name] in named or is_possessive]
        named.add(words[name])
        shown = known if known.startswith(_ARTICLES) else f"{before}{known}{after}"
        begins = re.search(r"(^|[.!?]\s+)$", text[: found.start()])
        return f"{shown[:1].upper()}{shown[1:]}" if begins else shown

    return _BESIDE_A_NAME.sub(fill, text)


def _as_text(value: Scalar) -> str:
    if isinstance(value, bool):
        return str(value).lower()
    return number_words(round_score(value), _DECIMALS) if isinstance(value, int | float) else value
