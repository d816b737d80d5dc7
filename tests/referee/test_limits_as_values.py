"""Limits of triggers and rules that are values: read when their measuring begins."""

import pytest

from rcj_challenges.scenario.errors import ScenarioError
from rcj_challenges.scenario.load import load_text
from rcj_challenges.views.sheet.phrasebook import Phrasebook
from rcj_challenges.views.sheet.rules import when_words
from tests.referee.building import ASKING, event_ticks, fail, hears, on_fault, once, place, rule

SECOND = "schema_version: 2\n"
LIMIT = "counters: {limit: {initial: 0.32}, of: {per: robots, initial: 0.32}}\n"
IN_MIDDLE = "{entity: ball, in: middle}"


def ticks(stage, trigger: str, *sections: str, until: int = 60, at: tuple[float, float] = (0, 0)) -> list[int]:
    """Return when a trigger fires; the ball is brought somewhere before tick 10."""
    play = stage(SECOND, LIMIT, hears(trigger), *sections)
    place(play, "ball", 0.4, 0.4, ticks=9)
    place(play, "ball", *at)
    play.play(until - play.tick)
    return event_ticks(play)


def sets(tick: int, value: str) -> str:
    return once(tick, f"{{action: count, counter: limit, to: {value}}}", name="sets")


@pytest.mark.parametrize(
    "trigger",
    [
        f"holds, conditions: [{IN_MIDDLE}], for_s: {{counter: limit}}",
        "stays_in, entity: ball, zone: middle, limit_s: {counter: limit, minus: 0.032}",
    ],
)
class TestHowLongSomethingMustLast:
    def test_is_what_the_counter_says(self, stage, trigger):
        assert ticks(stage, trigger) == [20]

    def test_is_read_when_it_begins(self, stage, trigger):
        assert ticks(stage, trigger, sets(5, "0.64")) == [30]
        assert ticks(stage, trigger, sets(15, "0.64")) == [20]


def test_what_must_last_as_long_as_nothing_never_has(stage):
    assert ticks(stage, f"holds, conditions: [{IN_MIDDLE}], for_s: {{told: Y1}}") == []


def test_interruptions_may_be_as_long_as_a_counter_says(stage):
    trigger = f"holds, conditions: [{IN_MIDDLE}], for_s: 0.64, grace_s: {{counter: limit}}"
    for limit, fires in (("0.16", [30]), ("0.064", [])):
        play = stage(SECOND, f"counters: {{limit: {{initial: {limit}}}}}", hears(trigger))
        place(play, "ball", 0.4, 0.4, ticks=9)
        place(play, "ball", 0, 0, ticks=5)
        place(play, "ball", 0.4, 0.4, ticks=5)
        place(play, "ball", 0, 0, ticks=15)
        assert event_ticks(play) == fires


def test_something_may_come_again_as_often_as_a_counter_says(stage):
    trigger = f"holds, conditions: [{IN_MIDDLE}], every_s: {{counter: limit}}"
    assert ticks(stage, trigger, until=35) == [10, 20, 30]
    assert ticks(stage, "time_reached, at_s: {counter: limit}, every_s: {counter: limit, times: 2}") == [10, 30, 50]


def test_a_time_that_is_drawn_is_that_of_the_half(stage):
    play = stage(SECOND, "draws: {at: {values: [0.64]}}", hears("time_reached, at_s: {draw: at}"))
    play.play(40)
    assert event_ticks(play) == [20]


class TestHowFarSomethingMayGo:
    TRIGGER = "displaced, entity: ball, from: [0, 0], distance_m: {counter: limit}"

    def test_is_what_the_counter_says(self, stage):
        assert ticks(stage, self.TRIGGER, at=(0.31, 0)) == [1]  # at first it was further away
        play = stage(SECOND, LIMIT, hears(self.TRIGGER))
        place(play, "ball", 0.31, 0)
        assert event_ticks(play) == []
        place(play, "ball", 0.33, 0)
        assert event_ticks(play) == [2]

    def test_it_may_be_another_one_for_each(self, stage):
        trigger = "displaced, entity: each, from: [0, 0], distance_m: {counter: of, entity: each}"
        text = hears(trigger).replace("triggers:", "for_each: blue, triggers:")
        play = stage(SECOND, LIMIT.replace("initial: 0.32}}", "initial: 0.9}}"), text)
        play.referee.counters["of"]["B2"] = 2
        play.referee._trackers.enter("play", None)
        for robot in ("B1", "B2"):
            place(play, robot, 0.1, 0.1)
        for robot in ("B1", "B2"):
            place(play, robot, 0.6, 0.8)
        assert len(event_ticks(play)) == 1

    def test_a_short_path_is_one_shorter_than_the_counter_says(self, stage):
        trigger = "no_progress, entity: ball, distance_m: {counter: limit}, within_s: 0.64"
        assert ticks(stage, trigger, "counters: {limit: {initial: 0.6}}", until=40) == [21]
        assert ticks(stage, trigger, until=40) == [30]


def test_a_tilt_is_judged_by_the_angle_that_a_counter_says(stage):
    for angle, fires in (("1.5", [2]), ("3", [])):
        trigger = hears("tips_over, entity: B1, angle_rad: {counter: limit}")
        play = stage(SECOND, f"counters: {{limit: {{initial: {angle}}}}}", trigger)
        play.play()
        play.tip("B1")
        play.play(2)
        assert event_ticks(play) == fires


def test_a_rule_rests_as_long_as_a_counter_says_when_it_fires(stage):
    resting = on_fault("B1", "{action: emit, event: TOLD}", more="cooldown_s: {counter: limit},")
    play = stage(SECOND, LIMIT, resting)
    for _ in range(25):
        fail(play, "B1")
    assert event_ticks(play) == [1, 11, 21]


def test_a_lasting_touch_counts_as_often_as_a_counter_says(stage):
    play = stage(SECOND, LIMIT, hears("touches, entity: Y1, other: B1, every_s: {counter: limit}"))
    play.touch("Y1", "B1", 25)
    play.play(25)
    assert event_ticks(play) == [1, 11, 21]


class TestWhatWasDrawnIsComparedAsANumber:
    DRAW = "draws: {bonus: {values: [5]}, text: {values: [a]}}\ncounters: {limit: {initial: 5}}\n"

    @pytest.mark.parametrize(
        ("bound", "holds"),
        [
            ("at_least: 5", True),
            ("above: 5", False),
            ("at_most: {counter: limit}", True),
            ("below: {counter: limit, plus: 1}", True),
            ("below: 5, negate: true", True),
        ],
    )
    def test_it_is(self, stage, bound, holds):
        play = fail(stage(SECOND, self.DRAW, ASKING % f"{{draw: bonus, {bound}}}"), "B1")
        assert bool(play.events_named("TRUE_NOW")) == holds

    @pytest.mark.parametrize(
        "condition", ["{draw: text, above: 1}", "{draw: bonus}", "{draw: bonus, above: 1, equals: 5}"]
    )
    def test_a_text_is_not_and_something_must_be_asked(self, condition):
        asked = f"rules: {{r: {{triggers: [{{trigger: half_started}}], conditions: [{condition}], actions: [{{action: end}}]}}}}"
        with pytest.raises(ScenarioError):
            load_text(f"{SECOND}id: it\ntitle: It\nextends: soccersim_v2\n{self.DRAW}{asked}\n")


@pytest.mark.parametrize("limit", ["0", "-1", "{counter: nothing}", "{flag: limit}", "[1]"])
def test_a_limit_must_be_one(limit):
    stays = rule(f"trigger: stays_in, entity: ball, zone: blue_goal, limit_s: {limit}", "{action: end}")
    with pytest.raises(ScenarioError):
        load_text(f"{SECOND}id: it\ntitle: It\nextends: soccersim_v2\ncounters: {{limit: {{}}}}\n{stays}\n")


@pytest.mark.parametrize(
    ("trigger", "words"),
    [
        (
            "stays_in, entity: ball, zone: blue_goal, limit_s: {counter: limit}",
            "When the ball has been in the blue goal for more than as many s as the counter “limit” says",
        ),
        (
            "displaced, entity: B1, distance_m: {counter: limit, times: 2}",
            "When B1 is more than as many m as 2 times the counter “limit” from where it was put",
        ),
        (
            "holds, conditions: [{entity: ball, held: true}], for_s: {draw: rest}, every_s: {counter: limit}",
            (
                "When B1 is held for as many s as what was drawn as “rest” says, and again each time after as many s as "
                "the counter “limit” says while that lasts"
            ),
        ),
        (
            "holds, conditions: [{distance: [Y1, ball], below: {lowest: [{counter: limit}, 0.3]}}]",
            "When the distance between Y1 and the ball in m is less than the lowest of the counter “limit” and 0.3",
        ),
        ("time_reached, at_s: {draw: rest}", "When the half has lasted 5 s or 8 s, as “rest” is drawn"),
    ],
)
def test_the_rule_sheet_has_the_limit_in_words(trigger, words):
    head = f"{SECOND}id: it\ntitle: It\nextends: soccersim_v2\ncounters: {{limit: {{}}}}\ndraws: {{rest: {{values: [5, 8]}}}}\n"
    loaded = load_text(head + rule(f"trigger: {trigger}", "{action: end}").replace("ball, held", "B1, held") + "\n")
    phrases = Phrasebook(loaded.scenario, loaded.roster)
    assert when_words(loaded.scenario.rules["act"], phrases) == words
