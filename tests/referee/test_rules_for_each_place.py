"""Rules over each of several gates or zones, with counters, flags and timers kept for each of them."""

import pytest

from tests.referee.building import place

GATES = """
gates:
  west: {from_m: [-0.5, 0], to_m: [-0.3, 0]}
  middle: {from_m: [-0.1, 0], to_m: [0.1, 0]}
  east: {from_m: [0.3, 0], to_m: [0.5, 0]}
groups: {posts: [west, middle, east]}
"""
PASSED = """
flags: {passed: {per: posts}}
counters: {times: {per: posts}}
rules:
  passed:
    for_each: posts
    triggers: [{trigger: crosses, entity: robots, gate: each, direction: forward}]
    conditions: [{flag: passed, entity: each, negate: true}]
    actions:
      - {action: set_flag, flag: passed, entity: each}
      - {action: emit, event: PASSED, payload: {gate: {word: each_name}, who: {word: robot_name}, named: {word: entity_name}}}
    says: "{entity} of {team} has passed {each}."
  counted:
    for_each: posts
    triggers: [{trigger: crosses, entity: robots, gate: each}]
    actions: [{action: count, counter: times, entity: each}]
  all_passed:
    triggers: [{trigger: holds, conditions: [{flag: passed, of: all}]}]
    actions: [{action: emit, event: ALL_PASSED}]
"""

CROSSED = """
rules:
  crossed:
    for_each: posts
    triggers: [{trigger: crosses, entity: Y1, gate: each}]
    actions: [{action: emit, event: CROSSED, payload: {gate: {word: each_name}}}]
    %s
"""


def pass_at(play, x_m, entity="Y1"):
    # Where a hand puts something is a way too: it goes back beside the posts.
    for x, y in ((-0.6, 0.1), (-0.6, -0.1), (x_m, -0.1)):
        place(play, entity, x, y)
    play.glide(entity, (x_m, 0.1), 4)
    play.play(4)


class TestGates:
    def test_each_gate_is_a_rule_of_its_own_and_the_event_is_about_the_robot(self, stage):
        play = stage(GATES, PASSED)
        pass_at(play, -0.4)
        pass_at(play, 0.4, "B2")
        pass_at(play, -0.4, "B2")
        assert [event.payload for event in play.events] == [
            {"gate": "west", "who": "Y1", "named": "Y1"},
            {"gate": "east", "who": "B2", "named": "B2"},
        ]
        assert play.referee.flags["passed"] == {"west": True, "middle": False, "east": True}
        said = [firing for firing in play.firings if firing.rule == "passed"]
        assert [firing.says for firing in said] == [
            "Y1 of Yellow Sub has passed west.",
            "B2 of Blue Moon has passed east.",
        ]

    @pytest.mark.parametrize(
        ("each", "entity", "expected"),
        [
            ("for_each: posts", ", entity: each", ["west"]),
            ("for_each: posts", "", ["east", "middle", "west"]),
            ("for_each: robots", ", entity: each", ["Y1"]),
            ("", ", entity: west", [""]),
            ("", ", entity: [east, west]", [""]),
            ("", ", entity: posts", [""]),
            ("", ", entity: east", []),
            ("", ", entity: Y1", [""]),
        ],
    )
    def test_rules_over_gates_and_over_robots_both_react_to_the_event(self, stage, each, entity, expected):
        hears = f"""
  hears:
    {each}
    triggers: [{{trigger: event, event: PASSED{entity}}}]
    actions: [{{action: emit, event: TOLD, payload: {{each: {{word: each_name}}}}}}]
"""
        play = stage(GATES, PASSED + hears)
        pass_at(play, -0.4)
        play.play(2)
        assert sorted(event.payload["each"] or "" for event in play.events_named("TOLD")) == expected

    @pytest.mark.parametrize("heard_of", ["[Y1, west]", "[west, Y1]", "[posts, robots]"])
    def test_a_rule_triggered_by_gate_or_robot_gets_the_robot(self, stage, heard_of):
        play = stage(
            GATES,
            f"""
rules:
  passed:
    for_each: posts
    triggers: [{{trigger: crosses, entity: robots, gate: each}}]
    actions: [{{action: emit, event: PASSED}}]
  hears:
    triggers: [{{trigger: event, event: PASSED, entity: {heard_of}}}]
    actions: [{{action: emit, event: TOLD, payload: {{who: {{word: entity_name}}}}}}]
""",
        )
        pass_at(play, -0.4)
        play.play(2)
        assert [event.payload for event in play.events_named("TOLD")] == [{"who": "Y1"}]

    @pytest.mark.parametrize(
        ("limit", "counted"), [("max_executions: 1", 2), ("cooldown_s: 10", 2), ("priority: 1", 4)]
    )
    def test_limits_count_for_each_gate(self, stage, limit, counted):
        play = stage(GATES, CROSSED % limit)
        for x_m in (-0.4, 0.4, -0.4, 0.4):
            pass_at(play, x_m)
        crossed = [event.payload["gate"] for event in play.events]
        assert crossed == ["west", "east", "west", "east"][:counted]

    @pytest.mark.parametrize("gate", ["west", "middle", "east"])
    def test_the_gate_that_is_drawn_counts(self, stage, gate):
        play = stage(
            GATES,
            "draws: {next: {values: [west, middle, east]}}",
            CROSSED % "conditions: [{draw: next, equals: each}]",
            draws={"next": gate},
        )
        for x_m in (-0.4, 0.0, 0.4):
            pass_at(play, x_m)
        assert [event.payload["gate"] for event in play.events] == [gate]


class TestZones:
    def test_each_zone_counts_its_own_visits(self, stage):
        play = stage(
            "groups: {sides: [left, right]}",
            "counters: {visits: {per: sides}}",
            """
            rules:
              visited:
                for_each: sides
                triggers: [{trigger: enters, entity: ball, zone: each}]
                actions: [{action: count, counter: visits, entity: each}]
              both_in:
                for_each: sides
                triggers: [{trigger: enters, entity: Y1, zone: each}]
                conditions: [{entity: ball, in: each}]
                actions: [{action: emit, event: TOGETHER, payload: {zone: {word: each_name}}}]
                says: "{entity} has come to the ball in {each}."
              all_together:
                triggers: [{trigger: holds, conditions: [{counter: visits, at_least: 4}]}]
                actions: [{action: emit, event: FOUR}]
            """,
        )
        play.place("Y1", 0.0, 0.0)
        for x_m in (0.3, -0.3, 0.3, -0.3):
            place(play, "ball", x_m, 0.0)
        assert play.referee.counters["visits"] == {"left": 2, "right": 2}
        place(play, "Y1", 0.3, 0.2)
        place(play, "Y1", -0.3, 0.2)
        assert play.names() == ["FOUR", "TOGETHER"]
        assert play.firings[-1].says == "Y1 has come to the ball in left."


def test_a_sentence_formats_names_as_people_write_them(stage):
    play = stage("""
    zones: {far_end: {shape: rect, y_min_m: 0.6}}
    groups: {ends: [far_end]}
    rules:
      there:
        for_each: ends
        triggers: [{trigger: enters, entity: Y1, zone: each}]
        actions: [{action: emit, event: THERE, payload: {zone: {word: each_name}}}]
        says: "{entity} is at the {each}."
    """)
    place(play, "Y1", 0, 0.65)
    assert play.firings[0].says == "Y1 is at the far end."
    assert play.events[0].payload == {"zone": "far_end"}
