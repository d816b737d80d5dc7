"""Lint of sentences that tell the number of a param: one of the base that was changed, or one that may be changed."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping

from rcj_challenges.scenario.errors import listing
from rcj_challenges.scenario.lint.suspect import Subject, Suspect
from rcj_challenges.scenario.messages.wording import found_text
from rcj_challenges.scenario.models import actions, conditions, triggers
from rcj_challenges.scenario.models.scenario import Rule
from rcj_challenges.scenario.tree import Entries, Items, Leaf, Mark, Node, Path, node_at
from rcj_challenges.scenario.visiting import visit

_WORDS = (
    *("zero", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven", "twelve"),
    *("thirteen", "fourteen", "fifteen", "sixteen", "seventeen", "eighteen", "nineteen", "twenty"),
)
_TENS = {30: "thirty", 40: "forty", 45: "forty-five", 50: "fifty", 60: "sixty", 90: "ninety", 100: "a hundred"}
_AFTER_ONE = r" (?:point|second|minute|metre|meter|goal|shot|lap|time|ball)\b"
"""What follows a "one" that counts something; other ones are "the one", "one of them"."""
_UNITS = {"s": ("s", "second", "seconds"), "m": ("m", "metre", "metres", "meter", "meters")}
_POINTS = ("point", "points")
_FOR_EACH = {"a", "an", "each", "every", "for", "per"}
_NEXT_WORDS = 2


def check_numbers(subject: Subject) -> Iterator[Suspect]:
    """Params that are set anew, and inherited sentences that tell the number of the base."""
    own = subject.tree.mark.file
    params = subject.tree.entries.get("params")
    for name, before in subject.replaced.items():
        now = params.entries.get(name) if isinstance(params, Entries) else None
        if not isinstance(now, Leaf) or now.mark.file != own or not _is_other_number(before, now):
            continue
        telling = [
            f"{rule} ({mark.file}:{mark.line})"
            for rule, mark in _inherited_sentences(subject)
            if _tells(subject.scenario.rules[rule].says, before) and _depends(rule, name, subject)
        ]
        if telling:
            yield _untrue(name, before, f"what is said by {listing(telling)} tells the number of the base", "its says:")
        text = subject.tree.entries.get("description")
        if isinstance(text, Leaf) and text.mark.file != own and _tells_of(str(text.value), before, name):
            yield _untrue(name, before, f"the description ({text.mark.file}) tells the number of the base", "it")


def _untrue(name: str, before: Leaf, reason: str, what: str) -> Suspect:
    return Suspect(
        "number_of_the_base",
        ("params", name),
        f"it was {found_text(before)}, and {reason}",
        f"write {what} anew here, or let the base say {{{name}}}, which fills it in",
        at_key=True,
    )


def _is_other_number(before: Leaf, now: Leaf) -> bool:
    numbers = [one.value for one in (before, now) if isinstance(one.value, int | float)]
    return len(numbers) == 2 and not any(isinstance(number, bool) for number in numbers) and numbers[0] != numbers[1]


def _inherited_sentences(subject: Subject) -> Iterator[tuple[str, Mark]]:
    for name in subject.scenario.rules:
        says = node_at(subject.tree, ("rules", name, "says"))
        if isinstance(says, Leaf) and says.mark.file != subject.tree.mark.file:
            yield name, says.mark


# --- numbers that a placeholder would tell ----------------------------------------------------------------------------


def check_written_out(subject: Subject) -> Iterator[Suspect]:
    """Numbers of the author's own sentences that are those of a param: ``--set`` makes them untrue."""
    params = {name: leaf for name, leaf in _params(subject) if _is_telling(leaf)}
    for rule, model in subject.scenario.rules.items():
        says = node_at(subject.tree, ("rules", rule, "says"))
        if params and isinstance(says, Leaf) and says.mark.file == subject.tree.mark.file:
            told = subject.repeated[rule].filled_in if rule in subject.repeated else ()
            found = [
                name for name, leaf in params.items() if name not in told and _tells_in_its_unit(model.says, leaf, name)
            ]
            meant = _alone(found, params)
            yield from _written_out(
                [name for name in meant if _is_meant(rule, name, params[name], subject)],
                params,
                ("rules", rule, "says"),
            )
    text = subject.tree.entries.get("description")
    if isinstance(text, Leaf) and text.mark.file == subject.tree.mark.file:
        own = {leaf.value for leaf in _leaves(subject.tree.entries.get("rules")) if not leaf.param}
        found = [
            name
            for name, leaf in params.items()
            # Where a param is told by its name, its number once more is one that rules have of their own.
            if _tells_of(str(text.value), leaf, name) and not (f"{{{name}}}" in str(text.value) and leaf.value in own)
        ]
        yield from _written_out(_alone(found, params), params, ("description",))


def _written_out(names: list[str], params: Mapping[str, Leaf], path: Path) -> Iterator[Suspect]:
    for name in names:
        yield Suspect(
            "number_instead_of_param",
            path,
            f"{found_text(params[name])} is the param '{name}' here, and with --set {name}=… it would be untrue",
            f"write {{{name}}}, which fills in its value",
        )


def _params(subject: Subject) -> Iterator[tuple[str, Leaf]]:
    params = subject.tree.entries.get("params")
    for name in subject.scenario.params:
        leaf = params.entries.get(name) if isinstance(params, Entries) else None
        if isinstance(leaf, Leaf):
            yield name, leaf


def _is_telling(leaf: Leaf) -> bool:
    """Return whether a value is a number that stands for itself: every other sentence has a one or a two in it."""
    return isinstance(leaf.value, int | float) and not isinstance(leaf.value, bool) and leaf.value not in _EVERYWHERE


_EVERYWHERE = (0, 1, 2)


def _alone(names: list[str], params: Mapping[str, Leaf]) -> list[str]:
    """Return those names that no other has the number of: else nobody knows which of them is meant."""
    values = [params[name].value for name in names]
    return [name for name in names if values.count(params[name].value) == 1]


def _is_meant(rule: str, param: str, leaf: Leaf, subject: Subject) -> bool:
    """Return whether the number stands in a rule, or in what it waits for, by its param and in no other way."""
    paths: list[Path] = [("rules", rule), *_waited_for(subject.scenario.rules[rule])]
    equal = [one for path in paths for one in _leaves(node_at(subject.tree, path)) if one.value == leaf.value]
    return bool(equal) and all(one.param == param for one in equal)


def _unit_of(param: str) -> tuple[str, ...] | None:
    """Return the words for the unit in which a param's name ends; None if it has none."""
    last = param.lower().rsplit("_", 1)[-1]
    return _POINTS if last in _POINTS else _UNITS.get(last)


def _tells_in_its_unit(text: str, number: Leaf, param: str) -> bool:
    """Return whether a text tells a number, and not of another unit than the param's name has."""
    own = _unit_of(param)
    others = {word for words in (*_UNITS.values(), _POINTS) if words != own for word in words}
    for found in re.finditer(_spelt(number), text, re.IGNORECASE):
        following = re.match(r"\s*([a-z]+)", text[found.end() :].lower())
        if own is None or following is None or following[1] not in others:
            return True
    return False


# --- numbers in sentences ---------------------------------------------------------------------------------------------


def _spelt(number: Leaf) -> str:
    """Return a pattern for a number as sentences write it."""
    value = number.value if isinstance(number.value, int | float) else 0
    # The 3 of Y3, and that of t_3, belong to a name.
    found = [rf"(?<![\w.]){re.escape(f'{value:g}')}(?![\d]|\.\d)"]
    if value == 1:
        found.append(rf"\bone(?={_AFTER_ONE})")
    elif value == int(value) and 0 <= value < len(_WORDS):
        found.append(rf"\b{_WORDS[int(value)]}\b(?!-)")
    elif value in _TENS:
        found.append(rf"\b{_TENS[int(value)]}\b(?!-)")
    return "|".join(found)


def _tells(text: str, number: Leaf) -> bool:
    return re.search(_spelt(number), text, re.IGNORECASE) is not None


def _tells_of(text: str, number: Leaf, param: str) -> bool:
    """Return whether a text tells a number of what a param is called after: ``shot_s`` and "fifteen seconds a shot"."""
    *parts, last = param.lower().split("_")
    unit = _unit_of(param)
    things = {word for part in (*parts, *(() if unit else (last,))) for word in (part, f"{part}s")}
    for found in re.finditer(_spelt(number), text, re.IGNORECASE):
        following = re.findall(r"[a-z]+", text[found.end() : found.end() + 40].lower())[:_NEXT_WORDS]
        # Of a name with a unit: "three jewels" is another number than jewel_points: 3, and "3 per jewel" is that one.
        about = following if unit is None or set(following[:1]) & _FOR_EACH else ()
        if set(unit or ()) & set(following) or things & set(about):
            return True
    return False


# --- what depends on a param ------------------------------------------------------------------------------------------


def _depends(rule: str, param: str, subject: Subject) -> bool:
    """Return whether a param stands in a rule, or in a timer or a phase on which the rule waits."""
    model = subject.scenario.rules[rule]
    paths: list[Path] = [("rules", rule), *_waited_for(model)]
    return any(_stands_in(node_at(subject.tree, path), param) for path in paths)


def _waited_for(rule: Rule) -> Iterator[Path]:
    for model, _ in visit(rule):
        match model:
            case triggers.TimerExpired() | conditions.TimerIs() | actions.TimerAction():
                yield "timers", model.timer
            case triggers.PhaseEntered() | actions.SetPhase():
                yield "phases", model.phase


def _stands_in(node: Node | None, param: str) -> bool:
    return any(leaf.param == param for leaf in _leaves(node))


def _leaves(node: Node | None) -> Iterator[Leaf]:
    """Yield the single values of what is written."""
    if isinstance(node, Leaf):
        yield node
    inner = node.entries.values() if isinstance(node, Entries) else node.items if isinstance(node, Items) else ()
    for one in inner:
        yield from _leaves(one)
