"""The sentences of the rule sheet about the words of an example."""

from __future__ import annotations

from typing import Any

from pydantic import BaseModel

from rcj_challenges.rules.actions.place import Place
from rcj_challenges.rules.base import Word
from rcj_challenges.rules.places import place_of
from rcj_challenges.scenario.load import load_text
from rcj_challenges.scenario.walk import walk
from rcj_challenges.views.sheet.phrasebook import Phrasebook


def sheet_sentences(word: type[BaseModel], kind: str, scenario_text: str) -> list[str]:
    """Return how the rule sheet describes a word in a scenario; nothing for what is not a word of its own.

    The kinds ``devices`` and ``chassis`` are looked for in robots and kits, all others in rules and broadcasts.
    """
    if not issubclass(word, Word):
        return []
    loaded = load_text(scenario_text)
    scenario, phrases = loaded.scenario, Phrasebook(loaded.scenario, loaded.roster)
    parts: list[tuple[Any, tuple[Phrasebook, ...]]] = [
        *((rule, (phrases.within(rule),)) for rule in scenario.rules.values()),
        (scenario.broadcast, (phrases,)),
    ]
    if kind in ("devices", "chassis"):
        parts = [(scenario.robots if kind == "devices" else scenario.kits, ())]
    sentences = []
    for part, needed in parts:
        models: list[Any] = [one for one, _ in walk(part)]
        models += [place_of(one.at) for one in models if isinstance(one, Place) and one.at is not None]
        sentences += [one.describe(*needed) for one in models if isinstance(one, word)]
    return list(dict.fromkeys(sentences))
