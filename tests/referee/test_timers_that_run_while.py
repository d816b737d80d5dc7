"""Timers that are lengthened, that have no end, and that run while conditions hold."""

import pytest

from rcj_challenges.scenario.errors import ScenarioError
from rcj_challenges.scenario.load import load_text
from tests.referee.building import once

SECOND = "schema_version: 2\n"
OVER = "rules: {over: {triggers: [{trigger: timer_expired, timer: t}], actions: [{action: emit, event: TOLD}]}}"


def lengthened(
    stage, *times: tuple[int, str], timer: str = "lasts_s: 0.64, starts: true", ticks: int = 80
) -> list[int]:
    """Return when a timer of 20 ticks runs out that is lengthened at some ticks."""
    rules = [
        once(tick, f"{{action: timer, timer: t, do: add, s: {more_s}}}", name=f"more_{tick}") for tick, more_s in times
    ]
    play = stage(SECOND, f"timers: {{t: {{{timer}}}}}\ncounters: {{n: {{initial: 0.32}}}}", OVER, *rules)
    play.play(ticks)
    return [event.tick for event in play.events_named("TOLD")]


class TestLengthened:
    @pytest.mark.parametrize(
        ("times", "ends"),
        [
            ([], [20]),
            ([(10, "0.32")], [30]),
            ([(5, "0.32"), (25, "0.32")], [40]),
            ([(10, "{counter: n, times: 2}")], [40]),
            ([(10, "-1")], [20]),
            ([(10, "{told: Y1}")], [20]),
        ],
    )
    def test_it_runs_out_so_much_later(self, stage, times, ends):
        assert lengthened(stage, *times) == ends

    def test_in_the_tick_in_which_it_would_have_run_out_it_has_not(self, stage):
        rule = """
rules:
  more: {triggers: [{trigger: time_reached, at_s: 0.64}], priority: -1, actions: [{action: timer, timer: t, do: add, s: 0.32}]}
"""
        play = stage(SECOND, "timers: {t: {lasts_s: 0.64, starts: true}}", OVER, rule)
        play.play(60)
        assert [event.tick for event in play.events_named("TOLD")] == [30]

    def test_what_has_run_out_goes_on_from_its_end(self, stage):
        assert lengthened(stage, (40, "0.32")) == [20, 50]

    def test_started_again_it_has_its_own_length(self, stage):
        again = once(15, "{action: timer, timer: t}", name="again")
        play = stage(
            SECOND,
            "timers: {t: {lasts_s: 0.64, starts: true}}",
            OVER,
            once(10, "{action: timer, timer: t, do: add, s: 0.32}", name="more"),
            again,
        )
        play.play(60)
        assert [event.tick for event in play.events_named("TOLD")] == [35]

    @pytest.mark.parametrize("change", ["do: add", "s: 5", "do: stop, s: 5"])
    def test_how_much_longer_belongs_to_it(self, change):
        rule = f"{{triggers: [{{trigger: half_started}}], actions: [{{action: timer, timer: t, {change}}}]}}"
        head = "schema_version: 2\nid: it\ntitle: It\nextends: soccersim_v2\ntimers: {t: {}}\n"
        with pytest.raises(ScenarioError) as caught:
            load_text(f"{head}rules: {{r: {rule}}}\n")
        assert [one.code for one in caught.value.diagnostics] == ["missing-key"]


class TestWithoutALength:
    def test_it_runs_on(self, stage):
        assert lengthened(stage, timer="starts: true") == []


class TestWhile:
    TIMER = "timers: {t: {per: yellow, while: [{entity: each, in: right}]%s}}\ncounters: {ran_s: {per: yellow}}"
    READ = """
rules:
  read:
    for_each: yellow
    triggers: [{trigger: time_reached, at_s: 0.64}]
    actions: [{action: count, counter: ran_s, entity: each, to: {timer: t, entity: each}}]
"""

    def test_it_runs_in_the_ticks_in_which_they_hold_each_for_its_owner(self, stage):
        play = stage(SECOND, self.TIMER % "", self.READ)  # Y2 starts there, Y1 does not
        play.play(4)
        play.place("Y2", 0, -0.5)
        play.play(2)
        play.place("Y1", 0.4, 0)
        play.play(20)
        # Y2 for 5 ticks, until it was seen elsewhere at tick 5; Y1 from tick 7 to tick 20.
        assert play.referee.counters["ran_s"] == {"Y1": pytest.approx(13 * 0.032), "Y2": pytest.approx(5 * 0.032)}

    def test_it_runs_out_when_it_has_run_for_so_long(self, stage):
        play = stage(SECOND, self.TIMER % ", lasts_s: 0.32", OVER)
        play.play(4)
        play.place("Y2", 0, -0.5)
        play.play(4)
        play.place("Y2", 0.4, -0.5)
        play.play(30)
        assert [event.tick for event in play.events_named("TOLD")] == [14]

    def test_whether_it_runs_is_a_fact(self, stage):
        told = once(10, "{action: emit, event: TOLD}", name="told", more="conditions: [{timer: t, entity: %s}],")
        for robot, names in (("Y2", ["TOLD"]), ("Y1", [])):
            play = stage(SECOND, self.TIMER % "", told % robot)
            play.play(12)
            assert [event.name for event in play.events_named("TOLD")] == names
