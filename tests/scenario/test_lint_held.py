"""Lint of phases and rules that hold robots."""

from __future__ import annotations

import pytest

from rcj_challenges.scenario.lint.table import lint
from rcj_challenges.scenario.load import load_text

HEAD = "schema_version: 1\nid: it\ntitle: It\nextends: soccersim_v2\nmatch: {half_s: 60}\n"
KINDS = (
    "hold_without_effect", "robots_never_free", "held_robot_makes_no_progress", "held_for_ever", "release_without_effect",
    "never_held", "phase_never_left", "limit_longer_than_the_half", "rule_never_fires",
)  # fmt: skip
COUNTDOWN = "phases: {countdown: {lasts_s: %s, robots: held}}\nfirst_phase: countdown\n"
LAZY = (
    "rules:\n  lazy:\n    phases: %s\n"
    "    triggers: [{trigger: no_progress, entity: %s, distance_m: 0.1, within_s: 5}]\n"
    "    actions: [{action: score, entrant: blue}]\n    says: Nobody drives.\n"
)
NOBODY = "entrants: {blue: null, yellow: null}\n"


def found(text: str) -> list[str]:
    """Return what is said about holding robots."""
    return [str(one) for one in lint(load_text(HEAD + text, file="it.yaml")) if one.kind in KINDS]


class TestPhasesThatHoldRobots:
    def test_a_countdown_is_fine(self):
        assert found(COUNTDOWN % 3) == []

    def test_nobody_drives(self):
        assert found(COUNTDOWN % 3 + NOBODY) == [
            (
                "it.yaml:6:42: warning: phases.countdown.robots: no robot has a program, and so none drives; leave it out, or "
                "name who drives under entrants: [hold_without_effect]"
            )
        ]

    def test_the_robots_are_never_free(self):
        assert found("phases: {play: {robots: held}, pause: {lasts_s: 1, robots: held}}\n") == [
            (
                "it.yaml:6:25: warning: phases.play.robots: robots are held in every phase that is ever entered, play, so that "
                "none ever drives; enter a phase in which they are free: give this one lasts_s, or a rule that sets another "
                "[robots_never_free]"
            )
        ]
        assert found("phases: {wait: {robots: held}}\nfirst_phase: wait\n") != []

    def test_a_phase_that_is_never_entered_is_told_as_that_only(self):
        assert found("phases: {wait: {robots: held}}\n") == []


GOAL = "rules:\n  goal: {triggers: [{trigger: enters, entity: ball, zone: blue_goal}], actions: [{action: set_phase, phase: over}]}\n"
READY = "phases: {ready: {robots: held}}\nfirst_phase: ready\nrules:\n"
GO = "  go: {phases: [ready], triggers: [%s], actions: [{action: set_phase, phase: play}]}\n"
TOUCH = "{trigger: touches, entity: Y1, other: ball}"


class TestPhasesThatHoldForEver:
    def test_no_rule_leaves_the_phase_and_it_has_no_length(self):
        assert found("phases: {over: {robots: held}}\n" + GOAL) == [
            (
                "it.yaml:6:25: warning: phases.over.robots: robots are held to the end of the half: 'over' has no lasts_s, and no "
                "rule that lives in it sets another phase or ends the half; give it lasts_s, or a rule with phases: [over] and "
                "{action: set_phase, …}; where all is over, write {action: end} in place of the phase [phase_never_left]"
            )
        ]

    @pytest.mark.parametrize(
        ("phase", "rule"),
        [
            ("lasts_s: 5, robots: held", ""),
            ("lasts_s: 60, robots: held", ""),  # as long as the half: so it is meant
            ("robots: free", ""),
            (
                "robots: held",
                "  x: {phases: any, triggers: [{trigger: time_reached, at_s: 50}], actions: [{action: end}]}\n",
            ),
            (
                "robots: held",
                f"  x: {{phases: [over], triggers: [{TOUCH}], actions: [{{action: set_phase, phase: play}}]}}\n",
            ),
        ],
    )
    def test_what_ends_it_is_enough(self, phase, rule):
        # The ball may still roll, and touch a robot.
        assert [one for one in found(f"phases: {{over: {{{phase}}}}}\n{GOAL}{rule}") if "never_left" in one] == []

    def test_a_rule_that_enters_it_once_more_does_not_leave_it(self):
        again = "  x: {phases: any, triggers: [{trigger: time_reached, at_s: 9}], actions: [{action: set_phase, phase: over}]}\n"
        assert len(found("phases: {over: {robots: held}}\n" + GOAL + again)) == 1

    def test_where_a_half_begins_nothing_moves_that_could_end_it(self):
        (text,) = found(READY + GO % TOUCH)
        assert "'ready' has no lasts_s, and 'go' would leave it once something moves, and nothing does" in text

    @pytest.mark.parametrize(
        "trigger",
        [
            "{trigger: tells, entity: Y1}",
            "{trigger: time_reached, at_s: 3}",
            TOUCH + ", {trigger: timer_expired, timer: t}",
            "{trigger: holds, condition: {condition: in_zone, entity: ball, zone: pitch}, for_s: 3}",
        ],
    )
    def test_what_comes_by_itself_ends_it(self, trigger):
        assert found("timers: {t: {lasts_s: 5, starts: true}}\n" + READY + GO % trigger) == []

    def test_so_does_a_touch_of_what_a_rule_puts_there(self):
        put = "  put: {phases: [ready], triggers: [{trigger: time_reached, at_s: 2}], actions: [{action: place, entity: ball, at: start}]}\n"
        assert found(READY + GO % TOUCH + put) == []


class TestHeldRobotsThatMustMove:
    @pytest.mark.parametrize("lasts", ["5", "8"])
    def test_a_window_as_long_as_the_phase(self, lasts):
        assert found(COUNTDOWN % lasts + LAZY % ("any", "yellow")) == [
            (
                "it.yaml:11:16: warning: rules.lazy.triggers[0] (no_progress): phase 'countdown' holds the robots for as long as "
                "the 5 s of this window or longer, and the rule lives in it: it finds robots that may not move; leave "
                "'countdown' out of its phases [held_robot_makes_no_progress]"
            )
        ]

    @pytest.mark.parametrize(
        ("lasts", "phases", "entity"),
        [("4.9", "any", "yellow"), ("8", "[play]", "yellow"), ("8", "any", "ball")],
        ids=["a shorter phase", "a rule that does not live in it", "the ball"],
    )
    def test_what_may_well_be_meant(self, lasts, phases, entity):
        assert found(COUNTDOWN % lasts + LAZY % (phases, entity)) == []

    def test_the_longest_that_a_draw_may_decide_counts(self):
        drawn = "draws: {wait: {values: [2, 6]}}\n" + COUNTDOWN % "{draw: wait}"
        assert len(found(drawn + LAZY % ("any", "robots"))) == 1


def rules(*actions: str, conditions: str = "") -> str:
    """Return rules with one action each."""
    lines = "".join(
        f"  r{number}:\n    triggers: [{{trigger: touches, entity: Y1, other: ball}}]\n    conditions: [{conditions}]\n"
        f"    actions: [{action}]\n"
        for number, action in enumerate(actions)
    )
    return f"rules:\n{lines}"


class TestRulesThatHoldRobots:
    @pytest.mark.parametrize(
        "actions",
        [
            ["{action: hold, entity: Y1, for_s: 5}"],
            ["{action: hold, entity: Y1, for_s: 60}"],  # to the end of the half
            ["{action: hold, entity: yellow}", "{action: release, entity: robots}"],
        ],
    )
    def test_for_a_time_or_until_a_rule_lets_them_go(self, actions):
        assert found(rules(*actions)) == []

    def test_nothing_lets_some_of_them_go(self):
        assert found(rules("{action: hold, entity: yellow}", "{action: release, entity: [Y1, Y3]}")) == [
            (
                "it.yaml:10:15: warning: rules.r0.actions[0] (hold): it has no for_s, and no rule lets Y2 go again; give it "
                "for_s, or write a rule with {action: release, entity: …}; to the end of the half is for_s: 60 [held_for_ever]"
            )
        ]

    def test_no_program_drives_them(self):
        idle = "robots: {X1: {colour: red, number: 1, kit: v2, idle: true, start: {x_m: 0.5, y_m: 0, yaw_rad: 0}}}\n"
        assert found(idle + rules("{action: hold, entity: X1, for_s: 5}")) == [
            (
                "it.yaml:11:15: warning: rules.r0.actions[0] (hold): no program drives X1: nothing but a push moves it "
                "anyway; leave it out, or name who drives under entrants: [hold_without_effect]"
            )
        ]
        assert found(idle + rules("{action: hold, entity: robots, for_s: 5}")) == []

    def test_longer_than_the_half(self):
        assert [
            "limit_longer_than_the_half" in one for one in found(rules("{action: hold, entity: Y1, for_s: 5000}"))
        ] == [True]

    def test_let_go_whom_no_rule_holds(self):
        release = "{action: release, entity: Y1}"
        assert found(rules(release, "{action: hold, entity: Y2, for_s: 1}")) == [
            (
                "it.yaml:10:15: warning: rules.r0.actions[0] (release): no rule holds Y1; leave it out, or hold them by a "
                "rule: {action: hold, entity: …} [release_without_effect]"
            )
        ]
        (told,) = found(COUNTDOWN % 3 + rules(release))
        assert "; what phase 'countdown' holds is held until it is over, whatever rules do; " in told

    @pytest.mark.parametrize("negate", ["", ", negate: true"])
    def test_asked_of_whom_nothing_holds(self, negate):
        asking = rules("{action: score, entrant: blue}", conditions=f"{{condition: held, entity: Y1{negate}}}")
        assert found(asking) == [
            (
                "it.yaml:9:18: warning: rules.r0.conditions[0] (held): it asks whether Y1 is held, and no rule or phase "
                "does that; write a rule that does: {action: hold, entity: …}, or leave it out [never_held]"
            )
        ]
        assert found(COUNTDOWN % 3 + asking) == []

    def test_told_to_programs_of_whom_nothing_holds(self):
        told = "broadcast: {fields: {Y1: {held: Y1}}}\n"
        assert ["[never_held]" in one for one in found(told)] == [True]
        assert found(told + rules("{action: hold, entity: yellow, for_s: 1}")) == []

    def test_waiting_in_play_for_a_hold_that_comes_with_a_pause(self):
        pause = "phases: {pause: {lasts_s: 1}}\n" + rules(
            "{action: hold, entity: Y1, for_s: 1}, {action: set_phase, phase: pause}"
        )
        waits = "  waits:\n    triggers: [{trigger: holds, condition: {condition: held, entity: Y1}}]\n    actions: [{action: end}]\n"
        assert ["[rule_never_fires]" in one for one in found(pause + waits)] == [True]
        assert found(pause + waits.replace("}}]", "}, for_s: 0.1}]")) == []
        # That nobody is held comes when the time is over.
        assert found(pause + waits.replace("Y1}", "robots, of: none}")) == []
        turned = waits.replace("Y1}", "robots, of: none, negate: true}")
        assert ["[rule_never_fires]" in one for one in found(pause + turned)] == [True]
