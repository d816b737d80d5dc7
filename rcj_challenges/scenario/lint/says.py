"""Lint of what rules tell: blanks in sentences and words in payloads that nothing ever fills."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from rcj_challenges.facts.messages import number_in
from rcj_challenges.scenario.blanks import BLANKS, in_braces, points_of
from rcj_challenges.scenario.errors import listing, nearest
from rcj_challenges.scenario.heard import as_said, wanted
from rcj_challenges.scenario.lint.about import OF_SEQUENCES, found_by, things_about
from rcj_challenges.scenario.lint.suspect import Subject, Suspect
from rcj_challenges.scenario.messages.wording import quoted
from rcj_challenges.scenario.models import triggers
from rcj_challenges.scenario.models.base import Scalar
from rcj_challenges.scenario.models.scenario import Rule
from rcj_challenges.scenario.models.state import WordValue
from rcj_challenges.scenario.models.triggers import Trigger
from rcj_challenges.scenario.other import has_other
from rcj_challenges.scenario.tree import Path
from rcj_challenges.scenario.visiting import visit

_WORDS_FOR = {
    "each_name": "each",
    "gate": "each",
    "zone": "each",
    "robot": "entity",
    "robot_name": "entity",
    "entity_name": "entity",
    "other_name": "other",
    "team_name": "team",
    "entrant": "team",
}
"""Words of payloads that authors write into sentences, and the blank that means the same."""
_NEEDS = {
    "robot_name": "robot",
    "entity_name": "entity",
    "each_name": "each",
    "other_name": "other",
    "team_name": "team",
    "entrant": "team",
    "score": "team",
    "measured": "measured",
    "limit": "limit",
}
"""Words of payloads that are known in some rules only, and what of a rule they need."""

_WITH_LIMIT = (
    triggers.Displaced,
    triggers.NoProgress,
    triggers.StaysIn,
    triggers.TipsOver,
    triggers.Holds,
    triggers.TimeReached,
    triggers.TimerExpired,
)

_NOBODY = "no trigger of this rule is about one entity, and it has no for_each over entities"
_TELL_ABOUT = "use a trigger with an entity, or for_each"
_WRITE_OUT = "write out what is meant, or leave it out"
_WHY_EMPTY = {
    "entity": "is about nobody in particular",
    "team": "is about no robot of a team",
    "measured": "measures nothing",
    "limit": "has no limit",
}
_MEASURE = "leave it out, or use a trigger that measures, such as stays_in"


def check_sentences(subject: Subject) -> Iterator[Suspect]:
    """Blanks that no rule fills, or that this rule never or not always can; payload words that stay empty."""
    for name, rule in subject.scenario.rules.items():
        lacks = _lacks(rule, subject)
        for blank in in_braces(rule.says):
            if blank in BLANKS or blank not in subject.scenario.params:
                known = subject.repeated[name].known if name in subject.repeated else ()
                yield from _blank(blank, ("rules", name, "says"), lacks, (*known, *subject.scenario.params))
            if blank not in lacks:
                yield from _at_times_empty(blank, name, rule, subject)
        for model, path in visit(rule, ("rules", name)):
            if isinstance(model, WordValue):
                yield from _word(model, path, lacks)


def check_description(subject: Subject) -> Iterator[Suspect]:
    """Blanks in the description that no param fills, and params in the title, which is always the same."""
    params = subject.scenario.params
    for blank in in_braces(subject.scenario.description):
        # Other braces are text: authors show there what programs are told, {"light": "red"}.
        if blank not in params and blank.strip().isidentifier():
            shown = quoted(f"{{{blank}}}")
            filled = f"what is filled in is {listing([f'{{{name}}}' for name in params], 12)}" if params else ""
            told = "that is known only when a rule fires" if blank in BLANKS else ""
            yield Suspect(
                "placeholder_unknown",
                ("description",),
                f"{shown} is not filled in, it stays as written{nearest(blank.strip(), params)}",
                "; ".join(part for part in (told, filled) if part) or "params are filled in by their names",
            )
    for blank in in_braces(subject.scenario.title):
        if blank in params:
            yield Suspect(
                "placeholder_unknown",
                ("title",),
                f"{quoted(f'{{{blank}}}')} is not filled in: a title is the same for every value of its params",
                "leave it out, or tell it in the description",
            )


def check_broadcast(subject: Subject) -> Iterator[Suspect]:
    """Words of the broadcast that speak of what a rule is about: it is told on every tick, whether one fires or not."""
    for model, path in visit(subject.scenario.broadcast, ("broadcast",)):
        if isinstance(model, WordValue):
            yield from _word(model, path, _LACKS_OF_BROADCAST)


@dataclass(frozen=True)
class _Lack:
    """Something that is never known when a rule fires.

    Attributes:
        reason: why not.
        remedy: what would help.
    """

    reason: str
    remedy: str


_NOBODY_TOLD = _Lack("a broadcast is about no single entity", "leave it out")
_NOTHING_MEASURED = _Lack(
    "a broadcast is about no rule that fires", "let the rule that measures set a counter to it, and tell the counter"
)
_LACKS_OF_BROADCAST = {
    **dict.fromkeys(("entity", "each", "other", "robot", "team"), _NOBODY_TOLD),
    **dict.fromkeys(("measured", "limit"), _NOTHING_MEASURED),
}


def _blank(blank: str, path: Path, lacks: dict[str, _Lack], params: tuple[str, ...]) -> Iterator[Suspect]:
    shown = quoted(f"{{{blank}}}")
    if blank not in BLANKS:
        word = blank.strip().casefold()
        hint = nearest(_WORDS_FOR.get(word, word), (*BLANKS, *params))
        known = listing([f"{{{name}}}" for name in (*BLANKS, *params)], len(BLANKS) + 12)
        yield Suspect(
            "placeholder_unknown",
            path,
            f"{shown} is not filled in, it stays as written{hint}",
            f"what is filled in is {known}{'' if params else ', and params by their names'}",
        )
    elif blank in lacks:
        lack = lacks[blank]
        empty = "is no single number" if blank == "points" else "stays empty"
        hidden = f", or give the param '{blank}' another name: it is not meant here" if blank in params else ""
        yield Suspect("placeholder_never_filled", path, f"{shown} {empty}: {lack.reason}", f"{lack.remedy}{hidden}")


def _at_times_empty(blank: str, name: str, rule: Rule, subject: Subject) -> Iterator[Suspect]:
    """Yield a blank that one trigger of a rule fills and another leaves empty."""
    if rule.for_each is not None and subject.members("each", rule) & _told_by(blank, subject):
        return
    without = next((trigger for trigger in rule.triggers if not _fills(trigger, blank, rule, subject)), None)
    if without is not None:
        hears_no_number = blank == "measured" and isinstance(without, triggers.Tells)
        why = "may hear what is no number" if hears_no_number else _WHY_EMPTY[blank]
        remedy = "give that trigger a rule of its own, or leave it out"
        yield Suspect(
            "placeholder_at_times_empty",
            ("rules", name, "says"),
            f"{quoted(f'{{{blank}}}')} stays empty when '{without.trigger}' sets the rule off, which {why}",
            f"write is_a: number there, or {remedy}" if hears_no_number else remedy,
        )


def _fills(trigger: Trigger, blank: str, rule: Rule, subject: Subject) -> bool:
    """Return whether a blank is known when a trigger has set a rule off."""
    if blank in {"entity", "team"}:
        return bool(found_by(trigger, rule, subject) & _told_by(blank, subject))
    if blank == "measured":
        return _measures(trigger, subject) and (not isinstance(trigger, triggers.Tells) or _is_number(trigger, subject))
    return blank != "limit" or isinstance(trigger, _WITH_LIMIT)


def _measures(trigger: Trigger, subject: Subject) -> bool:
    """Return whether a trigger measures something, or may hear a number."""
    if isinstance(trigger, triggers.Tells):
        said = wanted(trigger, subject.scenario)
        return trigger.is_a != "position" and (said is None or any(map(_number_of, said)))
    return isinstance(trigger, (*_WITH_LIMIT, *OF_SEQUENCES))


def _is_number(trigger: triggers.Tells, subject: Subject) -> bool:
    """Return whether what a trigger hears is always a number."""
    said = wanted(trigger, subject.scenario)
    return trigger.is_a == "number" or (said is not None and all(map(_number_of, said)))


def _number_of(said: Scalar) -> bool:
    return number_in(as_said(said)) is not None


def _told_by(blank: str, subject: Subject) -> frozenset[str]:
    """Return of which things a blank tells something."""
    if blank == "team":
        return _in_teams(subject)
    return frozenset(subject.roster.things if blank == "entity" else ())


def _in_teams(subject: Subject) -> frozenset[str]:
    return frozenset(robot for entrant in subject.scenario.entrants.values() for robot in entrant.robots)


def _word(value: WordValue, path: Path, lacks: dict[str, _Lack]) -> Iterator[Suspect]:
    lack = lacks.get(_NEEDS.get(value.word, ""))
    takes_of = value.word in ("team_name", "score")
    if lack is None or (takes_of and value.of is not None):
        return
    empty = "is always 0" if value.word == "score" else "stays empty"
    yield Suspect(
        "word_never_filled",
        (*path, "word"),
        f"'{value.word}' {empty}: {lack.reason}",
        f"say whose with 'of', or {lack.remedy}" if takes_of else lack.remedy,
    )


# --- what is known when a rule fires ----------------------------------------------------------------------------------


def _lacks(rule: Rule, subject: Subject) -> dict[str, _Lack]:
    """Return what can never be known when a rule fires, whichever of its triggers it was."""
    scenario = subject.scenario
    about = things_about(rule, subject)
    with_limit = any(isinstance(trigger, _WITH_LIMIT) for trigger in rule.triggers)
    lacks = {}
    if not about:
        lacks = dict.fromkeys(("entity", "robot", "team"), _Lack(_NOBODY, _TELL_ABOUT))
    elif not about & set(scenario.robots):
        lacks = dict.fromkeys(("robot", "team"), _Lack("this rule is never about a robot", _WRITE_OUT))
    elif not about & _in_teams(subject):
        lacks["team"] = _Lack("this rule is never about a robot of a team", _WRITE_OUT)
    if not with_limit:
        lacks["limit"] = _Lack("no trigger of this rule has a limit", _MEASURE)
        if not any(_measures(trigger, subject) for trigger in rule.triggers):
            lacks["measured"] = _Lack("no trigger of this rule measures anything", _MEASURE)
    if rule.for_each is None:
        lacks["each"] = _Lack("this rule has no for_each", "write out what is meant, or give it a for_each")
    if not has_other(rule):
        lacks["other"] = _Lack(
            "not all triggers of this rule are touches", "give the touches a rule of their own, or leave it out"
        )
    given = points_of(rule)
    if not given:
        lacks["points"] = _Lack("this rule gives no points", "add {action: score, …}, or leave it out")
    elif len(given) > 1:
        lacks["points"] = _Lack("this rule gives points more than once, and not as many", _WRITE_OUT)
    return lacks
