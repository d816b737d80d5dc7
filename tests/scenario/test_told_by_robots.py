"""Messages to the referee in the file: what is refused, what lint says, what a file without them is written as."""

import pytest

from rcj_challenges.scenario.heard import referee_listens, robots_that_speak
from rcj_challenges.scenario.lint.table import lint
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
                "rules.r.triggers[0] (tells).text: 'a ' is heard otherwise: with single blanks between its words, and none "
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
        ("text: [hello, 3]", "placeholder_at_times_empty"),
        ("text: hello", "placeholder_never_filled"),
        ("text: [1, '2']", None),
        ("text: {draw: number}", None),
        ("text: {draw: colour}", "placeholder_never_filled"),
    ],
)
def test_a_number_in_a_sentence_must_be_told(trigger, kind):
    rule = RULE.replace("says: Told.", "says: '{entity} tells {measured}.'") % trigger
    draws = "draws: {number: {values: [1, 2]}, colour: {values: [red, green]}}\n"
    kinds = {one.kind for one in lint(load_text(HEAD + draws + rule)) if "placeholder" in one.kind}
    assert kinds == ({kind} if kind else set())


@pytest.mark.parametrize(
    ("wanted", "reason"),
    [
        ("text: far, is_a: number", "'far' is no number"),
        ("text: [2, 3], is_a: position", "none of 2, 3 is a position"),
        ("text: 10000000000", "10000000000 is too large to be heard as a number"),
        ("text: {draw: odd}", "none of 'a  b', ' c' is ever heard"),
        ("text: [far, 2], is_a: number", None),
        ("text: '0.1, 0.2', is_a: position", None),
        ("text: {draw: odd}, is_a: number", "none of 'a  b', ' c' is a number"),
        ("text: {draw: sure}", None),
    ],
)
def test_what_no_message_can_be_is_never_heard(wanted, reason):
    draws = "draws: {odd: {values: ['a  b', ' c']}, sure: {values: [true, false]}}\n"
    asked = RULE.replace("actions", "conditions: [{condition: told, entity: Y1, %s}], actions") % ("", wanted)
    for rule, where in ((RULE % wanted, "triggers[0] (tells)"), (asked, "conditions[0] (told)")):
        told = found(draws + rule.replace("tells, }", "tells}"), "never_heard")
        assert [one.partition(": ")[0] for one in told] == ([f"rules.r.{where}"] if reason else [])
        assert not reason or reason in told[0]


def test_where_nobody_hears_the_referee_it_has_no_channel():
    deaf = "kits: {v2: {devices: {supervisor receiver: null}}}\n"
    (told,) = found(deaf + RULE % "entity: Y1", "never_heard")
    assert "the referee has no channel: no robot and no kit has a supervisor_receiver; give one of them one" in told


def test_the_broadcast_asks_in_vain_of_whom_nobody_hears():
    more = "robots: {Y2: {without: [team emitter]}}\nbroadcast: {fields: {a: {told: Y1}, b: {told: Y2}}}\n"
    (told,) = found(more, "never_heard")
    assert told.startswith("broadcast.fields.b.told: none of 'Y2' can tell the referee anything")


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
