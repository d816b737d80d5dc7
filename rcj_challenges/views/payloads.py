"""The values of an event's payload that the sentence of its rule does not have, as short text."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping
from typing import Any

from rcj_challenges.core.amounts import measure, measured_words, number_words

_ON_THE_BOARD = frozenset(
    ("score", "score_blue", "score_yellow", "team_name_blue", "team_name_yellow", "halftime", "match_id",
     "total_match_time", "total_match_time_s")
)  # fmt: skip
"""Fields of official events, which the scoreboard shows."""

_OFFICIAL = frozenset(("KICKOFF", "GOAL", "LACK_OF_PROGRESS", "ROBOT_DAMAGED"))
"""Events of the match, whose sentences name the robots and teams concerned."""
_SUBJECTS = frozenset(("robot_name", "team_name", "type"))

_LONGEST = 80
_DECIMALS = 4


def extra_payload_text(event: str, payload: Mapping[str, Any], says: str) -> str:
    """Return ``run 8.48 s, poles 1``: the values of an event's payload that neither sentence nor scoreboard show."""
    known = _ON_THE_BOARD | _SUBJECTS if says and event in _OFFICIAL else _ON_THE_BOARD
    if "robot_name" in payload:
        known |= {"type"}  # a robot, as its name says
    left = {key: value for key, value in payload.items() if key not in known}
    return ", ".join(_words(key, value) for key, value in left.items() if not _is_in_sentence(key, value, says))


def _is_in_sentence(key: str, value: Any, says: str) -> bool:
    """Return whether the sentence has a value: a text as a word, a number only with its unit (others may be alike)."""
    if isinstance(value, bool) or value is None:
        return False
    if isinstance(value, int | float):
        unit = measure(key)[1]
        text = f"{_number(value)} {unit}" if unit else ""
    else:
        text = value if isinstance(value, str) else ""
    # A name stands in a sentence with blanks in place of _, and in texts of records of older versions as it is.
    forms = {text, text.replace("_", " ")} if text else set()
    return any(re.search(rf"(?<![\w.]){re.escape(form)}(?!\w)", says) for form in forms)


def _words(key: str, value: Any) -> str:
    name = key.removesuffix("_name")
    match value:
        case bool():
            text = "yes" if value else "no"
        case int() | float() | None:
            text = _number(value)
        case str():
            text = value
        case _:
            text = json.dumps(value, ensure_ascii=False)
    return measured_words(name, text if len(text) <= _LONGEST else text[: _LONGEST - 1] + "…")


def _number(value: float | None) -> str:
    return number_words(value, _DECIMALS)
