"""Roles: a name for the one of several that is meant now, which may stand wherever one of them may."""

import itertools

import pytest

from rcj_challenges.expect.runner import run_test
from rcj_challenges.scenario.errors import ScenarioError
from rcj_challenges.scenario.lint.registry import lint
from rcj_challenges.scenario.load import load_text
from rcj_challenges.views.sheet import sheet_markdown
from tests.referee.building import event_ticks, hears, once, payloads, walk
from tests.views.sheets import section

SECOND = "schema_version: 2\n"
HEAD = SECOND + "id: x\ntitle: X\nextends: soccersim_v2\n"
ZONES = """
zones:
  a: {shape: circle, centre_m: [-0.4, 0], radius_m: 0.1}
  b: {shape: circle, centre_m: [0, 0.4], radius_m: 0.1}
  c: {shape: circle, centre_m: [0.4, 0], radius_m: 0.1}
"""
A, B, C, OUT = (-0.4, 0), (0, 0.4), (0.4, 0), (0, -0.5)


def listed(of: str, more: str = "") -> str:
    return f"roles: {{wanted: {{of: {of}, order: listed{more}}}}}"


def assign(tick: int, to: str = "next", name: str = "give") -> str:
    return once(tick, f"{{action: assign, role: wanted, to: {to}}}", name=name)


def play_robots(stage) -> tuple[str, ...]:
    roster = stage(SECOND).roster
    return roster.entities[: roster.robots]


def holder(play) -> str | None:
    return play.referee.draws["wanted"]


class TestOrder:
    def turns(self, stage, role: str, ticks: int = 5) -> list[str | None]:
        again = "rules: {turn: {triggers: [{trigger: time_reached, at_s: 0.032, every_s: 0.032}], actions: [{action: assign, role: wanted}]}}"
        play, found = stage(SECOND, role, again), []
        for _ in range(ticks):
            found.append(holder(play))
            play.play()
        return found

    def test_listed_comes_one_by_one_and_then_nothing(self, stage):
        assert self.turns(stage, listed("[Y1, B1, Y2]")) == ["Y1", "B1", "Y2", None, "Y1"]

    def test_cyclic_begins_again(self, stage):
        assert self.turns(stage, listed("[Y1, B1]", ", cyclic: true")) == ["Y1", "B1", "Y1", "B1", "Y1"]

    def test_initially_nothing(self, stage):
        assert self.turns(stage, listed("[Y1, B1]", ", initial: none"), 3) == [None, "Y1", "B1"]

    def test_by_chance_all_come_and_with_not_last_never_one_twice_running(self, stage):
        found = self.turns(stage, "roles: {wanted: {of: robots, not_last: true}}", 100)
        assert set(found) == set(play_robots(stage))
        assert all(one != other for one, other in itertools.pairwise(found))

    def test_with_not_again_each_comes_once_a_round(self, stage):
        found = self.turns(stage, "roles: {wanted: {of: blue, not_again: half}}", 4)
        assert [sorted(found[:2]), sorted(found[2:])] == [["B1", "B2"]] * 2

    def test_chance_is_that_of_a_draw_of_this_name(self, stage):
        draw = stage(SECOND, "draws: {wanted: {values: [B1, B2]}}")
        assert holder(stage(SECOND, "roles: {wanted: {of: blue}}")) == holder(draw)


@pytest.mark.parametrize(
    ("to", "expected"),
    [("next", "B1"), ("Y2", "Y2"), ("none", None), ("{last_touch: ball}", "Y1"), ("{role: other}", "B1")],
)
def test_what_it_is_assigned_to(stage, to, expected):
    roles = "roles: {wanted: {of: [Y1, B1, Y2], order: listed}, other: {of: [B1, B2], order: listed}}"
    assert holder_after(stage, roles, assign(10, to)) == expected


def holder_after(stage, *parts):
    play = stage(SECOND, *parts)
    play.play_until(12)
    return holder(play)


def test_each_is_the_member_of_the_rule(stage):
    rule = """
rules:
  catch:
    for_each: robots
    triggers: [{trigger: touches, entity: each, other: ball}]
    actions: [{action: assign, role: wanted, to: each}]
"""
    play = stage(SECOND, listed("robots"), rule)
    play.touch("Y2", "ball")
    play.play()
    assert holder(play) == "Y2"


def test_a_role_of_entrants_is_that_of_each_or_of_the_others(stage):
    rules = """
rules:
  conceded:
    for_each: entrants
    triggers: [{trigger: touches, entity: each, other: ball}]
    conditions: [{role: wanted, equals: each}]
    actions: [{action: assign, role: wanted, to: others}, {action: score, entrant: each}]
"""
    play = stage(SECOND, listed("entrants"), rules)
    for robot, expected in (("Y1", "blue"), ("B1", "yellow"), ("B2", "yellow"), ("Y2", "blue")):
        play.touch(robot, "ball")
        play.play()
        assert holder(play) == expected
    assert play.referee.scores == {"blue": 1, "yellow": 1}


def test_other_is_what_was_touched(stage):
    rule = """
rules:
  tag:
    triggers: [{trigger: touches, entity: wanted, other: robots}]
    actions: [{action: assign, role: wanted, to: other}]
"""
    play = stage(SECOND, listed("robots", ", initial: none"), assign(3, "Y1"), rule)
    play.play_until(5)
    play.touch("Y1", "B2")
    play.play()
    assert holder(play) == "B2"
    play.touch("Y1", "Y2")
    play.play()
    assert holder(play) == "B2"
    play.touch("B1", "B2")
    play.play()
    assert holder(play) == "B1"


class TestWhereANameMayStand:
    def test_a_robot_in_a_trigger(self, stage):
        play = stage(SECOND + ZONES, listed("[Y1, Y2]"), assign(20), hears("enters, entity: wanted, zone: a"))
        walk(play, "Y2", A, OUT)
        walk(play, "Y1", A, OUT)
        assert len(event_ticks(play)) == 1
        play.play_until(21)
        walk(play, "Y1", A, OUT)
        assert len(event_ticks(play)) == 1
        walk(play, "Y2", A)
        assert len(event_ticks(play)) == 2

    def test_a_zone(self, stage):
        play = stage(SECOND + ZONES, listed("[a, b, c]"), hears("enters, entity: Y1, zone: wanted"),
                     "rules: {next: {triggers: [{trigger: event, event: TOLD}], actions: [{action: assign, role: wanted}]}}")  # fmt: skip
        walk(play, "Y1", B, OUT, A, OUT, A, OUT, B, C, OUT)
        assert len(event_ticks(play)) == 3
        assert holder(play) is None

    def test_a_change_is_no_entry(self, stage):
        play = stage(SECOND + ZONES, listed("[a, b]"), assign(20), hears("enters, entity: Y1, zone: wanted"))
        walk(play, "Y1", B)
        play.play_until(30)
        assert event_ticks(play) == []
        walk(play, "Y1", OUT, B)
        assert len(event_ticks(play)) == 1

    @pytest.mark.parametrize(("at", "expected"), [(A, [25 + 32]), (B, [])])
    def test_a_time_that_something_must_last_begins_with_the_change(self, stage, at, expected):
        held = "rules: {told: {triggers: [{trigger: holds, for_s: 1.024, conditions: [{entity: Y1, in: wanted}]}], actions: [{action: emit, event: TOLD}]}}"
        play = stage(SECOND + ZONES, listed("[c, a, b]"), assign(25), held)
        walk(play, "Y1", at)
        play.play_until(70)
        assert event_ticks(play) == expected

    @pytest.mark.parametrize(("condition", "expected"), [
        ("{entity: wanted, in: a}", [False, True, False]),
        ("{entity: wanted, in: a, negate: true}", [True, False, True]),
        ("{distance: [wanted, a], below: 0.2}", [False, True, False]),
        ("{speed: ball, below: {distance: [wanted, a]}}", [True, False, False]),
        ("{any_of: [{entity: wanted, in: a}, {entity: Y1, in: a}]}", [True, True, True]),
        ("{role: wanted, equals: Y1}", [False, True, False]),
        ("{role: wanted, equals: none}", [False, False, True]),
        ("{flag: seen, entity: wanted}", [False, True, False]),
    ])  # fmt: skip
    def test_a_condition_is_about_the_one_that_has_it_and_false_if_none_has(self, stage, condition, expected):
        """First Y2 has the role, then Y1, who stands in zone a, then no one."""
        asked = "{trigger: time_reached, at_s: 0.32, every_s: 0.32}"
        play = stage(
            SECOND + ZONES + "flags: {seen: {per: robots}}", listed("[Y2, Y1]"),
            once(2, "{action: set_flag, flag: seen, entity: Y1}", name="seen"),
            assign(15), assign(25, name="later"),
            f"rules: {{told: {{triggers: [{asked}], conditions: [{condition}], actions: [{{action: emit, event: TOLD}}]}}}}",
        )  # fmt: skip
        walk(play, "Y1", A)
        play.play_until(32)
        assert [tick in event_ticks(play) for tick in (10, 20, 30)] == expected

    def test_an_action_is_about_the_one_that_has_it_then_and_does_nothing_if_none_has(self, stage):
        remove = "{action: remove, entity: wanted}"
        play = stage(
            SECOND,
            listed("[Y1, Y2]"),
            once(10, remove, name="first"),
            assign(12),
            assign(14, name="more"),
            once(20, remove, name="last"),
        )
        play.play_until(22)
        assert [play.is_off(name) for name in ("Y1", "Y2")] == [True, False]

    def test_actions_of_one_firing_read_it_as_it_is_then(self, stage):
        play = stage(
            SECOND,
            listed("[Y1, B1]"),
            once(
                10,
                "{action: score, entrant: wanted}",
                "{action: assign, role: wanted}",
                "{action: score, entrant: wanted, points: 5}",
            ),
        )
        play.play_until(12)
        assert play.referee.scores == {"yellow": 1, "blue": 5}

    def test_an_event_and_the_broadcast_have_its_name_and_null_if_there_is_none(self, stage):
        values = "{name: {role: wanted}, m: {distance: [wanted, ball]}}"
        play = stage(SECOND, listed("[Y1]"), f"broadcast: {{fields: {values}}}",
                     once(10, f"{{action: emit, event: TOLD, payload: {values}}}", name="now"), assign(12),
                     once(20, f"{{action: emit, event: TOLD, payload: {values}}}", name="then"))  # fmt: skip
        play.play_until(11)
        assert play.received["B1"] == {"name": "Y1", "m": 0.64}
        play.play_until(22)
        assert payloads(play) == [{"name": "Y1", "m": 0.64}, {"name": None, "m": None}]
        assert play.received["B1"] == {"name": None, "m": None}

    def test_a_ball_and_a_spot_where_something_is_put(self, stage):
        play = stage(
            SECOND, listed("[corner_blue_left, centre]"), once(10, "{action: place, entity: Y1, at: {spot: wanted}}")
        )
        play.play_until(12)
        assert play.pose("Y1")[:2] == pytest.approx(play.referee.spots["corner_blue_left"])


def test_a_duration_is_read_from_the_one_that_has_it(stage):
    """A cooldown is a key of the rule itself, not of one of its words; without such a number it lasts on."""
    rule = """
counters: {rest: {per: robots, initial: 0.32}}
rules:
  told:
    triggers: [{trigger: time_reached, at_s: 0.032, every_s: 0.032}]
    cooldown_s: {counter: rest, entity: wanted}
    actions: [{action: emit, event: TOLD}]
"""
    play = stage(
        SECOND, listed("[Y1, Y2]"), once(5, "{action: count, counter: rest, entity: Y2, to: 0.16}"), assign(8), rule
    )
    play.play_until(30)
    assert event_ticks(play) == [1, 11, 16, 21, 26]


def test_an_entrant_whose_turn_it_is(stage):
    rules = """
counters: {throws: {per: entrants}}
rules:
  thrown:
    for_each: entrants
    triggers: [{trigger: touches, entity: each, other: ball}]
    conditions: [{role: wanted, equals: each}]
    actions: [{action: score, entrant: wanted}, {action: count, counter: throws, entity: wanted}, {action: assign, role: wanted}]
"""
    play = stage(SECOND, listed("entrants", ", cyclic: true"), rules)
    for robot in ("Y1", "B1", "B2", "Y2", "Y1", "B1"):
        play.touch(robot, "ball")
        play.play(20)
    assert play.referee.scores == {"blue": 2, "yellow": 1}
    assert play.referee.counters["throws"] == {"blue": 2, "yellow": 1}


@pytest.mark.parametrize(("keep", "expected"), [("half", "B1"), ("late", "Y1"), ("phase", "Y1")])
def test_it_begins_anew_with_the_phase_for_which_it_is_kept(stage, keep, expected):
    late = once(20, "{action: set_phase, phase: late}", name="late")
    play = stage(SECOND + "phases: {late: {}}", listed("[Y1, B1]", f", keep: {keep}"), assign(10), late)
    play.play_until(22)
    assert holder(play) == expected


TESTED = (
    HEAD
    + """
roles: {wanted: {of: balls_and_robots, not_last: true}, turn: {of: [Y1, B1], order: listed}}
groups: {balls_and_robots: [ball, Y1, Y2]}
rules:
  next: {triggers: [{trigger: time_reached, at_s: 1}], actions: [{action: assign, role: wanted}, {action: assign, role: turn}]}
expect: {t: {keyframes: [{at_s: 0}], lasts_s: 2, %s}}
"""
)


@pytest.mark.parametrize(
    ("test", "differences"),
    [
        ("draws: {wanted: [Y1, Y2]}, roles: {wanted: Y2, turn: B1}", 0),
        ("draws: {wanted: [Y1, Y2]}, roles: {wanted: Y1}", 1),
        ("given: {roles: {turn: B1}}, roles: {turn: none}", 0),
        ("given: {roles: {turn: none}}, roles: {turn: Y1}", 0),
    ],
)
def test_tests_decide_give_and_expect_roles(test, differences):
    assert len(run_test(load_text(TESTED % test), "t").differences) == differences


def test_what_a_test_decides_of_a_role_that_begins_with_none_comes_when_it_is_assigned():
    tests = "{z: {keyframes: [{at_s: 0}], lasts_s: 0.5, draws: {wanted: Y2}, roles: {wanted: none}}, "
    tests += "t: {keyframes: [{at_s: 0}], lasts_s: 2, draws: {wanted: Y2}, roles: {wanted: Y2}}}"
    assigned = "triggers: [{trigger: time_reached, at_s: 1}], actions: [{action: assign, role: wanted}]"
    role = "roles: {wanted: {of: [Y1, Y2, B1, B2, B3], initial: none}}"
    loaded = load_text(HEAD + f"{role}\nrules: {{next: {{{assigned}}}}}\nexpect: {tests}\n")
    assert [run_test(loaded, name).differences for name in "zt"] == [(), ()]


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("zones: {z: {shape: rect, x_max_m: 0}}\nroles: {r: {of: [z]}}\nrules: {x: {triggers: [{trigger: enters, entity: r, zone: z}], actions: [{action: end}]}}", "wrong-kind"),
        ("roles: {r: {of: [Y9]}}", "unknown-name"),
        ("roles: {ball: {of: [Y1]}}", "name-taken"),
        ("roles: {r: {of: [Y1]}}\ndraws: {r: {values: [1, 2]}}", "name-taken"),
        ("roles: {r: {of: entrants}}\nrules: {x: {triggers: [{trigger: touches, entity: r, other: ball}], actions: [{action: end}]}}", "wrong-kind"),
        ("roles: {r: {of: [Y1]}}\nexpect: {t: {keyframes: [{at_s: 0}], lasts_s: 1, given: {roles: {r: B1}}}}", "never-drawn"),
        ("roles: {r: {of: [ball]}}\nrules: {x: {triggers: [{trigger: half_started}], actions: [{action: score, entrant: r}]}}", "wrong-kind"),
        ("roles: {r: {of: robots}}\nrules: {x: {triggers: [{trigger: half_started}], actions: [{action: assign, role: r, to: ball}]}}", "never-drawn"),
        ("roles: {r: {of: robots}}\nrules: {x: {for_each: r, triggers: [{trigger: half_started}], actions: [{action: end}]}}", "wrong-kind"),
        ("expect: {t: {keyframes: [{at_s: 0}], lasts_s: 1, roles: {x: Y1}}}", "unknown-name"),
        ("roles: {r: {of: robots}}\ncounters: {c: {per: r}}", "unbound-name"),
        ("roles: {r: {of: robots}}\ntimers: {t: {lasts_s: {distance: [r, ball]}}}", "unbound-name"),
    ],
)  # fmt: skip
def test_what_cannot_be_is_refused(text, code):
    with pytest.raises(ScenarioError) as refused:
        load_text(HEAD + text)
    assert [problem.code for problem in refused.value.diagnostics] == [code]


@pytest.mark.parametrize(
    ("rule", "message", "help_"),
    [
        ("for_each: entrants, triggers: [{trigger: half_started}], actions: [{action: assign, role: r, to: others}]", "'blue'", "Y1, B1"),
        ("triggers: [{trigger: half_started}], actions: [{action: assign, role: r, to: Y2}]", "role 'r'", "Y1, B1"),
        ("triggers: [{trigger: touches, entity: s, other: ball}], actions: [{action: end}]", "'s'", "for_each: entrants, a condition {role: s, equals: each}"),
        ("for_each: t, triggers: [{trigger: half_started}], actions: [{action: end}]", "'t'", "for_each: yellow, a condition {role: t, equals: each}"),
    ],
)  # fmt: skip
def test_refusals_name_the_role_and_a_way_out(rule, message, help_):
    roles = "roles: {r: {of: [Y1, B1]}, s: {of: entrants}, t: {of: yellow}}"
    with pytest.raises(ScenarioError) as refused:
        load_text(f"{HEAD}{roles}\nrules: {{x: {{{rule}}}}}")
    (problem,) = refused.value.diagnostics
    assert message in problem.message
    assert help_ in problem.help


@pytest.mark.parametrize(
    ("role", "is_assigned", "codes"),
    [
        ("order: listed", False, ["never-written"]),
        ("initial: none", False, ["never-written"]),
        ("", False, []),
        ("order: listed", True, []),
    ],
)
def test_a_role_that_never_changes_is_reported(role, is_assigned, codes):
    give = ", {action: assign, role: r}" * is_assigned
    text = f"roles: {{r: {{of: [Y1, B1], {role}}}}}\nrules: {{x: {{triggers: [{{trigger: touches, entity: r, other: ball}}], says: x, actions: [{{action: score, entrant: r}}{give}]}}}}"
    assert [one.code for one in lint(load_text(HEAD + text)) if "role" in one.message] == codes


def test_who_gets_the_points_depends_on_a_role():
    text = """
roles: {owner: {of: robots, order: listed, initial: none}}
rules:
  comes:
    for_each: robots
    triggers: [{trigger: touches, entity: each, other: ball}]
    actions: [{action: assign, role: owner, to: each}]
  owns:
    triggers: [{trigger: time_reached, at_s: 5, every_s: 5}]
    says: A point for the owner.
    actions: [{action: score, entrant: owner}]
"""
    assert lint(load_text(HEAD + text)) == []


def test_what_one_robot_does_that_has_a_role_is_not_reported_as_of_several():
    text = """
roles: {runner: {of: robots, order: listed}}
rules:
  in:
    triggers: [{trigger: enters, entity: runner, zone: blue_goal}]
    says: The runner is in.
    actions: [{action: score, entrant: runner}, {action: assign, role: runner}]
"""
    assert lint(load_text(HEAD + text)) == []


def test_the_sheet_names_them():
    text = """
roles:
  thrower: {of: [Y1, B1], order: listed, cyclic: true}
  wanted: {of: [Y2, Y3], not_last: true}
  it: {of: robots, initial: none, order: listed}
rules:
  thrown:
    triggers: [{trigger: touches, entity: thrower, other: wanted}]
    actions: [{action: score, entrant: thrower}, {action: assign, role: thrower}, {action: assign, role: it, to: none}]
"""
    loaded = load_text(HEAD + text)
    page = sheet_markdown(loaded.scenario, loaded.roster).replace("\\", "")
    course = section(page, "Course")
    assert (
        "When a half starts, “thrower” is Y1; rules say when the next one is: Y1, B1, and again from the first."
        in course
    )
    assert (
        "Chance decides “wanted” when a half starts, and whenever rules say so: Y2 or Y3, never the same twice running."
        in course
    )
    assert "Nothing is “it” when a half starts; rules say when that is B1, B2, B3, Y1, Y2 or Y3." in course
    rules = section(page, "Rules in full")
    assert (
        "When the thrower touches the wanted: the team of the thrower gets 1 point, then the next of them becomes “thrower”, then nothing becomes “it”."
        in rules
    )
