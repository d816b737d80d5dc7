"""Values that are measured or remembered: distances, timers, last touches; and points and sentences made of them."""

import pytest

from rcj_challenges.expect.scripted_match import ScriptedMatch, half_of
from rcj_challenges.scenario.load import load_text
from tests.referee.building import TAKEN_OFF, emitting, fail, on_fault, once, paid, payload, scoring, touch

HEAD = "schema_version: 2\nid: small\ntitle: Small\nextends: soccersim_v2\nmatch: {half_s: 60}\n"


class TestValueDistance:
    def test_it_is_in_metres_to_the_millimetre(self, stage):
        play = stage(emitting("{far: {distance: [Y1, ball]}, back: {distance: [ball, Y1]}}"))
        play.place("Y1", -0.3, -0.4001)
        assert payload(play) == {"far": 0.5, "back": 0.5}

    @pytest.mark.parametrize(("to", "far"), [("B2", 1.0), ("middle_blue", 0.3), ("[0.4, 0]", 0.4), ("[0, 0]", 0.0)])
    def test_it_is_measured_to_a_robot_a_spot_or_a_point(self, stage, to, far):
        play = stage("spots: {middle_blue: {x_m: 0, y_m: 0.3}}", emitting(f"{{far: {{distance: [ball, {to}]}}}}"))
        play.place("B2", -0.6, 0.8)
        assert payload(play) == {"far": far}

    def test_of_a_group_the_nearest_counts_and_nothing_is_measured_from_itself(self, stage):
        play = stage(emitting("{a: {distance: [ball, yellow]}, b: {distance: [Y1, yellow]}, c: {distance: [Y1, Y1]}}"))
        play.place("Y1", 0.3, 0.0)
        play.place("Y2", 0.5, 0.0)
        assert payload(play) == {"a": 0.3, "b": 0.2, "c": None}

    @pytest.mark.parametrize("off", ["ball", "Y1"])
    def test_off_the_field_there_is_none(self, stage, off):
        play = stage(emitting("{far: {distance: [Y1, ball]}}"), TAKEN_OFF % off)
        play.play_until(15)
        assert payload(play) == {"far": None}

    def test_it_can_be_points_or_a_count_as_it_is(self, stage):
        play = stage(
            "counters: {far: {}}",
            scoring("{distance: [Y1, ball]}"),
            on_fault("B1", "{action: count, counter: far, to: {distance: [Y1, ball]}}", name="kept"),
        )
        play.place("Y1", 0.0, 0.1234)
        assert paid(play) == 0.123
        assert play.referee.counters["far"] == 0.123

    def test_off_the_field_it_gives_nothing(self, stage):
        play = stage(scoring("{sum: [1, {distance: [Y1, ball], times: 10}]}"), TAKEN_OFF % "ball")
        play.play_until(15)
        assert paid(play) == 1


class TestValueTimer:
    TIMERS = "timers: {lap: {lasts_s: 10, starts: true}, still: {lasts_s: 10}, own: {lasts_s: 10, per: yellow}}"

    def test_it_is_how_long_the_timer_has_run_and_stops_at_its_length(self, stage):
        play = stage(self.TIMERS, emitting("{lap: {timer: lap}, still: {timer: still}}"))
        play.play_until(99)
        assert payload(play) == {"lap": 3.2, "still": 0}
        play.play_until(400)
        assert payload(play)["lap"] == 10.016

    def test_one_kept_per_robot_is_that_of_the_robot_or_the_longest(self, stage):
        values = "{y1: {timer: own, entity: Y1}, y2: {timer: own, entity: Y2}, all: {timer: own}}"
        started = once(1, "{action: timer, timer: own, entity: Y2, do: start}")
        play = stage(self.TIMERS, emitting(values), started)
        play.play_until(50)
        assert payload(play) == {"y1": 0, "y2": 1.6, "all": 1.6}

    @pytest.mark.parametrize(("rounded", "points"), [(", round: down", 2), ("", 2.976)])
    def test_as_points_its_whole_seconds_count_or_its_ticks(self, stage, rounded, points):
        play = stage(self.TIMERS, scoring(f"{{timer: lap{rounded}}}"))
        play.play_until(92)
        assert paid(play) == points


class TestValueLastTouch:
    def test_it_is_the_name_of_the_last_robot_or_null(self, stage):
        play = stage(emitting("{who: {last_touch: ball}}"))
        assert payload(play) == {"who": None}
        touch(play, "ball", "Y2")
        touch(play, "ball", "B1", ticks=3)
        assert payload(play) == {"who": "B1"}

    def test_a_broadcast_has_touches_though_no_rule_uses_them(self, stage):
        play = stage("broadcast: {fields: {who: {last_touch: ball}}}")
        assert play.output.broadcast == {"who": None}
        play.touch("ball", "Y2")
        assert play.play().broadcast == {"who": "Y2"}


class TestPointsAndParamsInSentences:
    def said(self, actions: str, says: str, params: str = "{}") -> str:
        text = f"params: {params}\nrules:\n  r:\n    triggers: [{{trigger: program_fault}}]\n    actions: {actions}\n"
        loaded = load_text(HEAD + text + f"    says: '{says}'\n")
        return self.firing(loaded).says

    @staticmethod
    def firing(loaded):
        play = ScriptedMatch(loaded.scenario, loaded.roster, half_of(loaded.scenario))
        play.place("Y1", 0.0, 0.5)
        fail(play, "Y1")
        return play.firings[-1]

    @pytest.mark.parametrize(
        ("points", "said"), [("3", "3"), ("0.5", "0.5"), ("-2.0", "-2"), ("{param: goal}", "7"), ("1234567", "1234567")]
    )
    def test_the_points_of_the_rule_are_a_measured_value(self, points, said):
        actions = f"[{{action: score, entrant: yellow, points: {points}}}]"
        assert self.said(actions, "A goal; {points} points.", "{goal: 7}") == f"A goal; {said} points."

    @pytest.mark.parametrize(("tries", "said"), [(1, "1 point"), (-1, "-1 point"), (2, "2 points"), (0, "0 points"), (0.5, "0.5 points")])  # fmt: skip
    def test_one_point_is_no_points(self, tries, said):
        assert self.said(f"[{{action: score, entrant: yellow, points: {tries}}}]", "{points} points.") == f"{said}."
        # The distance is 0.5 m: what is computed when the rule fires is said alike.
        computed = f"[{{action: score, entrant: yellow, points: {{sum: [{tries}, -0.5, {{distance: [Y1, [0, 0]]}}]}}}}]"
        assert self.said(computed, "A goal; {points} points!") == f"A goal; {said}!"
        assert self.said("[{action: score, entrant: yellow}]", "{goal} points.", f"{{goal: {tries}}}") == f"{said}."

    def test_a_param_stands_by_its_name(self):
        says = "{n} of {name}, {yes}; {nothing}; {entity}"
        params = "{n: 2.0, name: three, yes: true, entity: 9}"
        assert self.said("[{action: end}]", says, params) == "2 of three, true; {nothing}; Y1"

    def test_it_follows_what_is_set_on_the_command_line(self):
        text = (
            "params: {goal_points: 3}\nrules: {r: {triggers: [{trigger: program_fault}], actions: [{action: score, "
            "entrant: yellow, points: {param: goal_points}}], says: 'A goal; {goal_points} points, {points}.'}}\n"
        )
        assert self.firing(load_text(HEAD + text)).says == "A goal; 3 points, 3."
        assert self.firing(load_text(HEAD + text, ["goal_points=5"])).says == "A goal; 5 points, 5."
