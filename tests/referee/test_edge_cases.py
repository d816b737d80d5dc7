"""What the reference says of words at their edges, each as the referee has it."""

import pytest

from tests.referee.building import acted, at_tick_10, event_ticks, hears, once, place, rule


def holding(condition: str) -> str:
    return hears(f"holds, conditions: [{{{condition}}}]")


def placing(entity: str, at: str, more: str = "") -> str:
    return f"{{action: place, entity: {entity}, at: {at}{more}}}"


class TestHolds:
    VISITED = rule(
        "trigger: half_started", *(f"{{action: count, counter: visits, entity: {robot}}}" for robot in ("Y1", "Y2")),
        name="visited",
    )  # fmt: skip

    @pytest.mark.parametrize(
        ("condition", "action", "heard"),
        [
            # Where a rule puts something is not heard.
            ("entity: ball, in: right", placing("ball", "{point: [0.4, 0]}"), []),
            ("distance: [ball, centre], at_least: 0.3", placing("ball", "{point: [0.4, 0]}"), []),
            # That it frees a spot, loses the steps of a sequence or leaves fewer on the field is, one tick later.
            ("spot_free: centre", placing("ball", "{point: [0.4, 0]}"), [11]),
            ("sequence: way, equals: left, negate: true", placing("Y1", "{point: [0.4, 0]}"), [11]),
            (
                "counter: visits, entity: Y1, at_least: {count: [B1, B2]}",
                "{action: remove, entity: [B1, B2]}",
                [11],
            ),
        ],
    )
    def test_what_a_rule_makes_true(self, stage, condition, action, heard):
        kept = "counters: {visits: {per: robots}}\nsequences: {way: {entity: Y1, steps: [left, right]}}"
        play = stage(kept, self.VISITED, at_tick_10(action), holding(condition))
        play.play_until(20)
        assert event_ticks(play) == heard


class TestAPhaseEntered:
    def test_the_present_one_starts_again_when_a_rule_enters_it(self, stage):
        play = stage(
            "phases: {rest: {lasts_s: 0.64}}\nfirst_phase: rest",
            once(10, "{action: set_phase, phase: rest}", more="phases: any,"),
        )
        play.play_until(29)
        assert play.referee.phase == "rest"
        play.play()
        assert play.referee.phase == "play"


class TestDisplaced:
    def test_it_is_measured_from_where_noise_has_put_it(self, stage):
        put = placing("ball", "{point: [0, 0]}", ", noise_m: [0.3, 0]")
        play = stage(at_tick_10(put), hears("displaced, entity: ball, distance_m: 0.02"))
        play.play_until(12)
        x, y, _ = play.pose("ball")
        assert abs(x) > 0.02
        place(play, "ball", x, y + 0.019)
        assert event_ticks(play) == []
        place(play, "ball", x, y + 0.021)
        assert event_ticks(play) == [14]


class TestWaitingForRoom:
    RULES = """
phases: {rest: {lasts_s: 1.6}}
rules:
  put:
    %s
    triggers: [{trigger: time_reached, at_s: 0.32}]
    actions: [{action: place, entity: B1, at: {point: [0, 0]}}, {action: set_phase, phase: rest}]
"""

    @pytest.mark.parametrize(
        ("phases", "there_at_30"), [("", False), ("phases: any", True), ("phases: [play, rest]", True)]
    )
    def test_it_is_tried_again_in_the_phases_of_its_rule(self, stage, phases, there_at_30):
        play = stage(self.RULES % phases)  # the ball lies there
        play.play_until(20)
        play.place("ball", 0.5, 0)
        play.play_until(30)
        assert (play.pose("B1")[:2] == (0, 0)) is there_at_30
        play.play_until(62)
        assert play.pose("B1")[:2] == (0, 0)


class TestWhenAPlaceIsRead:
    """Which layout and whether mirrored: when the action runs; where that is: when all actions of the tick have run."""

    SIDES = """
    draws: {side: {values: [middle_blue, middle_yellow]}, form: {values: [a, b]}}
    flags: {changed: {}}
    placements: {a: [{entity: B1, at: {point: [0.4, 0.1]}}], b: [{entity: B1, at: {point: [0, 0.4]}}]}
    """

    @pytest.mark.parametrize(
        ("put", "after", "where"),
        [
            (placing("B1", "{spot: side}"), "{action: draw, draw: side, as: middle_yellow}", (0, -0.2)),
            (placing("B1", "{spot: middle_blue}"), "{action: set_spot, spot: middle_blue, to: [0.5, 0.1]}", (0.5, 0.1)),
            (
                placing("B1", "{point: [0.4, 0.1]}", ", mirror: {axis: x, when: changed}"),
                "{action: set_flag, flag: changed}",
                (0.4, 0.1),
            ),
            ("{action: place, layout: {draw: form}}", "{action: draw, draw: form, as: b}", (0.4, 0.1)),
        ],
    )
    def test_what_a_later_action_of_the_rule_changes(self, stage, put, after, where):
        play = acted(stage(self.SIDES, at_tick_10(put, after), draws={"side": "middle_blue", "form": "a"}))
        assert play.pose("B1")[:2] == pytest.approx(where)


class TestATimerThatHasRunOut:
    @pytest.mark.parametrize(("comparison", "holds"), [
        ("at_least: 5", True), ("at_most: 5", False), ("equals: 5", False), ("at_most: 5.024", True),
    ])  # fmt: skip
    def test_it_stands_at_its_length_in_whole_ticks(self, stage, comparison, holds):
        asked = f"conditions: [{{timer: five, {comparison}}}],"
        play = stage("timers: {five: {lasts_s: 5, starts: true}}", hears("time_reached, at_s: 8", asked))
        play.play_until(260)
        assert bool(event_ticks(play)) is holds


class TestRemove:
    def removals(self, stage, first: str, second: str) -> list[int]:
        """Return when B1 was put back that is taken off at tick 10 and again at tick 20."""
        again = once(20, f"{{action: remove, entity: B1{second}}}", name="again")
        play = stage(at_tick_10(f"{{action: remove, entity: B1{first}}}"), again)
        play.play_until(200)
        return [tick for tick, placed in play.placements if tick and not placed.parked]

    @pytest.mark.parametrize(("first", "second", "back"), [
        (", for_s: 3.2", ", for_s: 0.64", [40]),
        (", for_s: 0.64", ", for_s: 3.2", [120]),
        (", for_s: 3.2", "", []),
        ("", ", for_s: 0.64", [40]),
    ])  # fmt: skip
    def test_a_robot_already_off_returns_as_the_later_removal_states(self, stage, first, second, back):
        assert self.removals(stage, first, second) == back
