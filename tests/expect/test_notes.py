"""Notes of a failed test: likely reasons why an event is missing or a value differs."""

import pytest

GOAL = """
zones: {goal: {shape: rect, y_min_m: 0.7}}
counters: {goals: {}, own: {per: robots}, other: {}}
flags: {up: {}}
phases: {pause: {}}
"""
SCORES = "lasts_s: 2, keyframes: [{at_s: 0.32, place: {ball: [0, 0.75]}}], "
TWICE = (
    "lasts_s: 2, keyframes: [{at_s: 0.32, place: {ball: [0, 0.75]}}, {at_s: 0.64, place: {ball: [0, 0]}}, "
    "{at_s: 0.96, place: {ball: [0, 0.75]}}], "
)
ENTERS = "triggers: [{trigger: enters, entity: ball, zone: goal}]"
SECOND_HALF = "conditions: [{word: halftime, equals: 2}]"


def rules(**bodies: str) -> str:
    """Return rules, each from what stands in its braces."""
    return "rules:\n" + "".join(f"  {name}: {{{body}}}\n" for name, body in bodies.items())


def denied(action: str, more: str = "") -> str:
    """Return a rule that is triggered by a goal and never fires, as this is the first half."""
    return f"{more}{ENTERS}, {SECOND_HALF}, actions: [{action}]"


def emit(event: str) -> str:
    return f"{{action: emit, event: {event}}}"


@pytest.fixture
def notes(differences):
    def run(block: str, *sections: str) -> list[str]:
        found = differences(block, GOAL, *sections)
        assert found
        return [line for line in found if line.startswith("note: ")]

    return run


class TestDeniedRule:
    def test_triggered_rule_is_noted_with_time_and_the_condition_that_did_not_hold(self, notes):
        conditions = "conditions: [{word: halftime, equals: 1}, {counter: goals, at_least: 2}]"
        (note,) = notes(SCORES + "events: [{event: A}]", rules(a=f"{ENTERS}, {conditions}, actions: [{emit('A')}]"))
        assert note == ("note: a was triggered at 0.32 s, and {counter: goals, at_least: 2} did not hold")

    def test_condition_that_a_rule_of_the_same_tick_made_true_is_marked(self, notes):
        counted = f"{ENTERS}, actions: [{{action: count, counter: goals}}]"
        late = f"{ENTERS}, conditions: [{{counter: goals, at_least: 1}}], actions: [{emit('A')}]"
        (note,) = notes(SCORES + "events: [{event: A}]", rules(counted=counted, late=late))
        assert " did not hold yet: " in note

    @pytest.mark.parametrize(
        ("event", "time_s"), [("{event: A, at_s: 1}", 0.96), ("{event: A, at_s: 0.3}", 0.32), ("{event: A}", 0.96)]
    )
    def test_time_nearest_to_the_expected_one_is_noted(self, notes, event, time_s):
        (note,) = notes(f"{TWICE}events: [{event}]", rules(a=denied(emit("A"))))
        assert f"triggered at {time_s} s" in note

    @pytest.mark.parametrize(
        ("action", "expected"),
        [
            ("{action: count, counter: goals}", "counters: {goals: 1}"),
            ("{action: count, counter: own, entity: Y1}", "counters: {own: {Y1: 1}}"),
            ("{action: set_flag, flag: up}", "flags: {up: true}"),
            ("{action: set_flag, flag: up, to: opposite}", "flags: {up: true}"),
            ("{action: set_phase, phase: pause}", "phase: pause"),
            ("{action: end}", "ended: half"),
            ("{action: end, what: match}", "ended: match"),
            ("{action: hold, entity: Y1}", "held: {Y1: true}"),
            ("{action: score, entrant: yellow}", "score: {yellow: 1}"),
            ("{action: score, entrant: {last_touch: ball}}", "score: {yellow: 1}"),
        ],
    )
    def test_rule_that_would_have_caused_what_is_expected_is_noted(self, notes, action, expected):
        other = denied("{action: count, counter: other}")
        found = notes(SCORES + expected, rules(would=denied(action), other=other))
        assert [note.split()[1] for note in found] == ["would"]

    def test_rule_with_each_may_have_changed_any_score(self, notes):
        each = denied("{action: score, entrant: each}", "for_each: yellow, ")
        assert [note.split()[1] for note in notes(SCORES + "score: {yellow: 1}", rules(own=each))] == ["own"]

    def test_at_most_three_rules_are_noted(self, notes):
        many = {f"r{number}": denied(emit("A")) for number in range(5)}
        found = notes(SCORES + "events: [{event: A}]", rules(**many))
        assert [note.split()[1] for note in found] == ["r0", "r1", "r2"]

    @pytest.mark.parametrize(
        "rule",
        [
            f"{ENTERS}, actions: [{emit('A')}]",  # it fired
            denied(emit("B")),  # it emits another event
            denied(emit("A"), "phases: [pause], "),  # it was inactive
        ],
    )
    def test_other_rules_are_not_noted(self, notes, rule):
        assert notes(SCORES + "events: [{event: A}, {event: A}]", rules(r=rule)) == []


class TestEndingRule:
    ENDS = f"{ENTERS}, actions: [{{action: end, what: match}}]"

    @pytest.mark.parametrize("expected", ["events: [{event: A}]", "ended: none"])
    def test_rule_that_ended_the_test_is_noted_if_more_was_expected(self, notes, expected):
        (note,) = notes(SCORES + expected, rules(ends=self.ENDS))
        assert note.startswith("note: ends ended the match at 0.32 s")

    def test_it_is_not_noted_if_nothing_more_was_expected(self, notes):
        assert notes(SCORES + "score: {yellow: 1}", rules(ends=self.ENDS)) == []


class TestHoldsThatWasTrueBefore:
    # Y1 starts at (-0.4, -0.5), in the zone left.
    THERE = "triggers: [{trigger: holds, conditions: [{entity: Y1, in: left}]%s}], actions: [%s]"
    STANDS = "lasts_s: 1, keyframes: [{at_s: 0.5}], "

    def test_rule_whose_condition_held_from_the_start_is_noted(self, notes):
        (note,) = notes(self.STANDS + "events: [{event: A}]", rules(there=self.THERE % ("", emit("A"))))
        assert note.startswith("note: there waits for a condition to come true that held already at 0 s")

    def test_placement_that_made_it_true_is_noted_with_its_time(self, notes):
        away = "triggers: [{trigger: half_started}], actions: [{action: place, entity: Y1, at: {point: [0.4, 0]}}]"
        back = "triggers: [{trigger: time_reached, at_s: 0.32}], actions: [{action: place, entity: Y1, at: start}]"
        (note,) = notes(
            self.STANDS + "events: [{event: A}]", rules(there=self.THERE % ("", emit("A")), away=away, back=back)
        )
        assert "held already at 0.32 s" in note

    def test_rule_that_would_not_give_what_is_missing_is_not_noted(self, notes):
        assert notes(self.STANDS + "score: {yellow: 1}", rules(there=self.THERE % ("", emit("A")))) == []

    @pytest.mark.parametrize(
        ("condition", "opposite"),
        [
            (
                "{entity: Y1, in: left}",
                "{entity: Y1, in: left, negate: true}",
            ),
            ("{counter: goals, below: 3}", "{counter: goals, at_least: 3}"),
            ("{counter: goals, at_most: 3}", "{counter: goals, above: 3}"),
        ],
    )
    def test_rule_whose_opposite_is_also_a_rule_waits_for_a_change(self, notes, condition, opposite):
        block = self.STANDS + "events: [{event: A}]"
        holds = "triggers: [{trigger: holds, conditions: [%s]}], actions: [%s]"
        changes = rules(there=holds % (condition, emit("A")), back=holds % (opposite, emit("B")))
        assert notes(block, changes) == []
        (note,) = notes(block, rules(there=holds % (condition, emit("A")), back=holds % (condition, emit("B"))))
        assert note.startswith("note: there waits")

    def test_with_a_time_the_rule_fires(self, differences):
        sections = rules(there=self.THERE % (", for_s: 0.05", emit("A")))
        assert differences(self.STANDS + "events: [{event: A}]", sections) == []


class TestPlacedInsideZone:
    PUT = "triggers: [{trigger: time_reached, at_s: 0.32}], actions: [{action: place, entity: Y1, at: {point: [-0.4, 0]}}]"
    OUTSIDE = "lasts_s: 1, keyframes: [{at_s: 0.1, place: {Y1: [0.4, 0], Y2: [0.4, 0.3]}}%s], "

    def enters(self, entity: str, more: str = "") -> str:
        return f"{more}triggers: [{{trigger: enters, entity: {entity}, zone: left}}], actions: [{emit('A')}]"

    @pytest.mark.parametrize(("entity", "more"), [("Y1", ""), ("yellow", ""), ("each", "for_each: yellow, ")])
    def test_placement_is_noted_as_no_entry(self, notes, entity, more):
        sections = rules(there=self.enters(entity, more), put=self.PUT)
        (note,) = notes(self.OUTSIDE % "" + "events: [{event: A}]", sections)
        assert note.startswith("note: Y1 was put into left at 0.32 s")
        assert "{entity: Y1, in: left}" in note

    def test_other_entity_is_not_noted(self, notes):
        sections = rules(there=self.enters("Y2"), put=self.PUT)
        assert notes(self.OUTSIDE % "" + "events: [{event: A}]", sections) == []

    def test_rule_that_fired_is_not_noted(self, notes):
        walks = ", {at_s: 0.8, place: {Y1: [0.4, 0]}}, {at_s: 0.9, place: {Y1: [-0.4, 0]}}"
        sections = rules(there=self.enters("Y1"), put=self.PUT)
        assert notes(self.OUTSIDE % walks + "events: [{event: A}, {event: A}]", sections) == []


class TestWrongWay:
    # Forward through the gate is towards -y.
    GATE = """
gates: {line: {from_m: [0.65, 0.1], to_m: [-0.65, 0.1]}}
sequences: {round: {entity: ball, steps: [left, line]}}
rules:
  rounded: {triggers: [{trigger: sequence_completed, sequence: round}], actions: [{action: emit, event: ROUND}]}
  up: {triggers: [{trigger: crosses, entity: B1, gate: line, direction: backward}], actions: [{action: emit, event: UP}]}
"""
    BACKWARD = (
        "lasts_s: 1, keyframes: [{at_s: 0, place: {ball: [-0.3, -0.2]}}, {at_s: 0.32, place: {ball: [-0.3, 0.2]}}], "
    )

    def test_gate_of_a_sequence_crossed_backward_is_noted(self, notes):
        (note,) = notes(self.BACKWARD + "events: [{event: ROUND}]", self.GATE)
        assert note.startswith("note: ball crossed line backward at 0.32 s: no step of")

    def test_gate_of_a_rule_with_direction_crossed_the_other_way_is_noted(self, notes):
        forward = (
            "lasts_s: 1, keyframes: [{at_s: 0.1, place: {B1: [0.1, 0.2]}}, {at_s: 0.32, place: {B1: [0.1, -0.2]}}], "
        )
        (note,) = notes(forward + "events: [{event: UP}]", self.GATE)
        assert note.startswith("note: B1 crossed line forward at 0.32 s")

    def test_gate_that_is_anchored_is_crossed_where_it_is(self, notes):
        # B2 stands at (-0.4, 0.5) and looks along -y: forward through its gate is from its front to its back.
        anchored = "gates: {line: {from_m: [0, -0.2], to_m: [0, 0.2], anchor: B2}}"
        frames = (
            "lasts_s: 1, keyframes: [{at_s: 0, place: {ball: [0.4, 0.8]}}, {at_s: 0.32, place: {ball: [-0.4, 0.8]}},"
            " {at_s: 0.64, place: {ball: [-0.4, 0.2]}}], "
        )
        (note,) = notes(frames + "events: [{event: ROUND}]", self.GATE, anchored)
        assert note.startswith("note: ball crossed line backward at 0.64 s")

    @pytest.mark.parametrize(
        "rule",
        [
            "triggers: [{trigger: time_reached, at_s: 0.16}], actions: [{action: remove, entity: ball}]",
            "triggers: [{trigger: time_reached, at_s: 0.16}], actions: [{action: place, entity: ball, at: {point: [-0.3, 0.3]}}]",
        ],
    )
    def test_what_is_placed_or_off_the_field_crosses_nothing(self, notes, rule):
        assert notes(self.BACKWARD + "events: [{event: ROUND}]", self.GATE, rules(r=rule)) == []


class TestPhases:
    COUNTDOWN = (
        "phases: {countdown: {lasts_s: 0.64, next: %s}, rest: {lasts_s: 0.64, next: countdown}}\nfirst_phase: countdown"
    )

    def test_course_of_the_phases_is_noted_if_an_event_is_missing(self, notes):
        (note,) = notes(
            SCORES + "events: [{event: A}]",
            self.COUNTDOWN % "play",
            rules(a=f"{ENTERS}, actions: [{emit('A')}]"),
        )
        assert note == "note: the phase was countdown until 0.64 s, then play"

    def test_it_is_not_noted_if_only_a_value_differs(self, notes):
        assert notes(SCORES + "score: {yellow: 1}", self.COUNTDOWN % "play") == []

    def test_of_many_phases_the_first_six_are_noted(self, notes):
        block = SCORES.replace("lasts_s: 2", "lasts_s: 8") + "events: [{event: A}]"
        (note,) = notes(block, self.COUNTDOWN % "rest")
        assert note.count("then") == 5
        assert note.endswith(", …")
