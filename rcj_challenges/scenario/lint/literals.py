"""Lint of texts that are the names of values: in payloads and the broadcast, and in what robots must tell."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any, get_args

from rcj_challenges.scenario.lint.suspect import Subject, Suspect
from rcj_challenges.scenario.models.actions import Emit
from rcj_challenges.scenario.models.base import Strict
from rcj_challenges.scenario.models.conditions import Message
from rcj_challenges.scenario.models.scenario import Broadcast
from rcj_challenges.scenario.models.state import DrawValue, WordValue
from rcj_challenges.scenario.tree import Path

_WORDS = frozenset(get_args(WordValue.model_fields["word"].annotation))

_OR_MEANT = "; that the text is meant, says a test that expects it in the event's payload"


def check_literals(subject: Subject) -> Iterator[Suspect]:
    """Texts that are told to programs, or in a payload, where the value of that name is meant."""
    scenario = subject.scenario
    kept: dict[str, Mapping[str, Any]]
    kept = {"counter": scenario.counters, "flag": scenario.flags, "timer": scenario.timers, "draw": scenario.draws}
    for model, path in subject.models:
        for at, value in _texts(model, path):
            written = f"{{word: {value}}}" if value in _WORDS else ""
            if not written and isinstance(model, Broadcast):
                # In a payload the name itself may be meant: which of several draws it was about.
                kinds = [kind for kind, names in kept.items() if value in names]
                written = " or ".join(f"{{{kind}: {value}}}" for kind in kinds)
            if written and not (isinstance(model, Emit) and _is_meant(model, str(at[-1]), value, subject)):
                yield Suspect(
                    "text_instead_of_value",
                    at,
                    f"it is told as the text '{value}', the same each time",
                    f"write {written} for the value{_OR_MEANT if isinstance(model, Emit) else ''}",
                )


def check_told_names(subject: Subject) -> Iterator[Suspect]:
    """Messages that robots must tell letter by letter, where what the draw of that name has decided is meant."""
    draws = subject.scenario.draws
    for model, path in subject.models:
        if not isinstance(model, Message) or isinstance(model.text, DrawValue):
            continue
        is_list = isinstance(model.text, tuple)
        for text in model.text if isinstance(model.text, tuple) else (model.text,):
            if isinstance(text, str) and text in draws:
                value = f"{{draw: {text}}}"
                alone = f"text: {value} for what is drawn, without other texts beside it"
                yield Suspect(
                    "text_instead_of_value",
                    (*path, "text"),
                    f"it is the text '{text}' itself that must be told",
                    f"write {alone if is_list else f'{value} for what is drawn'}",
                )


def _is_meant(emit: Emit, key: str, text: str, subject: Subject) -> bool:
    """Return whether a payload's text is meant as one: a test expects it, or another rule tells another text there."""
    expected = (event for test in subject.scenario.expect.values() for event in test.events or ())
    if any(event.event == emit.event and event.payload.get(key) == text for event in expected):
        return True
    # Which of several it was, a limit or a foul; no text is written as `time_left_s` is.
    told = {one.payload.get(key) for one, _ in subject.models if isinstance(one, Emit) and one.event == emit.event}
    return "_" not in text and any(isinstance(other, str) and other not in _WORDS for other in told)


def _texts(model: Strict, path: Path) -> Iterator[tuple[Path, str]]:
    """Yield what is told as a text, with where it stands."""
    told: list[tuple[Path, Mapping[str, Any]]] = []
    if isinstance(model, Broadcast):
        told = [((*path, "fields"), model.fields)]
        told += [((*path, "only", whom), fields) for whom, fields in (model.only or {}).items()]
    elif isinstance(model, Emit):
        told = [((*path, "payload"), model.payload)]
    return (((*at, key), value) for at, values in told for key, value in values.items() if isinstance(value, str))
