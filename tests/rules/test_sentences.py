"""The rule sheet describes each word as the sentence beside its example says."""

import pytest

from rcj_challenges.rules.actions.place import Place
from rcj_challenges.rules.places import place_of
from rcj_challenges.scenario.load import load_text
from rcj_challenges.scenario.walk import walk
from rcj_challenges.views.sheet.phrasebook import Phrasebook
from scripts.write_reference import VOCABULARIES, Example

WORDS = [
    (kind, word, getattr(word, "VALUE", word).EXAMPLE)
    for kind, vocabulary in VOCABULARIES.items()
    for word in vocabulary.words()
    if word.SENTENCE
]


@pytest.mark.parametrize(("kind", "word", "example"), WORDS, ids=[f"{one[0]}-{one[1].name()}" for one in WORDS])
def test_word_of_an_example_is_described_as_beside_it(kind, word, example):
    loaded = load_text(Example(kind, (word.name(),), word.EXAMPLE or example).whole)
    scenario, phrases = loaded.scenario, Phrasebook(loaded.scenario, loaded.roster)
    sentences = []
    for rule in (*scenario.rules.values(), None):
        models = [
            one for one, _ in walk((scenario.broadcast, scenario.robots, scenario.kits) if rule is None else rule)
        ]
        models += [place_of(one.at) for one in models if isinstance(one, Place) and one.at is not None]
        own = phrases if rule is None else phrases.within(rule)
        needed = () if kind in ("chassis", "devices") else (own,)
        sentences += [one.describe(*needed) for one in models if isinstance(one, word)]
    assert word.SENTENCE in sentences
