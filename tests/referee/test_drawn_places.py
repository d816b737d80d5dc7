"""A draw's name where a zone or a gate stands, and where a distance is measured to something."""

import math

import pytest

from tests.referee.building import acted, at_tick_10, place

LEFT, MIDDLE, RIGHT, OUTSIDE = (-0.3, 0.0), (0.0, 0.0), (0.3, 0.0), (0.0, 0.7)
HOT = "draws: {hot: {values: [left, right], not_last: true}}"
NOW = "{trigger: time_reached, at_s: 0.32}"
"""Tick 10."""


def hears(*triggers: str, more: str = "") -> str:
    rules = (
        f"{name}: {{triggers: [{trigger}], {more} actions: [{{action: emit, event: {name.upper()}}}]}}"
        for name, trigger in zip(("one", "two", "three"), triggers, strict=False)
    )
    return f"rules: {{{', '.join(rules)}}}"


AGAIN = f"rules: {{again: {{triggers: [{NOW}], actions: [{{action: draw, draw: hot}}]}}}}"
ENTERS, LEAVES = "{trigger: enters, entity: ball, zone: hot}", "{trigger: leaves, entity: ball, zone: hot}"


def events(play) -> list[tuple[str, int]]:
    return [(event.name, event.tick) for event in play.events]


class TestZones:
    @pytest.mark.parametrize(("hot", "ticks"), [("left", [("ONE", 2), ("TWO", 3)]), ("right", [("ONE", 4)])])
    def test_the_drawn_one_is_entered_and_left_and_no_other(self, stage, hot, ticks):
        play = stage(HOT, hears(ENTERS, LEAVES), draws={"hot": hot})
        for where in (MIDDLE, LEFT, MIDDLE, RIGHT):
            place(play, "ball", *where)
        assert events(play) == ticks

    def test_a_change_of_the_draw_is_no_edge(self, stage):
        stays = "{trigger: stays_in, entity: ball, zone: hot, limit_s: 0.32}"
        play = stage(HOT, hears(ENTERS, LEAVES, stays), AGAIN, draws={"hot": "right"})
        place(play, "ball", *LEFT)
        play.play(11)
        # It lies in what is drawn at tick 10: nothing fires by that, and its stay begins then.
        assert events(play) == []
        play.play(15)
        assert events(play) == [("THREE", 21)]
        place(play, "ball", *MIDDLE)
        assert events(play)[1:] == [("TWO", 28)]

    def test_after_a_new_draw_the_other_one_is_followed_at_once(self, stage):
        play = stage(HOT, hears(ENTERS), AGAIN, draws={"hot": "left"})
        play.play(10)
        place(play, "ball", *LEFT)
        assert events(play) == []
        place(play, "ball", *RIGHT)
        assert events(play) == [("ONE", 12)]

    def test_what_is_drawn_again_and_stays_the_same_disturbs_no_stay(self, stage):
        stays = "{trigger: stays_in, entity: ball, zone: hot, limit_s: 0.48}"
        same = "draws: {hot: {values: [left]}}"
        play = stage(same, hears(stays), AGAIN)
        place(play, "ball", *LEFT)
        play.play(20)
        assert events(play) == [("ONE", 17)]

    def test_beside_others_it_is_one_of_them(self, stage):
        either = "{trigger: enters, entity: ball, zone: [hot, middle]}"
        play = stage(HOT, hears(either), draws={"hot": "left"})
        place(play, "ball", *OUTSIDE)
        for where in (LEFT, MIDDLE, RIGHT, LEFT):
            place(play, "ball", *where)
        # From the left part straight into the middle is no entry: it was in one of them before.
        assert events(play) == [("ONE", 2), ("ONE", 5)]

    @pytest.mark.parametrize(("hot", "where", "fires"), [("left", LEFT, 1), ("left", RIGHT, 0), ("right", RIGHT, 1)])
    def test_a_condition_asks_for_the_one_that_is_drawn_now(self, stage, hot, where, fires):
        rule = "conditions: [{entity: ball, in: hot}],"
        play = stage(
            HOT,
            hears("{trigger: time_reached, at_s: 0.64}", more=rule),
            AGAIN,
            draws={"hot": ("right" if hot == "left" else "left", hot)},
        )
        place(play, "ball", *where)
        play.play(25)
        assert len(play.events) == fires

    def test_holds_is_evaluated_again_when_a_draw_makes_it_true(self, stage):
        holds = "{trigger: holds, conditions: [{entity: ball, in: hot}]}"
        play = stage(HOT, hears(holds), AGAIN, draws={"hot": "right"})
        place(play, "ball", *LEFT)
        play.play(15)
        assert events(play) == [("ONE", 11)]

    def test_in_a_phase_in_which_the_rule_does_not_live_nothing_is_followed(self, stage):
        play = stage(
            HOT,
            "phases: {rest: {lasts_s: 0.64}}",
            f"rules: {{rests: {{triggers: [{NOW}], actions: [{{action: set_phase, phase: rest}}]}}}}",
            "rules: {late: {phases: any, triggers: [{trigger: time_reached, at_s: 0.48}], actions: [{action: draw, draw: hot}]}}",
            hears(ENTERS, LEAVES),
            draws={"hot": "right"},
        )
        place(play, "ball", *LEFT)
        play.play(35)
        assert events(play) == []
        place(play, "ball", *MIDDLE)
        assert [name for name, _ in events(play)] == ["TWO"]


class TestGates:
    DOORS = """
    gates: {west: {from_m: [0.6, -0.2], to_m: [-0.6, -0.2]}, east: {from_m: [0.6, 0.2], to_m: [-0.6, 0.2]}}
    draws: {door: {values: [west, east]}}
    """
    CROSSES = "{trigger: crosses, entity: ball, gate: door%s}"

    @pytest.mark.parametrize(("door", "tick"), [("west", 2), ("east", 3)])
    def test_the_drawn_one_is_crossed_and_no_other(self, stage, door, tick):
        play = stage(self.DOORS, hears(self.CROSSES % ""), draws={"door": door})
        for y in (-0.4, 0.0, 0.4):
            place(play, "ball", 0.0, y)
        assert events(play)[-1:] == [("ONE", tick)]

    def test_direction_counts_as_with_any_gate(self, stage):
        play = stage(self.DOORS, hears(*(self.CROSSES % f", direction: {way}" for way in ("forward", "backward"))),
                     draws={"door": "east"})  # fmt: skip
        for y in (0.4, 0.0):
            place(play, "ball", 0.0, y)
        assert events(play) == [("TWO", 1), ("ONE", 2)]


class TestDistances:
    PLACES = """
    spots: {far: {x_m: 0, y_m: 0.5}, near: {x_m: 0, y_m: 0.2}}
    balls: {ball: {start_m: [0, 0]}, red: {start_m: [0.5, 0]}}
    draws: {spot: {values: [far, near]}, part: {values: [left, right]}, one: {values: [ball, red]}}
    """

    @pytest.mark.parametrize(
        ("value", "draws", "far"),
        [
            ("[ball, spot]", {"spot": "far"}, 0.5),
            ("[ball, spot]", {"spot": "near"}, 0.2),
            ("[spot, red]", {"spot": "near"}, 0.539),
            ("[red, part]", {"part": "left"}, 0.6),
            ("[red, part]", {"part": "right"}, 0),
            ("[one, [0, 0]]", {"one": "red"}, 0.5),
            # Nothing is measured from itself.
            ("[red, one]", {"one": "ball"}, 0.5),
            ("[red, one]", {"one": "red"}, None),
        ],
    )
    def test_it_is_measured_to_what_is_drawn_now(self, stage, value, draws, far):
        actions = f"actions: [{{action: emit, event: TOLD, payload: {{far: {{distance: {value}}}}}}}]"
        body = f"rules: {{told: {{triggers: [{{trigger: half_started}}], {actions}}}}}"
        assert stage(self.PLACES, body, draws=draws).events[0].payload == {"far": far}


class TestPlaces:
    """A drawn robot, ball or obstacle, beside which or towards which something is put."""

    WHO = "draws: {who: {values: [%s]}}"

    def put(self, stage, who: str, action: str, values: str = "B1, Y1"):
        play = stage(self.WHO % values, at_tick_10(action), draws={"who": who})
        play.place("B1", 0.4, 0.5, math.pi / 2)
        play.place("Y1", -0.4, -0.5, math.pi)
        return acted(play)

    @pytest.mark.parametrize(
        ("at", "of_b1", "of_y1"),
        [
            ("{relative_to: who, offset_m: [0.1, -0.2]}", (0.5, 0.3), (-0.3, -0.7)),
            ("{relative_to: who, offset_m: [0.1, 0], turns: true}", (0.4, 0.6), (-0.5, -0.5)),
            # A mirror turns the offset over, and not the one that is drawn.
            ("{relative_to: who, offset_m: [0, 0.2]}, mirror: {axis: y}", (0.4, 0.3), (-0.4, -0.7)),
            ("{nearest_free: neutral_spots, to: who}", (0.3, 0.3), (-0.3, -0.3)),
            ("{furthest_free: neutral_spots, from: who}", (-0.3, -0.3), (0.3, 0.3)),
        ],
    )
    def test_something_is_put_where_the_drawn_one_is(self, stage, at, of_b1, of_y1):
        for who, where in (("B1", of_b1), ("Y1", of_y1)):
            play = self.put(stage, who, f"{{action: place, entity: ball, at: {at}}}")
            assert play.pose("ball")[:2] == pytest.approx(where)

    @pytest.mark.parametrize(("who", "way"), [("B1", (0.4, 0.5)), ("Y1", (-0.4, -0.5))])
    def test_a_ball_is_kicked_towards_the_drawn_one(self, stage, who, way):
        kick = "{towards: {relative_to: who}, speed_mps: 0.5}"
        play = self.put(stage, who, f"{{action: place, entity: ball, at: {{point: [0, 0]}}, kick: {kick}}}")
        placement = play.placements[-1][1]
        length = math.hypot(*way)
        assert (placement.vx_mps, placement.vy_mps) == pytest.approx(
            (0.5 * way[0] / length, 0.5 * way[1] / length), abs=1e-6
        )

    @pytest.mark.parametrize(("who", "x", "yaw"), [("B1", 0.4, math.pi / 2), ("Y1", -0.4, -math.pi / 2)])
    def test_a_robot_looks_towards_the_drawn_one(self, stage, who, x, yaw):
        action = f"{{action: place, entity: Y2, at: {{point: [{x}, 0]}}, facing: {{towards: who}}}}"
        assert self.put(stage, who, action).pose("Y2")[2] == pytest.approx(yaw, abs=1e-6)

    def test_of_a_draw_in_the_same_tick_the_new_one_counts(self, stage):
        actions = "{action: place, entity: ball, at: {relative_to: who, offset_m: [0.1, 0]}}, {action: draw, draw: who, as: Y1}"
        assert self.put(stage, "B1", actions).pose("ball")[:2] == pytest.approx((-0.3, -0.5))

    def test_entities_and_spots_may_be_drawn_together(self, stage):
        action = "{action: place, entity: ball, at: {relative_to: who, offset_m: [0.1, 0.1]}, mirror: {axis: y}}"
        play = self.put(stage, "middle_blue", action, "B1, middle_blue")
        assert play.pose("ball")[:2] == pytest.approx((0.1, -0.3))  # a spot is mirrored with its offset
