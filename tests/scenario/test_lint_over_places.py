"""Lint of rules over zones and gates: what is never named, never filled, never true."""

from rcj_challenges.scenario.lint.table import lint
from tests.scenario.writing import loaded

HEAD = """gates: {west: {from_m: [-0.5, 0], to_m: [-0.3, 0]}, east: {from_m: [0.3, 0], to_m: [0.5, 0]}}
groups: {doors: [west, east]}
rules:
"""
TELL = "{action: score, entrant: yellow}"


def rule(trigger, more="", for_each="doors", says="It is told.", action=TELL, name="r"):
    return f"  {name}: {{for_each: {for_each}, triggers: [{trigger}], actions: [{action}], says: '{says}'{more}}}\n"


def found(*rules):
    return [
        f"{one.problem.path}: {one.problem.message}; {one.remedy} [{one.kind}]"
        for one in lint(loaded(HEAD + "".join(rules)))
    ]


CROSSES = "{trigger: crosses, entity: Y1, gate: each}"
ENTERS = "{trigger: enters, entity: ball, zone: each}"
LEAVES = "{trigger: leaves, entity: ball, zone: each}"
AREAS = "penalty_areas"


def test_a_rule_over_gates_in_order_is_free_of_lint():
    assert found(rule(CROSSES, says="{entity} of {team} has passed {each}.")) == []
    assert found(rule(CROSSES), rule(ENTERS, for_each=AREAS, name="s")) == []


def test_a_gate_that_is_never_named_is_written_with_its_key():
    (warning,) = found(rule("{trigger: crosses, entity: Y1, gate: doors}"))
    assert warning.endswith("write gate: each where it looks or acts, or leave for_each out [each_never_named]")
    (warning,) = found(rule("{trigger: half_started}", for_each=AREAS), rule(CROSSES, name="s"))
    assert "write zone: each" in warning


def test_who_crossed_is_unknown_where_nobody_does():
    (warning,) = found(
        rule("{trigger: half_started}", more=", conditions: [{condition: in_zone, entity: ball, zone: each}]",
             for_each=AREAS, says="{entity} is told."),
        rule(CROSSES, name="s"),
    )  # fmt: skip
    assert "'{entity}' stays empty: no trigger of this rule is about one entity" in warning


def test_whose_timer_ran_out_is_unknown_where_it_is_that_of_a_gate():
    timers = "timers: {closed: {lasts_s: 3, per: %s}}\nrules:\n"
    expired = "  r: {triggers: [{trigger: timer_expired, timer: closed}], actions: [%s], says: '{entity} is told.'}\n"
    start = "{action: timer, timer: closed, entity: each}"
    of_gates = HEAD.replace("rules:\n", timers % "doors") + expired % TELL + rule(CROSSES, action=start, name="s")
    (warning,) = lint(loaded(of_gates))
    assert "'{entity}' stays empty: no trigger of this rule is about one entity" in warning.problem.message
    of_robots = HEAD.replace("rules:\n", timers % "robots") + expired % TELL
    of_robots += rule("{trigger: tips_over, entity: each}", for_each="robots", action=start, name="s")
    of_robots += rule(CROSSES, name="t")
    assert not lint(loaded(of_robots))


def test_each_is_unknown_in_a_rule_that_goes_over_nothing():
    (warning,) = found(
        "  r: {triggers: [{trigger: crosses, entity: Y1, gate: doors}], actions: [{action: score, entrant: yellow}], "
        "says: 'Passed {each}.'}\n"
    )
    assert "'{each}' stays empty: this rule has no for_each" in warning


def asked(trigger, zone, negate):
    return rule(trigger, f", conditions: [{{condition: in_zone, entity: ball, zone: {zone}, negate: {negate}}}]", AREAS)


def test_a_zone_that_was_just_entered_or_left_is_not_asked_for_the_opposite():
    use = rule(CROSSES, name="s")
    assert "[rule_never_fires]" in found(asked(ENTERS, "each", "true"), use)[0]
    assert "[rule_never_fires]" in found(asked(LEAVES, "each", "false"), use)[0]
    assert "[rule_never_fires]" in found(asked(ENTERS, AREAS, "true"), use)[0]
    # Out of one of them it may be in the other.
    assert found(asked(LEAVES, AREAS, "false"), use) == []
    assert found(asked(ENTERS, "each", "false"), use) == []


def test_two_rules_that_move_one_thing_on_the_edge_of_one_gate():
    put = "{action: place, entity: ball, at: start}"
    each = rule(CROSSES, action=put)
    one = f"  s: {{triggers: [{{trigger: crosses, entity: Y1, gate: west}}], actions: [{put}], says: It.}}\n"
    kinds = [one.rpartition("[")[2] for one in found(each, one)]
    assert "two_rules_move_one_thing]" in kinds
