"""The differences that a test reports of events, of the end and of counters."""

import pytest

from rcj_challenges.core.play import Event
from rcj_challenges.expect.compare import event_differences
from rcj_challenges.expect.runner import run_test
from rcj_challenges.scenario.load import load_text
from rcj_challenges.scenario.models.scenario import Expectation, ExpectedEvent

DEFAULT = Expectation.model_fields["ignore"].default


def came(*names, **payload):
    """Return events of these names, ten ticks apart."""
    return [Event(10 * number, name, payload) for number, name in enumerate(names, start=1)]


def wanted(*names, **more):
    return [ExpectedEvent(event=name, **more) for name in names]


OWN_IGNORED = (
    "ignore: [HIT] replaces the list that holds otherwise (MATCH_START, KICKOFF, MATCH_FINISH): add MATCH_START to it"
)
OFF = "up to 0.033 s off is allowed, more by tolerance_s beside at_s"
BY_TWO = [Event(10, "GOAL", {"by": "Y1"}), Event(20, "GOAL", {"by": "Y2"})]


@pytest.mark.parametrize(
    ("found", "expected", "lines"),
    [
        ((), (), []),
        (came(*"AABA"), wanted(*"AABA"), []),
        (came("X", *"ABCABC"), wanted(*"ABCABC"), ["superfluous: X at 0.32 s"]),
        (
            came("A", "C"),
            [*wanted("A"), *wanted("B", at_s=0.64, payload={"points": 2}), *wanted("C")],
            ["missing: B at 0.64 s (points 2), event 2 of the test"],
        ),
        (
            came("A", "B"),
            wanted("B", "A"),
            ["out of order: A at 0.32 s, event 2 of the test, came earlier than the test has it"],
        ),
        (
            came("B", "C", "A", ball="red_1"),
            wanted(*"ABC"),
            ["out of order: A at 0.96 s (ball red_1), event 1 of the test, came later than the test has it"],
        ),
        pytest.param(
            [Event(10, "HOME", {}), Event(10, "WRONG", {})],
            wanted("WRONG", "HOME"),
            [
                (
                    "out of order: HOME at 0.32 s, event 2 of the test, came earlier than the test has it; "
                    "events of one tick come in the order in which their rules are judged"
                )
            ],
            id="in one tick",
        ),
        pytest.param(
            came("A", "B"),
            [*wanted("B"), *wanted("A", at_s=9)],
            ["superfluous: A at 0.32 s", "missing: A at 9 s, event 2 of the test"],
            id="elsewhere and at another time it is another event",
        ),
        (BY_TWO, wanted("GOAL", payload={"by": "Y2"}), ["superfluous: GOAL at 0.32 s (by Y1)"]),
        (BY_TWO, wanted("GOAL", at_s=0.64), ["superfluous: GOAL at 0.32 s (by Y1)"]),
        pytest.param(
            BY_TWO,
            wanted("GOAL", at_s=1.0),
            [
                "superfluous: GOAL at 0.32 s (by Y1)",
                f"differs: event 1 (GOAL): expected at 1 s, came at 0.64 s; {OFF}",
            ],
            id="where none is in time, the nearer one",
        ),
        (
            came("X", "GOAL", points=1),
            wanted("GOAL", payload={"points": 2, "by": "Y1"}),
            [
                "superfluous: X at 0.32 s (points 1)",
                "differs: event 1 (GOAL): expected points 2, is 1",
                "differs: event 1 (GOAL): expected by Y1, is nothing",
            ],
        ),
        pytest.param(
            came("X", *"A" * 600),
            wanted(*"A" * 600),
            ["superfluous: X at 0.32 s", "missing: A, event 1 of the test", "superfluous: A at 192.32 s"],
            id="a flood is compared by position",
        ),
        pytest.param(
            came("KICKOFF", "KICKOFF"),
            wanted("KICKOFF"),
            ["superfluous: KICKOFF at 0.64 s"],
            id="ignored events count where one is expected",
        ),
    ],
)
def test_events_are_compared_in_their_order(found, expected, lines):
    assert [one.line for one in event_differences(found, expected, DEFAULT)] == lines


def test_ten_differences_of_events_are_shown_and_then_how_many_more():
    lines = [one.line for one in event_differences([], wanted(*"A" * 35), DEFAULT)]
    assert lines[9:] == ["missing: A, event 10 of the test", "and 25 more differences of events"]
    (last,) = [*event_differences([], wanted(*"A" * 11), DEFAULT)][10:]
    assert last.line == "and 1 more difference of events"


def test_a_list_of_ignored_events_replaces_the_default():
    (difference,) = event_differences(came("MATCH_START"), [], ("HIT",))
    assert difference.line == f"superfluous: MATCH_START at 0.32 s; {OWN_IGNORED}"
    (difference,) = event_differences(came("HIT"), [], ())
    assert difference.line == "superfluous: HIT at 0.32 s"


HEAD = "schema_version: 2\nid: it\ntitle: It\nextends: soccersim_v2\nmatch: {halves: 2, half_s: 10}\n"
GOAL = "rules: {goal: {triggers: [{trigger: enters, entity: ball, zone: blue_goal}], actions: [%s], says: A goal.}}\n"
SCORES = "{at_s: 1, place: {ball: [0, 0.8]}}"


def differences(action, keyframe, test, more=""):
    text = f"{HEAD}{more}{GOAL % action}expect: {{it: {{keyframes: [{keyframe}], {test}}}}}"
    return list(run_test(load_text(text), "it").differences)


class TestExpectEnded:
    @pytest.mark.parametrize(
        ("action", "keyframe", "lasts_s", "ended"),
        [
            ("{action: end, what: match}", SCORES, 5, "match"),
            ("{action: end}", SCORES, 5, "half"),
            ("{action: end}", "{at_s: 1}", 5, "none"),
            ("{action: end}", "{at_s: 1}", 10, "half"),
        ],
    )
    def test_what_is_over_at_the_end_is_compared(self, action, keyframe, lasts_s, ended):
        for one in ("match", "half", "none"):
            found = differences(action, keyframe, f"lasts_s: {lasts_s}, ended: {one}")
            found = [line for line in found if not line.startswith("note: ")]  # which rule it was
            assert found == ([] if one == ended else [f"ended: expected {one}, is {ended}"])

    def test_a_match_that_a_rule_ends_when_the_half_is_over(self):
        rule = "rules: {over: {triggers: [{trigger: half_ended}], actions: [{action: end, what: match}]}}\n"
        text = f"{HEAD}{rule}expect: {{it: {{keyframes: [{{at_s: 1}}], lasts_s: 10, ended: match}}}}"
        assert run_test(load_text(text), "it").differences == ()


class TestExpectToleranceCounters:
    COUNTS = "{action: count, counter: run_s, to: {word: time_s}}"
    KEPT = "counters: {run_s: {}}\n"

    @pytest.mark.parametrize(
        ("test", "lines"),
        [
            ("counters: {run_s: 1.024}", []),
            ("counters: {run_s: 1}", ["counter run_s: expected 1, is 1.024"]),
            ("counters: {run_s: 1}, tolerance_counters: 0.033", []),
            (
                "counters: {run_s: 1}, tolerance_counters: 0.02",
                ["counter run_s: expected 1, is 1.024; up to 0.02 off is allowed"],
            ),
        ],
    )
    def test_a_counter_may_be_so_far_off(self, test, lines):
        assert differences(self.COUNTS, SCORES, f"lasts_s: 2, {test}", self.KEPT) == lines

    def test_so_may_that_of_one_robot(self):
        counts = self.COUNTS.replace("counter: run_s", "counter: run_s, entity: Y1")
        test = "lasts_s: 2, counters: {run_s: {Y1: 1, Y2: 0}}, tolerance_counters: 0.01"
        assert differences(counts, SCORES, test, "counters: {run_s: {per: robots}}\n") == [
            "counter run_s of Y1: expected 1, is 1.024; up to 0.01 off is allowed"
        ]
