"""Events as lines of text for terminals."""

from rcj_challenges.facts.play import Event
from rcj_challenges.views.sentences import event_line


def test_an_event_says_when_it_came_and_what_is_told_with_it():
    told = event_line(Event(1000, "TOLD", {"by": "Y3", "far_m": 0.25}))
    assert told == " 0:32.0  TOLD  by Y3, far_m 0.25"


def test_what_there_was_none_of_is_told_as_none():
    assert event_line(Event(0, "TOLD", {"by": None, "far_m": None})).endswith("TOLD  by none, far_m none")
