"""Robots that phases or rules hold, for a time or until a rule lets them go; conditions and values ask for it."""

import pytest

from tests.referee.building import ASKING, fail, on_fault, touch

RULES = """
phases: {stop: {lasts_s: 0.32, robots: held}}
rules:
  hold: {for_each: robots, triggers: [{trigger: touches, entity: each, other: ball}], actions: [{action: hold, entity: each, for_s: 0.32}]}
  longer: {for_each: robots, triggers: [{trigger: touches, entity: each, other: walls}], actions: [{action: hold, entity: each}]}
  release: {triggers: [{trigger: program_fault, robot: B1}], actions: [{action: release, entity: robots}]}
  stop: {triggers: [{trigger: program_fault, robot: B2}], actions: [{action: set_phase, phase: stop}]}
  away: {triggers: [{trigger: program_fault, robot: Y1}], actions: [{action: remove, entity: Y1, for_s: 0.16}]}
"""
ROBOTS = ("B1", "B2", "Y1", "Y2")


@pytest.fixture
def play(stage):
    return stage(RULES)


def held(play, ticks):
    """Play so many ticks and return for each in which rules hold robots, 1 being the first, their names."""
    return {tick: found for tick in range(1, ticks + 1) if (found := names(play.play()))}


def names(output):
    return ",".join(ROBOTS[robot] for robot in sorted(output.held))


class TestPhaseThatHoldsRobots:
    """The output says in each tick whether the robots are held from the next one on."""

    PHASES = """
phases: {countdown: {lasts_s: 0.32, robots: held}, stop: {lasts_s: 0.32, robots: held}, pause: {lasts_s: 0.32}}
first_phase: %s
rules:
  stop: {triggers: [{trigger: touches, entity: Y1, other: ball}], actions: [{action: set_phase, phase: stop}]}
  pause: {triggers: [{trigger: touches, entity: Y2, other: ball}], actions: [{action: set_phase, phase: pause}]}
"""

    @pytest.mark.parametrize(
        ("first", "robot", "ticks"),
        [
            ("countdown", "", range(10)),  # over when tick 10 is judged
            ("play", "Y1", range(3, 13)),  # from the tick in which the rule enters the phase
            ("play", "Y2", []),
        ],
    )
    def test_from_its_first_tick_to_the_one_before_its_end(self, stage, first, robot, ticks):
        play = stage(self.PHASES % first)
        held = [play.output.robots_held]
        for tick in range(1, 23):
            if robot and tick == 3:
                play.touch(robot, "ball")
            held.append(play.play().robots_held)
        assert [tick for tick, is_held in enumerate(held) if is_held] == [*ticks]


class TestActionHold:
    def test_from_the_tick_of_the_rule_for_so_many_ticks(self, play):
        play.touch("Y1", "ball")
        assert held(play, 30) == dict.fromkeys(range(1, 11), "Y1")  # wheels stand in ticks 2 to 11

    def test_without_a_time_until_a_rule_lets_it_go(self, play):
        play.touch("Y1", "walls")
        assert list(held(play, 300)) == list(range(1, 301))
        play.fail("B1")
        assert held(play, 3) == {}

    def test_each_robot_has_its_own_time(self, play):
        touch(play, "Y1", "ball", ticks=5)
        play.touch("B2", "ball")
        found = held(play, 30)
        assert found == dict.fromkeys(range(1, 6), "B2,Y1") | dict.fromkeys(range(6, 11), "B2")

    @pytest.mark.parametrize(("value", "ticks"), [("0.32", 10), ("0", 0), ("-1", 0), ("0.001", 1), ("1000000", 200)])
    def test_a_counter_sets_the_hold_time_when_it_is_read(self, stage, value, ticks):
        hold = "{action: hold, entity: Y1, for_s: {counter: penalty_s}}"
        more = "{action: count, counter: penalty_s, to: 9}"
        play = stage(f"counters: {{penalty_s: {{initial: {value}}}}}", on_fault("Y1", hold, more))
        play.fail("Y1")
        assert len(held(play, 200)) == ticks

    def test_of_each_its_own_counter_and_a_penalty_grows(self, stage):
        play = stage(
            "counters: {mistakes: {per: robots}}",
            "rules: {r: {for_each: robots, triggers: [{trigger: program_fault, robot: each}], actions: "
            "[{action: count, counter: mistakes, entity: each}, "
            "{action: hold, entity: each, for_s: {counter: mistakes, entity: each}}]}}",
        )
        lasting = []
        for robot in ("Y1", "Y1", "B2"):
            play.fail(robot)
            lasting.append(len(held(play, 100)))
        assert lasting == [32, 63, 32]  # 1 s, 2 s and 1 s, rounded up to ticks

    def test_a_draw_sets_the_hold_time(self, stage):
        hold = "{action: hold, entity: Y1, for_s: {draw: penalty_s}}"
        play = stage("draws: {penalty_s: {values: [0.64, 0.64]}}", on_fault("Y1", hold))
        play.fail("Y1")
        assert len(held(play, 100)) == 20

    @pytest.mark.parametrize("first", ["walls", "ball"])
    def test_of_two_ends_the_later_one_counts(self, play, first):
        touch(play, "Y1", first, ticks=3)
        play.touch("Y1", "ball" if first == "walls" else "walls")
        assert len(held(play, 100)) == 100

    def test_a_robot_put_elsewhere_or_taken_off_stays_held_and_its_time_runs_on(self, play):
        touch(play, "Y1", "ball")
        play.fail("Y1")
        found = held(play, 30)
        assert play.referee.held["Y1"] is False
        assert [tick for tick, placement in play.placements if not placement.parked] == [7]  # back while it is held
        assert list(found) == list(range(1, 10))

    def test_it_ends_while_the_robot_is_off_the_field(self, play):
        touch(play, "Y1", "ball", ticks=8)
        play.fail("Y1")
        assert list(held(play, 30)) == [1, 2]
        assert [tick for tick, placement in play.placements if not placement.parked] == [14]

    def test_phases_come_and_go_and_change_nothing(self, play):
        touch(play, "Y1", "walls")
        play.fail("B2")
        assert play.play().robots_held
        play.play(20)
        assert (play.output.robots_held, names(play.output)) == (False, "Y1")

    def test_the_same_robots_are_the_same_object_so_that_quiet_ticks_cost_nothing(self, play):
        play.touch("Y1", "walls")
        first = play.play()
        play.play()  # the first quiet tick makes the object
        assert play.play() is play.play()
        assert play.output.held is first.held


class TestActionRelease:
    def test_what_a_phase_holds_stays_held(self, play):
        fail(play, "B2")
        play.fail("B1")
        assert play.play().robots_held

    @pytest.mark.parametrize(("order", "is_held"), [(("hold", "release"), False), (("release", "hold"), True)])
    def test_of_hold_and_release_in_one_tick_the_later_one_counts(self, stage, order, is_held):
        rules = "".join(
            f"  {word}_it: {{triggers: [{{trigger: touches, entity: Y1, other: ball}}], actions: [{{action: {word}, entity: Y1}}]}}\n"
            for word in order
        )
        play = stage(f"rules:\n{rules}")
        touch(play, "Y1", "ball")
        assert play.referee.held["Y1"] is is_held

    def test_release_then_hold_shortens_the_time(self, stage):
        short = "rules: {hold: {for_each: robots, triggers: [{trigger: touches, entity: each, other: ball}], actions: [{action: release, entity: each}, {action: hold, entity: each, for_s: 0.1}]}}"
        play = stage(RULES, short)
        touch(play, "Y1", "walls")
        play.touch("Y1", "ball")
        assert list(held(play, 20)) == [1, 2, 3, 4]


class TestConditionHeld:
    def test_negated_and_also_by_the_phase(self, stage, ask):
        play = stage(ASKING % "{entity: Y1, held: true, negate: true}")
        assert ask(play)
        play = stage(ASKING % "{entity: Y1, held: true, negate: true}", "phases: {play: {robots: held}}")
        assert not ask(play)

    def test_also_of_a_robot_off_the_field(self, stage, ask):
        off = "rules: {away: {triggers: [{trigger: half_started}], actions: [{action: hold, entity: Y1}, {action: remove, entity: Y1}]}}"
        assert ask(stage(ASKING % "{entity: Y1, held: true}", off))

    def test_the_time_is_over_when_the_tick_is_judged_in_which_it_ends(self, stage):
        play = stage(
            RULES,
            "rules: {free: {triggers: [{trigger: holds, conditions: [{entity: Y1, held: true, negate: true}]}], "
            "actions: [{action: emit, event: FREE, payload: {held: {entity: Y1, held: true}}}]}}",
        )
        touch(play, "Y1", "ball", ticks=20)
        assert [(event.tick, event.payload) for event in play.events] == [(11, {"held": False})]


class TestValueHeld:
    TOLD = """
rules:
  hold: {triggers: [{trigger: touches, entity: Y1, other: ball}], actions: [{action: hold, entity: Y1, for_s: 0.064}]}
  told:
    for_each: yellow
    triggers: [{trigger: touches, entity: Y2, other: ball}]
    actions: [{action: emit, event: TOLD, payload: {held: {entity: each, held: true}}}]
broadcast: {fields: {Y1: {entity: Y1, held: true}, B1: {entity: B1, held: true}}}
"""

    def test_in_the_broadcast_from_the_tick_in_which_a_rule_holds_it(self, stage):
        play = stage(self.TOLD)
        play.touch("Y1", "ball")
        assert [play.play().broadcast for _ in range(3)] == [{"Y1": held, "B1": False} for held in (True, True, False)]


class TestNoProgressOfHeldRobots:
    LAZY = """
rules:
  lazy:
    triggers: [{trigger: no_progress, entity: Y1, distance_m: 0.1, within_s: 0.64}]
    actions: [{action: emit, event: LAZY}]
  hold: {triggers: [{trigger: touches, entity: Y1, other: ball}], actions: [{action: hold, entity: Y1, for_s: 3.2}]}
  release: {triggers: [{trigger: touches, entity: Y1, other: walls}], actions: [{action: release, entity: Y1}]}
"""

    def test_a_held_robot_is_not_judged_and_its_window_begins_when_it_is_let_go(self, stage):
        play = stage(self.LAZY)
        touch(play, "Y1", "ball", ticks=160)
        assert [event.tick for event in play.events] == [101 + 21]  # held in ticks 2 to 101; 20 pieces of path follow

    def test_let_go_by_a_rule(self, stage):
        play = stage(self.LAZY)
        touch(play, "Y1", "ball", ticks=49)
        touch(play, "Y1", "walls", ticks=100)
        assert [event.tick for event in play.events] == [50 + 21]
