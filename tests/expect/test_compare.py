"""What a test says of events, of the end and of counters that are others than it expects."""

import pytest

from rcj_challenges.core.play import Event
from rcj_challenges.expect.compare import event_differences
from rcj_challenges.expect.runner import run_test
from rcj_challenges.scenario.load import load_text
from rcj_challenges.scenario.models.scenario import Expectation, ExpectedEvent
from tests.scenario.writing import complaints

DEFAULT = Expectation.model_fields["ignore"].default


def came(*names, **payload):
    """Return events of these names, ten ticks apart."""
    return [Event(10 * number, name, payload) for number, name in enumerate(names, start=1)]


def wanted(*names, **more):
    return [ExpectedEvent(event=name, **more) for name in names]


def told(found, expected, ignored=DEFAULT):
    return list(event_differences(found, expected, ignored))


class TestEventsThatBelongTogether:
    @pytest.mark.parametrize("names", [(), ("A",), ("A", "A", "B", "A")])
    def test_the_same_events_in_the_same_order_are_no_difference(self, names):
        assert told(came(*names), wanted(*names)) == []

    def test_one_too_many_at_the_front_is_one_difference(self):
        assert told(came("X", *"ABCABC"), wanted(*"ABCABC")) == ["superfluous: X at 0.32 s"]

    def test_one_that_lacks_is_one_difference_with_its_number(self):
        late = wanted("B", at_s=0.64, payload={"points": 2})
        assert told(came("A", "C"), [*wanted("A"), *late, *wanted("C")]) == [
            "missing: B at 0.64 s (points 2), event 2 of the test"
        ]

    def test_another_order_is_told_as_such(self):
        assert told(came("A", "B"), wanted("B", "A")) == [
            "out of order: A at 0.32 s, event 2 of the test, came earlier than the test has it"
        ]
        assert told(came("B", "C", "A", ball="red_1"), wanted("A", "B", "C")) == [
            "out of order: A at 0.96 s (ball red_1), event 1 of the test, came later than the test has it"
        ]

    def test_in_one_tick_events_come_in_the_order_of_the_rules(self):
        at_once = [Event(10, "HOME", {}), Event(10, "WRONG", {})]
        (line,) = told(at_once, wanted("WRONG", "HOME"))
        assert line.startswith("out of order: HOME at 0.32 s, event 2 of the test, came earlier than the test has it")
        assert line.endswith("; events of one tick come in the order in which their rules are judged")

    def test_what_comes_elsewhere_at_another_time_or_with_another_payload_is_another_event(self):
        late = wanted("B", *"A", at_s=9)
        assert [line.partition(":")[0] for line in told(came("A", "B"), [*wanted("B"), late[1]])] == [
            "superfluous",
            "missing",
        ]

    def test_of_equal_names_the_one_with_the_payload_or_the_time_is_meant(self):
        goals = [Event(10, "GOAL", {"by": "Y1"}), Event(20, "GOAL", {"by": "Y2"})]
        assert told(goals, wanted("GOAL", payload={"by": "Y2"})) == ["superfluous: GOAL at 0.32 s (by Y1)"]
        assert told(goals, wanted("GOAL", at_s=0.64)) == ["superfluous: GOAL at 0.32 s (by Y1)"]
        # Where none is in time, the nearer one.
        assert told(goals, wanted("GOAL", at_s=1.0)) == [
            "superfluous: GOAL at 0.32 s (by Y1)",
            (
                "differs: event 1 (GOAL): expected at 1 s, came at 0.64 s; up to 0.033 s off is allowed, more by "
                "tolerance_s beside at_s"
            ),
        ]

    def test_what_belongs_together_and_differs_says_in_what(self):
        assert told(came("X", "GOAL", points=1), wanted("GOAL", payload={"points": 2, "by": "Y1"})) == [
            "superfluous: X at 0.32 s (points 1)",
            "differs: event 1 (GOAL): expected points 2, is 1",
            "differs: event 1 (GOAL): expected by Y1, is nothing",
        ]

    def test_ten_differences_are_told_and_then_how_many_more(self):
        lines = told([], wanted(*"A" * 35))
        assert lines[9:] == ["missing: A, event 10 of the test", "and 25 more differences of events"]
        assert told([], wanted(*"A" * 11))[10:] == ["and 1 more difference of events"]

    def test_a_flood_of_events_is_compared_by_position(self):
        assert told(came(*"A" * 600), wanted(*"A" * 600)) == []
        flood = told(came("X", *"A" * 600), wanted(*"A" * 600))
        assert flood == ["superfluous: X at 0.32 s", "missing: A, event 1 of the test", "superfluous: A at 192.32 s"]

    def test_a_list_of_ignored_events_replaces_the_one_that_holds_otherwise(self):
        assert told(came("MATCH_START"), [], ("HIT",)) == [
            (
                "superfluous: MATCH_START at 0.32 s; ignore: [HIT] replaces the list that holds otherwise (MATCH_START, "
                "KICKOFF, MATCH_FINISH): add MATCH_START to it"
            )
        ]
        assert told(came("HIT"), [], ()) == ["superfluous: HIT at 0.32 s"]
        # It is in the list: a second one came where one is expected by name.
        assert told(came("KICKOFF", "KICKOFF"), wanted("KICKOFF")) == ["superfluous: KICKOFF at 0.64 s"]


HEAD = "schema_version: 1\nid: it\ntitle: It\nextends: soccersim_v2\nmatch: {halves: 2, half_s: 10}\n"
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
            said = differences(action, keyframe, f"lasts_s: {lasts_s}, ended: {one}")
            said = [line for line in said if not line.startswith("note: ")]  # which rule it was
            assert said == ([] if one == ended else [f"ended: expected {one}, is {ended}"])

    def test_a_match_that_a_rule_ends_when_the_half_is_over(self):
        rule = "rules: {over: {triggers: [{trigger: half_ended}], actions: [{action: end, what: match}]}}\n"
        text = f"{HEAD}{rule}expect: {{it: {{keyframes: [{{at_s: 1}}], lasts_s: 10, ended: match}}}}"
        assert run_test(load_text(text), "it").differences == ()

    def test_another_word_is_told_what_there_is(self):
        body = "expect: {it: {keyframes: [{at_s: 1}], lasts_s: 2, ended: game}}"
        assert complaints(body) == ["wrong-value expect.it.ended"]


class TestExpectToleranceCounters:
    COUNTS = "{action: count, counter: run_s, to: {word: time_s, fraction: true}}"
    KEPT = "counters: {run_s: {}}\n"

    @pytest.mark.parametrize(
        ("test", "said"),
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
    def test_a_counter_may_be_so_far_off(self, test, said):
        assert differences(self.COUNTS, SCORES, f"lasts_s: 2, {test}", self.KEPT) == said

    def test_so_may_that_of_one_robot(self):
        counts = self.COUNTS.replace("counter: run_s", "counter: run_s, entity: Y1")
        kept = "counters: {run_s: {per: robots}}\n"
        test = "lasts_s: 2, counters: {run_s: {Y1: 1, Y2: 0}}, tolerance_counters: 0.033"
        assert differences(counts, SCORES, test, kept) == []
        assert differences(counts, SCORES, test.replace("0.033", "0.01"), kept) == [
            "counter run_s of Y1: expected 1, is 1.024; up to 0.01 off is allowed"
        ]
