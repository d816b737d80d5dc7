"""`expect` blocks: what keyframes do, what can be given and decided, and how the outcome is compared."""

import time

import pytest

RULES = """
zones: {goal: {shape: rect, y_min_m: 0.7}}
counters: {goals: {initial: 2}, laps: {per: robots, initial: 1}}
flags: {up: {}, out: {per: robots}}
draws: {side: {values: [left, right]}}
rules:
  goal:
    triggers: [{trigger: enters, entity: ball, zone: goal}]
    actions:
      - {action: score, entrant: yellow}
      - {action: emit, event: GOAL, payload: {who: yellow, points: 1, good: true}}
      - {action: place, entity: ball, at: {point: [0, 0.25]}}
  hit: {triggers: [{trigger: touches, entity: ball, other: B1}], actions: [{action: emit, event: HIT}]}
  fell: {triggers: [{trigger: tips_over, entity: B1}], actions: [{action: emit, event: FELL}]}
  broke: {triggers: [{trigger: program_fault, robot: B1}], actions: [{action: emit, event: BROKE}]}
  lap:
    triggers: [{trigger: touches, entity: Y1, other: ball}]
    actions:
      - {action: count, counter: laps, entity: Y1}
      - {action: set_flag, flag: out, entity: Y1}
      - {action: hold, entity: Y1, for_s: 1}
      - {action: draw, draw: side}
      - {action: emit, event: DRAWN, payload: {side: {draw: side}}}
"""
GOAL = "keyframes: [{at_s: 0.32, place: {ball: [0, 0.75]}}], "
TOUCH = "keyframes: [{at_s: 0.5, touch: [[Y1, ball]]}], "


@pytest.fixture
def run(differences):
    return lambda block, *sections: differences(f"lasts_s: 2, {block}", RULES, *sections)


class TestKeyframes:
    def test_entity_glides_in_a_straight_line_from_the_keyframe_before(self, run):
        glide = "keyframes: [{at_s: 0.32, place: {ball: [0.4, 0]}}, {at_s: 0.96, move: {ball: [0.4, 0.4, 1]}}], "
        assert run(glide + "poses: {ball: [0.4, 0.4]}") == []

    def test_glide_enters_zones_on_its_way_and_ends_where_the_referee_places_the_entity(self, run):
        glide = "keyframes: [{at_s: 0.32}, {at_s: 0.96, move: {ball: [0, 0.8]}}], "
        assert run(glide + "events: [{event: GOAL, at_s: 0.88, tolerance_s: 0.05}], poses: {ball: [0, 0.25]}") == []

    def test_touches_tilts_and_faults_are_scripted(self, run):
        frames = "keyframes: [{at_s: 0.64, touch: [[ball, B1]]}, {at_s: 0.96, tips: [B1]}, {at_s: 1.28, fault: [B1]}], "
        events = "events: [{event: HIT, at_s: 0.64}, {event: FELL, at_s: 0.96}, {event: BROKE, at_s: 1.28}]"
        assert run(frames + events) == []

    def test_keyframe_at_0_is_seen_in_the_first_tick(self, run):
        frames = "keyframes: [{at_s: 0, place: {ball: [0, 0.75]}}], "
        assert run(frames + "events: [{event: GOAL, at_s: 0.032}]") == []


class TestComparison:
    def test_outcome_as_expected_is_no_difference(self, run):
        expected = (
            "events: [{event: GOAL, at_s: 0.32, payload: {points: 1, good: true}}], score: {yellow: 1, blue: 0}, "
            "counters: {goals: 2}, flags: {up: false}, phase: play, poses: {ball: [0, 0.25]}"
        )
        assert run(GOAL + expected) == []

    def test_each_difference_is_a_line(self, run):
        found = run(
            GOAL + "events: [{event: GOAL, at_s: 1, payload: {who: blue, good: false}}, {event: HIT, at_s: 0.5}], "
            "score: {yellow: 2}, counters: {goals: 3}, flags: {up: true}, phase: pause, poses: {ball: [0, 0.3]}",
            "phases: {pause: {}}",
        )
        assert found == [
            "differs: event 1 (GOAL): expected at 1 s, came at 0.32 s; up to 0.033 s off is allowed, more by tolerance_s beside at_s",
            "differs: event 1 (GOAL): expected who blue, is yellow",
            "differs: event 1 (GOAL): expected good false, is true",
            "missing: HIT at 0.5 s, event 2 of the test",
            "score of yellow: expected 2, is 1",
            "counter goals: expected 3, is 2",
            "flag up: expected true, is false",
            "phase: expected pause, is play",
            "ball: expected at (0, 0.3), is at (0, 0.25), 0.05 m off; up to 0.001 m off is allowed, more by tolerance_m",
        ]

    @pytest.mark.parametrize(("tolerance_s", "passes"), [(0.5, False), (0.68, True)])
    def test_event_may_be_off_by_its_tolerance(self, run, tolerance_s, passes):
        found = run(GOAL + f"events: [{{event: GOAL, at_s: 1, tolerance_s: {tolerance_s}}}]")
        assert (found == []) is passes

    @pytest.mark.parametrize(
        ("expected", "passes"),
        [
            ("events: []", False),
            ("events: [], ignore: [GOAL]", True),
            ("events: [{event: GOAL}], ignore: [GOAL]", True),
        ],
    )
    def test_unexpected_event_is_a_difference_unless_ignored(self, run, expected, passes):
        assert (run(GOAL + expected) == []) is passes

    @pytest.mark.parametrize(
        ("lasts_s", "held", "found"),
        [
            (1.4, "{Y1: true, Y2: false}", []),
            (1.4, "{Y1: false, Y2: true}", ["Y1 held: expected false, is true", "Y2 held: expected true, is false"]),
            (1.6, "{Y1: false}", []),
        ],
    )
    def test_held_robots_are_compared_at_the_end(self, differences, lasts_s, held, found):
        assert differences(f"lasts_s: {lasts_s}, {TOUCH}held: {held}", RULES) == found

    def test_phase_that_holds_all_robots_counts_as_held(self, run):
        assert run(TOUCH + "held: {B1: true}", "phases: {play: {robots: held}}") == []

    def test_counter_and_flag_of_each_are_compared_one_by_one_or_as_one(self, run):
        given = "given: {counters: {laps: {B2: 7}}, flags: {out: {B2: true}}}, " + TOUCH
        each = "counters: {laps: {Y1: 2, B2: 7, B1: 1}}, flags: {out: {B2: true, B1: false}}"
        assert run(given + each) == []
        assert run(given + "counters: {laps: 11}, flags: {out: true}") == []
        assert run(TOUCH + "counters: {laps: {Y1: 3, B1: 1}}, flags: {out: {B1: true}}") == [
            "counter laps of Y1: expected 3, is 2",
            "flag out of B1: expected true, is false",
        ]


class TestOffTheField:
    """Y1 is taken off by a touch, for 1 s or for good, and Y2 counts what enters the zone left."""

    RULES = """
zones: {far: {shape: rect, y_min_m: 0.3}}
counters: {entered: {}, near: {}}
rules:
  out: {triggers: [{trigger: touches, entity: Y1, other: ball}], actions: [{action: remove, entity: Y1, for_s: %s}]}
  enters: {triggers: [{trigger: enters, entity: Y1, zone: far}], actions: [{action: count, counter: entered}]}
  near:
    triggers: [{trigger: holds, conditions: [{distance: [Y1, Y2], at_most: 0.2}], for_s: 0.1}]
    actions: [{action: count, counter: near}]
"""
    OUT = "lasts_s: 2, keyframes: [{at_s: 0.32, touch: [[Y1, ball]]}%s], "

    @pytest.fixture
    def run(self, differences):
        return lambda block, frames="", for_s=30: differences(self.OUT % frames + block, self.RULES % for_s)

    def test_what_is_off_is_listed_and_stands_nowhere(self, run):
        assert run("'off': [Y1]") == []
        assert run("'off': yellow, poses: {Y1: [-0.4, -0.5]}") == [
            "Y2 off the field: expected true, is false",
            "Y1: expected at (-0.4, -0.5), is off the field",
        ]

    @pytest.mark.parametrize("how", ["place", "move"])
    def test_keyframe_brings_it_back(self, run, how):
        frames = (
            f", {{at_s: 0.64}}, {{at_s: 1.28, {how}: {{Y1: [0.4, 0.4]}}}}, {{at_s: 1.6, place: {{Y2: [0.4, 0.3]}}}}"
        )
        assert run("poses: {Y1: [0.4, 0.4]}, counters: {near: 1, entered: 0}", frames) == []
        assert run("'off': [Y1]", frames) == ["Y1 off the field: expected true, is false"]

    def test_it_enters_zones_and_is_removed_as_before(self, run):
        back = ", {at_s: 0.64, place: {Y1: [0.4, 0]}}, {at_s: 0.96, place: {Y1: [0.4, 0.4]}}"
        assert run("counters: {entered: 1}", back) == []
        assert run("'off': [Y1]", back + ", {at_s: 1.28, touch: [[Y1, ball]]}") == []

    def test_it_does_not_come_back_a_second_time(self, run):
        assert run("poses: {Y1: [0.4, 0]}", ", {at_s: 0.64, place: {Y1: [0.4, 0]}}", for_s=1) == []

    def test_it_stays_where_a_rule_put_it_before_it_would_have_moved_back(self, run):
        frames = ", {at_s: 0.64}, {at_s: 1.92, move: {Y1: [0.4, 0.4]}}"
        assert run("poses: {Y1: [-0.4, -0.5]}", frames, for_s=1) == []

    def test_what_a_rule_removes_on_its_way_stays_off(self, differences):
        way = "lasts_s: 2, keyframes: [{at_s: 0.32}, {at_s: 0.64, touch: [[Y1, ball]], move: {Y1: [0.4, 0]}}], 'off': [Y1]"
        assert differences(way, self.RULES % 30) == []
        late = "lasts_s: 2, keyframes: [{at_s: 0.3}, {at_s: 1.6, move: {Y1: [0, 0.5]}}], 'off': [Y1]"
        crossed = "rules: {line: {triggers: [{trigger: enters, entity: Y1, zone: far}], actions: [{action: remove, entity: Y1}]}}"
        assert differences(late, self.RULES % 30, crossed) == []


class TestRulesByName:
    GOAL_AND_HIT = "keyframes: [{at_s: 0.32, place: {ball: [0, 0.75]}, touch: [[ball, B1]]}], "

    def test_firing_of_a_rule_is_expected_between_events(self, run):
        assert run(self.GOAL_AND_HIT + "events: [{rule: goal, at_s: 0.32}, {event: GOAL}, {event: HIT}]") == []
        assert (
            run(self.GOAL_AND_HIT + "events: [{event: GOAL}, {rule: hit, payload: {entity: ball}}, {event: HIT}]") == []
        )

    def test_other_rules_may_fire(self, run):
        assert run(self.GOAL_AND_HIT + "events: [{rule: hit}], ignore: [GOAL, HIT]") == []

    def test_each_firing_counts(self, run):
        assert run(GOAL + "events: [{rule: goal}, {rule: goal, at_s: 1}], ignore: [GOAL]") == [
            "missing: rule goal at 1 s, event 2 of the test"
        ]
        twice = "keyframes: [{at_s: 0.32, touch: [[ball, B1]]}, {at_s: 1, touch: [[ball, B1]]}], "
        assert run(twice + "events: [{rule: hit}], ignore: [HIT]") == ["superfluous: rule hit at 1.024 s (entity ball)"]

    def test_suppressed_rule_has_not_fired(self, run):
        once = "rules: {once: {triggers: [{trigger: touches, entity: ball, other: B1}], actions: [{action: end}], phases: [pause]}}"
        found = run(self.GOAL_AND_HIT + "events: [{rule: once}], ignore: [GOAL, HIT]", "phases: {pause: {}}", once)
        assert found == ["missing: rule once, event 1 of the test"]

    def test_reason_why_a_missing_rule_did_not_fire_is_noted(self, run):
        late = "rules: {late: {triggers: [{trigger: touches, entity: ball, other: B1}], conditions: [{word: halftime, equals: 2}], actions: [{action: place, entity: ball, at: start}]}}"
        *_, note = run(self.GOAL_AND_HIT + "events: [{rule: late, at_s: 0.3}], ignore: [GOAL, HIT]", late)
        assert note.startswith("note: late was triggered at 0.32 s")


class TestGiven:
    def test_score_counters_and_flags_are_set_before_the_half(self, run):
        given = "given: {score: {yellow: 3}, counters: {goals: 7}, flags: {up: true}}, "
        assert run(given + GOAL + "score: {yellow: 4, blue: 0}, counters: {goals: 7}, flags: {up: true}") == []

    def test_given_values_stand_before_the_first_rule(self, differences):
        sections = """
counters: {laps: {per: yellow}}
flags: {handed_over: {keep: match}, out: {per: yellow}}
rules:
  first:
    triggers: [{trigger: half_started}]
    conditions: [{flag: handed_over}]
    actions: [{action: emit, event: FIRST, payload: {laps: {counter: laps, entity: Y1}, out: {flag: out, entity: Y1}}}]
"""
        given = "half: 2, given: {counters: {laps: 4}, flags: {handed_over: true, out: true}}, "
        block = "lasts_s: 1, keyframes: [{at_s: 0}], events: [{event: FIRST, payload: {laps: 4, out: true}}]"
        assert differences(given + block, sections) == []


class TestDecidedDraws:
    def drawn(self, run, decided: list[str], sides: list[str]) -> list[str]:
        frames = ", ".join(f"{{at_s: {0.3 * (index + 1):g}, touch: [[Y1, ball]]}}" for index in range(len(sides)))
        events = ", ".join(f"{{event: DRAWN, payload: {{side: {side}}}}}" for side in sides)
        return run(f"draws: {{side: [{', '.join(decided)}]}}, keyframes: [{frames}], events: [{events}]")

    @pytest.mark.parametrize("sides", [["left", "left", "right"], ["right", "left", "right"]])
    def test_each_draw_takes_the_next_decided_value(self, run, sides):
        assert self.drawn(run, ["left", *sides], sides) == []

    def test_failed_test_notes_values_that_were_not_drawn(self, run):
        *_, note = self.drawn(run, ["left", "right", "left", "left"], ["left", "left"])
        assert note == "note: side was drawn 3 times; draws decides 4 values"


def test_scripted_match_plays_at_200_times_real_time(match_play):
    play = match_play()
    play.play(100)
    best = min(_timed(play, 250) for _ in range(8))
    assert best < 250 * 0.032 / 200


def _timed(play, ticks: int) -> float:
    began = time.process_time()
    play.play(ticks)
    return time.process_time() - began
