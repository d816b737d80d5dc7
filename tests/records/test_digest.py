"""Equal runs have equal digests; whatever decides a result changes one of them, and nothing else does."""

from pathlib import Path

import pytest

from rcj_challenges.core.play import Event
from rcj_challenges.records.digest import StatesDigest, given_values, inputs_digest, run_digest
from rcj_challenges.records.result import read_result
from rcj_challenges.rules.fields import Strict
from rcj_challenges.scenario.load import load, load_resolved, load_text
from tests.made_up_runs import small_scenario, write_made_up_run

HEAD = "schema_version: 2\nid: it\ntitle: It\nextends: soccersim_v2\n"
RULE = "{triggers: [{trigger: half_started}], actions: [{action: emit, event: %s}]}"
PROGRAMS = {"blue": "00", "yellow": "11"}


def inputs(text: str = "", overrides: tuple[str, ...] = (), seed: int = 7, programs: dict | None = None) -> str:
    return inputs_digest(load_text(HEAD + text, overrides).scenario, seed, PROGRAMS if programs is None else programs)


def states(ticks: list[bytes], events: list[Event], half: int = 1) -> str:
    digest = StatesDigest()
    digest.half(half)
    for state in ticks:
        digest.state(state)
    for event in events:
        digest.event(event)
    return digest.hexdigest()


def test_the_same_run_has_the_same_digests_whenever_it_is_played(tmp_path: Path) -> None:
    results = [read_result(write_made_up_run(tmp_path, ticks=60)) for _ in range(2)]
    (found,) = {(result.inputs, result.states, result.digest) for result in results}
    assert [len(one) for one in found] == [64, 64, 64]
    assert run_digest(found[0], found[1]) == found[2]


# --- inputs -----------------------------------------------------------------------------------------------------------


def test_the_inputs_of_a_fixed_scenario_never_change_without_a_new_version() -> None:
    found = inputs_digest(small_scenario(), 7, PROGRAMS)
    assert found == "349a33f4c3f3c25df0c44b78cf60d0e7008416097e32402098aae3d349375bad"


@pytest.mark.parametrize(
    ("change", "what"),
    [
        ({"text": f"rules: {{b: {RULE % 'B'}, a: {RULE % 'A'}}}\n"}, "the order of rules"),
        ({"text": f"rules: {{a: {RULE % 'A'}}}\n"}, "a missing rule"),
        ({"overrides": ("match.half_s=61",)}, "a value"),
        ({"seed": 8}, "the seed"),
        ({"programs": {"blue": "11", "yellow": "00"}}, "who plays where"),
    ],
)
def test_what_is_played_changes_the_inputs(change: dict, what: str) -> None:
    usual = {"text": f"rules: {{a: {RULE % 'A'}, b: {RULE % 'B'}}}\n"}
    assert inputs(**usual) != inputs(**(usual | change)), what


def test_a_whole_number_is_the_same_with_and_without_a_fraction() -> None:
    text = "params: {x: 3}\nmatch: {half_s: {param: x}}\n"
    assert inputs(text, ("x=15",)) == inputs(text, ("x=15.0",)) == inputs("match: {half_s: 15}\n")
    assert inputs(text, ("x=15",)) != inputs(text, ("x=15.5",))


def test_integer_and_fraction_in_a_payload_have_different_digests() -> None:
    rule = "rules: {a: {triggers: [{trigger: half_started}], actions: [{action: emit, event: A, payload: {v: %s}}]}}\n"
    assert inputs(rule % "15") != inputs(rule % "15.0")


def test_explicit_default_value_has_the_digest_of_an_omitted_one() -> None:
    assert inputs("flags: {n: {}}\n") == inputs("flags: {n: {initial: false}}\n")
    assert inputs("counters: {n: {}}\n") != inputs("counters: {n: {initial: 1}}\n")


def test_a_scenario_read_from_its_record_has_the_same_inputs() -> None:
    loaded = load("match")
    again = load_resolved(loaded.resolved)
    assert inputs_digest(again.scenario, 1, {}) == inputs_digest(loaded.scenario, 1, {})


def test_neither_a_new_optional_key_nor_a_moved_field_nor_the_order_of_keys_changes_the_inputs() -> None:
    class Before(Strict):
        a: float
        b: bool = True

    class After(Strict):
        added: str | None = None
        b: bool = True
        also: tuple[int, ...] = ()
        a: float

    before, after = Before(a=2), After(a=2)
    assert given_values(before) == given_values(after) == {"a": 2}
    both = Before(a=2, b=False), After(b=False, a=2)
    assert [list(given_values(model).items()) for model in both] == [[("a", 2), ("b", False)]] * 2


def test_one_is_not_true() -> None:
    class Model(Strict):
        value: int | bool = 1

    assert given_values(Model(value=True)) == {"value": True}


# --- states -----------------------------------------------------------------------------------------------------------

TICKS = [b"12345678", b"abcdefgh"]
GOAL = Event(5, "GOAL", {"team_name": "Hanse"})


def test_the_states_of_a_fixed_run_never_change_without_a_new_version() -> None:
    assert states(TICKS, [GOAL]) == "c4783c4ffdcbf62187f6e0d4ac8d124384fac89805885371add0fa7fb9bbd63d"


@pytest.mark.parametrize(
    ("change", "what"),
    [
        ({"half": 2}, "the half"),
        ({"ticks": [b"12345678abcdefgh"]}, "how states are cut into ticks"),
        ({"ticks": [b"12345678", b"abcdefgi"]}, "one bit of a state"),
        ({"events": []}, "a missing event"),
        ({"events": [Event(6, "GOAL", {"team_name": "Hanse"})]}, "the tick of an event"),
        ({"events": [Event(5, "GOAL", {"team_name": "Alster"})]}, "the payload of an event"),
    ],
)
def test_what_happens_changes_the_states(change: dict, what: str) -> None:
    usual = {"ticks": TICKS, "events": [GOAL]}
    assert states(**usual) != states(**(usual | change)), what


def test_a_programs_own_words_are_no_part_of_the_states() -> None:
    def with_detail(detail: str) -> str:
        return states([], [Event(5, "PROGRAM_FAULT", {"robot_name": "Y1", "kind": "crash", "detail": detail})])

    assert with_detail("at 0x7f00") == with_detail("at 0x7fff")
