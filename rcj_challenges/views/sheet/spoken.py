"""What a rule says, with words for the blanks that are filled in only when it fires."""

from __future__ import annotations

import re
from collections.abc import Iterator

from rcj_challenges.rules.phrasing import number, plain
from rcj_challenges.scenario.blanks import partly_filled
from rcj_challenges.scenario.models.scenario import Rule
from rcj_challenges.scenario.roster import as_tuple, has_other
from rcj_challenges.scenario.touch_rules import written_others
from rcj_challenges.views.sheet.phrasebook import Phrasebook

OPEN = "…"
"""Stands for a number that is known only when the rule fires."""

_SOME_TEAM = "the team"

_ARTICLES = ("the ", "one of ", "a ", "an ")
"""How those words begin that need no “the” before them."""

_POINTERS = "the|an?|this|that"
"""What stands before a name, and not before words that have an article."""

_AFTER_A_NOUN = r"(\b(?:the|an?) (?!(?:next|other|first|second|third|last|new|same|right|wrong|free)\b)[a-z]+) "
"""Another word for what a blank stands for, as in “the field {each}”, and none that tells which one it is."""

_PLURALS = (("ies", "y"), ("es", ""), ("s", ""))
"""With what a group's name may end, and its members' in place of it."""


def spoken(nouns: Phrasebook, rule: Rule) -> str:
    """Return what a rule says as a whole sentence; an empty text if it says nothing."""
    words = partly_filled(rule, nouns.scenario.params).strip()
    if not words:
        return ""
    filled = {
        "{entity}": _subject(nouns, rule),
        "{each}": "" if rule.for_each is None else f"the {nouns.kinds_of(rule.for_each) or plain(rule.for_each)}",
        "{other}": _other(nouns, rule),
        "{team}": _team(nouns, rule),
        "{measured}": _measured(nouns, rule),
        "{limit}": _limit(nouns, rule),
        "{points}": OPEN,
    }
    end = "" if words.rstrip("\"'”)").endswith((".", "!", "?", "…", ":")) else "."
    if filled["{team}"] == _SOME_TEAM:
        # What is of one of the teams, nobody says of it.
        words = words.replace("{entity} of {team}", "{entity}")
    for blank, known in filled.items():
        if known.startswith(_ARTICLES):
            words = _bare(blank, _kinds_said(nouns, rule, blank), words)
    words = _first_of_a_group(nouns, rule, words)
    for blank, known in filled.items():
        words = _filled_in(blank, known, words)
    return f"{words[:1].upper()}{words[1:]}{end}"


def _kinds_said(nouns: Phrasebook, rule: Rule, blank: str) -> tuple[str, ...]:
    """Return the words beside a blank that say of what kind it is: ``gate``, and of a group of doors ``door``."""
    match blank:
        case "{team}":
            return ("team",)
        case "{other}":
            return (nouns.one_kind(nouns.roster.others(rule, rule.for_each)),)
        case "{entity}" if not _goes_over_entities(nouns, rule):
            return (nouns.one_kind(_concerned(nouns, rule)),)
    group = rule.for_each or ""
    return (nouns.one_kind(group), *(_singulars(group) if group in nouns.scenario.groups else ()))


def _singulars(group: str) -> Iterator[str]:
    """Yield what one of a group may be called, by the last word of its name: ``boxes`` are each a ``box``."""
    word = group.rpartition("_")[2]
    yield from (f"{word.removesuffix(end)}{one}" for end, one in _PLURALS if word.endswith(end))


def _bare(blank: str, kinds: tuple[str, ...], words: str) -> str:
    """Leave out what makes sense beside a name only: “the {each} is open”, “a door {each}”, “the {each} gate”.

    What stands there in the sheet, “one of the doors”, has an article and a kind of its own.
    """
    kind = "|".join(re.escape(one) for one in kinds if one)
    before, after = (rf"(?:\b(?:{kind}) )?", rf"(?: (?:{kind})\b)?") if kind else ("", "")
    return re.sub(rf"(?:\b(?:{_POINTERS}) )?{before}{re.escape(blank)}{after}", blank, words, flags=re.IGNORECASE)


def _filled_in(blank: str, known: str, words: str) -> str:
    """Return words in which a blank is filled in; where a sentence begins with it, with a capital."""
    if known.startswith(_ARTICLES):
        beside = f" ({known})" if known.startswith("one of ") or blank == "{other}" else ""
        words = re.sub(_AFTER_A_NOUN + re.escape(blank), lambda found: found[1] + beside, words, flags=re.IGNORECASE)
    capital = f"{known[:1].upper()}{known[1:]}"
    words = re.sub(rf"([.!?]\s+){re.escape(blank)}", lambda found: found[1] + capital, words)
    return words.replace(blank, known)


def _first_of_a_group(nouns: Phrasebook, rule: Rule, words: str) -> str:
    """Say of which group one is where a sentence names it first: “one of the red fruits”, later “the ball”.

    Two rules of one kind of thing would say the same otherwise. What belongs to it is said to be “the ball's”.
    """
    group = rule.for_each if rule.for_each in nouns.scenario.groups else None
    if group is None or len(nouns.roster.expand(group)) <= 1:
        return words
    blanks = ("{each}", "{entity}") if _goes_over_entities(nouns, rule) else ("{each}",)
    first = min((blank for blank in blanks if blank in words), key=words.index, default=None)
    if first is None:
        return words
    before, _, after = words.partition(first)
    if after.startswith(("'", "\N{RIGHT SINGLE QUOTATION MARK}")):
        return words
    return f"{_filled_in(first, nouns.any_of(group), before + first)}{after}"


def _subject(nouns: Phrasebook, rule: Rule) -> str:
    if _goes_over_entities(nouns, rule):
        return f"the {nouns.kinds_of(rule.for_each or ())}"
    names = _concerned(nouns, rule)
    return nouns.any_of(names) if names else "the one concerned"


def _goes_over_entities(nouns: Phrasebook, rule: Rule) -> bool:
    return rule.for_each is not None and nouns.is_on_field(rule.for_each)


def _other(nouns: Phrasebook, rule: Rule) -> str:
    """Return the one touched: ``the other robot``, ``the robot`` if a ball touches it, ``Y1`` if only that can be.

    Where it may be of several kinds, what the rule writes: ``a wall or the ball``.
    """
    others = nouns.roster.others(rule, rule.for_each) if has_other(rule) else ()
    if len(others) == 1:
        return nouns.thing(others[0])
    kind = nouns.one_kind(others)
    if others and not kind:
        # Of several kinds none says enough: “Y1 touches the other one” would be anything.
        return nouns.any_of(written_others(rule))
    touching = nouns.one_kind(rule.for_each or () if _goes_over_entities(nouns, rule) else _concerned(nouns, rule))
    return f"the {kind}" if kind and kind != touching else f"the other {kind or 'one'}"


def _team(nouns: Phrasebook, rule: Rule) -> str:
    """Return the team of all that a rule can be about, if it is one and the same."""
    each = nouns.roster.expand(rule.for_each or ())
    # Nobody drives a ball or an obstacle: then it is the team of who came to it.
    goes_over_robots = any(name in nouns.scenario.robots for name in each)
    names = each if goes_over_robots else tuple(name for name in _concerned(nouns, rule) if name != "each")
    entrants = nouns.scenario.entrants.items()
    seats = {
        next((seat for seat, entrant in entrants if member in entrant.robots), None)
        for member in nouns.roster.expand(names)
    }
    only = seats.pop() if len(seats) == 1 else None
    return _SOME_TEAM if only is None else plain(only)


def _limit(nouns: Phrasebook, rule: Rule) -> str:
    limits = {trigger.limit(nouns) for trigger in rule.triggers}
    only = limits.pop() if len(limits) == 1 else None
    return OPEN if only is None else number(round(only, 3))


def _measured(nouns: Phrasebook, rule: Rule) -> str:
    """Return what is measured where that is known before: what lasts so long fires when it has lasted so long."""
    return _limit(nouns, rule) if all(trigger.measures_its_limit() for trigger in rule.triggers) else OPEN


def _concerned(nouns: Phrasebook, rule: Rule) -> tuple[str, ...]:
    """Return what the triggers of a rule can be about, without repeats."""
    about = (trigger.about(nouns) for trigger in rule.triggers)
    return tuple(dict.fromkeys(name for names in about if names is not None for name in as_tuple(names)))
