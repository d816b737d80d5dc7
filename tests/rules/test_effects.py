"""What words declare about themselves is whole: readers of rules see nothing else of them."""

from typing import get_args

import pytest

from rcj_challenges.rules.actions import ACTIONS
from rcj_challenges.rules.effects import Effect, Moment
from rcj_challenges.rules.triggers import TRIGGERS
from rcj_challenges.scenario.load import load_text
from rcj_challenges.scenario.walk import walk
from scripts.write_reference import Example


def models_of(kind, word):
    return [one for one, _ in walk(load_text(Example(kind, (word.name(),), word.EXAMPLE).whole).scenario.rules)]


@pytest.mark.parametrize("word", ACTIONS.words(), ids=lambda word: word.name())
def test_each_action_has_an_effect(word):
    actions = [one for one in models_of("actions", word) if isinstance(one, word)]
    assert actions
    assert all(action.effects() for action in actions)


def test_each_kind_of_effect_and_moment_is_declared_by_a_word():
    actions = [one for word in ACTIONS.words() for one in models_of("actions", word) if isinstance(one, word)]
    triggers = [one for word in TRIGGERS.words() for one in models_of("triggers", word) if isinstance(one, word)]
    declared = {type(effect) for action in actions for effect in action.effects()}
    declared |= {type(trigger.moment()) for trigger in triggers}
    # No example places a layout: it would need one.
    assert {kind.__name__ for kind in {*get_args(Effect), *get_args(Moment)} - declared} == {"PlacesLayout"}
