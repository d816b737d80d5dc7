"""The rules of a rule sheet as sentences, in the order in which they are judged."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from rcj_challenges.core.amounts import times
from rcj_challenges.core.grouping import grouped
from rcj_challenges.core.timing import TICK_MS
from rcj_challenges.rules.actions import ACTIONS
from rcj_challenges.rules.conditions import CONDITIONS
from rcj_challenges.rules.effects import Draws, Emits, SetsSpot, Writes
from rcj_challenges.rules.fields import Strict
from rcj_challenges.rules.phrasing import listed, quoted
from rcj_challenges.rules.places import PLACES
from rcj_challenges.rules.triggers import TRIGGERS
from rcj_challenges.rules.values import VALUES, duration_words
from rcj_challenges.scenario.models.scenario import Rule, Scenario
from rcj_challenges.scenario.models.state import Sequence
from rcj_challenges.views.sheet.document import Block, Items
from rcj_challenges.views.sheet.phrasebook import Phrasebook

_VOCABULARIES = (TRIGGERS, CONDITIONS, VALUES, ACTIONS, PLACES)
_MAX_CHANGES = 4
_MARKS = ".,;:()“”"
_BOOKKEEPING = (Draws, Emits, SetsSpot, Writes)
"""Effects that change nothing on the field, in the score or in the course."""


def rules_on_sheet(scenario: Scenario) -> dict[str, Rule]:
    """Return the rules that are on the sheet, in the order in which they are judged.

    Those with ``sheet: false`` are left out, and helpers: they have no sentence and only keep books.
    """
    return {
        name: rule
        for name, rule in sorted(scenario.rules.items(), key=lambda named: named[1].priority)
        if rule.sheet and (rule.says or not all(isinstance(one, _BOOKKEEPING) for one in rule.all_effects()))
    }


def rule_blocks(phrases: Phrasebook, rules: Mapping[str, Rule]) -> Iterator[Block]:
    """Yield the effects of some rules, in sentences."""
    if rules:
        title = (
            "In the order in which they are judged; a name in brackets is the rule's name in the log. Rules that only "
            "count or remember something for others are left out."
        )
        yield Items(tuple(_sentences(rules, phrases)), title, numbered=True)
    yield from _exclusive_words(rules)


def when_words(rule: Rule, phrases: Phrasebook) -> str:
    """Return the moment in which a rule fires: ``When the ball enters the blue goal, provided that …``."""
    phrases = phrases.within(rule)
    each = f"For {phrases.each_of(rule.for_each)}, when " if rule.for_each else "When "
    edges = ", or when ".join(trigger.describe(phrases) for trigger in rule.triggers)
    levels = " and ".join(f"that {condition.describe(phrases)}" for condition in rule.conditions)
    return f"{each}{edges}" + (f", provided {levels}" if levels else "")


def _sentence(rule: Rule, phrases: Phrasebook) -> str:
    phrases = phrases.within(rule)
    each = "for each of them " if rule.for_each else ""
    keep, most = rule.limit
    limits = [
        *([f"{each}at most once in {duration_words(phrases, rule.cooldown_s)}"] if rule.cooldown_s else []),
        *([f"{each}at most {times(most)} {_during(keep, phrases)}"] if most else []),
        *(["in every phase"] if rule.phases == "any" else []),
    ]
    if rule.phases not in ("any", ("play",)):
        limits.append(f"in the phase {listed([quoted(phase) for phase in rule.phases], 'or')}")
    actions = ", then ".join(action.describe(phrases) for action in rule.actions)
    tail = f" ({'; '.join(limits)})" if limits else ""
    return f"{when_words(rule, phrases)}: {actions}{tail}."


def _during(keep: str, phrases: Phrasebook) -> str:
    known = {"half": phrases.period.a, "match": "in the match", "phase": "in a phase"}
    return known.get(keep, f"from one beginning of the phase {quoted(keep)} to the next")


def _sentences(rules: Mapping[str, Rule], phrases: Phrasebook) -> Iterator[str]:
    """Yield each rule in full, or by what distinguishes it from an earlier one that is worded alike."""
    said: dict[str, str] = {}
    for name, rule in rules.items():
        sentence = _sentence(rule, phrases)
        alike = ((other, _differences(words, sentence)) for other, words in said.items())
        like, changes = next(((other, found) for other, found in alike if found), ("", []))
        said[name] = sentence
        yield f"[{name}] As [{like}], with {'; '.join(changes)}." if changes else f"[{name}] {sentence}"


def _differences(sentence: str, other: str) -> list[str]:
    """Return how one sentence becomes another by a few words that are replaced wherever they stand; else nothing."""
    words, others = sentence.split(" "), other.split(" ")
    changed = {old: new for old, new in zip(words, others, strict=False) if old != new}
    is_alike = len(words) == len(others) and [changed.get(word, word) for word in words] == others
    changes = dict.fromkeys(f"{new.strip(_MARKS)} for {old.strip(_MARKS)}" for old, new in changed.items())
    return [*changes] if is_alike and len(changes) <= _MAX_CHANGES else []


def general_notes() -> Iterator[str]:
    """Yield what holds for all rules, whatever they use."""
    yield f"All is judged on every tick of {TICK_MS} ms; a time is over on the first tick on which it has passed."
    yield (
        "A rule that names no phase counts in the phase “play” only. What happens in another phase is not made up for "
        "later, and what must last for a time is measured again."
    )
    yield (
        "A robot, a ball or an obstacle is where its centre is: that counts for zones and gates, and distances are "
        "measured from it."
    )
    models: tuple[type[Strict], ...] = (Sequence, *(word for words in _VOCABULARIES for word in words.words()))
    yield from dict.fromkeys(note for model in models for note in model.NOTES)


def _exclusive_words(rules: Mapping[str, Rule]) -> Iterator[str]:
    groups = grouped((rule.exclusive, f"[{name}]") for name, rule in rules.items() if rule.exclusive is not None)
    for names in (names for names in groups.values() if len(names) > 1):
        one = "only the first that still may counts in a tick; rules “for each” count once for each of them"
        yield f"Of {listed(names, 'and')} {one}."
