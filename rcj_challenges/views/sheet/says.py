"""The sentence ``says`` of a rule, with general words for the blanks that are filled in when it fires."""

from __future__ import annotations

import re

from rcj_challenges.rules.phrasing import number, plain
from rcj_challenges.scenario.models.scenario import Rule
from rcj_challenges.scenario.placeholders import fill_params
from rcj_challenges.scenario.roster import ENTRANTS, as_tuple, has_other
from rcj_challenges.scenario.rule_effects import written_others
from rcj_challenges.views.sheet.phrasebook import Phrasebook

OPEN = "…"
"""Stands for a number that is known only when the rule fires."""

_UNKNOWN_TEAM = "the team"
_ARTICLES = ("the ", "one of ")
"""Beginnings of words that need no article or kind beside them."""
_KIND = "robot|ball|obstacle|gate|spot|zone|team"
_BESIDE_A_NAME = rf"(?:\b(?:the|an?|this|that) )?(?:\b(?:{_KIND}) )?{{}}(?: (?:{_KIND})\b)?"
"""What makes sense beside a name only: “the gate {each}”, “the {each} gate”."""


def says_sentence(phrases: Phrasebook, rule: Rule) -> str:
    """Return the sentence of a rule; an empty text if it has none."""
    words = fill_params(rule, phrases.scenario.params).strip()
    if not words:
        return ""
    kind = "" if rule.for_each is None else "team" if rule.for_each == ENTRANTS else phrases.kinds_of(rule.for_each)
    blanks = {
        "{entity}": _entity(phrases, rule),
        "{each}": f"the {kind or plain(rule.for_each or '')}",
        "{other}": _other(phrases, rule),
        "{team}": _team(phrases, rule),
        "{measured}": _limit(phrases, rule) if all(one.measures_its_limit() for one in rule.triggers) else OPEN,
        "{limit}": _limit(phrases, rule),
        "{points}": OPEN,
    }
    if blanks["{team}"] == _UNKNOWN_TEAM:
        words = words.replace("{entity} of {team}", "{entity}")
    for blank, known in blanks.items():
        if known.startswith(_ARTICLES):
            words = re.sub(_BESIDE_A_NAME.format(re.escape(blank)), blank, words, flags=re.IGNORECASE)
    words = _first_of_a_group(phrases, rule, words)
    for blank, known in blanks.items():
        words = _filled(words, blank, known)
    end = "" if words.rstrip("\"'”)").endswith((".", "!", "?", "…", ":")) else "."
    return f"{words[:1].upper()}{words[1:]}{end}"


def _filled(words: str, blank: str, known: str) -> str:
    """Return words in which a blank is filled in; with a capital if a sentence begins with it."""
    capital = f"{known[:1].upper()}{known[1:]}"
    words = re.sub(rf"([.!?]\s+){re.escape(blank)}", lambda found: found[1] + capital, words)
    return words.replace(blank, known)


def _first_of_a_group(phrases: Phrasebook, rule: Rule, words: str) -> str:
    """Name the group where a sentence names one of it first: “one of the red fruits”, later “the ball”.

    Otherwise rules over two groups of the same kind would say the same.
    """
    group = rule.for_each if rule.for_each in phrases.scenario.groups else None
    blanks = ("{each}", "{entity}") if _is_over_entities(phrases, rule) else ("{each}",)
    first = min((blank for blank in blanks if blank in words), key=words.index, default=None)
    if group is None or first is None or len(phrases.roster.expand(group)) <= 1:
        return words
    before, _, after = words.partition(first)
    is_possessive = after.startswith(("'", "\N{RIGHT SINGLE QUOTATION MARK}"))
    return words if is_possessive else f"{_filled(before + first, first, phrases.any_of(group))}{after}"


def _entity(phrases: Phrasebook, rule: Rule) -> str:
    if _is_over_entities(phrases, rule):
        return f"the {phrases.kinds_of(rule.for_each or ())}"
    names = _concerned(phrases, rule)
    return phrases.any_of(names) if names else "the one concerned"


def _is_over_entities(phrases: Phrasebook, rule: Rule) -> bool:
    return rule.for_each is not None and rule.for_each != ENTRANTS and phrases.is_on_field(rule.for_each)


def _other(phrases: Phrasebook, rule: Rule) -> str:
    """Return the one touched: ``the other robot``, ``the robot`` if a ball touches it, ``Y1`` if only that can be."""
    others = phrases.roster.others(rule, None) if has_other(rule) else ()
    if len(others) == 1:
        return phrases.thing(others[0])
    kind = phrases.one_kind(others)
    if others and not kind:
        return phrases.any_of(written_others(rule))
    touching = rule.for_each or () if _is_over_entities(phrases, rule) else _concerned(phrases, rule)
    return f"the {kind}" if kind and kind != phrases.one_kind(touching) else f"the other {kind or 'one'}"


def _team(phrases: Phrasebook, rule: Rule) -> str:
    each = phrases.roster.expand(rule.for_each or ())
    # Balls and obstacles have no team: then it is the team of what came to them.
    is_over_robots = any(name in phrases.scenario.robots for name in each)
    names = each if is_over_robots else tuple(name for name in _concerned(phrases, rule) if name != "each")
    entrants = phrases.scenario.entrants.items()
    seats = {
        next((seat for seat, entrant in entrants if member in entrant.robots), None)
        for member in phrases.roster.expand(names)
    }
    only = seats.pop() if len(seats) == 1 else None
    return _UNKNOWN_TEAM if only is None else plain(only)


def _limit(phrases: Phrasebook, rule: Rule) -> str:
    limits = {trigger.limit(phrases) for trigger in rule.triggers}
    only = limits.pop() if len(limits) == 1 else None
    return OPEN if only is None else number(round(only, 3))


def _concerned(phrases: Phrasebook, rule: Rule) -> tuple[str, ...]:
    about = (trigger.about(phrases) for trigger in rule.triggers)
    return tuple(dict.fromkeys(name for names in about if names is not None for name in as_tuple(names)))
