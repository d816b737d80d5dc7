"""What to write instead of a value that cannot stand in its place, where what is meant is said otherwise."""

from __future__ import annotations

from typing import get_args

from rcj_challenges.rules.values.word import NumberWord, WordValue
from rcj_challenges.scenario.catalogue import texts
from rcj_challenges.scenario.tree import Entries, Node, Path, child

_TIMES = ("at_s", "limit_s", "within_s", "for_s", "grace_s", "every_s")
"""The times that triggers wait for."""
_MEASURES = ("timer", "way", "distance", "word", "told", "flag", "draw")
_LIMITS = ("at_least", "at_most", "equals")
_ADDED_UP = ("points", "by", "to")
NUMBER_WORDS = frozenset(get_args(NumberWord.model_fields["word"].annotation))
"""Of numbers that the referee knows: in a list that is added up, and as a limit."""
_TOLD_WORDS = frozenset(get_args(WordValue.model_fields["word"].annotation))
"""Of all that the referee knows, in the payload of an event."""
_OF_THE_MATCH = frozenset({"halftime", "match_id", "total_match_time_s", "time_s", "time_left_s", "phase", "seed_id"})
"""Of what is about no entity, and stands in the broadcast as well."""


def for_value(path: Path, node: Node | None) -> str:
    """Return how something is said that cannot stand here as a value; empty: nothing is known that was meant.

    Args:
        path: where the value stands.
        node: the value, as it is written.
    """
    if not isinstance(node, Entries):
        return ""
    if path[:1] == ("broadcast",):
        return _told_otherwise(node) or _word_alone(node, _OF_THE_MATCH) or _team_told(node)
    if "payload" in path:
        return _told_otherwise(node) or _word_alone(node, _TOLD_WORDS) or _name_told(node)
    if path[:1] != ("rules",):
        return ""
    compared = (_no_number, _score_compared, _measured_before, _drawn_compared, _told_compared)
    ways = (say(path, node) for say in (*compared, _spot_of_chance))
    return next(filter(None, ways), "") or (
        _word_alone(node, NUMBER_WORDS) if any(key in path for key in _ADDED_UP) else ""
    )


def _told_otherwise(node: Entries) -> str:
    """Return how programs, or the log, are told what is no value."""
    if "condition" in node.entries:
        return "; a condition cannot be told: let rules set a flag, and tell {flag: NAME}"
    score = texts(child(node, "score"))
    return f"; a score is read like a counter: {{counter: {score[0]}}}" if score else ""


def _no_number(path: Path, node: Entries) -> str:
    """Return how a time that a draw or a counter says is told."""
    kind = next((one for one in ("counter", "draw") if texts(child(node, one))), None)
    if kind is None:
        return ""
    lasts = f"lasts_s: {{{kind}: {texts(child(node, kind))[0]}}} there"
    if path[2:] == ("cooldown_s",):
        asked = "{condition: timer, timer: …, negate: true}"
        return f"; a rest that is drawn or reckoned is a timer that the rule starts: {lasts}, and {asked} here"
    if path[2:3] != ("triggers",) or path[-1] not in _TIMES:
        return ""
    heard = "{trigger: timer_expired, timer: …}"
    return f"; a time that is drawn or reckoned is that of a timer: {lasts}, and {heard} here"


def _score_compared(path: Path, node: Entries) -> str:
    """Return how a score is compared with."""
    key = next((one for one in ("score", "entrant", "points") if texts(child(node, one))), None)
    if key is None or path[-1] not in _LIMITS:
        return ""
    return f"; a score is read like a counter: {{counter: {texts(child(node, key))[0]}}}"


def _measured_before(path: Path, node: Entries) -> str:
    """Return how a limit or a length is what something measures."""
    kind = next((one for one in _MEASURES if one in node.entries), None)
    lasts = path[2:3] == ("actions",) and path[-1] == "for_s"
    compared = path[-1] in _LIMITS and path[2:3] in (("conditions",), ("triggers",))
    if kind is None or not (lasts or compared) or (kind == "draw" and path[-1] == "equals"):
        return ""
    counted = f"{{action: count, counter: …, to: {{{kind}: …}}}}"
    return f"; what is measured is counted before, {counted}, and {{counter: …}} stands here"


def _drawn_compared(path: Path, node: Entries) -> str:
    """Return how two draws are compared, or one is set to what the other one has."""
    draw = texts(child(node, "draw"))
    if not draw or path[-1] not in ("equals", "as"):
        return ""
    asked = f"{{condition: drawn, draw: {draw[0]}, equals: each}}"
    return f"; what another draw has: for_each over those it decides among, {asked}, and 'each' here"


def _told_compared(path: Path, node: Entries) -> str:
    """Return how what a robot tells is compared with a number that is reckoned."""
    if path[-1] != "text" or "counter" not in node.entries:
        return ""
    return (
        "; a number that is reckoned: is_a: number, {action: count, counter: …, to: {told: …}} and an event, and the "
        "rule that hears it compares the two counters"
    )


def _spot_of_chance(path: Path, node: Entries) -> str:
    """Return how chance decides where a spot is."""
    if path[-1] != "to" or "choice" not in node.entries:
        return ""
    return (
        "; chance decides among spots of the file by a draw, draws: {hidden: {values: [a, b, c]}}: its name stands for "
        "the spot drawn, in distance, {spot: hidden} and {relative_to: hidden}"
    )


_NAMES_TOLD = {"other": "other one", "robot": "robot", "entity": "entity", "team": "team"}


def _word_alone(node: Entries, words: frozenset[str]) -> str:
    """Return how a value is written whose word stands where a key is expected."""
    word = next((key for key in node.entries if key in words), None)
    return f"; its value is written {{word: {word}}}" if word is not None else ""


def _name_told(node: Entries) -> str:
    """Return how a payload tells who it was, where what it was stands as a key."""
    about = next((key for key in node.entries if key in _NAMES_TOLD), None)
    return f"; the name of the {_NAMES_TOLD[about]} is written {{word: {about}_name}}" if about else ""


def _team_told(node: Entries) -> str:
    """Return how the broadcast tells the name of a team: it is about nobody, so it must say whose."""
    team = texts(child(node, "team"))
    return f"; the name of the team is written {{word: team_name, of: {team[0]}}}" if team else ""


def for_reckoned(above: Path, key: str, node: Node | None) -> str:
    """Return how a counter is reckoned with; empty: something else is meant.

    Args:
        above: where the mapping stands in which the key is not known.
        key: the key.
        node: that mapping.
    """
    counter = texts(child(node, "counter"))
    if key not in ("plus", "times", "minus", "weight") or not counter:
        return ""
    parts = f"[{{counter: {counter[0]}, weight: 2}}, 1]"
    if key == "minus" and isinstance(above[-1], int):
        return "; what is taken off has weight: -1"
    if above[-1:] in (("by",), ("to",), ("points",)):
        if key == "weight":
            return ""  # said of all that may stand in a list
        return f"; it is reckoned as a list that is added up: {parts}"
    counted = f"{{action: count, counter: …, to: {parts}}}"
    return f"; what is reckoned is counted before, {counted}, and that counter stands here"
