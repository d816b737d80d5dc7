"""``{param: NAME, times: …, plus: …}``: a number computed from a param, wherever a param may stand."""

from __future__ import annotations

from fractions import Fraction
from math import isfinite

import pytest
import yaml
from hypothesis import example, given
from hypothesis import strategies as st

from rcj_challenges.core.diagnostics import InFile
from rcj_challenges.scenario.lint.registry import lint
from rcj_challenges.scenario.load import load
from rcj_challenges.scenario.reading.params import compute
from tests.scenario.writing import HEAD, errors, loaded, rule, scenario

PAIR = """
params: {gap_m: 0.15}
zones:
  west: {shape: rect, x_max_m: {param: gap_m, times: -1}}
  east: {shape: rect, x_min_m: {param: gap_m}}
"""

wholes = st.integers(-(10**9), 10**9)
decimals = st.decimals(-1000, 1000, allow_nan=False, places=6).map(float)
numbers = wholes | decimals


def round_score(number: float) -> Fraction:
    """Return a number as it is written, not as the binary one next to it."""
    return Fraction(repr(number))


class TestArithmetic:
    @given(numbers, numbers, numbers)
    @example(0.1, 3, 0)
    @example(1.1, 1.1, 0)
    @example(0.1, 1, 0.2)
    @example(0.7, -1, 0.7)
    @example(94906265, 94906267, 0)
    @example(94897821, 94914711, 0.0)
    def test_it_is_the_number_that_one_gets_on_paper(self, value, times, plus):
        exact, found = round_score(value) * round_score(times) + round_score(plus), compute(value, times, plus)
        # What is whole stays exact, also where it has more digits than a float.
        assert found in (exact, float(exact))
        # From 2 ** 53 on every float is whole, whatever it stands for.
        assert abs(found) >= 2**53 or isinstance(found, int) == (round_score(found).denominator == 1)

    @given(wholes, wholes, wholes)
    def test_whole_numbers_stay_whole(self, value, times, plus):
        found = compute(value, times, plus)
        assert (type(found), found) == (int, value * times + plus)

    @given(st.floats(allow_nan=False, allow_infinity=False), st.floats(allow_nan=False, allow_infinity=False))
    def test_what_is_too_large_is_no_number_and_all_else_is_finite(self, value, times):
        found = compute(value, times, 0)
        if found is None:
            assert abs(round_score(value) * round_score(times)) > 1e308
        else:
            assert isfinite(found)

    def test_there_is_no_minus_nothing(self):
        assert str(compute(0.0, -1, 0)) == "0"
        assert str(compute(0.3, 1, -0.3)) == "0"


class TestWhereItStands:
    def test_a_pair_of_zones_from_one_number(self):
        zones = scenario(PAIR).zones
        assert (zones["west"].x_max_m, zones["east"].x_min_m) == (-0.15, 0.15)

    def test_in_lists_payloads_points_and_whole_numbers(self):
        found = scenario(
            "params: {n: 4, w: 0.3}\n"
            "zones: {z: {shape: polygon, points_m: [[{param: w, times: -1}, 0], [{param: w}, 0], [0, {param: w, plus: 0.1}]]}}\n"
            "draws: {d: {values: [{param: n}, {param: n, plus: 1}]}}\n"
            + rule(
                "{trigger: enters, entity: ball, zone: z}",
                "{action: emit, event: E, payload: {a: {param: n, times: 2}, b: {param: w, times: 3}}}",
                "    max_executions: {param: n, times: 0.5}\n"
                "    conditions: [{score: yellow, at_least: {param: n, plus: -1}}]\n",
            )
        )
        assert found.zones["z"].points_m == ((-0.3, 0.0), (0.3, 0.0), (0.0, 0.4))
        assert found.draws["d"].values == (4, 5)
        (made,) = found.rules.values()
        assert (made.max_executions, made.conditions[0].at_least) == (2, 3)
        assert made.actions[0].payload == {"a": 8, "b": 0.9}

    def test_a_sum_takes_it_as_a_number(self):
        points = "{sum: [{param: n, times: 2}, {word: time_s, times: {param: n, times: -0.1}}]}"
        found = scenario("params: {n: 3}\n" + rule(action=f"{{action: score, entrant: yellow, points: {points}}}"))
        number, word = found.rules["r"].actions[0].points.sum
        assert (number, word.times) == (6, -0.3)

    @pytest.mark.parametrize("override", ["gap_m=0.2", "params.gap_m=0.2", "params={gap_m: 0.2}"])
    def test_whoever_sets_the_param_sets_both(self, override):
        zones = scenario(PAIR, [override]).zones
        assert (zones["west"].x_max_m, zones["east"].x_min_m) == (-0.2, 0.2)

    def test_an_override_may_be_one(self):
        assert scenario(PAIR, ["match.half_s={param: gap_m, times: 200, plus: 30}"]).match.half_s == 60
        assert scenario(PAIR, ["zones.west.x_max_m.times=-2"]).zones["west"].x_max_m == -0.3

    def test_a_variant_sets_the_param_or_the_use(self, tmp_path):
        (tmp_path / "base.yaml").write_text(HEAD + PAIR, encoding="utf-8")
        mine = tmp_path / "mine.yaml"
        mine.write_text(
            "extends: base.yaml\nparams: {gap_m: 0.3}\nzones: {east: {x_min_m: {param: gap_m, times: 2}}}\n",
            encoding="utf-8",
        )
        zones = load(mine).scenario.zones
        assert (zones["west"].x_max_m, zones["east"].x_min_m) == (-0.3, 0.6)
        mine.write_text("extends: base.yaml\nzones: {west: {x_max_m: {param: gap_m}}}\n", encoding="utf-8")
        assert load(mine).scenario.zones["west"].x_max_m == 0.15

    def test_a_mapping_with_other_keys_is_what_it_was(self):
        payload = "{param: x, times: 3, other: 2}"
        found = scenario(rule(action=f"{{action: emit, event: E, payload: {payload}}}"))
        assert found.rules["r"].actions[0].payload == yaml.safe_load(payload)


class TestWhatIsSaid:
    def test_error_has_the_place_of_the_use_and_the_formula(self):
        (problem,) = errors("params: {pause_s: 3}\nphases: {p: {lasts_s: {param: pause_s, times: -2, plus: 1}}}\n")
        assert problem.where == InFile("a.yaml", 6, 31, "phases.p.lasts_s")
        assert problem.message.endswith("found -5 (param 'pause_s' times -2 plus 1)")


class TestLint:
    def test_it_is_a_use_of_the_param(self):
        kinds = [one.code for one in lint(loaded("params: {m: 2}\nmatch: {half_s: {param: m, times: 60}}\n"))]
        assert "never-used" not in kinds
