"""Messages to the referee in the file: what is refused, what lint says, what a file without them is written as."""

import pytest

from rcj_challenges.scenario.heard import referee_listens, robots_that_speak
from rcj_challenges.scenario.lint import lint
from rcj_challenges.scenario.load import load, load_text
from tests.scenario.writing import complaints

HEAD = "schema_version: 1\nid: it\ntitle: It\nextends: soccersim_v2\nmatch: {half_s: 60}\n"
RULE = "rules: {r: {triggers: [{trigger: tells, %s}], actions: [{action: emit, event: E}], says: Told.}}\n"


def found(more: str, *kinds: str) -> list[str]:
    """Return what lint says of these kinds, without where it is."""
    return [str(one).partition("warning: ")[2] for one in lint(load_text(HEAD + more)) if one.kind in kinds]


@pytest.mark.parametrize(
    ("trigger", "complaint"),
    [
        ("entity: ball", "rules.r.triggers[0] (tells): 'ball' is a ball; expected a robot"),
        ("text: {draw: no}", "rules.r.triggers[0] (tells): unknown draw 'no'"),
        ("is_a: text", "rules.r.triggers[0] (tells).is_a: expected number or position, found 'text'"),
        (
            "text: 'a '",
            (
                "rules.r.triggers[0] (tells).text: 'a ' is never heard: a message has single blanks between its words, and none "
                "at its ends"
            ),
        ),
        ("text: []", "rules.r.triggers[0] (tells).text: must have at least 1 entry, found an empty list"),
    ],
)
def test_what_cannot_be_listened_for_is_refused(trigger, complaint):
    (told,) = complaints(RULE % trigger)
    assert told.startswith(complaint)


@pytest.mark.parametrize(
    ("where", "more"),
    [
        (RULE % "entity: Y1", "entrants: {yellow: {robots: {Y1: null}}}"),
        (
            RULE % "entity: [Y1, Y2]",
            "robots: {Y2: {without: [team emitter]}}\nentrants: {yellow: {robots: {Y1: null}}}",
        ),
        (
            (
                "rules: {r: {triggers: [{trigger: half_ended}], conditions: [{condition: told, entity: Y1}],\n"
                "            actions: [{action: emit, event: E}], says: Told.}}\n"
            ),
            "entrants: {yellow: {robots: {Y1: null}}}",
        ),
        (
            (
                "rules: {r: {triggers: [{trigger: half_ended}], actions: [{action: score, entrant: blue, points: {told: Y1}}],\n"
                "            says: Told.}}\n"
            ),
            "entrants: {yellow: {robots: {Y1: null}}}",
        ),
    ],
)
def test_who_cannot_tell_anything_is_named(where, more):
    (told,) = found(where + more + "\n", "never_heard")
    assert (
        "can tell the referee anything: no program, or no team_emitter on board; listen to robots that have both"
        in told
    )
    assert found(where, "never_heard") == []


@pytest.mark.parametrize(
    ("trigger", "kind"),
    [
        ("is_a: number", None),
        ("is_a: position", "placeholder_never_filled"),
        ("text: hello", "placeholder_at_times_empty"),
    ],
)
def test_a_number_in_a_sentence_must_be_told(trigger, kind):
    rule = RULE.replace("says: Told.", "says: '{entity} tells {measured}.'") % trigger
    kinds = {one.kind for one in lint(load_text(HEAD + rule)) if "placeholder" in one.kind}
    assert kinds == ({kind} if kind else set())


def test_with_another_trigger_that_measures_it_may_stay_empty():
    triggers = "[{trigger: time_reached, at_s: 1}, {trigger: tells, entity: Y1%s}]"
    rule = "rules: {r: {triggers: %s, actions: [{action: emit, event: E}], says: 'After {measured}.'}}\n"
    (told,) = found(rule % (triggers % ""), "placeholder_at_times_empty")
    assert "which may hear what is no number; write is_a: number there, or give that trigger a rule of its own" in told
    assert found(rule % (triggers % ", is_a: number"), "placeholder_at_times_empty") == []


def test_the_referee_listens_only_where_a_rule_or_the_broadcast_asks():
    assert not referee_listens(load("match").scenario)
    assert referee_listens(load_text(HEAD + RULE % "entity: Y1").scenario)
    assert referee_listens(load_text(HEAD + "broadcast: {fields: {said: {told: Y1}}}\n").scenario)


def test_robots_of_2021_have_no_emitter_unless_they_are_given_one():
    old = HEAD.replace("soccersim_v2", "soccersim_2021")
    given = "robots: {Y3: {devices: {radio: {device: team_emitter}}}}\n"
    assert robots_that_speak(load_text(old).scenario) == []
    assert robots_that_speak(load_text(old + given).scenario) == ["Y3"]


def test_a_test_without_messages_is_written_as_before():
    block = "expect: {x: {keyframes: [{at_s: 1%s}], lasts_s: 2}}\n"
    silent, telling = (load_text(HEAD + block % more).resolved["expect"]["x"]["keyframes"][0]
                       for more in ("", ", tells: {Y1: [1, 2], Y2: 3, B1: hello}"))  # fmt: skip
    assert "tells" not in silent
    assert telling["tells"] == {"Y1": [1, 2], "Y2": 3, "B1": "hello"}
